#pragma once
// Pairs of faces drawn at random for the tests of the view factor: all nine pairs of kinds, bent inwards too,
// of any ratio of sizes, in poses with either cut, both, none and hidden.

#include "tests/engine/radiation/random_poses.h"

#include <complex>
#include <numbers>

namespace bask::test {

inline constexpr double kPi = std::numbers::pi;
inline constexpr int kKinds = 3;
inline const char* const kKindNames[] = {"disk", "fourier", "polygon"};

/// The tightest tolerance, with points enough: what others are measured against.
inline constexpr ViewFactorOptions kSharp{1e-13, 1 << 20};

inline Pose poseAt(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) {
    return poseFromRotationVector({x, y, z}, {rx, ry, rz});
}

/// A star with deep notches.
Contour star(double radius_m, int points, double inner);
/// Not star-shaped about any point: a horseshoe. A line may cut it into three pieces.
Contour horseshoe(double radius_m);
/// Lobes with bays between them.
FourierContour clover(double radius_m, int lobes, double depth);

/// One of each kind: 0 disk, 1 Fourier, 2 polygon; half of them bent inwards.
Shape drawShape(Draw& draw, int kind, double radius_m);

struct FacePair {
    Shape source, object;
    Pose X_SO;
    double size_m = 0.0; ///< of the smaller
};

/// Sizes apart by up to a factor of fifty either way; `variety` chooses among kinds of pose.
FacePair drawPair(Draw& draw, int sourceKind, int objectKind, int variety);

/// The shape moved by `shift` and turned in its own plane; a disk cannot be shifted.
Shape movedInPlane(const Shape& shape, std::complex<double> shift, double angle);
Shape scaled(const Shape& shape, double factor);

/// The same two faces with their roles exchanged. Each is now seen from its other side: outlines mirrored in
/// their x axis, and both frames turned about x by pi.
FacePair exchanged(const FacePair& pair);

/// Whether the line in which the two planes meet has points inside both faces.
bool runThroughEachOther(const FacePair& pair);

} // namespace bask::test
