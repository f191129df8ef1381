#pragma once
// The metrics of several runs beside each other, with their differences from one of them.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// How an exported comparison begins.
inline constexpr const char* kComparisonMark = "metric,object";

struct ComparedRun {
    QString mark;                        ///< "B"
    QString name;                        ///< "B evening"
    QString path;                        ///< of its file
    QStringList objects;                 ///< names, in the order of the metrics
    std::optional<RunMetrics> metrics{}; ///< empty: not computed yet, or cannot be read
    bool isFailed = false;               ///< they cannot be read
};

/// A metric of one object, or of a run as a whole.
struct ComparedMetric {
    struct Cell {
        QString text;                         ///< as on the Metrics page; a dash if the run does not have it
        QString difference;                   ///< from the reference, signed; a dash if one has no number
        std::optional<double> value{};        ///< in the unit of nameInFiles, rounded to what means something
        std::optional<double> deviation{};    ///< standard deviation of the value, in K
        std::optional<double> uncertainty{};  ///< standard uncertainty of the value, in SI
        std::optional<double> differenceBy{}; ///< of the rounded values
        /// of the difference, as if the two runs had nothing in common: root of the sum of squares
        std::optional<double> differenceUncertainty{};
    };
    QString name, definition, nameInFiles;
    QString object;          ///< empty: of the whole run
    std::vector<Cell> cells; ///< one for each run
};

/// Objects are matched by their names: all that any run has, in their order in the first run that has them.
/// `reference` is the index of the run that the others are compared with. The metrics are taken as they are.
std::vector<ComparedMetric> compareMetrics(const std::vector<ComparedRun>& runs, std::size_t reference,
                                           TemperatureUnit unit);

/// Returns the steps of objects that are not alike in the runs, by more than twice the band within which a
/// run is settled: "circle: A +15.0 K, B +25.0 K". Times and overshoots of such steps tell little of each
/// other.
QStringList unlikeSteps(const std::vector<ComparedRun>& runs, TemperatureUnit unit);

/// Returns how hot the source was at Start, "A 200 °C, B 31 °C", if the runs differ in that by more than they
/// do within one; else an empty string.
QString unlikeSources(const std::vector<ComparedRun>& runs, TemperatureUnit unit);

/// Returns the name of the column of differences: "B − A".
QString differenceName(const ComparedRun& run, const ComparedRun& reference);

/// Returns the table as people see it, tab-separated.
QString comparisonText(const std::vector<ComparedRun>& runs, std::size_t reference,
                       const std::vector<ComparedMetric>& metrics);
/// Returns the table with numbers only, as CSV in English; unknown ones are empty. Standard deviations and
/// uncertainties are rows of their own under that of their values, where any is known.
std::string comparisonCsv(const std::vector<ComparedRun>& runs, std::size_t reference,
                          const std::vector<ComparedMetric>& metrics);

} // namespace bask
