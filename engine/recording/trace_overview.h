#pragma once
// The data of a trace plot as minimum and maximum values over short stretches (intervals): it shows a day
// without reading its samples.

#include "engine/model/trace.h"

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// Returns the column of objects that a quantity shows; null if it is a quantity of the run.
const ObjectColumn* plottedColumn(Quantity quantity);
/// Returns the column of the run; null for the speed, whose two lines are computed from six columns.
const RunColumn* plottedRunColumn(Quantity quantity);
/// Returns the number of quantities.
std::size_t quantityCount();
/// Returns the number of lines of a quantity: one for each object, one for the run, or two for the speed.
std::size_t seriesCount(Quantity quantity, std::size_t objects);
/// Returns the number of lines of all quantities together, or of the first ones.
std::size_t lineCount(std::size_t objects, std::size_t quantities = quantityCount());
/// Returns the index of a line among all.
std::size_t lineIndex(Quantity quantity, std::size_t series, std::size_t objects);
/// Returns the value of a line in SI (K, K/s, 1, m/s and rad/s); NaN if it is unknown or the reading was
/// invalid.
double plottedValue(const TraceSample& sample, Quantity quantity, std::size_t series);

/// Minimum and maximum; both are NaN if there is no value.
struct Extremes {
    float min = std::numeric_limits<float>::quiet_NaN();
    float max = std::numeric_limits<float>::quiet_NaN();

    void include(float value);
    void include(const Extremes& other);
};

/// Extremes of every line over stretches (intervals) of kStretch samples. If the number of stretches is
/// limited, they become longer as the run becomes longer.
class TraceOverview {
public:
    static constexpr std::size_t kStretch = 16;
    static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

    explicit TraceOverview(std::size_t objects = 0, std::size_t max = kUnlimited);

    /// Adds a sample; samples must be in order of time. Missing objects have no values.
    void add(const TraceSample& sample);

    std::size_t objects() const { return m_objects; }
    std::size_t samples() const { return m_samples; }
    std::size_t samplesPerStretch() const { return m_perStretch; }
    /// Returns the number of stretches; the last one may be incomplete.
    std::size_t stretches() const { return m_spans.size(); }
    double from_s(std::size_t stretch) const { return m_spans[stretch].from_s; } ///< time of its first sample
    double to_s(std::size_t stretch) const { return m_spans[stretch].to_s; }     ///< time of its last sample
    double lastTime_s() const { return m_spans.empty() ? 0.0 : m_spans.back().to_s; }
    /// Returns the last stretch that begins at or before a time; 0 if there is none.
    std::size_t stretchAt(double time_s) const;
    const Extremes& extremes(Quantity quantity, std::size_t series, std::size_t stretch) const;
    bool hasValues(Quantity quantity) const; ///< whether any line ever has a value
    double largest(Quantity quantity) const; ///< value of any line; NaN if there is none

    /// Returns the complete stretches as bytes, and reads them back, in the format of docs/session-format.md.
    /// Bytes from before the last quantities were added have only the first ones. Reading returns false if
    /// the bytes are not complete stretches, or if the last stretch is incomplete.
    std::string bytes() const;
    bool addBytes(std::string_view bytes, std::size_t quantities = quantityCount());

private:
    struct Span {
        double from_s = 0.0, to_s = 0.0;
    };
    std::size_t lines() const { return m_lines; }
    void halve();

    std::size_t m_objects, m_lines;
    std::size_t m_max;
    std::size_t m_samples = 0;
    std::size_t m_perStretch = kStretch;
    std::vector<Span> m_spans;
    std::vector<Extremes> m_extremes; ///< lines() for each stretch
};

} // namespace bask
