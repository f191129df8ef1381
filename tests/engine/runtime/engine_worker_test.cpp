// The worker on a thread of its own, as the GUI uses it.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/alarm_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/unrecorded_alarms.h"
#include "engine/recording/run_metrics.h"
#include "engine/recording/session_header.h"
#include "engine/recording/session_store.h"
#include "engine/recording/session_verify.h"
#include "tests/engine/runtime/engine_thread.h"
#include "tests/engine/runtime/half_size.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <thread>

namespace bask {
namespace {

Experiment oneDisk() {
    Experiment experiment;
    experiment.title = "one disk";
    ObjectSpec object;
    object.name = "disk";
    object.shape = Disk{0.015};
    object.material = {"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
    object.target_K = kelvinFromCelsius(35.0);
    experiment.objects.push_back(object);
    experiment.sampling.period_s = 0.5;
    return experiment;
}

using Rig = EngineThread;

Experiment withMarkers() {
    return readExperiment(BASK_EXAMPLES "/moving-source.json").value();
}

bool shows(const std::shared_ptr<const VisionView>& view, int id) {
    return view && std::ranges::any_of(view->markers, [id](const auto& m) { return m.marker.id == id; });
}

} // namespace

TEST(EngineWorker, RunsRecordsAndDropsNoSample) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{path});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(AddNote{"hello"});
    ASSERT_TRUE(rig.reaches(RunState::Settled));
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); })) << "it is closed meanwhile";
    EXPECT_TRUE(rig.inOrder);
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->samples.size(), rig.samples);
    EXPECT_EQ(session->outcome, "settled");
    ASSERT_EQ(session->notes.size(), 1U);
    EXPECT_EQ(session->notes[0].text, "hello");
    EXPECT_TRUE(session->simulated);
}

// Catches an edit by which the simulated plate is hot again, objects cold, the robot elsewhere, or the
// sensors not ready.
TEST(EngineWorker, AnEditLeavesTheSimulatedRigAsItIs) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Settled));
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.source_K && *rig.last.source_K < 430.0; }));
    rig.send(SetSimulationSpeed{1.0});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.simulationSpeed == 1.0; }));
    const Snapshot before = rig.last;

    Experiment edited = oneDisk();
    edited.objects[0].material.emittance = 0.8;
    rig.send(LoadExperiment{edited, true});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.loadId > before.loadId && rig.last.source_K; }));
    EXPECT_NEAR(*rig.last.source_K, *before.source_K, 2.0);
    EXPECT_NEAR(rig.last.latest.objects[0].measured_K, before.latest.objects[0].measured_K, 1.0);
    EXPECT_LT((rig.last.latest.coordinates - before.latest.coordinates).norm(), 1e-3);
    EXPECT_GE(rig.last.clock_s, before.clock_s);
    const double loaded_s = rig.last.clock_s;
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_LT(rig.last.clock_s - loaded_s, 1.5) << "the windows of the sensors were full";

    Experiment more = edited;
    more.objects.push_back(edited.objects[0]);
    more.objects[1].name = "new";
    more.objects[1].mounting[0] = 0.05;
    const double last_K = rig.last.latest.objects[0].measured_K;
    rig.send(LoadExperiment{more, true});
    ASSERT_TRUE(rig.waitFor([&] {
        return rig.last.latest.objects.size() == 2 && std::isfinite(rig.last.latest.objects[1].measured_K);
    }));
    EXPECT_NEAR(rig.last.latest.objects[0].measured_K, last_K, 1.0);
    EXPECT_NEAR(rig.last.latest.objects[1].measured_K, more.environment_K, 1.0) << "it was not there before";
    const double added_s = rig.last.clock_s;
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_LT(rig.last.clock_s - added_s, 1.5) << "also with an object more";

    Experiment fewer = more;
    fewer.objects.erase(fewer.objects.begin());
    const double kept_K = rig.last.latest.objects[1].measured_K;
    rig.send(LoadExperiment{fewer, true});
    ASSERT_TRUE(rig.waitFor([&] {
        return rig.last.latest.objects.size() == 1 && std::isfinite(rig.last.latest.objects[0].measured_K);
    }));
    EXPECT_NEAR(rig.last.latest.objects[0].measured_K, kept_K, 0.5) << "the other object's";
    const double removed_s = rig.last.clock_s;
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_LT(rig.last.clock_s - removed_s, 1.5);
    fewer.objects[0].name = "with another name";
    rig.send(LoadExperiment{fewer, true});
    ASSERT_TRUE(rig.waitFor([&] {
        return rig.last.objects == std::vector{fewer.objects[0].name} &&
               std::isfinite(rig.last.latest.objects[0].measured_K);
    }));
    EXPECT_NEAR(rig.last.latest.objects[0].measured_K, kept_K, 0.5);

    rig.send(LoadExperiment{oneDisk()}); // another experiment, not an edit
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.latest.objects.size() == 1 && rig.last.source_K; }));
    EXPECT_NEAR(*rig.last.source_K, oneDisk().source.temperature_K, 1.0);
}

// Catches a zeroing, or the error of a sensor, that goes to another object when one is added or removed.
TEST(EngineWorker, AnEditLeavesTheZeroingToItsObjects) {
    Experiment three = oneDisk();
    three.simulation.sensorOffset_K = 0.8;
    three.simulation.sensorNoise_K = 0.0;
    three.simulation.sensorResolution_K = 0.0;
    for (const char* const name : {"second", "third"}) {
        three.objects.push_back(three.objects[0]);
        three.objects.back().name = name;
        three.objects.back().mounting[0] = 0.05 * static_cast<double>(three.objects.size() - 1);
    }
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{three});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(ZeroSensors{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.zeroing.has_value(); }));
    const Zeroing before = *rig.last.zeroing;
    ASSERT_GT(std::abs(before.offsets_K[1] - before.offsets_K[2]), 0.05) << "nothing would be exchanged";
    Experiment edited = three;
    edited.objects.erase(edited.objects.begin());
    std::swap(edited.objects[0], edited.objects[1]);
    edited.objects.push_back(three.objects[0]);
    edited.objects.back().name = "new";
    rig.send(LoadExperiment{edited, true});
    ASSERT_TRUE(rig.waitFor([&] {
        return rig.last.objects.size() == 3 && rig.last.objects[2] == "new" && rig.last.zeroing &&
               std::isfinite(rig.last.latest.objects[2].measured_K);
    }));
    EXPECT_DOUBLE_EQ(rig.last.zeroing->offsets_K[0], before.offsets_K[2]);
    EXPECT_DOUBLE_EQ(rig.last.zeroing->offsets_K[1], before.offsets_K[1]);
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    for (const ObjectSample& object : rig.last.latest.objects)
        EXPECT_NEAR(object.measured_K, before.environment_K, 0.05);
}

