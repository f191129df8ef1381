#include "engine/protocols/namur_lines.h"

#include "engine/protocols/plain_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

/// With a decimal point, whatever the language of the computer.
std::string withNumber(std::string command, double value, int decimals) {
    std::array<char, 40> text{};
    const auto [end, failed] =
        std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, decimals);
    if (failed != std::errc())
        throw std::invalid_argument("namur: a number");
    return command.append(text.begin(), end);
}

/// How watchdogs say their time back is not told by the manuals: seen are the number and the command.
std::string_view withoutCommand(std::string_view line) {
    const std::size_t at = line.find('@');
    return at == std::string_view::npos ? line : line.substr(at + 1);
}

} // namespace

std::string namurLine(const std::string& command) {
    return command + " \r\n";
}

std::string namurSetPoint(double setPoint_degC) {
    return withNumber("OUT_SP_1 ", setPoint_degC, 1);
}

std::string namurWatchdog(double time_s) {
    return withNumber("OUT_WD1@", time_s, 0);
}

std::optional<NamurValue> namurValue(std::string_view line) {
    line = withoutBlanks(line);
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos)
        return std::nullopt;
    const auto value = plainNumber(line.substr(0, blank));
    const std::string_view channel = withoutBlanks(line.substr(blank));
    if (!value || channel.size() != 1 || channel[0] < '0' || channel[0] > '9')
        return std::nullopt;
    return NamurValue{*value, channel[0] - '0'};
}

bool isWatchdogEcho(std::string_view line, double time_s) {
    line = withoutBlanks(withoutCommand(withoutBlanks(line)));
    const auto value = plainNumber(line.substr(0, line.find(' ')));
    return value && std::abs(*value - time_s) < 0.6; // it may round
}

bool isNamurName(std::string_view line) {
    line = withoutBlanks(line);
    constexpr std::array kCommands{"IN_", "OUT_", "START_", "STOP_"};
    const bool isCommand =
        std::ranges::any_of(kCommands, [&](const char* start) { return line.starts_with(start); });
    const bool isText = std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; });
    const bool hasLetter =
        std::ranges::any_of(line, [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
    return isText && hasLetter && !isCommand;
}

} // namespace bask
