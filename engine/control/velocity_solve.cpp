#include "engine/control/velocity_solve.h"

#include "engine/control/norm_bounded.h"
#include "engine/control/travel_time.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kMinDamping = 1e-6;    ///< keeps the normal matrix regular
constexpr double kHeightSlack_m = 1e-9; ///< by which a height may miss its bound
/// solves, each with further points of the outlines, before a step is shortened
constexpr int kMaxRounds = 7;

/// Rates after braking at full strength for dt_s, on a straight line.
Vector6d brakedRates(const RigGeometry& geometry, const Vector6d& q, const Vector6d& lastRates, double dt_s) {
    const RobotLimits& limits = geometry.limits();
    if (!limits.limitsAcceleration())
        return Vector6d::Zero();
    const double speed = lastRates.head<3>().norm();
    const double rotation = (rotationAxes(q) * lastRates.tail<3>()).norm();
    double share = 1.0; // of the velocity that is removed
    if (limits.maxAcceleration_m_s2 > 0.0 && speed > 0.0)
        share = std::min(share, limits.maxAcceleration_m_s2 * dt_s / speed);
    if (limits.maxAngularAcceleration_rad_s2 > 0.0 && rotation > 0.0)
        share = std::min(share, limits.maxAngularAcceleration_rad_s2 * dt_s / rotation);
    return (1.0 - share) * lastRates;
}

/// Longest time that braking on a straight line takes, from any allowed velocity.
double longestBraking_s(const RobotLimits& limits) {
    double time_s = 0.0;
    if (limits.maxAcceleration_m_s2 > 0.0)
        time_s = limits.maxSpeed_m_s / limits.maxAcceleration_m_s2;
    if (limits.maxAngularAcceleration_rad_s2 > 0.0)
        time_s = std::max(time_s, limits.maxRotation_rad_s / limits.maxAngularAcceleration_rad_s2);
    return time_s;
}

/// Largest p with dt max(p, (p + last) / 2) + p braking_s <= distance.
double fastestTowards(double distance, double last, double dt_s, double braking_s) {
    const double steady = distance / (dt_s + braking_s);
    return steady >= last ? steady : (distance - 0.5 * dt_s * last) / (0.5 * dt_s + braking_s);
}

/// The problem in the free coordinates about braking at full strength: rates = braked + scale * y.
struct Scaled {
    SmallMatrix H; ///< damped normal matrix
    SmallVector f;
    SmallRows G;
    RowVector h;
    SmallVector scale;
    std::vector<NormBound> norms;
    std::vector<Limit> normNames;
};

