#include "engine/drivers/guarded_link.h"

#include <utility>

namespace bask {
namespace {

constexpr double kGoingOver_s = 1.0; // until the port is free for the guard

} // namespace

GuardedLink::GuardedLink(HeaterGuard& guard, std::function<std::unique_ptr<ByteLink>()> direct,
                         const Clock& clock)
    : m_guard(guard), m_make(std::move(direct)), m_clock(clock) {}

bool GuardedLink::isGuarded() const {
    return m_guard.state() == HeaterGuard::State::Starting || m_guard.state() == HeaterGuard::State::Guarding;
}

void GuardedLink::open() {
    if (isGuarded()) {
        if (std::exchange(m_way, Way::Guard) != Way::Guard)
            m_direct->close();
        return m_guard.openPort();
    }
    if (m_guard.state() == HeaterGuard::State::TookOver)
        return;
    if (!m_direct)
        m_direct = m_make();
    m_way = Way::Direct;
    m_direct->open();
}

void GuardedLink::close() {
    m_guard.closePort();
    if (m_direct)
        m_direct->close();
    m_way = Way::Guard;
}

bool GuardedLink::isOpen() const {
    switch (m_way) {
    case Way::Guard:
        return m_guard.isPortOpen();
    case Way::Direct:
        return m_direct->isOpen();
    case Way::ToGuard:
        return isGuarded();
    }
    return false;
}

Message GuardedLink::problem() const {
    return m_way == Way::Direct ? m_direct->problem() : m_guard.portProblem();
}

std::string GuardedLink::portId() const {
    return m_way == Way::Direct ? m_direct->portId() : m_guard.portId();
}

/// The driver need not know: what it asks meanwhile is lost, and asked again.
void GuardedLink::goOverToGuard() {
    if (m_way == Way::Direct) {
        m_way = Way::ToGuard;
        m_since_s = m_clock.now_s();
        m_direct->close();
    }
    if (m_guard.isPortOpen() || m_clock.now_s() - m_since_s > kGoingOver_s)
        m_way = Way::Guard;
    else
        m_guard.openPort(); // again, until it is free
}

std::string GuardedLink::read() {
    if (m_way != Way::Guard && isGuarded()) {
        goOverToGuard();
        return {};
    }
    return m_way == Way::Direct ? m_direct->read() : m_guard.read();
}

void GuardedLink::write(std::string_view bytes) {
    if (m_way == Way::Direct)
        m_direct->write(bytes);
    else if (m_way == Way::Guard)
        m_guard.write(bytes);
}

} // namespace bask
