#include "engine/shape/fourier_contour.h"

#include "engine/base/message_code.h"
#include "engine/shape/crossing.h"
#include "engine/shape/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace bask {
namespace {

using Complex = std::complex<double>;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

Complex complexOf(const Eigen::Vector2d& p) {
    return {p.x(), p.y()};
}
Eigen::Vector2d vectorOf(const Complex& z) {
    return {z.real(), z.imag()};
}

double sinc(double x) {
    return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

// Arc length from point 0 to every point, and once round at the end.
std::vector<double> arcLengths(const std::vector<Eigen::Vector2d>& points) {
    std::vector<double> s(points.size() + 1, 0.0);
    for (std::size_t k = 0; k < points.size(); ++k)
        s[k + 1] = s[k] + (points[(k + 1) % points.size()] - points[k]).norm();
    return s;
}

// c_j = (1/L) int z(s) exp(-2 pi i j s/L) ds, exact on every straight edge. For j != 0 it is integrated by
// parts over the closed ring: an edge D of length l about s_mid gives L/(2 pi i j) D exp(-i w s_mid) sinc(w
// l/2) / L.
std::vector<Complex> project(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& s,
                             int harmonics) {
    const double length = s.back();
    std::vector<Complex> c(static_cast<std::size_t>(2 * harmonics + 1));
    const auto at = [&](int j) -> Complex& { return c[static_cast<std::size_t>(j + harmonics)]; };
    const Complex start = complexOf(points[0]);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Complex a = complexOf(points[k]), b = complexOf(points[(k + 1) % points.size()]);
        const double edge = s[k + 1] - s[k];
        at(0) += edge * (0.5 * (a + b) - start);
        const double half = std::numbers::pi * edge / length;
        const Complex turn = std::polar(1.0, -kTwoPi * 0.5 * (s[k] + s[k + 1]) / length);
        Complex power = 1.0;
        for (int j = 1; j <= harmonics; ++j) {
            power *= turn;
            const Complex share = (b - a) * sinc(half * j);
            at(j) += share * power;
            at(-j) += share * std::conj(power);
        }
    }
    at(0) = start + at(0) / length;
    for (int j = 1; j <= harmonics; ++j) {
        at(j) /= Complex(0.0, kTwoPi * j);
        at(-j) /= Complex(0.0, -kTwoPi * j);
    }
    return c;
}

// Distances at equal arc length: rms over even samples, the largest over these and the outline's corners.
void measureResidual(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& s,
                     FourierFit& fit) {
    const std::size_t n = points.size();
    const std::size_t samples = std::clamp<std::size_t>(16 * n, 32768, 262144);
    double sum = 0.0, max = 0.0;
    std::size_t edge = 0;
    for (std::size_t k = 0; k < samples; ++k) {
        const double at = s.back() * (static_cast<double>(k) + 0.5) / static_cast<double>(samples);
        while (edge + 1 < n && s[edge + 1] < at)
            ++edge;
        const double t = (at - s[edge]) / (s[edge + 1] - s[edge]);
        const Eigen::Vector2d p = points[edge] + t * (points[(edge + 1) % n] - points[edge]);
        const double d2 = std::norm(fit.contour.point(at / s.back()) - complexOf(p));
        sum += d2;
        max = std::max(max, d2);
    }
    for (std::size_t k = 0; k < n; ++k)
        max = std::max(max, std::norm(fit.contour.point(s[k] / s.back()) - complexOf(points[k])));
    fit.rms_m = std::sqrt(sum / static_cast<double>(samples));
    fit.max_m = std::sqrt(max);
}

// Chords that keep to the series within a millionth of its size as far as harmonics go.
std::vector<Eigen::Vector2d> chordsOf(const FourierContour& contour) {
    constexpr int kChords = 8192;
    std::vector<Eigen::Vector2d> chords;
    chords.reserve(kChords);
    for (int k = 0; k < kChords; ++k)
        chords.push_back(vectorOf(contour.point(static_cast<double>(k) / kChords)));
    return chords;
}

double hausdorffOf(const std::vector<Eigen::Vector2d>& points, const FourierContour& contour,
                   double perimeter_m) {
    constexpr double kTolerance = 1e-6;
    return hausdorffDistance(points, chordsOf(contour), kTolerance * perimeter_m);
}

// The first terms of a series, which are those of its shorter fits.
FourierContour truncated(const std::vector<Complex>& coefficients, int harmonics) {
    const auto middle = coefficients.begin() + static_cast<std::ptrdiff_t>(coefficients.size() / 2);
    return FourierContour(std::vector<Complex>(middle - harmonics, middle + harmonics + 1));
}

std::optional<Crossing> findChordCrossing(const FourierContour& contour, int n) {
    std::vector<Eigen::Vector2d> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        const Eigen::Vector2d p = vectorOf(contour.point(static_cast<double>(k) / n));
        if (points.empty() || p != points.back())
            points.push_back(p);
    }
    if (points.size() < 3)
        return Crossing{0, 0, points.front()};
    return findCrossing(points);
}

} // namespace