SmallVector freeOf(const std::vector<int>& free, const Vector6d& rates) {
    SmallVector out(static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
        out[static_cast<Eigen::Index>(k)] = rates[free[k]];
    return out;
}

/// Adds |M (rates - centre)| <= radius, M acting on the free coordinates.
void addNorm(Scaled& s, Limit name, const NormBound& M, const SmallVector& braked, const SmallVector& centre,
             double radius) {
    NormBound norm;
    norm.B = M.B * s.scale.asDiagonal();
    norm.b = M.B * (centre - braked);
    norm.radius = radius;
    s.norms.push_back(norm);
    s.normNames.push_back(name);
}

void addNorms(Scaled& s, const RigGeometry& geometry, const VelocityProblem& problem,
              const SmallVector& braked) {
    const auto& free = geometry.freeCoordinates();
    const auto n = static_cast<Eigen::Index>(free.size());
    const RobotLimits& limits = geometry.limits();
    const Eigen::Matrix3d axes = rotationAxes(problem.coordinates);
    NormBound speed, rotation;
    speed.B.setZero(3, n);
    rotation.B.setZero(3, n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int c = free[static_cast<std::size_t>(k)];
        if (c < 3)
            speed.B(c, k) = 1.0;
        else
            rotation.B.col(k) = axes.col(c - 3);
    }
    const SmallVector zero = SmallVector::Zero(n);
    const SmallVector last = freeOf(free, problem.lastRates);
    if (free.front() < 3) {
        addNorm(s, Limit::Speed, speed, braked, zero, limits.maxSpeed_m_s);
        if (limits.maxAcceleration_m_s2 > 0.0)
            addNorm(s, Limit::Acceleration, speed, braked, last, limits.maxAcceleration_m_s2 * problem.dt_s);
    }
    if (free.back() >= 3) {
        addNorm(s, Limit::Rotation, rotation, braked, zero, limits.maxRotation_rad_s);
        if (limits.maxAngularAcceleration_rad_s2 > 0.0)
            addNorm(s, Limit::AngularAcceleration, rotation, braked, last,
                    limits.maxAngularAcceleration_rad_s2 * problem.dt_s);
    }
}

/// Scale of each free coordinate: the change that the limits allow in one step.
SmallVector scales(const RigGeometry& geometry, double dt_s) {
    const RobotLimits& limits = geometry.limits();
    const auto smaller = [&](double speed, double acceleration) {
        return acceleration > 0.0 ? std::min(speed, acceleration * dt_s) : speed;
    };
    const auto& free = geometry.freeCoordinates();
    SmallVector scale(static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
        scale[static_cast<Eigen::Index>(k)] =
            free[k] < 3 ? smaller(limits.maxSpeed_m_s, limits.maxAcceleration_m_s2)
                        : smaller(limits.maxRotation_rad_s, limits.maxAngularAcceleration_rad_s2);
    return scale;
}

/// A point of an outline that has to stay above the floor: gradient . rates >= min_m_s.
struct Cut {
    Vector6d gradient;
    double min_m_s = 0.0;
};

void addCutRows(const std::vector<Cut>& cuts, const std::vector<int>& free, const SmallVector& braked,
                Scaled& s) {
    Eigen::Index row = s.h.size();
    s.G.conservativeResize(row + static_cast<Eigen::Index>(cuts.size()), Eigen::NoChange);
    s.h.conservativeResize(s.G.rows());
    for (const Cut& cut : cuts) {
        const SmallVector gradient = freeOf(free, cut.gradient);
        s.G.row(row) = gradient.cwiseProduct(s.scale).transpose();
        s.h[row++] = cut.min_m_s - gradient.dot(braked);
    }
}

Scaled scaledProblem(const RigGeometry& geometry, const VelocityProblem& problem, const Vector6d& brakedRates,
                     double largestSingularValue, const std::vector<Cut>& cuts) {
    const auto& free = geometry.freeCoordinates();
    const auto n = static_cast<Eigen::Index>(free.size());
    Scaled s;
    s.scale = scales(geometry, problem.dt_s);
    const SmallVector braked = freeOf(free, brakedRates);
    const SmallVector last = freeOf(free, problem.lastRates);
    SmallMatrix A(problem.rows.rows(), n);
    SmallVector damping(n);
    const double mu = std::max(problem.damping, kMinDamping) * std::max(largestSingularValue, 1e-12);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int c = free[static_cast<std::size_t>(k)];
        A.col(k) = problem.rows.col(c);
        damping[k] = std::pow(mu * (c < 3 ? 1.0 : problem.rotationLength_m), 2);
    }
    SmallMatrix H = A.transpose() * A;
    H.diagonal() += damping;
    s.f = s.scale.cwiseProduct(A.transpose() * problem.wanted - H * braked);
    s.H = s.scale.asDiagonal() * H * s.scale.asDiagonal();

    Eigen::MatrixXd G;
    Eigen::VectorXd h;
    stepLimits(geometry, problem.coordinates, G, h);
    s.G = G * s.scale.asDiagonal();
    s.h = h / problem.dt_s - G * braked;
    if (geometry.limits().limitsAcceleration()) {
        const double braking_s = longestBraking_s(geometry.limits());
        for (Eigen::Index i = 0; i < h.size(); ++i) {
            const double max =
                std::max(fastestTowards(-h[i], -G.row(i).dot(last), problem.dt_s, braking_s),
                         -G.row(i).dot(braked)); // if braking cannot help at the start, at least that
            s.h[i] = -max - G.row(i).dot(braked);
        }
    }
    addCutRows(cuts, free, braked, s);
    addNorms(s, geometry, problem, braked);
    return s;
}

/// Returns after which time of going on with `rates` a step, or the braking after it, is too low; empty if it
/// never is.
std::optional<double> tooLowAfter_s(const RigGeometry& geometry, const Vector6d& q, const Vector6d& rates,
                                    double dt_s, double min_m) {
    const auto isTooLow = [&](double time_s) {
        return geometry.lowestPoint_m(q + time_s * rates) < min_m - kHeightSlack_m;
    };
    const RobotLimits& limits = geometry.limits();
    if (!limits.limitsAcceleration())
        return isTooLow(dt_s) ? std::optional(dt_s) : std::nullopt;
    double braking_s = 0.0;
    if (limits.maxAcceleration_m_s2 > 0.0)
        braking_s = rates.head<3>().norm() / limits.maxAcceleration_m_s2;
    if (limits.maxAngularAcceleration_rad_s2 > 0.0)
        braking_s = std::max(braking_s, (rotationAxes(q) * rates.tail<3>()).norm() /
                                            limits.maxAngularAcceleration_rad_s2);
    const double reach_s = 1.5 * dt_s + 0.5 * braking_s;
    for (const double share : {1.0, 0.75, 0.5, 0.25})
        if (isTooLow(share * reach_s))
            return share * reach_s;
    return std::nullopt;
}

/// Adds the points that are too low after so long, which the rows of the points that are lowest at q do not
/// see: where a face is parallel to the floor, another side of it comes down with each tilt. If the way is
/// curved downwards, the rates have to make up for it. The lowest first, at most `room`; returns whether
/// there was any room.
bool addCuts(const RigGeometry& geometry, const Vector6d& q, const Vector6d& rates, double time_s,
             double min_m, std::size_t room, std::vector<Cut>& cuts) {
    const Vector6d low = q + time_s * rates;
    const std::vector<Clearance> there = geometry.clearances(low);
    const std::vector<Clearance> here = geometry.clearances(q, low);
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < there.size(); ++i)
        if (there[i].height_m < min_m - kHeightSlack_m)
            order.push_back(i);
    std::ranges::sort(order, {}, [&](std::size_t i) { return there[i].height_m; });
    order.resize(std::min(order.size(), room));
    for (const std::size_t i : order) {
        const double straight_m = there[i].height_m - here[i].gradient.dot(low - q);
        cuts.push_back({here[i].gradient, (min_m - std::min(here[i].height_m, straight_m)) / time_s});
    }
    return !order.empty();
}

