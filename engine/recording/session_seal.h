#pragma once
// The seal of a finished session: a SHA-256 of the whole file but for the seal itself. Where it holds, no
// byte has changed since Bask closed the file; the hash chain (row_chain.h) says what has, where it does not.

#include "engine/base/share_done.h"
#include "engine/recording/session_store.h"

#include <string>

namespace bask {

inline constexpr const char* kCreateSeal = "CREATE TABLE seal(hash BLOB NOT NULL)";

/// Makes room for the seal, also in the place of one. Call it in the transaction that says how the recording
/// ended, or that copies such a one: without a seal it counts as altered.
Result<void> makeSeal(SessionStore& store);

/// Writes the seal into its room. Does nothing if there is no room, while the log is there, or if the file is
/// written meanwhile. Takes a second for some 200 MB. Error: the file cannot be read or written.
Result<void> sealSession(const std::string& path);

enum class Seal {
    None,  ///< an older file, one that was not closed or not sealed yet, or with its log
    Holds, ///< no byte of the file has changed since it was sealed
    Broken,
    Removed ///< a chained recording that says how it ended, without its seal
};
/// Whether a recording may be sealed anew after Bask has changed its tags, or copied it.
constexpr bool mayBeSealed(Seal seal) {
    return seal == Seal::None || seal == Seal::Holds;
}
/// `isAlone`: nothing else in this process has the file open, so that an empty log beside it does not matter.
/// Error: the file cannot be read.
Result<Seal> lookAtSeal(const std::string& path, bool isAlone = false, const ShareDone& done = {});

} // namespace bask
