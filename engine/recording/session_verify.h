#pragma once
// Whether a recorded session is as it was recorded, and what was changed, removed or added where it is not.

#include "engine/base/result.h"
#include "engine/base/share_done.h"
#include "engine/recording/session_seal.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

/// A row, or several in a row, that are not as they were recorded. Those of the chain itself are links.
struct SessionFinding {
    enum class Kind { Changed, Removed, Added };
    Kind kind = Kind::Changed;
    std::string table; ///< kHeaderTable: a number in the database's header
    std::int64_t row =
        0; ///< number within its table, from 1 (of removed rows: where they were); 0: not known
    std::optional<double> time_s{}; ///< of the row, or of the next one that is there; empty: it has none
    bool isAfter = false;           ///< time_s is that of what is there before it
    std::int64_t lastRow = 0;       ///< of several that were removed or added together
    std::string type{}, name{};     ///< of what has a name: "view" or "key", and "sample" or "outcome"
};
inline constexpr const char* kHeaderTable = "header";

/// A table that cannot be read to its end. Where neither the list of tables nor the chain can be read, also
/// one that the run may not have had.
struct TableDamage {
    std::string table;
    std::int64_t rows = 0;        ///< that can be read, from the first
    std::optional<double> time_s; ///< of the last of these; empty: it has none
};

struct SessionVerdict {
    bool hasChain = false;            ///< also one that was removed; false: recorded before there were chains
    bool isDamaged = false;           ///< its database is not whole
    std::vector<TableDamage> damages; ///< none: every row can be read
    bool isClosed = false;            ///< the recording says when it ended
    Seal seal = Seal::None;
    std::string head; ///< of the chain, in hex: SHA-256
    std::int64_t rows = 0;
    std::int64_t links = 0;
    std::int64_t expectedLink = 0;        ///< whose hash is the head that was expected; 0: none
    std::vector<SessionFinding> findings; ///< the first kMaxFindings
    std::int64_t allFindings = 0;

    bool isIntact() const { return hasChain && !isDamaged && allFindings == 0 && mayBeSealed(seal); }
};
inline constexpr std::size_t kMaxFindings = 1000;

/// Looks at every row, and at every byte of a sealed file, which nothing else in this process may have open.
/// `expectedHead` is in hex, or empty: the head at the time of a report, after which an interrupted recording
/// may have been closed. Of a damaged file, what can be read is looked at. Errors: it is no session;
/// SessionDamaged for one that holds what Bask does not make.
Result<SessionVerdict> verifySession(const std::string& path, const std::string& expectedHead = {},
                                     const ShareDone& done = {});
/// The same of a file that this process may have open: one with a log beside it counts as not sealed. Once
/// it is asked to stop, the verdict means nothing.
Result<SessionVerdict> verifyOpenSession(const std::string& path, const std::stop_token& stop = {});

/// Returns the verdict in a word: "intact", "not sealed" (its rows are intact), "altered",
/// "damaged", or "no hash chain".
const char* verificationWord(const SessionVerdict& verdict);
/// Returns the same with the head of the chain where there is one, "intact (head 9f86...)": all 64 digits.
std::string verificationWords(const SessionVerdict& verdict);
/// The words of a session that this process may have open; "not verified" where it cannot be read.
std::string verificationOf(const std::string& path);

/// Returns the head of a session's chain, empty if it has none. Looks at nothing else.
Result<std::string> chainHead(const std::string& path);

} // namespace bask
