#pragma once
// Source, objects on the end-effector and the robot's limits as one geometry: view factors and clearances at
// a pose.

#include "engine/control/robot_limits.h"
#include "engine/radiation/interaction_matrix.h"
#include "engine/radiation/neighbours.h"
#include "engine/thermal/source_emission.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// To compare angles with lengths: a radian counts as 0.1 m.
inline constexpr double kRotationLength_m = 0.1;

/// How well the shade of objects on one another is known: exactly or, for tables, plans and searches, to
/// about a hundredth of it in a tenth of the time. Without shade both are the same.
enum class Shade { Exact, Rough };

/// View factors of all objects, with what the neighbours reflect (see Neighbours), and their derivatives by
/// the six pose coordinates (1/m, 1/rad).
struct ViewFactors {
    Eigen::VectorXd F;                           ///< N
    Eigen::Matrix<double, Eigen::Dynamic, 6> dF; ///< N x 6
};

/// Height of the lowest contour point of an object or fixture over the floor of the rig, with its derivative
/// by the pose coordinates.
struct Clearance {
    double height_m = 0.0;
    Vector6d gradient = Vector6d::Zero();
};

/// Immutable; calls are thread-safe. All poses q, and the workspace, are the end-effector's coordinates in
/// the robot's base R; the source is at X_RS. The floor, over which heights are measured, is the source's
/// plane or, parallel to it, the highest point of any shield: what is held above all shields hits none.
class RigGeometry {
public:
    /// `mountings` are X_EO as pose coordinates, one for each shape; `fronts` are the objects' materials: if
    /// empty, objects exchange nothing with one another. `screens` shade them. Throws std::invalid_argument
    /// if the lengths differ.
    RigGeometry(const Shape& source, const std::vector<Shape>& shapes, const std::vector<Vector6d>& mountings,
                const RobotLimits& limits, const Pose& X_RS = Pose::Identity(),
                const std::vector<FaceMaterial>& fronts = {}, const Screens& screens = {});

    /// Returns the same rig with its source at another pose. Shares the contours: cheap enough for every
    /// sample.
    std::shared_ptr<const RigGeometry> withSourceAt(const Pose& X_RS) const;
    /// Returns the same rig with an uneven source, at a temperature: `terms` are those of the emission, in S.
    /// Throws std::invalid_argument unless there is one emission for each of at least one term.
    std::shared_ptr<const RigGeometry> withSource(std::vector<SourceTerm> terms, SourceEmission emission,
                                                  double source_K) const;
    /// Returns the same rig with its source at another temperature, K: only the factors of an uneven one
    /// differ.
    std::shared_ptr<const RigGeometry> withSourceTemperature(double source_K) const;
    bool isSourceEven() const { return m_emission.isEven(); }
    /// Returns the temperature that an uneven source's factors are for, K.
    double source_K() const { return m_source_K; }
    /// Returns a bound of all view factors: 1, and more for a source with parts hotter than itself.
    double maxViewFactor() const { return m_maxViewFactor; }
    const Pose& X_RS() const { return m_X_RS; }
    /// Returns the source's normal in R: the direction away from its plane.
    Eigen::Vector3d away() const { return m_X_RS.linear().col(2); }

    int objects() const { return static_cast<int>(m_mounted.size()); }
    /// Returns the limits as given, but with a clearance of at least 0.1 mm.
    const RobotLimits& limits() const { return m_limits; }
    const std::vector<int>& freeCoordinates() const { return m_free; }

    /// With Shade::Rough, those of objects that are not `wanted` may be zero; empty: all are wanted.
    ViewFactors viewFactors(const Vector6d& q, Shade shade = Shade::Exact,
                            const std::vector<bool>& wanted = {}) const;
    /// Returns only the values, to 1e-6; those of objects that are not `wanted` may be zero; empty: all are
    /// wanted.
    Eigen::VectorXd viewFactorsFast(const Vector6d& q, const std::vector<bool>& wanted = {}) const;
    /// Returns only the values, with Shade::Rough.
    Eigen::VectorXd roughViewFactors(const Vector6d& q) const;
    /// Writes the values without shade into `F` (N), which is not allocated again; to 1e-6.
    void unshadedViewFactors(const Vector6d& q, Eigen::VectorXd& F) const;
    /// Returns whether an object may be shaded at some pose.
    bool mayShade() const { return m_mounted.mayShade(); }
    /// Returns the share of the view factors `unshaded` (N) that the others leave to each object, with
    /// Shade::Rough.
    Eigen::VectorXd roughShares(const Vector6d& q, const Eigen::VectorXd& unshaded) const;
    /// Returns what each object, fixture and shield takes of whose light: see MountedObjects::takenLight.
    std::vector<TakenLight> takenLight(const Vector6d& q) const;
    /// Returns the height of the floor over the source's plane, m; 0 without shields.
    double floor_m() const { return m_floor_m; }
    /// Returns the clearance of the lowest point of each object, then of each fixture.
    std::vector<Clearance> clearances(const Vector6d& q) const { return clearances(q, q); }
    /// Returns at pose q the clearance of the point of each object, then of each fixture, that is the lowest
    /// one at pose `lowestAt`.
    std::vector<Clearance> clearances(const Vector6d& q, const Vector6d& lowestAt) const;
    /// Returns the height over the floor of the lowest point of all objects and fixtures, m.
    double lowestPoint_m(const Vector6d& q) const;
    /// Returns whether the pose is inside the workspace and keeps the clearance from the floor, within 1e-9.
    bool allowed(const Vector6d& q) const;
    /// Returns whether a step to `to` is allowed under these limits. A limit that is already violated at
    /// `from` only forbids to go farther out.
    bool mayStep(const Vector6d& from, const Vector6d& to, const RobotLimits& limits) const;
    /// Returns what the objects exchange with one another.
    const Neighbours& neighbours() const { return m_neighbours; }

private:
    Pose X_SE(const Vector6d& q) const;
    /// Writes the values without shade and reflections into `F` (N).
    void directViewFactors(const Pose& X_SE, Eigen::VectorXd& F) const;

    RadiatingSource m_source;
    SourceEmission m_emission; ///< of an uneven source
    double m_source_K = 0.0;
    double m_maxViewFactor = 1.0;
    RobotLimits m_limits;
    std::vector<int> m_free;
    MountedObjects m_mounted;
    Neighbours m_neighbours;
    std::vector<std::vector<Eigen::Vector3d>> m_outlines_E; ///< contour points in E, of objects and fixtures
    Pose m_X_RS;
    std::optional<Pose> m_X_SR; ///< empty if R and S are the same
    double m_floor_m = 0.0;
};

} // namespace bask
