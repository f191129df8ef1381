#include "widgets/common/metric_words.h"

#include "engine/base/unit.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace bask {
namespace {

struct MetricWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Metrics)
};

struct MetricFacts {
    const char* name; ///< English, to be translated; in files in small letters
    Unit unit;
    int decimals; ///< on a screen
};

/// Returns nothing where the metric is of the truth and the recording has none.
const ObjectMetrics* countedFor(ObjectMetric metric, const RunMetrics& run, std::size_t object) {
    const auto& counted = metric.isTrue ? run.trueObjects : run.objects;
    return object < counted.size() ? &counted[object] : nullptr;
}

MetricFacts factsOf(ObjectMetric::Kind kind) {
    switch (kind) {
    case ObjectMetric::Target:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Target"), unit::kCelsius, 1};
    case ObjectMetric::Step:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Step"), unit::kKelvin, 1};
    case ObjectMetric::Final:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Final"), unit::kCelsius, 2};
    case ObjectMetric::Settling:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Settling time"), unit::kSeconds, 1};
    case ObjectMetric::Rise:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Rise time"), unit::kSeconds, 1};
    case ObjectMetric::Overshoot:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Overshoot"), unit::kKelvin, 2};
    case ObjectMetric::SteadyError:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Steady-state error"), unit::kKelvin, 2};
    case ObjectMetric::PathLength:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Path length"), unit::kMillimetres, 1};
    }
    return {};
}

MetricFacts factsOf(RunMetric metric) {
    switch (metric) {
    case RunMetric::Duration:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Duration of control"), unit::kSeconds, 1};
    case RunMetric::PathLength:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Path of the end-effector"), unit::kMillimetres, 1};
    case RunMetric::Turned:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Rotation of the end-effector"), unit::kDegrees, 1};
    case RunMetric::VelocityLimit:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Time at a velocity limit"), unit::kSeconds, 1};
    case RunMetric::Clamped:
        return {QT_TRANSLATE_NOOP("bask::Metrics", "Time at any limit"), unit::kSeconds, 1};
    }
    return {};
}

bool isIn(const Unit& unit, const Unit& other) {
    return std::string_view(unit.suffix) == other.suffix;
}

/// A number with its unit, neither of which is a temperature's.
QString withUnit(const QString& number, const Unit& unit) {
    if (isIn(unit, unit::kSeconds))
        return MetricWords::tr("%1 s").arg(number);
    return number + QChar(0x00a0) + QString::fromUtf8(unit.symbol);
}

/// Decimals that mean something: times to a part of the sampling period, readings to their resolution.
int finestDecimals(const MetricFacts& facts, const RunMetrics& run, bool isTrue = false) {
    constexpr int kFinest = 6;
    if (isIn(facts.unit, unit::kSeconds) && run.period_s > 0.0)
        return std::clamp(1 - static_cast<int>(std::floor(std::log10(run.period_s))), 0, kFinest);
    const bool isTemperature = isIn(facts.unit, unit::kCelsius) || isIn(facts.unit, unit::kKelvin);
    if (isTemperature && !isTrue && run.resolution_K > 0.0)
        return std::min(facts.decimals, decimalsOf(run.resolution_K, 1).value_or(facts.decimals));
    return facts.decimals;
}

/// A path of 9716 mm is not known to a tenth of one.
int decimalsFor(const MetricFacts& facts, double shown) {
    return std::abs(shown) < 1000.0 ? facts.decimals : 0;
}

double shownValue(const MetricFacts& facts, double value, TemperatureUnit unit) {
    if (isIn(facts.unit, unit::kCelsius))
        return displayTemperature(value, unit);
    if (isIn(facts.unit, unit::kKelvin))
        return displayDifference(value, unit);
    return value * facts.unit.symbolPerSi;
}

QString valueText(const MetricFacts& facts, double value, int decimals) {
    const double shown = roundedTo(value * facts.unit.symbolPerSi, decimals);
    return withUnit(QLocale().toString(shown, 'f', decimals), facts.unit);
}

QString differenceText(const MetricFacts& facts, double shown, TemperatureUnit unit, int decimals) {
    const QString number = formatSigned(shown, decimals);
    const bool isTemperature = isIn(facts.unit, unit::kCelsius) || isIn(facts.unit, unit::kKelvin);
    return isTemperature ? number + QChar(0x00a0) + differenceUnitSymbol(unit) : withUnit(number, facts.unit);
}

