// What a thermal picture costs. To be met: a frame of 256 x 192 to the temperatures of three objects in less
// than 5 ms, from the camera's bytes and as a rig does it (frameOfARig); a stored frame in less than 60 % of
// 16 bits a pixel (storedFrame); memory that stays as it is over a day of a run which records a frame each
// second (recordedHours).

#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/camera_thermometer.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/face_temperature.h"
#include "engine/thermography/frame_decoder.h"
#include "engine/thermography/frame_picture_file.h"
#include "engine/thermography/region_statistics.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <fstream>
#include <random>

#include <unistd.h>

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

/// Decodes a new frame of the same bytes whenever it is asked.
class CameraOfBytes final : public ThermalCamera {
public:
    CameraOfBytes(const ThermalProfile& profile, std::string bytes, const Clock& clock)
        : m_profile(profile), m_bytes(std::move(bytes)), m_clock(clock) {}
    Result<std::shared_ptr<const ThermalCameraFrame>> newest() override {
        auto frame = std::make_shared<ThermalCameraFrame>();
        frame->time_s = m_clock.now_s();
        frame->number = ++m_number;
        frame->frame = frameOfBytes(m_bytes, m_profile, "benchmark").value();
        return std::shared_ptr<const ThermalCameraFrame>(std::move(frame));
    }
    const ThermalProfile& profile() const override { return m_profile; }

private:
    ThermalProfile m_profile;
    std::string m_bytes;
    const Clock& m_clock;
    std::uint64_t m_number = 0;
};

/// Three objects of 5 cm below a camera half a metre above them.
Experiment nearExperiment() {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    const double x_m[] = {-0.11, 0.0, 0.11};
    for (std::size_t i = 0; i < 3; ++i) {
        ObjectSpec& object = experiment.objects[i];
        object.shape = i == 1 ? Shape(blob()) : Shape(Disk{0.05});
        object.mounting = Vector6d::Zero();
        object.mounting[0] = x_m[i];
    }
    experiment.simulation.thermalCamera->pose = coordinatesFromPose(lookingAt({0.02, 0.01, 0.65}, {0, 0, 0}));
    return experiment;
}

enum Phase { kHot, kCold, kVague };

/// All that is done on the engine's thread for one frame: decoding, view factors, the pixels of each object,
/// their statistics and temperatures. Cold: the camera is zeroed anew with each frame. Vague: one object is
/// too small for how well the camera's place is known.
void frameOfARig(benchmark::State& state) {
    Experiment experiment = nearExperiment();
    if (state.range(0) == kVague)
        experiment.objects[2].shape = Disk{0.008};
    SimulatedRig rig(simulatedRigConfig(experiment));
    const PlacedThermalCamera placed = believedThermalCamera(experiment, true).value();
    CameraThermometerSetup setup;
    setup.camera = placed.lens;
    setup.X_RC = placed.X_RC;
    if (state.range(0) == kVague)
        setup.sight = {0.002, 0.002};
    setup.hasShutter = true;
    setup.objects = experiment.objects;
    setup.source = experiment.source.shape;
    setup.geometry = rigGeometry(experiment);
    setup.reflecting = reflectingRig(experiment);
    setup.environment_K = experiment.environment_K;
    rig.advance(1.0);
    const ThermalProfile profile = rig.thermalCamera()->profile();
    const ThermalPicture picture = rig.thermalCamera()->newest().value()->frame.picture;
    CameraOfBytes camera(profile, bytesOfFrame(picture, profile), rig.clock());
    CameraThermometer thermometer(setup, camera, rig.robot(), rig.heatSource(), rig.clock());
    (void)thermometer.read();
    if (state.range(0) != kCold)
        for (int k = 0; k < 60; ++k) {
            (void)rig.heatSource().keepHeating(473.15, 10.0);
            rig.advance(1.0);
        }
    int valid = 0;
    for (auto _ : state) {
        const std::vector<Reading> readings = thermometer.read().value();
        valid = static_cast<int>(std::ranges::count_if(readings, &Reading::valid));
    }
    state.counters["read"] = valid;
}
BENCHMARK(frameOfARig)->ArgName("phase")->Arg(kHot)->Arg(kCold)->Arg(kVague)->Unit(benchmark::kMillisecond);

void decoding(benchmark::State& state) {
    const ThermalProfile profile = findThermalProfile("p2-pro").value();
    const std::string bytes = frameBytes(profile);
    for (auto _ : state) {
        auto frame = frameOfBytes(bytes, profile, "frame");
        benchmark::DoNotOptimize(frame);
    }
}
BENCHMARK(decoding)->Unit(benchmark::kMillisecond);

/// A picture of the thermal-camera example a minute after Start, as a session and a folder of TIFF keep it.
void storedFrame(benchmark::State& state) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    experiment.simulation.thermalCamera->profile = state.range(0) == 0 ? "lepton-3.5" : "p2-pro";
    SimulatedRig rig(simulatedRigConfig(experiment));
    for (int k = 0; k < 60; ++k) {
        (void)rig.heatSource().keepHeating(473.15, 10.0);
        rig.advance(1.0);
    }
    const ThermalProfile& profile = rig.thermalCamera()->profile();
    const ThermalPicture picture = rig.thermalCamera()->newest().value()->frame.picture;
    std::string png;
    for (auto _ : state)
        png = pngOfCounts(countsOfPicture(picture, profile));
    if (frameOfImage(png, profile, "stored").value().picture != picture)
        return state.SkipWithError("a pixel is lost");
    const double plain = 2.0 * profile.width * profile.height;
    state.counters["png_percent"] = 100.0 * static_cast<double>(png.size()) / plain;
    state.counters["tiff_percent"] =
        100.0 * static_cast<double>(tiffOfCounts(countsOfPicture(picture, profile)).size()) / plain;
}
BENCHMARK(storedFrame)->ArgName("p2_pro")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

double resident_MB() {
    std::ifstream in("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    in >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

/// The thermal-camera example, recorded with a frame of the P2 Pro each second, as fast as the machine goes.
/// By what memory grows after its first sixth; 24 hours take half an hour.
void recordedHours(benchmark::State& state) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    experiment.sampling.thermalFramePeriod_s = 1.0;
    const double duration_s = 3600.0 * static_cast<double>(state.range(0));
    for (auto _ : state) {
        const QTemporaryDir folder;
        SimulatedRunOptions options;
        options.duration_s = duration_s;
        options.sessionPath = folder.filePath(QStringLiteral("day.bask")).toStdString();
        double first_MB = 0.0, most_MB = 0.0;
        options.progress = [&](double time_s, const TraceSample&) {
            if (time_s < duration_s / 6.0)
                first_MB = resident_MB();
            else
                most_MB = std::max(most_MB, resident_MB());
        };
        if (const auto outcome = runSimulated(experiment, options); !outcome || outcome->fault)
            return state.SkipWithError("the run did not go on");
        state.counters["first_MB"] = first_MB;
        state.counters["grown_MB"] = most_MB - first_MB;
        state.counters["file_MB"] =
            1e-6 * static_cast<double>(QFileInfo(QString::fromStdString(options.sessionPath)).size());
        state.counters["frames"] = 0;
        (void)readThermalFrames(options.sessionPath,
                                [&](double, const std::string&) { state.counters["frames"] += 1; });
    }
}
BENCHMARK(recordedHours)->ArgName("hours")->Arg(1)->Arg(24)->Unit(benchmark::kSecond)->Iterations(1);

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    const QCoreApplication application(argc, argv); // Qt's SQL drivers need one
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