// Catches a prediction that is not kept with its run, is kept with another one, or breaks the recording.
TEST(EngineWorker, ThePredictionIsKeptWithItsRun) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    const auto predicted = [](std::size_t objects, double first_K) {
        auto run = std::make_shared<PredictedRun>();
        for (int k = 0; k < 3; ++k) {
            PredictedSample sample;
            sample.time_s = k;
            sample.temperatures_K.assign(objects, first_K + k);
            run->samples.push_back(std::move(sample));
        }
        return run;
    };
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(KeepPrediction{rig.last.runId, predicted(1, 500.0)}); // nothing is recorded
    rig.send(Arm{path});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(KeepPrediction{rig.last.runId, predicted(1, 300.0)});
    rig.send(KeepPrediction{rig.last.runId - 1, predicted(1, 400.0)});
    rig.send(KeepPrediction{rig.last.runId, predicted(2, 400.0)});
    rig.send(KeepPrediction{rig.last.runId, nullptr});
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    ASSERT_EQ(session->prediction.samples.size(), 3U);
    EXPECT_EQ(session->prediction.samples[2].temperatures_K, std::vector{302.0});
}

// Catches a watch that hears nothing while the window hangs, or hears an event twice.
TEST(EngineWorker, TheWatchIsToldAlsoWhileNobodyTakesSnapshots) {
    std::mutex mutex;
    int told = 0;
    std::vector<std::string> events;
    RunState state = RunState::Idle;
    Rig rig([&](const Snapshot& snapshot) {
        const std::lock_guard lock(mutex);
        ++told;
        state = snapshot.state;
        for (const TraceEvent& event : snapshot.newEvents)
            events.emplace_back(messageName(event.message.code));
    });
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    const auto now = [&] {
        const std::lock_guard lock(mutex);
        return std::pair(told, state);
    };
    const int before = now().first;
    rig.send(EmergencyStop{});
    for (int k = 0; k < 500 && (now().second != RunState::Fault || now().first < before + 20); ++k)
        std::this_thread::sleep_for(std::chrono::milliseconds(10)); // this thread takes no snapshot
    EXPECT_EQ(now().second, RunState::Fault);
    EXPECT_GE(now().first, before + 20) << "at most two snapshots wait for a receiver that hangs";
    const std::lock_guard lock(mutex);
    EXPECT_EQ(std::ranges::count(events, "EventEmergencyStop"), 1);
    EXPECT_EQ(std::ranges::count(events, "EventStarted"), 1);
}

// Catches a command, note or acknowledgement without its operator, and labels that get lost with an
// experiment.
TEST(EngineWorker, RecordsWhoOperatesAndWhatIsHeated) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(SetLabels{{"A. Hu", "plate 7", "B3"}});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_EQ(rig.last.labels, (RunLabels{"A. Hu", "plate 7", "B3"}));
    EXPECT_EQ(rig.last.objects, std::vector<std::string>{"disk"});
    rig.send(SetLabels{{"two\nlines", "", ""}});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::NameNotPlain; }));
    rig.send(Arm{path});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(AddNote{"hello"});
    rig.send(SetLabels{{"B. Li", "another", "B3"}});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SessionAlreadyRunning; }))
        << "the sample of a run stays what it is";
    rig.send(SetLabels{{"B. Li", "plate 7", "B3"}});
    rig.send(AddNote{"good bye"});
    rig.send(SetTargets{{kelvinFromCelsius(36.0)}});
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->labels, (RunLabels{"A. Hu", "plate 7", "B3"}));
    ASSERT_EQ(session->notes.size(), 2U);
    EXPECT_EQ(session->notes[0].operatorName, "A. Hu");
    EXPECT_EQ(session->notes[1].operatorName, "B. Li");
    std::string names;
    for (const CommandRow& command : session->commands)
        names += command.name + " by " + command.operatorName + "; ";
    EXPECT_EQ(names, "arm by A. Hu; start by A. Hu; operator by B. Li; targets by B. Li; stop by B. Li; ");
}

// Catches a fault that a person simulates, or a speed that one chooses, in a recording without a row.
TEST(EngineWorker, RecordsWhoSimulatesAFaultAndChoosesTheSpeed) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    Rig rig;
    rig.send(SetLabels{{"A. Hu", "", ""}});
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{path});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(SetSimulationSpeed{10.0});
    rig.send(SetSimulationSpeed{10.0});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(SimulateFault{SimulatedFault::SourceLimited, 0});
    rig.send(SimulateFault{SimulatedFault::None, 0});
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    std::string names;
    for (const CommandRow& command : session->commands)
        names += command.name + " by " + command.operatorName + "; ";
    EXPECT_EQ(
        names,
        "arm by A. Hu; speed by A. Hu; start by A. Hu; fault by A. Hu; fault by A. Hu; stop by A. Hu; ");
}

TEST(EngineWorker, AnAlarmKeepsWhoHasSeenIt) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    {
        Rig rig(path);
        rig.send(SetLabels{{"A. Hu", "", ""}});
        rig.send(LoadExperiment{oneDisk()});
        ASSERT_TRUE(rig.reaches(RunState::Ready));
        rig.send(Arm{});
        rig.send(Start{});
        ASSERT_TRUE(rig.reaches(RunState::Running));
        rig.send(SimulateFault{SimulatedFault::SensorLost, 0});
        ASSERT_TRUE(rig.waitFor([&] { return !rig.last.alarms.empty(); }));
        EXPECT_EQ(rig.last.alarms[0].seenBy, "");
        rig.send(AcknowledgeAll{});
        ASSERT_TRUE(rig.waitFor([&] { return rig.last.alarms[0].isAcknowledged; }));
        EXPECT_EQ(rig.last.alarms[0].seenBy, "A. Hu");
    }
    const auto kept = readAlarms(path);
    ASSERT_TRUE(kept);
    ASSERT_FALSE(kept->empty());
    EXPECT_EQ(kept->front().seenBy, "A. Hu");
}

