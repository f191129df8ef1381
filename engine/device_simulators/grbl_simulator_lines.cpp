// The bytes and lines that a simulated Grbl takes.

#include "engine/device_simulators/grbl_simulator.h"
#include "engine/protocols/grbl_lines.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace bask {
namespace {

constexpr double kSlow_s = 3.0; // "slow-ok"
constexpr std::size_t kLineBytes = 80;

} // namespace

void GrblSimulator::takeByte(char byte) {
    switch (byte) {
    case grbl::kStatus:
    case '\x80':
        if (m_state != State::Home || m_config.isHal)
            say(status());
        return;
    case grbl::kReset:
        return reset();
    case grbl::kHold:
        if (m_state == State::Jog)
            return cancelJog(); // Grbl ends a jog by a hold
        if (m_state == State::Idle || m_state == State::Run) {
            m_isStopping = m_speed > 0.0;
            m_state = State::Hold;
        }
        return;
    case grbl::kResume:
        if (m_state == State::Hold || (m_state == State::Door && !m_isDoorOpen)) {
            m_isStopping = false;
            m_state = m_blocks.empty() ? State::Idle : State::Run;
        }
        return;
    case grbl::kJogCancel:
        if (m_config.isHal) { // what has not been taken is dropped, without an answer
            m_lines.clear();
            m_partial.clear();
        }
        if (m_state == State::Jog)
            cancelJog();
        return;
    default:
        break;
    }
    if (byte != '\n' && byte != '\r') {
        m_partial += byte;
    } else if (byte == '\n') {
        m_lines.push_back({m_now_s + (m_fault == "slow-ok" ? kSlow_s : m_config.lineTime_s), m_partial});
        m_partial.clear();
    }
}

bool GrblSimulator::takesLines() const {
    const bool isPaused = m_state == State::Hold || m_state == State::Door || m_state == State::Home;
    return !isPaused && !m_isStopping && !m_isDwelling && m_blocks.size() < kBlocks;
}

void GrblSimulator::takeLines() {
    while (takesLines() && !m_lines.empty() && m_lines.front().time_s <= m_now_s) {
        const std::string line = m_lines.front().text;
        m_lines.pop_front();
        take(line);
    }
}

void GrblSimulator::take(const std::string& line) {
    std::string text;
    for (const char c : line)
        if (c > ' ')
            text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (m_needsReset)
        return answer(9);
    if (line.size() >= kLineBytes)
        return answer(11);
    if (text.empty())
        return answer(0);
    const int error = text[0] == '$' ? takeDollar(text) : takeCode(text);
    if (error >= 0)
        answer(error);
}

/// Error number; -1: answers later.
int GrblSimulator::takeDollar(const std::string& line) {
    const bool isAtRest = m_state == State::Idle || m_state == State::Alarm;
    if (line.starts_with("$J="))
        return takeJog(line.substr(3));
    if (line == "$G") {
        say("[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F" + std::to_string(std::lround(60.0 * m_feed_mm_s)) +
            " S0]");
        return 0;
    }
    if (!isAtRest)
        return 8;
    if (line == "$I") {
        say((m_config.isHal ? "[VER:1.1f.20240101:" : "[VER:1.1h.20190825:") + m_config.name + "]");
        say(m_config.isHal ? "[OPT:VNMSL,100,1024,4,0]" : "[OPT:V,15,128]");
    } else if (line == "$$") {
        for (const auto& [number, value] : m_settings)
            say("$" + std::to_string(number) + "=" + value);
    } else if (line == "$X") {
        if (m_state == State::Alarm)
            say("[MSG:Caution: Unlocked]");
        m_state = State::Idle;
    } else if (line == "$H") {
        if (!m_config.canHome)
            return 5;
        home();
        return -1;
    } else {
        return takeSetting(line);
    }
    return 0;
}

int GrblSimulator::takeSetting(const std::string& line) {
    const GrblLine parsed = parseGrblLine(line);
    const auto* setting = std::get_if<GrblSetting>(&parsed);
    if (setting == nullptr)
        return 3;
    if (m_state == State::Alarm)
        return 9;
    m_settings[setting->number] = setting->value;
    if (setting->number == 10)
        m_config.tellsWork = std::atoi(setting->value.c_str()) % 2 == 0;
    if (setting->number == 13)
        m_config.tellsInches = setting->value != "0";
    return 0;
}

