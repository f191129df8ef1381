#pragma once
// A session of a day at 10 Hz with three objects, recorded for measurements, and watches to measure with.

#include "engine/recording/session_file.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include <malloc.h>
#include <unistd.h>

namespace bask::benchmarks {

inline constexpr int kHour = 36'000; // samples
inline constexpr int kDay = 24 * kHour;
inline constexpr double kPeriod_s = 0.1;
inline constexpr int kSpike = 500'123;
inline constexpr double kSpike_K = 360.0;

inline Experiment threeDisks() {
    Experiment experiment;
    for (const char* name : {"circle", "bunny", "hand"}) {
        ObjectSpec object;
        object.name = name;
        object.shape = Disk{0.015};
        object.mounting[kX] = 0.06 * static_cast<double>(experiment.objects.size());
        experiment.objects.push_back(object);
    }
    return experiment;
}

/// Every number has all its digits; a source that is followed never lies quite still.
inline TraceSample sampleOf(const Experiment& experiment, int k, bool isFollowed, std::mt19937& random) {
    std::normal_distribution<double> noise(0.0, 0.02);
    TraceSample sample;
    sample.time_s = kPeriod_s * (k + 1) + 1e-4 * noise(random);
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const double x = 2e-4 * k + static_cast<double>(i);
        ObjectSample object;
        object.true_K = 313.15 + 8.0 * std::sin(x);
        object.measured_K = k == kSpike && i == 1 ? kSpike_K : object.true_K + noise(random);
        object.estimated_K = object.true_K + 0.1 * noise(random);
        object.rate_K_s = 0.01 * noise(random);
        object.target_K = k < kDay / 2 ? 313.15 : 318.15;
        object.viewFactor = 0.3 + 0.1 * std::cos(x);
        object.lambda1 = 0.2 + noise(random);
        object.lambda2 = 1e-11 * (1.0 + noise(random));
        object.valid = true;
        sample.objects.push_back(object);
    }
    sample.coordinates << 0.1 * std::sin(1e-3 * k), 0.05, 0.3 + 0.01 * noise(random), 0.1,
        0.2 * std::sin(2e-3 * k), 0.3;
    for (int j = 0; j < 6; ++j)
        sample.twist[j] = 0.1 * noise(random);
    sample.source_K = 473.15 + noise(random);
    sample.source = experiment.source.pose;
    if (isFollowed)
        for (int j = 0; j < 6; ++j)
            sample.source[j] += 1e-3 * noise(random);
    sample.smallestSingularValue = 0.1 + 0.01 * noise(random);
    return sample;
}

/// `commit`: after so many samples.
inline bool record(const std::string& path, int samples, int commit, bool isFollowed) {
    const Experiment experiment = threeDisks();
    std::mt19937 random(1);
    auto writer = SessionWriter::create(path, experiment, true, 1e6, SessionWriter::Earlier::Replaced);
    for (int k = 0; writer && k < samples; ++k)
        if (!(*writer)->add(sampleOf(experiment, k, isFollowed, random)) ||
            (k % commit == 0 && !(*writer)->flush()))
            return false;
    return writer && (*writer)->finish("settled");
}

/// The day, recorded once; where the variable BASK_DAY_SESSION names a file, there, and kept.
struct DayFile {
    QTemporaryDir folder;
    std::string path =
        qEnvironmentVariable("BASK_DAY_SESSION", folder.filePath(QStringLiteral("day.bask"))).toStdString();
    bool isThere = QFile::exists(QString::fromStdString(path)) || record(path, kDay, 1000, false);
};

inline const DayFile& day() {
    static const DayFile file;
    return file;
}

/// Of this process.
inline double resident_MB() {
    malloc_trim(0);
    std::ifstream in("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    in >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) * 1e-6;
}

/// Of wall and of processor: the machine may have other work.
class Stopwatch {
public:
    Stopwatch() { m_wall.start(); }
    double wall_ms() const { return 1e-6 * static_cast<double>(m_wall.nsecsElapsed()); }
    double cpu_ms() const { return 1e3 * static_cast<double>(std::clock() - m_cpu) / CLOCKS_PER_SEC; }

private:
    QElapsedTimer m_wall;
    std::clock_t m_cpu = std::clock();
};

struct Times {
    std::vector<double> wall_ms, cpu_ms;

    void add(const Stopwatch& watch) {
        cpu_ms.push_back(watch.cpu_ms());
        wall_ms.push_back(watch.wall_ms());
    }
    void tell(benchmark::State& state) {
        for (auto* times : {&wall_ms, &cpu_ms}) {
            std::ranges::sort(*times);
            const std::string which = times == &wall_ms ? "wall" : "cpu";
            const auto at = [&](double p) {
                return (*times)[static_cast<std::size_t>(p * static_cast<double>(times->size() - 1))];
            };
            state.counters[which + "_median_ms"] = at(0.5);
            state.counters[which + "_p99_ms"] = at(0.99);
            state.counters[which + "_worst_ms"] = times->back();
            state.counters[which + "_per_s"] =
                1e3 * static_cast<double>(times->size()) / std::accumulate(times->begin(), times->end(), 0.0);
        }
    }
};

} // namespace bask::benchmarks
