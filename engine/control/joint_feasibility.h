#pragma once
// The exact check: whether a pose of the workspace has all targets as its steady temperatures; if not, why,
// and which feasible targets are nearest.

#include "engine/base/message.h"
#include "engine/control/feasibility.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

/// The request. All vectors have one entry for each object.
struct FeasibilityRequest {
    std::shared_ptr<const RigGeometry> geometry; ///< 1 to 6 objects, any free coordinates, any X_RS
    Vector6d rest = Vector6d::Zero();            ///< gives the fixed coordinates
    std::vector<std::string> names;              ///< for the sentence with the reason
    std::vector<HeatRates> rates;                ///< at the source's set temperature
    bool isAirKnown = false;                     ///< whether the rates hold what the air takes
    std::vector<double> targets_K;
    std::vector<bool> fixed; ///< targets that the nearest feasible ones must keep; empty: none
    /// The look-up of the same geometry and rest (made by feasibilityLookup()), so that it is not sampled
    /// again for every edit of a target; if empty, it is made here.
    std::shared_ptr<const PoseLookup> lookup;
};

/// The distance of a pose from the nearest limit.
struct PoseMargin {
    /// Distance to the nearest bound of the workspace or the clearance, m; a radian counts as 10 cm.
    double distance_m = 0.0;
    Limit limit = Limit::Workspace; ///< the nearest limit: Workspace or Clearance
    int coordinate = 0;             ///< of Limit::Workspace
    /// Smallest change of the steady temperatures (norm) for a move that affects them, K/m, a radian counting
    /// as 10 cm: the smallest singular value of their derivatives by the free coordinates. 0 if some targets
    /// cannot be changed independently there.
    double smallestSingularValue_K_m = 0.0;
};

/// The result.
struct JointVerdict {
    bool feasible = false; ///< whether the root mean square of residuals_K is within kReachedWithin_K
    /// False if no sampled pose is within workspace and clearance; the rest is then empty.
    bool anyPose = true;
    Vector6d pose = Vector6d::Zero(); ///< in R: the solution, or the best compromise (least squares in K)
    std::vector<double> steady_K;     ///< steady temperatures at that pose
    std::vector<double> residuals_K;  ///< steady_K - targets
    PoseMargin margin;                ///< of the pose
    /// Nearest feasible targets, least squares in K, with the requested ones kept; the targets themselves if
    /// feasible.
    std::vector<double> nearest_K;
    Vector6d nearestPose = Vector6d::Zero();
    /// False if the targets to keep cannot be reached together; nearest_K then misses them too.
    bool fixedKept = true;
    std::vector<TargetVerdict> conditions1;
    std::vector<PairVerdict> conditions2;
    /// Distance by which the objects' target surfaces miss one another in end-effector space, m: one point on
    /// each surface, around the best compromise, at its angles and within the workspace; the largest distance
    /// between two of them. Empty if the targets are feasible, if a target has no surface near the
    /// compromise, or if no free axis moves the end-effector along a line.
    std::optional<double> surfaceGap_m;
    std::vector<Eigen::Vector3d> surfacePoints; ///< those points (E's origin in R), one for each object
    Message reason;                             ///< why the targets are not feasible; None if they are
    Message caveat; ///< what the verdict does not count; None if nothing is known to be missing
};

/// Checks the targets. Takes about 50 to 100 ms without a given look-up, with shade about 0.2 s and as long
/// for the look-up: run it as a job. The same request has the same result. Every pose of the result is within
/// workspace and clearance, and its temperatures were computed there. Therefore the verdict feasible is
/// certain; the verdict not feasible is based on a sampled workspace and local searches from its best poses.
/// Empty if stopped. Throws std::invalid_argument if the vectors have different lengths.
std::optional<JointVerdict> jointFeasibility(const FeasibilityRequest& request, std::stop_token stop = {});

} // namespace bask
