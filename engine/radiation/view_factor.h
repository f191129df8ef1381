#pragma once
// View factor F21 from a planar object to a planar source with its exact gradient (circulation form).

#include "engine/base/pose.h"
#include "engine/base/result.h"
#include "engine/shape/shape.h"

#include <memory>

namespace bask {

/// Which part of the two faces sees the other: all, some (either cut bites), none (F = 0).
enum class Visibility { Full, Partial, Hidden };
const char* visibilityName(Visibility visibility); ///< "full", "partial", "hidden"

/// A view factor with what it took.
struct ViewFactor {
    double value = 0.0; ///< F21, in [0, 1]
    /// dF/d(position) 1/m and dF/d(rotation) 1/rad, S axes, about O's origin.
    Vector6d gradient = Vector6d::Zero();
    Visibility visibility = Visibility::Hidden;
    double errorEstimate = 0.0; ///< of `value`, absolute, at most 1
};

struct ViewFactorOptions {
    double tolerance = 1e-9; ///< absolute, of the value; it decides the number of points
    /// Of an outline of the object's over one of the source's; beyond it the estimate tells what was reached.
    int maxPoints = 1 << 17;
};

/// A shape, of an object or of a source, prepared for many evaluations: area and tabulated points of its
/// outline and holes, shared by copies. Immutable.
class RadiatingContour {
public:
    /// Any counter-clockwise shape, taken where it is. It ought to be simple; where it crosses itself, what
    /// it goes round twice counts twice. Throws std::invalid_argument when the area is not positive.
    explicit RadiatingContour(const Shape& shape);
    ~RadiatingContour();
    RadiatingContour(const RadiatingContour&);
    RadiatingContour& operator=(const RadiatingContour&);

    double area_m2() const; ///< holes counted off
    const Shape& shape() const;

    struct Impl;
    const Impl& impl() const { return *m_impl; }

private:
    std::shared_ptr<const Impl> m_impl;
};

/// F21 of the object at X_SO over the source, with gradient, visibility and error estimate. Heated face along
/// -z of O. Method: F21 is the circulation of the source's vector potential along the visible part of the
/// outline; the gradient is the force and torque on a current loop in its curl. A hole is an outline with the
/// opposite sign, in either face. Two half-space cuts decide what is visible. Where the faces run through
/// each other, which plates cannot, the value stands but the gradient leaves out what the cuts gain by
/// moving. Thread-safe. Throws std::invalid_argument on a pose that is not finite, options that mean nothing,
/// and where the two faces overlap in one plane.
ViewFactor viewFactor(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options = {});

/// Value only, to an absolute tolerance: for tables of many thousand poses. `errorEstimate` gets what was
/// reached, if it is given. Throws as viewFactor does.
double viewFactorValue(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance = 1e-9, double* errorEstimate = nullptr);

/// Radiation from the whole object to the source, the reference point moved from O's origin to E's origin:
/// gradient about p_SE, so that it is the row of the interaction matrix for the end-effector's twist in S
/// axes.
Vector6d gradientAbout(const Vector6d& gradient, const Eigen::Vector3d& p_SO, const Eigen::Vector3d& p_SE);

} // namespace bask
