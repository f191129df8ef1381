#include "engine/runtime/retreat_motion.h"

#include "engine/control/velocity_solve.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kRetreated = 1e-3;  ///< m, rad: it has arrived
constexpr double kNearlyAway = 5e-3; ///< m, rad: near enough if it stands still
constexpr double kAnnounced_s = 10.0;

double farthest(const Vector6d& a, const Vector6d& b) {
    return (a - b).cwiseAbs().maxCoeff();
}

} // namespace

RetreatMotion::RetreatMotion(const Experiment& experiment, const RigDevices& devices,
                             const RigReadings& readings, RobotMotion& motion, const Clock& clock,
                             TraceSample& sample)
    : m_experiment(experiment), m_devices(devices), m_readings(readings), m_motion(motion), m_clock(clock),
      m_sample(sample) {}

void RetreatMotion::begin() {
    m_motion.forgetGoal();
    m_at_s.reset();
    m_isRaised = false;
    m_approach.begin(m_clock.now_s());
    m_devices.robot.setRetreating(true);
}

void RetreatMotion::end() {
    m_devices.robot.setRetreating(false);
}

RetreatMotion::Step RetreatMotion::step() {
    // It never moves sideways near the source. A robot with an unsure position only moves off the source.
    const RobotLimits& limits = m_experiment.robot;
    const Vector6d& q = m_readings.coordinates();
    const double now_s = m_clock.now_s();
    const double period_s = m_experiment.sampling.period_s;
    if (m_motion.isHoming()) { // it takes no velocity until homing has ended
        m_approach.begin(now_s);
        return Step::UnderWay;
    }
    // A robot that cannot come nearer because of its limits has also arrived.
    const auto isThere = [&](const Vector6d& goal) {
        const double left = farthest(goal, q);
        m_approach.add(now_s, left, period_s);
        return left <= kRetreated ||
               (m_approach.isStill() && (left <= kNearlyAway || m_motion.rates().isZero(1e-9)));
    };
    Vector6d goal = poseOffSource(*m_readings.geometry(), q);
    bool isOver = false;
    if (!m_isRaised && isThere(goal)) {
        m_isRaised = true;
        m_approach.begin(now_s);
    }
    if (m_isRaised) {
        goal = q;
        for (int k = kThetaX; k <= kThetaZ; ++k)
            if (limits.free[static_cast<std::size_t>(k)] && m_readings.robot().isPlaceSure)
                goal[k] = std::clamp(0.0, limits.lower[k], limits.upper[k]);
        isOver = isThere(goal);
    }
    m_left_m = (goal - q).head<3>().norm();
    if (isOver)
        return Step::There;
    if (m_approach.isStill())
        return Step::Stuck;
    const VelocitySolution way = velocityTowards(*m_readings.geometry(), q, goal, period_s, m_motion.rates());
    m_sample.limits = way.limits;
    m_motion.move(way.rates);
    return Step::UnderWay;
}

bool RetreatMotion::isAway() const {
    const Vector6d& q = m_readings.coordinates();
    return farthest(poseOffSource(*m_readings.geometry(), q), q) <= kNearlyAway;
}

double RetreatMotion::longest_m() const {
    const RobotLimits& limits = m_experiment.robot;
    const Eigen::Vector3d away = m_readings.geometry()->away();
    Vector6d nearest = m_readings.coordinates();
    for (int k = 0; k < 3; ++k)
        if (limits.free[static_cast<std::size_t>(k)])
            nearest[k] = away[k] > 0.0 ? limits.lower[k] : limits.upper[k];
    return (poseOffSource(*m_readings.geometry(), nearest) - nearest).head<3>().norm();
}

bool RetreatMotion::announce(bool isWanted) {
    if (!isWanted) {
        m_at_s.reset();
        return false;
    }
    if (!m_at_s)
        m_at_s = m_clock.now_s() + kAnnounced_s;
    return m_clock.now_s() >= *m_at_s - 1e-9;
}

} // namespace bask
