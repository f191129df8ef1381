#pragma once
// Truncated Fourier contour x + iy = sum_{j=-H..H} c_j exp(2 pi i j phi) and its least-squares fit by arc
// length.

#include "engine/base/share_done.h"
#include "engine/shape/contour.h"

#include <complex>
#include <optional>
#include <vector>

namespace bask {

inline constexpr int kMaxHarmonics = 40; ///< the maximum for a fit

/// Descriptor series, counter-clockwise; coefficient(j) for |j| <= harmonics(), metres.
class FourierContour {
public:
    FourierContour() = default;
    /// `coefficients` has 2H+1 entries for j = -H..H; throws std::invalid_argument otherwise.
    explicit FourierContour(std::vector<std::complex<double>> coefficients);

    int harmonics() const { return (static_cast<int>(m_coefficients.size()) - 1) / 2; }
    std::complex<double> coefficient(int j) const;
    const std::vector<std::complex<double>>& coefficients() const { return m_coefficients; }

    std::complex<double> point(double phi) const;      ///< m, phi in [0,1)
    std::complex<double> derivative(double phi) const; ///< m per unit phi

    double area() const;                   ///< m2, exact: pi sum j |c_j|^2
    double perimeter() const;              ///< m, trapezoid, converged to 1e-9 of its value or to 2^14 points
    std::complex<double> centroid() const; ///< m, area centroid

    bool operator==(const FourierContour&) const = default;

private:
    std::vector<std::complex<double>> m_coefficients;
};

/// Returns a point (m) where the curve meets itself, also where it runs over itself again; empty if it is
/// simple. Parts closer together than 1e-8 of the size may count as meeting, and loops of that size may be
/// missed.
std::optional<Eigen::Vector2d> findCrossing(const FourierContour& contour);

/// A fit and its errors: rms and largest distance (m) between points of the outline and of the series at
/// equal arc length, and the Hausdorff distance, which does not depend on arc length.
struct FourierFit {
    FourierContour contour;
    Eigen::Vector2d centre_m = Eigen::Vector2d::Zero(); ///< the series' origin in the outline's coordinates
    double rms_m = 0.0;
    double max_m = 0.0;
    double hausdorff_m = 0.0;   ///< both ways, to 1e-6 of the perimeter
    double areaError = 0.0;     ///< area of the series divided by that of the outline, minus one
    bool crossesItself = false; ///< the truncated curve is not simple
};

/// Fits a least-squares series of `harmonics` harmonics in the arc length of the outline (exact projection,
/// edge by edge). The centroid of the **series** is moved to the origin. Refuses harmonics
/// outside 1..kMaxHarmonics.
Result<FourierFit> fitFourier(const Contour& outline, int harmonics);

/// Returns the distance (m) of points in the outline's coordinates to the nearest point of the fitted curve,
/// to a millionth of its size.
std::vector<double> distancesTo(const FourierFit& fit, const std::vector<Eigen::Vector2d>& points);

/// Returns the fit with the smallest number of harmonics whose Hausdorff distance from the outline is at most
/// `tolerance_m` and that does not cross itself. `done` is told of the largest share that is left. Errors:
/// ValueNotPositive, ToleranceUnreachable.
Result<FourierFit> fitFourierWithin(const Contour& outline, double tolerance_m, const ShareDone& done = {});

} // namespace bask
