#pragma once
// Tries whether a program keeps the rules of docs/program-driver.md: `bask check-device`.

#include "engine/protocols/program_lines.h"

#include <functional>
#include <string>

namespace bask {

struct ProgramCheckOptions {
    bool mayMove = true; ///< a few millimetres or degrees; a heat source is heated by 5 K
    std::function<bool()> isStopped = [] { return false; }; ///< asked again and again; true ends the check
    bool mayHome = false;                                   ///< a robot is homed, which may move it far
};

/// One rule, and whether it is kept.
struct ProgramFinding {
    enum class Kind { Kept, Broken, NotTried };
    Kind kind;
    std::string words; ///< what was seen, or what is wrong and what to do
};

/// Starts the program and tries one rule after the other; each finding is told at once. Takes up to a minute,
/// and waits. A program that ends too early ends the check.
void checkProgram(const std::string& command, ProgramRole role, const ProgramCheckOptions& options,
                  const std::function<void(const ProgramFinding&)>& tell);

} // namespace bask
