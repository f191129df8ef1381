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
    const bool told = m_clock.now_s() < m_expires_s && !m_wanted.isZero();
    const bool moving = told || !m_rates.isZero();
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
    m_wanted = rates;
    m_expires_s = m_clock.now_s() + validFor_s;
    return {};
}

Result<void> SimulatedRobot::halt() {
    m_wanted.setZero();
    if (m_linkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    return {};
}

void SimulatedRobot::ramp(const Vector6d& wanted, double dt_s) {
    if (dt_s <= 0.0)
        return;
    const Vector6d change = wanted - m_rates;
    double ramp_s = 0.0; // that the change takes
    if (m_config.maxAcceleration_m_s2 > 0.0)
        ramp_s = change.head<3>().norm() / m_config.maxAcceleration_m_s2;
    if (m_config.maxAngularAcceleration_rad_s2 > 0.0)
        ramp_s = std::max(ramp_s, (rotationAxes(m_exact) * change.tail<3>()).norm() /
                                      m_config.maxAngularAcceleration_rad_s2);
    const double ramping_s = std::min(ramp_s, dt_s);
    const Vector6d before = m_rates;
    m_rates = ramp_s > dt_s ? Vector6d(before + dt_s / ramp_s * change) : wanted;
    m_exact += 0.5 * ramping_s * (before + m_rates) + (dt_s - ramping_s) * wanted;
    for (int k = 0; k < 6; ++k)
        if (m_config.free[static_cast<std::size_t>(k)])
            m_exact[k] = std::clamp(m_exact[k], m_config.lower[k], m_config.upper[k]);
}

void SimulatedRobot::advance(double dt_s) {
    const double told_s = std::clamp(m_expires_s - m_clock.now_s(), 0.0, dt_s);
    ramp(m_wanted, told_s);
    ramp(Vector6d::Zero(), dt_s - told_s);
}

} // namespace bask
