// The rig by hand, while no run is armed or on.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/control/velocity_solve.h"
#include "engine/runtime/command.h"
#include "engine/runtime/servo_loop.h"

#include <Eigen/LU>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bask {

// Half of what a position-stepping robot resolves.
constexpr double kThere_m = 6e-5;
constexpr double kThere_rad = 3e-4;

bool ServoLoop::isByHand() const {
    return m_state == RunState::NotReady || m_state == RunState::Ready || m_state == RunState::Stopped;
}

Result<void> ServoLoop::moveTo(const Vector6d& goal) {
    if (!isByHand())
        return refusal(CommandVerb::Move);
    if (m_isHoming)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Move), "Homing"});
    Vector6d reachable = goal;
    for (std::size_t k = 0; k < 6; ++k)
        if (!m_experiment.robot.free[k])
            reachable[static_cast<Eigen::Index>(k)] = m_coordinates[static_cast<Eigen::Index>(k)];
    if (!reachable.allFinite() || !m_geometry->allowed(reachable))
        return Error(MessageCode::MoveOutside, {});
    m_goal = reachable;
    m_approach.begin(m_clock.now_s());
    return {};
}

Result<void> ServoLoop::jog(const Vector6d& twist) {
    if (!isByHand())
        return refusal(CommandVerb::Jog);
    if (m_isHoming)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Jog), "Homing"});
    if (!twist.allFinite())
        return Error(MessageCode::MoveOutside, {});
    if (m_goal)
        endMove();
    if (twist.isZero(0.0)) {
        endMove();
        return {};
    }
    Vector6d rates = twist;
    rates.tail<3>() = rotationAxes(m_coordinates).inverse() * twist.tail<3>();
    const Vector6d goal = m_coordinates + Jog::kJog_s * rates;
    m_jogEnds_s = m_clock.now_s() + Jog::kJog_s;
    move(velocityTowards(*m_geometry, m_coordinates, goal, Jog::kJog_s, m_rates).rates, Jog::kJog_s);
    return {};
}

Result<Zeroing> ServoLoop::findZero() const {
    if (m_state == RunState::Armed || running())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (heatOn() || m_handHeat_K)
        return Error(MessageCode::ReasonNotAtAmbient, {}, {temperatureArg(m_experiment.environment_K)});
    for (std::size_t i = 0; i < m_sensors.size(); ++i)
        if (const auto fresh = requireFreshSensor(i); !fresh)
            return fresh.error();
    return m_sensors.findZero(m_experiment.environment_K);
}

void ServoLoop::take(Zeroing found) {
    found.utc_s = std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    m_sensors.use(found);
    takeReadings(); // or the first step would see them as they were before
    m_safety.atRest(observe());
    event(MessageCode::EventZeroed);
}

Result<void> ServoLoop::zeroSensors() {
    auto found = findZero();
    if (!found)
        return found.error();
    take(std::move(*found));
    command("zero", zeroingJson(*m_sensors.zeroing()));
    return {};
}

Message ServoLoop::distrust(std::size_t object) const {
    const std::string& name = m_experiment.objects[object].name;
    const MessageArg told = roundedTemperatureArg(m_sensors.told_K(object, m_clock.now_s()));
    if (!m_sensors.isDistrusted(object))
        return {MessageCode::ReasonSensorDoubted, {name, told}};
    const HeatBounds* const bounds = m_sensors.bounds(object);
    return {MessageCode::ReasonSensorDistrusted,
            {name, told, roundedTemperatureArg(bounds->min_K()), roundedTemperatureArg(bounds->max_K())}};
}

SensorTrust ServoLoop::sensorTrust(std::size_t object) const {
    if (!m_sensors.isBelieved(object))
        return SensorTrust::Distrusted;
    return !m_sensors.fresh(object, m_clock.now_s()) || m_safety.isSensorStill(object) ? SensorTrust::Stale
                                                                                       : SensorTrust::Trusted;
}

