#include "engine/protocols/grbl_lines.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr std::size_t kMaxShown = 60;  // characters of garbage
constexpr double kFarthest = 9999.999; // mm, degrees
constexpr double kMinFeed = 0.1, kMaxFeed = 99999.9;

constexpr std::array<std::pair<std::string_view, GrblState>, 10> kStates{{{"Idle", GrblState::Idle},
                                                                          {"Run", GrblState::Run},
                                                                          {"Hold", GrblState::Hold},
                                                                          {"Jog", GrblState::Jog},
                                                                          {"Alarm", GrblState::Alarm},
                                                                          {"Door", GrblState::Door},
                                                                          {"Check", GrblState::Check},
                                                                          {"Home", GrblState::Home},
                                                                          {"Sleep", GrblState::Sleep},
                                                                          {"Tool", GrblState::Tool}}};

constexpr std::array<std::pair<int, const char*>, 19> kAlarms{
    {{1, "hard limit"},
     {2, "target beyond the soft limits"},
     {3, "reset while in motion"},
     {4, "probe not in its first state"},
     {5, "probe without contact"},
     {6, "reset while homing"},
     {7, "door opened while homing"},
     {8, "homing switch did not clear"},
     {9, "homing switch not found"},
     {10, "emergency stop, or a second homing switch"},
     {11, "homing required"},
     {12, "limit switch engaged"},
     {13, "probe protection"},
     {14, "spindle"},
     {15, "homing of the second motor"},
     {16, "power-on self-test"},
     {17, "motor fault"},
     {18, "homing is set up wrongly"},
     {21, "stored settings unreadable"}}};

constexpr std::array<std::pair<int, const char*>, 27> kErrors{{{1, "a word without its letter"},
                                                               {2, "a number that cannot be read"},
                                                               {3, "unknown $ command"},
                                                               {4, "a negative number"},
                                                               {5, "homing is switched off"},
                                                               {6, "step pulse too short"},
                                                               {7, "stored settings unreadable"},
                                                               {8, "only when idle"},
                                                               {9, "locked by an alarm or a jog"},
                                                               {10, "soft limits need homing"},
                                                               {11, "line too long"},
                                                               {12, "step rate too high"},
                                                               {13, "door open"},
                                                               {14, "start-up line too long"},
                                                               {15, "jog beyond the travel"},
                                                               {16, "no valid jog"},
                                                               {17, "laser mode needs PWM"},
                                                               {18, "reset asserted"},
                                                               {20, "unsupported command"},
                                                               {21, "two commands of one group"},
                                                               {22, "no feed rate"},
                                                               {25, "a word twice"},
                                                               {33, "invalid target"},
                                                               {45, "limit switch engaged"},
                                                               {46, "homing required"},
                                                               {50, "emergency stop"},
                                                               {79, "motor fault"}}};

template <std::size_t N>
std::string words(const std::array<std::pair<int, const char*>, N>& table, int number) {
    const auto it = std::ranges::find(table, number, &std::pair<int, const char*>::first);
    return it == table.end() ? std::string() : it->second;
}

std::optional<int> wholeNumber(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size() || value < 0)
        return std::nullopt;
    return value;
}

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> out;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t to = std::min(text.find(at, from), text.size());
        out.push_back(text.substr(from, to - from));
        from = to + 1;
    }
    return out;
}

/// Positions; empty when one of them is no plain number.
std::vector<double> positions(std::string_view text) {
    std::vector<double> out;
    for (const std::string_view part : split(text, ',')) {
        double value = 0.0;
        const auto [end, error] =
            std::from_chars(part.data(), part.data() + part.size(), value, std::chars_format::fixed);
        if (part.empty() || error != std::errc() || end != part.data() + part.size() || !std::isfinite(value))
            return {};
        out.push_back(value);
    }
    return out;
}

bool readState(std::string_view text, GrblStatus& status) {
    const auto parts = split(text, ':');
    const auto it = std::ranges::find(kStates, parts[0], &std::pair<std::string_view, GrblState>::first);
    if (it == kStates.end() || parts.size() > 2)
        return false;
    status.state = it->second;
    status.word = text;
    if (parts.size() == 2) {
        status.part = wholeNumber(parts[1]);
        return status.part.has_value();
    }
    return true;
}

bool readPositions(std::string_view value, std::vector<double>& into) {
    const bool isFirst = into.empty();
    into = positions(value);
    return isFirst && !into.empty();
}

bool readBuffer(std::string_view value, GrblStatus& status) {
    const auto parts = split(value, ',');
    if (parts.size() != 2)
        return false;
    status.freeBlocks = wholeNumber(parts[0]);
    status.freeBytes = wholeNumber(parts[1]);
    return status.freeBlocks && status.freeBytes;
}

bool readHomed(std::string_view value, GrblStatus& status) {
    const auto parts = split(value, ',');
    const auto homed = wholeNumber(parts[0]);
    if (!homed || parts.size() > 2)
        return false;
    status.isHomed = *homed != 0;
    if (parts.size() == 2) {
        const auto mask = wholeNumber(parts[1]);
        if (!mask)
            return false;
        status.homedAxes = static_cast<unsigned>(*mask);
    }
    return true;
}

/// False where the field is damaged; fields that are not used here (FS, Ov, A ...) pass.
bool readField(std::string_view field, GrblStatus& status) {
    const std::size_t colon = field.find(':');
    if (colon == std::string_view::npos || colon == 0)
        return false;
    const std::string_view name = field.substr(0, colon), value = field.substr(colon + 1);
    if (name == "MPos")
        return readPositions(value, status.machine);
    if (name == "WPos")
        return readPositions(value, status.work);
    if (name == "WCO")
        return readPositions(value, status.offset);
    if (name == "Bf")
        return readBuffer(value, status);
    if (name == "H")
        return readHomed(value, status);
    if (name == "Pn")
        status.pins = value;
    return true;
}

