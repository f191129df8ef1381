#pragma once
// A simulated rig and its loop, advanced together as fast as the machine goes.

#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"
#include "engine/simulation/simulated_rig.h"
#include "engine/vision/camera_source_tracker.h"

#include <memory>

namespace bask {

class SimulatedDrive {
public:
    /// Of an experiment that validates.
    explicit SimulatedDrive(const Experiment& experiment);

    ServoLoop& loop() { return m_loop; }
    const Clock& clock() { return m_rig.clock(); }
    /// A sampling period of the rig, its faults that are due, and a tick.
    void period();

private:
    void advance();

    double m_period_s;
    SimulatedRig m_rig;
    std::unique_ptr<CameraSourceTracker> m_camera; ///< where the camera follows the source
    ServoLoop m_loop;
    FaultScript m_script;
};

} // namespace bask
