#include "engine/control/velocity_solve.h"

#include "engine/control/bounded_least_squares.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kRelaxed = 1e-12; ///< relative slack on the speed norms

/// The problem in the free coordinates, rotation scaled: y = scale * rates.
struct Scaled {
    Eigen::MatrixXd A;
    Eigen::MatrixXd H; ///< damped normal matrix
    Eigen::VectorXd f;
    Eigen::MatrixXd G;
    Eigen::VectorXd h;
    Eigen::VectorXd scale;
    Eigen::MatrixXd speed;    ///< v = speed * y
    Eigen::MatrixXd rotation; ///< w = rotation * y
};

BoundedSolution solveWithPrices(const Scaled& s, double speedPrice, double rotationPrice) {
    const Eigen::MatrixXd H = s.H + speedPrice * s.speed.transpose() * s.speed +
                              rotationPrice * s.rotation.transpose() * s.rotation;
    return solveBounded(H, s.f, s.G, s.h);
}

/// Smallest price at which `excess` (falling in the price) is not positive, by bracketing and bisection in
/// its logarithm.
template <class Excess> double priceFor(double unit, Excess excess) {
    if (excess(0.0) <= 0.0)
        return 0.0;
    double high = unit;
    while (excess(high) > 0.0 && high < 1e12 * unit)
        high *= 10.0;
    double low = high / 10.0;
    if (high == unit)
        low = 1e-9 * unit;
    for (int i = 0; i < 40 && high / low > 1.0 + 1e-7; ++i) {
        const double middle = std::sqrt(low * high);
        (excess(middle) > 0.0 ? low : high) = middle;
    }
    return high;
}

Scaled scaledProblem(const RigGeometry& geometry, const VelocityProblem& problem, double& smallest) {
    const auto& free = geometry.freeCoordinates();
    const auto n = static_cast<Eigen::Index>(free.size());
    Scaled s;
    s.scale.resize(n);
    s.A.resize(problem.rows.rows(), n);
    s.speed = Eigen::MatrixXd::Zero(3, n);
    s.rotation = Eigen::MatrixXd::Zero(3, n);
    const Eigen::Matrix3d axes = rotationAxes(problem.coordinates);
    for (Eigen::Index k = 0; k < n; ++k) {
        const int c = free[static_cast<std::size_t>(k)];
        s.scale[k] = c < 3 ? 1.0 : problem.rotationLength_m;
        s.A.col(k) = problem.rows.col(c) / s.scale[k];
        if (c < 3)
            s.speed(c, k) = 1.0;
        else
            s.rotation.col(k) = axes.col(c - 3) / s.scale[k];
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(s.A);
    const double largest = svd.singularValues().size() > 0 ? svd.singularValues()[0] : 0.0;
    smallest = svd.singularValues().size() > 0 ? svd.singularValues().tail<1>()[0] : 0.0;
    const double mu = problem.damping * std::max(largest, 1e-12);
    s.H = s.A.transpose() * s.A + mu * mu * Eigen::MatrixXd::Identity(n, n);
    s.f = s.A.transpose() * problem.wanted;
    stepLimits(geometry, problem.coordinates, s.G, s.h);
    s.G = s.G * s.scale.cwiseInverse().asDiagonal();
    s.h /= problem.dt_s;
    return s;
}

/// Shortens a step until it keeps the clearance that the linearised rows may miss by their curvature.
void keepClear(const RigGeometry& geometry, const Vector6d& q, double dt_s, VelocitySolution& solution) {
    const double now = geometry.lowestPoint_m(q);
    const double least = std::min(now, geometry.limits().clearance_m) - 1e-9;
    for (int i = 0; i < 30 && geometry.lowestPoint_m(q + dt_s * solution.rates) < least; ++i) {
        solution.rates *= 0.7;
        solution.limited = true;
    }
}

} // namespace

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

