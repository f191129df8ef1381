#include "engine/base/clock.h"

#include <chrono>
#include <stdexcept>

namespace bask {

double SteadyClock::now_s() const {
    using namespace std::chrono;
    return duration<double>(steady_clock::now().time_since_epoch()).count();
}

void ManualClock::advance(double dt_s) {
    if (!(dt_s >= 0.0))
        throw std::logic_error("ManualClock: time runs forward only");
    m_now_s += dt_s;
}

} // namespace bask
