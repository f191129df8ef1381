#include "engine/runtime/robot_motion.h"

#include "engine/base/edge_units.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/base/words.h"
#include "engine/control/velocity_solve.h"
#include "engine/runtime/command.h"
#include "engine/runtime/safety_monitor.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kVelocityPeriods = 1.5; ///< a commanded velocity expires after this number of periods
constexpr double kHomingStarts_s = 2.0;  ///< longest time from the command until homing starts
// Half of what a position-stepping robot resolves.
constexpr double kThere_m = 6e-5;
constexpr double kThere_rad = 3e-4;

} // namespace

RobotMotion::RobotMotion(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings,
                         const Clock& clock, TraceSample& sample, Refused refused)
    : m_experiment(experiment), m_devices(devices), m_readings(readings), m_clock(clock), m_sample(sample),
      m_refused(std::move(refused)) {}

void RobotMotion::move(const Vector6d& rates) {
    move(rates, kVelocityPeriods * m_experiment.sampling.period_s);
}

void RobotMotion::move(const Vector6d& rates, double validFor_s) {
    m_rates = rates;
    m_sample.twist.head<3>() = rates.head<3>();
    m_sample.twist.tail<3>() = rotationAxes(m_readings.coordinates()) * rates.tail<3>();
    if (const auto result = m_devices.robot.setTwist(m_sample.twist, validFor_s); !result)
        m_refused(result.error().message);
}

void RobotMotion::backOff() {
    const RigGeometry& geometry = *m_readings.geometry();
    const Vector6d& q = m_readings.coordinates();
    m_sample.limits.add(Limit::Clearance);
    move(velocityTowards(geometry, q, poseOffSource(geometry, q), m_experiment.sampling.period_s, m_rates)
             .rates);
}

void RobotMotion::standStill() {
    // Errors are ignored: a dead link is known already, and the velocity expires in the robot.
    (void)m_devices.robot.halt();
    m_rates.setZero();
    m_sample.twist.setZero();
    m_sample.limits = {}; // no limit is active
}

Result<void> RobotMotion::moveTo(const Vector6d& goal) {
    if (m_isHoming)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Move), "Homing"});
    Vector6d reachable = goal;
    for (std::size_t k = 0; k < 6; ++k)
        if (!m_experiment.robot.free[k])
            reachable[static_cast<Eigen::Index>(k)] = m_readings.coordinates()[static_cast<Eigen::Index>(k)];
    if (!reachable.allFinite() || !m_readings.geometry()->allowed(reachable))
        return Error(MessageCode::MoveOutside, {});
    m_goal = reachable;
    m_approach.begin(m_clock.now_s());
    return {};
}

Result<void> RobotMotion::jog(const Vector6d& twist) {
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
    const Vector6d& q = m_readings.coordinates();
    Vector6d rates = twist;
    rates.tail<3>() = rotationAxes(q).inverse() * twist.tail<3>();
    const Vector6d goal = q + Jog::kJog_s * rates;
    m_jogEnds_s = m_clock.now_s() + Jog::kJog_s;
    move(velocityTowards(*m_readings.geometry(), q, goal, Jog::kJog_s, m_rates).rates, Jog::kJog_s);
    return {};
}

Result<void> RobotMotion::home() {
    endMove();
    if (auto asked = m_devices.robot.home(); !asked)
        return asked;
    m_isHoming = true;
    m_isHomingSeen = false;
    m_homingSince_s = m_clock.now_s();
    return {};
}

Result<void> RobotMotion::clearAlarm() {
    endMove();
    return m_devices.robot.clearAlarm();
}

std::optional<RobotLag> RobotMotion::lag() const {
    const RobotLimits& limits = m_experiment.robot;
    return m_devices.robot.lagAt(limits.maxSpeed_m_s, limits.maxRotation_rad_s,
                                 kVelocityPeriods * m_experiment.sampling.period_s);
}

Result<void> RobotMotion::checkReach() const {
    const RobotLimits& workspace = m_experiment.robot;
    const RobotReach reach = m_devices.robot.reach();
    for (int k = 0; k < 6; ++k) {
        const bool isLow = workspace.lower[k] < reach.lower[k] - kThere_m;
        if (!workspace.free[static_cast<std::size_t>(k)] ||
            (!isLow && workspace.upper[k] <= reach.upper[k] + kThere_m))
            continue;
        const EdgeUnit unit = coordinateUnit(k);
        const auto text = [unit](double si) {
            return formatNumber(fromSi(si, unit).value, 6) + ' ' + std::string(readableUnit(unit));
        };
        return Error(MessageCode::ReasonReachShort, {},
                     {kCoordinateNames[static_cast<std::size_t>(k)],
                      text(isLow ? workspace.lower[k] : workspace.upper[k]),
                      text(isLow ? reach.lower[k] : reach.upper[k])});
    }
    return {};
}

Message RobotMotion::goOn() {
    if (!m_goal) { // a jog has ended by itself
        if (!m_rates.isZero(0.0) && !isMoving())
            standStill();
        return {};
    }
    const double period_s = m_experiment.sampling.period_s;
    const Vector6d& q = m_readings.coordinates();
    const Vector6d left = (*m_goal - q).cwiseAbs();
    const bool arrived = left.head<3>().maxCoeff() <= kThere_m && left.tail<3>().maxCoeff() <= kThere_rad;
    const Vector6d rates = velocityTowards(*m_readings.geometry(), q, *m_goal, period_s, m_rates).rates;
    m_approach.add(m_clock.now_s(), left.maxCoeff(), period_s);
    const bool stands = std::max(rates.cwiseAbs().maxCoeff(), m_rates.cwiseAbs().maxCoeff()) < 1e-9;
    if (arrived || stands)
        endMove();
    else if (m_approach.isStill())
        return doesNotMove(left.head<3>().norm());
    else
        move(rates);
    return {};
}

void RobotMotion::endMove() {
    m_goal.reset();
    m_jogEnds_s = -1e300;
    standStill();
}

void RobotMotion::breakOff() {
    m_isHoming = false;
    endMove();
}

void RobotMotion::watch() {
    if (!m_readings.isRobotTelling())
        return;
    const bool isUnderWay = m_readings.robot().moving;
    m_isHomingSeen = m_isHomingSeen || isUnderWay;
    // A short one is over between two looks: the place is sure then.
    const bool mayBegin = !m_isHomingSeen && !m_readings.robot().isPlaceSure &&
                          m_clock.now_s() - m_homingSince_s < kHomingStarts_s;
    m_isHoming = m_isHoming && (isUnderWay || mayBegin);
}

PlaceState RobotMotion::placeState() const {
    const double old_s = std::max(SafetyMonitor::kRobotSlow_s,
                                  m_experiment.safety.stalePeriods * m_experiment.sampling.period_s);
    if (m_readings.robotProblem().code != MessageCode::None || !(placeAge_s() <= old_s))
        return PlaceState::Unknown;
    return m_readings.robot().isPlaceSure && !m_isHoming ? PlaceState::Sure : PlaceState::Unsure;
}

double RobotMotion::placeAge_s() const {
    return m_readings.answers().hasRobot ? m_clock.now_s() - m_readings.robot().time_s
                                         : std::numeric_limits<double>::infinity();
}

} // namespace bask
