#pragma once
// A line of Modbus on a thread of its own. Its calls never wait, whatever the line does.

#include "engine/drivers/link_thread.h"
#include "engine/drivers/modbus_link.h"

#include <functional>
#include <map>
#include <memory>
#include <mutex>

namespace bask {

class ModbusLinkOnThread final : public ModbusLink {
public:
    /// `make` is called there; the link that it gives is used there only. `name` is what it is called.
    ModbusLinkOnThread(std::string name, std::function<std::unique_ptr<ModbusLink>()> make);
    ~ModbusLinkOnThread() override;

    /// One that is open, or being opened, stays so.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    bool isFree() const override;
    /// Throws std::logic_error unless it is free.
    int send(const ModbusRequest& request) override;
    std::optional<ModbusReply> takeReply(int number) override;
    std::string name() const override { return m_name; }
    std::string portId() const override;

private:
    void turn();
    void drop();

    const std::string m_name;
    mutable std::mutex m_mutex;
    // Under the mutex
    int m_wanted = 0; ///< counts open() and close(): what belongs to an earlier one is void
    bool m_isOpen = false, m_isOpening = false, m_isFree = false;
    Message m_problem;
    std::string m_portId;
    int m_lastNumber = 0;
    std::optional<int> m_asked; ///< number that has no reply yet
    std::map<int, ModbusReply> m_replies;
    // There only
    int m_done = 0;
    std::optional<ModbusRequest> m_toSend; ///< as soon as the line is free
    std::optional<int> m_sent;             ///< as the line numbers it
    std::unique_ptr<ModbusLink> m_link;
    LinkThread m_thread; ///< last: it ends first
};

} // namespace bask
