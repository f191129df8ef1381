#pragma once
// Names of threads, as debuggers and `top -H` show them.

#include <pthread.h>

namespace bask {

/// Names the calling thread, with at most 15 characters. Without it a thread has the name of the one that
/// started it.
inline void nameThread(const char* name) {
    ::pthread_setname_np(::pthread_self(), name);
}

} // namespace bask
