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

/// What of the sensors an edit of the experiment leaves.
struct KeptSensors {
    SensorChannels channels;          ///< one for each object of the edited experiment
    std::vector<std::size_t> ofNew{}; ///< those of objects that the simulated rig did not have
};

/// Created again for each experiment, on the engine's thread.
struct EngineSession {
    /// Uses the kept rig, or a simulated one if there is none.
    EngineSession(const Experiment& experiment, const Clock& wall, KeptRig kept);

    const Clock& clock() const { return simulated ? simulated->clock() : steady; }
    /// Returns what of a simulated rig an edit to this experiment leaves; empty for another rig.
    std::optional<RigCondition> condition(const Experiment& edited) const;
    /// Returns its zeroing if it holds for another experiment's sensors: of an edited one on the simulated
    /// rig by the objects' names, else by their places.
    std::optional<Zeroing> zeroingFor(const Experiment& other, bool isEdit) const;
    /// Returns its sensors as another session of the same rig uses them, a channel for each object of the
    /// edited experiment. Empty if sensors or sampling are others.
    std::optional<KeptSensors> sensorsFor(const Experiment& edited) const;
    /// Goes on with the sensors of the session before. Of an object that a simulated rig has got since then,
    /// which rests at the room's temperature, the sensor tells a window of readings at once, and is zeroed as
    /// the others are.
    void useSensors(const KeptSensors& before);
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

/// Returns which object of the experiment before each one of the edited experiment was: by its name, or,
/// where objects have only got other names, by its place; empty: it is new.
std::vector<std::optional<std::size_t>> objectsBefore(const Experiment& before, const Experiment& edited);

/// Returns whether sensor offsets found with one experiment are valid for the other.
bool haveSameSensors(const Experiment& a, const Experiment& b);

} // namespace bask
