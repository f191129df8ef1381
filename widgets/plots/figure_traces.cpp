#include "widgets/plots/figure_traces.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_plot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr std::size_t kLinePixels = 2000; // a line shows least and greatest values within each
constexpr int kReads = 300;      // blocks of recorded runs, about a second: the window waits for them
constexpr int kLabelStrip = 20;  // above the lines, for the words of moments
constexpr double kBeside = 12.0; // left and right of the legend
constexpr int kUnderLines = 58;  // numbers and words of the time axis, with the room to the legend
constexpr int kUnderLegend = 8;
constexpr double kLegendIcon = 70.0;    // with the room around a name
constexpr double kLowest = 200.0;       // of the lines, 35 mm
constexpr const char* kUnder = "under"; // the layer of what is drawn before the run's own lines
constexpr FigureRange kNothing{1e300, -1e300};

struct TimeUnit {
    double length_s;
    QString label;
};

/// By the span: in hours, the ticks of a minute late in a run would hardly differ.
TimeUnit timeUnit(const FigureRange& shown_s) {
    const double span_s = shown_s.max - shown_s.min;
    if (span_s <= 900.0)
        return {1.0, TracePlot::tr("Time since Start (s)")};
    if (span_s <= 4.0 * 3600.0)
        return {60.0, TracePlot::tr("Time since Start (min)")};
    return {3600.0, TracePlot::tr("Time since Start (h)")};
}

/// In the key the targets' dashes of all objects in turn, as in the plot.
class TargetKey : public QCPGraph {
public:
    TargetKey(QCustomPlot& plot, QList<QPen> pens)
        : QCPGraph(plot.xAxis, plot.yAxis), m_pens(std::move(pens)) {}

protected:
    void drawLegendIcon(QCPPainter* painter, const QRectF& rect) const override {
        for (const QPen& dashes : m_pens) {
            painter->setPen(dashes);
            painter->drawLine(QLineF(rect.left(), rect.center().y(), rect.right(), rect.center().y()));
        }
    }

private:
    QList<QPen> m_pens;
};

class TraceDrawing {
public:
    TraceDrawing(QCustomPlot& plot, const TraceFigure& figure, const TraceStore& traces)
        : m_plot(plot), m_figure(figure), m_traces(traces), m_shown_s(shownTime()),
          m_time(timeUnit(m_shown_s)) {}

    /// Returns the size of the picture, in units: higher with a long head or legend.
    QSize draw() {
        m_plot.setBackground(Qt::white);
        styleAxis(m_plot.xAxis, m_time.label);
        styleAxis(m_plot.yAxis, quantityAxis(m_figure.quantity, m_figure.unit));
        const int strip = m_figure.moments.isEmpty() ? 4 : kLabelStrip;
        m_plot.axisRect()->setMinimumMargins({12, strip, 20, 0});
        m_plot.addLayer(kUnder, m_plot.layer("main"), QCustomPlot::limBelow);
        m_plot.setCurrentLayer(kUnder);
        if (m_figure.quantity == Quantity::Temperature)
            for (std::size_t i = 0; i < m_traces.objects(); ++i)
                addTarget(i);
        addPrediction();
        m_plot.setCurrentLayer("main");
        for (std::size_t i = 0; i < seriesCount(m_figure.quantity, m_traces.objects()); ++i)
            addSeries(i); // first in the key, over the others in the plot
        m_plot.setCurrentLayer(kUnder);
        for (qsizetype k = 0; k < m_figure.overlays.size(); ++k)
            addOverlay(static_cast<int>(k));
        addRight();
        m_plot.setCurrentLayer("main");
        setTimeRange();
        setRange(m_plot.yAxis, m_figure.quantity, m_left, m_figure.yRange);
        if (m_figure.quantity == Quantity::Error)
            addZero();
        for (const FigureMoment& moment : m_figure.moments)
            addMoment(moment);
        addTargetToLegend();
        addLegend(m_plot, legendColumns());
        int above = 0;
        if (m_figure.layout.hasHeading)
            above = addHead(m_plot, m_figure.title, m_figure.note, width());
        else if (!m_figure.corner.isEmpty())
            above = addCorner(m_plot, m_figure.corner, width());
        const int lines = qRound(std::max(kLowest, m_figure.aspect * width()));
        const int key = m_plot.legend->minimumOuterSizeHint().height() + kUnderLegend;
        const int height = above + strip + lines + kUnderLines + key;
        return {width(), height + height % 2}; // whole points
    }

private:
    FigureRange shownTime() const {
        if (m_figure.time_s)
            return *m_figure.time_s;
        FigureRange shown{m_traces.rows() > 0 ? m_traces.time_s(0) : 0.0, m_traces.lastTime_s()};
        for (const FigureOverlay& overlay : m_figure.overlays)
            shown.max = std::max(shown.max, overlay.traces->lastTime_s());
        return shown;
    }

