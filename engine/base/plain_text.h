#pragma once
// Texts from files: read whole, and fit for a sentence.

#include "engine/base/result.h"

#include <cstdint>
#include <string>

namespace bask {

/// Words from a parser or a file, fit for a sentence: one line of plain characters, not too long, without the
/// JSON library's error id.
std::string plainWords(const std::string& words);

/// A person's words from a file, in any script and of any lines: other control characters, which a terminal
/// would obey and XML cannot have, are spaces.
std::string printable(std::string text);

/// The whole of a file that is at most so large, bytes. Errors: FileNotFound, FileUnreadable, FileTooLarge.
Result<std::string> readTextFile(const std::string& path, std::uintmax_t most);

} // namespace bask
