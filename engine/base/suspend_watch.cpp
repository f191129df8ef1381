#include "engine/base/suspend_watch.h"

#include <ctime>

namespace bask {

double AwakeClock::now_s() const {
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

SuspendWatch::SuspendWatch(const Clock& always, const Clock& awake)
    : m_always(always), m_awake(awake), m_apart_s(always.now_s() - awake.now_s()) {}

double SuspendWatch::slept_s() {
    const double apart_s = m_always.now_s() - m_awake.now_s();
    const double slept_s = apart_s - m_apart_s;
    if (slept_s <= kMin_s)
        return 0.0;
    m_apart_s = apart_s;
    return slept_s;
}

} // namespace bask
