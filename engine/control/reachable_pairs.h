#pragma once
// Which pairs of steady temperatures two objects can have together, as a map with density and boundary.

#include "engine/control/joint_feasibility.h"

#include <array>

namespace bask {

/// A grid of cells over the temperatures of two objects that the workspace offers, seen from one target.
struct ReachableMap {
    int first = 0; ///< objects; `first` along the map's x
    int second = 0;
    int cells = 0;                     ///< along each side
    Eigen::Vector2d lower_K{0.0, 0.0}; ///< outer edges of the map: (first, second)
    Eigen::Vector2d upper_K{0.0, 0.0};
    /// cells x cells, row by row from lower_K, x fastest. Share of the sampled poses whose temperatures lie
    /// in the cell; where it is small, the pair asks for a pose that is hard to keep.
    std::vector<double> density;
    std::vector<bool> reachable; ///< some pose of the workspace comes into the cell
    /// Edges between reachable and other cells, their ends in K: the boundary to the size of a cell.
    std::vector<std::array<Eigen::Vector2d, 2>> boundary;
    Eigen::Vector2d target_K{0.0, 0.0};
    bool targetReachable = false;        ///< for these two, whatever becomes of the other objects
    Eigen::Vector2d nearest_K{0.0, 0.0}; ///< the pair that some pose holds nearest to the target
    /// Outside: to that nearest pair, K. Inside: to the boundary of the cells.
    double distance_K = 0.0;

    Eigen::Vector2d cell_K() const { return (upper_K - lower_K) / cells; }
};

inline constexpr int kReachableCells = 48;

/// Maps of all pairs, first < second, in lexical order. From each cell with a sample the search goes on to
/// its neighbours without one until none is added: the map has no holes for want of samples. Some 50 ms a
/// pair: a job. Empty when stopped. No maps where no pose is allowed.
std::optional<std::vector<ReachableMap>> reachablePairs(const FeasibilityRequest& request,
                                                        std::stop_token stop = {});

/// The same maps seen from the request's targets, where nothing else of it changed: 0.4 to 2.5 ms a pair.
/// Empty when stopped.
std::optional<std::vector<ReachableMap>>
placeTargets(std::vector<ReachableMap> maps, const FeasibilityRequest& request, std::stop_token stop = {});

} // namespace bask
