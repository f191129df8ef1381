#include "engine/drivers/program_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using Kind = ProgramRequest::Kind;

constexpr double kOffAgain_s = 0.5, kOffTold_s = 3.0;
constexpr double kMaxValid_s = 10.0; ///< of one request
constexpr double kKnownFor_s = 3.0;  ///< an older state is not shown as known
constexpr double kStateStep_K = 0.05, kStateWithin_K = 0.6;
constexpr int kOtherStates = 3; ///< one may have been asked before it was set

} // namespace

ProgramHeater::ProgramHeater(ByteLink& link, const Clock& clock, bool mayHeatUnattended)
    : m_talk(link, clock, ProgramRole::HeatSource), m_clock(clock), m_mayHeatUnattended(mayHeatUnattended) {}

void ProgramHeater::work() {
    if (m_isOn && m_clock.now_s() >= m_until_s) // before anything is sent: an engine that was held up
        stop();
    const auto taken = [this](const ProgramLine& line, const ProgramRequest* asked) { take(line, asked); };
    switch (m_talk.work(taken)) {
    case ProgramTalk::Turn::Closed:
        m_isOffDue = m_isOffDue || m_isOn;
        m_isOn = false;
        return;
    case ProgramTalk::Turn::Opened:
        begin();
        return;
    case ProgramTalk::Turn::Open:
        break;
    }
    order();
}

/// Nothing is known of one that has started: it is told to switch off.
void ProgramHeater::begin() {
    m_state.reset();
    m_isOn = false;
    m_refused.clear();
    m_others = 0;
    m_isOffDue = true;
    m_off_s = m_clock.now_s();
    m_offSent_s = -1e300;
}

void ProgramHeater::take(const ProgramLine& line, const ProgramRequest* asked) {
    if (const auto* refusal = std::get_if<ProgramRefusal>(&line.what)) {
        m_refused = refusal->words;
        if (asked->kind == Kind::Heat)
            stop();
    }
    const auto* state = std::get_if<ProgramHeaterState>(&line.what);
    if (state == nullptr)
        return;
    m_state = *state;
    m_at_s = m_talk.measuredAt_s(line, asked);
    const bool isOther =
        m_isOn && state->setPoint_K && std::abs(*state->setPoint_K - m_sent_K) > kStateWithin_K;
    m_others = isOther ? m_others + 1 : 0;
    if (!m_isOn && !state->isHeating && m_at_s > m_offSent_s && !m_talk.isWaitingFor(Kind::Off) && asked)
        m_isOffDue = m_wasOn = false;
    else if (!m_isOn && state->isHeating && !m_isOffDue) { // somebody else has switched it on
        m_isOffDue = true;
        m_off_s = m_clock.now_s();
    }
}

void ProgramHeater::order() {
    const double now_s = m_clock.now_s();
    if (!m_isOn && m_isOffDue && now_s - m_offSent_s > kOffAgain_s && m_talk.hello()) {
        m_talk.send(Kind::Off);
        m_offSent_s = now_s;
    }
    const bool isDue = now_s - m_heat_s > 0.25 * std::min(m_validFor_s, kMaxValid_s) ||
                       std::abs(m_setPoint_K - m_sent_K) >= kStateStep_K;
    if (!m_isOn || !isDue || m_talk.isWaitingFor(Kind::Heat))
        return;
    if (m_setPoint_K != m_sent_K)
        m_others = 0;
    m_heat_s = now_s;
    m_sent_K = m_setPoint_K;
    if (m_until_s > now_s)
        m_talk.sendHeat(m_setPoint_K, std::min(m_until_s - now_s, kMaxValid_s));
}

void ProgramHeater::stop() {
    m_isOn = false;
    m_isOffDue = true;
    m_others = 0;
    m_off_s = m_offSent_s = m_clock.now_s();
    m_talk.send(Kind::Off);
}

bool ProgramHeater::isSetPointOther() const {
    return m_isOn && m_others >= kOtherStates && m_state && m_state->setPoint_K;
}

