#pragma once
// The exact question: is there a pose of the workspace whose steady temperatures are all the targets; if not,
// why, and which targets near them there are.

#include "engine/base/message.h"
#include "engine/control/feasibility.h"

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

/// What is asked. All vectors have one entry an object.
struct FeasibilityRequest {
    std::shared_ptr<const RigGeometry> geometry; ///< 1 to 6 objects, any free coordinates, any X_RS
    Vector6d rest = Vector6d::Zero();            ///< gives the fixed coordinates
    std::vector<std::string> names;              ///< for the reason in words
    std::vector<HeatRates> rates;                ///< at the source's set temperature
    std::vector<double> targets_K;
    std::vector<bool> held; ///< targets that the nearest feasible ones keep; empty: none
    /// Of the same geometry and rest (feasibilityLookup() makes it), so that it is not sampled anew for every
    /// edit of a target; empty: made here.
    std::shared_ptr<const PoseLookup> lookup;
};

/// How far a pose is from where it stops being one.
struct PoseMargin {
    /// To the nearest bound of the workspace or the clearance, m; a radian counts as 10 cm.
    double distance_m = 0.0;
    Limit limit = Limit::Workspace; ///< which one: Workspace or Clearance
    int coordinate = 0;             ///< of Limit::Workspace
    /// Least change of the steady temperatures (norm) for a move that acts on them, K/m, a radian again as 10
    /// cm: smallest singular value of their derivatives by the free coordinates. 0: some targets cannot be
    /// changed independently there.
    double smallestSingularValue_K_m = 0.0;
};

/// The answer.
struct JointVerdict {
    bool feasible = false; ///< root mean square of residuals_K within kHeldWithin_K
    bool anyPose = true;   ///< false: no sampled pose keeps workspace and clearance; the rest is empty
    Vector6d pose = Vector6d::Zero(); ///< in R: the solution, or the best compromise (least squares in K)
    std::vector<double> steady_K;     ///< there
    std::vector<double> residuals_K;  ///< steady_K - targets
    PoseMargin margin;                ///< of the pose
    /// Nearest feasible targets, least squares in K, those of `held` as they are; the targets where feasible.
    std::vector<double> nearest_K;
    Vector6d nearestPose = Vector6d::Zero();
    bool heldKept = true; ///< false: the held ones cannot be held together; nearest_K misses them too
    std::vector<TargetVerdict> conditions1;
    std::vector<PairVerdict> conditions2;
    /// By how much the objects' target surfaces miss one another in end-effector space: around the best
    /// compromise, at its angles and within the workspace, one point on each, the largest distance between
    /// two of them, m. Empty where feasible, where a target has no surface near the compromise, or where no
    /// free axis moves the end-effector along a line.
    std::optional<double> surfaceGap_m;
    std::vector<Eigen::Vector3d> surfacePoints; ///< those points (E's origin in R), one an object
    Message reason;                             ///< the binding one; None where feasible
};

/// Takes some 50 to 100 ms without a look-up at hand: run it as a job. The same request has the same answer.
/// Every pose of the answer lies within workspace and clearance, and its temperatures were computed there: a
/// verdict of feasible is certain; one of not feasible rests on a sampled workspace and local searches from
/// its best poses. Empty when stopped. Throws std::invalid_argument on different lengths.
std::optional<JointVerdict> jointFeasibility(const FeasibilityRequest& request, std::stop_token stop = {});

} // namespace bask
