#pragma once
// A look at a JSON text before a tree is built of it, and its bad parts in printable words.

#include "engine/base/result.h"

#include <cstdint>
#include <optional>
#include <string>

namespace bask {

/// What is wrong with a text as JSON: syntax, numbers out of reach, repeated keys, nesting deeper than 32.
/// Empty: nothing.
std::optional<Message> checkJsonText(const std::string& text);

/// Words from a parser or a file, fit for a sentence: one line of plain characters, not too long, without the
/// JSON library's error id.
std::string plainWords(const std::string& words);

/// A person's words from a file, in any script and of any lines: other control characters, which a terminal
/// would obey and XML cannot have, are spaces.
std::string printable(std::string text);

/// The whole of a file that is at most so large, bytes. Errors: FileNotFound, FileUnreadable, FileTooLarge.
Result<std::string> readTextFile(const std::string& path, std::uintmax_t most);

} // namespace bask
