// What a recipe asks of the engine, by snapshots made up here.

#include "engine/recipe/recipe_runner.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

using State = RecipeProgress::State;
using Phase = RecipeRunner::Phase;
using Until = RecipeStep::Until;

/// Names of commands in their order.
std::string words(const std::vector<Command>& commands) {
    std::string out;
    for (const Command& command : commands) {
        out += out.empty() ? "" : " ";
        out += std::holds_alternative<LoadExperiment>(command) ? "load"
               : std::holds_alternative<Arm>(command)          ? "arm"
               : std::holds_alternative<Start>(command)        ? "start"
               : std::holds_alternative<Stop>(command)         ? "stop"
               : std::holds_alternative<Reset>(command)        ? "reset"
                                                               : "?";
    }
    return out;
}

RecipeStep run(const char* file, Until until = Until::Time, double duration_s = 100.0) {
    RecipeStep step;
    step.experiment = file;
    step.until = until;
    step.duration_s = duration_s;
    step.maxDuration_s = 600.0;
    step.object = "left";
    return step;
}

RecipeStep wait(Until until, double duration_s = 50.0) {
    return run("", until, duration_s);
}

/// An engine that says what the test wants.
struct Runner : testing::Test {
    Snapshot snapshot;
    std::unique_ptr<RecipeRunner> runner;

    Runner() {
        snapshot.loadId = 5;
        snapshot.clock_s = 1000.0;
        snapshot.latest.objects.resize(2);
        snapshot.state = RunState::Ready;
    }

    std::string begin(std::vector<RecipeStep> steps) {
        RecipeExperiments experiments;
        std::map<std::string, std::shared_ptr<const Experiment>> known;
        for (const RecipeStep& step : steps) {
            auto& one = known[step.isRun() ? step.experiment : steps.front().experiment];
            if (!one) {
                Experiment made;
                made.title = step.experiment;
                made.objects.resize(2);
                made.objects[0].name = "right";
                made.objects[1].name = "left";
                one = std::make_shared<const Experiment>(made);
            }
            experiments.push_back(one);
        }
        runner = std::make_unique<RecipeRunner>(
            Recipe{"", std::move(steps)}, std::move(experiments),
            [](std::size_t step) { return "run" + std::to_string(step) + ".bask"; });
        return words(runner->begin(snapshot));
    }
    std::string take(RunState state, double passed_s = 1.0) {
        snapshot.state = state;
        snapshot.clock_s += passed_s;
        const std::string said = words(runner->take(snapshot));
        snapshot.newSamples.clear();
        snapshot.refusal = {};
        return said;
    }
    std::string load() {
        ++snapshot.loadId;
        snapshot.clock_s = 0.0; // a new rig
        return take(RunState::NotReady, 0.0);
    }
    /// A run's sample: both objects so far off their targets, so hot.
    std::string sample(double time_s, double error_K, double measured_K = 320.0,
                       RunState state = RunState::Running) {
        TraceSample made;
        made.time_s = time_s;
        for (int i = 0; i < 2; ++i) {
            ObjectSample object;
            object.target_K = 320.0;
            object.estimated_K = 320.0 + error_K;
            object.measured_K = measured_K;
            object.valid = true;
            made.objects.push_back(object);
        }
        made.objects[0].measured_K = 320.0; // "right"
        snapshot.newSamples.push_back(made);
        snapshot.latest = made;
        snapshot.runTime_s = time_s;
        return take(state);
    }
    void start() {
        EXPECT_EQ(load(), "");
        EXPECT_EQ(take(RunState::Ready), "arm");
        EXPECT_EQ(take(RunState::Armed), "");
        EXPECT_EQ(take(RunState::Armed, 1.1), "start");
        snapshot.runTime_s = 0.0;
        EXPECT_EQ(take(RunState::Running), "");
        EXPECT_EQ(runner->phase(), Phase::Run);
    }
    void raise(int priority, MessageCode code = MessageCode::SafetyObjectWarm) {
        Alarm alarm;
        alarm.id = snapshot.alarms.size() + 1;
        alarm.priority = priority;
        alarm.message.code = code;
        snapshot.alarms.push_back(alarm);
    }
    const RecipeProgress& at(std::size_t step) { return runner->progress()[step]; }
};

} // namespace

