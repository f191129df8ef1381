#include "engine/drivers/step_planner.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr int kHalvings = 5;
constexpr double kShortest_s = 0.02;    // what is left of a velocity is not worth a step
constexpr double kRefusedPause_s = 0.1; // the guard is not asked the same again and again

} // namespace

double outside(const std::vector<double>& at, const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const auto [low, high] = std::minmax(a[i], b[i]);
        worst = std::max({worst, low - at[i], at[i] - high});
    }
    return worst;
}

StepPlanner::StepPlanner(AxisMap map, MotionGuard guard) : m_map(std::move(map)), m_guard(std::move(guard)) {}

void StepPlanner::setTwist(const Vector6d& twist, double validFor_s, double now_s) {
    if (m_isRefused && twist != m_twist)
        m_notBefore_s = now_s;
    m_twist = twist;
    m_expires_s = now_s + validFor_s;
}

void StepPlanner::renew() {
    m_notBefore_s = 0.0;
    m_goal.reset();
}

void StepPlanner::forget() {
    m_twist.setZero();
    m_expires_s = m_notBefore_s = 0.0;
    m_goal.reset();
    m_isRefused = false;
}

std::vector<double> StepPlanner::rounded(const Vector6d& coordinates) const {
    std::vector<double> out = m_map.positions(coordinates);
    for (double& position : out)
        position = std::round(position * 1000.0) / 1000.0;
    return out;
}

Vector6d StepPlanner::startFrom(const std::vector<double>& at) const {
    if (m_goal) {
        const std::vector<double> goal = m_map.positions(*m_goal);
        if (outside(at, goal, goal) <= kSlack)
            return *m_goal;
    }
    return m_map.coordinates(at);
}

double StepPlanner::approvedShare(const Vector6d& start, const Vector6d& way) const {
    const auto isFine = [&](double share) {
        return m_guard(m_map.coordinates(rounded(start + share * way)));
    };
    // What is carried on an arm swings out between two places that are fine.
    const bool turns = !way.tail<3>().isZero(0.0);
    const auto approves = [&](double share) {
        return isFine(share) &&
               (!turns || (isFine(0.75 * share) && isFine(0.5 * share) && isFine(0.25 * share)));
    };
    if (approves(1.0))
        return 1.0;
    double min = 0.0, max = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (min + max);
        (approves(middle) ? min : max) = middle;
    }
    return min;
}

std::optional<PlannedStep> StepPlanner::next(const std::vector<double>& at, double now_s) {
    if (now_s >= m_expires_s || now_s < m_notBefore_s || m_twist.isZero(0.0))
        return std::nullopt;
    const double left_s = std::min(kLongest_s, m_expires_s - now_s);
    if (left_s < kShortest_s)
        return std::nullopt;
    const double turn_rad_s = m_twist.tail<3>().norm();
    const double time_s = left_s * turn_rad_s > kMaxTurn_rad ? kMaxTurn_rad / turn_rad_s : left_s;
    const Vector6d start = startFrom(at);
    Vector6d way = time_s * m_twist;
    way.tail<3>() = rotationAxes(start).inverse() * way.tail<3>();
    if (!way.allFinite()) // turned to where its axes have no inverse
        return std::nullopt;
    const double share = approvedShare(start, way);
    m_isRefused = share == 0.0;
    m_notBefore_s = now_s + (m_isRefused ? kRefusedPause_s : share * time_s);
    if (m_isRefused)
        return std::nullopt;
    const Vector6d goal = start + share * way;
    m_goal = m_map.coordinates(m_map.positions(goal)); // coordinates without an axis stay
    PlannedStep step{at, rounded(goal), share * time_s};
    if (step.to == rounded(m_map.coordinates(at)))
        return std::nullopt; // it adds up in the goal until it is long enough
    return step;
}

} // namespace bask
