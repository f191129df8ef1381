#include "engine/device_simulators/grbl_simulator.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/fault_names.h"
#include "engine/protocols/grbl_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kStep_s = 0.001;  // of the motion
constexpr double kSwitch_mm = 1.0; // the switches are this far beyond the travel
constexpr double kSearch_s = 5.0;

std::string fixed(double value, int decimals = 3) {
    std::array<char, 64> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

std::string joined(const std::vector<double>& values) {
    std::string out;
    for (const double value : values)
        out += (out.empty() ? "" : ",") + fixed(value);
    return out;
}

} // namespace

GrblSimulator::GrblSimulator(const GrblSimulatorConfig& config)
    : m_config(config), m_true(config.start), m_reads(config.start) {
    m_settings = {{10, config.tellsWork ? "0" : "1"},
                  {13, config.tellsInches ? "1" : "0"},
                  {20, config.hasSoftLimits ? "1" : "0"},
                  {22, config.canHome ? "1" : "0"}};
    for (std::size_t i = 0; i < m_true.size(); ++i) {
        m_settings[110 + static_cast<int>(i)] = fixed(config.maxRate_mm_min);
        m_settings[120 + static_cast<int>(i)] = fixed(config.acceleration_mm_s2);
        m_settings[130 + static_cast<int>(i)] = fixed(config.upper[i] - config.lower[i]);
    }
    m_state = config.startsLocked ? State::Alarm : State::Idle;
}

void GrblSimulator::opened(double now_s) {
    advance(now_s);
    if (m_config.resetsWhenOpened)
        restart();
}

void GrblSimulator::receive(std::string_view bytes, double now_s) {
    advance(now_s);
    for (const char byte : bytes)
        takeByte(byte);
}

std::string GrblSimulator::transmit(double now_s) {
    advance(now_s);
    std::string out = std::exchange(m_said, {});
    if (m_fault == "silent")
        return {};
    if (m_fault == "garbage")
        spoil(out);
    return out;
}

std::vector<std::string> GrblSimulator::faults() const {
    return {"none",    "silent",     "restart", "alarm",  "door",
            "slow-ok", "lost-steps", "garbage", "inches", "homing-fails"};
}

Result<void> GrblSimulator::setFault(const std::string& name) {
    if (const auto known = checkFault(name, faults()); !known)
        return known;
    if (name == "inches" || m_fault == "inches") {
        m_config.tellsInches = name == "inches";
        m_settings[13] = m_config.tellsInches ? "1" : "0";
    }
    m_fault = name;
    m_isDoorOpen = name == "door";
    if (name == "restart")
        restart();
    if (name == "alarm")
        raiseAlarm(1);
    if (m_isDoorOpen) {
        say("[MSG:Check Door]");
        cancelJog();
        if (m_state != State::Alarm)
            m_state = State::Door;
    }
    return {};
}

// --- States ---

void GrblSimulator::restart() {
    std::ranges::fill(m_reads, 0.0);
    m_speed = 0.0;
    m_homing.clear();
    m_isHomed = false;
    startUp(m_config.startsLocked);
}

void GrblSimulator::reset() {
    const bool wasHoming = m_state == State::Home;
    const bool wasLocked = m_state == State::Alarm;
    const bool wasMoving = isMoving();
    m_speed = 0.0;
    m_homing.clear();
    if (wasMoving)
        say(wasHoming ? "ALARM:6" : "ALARM:3");
    startUp(wasMoving || wasLocked);
}

void GrblSimulator::startUp(bool isLocked) {
    m_blocks.clear();
    m_lines.clear();
    m_partial.clear();
    m_isStopping = m_isDwelling = m_needsReset = false;
    m_isRelative = m_isInches = false;
    m_motion = 0;
    m_feed_mm_s = 0.0;
    m_state = isLocked ? State::Alarm : m_isDoorOpen ? State::Door : State::Idle;
    say("");
    say(m_config.isHal ? "GrblHAL 1.1f ['$' or '$HELP' for help]" : "Grbl 1.1h ['$' for help]");
    if (isLocked)
        say("[MSG:'$H'|'$X' to unlock]");
}

void GrblSimulator::raiseAlarm(int number) {
    m_speed = 0.0;
    m_homing.clear();
    m_blocks.clear();
    m_isStopping = m_isDwelling = false;
    m_state = State::Alarm;
    m_needsReset = true;
    say("ALARM:" + std::to_string(number));
    say("[MSG:Reset to continue]");
}

void GrblSimulator::cancelJog() {
    m_isStopping = m_speed > 0.0;
    if (!m_isStopping && m_state == State::Jog)
        stopped();
}

void GrblSimulator::home() {
    m_state = State::Home;
    m_homing = m_config.home;
    m_homingLeft_s = kSearch_s;
}

std::string GrblSimulator::state() const {
    constexpr std::array<const char*, 7> kWords{"Idle", "Run", "Hold", "Jog", "Alarm", "Door", "Home"};
    const std::string word = kWords[static_cast<std::size_t>(m_state)];
    if (m_state == State::Hold)
        return word + (m_isStopping ? ":1" : ":0");
    if (m_state == State::Door)
        return word + (m_isStopping ? ":2" : m_isDoorOpen ? ":1" : ":0");
    return word;
}

