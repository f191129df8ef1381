#pragma once
// Ctrl+C, a log-out or a closed terminal ends the window's program as its own Quit does, with the rig made
// safe.

#include <functional>
#include <mutex>
#include <thread>

namespace bask {

/// Handles SIGINT, SIGTERM and SIGHUP during its lifetime, and ends the application's event loop without a
/// question. Only one object at a time.
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    /// Sets what is done first, at once and on another thread, since the event loop may hang.
    void setFirst(std::function<void()> first);

private:
    void listen();

    std::mutex m_mutex;
    std::function<void()> m_first; ///< protected by the mutex
    std::thread m_thread;
};

} // namespace bask