TEST_F(Runner, goesThroughRunsAndWaitsInTheirOrder) {
    EXPECT_EQ(begin({run("a"), wait(Until::Below), run("b", Until::Settled, 20.0)}), "load");
    EXPECT_EQ(take(RunState::Ready), ""); // from before the load
    start();
    EXPECT_EQ(at(0).recording, "run0.bask");
    EXPECT_EQ(sample(99.0, 3.0), "");
    EXPECT_EQ(sample(100.0, 3.0), "stop");
    EXPECT_EQ(take(RunState::Running), "");
    EXPECT_EQ(take(RunState::Stopping), "");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(at(0).state, State::Done);
    EXPECT_EQ(at(0).elapsed_s, 100.0);
    ASSERT_EQ(runner->phase(), Phase::Wait);
    EXPECT_EQ(sample(100.0, 3.0, 303.2, RunState::Stopped), ""); // 303.15 K, and "left" alone counts
    EXPECT_EQ(sample(100.0, 3.0, 303.1, RunState::Stopped), "load");
    EXPECT_EQ(at(1).state, State::Done);
    start();
    EXPECT_EQ(sample(10.0, 0.4), "");
    EXPECT_EQ(sample(20.0, 0.6), ""); // out again
    EXPECT_EQ(sample(25.0, 0.4), "");
    EXPECT_EQ(sample(44.0, -0.5), "");
    EXPECT_EQ(sample(45.0, 0.0), "stop");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Done);
    EXPECT_EQ(take(RunState::Ready), "");
}

TEST_F(Runner, waitsByTheRigsClock) {
    begin({wait(Until::Time, 50.0), run("a")});
    EXPECT_EQ(load(), "");
    EXPECT_EQ(runner->phase(), Phase::Wait);
    EXPECT_EQ(take(RunState::Ready, 49.0), "");
    EXPECT_EQ(at(0).elapsed_s, 49.0);
    EXPECT_EQ(take(RunState::Ready, 1.0), "load"); // the run's own rig
}

TEST_F(Runner, aStepThatDoesNotGetThereEndsItOrDoesNot) {
    for (const bool goesOn : {false, true}) {
        RecipeStep first = run("a", Until::Above);
        first.temperature_K = 400.0;
        first.goesOn = goesOn;
        begin({first, run("b")});
        start();
        EXPECT_EQ(sample(599.0, 3.0), "");
        EXPECT_EQ(sample(600.0, 3.0), "stop");
        EXPECT_EQ(at(0).state, State::NotReached);
        EXPECT_EQ(take(RunState::Stopped), goesOn ? "load" : "");
        EXPECT_EQ(runner->end(), goesOn ? RecipeEnd::None : RecipeEnd::StepFailed);
        if (!goesOn)
            continue;
        start();
        EXPECT_EQ(sample(100.0, 3.0), "stop");
        EXPECT_EQ(take(RunState::Stopped), "");
        EXPECT_EQ(runner->end(), RecipeEnd::StepFailed); // the last one alone is not all
    }
    RecipeStep cold = wait(Until::Below);
    begin({cold, run("a")});
    load();
    EXPECT_EQ(take(RunState::Ready, 599.0), "");
    EXPECT_EQ(take(RunState::Ready, 1.0), "");
    EXPECT_EQ(at(0).state, State::NotReached);
    EXPECT_EQ(runner->end(), RecipeEnd::StepFailed);
}

