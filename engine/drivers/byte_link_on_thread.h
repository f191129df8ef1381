#pragma once
// A link of bytes on a thread of its own. Its calls never wait, whatever the link does.

#include "engine/drivers/byte_link.h"
#include "engine/drivers/link_thread.h"

#include <functional>
#include <memory>
#include <mutex>

namespace bask {

class ByteLinkOnThread final : public ByteLink {
public:
    /// `make` is called there; the link that it gives is used there only. `name` is what it is called.
    ByteLinkOnThread(std::string name, std::function<std::unique_ptr<ByteLink>()> make);
    ~ByteLinkOnThread() override;

    /// One that is being opened stays so.
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
    static constexpr std::size_t kMaxUnread = 65536; ///< more stays with the link

    void turn();
    void drop();
    void shut();

    const std::string m_name;
    mutable std::mutex m_mutex;
    // Under the mutex
    int m_wanted = 0; ///< counts open() and close(): what belongs to an earlier one is void
    bool m_isOpen = false, m_isOpening = false;
    Message m_problem;
    std::string m_portId;
    std::string m_unread;
    double m_unreadEmptyAt_s = 0.0,
           m_readEmptyAt_s = 0.0; ///< before the first of m_unread; of the last read()
    std::size_t m_unwritten = 0;
    // There only
    int m_done = 0;
    double m_looked_s = 0.0; ///< for bytes, of which none were left then
    std::unique_ptr<ByteLink> m_link;
    LinkThread m_thread; ///< last: it ends first
};

} // namespace bask
