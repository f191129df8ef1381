// Which faults the simulated rig has, as its devices tell, and which would show nothing.

#include "engine/runtime/fault_effect.h"
#include "engine/runtime/fault_script.h"
#include "tests/engine/runtime/loop_on_rig.h"

#include <cmath>

namespace bask {
namespace {

using Faults = std::vector<ActiveFault>;

struct FaultyRig {
    Experiment experiment = twoDisks(40.0);
    SimulatedRig rig{simulatedRigConfig(experiment)};
    Faults faults() { return activeFaults(rig); }
};

/// What a source would have told after a minute, with or without a fault that began at once.
double sourceAfterAMinute_K(SimulatedFault fault, bool isHeated) {
    FaultyRig bench;
    HeatSource& source = bench.rig.heatSource();
    const auto go = [&](double for_s, bool isOn) {
        if (isOn)
            EXPECT_TRUE(source.keepHeating(473.15, for_s + 1.0));
        else
            EXPECT_TRUE(source.heatOff());
        bench.rig.advance(for_s);
    };
    go(10.0, true); // heated once: it cools from then on
    go(60.0, false);
    if (isHeated)
        go(0.1, true);
    setFault(bench.rig, fault, 0, true);
    if (isHeated)
        go(60.0, true);
    else
        bench.rig.advance(60.0);
    return source.read()->value_K;
}

} // namespace

// Catches a fault that is set and not told, or told of another object, and one that cannot be ended alone.
TEST(SimulatedFaults, EachIsToldWhileItIsOn) {
    FaultyRig bench;
    EXPECT_TRUE(bench.faults().empty());
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        const std::size_t object = isOfObject(fault) ? 1 : 0;
        setFault(bench.rig, fault, object, true);
        EXPECT_EQ(bench.faults(), (Faults{{fault, object}})) << simulatedFaultName(fault);
        bench.rig.advance(1.0);
        EXPECT_EQ(bench.faults(), (Faults{{fault, object}})) << simulatedFaultName(fault);
        endFault(bench.rig, fault, object);
        EXPECT_TRUE(bench.faults().empty()) << simulatedFaultName(fault);
    }
    setFault(bench.rig, SimulatedFault::SensorLost, 7, true);
    endFault(bench.rig, SimulatedFault::SensorLost, 7);
    EXPECT_TRUE(bench.faults().empty()) << "there is no such object";
}

// Catches an end that takes others along, of the same device or of another.
TEST(SimulatedFaults, TheEndOfOneLeavesTheOthers) {
    FaultyRig bench;
    setFault(bench.rig, SimulatedFault::SensorLost, 0, true);
    setFault(bench.rig, SimulatedFault::ObjectHot, 1, true);
    setFault(bench.rig, SimulatedFault::RobotAlarm, 0, true);
    const Faults all{
        {SimulatedFault::SensorLost, 0}, {SimulatedFault::ObjectHot, 1}, {SimulatedFault::RobotAlarm, 0}};
    EXPECT_EQ(bench.faults(), all);
    endFault(bench.rig, SimulatedFault::SensorOpen, 0);
    endFault(bench.rig, SimulatedFault::RobotSlow, 0);
    endFault(bench.rig, SimulatedFault::ObjectHot, 0);
    EXPECT_EQ(bench.faults(), all);
    endFault(bench.rig, SimulatedFault::ObjectHot, 1);
    EXPECT_EQ(bench.faults(), (Faults{all[0], all[2]}));
    clearFaults(bench.rig);
    EXPECT_TRUE(bench.faults().empty());
}

// Catches a fault that is told although the device has ended it.
TEST(SimulatedFaults, WhatTheRobotHasEndedIsOver) {
    FaultyRig bench;
    setFault(bench.rig, SimulatedFault::RobotAlarm, 0, true);
    EXPECT_TRUE(bench.rig.robot().clearAlarm());
    EXPECT_TRUE(bench.faults().empty());
    setFault(bench.rig, SimulatedFault::RobotRestarted, 0, true);
    EXPECT_TRUE(bench.rig.robot().home());
    EXPECT_TRUE(bench.faults().empty());
}