// Catches an alarm that came while nothing was recorded and has no trace.
TEST(EngineWorker, AnAlarmWithoutARunIsKept) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    constexpr auto kUnasked = MessageCode::SafetySourceHeatsUnasked;
    {
        Rig rig(path);
        rig.send(SetLabels{{"A. Hu", "", ""}});
        rig.send(SetSimulationSpeed{20.0});
        rig.send(LoadExperiment{oneDisk()});
        ASSERT_TRUE(rig.reaches(RunState::Ready));
        rig.send(SimulateFault{SimulatedFault::SourceHeatsAlone});
        ASSERT_TRUE(rig.waitFor([&] { return isActive(rig.last.alarms, kUnasked); }));
        rig.send(AcknowledgeAll{});
        ASSERT_TRUE(
            rig.waitFor([&] { return std::ranges::all_of(rig.last.alarms, &Alarm::isAcknowledged); }));
        rig.send(SimulateFault{SimulatedFault::None});
        ASSERT_TRUE(rig.waitFor([&] { return !isActive(rig.last.alarms, kUnasked); }));
    }
    const auto kept = readUnrecordedAlarms(unrecordedAlarmFile(path));
    ASSERT_TRUE(kept);
    std::vector<AlarmChange> changes;
    for (const UnrecordedChange& each : kept->changes)
        if (each.message.code == kUnasked) {
            EXPECT_EQ(each.operatorName, "A. Hu");
            changes.push_back(each.change);
        }
    ASSERT_GE(changes.size(), 3U);
    EXPECT_EQ(changes[0], AlarmChange::Raised);
    EXPECT_EQ(changes[1], AlarmChange::Acknowledged);
    EXPECT_EQ(changes[2], AlarmChange::Over);
}

// Catches an alarm that a recording tells, and the file of those without a run, too.
TEST(EngineWorker, AnAlarmOfARunIsNotOneWithoutARun) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("alarms.json").toStdString();
    {
        Rig rig(path);
        rig.send(LoadExperiment{oneDisk()});
        ASSERT_TRUE(rig.reaches(RunState::Ready));
        rig.send(Arm{folder.filePath("run.bask").toStdString()});
        ASSERT_TRUE(rig.reaches(RunState::Armed));
        rig.send(SimulateFault{SimulatedFault::RobotLost});
        ASSERT_TRUE(rig.waitFor([&] { return isActive(rig.last.alarms, MessageCode::ReasonRobotLost); }));
    }
    const auto kept = readUnrecordedAlarms(unrecordedAlarmFile(path));
    ASSERT_TRUE(kept);
    for (const UnrecordedChange& each : kept->changes)
        EXPECT_FALSE(each.change == AlarmChange::Raised && each.key == "RobotLost") << describe(each.message);
}

// Catches targets that cannot be held and are run without a person's word, and one whose Start is lost.
TEST(EngineWorker, AnUnreachableTargetNeedsAnExplicitYes) {
    Rig rig;
    Experiment experiment = oneDisk();
    experiment.objects[0].target_K = kelvinFromCelsius(-20.0); // nothing cools it
    rig.send(LoadExperiment{experiment});
    rig.send(SetSimulationSpeed{20.0});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{false});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::ReasonTargetInfeasible; }));
    EXPECT_EQ(rig.last.state, RunState::Armed);
    rig.send(Start{true});
    EXPECT_TRUE(rig.reaches(RunState::Running));
}

// Catches a Start that is still being judged when STOP comes, and starts the run afterwards.
TEST(EngineWorker, WhatWasBegunIsVoidAfterStop) {
    const QTemporaryDir folder;
    Rig rig;
    rig.send(LoadExperiment{oneDisk()});
    rig.send(SetSimulationSpeed{20.0});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    const std::uint64_t runId = rig.last.runId;
    rig.send(Arm{folder.filePath("run.bask").toStdString()});
    rig.send(Start{});
    rig.send(EmergencyStop{});
    rig.send(Reset{});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    EXPECT_EQ(rig.last.runId, runId + 1) << "the first was never armed";
    rig.send(Start{});
    rig.send(Disarm{});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    const double at_s = rig.last.clock_s;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.clock_s > at_s + 30.0; }));
    EXPECT_EQ(rig.last.state, RunState::Ready);
}

// Catches snapshots and rows that pile up, or are lost, while the window hangs.
TEST(EngineWorker, AWindowThatHangsGetsTheNewestAndEveryRow) {
    Rig rig;
    rig.send(LoadExperiment{oneDisk()});
    rig.send(SetSimulationSpeed{20.0});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{true});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    const double before_s = rig.last.runTime_s;
    const int taken = rig.snapshots;
    std::this_thread::sleep_for(std::chrono::milliseconds(1500)); // it hangs, for thirty snapshots
    QCoreApplication::processEvents();
    EXPECT_LE(rig.snapshots - taken, static_cast<int>(Underway::kMax));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > before_s + 20.0; }));
    EXPECT_TRUE(rig.inOrder);
    // Start falls between two steps of the rig.
    EXPECT_NEAR(static_cast<double>(rig.samples), rig.last.runTime_s / 0.5 + 1.0, 1.0);
}

// Catches pictures of a megabyte each that pile up, and a window that shows old ones afterwards.
TEST(EngineWorker, AWindowThatHangsGetsTwoPicturesAndThenTheNewest) {
    Rig rig;
    rig.send(LoadExperiment{withHalfSizePictures(withMarkers())});
    rig.send(WatchCamera{true, {}});
    ASSERT_TRUE(rig.waitFor([&] { return rig.views > 2; }));
    const int taken = rig.views;
    std::this_thread::sleep_for(std::chrono::milliseconds(1500)); // it hangs
    const double hung_s = rig.view->frame->time_s;
    QCoreApplication::processEvents();
    EXPECT_LE(rig.views - taken, static_cast<int>(Underway::kMax));
    EXPECT_TRUE(rig.waitFor([&] { return rig.view->frame->time_s > hung_s + 1.0; }, 5000));
}

