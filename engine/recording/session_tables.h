#pragma once
// The tables of a session file: one row a sample in `step`, and the views by which people and scripts read it
// (docs/session-format.md).

#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace bask {

/// Samples that one row of the table `overview` stands for.
inline constexpr std::size_t kSamplesPerOverviewRow = 512; // three rows fill a page

class SessionTables {
public:
    SessionTables(const Experiment& experiment, bool simulated);
    /// Of a file, which may lack columns that came later than it: those are read as unknown. Errors: the file
    /// cannot be read.
    static Result<SessionTables> of(const SessionStore& store, const SessionRecord& facts);

    /// Statements that make all tables and views of a new file.
    std::vector<std::string> create() const;

    std::string insertStep() const; ///< takes stepRow()
    std::vector<SqlValue> stepRow(std::int64_t number, const TraceSample& sample) const;

    std::string selectSteps() const; ///< without its WHERE; rows for sampleOf()
    static std::int64_t numberOfStep(SessionStore::Row row);
    TraceSample sampleOf(SessionStore::Row row) const;

    /// Quantities that have all their columns: those of the file's overview.
    std::size_t quantities() const;

private:
    bool isAbsent(const std::string& key) const;
    std::string columnList(bool typed) const;

    std::vector<std::string> m_names; ///< of the objects
    std::set<std::string> m_absent;   ///< keys of columns that the file lacks
    Vector6d m_source;                ///< pose in the experiment: not stored again
    bool m_simulated;                 ///< there is a truth to be stored
};

/// Coordinates of columns x_m, y_m, z_m, qw, qx, qy, qz.
Vector6d coordinatesOfColumns(SessionStore::Row columns);

} // namespace bask
