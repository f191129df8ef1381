#include "engine/drivers/namur_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/off_program.h"
#include "engine/protocols/namur_lines.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kLineGap_s = 0.05;                       ///< a plate loses lines that come in a hurry
constexpr int kStops = 3;                                 ///< it does not say whether it heard one
constexpr double kStopAgain_s = 1.0, kStopLater_s = 10.0; ///< later: some keep set points where they wear
constexpr double kSetAgain_s = 0.5, kSetPointStep_K = 0.05;
constexpr int kNames = 3;                 ///< questions for a name that some have not
constexpr int kSetPointEvery = 4;         ///< polls
constexpr double kSetPointWithin_K = 0.6; ///< some plates take whole degrees
constexpr double kOff_degC = 0.0;
constexpr int kOthersTold = 2; ///< one may have been asked before it was set
constexpr int kUnechoedTold = 2;
constexpr double kLowest_degC = -60.0, kHighest_degC = 500.0; ///< what a plate or its probe can have

} // namespace

NamurHeater::NamurHeater(ByteLink& link, const Clock& clock, const NamurHeaterConfig& config)
    : m_link(link), m_clock(clock), m_config(config), m_watch(link, clock, kSilence_s) {
    if (!(config.watchdog_s >= namur::kShortestWatchdog_s && config.watchdog_s <= namur::kLongestWatchdog_s))
        throw std::invalid_argument("NamurHeater: watchdog");
}

void NamurHeater::work() {
    const double now_s = m_clock.now_s();
    if (m_isOn && now_s >= m_until_s) { // before anything is sent: an engine that was held up must not go on
        stop();
        m_isFed = false;
    }
    switch (m_watch.work()) {
    case LinkWatch::Turn::Closed:
        m_isOffDue = m_isOffDue || m_isOn;
        m_isOn = m_isFed = false;
        return;
    case LinkWatch::Turn::Opened:
        begin();
        return;
    case LinkWatch::Turn::Open:
        break;
    }
    m_lines.add(m_link.read());
    while (const auto line = m_lines.next())
        takeLine(*line);
    giveUpLate();
    speak();
}

/// Nothing is known of a plate that was away: it is told to stop, and asked for everything.
void NamurHeater::begin() {
    m_lines.clear();
    m_name.clear();
    m_isNameTold = false;
    m_namesLeft = kNames;
    m_asked = Question::None;
    m_readBack_K.reset();
    m_isOn = m_isFed = false;
    m_isOffDue = m_mustZero = true;
    m_stopsLeft = kStops;
    m_polls = m_unechoed = 0;
    m_nextLine_s = m_nextStop_s = m_nextPoll_s = m_off_s = m_clock.now_s();
}

void NamurHeater::takeLine(const std::string& line) {
    bool fits = false;
    switch (m_asked) {
    case Question::None:
        break;
    case Question::Name:
        fits = isNamurName(line);
        if (fits)
            takeName(line.substr(0, line.find_last_not_of(' ') + 1));
        break;
    case Question::Temperature:
        fits = takeTemperature(line);
        break;
    case Question::SetPoint:
        fits = takeSetPoint(line);
        break;
    case Question::Watchdog:
        fits = isWatchdogEcho(line, m_config.watchdog_s);
        if (fits) {
            m_unechoed = 0;
            m_isWatched = true;
        }
        break;
    }
    if (fits)
        m_asked = Question::None;
    else
        m_watch.discarded(line);
}

/// Empty: it tells none.
void NamurHeater::takeName(std::string name) {
    m_name = std::move(name);
    m_isNameTold = true;
    if (!m_expected && !m_name.empty())
        m_expected = m_name;
}

bool NamurHeater::takeTemperature(const std::string& line) {
    const auto value = namurValue(line);
    if (!value || value->channel != (m_config.isProbeUsed ? 1 : 2))
        return false;
    const bool isPossible = value->value >= kLowest_degC && value->value <= kHighest_degC;
    m_reading = Reading{m_askedAt_s, isPossible ? kelvinFromCelsius(value->value) : 0.0, isPossible,
                        isPossible ? SensorFault::None : SensorFault::OutOfRange};
    m_watch.answered(m_clock.now_s() - m_askedAt_s);
    return true;
}

bool NamurHeater::takeSetPoint(const std::string& line) {
    const auto value = namurValue(line);
    if (!value || value->channel != 1)
        return false;
    m_readBack_K = kelvinFromCelsius(value->value);
    const bool isOther = m_isOn && !m_mustStart && std::abs(*m_readBack_K - m_sent_K) > kSetPointWithin_K;
    m_others = isOther ? m_others + 1 : 0;
    m_mustSet = m_mustSet || isOther; // some forget it at the start
    if (!m_mustZero && !m_mustLook && value->value <= kOff_degC + kSetPointWithin_K && !m_isOn)
        m_isOffDue = m_wasOn = false;
    return true;
}

