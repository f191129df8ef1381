#pragma once
// The tables of a session file: one row for each sample in `step`, and the views that people and scripts read
// (docs/session-format.md).

#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"

#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace bask {

/// Number of samples in one row of the table `overview`.
inline constexpr std::size_t kSamplesPerOverviewRow = 512; // three rows fill a page

class SessionTables {
public:
    SessionTables(const Experiment& experiment, bool simulated);
    /// Returns the tables of a file. Columns that are newer than the file are missing; they are read as
    /// unknown. Errors: the file cannot be read.
    static Result<SessionTables> of(const SessionStore& store, const SessionRecord& facts);

    bool hasFrames() const { return m_rig.hasThermalCamera; } ///< whether there is the table thermal_frame

    /// Returns the statements that create all tables and views of a new file.
    std::vector<std::string> create() const;

    std::string insertStep() const; ///< statement with the values of stepRow()
    std::vector<SqlValue> stepRow(std::int64_t number, const TraceSample& sample) const;

    std::string selectSteps() const; ///< statement without its WHERE; its rows are for sampleOf()
    static std::int64_t numberOfStep(SessionStore::Row row);
    TraceSample sampleOf(SessionStore::Row row) const;
    /// Returns what no run records in a row of selectSteps(), in words; empty if there is nothing.
    std::string impossibleIn(SessionStore::Row row) const;

    /// Returns the number of quantities with all their columns: those of the file's overview.
    std::size_t quantities() const;

private:
    bool isAbsent(const std::string& key) const;
    std::string columnList(bool typed) const;

    std::vector<std::string> m_names; ///< names of the objects
    std::set<std::string> m_absent;   ///< keys of columns that are missing in the file
    Vector6d m_source;                ///< pose in the experiment, which is not stored again
    RecordedRig m_rig;                ///< of what it does not have, nothing is stored
};

// What no run records, in words; empty if there is nothing.
std::string impossibleNumbers(SessionStore::Row row); ///< text, or bytes, where numbers are
/// Of the columns x_m, y_m, z_m, qw, qx, qy, qz; all unknown is possible.
std::string impossiblePose(SessionStore::Row columns);
template <class Sample> std::string impossibleValue(const SampleColumn<Sample>& column, double value) {
    if (column.unit.edge != EdgeUnit::Temperature || std::isnan(value) ||
        (value >= 0.0 && std::isfinite(value)))
        return {};
    return std::string(column.key) + (value < 0.0 ? " below absolute zero" : " that is infinite");
}

/// Converts the columns x_m, y_m, z_m, qw, qx, qy, qz to coordinates.
Vector6d coordinatesOfColumns(SessionStore::Row columns);

} // namespace bask
