#include "engine/control/pose_lookup.h"

#include "engine/control/bounded_least_squares.h"
#include "engine/control/travel_time.h"
#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace bask {
namespace {

/// Samples per free coordinate: x and y get the most, heights more where F changes faster, angles the fewest.
std::vector<int> samplesPerCoordinate(const std::vector<int>& free, int samples) {
    constexpr std::array<double, 6> kShare{1.6, 1.6, 1.0, 0.55, 0.55, 0.55};
    double product = 1.0;
    for (const int k : free)
        product *= kShare[static_cast<std::size_t>(k)];
    const double unit =
        std::pow(samples / product, 1.0 / static_cast<double>(std::max<std::size_t>(free.size(), 1)));
    std::vector<int> counts;
    for (const int k : free)
        counts.push_back(
            std::clamp(static_cast<int>(std::lround(unit * kShare[static_cast<std::size_t>(k)])), 3, 401));
    return counts;
}

/// Heights are denser near the source, where the view factor changes fastest.
double coordinateAt(int coordinate, double fraction, double lower, double upper) {
    const double bent = coordinate == kZ ? std::pow(fraction, 1.5) : fraction;
    return lower + bent * (upper - lower);
}

/// Weight of a second of travel in the look-up, relative to weighted squared errors of F: prefers the nearer
/// of equally good poses.
constexpr double kTravelPrice = 5e-5;

} // namespace

PoseLookup::PoseLookup(std::shared_ptr<const RigGeometry> geometry, const Vector6d& rest, int samples)
    : m_geometry(std::move(geometry)) {
    const RobotLimits& limits = m_geometry->limits();
    const auto& free = m_geometry->freeCoordinates();
    const std::vector<int> counts = samplesPerCoordinate(free, samples);
    const int total = std::accumulate(counts.begin(), counts.end(), 1, std::multiplies<>());
    for (std::size_t k = 0; k < free.size(); ++k)
        m_cell[free[k]] = (limits.upper[free[k]] - limits.lower[free[k]]) / (counts[k] - 1);
    for (int index = 0; index < total; ++index) {
        Vector6d q = rest;
        int remainder = index;
        for (std::size_t k = 0; k < free.size(); ++k) {
            const int c = free[k];
            q[c] = coordinateAt(c, static_cast<double>(remainder % counts[k]) / (counts[k] - 1),
                                limits.lower[c], limits.upper[c]);
            remainder /= counts[k];
        }
        if (m_geometry->allowed(q))
            m_poses.push_back(q);
    }
    m_F.resize(static_cast<Eigen::Index>(m_poses.size()), m_geometry->objects());
    for (std::size_t k = 0; k < m_poses.size(); ++k)
        m_F.row(static_cast<Eigen::Index>(k)) = m_geometry->roughViewFactors(m_poses[k]).array();
}

double residualCost(const PoseQuery& query, const Eigen::VectorXd& F) {
    return query.weights.dot((F - query.wanted).cwiseAbs2());
}

std::vector<Vector6d> PoseLookup::best(const PoseQuery& query, int count) const {
    constexpr std::size_t kSome = 64; // before those in neighbouring cells are left out
    Eigen::ArrayXd misses = Eigen::ArrayXd::Zero(m_F.rows());
    for (Eigen::Index i = 0; i < m_F.cols(); ++i)
        misses += query.weights[i] * (m_F.col(i) - query.wanted[i]).square();
    const TravelTime travel(m_geometry->limits(), query.from);
    std::vector<std::pair<double, std::size_t>> cheapest; // a heap, the most expensive first
    for (std::size_t k = 0; k < m_poses.size(); ++k) {
        const double missed = misses[static_cast<Eigen::Index>(k)];
        const bool full = cheapest.size() == kSome;
        if (full && missed >= cheapest.front().first)
            continue;
        cheapest.emplace_back(missed + kTravelPrice * travel.to(m_poses[k]), k);
        std::ranges::push_heap(cheapest);
        if (full) {
            std::ranges::pop_heap(cheapest);
            cheapest.pop_back();
        }
    }
    std::ranges::sort_heap(cheapest);
    std::vector<Vector6d> out;
    for (const auto& [cost, k] : cheapest) {
        if (static_cast<int>(out.size()) == count)
            break;
        const Vector6d& q = m_poses[k];
        const bool apart = std::ranges::all_of(out, [&](const Vector6d& other) {
            return ((q - other).cwiseAbs() - 1.5 * m_cell).maxCoeff() > 0.0;
        });
        if (apart)
            out.push_back(q);
    }
    return out;
}