QString nameInFiles(const MetricFacts& facts, const char* kind = "") {
    const bool isTemperature = isIn(facts.unit, unit::kCelsius);
    const QString unit =
        isTemperature ? QString::fromUtf8(facts.unit.words) : QString::fromStdString(siUnit(facts.unit));
    return QStringLiteral("%1%2 (%3)")
        .arg(QLatin1String(kind), QString::fromUtf8(facts.name).toLower(), unit);
}

/// More of them in SI than on a screen.
int decimalsOfUnit(const MetricFacts& facts) {
    return static_cast<int>(std::ceil(std::log10(facts.unit.symbolPerSi)));
}

QString share(double part) {
    return QLocale().toString(100.0 * part, 'f', 1) + QStringLiteral("\u00a0%");
}

bool isSmallStep(const ObjectMetrics& metrics, double band_K) {
    return metrics.step_K && std::abs(*metrics.step_K) < 2.0 * band_K;
}

bool isOfTime(ObjectMetric::Kind kind) {
    return kind == ObjectMetric::Settling || kind == ObjectMetric::Rise;
}

/// Returns as many decimals as show two digits of an uncertainty, not more than usual; what is usual without
/// one.
int decimalsBy(std::optional<double> shownUncertainty, int usual) {
    const auto first = decimalsOf(shownUncertainty.value_or(0.0), 0);
    return first ? std::min(usual, *first + 1) : usual;
}

/// A difference of temperatures, or a time, with two digits: " \u00b1 0.15 K"; empty without one. An infinite
/// one is put into words.
QString plusMinusText(ObjectMetric::Kind kind, std::optional<double> uncertainty, TemperatureUnit unit) {
    if (!uncertainty)
        return {};
    if (std::isinf(*uncertainty))
        return MetricWords::tr(", not sure", "after a number");
    const bool isTime = isOfTime(kind);
    const double shown = isTime ? *uncertainty : displayDifference(*uncertainty, unit);
    const auto first = decimalsOf(shown, 0);
    if (!first)
        return {};
    const QString number = QLocale().toString(shown, 'f', *first + 1);
    return QStringLiteral(" \u00b1 ") + (isTime ? MetricWords::tr("%1 s").arg(number)
                                                : number + QChar(0x00a0) + differenceUnitSymbol(unit));
}

/// With the time of a target that was changed during the run.
QString stepText(const ObjectMetrics& metrics, double period_s, TemperatureUnit unit, int decimals) {
    if (!metrics.step_K)
        return MetricWords::tr("start unknown");
    QString step = formatDifference(*metrics.step_K, unit, decimals);
    if (metrics.from_s <= period_s) // of the targets at Start
        return step;
    return MetricWords::tr("%1 at %2 s", "difference of temperatures; time of the run")
        .arg(step, QLocale().toString(metrics.from_s, 'f', 0));
}

QString riseText(const ObjectMetrics& metrics, double band_K, int decimals) {
    if (metrics.rise_s)
        return valueText(factsOf(ObjectMetric::Rise), *metrics.rise_s, decimals) +
               plusMinusText(ObjectMetric::Rise, metrics.riseUncertainty_s, TemperatureUnit::Kelvin);
    if (!metrics.step_K)
        return MetricWords::tr("start unknown");
    return isSmallStep(metrics, band_K) ? MetricWords::tr("step too small") : MetricWords::tr("not reached");
}

QString overshootText(const ObjectMetrics& metrics, TemperatureUnit unit, int decimals) {
    if (!metrics.overshoot_K)
        return metrics.step_K ? MetricWords::tr("step too small") : MetricWords::tr("start unknown");
    if (*metrics.overshoot_K <= 0.0)
        return MetricWords::tr("none");
    const double shown = roundedTo(displayDifference(*metrics.overshoot_K, unit), decimals);
    return QStringLiteral("%1\u00a0%2%3 (%4)")
        .arg(QLocale().toString(shown, 'f', decimals), differenceUnitSymbol(unit),
             plusMinusText(ObjectMetric::Overshoot, metrics.readingUncertainty_K, unit),
             share(*metrics.overshootShare()));
}

/// By the standard deviation, if there is one.
int steadyDecimals(const ObjectMetrics& metrics, TemperatureUnit unit) {
    constexpr int kFinest = 3;
    const int usual = factsOf(ObjectMetric::SteadyError).decimals;
    return std::min(
        kFinest,
        decimalsOf(displayDifference(metrics.steadyDeviation_K.value_or(0.0), unit), usual).value_or(usual));
}

