#include "engine/thermography/band_radiance.h"

#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kPlanck_Js = 6.62607015e-34, kLight_m_s = 299792458.0, kBoltzmann_J_K = 1.380649e-23;
constexpr double kFirst = 2.0 * kPlanck_Js * kLight_m_s * kLight_m_s;   ///< W m2 / sr
constexpr double kSecond_mK = kPlanck_Js * kLight_m_s / kBoltzmann_J_K; ///< c2
constexpr double kMinWavelength_m = 1e-7, kMaxWavelength_m = 1e-3;

/// A radiance and its first two derivatives by ln T, in units of exp(scale): at 100 K and 0.1 um it would be
/// too small for a double.
struct ScaledRadiance {
    double value = 0.0, first = 0.0, second = 0.0;
};

/// Adds Planck's law at one wavelength, divided by exp(-shift).
void addPlanck(double wavelength_m, double T_K, double weight, double shift, ScaledRadiance& sum) {
    const double x = kSecond_mK / (wavelength_m * T_K);
    const double gone = -std::expm1(-x); // 1 - exp(-x)
    const double B = weight * kFirst / std::pow(wavelength_m, 5.0) * std::exp(shift - x) / gone;
    const double w = x / gone; // d ln B / d ln T
    const double dw = (gone - x * std::exp(-x)) / (gone * gone);
    sum.value += B;
    sum.first += B * w;
    sum.second += B * (w * w - x * dw);
}

/// Gauss's rule of 16 points on panels short beside the wavelength: exact to rounding.
ScaledRadiance integrated(const std::vector<BandResponse>& curve, double T_K, double shift) {
    const GaussRule rule = gaussRule(kMaxGaussPoints);
    ScaledRadiance sum;
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
        const BandResponse &a = curve[k], &b = curve[k + 1];
        // The exponent kSecond / (lambda T) may change by some units on a panel.
        const double range = kSecond_mK / T_K * (1.0 / a.wavelength_m - 1.0 / b.wavelength_m);
        const double octaves = std::log2(b.wavelength_m / a.wavelength_m);
        const int panels =
            std::clamp(static_cast<int>(std::ceil(std::max(range / 4.0, 3.0 * octaves))), 1, 20000);
        const double width = (b.wavelength_m - a.wavelength_m) / panels;
        for (int p = 0; p < panels; ++p)
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double share = (p + rule.nodes[i]) / panels;
                const double response = a.response + share * (b.response - a.response);
                addPlanck(a.wavelength_m + (p + rule.nodes[i]) * width, T_K,
                          rule.weights[i] * width * response, shift, sum);
            }
    }
    return sum;
}

void requireCurve(const std::vector<BandResponse>& curve) {
    bool isGood = curve.size() >= 2, isPositive = false;
    for (std::size_t k = 0; isGood && k < curve.size(); ++k) {
        const BandResponse& at = curve[k];
        isGood = at.wavelength_m >= kMinWavelength_m && at.wavelength_m <= kMaxWavelength_m &&
                 at.response >= 0.0 && std::isfinite(at.response) &&
                 (k == 0 || at.wavelength_m > curve[k - 1].wavelength_m);
        isPositive = isPositive || at.response > 0.0;
    }
    if (!isGood || !isPositive)
        throw std::invalid_argument(
            "BandRadiance: a response needs two points or more with growing wavelengths "
            "from 0.1 um to 1 mm, not negative, not all zero");
}

struct PiecePlace {
    std::size_t piece = 0;
    double t = 0.0;
};

PiecePlace placeIn(double argument, double first, double step, int pieces) {
    const double at = (argument - first) / step;
    const int piece = std::clamp(static_cast<int>(at), 0, pieces - 1);
    return {static_cast<std::size_t>(piece), at - piece};
}

double polynomial(const std::array<double, 6>& c, double t) {
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
}

double slope(const std::array<double, 6>& c, double t) {
    return c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * 5.0 * c[5])));
}

double lnInBand(double T_K) {
    if (!(T_K >= kMinBand_K && T_K <= kMaxBand_K))
        throw std::invalid_argument("BandRadiance: temperatures from 100 to 3000 K");
    return std::log(T_K);
}

} // namespace

