#include "widgets/plots/figure_traces.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr std::size_t kLinePixels = 2000; // a line shows least and greatest values within each

struct TimeUnit {
    double length_s;
    QString label;
};

TimeUnit timeUnit(double end_s) {
    if (end_s <= 900.0)
        return {1.0, TracePlot::tr("Time since Start (s)")};
    if (end_s <= 4.0 * 3600.0)
        return {60.0, TracePlot::tr("Time since Start (min)")};
    return {3600.0, TracePlot::tr("Time since Start (h)")};
}

class TraceDrawing {
public:
    TraceDrawing(QCustomPlot& plot, const TraceFigure& figure, const TraceStore& traces)
        : m_plot(plot), m_figure(figure), m_traces(traces), m_time(timeUnit(traces.lastTime_s())) {}

    void draw() {
        m_plot.setBackground(Qt::white);
        styleAxis(m_plot.xAxis, m_time.label);
        styleAxis(m_plot.yAxis, quantityAxis(m_figure.quantity, m_figure.unit));
        m_plot.axisRect()->setMinimumMargins({12, 4, 20, 0});
        if (m_figure.quantity == Quantity::Temperature)
            for (std::size_t i = 0; i < m_traces.objects(); ++i)
                addTarget(i);
        for (std::size_t i = 0; i < seriesCount(m_figure.quantity, m_traces.objects()); ++i)
            addSeries(i);
        setRanges();
        if (m_figure.quantity == Quantity::Error)
            shadeAboutZero(m_plot, displayDifference(m_figure.band_K, m_figure.unit));
        for (const FigureMoment& moment : m_figure.moments)
            addMoment(moment);
        addLegend(m_plot);
        addHead(m_plot, m_figure.title, m_figure.note);
    }

private:
    double displayed(double value, std::size_t series) const {
        if (m_figure.quantity == Quantity::Speed)
            return 100.0 * value /
                   (series == 0 ? m_figure.limits.translation_m_s : m_figure.limits.rotation_rad_s);
        return displayedQuantity(value, m_figure.quantity, m_figure.unit);
    }

    bool isOfRun() const { return plottedColumn(m_figure.quantity) == nullptr; }

    QPen pen(std::size_t series) const {
        if (!isOfRun())
            return seriesPen(static_cast<int>(series), false, 1.6);
        QPen line(series == 0 ? themePalette(false).color(QPalette::Text) : accentColor(false), 1.4);
        if (series == 1)
            line.setDashPattern({6, 2.5});
        return line;
    }

    void addSeries(std::size_t series) {
        int reads = std::numeric_limits<int>::max();
        const double from_s = m_traces.rows() > 0 ? m_traces.time_s(0) : 0.0;
        const TraceStore::Line line =
            m_traces.line(m_figure.quantity, series, from_s, m_traces.lastTime_s(), kLinePixels, reads);
        QVector<QCPGraphData> data;
        data.reserve(static_cast<qsizetype>(line.values.size()));
        for (std::size_t k = 0; k < line.values.size(); ++k) {
            const double value = displayed(line.values[k], series);
            data << QCPGraphData(line.times_s[k] / m_time.length_s, value);
            take(value);
        }
        QCPGraph* graph = m_plot.addGraph();
        graph->data()->set(data, true);
        graph->setPen(pen(series));
        graph->setAdaptiveSampling(true);
        graph->setName(isOfRun() ? quantitySeries(m_figure.quantity, series)
                                 : m_figure.names.value(static_cast<qsizetype>(series)));
    }

    QCPGraph* addSteps(const std::vector<std::pair<double, double>>& steps, double shift_K) {
        QCPGraph* graph = m_plot.addGraph();
        graph->setLineStyle(QCPGraph::lsStepLeft);
        graph->removeFromLegend();
        for (const auto& [time_s, target_K] : steps)
            graph->addData(time_s / m_time.length_s, displayed(target_K + shift_K, 0));
        if (!steps.empty())
            graph->addData(m_traces.lastTime_s() / m_time.length_s,
                           displayed(steps.back().second + shift_K, 0));
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
            high->setBrush(QColor(0, 0, 0, 22));
            high->setChannelFillGraph(low);
        }
        QPen line(seriesColor(static_cast<int>(object), false), 1.1);
        line.setCapStyle(Qt::FlatCap);
        line.setDashPattern({5.0, std::max(4.0, 5.0 * (static_cast<double>(m_traces.objects()) - 1.0))});
        line.setDashOffset(5.0 * static_cast<double>(object));
        addSteps(steps, 0.0)->setPen(line);
        for (const auto& step : steps)
            for (const double shift_K : {-m_figure.band_K, m_figure.band_K})
                take(displayed(step.second + shift_K, 0));
    }

    void take(double value) {
        if (!std::isfinite(value))
            return;
        m_min = std::min(m_min, value);
        m_max = std::max(m_max, value);
    }

    void setRanges() {
        const double end = std::max(m_traces.lastTime_s() / m_time.length_s, 1e-3);
        m_plot.xAxis->setRange(0.0, 1.01 * end);
        if (m_traces.rows() > 0 && m_traces.time_s(0) < 0.0)
            m_plot.xAxis->setRangeLower(m_traces.time_s(0) / m_time.length_s);
        FigureRange needed = m_min <= m_max ? FigureRange{m_min, m_max} : FigureRange{};
        if (m_figure.quantity == Quantity::Speed)
            needed = {0.0, std::max(needed.max, 100.0)};
        const FigureRange range = m_figure.yRange.value_or(needed);
        const double margin = 0.06 * std::max(range.max - range.min, 1e-9);
        m_plot.yAxis->setRange(range.min - margin, range.max + margin);
    }

    void addMoment(const FigureMoment& moment) {
        auto* line = new QCPItemLine(&m_plot);
        auto* label = new QCPItemText(&m_plot);
        int side = 0;
        for (QCPItemPosition* end : {line->start, line->end, label->position}) {
            end->setTypeX(QCPItemPosition::ptPlotCoords);
            end->setTypeY(QCPItemPosition::ptAxisRectRatio);
            end->setCoords(moment.time_s / m_time.length_s, side++ == 0 ? 1.0 : 0.0);
        }
        line->setPen(QPen(secondaryText(false), 1, Qt::DotLine));
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setPadding({3, 1, 2, 0});
        label->setFont(figureFont(11));
        label->setColor(secondaryText(false));
        label->setText(moment.label);
    }

    QCustomPlot& m_plot;
    const TraceFigure& m_figure;
    const TraceStore& m_traces;
    TimeUnit m_time;
    double m_min = 1e300, m_max = -1e300;
};

} // namespace

QByteArray traceFigure(const TraceFigure& figure, const TraceStore& traces, FigureFormat format,
                       const QString& comment) {
    QCustomPlot plot;
    TraceDrawing(plot, figure, traces).draw();
    return pictureOf(plot, figure.size_px, format, comment);
}

} // namespace bask
