#pragma once
// Supervises the link of a driver: opens it, and again at most twice a second when it cannot be or is lost,
// and knows for how long the device alone is to blame for a silence.

#include "engine/drivers/byte_link.h"

namespace bask {

class LinkKeeper {
public:
    enum class Found { Closed, Opened, Open, Lost };

    explicit LinkKeeper(ByteLink& link) : m_link(link) {}

    /// How it finds the link; Opened and Lost once each time. Opens it when that is due.
    Found work(double now_s);
    /// On purpose, to begin anew; it is not told as lost.
    void close(double now_s);
    bool isOpen() const { return m_isOpen; }
    /// When it was found open, s.
    double opened_s() const { return m_opened_s; }
    /// For how long nothing has come since `last_s`, as far as the device is to blame: not while the link was
    /// closed, nor while the engine was held up, since what came meanwhile is still to be read.
    double silence_s(double last_s, double now_s) const;
    /// Why it is closed; where the link does not tell, that it was closed.
    Message problem() const;
    ByteLink& link() const { return m_link; }

private:
    ByteLink& m_link;
    bool m_isOpen = false, m_isOpening = false;
    double m_tried_s = -1e300, m_opened_s = -1e300;
    double m_worked_s = -1e300, m_listening_s = -1e300; ///< last, and since when without a pause
};

} // namespace bask
