#include "engine/recording/trace_overview.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace bask {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the file's numbers are taken as they lie in memory");

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

constexpr auto kIsPlotted = [](const auto& column) { return column.plot.has_value(); };
constexpr std::size_t kQuantities = 1 + // the speed, which is no column
                                    std::ranges::count_if(kObjectColumns, kIsPlotted) +
                                    std::ranges::count_if(kRunColumns, kIsPlotted);

/// Where a quantity's values are; both null: the speed.
struct PlottedAs {
    const ObjectColumn* ofObjects = nullptr;
    const RunColumn* ofRun = nullptr;
};

constexpr std::array<PlottedAs, kQuantities> kPlottedAs = [] {
    std::array<PlottedAs, kQuantities> out{};
    for (const ObjectColumn& column : kObjectColumns)
        if (column.plot)
            out.at(static_cast<std::size_t>(*column.plot)).ofObjects = &column;
    for (const RunColumn& column : kRunColumns)
        if (column.plot)
            out.at(static_cast<std::size_t>(*column.plot)).ofRun = &column;
    return out;
}();

const PlottedAs& plottedAs(Quantity quantity) {
    return kPlottedAs.at(static_cast<std::size_t>(quantity));
}

double finiteOrNaN(double value) {
    return std::isfinite(value) ? value : kNotKnown;
}

template <class T> void append(std::string& out, const T& value) {
    out.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T> T take(std::string_view& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
    return value;
}

} // namespace

const ObjectColumn* plottedColumn(Quantity quantity) {
    return plottedAs(quantity).ofObjects;
}

const RunColumn* plottedRunColumn(Quantity quantity) {
    return plottedAs(quantity).ofRun;
}

std::size_t quantityCount() {
    return kQuantities;
}

std::size_t seriesCount(Quantity quantity, std::size_t objects) {
    if (plottedColumn(quantity) != nullptr)
        return objects;
    return plottedRunColumn(quantity) != nullptr ? 1 : 2;
}

std::size_t lineCount(std::size_t objects, std::size_t quantities) {
    std::size_t count = 0;
    for (std::size_t q = 0; q < quantities; ++q)
        count += seriesCount(static_cast<Quantity>(q), objects);
    return count;
}

std::size_t lineIndex(Quantity quantity, std::size_t series, std::size_t objects) {
    return lineCount(objects, static_cast<std::size_t>(quantity)) + series;
}

double plottedValue(const TraceSample& sample, Quantity quantity, std::size_t series) {
    if (const ObjectColumn* column = plottedColumn(quantity)) {
        if (series >= sample.objects.size() || (column->isReading && !sample.objects[series].valid))
            return kNotKnown;
        return finiteOrNaN(column->value.get(sample.objects[series]));
    }
    if (const RunColumn* column = plottedRunColumn(quantity))
        return finiteOrNaN(column->value.get(sample));
    return finiteOrNaN(series == 0 ? sample.twist.head<3>().norm() : sample.twist.tail<3>().norm());
}

void Extremes::include(float value) {
    min = std::fmin(min, value); // the other one where one is NaN
    max = std::fmax(max, value);
}

void Extremes::include(const Extremes& other) {
    min = std::fmin(min, other.min);
    max = std::fmax(max, other.max);
}

TraceOverview::TraceOverview(std::size_t objects, std::size_t max)
    : m_objects(objects), m_lines(lineCount(objects)), m_max(std::max<std::size_t>(max, 2)) {}

void TraceOverview::add(const TraceSample& sample) {
    if (m_samples % m_perStretch == 0) {
        if (m_spans.size() >= m_max)
            halve();
        if (m_samples % m_perStretch == 0) {
            m_spans.push_back({sample.time_s, sample.time_s});
            m_extremes.resize(m_extremes.size() + lines());
        }
    }
    ++m_samples;
    m_spans.back().to_s = sample.time_s;
    Extremes* const open = &m_extremes[m_extremes.size() - lines()];
    for (std::size_t q = 0, line = 0; q < quantityCount(); ++q) {
        const auto quantity = static_cast<Quantity>(q);
        for (std::size_t i = 0; i < seriesCount(quantity, m_objects); ++i)
            open[line++].include(static_cast<float>(plottedValue(sample, quantity, i)));
    }
}

/// Joins two stretches each; the last of an odd number stays alone and is filled up.
void TraceOverview::halve() {
    const std::size_t kept = (m_spans.size() + 1) / 2, width = lines();
    for (std::size_t k = 0; k < kept; ++k) {
        const std::size_t second = std::min(2 * k + 1, m_spans.size() - 1);
        m_spans[k] = {m_spans[2 * k].from_s, m_spans[second].to_s};
        for (std::size_t j = 0; j < width; ++j) {
            Extremes joined = m_extremes[2 * k * width + j];
            joined.include(m_extremes[second * width + j]);
            m_extremes[k * width + j] = joined;
        }
    }
    m_spans.resize(kept);
    m_extremes.resize(kept * width);
    m_perStretch *= 2;
}

std::size_t TraceOverview::stretchAt(double time_s) const {
    const auto after = std::ranges::upper_bound(m_spans, time_s, {}, &Span::from_s) - m_spans.begin();
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1) - 1);
}

const Extremes& TraceOverview::extremes(Quantity quantity, std::size_t series, std::size_t stretch) const {
    return m_extremes[stretch * lines() + lineIndex(quantity, series, m_objects)];
}

bool TraceOverview::hasValues(Quantity quantity) const {
    const std::size_t count = seriesCount(quantity, m_objects);
    for (std::size_t k = 0; k < m_spans.size(); ++k)
        for (std::size_t i = 0; i < count; ++i)
            if (!std::isnan(extremes(quantity, i, k).min))
                return true;
    return false;
}

double TraceOverview::largest(Quantity quantity) const {
    const std::size_t count = seriesCount(quantity, m_objects);
    Extremes all;
    for (std::size_t k = 0; k < m_spans.size(); ++k)
        for (std::size_t i = 0; i < count; ++i)
            all.include(extremes(quantity, i, k));
    return all.max;
}

std::string TraceOverview::bytes() const {
    std::string out;
    for (std::size_t k = 0; k < m_samples / m_perStretch; ++k) {
        append(out, m_spans[k]);
        for (std::size_t j = 0; j < lines(); ++j)
            append(out, m_extremes[k * lines() + j]);
    }
    return out;
}

bool TraceOverview::addBytes(std::string_view bytes, std::size_t quantities) {
    const std::size_t stored = lineCount(m_objects, quantities);
    const std::size_t size = sizeof(Span) + stored * sizeof(Extremes);
    if (m_samples % m_perStretch != 0 || m_perStretch != kStretch || bytes.size() % size != 0)
        return false;
    while (!bytes.empty()) {
        m_spans.push_back(take<Span>(bytes));
        m_extremes.resize(m_extremes.size() + lines());
        Extremes* const added = &m_extremes[m_extremes.size() - lines()];
        for (std::size_t j = 0; j < stored; ++j)
            added[j] = take<Extremes>(bytes);
        m_samples += kStretch;
    }
    return true;
}

} // namespace bask