Result<void> ServoLoop::confirmSensor(std::size_t object) {
    if (object >= m_sensors.size())
        return refusal(CommandVerb::ConfirmSensor);
    const std::string& name = m_experiment.objects[object].name;
    if (!m_sensors.confirm(object, m_clock.now_s()))
        return Error(MessageCode::ReasonSensorInvalid, {}, {name});
    m_safety.confirmSensor(object);
    const double value_K = m_sensors.measured_K(object);
    command("confirm-sensor", "{\"object\":" + std::to_string(object) +
                                  ",\"temperature_K\":" + formatNumber(value_K, 10) + "}");
    event(MessageCode::EventSensorConfirmed, {name, roundedTemperatureArg(value_K)});
    return {};
}

Result<void> ServoLoop::home() {
    if (!isByHand() && m_state != RunState::Fault)
        return refusal(CommandVerb::Home);
    endMove();
    if (const auto asked = m_devices.robot.home(); !asked)
        return asked;
    m_isHoming = true;
    m_isHomingSeen = false;
    m_homingSince_s = m_clock.now_s();
    return {};
}

Result<void> ServoLoop::clearRobotAlarm() {
    if (!isByHand() && m_state != RunState::Fault)
        return refusal(CommandVerb::ClearAlarm);
    endMove();
    return m_devices.robot.clearAlarm();
}

double ServoLoop::mostHeat_K() const {
    double most_K = m_experiment.source.temperature_K;
    for (const auto& point : m_experiment.source.temperatureProfile)
        most_K = std::max(most_K, point.value);
    return most_K;
}

Result<void> ServoLoop::setHeat(std::optional<double> setPoint_K) {
    if (!setPoint_K) { // off is never refused
        m_handHeat_K.reset();
        if (running() && m_state != RunState::Stopping)
            return stop();
        switchHeatOff();
        return {};
    }
    if (!isByHand())
        return refusal(CommandVerb::Heat);
    for (std::size_t i = 0; i < m_sensors.size(); ++i) // or nobody sees how hot the objects become
        if (const auto fresh = requireFreshSensor(i); !fresh)
            return fresh;
    if (const SafetyFinding* lost = m_safety.lostSensor())
        return Error(lost->message.code, {}, lost->message.args);
    if (!(*setPoint_K > m_experiment.environment_K && *setPoint_K <= mostHeat_K()))
        return Error(MessageCode::ValueOutOfRange, {},
                     {formatNumber(celsiusFromKelvin(*setPoint_K)),
                      formatNumber(celsiusFromKelvin(m_experiment.environment_K)),
                      formatNumber(celsiusFromKelvin(mostHeat_K())), "\u00b0C"});
    m_handHeat_K = setPoint_K;
    keepHeating();
    return {};
}

std::optional<double> ServoLoop::heatSetPoint_K() const {
    if (m_state == RunState::Running || m_state == RunState::Settled || m_state == RunState::Holding)
        return sourceSetPoint_K(m_experiment.source, m_clock.now_s() - m_startTime_s);
    return m_handHeat_K;
}

// Towards the goal; what was jogged has ended by itself.
void ServoLoop::goOn() {
    if (!m_goal) {
        if (!m_rates.isZero(0.0) && !isMoving())
            standStill();
        return;
    }
    const double period_s = m_experiment.sampling.period_s;
    const Vector6d left = (*m_goal - m_coordinates).cwiseAbs();
    const bool arrived = left.head<3>().maxCoeff() <= kThere_m && left.tail<3>().maxCoeff() <= kThere_rad;
    const Vector6d rates = velocityTowards(*m_geometry, m_coordinates, *m_goal, period_s, m_rates).rates;
    m_approach.add(m_clock.now_s(), left.maxCoeff(), period_s);
    if (arrived || rates.cwiseAbs().maxCoeff() < 1e-9)
        endMove();
    else if (m_approach.isStill())
        fault({MessageCode::RobotDoesNotMove,
               {formatNumber(std::round(left.head<3>().norm() * 1e3) * 0.1, 3)}});
    else
        move(rates);
}

void ServoLoop::endMove() {
    m_goal.reset();
    m_jogEnds_s = -1e300;
    standStill();
}

} // namespace bask
