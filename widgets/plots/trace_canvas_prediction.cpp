// The predicted run behind the measured one of a trace plot: pale dotted lines in the objects' colours.

#include "widgets/common/theme.h"
#include "widgets/plots/trace_canvas.h"

#include <algorithm>
#include <limits>

namespace bask {
namespace {

constexpr double kAfterSettling_s = 30.0; // shown of what is predicted
constexpr double kPredictedWeight = 0.75; // of the object's colour

} // namespace

void TracePlot::Canvas::setPrediction(const PredictedRun& run) {
    if (prediction.samples.empty() && run.samples.empty())
        return;
    prediction = run;
    m_valueAuto = true;
    rebuild();
}

void TracePlot::Canvas::showPrediction(bool visible) {
    if (isPredictionShown == visible)
        return;
    isPredictionShown = visible;
    rebuild();
}

/// The graphs go with clearGraphs().
void TracePlot::Canvas::rebuildPrediction() {
    m_predicted.clear();
    if (!isPredictionShown || quantity != Quantity::Temperature || prediction.samples.empty())
        return;
    for (std::size_t i = 0; i < traces->objects(); ++i) {
        QVector<double> keys, values;
        for (const PredictedSample& sample : prediction.samples) {
            keys << sample.time_s;
            values << (i < sample.temperatures_K.size() ? displayed(sample.temperatures_K[i])
                                                        : std::numeric_limits<double>::quiet_NaN());
        }
        m_predicted << addGraph();
        m_predicted.back()->setData(keys, values, true);
    }
}

void TracePlot::Canvas::stylePrediction() {
    const QColor ground = themePalette(dark).color(QPalette::Base);
    for (int i = 0; i < m_predicted.size(); ++i) {
        QPen pen(mixed(seriesColor(i, dark), ground, kPredictedWeight), 1.0);
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({1.5, 4.0}); // sparser than those of any object's measured line
        m_predicted[i]->setPen(pen);
    }
}

double TracePlot::Canvas::wholeEnd_s() const {
    const double last_s = lastTime_s();
    if (!isPredictionShown || prediction.samples.empty())
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
