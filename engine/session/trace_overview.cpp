#include "engine/session/trace_overview.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace bask {
namespace {

static_assert(std::endian::native == std::endian::little,
              "the file's numbers are taken as they lie in memory");

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kOfObjects{Quantity::Temperature, Quantity::Error, Quantity::ViewFactor, Quantity::Rate,
                                Quantity::Strength};

double finiteOrNaN(double value) {
    return std::isfinite(value) ? value : kNaN;
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

std::size_t seriesCount(Quantity quantity, std::size_t objects) {
    return quantity == Quantity::Speed ? 2 : objects;
}

double plottedValue(const TraceSample& sample, Quantity quantity, std::size_t series) {
    if (quantity == Quantity::Speed)
        return finiteOrNaN(series == 0 ? sample.twist.head<3>().norm() : sample.twist.tail<3>().norm());
    if (series >= sample.objects.size())
        return kNaN;
    const ObjectSample& object = sample.objects[series];
    switch (quantity) {
    case Quantity::ViewFactor:
        return finiteOrNaN(object.viewFactor);
    case Quantity::Strength:
        return finiteOrNaN(object.lambda1);
    case Quantity::Rate:
        return object.valid ? finiteOrNaN(object.rate_K_s) : kNaN;
    case Quantity::Error:
        return object.valid ? finiteOrNaN(object.measured_K - object.target_K) : kNaN;
    default:
        return object.valid ? finiteOrNaN(object.measured_K) : kNaN;
    }
}

void Extremes::include(float value) {
    least = std::fmin(least, value); // the other one where one is NaN
    greatest = std::fmax(greatest, value);
}

void Extremes::include(const Extremes& other) {
    least = std::fmin(least, other.least);
    greatest = std::fmax(greatest, other.greatest);
}

TraceOverview::TraceOverview(std::size_t objects, std::size_t most)
    : m_objects(objects), m_most(std::max<std::size_t>(most, 2)) {}

std::size_t TraceOverview::line(Quantity quantity, std::size_t series) const {
    if (quantity == Quantity::Speed)
        return 5 * m_objects + series;
    const auto at = std::ranges::find(kOfObjects, quantity) - kOfObjects.begin();
    return static_cast<std::size_t>(at) * m_objects + series;
}

void TraceOverview::add(const TraceSample& sample) {
    if (m_samples % m_perStretch == 0) {
        if (m_spans.size() >= m_most)
            halve();
        if (m_samples % m_perStretch == 0) {
            m_spans.push_back({sample.time_s, sample.time_s});
            m_extremes.resize(m_extremes.size() + lines());
        }
    }
    ++m_samples;
    m_spans.back().to_s = sample.time_s;
    Extremes* const open = &m_extremes[m_extremes.size() - lines()];
    for (std::size_t q = 0; q < kOfObjects.size(); ++q)
        for (std::size_t i = 0; i < m_objects; ++i)
            open[q * m_objects + i].include(static_cast<float>(plottedValue(sample, kOfObjects[q], i)));
    for (std::size_t i = 0; i < 2; ++i)
        open[5 * m_objects + i].include(static_cast<float>(plottedValue(sample, Quantity::Speed, i)));
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
    return m_extremes[stretch * lines() + line(quantity, series)];
}

bool TraceOverview::hasValues(Quantity quantity) const {
    const std::size_t count = seriesCount(quantity, m_objects);
    for (std::size_t k = 0; k < m_spans.size(); ++k)
        for (std::size_t i = 0; i < count; ++i)
            if (!std::isnan(extremes(quantity, i, k).least))
                return true;
    return false;
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

bool TraceOverview::addBytes(std::string_view bytes) {
    const std::size_t size = sizeof(Span) + lines() * sizeof(Extremes);
    if (m_samples % m_perStretch != 0 || m_perStretch != kStretch || bytes.size() % size != 0)
        return false;
    while (!bytes.empty()) {
        m_spans.push_back(take<Span>(bytes));
        for (std::size_t j = 0; j < lines(); ++j)
            m_extremes.push_back(take<Extremes>(bytes));
        m_samples += kStretch;
    }
    return true;
}

} // namespace bask
