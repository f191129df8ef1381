#include "engine/control/reachable_pairs.h"

#include "engine/control/steady_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

SteadySearch searchFor(const FeasibilityRequest& request, std::stop_token stop) {
    const auto lookup = request.lookup ? request.lookup : feasibilityLookup(request.geometry, request.rest);
    return SteadySearch(request.geometry, lookup, request.rates, std::move(stop));
}

/// The condition that the two objects of the map have these temperatures.
SteadyAim aimAt(const SteadySearch& search, const ReachableMap& map, const Eigen::Vector2d& pair_K) {
    SteadyAim aim{Eigen::MatrixXd::Zero(2, search.geometry().objects()), pair_K};
    aim.rows(0, map.first) = 1.0;
    aim.rows(1, map.second) = 1.0;
    return aim;
}

double toBoundary_K(const ReachableMap& map) {
    double min_K = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : map.boundary) {
        const Eigen::Vector2d onEdge_K = map.target_K.cwiseMax(a).cwiseMin(b); // edges lie along axes
        min_K = std::min(min_K, (onEdge_K - map.target_K).norm());
    }
    return min_K;
}

void placeTarget(ReachableMap& map, const SteadySearch& search, const std::vector<double>& targets_K) {
    constexpr int kStarts = 48;
    map.target_K = {targets_K[static_cast<std::size_t>(map.first)],
                    targets_K[static_cast<std::size_t>(map.second)]};
    const SteadyPose found = search.best(aimAt(search, map, map.target_K), kStarts, 1e-6);
    map.nearest_K = {found.T_K[map.first], found.T_K[map.second]};
    map.targetReachable = found.cost_K2 <= 2.0 * kReachedWithin_K * kReachedWithin_K;
    map.distance_K = map.targetReachable ? toBoundary_K(map) : std::sqrt(found.cost_K2);
}

/// A map that is being computed.
class Mapping {
public:
    Mapping(const SteadySearch& search, int first, int second) : m_search(search) {
        m_map.first = first;
        m_map.second = second;
        m_map.cells = kReachableCells;
    }

    ReachableMap made() {
        frame();
        count();
        grow();
        outline();
        return std::move(m_map);
    }

private:
    static constexpr int kSide = kReachableCells;

    static std::size_t index(int x, int y) { return static_cast<std::size_t>(y * kSide + x); }
    bool reached(int x, int y) const {
        return x >= 0 && y >= 0 && x < kSide && y < kSide && m_map.reachable[index(x, y)];
    }
    Eigen::Vector2d corner_K(int x, int y) const {
        return m_map.lower_K + m_map.cell_K().cwiseProduct(Eigen::Vector2d(x, y));
    }

    /// The range of the samples, and two cells more on each side for what lies between and beyond them.
    void frame() {
        for (int axis = 0; axis < 2; ++axis) {
            const auto T_K = m_search.table_K().col(axis == 0 ? m_map.first : m_map.second);
            const double min_K = T_K.minCoeff(), largest_K = T_K.maxCoeff();
            const double cell_K = std::max(largest_K - min_K, 0.1) / (kSide - 4);
            m_map.lower_K[axis] = min_K - 2.0 * cell_K;
            m_map.upper_K[axis] = m_map.lower_K[axis] + kSide * cell_K;
        }
    }

    void count() {
        m_map.density.assign(static_cast<std::size_t>(kSide * kSide), 0.0);
        m_poses.resize(m_map.density.size());
        const auto& table_K = m_search.table_K();
        const Eigen::Vector2d cell_K = m_map.cell_K();
        for (Eigen::Index k = 0; k < table_K.rows(); ++k) {
            const Eigen::Vector2d pair_K(table_K(k, m_map.first), table_K(k, m_map.second));
            const Eigen::Vector2d place = (pair_K - m_map.lower_K).cwiseQuotient(cell_K);
            const std::size_t cell = index(static_cast<int>(place.x()), static_cast<int>(place.y()));
            m_map.density[cell] += 1.0 / static_cast<double>(table_K.rows());
            m_poses[cell] = m_search.sample(k);
        }
        for (const double share : m_map.density)
            m_map.reachable.push_back(share > 0.0);
    }

    /// Starts from a pose in a neighbouring cell: does a pose exist in this cell, as near to its centre as
    /// possible?
    bool reach(int x, int y, const Vector6d& from) {
        const Eigen::Vector2d half_K = 0.5 * m_map.cell_K();
        const Eigen::Vector2d centre_K = corner_K(x, y) + half_K;
        const SteadyPose found = m_search.refine(aimAt(m_search, m_map, centre_K), from, Shade::Rough);
        const Eigen::Vector2d missed_K =
            Eigen::Vector2d(found.T_K[m_map.first], found.T_K[m_map.second]) - centre_K;
        if ((missed_K.cwiseAbs() - half_K).maxCoeff() > 0.0)
            return false;
        m_map.reachable[index(x, y)] = true;
        m_poses[index(x, y)] = found.q;
        return true;
    }

    /// Extends each reachable cell to its neighbours until nothing is added.
    void grow() {
        std::vector<std::pair<int, int>> edge;
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                if (reached(x, y))
                    edge.emplace_back(x, y);
        while (!edge.empty() && !m_search.stopped()) {
            const auto [x, y] = edge.back();
            edge.pop_back();
            for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
                const int nx = x + dx, ny = y + dy;
                const bool within = nx >= 0 && ny >= 0 && nx < kSide && ny < kSide;
                if (within && !reached(nx, ny) && reach(nx, ny, m_poses[index(x, y)]))
                    edge.emplace_back(nx, ny);
            }
        }
    }

    void outline() {
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                if (!reached(x, y))
                    continue;
                if (!reached(x - 1, y))
                    m_map.boundary.push_back({corner_K(x, y), corner_K(x, y + 1)});
                if (!reached(x + 1, y))
                    m_map.boundary.push_back({corner_K(x + 1, y), corner_K(x + 1, y + 1)});
                if (!reached(x, y - 1))
                    m_map.boundary.push_back({corner_K(x, y), corner_K(x + 1, y)});
                if (!reached(x, y + 1))
                    m_map.boundary.push_back({corner_K(x, y + 1), corner_K(x + 1, y + 1)});
            }
    }

    const SteadySearch& m_search;
    ReachableMap m_map;
    std::vector<Vector6d> m_poses; ///< one in each reachable cell
};

} // namespace

std::optional<std::vector<ReachableMap>> reachablePairs(const FeasibilityRequest& request,
                                                        std::stop_token stop) {
    const SteadySearch search = searchFor(request, std::move(stop));
    std::vector<ReachableMap> maps;
    const int N = search.empty() ? 0 : request.geometry->objects();
    for (int i = 0; i < N; ++i)
        for (int j = i + 1; j < N && !search.stopped(); ++j) {
            maps.push_back(Mapping(search, i, j).made());
            placeTarget(maps.back(), search, request.targets_K);
        }
    if (search.stopped())
        return std::nullopt;
    return maps;
}

std::optional<std::vector<ReachableMap>>
placeTargets(std::vector<ReachableMap> maps, const FeasibilityRequest& request, std::stop_token stop) {
    const SteadySearch search = searchFor(request, std::move(stop));
    for (ReachableMap& map : maps)
        if (!search.stopped())
            placeTarget(map, search, request.targets_K);
    if (search.stopped())
        return std::nullopt;
    return maps;
}

} // namespace bask
