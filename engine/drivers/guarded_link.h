#pragma once
// A heater's port as a link of bytes: through its guard while there is one, otherwise directly.

#include "engine/drivers/byte_link.h"
#include "engine/drivers/heater_guard.h"

#include <functional>
#include <memory>

namespace bask {

/// If the guard ends, the link is lost; opened again, it is the port itself. A new guard then takes the port
/// without losing the link.
class GuardedLink final : public ByteLink {
public:
    /// `direct` makes a link to the same port. `guard` and `clock` must outlive it.
    GuardedLink(HeaterGuard& guard, std::function<std::unique_ptr<ByteLink>()> direct, const Clock& clock);

    /// No effect if it is being opened, or while the guard switches off.
    void open() override;
    void close() override;
    bool isOpen() const override;
    Message problem() const override;
    std::string read() override;
    void write(std::string_view bytes) override;
    std::string name() const override { return m_guard.port(); }
    std::string portId() const override;

private:
    enum class Way { Guard, Direct, ToGuard };

    bool isGuarded() const;
    void goOverToGuard();

    HeaterGuard& m_guard;
    std::function<std::unique_ptr<ByteLink>()> m_make;
    const Clock& m_clock;
    std::unique_ptr<ByteLink> m_direct; ///< made when it is needed
    Way m_way = Way::Guard;
    double m_since_s = 0.0; ///< since when it has been passed to the guard
};

} // namespace bask