// Catches a second program with the same settings that is not told so.
TEST(EngineWorker, ASecondBaskIsTold) {
    const QTemporaryDir folder;
    const std::string file = folder.filePath("alarms.json").toStdString();
    Rig first(file);
    // It keeps its alarms once it has the lock, whose file is there before the lock is.
    ASSERT_TRUE(first.waitFor([&] { return QFile::exists(folder.filePath("alarms.json")); }));
    Rig second(file);
    ASSERT_TRUE(second.waitFor([&] {
        return std::ranges::any_of(second.events, [](const TraceEvent& event) {
            return describe(event.message).find("alarms-2.json") != std::string::npos;
        });
    }));
    EXPECT_TRUE(first.events.empty());
}

// Catches a recording that ends with the fault that people want to see, an outcome that is not the run's, and
// one that cannot be ended.
TEST(EngineWorker, ARecordingGoesOnAfterStopUntilAPersonEndsIt) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("stop.bask").toStdString();
    Experiment hot = oneDisk();
    hot.objects[0].target_K = kelvinFromCelsius(70.0);
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{hot});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{path});
    rig.send(Start{true});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.latest.objects[0].estimated_K > 320.0; }));
    rig.send(EndRecording{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SessionAlreadyRunning; }));
    rig.send(EmergencyStop{});
    ASSERT_TRUE(rig.reaches(RunState::Fault));
    const double stop_s = rig.last.runTime_s;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > stop_s + 5.0; }));
    EXPECT_EQ(rig.last.recordingPath, path);
    rig.send(EndRecording{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->outcome, "emergency-stop");
    EXPECT_GT(session->samples.back().time_s, stop_s + 4.0);
    EXPECT_LE(session->controlledSamples().back().time_s, stop_s);
    EXPECT_LE(runMetrics(*session).last.time_s, stop_s);
}

// Catches an engine that waits for a camera to be let go (a picture that is looked at, a driver that hangs)
// while STOP and the robot wait for the engine.
TEST(EngineWorker, ChangesNoCameraWhileARunIsOn) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(ChooseCamera{"/nowhere"});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SessionAlreadyRunning; }));
    EXPECT_EQ(rig.last.state, RunState::Running);
}

// Catches a run that is held and ended by a look at the Calibrate page, whose board hid the source.
TEST(EngineWorker, HoldsNoBoardBeforeTheSourceInARun) {
    Rig rig;
    Experiment still = withHalfSizePictures(readExperiment(BASK_EXAMPLES "/moving-source.json").value());
    still.simulation.sourceMotion.clear();
    rig.send(LoadExperiment{still});
    rig.send(SetSimulationSpeed{4.0});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{true});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(WatchCamera{true, parseBoard("charuco:5x7:0.04:0.02:6X6_250").value()});
    const double from_s = rig.last.runTime_s;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > from_s + 10.0; }));
    EXPECT_NE(rig.last.state, RunState::Holding);
    ASSERT_TRUE(rig.last.tracking);
    EXPECT_TRUE(rig.last.tracking->isSeen);
    EXPECT_LT(rig.last.tracking->age_s, 3.0);
}

// The source is carried 10 cm away twenty times as fast as by hand, or as fast as pictures are looked at.
// Catches a run that is held for a source not seen, because simulated time outruns the pictures.
TEST(EngineWorker, FollowsTheSourceWhenTimeIsSpedUp) {
    Rig rig;
    Experiment carried = withHalfSizePictures(readExperiment(BASK_EXAMPLES "/moving-source.json").value());
    Vector6d away = carried.source.pose;
    away[kX] += 0.1;
    carried.simulation.sourceMotion = {{0.0, carried.source.pose}, {5.0, carried.source.pose}, {25.0, away}};
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{carried});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{true});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    const auto isPaused = [&] { return rig.last.state == RunState::Holding; };
    EXPECT_TRUE(rig.waitFor([&] { return isPaused() || rig.last.runTime_s > 40.0; }, 60000));
    EXPECT_FALSE(isPaused()) << rig.last.runTime_s;
    EXPECT_LT((rig.last.latest.source - away).cwiseAbs().maxCoeff(), 0.01);
}

TEST(EngineWorker, RefusesABadExperimentAndKeepsTheOneThatRuns) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    Experiment bad = oneDisk();
    bad.objects[0].material.emittance = 3.0;
    rig.send(LoadExperiment{bad});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::ValueOutOfRange; }));
    EXPECT_EQ(rig.last.state, RunState::Ready);
    rig.send(Arm{});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SessionAlreadyRunning; }));
    EXPECT_EQ(rig.last.state, RunState::Running);
}

TEST(EngineWorker, AnUnwritableRecordingIsRefusedBeforeTheRun) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{"/nowhere/at/all/run.bask"});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code != MessageCode::None; }));
    EXPECT_TRUE(rig.reaches(RunState::Ready));
}

// Catches a recording of before, or one that another process has made since, that is lost to Arm.
TEST(EngineWorker, AnEarlierRecordingIsReplacedOnlyWhereThatIsAsked) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    ASSERT_TRUE((*SessionWriter::create(path, oneDisk(), true))->finish("settled"));
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{path});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::FileUnwritable; }));
    EXPECT_EQ(rig.last.state, RunState::Ready);
    EXPECT_EQ(readSessionHeader(path).outcome, "settled");
    rig.send(Arm{path, true});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    EXPECT_EQ(rig.last.recordingPath, path);
    rig.send(Disarm{});
    ASSERT_TRUE(rig.waitFor([&] { return readSessionHeader(path).outcome == "stopped"; }));
}

TEST(EngineWorker, SimulatedFaultsReachTheOperatorAndResetClearsThem) {
    Rig rig;
    Experiment experiment = oneDisk();
    experiment.safety.pauseLimit_s = 1.0;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(SimulateFault{SimulatedFault::SourceLost});
    ASSERT_TRUE(rig.reaches(RunState::Fault));
    ASSERT_FALSE(rig.last.reasons.empty());
    EXPECT_FALSE(rig.last.heatOn);
    EXPECT_EQ(rig.last.heat, HeatState::Unknown) << "a lost source is not off";
    const auto isRemoved = [&] {
        return std::ranges::any_of(rig.events, [](const TraceEvent& event) {
            return event.message == Message{MessageCode::EventFaultEnded, {"source-lost"}};
        });
    };
    EXPECT_FALSE(isRemoved());
    rig.send(SimulateFault{SimulatedFault::None});
    rig.send(Reset{});
    EXPECT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_EQ(rig.last.heat, HeatState::Off);
    EXPECT_TRUE(isRemoved());
}

