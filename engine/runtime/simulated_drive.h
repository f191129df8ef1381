#pragma once
// A simulated rig and its loop, advanced together as fast as the computer can.

#include "engine/rig/object_thermometer.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"
#include "engine/simulation/simulated_rig.h"
#include "engine/vision/camera_source_tracker.h"

#include <memory>

namespace bask {

class SimulatedDrive {
public:
    /// `experiment` must be valid.
    explicit SimulatedDrive(const Experiment& experiment);

    ServoLoop& loop() { return m_loop; }
    const Clock& clock() { return m_rig.clock(); }
    /// Begins there in place of the start; before the first period.
    void use(const RigCondition& condition) { m_rig.use(condition); }
    /// Advances the rig by one sampling period, after activating its faults that are due, and ticks the loop.
    void period();

private:
    void advance();

    double m_period_s;
    SimulatedRig m_rig;
    std::unique_ptr<CameraSourceTracker> m_camera;    ///< null unless a camera follows the source
    std::unique_ptr<ObjectThermometer> m_thermometer; ///< null without a thermal camera
    ServoLoop m_loop;
    FaultScript m_script;
};

} // namespace bask
