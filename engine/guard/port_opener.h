#pragma once
// Opens the port on a thread of its own: one that opens slowly holds up no beat.

#include "engine/guard/guarded_port.h"

namespace bask::guard {

class PortOpener {
public:
    /// `port` is this one's alone from begin() to take().
    explicit PortOpener(GuardedPort& port);

    void begin();
    bool isBusy() const { return m_isBusy; }
    /// To be read when it is done.
    int descriptor() const { return m_done[0]; }
    /// Waits until it is done; as GuardedPort::open().
    int take();

private:
    static void* run(void* opener);
    void open();

    GuardedPort& m_port;
    int m_wanted[2] = {-1, -1}, m_done[2] = {-1, -1}; ///< pipes to the thread and back
    bool m_isRunning = false, m_isBusy = false;
    unsigned long m_thread = 0;
};

} // namespace bask::guard
