// Time of one view factor by kind of source, object and pose, beside the paper's own method in the same run:
// the double contour integral by Simpson's rule with 64 x 64 points, the gradient by seven evaluations.

#include "benchmarks/fixed_disk.h"
#include "engine/radiation/interaction_matrix.h"
#include "engine/radiation/kernels/kernels.h"
#include "engine/radiation/paper_methods.h"
#include "engine/shape/contour_import.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Vector6d at(double x, double y, double z, double theta_x = 0.0) {
    Vector6d q = Vector6d::Zero();
    q << x, y, z, theta_x, 0.0, 0.0;
    return q;
}

const Vector6d kParallel = at(0.04, 0.03, 0.05); // sees the whole source
const Vector6d kTilted = at(0.04, 0.03, 0.05, 0.2);
const Vector6d kCut = at(0.0, 0.0, 0.05, 80.0 * kDegree);       // its plane cuts the source
const Vector6d kDipping = at(0.0, -0.2, 0.005, 45.0 * kDegree); // half of it below the source plane
const Vector6d kNear = at(0.10, 0.0, 0.0003);                   // over the rim, gap about 1 % of its size

const Shape kDiskSource = Disk{0.15};
const Shape kDisk = Disk{0.015};

Contour outlineFrom(const std::string& name) {
    const auto contour = readContourCsv(BASK_EXAMPLES "/contours/" + name, std::nullopt);
    if (!contour)
        throw std::runtime_error(describe(contour.error()));
    return centred(*contour);
}

Shape bunny(int harmonics) {
    return fitFourier(outlineFrom("bunny_mm.csv"), harmonics)->contour;
}

// A wavy plate of about 8 cm with four harmonics.
Shape fourierSource() {
    std::vector<std::complex<double>> c(9);
    for (int j = -4; j <= 4; ++j)
        c[static_cast<std::size_t>(j + 4)] = std::polar(0.004 / (1.0 + j * j), 1.3 * j);
    c[4] = 0.0;
    c[5] = 0.08;
    return FourierContour(c);
}

// Waves of 40 harmonics as strong as an outline can have them; seen by itself, close by and a little tilted.
Shape roughSource() {
    std::vector<std::complex<double>> c(81);
    for (int j = -40; j <= 40; ++j)
        (c.begin() + 40)[j] = std::polar(4e-5, 1.3 * j * j);
    c[40] = 0.0;
    c[41] = 0.1;
    return FourierContour(c);
}

void paperSimpson64(benchmark::State& state, const Shape& source, const Shape& object, const Vector6d& q) {
    for (auto _ : state)
        benchmark::DoNotOptimize(simpsonGradient(source, object, q, 64));
}

/// The baseline of one call, disk over disk.
void fixed32(benchmark::State& state, const Vector6d& q, bool withGradient) {
    const Pose X_SO = poseFromCoordinates(q);
    const ViewFactor exact = viewFactor(RadiatingContour(kDiskSource), RadiatingContour(kDisk), X_SO);
    double o[3], k[3];
    const auto place = [&] {
        Eigen::Map<Eigen::Vector3d>{o} = X_SO.linear().transpose() * X_SO.translation();
        Eigen::Map<Eigen::Vector3d>{k} = X_SO.linear().row(2).transpose();
    };
    place();
    const FixedDisk fixed = fixedDiskGradient(0.15, 0.015, o, k);
    const Eigen::Vector3d force = X_SO.linear() * Eigen::Map<const Eigen::Vector3d>(fixed.gradient);
    if (std::abs(fixed.value - exact.value) > 1e-9 || (force - exact.gradient.head<3>()).norm() > 1e-7) {
        state.SkipWithError("the baseline is not this view factor");
        return;
    }
    for (auto _ : state) {
        place();
        benchmark::ClobberMemory();
        if (withGradient)
            benchmark::DoNotOptimize(fixedDiskGradient(0.15, 0.015, o, k));
        else
            benchmark::DoNotOptimize(fixedDiskValue(0.15, 0.015, o, k));
    }
}

void gradient(benchmark::State& state, const Shape& source, const Shape& object, const Vector6d& q,
              double tolerance) {
    const RadiatingContour from(source), to(object);
    const Pose X_SO = poseFromCoordinates(q);
    for (auto _ : state)
        benchmark::DoNotOptimize(viewFactor(from, to, X_SO, {.tolerance = tolerance}));
}

void value(benchmark::State& state, const Shape& source, const Shape& object, const Vector6d& q,
           double tolerance) {
    const RadiatingContour from(source), to(object);
    const Pose X_SO = poseFromCoordinates(q);
    for (auto _ : state)
        benchmark::DoNotOptimize(viewFactorValue(from, to, X_SO, tolerance));
}

// The disks' F + gradient with each set of kernels that the processor can run.
void byProcessor(benchmark::State& state) {
    const kernels::KernelList list = kernels::runnableKernels();
    const kernels::Kernels& usual = kernels::kernels();
    const auto which = static_cast<int>(state.range(0));
    if (which >= list.count) {
        state.SkipWithError("not on this processor");
        return;
    }
    kernels::useKernels(*list.sets[which]);
    state.SetLabel(list.sets[which]->name);
    gradient(state, kDiskSource, kDisk, kParallel, 1e-12);
    kernels::useKernels(usual);
}

