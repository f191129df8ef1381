// What a trace plot shows, as a figure for print and as a table.

#include "engine/base/unit.h"
#include "engine/recording/csv_field.h"
#include "engine/recording/recorded_session.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/plots/figure_traces.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_canvas.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kPlotHeight_px = 1080;
constexpr double kNumberRoom = 0.022; // of the shown time, from one numbered moment to the next

/// The columns of one run: the first are its times.
struct TableBlock {
    QStringList headers;
    std::vector<std::vector<double>> columns;
};

/// Name and unit of a quantity in files, as in traces.csv: "measured (degC)".
QString fileName(Quantity quantity, std::size_t series) {
    const auto named = [](const auto& column) {
        const bool isTemperature = column.unit.edge == EdgeUnit::Temperature;
        return QStringLiteral("%1 (%2)").arg(QLatin1String(column.csv != nullptr ? column.csv : column.label),
                                             isTemperature ? QStringLiteral("degC")
                                                           : QString::fromStdString(siUnit(column.unit)));
    };
    if (const ObjectColumn* column = plottedColumn(quantity))
        return named(*column);
    if (const RunColumn* column = plottedRunColumn(quantity))
        return named(*column);
    return series == 0 ? QStringLiteral("commanded speed (m/s)")
                       : QStringLiteral("commanded rotation (rad/s)");
}

double inFiles(double si, Quantity quantity) {
    const ObjectColumn* column = plottedColumn(quantity);
    const RunColumn* ofRun = plottedRunColumn(quantity);
    const Unit* unit = column != nullptr ? &column->unit : ofRun != nullptr ? &ofRun->unit : nullptr;
    return unit != nullptr && unit->edge == EdgeUnit::Temperature ? celsiusFromKelvin(si) : si;
}

/// Adds the values of a quantity between two times, and the times if they are not there yet.
void addQuantity(TableBlock& block, const TraceStore& traces, const QStringList& objects, Quantity quantity,
                 double from_s, double to_s) {
    for (std::size_t i = 0; i < seriesCount(quantity, traces.objects()); ++i) {
        int reads = std::numeric_limits<int>::max();
        const TraceStore::Line line =
            traces.line(quantity, i, from_s, to_s, std::numeric_limits<std::size_t>::max(), reads);
        std::vector<double> times, values;
        times.reserve(line.values.size());
        values.reserve(line.values.size());
        for (std::size_t k = 0; k < line.values.size(); ++k)
            if (line.times_s[k] >= from_s && line.times_s[k] <= to_s) {
                times.push_back(line.times_s[k]);
                values.push_back(inFiles(line.values[k], quantity));
            }
        if (block.columns.empty()) {
            block.headers << QStringLiteral("time (s)");
            block.columns.push_back(std::move(times));
        }
        const QString object = plottedColumn(quantity) != nullptr
                                   ? objects.value(static_cast<qsizetype>(i)) + QStringLiteral(" ")
                                   : QString();
        block.headers << object + fileName(quantity, i);
        block.columns.push_back(std::move(values));
    }
}

void addTargets(TableBlock& block, const TraceStore& traces, const QStringList& objects) {
    if (block.columns.empty())
        return;
    for (std::size_t i = 0; i < traces.objects(); ++i) {
        const auto& steps = traces.targetSteps(i);
        std::vector<double> values;
        values.reserve(block.columns.front().size());
        for (const double time_s : block.columns.front()) {
            const auto after =
                std::ranges::upper_bound(steps, time_s, {}, [](const auto& step) { return step.first; });
            values.push_back(after == steps.begin() ? std::numeric_limits<double>::quiet_NaN()
                                                    : celsiusFromKelvin(std::prev(after)->second));
        }
        block.headers << objects.value(static_cast<qsizetype>(i)) + QStringLiteral(" target (degC)");
        block.columns.push_back(std::move(values));
    }
}

