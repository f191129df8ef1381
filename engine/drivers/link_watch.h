#pragma once
// Keeps a link open, and reports whether the device at its end is alive, judged only by its own answers.

#include "engine/base/clock.h"
#include "engine/base/result.h"
#include "engine/devices/device.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/reply_rate.h"

namespace bask {

/// Link and clock must outlive it.
class LinkWatch {
public:
    static constexpr double kTold_s = 2.0; ///< how long a discarded answer is reported

    /// A device that has not answered for silence_s is lost, whatever the link says; the link is then opened
    /// again.
    LinkWatch(ByteLink& link, const Clock& clock, double silence_s);

    enum class Turn {
        Closed, ///< nothing can be sent
        Opened, ///< just now: everything from before is invalid
        Open
    };
    Turn work();

    /// Call when the device has given a valid answer.
    void answered(double replyTime_s = 0.0);
    /// Call when it sent something that was not requested or cannot be read.
    void discarded(std::string_view line);
    /// Reports words in the same way as a discarded answer.
    void complain(const std::string& words);
    /// Returns their number so far.
    int discards() const { return m_discards; }

    bool isLive() const;
    DeviceStatus status() const;
    /// Returns the error of a device that is not live.
    Error error() const;

private:
    Message problem() const;
    Message silent() const;

    LinkKeeper m_keeper;
    const Clock& m_clock;
    double m_silence_s;
    bool m_isAsked = false;
    double m_complained_s = -1e300;
    double m_lastReply_s = -1e300, m_replyTime_s = 0.0;
    Message m_problem, m_complaint;
    ReplyRate m_rate;
    int m_discards = 0;
};

} // namespace bask