// Catches a cold source that is not told before Start, or told with a time while it cannot be known.
TEST(EngineWorker, TellsWhereARunHasTheSourceAndHowSoon) {
    Rig rig;
    Experiment experiment = oneDisk();
    experiment.source.temperatureProfile = {{0.0, kelvinFromCelsius(180.0)},
                                            {600.0, kelvinFromCelsius(200.0)}};
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    ASSERT_TRUE(rig.last.warmUp);
    EXPECT_NEAR(rig.last.warmUp->setPoint_K, kelvinFromCelsius(180.0), 1e-9);
    EXPECT_EQ(rig.last.warmUp->in_s, 0.0) << "a simulated source begins warm";
    rig.send(SetSimulationSpeed{20.0});
    rig.send(SetHeat{kelvinFromCelsius(100.0)}); // colder than a run has it
    ASSERT_TRUE(
        rig.waitFor([&] { return rig.last.source_K && *rig.last.source_K < kelvinFromCelsius(110.0); }));
    EXPECT_NEAR(rig.last.warmUp->setPoint_K, kelvinFromCelsius(180.0), 1e-9);
    EXPECT_GT(rig.last.warmUp->in_s.value_or(0.0), 60.0);
    rig.send(SimulateFault{SimulatedFault::SourceNotHeating});
    EXPECT_TRUE(rig.waitFor([&] { return !rig.last.warmUp->in_s; }));
}

// Catches active faults as they were asked for: one that another replaced, that the robot has ended, that an
// end of another took along, or that is told of the next experiment.
TEST(EngineWorker, TellsTheSimulatedFaultsThatTheRigHas) {
    using Faults = std::vector<ActiveFault>;
    Rig rig;
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_TRUE(rig.last.faults.empty());
    const auto becomes = [&](const Faults& faults) {
        return rig.waitFor([&] { return rig.last.faults == faults; });
    };
    rig.send(SimulateFault{SimulatedFault::SensorLost, 0});
    EXPECT_TRUE(becomes({{SimulatedFault::SensorLost, 0}}));
    rig.send(SimulateFault{SimulatedFault::RobotAlarm});
    EXPECT_TRUE(becomes({{SimulatedFault::RobotAlarm, 0}})) << "it replaces what was before";
    rig.send(ClearRobotAlarm{});
    EXPECT_TRUE(becomes({})) << "the robot has ended it";
    rig.send(SimulateFault{SimulatedFault::SourceSilent});
    ASSERT_TRUE(becomes({{SimulatedFault::SourceSilent, 0}}));
    rig.send(SimulateFault{SimulatedFault::SourceLost, 0, false});
    const int before = rig.snapshots;
    ASSERT_TRUE(rig.waitFor([&] { return rig.snapshots > before + 2; }));
    EXPECT_EQ(rig.last.faults, (Faults{{SimulatedFault::SourceSilent, 0}}));
    rig.send(SimulateFault{SimulatedFault::SourceSilent, 0, false});
    EXPECT_TRUE(becomes({}));
    rig.send(SimulateFault{SimulatedFault::ObjectHot, 0});
    ASSERT_TRUE(becomes({{SimulatedFault::ObjectHot, 0}}));
    const std::uint64_t load = rig.last.loadId;
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.loadId > load; }));
    EXPECT_TRUE(rig.last.faults.empty());
}

// Catches a hold that is over before a person can do anything: its limit of 15 s was 0.75 s of theirs.
TEST(EngineWorker, AHoldIsNotFastForwarded) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    QElapsedTimer timer;
    timer.start();
    rig.send(SimulateFault{SimulatedFault::SensorLost});
    ASSERT_TRUE(rig.reaches(RunState::Holding));
    EXPECT_EQ(rig.last.simulationSpeed, 1.0);
    const double paused_s = rig.last.latest.time_s;
    EXPECT_FALSE(rig.waitFor([&] { return rig.last.state != RunState::Holding; }, 2000));
    EXPECT_LT(rig.last.latest.time_s - paused_s, 2.0 + 1e-3 * static_cast<double>(timer.elapsed()));
    rig.send(SimulateFault{SimulatedFault::None});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.latest.objects[0].valid; }));
    rig.send(Resume{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    EXPECT_EQ(rig.last.simulationSpeed, 20.0);
}

// Catches alarms that are not published, cannot be acknowledged, are not in the record, or are forgotten by a
// restart.
TEST(EngineWorker, AlarmsArePublishedAcknowledgedAndOutliveIt) {
    const QTemporaryDir folder;
    const std::string file = folder.filePath("alarms.json").toStdString();
    const std::string path = folder.filePath("run.bask").toStdString();
    {
        Rig rig(file);
        rig.send(SetSimulationSpeed{20.0});
        rig.send(LoadExperiment{oneDisk()});
        ASSERT_TRUE(rig.reaches(RunState::Ready));
        EXPECT_TRUE(rig.last.alarms.empty());
        rig.send(Arm{path});
        rig.send(Start{});
        ASSERT_TRUE(rig.reaches(RunState::Running));
        rig.send(SimulateFault{SimulatedFault::RobotAlarm});
        ASSERT_TRUE(rig.reaches(RunState::Fault));
        ASSERT_TRUE(rig.waitFor([&] { return !rig.last.alarms.empty(); }));
        const Alarm alarm = rig.last.alarms.front();
        EXPECT_EQ(alarm.message.code, MessageCode::RobotAlarm);
        EXPECT_TRUE(alarm.isActive && !alarm.isFirst && !alarm.isAcknowledged) << "of one";
        EXPECT_GT(alarm.raised_s, 1.7e9);
        rig.send(Reset{}); // still in alarm
        ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::RobotAlarm; }));
        rig.send(AcknowledgeAlarm{alarm.id});
        ASSERT_TRUE(rig.waitFor([&] { return rig.last.alarms.front().isAcknowledged; }));
        rig.send(SimulateFault{SimulatedFault::None});
        rig.send(Reset{});
        ASSERT_TRUE(rig.waitFor([&] { return rig.last.alarms.empty(); }));
        rig.send(SimulateFault{SimulatedFault::SourceLost});
        ASSERT_TRUE(rig.waitFor([&] { return !rig.last.alarms.empty(); }));
    }
    Rig rig(file);
    ASSERT_TRUE(rig.waitFor([&] { return !rig.last.alarms.empty(); }));
    // Beside it, that a lost source takes no order to switch off.
    const auto lost = std::ranges::find_if(
        rig.last.alarms, [](const Alarm& a) { return a.message.code == MessageCode::ReasonSourceLost; });
    ASSERT_NE(lost, rig.last.alarms.end());
    EXPECT_TRUE(lost->isFromBefore);
    EXPECT_FALSE(lost->isActive);
    rig.send(AcknowledgeAll{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.alarms.empty(); }));
    EXPECT_TRUE(rig.waitFor([&] { return readAlarms(file).value().empty(); })) << "written meanwhile";
}