    int width() const { return figureUnits(m_figure.layout.width_mm); }

    double displayed(double value, Quantity quantity, std::size_t series) const {
        if (quantity == Quantity::Speed)
            return 100.0 * value /
                   (series == 0 ? m_figure.limits.translation_m_s : m_figure.limits.rotation_rad_s);
        return displayedQuantity(value, quantity, m_figure.unit);
    }

    static bool isOfRun(Quantity quantity) { return plottedColumn(quantity) == nullptr; }

    static QColor colorOf(Quantity quantity, int index) {
        if (!isOfRun(quantity))
            return seriesColor(index, false);
        return index == 0 ? themePalette(false).color(QPalette::Text) : accentColor(false);
    }

    QPen pen(int series) const {
        if (!m_figure.overlays.isEmpty()) // dashes tell the runs apart then
            return {colorOf(m_figure.quantity, series), 1.6};
        if (!isOfRun(m_figure.quantity))
            return seriesPen(series, false, 1.6);
        QPen line(colorOf(m_figure.quantity, series), 1.4);
        if (series == 1)
            line.setDashPattern({6, 2.5});
        return line;
    }

    /// What the legend calls a line; with the name of its run if there are several.
    QString nameOf(const QString& run, const QString& line) const {
        return m_figure.overlays.isEmpty() || run.isEmpty() ? line : run + QStringLiteral(" \u00b7 ") + line;
    }

    static QString lineName(Quantity quantity, std::size_t series, const QStringList& objects) {
        return isOfRun(quantity) ? quantitySeries(quantity, series)
                                 : objects.value(static_cast<qsizetype>(series));
    }

    QCPGraph* addLine(const TraceStore& traces, Quantity quantity, std::size_t series, QCPAxis* axis) {
        const TraceStore::Line line =
            traces.line(quantity, series, m_shown_s.min, m_shown_s.max, kLinePixels, m_reads);
        QVector<QCPGraphData> data;
        data.reserve(static_cast<qsizetype>(line.values.size()));
        for (std::size_t k = 0; k < line.values.size(); ++k) {
            const double value = displayed(line.values[k], quantity, series);
            data << QCPGraphData(line.times_s[k] / m_time.length_s, value);
            if (line.times_s[k] >= m_shown_s.min && line.times_s[k] <= m_shown_s.max)
                take(axis == m_plot.yAxis2 ? m_right : m_left, value);
        }
        QCPGraph* graph = m_plot.addGraph(m_plot.xAxis, axis);
        graph->data()->set(data, true);
        graph->setAdaptiveSampling(true);
        return graph;
    }

    /// A few along the line.
    void addMarkers(QCPGraph* graph, int object) const {
        if (m_figure.overlays.isEmpty())
            return;
        graph->setScatterStyle(figureMarker(object, graph->pen().color()));
        graph->setScatterSkip(std::max(0, graph->dataCount() / kMarkersOfLine - 1));
    }

    void addSeries(std::size_t series) {
        QCPGraph* graph = addLine(m_traces, m_figure.quantity, series, m_plot.yAxis);
        graph->setPen(pen(static_cast<int>(series)));
        graph->setName(nameOf(m_figure.run, lineName(m_figure.quantity, series, m_figure.names)));
        addMarkers(graph, static_cast<int>(series));
    }

    void addOverlay(int place) {
        const FigureOverlay& overlay = m_figure.overlays[place];
        const auto count = static_cast<int>(seriesCount(m_figure.quantity, overlay.traces->objects()));
        for (int i = 0; i < count; ++i) {
            const auto series = static_cast<std::size_t>(i);
            const QString name = lineName(m_figure.quantity, series, overlay.objects);
            const auto same = static_cast<int>(m_figure.names.indexOf(name)); // in the run underneath
            const int object = same >= 0 ? same : i;
            QPen line(colorOf(m_figure.quantity, object), 1.4);
            line.setCapStyle(Qt::FlatCap);
            line.setDashPattern(TracePlot::overlayDashes(place)); // as on the screen
            QCPGraph* graph = addLine(*overlay.traces, m_figure.quantity, series, m_plot.yAxis);
            graph->setPen(line);
            graph->setName(nameOf(overlay.run, name));
            addMarkers(graph, object);
        }
    }

