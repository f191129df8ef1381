#include "engine/drivers/guarded_heater.h"

#include "engine/base/message_code.h"

#include <utility>

namespace bask {

using State = HeaterGuard::State;

GuardedHeater::GuardedHeater(std::unique_ptr<HeatSource> heater, HeaterGuard& guard, std::string program,
                             std::function<guard::OffProgram()> off, const Clock& clock)
    : m_heater(std::move(heater)), m_guard(guard), m_program(std::move(program)), m_off(std::move(off)),
      m_clock(clock) {
    m_guard.start(m_program);
}

void GuardedHeater::work() {
    const bool isGuarded = m_guard.state() == State::Guarding;
    if (std::exchange(m_wasGuarded, isGuarded) && !isGuarded)
        (void)m_heater->heatOff(); // as soon as the port is there again
    const double now_s = m_clock.now_s();
    m_isDoubted = m_isDoubted && m_heater->heatState() != HeatState::Off;
    if (m_heater->heating() || m_isDoubted) { // also one that was found on
        m_heated_s = now_s;
        m_guard.arm(m_off());
    } else if (now_s - m_heated_s >= kSeenOff_s) {
        m_guard.disarm();
    }
}

Result<void> GuardedHeater::keepHeating(double setPoint_K, double validFor_s) {
    m_guard.arm(m_off());
    if (!m_guard.isArmed()) {
        (void)m_heater->heatOff();
        const Message why = cannotHeat();
        return Error(why.code, {}, why.args);
    }
    m_heated_s = m_clock.now_s();
    return m_heater->keepHeating(setPoint_K, validFor_s);
}

/// What the guard does is not seen from here.
HeatState GuardedHeater::heatState() const {
    return m_guard.state() == State::TookOver ? HeatState::Unknown : m_heater->heatState();
}

Message GuardedHeater::cannotHeat() const {
    if (m_guard.state() == State::Guarding)
        return {};
    return m_guard.state() == State::Starting
               ? Message{MessageCode::HeaterGuardMissing, {"it is being started"}}
               : m_guard.problem();
}

Message GuardedHeater::guardProblem() const {
    const bool isGone = m_guard.state() == State::TookOver || m_guard.state() == State::Ended;
    return isGone ? m_guard.problem() : Message{};
}

void GuardedHeater::renewGuard() {
    if (m_guard.state() == State::None || m_guard.state() == State::Ended)
        m_guard.start(m_program);
}

} // namespace bask
