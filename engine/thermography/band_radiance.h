#pragma once
// Radiance of a black body within the band of a thermal camera, and the temperature for a radiance.

#include <array>
#include <vector>

namespace bask {

/// The lowest and the highest temperature of a BandRadiance, K.
inline constexpr double kMinBand_K = 100.0, kMaxBand_K = 3000.0;

/// The band that nearly all uncooled cameras have, m.
inline constexpr double kThermalBandFrom_m = 8e-6, kThermalBandTo_m = 14e-6;

/// One point of a camera's spectral response. Between two points the response is linear; outside of the first
/// and the last it is zero. Only ratios matter for temperatures.
struct BandResponse {
    double wavelength_m = 0.0;
    double response = 0.0;
    bool operator==(const BandResponse&) const = default;
};

/// L(T) = integral over the band of R(lambda) 2 h c^2 / (lambda^5 (exp(h c / (lambda k T)) - 1)), by the
/// constants of CODATA 2018, with the response R = 1 unless a curve is given. Values, derivatives and inverse
/// are within 1e-10 (relative) of the integral; each takes a few tens of ns, because ln L is stored as
/// polynomials of ln T, and ln T as polynomials of ln L. Immutable; thread-safe; making one takes some 5 ms.
class BandRadiance {
public:
    /// A flat response from `from_m` to `to_m`. Throws std::invalid_argument unless 0.1 um <= from < to <= 1
    /// mm.
    explicit BandRadiance(double from_m = kThermalBandFrom_m, double to_m = kThermalBandTo_m);
    /// A tabulated response. Throws std::invalid_argument unless there are at least two points with growing
    /// wavelengths from 0.1 um to 1 mm, no response is negative, and one is positive.
    explicit BandRadiance(const std::vector<BandResponse>& curve);

    /// Returns the radiance (W / (m2 sr) for a flat response). Throws std::invalid_argument outside of
    /// kMinBand_K to kMaxBand_K, and for NaN.
    double radiance(double T_K) const;
    /// Returns the derivative of the radiance by the temperature, per K; the same range.
    double derivative(double T_K) const;
    /// Returns the temperature of the black body of this radiance, K. NaN for a radiance that no temperature
    /// of kMinBand_K to kMaxBand_K has.
    double temperature(double radiance) const;

private:
    static constexpr int kPieces = 256;
    /// Coefficients of a polynomial of degree five on [0, 1].
    using Piece = std::array<double, 6>;
    struct Table {
        double first = 0.0, step = 1.0;
        std::array<Piece, kPieces> pieces{};
    };
    /// A value with two derivatives by the table's argument.
    struct Node {
        double value = 0.0, first = 0.0, second = 0.0;
    };
    void build(const std::vector<BandResponse>& curve);
    template <class NodeAt> static Table tabulated(double first, double last, NodeAt nodeAt);

    Table m_lnL; ///< of ln T
    Table m_lnT; ///< of ln L
    double m_minLnL = 0.0, m_maxLnL = 0.0;
};

/// Returns the band of 8 to 14 um with a flat response, made at its first use.
const BandRadiance& thermalBand();

} // namespace bask
