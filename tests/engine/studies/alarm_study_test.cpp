// The study of alarms in short: runs at random without a false word, faults that are found in the time that
// docs/safety.md states. Its long form is `bask study alarms`.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/studies/alarm_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace bask {
namespace {

// Numbers of runs with both, of seed 1.
constexpr int kJumpingRun = 26, kSwappedRun = 28, kNearRun = 7, kDriftingRun = 88;

std::vector<Experiment> rigs(const std::vector<std::string>& names) {
    std::vector<Experiment> out;
    for (const std::string& name : names) {
        auto rig = readExperiment(BASK_EXAMPLES "/" + name);
        EXPECT_TRUE(rig) << name;
        if (rig)
            out.push_back(std::move(*rig));
    }
    return out;
}

// Catches a study of objects that nobody can build.
TEST(AlarmStudy, ObjectsThroughEachOtherAreRefused) {
    AlarmStudy study;
    study.rigs = rigs({"three-objects.json", "two-circles.json"});
    study.count = 1;
    ObjectSpec& right = study.rigs[1].objects[1];
    right.mounting = study.rigs[1].objects[0].mounting;
    right.mounting[kThetaX] = 1.0;
    const auto rows = runAlarmStudy(study, 1, {});
    ASSERT_FALSE(rows);
    EXPECT_EQ(rows.error().code(), MessageCode::MountingOverlap);
}

void expectNoFalseWord(const AlarmStudy& study) {
    const auto rows = runAlarmStudy(study, 0, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    for (std::size_t k = 0; k < rows->size(); ++k) {
        EXPECT_TRUE((*rows)[k].refusal.empty()) << "run " << k << ": " << (*rows)[k].refusal;
        for (const RaisedAlarm& alarm : (*rows)[k].alarms)
            EXPECT_FALSE(alarm.isFalse) << "run " << k << ", " << alarm.time_s << " s: " << alarm.sentence;
    }
    const AlarmSummary summary = summarize(*rows);
    EXPECT_EQ(summary.falseTrips, 0);
    EXPECT_LE(summary.per10min[0] + summary.per10min[1] + summary.per10min[2], 1.0);
}

/// Longest from when a fault shows itself to when it is found, s, as docs/safety.md states it.
double statedTime_s(SimulatedFault fault, ReadBy readBy) {
    if (fault == SimulatedFault::CameraLost && readBy == ReadBy::Both)
        return 10.0; // of a second opinion
    static const std::map<SimulatedFault, double> stated{
        {SimulatedFault::SensorFrozen, 60.0},     {SimulatedFault::SensorOff, 180.0},
        {SimulatedFault::ObjectHot, 15.0},        {SimulatedFault::SourceNotHeating, 240.0},
        {SimulatedFault::SourceHeatsAlone, 15.0}, {SimulatedFault::SourceOverheats, 30.0},
        {SimulatedFault::SourceLimited, 12.0},    {SimulatedFault::SensorsSwapped, 30.0},
    };
    const auto found = stated.find(fault);
    return found == stated.end() ? 5.0 : found->second;
}

void expectFound(const AlarmStudy& study) {
    const auto rows = runAlarmStudy(study, 0, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    const AlarmSummary summary = summarize(*rows);
    EXPECT_LE(summary.maxIn10min, 10);
    if (study.readBy != ReadBy::Camera) { // without the faults of sensors
        EXPECT_NEAR(summary.shares[0], 0.05, 0.05) << "of priority 1, near what EEMUA 191 asks for";
        EXPECT_NEAR(summary.shares[2], 0.80, 0.15) << "of priority 3";
    }
    for (const FaultSummary& fault : summary.faults) {
        EXPECT_EQ(fault.found, fault.shown) << simulatedFaultName(fault.fault);
        EXPECT_LE(fault.worst_s, statedTime_s(fault.fault, study.readBy)) << simulatedFaultName(fault.fault);
    }
}

} // namespace

// Catches a draw that depends on the threads, or is the same each time, or cannot be repeated alone.
TEST(AlarmStudy, ItsRowsAreOfSeedAndIndexAlone) {
    AlarmStudy study{rigs({"three-objects.json"}), AlarmDraw::Faulty, 3, 7};
    const auto one = runAlarmStudy(study, 1, {});
    const auto two = runAlarmStudy(study, 2, {});
    ASSERT_TRUE(one && two);
    EXPECT_EQ(alarmCsv(study, *one), alarmCsv(study, *two));
    const AlarmStudy last{study.rigs, study.draw, 1, study.seed, 3};
    const auto repeated = runAlarmStudy(last, 1, {});
    ASSERT_TRUE(repeated);
    EXPECT_TRUE(alarmCsv(study, *one).ends_with(alarmCsv(last, *repeated).substr(alarmCsv(last, {}).size())));
    study.seed = 8;
    const auto other = runAlarmStudy(study, 2, {});
    ASSERT_TRUE(other);
    EXPECT_NE(alarmCsv(study, *one), alarmCsv(study, *other));
}

// Catches alarms that cry wolf, whatever object, source, controller, sensor and operator.
TEST(AlarmStudy, HealthyRunsHaveNoFalseWord) {
    expectNoFalseWord(
        {rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy, 24, 1});
}

// Its rates are wrong by 3.64. Catches a watch that takes its estimate for better than that.
TEST(AlarmStudy, AnExperimentOfThePaperEndsByNoFalseAlarm) {
    expectNoFalseWord({rigs({"paper/three-objects-exp-7.json"}), AlarmDraw::Paper, 24, 1});
}

// Catches faults that nobody is told, or too late.
TEST(AlarmStudy, FaultsAreFoundInTheTimeThatIsStated) {
    const int each = 2;
    expectFound({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Faulty,
                 each * static_cast<int>(alarmFaults(ReadBy::Contact).size()), 1});
}

// Catches a draw that never ends since the only rig has one object, whose sensor is swapped with none.
TEST(AlarmStudy, NoSensorIsSwappedWithNone) {
    auto rig = rigs({"three-objects.json"});
    rig.front().objects.resize(1);
    const auto faults = alarmFaults(ReadBy::Both);
    const auto swapped = std::ranges::find(faults, SimulatedFault::SensorsSwapped) - faults.begin();
    EXPECT_THROW((void)drawAlarmCase(rig, AlarmDraw::Faulty, ReadBy::Both, 1, static_cast<int>(swapped)),
                 std::invalid_argument);
}

// Catches a camera whose draws change the runs beside which it stands.
TEST(AlarmStudy, ACameraIsDrawnBesideTheSameRun) {
    const auto rig = rigs({"three-objects.json", "three-objects-in-line.json"});
    for (int index = 0; index < 5; ++index) {
        const AlarmCase by = drawAlarmCase(rig, AlarmDraw::Healthy, ReadBy::Contact, 1, index);
        const AlarmCase both = drawAlarmCase(rig, AlarmDraw::Healthy, ReadBy::Both, 1, index);
        EXPECT_FALSE(by.experiment.simulation.thermalCamera);
        ASSERT_TRUE(both.experiment.simulation.thermalCamera);
        EXPECT_EQ(both.experiment.simulation.seed, by.experiment.simulation.seed);
        EXPECT_EQ(both.experiment.start, by.experiment.start);
        EXPECT_EQ(both.actions.size(), by.actions.size());
        ASSERT_EQ(both.experiment.objects.size(), by.experiment.objects.size());
        for (std::size_t i = 0; i < by.experiment.objects.size(); ++i) {
            const ObjectSpec &seen = both.experiment.objects[i], &read = by.experiment.objects[i];
            EXPECT_EQ(seen.readBy, ReadBy::Both);
            EXPECT_EQ(seen.target_K, read.target_K);
            EXPECT_EQ(seen.simulatedMaterial, read.material);
            EXPECT_NEAR(seen.material.emittance, read.material.emittance, kAlarmEmittance);
        }
    }
}

// Catches a second opinion that doubts good sensors, or says that it cannot read what it could.
TEST(AlarmStudy, ACameraBesideGoodSensorsTellsNothingFalse) {
    expectNoFalseWord({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy, 6, 1,
                       1, ReadBy::Both});
}

// Catches sensors called swapped since the camera's error changed by kelvins within half a minute.
TEST(AlarmStudy, ACameraThatErrsOtherwiseThanBeforeTellsNothingFalse) {
    expectNoFalseWord({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy, 1, 1,
                       kDriftingRun, ReadBy::Both});
}

// Catches what the camera alone tells of an object taken for what its heat does not explain: of run 20 a
// small one before the hot source.
TEST(AlarmStudy, ACameraAloneTellsNothingFalse) {
    expectNoFalseWord({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy, 1, 1,
                       20, ReadBy::Camera});
}

// Catches swapped sensors that nobody is told of, or late: of objects 0.7 K apart.
TEST(AlarmStudy, SwappedSensorsOfObjectsNearlyAsWarmAreToldSoonWithACamera) {
    const auto rows = runAlarmStudy({rigs({"three-objects.json", "three-objects-in-line.json"}),
                                     AlarmDraw::Faulty, 1, 1, kNearRun, ReadBy::Both},
                                    1, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    const AlarmStudyRow& row = rows->front();
    ASSERT_EQ(row.drawn.fault, SimulatedFault::SensorsSwapped);
    EXPECT_LT(row.apartSoon_K, 1.0);
    EXPECT_LE(row.told_s.value_or(1e9), 10.0);
}

// Catches swapped sensors that nobody is told of, or late.
TEST(AlarmStudy, SwappedSensorsAreFoundWithACamera) {
    const auto rows = runAlarmStudy({rigs({"three-objects.json", "three-objects-in-line.json"}),
                                     AlarmDraw::Faulty, 1, 1, kSwappedRun, ReadBy::Both},
                                    1, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    const AlarmStudyRow& row = rows->front();
    ASSERT_EQ(row.drawn.fault, SimulatedFault::SensorsSwapped);
    ASSERT_TRUE(row.acted_s);
    EXPECT_LE(*row.acted_s - row.shown_s.value_or(0.0), 30.0);
}

// Catches bare metal that is told to be unusable again and again, and a true word that is counted as false.
TEST(AlarmStudy, BareMetalIsToldOnceInAWhileWithACamera) {
    constexpr int kBareRun = 162;
    const AlarmStudy study{rigs({"three-objects.json", "three-objects-in-line.json"}),
                           AlarmDraw::Healthy,
                           1,
                           1,
                           kBareRun,
                           ReadBy::Both};
    const auto rows = runAlarmStudy(study, 1, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    EXPECT_GE(rows->front().alarms.size(), 1U);
    EXPECT_LE(rows->front().alarms.size(), 6U); // 13 in half an hour before
    EXPECT_EQ(summarize(*rows).falseWords, 0);
}

// Catches a camera that repeats, as long as a sensor jumps, that it differs from it.
TEST(AlarmStudy, AJumpingSensorIsNoFloodOfAlarmsWithACamera) {
    const auto rows = runAlarmStudy({rigs({"three-objects.json", "three-objects-in-line.json"}),
                                     AlarmDraw::Faulty, 1, 1, kJumpingRun, ReadBy::Both},
                                    1, {});
    ASSERT_TRUE(rows) << describe(rows.error());
    ASSERT_EQ(rows->front().drawn.fault, SimulatedFault::SensorJumping);
    EXPECT_TRUE(rows->front().acted_s);
    EXPECT_LE(summarize(*rows).maxIn10min, 5);
}

TEST(AlarmStudyLong, healthy) {
    expectNoFalseWord(
        {rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy, 2000, 1});
}

TEST(AlarmStudyLong, faulty) {
    expectFound({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Faulty,
                 200 * static_cast<int>(alarmFaults(ReadBy::Contact).size()), 1});
}

TEST(AlarmStudyLong, healthyWithACamera) {
    for (const ReadBy readBy : {ReadBy::Both, ReadBy::Camera})
        expectNoFalseWord({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Healthy,
                           200, 1, 1, readBy});
}

TEST(AlarmStudyLong, faultyWithACamera) {
    for (const ReadBy readBy : {ReadBy::Both, ReadBy::Camera})
        expectFound({rigs({"three-objects.json", "three-objects-in-line.json"}), AlarmDraw::Faulty,
                     10 * static_cast<int>(alarmFaults(readBy).size()), 1, 1, readBy});
}

// Catches a second opinion that waits where the camera tells the two objects apart: docs/safety.md has the
// distribution. Of objects nearer than 0.7 K nothing tells soon.
TEST(AlarmStudyLong, swappedWithACamera) {
    constexpr int kRuns = 160;
    constexpr double kTold_K = 0.7, kPlain_K = 2.0;
    const auto faults = alarmFaults(ReadBy::Both);
    const auto count = static_cast<int>(faults.size());
    const auto swapped =
        static_cast<int>(std::ranges::find(faults, SimulatedFault::SensorsSwapped) - faults.begin());
    const auto drawn = rigs({"three-objects.json", "three-objects-in-line.json"});
    int apart = 0, soon = 0, plain = 0, plainSoon = 0;
    for (int k = 0; k < kRuns; ++k) {
        const int number = 1 + swapped + k * count; // counted from 1
        const auto rows = runAlarmStudy({drawn, AlarmDraw::Faulty, 1, 1, number, ReadBy::Both}, 1, {});
        ASSERT_TRUE(rows) << describe(rows.error());
        const AlarmStudyRow& row = rows->front();
        ASSERT_EQ(row.drawn.fault, SimulatedFault::SensorsSwapped);
        const bool isSoon = row.told_s.value_or(1e9) <= 10.0;
        if (row.apartSoon_K >= kTold_K) {
            ++apart;
            soon += isSoon ? 1 : 0;
        }
        if (row.apartSoon_K >= kPlain_K) {
            ++plain;
            plainSoon += isSoon ? 1 : 0;
            EXPECT_LE(row.told_s.value_or(1e9), 60.0) << "run " << number;
        }
    }
    RecordProperty("apart", apart);
    RecordProperty("told_soon", soon);
    EXPECT_GT(plain, kRuns / 3);
    EXPECT_GE(plainSoon, 0.97 * plain);
    EXPECT_GE(soon, 0.9 * apart);
}

} // namespace bask
