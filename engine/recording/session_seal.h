#pragma once
// The seal of a finished session: a SHA-256 of the whole file but for the seal itself. Where it holds, no
// byte has changed since Bask closed the file; the hash chain (row_chain.h) says what has, where it does not.

#include "engine/recording/session_store.h"

#include <string>

namespace bask {

inline constexpr const char* kCreateSeal = "CREATE TABLE seal(hash BLOB NOT NULL)";

/// Makes room for the seal. Call it inside a transaction, once.
Result<void> makeSeal(SessionStore& store);

/// Writes the seal into a session that nobody has open for writing. Does nothing if there is no room for it,
/// or while its log is there. Error: the file cannot be read or written.
Result<void> sealSession(const std::string& path);

enum class Seal {
    None, ///< an older file, one that was not closed, or with its log
    Holds,
    Broken
};
/// Error: the file cannot be read.
Result<Seal> lookAtSeal(const std::string& path);

} // namespace bask
