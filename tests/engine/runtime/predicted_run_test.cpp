// Runs as they are predicted before Start.

#include "engine/experiment/experiment_file.h"
#include "engine/model/trace.h"
#include "engine/runtime/simulated_run.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

Experiment predictedExample() {
    return readExperiment(BASK_EXAMPLES "/three-objects.json").value();
}

void expectTimesAscend(const PredictedRun& run) {
    for (std::size_t i = 1; i < run.samples.size(); ++i)
        EXPECT_LT(run.samples[i - 1].time_s, run.samples[i].time_s) << i;
}

} // namespace

// Catches a prediction that does not begin at the start, ends away from the targets, or is not of the time
// that it tells.
TEST(PredictedRun, LeadsFromTheStartToTheTargets) {
    const Experiment experiment = predictedExample();
    const auto run = predictedRun(experiment, std::nullopt);
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_GT(run->samples.size(), 10U);
    EXPECT_LE(run->samples.size(), PredictedRun::kMaxSamples);
    expectTimesAscend(*run);
    const PredictedSample& first = run->samples.front();
    EXPECT_NEAR(first.time_s, 0.0, experiment.sampling.period_s);
    EXPECT_LT((first.coordinates - experiment.start).norm(), 2e-3);
    const PredictedSample& last = run->samples.back();
    EXPECT_GT((last.coordinates - experiment.start).norm(), 2e-2) << "it goes to the source";
    EXPECT_EQ(run->end, PredictedEnd::Settled);
    ASSERT_TRUE(run->settling_s);
    EXPECT_LT(*run->settling_s, run->end_s());
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        EXPECT_NEAR(first.temperatures_K.at(i), experiment.environment_K, 0.5) << i;
        EXPECT_NEAR(last.temperatures_K.at(i), experiment.objects[i].target_K, kSettledBand_K) << i;
    }
}

// Catches a band beside its line, one that is none, and one of runs that begin with other rates.
TEST(PredictedRun, TellsHowFarOtherNoiseTakesIt) {
    Experiment experiment = predictedExample();
    experiment.controller.estimatedRateErrorFactor = 2.0;
    auto run = predictedRun(experiment, std::nullopt);
    ASSERT_TRUE(run) << describe(run.error());
    const std::vector<PredictedSample> line = run->samples;
    ASSERT_TRUE(addSpread(*run, experiment, std::nullopt, 2));
    ASSERT_EQ(run->samples.size(), line.size());
    double widest_K = 0.0, atStart_K = 0.0;
    for (std::size_t k = 0; k < line.size(); ++k)
        for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
            const PredictedSample& sample = run->samples[k];
            EXPECT_EQ(sample.temperatures_K.at(i), line[k].temperatures_K[i]);
            EXPECT_LE(sample.lowest_K.at(i), sample.temperatures_K[i]) << k;
            EXPECT_GE(sample.highest_K.at(i), sample.temperatures_K[i]) << k;
            const double width_K = sample.highest_K[i] - sample.lowest_K[i];
            widest_K = std::max(widest_K, width_K);
            if (sample.time_s < 3.0) // the first steps are those of the rates that it begins with
                atStart_K = std::max(atStart_K, width_K);
        }
    EXPECT_GT(widest_K, 0.01);
    EXPECT_LT(atStart_K, 1.0);
    std::stop_source stopped;
    stopped.request_stop();
    run->samples = line;
    ASSERT_TRUE(addSpread(*run, experiment, std::nullopt, 2, stopped.get_token()));
    EXPECT_TRUE(run->samples.front().lowest_K.empty());
}

// Catches a prediction from the start although the robot stands elsewhere and an object is warm, or none
// because that cannot be zeroed.
TEST(PredictedRun, BeginsWhereTheRigIs) {
    const Experiment experiment = predictedExample();
    RigCondition now;
    now.coordinates = experiment.start;
    (*now.coordinates)[kX] += 0.01;
    now.objects_K.assign(experiment.objects.size(), std::nan(""));
    now.objects_K[1] = experiment.environment_K + 10.0;
    const auto run = predictedRun(experiment, now);
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_GT(run->samples.size(), 10U);
    expectTimesAscend(*run);
    const PredictedSample& first = run->samples.front();
    EXPECT_LT((first.coordinates - *now.coordinates).norm(), 2e-3);
    EXPECT_NEAR(first.temperatures_K.at(0), experiment.environment_K, 0.5);
    EXPECT_GT(first.temperatures_K.at(1), experiment.environment_K + 5.0);
    EXPECT_LT(first.temperatures_K.at(1), experiment.environment_K + 10.1);
    for (std::size_t i = 0; i < experiment.objects.size(); ++i)
        EXPECT_NEAR(run->samples.back().temperatures_K.at(i), experiment.objects[i].target_K, kSettledBand_K)
            << i;
}

