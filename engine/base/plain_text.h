#pragma once
// Text from files: reading a whole file, and making text safe for a sentence.

#include "engine/base/result.h"

#include <cstdint>
#include <string>

namespace bask {

/// Makes words from a parser or a file safe for a sentence: one line of plain characters, shortened, without
/// the error id of the JSON library.
std::string plainWords(const std::string& words);

/// Replaces control characters other than line breaks and tabs by spaces in a text written by a person, in
/// any script. A terminal would interpret them, and XML does not allow them.
std::string printable(std::string text);

/// Returns whether a text (UTF-8) has characters that nobody sees or that turn the direction of writing: two
/// names that differ in such look the same.
bool hasInvisible(const std::string& text);
/// Returns the number of characters (code points) of a text in UTF-8.
std::size_t characterCount(const std::string& text);

/// Reads a whole file of at most the given number of bytes. Errors: FileNotFound, FileUnreadable,
/// FileTooLarge.
Result<std::string> readTextFile(const std::string& path, std::uintmax_t max);

} // namespace bask