TEST_F(Runner, aRunThatIsRefusedFailsItsStep) {
    const Message refusal{MessageCode::ReasonTargetInfeasible, {}};
    RecipeStep first = run("a");
    first.goesOn = true;
    begin({first, first, first, run("b")});
    snapshot.refusal = {MessageCode::CommandNotNow, {"Set targets", "Stopping"}}; // a person's, before
    EXPECT_EQ(take(RunState::Ready), "");
    snapshot.refusal = refusal; // the load
    EXPECT_EQ(take(RunState::Ready), "load");
    EXPECT_EQ(at(0).reason, refusal);
    load();
    take(RunState::Ready);
    snapshot.refusal = refusal; // arm
    EXPECT_EQ(take(RunState::Ready), "load");
    EXPECT_EQ(at(1).state, State::Failed);
    EXPECT_EQ(at(1).recording, "");
    load();
    take(RunState::Ready);
    take(RunState::Armed);
    take(RunState::Armed, 2.0);
    snapshot.refusal = refusal; // start: disarmed first
    EXPECT_EQ(take(RunState::Armed), "stop load");
    EXPECT_EQ(at(2).state, State::Failed);
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    EXPECT_EQ(runner->end(), RecipeEnd::StepFailed);
}

TEST_F(Runner, aRigThatDoesNotGetReadyFailsItsStep) {
    begin({run("a")});
    load();
    snapshot.reasons = {{MessageCode::ReasonNotAtAmbient, {"25"}}};
    EXPECT_EQ(take(RunState::NotReady, 59.0), "");
    EXPECT_EQ(take(RunState::NotReady, 60.0), "");
    EXPECT_EQ(runner->end(), RecipeEnd::StepFailed);
    EXPECT_EQ(runner->reason(), snapshot.reasons.front());
}

// Catches a fault that nobody has looked at and that is reset all the same, in the middle of a night.
TEST_F(Runner, neverResets) {
    const auto connected = [this] {
        load();
        snapshot.reasons = {{MessageCode::SafetyStartUp, {}}, {MessageCode::RobotOpening, {}}};
    };
    begin({run("a")});
    connected();
    EXPECT_EQ(take(RunState::Fault), "");
    EXPECT_EQ(take(RunState::Fault, 5.0), "");
    EXPECT_FALSE(runner->isOver()) << "somebody may be looking at the rig";
    snapshot.reasons.push_back({MessageCode::ReasonEmergencyStop, {}});
    EXPECT_EQ(take(RunState::Fault, 5.0), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Fault);

    snapshot.reasons.clear();
    begin({run("a"), run("b")});
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    connected(); // for the second step: nothing of the rig has changed
    EXPECT_EQ(take(RunState::Fault), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Fault);
}