    void addRight() {
        if (!m_figure.right)
            return;
        styleAxis(m_plot.yAxis2, quantityAxis(*m_figure.right, m_figure.unit));
        m_plot.yAxis2->setVisible(true);
        const auto count = static_cast<int>(seriesCount(*m_figure.right, m_traces.objects()));
        for (int i = 0; i < count; ++i) {
            QCPGraph* graph = addLine(m_traces, *m_figure.right, static_cast<std::size_t>(i), m_plot.yAxis2);
            QPen line(colorOf(*m_figure.right, i), 1.5);
            line.setCapStyle(Qt::FlatCap);
            line.setDashPattern(dotGroups(i));
            graph->setPen(line);
            graph->setName(
                nameOf(m_figure.run, lineName(*m_figure.right, static_cast<std::size_t>(i), m_figure.names) +
                                         QStringLiteral(" \u25b8")));
        }
        setRange(m_plot.yAxis2, *m_figure.right, m_right, {});
    }

    void addPrediction() {
        for (int i = 0; i < m_figure.prediction.lines.size(); ++i) {
            QCPGraph* graph = m_plot.addGraph();
            graph->removeFromLegend();
            for (const QPointF& point : m_figure.prediction.lines[i]) {
                graph->addData(point.x() / m_time.length_s, point.y());
                if (point.x() >= m_shown_s.min && point.x() <= m_shown_s.max)
                    take(m_left, point.y());
            }
            graph->setPen(predictionPen(seriesColor(i, false)));
        }
        if (!m_figure.prediction.lines.isEmpty())
            addLegendEntry(m_plot, m_figure.prediction.name, predictionPen(secondaryText(false)));
    }

    static QPen predictionPen(const QColor& color) {
        QPen line(mixed(color, Qt::white, 0.75), 1.0);
        line.setCapStyle(Qt::FlatCap);
        line.setDashPattern({1.5, 4.0});
        return line;
    }

    QCPGraph* addSteps(const std::vector<std::pair<double, double>>& steps, double shift_K) {
        QCPGraph* graph = m_plot.addGraph();
        graph->setLineStyle(QCPGraph::lsStepLeft);
        graph->removeFromLegend();
        for (const auto& [time_s, target_K] : steps)
            graph->addData(time_s / m_time.length_s, displayed(target_K + shift_K, Quantity::Temperature, 0));
        if (!steps.empty())
            graph->addData(std::max(m_shown_s.max, steps.back().first) / m_time.length_s,
                           displayed(steps.back().second + shift_K, Quantity::Temperature, 0));
        return graph;
    }

    /// Dashed, with its band; dashes of objects with one target take turns.
    void addTarget(std::size_t object) {
        const auto& steps = m_traces.targetSteps(object);
        bool isShaded = false; // with an object of the same targets
        for (std::size_t other = 0; other < object && !isShaded; ++other)
            isShaded = m_traces.targetSteps(other) == steps;
        if (!isShaded) {
            QCPGraph* low = addSteps(steps, -m_figure.band_K);
            QCPGraph* high = addSteps(steps, m_figure.band_K);
            for (QCPGraph* edge : {low, high})
                edge->setPen(Qt::NoPen);
            high->setBrush(kBandColor);
            high->setChannelFillGraph(low);
        }
        addSteps(steps, 0.0)->setPen(penOfTarget(object));
        for (std::size_t k = 0; k < steps.size(); ++k) {
            const bool isOver = k + 1 < steps.size() && steps[k + 1].first < m_shown_s.min;
            if (!isOver && steps[k].first <= m_shown_s.max)
                for (const double shift_K : {-m_figure.band_K, m_figure.band_K})
                    take(m_left, displayed(steps[k].second + shift_K, Quantity::Temperature, 0));
        }
    }

    /// Where errors have their target, with the band.
    void addZero() {
        shadeAboutZero(m_plot, displayDifference(m_figure.band_K, m_figure.unit));
        auto* line = new QCPItemStraightLine(&m_plot);
        line->setLayer(QStringLiteral("background"));
        line->point1->setCoords(0.0, 0.0);
        line->point2->setCoords(1.0, 0.0);
        line->setPen(zeroPen());
    }

