#pragma once
// A link of bytes on its own thread. Its calls never wait, whatever the link does.

#include "engine/drivers/byte_link.h"
#include "engine/drivers/link_thread.h"

#include <functional>
#include <memory>
#include <mutex>

namespace bask {

class ByteLinkOnThread final : public ByteLink {
public:
    /// `make` is called on that thread, and the link that it returns is used only there. `name` is the link's
    /// name.
    ByteLinkOnThread(std::string name, std::function<std::unique_ptr<ByteLink>()> make);
    ~ByteLinkOnThread() override;

    /// No effect if it is being opened.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    double emptyAt_s() const override;
    void write(std::string_view bytes) override;
    std::string name() const override { return m_name; }
    std::string portId() const override;

private:
    static constexpr std::size_t kMaxUnread = 65536; ///< more bytes stay in the link

    void turn();
    void drop();
    void shut();

    const std::string m_name;
    mutable std::mutex m_mutex;
    // Protected by the mutex
    int m_wanted = 0; ///< counts open() and close(); data from before the last one is invalid
    bool m_isOpen = false, m_isOpening = false;
    Message m_problem;
    std::string m_portId;
    std::string m_unread;
    double m_unreadEmptyAt_s = 0.0,
           m_readEmptyAt_s = 0.0; ///< before the first byte of m_unread; for the last read()
    std::size_t m_unwritten = 0;
    // Used only on that thread
    int m_done = 0;
    double m_looked_s = 0.0; ///< when it was last read until no bytes were left
    std::unique_ptr<ByteLink> m_link;
    LinkThread m_thread; ///< declared last, so that it ends first
};

} // namespace bask