QString steadyText(const ObjectMetrics& metrics, TemperatureUnit unit, int decimals) {
    if (!metrics.steadyError_K)
        return MetricWords::tr("not settled");
    const QString mean = formatDifference(*metrics.steadyError_K, unit, decimals) +
                         plusMinusText(ObjectMetric::SteadyError, metrics.steadyUncertainty_K, unit);
    if (!metrics.steadyDeviation_K) // of one sample
        return mean;
    const double smallest = std::pow(10.0, -decimals),
                 deviation = displayDifference(*metrics.steadyDeviation_K, unit);
    const QString number = QLocale().toString(std::max(smallest, deviation), 'f', decimals);
    return MetricWords::tr("%1 (s.d. %2)", "mean with its unit, standard deviation without")
        .arg(mean, deviation < 0.5 * smallest ? QStringLiteral("<\u00a0") + number : number);
}

} // namespace

std::vector<ObjectMetric> objectMetrics(bool hasTruth) {
    std::vector<ObjectMetric> out;
    for (const ObjectMetric metric : kReadMetrics) {
        out.push_back(metric);
        for (const ObjectMetric truth : kTrueMetrics)
            if (hasTruth && truth.kind == metric.kind)
                out.push_back(truth);
    }
    return out;
}

QString metricName(ObjectMetric metric) {
    const QString name = MetricWords::tr(factsOf(metric.kind).name);
    return metric.isTrue ? MetricWords::tr("%1, true", "a metric by the true temperature").arg(name) : name;
}

QString metricName(RunMetric metric) {
    return MetricWords::tr(factsOf(metric).name);
}

QString metricDefinition(ObjectMetric metric, double band_K, TemperatureUnit unit) {
    if (metric.isTrue)
        return MetricWords::tr("The same by the simulated object's own temperature, which no sensor tells.");
    const QString band = QStringLiteral("\u00b1") + formatDifference(band_K, unit).mid(1);
    switch (metric.kind) {
    case ObjectMetric::Target:
        return MetricWords::tr(
            "The last target that was set. The other numbers count from that moment, or from Start "
            "when it was not changed, until Stop.");
    case ObjectMetric::Step:
        return MetricWords::tr(
            "The target minus the temperature when it was set: at Start, or at the time beside it where the "
            "target was changed during the run. Times, overshoot and steady-state error are of this step.");
    case ObjectMetric::Final:
        return MetricWords::tr(
            "What the object's thermometer read at the last sample until Stop. The other numbers take its "
            "readings, too. \u00b1 is the standard uncertainty: of a sensor that of the room's temperature "
            "to which it was zeroed, of its zeroing, and of step and noise of its readings, without its own "
            "error away from the room's temperature and that of its contact.");
    case ObjectMetric::Settling:
        return MetricWords::tr(
                   "Time until the temperature stays within %1 of the target until Stop. The event "
                   "\"All objects settled\" is another and comes later: when all objects have been "
                   "so near for %2 s by the controller's estimates, and the robot needs no other place. "
                   "\u00b1 is its standard uncertainty: how far readings that are wrong by theirs move that "
                   "moment, and the period. Not sure: with such an error it would be outside at the end.")
            .arg(band, QLocale().toString(kRunSettledAfter_s, 'f', 0));
    case ObjectMetric::Rise:
        return MetricWords::tr(
            "Time between the first crossings of 10 % and of 90 % of the step, which leads from the "
            "temperature when the target was set to the target. Not given for steps under twice the "
            "band. \u00b1 is its standard uncertainty: how far wrong readings at the beginning and at both "
            "crossings move these.");
    case ObjectMetric::Overshoot:
        return MetricWords::tr(
            "How far the temperature went beyond the target in the direction of the step, and as a "
            "share of the step. Not given for steps under twice the band.");
    case ObjectMetric::SteadyError:
        return MetricWords::tr(
                   "Mean of temperature minus target over the last %1 s until Stop, or since settling where "
                   "that is less, with its standard uncertainty (\u00b1) and the standard deviation of the "
                   "samples.")
            .arg(QLocale().toString(kSteadyWindow_s, 'f', 0));
    case ObjectMetric::PathLength:
        return MetricWords::tr(
            "Length of the path of the object's centre in the robot's base, from Start until Stop, by the "
            "robot's reported places, whose uncertainty no device tells.");
    }
    return {};
}