DeviceStatus ProgramHeater::status() const {
    DeviceStatus status = m_talk.status();
    if (status.link == LinkState::Live && isSetPointOther())
        status.problem = {MessageCode::SafetySetPointOther,
                          {formatNumber(celsiusFromKelvin(m_sent_K)),
                           formatNumber(celsiusFromKelvin(*m_state->setPoint_K))}};
    else if (status.problem.code == MessageCode::None && !m_refused.empty())
        status.problem = {MessageCode::ProgramRefuses, {m_talk.name(), m_refused}};
    return status;
}

Result<Reading> ProgramHeater::read() {
    if (!m_talk.isLive() || !m_state)
        return m_talk.error();
    const auto& temperature_K = m_state->temperature_K;
    return Reading{m_at_s, temperature_K.value_or(0.0), temperature_K.has_value(),
                   temperature_K ? SensorFault::None : SensorFault::Other};
}

Result<void> ProgramHeater::keepHeating(double setPoint_K, double validFor_s) {
    if (!(validFor_s > 0.0))
        return Error{MessageCode::ValueNotPositive, "validFor", {formatNumber(validFor_s)}};
    if (!m_talk.isLive())
        return m_talk.error();
    if (const Message why = cannotHeat(); why.code != MessageCode::None)
        return Error(why.code, {}, why.args);
    const double max_K = m_talk.hello()->maxTemperature_K;
    if (!(setPoint_K > 0.0 && setPoint_K <= max_K))
        return Error{MessageCode::ValueOutOfRange,
                     "setPoint",
                     {formatNumber(celsiusFromKelvin(setPoint_K)), formatNumber(celsiusFromKelvin(0.0)),
                      formatNumber(celsiusFromKelvin(max_K)), "degC"}};
    if (!m_refused.empty())
        return Error(MessageCode::ProgramRefuses, {}, {m_talk.name(), m_refused});
    if (!m_isOn) {
        m_isOn = m_wasOn = true;
        m_isOffDue = false;
        m_others = 0;
        m_heat_s = -1e300;
    }
    m_setPoint_K = setPoint_K;
    m_validFor_s = validFor_s;
    m_until_s = m_clock.now_s() + validFor_s;
    return {};
}

Result<void> ProgramHeater::heatOff() {
    m_refused.clear();
    if (m_isOn)
        stop();
    if (!m_talk.isLive()) {
        m_isOffDue = m_isOffDue || m_wasOn;
        return m_talk.error();
    }
    const bool isLate = m_isOffDue && m_clock.now_s() - m_off_s > kOffTold_s;
    if (isLate && m_state && m_state->isHeating)
        return Error(MessageCode::ProgramRefuses, {}, {m_talk.name(), "it says that it heats after \"off\""});
    return {};
}

HeatState ProgramHeater::heatState() const {
    if (!m_talk.isLive() || !m_state || m_clock.now_s() - m_at_s > kKnownFor_s)
        return HeatState::Unknown;
    if (m_isOn || m_state->isHeating)
        return HeatState::On;
    return m_isOffDue ? HeatState::Unknown : HeatState::Off;
}

std::optional<double> ProgramHeater::setPoint_K() const {
    return m_state ? m_state->setPoint_K : std::nullopt;
}

Message ProgramHeater::cannotHeat() const {
    if (m_mayHeatUnattended || hasWatchdog())
        return {};
    return {MessageCode::SourceUnwatched, {m_talk.hello()->name}};
}

HeatSourceDriver programHeaterDriver() {
    HeatSourceDriver driver;
    driver.key = "program";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Program of your own");
    driver.link = DriverLink::Program;
    driver.make = [](DriverLinks& links, const HeatSourceDeviceSpec& spec) -> MadeDevice<HeatSource> {
        return std::make_unique<ProgramHeater>(links.program(ProgramRole::HeatSource), links.clock(),
                                               spec.mayHeatUnattended);
    };
    return driver;
}

} // namespace bask
