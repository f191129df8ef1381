#include "widgets/review/metric_comparison.h"

#include "engine/base/message_arg.h"
#include "engine/recording/csv_field.h"
#include "widgets/common/display.h"
#include "widgets/common/metric_words.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

struct ComparisonWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Comparison)
};

constexpr double kSourceAlike_K = 5.0; // a source swings about its set point
constexpr int kDigitsInFiles = 15;     // of a number that is rounded
constexpr int kDigitsOfDeviation = 2;

/// What a run tells of a metric.
struct Told {
    std::optional<double> value{};     ///< in SI
    std::optional<double> deviation{}; ///< of the value
    std::optional<double> uncertainty{};
    double shown = std::numeric_limits<double>::quiet_NaN();
    int decimals = 0, finest = 0; ///< of what is shown, and what it may have at the finest
    int decimalsInFiles = 0;
};

/// `text` and `difference` tell how a number is shown with so many decimals, `inFiles` what it is in files.
template <class Text, class Difference, class InFiles>
void addCells(ComparedMetric& metric, const std::vector<Told>& runs, std::size_t reference, const Text& text,
              const Difference& difference, const InFiles& inFiles) {
    std::vector<double> shown;
    shown.reserve(runs.size());
    int decimals = 0, finest = 0, decimalsInFiles = 0;
    for (const Told& told : runs) {
        shown.push_back(told.shown);
        decimals = std::max(decimals, told.decimals);
        finest = std::max(finest, told.finest);
        decimalsInFiles = std::max(decimalsInFiles, told.decimalsInFiles);
    }
    decimals = std::clamp(decimalsWithDifferences(shown, shown[reference], decimals), decimals,
                          std::max(decimals, finest));
    const auto inFile = [&](double value) { return roundedTo(inFiles(value), decimalsInFiles); };
    for (std::size_t k = 0; k < runs.size(); ++k) {
        ComparedMetric::Cell cell{text(k, decimals), k == reference ? QString() : kNoValue};
        if (runs[k].value)
            cell.value = inFile(*runs[k].value);
        cell.deviation = runs[k].deviation;
        cell.uncertainty = runs[k].uncertainty;
        if (k != reference && runs[k].value && runs[reference].value) {
            cell.differenceBy =
                roundedTo(inFile(*runs[k].value) - inFile(*runs[reference].value), decimalsInFiles);
            if (runs[k].uncertainty && runs[reference].uncertainty)
                cell.differenceUncertainty = std::hypot(*runs[k].uncertainty, *runs[reference].uncertainty);
            cell.difference =
                difference(roundedTo(shown[k], decimals) - roundedTo(shown[reference], decimals),
                           cell.differenceUncertainty, decimals);
        }
        metric.cells.push_back(std::move(cell));
    }
}

QStringList allObjects(const std::vector<ComparedRun>& runs) {
    QStringList names;
    for (const ComparedRun& run : runs)
        for (const QString& name : run.objects)
            if (!names.contains(name))
                names << name;
    return names;
}

ComparedMetric compared(ObjectMetric metric, const QString& object, const std::vector<ComparedRun>& runs,
                        std::size_t reference, double band_K, TemperatureUnit unit) {
    ComparedMetric out{
        metricName(metric), metricDefinition(metric, band_K, unit), metricNameInFiles(metric), object, {}};
    std::vector<Told> all;
    all.reserve(runs.size());
    const auto indexIn = [&object](const ComparedRun& run) { // none is beyond all others
        return static_cast<std::size_t>(run.objects.indexOf(object));
    };
    const auto isThere = [&indexIn](const ComparedRun& run) {
        return run.metrics && indexIn(run) < run.metrics->objects.size();
    };
    for (const ComparedRun& run : runs) {
        Told told;
        if (isThere(run)) {
            const std::size_t index = indexIn(run);
            told.value = metricValue(metric, *run.metrics, index);
            told.deviation = metricDeviation(metric, *run.metrics, index);
            told.uncertainty = metricUncertainty(metric, *run.metrics, index);
            told.decimals = metricDecimals(metric, *run.metrics, index, unit);
            told.finest = metricFinestDecimals(metric, *run.metrics);
            told.decimalsInFiles = metricDecimalsInFiles(metric, *run.metrics);
        }
        if (told.value)
            told.shown = metricShown(metric, *told.value, unit);
        all.push_back(told);
    }
    addCells(
        out, all, reference,
        [&](std::size_t k, int decimals) {
            return isThere(runs[k]) ? metricText(metric, *runs[k].metrics, indexIn(runs[k]), unit, decimals)
                                    : kNoValue;
        },
        [&](double by, std::optional<double> uncertainty, int decimals) {
            return metricDifferenceText(metric, by, uncertainty, unit, decimals);
        },
        [&](double value) { return metricValueInFiles(metric, value); });
    return out;
}

