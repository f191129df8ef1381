#pragma once
// Keeps a link open, and tells whether the device at its end is alive: by its own answers only.

#include "engine/base/clock.h"
#include "engine/base/result.h"
#include "engine/devices/device.h"
#include "engine/drivers/link_keeper.h"
#include "engine/drivers/reply_rate.h"

namespace bask {

/// Both must outlive it.
class LinkWatch {
public:
    static constexpr double kTold_s = 2.0; ///< so long a discarded answer is told of

    /// A device that has not answered for silence_s is lost, whatever the link says, and the link is opened
    /// anew.
    LinkWatch(ByteLink& link, const Clock& clock, double silence_s);

    enum class Turn {
        Closed, ///< nothing can be said
        Opened, ///< just now: all that went before is void
        Open
    };
    Turn work();

    /// The device answered as it should.
    void answered(double replyTime_s = 0.0);
    /// It said something that was not asked or that nobody can read.
    void discarded(std::string_view line);
    /// Told as a discarded answer is.
    void complain(const std::string& words);
    /// How many so far.
    int discards() const { return m_discards; }

    bool isLive() const;
    DeviceStatus status() const;
    /// Of a device that is not live.
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
