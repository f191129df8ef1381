#pragma once
// The numbers behind a trace plot in SI, and the lines they make: samples where they can be told apart, least
// and greatest values where they are denser than pixels.

#include "engine/model/trace.h"
#include "engine/recording/trace_overview.h"

#include <memory>
#include <utility>
#include <vector>

namespace bask {

class RecordedSession;

/// Limits that make 100 % of the command speed.
struct SpeedLimits {
    double translation_m_s = 0.02;
    double rotation_rad_s = 0.1;
};

/// Samples of one run in the order of time. Of a run that goes on, the newest kMaxRows are kept, older ones
/// as an overview of at most kMaxStretches: a plot takes no more than about 12 MB however long it runs. A
/// recorded run is read as it is looked at.
class TraceStore {
public:
    static constexpr std::size_t kMaxRows = 32768; ///< an hour at 9 Hz
    static constexpr std::size_t kMaxStretches = 16384;

    /// Starts again with this number of objects; more in a sample are left out, missing ones are NaN.
    void reset(std::size_t objects);
    /// Of a run that is over and whole in memory: drops nothing.
    void keepAll() { m_keepsAll = true; }
    /// Shows a recorded run instead.
    void show(std::shared_ptr<RecordedSession> run);

    /// Adds samples that are later than the last one. Returns the index of the first row added.
    std::size_t append(const std::vector<TraceSample>& samples);

    std::size_t rows() const; ///< that are kept, or in the file
    std::size_t objects() const { return m_objects; }
    double time_s(std::size_t row) const;
    double lastTime_s() const;

    /// Value in SI (K, K/s, 1); NaN where it is unknown or the reading was invalid. Speed in m/s and rad/s.
    double value(Quantity quantity, std::size_t series, std::size_t row) const;
    bool hasValues(Quantity quantity) const { return overview().hasValues(quantity); }

    /// Row nearest in time; rows() when there is none.
    std::size_t nearestRow(double time_s) const;

    /// Samples in a stretch of time, roughly.
    std::size_t samplesBetween(double from_s, double to_s) const;

    /// Times at which an object's target changed, with the new target (K).
    const std::vector<std::pair<double, double>>& targetSteps(std::size_t object) const;

    struct Line {
        std::vector<double> times_s, values; ///< NaN in a gap
    };
    /// A line from just before one time to just after another, as it can be seen on so many pixels. Reads at
    /// most `reads` blocks of a recorded run, takes off what it has read, and shows the overview where that
    /// was not enough.
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
