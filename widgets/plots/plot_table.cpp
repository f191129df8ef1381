#include "widgets/plots/plot_table.h"

#include "engine/base/unit.h"
#include "engine/base/units.h"
#include "engine/recording/csv_field.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/trace_overview.h"
#include "widgets/plots/trace_store.h"

#include <QByteArray>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Name and unit of a quantity in files, as in traces.csv: "measured (degC)".
QString fileColumnName(Quantity quantity, std::size_t series) {
    const auto named = [](const auto& column) {
        const bool isTemperature = column.unit.edge == EdgeUnit::Temperature;
        return QStringLiteral("%1 (%2)").arg(QLatin1String(column.csv != nullptr ? column.csv : column.label),
                                             isTemperature ? QStringLiteral("degC")
                                                           : QString::fromStdString(siUnit(column.unit)));
    };
    if (const ObjectColumn* column = plottedColumn(quantity))
        return named(*column);
    if (const RunColumn* column = plottedRunColumn(quantity))
        return named(*column);
    return series == 0 ? QStringLiteral("commanded speed (m/s)")
                       : QStringLiteral("commanded rotation (rad/s)");
}

double siInFileUnit(double si, Quantity quantity) {
    const ObjectColumn* column = plottedColumn(quantity);
    const RunColumn* ofRun = plottedRunColumn(quantity);
    const Unit* unit = column != nullptr ? &column->unit : ofRun != nullptr ? &ofRun->unit : nullptr;
    return unit != nullptr && unit->edge == EdgeUnit::Temperature ? celsiusFromKelvin(si) : si;
}

double recordedValue(const TraceSample& sample, const PlotTable::Column& column) {
    if (!column.isTarget)
        return siInFileUnit(plottedValue(sample, column.quantity, column.series), column.quantity);
    return column.series < sample.objects.size() ? celsiusFromKelvin(sample.objects[column.series].target_K)
                                                 : kNoNumber;
}

double liveValue(const TraceStore& traces, std::size_t row, const PlotTable::Column& column) {
    if (!column.isTarget)
        return siInFileUnit(traces.value(column.quantity, column.series, row), column.quantity);
    const auto& steps = traces.targetSteps(column.series);
    const auto after =
        std::ranges::upper_bound(steps, traces.time_s(row), {}, [](const auto& step) { return step.first; });
    return after == steps.begin() ? kNoNumber : celsiusFromKelvin(std::prev(after)->second);
}

Result<void> readRows(PlotTable::Run& run, double from_s, double to_s, const std::stop_token& stop) {
    std::stop_source end; // nothing is wanted of what follows the shown time
    const std::stop_callback ended(stop, [&end] { end.request_stop(); });
    const auto take = [&](const TraceSample& sample) {
        if (sample.time_s > to_s)
            end.request_stop();
        if (sample.time_s < from_s || sample.time_s > to_s)
            return;
        run.times_s.push_back(sample.time_s);
        for (PlotTable::Column& column : run.columns)
            column.values.push_back(recordedValue(sample, column));
    };
    return readSamples(run.path, take, end.get_token());
}

void addHeader(std::string& text, const PlotTable::Run& run, const QString& header) {
    const QString whole = run.name.isEmpty() ? header : run.name + QStringLiteral(": ") + header;
    text += csvField(whole.toStdString()) + ',';
}

void addField(std::string& text, const std::vector<double>& values, std::size_t row) {
    constexpr int kDigits = 9;
    if (row < values.size() && std::isfinite(values[row]))
        text += QByteArray::number(values[row], 'g', kDigits).toStdString();
    text += ',';
}

} // namespace

void addQuantity(PlotTable::Run& run, const TraceStore& traces, const QStringList& objects,
                 Quantity quantity) {
    for (std::size_t i = 0; i < seriesCount(quantity, traces.objects()); ++i) {
        const QString object = plottedColumn(quantity) != nullptr
                                   ? objects.value(static_cast<qsizetype>(i)) + QStringLiteral(" ")
                                   : QString();
        run.columns.push_back({object + fileColumnName(quantity, i), quantity, i});
    }
}

void addTargets(PlotTable::Run& run, const TraceStore& traces, const QStringList& objects) {
    for (std::size_t i = 0; i < traces.objects(); ++i)
        run.columns.push_back({objects.value(static_cast<qsizetype>(i)) + QStringLiteral(" target (degC)"),
                               Quantity::Temperature, i, true});
}

void addLiveRows(PlotTable::Run& run, const TraceStore& traces, double from_s, double to_s) {
    for (std::size_t row = 0; row < traces.rows(); ++row) {
        if (traces.time_s(row) < from_s || traces.time_s(row) > to_s)
            continue;
        run.times_s.push_back(traces.time_s(row));
        for (PlotTable::Column& column : run.columns)
            column.values.push_back(liveValue(traces, row, column));
    }
}

Result<std::string> plotTableCsv(PlotTable table, const std::stop_token& stop) {
    std::string text;
    std::size_t rows = 0;
    for (PlotTable::Run& run : table.runs) {
        if (!run.path.empty())
            if (auto read = readRows(run, table.from_s, table.to_s, stop); !read)
                return read.error();
        rows = std::max(rows, run.times_s.size());
        addHeader(text, run, QStringLiteral("time (s)"));
        for (const PlotTable::Column& column : run.columns)
            addHeader(text, run, column.header);
    }
    text += csvField(table.mark.toStdString()) + '\n'; // a line before the headers would break readers
    for (std::size_t row = 0; row < rows && !stop.stop_requested(); ++row) {
        for (const PlotTable::Run& run : table.runs) {
            addField(text, run.times_s, row);
            for (const PlotTable::Column& column : run.columns)
                addField(text, column.values, row);
        }
        text += '\n';
    }
    return text;
}

} // namespace bask
