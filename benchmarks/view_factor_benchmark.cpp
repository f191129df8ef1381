// Time of one view factor, by kind of object and pose, beside a plain double contour integral in the same
// run.

#include "engine/radiation/view_factor.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace bask {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
const RadiatingContour kSource(Disk{0.15});

Shape disk() {
    return Disk{0.015};
}

Shape fourier() {
    std::vector<std::complex<double>> c(11);
    for (int j = -5; j <= 5; ++j)
        c[static_cast<std::size_t>(j + 5)] = std::polar(0.002 / (1.0 + j * j), 1.3 * j);
    c[5] = 0.0;
    c[6] = 0.02;
    return FourierContour(c);
}

Shape polygon() {
    Contour contour;
    for (int i = 0; i < 60; ++i) {
        const double r = 0.02 + 0.003 * std::sin(3.0 * kTwoPi * i / 60);
        contour.points_m.emplace_back(r * std::cos(kTwoPi * i / 60), r * std::sin(kTwoPi * i / 60));
    }
    return contour;
}

Pose ordinary() {
    return poseFromRotationVector({0.03, -0.02, 0.08}, {0.2, 0.1, 0.3});
}
Pose sourceCut() {
    return poseFromRotationVector({0.03, -0.02, 0.08}, {0.9, 0.1, 0.3});
}
Pose objectCut() {
    return poseFromRotationVector({0.0, -0.2, 0.005}, {0.7, 0.1, 0.3});
}

void withGradient(benchmark::State& state, const Shape& shape, const Pose& X_SO) {
    const RadiatingContour object(shape);
    for (auto _ : state)
        benchmark::DoNotOptimize(viewFactor(kSource, object, X_SO));
}

void valueOnly(benchmark::State& state, const Shape& shape, const Pose& X_SO) {
    const RadiatingContour object(shape);
    for (auto _ : state)
        benchmark::DoNotOptimize(viewFactorValue(kSource, object, X_SO));
}

// The baseline: trapezoidal rule over both contours, 64 x 64 logarithms, value only, tables made beforehand.
void doubleContour64x64(benchmark::State& state) {
    constexpr int kPoints = 64;
    std::vector<Eigen::Vector3d> s(kPoints), ds(kPoints), q(kPoints), dq(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        const double angle = kTwoPi * i / kPoints;
        s[i] = {0.15 * std::cos(angle), 0.15 * std::sin(angle), 0.0};
        ds[i] = Eigen::Vector3d(-s[i].y(), s[i].x(), 0.0) * (kTwoPi / kPoints);
        q[i] = s[i] / 10.0;
        dq[i] = ds[i] / 10.0;
    }
    const double area = std::numbers::pi * 0.015 * 0.015;
    const Pose X_SO = ordinary();
    for (auto _ : state) {
        double sum = 0.0;
        for (int i = 0; i < kPoints; ++i) {
            const Eigen::Vector3d p = X_SO * q[i];
            const Eigen::Vector3d dp = X_SO.linear() * dq[i];
            for (int k = 0; k < kPoints; ++k)
                sum += 0.5 * std::log((p - s[k]).squaredNorm()) * ds[k].dot(dp);
        }
        benchmark::DoNotOptimize(-sum / (kTwoPi * area));
    }
}

BENCHMARK(doubleContour64x64)->Name("baseline/double_contour_64x64/value");
BENCHMARK_CAPTURE(valueOnly, disk, disk(), ordinary());
BENCHMARK_CAPTURE(valueOnly, fourier, fourier(), ordinary());
BENCHMARK_CAPTURE(valueOnly, polygon60, polygon(), ordinary());
BENCHMARK_CAPTURE(valueOnly, disk_source_cut, disk(), sourceCut());
BENCHMARK_CAPTURE(valueOnly, disk_object_cut, disk(), objectCut());
BENCHMARK_CAPTURE(withGradient, disk, disk(), ordinary());
BENCHMARK_CAPTURE(withGradient, fourier, fourier(), ordinary());
BENCHMARK_CAPTURE(withGradient, polygon60, polygon(), ordinary());
BENCHMARK_CAPTURE(withGradient, disk_source_cut, disk(), sourceCut());
BENCHMARK_CAPTURE(withGradient, fourier_source_cut, fourier(), sourceCut());
BENCHMARK_CAPTURE(withGradient, disk_object_cut, disk(), objectCut());
BENCHMARK_CAPTURE(withGradient, fourier_object_cut, fourier(), objectCut());

} // namespace
} // namespace bask
