#pragma once
// Threads whose work can wait.

#include <sys/resource.h>
#include <unistd.h>

namespace bask {

/// Lets the calling thread have only what of the processors nothing else wants, from now on: niceness 10,
/// which Linux keeps for each thread. Of Qt's priorities those over idle do nothing there, and an idle thread
/// is waited for at the end.
inline void giveWay() {
    constexpr int kNice = 10;
    ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

} // namespace bask