/// Blocks beside each other; unknown values, and the rows after the end of a shorter run, are empty. The mark
/// is the last column: a line before the headers would break readers.
QByteArray csvOf(const std::vector<TableBlock>& blocks, const QString& mark) {
    constexpr int kDigits = 9;
    QByteArray text;
    std::size_t rows = 0;
    for (const TableBlock& block : blocks) {
        for (const QString& header : block.headers)
            text += QByteArray::fromStdString(csvField(header.toStdString())) + ',';
        rows = std::max(rows, block.columns.empty() ? 0 : block.columns.front().size());
    }
    text += QByteArray::fromStdString(csvField(mark.toStdString())) + '\n';
    for (std::size_t row = 0; row < rows; ++row) {
        for (const TableBlock& block : blocks)
            for (const std::vector<double>& column : block.columns) {
                if (row < column.size() && std::isfinite(column[row]))
                    text += QByteArray::number(column[row], 'g', kDigits);
                text += ',';
            }
        text += '\n';
    }
    return text;
}

/// Its mark, if it has one, and its file.
QString nameOfRun(const QString& mark, const TraceStore& traces) {
    const RecordedSession* run = traces.run();
    const QString file =
        run != nullptr ? QFileInfo(QString::fromStdString(run->facts().path)).completeBaseName() : QString();
    return (mark + u' ' + file).trimmed();
}

QString withRig(const QString& name, const TraceStore& traces) {
    return QStringLiteral("%1 (%2)").arg(name, rigWord(traces.run()->facts().simulated));
}

} // namespace

/// Moments are numbered, and the note says what they are: words would hide lines, or each other.
QByteArray TracePlot::Canvas::figure(const QString& unrecorded, FigureFormat format, const QString& comment) {
    updateRanges();
    const double from_s = xAxis->range().lower, to_s = xAxis->range().upper;
    TraceFigure out;
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
    out.size_px = QSize(kFigureWidth_px, kPlotHeight_px);
    out.run = nameOfRun(kOwnMark, *traces);
    QStringList runs{traces->run() != nullptr
                         ? withRig(overlays.empty() ? nameOfRun({}, *traces) : out.run, *traces)
                         : unrecorded};
    for (const Overlay& overlay : overlays) {
        const QString name = nameOfRun(overlay.mark, overlay.traces);
        out.overlays << FigureOverlay{name, overlay.objects, &overlay.traces};
        runs << withRig(name, overlay.traces);
    }
    out.prediction.name = predictionWords();
    for (int i = 0; i < m_predicted.size(); ++i)
        out.prediction.lines << predictedPoints(i);
    QStringList words;
    double numbered_s = -std::numeric_limits<double>::infinity();
    for (const Marker& marker : std::as_const(markers)) {
        if (marker.time_s < from_s || marker.time_s > to_s)
            continue;
        QString number;
        if (markerTexts && marker.time_s - numbered_s > kNumberRoom * (to_s - from_s)) {
            number = QString::number(words.size() + 1);
            words << number + u' ' + marker.text;
            numbered_s = marker.time_s;
        }
        out.moments << FigureMoment{marker.time_s, number};
    }
    QStringList lines{runs.join(listSeparator()), words.join(listSeparator())};
    lines.removeAll(QString());
    out.note = lines.join(QStringLiteral(" \u00b7 "));
    return traceFigure(out, *traces, format, comment);
}

QByteArray TracePlot::Canvas::table(const QString& mark) {
    updateRanges();
    const double from_s = xAxis->range().lower, to_s = xAxis->range().upper;
    std::vector<TableBlock> blocks(1);
    addQuantity(blocks.front(), *traces, names, quantity, from_s, to_s);
    if (quantity == Quantity::Temperature)
        addTargets(blocks.front(), *traces, names);
    if (rightAxis.quantity)
        addQuantity(blocks.front(), *traces, names, *rightAxis.quantity, from_s, to_s);
    if (overlays.empty())
        return csvOf(blocks, mark);
    const auto nameBlock = [](TableBlock& block, const QString& run) {
        for (QString& header : block.headers)
            header.prepend(run + QStringLiteral(": "));
    };
    nameBlock(blocks.front(), nameOfRun(kOwnMark, *traces));
    for (const Overlay& overlay : overlays) {
        blocks.emplace_back();
        addQuantity(blocks.back(), overlay.traces, overlay.objects, quantity, from_s, to_s);
        nameBlock(blocks.back(), nameOfRun(overlay.mark, overlay.traces));
    }
    return csvOf(blocks, mark);
}

} // namespace bask