/// An answer that comes after all is not taken for the next one's.
void NamurHeater::giveUpLate() {
    const double now_s = m_clock.now_s();
    if (m_asked == Question::None || now_s < m_askedAt_s + kDeadline_s)
        return;
    const Question asked = std::exchange(m_asked, Question::None);
    m_nextLine_s = now_s + (m_config.isProbeUsed ? kDeadline_s : kQuiet_s);
    if (asked == Question::Watchdog)
        watchdogUnechoed();
    if (asked == Question::Name && m_namesLeft == 0)
        takeName({});
}

/// Once may be a disturbance: it is sent again at once.
void NamurHeater::watchdogUnechoed() {
    if (++m_unechoed < kUnechoedTold) {
        m_nextWatchdog_s = m_clock.now_s();
        return;
    }
    const std::string words =
        "nothing to " + namurWatchdog(m_config.watchdog_s) + ", so that its watchdog may not run";
    m_watch.complain(words);
    if (!m_isOn || m_config.mayHeatUnattended)
        return;
    m_refusal = {MessageCode::DeviceAnswersWrong, {m_link.name(), words}};
    stop();
    m_isFed = false;
}

void NamurHeater::speak() {
    if (m_asked != Question::None || m_clock.now_s() < m_nextLine_s)
        return;
    if (isOther())
        return;
    // Nothing else is said to it before; but one that was hot and does not answer is told to stop.
    const bool isStopDue = m_wasOn && m_namesLeft < kNames;
    if (m_expected && !m_isNameTold && !isStopDue) {
        --m_namesLeft;
        return ask(Question::Name, namur::kName);
    }
    const double before_s = m_nextLine_s;
    order();
    if (m_nextLine_s == before_s)
        poll();
}

/// One line of what the plate is to do. The watchdog comes before the heat, and is not fed while that may be
/// on unasked.
void NamurHeater::order() {
    const double now_s = m_clock.now_s();
    if ((m_stopsLeft > 0 || m_isOffDue) && now_s >= m_nextStop_s) {
        sayStop();
    } else if (m_mustZero) {
        m_mustZero = false;
        m_mustLook = true;
        say(namurSetPoint(kOff_degC));
    } else if (m_mustLook) {
        m_mustLook = false;
        ask(Question::SetPoint, namur::kSetPoint);
    } else if (m_isFed && !m_isOffDue && now_s >= m_nextWatchdog_s) {
        m_nextWatchdog_s = now_s + m_config.watchdog_s / 4.0;
        ask(Question::Watchdog, namurWatchdog(m_config.watchdog_s));
    } else if (m_isOn && !m_isWatched && !m_config.mayHeatUnattended) {
        return;
    } else if (m_isOn && m_mustSet && now_s >= m_nextSet_s) {
        if (m_sent_K != m_setPoint_K)
            m_others = 0;
        m_sent_K = m_setPoint_K;
        m_mustSet = false;
        m_nextSet_s = now_s + kSetAgain_s;
        say(namurSetPoint(celsiusFromKelvin(m_setPoint_K)));
    } else if (m_isOn && m_mustStart) {
        m_mustStart = false;
        say(namur::kStart);
    }
}

void NamurHeater::poll() {
    const double now_s = m_clock.now_s();
    if (now_s < m_nextPoll_s)
        return;
    m_nextPoll_s = now_s + kPoll_s;
    ++m_polls;
    if (m_name.empty() && m_namesLeft > 0 && m_polls % kSetPointEvery == 1) { // with temperatures between
        --m_namesLeft;
        m_nextPoll_s = now_s;
        ask(Question::Name, namur::kName);
    } else if (m_polls % kSetPointEvery == 0) {
        m_nextPoll_s = now_s;
        ask(Question::SetPoint, namur::kSetPoint);
    } else {
        ask(Question::Temperature, m_config.isProbeUsed ? namur::kProbe : namur::kPlate);
    }
}

void NamurHeater::ask(Question question, const std::string& command) {
    say(command);
    m_asked = question;
    m_askedAt_s = m_clock.now_s();
}

void NamurHeater::say(const std::string& command) {
    m_link.write(namurLine(command));
    m_nextLine_s = m_clock.now_s() + kLineGap_s;
}

/// At once, whatever was asked; and again later, should it not have been heard.
void NamurHeater::stop() {
    m_isOn = false;
    m_others = 0;
    m_isOffDue = true;
    m_off_s = m_clock.now_s();
    m_stopsLeft = kStops;
    sayStop();
}

void NamurHeater::sayStop() {
    say(namur::kStop);
    m_stopsLeft = std::max(0, m_stopsLeft - 1);
    m_mustZero = m_isOffDue;
    m_nextStop_s = m_clock.now_s() + (m_stopsLeft > 0 || !m_isOffDue ? kStopAgain_s : kStopLater_s);
}

bool NamurHeater::isSetPointOther() const {
    return m_isOn && m_others >= kOthersTold && m_readBack_K;
}

DeviceStatus NamurHeater::status() const {
    DeviceStatus status = m_watch.status();
    status.identity = m_name;
    status.signature = m_isNameTold ? std::optional(m_name) : std::nullopt;
    if (isOther()) {
        status.link = LinkState::Opening;
        status.problem = exchanged();
    }
    if (status.link == LinkState::Live && isSetPointOther())
        status.problem = {
            MessageCode::SafetySetPointOther,
            {formatNumber(celsiusFromKelvin(m_sent_K)), formatNumber(celsiusFromKelvin(*m_readBack_K))}};
    return status;
}

