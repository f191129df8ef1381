#pragma once
// Which pairs of steady temperatures two objects can have together, as a map with density and boundary.

#include "engine/control/joint_feasibility.h"

#include <array>

namespace bask {

/// A grid of cells over the steady temperatures of two objects within the workspace, and its relation to one
/// target.
struct ReachableMap {
    int first = 0; ///< objects; `first` along the map's x
    int second = 0;
    int cells = 0;                     ///< along each side
    Eigen::Vector2d lower_K{0.0, 0.0}; ///< outer edges of the map: (first, second)
    Eigen::Vector2d upper_K{0.0, 0.0};
    /// cells x cells, row by row from lower_K, x fastest: fraction of the sampled poses whose temperatures
    /// are in the cell. If it is small, the pair needs a pose that is difficult to keep.
    std::vector<double> density;
    std::vector<bool> reachable; ///< whether a pose of the workspace reaches the cell
    /// Edges between reachable and other cells, with their ends in K: the boundary to the size of a cell.
    std::vector<std::array<Eigen::Vector2d, 2>> boundary;
    Eigen::Vector2d target_K{0.0, 0.0};
    bool targetReachable = false;        ///< for these two objects, regardless of the others
    Eigen::Vector2d nearest_K{0.0, 0.0}; ///< the pair of steady temperatures nearest to the target
    /// If unreachable: distance to that nearest pair, K. If reachable: distance to the boundary of the cells.
    double distance_K = 0.0;

    Eigen::Vector2d cell_K() const { return (upper_K - lower_K) / cells; }
};

inline constexpr int kReachableCells = 48;

/// Returns maps of all pairs, first < second, in lexical order. From each cell with a sample the search
/// continues into neighbours without one until none is added, so that too few samples leave no holes in the
/// map. About 50 ms for each pair: run it as a job. Empty if stopped. No maps if no pose is allowed.
std::optional<std::vector<ReachableMap>> reachablePairs(const FeasibilityRequest& request,
                                                        std::stop_token stop = {});

/// Updates the maps for the request's targets, if nothing else of the request changed: 0.4 to 2.5 ms for each
/// pair. Empty if stopped.
std::optional<std::vector<ReachableMap>>
placeTargets(std::vector<ReachableMap> maps, const FeasibilityRequest& request, std::stop_token stop = {});

} // namespace bask
