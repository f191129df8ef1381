#pragma once
// How many points of a disk's outline are enough over a whole disk.
//
// On the outline of a disk of radius r, at the angle phi, the field of a whole disk of radius R is singular
// where S = 0 (kernels/terms.h). With o and k of kernels::WholeDisk and z = k . o
//     S^2 = T conj(T) for real phi,   T = t + 2iRz(phi) = c0 + c e^(i phi) + d e^(-i phi),
//     c0 = |o|^2 + r^2 - R^2 + 2iRz,   c, d = r (o1 -+ i o2 + iR (k1 -+ i k2)).
// The zeros of T are those of a quadratic in e^(i phi), so that the half width b of the strip without a
// singularity is known: with m = max(|c|, |d|)
//     cosh 2b >= (|c0|^2 + |c0^2 - 4cd|)/(4 m^2),
// equal where |c| = |d|, as for parallel disks. The trapezoidal rule converges as outline_integral.h says.

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {

/// Lengths up to this do not overflow in stripCosh().
inline constexpr double kFarthestStrip_m = 1e15;

/// Returns a lower bound of cosh 2b; where it is less than one there is no strip, or none is known.
inline double stripCosh(double R, double r, double o1, double o2, double o3, double k1, double k2, double z) {
    const double real = o1 * o1 + o2 * o2 + o3 * o3 + r * r - R * R;
    const double imag = 2.0 * R * z;
    const double q1 = R * k1, q2 = R * k2;
    const double c1 = o1 + q2, c2 = q1 - o2, d1 = o1 - q2, d2 = q1 + o2; // c/r and d/r
    const double twice2 = 4.0 * r * r;
    const double root1 = std::abs(real * real - imag * imag - twice2 * (c1 * d1 - c2 * d2));
    const double root2 = std::abs(2.0 * real * imag - twice2 * (c1 * d2 + c2 * d1));
    // A complex number is at least as large as this, and by less than a tenth larger.
    const double root = std::max(std::max(root1, root2), 0.7071 * (root1 + root2));
    return (real * real + imag * imag + root) /
           (twice2 * std::max(c1 * c1 + c2 * c2, d1 * d1 + d2 * d2) + std::numeric_limits<double>::min());
}

/// Returns exp(2b), or nearly without a root: a lower bound that is good where the strip is wide.
inline double stripExp(double cosh2b) {
    return cosh2b + std::sqrt(std::max(cosh2b * cosh2b - 1.0, 0.0));
}
inline double wideStripExp(double cosh2b) {
    return 2.0 * cosh2b - 1.0;
}

/// The smallest rule, of a multiple of kStep points, whose error is small enough; without logarithms.
template <int kStep> struct DiskRule {
    static_assert(kStep == 4 || kStep == 8);

    /// The error is `bound` divided by `gain`, which is exp((n - 2) b) for n points. More than `maxPoints`:
    /// none of as many is enough.
    DiskRule(double exp2b, double bound, double allowed, int maxPoints) {
        constexpr double kKeepAway = 0.81; // of exp(2b): at a singularity the moments are infinite
        const double square = kKeepAway * std::min(exp2b, 1e20); // above the centre it is infinite
        const double four = square * square;
        const double step = kStep == 4 ? four : four * four;
        gain = kStep == 4 ? square : four * square;
        while (!(gain * allowed >= bound) && points <= maxPoints) {
            gain *= step;
            points += kStep;
        }
    }

    int points = kStep;
    double gain = 0.0;
};

} // namespace bask
