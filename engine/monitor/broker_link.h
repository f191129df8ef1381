#pragma once
// A connection to a broker that publishes and never subscribes. The library that speaks MQTT is a module,
// loaded when monitoring is first switched on.

#include "engine/base/result.h"

#include <chrono>
#include <memory>
#include <set>
#include <string>

namespace bask {

/// What a link needs to know; BrokerSettings with the password read.
struct BrokerAccess {
    std::string host;
    int port = 0;
    bool usesTls = false;
    std::string caFile; ///< empty: the certificates of the system
    std::string user, password;
    std::string clientId;
    /// "here" while connected; the broker says "gone" when the connection is lost. Empty: says nothing.
    std::string presenceTopic;
};

/// For one thread.
class BrokerLink {
public:
    static constexpr std::chrono::seconds kPatience{4}; ///< with each step of connecting
    static constexpr std::size_t kMaxUnanswered = 20;   ///< messages that the broker has not acknowledged

    enum class State { Connecting, Connected, Failed };

    virtual ~BrokerLink() = default;
    /// Begins to connect; waits for the lookup of the host's name, and up to kPatience for each of its
    /// addresses. A link that has failed is not used again.
    virtual void begin(const BrokerAccess& access) = 0;
    /// Sends and receives; waits at most `max` for the network.
    virtual void work(std::chrono::milliseconds max) = 0;
    virtual State state() const = 0;
    virtual std::string problem() const = 0; ///< why it has failed
    /// Whether a new message would only wait in memory.
    virtual bool isBusy() const = 0;
    /// Returns the number of the message, which is in unanswered() until the broker has acknowledged it; 0 if
    /// it is not sent.
    virtual int publish(const std::string& topic, const std::string& payload, bool isRetained) = 0;
    virtual const std::set<int>& unanswered() const = 0;
    virtual void end() = 0; ///< says goodbye; the broker then does not publish the last will
};

/// Error: MonitorNoModule.
Result<std::unique_ptr<BrokerLink>> makeBrokerLink();

} // namespace bask
