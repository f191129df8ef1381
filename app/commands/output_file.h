#pragma once
// The files that subcommands write: looked at before the work, so that nothing of the user's is lost to them.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// A file that a subcommand is told to write.
struct OutputFile {
    std::string path;
    /// The first key of a JSON output: a file that does not begin with it is not replaced. Empty: whoever
    /// writes the file has a rule of their own for what is there.
    std::string firstKey = {};
    /// What such a file is, in words: "a contour written by Bask".
    std::string kind = {};
};

/// Refuses outputs that are no regular files, are one file with an input, each other or standard output,
/// cannot be written, or would replace a file of another kind. A file that is not there yet or is empty is
/// fine.
Result<void> checkOutputs(const std::vector<std::string>& inputs, const std::vector<OutputFile>& outputs);

/// Puts `text` in place of the file, whole or not at all.
Result<void> writeOutput(const std::string& path, const std::string& text);

} // namespace bask
