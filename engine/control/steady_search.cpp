#include "engine/control/steady_search.h"

#include "engine/control/bounded_least_squares.h"
#include "engine/control/steady_states.h"
#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

double lengthOf(int coordinate) {
    return coordinate < 3 ? 1.0 : kRadianLength_m;
}

/// q clamped to the workspace's box, and moved along the clearance's gradient if a step along its tangent
/// went below it.
Vector6d repaired(const RigGeometry& geometry, Vector6d q) {
    constexpr int kLifts = 3;
    const RobotLimits& limits = geometry.limits();
    for (int lift = 0;; ++lift) {
        for (const int c : geometry.freeCoordinates())
            q[c] = std::clamp(q[c], limits.lower[c], limits.upper[c]);
        if (lift == kLifts || geometry.lowestPoint_m(q) >= limits.clearance_m)
            return q;
        for (const Clearance& clearance : geometry.clearances(q)) {
            const double missing_m = limits.clearance_m - clearance.height_m;
            if (missing_m <= 0.0)
                continue;
            Vector6d way = Vector6d::Zero();
            for (const int c : geometry.freeCoordinates())
                way[c] = clearance.gradient[c] / (lengthOf(c) * lengthOf(c));
            if (const double rise = way.dot(clearance.gradient); rise > 0.0)
                q += (missing_m + 1e-10) / rise * way;
        }
    }
}

constexpr double kAlmostNone = 1e-6; // gain of a step, relative

std::vector<bool> wantedBy(const SteadyAim& aim) {
    std::vector<bool> wanted;
    for (Eigen::Index i = 0; i < aim.rows.cols(); ++i)
        wanted.push_back(!aim.rows.col(i).isZero());
    return wanted;
}

/// One combination, to be as small or as large as it can be.
bool isForExtreme(const SteadyAim& aim) {
    return aim.rows.rows() == 1;
}

double costOf(const SteadyAim& aim, const Vector6d& q, const Eigen::VectorXd& residual) {
    return residual.squaredNorm() + aim.pull.cwiseAbs2().dot((q - aim.towards).cwiseAbs2());
}

} // namespace

SteadySearch::SteadySearch(std::shared_ptr<const RigGeometry> geometry,
                           std::shared_ptr<const PoseLookup> lookup, std::vector<HeatRates> rates,
                           std::stop_token stop)
    : m_geometry(std::move(geometry)), m_lookup(std::move(lookup)), m_rates(std::move(rates)),
      m_stop(std::move(stop)) {
    if (static_cast<int>(m_rates.size()) != m_geometry->objects())
        throw std::invalid_argument("SteadySearch: one rate an object");
    m_T_K = m_lookup->table();
    if (m_geometry->neighbours().exchange()) {
        for (Eigen::Index k = 0; k < m_T_K.rows(); ++k)
            m_T_K.row(k) = steadyAt_K(m_T_K.row(k).matrix().transpose()).transpose().array();
        return;
    }
    for (Eigen::Index i = 0; i < m_T_K.cols(); ++i) {
        const HeatRates& rate = m_rates[static_cast<std::size_t>(i)];
        if (rate.air.isZero())
            m_T_K.col(i) = ((rate.lambda1 * m_T_K.col(i) + rate.lambda3) / rate.lambda2).sqrt().sqrt();
        else
            m_T_K.col(i) = m_T_K.col(i).unaryExpr([&](double F) { return rate.steadyTemperature_K(F); });
    }
}

SteadySearch::Gradient SteadySearch::at(const Vector6d& q) const {
    return withTemperatures(m_geometry->viewFactors(q));
}

SteadySearch::Gradient SteadySearch::withTemperatures(ViewFactors now) const {
    Gradient out{steadyAt_K(now.F), std::move(now.dF)};
    if (m_geometry->neighbours().exchange()) {
        out.dT = steadySlopes_K(m_rates, m_geometry->neighbours(), out.T_K) * out.dT;
        return out;
    }
    for (Eigen::Index i = 0; i < now.F.size(); ++i) {
        const HeatRates& rate = m_rates[static_cast<std::size_t>(i)];
        out.dT.row(i) *= rate.lambda1 / rate.lossSlope_1_s(out.T_K[i]);
    }
    return out;
}

Eigen::VectorXd SteadySearch::steadyAt_K(const Eigen::VectorXd& F) const {
    return steadyTemperatures_K(m_rates, m_geometry->neighbours(), F.cwiseMax(0.0));
}

SteadyPose SteadySearch::refine(const SteadyAim& aim, const Vector6d& start, Shade shade) const {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(m_geometry->objects());
    const SteadyPose found = descend(aim, start, none, kAlmostNone);
    return shade == Shade::Exact && m_geometry->mayShade() ? madeExact(aim, found) : found;
}

