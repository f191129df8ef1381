#pragma once
// A rig, simulated or real, with the loop of one experiment on it.

#include "engine/rig/real_rig.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"
#include "engine/vision/vision_thread.h"

#include <memory>

namespace bask {

/// What stays from one session to the next.
struct KeptRig {
    std::unique_ptr<RealRig> rig;
    std::unique_ptr<VisionThread> watcher; ///< of its camera
};

/// Made anew with each experiment, on the engine's thread.
struct EngineSession {
    /// On that rig, or on a simulated one.
    EngineSession(const Experiment& experiment, const Clock& wall, KeptRig kept);

    const Clock& clock() const { return simulated ? simulated->clock() : steady; }
    /// Writes what is known of rig and loop into a snapshot.
    void tell(Snapshot& snapshot) const;

    /// By the camera where the experiment has what that takes.
    struct Tracker final : SourceTracker {
        explicit Tracker(EngineSession& owner) : session(owner) {}
        Result<PoseReading> read() override;
        EngineSession& session;
    };

    const Clock& steady;
    std::unique_ptr<SimulatedRig> simulated; ///< this or the next
    std::unique_ptr<RealRig> real;
    std::unique_ptr<VisionThread> vision; ///< where there is a camera
    Tracker tracker;
    ServoLoop loop;
    FaultScript script;

private:
    RigDevices devices();
};

/// Offsets that were found with one experiment hold for the other.
bool haveSameSensors(const Experiment& a, const Experiment& b);

} // namespace bask