// Catches a reset by what the engine told before a person pressed STOP, which follows STOP and clears it.
TEST_F(Runner, asksForNothingOnceAPersonTakesOver) {
    begin({run("a"), run("b")});
    load();
    snapshot.reasons = {{MessageCode::SafetyStartUp, {}}};
    runner->takeOver();
    EXPECT_EQ(take(RunState::Fault), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
    EXPECT_EQ(at(0).state, State::Stopped);
    EXPECT_EQ(at(1).state, State::Waiting);
}

TEST_F(Runner, aFaultEndsItWhereverItIs) {
    RecipeStep first = run("a");
    first.goesOn = true;
    const std::vector<RecipeStep> steps{first, wait(Until::Time), run("b")};
    const auto isOver = [this] {
        snapshot.reasons = {{MessageCode::ReasonEmergencyStop, {}}};
        EXPECT_EQ(take(RunState::Fault), "");
        EXPECT_EQ(runner->end(), RecipeEnd::Fault);
        EXPECT_EQ(runner->reason(), snapshot.reasons.front());
        snapshot.reasons.clear();
        EXPECT_EQ(take(RunState::Ready, 5.0), ""); // a Reset starts nothing
    };
    begin(steps);
    load();
    take(RunState::Ready);
    isOver(); // armed
    begin(steps);
    start();
    isOver();
    begin(steps);
    start();
    sample(100.0, 0.0);
    take(RunState::Stopping);
    isOver();
    begin(steps);
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    ASSERT_EQ(runner->phase(), Phase::Wait);
    isOver();
}

TEST_F(Runner, aNewAlarmStopsTheRunAndEndsIt) {
    RecipeStep first = run("a");
    first.goesOn = true;
    raise(1); // from before: a person has let it be
    begin({first, run("b")});
    start();
    raise(3, MessageCode::SafetyLoopLate); // a notice
    EXPECT_EQ(sample(1.0, 0.0), "");
    raise(2);
    EXPECT_EQ(sample(2.0, 0.0), "stop");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
    EXPECT_EQ(at(0).state, State::Failed);
    EXPECT_EQ(runner->reason().code, MessageCode::SafetyObjectWarm);

    begin({run("a"), wait(Until::Time), run("b")});
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    raise(3, MessageCode::SafetySensorOpen);
    EXPECT_EQ(take(RunState::Stopped, 100.0), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
}

// Catches a recipe that ends a run which a person has taken in hand, or leaves one that safety holds.
TEST_F(Runner, aHoldEndsItAndIsStoppedUnlessItIsAPersons) {
    begin({run("a"), run("b")});
    start();
    snapshot.reasons = {{MessageCode::ReasonHeldByOperator, {}}};
    EXPECT_EQ(take(RunState::Holding), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
    EXPECT_EQ(at(0).state, State::Paused);
    begin({run("a"), run("b")});
    snapshot.reasons.clear();
    start();
    snapshot.reasons = {{MessageCode::ReasonSensorStale, {"left", "4"}}};
    EXPECT_EQ(take(RunState::Holding), "stop");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
}

// Catches a program that ends, and with it the robot's way, in the middle of a retreat.
TEST_F(Runner, theEnginesOwnRetreatIsWaitedFor) {
    begin({run("a"), wait(Until::Time), run("b")});
    start();
    snapshot.reasons = {{MessageCode::ReasonRecorderFailed, {"full"}}};
    EXPECT_EQ(take(RunState::Stopping), "");
    EXPECT_FALSE(runner->isOver());
    EXPECT_EQ(take(RunState::Fault), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Fault);
    EXPECT_EQ(at(0).reason.code, MessageCode::ReasonRecorderFailed);

    snapshot.reasons.clear();
    begin({run("a"), wait(Until::Time), run("b")});
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    raise(1, MessageCode::SafetyObjectHot);
    EXPECT_EQ(take(RunState::Stopping), "");
    EXPECT_FALSE(runner->isOver());
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
    EXPECT_EQ(at(1).state, State::Failed);
}

TEST_F(Runner, aRetreatOrAnAlarmBeforeTheStartEndsIt) {
    for (const bool isStarted : {false, true}) {
        snapshot.reasons.clear();
        snapshot.alarms.clear();
        begin({run("a"), run("b")});
        load();
        take(RunState::Ready);
        take(RunState::Armed);
        EXPECT_EQ(take(RunState::Armed, isStarted ? 1.1 : 0.1), isStarted ? "start" : "");
        snapshot.reasons = {{MessageCode::SafetySourceHot, {"310", "305"}}};
        EXPECT_EQ(take(RunState::Stopping), "");
        EXPECT_FALSE(runner->isOver());
        EXPECT_EQ(take(RunState::Fault), "");
        EXPECT_EQ(runner->end(), RecipeEnd::Fault);
        EXPECT_EQ(at(0).state, State::Failed);

        snapshot.reasons.clear();
        begin({run("a"), run("b")});
        load();
        take(RunState::Ready);
        take(RunState::Armed);
        EXPECT_EQ(take(RunState::Armed, isStarted ? 1.1 : 0.1), isStarted ? "start" : "");
        raise(1, MessageCode::SafetyHeatNotOff);
        EXPECT_EQ(take(RunState::Armed), "stop");
        EXPECT_EQ(take(RunState::Ready), "");
        EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
    }
}

// Catches a recipe that goes on to heat although the source could not be switched off: the next experiment's
// load ends that alarm.
TEST_F(Runner, anAlarmWhileTheNextIsLoadedEndsIt) {
    begin({run("a"), run("b")});
    load();
    raise(1, MessageCode::LinkLost); // not there yet
    raise(3, MessageCode::SafetyNoWatchdog);
    EXPECT_EQ(take(RunState::NotReady), "");
    EXPECT_EQ(take(RunState::Ready), "arm");
    take(RunState::Armed);
    EXPECT_EQ(take(RunState::Armed, 1.1), "start");
    take(RunState::Running);
    EXPECT_EQ(sample(100.0, 0.0), "stop");
    EXPECT_EQ(take(RunState::Stopped), "load");
    raise(1, MessageCode::SafetyHeatNotOff);
    snapshot.alarms.back().isActive = false;
    EXPECT_EQ(load(), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Alarm);
    EXPECT_EQ(at(1).state, State::Failed);
}

// Catches a rig that arms and starts by itself while somebody works at it.
TEST_F(Runner, endsWhereThePersonMovesOrHeatsByHand) {
    begin({wait(Until::Time), run("a")});
    load();
    EXPECT_EQ(take(RunState::Ready), "");
    snapshot.isMoving = true;
    EXPECT_EQ(take(RunState::Ready), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
    snapshot.isMoving = false;
    begin({run("a")});
    load();
    snapshot.heatSetPoint_K = 400.0;
    EXPECT_EQ(take(RunState::NotReady), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
}

// Catches runs that are not recorded, unseen, where the folder has gone.
TEST_F(Runner, aRunThatCannotBeRecordedFails) {
    begin({run("a")});
    const auto one = std::make_shared<const Experiment>();
    RecipeRunner other(runner->recipe(), {one}, [](std::size_t) {
        return Error(MessageCode::FileUnwritable, "gone", {"it is gone"});
    });
    (void)other.begin(snapshot);
    ++snapshot.loadId;
    EXPECT_EQ(words(other.take(snapshot)), "");
    EXPECT_EQ(other.end(), RecipeEnd::StepFailed);
    EXPECT_EQ(other.reason().code, MessageCode::FileUnwritable);
}

TEST_F(Runner, whatAPersonStopsStaysStopped) {
    begin({run("a"), run("b")});
    start();
    EXPECT_EQ(take(RunState::Stopping), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
    EXPECT_EQ(take(RunState::Stopped), "");

    begin({run("a"), wait(Until::Time), run("b")});
    start();
    sample(100.0, 0.0);
    take(RunState::Stopped);
    ++snapshot.loadId; // another experiment
    EXPECT_EQ(take(RunState::Ready), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);

    begin({run("a")});
    load();
    take(RunState::Ready);
    take(RunState::Armed);
    EXPECT_EQ(take(RunState::Ready), ""); // disarmed
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
}

TEST_F(Runner, stopsWhenAsked) {
    begin({run("a"), run("b")});
    EXPECT_EQ(words(runner->stopNow()), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Stopped);
    begin({run("a"), run("b")});
    load();
    take(RunState::Ready);
    EXPECT_EQ(words(runner->stopNow()), "stop"); // on its way to be armed
    EXPECT_EQ(runner->end(), RecipeEnd::Stopped);
    begin({run("a"), run("b")});
    start();
    EXPECT_EQ(words(runner->stopNow()), "stop");
    EXPECT_EQ(runner->end(), RecipeEnd::None); // the retreat
    EXPECT_EQ(words(runner->stopNow()), "");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Stopped);
    EXPECT_EQ(at(0).state, State::Stopped);
    EXPECT_EQ(at(1).state, State::Waiting);
    begin({run("a"), run("b")});
    start();
    runner->setStopAfterStep(true);
    EXPECT_EQ(sample(100.0, 0.0), "stop");
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::Stopped);
    EXPECT_EQ(at(0).state, State::Done);
}

TEST_F(Runner, loadsNothingOverEditsThatAreNotSaved) {
    begin({run("a"), run("b")});
    start();
    runner->setKeepsExperiment(true);
    sample(100.0, 0.0);
    EXPECT_EQ(take(RunState::Stopped), "");
    EXPECT_EQ(runner->end(), RecipeEnd::TakenOver);
}

} // namespace bask
