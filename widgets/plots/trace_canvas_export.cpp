// What a trace plot shows, as a figure for print and as a table.

#include "engine/recording/recorded_session.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/plots/figure_traces.h"
#include "widgets/plots/plot_table.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_canvas.h"

#include <QFileInfo>

#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr double kNumberRoom = 0.022; // of the shown time, from one numbered moment to the next

/// Empty for a live run.
QString fileOfRun(const TraceStore& traces) {
    const RecordedSession* run = traces.run();
    return run != nullptr ? QFileInfo(QString::fromStdString(run->facts().path)).completeBaseName()
                          : QString();
}

/// Its mark, if it has one, and its file.
QString markedFile(const QString& mark, const TraceStore& traces) {
    return (mark + u' ' + fileOfRun(traces)).trimmed();
}

/// Name, file and rig.
QString allOfRun(const QString& name, const TraceStore& traces) {
    const QString file = fileOfRun(traces);
    QStringList rest{rigWord(traces.run()->facts().simulated)};
    if (!name.endsWith(file))
        rest.prepend(file);
    return QStringLiteral("%1 (%2)").arg(name, rest.join(listSeparator()));
}

} // namespace

QString TracePlot::Canvas::nameOfRun(int place) const {
    const Overlay* over = place > 0 ? &overlays[static_cast<std::size_t>(place) - 1] : nullptr;
    const QString mark = over != nullptr ? over->mark : overlays.empty() ? QString() : kOwnMark;
    const QString name = overlays.empty() ? QString() : runNames.value(place);
    return name.isEmpty() ? markedFile(mark, over != nullptr ? over->traces : *traces) : mark + u' ' + name;
}

/// Which runs are simulated; empty if none is.
QString TracePlot::Canvas::rigsOfRuns() const {
    QStringList all{rigWord(traces->run()->facts().simulated)};
    QStringList marked{kOwnMark + u' ' + all.front()};
    bool isAnySimulated = traces->run()->facts().simulated;
    for (const Overlay& overlay : overlays) {
        const bool isSimulated = overlay.traces.run()->facts().simulated;
        isAnySimulated = isAnySimulated || isSimulated;
        all << rigWord(isSimulated);
        marked << overlay.mark + u' ' + all.back();
    }
    if (!isAnySimulated)
        return {};
    return all.count(all.front()) == all.size() ? all.front() : marked.join(listSeparator());
}

/// Moments are numbered, and the note says what they are: words would hide lines, or each other. Those for
/// whose number there is no room are counted.
QByteArray TracePlot::Canvas::figure(const QString& unrecorded, FigureFormat format, const QString& comment,
                                     const FigureLayout& layout) {
    updateRanges();
    const double from_s = xAxis->range().lower, to_s = xAxis->range().upper;
    TraceFigure out;
    out.layout = layout;
    out.title = quantityTitle(quantity);
    if (rightAxis.quantity)
        out.title += listSeparator() + quantityTitle(*rightAxis.quantity);
    out.quantity = quantity;
    out.names = names;
    out.unit = unit;
    out.limits = limits;
    out.time_s = FigureRange{from_s, to_s};
    if (!m_valueAuto)
        out.yRange = FigureRange{yAxis->range().lower, yAxis->range().upper};
    out.right = rightAxis.quantity;
    out.run = nameOfRun(0);
    QStringList runs{traces->run() != nullptr ? allOfRun(out.run, *traces) : unrecorded};
    for (const Overlay& overlay : overlays) {
        const QString name = nameOfRun(static_cast<int>(out.overlays.size()) + 1);
        out.overlays << FigureOverlay{name, overlay.objects, &overlay.traces};
        runs << allOfRun(name, overlay.traces);
    }
    out.corner = traces->run() != nullptr ? rigsOfRuns() : unrecorded;
    out.prediction.name = predictionWords();
    for (int i = 0; i < m_predicted.size(); ++i)
        out.prediction.lines << predictedPoints(i);
    QStringList words;
    int unnumbered = 0;
    double numbered_s = -std::numeric_limits<double>::infinity();
    for (const Marker& marker : std::as_const(markers)) {
        if (!layout.hasHeading || marker.time_s < from_s || marker.time_s > to_s)
            continue;
        QString number;
        if (markerTexts && marker.time_s - numbered_s > kNumberRoom * (to_s - from_s)) {
            number = QString::number(words.size() + 1);
            words << number + u' ' + wordsOf(marker.text);
            numbered_s = marker.time_s;
        } else if (markerTexts) {
            ++unnumbered;
        }
        out.moments << FigureMoment{marker.time_s, number};
    }
    if (unnumbered > 0)
        words << TracePlot::tr("%n more without a number", "moments that are close to another one",
                               unnumbered);
    QStringList lines{runs.join(listSeparator()), words.join(listSeparator())};
    lines.removeAll(QString());
    out.note = lines.join(QStringLiteral(" \u00b7 "));
    return traceFigure(out, *traces, format, comment);
}

PlotTable TracePlot::Canvas::table(const QString& mark) {
    updateRanges();
    PlotTable out;
    out.from_s = xAxis->range().lower;
    out.to_s = xAxis->range().upper;
    out.isCut = !traces->keepsFrom(out.from_s);
    out.mark = mark;
    const auto add = [&](const QString& name, const TraceStore& from, const QStringList& objects) {
        PlotTable::Run run{name, from.run() != nullptr ? from.run()->facts().path : std::string()};
        addQuantity(run, from, objects, quantity);
        out.runs.push_back(std::move(run));
    };
    add(overlays.empty() ? QString() : markedFile(kOwnMark, *traces), *traces, names);
    PlotTable::Run& own = out.runs.front();
    if (quantity == Quantity::Temperature)
        addTargets(own, *traces, names);
    if (rightAxis.quantity)
        addQuantity(own, *traces, names, *rightAxis.quantity);
    if (own.path.empty())
        addLiveRows(own, *traces, out.from_s, out.to_s);
    for (const Overlay& overlay : overlays)
        add(markedFile(overlay.mark, overlay.traces), overlay.traces, overlay.objects);
    return out;
}

} // namespace bask
