#include "engine/base/clock.h"

#include <chrono>
#include <ctime>
#include <stdexcept>

namespace bask {

double SteadyClock::now_s() const {
    timespec time{};
    ::clock_gettime(CLOCK_BOOTTIME, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ManualClock::advanceTo(double time_s) {
    if (!(time_s >= m_now_s))
        throw std::logic_error("ManualClock: time runs forward only");
    m_now_s = time_s;
}

double utcNow_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

} // namespace bask
