#pragma once
// Source, objects on the end-effector and the robot's limits as one geometry: view factors and clearances at
// a pose.

#include "engine/control/robot_limits.h"
#include "engine/radiation/interaction_matrix.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// By which angles are compared with lengths: a radian counts as 0.1 m.
inline constexpr double kRotationLength_m = 0.1;

/// View factors of all objects and their derivatives by the six pose coordinates (1/m, 1/rad).
struct ViewFactors {
    Eigen::VectorXd F;                           ///< N
    Eigen::Matrix<double, Eigen::Dynamic, 6> dF; ///< N x 6
};

/// Height of an object's lowest contour point over the source plane, with its derivative by the pose
/// coordinates.
struct Clearance {
    double height_m = 0.0;
    Vector6d gradient = Vector6d::Zero();
};

/// Immutable; calls are thread-safe. All poses q are the end-effector's coordinates in the robot's base R,
/// and so is the workspace; the source lies at X_RS.
class RigGeometry {
public:
    /// `mountings` are X_EO as pose coordinates, one a shape. Throws std::invalid_argument on different
    /// lengths.
    RigGeometry(const Shape& source, const std::vector<Shape>& shapes, const std::vector<Vector6d>& mountings,
                const RobotLimits& limits, const Pose& X_RS = Pose::Identity());

    /// The same rig with its source elsewhere. Shares the contours: cheap enough for every sample.
    std::shared_ptr<const RigGeometry> withSourceAt(const Pose& X_RS) const;
    const Pose& X_RS() const { return m_X_RS; }
    /// The source's normal in R: the way off its plane.
    Eigen::Vector3d away() const { return m_X_RS.linear().col(2); }

    int objects() const { return static_cast<int>(m_mounted.size()); }
    /// As given, with a clearance of 0.1 mm at least.
    const RobotLimits& limits() const { return m_limits; }
    const std::vector<int>& freeCoordinates() const { return m_free; }

    ViewFactors viewFactors(const Vector6d& q) const;
    /// Values only, to 1e-6: for tables.
    Eigen::VectorXd viewFactorsFast(const Vector6d& q) const;
    /// The same into `F` (N), which is not allocated anew.
    void viewFactorsFast(const Vector6d& q, Eigen::VectorXd& F) const;
    /// Lowest point of each object.
    std::vector<Clearance> clearances(const Vector6d& q) const;
    /// Least clearance of all objects, m.
    double lowestPoint_m(const Vector6d& q) const;
    /// Inside the workspace and at least the clearance from the source plane, within 1e-9.
    bool allowed(const Vector6d& q) const;
    /// As allowed(to) under these limits, but for what is outside at `from` already: there the step only may
    /// not lead farther out.
    bool mayStep(const Vector6d& from, const Vector6d& to, const RobotLimits& limits) const;

private:
    Pose X_SE(const Vector6d& q) const;

    RadiatingContour m_source;
    RobotLimits m_limits;
    std::vector<int> m_free;
    std::vector<MountedContour> m_mounted;
    std::vector<std::vector<Eigen::Vector3d>> m_outlines_E; ///< contour points in E
    Pose m_X_RS;
    std::optional<Pose> m_X_SR; ///< empty where R and S are one
};

} // namespace bask
