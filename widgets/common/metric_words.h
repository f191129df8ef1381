#pragma once
// The metrics of a run in words: name, definition, and value with its unit or the reason why there is none;
// and their differences between two runs.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QString>

#include <array>
#include <optional>
#include <vector>

namespace bask {

/// Of an object: what is counted, and on which temperature.
struct ObjectMetric {
    enum class Kind { Target, Step, Final, Settling, Rise, Overshoot, SteadyError, PathLength };
    using enum Kind;
    Kind kind;
    bool isTrue = false; ///< on the simulated object's own temperature instead of the readings
};
inline constexpr std::array kReadMetrics{
    ObjectMetric{ObjectMetric::Target},      ObjectMetric{ObjectMetric::Step},
    ObjectMetric{ObjectMetric::Final},       ObjectMetric{ObjectMetric::Settling},
    ObjectMetric{ObjectMetric::Rise},        ObjectMetric{ObjectMetric::Overshoot},
    ObjectMetric{ObjectMetric::SteadyError}, ObjectMetric{ObjectMetric::PathLength}};
inline constexpr std::array kTrueMetrics{
    ObjectMetric{ObjectMetric::Final, true}, ObjectMetric{ObjectMetric::Settling, true},
    ObjectMetric{ObjectMetric::Rise, true}, ObjectMetric{ObjectMetric::Overshoot, true},
    ObjectMetric{ObjectMetric::SteadyError, true}};
/// Returns all of them, in the order of a table; those by the true temperature only where there is one.
std::vector<ObjectMetric> objectMetrics(bool hasTruth);

enum class RunMetric { Duration, PathLength, Turned, VelocityLimit, Clamped };
inline constexpr std::array kRunMetrics{RunMetric::Duration, RunMetric::PathLength, RunMetric::Turned,
                                        RunMetric::VelocityLimit, RunMetric::Clamped};

QString metricName(ObjectMetric metric);
QString metricName(RunMetric metric);
/// Returns the definition in one or two sentences, as in engine/recording/run_metrics.h.
QString metricDefinition(ObjectMetric metric, double band_K, TemperatureUnit unit);
QString metricDefinition(RunMetric metric);
/// Returns "42.0 s", "+0.12 K ± 0.15 K" with the standard uncertainty where it is known, or why there is no
/// value: "not settled"; with metricDecimals() if there are none.
QString metricText(ObjectMetric metric, const RunMetrics& run, std::size_t object, TemperatureUnit unit,
                   std::optional<int> decimals = {});
QString metricText(RunMetric metric, const RunMetrics& run, std::optional<int> decimals = {});

/// Returns the number of metricText() in SI; empty where that says why there is none.
std::optional<double> metricValue(ObjectMetric metric, const RunMetrics& run, std::size_t object);
std::optional<double> metricValue(RunMetric metric, const RunMetrics& run);
/// Returns the standard deviation of such a number, in SI, where it is known: of a mean of samples.
std::optional<double> metricDeviation(ObjectMetric metric, const RunMetrics& run, std::size_t object);
/// Returns the standard uncertainty of such a number, in SI, where it is known.
std::optional<double> metricUncertainty(ObjectMetric metric, const RunMetrics& run, std::size_t object);
/// Returns how many decimals the number has on a screen: where its uncertainty is known, as show two digits
/// of that, or less; else no finer than sampling and sensors tell.
int metricDecimals(ObjectMetric metric, const RunMetrics& run, std::size_t object, TemperatureUnit unit);
int metricDecimals(RunMetric metric, const RunMetrics& run);
/// Returns how many decimals the number of metricValueInFiles() has that mean something.
int metricDecimalsInFiles(ObjectMetric metric, const RunMetrics& run);
int metricDecimalsInFiles(RunMetric metric, const RunMetrics& run);
/// Returns how many decimals it may have on a screen where a printed difference needs them.
int metricFinestDecimals(ObjectMetric metric, const RunMetrics& run);
int metricFinestDecimals(RunMetric metric, const RunMetrics& run);
/// Converts a number of metricValue() to the unit of metricText().
double metricShown(ObjectMetric metric, double value, TemperatureUnit unit);
double metricShown(RunMetric metric, double value);
/// Returns a difference of two such numbers, in that unit, with its standard uncertainty in SI where it is
/// known: "+1.5 s ± 0.4 s".
QString metricDifferenceText(ObjectMetric metric, double shown, std::optional<double> uncertainty,
                             TemperatureUnit unit, int decimals);
QString metricDifferenceText(RunMetric metric, double shown, int decimals);

/// Returns "settling time (s)": the metric in exported tables, in English, with the unit of its numbers
/// there.
QString metricNameInFiles(ObjectMetric metric);
QString metricNameInFiles(RunMetric metric);
/// Converts a number of metricValue(): temperatures are in degC there, all else in SI.
double metricValueInFiles(ObjectMetric metric, double value);

} // namespace bask
