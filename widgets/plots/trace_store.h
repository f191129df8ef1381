#pragma once
// The values of a trace plot in SI, and the lines made from them: samples where they can be distinguished,
// minima and maxima where they are denser than pixels.

#include "engine/model/trace.h"
#include "engine/recording/trace_overview.h"

#include <memory>
#include <utility>
#include <vector>

namespace bask {

class RecordedSession;

/// Limits that correspond to 100 % of the command speed.
struct SpeedLimits {
    double translation_m_s = 0.02;
    double rotation_rad_s = 0.1;
};

/// Samples of one run in time order. For a current run the newest kMaxRows are kept, and older ones as an
/// overview of at most kMaxStretches: a plot takes at most about 12 MB for any duration. A recorded run is
/// read when it is shown.
class TraceStore {
public:
    static constexpr std::size_t kMaxRows = 32768; ///< an hour at 9 Hz
    static constexpr std::size_t kMaxStretches = 16384;

    /// Starts again with this number of objects; additional ones in a sample are ignored, missing ones are
    /// NaN.
    void reset(std::size_t objects);
    /// Call for a finished run that is completely in memory: no rows are dropped.
    void keepAll() { m_keepsAll = true; }
    /// Shows a recorded run instead.
    void show(std::shared_ptr<RecordedSession> run);

    /// Adds samples that are later than the last one. Returns the index of the first added row.
    std::size_t append(const std::vector<TraceSample>& samples);

    /// Returns the recorded run that is shown; null if there is none.
    const RecordedSession* run() const { return m_run.get(); }
    std::size_t rows() const; ///< number of rows that are kept, or in the file
    std::size_t objects() const { return m_objects; }
    double time_s(std::size_t row) const;
    /// Returns whether every sample from a time on is among the rows, none dropped.
    bool keepsFrom(double time_s) const;
    double lastTime_s() const;

    /// Returns the value in SI (K, K/s, 1); NaN if it is unknown or the reading was invalid. Speed in m/s and
    /// rad/s.
    double value(Quantity quantity, std::size_t series, std::size_t row) const;
    bool hasValues(Quantity quantity) const { return overview().hasValues(quantity); }
    /// Returns the largest value of all lines of the whole run, in SI; NaN if there is none.
    double largest(Quantity quantity) const { return overview().largest(quantity); }

    /// Returns the newest row at or before a time, as a replay shows it, else the first; rows() if there is
    /// none.
    std::size_t rowAt(double time_s) const;

    /// Returns the approximate number of samples in a time range.
    std::size_t samplesBetween(double from_s, double to_s) const;

    /// Times at which an object's target changed, with the new target (K).
    const std::vector<std::pair<double, double>>& targetSteps(std::size_t object) const;

    struct Line {
        std::vector<double> times_s, values; ///< NaN in a gap
    };
    /// Returns a line from just before one time to just after another, reduced to this number of pixels.
    /// Reads at most `reads` blocks of a recorded run, subtracts the number that it has read, and uses the
    /// overview if that was not enough.
    Line line(Quantity quantity, std::size_t series, double from_s, double to_s, std::size_t pixels,
              int& reads) const;

private:
    const std::vector<double>& values(Quantity quantity, std::size_t series) const {
        return m_lines[lineIndex(quantity, series, m_objects)];
    }
    const TraceOverview& overview() const;
    std::size_t lowerRow(double time_s) const;
    void dropOldRows();
    void addRows(Line& line, Quantity quantity, std::size_t series, double from_s, double to_s,
                 std::size_t pixels) const;
    void addBlocks(Line& line, Quantity quantity, std::size_t series, std::size_t first, std::size_t last,
                   std::size_t pixels, int& reads) const;
    void addStretches(Line& line, Quantity quantity, std::size_t series, std::size_t first, std::size_t last,
                      std::size_t group) const;

    std::size_t m_objects = 0;
    bool m_keepsAll = false;
    std::vector<double> m_time_s;
    std::vector<std::vector<double>> m_lines; ///< in the order of lineIndex()
    std::vector<std::vector<std::pair<double, double>>> m_targets;
    TraceOverview m_overview;
    std::shared_ptr<RecordedSession> m_run;
};

} // namespace bask
