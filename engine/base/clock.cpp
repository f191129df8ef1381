#include "engine/base/clock.h"

#include <chrono>
#include <stdexcept>

namespace bask {

double SteadyClock::now_s() const {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

void ManualClock::advanceTo(double time_s) {
    if (!(time_s >= m_now_s))
        throw std::logic_error("ManualClock: time runs forward only");
    m_now_s = time_s;
}

} // namespace bask