// Catches a recording that is begun on a disk which has no room for it.
TEST(EngineWorker, ARecordingNeedsRoomOnTheDisk) {
    const QTemporaryDir folder;
    Rig rig;
    Experiment experiment = oneDisk();
    experiment.safety.minDisk_MB = 1e6; // a terabyte
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{folder.filePath("run.bask").toStdString()});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SafetyDiskLow; }));
    EXPECT_EQ(rig.last.state, RunState::Ready);
    rig.send(Arm{});
    EXPECT_TRUE(rig.reaches(RunState::Armed));
}

// Catches: a page without pictures, pictures that nobody wants, and a board that is not held before the
// simulated camera.
TEST(EngineWorker, ShowsWhatTheCameraSeesWhileItIsWatched) {
    Rig rig;
    rig.send(LoadExperiment{withMarkers()});
    rig.send(WatchCamera{true, std::nullopt});
    ASSERT_TRUE(rig.waitFor([&] { return shows(rig.view, 1) && shows(rig.view, 12); }));
    EXPECT_EQ(rig.view->cameraName, "simulated");
    EXPECT_EQ(rig.view->problem.code, MessageCode::None);
    EXPECT_FALSE(rig.view->board);
    rig.send(WatchCamera{true, *parseBoard("chessboard:9x6:0.025")});
    ASSERT_TRUE(rig.waitFor([&] { return rig.view->board && rig.view->board->ok(); }));
    rig.send(LoadExperiment{withMarkers()}); // watched on
    const auto before = rig.view;
    ASSERT_TRUE(rig.waitFor([&] { return rig.view != before && rig.view->board; }));
    rig.send(WatchCamera{false, std::nullopt});
    const auto sequence = rig.last.sequence;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.sequence > sequence + 2; }));
    const int views = rig.views;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.sequence > sequence + 12; }));
    EXPECT_EQ(rig.views, views);
}

// Catches: markers changed under a run; markers that are listed and not on the simulated rig.
TEST(EngineWorker, TakesMarkersWhileNoRunIsOn) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    Experiment experiment = withMarkers();
    experiment.source.tracked = false;
    rig.send(LoadExperiment{experiment});
    rig.send(WatchCamera{true, std::nullopt});
    ASSERT_TRUE(rig.waitFor([&] { return shows(rig.view, 2) && shows(rig.view, 3); }));
    VisionSpec fewer = experiment.vision;
    fewer.markers.erase(fewer.markers.begin() + 3);
    rig.send(SetVision{fewer});
    ASSERT_TRUE(rig.waitFor([&] { return shows(rig.view, 2) && !shows(rig.view, 3); }));
    EXPECT_EQ(rig.refusal.code, MessageCode::None);
    VisionSpec twice = experiment.vision;
    twice.markers[1].id = 0;
    rig.send(SetVision{twice});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::MarkerListedTwice; }));
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    rig.send(SetVision{experiment.vision});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::SessionAlreadyRunning; }));
    EXPECT_FALSE(shows(rig.view, 3));
}

// Catches: pictures of one camera told as another's, a camera that cannot be had told as nothing, and no way
// back to the simulated one.
TEST(EngineWorker, AnotherCameraIsWatchedAndTheSimulatedOneAgain) {
    const QTemporaryDir pictures;
    for (const QString& name : {QStringLiteral("/left01.jpg"), QStringLiteral("/left02.jpg")})
        ASSERT_TRUE(
            QFile::copy(QStringLiteral(BASK_TEST_DATA "/calibration") + name, pictures.path() + name));
    const std::string folder = pictures.path().toStdString();
    Rig rig;
    rig.send(LoadExperiment{withMarkers()});
    rig.send(WatchCamera{true, std::nullopt});
    rig.send(ChooseCamera{folder});
    ASSERT_TRUE(rig.waitFor([&] { return rig.view && rig.view->cameraName == folder && rig.view->frame; }));
    EXPECT_EQ(rig.view->frame->picture.width, 640);
    EXPECT_EQ(rig.view->problem.code, MessageCode::CameraSizeOther) << "calibrated for 1280 x 720";
    rig.send(ChooseCamera{"/nowhere/at/all"});
    ASSERT_TRUE(rig.waitFor([&] { return rig.view->cameraName == "/nowhere/at/all"; }));
    ASSERT_TRUE(rig.waitFor([&] { return rig.view->problem.code == MessageCode::CameraNotOpened; }));
    EXPECT_FALSE(rig.view->frame);
    rig.send(ChooseCamera{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.view->cameraName == "simulated" && shows(rig.view, 1); }));
    rig.send(ChooseCamera{folder});
    ASSERT_TRUE(rig.waitFor([&] { return rig.view->cameraName == folder; })); // and ends with it open
}

