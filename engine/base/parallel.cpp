#include "engine/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace bask {

void runInParallel(int count, int threads, const std::function<void(int index)>& work,
                   const std::function<void(int done)>& progress) {
    std::atomic<int> next = 0, done = 0;
    std::mutex mutex;
    std::exception_ptr failure; // of the first that failed
    const auto share = [&](bool reports) {
        try {
            for (int index = next++; index < count; index = next++) {
                work(index);
                ++done;
                if (reports && progress)
                    progress(done);
            }
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!failure)
                failure = std::current_exception();
            next = count; // the others end, too
        }
    };
    const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    {
        std::vector<std::jthread> others;
        try {
            for (int i = 1; i < std::min(wanted, count); ++i)
                others.emplace_back(share, false);
        } catch (const std::system_error&) {
            // The system gives no more threads: the existing ones do the work.
        }
        share(true);
    }
    if (failure)
        std::rethrow_exception(failure);
}

} // namespace bask
