#pragma once
// A servo loop on the simulated rig, with one clock that tests set forward.

#include "engine/base/units.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/servo_loop.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {

/// Two painted disks, 8 cm apart along y.
inline Experiment twoDisks(double target_degC) {
    Experiment experiment;
    experiment.title = "two disks";
    for (const double y : {-0.04, 0.04}) {
        ObjectSpec object;
        object.name = y < 0.0 ? "left" : "right";
        object.shape = Disk{0.015};
        object.material = {"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
        object.mounting[kY] = y;
        object.target_K = kelvinFromCelsius(target_degC);
        experiment.objects.push_back(object);
    }
    return experiment;
}

/// Sets the clock of the rig forward by so many sampling periods, with a tick after each.
inline void passPeriods(SimulatedRig& rig, ServoLoop& loop, double period_s, int count) {
    for (int i = 0; i < count; ++i) {
        rig.advance(period_s);
        loop.tick();
    }
}

struct LoopOnRig {
    /// `tracker`: instead of the rig's.
    explicit LoopOnRig(const Experiment& from, SourceTracker* tracker = nullptr)
        : experiment(from), rig(simulatedRigConfig(experiment)),
          loop(experiment,
               {rig.robot(), rig.thermometer(), rig.heatSource(), [this] { return rig.trueTemperatures_K(); },
                tracker ? tracker : &rig.sourceTracker()},
               rig.clock()) {}

    void periods(int count) { passPeriods(rig, loop, experiment.sampling.period_s, count); }
    void startRun(bool acceptInfeasible = false) {
        periods(10);
        ASSERT_TRUE(loop.arm());
        ASSERT_TRUE(loop.start(acceptInfeasible));
    }
    bool reasonGiven(MessageCode code) const {
        return std::ranges::any_of(loop.reasons(), [&](const Message& r) { return r.code == code; });
    }
    bool eventSeen(MessageCode code) {
        const LoopRecord rows = loop.takeRecord();
        return std::ranges::any_of(rows.events, [&](const TraceEvent& e) { return e.message.code == code; });
    }

    Experiment experiment;
    SimulatedRig rig;
    ServoLoop loop;
};

/// With a heat source of the test's own over the rig's, as one that does not obey.
template <class Source> struct LoopWithSource {
    explicit LoopWithSource(const Experiment& from)
        : experiment(from), rig(simulatedRigConfig(experiment)), source(rig.heatSource()),
          loop(experiment, {rig.robot(), rig.thermometer(), source, {}}, rig.clock()) {}

    void periods(int count) { passPeriods(rig, loop, experiment.sampling.period_s, count); }

    Experiment experiment;
    SimulatedRig rig;
    Source source;
    ServoLoop loop;
};

} // namespace bask
