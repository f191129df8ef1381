#include "widgets/plots/trace_canvas.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/plots/quantity_words.h"

#include <QLabel>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kMaxPoints =
    1600; ///< stretches in a picture; more would want more blocks than a recorded run keeps

constexpr std::size_t kFineStretch = 3; // px
constexpr int kReadsPerFrame = 3;       // blocks of a recorded run, 3 ms each
constexpr double kAfterEnd_s = 1.0;     // of a run, until it has no values any more

/// The value of a run at its newest sample until a time; NaN if the run was over by then.
double valueAt(const TraceStore& traces, Quantity quantity, std::size_t series, double time_s) {
    const std::size_t row = traces.rowAt(time_s);
    return row < traces.rows() && time_s <= traces.lastTime_s() + kAfterEnd_s
               ? traces.value(quantity, series, row)
               : std::numeric_limits<double>::quiet_NaN();
}

/// "0:04.5", of a time that is rounded to that.
QString momentToATenth(double time_s) {
    if (!std::isfinite(time_s))
        return kNoValue;
    const double whole_s = std::floor(time_s + 0.05);
    return formatDuration(whole_s) + QLocale().decimalPoint() +
           QString::number(std::lround(10.0 * (time_s - whole_s)));
}

} // namespace

TracePlot::Canvas::Canvas(TracePlot* plot) : QCustomPlot(plot), owner(plot) {
    setObjectName(QStringLiteral("tracePlotCanvas"));
    setFocusPolicy(Qt::NoFocus); // the plot around it has the focus
    setMouseTracking(true);
    setPlottingHint(QCP::phFastPolylines);
    setNotAntialiasedElements(QCP::aeGrid | QCP::aeAxes);
    setNoAntialiasingOnDrag(true);
    addLayer(QStringLiteral("labels"), layer(QStringLiteral("axes")), limAbove);
    addLayer(QStringLiteral("cursor"), layer(QStringLiteral("labels")), limAbove);
    layer(QStringLiteral("cursor"))->setMode(QCPLayer::lmBuffered);

    auto ticker = QSharedPointer<QCPAxisTickerTime>::create();
    ticker->setTimeFormat(QStringLiteral("%m:%s"));
    ticker->setFieldWidth(QCPAxisTickerTime::tuMinutes, 1);
    xAxis->setTicker(ticker);
    xAxis->setRange(0.0, 60.0);
    axisRect()->setAutoMargins(QCP::msBottom);
    axisRect()->setRangeDrag(Qt::Horizontal);
    axisRect()->setRangeZoomFactor(0.8);

    m_reference = new QCPItemStraightLine(this);
    m_errorBand = new QCPItemRect(this);
    m_errorBand->setLayer(QStringLiteral("background"));
    m_empty = new QCPItemText(this);
    m_empty->setLayer(QStringLiteral("labels"));
    m_empty->position->setType(QCPItemPosition::ptAxisRectRatio);
    m_empty->position->setCoords(0.5, 0.5);
    m_empty->setClipToAxisRect(false);
    m_predictionText = new QCPItemText(this);
    m_predictionText->setLayer(QStringLiteral("labels"));
    m_predictionText->position->setType(QCPItemPosition::ptAbsolute);
    for (QCPItemLine** line : {&m_position, &m_pinned, &m_cursor}) {
        *line = new QCPItemLine(this);
        (*line)->setLayer(QStringLiteral("cursor"));
        (*line)->setVisible(false);
        for (QCPItemPosition* end : {(*line)->start, (*line)->end}) {
            end->setTypeX(QCPItemPosition::ptPlotCoords);
            end->setTypeY(QCPItemPosition::ptAxisRectRatio);
        }
    }
    m_readout = new QLabel(this);
    m_readout->setObjectName(QStringLiteral("tracePlotReadout"));
    m_readout->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_readout->setTextFormat(Qt::RichText);
    m_readout->setAutoFillBackground(true);
    m_readout->setMargin(5);
    m_readout->hide();
    connectInteraction();
}

void TracePlot::Canvas::setObjects(const QStringList& objects) {
    names = objects;
    prediction = {}; // it was of others
    clearData();
    rebuild();
}

