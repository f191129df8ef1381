#pragma once
// Runs many independent pieces of work on several threads.

#include <functional>

namespace bask {

/// Calls work(0) ... work(count - 1) on `threads` threads (0: one for each processor). After each of its own
/// calls the caller's thread calls progress(done), which may be empty. Passes on the first exception of a
/// call; calls that have not begun by then are left out.
void runInParallel(int count, int threads, const std::function<void(int index)>& work,
                   const std::function<void(int done)>& progress);

} // namespace bask
