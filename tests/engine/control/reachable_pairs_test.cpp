// Maps of reachable pairs of temperatures against a fine grid of poses.

#include "engine/control/reachable_pairs.h"

#include "engine/base/units.h"
#include "engine/control/steady_search.h"
#include "tests/engine/control/two_disks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace bask {
namespace {

FeasibilityRequest twoDisksAt(double first_degC, double second_degC) {
    const double room_K = kelvinFromCelsius(25.0);
    FeasibilityRequest request;
    request.geometry = std::make_shared<RigGeometry>(twoDisks(RobotLimits{}));
    request.rest[kZ] = 0.12;
    request.names = {"left", "right"};
    request.rates.assign(
        2, heatRates({}, surroundingsOf(SourceModel::Gray, kelvinFromCelsius(200.0), 0.25, room_K)));
    request.targets_K = {kelvinFromCelsius(first_degC), kelvinFromCelsius(second_degC)};
    return request;
}

ReachableMap mapOf(const FeasibilityRequest& request) {
    return reachablePairs(request).value().at(0);
}

// Catches: holes for want of samples, cells that no pose reaches, a density that loses poses: of 300,000
// poses each lies in a reachable cell (but for such as only touch one), and the map is no wider than they.
TEST(ReachablePairs, AgreeWithAFineGrid) {
    const FeasibilityRequest request = twoDisksAt(45.0, 45.0);
    const ReachableMap map = mapOf(request);
    EXPECT_NEAR(std::accumulate(map.density.begin(), map.density.end(), 0.0), 1.0, 1e-9);
    const SteadySearch fine(request.geometry,
                            std::make_shared<PoseLookup>(request.geometry, request.rest, 300000),
                            request.rates);
    const auto cells = static_cast<std::size_t>(map.cells);
    std::vector<bool> visited(cells * cells);
    int outside = 0;
    for (Eigen::Index k = 0; k < fine.table_K().rows(); ++k) {
        const Eigen::Vector2d pair_K(fine.table_K()(k, 0), fine.table_K()(k, 1));
        const Eigen::Vector2d place = (pair_K - map.lower_K).cwiseQuotient(map.cell_K());
        const auto cell = static_cast<std::size_t>(place.y()) * cells + static_cast<std::size_t>(place.x());
        visited[cell] = true;
        outside += map.reachable[cell] ? 0 : 1;
    }
    EXPECT_LT(outside, fine.table_K().rows() / 1000);
    int reachable = 0, unvisited = 0;
    for (std::size_t k = 0; k < cells * cells; ++k) {
        reachable += map.reachable[k] ? 1 : 0;
        unvisited += map.reachable[k] && !visited[k] ? 1 : 0;
    }
    EXPECT_GT(reachable, 300);
    EXPECT_LT(unvisited, reachable / 20); // where even 300,000 poses leave gaps
}

// Catches: a distance that is not the one to the set: outside it is what the joint search misses by, inside
// a target farther from the boundary has more.
TEST(ReachablePairs, TellHowFarATargetIsFromTheBoundary) {
    const FeasibilityRequest apart = twoDisksAt(94.9, 94.9);
    const ReachableMap outside = mapOf(apart);
    EXPECT_FALSE(outside.targetReachable);
    const JointVerdict verdict = jointFeasibility(apart).value();
    EXPECT_NEAR(outside.distance_K, std::hypot(verdict.residuals_K[0], verdict.residuals_K[1]), 0.01);
    const ReachableMap middle = mapOf(twoDisksAt(50.0, 50.0));
    EXPECT_TRUE(middle.targetReachable);
    const ReachableMap edge = mapOf(twoDisksAt(75.0, 50.0));
    EXPECT_TRUE(edge.targetReachable);
    EXPECT_LT(edge.distance_K, middle.distance_K);
    EXPECT_GT(middle.distance_K, 3.0);
}

// Catches: a target that was moved and is told about as before, or otherwise than by maps made anew.
TEST(ReachablePairs, PlacedTargetsAreAsInMapsMadeForThem) {
    const auto maps = reachablePairs(twoDisksAt(45.0, 45.0)).value();
    for (const auto& [first_degC, second_degC] : {std::pair(94.9, 94.9), std::pair(75.0, 50.0)}) {
        const FeasibilityRequest moved = twoDisksAt(first_degC, second_degC);
        const ReachableMap placed = placeTargets(maps, moved).value().at(0);
        const ReachableMap made = mapOf(moved);
        EXPECT_EQ(placed.target_K, made.target_K);
        EXPECT_EQ(placed.nearest_K, made.nearest_K);
        EXPECT_EQ(placed.targetReachable, made.targetReachable);
        EXPECT_EQ(placed.distance_K, made.distance_K);
        EXPECT_EQ(placed.density, made.density);
        EXPECT_NEAR((placed.nearest_K - placed.target_K).norm(),
                    placed.targetReachable ? 0.0 : placed.distance_K, kReachedWithin_K);
    }
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(placeTargets(maps, twoDisksAt(45.0, 45.0), stop.get_token()));
}

// Catches: a boundary with ends in the air: each corner of it belongs to an even number of edges.
TEST(ReachablePairs, TheBoundaryIsClosed) {
    const ReachableMap map = mapOf(twoDisksAt(45.0, 45.0));
    std::vector<int> edges(static_cast<std::size_t>((map.cells + 1) * (map.cells + 1)));
    for (const auto& edge : map.boundary)
        for (const Eigen::Vector2d& end_K : edge) {
            const Eigen::Vector2d place = (end_K - map.lower_K).cwiseQuotient(map.cell_K());
            ++edges[static_cast<std::size_t>(std::lround(place.y()) * (map.cells + 1) +
                                             std::lround(place.x()))];
        }
    EXPECT_FALSE(map.boundary.empty());
    for (const int count : edges)
        EXPECT_EQ(count % 2, 0);
}

// Catches: pairs forgotten, and a job that does not end.
TEST(ReachablePairs, OneMapAPairUntilStopped) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(reachablePairs(twoDisksAt(45.0, 45.0), stop.get_token()));
    EXPECT_EQ(reachablePairs(twoDisksAt(45.0, 45.0))->size(), 1U);
}

// Catches a read beyond the end when a search is stopped between its question and its first pose.
TEST(ReachablePairs, AStoppedSearchStillHasTemperatures) {
    std::stop_source stop;
    stop.request_stop();
    const FeasibilityRequest request = twoDisksAt(45.0, 45.0);
    const SteadySearch search(request.geometry, feasibilityLookup(request.geometry, request.rest),
                              request.rates, stop.get_token());
    const SteadyAim aim{Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(310.0, 310.0)};
    EXPECT_EQ(search.best(aim, 48, 1e-6).T_K.size(), 2);
}

} // namespace
} // namespace bask
