#pragma once
// The devices of a real rig, made from an experiment's rig.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermometer.h"
#include "engine/runtime/snapshot.h"
#include "engine/session/experiment.h"

#include <functional>
#include <memory>
#include <vector>

namespace bask {

/// Engine thread, with Qt's event loop. A device that is missing or dead says so by its calls and states.
class RealRig {
public:
    /// Whether the robot may be sent from one place to another (coordinates in R).
    using StepGuard = std::function<bool(const Vector6d& from, const Vector6d& to)>;

    /// Opens the links; `clock` outlives it. Until setGuard the robot is not moved.
    RealRig(const Experiment& experiment, const Clock& clock);
    /// The same of one device alone, to try it: nothing is moved or heated.
    RealRig(const RigSpec& rig, const Clock& clock);
    ~RealRig();

    /// Works on until the heat is seen off and all has been sent, for a bounded time in which Qt's events are
    /// processed: what was asked of the devices last. False: the heat is not known to be off.
    bool sayLastWords();

    /// Lets the devices take what has come and send what is due.
    void work();

    Robot& robot();
    /// One channel an object, in their order; when tried, all channels of the device.
    Thermometer& thermometer();
    HeatSource& heatSource();
    Camera* camera(); ///< null: none
    void setGuard(StepGuard guard);
    /// Refused where no person keeps the source hot.
    Result<void> typeSourceTemperature(double temperature_K);

    std::vector<RigDeviceState> devices() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bask
