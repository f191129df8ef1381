#pragma once
// What a command line starts: its words, and a fingerprint of the files that are named in it.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

struct ProgramFiles {
    std::vector<std::string> words; ///< the command line without its quotes
    std::string program;            ///< path of the file that is started
    std::vector<std::string> files; ///< the program, and what else of the words is a file; absolute paths
    std::string hash; ///< SHA-256 of the words, the paths and the contents, in hexadecimal digits
};

/// Splits a command line at spaces outside of double quotes, without a shell, and reads the files. Paths are
/// relative to the working directory. Errors: ProgramNotStarted.
Result<ProgramFiles> programFiles(const std::string& command);

/// Returns a short name for people: that of the script, or else of the program.
std::string programName(const std::string& command);

/// Returns the command line of these words.
std::string commandLine(const std::vector<std::string>& words);

} // namespace bask
