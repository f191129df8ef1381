// Whole recipes on the simulated rig.

#include "engine/experiment/experiment_file.h"
#include "engine/recipe/simulated_recipe.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/recording/session_file.h"

#include <QFileInfo>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask {
namespace {

using State = RecipeProgress::State;
using Until = RecipeStep::Until;

struct SimulatedRecipe : testing::Test {
    QTemporaryDir folder;

    RecipeStep step(Until until, double duration_s, bool isRun = true) {
        RecipeStep made;
        made.experiment = isRun ? "two-circles" : "";
        made.until = until;
        made.duration_s = duration_s;
        made.object = "left";
        made.temperature_K = kelvinFromCelsius(34.0);
        made.maxDuration_s = 1800.0;
        return made;
    }
    RecipeRunner runner(const std::vector<RecipeStep>& steps,
                        const std::function<void(Experiment&)>& change = {}) {
        Experiment experiment = *readExperiment(BASK_EXAMPLES "/two-circles.json");
        if (change)
            change(experiment);
        const auto shared = std::make_shared<const Experiment>(experiment);
        return RecipeRunner({"", steps}, RecipeExperiments(steps.size(), shared), [this](std::size_t i) {
            return folder.filePath(QStringLiteral("%1.bask").arg(i)).toStdString();
        });
    }
};

} // namespace

// Catches waits by wall time, heat that stays on in them, sessions that are not closed, a rig that is not
// cooled.
TEST_F(SimulatedRecipe, runsWaitsAndRunsAgain) {
    RecipeRunner made = runner({step(Until::Settled, 30.0), step(Until::Below, 0.0, false),
                                step(Until::Time, 45.0, false), step(Until::Above, 0.0)});
    double coldest_K = 1e3;
    int waits = 0;
    runSimulated(made, [&](const RecipeRunner& runner, const Snapshot& snapshot) {
        if (runner.phase() != RecipeRunner::Phase::Wait)
            return;
        ++waits;
        EXPECT_FALSE(snapshot.heatOn);
        EXPECT_EQ(snapshot.state, RunState::Stopped);
        coldest_K = std::min(coldest_K, snapshot.latest.objects[0].measured_K);
    });
    EXPECT_EQ(made.end(), RecipeEnd::Done) << describe(made.reason());
    EXPECT_LT(coldest_K, kelvinFromCelsius(34.1));
    EXPECT_GT(waits, 60);
    const auto& steps = made.progress();
    EXPECT_GE(steps[0].elapsed_s, 60.0);
    EXPECT_GT(steps[1].elapsed_s, 10.0);
    EXPECT_NEAR(steps[2].elapsed_s, 45.0, 1.0);
    EXPECT_LT(steps[3].elapsed_s, steps[0].elapsed_s); // 34 degC on the way to 50
    EXPECT_TRUE(steps[1].recording.empty());
    for (const std::size_t i : {std::size_t{0}, std::size_t{3}}) {
        const auto session = readSession(steps[i].recording);
        ASSERT_TRUE(session) << describe(session.error());
        EXPECT_EQ(session->outcome, i == 0 ? "settled" : "stopped");
    }
}

TEST_F(SimulatedRecipe, aLostSensorEndsItByAlarm) {
    RecipeStep first = step(Until::Settled, 30.0);
    first.goesOn = true;
    RecipeRunner made = runner({first, step(Until::Time, 20.0)}, [](Experiment& experiment) {
        experiment.simulation.faults = {{20.0, SimulatedFault::SensorLost, 0}};
    });
    runSimulated(made);
    EXPECT_EQ(made.end(), RecipeEnd::Alarm);
    EXPECT_EQ(made.progress()[0].state, State::Failed);
    EXPECT_NE(made.reason().code, MessageCode::None);
    EXPECT_EQ(made.progress()[1].state, State::Waiting);
}

TEST_F(SimulatedRecipe, targetsThatCannotBeHeldFailTheirStep) {
    RecipeRunner made = runner({step(Until::Time, 20.0)},
                               [](Experiment& experiment) { experiment.objects[0].target_K = 440.0; });
    runSimulated(made);
    EXPECT_EQ(made.end(), RecipeEnd::StepFailed);
    EXPECT_EQ(made.progress()[0].state, State::Failed);
    EXPECT_TRUE(made.progress()[0].recording.empty());
}

TEST_F(SimulatedRecipe, aSessionThatCannotBeWrittenFailsItsStep) {
    const auto shared =
        std::make_shared<const Experiment>(*readExperiment(BASK_EXAMPLES "/two-circles.json"));
    RecipeRunner made({"", {step(Until::Time, 20.0)}}, {shared},
                      [](std::size_t) { return std::string("/nowhere/at-all.bask"); });
    runSimulated(made);
    EXPECT_EQ(made.end(), RecipeEnd::StepFailed);
    EXPECT_EQ(made.reason().code, MessageCode::FileUnwritable) << describe(made.reason());
}

// Catches a recording of another recipe, which came there since this one began, that is lost to it.
TEST_F(SimulatedRecipe, aSessionThatIsThereIsKeptAndFailsItsStep) {
    RecipeStep first = step(Until::Time, 20.0);
    first.goesOn = true;
    RecipeRunner made = runner({first, step(Until::Time, 20.0)});
    const std::string there = folder.filePath("0.bask").toStdString();
    ASSERT_TRUE((*SessionWriter::create(there, *readExperiment(BASK_EXAMPLES "/three-objects.json"), true))
                    ->finish("settled"));
    runSimulated(made);
    EXPECT_EQ(made.progress()[0].state, State::Failed);
    EXPECT_EQ(made.progress()[0].reason.code, MessageCode::FileUnwritable);
    EXPECT_EQ(made.progress()[1].state, State::Done);
    EXPECT_EQ(readSession(there)->experiment.objects.size(), 3U);
}

TEST_F(SimulatedRecipe, stopsWithTheHeatOffWhenAsked) {
    std::stop_source stop;
    RecipeRunner made = runner({step(Until::Settled, 30.0), step(Until::Time, 20.0)});
    RunState last = RunState::Idle;
    runSimulated(
        made,
        [&](const RecipeRunner&, const Snapshot& snapshot) {
            last = snapshot.state;
            if (snapshot.runTime_s > 20.0)
                stop.request_stop();
        },
        stop.get_token());
    EXPECT_EQ(made.end(), RecipeEnd::Stopped);
    EXPECT_EQ(last, RunState::Stopped);
    EXPECT_EQ(readSession(made.progress()[0].recording)->outcome, "stopped");
}

} // namespace bask
