#pragma once
// A rig, simulated or real, with the servo loop of one experiment.

#include "engine/rig/missing_devices.h"
#include "engine/rig/object_thermometer.h"
#include "engine/rig/real_rig.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"
#include "engine/vision/vision_thread.h"

#include <memory>

namespace bask {

/// What is kept from one session to the next.
struct KeptRig {
    std::unique_ptr<RealRig> rig;
    std::unique_ptr<VisionThread> watcher; ///< reads its camera
    std::optional<RigCondition> condition; ///< of a simulated rig
};

/// Created again for each experiment, on the engine's thread.
struct EngineSession {
    /// Uses the kept rig, or a simulated one if there is none.
    EngineSession(const Experiment& experiment, const Clock& wall, KeptRig kept);

    const Clock& clock() const { return simulated ? simulated->clock() : steady; }
    /// Returns what of a simulated rig an edit to this experiment leaves; empty for another rig.
    std::optional<RigCondition> condition(const Experiment& edited) const;
    /// Writes the state of rig and loop into a snapshot.
    void tell(Snapshot& snapshot) const;

    /// Follows the source by the camera if the experiment has all that this needs; otherwise, on a simulated
    /// rig, by the true pose.
    struct Tracker final : SourceTracker {
        explicit Tracker(EngineSession& owner) : session(owner) {}
        Result<PoseReading> read() override;
        EngineSession& session;
    };

    const Clock& steady;
    std::unique_ptr<SimulatedRig> simulated; ///< either this or `real` is set
    std::unique_ptr<RealRig> real;
    std::unique_ptr<ObjectThermometer> thermometer; ///< null without a thermal camera
    MissingThermometer noCamera{"thermal camera"};  ///< where objects are read by one that is not there
    std::unique_ptr<VisionThread> vision;           ///< null without a camera
    Tracker tracker;
    ServoLoop loop;
    FaultScript script;

private:
    SourceWarmUp warmUp() const;
    RigDevices devices(const Experiment& experiment);
    Thermometer& thermometerOf(const Experiment& experiment);
};

/// Returns whether sensor offsets found with one experiment are valid for the other.
bool haveSameSensors(const Experiment& a, const Experiment& b);

} // namespace bask