namespace {

/// `from`: where the price of a move is zero.
Vector6d descend(const RigGeometry& geometry, const PoseQuery& query, const Vector6d& from,
                 const Vector6d& start, int iterations) {
    const auto& free = geometry.freeCoordinates();
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::VectorXd lengths(n); // that a unit of each free coordinate counts
    for (Eigen::Index k = 0; k < n; ++k)
        lengths[k] = free[static_cast<std::size_t>(k)] < 3 ? 1.0 : kRotationLength_m;
    const auto timesSquares = [&lengths](double factor) -> Eigen::VectorXd {
        return (factor * lengths).cwiseProduct(lengths);
    };
    const Eigen::VectorXd price = timesSquares(query.movePrice_1_m2); // of the squared change
    const auto moved = [&](const Vector6d& to) {
        Eigen::VectorXd out(n);
        for (Eigen::Index k = 0; k < n; ++k)
            out[k] = to[free[static_cast<std::size_t>(k)]] - from[free[static_cast<std::size_t>(k)]];
        return out;
    };
    const auto costOf = [&](const Vector6d& at, const Eigen::VectorXd& F) {
        return residualCost(query, F) + price.dot(moved(at).cwiseAbs2());
    };
    Vector6d q = start;
    ViewFactors now = geometry.viewFactors(q, Shade::Rough);
    double cost = costOf(q, now.F);
    double damping = 1e-3;
    for (int i = 0; i < iterations; ++i) {
        Eigen::MatrixXd J(geometry.objects(), n);
        for (Eigen::Index k = 0; k < n; ++k)
            J.col(k) = now.dF.col(free[static_cast<std::size_t>(k)]);
        Eigen::MatrixXd H = J.transpose() * query.weights.asDiagonal() * J;
        const double size = std::max(H.trace(), 1e-9);
        H.diagonal() += price;
        H.diagonal() += timesSquares(damping * size);
        Eigen::MatrixXd G;
        Eigen::VectorXd h;
        stepLimits(geometry, q, G, h);
        const Eigen::VectorXd f =
            J.transpose() * query.weights.cwiseProduct(query.wanted - now.F) - price.cwiseProduct(moved(q));
        const Eigen::VectorXd y = solveBounded(H, f, G, h).y;
        Vector6d next = q;
        for (Eigen::Index k = 0; k < n; ++k)
            next[free[static_cast<std::size_t>(k)]] += y[k];
        if ((next - q).cwiseAbs().maxCoeff() < 1e-7)
            break;
        bool better = false;
        if (geometry.allowed(next)) {
            ViewFactors there = geometry.viewFactors(next, Shade::Rough);
            const double nextCost = costOf(next, there.F);
            if (nextCost < cost) {
                better = true;
                q = next;
                now = std::move(there);
                cost = nextCost;
            }
        }
        damping = better ? std::max(1e-9, damping * 0.2) : damping * 8.0;
        if (damping > 1e6)
            break;
    }
    return q;
}

} // namespace

Vector6d refinePose(const RigGeometry& geometry, const PoseQuery& query, const Vector6d& start,
                    int iterations, Shade shade) {
    Vector6d q = descend(geometry, query, start, start, iterations);
    if (shade == Shade::Exact && geometry.mayShade()) {
        // As the rough view factors miss the exact ones here, so they will at the pose that is found.
        PoseQuery shifted = query;
        shifted.wanted -= geometry.viewFactorsFast(q) - geometry.viewFactors(q, Shade::Rough).F;
        q = descend(geometry, shifted, start, q, iterations);
    }
    return q;
}

} // namespace bask
