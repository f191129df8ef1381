#pragma once

#include <ctime>

namespace bask::test {

/// Of the calling thread, on a processor: other work on the machine does not count.
inline double threadTime_s() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace bask::test
