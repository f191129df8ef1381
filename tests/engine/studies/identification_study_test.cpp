// Whether the standard errors of identified rates are those of recorded runs: of the three-object example
// with its level servo, whose readings are rounded to a tenth of a kelvin, noisy and zeroed.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/recording/session_identification.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace bask {
namespace {

/// Convection of the simulated air, and what the experiment says of it.
struct Scenario {
    const char* name;
    double convection_W_m2K;
    Air air;
};

struct Coverage {
    int runs = 0, covered = 0;
    double bias = 0.0, square = 0.0, stated = 0.0; ///< relative to the truth, sums

    void add(const Estimate& estimate, double truth) {
        const double off = estimate.value - truth;
        ++runs;
        covered += std::abs(off) <= 2.0 * estimate.standardError ? 1 : 0;
        bias += off / truth;
        square += std::pow(off / truth, 2);
        stated += estimate.standardError / std::abs(truth);
    }
    void add(const Coverage& other) {
        runs += other.runs;
        covered += other.covered;
    }
    double share() const { return static_cast<double>(covered) / runs; }
    double meanError() const { return stated / runs; }
    void print(const std::string& name) const {
        std::printf(
            "%-24s %5d intervals, 2 sigma cover %.1f %%; bias %+.3f %%, scatter %.3f %%, stated %.3f %%\n",
            name.c_str(), runs, 100.0 * share(), 100.0 * bias / runs,
            100.0 * std::sqrt(square / runs - std::pow(bias / runs, 2)), 100.0 * stated / runs);
    }
};

using Coverages = std::map<std::string, Coverage>;

/// lambda1 and lambda2 where the air is known; lambda1 alone, the loss and its slope where it is not, of a
/// fit with convection.
void addRun(Coverages& out, const Experiment& experiment, const std::string& path) {
    SimulatedRunOptions options;
    options.sessionPath = path;
    options.mayReplace = true;
    const auto run = runSimulated(experiment, options);
    ASSERT_TRUE(run) << describe(run.error());
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    HeatRecords records(*session);
    for (const TraceSample& sample : session->samples)
        records.add(sample);
    const bool isKnown = experiment.air.isKnown();
    const std::vector<IdentifiedRates> found = records.identify({false, !isKnown});
    const std::vector<HeatRates> truth = trueRates(experiment);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const IdentifiedRates& fit = found[i];
        if (isKnown) {
            ASSERT_TRUE(fit.usable()) << describe(fit.reason);
        }
        out["lambda1"].add(fit.lambda1, truth[i].lambda1);
        if (isKnown)
            out["lambda2"].add(fit.lambda2, truth[i].lambda2);
        // Readings are zeroed to one another, not to the truth: the loss is told at the same height over the
        // room.
        const double room_K = experiment.environment_K;
        const double measuredRoom_K = std::pow(fit.lambda3.value / fit.lambda2.value, 0.25);
        const double T_K = fit.workingTemperature_K - measuredRoom_K + room_K;
        out["loss"].add(fit.loss, -truth[i].rate_K_s(0.0, T_K));
        out["loss slope"].add(fit.lossSlope, truth[i].lossSlope_1_s(T_K));
    }
}

Coverages coverages(const Scenario& scenario, std::uint64_t seeds) {
    const QTemporaryDir folder;
    Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
    experiment.simulation.convection_W_m2K = scenario.convection_W_m2K;
    if (scenario.convection_W_m2K > 0.0)
        experiment.source.emittance = 0.9; // a weak source does not hold the targets against the air
    experiment.air = scenario.air;
    Coverages out;
    for (std::uint64_t seed = 1; seed <= seeds && !testing::Test::HasFatalFailure(); ++seed) {
        experiment.simulation.seed = seed;
        const QString path = folder.filePath(QString::number(seed) + ".bask");
        addRun(out, experiment, path.toStdString());
        QFile::remove(path);
    }
    for (const auto& [name, coverage] : out)
        coverage.print(std::string(scenario.name) + ", " + name);
    return out;
}

const Scenario kScenarios[]{
    {"no air, known", 0.0, {0.0}},
    {"h = 8, known", 8.0, {8.0}},
    {"h = 8, unknown", 8.0, {}},
};

} // namespace

// Catches standard errors that are too small for rounded readings of a robot at rest, and such that are only
// large enough: a fit over short windows, each with a temperature of its own, has errors of 0.6 and 1.8 % (as
// in 0.2).
TEST(IdentificationCoverage, twenty) {
    for (const Scenario& scenario : kScenarios) {
        Coverage all;
        Coverages each = coverages(scenario, 20);
        for (const auto& [name, coverage] : each)
            all.add(coverage);
        EXPECT_GE(all.share(), 0.88) << scenario.name; // of 180 to 240, not all independent
        EXPECT_GT(all.runs, 170) << scenario.name;
        if (!scenario.air.isKnown())
            continue;
        EXPECT_LT(each["lambda1"].meanError(), 0.003) << scenario.name;
        EXPECT_LT(each["lambda2"].meanError(), 0.007) << scenario.name;
    }
}

// The number to meet: 93 to 97 % of the intervals, with and without convection. Of 600, three to a run, a
// share comes out within 1 % of what it is: lambda2 in known air is at 97.3 %.
TEST(IdentificationCoverage, twoHundred) {
    for (const Scenario& scenario : kScenarios)
        for (const auto& [name, coverage] : coverages(scenario, 200)) {
            EXPECT_GE(coverage.share(), 0.93) << scenario.name << ": " << name;
            EXPECT_LE(coverage.share(), 0.98) << scenario.name << ": " << name;
        }
}

} // namespace bask
