// Further runs over the one of a trace plot: colours and markers by object, dashes by run, marked at the ends
// of their lines.

#include "engine/recording/recorded_session.h"
#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"
#include "widgets/plots/trace_canvas.h"

#include <algorithm>
#include <iterator>

namespace bask {
namespace {

constexpr int kLongestName = 100; // px, in front of the run's mark

} // namespace

QList<qreal> TracePlot::overlayDashes(int place) {
    static const QList<qreal> kDashes[]{{7, 2.5}, {7, 2.5, 1.5, 2.5}, {1.5, 2}, {14, 2.5, 4, 2.5}};
    return kDashes[static_cast<std::size_t>(place) % std::size(kDashes)];
}

double TracePlot::Canvas::lastTime_s() const {
    double last_s = traces->lastTime_s();
    for (const Overlay& overlay : overlays)
        last_s = std::max(last_s, overlay.traces.lastTime_s());
    return last_s;
}

void TracePlot::Canvas::addOverlay(const QString& mark, std::shared_ptr<RecordedSession> run) {
    Overlay overlay{mark, {}, {}, {}, {}};
    for (const ObjectSpec& object : run->facts().experiment.objects)
        overlay.objects << QString::fromStdString(object.name);
    overlay.traces.show(std::move(run));
    overlays.push_back(std::move(overlay));
    rebuild();
}

void TracePlot::Canvas::clearOverlays() {
    if (overlays.empty())
        return;
    removeOverlayItems();
    overlays.clear();
    rebuild();
}

/// The graphs go with clearGraphs(), the labels do not.
void TracePlot::Canvas::removeOverlayItems() {
    for (Overlay& overlay : overlays) {
        for (QCPItemText* label : std::as_const(overlay.labels))
            removeItem(label);
        overlay.labels.clear();
        overlay.graphs.clear();
    }
}

void TracePlot::Canvas::rebuildOverlays() {
    removeOverlayItems();
    for (Overlay& overlay : overlays) {
        const auto count =
            static_cast<int>(bask::seriesCount(quantity, static_cast<std::size_t>(overlay.objects.size())));
        for (int i = 0; i < count; ++i) {
            overlay.graphs << addGraph();
            overlay.graphs.back()->setAdaptiveSampling(true);
            overlay.labels << makeLineLabel();
        }
    }
    styleOverlays(Density::Loose);
}

QString TracePlot::Canvas::overlayName(const Overlay& overlay, int series) const {
    return isOfRun() ? seriesName(series) : overlay.objects.value(series);
}

/// A few along the line, as in figures: the dashes are the runs' then.
void TracePlot::Canvas::markObject(QCPGraph* graph, int object) const {
    graph->setScatterStyle(overlays.empty() ? QCPScatterStyle() : figureMarker(object, graph->pen().color()));
    graph->setScatterSkip(std::max(0, graph->dataCount() / kMarkersOfLine - 1));
}

void TracePlot::Canvas::styleOverlays(Density density) {
    const QFontMetrics metrics(font());
    for (std::size_t k = 0; k < overlays.size(); ++k) {
        const Overlay& overlay = overlays[k];
        for (int i = 0; i < overlay.graphs.size(); ++i) {
            const QString name = overlayName(overlay, i);
            const auto same = static_cast<int>(names.indexOf(name)); // in the run underneath
            const int object = same >= 0 ? same : i;
            QPen pen(seriesColor(object, dark), 1.4);
            if (isOfRun())
                pen.setColor(inkOfRun(i));
            pen.setCapStyle(Qt::FlatCap);
            if (density == Density::Loose)
                pen.setDashPattern(overlayDashes(static_cast<int>(k)));
            else
                pen = plainPen(pen, density);
            overlay.graphs[i]->setPen(pen);
            markObject(overlay.graphs[i], object);
            overlay.labels[i]->setFont(font());
            overlay.labels[i]->setColor(pen.color());
            overlay.labels[i]->setText(QStringLiteral("%1 %2").arg(
                metrics.elidedText(name, Qt::ElideRight, kLongestName), overlay.mark));
        }
    }
}

} // namespace bask
