#pragma once
// Parts of reading a session file, shared by the readers.

#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"
#include "engine/recording/session_tables.h"

#include <functional>
#include <limits>
#include <stop_token>

namespace bask {

/// Reads header, experiment, events, notes and commands, but no samples.
Result<SessionRecord> readFacts(const SessionStore& store, const std::string& path);

/// Returns the event of a row: time_s, code, args.
TraceEvent eventOf(SessionStore::Row row);

/// Returns about how many rows a table has, by the number of its last one; 0 where that tells nothing.
double roughRows(const SessionStore& store, const std::string& table);

/// Refuses a file whose structure is damaged; reads all of it.
Result<void> checkIntegrity(const SessionStore& store, const std::string& path);

/// The times of samples one after the other: they ascend, and few are of one moment.
class SampleTimes {
public:
    bool isPossible(double next_s);

private:
    double m_last_s = -std::numeric_limits<double>::infinity();
    int m_equal = 0;
};

/// Reads samples of version 1, whose tables have one row for each sample, or for each sample and object.
Result<void> readFirstVersion(const SessionStore& store, SessionRecord& record);

/// Calls `take` for the samples with these numbers, from 1, until `stop` is requested; refuses a gap.
Result<void> readSteps(const SessionStore& store, const SessionTables& tables, const std::string& path,
                       std::size_t first, std::size_t last,
                       const std::function<void(const TraceSample&)>& take, const std::stop_token& stop = {});

} // namespace bask
