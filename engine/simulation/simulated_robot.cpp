#include "engine/simulation/simulated_robot.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bask {

SimulatedRobot::SimulatedRobot(const SimulatedRobotConfig& config, const Clock& clock)
    : m_config(config), m_clock(clock), m_exact(config.start) {}

Vector6d SimulatedRobot::coordinates() const {
    Vector6d q = m_exact;
    for (int k = 0; k < 6; ++k) {
        const double step = k < 3 ? m_config.step_m : m_config.step_rad;
        if (step > 0.0 && m_config.free[static_cast<std::size_t>(k)])
            q[k] = std::clamp(std::round(q[k] / step) * step, m_config.lower[k], m_config.upper[k]);
    }
    return q;
}

Result<RobotState> SimulatedRobot::state() {
    if (m_linkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    const bool moving = m_clock.now_s() < m_expires_s && !m_rates.isZero();
    return RobotState{m_clock.now_s(), coordinates(), moving};
}

Result<void> SimulatedRobot::setTwist(const Vector6d& twist, double validFor_s) {
    if (m_linkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    Vector6d rates;
    rates.head<3>() = twist.head<3>();
    rates.tail<3>() = rotationAxes(m_exact).inverse() * twist.tail<3>();
    for (int k = 0; k < 6; ++k)
        if (!m_config.free[static_cast<std::size_t>(k)])
            rates[k] = 0.0;
    // The motors' own limits, for a host that asks too much.
    const double speed = rates.head<3>().norm();
    const double rotation = rates.tail<3>().norm();
    if (speed > m_config.maxSpeed_m_s)
        rates.head<3>() *= m_config.maxSpeed_m_s / speed;
    if (rotation > m_config.maxRotation_rad_s)
        rates.tail<3>() *= m_config.maxRotation_rad_s / rotation;
    m_rates = rates;
    m_expires_s = m_clock.now_s() + validFor_s;
    return {};
}

Result<void> SimulatedRobot::halt() {
    m_rates.setZero();
    if (m_linkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    return {};
}

void SimulatedRobot::advance(double dt_s) {
    const double until_s = std::min(m_clock.now_s() + dt_s, m_expires_s);
    const double moving_s = std::max(0.0, until_s - m_clock.now_s());
    m_exact += moving_s * m_rates;
    for (int k = 0; k < 6; ++k)
        if (m_config.free[static_cast<std::size_t>(k)])
            m_exact[k] = std::clamp(m_exact[k], m_config.lower[k], m_config.upper[k]);
}

} // namespace bask
