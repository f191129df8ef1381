#pragma once
// View factor F21 from a planar object to a planar source with its exact gradient (circulation form).

#include "engine/base/pose.h"
#include "engine/base/result.h"
#include "engine/shape/shape.h"

#include <memory>

namespace bask {

/// How much of the two faces is visible to the other: all, a part (one of the cuts applies), none (F = 0).
enum class Visibility { Full, Partial, Hidden };
const char* visibilityName(Visibility visibility); ///< "full", "partial", "hidden"

/// A view factor with its gradient, error estimate and effort.
struct ViewFactor {
    double value = 0.0; ///< F21, in [0, 1]
    /// dF/d(position) 1/m and dF/d(rotation) 1/rad, S axes, about O's origin.
    Vector6d gradient = Vector6d::Zero();
    Visibility visibility = Visibility::Hidden;
    double errorEstimate = 0.0; ///< absolute error of `value`, at most 1
};

struct ViewFactorOptions {
    double tolerance = 1e-9; ///< absolute error of the value; determines the number of points
    /// The limit for an outline of the object over one of the source; if it is reached, errorEstimate says
    /// which error remains.
    int maxPoints = 1 << 17;
};

/// A shape, of an object or of a source, prepared for many evaluations: area and tabulated points of its
/// outline and holes, shared by copies. Immutable.
class RadiatingContour {
public:
    /// Takes any counter-clockwise shape at its position. It should be simple; where it crosses itself, an
    /// area that it goes round twice counts twice. Throws std::invalid_argument if the area is not positive.
    explicit RadiatingContour(const Shape& shape);
    ~RadiatingContour();
    RadiatingContour(const RadiatingContour&);
    RadiatingContour& operator=(const RadiatingContour&);

    double area_m2() const; ///< without the holes
    const Shape& shape() const;

    struct Impl;
    const Impl& impl() const { return *m_impl; }

private:
    std::shared_ptr<const Impl> m_impl;
};

/// Returns F21 of the object at X_SO to the source, with gradient, visibility and error estimate. The heated
/// face is along -z of O. Method: F21 is the circulation of the source's vector potential along the visible
/// part of the outline; the gradient is the force and torque on a current loop in its curl. A hole, in either
/// face, is an outline with the opposite sign. Two half-space cuts determine the visible part. If the faces
/// pass through each other, which plates cannot, the value is valid but the gradient ignores how the cuts
/// move. Thread-safe. Throws std::invalid_argument for a pose that is not finite, for invalid options, and if
/// the two faces overlap in one plane.
ViewFactor viewFactor(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options = {});

/// Returns only the value, to an absolute tolerance: for tables of many thousand poses. If `errorEstimate` is
/// given, it receives the estimated error. Throws as viewFactor does.
double viewFactorValue(const RadiatingContour& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance = 1e-9, double* errorEstimate = nullptr);

/// Moves the reference point of a gradient from O's origin to E's origin. Returns the gradient about p_SE:
/// the row of the interaction matrix for the end-effector's twist in S axes.
Vector6d gradientAbout(const Vector6d& gradient, const Eigen::Vector3d& p_SO, const Eigen::Vector3d& p_SE);

} // namespace bask
