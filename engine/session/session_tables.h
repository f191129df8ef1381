#pragma once
// The tables of a session file: one row a sample in `step`, and the views by which people and scripts read it
// (docs/session-format.md).

#include "engine/session/session_file.h"
#include "engine/session/session_store.h"

#include <cstdint>
#include <string>
#include <vector>

namespace bask {

/// Samples that one row of the table `overview` stands for.
inline constexpr std::size_t kSamplesPerOverviewRow = 512; // three rows fill a page

class SessionTables {
public:
    SessionTables(const Experiment& experiment, bool simulated);
    explicit SessionTables(const SessionRecord& facts) : SessionTables(facts.experiment, facts.simulated) {}

    /// Statements that make all tables and views of a new file.
    std::vector<std::string> create() const;

    std::string insertStep() const; ///< takes stepRow()
    std::vector<SqlValue> stepRow(std::int64_t number, const TraceSample& sample) const;

    std::string selectSteps() const; ///< without its WHERE; rows for sampleOf()
    static std::int64_t numberOfStep(SessionStore::Row row);
    TraceSample sampleOf(SessionStore::Row row) const;

private:
    std::vector<std::string> m_names; ///< of the objects
    Vector6d m_source;                ///< pose in the experiment: not stored again
    bool m_simulated;                 ///< there is a truth to be stored
};

/// Coordinates of columns x_m, y_m, z_m, qw, qx, qy, qz.
Vector6d coordinatesOfColumns(SessionStore::Row columns);
/// A number that is no set of limits is none.
ActiveLimits limitsOf(const SqlValue& value);

} // namespace bask
