#pragma once
// The field of a disk source along an object's outline: whole disk (vectorised), or the segment that the
// object's plane leaves.

#include "engine/base/pose.h"
#include "engine/radiation/quadrature.h"

#include <cmath>
#include <numbers>

namespace bask {

/// Points of an outline in O (m) with the weighted steps along it, as separate arrays of `count`.
struct OutlinePoints {
    const double* x = nullptr;
    const double* y = nullptr;
    const double* dx = nullptr;
    const double* dy = nullptr;
    int count = 0;
};

/// One point of an outline in O (m) and the step (m per unit of its parameter).
struct OutlinePoint {
    double x = 0.0, y = 0.0, dx = 0.0, dy = 0.0;
};

/// The whole disk seen from O: all it takes to evaluate W and B there. Moments come out in **O axes**, about
/// O's origin.
struct WholeDisk {
    double radius = 0.0;
    Eigen::Vector3d o = Eigen::Vector3d::Zero(); ///< O's origin less the source's centre, O axes
    Eigen::Vector3d k = Eigen::Vector3d::Zero(); ///< source's normal, O axes

    WholeDisk(double radius_m, const Pose& X_SO)
        : radius(radius_m), o(X_SO.linear().transpose() * X_SO.translation()),
          k(X_SO.linear().row(2).transpose()) {}

    LoopSums at(const OutlinePoint& point) const;
};

/// Sum over points; the value alone, or with the moments. `distance_m` is a lower bound of the distance to
/// the rim.
LoopSums wholeDiskValue(const WholeDisk& disk, const OutlinePoints& points);
LoopSums wholeDiskSums(const WholeDisk& disk, const OutlinePoints& points);

/// The disk's segment in front of the object's plane: an arc and the chord on the line where the two planes
/// meet. Its axes are e1 (in the source plane, towards the kept side), e2 (along the chord), e3 = source's
/// normal; lengths in radii. Moments come out in these axes, about O's origin.
class DiskSegment {
public:
    /// `X_SO` must be a pose whose plane crosses the disk.
    DiskSegment(double radius_m, const Pose& X_SO);

    /// Field of arc and chord; `arcOnly` leaves out the chord, for points on the chord's own line.
    LoopSums at(const OutlinePoint& point, bool arcOnly = false) const;
    LoopSums sums(const OutlinePoints& points) const;

    /// Straight piece of the object's outline from `a` to `b` (O, m), both on the chord's line: the chord's
    /// part of it.
    LoopSums chordAlongItself(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;

    /// Coordinate along the chord's line (m) of a point of O's plane; the chord ends at +-halfChord_m().
    double along_m(const Eigen::Vector2d& p) const;
    double halfChord_m() const { return m_sinBeta * m_radius; }

    /// Columns are e1, e2, e3 in S axes.
    const Eigen::Matrix3d& axes() const { return m_axes; }

private:
    double m_radius;
    Eigen::Matrix3d m_axes;
    Eigen::Matrix3d m_turn;   // O axes to segment axes
    Eigen::Vector3d m_origin; // O's origin, segment axes, in radii
    double m_sinTilt, m_normal3;
    double m_beta, m_sinBeta, m_cosBeta;
};

/// W.dp, dp x B and lever x (dp x B) of a whole disk at a point of O; MODEL section 2, written in O axes,
/// where B = -g_z p + (B_z + z g_z) k. Shared by the vectorised loops and the adaptive integrals.
template <bool kMoments, class Out>
[[gnu::always_inline]] inline void wholeDiskTerm(double r2, double o1, double o2, double o3, double k1,
                                                 double k2, double k3, double x, double y, double dx,
                                                 double dy, Out& out) {
    const double p1 = o1 + x;
    const double p2 = o2 + y;
    const double square = p1 * p1 + p2 * p2 + o3 * o3;
    const double z = k1 * p1 + k2 * p2 + k3 * o3;
    const double a = square + r2;
    const double t = square - r2;
    const double root = std::sqrt(t * t + 4.0 * r2 * z * z);
    const double s = root > 1e-150 ? root : 1e-150; // a point on the rim itself stays finite
    const double step = k2 * o3 * dx - k1 * o3 * dy + k3 * (p1 * dy - p2 * dx);
    out.s = s;
    if constexpr (!kMoments) {
        out.circulation = step / (a + s);
    } else {
        const double both = 1.0 / (s * (a + s));
        const double u = s * both;
        const double v = (a + s) * both;
        out.circulation = step * u;
        const double gz = -2.0 * z * both; // all over -2 pi r^2, as the circulation
        const double q = square - z * z;
        const double h = 2.0 * u * (1.0 - q * (s + t) * both - z * z * v);
        const double b1 = h * k1 - gz * p1;
        const double b2 = h * k2 - gz * p2;
        const double b3 = h * k3 - gz * o3;
        const double f1 = dy * b3;
        const double f2 = -dx * b3;
        const double f3 = dx * b2 - dy * b1;
        out.f1 = f1;
        out.f2 = f2;
        out.f3 = f3;
        out.t1 = y * f3;
        out.t2 = -x * f3;
        out.t3 = x * f2 - y * f1;
    }
}

} // namespace bask