void TracePlot::Canvas::setQuantity(Quantity wanted) {
    quantity = wanted;
    m_valueAuto = true;
    setRight(rightAxis.quantity);
}

void TracePlot::Canvas::setUnit(TemperatureUnit wanted) {
    if (unit == wanted)
        return;
    unit = wanted;
    m_valueAuto = true;
    rebuild();
}

void TracePlot::Canvas::setLimits(const SpeedLimits& wanted) {
    limits = wanted;
    rebuild();
}

void TracePlot::Canvas::clearData() {
    traces->reset(static_cast<std::size_t>(names.size()));
    clearMarkers();
    pinCursor(std::nullopt);
    hideCursor();
    m_valueAuto = true;
    for (QCPGraph* graph : m_series)
        graph->data()->clear();
    m_pointsAreOld = true;
    setFollow(true);
    schedule();
    if (std::exchange(isPredictionOfNext, false))
        rebuild();
}

void TracePlot::Canvas::setRun(std::shared_ptr<RecordedSession> run) {
    clearData();
    traces->show(std::move(run));
    rebuild();
}

QString TracePlot::Canvas::seriesName(int series) const {
    return isOfRun() ? quantitySeries(quantity, static_cast<std::size_t>(series)) : names.value(series);
}

bool TracePlot::Canvas::isOfRun() const {
    return plottedColumn(quantity) == nullptr;
}

double TracePlot::Canvas::displayed(double value) const {
    return displayedQuantity(value, quantity, unit);
}

QList<QPointF> TracePlot::Canvas::allPoints(Quantity of, int series) const {
    constexpr double kEver = std::numeric_limits<double>::infinity();
    int reads = std::numeric_limits<int>::max();
    QList<QPointF> points;
    for (const QCPGraphData& point :
         pointsOf(*traces, of, series, {-kEver, kEver}, std::numeric_limits<std::size_t>::max(), reads))
        points.append({point.key, point.value});
    return points;
}

void TracePlot::Canvas::rebuild() {
    clearGraphs();
    m_series.clear();
    m_targets.clear();
    m_bandLow.clear();
    m_bandHigh.clear();
    for (QCPItemText* label : std::as_const(m_labels))
        removeItem(label);
    m_labels.clear();

    const auto count = static_cast<int>(bask::seriesCount(quantity, traces->objects()));
    if (quantity == Quantity::Temperature) {
        for (int i = 0; i < count; ++i) {
            m_bandLow << addGraph();
            m_bandHigh << addGraph();
            m_bandHigh.back()->setChannelFillGraph(m_bandLow.back());
            m_targets << addGraph();
            for (QCPGraph* graph : {m_bandLow.back(), m_bandHigh.back(), m_targets.back()})
                graph->setLineStyle(QCPGraph::lsStepLeft);
        }
    }
    rebuildPrediction();
    rebuildOverlays(); // under the lines of the run itself
    rebuildRight();
    for (int i = 0; i < count; ++i) {
        QCPGraph* graph = addGraph();
        graph->setAdaptiveSampling(true);
        graph->setName(seriesName(i));
        m_series << graph;
        m_labels << makeLineLabel();
    }
    m_pointsAreOld = true;
    retranslate();
    restyle(dark);
}

double TracePlot::Canvas::factor(Quantity of, int series) const {
    if (of != Quantity::Speed)
        return 1.0;
    return 100.0 / (series == 0 ? limits.translation_m_s : limits.rotation_rad_s);
}

/// Gives the lines the points of the visible time.
void TracePlot::Canvas::updatePoints() {
    const QCPRange range = xAxis->range();
    const int width = std::clamp(axisRect()->width(), 1, kMaxPoints);
    if (!m_pointsAreOld && range == m_pointsRange && width == m_pointsWidth)
        return;
    // Where the overview is nearly as fine as the screen, the samples are read when the picture rests.
    const bool isFine = std::cmp_greater(traces->samplesBetween(range.lower, range.upper) * kFineStretch,
                                         width * TraceOverview::kStretch);
    int reads = isFine && range != m_pointsRange ? 0 : kReadsPerFrame;
    m_pointsRange = range;
    m_pointsWidth = width;
    for (int i = 0; i < m_series.size(); ++i)
        fillGraph(m_series[i], *traces, quantity, i, reads);
    for (const Overlay& overlay : overlays)
        for (int i = 0; i < overlay.graphs.size(); ++i)
            fillGraph(overlay.graphs[i], overlay.traces, quantity, i, reads);
    for (int i = 0; i < rightAxis.graphs.size(); ++i)
        fillGraph(rightAxis.graphs[i], *traces, *rightAxis.quantity, i, reads);
    m_pointsAreOld = false;
    m_isUnread = reads < 0;
    if (m_isUnread)
        schedule();
}