// Space mapping (J. Bandler et al., 1994): the rough temperatures plus what they miss at the last pose are as
// good as the exact ones near it, so few exact ones are needed. Where a single combination does not get as
// far as wanted, it does not get there by what is missed either: a shift does not move its extreme.
SteadyPose SteadySearch::madeExact(const SteadyAim& aim, SteadyPose found) const {
    constexpr int kRounds = 6;
    constexpr double kSame_K = 1e-6, kShort_K = 1e-3;
    const std::vector<bool> wanted = wantedBy(aim);
    SteadyPose best = found;
    best.cost_K2 = std::numeric_limits<double>::infinity();
    Eigen::VectorXd missed_K = Eigen::VectorXd::Zero(m_geometry->objects());
    for (int round = 0; round < kRounds; ++round) {
        const Eigen::VectorXd T_K = steadyAt_K(m_geometry->viewFactorsFast(found.q, wanted));
        const Eigen::VectorXd change_K = T_K - found.T_K;
        missed_K += change_K;
        const Eigen::VectorXd roughly = aim.rows * found.T_K - aim.wanted,
                              exactly = aim.rows * T_K - aim.wanted;
        const double cost_K2 = costOf(aim, found.q, exactly);
        const bool isBetter = cost_K2 < best.cost_K2;
        const bool isExtreme =
            isForExtreme(aim) && std::abs(roughly[0]) > kShort_K && roughly[0] * exactly[0] > 0.0;
        if (isBetter)
            best = {found.q, T_K, cost_K2};
        if (!isBetter || isExtreme || stopped() || change_K.cwiseAbs().maxCoeff() < kSame_K)
            break;
        found = descend(aim, found.q, missed_K, kAlmostNone);
    }
    return best;
}

SteadyPose SteadySearch::descend(const SteadyAim& aim, const Vector6d& start, const Eigen::VectorXd& missed_K,
                                 double gain) const {
    constexpr int kIterations = 60;
    constexpr double kExact_K2 = 1e-12;
    constexpr double kTrusted = 1e-2; // damping up to which a step is about the best one
    const bool mayShade = m_geometry->mayShade();
    const auto& free = m_geometry->freeCoordinates();
    const auto n = static_cast<Eigen::Index>(free.size());
    Vector6d q = start;
    const std::vector<bool> wanted = wantedBy(aim);
    const auto lookAt = [&](const Vector6d& pose) {
        Gradient seen = withTemperatures(m_geometry->viewFactors(pose, Shade::Rough, wanted));
        seen.T_K += missed_K;
        return seen;
    };
    Gradient now = lookAt(q);
    Eigen::VectorXd residual = aim.rows * now.T_K - aim.wanted;
    const Vector6d pull2 = aim.pull.cwiseAbs2();
    double cost_K2 = costOf(aim, q, residual);
    double damping = 1e-3;
    int still = 0; // number of steps in a row without this gain
    for (int i = 0; i < kIterations && still < 3 && !stopped(); ++i) {
        if (cost_K2 < kExact_K2)
            break;
        Eigen::MatrixXd J(aim.rows.rows(), n);
        for (Eigen::Index k = 0; k < n; ++k)
            J.col(k) = aim.rows * now.dT.col(free[static_cast<std::size_t>(k)]);
        Eigen::MatrixXd H = J.transpose() * J;
        const double size = std::max(H.trace(), 1e-9);
        Eigen::VectorXd f = -J.transpose() * residual;
        for (Eigen::Index k = 0; k < n; ++k) {
            const int c = free[static_cast<std::size_t>(k)];
            H(k, k) += pull2[c] + damping * size * lengthOf(c) * lengthOf(c);
            f[k] += pull2[c] * (aim.towards[c] - q[c]);
        }
        Eigen::MatrixXd G;
        Eigen::VectorXd h;
        stepLimits(*m_geometry, q, G, h);
        const Eigen::VectorXd y = solveBounded(H, f, G, h).y;
        const double expected_K2 = y.dot(2.0 * f - H * y);
        if (mayShade && damping < kTrusted && expected_K2 < gain * cost_K2)
            break;
        Vector6d next = q;
        for (Eigen::Index k = 0; k < n; ++k)
            next[free[static_cast<std::size_t>(k)]] += y[k];
        next = repaired(*m_geometry, next);
        if ((next - q).cwiseAbs().maxCoeff() < 1e-9)
            break;
        bool better = false;
        if (m_geometry->allowed(next)) {
            Gradient there = lookAt(next);
            Eigen::VectorXd left = aim.rows * there.T_K - aim.wanted;
            if (const double after_K2 = costOf(aim, next, left); after_K2 < cost_K2) {
                better = true;
                still = after_K2 > (1.0 - gain) * cost_K2 ? still + 1 : 0;
                cost_K2 = after_K2;
                q = next;
                now = std::move(there);
                residual = std::move(left);
            }
        }
        damping = better ? std::max(1e-9, damping * 0.2) : damping * 8.0;
        if (damping > 1e6)
            break;
    }
    return {q, now.T_K, cost_K2};
}