/// Even, in sectors (polygons), or in rings (disks), as many as the argument says.
RadiatingSource cutInto(int sectors, int rings) {
    std::vector<SourceTerm> terms;
    std::vector<double> factors;
    for (int k = 0; k < sectors; ++k) {
        constexpr int kChords = 12;
        Contour sector;
        sector.points_m.emplace_back(0.0, 0.0);
        for (int c = 0; c <= kChords; ++c)
            sector.points_m.push_back(
                0.1 *
                Eigen::Rotation2Dd(2.0 * std::numbers::pi * (k + static_cast<double>(c) / kChords) / sectors)
                    .toRotationMatrix()
                    .col(0));
        terms.push_back({RadiatingContour(sector)});
        factors.push_back(1.0 + 0.1 * (k % 2));
    }
    for (int k = 0; k < rings; ++k) {
        terms.push_back({RadiatingContour(Disk{0.1 * (k + 1) / rings})});
        factors.push_back(1.0 / rings);
    }
    if (terms.empty())
        return RadiatingContour(Disk{0.1});
    return {std::move(terms), std::move(factors)};
}

void matrixOfThree(benchmark::State& state, int sectors, int rings) {
    const auto mounted = [](const Shape& shape, double x, double y) {
        return MountedContour{RadiatingContour(shape), poseFromCoordinates(at(x, y, 0.0))};
    };
    const MountedObjects objects(
        {mounted(kDisk, 0.0, 0.05), mounted(bunny(5), -0.0435, -0.025),
         mounted(fitFourier(outlineFrom("hand_mm.csv"), 5)->contour, 0.0435, -0.025)});
    const RadiatingSource source = cutInto(sectors, rings);
    const Pose X_SE = poseFromCoordinates(at(0.01, 0.02, 0.10, 0.1));
    for (auto _ : state)
        benchmark::DoNotOptimize(interactionMatrix(source, objects, X_SE));
}

BENCHMARK_CAPTURE(paperSimpson64, disk, kDiskSource, kDisk, kParallel);
BENCHMARK_CAPTURE(fixed32, value, kParallel, false);
BENCHMARK_CAPTURE(fixed32, gradient, kParallel, true);
BENCHMARK_CAPTURE(gradient, disk_1e9, kDiskSource, kDisk, kParallel, 1e-9);
BENCHMARK_CAPTURE(gradient, disk_1e12, kDiskSource, kDisk, kParallel, 1e-12);
BENCHMARK_CAPTURE(value, disk_1e9, kDiskSource, kDisk, kParallel, 1e-9);
BENCHMARK_CAPTURE(value, disk_tilted_1e9, kDiskSource, kDisk, kTilted, 1e-9);
BENCHMARK_CAPTURE(gradient, disk_tilted_1e9, kDiskSource, kDisk, kTilted, 1e-9);
BENCHMARK_CAPTURE(gradient, disk_source_cut_1e9, kDiskSource, kDisk, kCut, 1e-9);
BENCHMARK_CAPTURE(gradient, disk_dipping_1e9, kDiskSource, kDisk, kDipping, 1e-9);
BENCHMARK_CAPTURE(paperSimpson64, bunny5, kDiskSource, bunny(5), kParallel);
BENCHMARK_CAPTURE(gradient, bunny5_1e9, kDiskSource, bunny(5), kParallel, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny5_source_cut_1e9, kDiskSource, bunny(5), kCut, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny5_dipping_1e9, kDiskSource, bunny(5), kDipping, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny_polygon_1e9, kDiskSource, outlineFrom("bunny_mm.csv"), kParallel, 1e-9);
BENCHMARK_CAPTURE(paperSimpson64, bunny5_fourier_source, fourierSource(), bunny(5), kParallel);
BENCHMARK_CAPTURE(gradient, bunny5_fourier_source_1e9, fourierSource(), bunny(5), kParallel, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny5_fourier_source_cut_1e9, fourierSource(), bunny(5), kCut, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny_polygon_source_1e9, outlineFrom("bunny_mm.csv"), kDisk, kParallel, 1e-9);
BENCHMARK_CAPTURE(gradient, disk_near_1e9, Disk{0.1}, Disk{0.03}, kNear, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny5_near_1e9, Disk{0.1}, bunny(5), kNear, 1e-9);
BENCHMARK_CAPTURE(gradient, bunny5_fourier_source_near_1e9, fourierSource(), bunny(5), at(0.08, 0.0, 0.0003),
                  1e-9);
BENCHMARK_CAPTURE(gradient, rough40_over_itself_cut_1e9, roughSource(), roughSource(),
                  at(0.0, 0.0, 0.001, 0.02), 1e-9);
BENCHMARK_CAPTURE(matrixOfThree, even, 0, 0);
BENCHMARK_CAPTURE(matrixOfThree, sectors6, 6, 0);
BENCHMARK_CAPTURE(matrixOfThree, sectors16, 16, 0);
BENCHMARK_CAPTURE(matrixOfThree, rings8, 0, 8);
BENCHMARK_CAPTURE(matrixOfThree, rings40, 0, 40);
BENCHMARK(byProcessor)->DenseRange(0, 2);

} // namespace
} // namespace bask