QString metricDefinition(RunMetric metric) {
    switch (metric) {
    case RunMetric::Duration:
        return MetricWords::tr("From Start until Stop.");
    case RunMetric::PathLength:
        return MetricWords::tr(
            "Length of the path of the end-effector's origin in the robot's base, from Start until Stop, by "
            "the robot's reported places, whose uncertainty no device tells.");
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

int metricDecimals(ObjectMetric metric, const RunMetrics& run, std::size_t object, TemperatureUnit unit) {
    const MetricFacts facts = factsOf(metric.kind);
    const ObjectMetrics* const counted = countedFor(metric, run, object);
    const auto uncertainty = metricUncertainty(metric, run, object);
    if (uncertainty && isOfTime(metric.kind))
        return decimalsBy(uncertainty, facts.decimals);
    if (uncertainty)
        return decimalsBy(displayDifference(*uncertainty, unit), facts.decimals);
    if (counted != nullptr && metric.kind == ObjectMetric::SteadyError)
        return steadyDecimals(*counted, unit);
    if (counted != nullptr && metric.kind == ObjectMetric::PathLength)
        return decimalsFor(facts, counted->pathLength_m * facts.unit.symbolPerSi);
    return metric.kind == ObjectMetric::Target ? facts.decimals : finestDecimals(facts, run, metric.isTrue);
}

int metricDecimals(RunMetric metric, const RunMetrics& run) {
    const MetricFacts facts = factsOf(metric);
    return isIn(facts.unit, unit::kSeconds)
               ? finestDecimals(facts, run)
               : decimalsFor(facts, metricValue(metric, run).value_or(0.0) * facts.unit.symbolPerSi);
}

int metricFinestDecimals(ObjectMetric metric, const RunMetrics& run) {
    return finestDecimals(factsOf(metric.kind), run, metric.isTrue);
}

int metricFinestDecimals(RunMetric metric, const RunMetrics& run) {
    return finestDecimals(factsOf(metric), run);
}

int metricDecimalsInFiles(ObjectMetric metric, const RunMetrics& run) {
    const MetricFacts facts = factsOf(metric.kind);
    const bool isTemperature = isIn(facts.unit, unit::kCelsius) || isIn(facts.unit, unit::kKelvin);
    constexpr int kTemperature = 3; // more than on a screen: a reader may take differences
    return isTemperature ? kTemperature : finestDecimals(facts, run) + decimalsOfUnit(facts);
}

int metricDecimalsInFiles(RunMetric metric, const RunMetrics& run) {
    const MetricFacts facts = factsOf(metric);
    return finestDecimals(facts, run) + decimalsOfUnit(facts);
}

double metricShown(ObjectMetric metric, double value, TemperatureUnit unit) {
    return shownValue(factsOf(metric.kind), value, unit);
}

double metricShown(RunMetric metric, double value) {
    return shownValue(factsOf(metric), value, TemperatureUnit::Kelvin); // none is a temperature
}

QString metricText(ObjectMetric metric, const RunMetrics& run, std::size_t object, TemperatureUnit unit,
                   std::optional<int> decimals) {
    if (run.samples == 0)
        return MetricWords::tr("no samples");
    const ObjectMetrics* const counted = countedFor(metric, run, object);
    if (counted == nullptr)
        return MetricWords::tr("not known");
    const ObjectMetrics& metrics = *counted;
    const MetricFacts facts = factsOf(metric.kind);
    const int with = decimals.value_or(metricDecimals(metric, run, object, unit));
    switch (metric.kind) {
    case ObjectMetric::Target:
        return formatTemperature(metrics.target_K, unit, with);
    case ObjectMetric::Step:
        return stepText(metrics, run.period_s, unit, with);
    case ObjectMetric::Final:
        return metrics.final_K ? formatTemperature(*metrics.final_K, unit, with) +
                                     plusMinusText(metric.kind, metrics.readingUncertainty_K, unit)
                               : MetricWords::tr("not known");
    case ObjectMetric::Settling:
        return metrics.settling_s ? valueText(facts, *metrics.settling_s, with) +
                                        plusMinusText(metric.kind, metrics.settlingUncertainty_s, unit)
                                  : MetricWords::tr("not settled");
    case ObjectMetric::Rise:
        return riseText(metrics, run.band_K, with);
    case ObjectMetric::Overshoot:
        return overshootText(metrics, unit, with);
    case ObjectMetric::SteadyError:
        return steadyText(metrics, unit, with);
    case ObjectMetric::PathLength:
        return valueText(facts, metrics.pathLength_m, with);
    }
    return {};
}

QString metricText(RunMetric metric, const RunMetrics& run, std::optional<int> decimals) {
    const std::optional<double> value = metricValue(metric, run);
    if (!value)
        return MetricWords::tr("no samples");
    const QString text = valueText(factsOf(metric), *value, decimals.value_or(metricDecimals(metric, run)));
    const bool isPartOfTime = metric == RunMetric::VelocityLimit || metric == RunMetric::Clamped;
    return isPartOfTime && run.duration_s > 0.0
               ? QStringLiteral("%1 (%2)").arg(text, share(*value / run.duration_s))
               : text;
}

std::optional<double> metricValue(ObjectMetric metric, const RunMetrics& run, std::size_t object) {
    const ObjectMetrics* const counted = countedFor(metric, run, object);
    if (run.samples == 0 || counted == nullptr)
        return std::nullopt;
    const ObjectMetrics& metrics = *counted;
    switch (metric.kind) {
    case ObjectMetric::Target:
        return std::isfinite(metrics.target_K) ? std::optional(metrics.target_K) : std::nullopt;
    case ObjectMetric::Step:
        return metrics.step_K;
    case ObjectMetric::Final:
        return metrics.final_K;
    case ObjectMetric::Settling:
        return metrics.settling_s;
    case ObjectMetric::Rise:
        return metrics.rise_s;
    case ObjectMetric::Overshoot:
        return metrics.overshoot_K;
    case ObjectMetric::SteadyError:
        return metrics.steadyError_K;
    case ObjectMetric::PathLength:
        return metrics.pathLength_m;
    }
    return std::nullopt;
}

std::optional<double> metricValue(RunMetric metric, const RunMetrics& run) {
    if (run.samples == 0)
        return std::nullopt;
    switch (metric) {
    case RunMetric::Duration:
        return run.duration_s;
    case RunMetric::PathLength:
        return run.pathLength_m;
    case RunMetric::Turned:
        return run.turned_rad;
    case RunMetric::VelocityLimit:
        return run.atVelocityLimit_s;
    case RunMetric::Clamped:
        return run.clamped_s;
    }
    return std::nullopt;
}

std::optional<double> metricDeviation(ObjectMetric metric, const RunMetrics& run, std::size_t object) {
    const ObjectMetrics* const counted = countedFor(metric, run, object);
    return counted != nullptr && metric.kind == ObjectMetric::SteadyError ? counted->steadyDeviation_K
                                                                          : std::nullopt;
}

std::optional<double> metricUncertainty(ObjectMetric metric, const RunMetrics& run, std::size_t object) {
    const ObjectMetrics* const counted = countedFor(metric, run, object);
    if (counted == nullptr || !metricValue(metric, run, object))
        return std::nullopt;
    switch (metric.kind) {
    case ObjectMetric::Final:
        return counted->readingUncertainty_K;
    case ObjectMetric::Overshoot:
        return *counted->overshoot_K > 0.0 ? counted->readingUncertainty_K : std::nullopt;
    case ObjectMetric::SteadyError:
        return counted->steadyUncertainty_K;
    case ObjectMetric::Settling:
        return counted->settlingUncertainty_s;
    case ObjectMetric::Rise:
        return counted->riseUncertainty_s;
    case ObjectMetric::Target:
    case ObjectMetric::Step:
    case ObjectMetric::PathLength:
        break;
    }
    return std::nullopt;
}

QString metricDifferenceText(ObjectMetric metric, double shown, std::optional<double> uncertainty,
                             TemperatureUnit unit, int decimals) {
    return differenceText(factsOf(metric.kind), shown, unit, decimals) +
           plusMinusText(metric.kind, uncertainty, unit);
}

QString metricDifferenceText(RunMetric metric, double shown, int decimals) {
    return differenceText(factsOf(metric), shown, TemperatureUnit::Kelvin, decimals); // none is a temperature
}

QString metricNameInFiles(ObjectMetric metric) {
    return nameInFiles(factsOf(metric.kind), metric.isTrue ? "true " : "");
}

QString metricNameInFiles(RunMetric metric) {
    return nameInFiles(factsOf(metric));
}

double metricValueInFiles(ObjectMetric metric, double value) {
    return isIn(factsOf(metric.kind).unit, unit::kCelsius) ? celsiusFromKelvin(value) : value;
}

} // namespace bask