std::vector<Vector6d> SteadySearch::startsFor(const SteadyAim& aim, int count) const {
    constexpr Eigen::Index kSome = 1024; // before those in neighbouring cells are left out
    Eigen::ArrayXd cost_K2 = Eigen::ArrayXd::Zero(m_T_K.rows());
    for (Eigen::Index k = 0; k < aim.rows.rows(); ++k) {
        Eigen::ArrayXd residual_K = Eigen::ArrayXd::Constant(m_T_K.rows(), -aim.wanted[k]);
        for (Eigen::Index i = 0; i < m_T_K.cols(); ++i)
            if (aim.rows(k, i) != 0.0)
                residual_K += aim.rows(k, i) * m_T_K.col(i);
        cost_K2 += residual_K.square();
    }
    std::vector<Eigen::Index> order(static_cast<std::size_t>(m_T_K.rows()));
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    const auto cheaper = [&](Eigen::Index a, Eigen::Index b) {
        return std::pair(cost_K2[a], a) < std::pair(cost_K2[b], b);
    };
    const auto some = order.begin() + std::min<Eigen::Index>(kSome, m_T_K.rows());
    std::ranges::partial_sort(order, some, cheaper);
    std::vector<Vector6d> out;
    for (auto k = order.begin(); k != some && static_cast<int>(out.size()) < count; ++k) {
        const Vector6d& q = sample(*k);
        const bool apart = std::ranges::all_of(out, [&](const Vector6d& other) {
            return ((q - other).cwiseAbs() - 1.5 * m_lookup->cell()).maxCoeff() > 0.0;
        });
        if (apart)
            out.push_back(q);
    }
    return out;
}

SteadyPose SteadySearch::best(const SteadyAim& aim, int starts, double enough_K2) const {
    // With shade, a first descent ends where it gains little, and a pose this much worse than the best one is
    // worth no second descent or no exact shade. An extreme stays as wrong as its rough values, so more of
    // them are made exact.
    constexpr double kFirst_K = 1.0, kRough_K = 0.1, kRoughExtreme_K = 0.5, kLittle = 0.01;
    constexpr double kNear = 3e-3, kSame = 1e-3; // m, rad
    const bool mayShade = m_geometry->mayShade();
    const double rough_K = isForExtreme(aim) ? kRoughExtreme_K : kRough_K;
    const double scale = aim.rows.cwiseAbs().maxCoeff();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(m_geometry->objects());
    std::vector<Vector6d> firstEnds, madeAlready;
    const auto isIn = [](const std::vector<Vector6d>& poses, const Vector6d& q, double apart) {
        return std::ranges::any_of(
            poses, [&](const Vector6d& other) { return (q - other).cwiseAbs().maxCoeff() < apart; });
    };
    SteadyPose best;
    best.cost_K2 = std::numeric_limits<double>::infinity();
    double bestMargin_m = 0.0;
    int tried = 0;
    for (const Vector6d& start : startsFor(aim, starts)) {
        const bool enough = tried % kBatch == 0 && best.cost_K2 <= enough_K2;
        if (tried++ > 0 && (stopped() || enough)) // a stopped search also returns temperatures
            break;
        SteadyPose found = descend(aim, start, none, mayShade ? kLittle : kAlmostNone);
        if (mayShade) {
            const auto isFar = [&](double allowed_K) {
                return std::sqrt(found.cost_K2) > std::sqrt(best.cost_K2) + allowed_K * scale;
            };
            if (isFar(kFirst_K) || isIn(firstEnds, found.q, kNear))
                continue;
            firstEnds.push_back(found.q);
            found = descend(aim, found.q, none, kAlmostNone);
            if (isFar(rough_K) || isIn(madeAlready, found.q, kSame))
                continue;
            madeAlready.push_back(found.q);
            found = madeExact(aim, std::move(found));
        }
        const double margin_m = nearestLimit(*m_geometry, found.q).distance_m;
        const bool bothEnough = std::max(found.cost_K2, best.cost_K2) <= enough_K2;
        if (bothEnough ? margin_m > bestMargin_m : found.cost_K2 < best.cost_K2) {
            best = std::move(found);
            bestMargin_m = margin_m;
        }
    }
    return best;
}

LimitDistance nearestLimit(const RigGeometry& geometry, const Vector6d& q) {
    const RobotLimits& limits = geometry.limits();
    LimitDistance out{geometry.lowestPoint_m(q) - limits.clearance_m, Limit::Clearance, 0};
    for (const int c : geometry.freeCoordinates()) {
        const double distance_m = lengthOf(c) * std::min(q[c] - limits.lower[c], limits.upper[c] - q[c]);
        if (distance_m < out.distance_m)
            out = {distance_m, Limit::Workspace, c};
    }
    out.distance_m = std::max(0.0, out.distance_m);
    return out;
}

} // namespace bask
