#pragma once
// Keeps a link open: opens it, and again at most twice a second when it cannot be or is lost.

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
    /// Why it is closed; where the link does not tell, that it was closed.
    Message problem() const;
    ByteLink& link() const { return m_link; }

private:
    ByteLink& m_link;
    bool m_isOpen = false, m_isOpening = false;
    double m_tried_s = -1e300;
};

} // namespace bask