GrblSimulator::Words GrblSimulator::readWords(const std::string& text) const {
    Words words;
    for (const char *p = text.data(), *end = p + text.size(); p != end;) {
        const char letter = *p++;
        if (letter < 'A' || letter > 'Z')
            return {{}, {}, 1};
        double value = 0.0;
        const auto [after, error] = std::from_chars(p, end, value, std::chars_format::fixed);
        if (error != std::errc())
            return {{}, {}, 2};
        p = after;
        const std::size_t axis = grbl::kLetters.find(letter);
        if (letter == 'G')
            words.g.push_back(static_cast<int>(std::lround(10.0 * value)));
        else if (letter != 'F' && letter != 'P' && axis >= m_true.size())
            return {{}, {}, 20};
        else if (!words.values.emplace(letter, value).second)
            return {{}, {}, 25};
    }
    return words;
}

int GrblSimulator::takeJog(const std::string& text) {
    if (m_state == State::Alarm)
        return 9;
    if (m_state != State::Idle && m_state != State::Jog)
        return 8;
    const Words words = readWords(text);
    if (words.error != 0)
        return words.error;
    bool isRelative = m_isRelative, isInches = m_isInches;
    for (const int g : words.g) {
        if (g != 200 && g != 210 && g != 900 && g != 910 && g != 530)
            return 16;
        isRelative = g == 910 || (isRelative && g != 900);
        isInches = g == 200 || (isInches && g != 210);
    }
    if (words.values.contains('P'))
        return 16;
    const auto feed = words.values.find('F');
    if (feed == words.values.end() || !(feed->second > 0.0))
        return 22;
    return queue(words, isRelative, isInches, feed->second / 60.0 * (isInches ? kInch_mm : 1.0), true);
}

int GrblSimulator::takeCode(const std::string& text) {
    if (m_state == State::Alarm || m_state == State::Jog)
        return 9;
    const Words words = readWords(text);
    if (words.error != 0)
        return words.error;
    bool isDwell = false, isOffset = false;
    for (const int g : words.g) {
        isOffset = isOffset || g == 920;
        if (g == 0 || g == 10)
            m_motion = g / 10;
        else if (g == 200 || g == 210)
            m_isInches = g == 200;
        else if (g == 900 || g == 910)
            m_isRelative = g == 910;
        else if (g == 40)
            isDwell = true;
        else if (g != 530 && g != 920)
            return 20;
    }
    for (std::size_t i = 0; isOffset && i < m_reads.size(); ++i)
        if (const auto word = words.values.find(grbl::kLetters[i]); word != words.values.end())
            m_config.workOffset[i] = m_reads[i] - word->second * (m_isInches ? kInch_mm : 1.0);
    if (isOffset)
        return 0;
    if (const auto feed = words.values.find('F'); feed != words.values.end())
        m_feed_mm_s = feed->second / 60.0 * (m_isInches ? kInch_mm : 1.0);
    if (isDwell) {
        const auto pause = words.values.find('P');
        m_isDwelling = true; // from when the queue is empty; its ok comes at the end
        m_dwellUntil_s = pause == words.values.end() ? 0.0 : pause->second;
        return -1;
    }
    const bool hasAxis = std::ranges::any_of(words.values, [](const auto& word) {
        return grbl::kLetters.find(word.first) != std::string_view::npos;
    });
    if (!hasAxis)
        return 0;
    if (m_motion == 1 && m_feed_mm_s <= 0.0)
        return 22;
    return queue(words, m_isRelative, m_isInches, m_motion == 0 ? HUGE_VAL : m_feed_mm_s, false);
}

int GrblSimulator::queue(const Words& words, bool isRelative, bool isInches, double feed_mm_s, bool isJog) {
    Block block{m_blocks.empty() ? m_reads : m_blocks.back().to, feed_mm_s};
    const std::vector<double> from = block.to;
    bool hasAxis = false, isBeyond = false;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const auto word = words.values.find(grbl::kLetters[i]);
        if (word == words.values.end())
            continue;
        hasAxis = true;
        const double value = word->second * (isInches ? kInch_mm : 1.0);
        block.to[i] = isRelative ? from[i] + value : value;
        isBeyond = isBeyond || block.to[i] < m_config.lower[i] || block.to[i] > m_config.upper[i];
    }
    if (!hasAxis)
        return 16;
    if (isBeyond && m_config.hasSoftLimits && m_isHomed) {
        if (isJog || m_config.isHal)
            return 15;
        raiseAlarm(2);
        return 0;
    }
    const double length = distance(from, block.to);
    if (length < kThere)
        return 0;
    for (std::size_t i = 0; i < from.size(); ++i) // each motor's own limit
        if (const double share = std::abs(block.to[i] - from[i]) / length; share > 0.0)
            block.feed_mm_s = std::min(block.feed_mm_s, m_config.maxRate_mm_min / 60.0 / share);
    m_blocks.push_back(block);
    m_state = isJog ? State::Jog : State::Run;
    return 0;
}

} // namespace bask
