#include "widgets/review/metric_comparison.h"

#include "engine/base/message_arg.h"
#include "engine/recording/csv_field.h"
#include "widgets/common/display.h"
#include "widgets/common/metric_words.h"

#include <QCoreApplication>

namespace bask {
namespace {

struct ComparisonWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Comparison)
};

constexpr int kDigitsInFiles = 10; // significant ones: a difference of doubles has no more to say

/// A number for each run, in SI, where it has one; `text` and `difference` tell how it is shown, `inFiles`
/// what it is in files.
template <class Text, class Difference, class InFiles>
void addCells(ComparedMetric& metric, const std::vector<std::optional<double>>& numbers,
              std::size_t reference, const Text& text, const Difference& difference, const InFiles& inFiles) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        ComparedMetric::Cell cell{text(k), k == reference ? QString() : kNoValue};
        if (numbers[k])
            cell.value = inFiles(*numbers[k]);
        if (k != reference && numbers[k] && numbers[reference]) {
            cell.differenceBy = *numbers[k] - *numbers[reference];
            cell.difference = difference(*cell.differenceBy);
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
    QStringList texts;
    std::vector<std::optional<double>> numbers;
    numbers.reserve(runs.size());
    for (const ComparedRun& run : runs) {
        const auto index = static_cast<std::size_t>(run.objects.indexOf(object)); // none is beyond all others
        const bool isThere = run.metrics && index < run.metrics->objects.size();
        texts << (isThere ? metricText(metric, *run.metrics, index, unit) : kNoValue);
        numbers.push_back(isThere ? metricValue(metric, *run.metrics, index) : std::nullopt);
    }
    addCells(
        out, numbers, reference, [&](std::size_t k) { return texts[static_cast<qsizetype>(k)]; },
        [&](double by) { return metricDifferenceText(metric, by, unit); },
        [&](double value) { return metricValueInFiles(metric, value); });
    return out;
}

ComparedMetric compared(RunMetric metric, const std::vector<ComparedRun>& runs, std::size_t reference) {
    ComparedMetric out{metricName(metric), metricDefinition(metric), metricNameInFiles(metric), {}, {}};
    std::vector<std::optional<double>> numbers;
    for (const ComparedRun& run : runs)
        numbers.push_back(run.metrics ? metricValue(metric, *run.metrics) : std::nullopt);
    addCells(
        out, numbers, reference,
        [&](std::size_t k) { return runs[k].metrics ? metricText(metric, *runs[k].metrics) : kNoValue; },
        [&](double by) { return metricDifferenceText(metric, by); }, [](double value) { return value; });
    return out;
}

std::string numberInFiles(const std::optional<double>& value) {
    return value ? formatNumber(*value, kDigitsInFiles) : std::string();
}

} // namespace

std::vector<ComparedMetric> compareMetrics(const std::vector<ComparedRun>& runs, std::size_t reference,
                                           TemperatureUnit unit) {
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
        header += k == reference ? std::string() : ',' + difference.toStdString();
    }
    std::string text = header + '\n';
    for (const ComparedMetric& metric : metrics) {
        text += csvField(metric.nameInFiles.toStdString()) + ',' + csvField(metric.object.toStdString());
        for (std::size_t k = 0; k < metric.cells.size(); ++k) {
            text += ',' + numberInFiles(metric.cells[k].value);
            text += k == reference ? std::string() : ',' + numberInFiles(metric.cells[k].differenceBy);
        }
        text += '\n';
    }
    return text;
}

} // namespace bask