// Catches: a robot that does not go where the page sends it, goes where it may not, or cannot be stopped.
TEST(EngineWorker, MovesTheRobotAndHoldsIt) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    const Experiment experiment = oneDisk();
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    Vector6d goal = experiment.start;
    goal[kX] += 0.05;
    rig.send(MoveTo{goal});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.isMoving; }));
    ASSERT_TRUE(rig.waitFor([&] { return !rig.last.isMoving; }));
    EXPECT_LT((rig.last.latest.coordinates - goal).cwiseAbs().maxCoeff(), 2e-3);
    goal[kZ] = 1e-4;
    rig.send(MoveTo{goal});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code == MessageCode::MoveOutside; }));
    EXPECT_FALSE(rig.last.isMoving);
    rig.send(MoveTo{experiment.start});
    rig.send(Hold{});
    const auto sequence = rig.last.sequence;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.sequence > sequence + 10; }));
    EXPECT_FALSE(rig.last.isMoving);
    EXPECT_GT((rig.last.latest.coordinates - experiment.start).norm(), 0.02);
}

// Catches edits that come while a real rig says its last words: the engine must end with the newest, and
// obey a STOP among them.
TEST(EngineWorker, OfExperimentsThatComeWhileARigIsClosedTheNewestCounts) {
    Experiment real = oneDisk();
    real.rig = RigSpec();
    real.rig->source = HeatSourceDeviceSpec();
    real.rig->source->driver = "namur";
    real.rig->source->port = "/nowhere/plate";
    Rig rig;
    rig.send(LoadExperiment{real});
    ASSERT_TRUE(rig.waitFor([&] { return !rig.last.simulated; }));
    for (int i = 1; i <= 5; ++i) {
        Experiment edited = real;
        edited.objects[0].target_K = 300.0 + i;
        rig.send(LoadExperiment{edited});
        QElapsedTimer timer;
        timer.start();
        (void)rig.waitFor([&] { return timer.elapsed() > 60; });
    }
    rig.send(EmergencyStop{});
    (void)rig.waitFor([&] { return !rig.last.targets_K.empty() && rig.last.targets_K[0] == 305.0; });
    ASSERT_FALSE(rig.last.targets_K.empty());
    EXPECT_EQ(rig.last.targets_K[0], 305.0);
    EXPECT_TRUE(rig.waitFor([&] {
        return std::ranges::any_of(
            rig.last.reasons, [](const Message& m) { return m.code == MessageCode::ReasonEmergencyStop; });
    }));
}

namespace {

/// A run at 20x that STOP has ended.
void stopARun(EngineThread& rig, const std::string& path) {
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(Arm{path});
    rig.send(Start{true});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    rig.send(EmergencyStop{});
    ASSERT_TRUE(rig.reaches(RunState::Fault));
}

} // namespace

// Catches a recording that ends with STOP where the objects are still cool and the source is hot, one that
// delays the next run or is left without an end by it, and rows that a power failure meanwhile would lose.
TEST(EngineWorker, ARecordingGoesOnBesideAHotSourceUntilTheNextRun) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("stop.bask").toStdString();
    const std::string copy = folder.filePath("copy.bask").toStdString();
    const std::string next = folder.filePath("next.bask").toStdString();
    Rig rig;
    ASSERT_NO_FATAL_FAILURE(stopARun(rig, path));
    const double stop_s = rig.last.runTime_s;
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > stop_s + 20.0; }));
    rig.send(Reset{});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_EQ(rig.last.recordingPath, path);
    EXPECT_TRUE(rig.last.isRecordedUntilCold);
    const std::size_t safe = rig.last.recordedRows;
    ASSERT_TRUE(copySession(path, copy)) << "what is on the disk at this moment";
    const auto cut = readSession(copy);
    ASSERT_TRUE(cut) << describe(cut.error());
    EXPECT_TRUE(cut->interrupted());
    EXPECT_GE(cut->samples.size(), safe);
    EXPECT_LE(runMetrics(*cut).last.time_s, stop_s);
    EXPECT_TRUE(verifySession(copy)->isIntact());
    rig.send(Arm{next});
    ASSERT_TRUE(rig.reaches(RunState::Armed));
    EXPECT_EQ(rig.last.recordingPath, next);
    EXPECT_FALSE(rig.last.isRecordedUntilCold);
    ASSERT_TRUE(rig.waitFor([&] { return readSessionHeader(path).outcome == "emergency-stop"; }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    EXPECT_EQ(session->outcome, "emergency-stop");
    EXPECT_GT(session->samples.back().time_s, stop_s + 15.0);
    EXPECT_LE(readSessionHeader(path).length_s(), stop_s) << "the run's own, without what followed";
    const auto verdict = verifySession(path);
    ASSERT_TRUE(verdict) << describe(verdict.error());
    EXPECT_TRUE(verdict->isIntact());
    EXPECT_TRUE(verdict->isClosed);
}

namespace {

/// A run that STOP ended, and that is still being recorded beside the hot source, after a reset.
void beInTail(EngineThread& rig, const std::string& path) {
    ASSERT_NO_FATAL_FAILURE(stopARun(rig, path));
    rig.send(Reset{});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    ASSERT_EQ(rig.last.recordingPath, path);
}

bool wasTold(const EngineThread& rig, MessageCode code) {
    return std::ranges::any_of(rig.events,
                               [&](const TraceEvent& event) { return event.message.code == code; });
}

} // namespace

// Catches a sample of the cooling after a run that is told as the next one's: a plot then waits for that
// time, and stays empty for minutes.
TEST(EngineWorker, SamplesOfTheRunBeforeAreNotToldAsTheNextOnes) {
    const QTemporaryDir folder;
    EngineThread rig;
    ASSERT_NO_FATAL_FAILURE(beInTail(rig, folder.filePath("run.bask").toStdString()));
    for (int run = 0; run < 5; ++run) { // a sample comes in 25 ms, a snapshot in 60 ms
        ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > 15.0 + run; }));
        QThread::msleep(30); // between two snapshots, after a sample
        rig.send(Arm{folder.filePath(QStringLiteral("next%1.bask").arg(run)).toStdString()});
        ASSERT_TRUE(rig.reaches(RunState::Armed));
        rig.send(Start{true});
        ASSERT_TRUE(rig.waitFor([&] { return rig.last.runTime_s > 3.0 && rig.firstOfRun_s; }));
        EXPECT_LT(*rig.firstOfRun_s, 3.0) << "run " << run;
        rig.send(EmergencyStop{});
        ASSERT_TRUE(rig.reaches(RunState::Fault));
        rig.send(Reset{});
        ASSERT_TRUE(rig.reaches(RunState::Ready));
    }
}

