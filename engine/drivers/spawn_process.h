#pragma once
// Starts another program without a shell.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace bask {

struct SpawnedProgram {
    std::string program;                          ///< path of the file
    std::vector<std::string> words;               ///< its arguments, from its own name on
    std::vector<std::pair<int, int>> descriptors; ///< ours, and what each is there
    std::optional<int> closedFrom; ///< there all descriptors from this one on are closed; empty: none
    char* const* environment;
};

/// Starts it in a session of its own, with no signal blocked or ignored. Returns 0, or the number of the
/// error; sets its process.
int spawnProcess(const SpawnedProgram& spawned, pid_t& process);

} // namespace bask
