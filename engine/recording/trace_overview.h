#pragma once
// What a trace plot shows of a run, as least and greatest values over short stretches: the picture of a day
// without its samples.

#include "engine/model/trace.h"

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// The column of objects that a quantity shows; null: it is of the run.
const ObjectColumn* plottedColumn(Quantity quantity);
/// The same of the run's columns; null for the speed, which has two lines made from six.
const RunColumn* plottedRunColumn(Quantity quantity);
/// All quantities.
std::size_t quantityCount();
/// Lines that a quantity has: one an object, one of the run, or two for the speed.
std::size_t seriesCount(Quantity quantity, std::size_t objects);
/// Lines of all quantities together, or of the first ones.
std::size_t lineCount(std::size_t objects, std::size_t quantities = quantityCount());
/// Index of a line among all.
std::size_t lineIndex(Quantity quantity, std::size_t series, std::size_t objects);
/// Value of a line in SI (K, K/s, 1, m/s and rad/s); NaN where it is unknown or the reading was invalid.
double plottedValue(const TraceSample& sample, Quantity quantity, std::size_t series);

/// Both NaN when there is no value.
struct Extremes {
    float least = std::numeric_limits<float>::quiet_NaN();
    float greatest = std::numeric_limits<float>::quiet_NaN();

    void include(float value);
    void include(const Extremes& other);
};

/// Extremes of every line over each kStretch samples; a stretch is the longer the longer the run is, where
/// `most` says how many are kept.
class TraceOverview {
public:
    static constexpr std::size_t kStretch = 16;
    static constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();

    explicit TraceOverview(std::size_t objects = 0, std::size_t most = kUnlimited);

    /// Samples in the order of time; objects that are missing have no values.
    void add(const TraceSample& sample);

    std::size_t objects() const { return m_objects; }
    std::size_t samples() const { return m_samples; }
    std::size_t samplesPerStretch() const { return m_perStretch; }
    /// The last one may not be full yet.
    std::size_t stretches() const { return m_spans.size(); }
    double from_s(std::size_t stretch) const { return m_spans[stretch].from_s; } ///< of its first sample
    double to_s(std::size_t stretch) const { return m_spans[stretch].to_s; }     ///< of its last
    double lastTime_s() const { return m_spans.empty() ? 0.0 : m_spans.back().to_s; }
    /// The last stretch that begins at or before a time; 0 when none does.
    std::size_t stretchAt(double time_s) const;
    const Extremes& extremes(Quantity quantity, std::size_t series, std::size_t stretch) const;
    bool hasValues(Quantity quantity) const; ///< any line, ever

    /// Full stretches as bytes, and back: as docs/session-format.md says. Bytes of before the last quantities
    /// came have the first ones only. False for bytes that are no whole stretches, or after one that is not
    /// full.
    std::string bytes() const;
    bool addBytes(std::string_view bytes, std::size_t quantities = quantityCount());

private:
    struct Span {
        double from_s = 0.0, to_s = 0.0;
    };
    std::size_t lines() const { return m_lines; }
    void halve();

    std::size_t m_objects, m_lines;
    std::size_t m_most;
    std::size_t m_samples = 0;
    std::size_t m_perStretch = kStretch;
    std::vector<Span> m_spans;
    std::vector<Extremes> m_extremes; ///< lines() a stretch
};

} // namespace bask
