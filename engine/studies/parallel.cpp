#include "engine/studies/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace bask {

void runInParallel(int count, int threads, const std::function<void(int index)>& work,
                   const std::function<void(int done)>& progress) {
    std::atomic<int> next = 0, done = 0;
    const auto share = [&](bool reports) {
        for (int index = next++; index < count; index = next++) {
            work(index);
            ++done;
            if (reports && progress)
                progress(done);
        }
    };
    const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
    std::vector<std::jthread> others;
    for (int i = 1; i < std::min(wanted, count); ++i)
        others.emplace_back(share, false);
    share(true);
}

} // namespace bask
