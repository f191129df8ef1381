#pragma once
// Cases of a study, beside each other.

#include <functional>

namespace bask {

/// Calls work(0) ... work(count - 1) on so many threads (0: one each processor), and after each of its own,
/// on the caller's thread, progress(done), which may be empty.
void runInParallel(int count, int threads, const std::function<void(int index)>& work,
                   const std::function<void(int done)>& progress);

} // namespace bask
