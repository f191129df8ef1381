#pragma once
// The devices of a real rig, made from an experiment's rig.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermometer.h"
#include "engine/experiment/device_memory.h"
#include "engine/model/experiment.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bask {

/// Engine thread, with Qt's event loop. A device that is missing or dead says so by its calls and states.
class RealRig {
public:
    /// Whether the robot may be sent from one place to another (coordinates in R).
    using StepGuard = std::function<bool(const Vector6d& from, const Vector6d& to)>;

    /// Opens the links; `clock` outlives it. Until setGuard the robot is not moved. The heater's guard
    /// appends to `guardLog` what it does; empty: to no file. Devices that `memory` has are to be those
    /// again: to another one nothing is written but what asks for its name.
    RealRig(const Experiment& experiment, const Clock& clock, const std::string& guardLog = {},
            const DeviceMemory& memory = {});
    /// The same of one device alone, to try it: nothing is moved or heated.
    RealRig(const RigSpec& rig, const Clock& clock, const DeviceMemory& memory = {});
    ~RealRig();

    /// Whether every device is the one that this experiment would have made.
    bool isFor(const Experiment& experiment) const;
    /// Makes it the rig of this experiment. Devices that are the same stay, with their links as they are: a
    /// port that is opened anew may reset what is behind it. The others are closed before new ones are made;
    /// nobody may still have them.
    void change(const Experiment& experiment, const DeviceMemory& memory);
    /// What was remembered of it; by the next change() it is made anew.
    void forget(DeviceRole role, DeviceMemory& memory);
    /// What is known of the devices that are live.
    DeviceMemory met() const;

    /// Works on until the heat is seen off and all has been sent, for a bounded time in which Qt's events are
    /// processed: what was asked of the devices last. False: the heat is not known to be off; its guard has
    /// taken over.
    bool sayLastWords();

    /// Lets the devices take what has come and send what is due.
    void work();

    Robot& robot();
    /// One channel an object, in their order; when tried, all channels of the device.
    Thermometer& thermometer();
    HeatSource& heatSource();
    Camera* camera(); ///< null: none
    /// Hands it over to be closed elsewhere, which takes half a second where its driver hangs.
    std::unique_ptr<Camera> takeCamera();
    /// Whether another thread may destroy it: a network link belongs to this one, and closes at once.
    bool mayEndElsewhere() const;
    void setGuard(StepGuard guard);
    /// So often the thermometer is read.
    void setPeriod(double period_s);
    /// The quickest that the robot may move, also where it does not do as it is told.
    void limitSpeed(const RobotLimits& limits);
    /// Refused where no person keeps the source hot.
    Result<void> typeSourceTemperature(double temperature_K);

    std::vector<RigDeviceState> devices() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bask