FourierContour::FourierContour(std::vector<Complex> coefficients) : m_coefficients(std::move(coefficients)) {
    if (m_coefficients.size() % 2 == 0)
        throw std::invalid_argument("FourierContour: the number of coefficients must be odd, 2H + 1");
}

Complex FourierContour::coefficient(int j) const {
    if (std::abs(j) > harmonics() || m_coefficients.empty())
        throw std::out_of_range("FourierContour: no coefficient " + std::to_string(j));
    return m_coefficients[static_cast<std::size_t>(j + harmonics())];
}

Complex FourierContour::point(double phi) const {
    const Complex turn = std::polar(1.0, kTwoPi * phi);
    Complex sum = 0.0;
    for (std::size_t k = m_coefficients.size(); k-- > 0;)
        sum = sum * turn + m_coefficients[k];
    return sum * std::polar(1.0, -kTwoPi * phi * harmonics());
}

Complex FourierContour::derivative(double phi) const {
    const Complex turn = std::polar(1.0, kTwoPi * phi);
    Complex sum = 0.0;
    for (std::size_t k = m_coefficients.size(); k-- > 0;)
        sum = sum * turn + m_coefficients[k] * static_cast<double>(static_cast<int>(k) - harmonics());
    return Complex(0.0, kTwoPi) * sum * std::polar(1.0, -kTwoPi * phi * harmonics());
}

double FourierContour::area() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < m_coefficients.size(); ++k)
        sum += (static_cast<int>(k) - harmonics()) * std::norm(m_coefficients[k]);
    return std::numbers::pi * sum;
}

double FourierContour::perimeter() const {
    const auto sumAt = [&](int n, double offset) {
        double sum = 0.0;
        for (int k = 0; k < n; ++k)
            sum += std::abs(derivative((k + offset) / n));
        return sum / n;
    };
    int n = 64;
    double value = sumAt(n, 0.0);
    while (n < 1 << 14) {
        const double finer = 0.5 * (value + sumAt(n, 0.5)); // the even points are those already summed
        n *= 2;
        const bool converged = n > 4 * harmonics() && std::abs(finer - value) <= 1e-9 * finer;
        value = finer;
        if (converged)
            break;
    }
    return value;
}

Complex FourierContour::centroid() const {
    if (m_coefficients.empty())
        return 0.0;
    // Integral of z over the area = 1/(2i) oint |z|^2 dz; the trapezoid is exact above 3H points.
    const Complex middle = coefficient(0);
    const int n = 4 * harmonics() + 4;
    Complex sum = 0.0;
    for (int k = 0; k < n; ++k) {
        const double phi = static_cast<double>(k) / n;
        sum += std::norm(point(phi) - middle) * derivative(phi);
    }
    const double a = area();
    return a == 0.0 ? middle : middle + sum / Complex(0.0, 2.0 * n * a);
}

