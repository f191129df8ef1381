#pragma once
// A link whose traffic is kept for the device console, and which a person may take from its driver.

#include "engine/base/clock.h"
#include "engine/base/result.h"
#include "engine/drivers/byte_link.h"
#include "engine/drivers/traffic_log.h"

#include <memory>
#include <vector>

namespace bask {

class LoggedLink;

/// The links of one rig on which a person may send. It must outlive them.
class LinkDesk {
public:
    /// Sends bytes of a person. Errors: LinkNotOpened, ValueOutOfRange for more than LoggedLink::kMaxByHand.
    Result<void> send(const std::string& link, std::string_view bytes);
    /// Hears what comes on links that a person has.
    void work();
    /// Gives all links back to their drivers.
    void end();

private:
    friend class LoggedLink;
    std::vector<LoggedLink*> m_links;
};

/// While a person sends by hand, the link is closed for its driver (LinkByHand), so that the driver takes no
/// answer to the person for one to its own question, and sets the device up anew afterwards: it may have
/// other settings. The driver has it back when it opens it kByHand_s or more after the last bytes sent by
/// hand.
class LoggedLink final : public ByteLink {
public:
    static constexpr double kByHand_s = 3.0;
    static constexpr std::size_t kMaxByHand = 256; ///< bytes at once: a slow line is free again soon

    /// What the driver finds when it has the link back.
    enum class After { Same, Restarted };

    /// `clock` must outlive it. `desk`: null if nobody may send by hand.
    LoggedLink(std::unique_ptr<ByteLink> link, std::shared_ptr<TrafficLog> log, const Clock& clock,
               LinkDesk* desk, After after = After::Same);
    ~LoggedLink() override;

    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    double emptyAt_s() const override { return m_link->emptyAt_s(); }
    void write(std::string_view bytes) override;
    std::string portId() const override { return m_link->portId(); }
    std::string name() const override { return m_link->name(); }

private:
    friend class LinkDesk;
    bool isThere() const; ///< whether the link itself is open
    void add(TrafficKind kind, std::string_view bytes = {}) const;

    std::unique_ptr<ByteLink> m_link;
    std::shared_ptr<TrafficLog> m_log;
    const Clock& m_clock;
    LinkDesk* m_desk;
    const After m_after;
    bool m_isByHand = false;
    double m_byHandUntil_s = 0.0;
    mutable bool m_isTold = false; ///< told as open
};

} // namespace bask