QVector<QCPGraphData> TracePlot::Canvas::pointsOf(const TraceStore& from, Quantity of, int series,
                                                  const QCPRange& time, std::size_t pixels,
                                                  int& reads) const {
    const auto line = from.line(of, static_cast<std::size_t>(series), time.lower, time.upper, pixels, reads);
    QVector<QCPGraphData> points(static_cast<qsizetype>(line.values.size()));
    const double scale = factor(of, series);
    for (std::size_t k = 0; k < line.values.size(); ++k)
        points[static_cast<qsizetype>(k)] = {line.times_s[k],
                                             displayedQuantity(line.values[k], of, unit) * scale};
    return points;
}

void TracePlot::Canvas::fillGraph(QCPGraph* graph, const TraceStore& from, Quantity of, int series,
                                  int& reads) const {
    const auto pixels = static_cast<std::size_t>(m_pointsWidth);
    graph->data()->set(pointsOf(from, of, series, m_pointsRange, pixels, reads), true);
}

void TracePlot::Canvas::append(const std::vector<TraceSample>& samples) {
    if (traces->append(samples) != traces->rows())
        showNewSamples();
}

void TracePlot::Canvas::showNewSamples() {
    m_pointsAreOld = true;
    schedule();
}

/// Targets are steps that reach to the newest sample; objects with the same steps share one band.
void TracePlot::Canvas::updateTargets() {
    for (qsizetype i = 0; i < m_targets.size(); ++i) {
        const auto& steps = traces->targetSteps(static_cast<std::size_t>(i));
        QVector<double> keys, values, low, high;
        for (const auto& [time_s, target_K] : steps) {
            keys << time_s;
            values << displayTemperature(target_K, unit);
        }
        if (!steps.empty()) {
            keys << std::max(lastTime_s(), xAxis->range().upper);
            values << values.back();
        }
        m_targets[i]->setData(keys, values, true);
        bool shared = false;
        for (qsizetype j = 0; j < i; ++j)
            shared = shared || traces->targetSteps(static_cast<std::size_t>(j)) == steps;
        const double band = displayDifference(kSettledBand_K, unit);
        for (double value : std::as_const(values)) {
            low << value - band;
            high << value + band;
        }
        m_bandLow[i]->setData(shared ? QVector<double>() : keys, shared ? QVector<double>() : low, true);
        m_bandHigh[i]->setData(shared ? QVector<double>() : keys, shared ? QVector<double>() : high, true);
    }
}

