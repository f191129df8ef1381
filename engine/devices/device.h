#pragma once
// What all drivers of real devices have in common: regular time to work, and a status.

#include "engine/base/message.h"

#include <optional>
#include <string>

namespace bask {

enum class DeviceRole { Robot, Thermometer, HeatSource, Camera, ThermalCamera };

enum class LinkState {
    Closed,  ///< not to be opened
    Opening, ///< opened, but the device has not answered yet; or opened repeatedly
    Live,    ///< answers
    Lost     ///< answered before, but does not any more
};

/// Whether a source heats, as far as the device itself reports.
enum class HeatState {
    Off,    ///< confirmed by the device
    On,     ///< requested, or not yet confirmed to be off again
    Unknown ///< it does not answer, has reported nothing yet, or does not confirm the command to switch off
};

/// The state of a device at one time.
struct DeviceStatus {
    LinkState link = LinkState::Closed;
    Message problem;             ///< why it is not live; code None if it is
    double lastReply_s = -1e300; ///< time of its last valid answer, on the engine's clock
    double replyTime_s = 0.0;    ///< from the newest request to its answer; 0: unknown
    double rate_Hz = 0.0;        ///< rate of answers
    int discarded = 0;           ///< number of replies so far that could not be read or were not requested
    Message lastDiscarded{};     ///< why the last of them was; code None: not known
    std::string identity;        ///< as the device reports it, "Grbl 1.1h"; empty: it does not
    /// Distinguishes it from others of its kind, as it reports it. "": it has none; empty: not reported yet.
    std::optional<std::string> signature{};
};

/// Use it only on the engine thread.
class Device {
public:
    virtual ~Device() = default;
    /// Reads what has arrived and sends what is due; never waits. Called every few milliseconds.
    virtual void work() = 0;
    virtual DeviceStatus status() const = 0;
    /// Sets the expected device by its signature; without this the first device found on the link is
    /// expected. A different device is only asked for its name, is not live (DeviceExchanged), and all
    /// commands to it are refused.
    virtual void expect(const std::string&) {}
};

/// The present state of a device of a real rig.
struct RigDeviceState {
    DeviceRole role = DeviceRole::Robot;
    std::string port;
    DeviceStatus status;
    double age_s = 0.0; ///< age of its last answer
};

} // namespace bask
