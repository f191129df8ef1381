#pragma once
// What every driver of a real device has in common: it is given time to work, and tells how it is.

#include "engine/base/message.h"

#include <string>

namespace bask {

enum class LinkState {
    Closed,  ///< not asked for
    Opening, ///< opened, but the device has not answered yet; or opened again and again
    Live,    ///< answers
    Lost     ///< did answer, and does not any more
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
};

/// Used on the engine thread only.
class Device {
public:
    virtual ~Device() = default;
    /// Takes what has come and sends what is due; never waits. Called every few milliseconds.
    virtual void work() = 0;
    virtual DeviceStatus status() const = 0;
};

} // namespace bask
