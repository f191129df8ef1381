// The predicted run behind the measured one of a trace plot: pale dotted lines in the objects' colours, each
// in the band that other noise of the sensors would make of it.

#include "widgets/common/theme.h"
#include "widgets/plots/trace_canvas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr double kAfterSettling_s = 30.0; // shown of what is predicted
constexpr float kSpreadWeight = 0.15F;    // opacity of a band
constexpr double kFromLines = 4.0;        // px, of the words

} // namespace

void TracePlot::Canvas::setPrediction(const PredictedRun& run) {
    if (prediction.samples.empty() && run.samples.empty())
        return;
    prediction = run;
    isPredictionOfNext = traces->rows() > 0;
    rebuild();
}

void TracePlot::Canvas::showPrediction(bool visible) {
    if (isPredictionShown == visible)
        return;
    isPredictionShown = visible;
    rebuild();
}

/// One of the next run would run through the traces of the last: it waits until they are gone.
bool TracePlot::Canvas::hasPrediction() const {
    return isPredictionShown && !isPredictionOfNext && !prediction.samples.empty();
}

/// The graphs go with clearGraphs().
void TracePlot::Canvas::rebuildPrediction() {
    m_predicted.clear();
    m_spreads.clear();
    if (!hasPrediction() || quantity != Quantity::Temperature)
        return;
    for (std::size_t i = 0; i < traces->objects(); ++i) {
        QVector<double> keys, values;
        for (const PredictedSample& sample : prediction.samples) {
            keys << sample.time_s;
            values << (i < sample.temperatures_K.size() ? displayed(sample.temperatures_K[i])
                                                        : std::numeric_limits<double>::quiet_NaN());
        }
        addSpread(i, keys);
        m_predicted << addGraph();
        m_predicted.back()->setData(keys, values, true);
    }
}

void TracePlot::Canvas::addSpread(std::size_t object, const QVector<double>& keys) {
    QVector<double> lowest, highest;
    for (const PredictedSample& sample : prediction.samples)
        if (object < sample.lowest_K.size() && object < sample.highest_K.size()) {
            lowest << displayed(sample.lowest_K[object]);
            highest << displayed(sample.highest_K[object]);
        }
    if (lowest.size() != keys.size())
        return;
    for (const QVector<double>& edge : {lowest, highest}) {
        m_spreads << addGraph();
        m_spreads.back()->setData(keys, edge, true);
        m_spreads.back()->setPen(Qt::NoPen);
    }
    m_spreads.back()->setChannelFillGraph(m_spreads[m_spreads.size() - 2]);
}

void TracePlot::Canvas::stylePrediction() {
    for (int i = 0; i < m_predicted.size(); ++i) {
        QPen pen(paleSeriesColor(i, dark), 1.0);
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({1.5, 4.0}); // sparser than those of any object's measured line
        m_predicted[i]->setPen(pen);
    }
    for (int i = 1; i < m_spreads.size(); i += 2) {
        QColor band = seriesColor(i / 2, dark);
        band.setAlphaF(kSpreadWeight);
        m_spreads[i]->setBrush(band);
    }
}

QString TracePlot::Canvas::predictionWords() const {
    if (m_predicted.isEmpty())
        return {};
    switch (prediction.end) {
    case PredictedEnd::Settled:
        return m_spreads.isEmpty() ? TracePlot::tr("predicted")
                                   : TracePlot::tr("predicted; band: other sensor noise only");
    case PredictedEnd::Limit:
        return TracePlot::tr("predicted, not settled by then");
    case PredictedEnd::Cut:
        return TracePlot::tr("predicted, not computed further");
    case PredictedEnd::Fault:
        return TracePlot::tr("predicted to end in a fault");
    }
    return {};
}

/// At the end of the lines, under the lowest: what is heated comes from there on the left. Above the highest
/// where there is no room.
void TracePlot::Canvas::placePredictionWords() {
    const QRect area = axisRect()->rect();
    const QFontMetrics metrics(m_predictionText->font());
    const double width = metrics.horizontalAdvance(m_predictionText->text()) + 2.0 * kFromLines;
    double right = area.left(), highest = area.bottom(), lowest = area.top();
    bool isSeen = false;
    for (const QCPGraph* graph : std::as_const(m_predicted)) {
        const auto points = graph->data();
        const auto end = points->findEnd(xAxis->range().upper, false);
        if (end == points->findBegin(xAxis->range().lower, false))
            continue;
        const QCPGraphData& last = *std::prev(end);
        const double y = yAxis->coordToPixel(last.value);
        if (!std::isfinite(y))
            continue;
        isSeen = true;
        right = std::max(right, xAxis->coordToPixel(last.key));
        highest = std::min(highest, y);
        lowest = std::max(lowest, y);
    }
    m_predictionText->setVisible(isSeen);
    const bool isUnder = lowest + kFromLines + metrics.height() <= area.bottom();
    m_predictionText->setPositionAlignment(Qt::AlignRight | (isUnder ? Qt::AlignTop : Qt::AlignBottom));
    const double y = isUnder ? lowest + kFromLines : highest - kFromLines;
    m_predictionText->position->setPixelPosition(
        {std::clamp(right, area.left() + std::min(width, area.width() - 1.0), double(area.right())),
         std::clamp(y, double(area.top()), double(area.bottom()))});
}

double TracePlot::Canvas::wholeEnd_s() const {
    const double last_s = lastTime_s();
    if (!hasPrediction())
        return last_s;
    if (prediction.settling_s)
        return std::max(last_s, std::min(*prediction.settling_s + kAfterSettling_s, prediction.end_s()));
    return traces->rows() == 0 ? prediction.end_s() : last_s;
}

QList<QPointF> TracePlot::Canvas::predictedPoints(int series) const {
    QList<QPointF> points;
    if (series >= 0 && series < m_predicted.size())
        for (const QCPGraphData& point : *m_predicted[series]->data())
            points.append({point.key, point.value});
    return points;
}

} // namespace bask