// Catches sensors of objects that are a little warm, which are zeroed as if they were cold: by the true
// temperatures they would be held beside the targets.
TEST(PredictedRun, ALittleWarmthIsNotZeroedAway) {
    const Experiment experiment = predictedExample();
    RigCondition now;
    now.objects_K.assign(experiment.objects.size(), std::nan(""));
    now.objects_K[1] = experiment.environment_K + 2.5;
    const auto run = predictedRun(experiment, now);
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_EQ(run->end, PredictedEnd::Settled);
    for (std::size_t i = 0; i < experiment.objects.size(); ++i)
        EXPECT_NEAR(run->samples.back().temperatures_K.at(i), experiment.objects[i].target_K, kSettledBand_K)
            << i;
}

// Catches a prediction that knows what only the simulated rig does: the run would not deviate from it, and
// two pages would tell two times.
TEST(PredictedRun, KnowsNoMoreThanTheExperimentAssumes) {
    Experiment experiment = predictedExample();
    experiment.objects.resize(1);
    experiment.air = {};
    experiment.simulation.convection_W_m2K = 0.0;
    experiment.objects[0].simulatedMaterial.reset();
    const auto assumed = predictedRun(experiment, std::nullopt);
    experiment.simulation.convection_W_m2K = 12.0;
    experiment.simulation.sourceEmittance = 0.5 * experiment.source.emittance;
    experiment.simulation.sourcePose = experiment.source.pose + 0.01 * Vector6d::Unit(kX);
    experiment.simulation.sourceMotion = {{0.0, experiment.source.pose},
                                          {50.0, experiment.source.pose + 0.03 * Vector6d::Unit(kX)}};
    experiment.objects[0].simulatedMaterial = experiment.objects[0].material;
    experiment.objects[0].simulatedMaterial->absorptance *= 0.5;
    const auto run = predictedRun(experiment, std::nullopt);
    ASSERT_TRUE(assumed && run);
    EXPECT_TRUE(assumed->settling_s);
    EXPECT_EQ(run->settling_s, assumed->settling_s);
    EXPECT_EQ(run->samples.back().temperatures_K, assumed->samples.back().temperatures_K);
}

// Catches a run that does not settle in its time, and looks as if it ended there.
TEST(PredictedRun, SaysThatItDoesNotSettle) {
    Experiment experiment = predictedExample();
    experiment.simulation.durationLimit_s = 20.0;
    const auto run = predictedRun(experiment, std::nullopt);
    ASSERT_TRUE(run) << describe(run.error());
    EXPECT_EQ(run->end, PredictedEnd::Limit);
    EXPECT_FALSE(run->settling_s);
}

// Catches a prediction that goes on when nobody wants it, or tells when it would have settled all the same.
TEST(PredictedRun, StopsWhenAsked) {
    const Experiment experiment = predictedExample();
    std::stop_source stop;
    const auto run = predictedRun(experiment, std::nullopt, stop.get_token(), [&](double time_s) {
        if (time_s >= 20.0)
            stop.request_stop();
    });
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_FALSE(run->samples.empty());
    EXPECT_NEAR(run->end_s(), 20.0, 2.0 * experiment.sampling.period_s);
    EXPECT_FALSE(run->settling_s);
    EXPECT_EQ(run->end, PredictedEnd::Cut);
    const auto none = predictedRun(experiment, std::nullopt, stop.get_token());
    ASSERT_TRUE(none) << describe(none.error());
    EXPECT_TRUE(none->samples.empty()) << "the estimators filled all the same";
    EXPECT_EQ(none->end, PredictedEnd::Cut);
}

// Catches samples without bound, or a thinned prediction that loses its end.
TEST(PredictedRun, StaysSmallHoweverOftenIsSampled) {
    Experiment experiment = predictedExample();
    experiment.objects.resize(1);
    experiment.sampling.period_s = 0.2;
    experiment.simulation.durationLimit_s = 140.0;
    double last_s = 0.0;
    int told = 0;
    const auto run = predictedRun(experiment, std::nullopt, {}, [&](double time_s) {
        last_s = time_s;
        ++told;
    });
    ASSERT_TRUE(run) << describe(run.error());
    ASSERT_GT(told, static_cast<int>(PredictedRun::kMaxSamples));
    EXPECT_LE(run->samples.size(), PredictedRun::kMaxSamples);
    EXPECT_GE(run->samples.size(), PredictedRun::kMaxSamples / 2);
    expectTimesAscend(*run);
    EXPECT_NEAR(run->samples.front().time_s, 0.0, 1e-9);
    EXPECT_EQ(run->end_s(), last_s);
}

} // namespace bask
