#pragma once
// The output files of subcommands: checked before the work, so that no file of the user is lost.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// A file that a subcommand is told to write.
struct OutputFile {
    std::string path;
    /// The first key of a JSON output: a file that does not begin with it is not replaced. Empty if the
    /// writer of the file has its own rule.
    std::string firstKey = {};
    /// The kind of file, in words: "a contour written by Bask".
    std::string kind = {};
};

/// Refuses outputs that are not regular files, that are the same file as an input, another output or standard
/// output, that cannot be written, or that would replace a file of another kind. A file that does not exist
/// or is empty is accepted.
Result<void> checkOutputs(const std::vector<std::string>& inputs, const std::vector<OutputFile>& outputs);

} // namespace bask
