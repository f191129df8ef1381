#include "benchmarks/fixed_disk.h"

#include <array>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr int kPoints = 32;

/// The outline of a unit disk; the steps have the same numbers, turned and times 2 pi / kPoints.
struct Circle {
    double x[kPoints], y[kPoints];
};

const Circle kCircle = [] {
    Circle circle{};
    for (int i = 0; i < kPoints; ++i) {
        circle.x[i] = std::cos(2.0 * std::numbers::pi * i / kPoints);
        circle.y[i] = std::sin(2.0 * std::numbers::pi * i / kPoints);
    }
    return circle;
}();

template <bool kGradient>
[[gnu::always_inline]] inline FixedDisk sum(double R, double r, const double (&o)[3], const double (&k)[3]) {
    const double R2 = R * R, o1 = o[0], o2 = o[1], o3 = o[2], k1 = k[0], k2 = k[1], k3 = k[2];
    double value = 0.0, f1 = 0.0, f2 = 0.0, f3 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
    for (int i = 0; i < kPoints; ++i) {
        const double x = r * kCircle.x[i], y = r * kCircle.y[i], dx = -y, dy = x;
        const double p1 = o1 + x, p2 = o2 + y;
        const double square = p1 * p1 + p2 * p2 + o3 * o3;
        const double z = k1 * p1 + k2 * p2 + k3 * o3;
        const double a = square + R2, t = square - R2;
        const double s = std::sqrt(t * t + 4.0 * R2 * z * z);
        const double step = k2 * o3 * dx - k1 * o3 * dy + k3 * (p1 * dy - p2 * dx);
        if constexpr (!kGradient) {
            value += step / (a + s);
        } else {
            const double both = 1.0 / (s * (a + s));
            const double u = s * both, v = (a + s) * both;
            const double gz = -2.0 * z * both;
            const double h = 2.0 * u * (1.0 - (square - z * z) * (s + t) * both - z * z * v);
            const double b3 = h * k3 - gz * o3;
            const double d1 = dy * b3, d2 = -dx * b3;
            const double d3 = dx * (h * k2 - gz * p2) - dy * (h * k1 - gz * p1);
            value += step * u;
            f1 += d1;
            f2 += d2;
            f3 += d3;
            t1 += y * d3;
            t2 -= x * d3;
            t3 += x * d2 - y * d1;
        }
    }
    const double perSum = R2 / (r * r) * 2.0 / kPoints; // R2 / area * 2 pi / points
    return {perSum * value, {perSum * f1, perSum * f2, perSum * f3, perSum * t1, perSum * t2, perSum * t3}};
}

using Sum = FixedDisk (*)(double R, double r, const double (&o)[3], const double (&k)[3]);

FixedDisk baselineValue(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<false>(R, r, o, k);
}
FixedDisk baselineGradient(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<true>(R, r, o, k);
}

#if defined(__x86_64__)
#define BASK_AVX2 [[gnu::target("avx2,fma")]]
#define BASK_AVX512 [[gnu::target("avx512f,avx512dq,avx512vl,avx512bw,fma,prefer-vector-width=512")]]

BASK_AVX2 FixedDisk avx2Value(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<false>(R, r, o, k);
}
BASK_AVX2 FixedDisk avx2Gradient(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<true>(R, r, o, k);
}
BASK_AVX512 FixedDisk avx512Value(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<false>(R, r, o, k);
}
BASK_AVX512 FixedDisk avx512Gradient(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return sum<true>(R, r, o, k);
}

std::array<Sum, 2> newest() {
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw"))
        return {avx512Value, avx512Gradient};
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return {avx2Value, avx2Gradient};
    return {baselineValue, baselineGradient};
}
#else
std::array<Sum, 2> newest() {
    return {baselineValue, baselineGradient};
}
#endif

const std::array<Sum, 2> kNewest = newest();

} // namespace

double fixedDiskValue(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return kNewest[0](R, r, o, k).value;
}

FixedDisk fixedDiskGradient(double R, double r, const double (&o)[3], const double (&k)[3]) {
    return kNewest[1](R, r, o, k);
}

} // namespace bask
