#pragma once
// What every driver of a real device has in common: it is given time to work, and tells how it is.

#include "engine/base/message.h"

#include <optional>
#include <string>

namespace bask {

enum class DeviceRole { Robot, Thermometer, HeatSource, Camera };

enum class LinkState {
    Closed,  ///< not asked for
    Opening, ///< opened, but the device has not answered yet; or opened again and again
    Live,    ///< answers
    Lost     ///< did answer, and does not any more
};

/// Whether a source heats, as far as the device itself tells.
enum class HeatState {
    Off,    ///< the device has confirmed it
    On,     ///< asked for, or not yet confirmed to be off again
    Unknown ///< it does not answer, has told nothing yet, or does not confirm the order to switch off
};

/// A device at one moment.
struct DeviceStatus {
    LinkState link = LinkState::Closed;
    Message problem;             ///< why it is not live; code None: nothing
    double lastReply_s = -1e300; ///< when it answered last as it should, on the engine's clock
    double replyTime_s = 0.0;    ///< from the newest request to its answer; 0: not known
    double rate_Hz = 0.0;        ///< of answers
    int discarded = 0;           ///< replies so far that nobody can read or that were not asked for
    std::string identity;        ///< as the device tells, "Grbl 1.1h"; empty: it does not
    /// What tells it from others of its kind, as it tells; "": it has nothing; empty: not told yet.
    std::optional<std::string> signature{};
};

/// Used on the engine thread only.
class Device {
public:
    virtual ~Device() = default;
    /// Takes what has come and sends what is due; never waits. Called every few milliseconds.
    virtual void work() = 0;
    virtual DeviceStatus status() const = 0;
    /// By its signature, the device that is meant; without this the first one that is met since the link was
    /// made. Of another one nothing but its name is asked, it is not live (DeviceExchanged), and what it is
    /// told is refused.
    virtual void expect(const std::string&) {}
};

/// A device of a real rig, as it is now.
struct RigDeviceState {
    DeviceRole role = DeviceRole::Robot;
    std::string port;
    DeviceStatus status;
    double age_s = 0.0; ///< of what it told last
};

} // namespace bask
