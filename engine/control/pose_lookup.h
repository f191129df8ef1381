#pragma once
// The workspace sampled once, to find the pose with given view factors. The search is global, so it has no
// local minima; the result is refined elsewhere.

#include "engine/control/rig_geometry.h"

#include <memory>
#include <vector>

namespace bask {

/// The query of the inner step of the level servo.
struct PoseQuery {
    Eigen::VectorXd wanted;           ///< N view factors
    Eigen::VectorXd weights;          ///< N, of the squared errors of F
    Vector6d from = Vector6d::Zero(); ///< present pose; fixed coordinates are taken from it
    /// Of refinePose(): added to the residual per squared metre away from its start, a radian counting as
    /// kRotationLength_m.
    double movePrice_1_m2 = 0.0;
};

/// A table of about `samples` allowed poses over the free coordinates (fixed ones as in `rest`) with the view
/// factors of all objects.
class PoseLookup {
public:
    PoseLookup(std::shared_ptr<const RigGeometry> geometry, const Vector6d& rest, int samples = 40000);

    std::size_t size() const { return m_poses.size(); }
    const Vector6d& pose(std::size_t k) const { return m_poses[k]; }
    /// Returns the mean spacing of the samples, m and rad; 0 in fixed coordinates.
    const Vector6d& cell() const { return m_cell; }
    /// Returns the view factors, size() x N.
    const Eigen::ArrayXXd& table() const { return m_F; }

    /// Returns the `count` cheapest poses, cheapest first, no two of them in neighbouring cells.
    std::vector<Vector6d> best(const PoseQuery& query, int count) const;

private:
    std::shared_ptr<const RigGeometry> m_geometry;
    std::vector<Vector6d> m_poses;
    Eigen::ArrayXXd m_F;
    Vector6d m_cell = Vector6d::Zero();
};

/// Returns the weighted sum of squared errors of F.
double residualCost(const PoseQuery& query, const Eigen::VectorXd& F);

/// Refines a pose by damped Gauss-Newton steps on the residual from `start`, with the gradient, inside
/// workspace and clearance; without shade it never returns a worse pose.
Vector6d refinePose(const RigGeometry& geometry, const PoseQuery& query, const Vector6d& start,
                    int iterations, Shade shade = Shade::Exact);

} // namespace bask
