#include "widgets/common/metric_words.h"

#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

namespace bask {
namespace {

struct MetricWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Metrics)
};

QString seconds(double time_s) {
    return MetricWords::tr("%1 s").arg(QLocale().toString(time_s, 'f', 1));
}

QString share(double part) {
    return QLocale().toString(100.0 * part, 'f', 1) + QStringLiteral("\u00a0%");
}

bool isSmallStep(const ObjectMetrics& metrics, double band_K) {
    return metrics.step_K && std::abs(*metrics.step_K) < 2.0 * band_K;
}

QString riseText(const ObjectMetrics& metrics, double band_K) {
    if (metrics.rise_s)
        return seconds(*metrics.rise_s);
    if (!metrics.step_K)
        return MetricWords::tr("start unknown");
    return isSmallStep(metrics, band_K) ? MetricWords::tr("step too small") : MetricWords::tr("not reached");
}

QString overshootText(const ObjectMetrics& metrics, TemperatureUnit unit) {
    if (!metrics.overshoot_K)
        return metrics.step_K ? MetricWords::tr("step too small") : MetricWords::tr("start unknown");
    if (*metrics.overshoot_K <= 0.0)
        return MetricWords::tr("none");
    return QStringLiteral("%1\u00a0%2 (%3)")
        .arg(QLocale().toString(displayDifference(*metrics.overshoot_K, unit), 'f', 2),
             differenceUnitSymbol(unit), share(*metrics.overshootShare()));
}

QString steadyText(const ObjectMetrics& metrics, TemperatureUnit unit) {
    if (!metrics.steadyError_K)
        return MetricWords::tr("not settled");
    const QString mean = formatDifference(*metrics.steadyError_K, unit, 2);
    if (!metrics.steadyDeviation_K)
        return mean;
    const QString deviation = QLocale().toString(displayDifference(*metrics.steadyDeviation_K, unit), 'f', 2);
    return MetricWords::tr("%1 (s.d. %2)", "mean with its unit, standard deviation without")
        .arg(mean, deviation);
}

} // namespace

QString metricName(ObjectMetric metric) {
    switch (metric) {
    case ObjectMetric::Target:
        return MetricWords::tr("Target");
    case ObjectMetric::Final:
        return MetricWords::tr("Final");
    case ObjectMetric::Settling:
        return MetricWords::tr("Settling time");
    case ObjectMetric::Rise:
        return MetricWords::tr("Rise time");
    case ObjectMetric::Overshoot:
        return MetricWords::tr("Overshoot");
    case ObjectMetric::SteadyError:
        return MetricWords::tr("Steady-state error");
    case ObjectMetric::PathLength:
        return MetricWords::tr("Path length");
    }
    return {};
}

QString metricName(RunMetric metric) {
    switch (metric) {
    case RunMetric::Duration:
        return MetricWords::tr("Duration of control");
    case RunMetric::PathLength:
        return MetricWords::tr("Path of the end-effector");
    case RunMetric::Turned:
        return MetricWords::tr("Rotation of the end-effector");
    case RunMetric::VelocityLimit:
        return MetricWords::tr("Time at a velocity limit");
    case RunMetric::Clamped:
        return MetricWords::tr("Time at any limit");
    }
    return {};
}

QString metricDefinition(ObjectMetric metric, double band_K, TemperatureUnit unit) {
    const QString band = QStringLiteral("\u00b1") + formatDifference(band_K, unit).mid(1);
    switch (metric) {
    case ObjectMetric::Target:
        return MetricWords::tr(
            "The last target that was set. The other numbers count from that moment, or from Start "
            "when it was not changed, until Stop.");
    case ObjectMetric::Final:
        return MetricWords::tr(
            "The object's temperature at the last sample until Stop: the simulated object's own, on a "
            "real rig the estimate from its sensor. The other numbers take this temperature, too.");
    case ObjectMetric::Settling:
        return MetricWords::tr("Time until the temperature stays within %1 of the target until Stop.")
            .arg(band);
    case ObjectMetric::Rise:
        return MetricWords::tr(
            "Time between the first crossings of 10 % and of 90 % of the step, which leads from the "
            "temperature when the target was set to the target. Not given for steps under twice the "
            "band.");
    case ObjectMetric::Overshoot:
        return MetricWords::tr(
            "How far the temperature went beyond the target in the direction of the step, and as a "
            "share of the step. Not given for steps under twice the band.");
    case ObjectMetric::SteadyError:
        return MetricWords::tr(
                   "Mean of temperature minus target over the last %1 s until Stop, or since settling where "
                   "that is less, with the standard deviation of the samples.")
            .arg(QLocale().toString(kSteadyWindow_s, 'f', 0));
    case ObjectMetric::PathLength:
        return MetricWords::tr(
            "Length of the path of the object's centre in the robot's base, from Start until Stop.");
    }
    return {};
}

QString metricDefinition(RunMetric metric) {
    switch (metric) {
    case RunMetric::Duration:
        return MetricWords::tr("From Start until Stop.");
    case RunMetric::PathLength:
        return MetricWords::tr(
            "Length of the path of the end-effector's origin in the robot's base, from Start until Stop.");
    case RunMetric::Turned:
        return MetricWords::tr(
            "Sum of the angles by which the end-effector was turned from sample to sample.");
    case RunMetric::VelocityLimit:
        return MetricWords::tr("Time in which the limit of speed or of rotation held the command back.");
    case RunMetric::Clamped:
        return MetricWords::tr(
            "Time in which a limit of any kind held the command back: speed, rotation, acceleration, "
            "clearance or workspace.");
    }
    return {};
}

QString metricText(ObjectMetric metric, const RunMetrics& run, std::size_t object, TemperatureUnit unit) {
    const ObjectMetrics& metrics = run.objects.at(object);
    if (run.samples == 0)
        return MetricWords::tr("no samples");
    switch (metric) {
    case ObjectMetric::Target:
        return formatTemperature(metrics.target_K, unit);
    case ObjectMetric::Final:
        return metrics.final_K ? formatTemperature(*metrics.final_K, unit, 2) : MetricWords::tr("not known");
    case ObjectMetric::Settling:
        return metrics.settling_s ? seconds(*metrics.settling_s) : MetricWords::tr("not settled");
    case ObjectMetric::Rise:
        return riseText(metrics, run.band_K);
    case ObjectMetric::Overshoot:
        return overshootText(metrics, unit);
    case ObjectMetric::SteadyError:
        return steadyText(metrics, unit);
    case ObjectMetric::PathLength:
        return formatLength_mm(metrics.pathLength_m);
    }
    return {};
}

QString metricText(RunMetric metric, const RunMetrics& run) {
    if (run.samples == 0)
        return MetricWords::tr("no samples");
    const auto withShare = [&](double time_s) {
        return run.duration_s > 0.0
                   ? QStringLiteral("%1 (%2)").arg(seconds(time_s), share(time_s / run.duration_s))
                   : seconds(time_s);
    };
    switch (metric) {
    case RunMetric::Duration:
        return seconds(run.duration_s);
    case RunMetric::PathLength:
        return formatLength_mm(run.pathLength_m);
    case RunMetric::Turned:
        return QLocale().toString(degFromRad(run.turned_rad), 'f', 1) + QStringLiteral("\u00a0\u00b0");
    case RunMetric::VelocityLimit:
        return withShare(run.atVelocityLimit_s);
    case RunMetric::Clamped:
        return withShare(run.clamped_s);
    }
    return {};
}

} // namespace bask
