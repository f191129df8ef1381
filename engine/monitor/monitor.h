#pragma once
// Publishes what a run does to a broker and to files, on threads of its own: whatever becomes of network and
// disk, nobody waits for it.

#include "engine/monitor/monitor_settings.h"
#include "engine/runtime/snapshot.h"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

namespace bask {

/// How the publishing goes.
struct MonitorState {
    bool isOn = false;
    bool hasBroker = false;
    bool isConnected = false; ///< with the broker
    Message brokerProblem;    ///< code None: none, or there is no broker
    Message fileProblem;
    std::uint64_t sent = 0;    ///< messages that went to the broker
    std::uint64_t leftOut = 0; ///< events that came faster than they could be sent, and are not sent
    bool operator==(const MonitorState&) const = default;
};

/// Topics, below the one of the settings: presence ("here", "gone", or "closed" after a proper end), status
/// (JSON, once a second and when the state changes), alarms (JSON, when they change), event (JSON, each). All
/// but event are retained. Files: status_files.h.
class Monitor {
public:
    static constexpr std::chrono::seconds kPeriod{1};
    /// How long the end waits until the last status has gone out; threads that hang are left to themselves.
    static constexpr std::chrono::milliseconds kGoodbye{1000};
    /// Events that wait; of more the oldest are left out.
    static constexpr std::size_t kMaxWaiting = 1000;

    Monitor();
    ~Monitor(); ///< tells that Bask is closed
    Monitor(const Monitor&) = delete;
    Monitor& operator=(const Monitor&) = delete;

    /// Publishes by these settings from now on, no longer by the ones before.
    void use(const MonitorSettings& settings);
    MonitorState state() const;

    /// Returns what takes the state of the engine and its new events (EngineWorker::setWatch), on any thread.
    /// It copies and returns; it may outlive this object.
    EngineWatch inlet() const;

private:
    struct Posts;
    std::shared_ptr<Posts> m_posts;
};

/// Connects once and publishes to the topic "test", which the broker must acknowledge, and makes sure that
/// the status files can be written. Waits for network and disk: call it on a thread that nobody waits for.
Result<void> tryMonitor(const MonitorSettings& settings);

} // namespace bask