/// Shortens a step that even the cuts do not keep clear.
void shorten(const RigGeometry& geometry, const VelocityProblem& problem, const Vector6d& braked,
             double min_m, VelocitySolution& solution) {
    const auto isTooLow = [&] {
        return tooLowAfter_s(geometry, problem.coordinates, solution.rates, problem.dt_s, min_m).has_value();
    };
    for (int i = 0; i < 30 && isTooLow(); ++i) {
        solution.rates = braked + 0.7 * (solution.rates - braked);
        solution.limits.add(Limit::Clearance);
    }
}

} // namespace

SingularRange singularRange(const RigGeometry& geometry, const Eigen::Matrix<double, Eigen::Dynamic, 6>& rows,
                            double rotationLength_m) {
    const auto& free = geometry.freeCoordinates();
    if (rows.rows() > kMaxUnknowns)
        throw std::invalid_argument("singularRange: at most six rows");
    if (rows.rows() == 0 || free.empty())
        return {};
    SmallMatrix A(rows.rows(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
        A.col(static_cast<Eigen::Index>(k)) = rows.col(free[k]) / (free[k] < 3 ? 1.0 : rotationLength_m);
    const Eigen::JacobiSVD<SmallMatrix> svd(A);
    return {svd.singularValues().tail<1>()[0], svd.singularValues()[0]};
}

void stepLimits(const RigGeometry& geometry, const Vector6d& q, Eigen::MatrixXd& G, Eigen::VectorXd& h) {
    const auto& free = geometry.freeCoordinates();
    const RobotLimits& limits = geometry.limits();
    const auto n = static_cast<Eigen::Index>(free.size());
    const std::vector<Clearance> clearances = geometry.clearances(q);
    const auto m = 2 * n + static_cast<Eigen::Index>(clearances.size());
    G = Eigen::MatrixXd::Zero(m, n);
    h = Eigen::VectorXd::Zero(m);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int c = free[static_cast<std::size_t>(k)];
        G(2 * k, k) = 1.0;
        h[2 * k] = std::min(0.0, limits.lower[c] - q[c]);
        G(2 * k + 1, k) = -1.0;
        h[2 * k + 1] = std::min(0.0, q[c] - limits.upper[c]);
        for (std::size_t i = 0; i < clearances.size(); ++i)
            G(2 * n + static_cast<Eigen::Index>(i), k) = clearances[i].gradient[c];
    }
    for (std::size_t i = 0; i < clearances.size(); ++i)
        h[2 * n + static_cast<Eigen::Index>(i)] = std::min(0.0, limits.clearance_m - clearances[i].height_m);
}

namespace {

/// Takes the rates and the active limits of a solution.
void take(const RigGeometry& geometry, const Scaled& s, const NormBoundedSolution& solution,
          const Vector6d& braked, VelocitySolution& out) {
    const auto& free = geometry.freeCoordinates();
    out.rates = braked;
    out.limits = {};
    for (std::size_t k = 0; k < free.size() && solution.converged; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        out.rates[free[k]] += s.scale[i] * solution.y[i];
    }
    const auto boxes = 2 * free.size();
    const auto rows = static_cast<std::size_t>(s.h.size());
    for (const int index : solution.active) {
        const auto i = static_cast<std::size_t>(index);
        if (i < boxes)
            out.limits.add(Limit::Workspace, free[i / 2]);
        else
            out.limits.add(i < rows ? Limit::Clearance : s.normNames[i - rows]);
    }
    if (!solution.converged)
        out.limits.addUnnamed();
}

} // namespace

VelocitySolution solveVelocity(const RigGeometry& geometry, const VelocityProblem& problem) {
    VelocitySolution out;
    const auto& free = geometry.freeCoordinates();
    if (free.empty())
        return out;
    const SingularRange range = singularRange(geometry, problem.rows, problem.rotationLength_m);
    const Vector6d braked = brakedRates(geometry, problem.coordinates, problem.lastRates, problem.dt_s);
    out.smallestSingularValue = range.smallest;
    const Vector6d& q = problem.coordinates;
    const double min_m = std::min(geometry.lowestPoint_m(q), geometry.limits().clearance_m);
    std::vector<Cut> cuts;
    for (int round = 0; round < kMaxRounds; ++round) {
        const Scaled s = scaledProblem(geometry, problem, braked, range.largest, cuts);
        const NormBoundedSolution solution = solveNormBounded(s.H, s.f, s.G, s.h, s.norms);
        if (!solution.converged && round > 0)
            break; // no step satisfies the cuts: the one before is shortened
        take(geometry, s, solution, braked, out);
        const auto time_s = tooLowAfter_s(geometry, q, out.rates, problem.dt_s, min_m);
        if (!time_s)
            return out;
        const std::size_t room = kMaxRows - static_cast<std::size_t>(s.h.size()) - s.norms.size();
        if (!addCuts(geometry, q, out.rates, *time_s, min_m, room, cuts))
            break;
    }
    shorten(geometry, problem, braked, min_m, out);
    return out;
}

double travelTime_s(const RobotLimits& limits, const Vector6d& a, const Vector6d& b) {
    return TravelTime(limits, a).to(b);
}

Vector6d poseOffSource(const RigGeometry& geometry, const Vector6d& q) {
    const RobotLimits& limits = geometry.limits();
    const Eigen::Vector3d n = geometry.away();
    int steepest = -1; // the free axis that moves away fastest: its end is the goal's
    for (int k = 0; k < 3; ++k)
        if (limits.free[static_cast<std::size_t>(k)] && n[k] != 0.0 &&
            (steepest < 0 || std::abs(n[k]) > std::abs(n[steepest])))
            steepest = k;
    Vector6d goal = q;
    if (steepest < 0)
        return goal;
    const double end = n[steepest] > 0.0 ? limits.upper[steepest] : limits.lower[steepest];
    const double way = (end - q[steepest]) / n[steepest];
    for (int k = 0; k < 3; ++k)
        if (limits.free[static_cast<std::size_t>(k)] && n[k] != 0.0)
            goal[k] = std::clamp(q[k] + way * n[k], limits.lower[k], limits.upper[k]);
    goal[steepest] = end;
    return goal;
}

Vector6d poseFacingSource(const RigGeometry& geometry, const Vector6d& q) {
    const RobotLimits& limits = geometry.limits();
    const Pose& X_RS = geometry.X_RS();
    const double height_m = geometry.away().dot(q.head<3>() - X_RS.translation());
    const Vector6d facing = coordinatesFromPose(X_RS * Eigen::Translation3d(0.0, 0.0, height_m));
    Vector6d goal = q;
    for (const int k : geometry.freeCoordinates())
        goal[k] = std::clamp(facing[k], limits.lower[k], limits.upper[k]);
    return goal;
}

namespace {

/// Share of full speed that still lets the robot stop after `path_s` seconds of full speed; braking from full
/// speed takes `braking_s`. Largest p with dt max(p, (p + last) / 2) + way(p) <= path, where way(p) is that
/// of braking by dt / braking_s each step, trapezoids: of m whole steps and a remainder r,
/// dt (m^2 step / 2 + (m + 1/2) r). Where full speed can be taken away within one step, a change takes only
/// its part of braking_s.
double shareOfSpeed(double path_s, double last, double braking_s, double dt_s) {
    if (braking_s <= 0.0)
        return std::min(1.0, path_s / dt_s);
    if (braking_s <= dt_s) { // dt p + braking (max(last - p, 0)^2 + p^2) / 2 <= path
        const double relative_s = dt_s / braking_s;
        const double steps = path_s / braking_s;
        const double steady = 2.0 * steps / (relative_s + std::sqrt(relative_s * relative_s + 2.0 * steps));
        if (steady >= last)
            return std::min(1.0, steady);
        const double turn = 0.5 * (last - relative_s); // of the parabola p^2 - 2 turn p
        return std::clamp(turn + std::sqrt(std::max(0.0, turn * turn + steps - 0.5 * last * last)), 0.0,
                          std::min(last, 1.0));
    }
    const double step = dt_s / braking_s;
    const double steps = path_s / (dt_s * step);
    double m = std::floor(std::sqrt(1.0 + 2.0 * steps) - 1.0);
    const double steady = step * (m + (steps - m - 0.5 * m * m) / (m + 1.5));
    if (steady >= last)
        return std::min(1.0, steady);
    const double left = std::max(0.0, steps - 0.5 * last / step);
    m = std::floor(0.5 * (std::sqrt(1.0 + 8.0 * left) - 1.0));
    return std::min({1.0, last, step * (m + (left - 0.5 * (m * m + m)) / (m + 1.0))});
}

/// The allowed velocity nearest to `wanted`; it slides along active limits.
VelocitySolution nearestVelocity(const RigGeometry& geometry, const Vector6d& q, const Vector6d& wanted,
                                 double dt_s, const Vector6d& lastRates) {
    VelocityProblem problem;
    problem.rows =
        Vector6d(1.0, 1.0, 1.0, kRotationLength_m, kRotationLength_m, kRotationLength_m).asDiagonal();
    problem.wanted = problem.rows * wanted;
    problem.coordinates = q;
    problem.lastRates = lastRates;
    problem.dt_s = dt_s;
    problem.rotationLength_m = kRotationLength_m;
    problem.damping = 1e-6;
    return solveVelocity(geometry, problem);
}

/// Adds to `rates` the motion away from the source that a step of dt needs for its clearance, within the
/// speed limit; returns whether it needs any. On a straight line between two poses at the clearance,
/// curvature and rounding alone take some nanometres.
bool liftOver(const RigGeometry& geometry, const Vector6d& q, double dt_s, Vector6d& rates) {
    constexpr double kRounding_m = 1e-6;
    const RobotLimits& limits = geometry.limits();
    const Eigen::Vector3d off = (poseOffSource(geometry, q) - q).head<3>();
    const double lacking_m = limits.clearance_m - geometry.lowestPoint_m(q + dt_s * rates);
    const double rise = off.normalized().dot(geometry.away());
    if (lacking_m <= 0.0 || off.norm() == 0.0 || rise <= 0.0)
        return false;
    Vector6d lifted = rates;
    lifted.head<3>() += (lacking_m + 1e-9) / (dt_s * rise) * off.normalized();
    lifted *= std::min(1.0, limits.maxSpeed_m_s / std::max(lifted.head<3>().norm(), 1e-12));
    if (!geometry.allowed(q + dt_s * lifted))
        return false;
    rates = lifted;
    return lacking_m > kRounding_m;
}

/// Whether rates that lead to an allowed goal may be taken up without a solve: within the limits of
/// acceleration, with room to stop afterwards, whether the robot takes them up at once or over the period.
bool mayTakeUp(const RigGeometry& geometry, const Vector6d& q, const Vector6d& rates, double dt_s,
               const Vector6d& lastRates) {
    const RobotLimits& limits = geometry.limits();
    const Vector6d change = rates - lastRates;
    double change_s = 0.0, braking_s = 0.0;
    const auto count = [&](double acceleration, double changed, double speed) {
        if (acceleration <= 0.0)
            return;
        change_s = std::max(change_s, changed / acceleration);
        braking_s = std::max(braking_s, speed / acceleration);
    };
    count(limits.maxAcceleration_m_s2, change.head<3>().norm(), rates.head<3>().norm());
    const Eigen::Matrix3d axes = rotationAxes(q);
    count(limits.maxAngularAcceleration_rad_s2, (axes * change.tail<3>()).norm(),
          (axes * rates.tail<3>()).norm());
    if (change_s > dt_s)
        return false;
    const Vector6d stop = 0.5 * (braking_s <= dt_s ? dt_s : dt_s + braking_s) * rates;
    for (const Vector6d& step : {Vector6d(dt_s * rates), Vector6d(0.5 * dt_s * (rates + lastRates))})
        if (!geometry.allowed(q + step) || !geometry.allowed(q + step + stop))
            return false;
    return true;
}

/// The component of `rates` along `wanted`, relative to `wanted`.
double shareOf(const Vector6d& rates, const Vector6d& wanted) {
    return rates.dot(wanted) / wanted.squaredNorm();
}

} // namespace

VelocitySolution velocityTowards(const RigGeometry& geometry, const Vector6d& q, const Vector6d& goal,
                                 double dt_s, const Vector6d& lastRates) {
    const RobotLimits& limits = geometry.limits();
    VelocitySolution out;
    const double time_s = travelTime_s(limits, q, goal);
    if (time_s <= 0.0)
        return limits.limitsAcceleration() ? nearestVelocity(geometry, q, Vector6d::Zero(), dt_s, lastRates)
                                           : out;
    const Vector6d full = (goal - q) / time_s;
    const double last = std::max(0.0, shareOf(lastRates, full));
    const double share = shareOfSpeed(time_s, last, longestBraking_s(limits), dt_s);
    Vector6d straight = share * full;
    const bool lifted = liftOver(geometry, q, dt_s, straight);
    const bool open = geometry.allowed(q + dt_s * straight);
    if (open && (!limits.limitsAcceleration() || mayTakeUp(geometry, q, straight, dt_s, lastRates))) {
        out.rates = straight;
        if (time_s > dt_s && share >= 1.0)
            out.limits.add((goal - q).head<3>().norm() / limits.maxSpeed_m_s >= time_s * (1.0 - 1e-9)
                               ? Limit::Speed
                               : Limit::Rotation);
        if (lifted)
            out.limits.add(Limit::Clearance);
        return out;
    }
    out = nearestVelocity(geometry, q, straight, dt_s, lastRates);
    const bool stuck = !open && out.rates.norm() < 0.05 * straight.norm() &&
                       (out.limits.has(Limit::Clearance) || !limits.limitsAcceleration());
    const Eigen::Vector3d off = (poseOffSource(geometry, q) - q).head<3>();
    if (stuck && off.norm() > 0.0) { // moving away from the source is always allowed
        Vector6d away = Vector6d::Zero();
        away.head<3>() = std::min(limits.maxSpeed_m_s, off.norm() / dt_s) * off.normalized();
        out = nearestVelocity(geometry, q, away, dt_s, lastRates);
        out.limits.add(Limit::Clearance);
    }
    if (share >= 1.0)
        out.limits.add(Limit::Speed);
    return out;
}

} // namespace bask
