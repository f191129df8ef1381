// Safety limits and scripted faults in an experiment's file.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

Experiment twoCircles() {
    return readExperiment(BASK_EXAMPLES "/two-circles.json").value();
}

} // namespace

// Catches a limit that is lost on its way through the file.
TEST(SafetySpec, AllGoesThroughTheFile) {
    Experiment e = twoCircles();
    e.safety = {360.0, 380.0, 600.0, 5.0, 20.0, 7.0, 4, 45.0, 6.0, 9.0, 200.0, 12.0, 15.0, 250.0};
    e.objects[0].warning_K = 340.25;
    e.objects[1].trip_K = 400.0;
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        e.simulation.faults.push_back({10.0 * i, fault, isOfObject(fault) ? 1U : 0U, {}});
    }
    e.simulation.faults[3].until_s = 99.0;
    const auto read = experimentFromJson(experimentToJson(e), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(*read, e);
}

// Catches defaults written into every file, and limits that are not those of the documents.
TEST(SafetySpec, TheDefaultsAreNotWritten) {
    const Experiment e = twoCircles();
    EXPECT_EQ(experimentToJson(e).find("safety"), std::string::npos);
    EXPECT_NEAR(warningLimit_K(e, e.objects[0]), kelvinFromCelsius(120.0), 1e-9);
    EXPECT_NEAR(tripLimit_K(e, e.objects[0]), kelvinFromCelsius(150.0), 1e-9);
    EXPECT_NEAR(sourceTripLimit_K(e), e.source.temperature_K + 50.0, 1e-9);
    Experiment profile = e;
    profile.source.temperatureProfile = {{0.0, 473.15}, {100.0, 573.15}};
    EXPECT_NEAR(sourceTripLimit_K(profile), 623.15, 1e-9);
}

// Catches limits that can never act, or that act before the other.
TEST(SafetySpec, LimitsThatContradictAreRefused) {
    const auto refusedAt = [](auto change) {
        Experiment e = twoCircles();
        change(e);
        const auto valid = validate(e);
        return valid ? std::string() : valid.error().where;
    };
    EXPECT_EQ(refusedAt([](Experiment& e) { e.safety.trip_K = e.safety.warning_K - 1.0; }),
              "safety.trip_degC");
    EXPECT_EQ(refusedAt([](Experiment& e) { e.objects[1].warning_K = e.safety.trip_K + 1.0; }),
              "objects[1].trip_degC");
    EXPECT_EQ(refusedAt([](Experiment& e) { e.safety.sourceTrip_K = e.source.temperature_K - 1.0; }),
              "safety.source_trip_degC");
    EXPECT_EQ(refusedAt([](Experiment& e) { e.safety.stalePeriods = 0.5; }), "safety.stale_periods");
    EXPECT_EQ(refusedAt([](Experiment& e) { e.safety.frozen_s = 0.0; }), "safety.frozen_s");
    EXPECT_EQ(refusedAt([](Experiment& e) {
                  e.simulation.faults = {{1.0, SimulatedFault::SensorOpen, 2, {}}};
              }),
              "simulation.faults[0].object");
    EXPECT_EQ(refusedAt([](Experiment& e) {
                  e.simulation.faults = {{5.0, SimulatedFault::RobotLost, 0, 4.0}};
              }),
              "simulation.faults[0].until_s");
}

// Catches an unknown fault that is taken for none.
TEST(SafetySpec, AnUnknownFaultIsRefusedWithTheKnownOnes) {
    std::string text = experimentToJson(twoCircles());
    const std::string key = "\"seed\":";
    text.insert(text.find(key), R"("faults": [{"time_s": 1, "fault": "sensor-opn"}], )");
    const auto read = experimentFromJson(text, "", "");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().where, "simulation.faults[0].fault");
    EXPECT_NE(describe(read.error()).find("sensor-open"), std::string::npos);
}

} // namespace bask
