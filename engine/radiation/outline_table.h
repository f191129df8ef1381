#pragma once
// A radiating outline prepared for integration: tables of points and steps, evaluation anywhere, pieces in
// front of a plane, distance from a point.

#include "engine/radiation/kernels/kernels.h"
#include "engine/radiation/view_factor.h"

#include <array>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

namespace bask {

/// A rule of exponent x is off by kRuleSafety times both perimeters times exp(-x): two for the rule, the rest
/// for the potential's size in the complex plane.
inline constexpr double kRuleSafety = 24.0;
/// A rule gets this share of the tolerance, so that the sum of the parts of an estimate is less than it.
inline constexpr double kRuleShare = 0.6;
/// A face whose lowest point is higher over a plane, relative to the size of both, is in front of it.
inline constexpr double kInFront = 1e-10;

/// The height of one face's points over the other's plane: z0 + kx x + ky y (m).
struct HeightPlane {
    double z0, kx, ky;
    double slope; ///< along the steepest direction

    HeightPlane(double z, double x, double y) : z0(z), kx(x), ky(y), slope(std::sqrt(x * x + y * y)) {}
    double at(double x, double y) const { return z0 + kx * x + ky * y; }
};

/// One point of an outline in O (m) and the step (m per unit of its parameter).
struct OutlinePoint {
    double x = 0.0, y = 0.0, dx = 0.0, dy = 0.0;
};

/// Points of an outline with weighted steps, in the layout of the kernels.
class OutlineTable {
public:
    void add(double x, double y, double dx, double dy);
    /// Adds `count` points of another table, from `first` on.
    void add(const OutlineTable& other, int first, int count);
    void clear();
    int size() const { return static_cast<int>(m_x.size()); }
    /// Pads the table with zero steps for the kernels; call before view().
    void seal();
    kernels::Outline view() const { return {m_x.data(), m_y.data(), m_dx.data(), m_dy.data(), size()}; }

private:
    std::vector<double> m_x, m_y, m_dx, m_dy;
};

/// A smooth part of an outline (parameter from..to) or a straight one (from point a to b).
struct OutlinePiece {
    bool straight = false;
    bool onCut = false; ///< lies on the line where the object's plane meets the source plane
    double from = 0.0, to = 0.0;
    Eigen::Vector2d a = Eigen::Vector2d::Zero(), b = Eigen::Vector2d::Zero();
};

/// Squared distance (m2) of a point to an edge.
double squaredDistance(const kernels::Edge& edge, const Eigen::Vector3d& p);

/// The side of the source plane on which an outline lies.
enum class PlaneSide { Front, Behind, Across };

/// How far a smooth outline's parameter may become complex before a point of the outline meets a singularity
/// of the field; this determines how fast quadrature rules converge. Tabulated over the half width b (rad) of
/// the strip.
class AnalyticStrip {
public:
    static constexpr int kSteps = 96;

    AnalyticStrip() = default;
    /// `coefficients` for j = -harmonics .. harmonics.
    AnalyticStrip(const std::vector<std::complex<double>>& coefficients, int harmonics, double perimeter_m);

    /// Returns the widest step whose strip is free of a singularity at `distance_m` from O's origin; -1 if
    /// there is none.
    int fromCentre(double distance_m) const { return widest(m_reach, distance_m); }
    /// Returns the widest step for a singularity at `distance_m` from the outline; -1 if there is none.
    int fromOutline(double distance_m) const { return widest(m_shift, distance_m); }
    /// Returns the complex distance (of phi) from one point of the outline within which no singularity at
    /// `distance_m` from that point is met.
    double radius(double distance_m) const;
    /// Returns the smallest distance (m) at which radius() is at least `radius`; infinite if none is.
    double distanceFor(double radius) const;

    static double width(int step); ///< b, rad
    /// Returns the log of the largest |dp/dphi| in the strip divided by the perimeter: the cost of a wide
    /// strip.
    double growth(int step) const { return m_growth[static_cast<std::size_t>(step)]; }

private:
    using Table = std::array<double, kSteps>;
    static int widest(const Table& table, double distance_m);

    Table m_reach{}, m_shift{}, m_growth{};
};

/// A trapezoidal rule on a smooth outline. For powers of two it also has the same rule moved by half a step:
/// the mean of the two is the rule with twice as many points.
struct TrapezoidTable {
    int points = 0;
    OutlineTable table;
    OutlineTable shifted;
};

inline constexpr double kTableExponent = 36.0; ///< error of the tabulated Gauss rules is exp(-this): rounding

/// Gauss rules on the edges of a polygon, fine enough for singularities at `distance_m`.
struct GaussTable {
    double distance_m = 0.0;
    OutlineTable table;
};

class Plate;

/// A rule whose error is known in advance: exp(-exponent).
struct ForeseenRule {
    const TrapezoidTable* rule = nullptr; ///< null: there is none
    double exponent = 0.0;
};

/// The tables of an outline, and those of its holes, which are outlines themselves.
struct RadiatingContour::Impl {
    explicit Impl(const Shape& outline);

