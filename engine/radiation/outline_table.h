#pragma once
// A radiating outline made ready: points and steps at rising resolution, evaluation anywhere, pieces in front
// of a plane.

#include "engine/radiation/disk_field.h"
#include "engine/radiation/view_factor.h"

#include <vector>

namespace bask {

/// The height above the source plane as a function on O's plane: z = z0 + kx x + ky y (m).
struct HeightPlane {
    double z0 = 0.0, kx = 0.0, ky = 0.0;

    double at(double x, double y) const { return z0 + kx * x + ky * y; }
};

/// A smooth stretch of an outline (parameter from..to) or a straight one (from point a to b).
struct OutlinePiece {
    bool straight = false;
    bool onCut = false; ///< lies on the line where the object's plane meets the source plane
    double from = 0.0, to = 0.0;
    Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();
};

/// Where an outline lies with respect to the source plane.
enum class PlaneSide { Front, Behind, Across };

struct RadiatingContour::Impl {
    /// Largest number of tabulated points of a smooth outline.
    static constexpr int kMostTabulated = 256;

    explicit Impl(const Shape& outline);

    /// Levels of resolution. Smooth: level l adds points to those before it (weights are per point, to be
    /// divided by the number of points so far). Polygon: each level stands for itself, weights included.
    int levels() const { return static_cast<int>(m_begin.size()) - 1; }
    OutlinePoints level(int l) const;
    int firstLevel() const {
        return m_firstLevel;
    } ///< enough points for a field that varies linearly over the outline
    bool isSmooth() const { return !isPolygon; }

    /// Point and derivative of a smooth outline at `phi` in [0, 1].
    OutlinePoint at(double phi) const;

    PlaneSide side(const HeightPlane& height) const;
    /// The part with positive height as a closed loop, straight pieces on the cut line included. Empty if
    /// there is none.
    std::vector<OutlinePiece> piecesInFront(const HeightPlane& height) const;
    /// The whole outline as pieces, for adaptive integration.
    std::vector<OutlinePiece> allPieces() const;

    Shape shape;
    double area = 0.0;      ///< m2
    double reach = 0.0;     ///< m, no point is farther from O
    double size = 0.0;      ///< m, about its half extent
    double maxSpeed = 0.0;  ///< m per unit of phi (smooth); longest stretch (polygon)
    double perimeter = 0.0; ///< m, about
    int harmonics = 1;      ///< of a smooth outline
    bool isPolygon = false;

private:
    void tabulateSmooth();
    void tabulatePolygon(const Contour& polygon);
    std::vector<double> crossings(const HeightPlane& height) const;
    std::vector<OutlinePiece> smoothPieces(const HeightPlane& height) const;
    std::vector<OutlinePiece> polygonPieces(const HeightPlane& height) const;

    std::vector<std::complex<double>> m_coefficients; // j = -harmonics .. harmonics
    std::vector<double> m_x, m_y, m_dx, m_dy;
    std::vector<int> m_begin;         // first point of each level, and the end
    std::vector<OutlinePoint> m_scan; // smooth outlines: evenly spaced, in order, for finding crossings
    int m_firstLevel = 0;
};

} // namespace bask