/// Least and greatest value wanted on the value axis for the visible time, with the quantity's own fixed
/// points.
std::pair<double, double> TracePlot::Canvas::wantedValueRange() const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto include = [&](double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    };
    const QCPRange time = xAxis->range();
    QList<QCPGraph*> graphs = m_series + m_predicted + m_spreads;
    for (const Overlay& overlay : overlays)
        graphs << overlay.graphs;
    for (const QCPGraph* graph : std::as_const(graphs)) {
        const auto points = graph->data();
        for (auto it = points->findBegin(time.lower); it != points->findEnd(time.upper); ++it)
            include(it->value);
    }
    const double kelvin = displayDifference(1.0, unit);
    double smallest = 0.0;
    if (quantity == Quantity::Temperature)
        for (std::size_t i = 0; i < traces->objects(); ++i) {
            const auto& steps = traces->targetSteps(i);
            for (std::size_t k = 0; k < steps.size(); ++k) {
                const bool over = k + 1 < steps.size() && steps[k + 1].first < time.lower;
                if (!over && steps[k].first <= time.upper) {
                    include(displayTemperature(steps[k].second - 2.0 * kSettledBand_K, unit));
                    include(displayTemperature(steps[k].second + 2.0 * kSettledBand_K, unit));
                }
            }
        }
    switch (quantityShownAs(quantity)) {
    case ShownAs::Temperature:
        smallest = 2.0 * kelvin;
        break;
    case ShownAs::Difference:
        include(-1.0 * kelvin);
        include(1.0 * kelvin);
        break;
    case ShownAs::RatePerMinute:
        include(0.0);
        smallest = 2.0 * kelvin;
        break;
    case ShownAs::Number:
        include(0.0);
        if (quantity == Quantity::Speed)
            include(100.0);
        if (quantity == Quantity::ViewFactor)
            smallest = 0.1;
        if (quantity == Quantity::Shade)
            include(5.0);
        break;
    }
    if (!(low <= high)) // nothing to show yet
        return quantityShownAs(quantity) == ShownAs::Temperature
                   ? std::pair{displayTemperature(293.15, unit), displayTemperature(323.15, unit)}
                   : std::pair{0.0, 1.0};
    if (high - low < smallest) {
        const double centre = 0.5 * (low + high);
        low = centre - 0.5 * smallest;
        high = centre + 0.5 * smallest;
    }
    const double span = std::max(high - low, 1e-12);
    const bool fromZero = low == 0.0;
    return {fromZero ? 0.0 : low - 0.06 * span, high + 0.06 * span};
}

std::optional<double> TracePlot::Canvas::momentAt(double time_s) const {
    const TraceStore* longest = traces.get();
    for (const Overlay& overlay : overlays) // one that goes on after the end of those before it
        if (time_s > longest->lastTime_s() && overlay.traces.lastTime_s() > longest->lastTime_s())
            longest = &overlay.traces;
    const std::size_t row = longest->rowAt(time_s);
    if (row >= longest->rows() || !std::isfinite(longest->time_s(row))) // not finite: of a damaged file
        return std::nullopt;
    return longest->time_s(row);
}

QList<TracePlot::Canvas::ReadValue> TracePlot::Canvas::readout(double time_s,
                                                               std::optional<double> from_s) const {
    const std::optional<double> then_s = momentAt(time_s);
    if (!then_s)
        return {};
    const std::optional<double> first_s = from_s ? momentAt(*from_s) : std::nullopt;
    const auto withChange = [](const QString& first, const QString& then, const QString& change) {
        return QStringLiteral("%1 \u2192 %2 (\u0394 %3)").arg(first, then, change);
    };
    QList<ReadValue> out{{formatDuration(*then_s), {}}};
    if (first_s) {
        const double rounded_s = roundedTo(*first_s, 1), thenRounded_s = roundedTo(*then_s, 1);
        out[0].words = withChange(momentToATenth(rounded_s), momentToATenth(thenRounded_s),
                                  formatSigned(thenRounded_s - rounded_s, 1) + QStringLiteral("\u00a0s"));
    }
    const auto add = [&](const QString& name, const QColor& color, const TraceStore& from, Quantity of,
                         int index) {
        const auto series = static_cast<std::size_t>(index);
        const double value = valueAt(from, of, series, *then_s);
        QString text = quantityText(value, of, series, unit);
        if (first_s) {
            const QuantityChange change =
                quantityChange(valueAt(from, of, series, *first_s), value, of, series, unit);
            text = withChange(change.first, change.then, change.by);
        }
        out.append({QStringLiteral("%1 %2").arg(name, text), color});
    };
    const QString own = overlays.empty() ? QString() : u' ' + kOwnMark;
    for (int i = 0; i < m_series.size(); ++i)
        add(seriesName(i) + own, penOfSeries(i).color(), *traces, quantity, i);
    for (int i = 0; i < rightAxis.graphs.size(); ++i)
        add(rightName(i) + own, penOfRight(i).color(), *traces, *rightAxis.quantity, i);
    for (const Overlay& overlay : overlays)
        for (int i = 0; i < overlay.graphs.size(); ++i)
            add(overlayName(overlay, i) + u' ' + overlay.mark, overlay.graphs[i]->pen().color(),
                overlay.traces, quantity, i);
    return out;
}

} // namespace bask