VelocitySolution solveVelocity(const RigGeometry& geometry, const VelocityProblem& problem) {
    VelocitySolution out;
    const auto& free = geometry.freeCoordinates();
    if (free.empty())
        return out;
    const Scaled s = scaledProblem(geometry, problem, out.smallestSingularValue);
    const double maxSpeed = geometry.limits().maxSpeed_m_s * (1.0 + kRelaxed);
    const double maxRotation = geometry.limits().maxRotation_rad_s * (1.0 + kRelaxed);
    const double unit = std::max(s.H.trace(), 1e-12);

    double speedPrice = 0.0;
    const auto rotationPrice = [&](double price) {
        return priceFor(unit, [&](double w) {
            return (s.rotation * solveWithPrices(s, price, w).y).norm() - maxRotation;
        });
    };
    speedPrice = priceFor(unit, [&](double price) {
        return (s.speed * solveWithPrices(s, price, rotationPrice(price)).y).norm() - maxSpeed;
    });
    const double wPrice = rotationPrice(speedPrice);
    const BoundedSolution solution = solveWithPrices(s, speedPrice, wPrice);

    out.limited = solution.constrained || speedPrice > 0.0 || wPrice > 0.0;
    for (std::size_t k = 0; k < free.size(); ++k)
        out.rates[free[k]] = solution.y[static_cast<Eigen::Index>(k)] / s.scale[static_cast<Eigen::Index>(k)];
    keepClear(geometry, problem.coordinates, problem.dt_s, out);
    return out;
}

double travelTime_s(const RobotLimits& limits, const Vector6d& a, const Vector6d& b) {
    const Eigen::Vector3d rotation = rotationAxes(a) * (b - a).tail<3>();
    return std::max((b - a).head<3>().norm() / limits.maxSpeed_m_s,
                    rotation.norm() / limits.maxRotation_rad_s);
}

Vector6d poseOffSource(const RigGeometry& geometry, const Vector6d& q) {
    const RobotLimits& limits = geometry.limits();
    const Eigen::Vector3d n = geometry.away();
    int most = -1; // the free axis that leads away most: its end is the goal's
    for (int k = 0; k < 3; ++k)
        if (limits.free[static_cast<std::size_t>(k)] && n[k] != 0.0 &&
            (most < 0 || std::abs(n[k]) > std::abs(n[most])))
            most = k;
    Vector6d goal = q;
    if (most < 0)
        return goal;
    const double end = n[most] > 0.0 ? limits.upper[most] : limits.lower[most];
    const double way = (end - q[most]) / n[most];
    for (int k = 0; k < 3; ++k)
        if (limits.free[static_cast<std::size_t>(k)] && n[k] != 0.0)
            goal[k] = std::clamp(q[k] + way * n[k], limits.lower[k], limits.upper[k]);
    goal[most] = end;
    return goal;
}

VelocitySolution velocityTowards(const RigGeometry& geometry, const Vector6d& q, const Vector6d& goal,
                                 double dt_s) {
    VelocitySolution out;
    const double time_s = travelTime_s(geometry.limits(), q, goal);
    if (time_s <= 0.0)
        return out;
    const Vector6d straight = (goal - q) / std::max(time_s, dt_s);
    out.limited = time_s > dt_s;
    if (geometry.allowed(q + dt_s * straight)) {
        out.rates = straight;
        return out;
    }
    // Something is in the way: the nearest velocity that the limits allow slides along it.
    VelocityProblem problem;
    constexpr double kRotationLength_m = 0.1;
    problem.rows =
        Vector6d(1.0, 1.0, 1.0, kRotationLength_m, kRotationLength_m, kRotationLength_m).asDiagonal();
    problem.wanted = problem.rows * straight;
    problem.coordinates = q;
    problem.dt_s = dt_s;
    problem.rotationLength_m = kRotationLength_m;
    problem.damping = 1e-6;
    out = solveVelocity(geometry, problem);
    const bool stuck = (problem.rows * out.rates).norm() < 0.05 * problem.wanted.norm();
    const Eigen::Vector3d off = (poseOffSource(geometry, q) - q).head<3>();
    if (stuck && off.norm() > 0.0) { // away from the source is always open
        out.rates.setZero();
        out.rates.head<3>() =
            std::min(geometry.limits().maxSpeed_m_s, off.norm() / dt_s) * (off / off.norm());
    }
    out.limited = true;
    return out;
}

} // namespace bask
