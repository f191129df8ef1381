#include "engine/radiation/conic_roots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr std::size_t kSamples = 16;
constexpr double kSampleStep = 2.0 * std::numbers::pi / kSamples;

/// Cosines and sines of even steps of the angle and of its double.
struct Samples {
    std::array<double, kSamples> c1, s1, c2, s2;

    explicit Samples(double first) {
        for (std::size_t i = 0; i < kSamples; ++i) {
            const double angle = first + kSampleStep * static_cast<double>(i);
            c1[i] = std::cos(angle);
            s1[i] = std::sin(angle);
            c2[i] = std::cos(2.0 * angle);
            s2[i] = std::sin(2.0 * angle);
        }
    }
};

/// The polynomial about the middle between two samples as a quartic in t = tan(half the angle from there),
/// without the factor (1 + t^2)^-2.
class Quartic {
public:
    Quartic(const Conic& f, std::size_t sample) {
        static const Samples kMiddles(0.5 * kSampleStep);
        m_middle = {kMiddles.c1[sample], kMiddles.s1[sample]};
        const double c1 = f.c1 * kMiddles.c1[sample] + f.s1 * kMiddles.s1[sample];
        const double s1 = f.s1 * kMiddles.c1[sample] - f.c1 * kMiddles.s1[sample];
        const double c2 = f.c2 * kMiddles.c2[sample] + f.s2 * kMiddles.s2[sample];
        const double s2 = f.s2 * kMiddles.c2[sample] - f.c2 * kMiddles.s2[sample];
        m_a = {f.mean + c1 + c2, 2.0 * s1 + 4.0 * s2, 2.0 * f.mean - 6.0 * c2, 2.0 * s1 - 4.0 * s2,
               f.mean - c1 + c2};
    }

    double value(double t) const { return m_a[0] + t * (m_a[1] + t * (m_a[2] + t * (m_a[3] + t * m_a[4]))); }
    double slope(double t) const {
        return m_a[1] + t * (2.0 * m_a[2] + t * (3.0 * m_a[3] + t * 4.0 * m_a[4]));
    }
    double bend(double t) const { return 2.0 * m_a[2] + t * (6.0 * m_a[3] + t * 12.0 * m_a[4]); }
    Eigen::Vector2d point(double t) const {
        const double scale = 1.0 / (1.0 + t * t);
        const double c = (1.0 - t * t) * scale, s = 2.0 * t * scale;
        return {m_middle.x() * c - m_middle.y() * s, m_middle.y() * c + m_middle.x() * s};
    }

private:
    Eigen::Vector2d m_middle;
    std::array<double, 5> m_a;
};

constexpr double kHalfStep = 0.098491403357164253; // tan(pi / 32): from a middle to its samples

/// Newton's method between two points where the function has opposite signs, halving where it leaves them.
/// The error after a step is like the step's square.
constexpr double kLastStep = 1e-8;
template <class F, class Slope>
double rootBetween(const F& f, const Slope& slope, double a, double fa, double b, double fb) {
    double t = (a * fb - b * fa) / (fb - fa);
    for (int step = 0; step < 60; ++step) {
        const double value = f(t);
        ((value > 0.0) == (fa > 0.0) ? a : b) = t;
        double next = t - value / slope(t);
        const bool isNewton = next >= a && next <= b;
        if (!isNewton)
            next = 0.5 * (a + b);
        if (std::abs(next - t) < (isNewton ? kLastStep : 1e-15))
            return next;
        t = next;
    }
    return t;
}

} // namespace

ConicRoots rootsOf(const Conic& f) {
    ConicRoots roots;
    const auto found = [&roots](const Eigen::Vector2d& u) {
        if (roots.count < roots.at.size()) // more than four come from rounding only
            roots.at[roots.count++] = u;
    };
    const double most = std::sqrt(f.c1 * f.c1 + f.s1 * f.s1) + std::sqrt(f.c2 * f.c2 + f.s2 * f.s2);
    if (std::abs(f.mean) > most)
        return roots;
    static const Samples kAt(0.0);
    std::array<double, kSamples + 1> values;
    for (std::size_t i = 0; i < kSamples; ++i)
        values[i] = f.mean + f.c1 * kAt.c1[i] + f.s1 * kAt.s1[i] + f.c2 * kAt.c2[i] + f.s2 * kAt.s2[i];
    values[kSamples] = values[0];
    // Between two samples the value bends by at most so much.
    const double sag = most * 4.0 * kSampleStep * kSampleStep / 8.0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        const double here = values[i], there = values[i + 1];
        const bool changes = (here > 0.0) != (there > 0.0);
        if (!changes && std::min(std::abs(here), std::abs(there)) > sag)
            continue;
        const Quartic q(f, i);
        const auto value = [&q](double t) { return q.value(t); };
        const auto slope = [&q](double t) { return q.slope(t); };
        if (changes) {
            found(q.point(rootBetween(value, slope, -kHalfStep, here, kHalfStep, there)));
            continue;
        }
        const double slopeHere = q.slope(-kHalfStep), slopeThere = q.slope(kHalfStep);
        if (here > 0.0 ? !(slopeHere < 0.0 && slopeThere > 0.0) : !(slopeHere > 0.0 && slopeThere < 0.0))
            continue;
        const double turn = rootBetween(
            slope, [&q](double t) { return q.bend(t); }, -kHalfStep, slopeHere, kHalfStep, slopeThere);
        const double least = q.value(turn);
        if ((least > 0.0) == (here > 0.0))
            continue;
        found(q.point(rootBetween(value, slope, -kHalfStep, here, turn, least)));
        found(q.point(rootBetween(value, slope, turn, least, kHalfStep, there)));
    }
    return roots;
}

} // namespace bask