std::optional<GrblStatus> readStatus(std::string_view inside) {
    if (inside.find_first_of("<>[]") != std::string_view::npos)
        return std::nullopt; // two reports run into one
    GrblStatus status;
    const auto fields = split(inside, '|');
    if (!readState(fields[0], status))
        return std::nullopt;
    for (std::size_t i = 1; i < fields.size(); ++i)
        if (!readField(fields[i], status))
            return std::nullopt;
    return status;
}

GrblLine readReport(std::string_view inside) {
    constexpr std::string_view kOptions = "OPT:";
    if (!inside.starts_with(kOptions))
        return GrblReport{std::string(inside)};
    const auto parts = split(inside.substr(kOptions.size()), ',');
    const auto blocks = parts.size() > 1 ? wholeNumber(parts[1]) : std::nullopt;
    const auto bytes = parts.size() > 2 ? wholeNumber(parts[2]) : std::nullopt;
    if (!blocks || !bytes)
        return GrblReport{std::string(inside)};
    return GrblOptions{std::string(parts[0]), *blocks, *bytes};
}

/// "Grbl 1.1h" of `Grbl 1.1h ['$' for help]`, wherever it stands.
std::optional<std::string> bannerIn(std::string_view line) {
    for (const std::string_view name : {"GrblHAL ", "Grbl "}) {
        const std::size_t at = line.find(name);
        if (at == std::string_view::npos || at + name.size() >= line.size())
            continue;
        const char first = line[at + name.size()];
        if (first < '0' || first > '9')
            continue;
        const std::size_t end = std::min(line.find_first_of(" [", at + name.size()), line.size());
        return std::string(line.substr(at, end - at));
    }
    return std::nullopt;
}

GrblLine garbage(std::string_view line) {
    std::string text(line.substr(0, kMaxShown));
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '.');
    return GrblGarbage{std::move(text)};
}

std::optional<GrblLine> readNumbered(std::string_view line) {
    constexpr std::string_view kError = "error:", kAlarm = "ALARM:";
    if (line.starts_with(kError)) {
        if (const auto number = wholeNumber(line.substr(kError.size())))
            return GrblError{*number};
    } else if (line.starts_with(kAlarm)) {
        if (const auto number = wholeNumber(line.substr(kAlarm.size())))
            return GrblAlarm{*number};
    } else if (line.starts_with('$')) {
        const std::size_t equals = line.find('=');
        if (equals != std::string_view::npos)
            if (const auto number = wholeNumber(line.substr(1, equals - 1)))
                return GrblSetting{*number, std::string(line.substr(equals + 1))};
    }
    return std::nullopt;
}

/// With a point whatever the language of the computer.
std::string fixed(double value, int decimals) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                   std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

Error outOfRange(double value, double min, double max, const char* where, const char* unit) {
    return Error(MessageCode::ValueOutOfRange, where,
                 {formatNumber(value), formatNumber(min), formatNumber(max, 7), unit});
}

} // namespace

GrblLine parseGrblLine(std::string_view line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
        line.remove_suffix(1);
    if (line.empty())
        return GrblBlank{};
    if (line == "ok")
        return GrblOk{};
    if (line.front() == '<' && line.back() == '>' && line.size() > 2)
        if (auto status = readStatus(line.substr(1, line.size() - 2)))
            return *std::move(status);
    if (line.front() == '[' && line.back() == ']' && line.size() > 2)
        return readReport(line.substr(1, line.size() - 2));
    if (auto banner = bannerIn(line))
        return GrblBanner{*std::move(banner)};
    if (auto numbered = readNumbered(line))
        return *std::move(numbered);
    return garbage(line);
}

std::string grblAlarmWords(int number) {
    return words(kAlarms, number);
}

std::string grblErrorWords(int number) {
    return words(kErrors, number);
}

bool isPlaceKept(int alarm) {
    constexpr std::array kKept{2, 4, 5, 12, 14}; // stopped by a ramp, or before any motion
    return std::ranges::find(kKept, alarm) != kKept.end();
}

std::optional<double> grblNumber(std::string_view value) {
    const std::vector<double> numbers = positions(value);
    return numbers.size() == 1 ? std::optional(numbers.front()) : std::nullopt;
}

std::optional<double> grblFeedIn(std::string_view report) {
    for (const std::string_view word : split(report, ' ')) {
        if (word.starts_with('F'))
            return grblNumber(word.substr(1));
    }
    return std::nullopt;
}

double grblRounded(double position) {
    return std::round(position * 1000.0) / 1000.0;
}

Result<std::string> grblJogLine(const std::vector<GrblTarget>& targets, double time_s) {
    if (!(time_s > 0.0))
        return outOfRange(time_s, 0.0, 1e3, "time", "s");
    std::string line = "$J=G21G90G53";
    double squares = 0.0;
    for (const GrblTarget& target : targets) {
        if (!(std::abs(target.to) <= kFarthest))
            return outOfRange(target.to, -kFarthest, kFarthest, "position", "");
        line += target.letter + fixed(grblRounded(target.to), 3);
        squares += std::pow(target.to - target.from, 2);
    }
    const double feed = 60.0 * std::sqrt(squares) / time_s;
    return line + 'F' + fixed(std::isfinite(feed) ? std::clamp(feed, kMinFeed, kMaxFeed) : kMinFeed, 1) +
           '\n';
}

} // namespace bask
