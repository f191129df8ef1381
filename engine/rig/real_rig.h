#pragma once
// The devices of a real rig, made from an experiment's rig.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermal_camera.h"
#include "engine/devices/thermometer.h"
#include "engine/experiment/device_memory.h"
#include "engine/model/experiment.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

class ConfirmedPrograms;
class TrafficLog;

/// Returns whether two specifications are of one camera: its lens and its pose are no matter of the device.
bool isSameDevice(const std::optional<ThermalCameraSpec>& a, const std::optional<ThermalCameraSpec>& b);

/// Use it on the engine thread, with Qt's event loop. A device that is missing or dead reports this in its
/// results and states.
class RealRig {
public:
    /// Returns whether the robot may be sent from one position to another (coordinates in R).
    using StepGuard = std::function<bool(const Vector6d& from, const Vector6d& to)>;

    /// Opens the links; `clock` must outlive it. The robot does not move before setGuard(). The heater's
    /// guard appends its actions to `guardLog`; empty: to no file. Devices in `memory` are expected again: a
    /// different device receives only the request for its name. Only programs in `programs` are started;
    /// null: none. What goes over the links is added to `traffic`; null: it is not kept.
    RealRig(const Experiment& experiment, const Clock& clock, const std::string& guardLog = {},
            const DeviceMemory& memory = {}, std::shared_ptr<const ConfirmedPrograms> programs = nullptr,
            std::shared_ptr<TrafficLog> traffic = nullptr);
    /// Opens only one device, to test it: nothing is moved or heated.
    RealRig(const RigSpec& rig, const Clock& clock, const DeviceMemory& memory = {},
            std::shared_ptr<const ConfirmedPrograms> programs = nullptr,
            std::shared_ptr<TrafficLog> traffic = nullptr);
    ~RealRig();

    /// Returns whether every device is the one that this experiment would make.
    bool isFor(const Experiment& experiment) const;
    /// Makes it the rig of this experiment. Devices that are the same stay, and their links stay open:
    /// opening a port again may reset the device. The others are closed before new ones are made, so nobody
    /// may still use them.
    void change(const Experiment& experiment, const DeviceMemory& memory);
    /// Removes a device from the memory; the next change() makes it again.
    void forget(DeviceRole role, DeviceMemory& memory);
    /// Returns what is known of the devices that are live.
    DeviceMemory met() const;

    /// Continues to work until the heat is confirmed off and everything has been sent, for a limited time in
    /// which Qt's events are processed: the last commands to the devices. Returns false if the heat is not
    /// known to be off; its guard has then taken over.
    bool sayLastWords();

    /// Lets the devices read what has arrived and send what is due.
    void work();
    /// Sends bytes of a person on an open link, which is closed for its driver meanwhile (LoggedLink).
    Result<void> sendByHand(const std::string& link, const std::string& bytes);
    void endByHand(); ///< gives the links back to the drivers
    /// Returns whether a person has sent something by hand since the source was last seen off.
    bool isSourceDoubted() const;

    Robot& robot();
    /// Returns one channel for each object with a sensor on it, in their order; for a test, all channels of
    /// the device.
    Thermometer& thermometer();
    HeatSource& heatSource();
    Camera* camera();               ///< null if there is none
    ThermalCamera* thermalCamera(); ///< null if there is none
    /// Returns the cameras so that they can be closed elsewhere, which takes half a second if a driver hangs.
    std::unique_ptr<Camera> takeCamera();
    std::unique_ptr<ThermalCamera> takeThermalCamera();
    /// Returns whether another thread may destroy it: a network link belongs to this thread, and closes at
    /// once.
    bool mayEndElsewhere() const;
    void setGuard(StepGuard guard);
    /// Sets the period of the thermometer's readings.
    void setPeriod(double period_s);
    /// Sets the largest speed of the robot, which also applies if it does not follow its commands.
    void limitSpeed(const RobotLimits& limits);
    /// Sets the typed temperature. Refused unless a person heats the source.
    Result<void> typeSourceTemperature(double temperature_K);

    std::vector<RigDeviceState> devices() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace bask