// Catches a fault of a sensor offered for an object that has none, and a swap with nothing.
TEST(FaultEffect, SensorsAreWhatTheRigReads) {
    Experiment experiment = twoDisks(40.0);
    const auto of = [&](SimulatedFault fault, std::size_t object) {
        return faultEffect(experiment, HeatState::Off, fault, object);
    };
    EXPECT_EQ(of(SimulatedFault::SensorFrozen, 0), FaultEffect::AtOnce);
    EXPECT_EQ(of(SimulatedFault::SensorOff, 0), FaultEffect::WhenWarm);
    EXPECT_EQ(of(SimulatedFault::SensorsSwapped, 0), FaultEffect::WhenApart);
    experiment.objects[0].readBy = ReadBy::Camera;
    for (const SimulatedFault fault :
         {SimulatedFault::SensorLost, SimulatedFault::SensorOpen, SimulatedFault::SensorShort,
          SimulatedFault::SensorFrozen, SimulatedFault::SensorJumping, SimulatedFault::SensorOff}) {
        EXPECT_EQ(of(fault, 0), FaultEffect::NoneByCamera) << simulatedFaultName(fault);
        EXPECT_FALSE(showsNothing(of(fault, 1))) << simulatedFaultName(fault);
    }
    EXPECT_EQ(of(SimulatedFault::ObjectHot, 0), FaultEffect::AtOnce);
    EXPECT_FALSE(showsNothing(of(SimulatedFault::SensorsSwapped, 0))) << "the other one is read";
    experiment.objects[1].readBy = ReadBy::Camera;
    EXPECT_EQ(of(SimulatedFault::SensorsSwapped, 0), FaultEffect::NoneByCamera);
    experiment.objects.pop_back();
    EXPECT_EQ(of(SimulatedFault::SensorsSwapped, 0), FaultEffect::NoneAlone);
}

// Catches a hand before markers that are not there, and a camera that nothing uses.
TEST(FaultEffect, TheCameraIsWhatFollowsTheSource) {
    Experiment experiment = twoDisks(40.0);
    const auto of = [&](SimulatedFault fault) { return faultEffect(experiment, HeatState::Off, fault, 0); };
    EXPECT_EQ(of(SimulatedFault::SourceCovered), FaultEffect::NoneUnmarked);
    EXPECT_EQ(of(SimulatedFault::CameraLost), FaultEffect::NoneUnused);
    EXPECT_TRUE(showsNothing(FaultEffect::NoneUnused));
    experiment.vision.markers = {{Part::Source, 3, 0.05}};
    EXPECT_EQ(of(SimulatedFault::SourceCovered), FaultEffect::InPictures);
    EXPECT_EQ(of(SimulatedFault::CameraLost), FaultEffect::NoneUnused) << "markers alone hold no run";
    experiment.source.tracked = true;
    EXPECT_EQ(of(SimulatedFault::SourceCovered), FaultEffect::AtOnce);
    EXPECT_EQ(of(SimulatedFault::CameraLost), FaultEffect::AtOnce);
}

// Catches a reason that is not so: a source that has been told to show nothing has to show nothing.
TEST(FaultEffect, WhatIsSaidToShowNothingOfTheSourceShowsNothing) {
    const Experiment experiment = twoDisks(40.0);
    int hindered = 0;
    for (const SimulatedFault fault :
         {SimulatedFault::SourceNotHeating, SimulatedFault::SourceLimited, SimulatedFault::SourceKeepsHeat,
          SimulatedFault::SourceHeatsAlone, SimulatedFault::SourceOverheats}) {
        for (const bool isHeated : {false, true}) {
            const FaultEffect effect =
                faultEffect(experiment, isHeated ? HeatState::On : HeatState::Off, fault, 0);
            if (effect == FaultEffect::WhenOff)
                continue;
            const double difference_K =
                sourceAfterAMinute_K(fault, isHeated) - sourceAfterAMinute_K(SimulatedFault::None, isHeated);
            EXPECT_EQ(showsNothing(effect), std::abs(difference_K) < 1e-9)
                << simulatedFaultName(fault) << (isHeated ? " heated, " : " not heated, ") << difference_K;
            hindered += showsNothing(effect) ? 1 : 0;
        }
        EXPECT_FALSE(showsNothing(faultEffect(experiment, HeatState::Unknown, fault, 0)))
            << simulatedFaultName(fault);
    }
    EXPECT_EQ(hindered, 4);
}

} // namespace bask
