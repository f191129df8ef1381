#include "engine/simulation/simulated_robot.h"

#include "engine/base/message_code.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

const Message kAlarm{MessageCode::RobotAlarm, {"1", "simulated hard limit"}};

} // namespace

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

void SimulatedRobot::placeAt(const Vector6d& coordinates) {
    for (int k = 0; k < 6; ++k)
        if (m_config.free[static_cast<std::size_t>(k)])
            m_exact[k] = std::clamp(coordinates[k], m_config.lower[k], m_config.upper[k]);
}

Result<RobotState> SimulatedRobot::state() {
    if (m_trouble == RobotTrouble::LinkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    if (m_trouble == RobotTrouble::Slow)
        return m_told;
    const bool told = m_clock.now_s() < m_expires_s && !m_wanted.isZero();
    const bool moving = told || !m_rates.isZero();
    m_told = {m_clock.now_s(), coordinates(), moving};
    m_told.isPlaceSure = m_trouble != RobotTrouble::Restarted;
    if (m_trouble == RobotTrouble::Alarm)
        m_told.alarm = kAlarm;
    return m_told;
}

void SimulatedRobot::setTrouble(RobotTrouble trouble) {
    if (trouble == m_trouble)
        return;
    m_trouble = trouble;
    if (trouble == RobotTrouble::Alarm || trouble == RobotTrouble::Restarted) { // it stops at once
        m_orders.clear();
        m_wanted.setZero();
        m_rates.setZero();
    }
}

Result<void> SimulatedRobot::home() {
    if (m_trouble == RobotTrouble::Restarted)
        m_trouble = RobotTrouble::None;
    return {};
}

Result<void> SimulatedRobot::clearAlarm() {
    if (m_trouble == RobotTrouble::Alarm)
        m_trouble = RobotTrouble::None;
    return {};
}

Result<void> SimulatedRobot::setTwist(const Vector6d& twist, double validFor_s) {
    if (m_trouble == RobotTrouble::LinkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    if (m_trouble == RobotTrouble::Alarm)
        return Error(kAlarm.code, {}, kAlarm.args);
    give(twist, validFor_s);
    return {};
}

Result<void> SimulatedRobot::halt() {
    give(Vector6d::Zero(), 0.0);
    if (m_trouble == RobotTrouble::LinkLost)
        return Error(MessageCode::ReasonRobotLost, {}, {"simulated link lost"});
    return {};
}

void SimulatedRobot::give(const Vector6d& twist, double validFor_s) {
    const double late_s = m_config.latency_s + (m_trouble == RobotTrouble::Slow ? kSlow_s : 0.0);
    m_orders.push_back({m_clock.now_s() + late_s, twist, validFor_s});
    obey(m_clock.now_s());
}

void SimulatedRobot::obey(double now_s) {
    for (; !m_orders.empty() && m_orders.front().time_s <= now_s; m_orders.pop_front()) {
        const Order& order = m_orders.front();
        Vector6d rates = order.twist;
        if (!order.twist.isZero(0.0)) // a halt needs no axes, not even where they have no inverse
            rates.tail<3>() = rotationAxes(m_exact).inverse() * order.twist.tail<3>();
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
        m_expires_s = order.time_s + order.validFor_s;
    }
}

void SimulatedRobot::advance(double dt_s) {
    const double end_s = m_clock.now_s() + dt_s;
    for (double now_s = m_clock.now_s(); now_s < end_s;) {
        const double next_s = m_orders.empty() ? end_s : std::min(end_s, m_orders.front().time_s);
        const double told_s = std::clamp(m_expires_s - now_s, 0.0, next_s - now_s);
        ramp(m_wanted, told_s);
        ramp(Vector6d::Zero(), next_s - now_s - told_s);
        now_s = next_s;
        obey(now_s);
    }
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

} // namespace bask