template <class NodeAt>
BandRadiance::Table BandRadiance::tabulated(double first, double last, NodeAt nodeAt) {
    Table table;
    table.first = first;
    table.step = (last - first) / kPieces;
    const auto scaled = [&](int k) {
        Node node = nodeAt(k == kPieces ? last : first + k * table.step);
        node.first *= table.step;
        node.second *= table.step * table.step;
        return node;
    };
    Node a = scaled(0);
    for (int k = 0; k < kPieces; ++k) {
        const Node b = scaled(k + 1);
        // Hermite's polynomial of degree five: value, slope and curvature at both ends.
        const double rise = b.value - a.value - a.first - 0.5 * a.second;
        const double turn = b.first - a.first - a.second, bend = b.second - a.second;
        table.pieces[static_cast<std::size_t>(k)] = {a.value,
                                                     a.first,
                                                     0.5 * a.second,
                                                     10.0 * rise - 4.0 * turn + 0.5 * bend,
                                                     -15.0 * rise + 7.0 * turn - bend,
                                                     6.0 * rise - 3.0 * turn + 0.5 * bend};
        a = b;
    }
    return table;
}

void BandRadiance::build(const std::vector<BandResponse>& curve) {
    requireCurve(curve);
    // ln L, with the exponent at the long end taken out of the sums and put back.
    const auto lnRadiance = [&](double lnT) {
        const double T_K = std::exp(lnT);
        const double shift = kSecond_mK / (curve.back().wavelength_m * T_K);
        const ScaledRadiance L = integrated(curve, T_K, shift);
        const double first = L.first / L.value;
        return Node{std::log(L.value) - shift, first, L.second / L.value - first * first};
    };
    const double minLnT = std::log(kMinBand_K), maxLnT = std::log(kMaxBand_K);
    m_lnL = tabulated(minLnT, maxLnT, lnRadiance);
    m_minLnL = polynomial(m_lnL.pieces.front(), 0.0);
    m_maxLnL = polynomial(m_lnL.pieces.back(), 1.0);
    double lnT = minLnT;
    m_lnT = tabulated(m_minLnL, m_maxLnL, [&](double lnL) {
        // Newton, from the node before; ln L is concave in ln T, so that no step goes too far.
        Node at = lnRadiance(lnT);
        for (int i = 0; i < 60; ++i) {
            const double step = (lnL - at.value) / at.first;
            lnT = std::clamp(lnT + step, minLnT - 1e-12, maxLnT + 1e-12);
            at = lnRadiance(lnT);
            if (std::abs(step) < 1e-13)
                break;
        }
        return Node{lnT, 1.0 / at.first, -at.second / (at.first * at.first * at.first)};
    });
}

BandRadiance::BandRadiance(double from_m, double to_m) {
    build({{from_m, 1.0}, {to_m, 1.0}});
}

BandRadiance::BandRadiance(const std::vector<BandResponse>& curve) {
    build(curve);
}

double BandRadiance::radiance(double T_K) const {
    const PiecePlace at = placeIn(lnInBand(T_K), m_lnL.first, m_lnL.step, kPieces);
    return std::exp(polynomial(m_lnL.pieces[at.piece], at.t));
}

double BandRadiance::derivative(double T_K) const {
    const PiecePlace at = placeIn(lnInBand(T_K), m_lnL.first, m_lnL.step, kPieces);
    const auto& piece = m_lnL.pieces[at.piece];
    return std::exp(polynomial(piece, at.t)) * slope(piece, at.t) / (m_lnL.step * T_K);
}

double BandRadiance::temperature(double radiance) const {
    const double lnL = std::log(radiance); // of a negative one: NaN
    if (!(lnL >= m_minLnL - 1e-12 && lnL <= m_maxLnL + 1e-12))
        return std::numeric_limits<double>::quiet_NaN();
    const PiecePlace at = placeIn(lnL, m_lnT.first, m_lnT.step, kPieces);
    return std::clamp(std::exp(polynomial(m_lnT.pieces[at.piece], at.t)), kMinBand_K, kMaxBand_K);
}

const BandRadiance& thermalBand() {
    static const BandRadiance kBand;
    return kBand;
}

} // namespace bask