    QPen penOfTarget(std::size_t object) const {
        QPen line(seriesColor(static_cast<int>(object), false), 1.1);
        line.setCapStyle(Qt::FlatCap);
        line.setDashPattern({5.0, std::max(4.0, 5.0 * (static_cast<double>(m_traces.objects()) - 1.0))});
        line.setDashOffset(5.0 * static_cast<double>(object));
        return line;
    }

    static QPen zeroPen() {
        QPen line(secondaryText(false), 1.1);
        line.setCapStyle(Qt::FlatCap);
        line.setDashPattern({5.0, 4.0});
        return line;
    }

    void addTargetToLegend() {
        if (m_figure.quantity != Quantity::Temperature && m_figure.quantity != Quantity::Error)
            return;
        QList<QPen> pens{zeroPen()};
        if (m_figure.quantity == Quantity::Temperature) {
            pens.clear();
            for (std::size_t i = 0; i < m_traces.objects(); ++i)
                pens << penOfTarget(i);
        }
        (new TargetKey(m_plot, std::move(pens)))->setName(TracePlot::tr("target"));
        const QString band = formatDifference(m_figure.band_K, m_figure.unit).mid(1); // without its sign
        addLegendEntry(m_plot, TracePlot::tr("band of \u00b1%1", "%1 is 0.5 K").arg(band), Qt::NoPen,
                       kBandColor);
    }

    static void take(FigureRange& range, double value) {
        if (!std::isfinite(value))
            return;
        range.min = std::min(range.min, value);
        range.max = std::max(range.max, value);
    }

    void setTimeRange() {
        const double from = m_shown_s.min / m_time.length_s, to = m_shown_s.max / m_time.length_s;
        if (m_figure.time_s)
            m_plot.xAxis->setRange(from, to);
        else
            m_plot.xAxis->setRange(std::min(from, 0.0), 1.01 * std::max(to, 1e-3));
    }

    static void setRange(QCPAxis* axis, Quantity quantity, const FigureRange& taken,
                         const std::optional<FigureRange>& wanted) {
        if (wanted)
            return axis->setRange(wanted->min, wanted->max);
        FigureRange range = taken.min <= taken.max ? taken : FigureRange{};
        if (quantity == Quantity::Speed)
            range = {0.0, std::max(range.max, 100.0)};
        const double margin = 0.06 * std::max(range.max - range.min, 1e-3 * std::abs(range.max) + 1e-9);
        axis->setRange(range.min - margin, range.max + margin);
    }

    /// As many as the longest name leaves room for.
    int legendColumns() const {
        const QFontMetricsF metrics(figureFont(kSmallLetters));
        double widest = 1.0;
        for (int i = 0; i < m_plot.legend->itemCount(); ++i)
            if (auto* item = qobject_cast<QCPPlottableLegendItem*>(m_plot.legend->item(i)))
                widest = std::max(widest, metrics.horizontalAdvance(item->plottable()->name()));
        return std::clamp(static_cast<int>((width() - 2.0 * kBeside) / (widest + kLegendIcon)), 1, 3);
    }

    void addMoment(const FigureMoment& moment) {
        if (!m_plot.xAxis->range().contains(moment.time_s / m_time.length_s))
            return;
        auto* line = new QCPItemLine(&m_plot);
        auto* label = new QCPItemText(&m_plot);
        int side = 0;
        for (QCPItemPosition* end : {line->start, line->end, label->position}) {
            end->setTypeX(QCPItemPosition::ptPlotCoords);
            end->setTypeY(QCPItemPosition::ptAxisRectRatio);
            end->setCoords(moment.time_s / m_time.length_s, side++ == 0 ? 1.0 : 0.0);
        }
        line->setPen(QPen(secondaryText(false), 1, Qt::DotLine));
        label->setClipToAxisRect(false);
        label->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        label->setPadding({0, 0, 0, 2});
        label->setFont(figureFont(kSmallLetters));
        label->setColor(secondaryText(false));
        label->setText(moment.label);
    }

    QCustomPlot& m_plot;
    const TraceFigure& m_figure;
    const TraceStore& m_traces;
    FigureRange m_shown_s;
    TimeUnit m_time;
    int m_reads = kReads;                              ///< how many are left
    FigureRange m_left = kNothing, m_right = kNothing; ///< of the shown values
};

} // namespace

QByteArray traceFigure(const TraceFigure& figure, const TraceStore& traces, FigureFormat format,
                       const QString& comment) {
    QCustomPlot plot;
    const QSize size = TraceDrawing(plot, figure, traces).draw();
    return pictureOf(plot, size, format, comment);
}

} // namespace bask