ComparedMetric compared(RunMetric metric, const std::vector<ComparedRun>& runs, std::size_t reference) {
    ComparedMetric out{metricName(metric), metricDefinition(metric), metricNameInFiles(metric), {}, {}};
    std::vector<Told> all;
    all.reserve(runs.size());
    for (const ComparedRun& run : runs) {
        Told told;
        if (run.metrics) {
            told.value = metricValue(metric, *run.metrics);
            told.decimals = metricDecimals(metric, *run.metrics);
            told.finest = metricFinestDecimals(metric, *run.metrics);
            told.decimalsInFiles = metricDecimalsInFiles(metric, *run.metrics);
        }
        if (told.value)
            told.shown = metricShown(metric, *told.value);
        all.push_back(told);
    }
    addCells(
        out, all, reference,
        [&](std::size_t k, int decimals) {
            return runs[k].metrics ? metricText(metric, *runs[k].metrics, decimals) : kNoValue;
        },
        [&](double by, std::optional<double>, int decimals) {
            return metricDifferenceText(metric, by, decimals);
        },
        [](double value) { return value; });
    return out;
}

std::string numberInFiles(const std::optional<double>& value, int digits = kDigitsInFiles) {
    return value ? formatNumber(*value + 0.0, digits) : std::string(); // no minus zero
}

/// "steady-state error s.d. (K)", "final standard uncertainty (K)"
QString nameOfSpread(const ComparedMetric& metric, const QString& what) {
    return QString(metric.nameInFiles)
        .replace(QStringLiteral(" ("), u' ' + what + QStringLiteral(" ("))
        .replace(QStringLiteral("(degC)"), QStringLiteral("(K)"));
}

} // namespace

std::vector<ComparedMetric> compareMetrics(const std::vector<ComparedRun>& runs, std::size_t reference,
                                           TemperatureUnit unit) {
    if (runs.empty())
        return {};
    double band_K = kSettledBand_K;
    bool hasTruth = false;
    for (const ComparedRun& run : runs)
        if (run.metrics) {
            band_K = run.metrics->band_K;
            hasTruth = hasTruth || !run.metrics->trueObjects.empty();
        }
    std::vector<ComparedMetric> out;
    const QStringList objects = allObjects(runs);
    for (const ObjectMetric metric : objectMetrics(hasTruth))
        for (const QString& object : objects)
            out.push_back(compared(metric, object, runs, reference, band_K, unit));
    for (const RunMetric metric : kRunMetrics)
        out.push_back(compared(metric, runs, reference));
    return out;
}

QStringList unlikeSteps(const std::vector<ComparedRun>& runs, TemperatureUnit unit) {
    QStringList out;
    for (const QString& object : allObjects(runs)) {
        QStringList steps;
        double min_K = std::numeric_limits<double>::infinity(), max_K = -min_K, band_K = 0.0;
        for (const ComparedRun& run : runs) {
            const auto index = static_cast<std::size_t>(run.objects.indexOf(object));
            const std::optional<double> step_K =
                run.metrics ? metricValue({ObjectMetric::Step}, *run.metrics, index) : std::nullopt;
            if (!step_K)
                continue;
            min_K = std::min(min_K, *step_K);
            max_K = std::max(max_K, *step_K);
            band_K = run.metrics->band_K;
            steps << run.mark + u' ' + metricText({ObjectMetric::Step}, *run.metrics, index, unit);
        }
        if (max_K - min_K > 2.0 * band_K)
            out << ComparisonWords::tr("%1: %2", "object; its steps in the runs")
                       .arg(object, steps.join(listSeparator()));
    }
    return out;
}