Message NamurHeater::exchanged() const {
    return {MessageCode::DeviceExchanged, {m_link.name(), *m_expected, m_name.empty() ? "?" : m_name}};
}

Result<Reading> NamurHeater::read() {
    if (isOther())
        return Error(exchanged().code, {}, exchanged().args);
    if (!m_watch.isLive() || !m_reading)
        return m_watch.error();
    return *m_reading;
}

Result<void> NamurHeater::keepHeating(double setPoint_K, double validFor_s) {
    const double setPoint_degC = celsiusFromKelvin(setPoint_K);
    if (!(setPoint_degC >= 0.0 && setPoint_degC <= namur::kHighest_degC))
        return Error{MessageCode::ValueOutOfRange,
                     "setPoint",
                     {formatNumber(setPoint_degC), "0", formatNumber(namur::kHighest_degC), "degC"}};
    if (!(validFor_s > 0.0))
        return Error{MessageCode::ValueNotPositive, "validFor", {formatNumber(validFor_s)}};
    if (isOther())
        return Error(exchanged().code, {}, exchanged().args);
    if (!m_watch.isLive())
        return m_watch.error();
    if (m_refusal != Message{})
        return Error(m_refusal.code, {}, m_refusal.args);
    if (!m_isOn) {
        m_isOn = m_wasOn = m_isFed = m_mustSet = m_mustStart = true;
        m_isWatched = m_isOffDue = m_mustZero = m_mustLook = false;
        m_others = m_stopsLeft = 0;
        m_nextWatchdog_s = m_clock.now_s();
        m_nextSet_s = m_clock.now_s();
    }
    m_mustSet = m_mustSet || std::abs(setPoint_K - m_sent_K) >= kSetPointStep_K;
    m_setPoint_K = setPoint_K;
    m_until_s = m_clock.now_s() + validFor_s;
    return {};
}

Result<void> NamurHeater::heatOff() {
    m_refusal = {};
    if (isOther())
        return Error(exchanged().code, {}, exchanged().args);
    if (!m_link.isOpen()) {
        m_isOffDue = m_isOffDue || m_isOn;
        m_isOn = m_isFed = false;
        return m_watch.error();
    }
    if (m_isOn)
        stop();
    else if (!m_isOffDue && m_stopsLeft == 0 && m_clock.now_s() >= m_nextStop_s)
        m_stopsLeft = 1;
    return offSeen();
}

Result<void> NamurHeater::offSeen() const {
    if (!heating() || m_clock.now_s() < m_off_s + kStops * kStopAgain_s)
        return {};
    if (!m_watch.isLive())
        return m_watch.error();
    if (!m_readBack_K)
        return Error(MessageCode::DeviceAnswersWrong, {},
                     {m_link.name(), std::string("nothing to ") + namur::kSetPoint});
    return Error(MessageCode::SafetySetPointOther, {},
                 {formatNumber(kOff_degC), formatNumber(celsiusFromKelvin(*m_readBack_K))});
}

HeatState NamurHeater::heatState() const {
    if (!m_watch.isLive() || isOther())
        return HeatState::Unknown;
    if (m_isOn)
        return HeatState::On;
    if (!m_isOffDue)
        return HeatState::Off;
    return m_wasOn && offSeen() ? HeatState::On : HeatState::Unknown; // the order is on its way, or in vain
}

guard::OffProgram NamurHeater::offProgram() {
    constexpr int kGap_ms = 60;
    constexpr int kDeadline_ms = 500;
    guard::OffProgram program;
    for (int i = 0; i < 2; ++i) // the first may follow half a line, and not be heard
        add(program, offWrite(namurLine(namur::kStop), {}, 0, kGap_ms));
    add(program, offWrite(namurLine(namurSetPoint(kOff_degC)), {}, 0, kGap_ms));
    add(program,
        offWhenNumber(namurLine(namur::kSetPoint), kOff_degC + kSetPointWithin_K, "1", kDeadline_ms));
    return program;
}

bool NamurHeater::hasWatchdog() const {
    return m_unechoed < kUnechoedTold;
}

HeatSourceDriver namurHeaterDriver() {
    HeatSourceDriver driver;
    driver.key = "namur";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Hotplate (NAMUR, IKA)");
    driver.serial = {9600, 7, 'E', 1};
    driver.parameters = {deviceParameter(heatSourceParameters(), "watchdog", SetupStep::Use)};
    driver.hasProbe = true;
    driver.make = [](DriverLinks& links, const HeatSourceDeviceSpec& spec) -> MadeDevice<HeatSource> {
        return {std::make_unique<NamurHeater>(
                    links.serial(), links.clock(),
                    NamurHeaterConfig{spec.isProbeUsed, spec.watchdog_s, spec.mayHeatUnattended}),
                &NamurHeater::offProgram};
    };
    return driver;
}

} // namespace bask
