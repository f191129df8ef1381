// Memory of a recorded run at 10 Hz, as fast as the machine goes: half an hour in CI, a day by hand (`ctest
// -L soak -R day`).

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

/// Memory after each `every_s` of a run of `duration_s`, MB.
std::vector<double> memoryOfRun(double duration_s, double every_s) {
    auto experiment = readExperiment(BASK_EXAMPLES "/three-objects.json");
    EXPECT_TRUE(experiment) << describe(experiment.error());
    experiment->sampling.period_s = 0.1;
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("day.bask"));
    std::vector<double> memory_MB;
    std::size_t samples = 0;
    SimulatedRunOptions options;
    options.duration_s = duration_s;
    options.sessionPath = path.toStdString();
    options.progress = [&](double time_s, const TraceSample&) {
        ++samples;
        if (time_s + 0.05 < every_s * static_cast<double>(memory_MB.size() + 1))
            return;
        memory_MB.push_back(resident_MB());
        std::printf("%.1f h: %.2f MB\n", time_s / 3600.0, memory_MB.back());
        std::fflush(stdout); // a day takes a while
    };
    const std::clock_t start = std::clock();
    const auto outcome = runSimulated(*experiment, options);
    const double spent_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_TRUE(outcome) << describe(outcome.error());
    if (outcome) {
        EXPECT_FALSE(outcome->fault);
    }
    std::printf("%zu samples, a file of %.1f MB, %.0f s of processor time\n", samples,
                static_cast<double>(QFileInfo(path).size()) / 1e6, spent_s);
    EXPECT_GE(static_cast<double>(samples), 10.0 * duration_s);
    return memory_MB;
}

} // namespace

// Catches samples, events or pages that pile up in memory.
TEST(DayRun, halfAnHour) {
    const auto memory_MB = memoryOfRun(1800.0, 300.0);
    ASSERT_EQ(memory_MB.size(), 6u);
    if (!test::kIsSanitized) { // the address sanitizer keeps freed memory for a while
        EXPECT_LT(memory_MB.back() - memory_MB[1], 1.0);
    }
}

TEST(DayRun, day) {
    const auto memory_MB = memoryOfRun(24.0 * 3600.0, 3600.0);
    ASSERT_EQ(memory_MB.size(), 24u);
    EXPECT_LT(memory_MB.back() - memory_MB.front(), 1.0);
}

} // namespace bask