QString unlikeSources(const std::vector<ComparedRun>& runs, TemperatureUnit unit) {
    QStringList sources;
    double min_K = std::numeric_limits<double>::infinity(), max_K = -min_K;
    for (const ComparedRun& run : runs) {
        const double source_K = run.metrics && run.metrics->samples > 0
                                    ? run.metrics->first.source_K
                                    : std::numeric_limits<double>::quiet_NaN();
        if (!std::isfinite(source_K))
            continue;
        min_K = std::min(min_K, source_K);
        max_K = std::max(max_K, source_K);
        sources << run.mark + u' ' + formatTemperature(source_K, unit, 0);
    }
    return max_K - min_K > kSourceAlike_K ? sources.join(listSeparator()) : QString();
}

QString differenceName(const ComparedRun& run, const ComparedRun& reference) {
    return QStringLiteral("%1 \u2212 %2").arg(run.mark, reference.mark);
}

QString comparisonText(const std::vector<ComparedRun>& runs, std::size_t reference,
                       const std::vector<ComparedMetric>& metrics) {
    QStringList header{ComparisonWords::tr("Metric"), ComparisonWords::tr("Object")};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        header << runs[k].name;
        if (k != reference)
            header << differenceName(runs[k], runs[reference]);
    }
    QStringList lines{header.join(u'\t')};
    for (const ComparedMetric& metric : metrics) {
        QStringList cells{metric.name, metric.object};
        for (std::size_t k = 0; k < metric.cells.size(); ++k) {
            cells << metric.cells[k].text;
            if (k != reference)
                cells << metric.cells[k].difference;
        }
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n');
}

std::string comparisonCsv(const std::vector<ComparedRun>& runs, std::size_t reference,
                          const std::vector<ComparedMetric>& metrics) {
    std::string header = kComparisonMark;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const QString difference = QStringLiteral("%1 - %2").arg(runs[k].mark, runs[reference].mark);
        header += ',' + csvField(runs[k].name.toStdString());
        header += k == reference ? std::string() : ',' + csvField(difference.toStdString());
    }
    std::string text = header + '\n';
    for (const ComparedMetric& metric : metrics) {
        std::string values, deviations, uncertainties;
        for (std::size_t k = 0; k < metric.cells.size(); ++k) {
            const ComparedMetric::Cell& cell = metric.cells[k];
            values.append(1, ',').append(numberInFiles(cell.value));
            if (k != reference)
                values.append(1, ',').append(numberInFiles(cell.differenceBy));
            deviations.append(1, ',').append(numberInFiles(cell.deviation, kDigitsOfDeviation));
            deviations += k == reference ? "" : ",";
            uncertainties.append(1, ',').append(numberInFiles(cell.uncertainty, kDigitsOfDeviation));
            if (k != reference)
                uncertainties.append(1, ',').append(
                    numberInFiles(cell.differenceUncertainty, kDigitsOfDeviation));
        }
        const std::string object = ',' + csvField(metric.object.toStdString());
        text.append(csvField(metric.nameInFiles.toStdString())).append(object).append(values).append(1, '\n');
        const auto addSpread = [&](const char* what, const std::string& numbers) {
            const QString name = nameOfSpread(metric, QLatin1String(what));
            text.append(csvField(name.toStdString())).append(object).append(numbers).append(1, '\n');
        };
        if (std::ranges::any_of(metric.cells, [](const auto& cell) { return cell.deviation.has_value(); }))
            addSpread("s.d.", deviations);
        if (std::ranges::any_of(metric.cells, [](const auto& cell) { return cell.uncertainty.has_value(); }))
            addSpread("standard uncertainty", uncertainties);
    }
    return text;
}

} // namespace bask
