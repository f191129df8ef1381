#pragma once
// Supervises the link of a driver: opens it, opens it again at most twice a second if it cannot be opened or
// is lost, and measures for how long only the device is responsible for a silence.

#include "engine/drivers/byte_link.h"

namespace bask {

class LinkKeeper {
public:
    enum class Found { Closed, Opened, Open, Lost };

    explicit LinkKeeper(ByteLink& link) : m_link(link) {}

    /// Returns the state of the link; Opened and Lost once for each time. Opens the link when it is due.
    Found work(double now_s);
    /// Closes the link on purpose, to start again; this is not reported as lost.
    void close(double now_s);
    bool isOpen() const { return m_isOpen; }
    /// Returns when the link was opened, s.
    double opened_s() const { return m_opened_s; }
    /// Returns for how long nothing has arrived since `last_s`, as far as the device is responsible: not
    /// while the link was closed, nor while the engine was delayed, because what arrived in that time has not
    /// been read yet.
    double silence_s(double last_s, double now_s) const;
    /// Returns why it is closed; if the link does not report a reason, only that it was closed.
    Message problem() const;
    ByteLink& link() const { return m_link; }

private:
    ByteLink& m_link;
    bool m_isOpen = false, m_isOpening = false;
    double m_tried_s = -1e300, m_opened_s = -1e300;
    /// Last call, and start of the present series of calls without a pause.
    double m_worked_s = -1e300, m_listening_s = -1e300;
};

} // namespace bask