    /// Returns the point and derivative of a smooth outline at `phi` in [0, 1].
    OutlinePoint at(double phi) const;
    /// Returns the point of a piece at its own parameter: phi, or 0 to 1 from a to b.
    OutlinePoint at(const OutlinePiece& piece, double t) const;
    /// Calls `take(i, point)` with the points of a piece at from + width * nodes[i], at most
    /// kernels::kMaxSeriesPoints of them. For an outline of many harmonics this is much faster than at(),
    /// from which it differs by rounding.
    template <class F>
    void atNodes(const OutlinePiece& piece, double from, double width, std::span<const double> nodes,
                 const F& take) const {
        if (piece.straight || disk) {
            for (std::size_t i = 0; i < nodes.size(); ++i)
                take(i, at(piece, from + width * nodes[i]));
            return;
        }
        const kernels::SeriesPoints p = seriesAt(from, width, nodes);
        constexpr double kTurn = 2.0 * std::numbers::pi;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            take(i, OutlinePoint{p.x[i], p.y[i], kTurn * p.dx[i], kTurn * p.dy[i]});
    }

    /// Returns a trapezoidal rule (smooth outline) of at least `points` points, weights included; null if no
    /// rule has as many.
    const TrapezoidTable* trapezoid(double points) const;
    /// Returns a trapezoidal rule on a whole smooth outline for an error exp(-exponent), where the source's
    /// outline is at least `fromCentre` from O's origin and `nearest` from the outline (m).
    ForeseenRule foreseen(double fromCentre, double nearest, double exponent) const;
    /// Returns the trapezoidal rule of 8, 16, 24 or 32 points of a smooth outline, as it stays in memory: a
    /// view that is made for a call would keep the kernel waiting.
    const kernels::Outline& quick(int points) const {
        return m_quick[static_cast<std::size_t>(points / 8 - 1)];
    }
    static constexpr int kMaxQuickPoints = 32;
    /// Returns Gauss rules on the edges of a polygon that resolve singularities at `distance_m` to rounding;
    /// null if none do.
    const GaussTable* gauss(double distance_m) const;

    bool isPlainDisk() const { return disk != nullptr && holes.empty(); }
    PlaneSide side(const HeightPlane& height) const;
    /// Returns the part with positive height as a closed loop, with straight pieces on the cut line. Empty if
    /// there is none.
    std::vector<OutlinePiece> piecesInFront(const HeightPlane& height) const;
    /// Returns the whole outline as pieces.
    std::vector<OutlinePiece> allPieces() const;

    /// Returns a lower bound of the distance (m) of a point of O to a smooth outline, within a third of it.
    double curveDistance_m(const Eigen::Vector3d& p) const;
    /// Returns an upper bound of the speed (m per unit of phi) of a Fourier outline between two parameters.
    double speedBetween_m(double from, double to) const;

    /// Returns what shade needs of the shape, made at the first call.
    const Plate& plate() const;

    Shape shape;
    double netArea = 0.0; ///< m2, without the holes
    std::vector<Impl> holes;

    double area = 0.0;       ///< m2, of the outline without holes, like all that follows
    double reach = 0.0;      ///< m, largest distance of a point from O
    double maxSpeed_m = 0.0; ///< largest speed of a smooth outline, per unit of phi
    double perimeter = 0.0;  ///< m, approximate
    int harmonics = 1;       ///< of a smooth outline
    bool isPolygon = false;
    const Disk* disk = nullptr;       ///< null if it is not a disk
    AnalyticStrip strip;              ///< of a smooth outline
    std::vector<kernels::Edge> edges; ///< of a polygon

private:
    kernels::SeriesPoints seriesAt(double from, double width, std::span<const double> nodes) const;
    void tabulateSmooth();
    void tabulatePolygon(const Contour& polygon);
    std::vector<double> crossings(const HeightPlane& height) const;
    std::vector<OutlinePiece> smoothPieces(const HeightPlane& height) const;
    std::vector<OutlinePiece> polygonPieces(const HeightPlane& height) const;

    struct LatePlate;
    static std::shared_ptr<LatePlate> latePlate();
    std::shared_ptr<LatePlate> m_plate = latePlate();

    std::vector<std::complex<double>> m_coefficients;          // j = -harmonics .. harmonics
    std::array<kernels::Outline, kMaxQuickPoints / 8> m_quick; // views of the first trapezoids
    std::vector<TrapezoidTable> m_trapezoids; // of a smooth outline, in ascending order of points
    std::vector<GaussTable> m_gauss;          // of a polygon, in descending order of distance
    std::vector<double> m_speeds;             // bounds from each scanned point to the next
    std::vector<OutlinePoint> m_scan; // smooth outlines: evenly spaced, in order, for finding crossings
};

} // namespace bask
