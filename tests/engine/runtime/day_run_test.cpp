// Memory of a recorded run, as fast as the machine goes: at 10 Hz, and at 1 Hz with a picture of the thermal
// camera each second. Minutes of it in CI, a day of each by hand (`ctest -L soak -R day`).

#include "engine/experiment/experiment_file.h"
#include "engine/runtime/simulated_run.h"
#include "tests/support/sanitized.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <cstdio>
#include <ctime>
#include <fstream>

#include <unistd.h>

namespace bask {
namespace {

double resident_MB() {
    std::ifstream in("/proc/self/statm");
    double all = 0.0, resident = 0.0;
    in >> all >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

Experiment atTenHertz() {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    EXPECT_TRUE(experiment) << describe(experiment.error());
    experiment->sampling.period_s = 0.1;
    return *experiment;
}

/// The smallest camera: what piles up is seen, and most of the time is not spent on rendering.
Experiment withPictures() {
    auto experiment = readExperiment(BASK_EXAMPLES "/two-circles.json");
    EXPECT_TRUE(experiment) << describe(experiment.error());
    experiment->sampling.period_s = 1.0;
    experiment->sampling.thermalFramePeriod_s = 1.0;
    experiment->simulation.thermalCamera.emplace().profile = "lepton-3.5";
    return *experiment;
}

struct DayRecord {
    std::vector<double> memory_MB; ///< after each `every_s`
    int samples = 0, pictures = 0;
};

DayRecord recorded(const Experiment& experiment, double duration_s, double every_s) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("day.bask"));
    DayRecord out;
    SimulatedRunOptions options;
    options.duration_s = duration_s;
    options.sessionPath = path.toStdString();
    options.progress = [&](double time_s, const TraceSample&) {
        ++out.samples;
        if (time_s + 0.05 < every_s * static_cast<double>(out.memory_MB.size() + 1))
            return;
        out.memory_MB.push_back(resident_MB());
        std::printf("%.2f h: %.2f MB\n", time_s / 3600.0, out.memory_MB.back());
        std::fflush(stdout); // a day takes a while
    };
    const std::clock_t start = std::clock();
    const auto outcome = runSimulated(experiment, options);
    const double spent_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_TRUE(outcome) << describe(outcome.error());
    if (outcome) {
        EXPECT_FALSE(outcome->fault);
    }
    EXPECT_TRUE(readThermalFrames(options.sessionPath, [&](double, const std::string&) { ++out.pictures; }));
    std::printf("%d samples, %d pictures, a file of %.1f MB, %.0f s of processor time\n", out.samples,
                out.pictures, static_cast<double>(QFileInfo(path).size()) / 1e6, spent_s);
    EXPECT_GE(out.samples, duration_s / experiment.sampling.period_s);
    return out;
}

} // namespace

// Catches samples, events or pages that pile up in memory.
TEST(DayRun, halfAnHour) {
    const auto memory_MB = recorded(atTenHertz(), 1800.0, 300.0).memory_MB;
    ASSERT_EQ(memory_MB.size(), 6u);
    if (!test::kIsSanitized) { // the address sanitizer keeps freed memory for a while
        EXPECT_LT(memory_MB.back() - memory_MB[1], 1.0);
    }
}

// Catches pictures that pile up: of the last 400, the PNG would take 7 MB, the temperatures 61 MB.
TEST(DayRun, tenMinutesWithPictures) {
    const DayRecord record = recorded(withPictures(), 600.0, 100.0);
    ASSERT_EQ(record.memory_MB.size(), 6u);
    EXPECT_GE(record.pictures, 600);
    if (!test::kIsSanitized) {
        EXPECT_LT(record.memory_MB.back() - record.memory_MB[1], 2.0);
    }
}

TEST(DayRun, day) {
    const auto memory_MB = recorded(atTenHertz(), 24.0 * 3600.0, 3600.0).memory_MB;
    ASSERT_EQ(memory_MB.size(), 24u);
    EXPECT_LT(memory_MB.back() - memory_MB.front(), 1.0);
}

TEST(DayRun, dayWithPictures) {
    const DayRecord record = recorded(withPictures(), 24.0 * 3600.0, 3600.0);
    ASSERT_EQ(record.memory_MB.size(), 24u);
    EXPECT_GE(record.pictures, 24 * 3600);
    EXPECT_LT(record.memory_MB.back() - record.memory_MB.front(), 2.0);
}

} // namespace bask
