#include "engine/drivers/spawn_process.h"

#include <csignal>

#include <spawn.h>

namespace bask {

int spawnProcess(const SpawnedProgram& spawned, pid_t& process) {
    std::vector<char*> words;
    for (const std::string& word : spawned.words)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    for (const auto& [ours, there] : spawned.descriptors)
        ::posix_spawn_file_actions_adddup2(&actions, ours, there);
    if (spawned.closedFrom)
        ::posix_spawn_file_actions_addclosefrom_np(&actions, *spawned.closedFrom);
    sigset_t none, all;
    ::sigemptyset(&none);
    ::sigfillset(&all);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setflags(&attributes,
                               POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
    const int problem = ::posix_spawn(&process, spawned.program.c_str(), &actions, &attributes, words.data(),
                                      spawned.environment);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    return problem;
}

} // namespace bask
