// What a thermal picture costs. To be met: a frame of 256 x 192 to the temperatures of three objects in less
// than 5 ms.

#include "engine/base/units.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/face_temperature.h"
#include "engine/thermography/frame_decoder.h"
#include "engine/thermography/region_statistics.h"

#include <benchmark/benchmark.h>

#include <random>

namespace {

using namespace bask;

void radiance(benchmark::State& state) {
    const BandRadiance& band = thermalBand();
    double T_K = 280.0, sum = 0.0;
    for (auto _ : state) {
        sum += band.radiance(T_K);
        T_K = T_K < 580.0 ? T_K + 0.37 : 280.0;
    }
    benchmark::DoNotOptimize(sum);
}
BENCHMARK(radiance);

void temperature(benchmark::State& state) {
    const BandRadiance& band = thermalBand();
    double L = 30.0, sum = 0.0;
    for (auto _ : state) {
        sum += band.temperature(L);
        L = L < 500.0 ? L + 0.37 : 30.0;
    }
    benchmark::DoNotOptimize(sum);
}
BENCHMARK(temperature);

/// A frame of the P2 Pro: noise about 40 degC.
std::string frameBytes(const ThermalProfile& profile) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal(64.0 * kelvinFromCelsius(40.0), 3.0);
    std::string bytes;
    for (int k = 0; k < profile.width * (profile.skipTop + profile.height); ++k) {
        const auto number = static_cast<unsigned>(normal(random));
        bytes += static_cast<char>(number & 0xFF);
        bytes += static_cast<char>(number >> 8);
    }
    return bytes;
}

CameraModel camera() {
    CameraModel out;
    out.width = 256;
    out.height = 192;
    out.fx = out.fy = 250.0;
    out.cx = 127.5;
    out.cy = 95.5;
    out.distortion = {-0.3, 0.1, 0.001, -0.001, 0.0};
    return out;
}

FourierContour blob() {
    std::vector<std::complex<double>> coefficients(11);
    coefficients[6] = 0.05;
    coefficients[3] = 0.006;
    coefficients[9] = 0.003;
    return FourierContour(coefficients);
}

/// Bytes to the temperatures of three objects with their uncertainties, before a hot source that they hide in
/// part.
void threeObjects(benchmark::State& state) {
    const ThermalProfile profile = findThermalProfile("p2-pro").value();
    const std::string bytes = frameBytes(profile);
    const PixelRays rays(camera());
    const auto at = [](double x, double y, double z, double tilt_rad) {
        return poseFromRotationVector({x, y, z}, {tilt_rad, 0.2, 0.0});
    };
    const std::vector<PlacedPlate> objects{{blob(), at(-0.07, 0.0, 0.4, 0.3)},
                                           {Disk{0.05}, at(0.06, 0.03, 0.42, -0.2)},
                                           {blob(), at(0.0, -0.05, 0.5, 0.1)}};
    const std::vector<PlacedPlate> screens{{Disk{0.3}, at(0.0, 0.0, 0.9, 0.0)}};
    const FaceSurroundings face{0.9, {{0.3, 473.15, 0.25}}, 298.15};
    ReadingUncertainty uncertainty{
        .offset_K = 0.1, .emittance = 0.01, .T_env_K = 0.5, .surfaces = {{0.01, 2.0, 0.02}}};
    std::size_t pixels = 0;
    for (auto _ : state) {
        const auto frame = frameOfBytes(bytes, profile, "frame");
        pixels = 0;
        for (const auto& seen : facePixels(rays, Pose::Identity(), objects, screens)) {
            const auto statistics = regionStatistics(frame->picture, seen->pixels);
            uncertainty.pixels_K = statistics->standardError_K;
            auto reading = readFace(thermalBand(), face, statistics->mean_K, uncertainty);
            benchmark::DoNotOptimize(reading);
            pixels += seen->pixels.size();
        }
    }
    state.counters["pixels"] = static_cast<double>(pixels);
}
BENCHMARK(threeObjects)->Unit(benchmark::kMillisecond);

void decoding(benchmark::State& state) {
    const ThermalProfile profile = findThermalProfile("p2-pro").value();
    const std::string bytes = frameBytes(profile);
    for (auto _ : state) {
        auto frame = frameOfBytes(bytes, profile, "frame");
        benchmark::DoNotOptimize(frame);
    }
}
BENCHMARK(decoding)->Unit(benchmark::kMillisecond);

} // namespace