std::string GrblSimulator::status() {
    std::vector<double> told = m_reads;
    for (std::size_t i = 0; i < told.size(); ++i) {
        if (m_config.tellsWork)
            told[i] -= m_config.workOffset[i];
        if (m_config.tellsInches)
            told[i] /= kInch_mm;
    }
    std::string out = "<" + state() + (m_config.tellsWork ? "|WPos:" : "|MPos:") + joined(told) +
                      "|Bf:" + std::to_string(kBlocks - m_blocks.size()) +
                      ",128|FS:" + fixed(60.0 * m_speed, 0) + ",0";
    if (m_reports++ % 10 == 0) {
        if (m_config.tellsOffset)
            out += "|WCO:" + joined(m_config.workOffset);
        if (m_config.isHal)
            out += m_isHomed ? "|H:1,15" : "|H:0,0";
    }
    return out + ">";
}

void GrblSimulator::spoil(std::string& bytes) {
    std::uniform_int_distribution<int> permille(0, 999), any(0, 255);
    std::string out;
    for (const char byte : bytes) {
        const int chance = permille(m_random);
        if (chance == 0)
            out += static_cast<char>(any(m_random));
        if (chance != 1)
            out += chance == 2 ? static_cast<char>(any(m_random)) : byte;
    }
    bytes = out;
}

// --- Motion ---

double GrblSimulator::distance(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(squares);
}

void GrblSimulator::advance(double now_s) {
    while (m_now_s < now_s) {
        takeLines();
        double next_s = now_s;
        if (takesLines() && !m_lines.empty())
            next_s = std::min(next_s, std::max(m_lines.front().time_s, m_now_s + 1e-6));
        const bool isAtWork = !m_blocks.empty() || !m_homing.empty() || m_isDwelling;
        if (isAtWork && m_state != State::Hold && m_state != State::Door)
            next_s = std::min(next_s, m_now_s + kStep_s);
        else if (m_isStopping)
            next_s = std::min(next_s, m_now_s + kStep_s);
        work(next_s - m_now_s);
        m_now_s = next_s;
    }
    takeLines();
}

void GrblSimulator::work(double dt_s) {
    if (!m_homing.empty())
        return moveHome(dt_s);
    const bool isPaused = (m_state == State::Hold || m_state == State::Door) && !m_isStopping;
    if (!m_blocks.empty() && !isPaused)
        return move(dt_s);
    if (m_isDwelling && m_blocks.empty()) {
        m_dwellUntil_s -= dt_s;
        if (m_dwellUntil_s <= 0.0) {
            m_isDwelling = false;
            answer(0);
        }
    }
}

/// The speed from which it can still stop at the block's end.
double GrblSimulator::speedAllowed(double left) const {
    const double feed = m_isStopping ? 0.0 : m_blocks.front().feed_mm_s;
    return std::min(feed, std::sqrt(2.0 * m_config.acceleration_mm_s2 * left));
}

void GrblSimulator::move(double dt_s) {
    const Block& block = m_blocks.front();
    const double left = distance(m_reads, block.to);
    if (m_config.acceleration_mm_s2 > 0.0) {
        const double change = m_config.acceleration_mm_s2 * dt_s;
        m_speed = std::clamp(speedAllowed(left), m_speed - change, m_speed + change);
    } else {
        m_speed = m_isStopping ? 0.0 : block.feed_mm_s;
    }
    if (m_isStopping && m_speed <= 0.0)
        return stopped();
    if (m_fault == "lost-steps") { // the motors hum and stand
        m_blocks.pop_front();
        return endBlock();
    }
    const double way = m_speed * dt_s;
    // The last of the ramp is so slow that it would never end.
    const bool isAtEnd = way >= left || left < 1e-4;
    stepTo(block, isAtEnd ? left : way);
    if (m_state == State::Alarm)
        return;
    if (isAtEnd) {
        m_blocks.pop_front();
        m_isStopping ? stopped() : endBlock();
    }
}

void GrblSimulator::stepTo(const Block& block, double way) {
    const double left = distance(m_reads, block.to);
    const double share = left > kThere ? way / left : 1.0;
    bool isOnSwitch = false;
    for (std::size_t i = 0; i < m_reads.size(); ++i) {
        const double step = share * (block.to[i] - m_reads[i]);
        m_reads[i] += step;
        m_true[i] += step;
        isOnSwitch = isOnSwitch || (step < 0.0 && m_true[i] < m_config.lower[i] - kSwitch_mm) ||
                     (step > 0.0 && m_true[i] > m_config.upper[i] + kSwitch_mm);
    }
    if (isOnSwitch)
        raiseAlarm(1);
}

void GrblSimulator::endBlock() {
    if (!m_blocks.empty())
        return;
    m_speed = 0.0;
    m_isStopping = false;
    if (m_state == State::Jog || m_state == State::Run)
        m_state = State::Idle;
}

/// At rest after a hold, a door or a cancelled jog.
void GrblSimulator::stopped() {
    m_speed = 0.0;
    m_isStopping = false;
    if (m_state == State::Jog || m_state == State::Door) // here a door ends every motion
        m_blocks.clear();
    if (m_state == State::Jog)
        m_state = State::Idle;
}

void GrblSimulator::moveHome(double dt_s) {
    m_homingLeft_s -= dt_s;
    if (m_fault == "homing-fails") {
        if (m_homingLeft_s > 0.0)
            return;
        m_homing.clear();
        say("ALARM:9");
        return startUp(true);
    }
    const double left = distance(m_true, m_homing);
    const double way = m_config.homingRate_mm_min / 60.0 * dt_s;
    const double share = way < left ? way / left : 1.0;
    for (std::size_t i = 0; i < m_true.size(); ++i) {
        const double step = share * (m_homing[i] - m_true[i]);
        m_true[i] += step;
        m_reads[i] += step;
    }
    if (share < 1.0)
        return;
    m_reads = m_true = m_homing;
    m_homing.clear();
    m_isHomed = true;
    m_state = State::Idle;
    answer(0);
}

} // namespace bask
