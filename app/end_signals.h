#pragma once
// Ctrl+C, a log-out, a closed terminal: the window's program ends as after its own Quit, with a rig made
// safe.

#include <functional>
#include <mutex>
#include <thread>

namespace bask {

/// Takes SIGINT, SIGTERM and SIGHUP while it lives, and ends the application's event loop for them without a
/// question. One at a time.
class EndSignals {
public:
    EndSignals();
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

    /// Done at once, on a thread of its own: the event loop may hang.
    void setFirst(std::function<void()> first);

private:
    void listen();

    std::mutex m_mutex;
    std::function<void()> m_first; ///< under the mutex
    std::thread m_thread;
};

} // namespace bask