std::optional<Eigen::Vector2d> findCrossing(const FourierContour& contour) {
    // Chords of close strands may cross where the curve does not, so a crossing has to stay among far shorter
    // ones. Primes, so that the chords of a curve traced more than once do not lie on each other.
    constexpr int kChords = 4099;
    constexpr int kShortChords = 65537;
    std::vector<Complex> coefficients = contour.coefficients();
    const Complex middle =
        std::exchange(coefficients.at(static_cast<std::size_t>(contour.harmonics())), Complex(0.0));
    const FourierContour about(std::move(coefficients)); // far from the origin, digits would be lost
    if (!findChordCrossing(about, kChords))
        return std::nullopt;
    const auto crossing = findChordCrossing(about, kShortChords);
    return crossing ? std::optional<Eigen::Vector2d>(crossing->point + vectorOf(middle)) : std::nullopt;
}

Result<FourierFit> fitFourier(const Contour& outline, int harmonics) {
    if (harmonics < 1 || harmonics > kMaxHarmonics)
        return Error{MessageCode::HarmonicsOutOfRange,
                     {},
                     {std::to_string(harmonics), "1", std::to_string(kMaxHarmonics)}};
    if (outline.points_m.size() < 3)
        return Error{MessageCode::ContourTooFewPoints, {}, {std::to_string(outline.points_m.size()), "3"}};
    const std::vector<double> s = arcLengths(outline.points_m);
    std::vector<Complex> c = project(outline.points_m, s, harmonics);
    FourierFit fit;
    fit.contour = FourierContour(c);
    measureResidual(outline.points_m, s, fit);
    fit.hausdorff_m = hausdorffOf(outline.points_m, fit.contour, s.back());
    fit.areaError = fit.contour.area() / contourArea(outline) - 1.0;
    fit.centre_m = vectorOf(fit.contour.centroid());
    c[static_cast<std::size_t>(harmonics)] -= fit.contour.centroid();
    fit.contour = FourierContour(std::move(c));
    fit.crossesItself = !(fit.contour.area() > 0.0) || findCrossing(fit.contour).has_value();
    return fit;
}

std::vector<double> distancesTo(const FourierFit& fit, const std::vector<Eigen::Vector2d>& points) {
    std::vector<Eigen::Vector2d> curve = chordsOf(fit.contour);
    for (Eigen::Vector2d& p : curve)
        p += fit.centre_m;
    return distancesTo(curve, points);
}

Result<FourierFit> fitFourierWithin(const Contour& outline, double tolerance_m, const ShareDone& done) {
    if (!(tolerance_m > 0.0))
        return Error{MessageCode::ValueNotPositive, {}, {formatNumber(tolerance_m * 1e3)}};
    if (outline.points_m.size() < 3)
        return Error{MessageCode::ContourTooFewPoints, {}, {std::to_string(outline.points_m.size()), "3"}};
    const std::vector<double> s = arcLengths(outline.points_m);
    const std::vector<Complex> c = project(outline.points_m, s, kMaxHarmonics);
    double min_m = 0.0;
    ShareCount count(done, kMaxHarmonics);
    for (int harmonics = 1; harmonics <= kMaxHarmonics; ++harmonics) {
        min_m = hausdorffOf(outline.points_m, truncated(c, harmonics), s.back());
        count.add();
        if (min_m > tolerance_m)
            continue;
        auto fit = fitFourier(outline, harmonics);
        if (!fit || !fit->crossesItself)
            return fit;
    }
    return Error{MessageCode::ToleranceUnreachable,
                 {},
                 {formatNumber(tolerance_m * 1e3), std::to_string(kMaxHarmonics), formatNumber(min_m * 1e3)}};
}

} // namespace bask
