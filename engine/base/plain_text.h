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

/// Characters that choose a variant of the one before them: of a Chinese character, a Mongolian letter, an
/// emoji.
enum class Variants {
    Refused, ///< for what is told apart by its name, since many fonts draw all variants alike
    Kept     ///< for words and for names of people: only where one may stand, behind a character beyond ASCII
};
/// Returns whether a text (UTF-8) has characters that nobody sees or that turn the direction of writing: two
/// names that differ in such look the same.
bool hasInvisible(const std::string& text, Variants variants = Variants::Refused);
/// Returns whether a text has no control characters (C0, DEL, C1) and no space at either end.
bool isOneLine(const std::string& text);
/// Returns letters, digits, '-' and '_' unchanged and "_" for other characters: a part of a file name.
std::string plainFileName(const std::string& name);
/// Returns the number of characters (code points) of a text in UTF-8.
std::size_t characterCount(const std::string& text);

/// Reads a whole file of at most the given number of bytes. Errors: FileNotFound, FileUnreadable,
/// FileTooLarge.
Result<std::string> readTextFile(const std::string& path, std::uintmax_t max);

} // namespace bask
