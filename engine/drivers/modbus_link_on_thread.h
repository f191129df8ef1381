#pragma once
// A Modbus line on its own thread. Its calls never wait, whatever the line does.

#include "engine/drivers/link_thread.h"
#include "engine/drivers/modbus_link.h"
#include "engine/drivers/modbus_replies.h"

#include <functional>
#include <memory>
#include <mutex>

namespace bask {

class ModbusLinkOnThread final : public ModbusLink {
public:
    /// `make` is called on that thread, and the link that it returns is used only there. `name` is the link's
    /// name.
    ModbusLinkOnThread(std::string name, std::function<std::unique_ptr<ModbusLink>()> make);
    ~ModbusLinkOnThread() override;

    /// No effect if it is open or being opened.
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
    // Protected by the mutex
    int m_wanted = 0; ///< counts open() and close(); data from before the last one is invalid
    bool m_isOpen = false, m_isOpening = false, m_isFree = false;
    Message m_problem;
    std::string m_portId;
    int m_lastNumber = 0;
    std::optional<int> m_asked; ///< number of the request without a reply
    ModbusReplies m_replies;
    // Used only on that thread
    int m_done = 0;
    std::optional<ModbusRequest> m_toSend; ///< to be sent as soon as the line is free
    std::optional<int> m_sent;             ///< its number on the line
    std::unique_ptr<ModbusLink> m_link;
    LinkThread m_thread; ///< declared last, so that it ends first
};

} // namespace bask