// Catches a full disk that ends what the rig is used for after the run.
TEST(EngineWorker, ARecorderThatFailsAfterTheRunIsToldAndFaultsNothing) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("stop.bask").toStdString();
    Rig rig;
    ASSERT_NO_FATAL_FAILURE(beInTail(rig, path));
    const auto other = SessionStore::create(path);
    ASSERT_TRUE(other) << describe(other.error());
    bool isDropped = false; // it is tried while the recorder has the file to itself, too
    ASSERT_TRUE(
        rig.waitFor([&] { return isDropped = isDropped || (*other)->execute("DROP TABLE step").ok(); }));
    ASSERT_TRUE(rig.waitFor([&] { return wasTold(rig, MessageCode::ReasonRecorderFailed); }));
    EXPECT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
    EXPECT_EQ(rig.last.state, RunState::Ready);
    EXPECT_TRUE(rig.last.reasons.empty());
}

// Catches a retreat that is offered to objects which it has taken away.
TEST(EngineWorker, TellsWhetherTheObjectsAreAway) {
    Rig rig;
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    EXPECT_FALSE(rig.last.isAway);
    rig.send(SetSimulationSpeed{20.0});
    rig.send(Retreat{});
    EXPECT_TRUE(rig.waitFor([&] { return rig.last.isAway && !isRunOn(rig.last.state); }));
}

// Catches heat by hand that is recorded as the cooling of the run before.
TEST(EngineWorker, HeatByHandEndsTheRecordOfTheRunBefore) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("stop.bask").toStdString();
    Rig rig;
    ASSERT_NO_FATAL_FAILURE(beInTail(rig, path));
    rig.send(SetHeat{kelvinFromCelsius(100.0)});
    ASSERT_TRUE(rig.waitFor([&] { return readSessionHeader(path).outcome == "emergency-stop"; }));
    EXPECT_TRUE(rig.waitFor([&] { return wasTold(rig, MessageCode::EventRecordEnded); }));
    EXPECT_TRUE(rig.waitFor([&] { return rig.last.heatOn; }));
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    ASSERT_FALSE(session->events.empty());
    EXPECT_EQ(session->events.back().message.code, MessageCode::EventRecordEnded);
}

// Catches an edit, or the end of the program, that leaves the record of a run without its outcome.
TEST(EngineWorker, AnEditAndTheProgramsEndCloseTheRecordOfTheRunBefore) {
    for (const bool isEdit : {true, false}) {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("stop.bask").toStdString();
        {
            Rig rig;
            ASSERT_NO_FATAL_FAILURE(beInTail(rig, path));
            if (isEdit) {
                Experiment edited = oneDisk();
                edited.objects[0].target_K += 1.0;
                rig.send(LoadExperiment{edited, true});
                ASSERT_TRUE(rig.waitFor([&] { return wasTold(rig, MessageCode::EventRecordEnded); }));
                EXPECT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); }));
                EXPECT_EQ(readSessionHeader(path).outcome, "emergency-stop");
            }
        }
        const auto session = readSession(path);
        ASSERT_TRUE(session) << describe(session.error());
        EXPECT_EQ(session->outcome, "emergency-stop");
    }
}

// Catches a zeroing that is lost with the next edit, after which warm objects could not be armed.
TEST(EngineWorker, AZeroingOutlivesEditsButNotOtherSensors) {
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    Experiment experiment = oneDisk();
    experiment.simulation.sensorOffset_K = 0.5;
    rig.send(LoadExperiment{experiment});
    rig.send(ZeroSensors{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.refusal.code != MessageCode::None; }));
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.zeroProblem.code == MessageCode::None; }));
    EXPECT_FALSE(rig.last.zeroing);
    rig.send(ZeroSensors{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.zeroing.has_value(); }));
    const Zeroing zeroing = *rig.last.zeroing;
    EXPECT_GT(zeroing.utc_s, 1.6e9);
    ASSERT_EQ(zeroing.offsets_K.size(), 1U);

    experiment.objects[0].target_K += 2.0;
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(
        rig.waitFor([&] { return rig.last.targets_K == std::vector{experiment.objects[0].target_K}; }));
    EXPECT_EQ(rig.last.zeroing, zeroing);
    experiment.simulation.seed = 7; // other sensors
    experiment.objects[0].target_K += 2.0;
    rig.send(LoadExperiment{experiment});
    ASSERT_TRUE(
        rig.waitFor([&] { return rig.last.targets_K == std::vector{experiment.objects[0].target_K}; }));
    EXPECT_FALSE(rig.last.zeroing);
}

// Catches a record that does not tell which offsets its temperatures have.
TEST(EngineWorker, ASessionHasTheOffsetsThatWereFoundBeforeArm) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("run.bask").toStdString();
    Rig rig;
    rig.send(SetSimulationSpeed{20.0});
    rig.send(LoadExperiment{oneDisk()});
    ASSERT_TRUE(rig.reaches(RunState::Ready));
    rig.send(ZeroSensors{});
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.zeroing.has_value(); }));
    const Zeroing zeroing = *rig.last.zeroing;
    rig.send(Arm{path});
    rig.send(Start{});
    ASSERT_TRUE(rig.reaches(RunState::Running));
    EXPECT_EQ(rig.last.zeroProblem.code, MessageCode::SessionAlreadyRunning);
    rig.send(Stop{});
    ASSERT_TRUE(rig.reaches(RunState::Stopped));
    EXPECT_EQ(rig.last.zeroing, zeroing);
    ASSERT_TRUE(rig.waitFor([&] { return rig.last.recordingPath.empty(); })) << "it is closed meanwhile";
    const auto session = readSession(path);
    ASSERT_TRUE(session) << describe(session.error());
    const auto arm = std::ranges::find(session->commands, "arm", &CommandRow::name);
    ASSERT_NE(arm, session->commands.end());
    EXPECT_EQ(arm->value, zeroingJson(zeroing));
    const auto start = std::ranges::find(session->commands, "start", &CommandRow::name);
    ASSERT_NE(start, session->commands.end());
    EXPECT_NE(start->value.find(formatNumber(zeroing.environment_K, 10)), std::string::npos) << start->value;
}

} // namespace bask
