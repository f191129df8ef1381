#include "engine/runtime/approach.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

// A robot that has not come nearer for this time is stuck. The time is long, since a robot may obey late and
// start slowly.
constexpr double kStill_s = 15.0;
constexpr double kStillPeriods = 3.0;
constexpr double kNearer = 1e-4; ///< m, rad: smaller changes are jitter of the readings

} // namespace

Message doesNotMove(double left_m) {
    return {MessageCode::RobotDoesNotMove, {formatNumber(std::round(left_m * 1e3) * 0.1, 3)}}; // in cm
}

void Approach::begin(double now_s) {
    m_nearer_s = now_s;
    m_left = std::numeric_limits<double>::infinity();
    m_isStill = false;
}

void Approach::add(double now_s, double left, double period_s) {
    if (left < m_left - kNearer) {
        m_left = left;
        m_nearer_s = now_s;
    }
    m_isStill = now_s - m_nearer_s >= std::max(kStill_s, kStillPeriods * period_s);
}

} // namespace bask
