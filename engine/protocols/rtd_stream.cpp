#include "engine/protocols/rtd_stream.h"

#include "engine/protocols/plain_number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace bask {
namespace {

constexpr double kLowest_degC = -200.0, kHighest_degC = 850.0; ///< of a PT100, IEC 60751
/// The converter's codes 0 and 32767 as temperatures: what it prints when nothing answers at all.
constexpr std::array kDead_degC{-246.86, 988.79};

RtdFault faultOf(double value_degC) {
    if (std::ranges::any_of(kDead_degC, [&](double dead) { return std::abs(value_degC - dead) < 0.011; }))
        return RtdFault::Other;
    return value_degC < kLowest_degC || value_degC > kHighest_degC ? RtdFault::OutOfRange : RtdFault::None;
}

/// Bits of the fault register: 7 above the high threshold, 6 below the low one, 5 to 3 reference and force
/// open, 2 voltage.
RtdFault faultOfBits(unsigned bits) {
    if ((bits & 0xB8U) != 0)
        return RtdFault::Open;
    return (bits & 0x40U) != 0 ? RtdFault::Short : bits != 0 ? RtdFault::Other : RtdFault::None;
}

/// The hexadecimal number that the text begins with.
std::optional<unsigned> hexadecimal(std::string_view text) {
    unsigned value = 0;
    const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    return failed == std::errc() ? std::optional(value) : std::nullopt;
}

/// "T2" -> 1, "Temperature" -> 0; -1: no channel's name.
int channelOf(std::string_view name) {
    if (name == "Temperature")
        return 0;
    if (name.size() < 2 || name.size() > 3 || (name[0] != 'T' && name[0] != 't'))
        return -1;
    const auto number = plainNumber(name.substr(1));
    const bool isCount = number && *number >= 1.0 && *number == std::floor(*number);
    return isCount ? static_cast<int>(*number) - 1 : -1;
}

/// "23.4", "23.4 C", "23.4 °C".
std::optional<double> temperatureIn(std::string_view text) {
    for (const std::string_view unit : {"degC", "\u00b0C", "C"})
        if (text.ends_with(unit)) {
            text.remove_suffix(unit.size());
            break;
        }
    return plainNumber(withoutBlanks(text));
}

bool isNotANumber(std::string_view text) {
    return text == "nan" || text == "NaN" || text == "NAN" || text == "-nan";
}

/// The pieces between commas, semicolons or blanks; empty where one is missing.
std::vector<std::string_view> columnsOf(std::string_view line) {
    if (temperatureIn(line))
        return {line};
    const char* between = line.find_first_of(",;") != std::string_view::npos ? ",;" : " \t";
    std::vector<std::string_view> columns;
    for (;;) {
        const std::size_t end = line.find_first_of(between);
        columns.push_back(withoutBlanks(line.substr(0, end)));
        if (end == std::string_view::npos)
            return columns;
        line.remove_prefix(end + 1);
        if (between[0] == ' ')
            line = withoutBlanks(line);
    }
}

bool isText(std::string_view line) {
    return std::ranges::all_of(line, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; });
}

} // namespace

RtdStream::RtdStream(int channels) : m_channels(static_cast<std::size_t>(std::max(channels, 0))) {}

void RtdStream::add(std::string_view bytes, double stamp) {
    m_lines.add(bytes);
    while (const auto line = m_lines.next()) {
        const bool isHalf = std::exchange(m_isFirst, false);
        if (!isHalf && !readLine(withoutBlanks(*line), stamp))
            m_discarded.push_back(*line);
    }
}

bool RtdStream::readLine(std::string_view line, double stamp) {
    if (!line.empty() && line.find("Fault") != std::string_view::npos)
        return readFault(line);
    if (const std::size_t mid = line.find_first_of("=:"); mid != std::string_view::npos)
        return readNamed(withoutBlanks(line.substr(0, mid)), withoutBlanks(line.substr(mid + 1)), stamp);
    // A row begins with a number or what stands for one; all else are words.
    const bool isRow = !line.empty() &&
                       (line.find_first_of("0123456789+-.,;") == 0 || isNotANumber(columnsOf(line).front()));
    return isRow ? readRow(line, stamp) : isText(line);
}

/// A fault whose bits cannot be read is a fault all the same.
bool RtdStream::readFault(std::string_view line) {
    const std::size_t at = line.find("Fault"), digits = line.find("0x", at);
    std::string_view name = withoutBlanks(line.substr(0, at));
    const auto bits =
        digits != std::string_view::npos ? hexadecimal(withoutBlanks(line.substr(digits + 2))) : std::nullopt;
    const RtdFault fault = bits ? faultOfBits(*bits) : RtdFault::Other;
    if (fault == RtdFault::None || name == "No")
        return true;
    name = withoutBlanks(name.substr(0, name.find_first_of("=:")));
    const int only = channelOf(name);
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        if (only >= 0 && only != static_cast<int>(i))
            continue;
        m_channels[i].next = fault;
        m_channels[i].value.fault = fault;
        m_channels[i].value.value_degC = 0.0;
    }
    return isText(line);
}

bool RtdStream::readNamed(std::string_view key, std::string_view value, double stamp) {
    const int channel = channelOf(key);
    if (channel < 0)
        return isText(key) && isText(value);
    const auto temperature = temperatureIn(value);
    if (!temperature && !isNotANumber(value))
        return false;
    if (channel < static_cast<int>(m_channels.size()))
        told(channel, temperature.value_or(0.0), temperature ? faultOf(*temperature) : RtdFault::Other,
             stamp);
    return true;
}

/// A row with another count of numbers than the one before has lost a part.
bool RtdStream::readRow(std::string_view line, double stamp) {
    const auto columns = columnsOf(line);
    const std::size_t before = std::exchange(m_columns, columns.size());
    if ((before != 0 && before != columns.size()) || columns.size() < m_channels.size())
        return false;
    std::vector<std::optional<double>> values;
    for (const std::string_view column : columns) {
        values.push_back(temperatureIn(column));
        if (!values.back() && !isNotANumber(column))
            return false;
    }
    for (std::size_t i = 0; i < m_channels.size(); ++i)
        told(static_cast<int>(i), values[i].value_or(0.0), values[i] ? faultOf(*values[i]) : RtdFault::Other,
             stamp);
    return true;
}

void RtdStream::told(int channel, double value_degC, RtdFault fault, double stamp) {
    Channel& told = m_channels[static_cast<std::size_t>(channel)];
    if (told.isWaiting)
        settle(); // the next round
    const RtdFault spoilt = std::exchange(told.next, RtdFault::None);
    const RtdFault all = spoilt != RtdFault::None ? spoilt : fault;
    told.value = {channel, all == RtdFault::None ? value_degC : 0.0, all, stamp};
    told.isWaiting = true;
}

void RtdStream::settle() {
    for (Channel& channel : m_channels)
        if (std::exchange(channel.isWaiting, false))
            m_certain.push_back(channel.value);
}

bool RtdStream::isWaiting() const {
    return std::ranges::any_of(m_channels, &Channel::isWaiting);
}

std::vector<RtdValue> RtdStream::take() {
    return std::exchange(m_certain, {});
}

std::vector<std::string> RtdStream::takeDiscarded() {
    return std::exchange(m_discarded, {});
}

void RtdStream::clear() {
    m_lines.clear();
    m_channels.assign(m_channels.size(), {});
    m_certain.clear();
    m_columns = 0;
    m_isFirst = true;
}

} // namespace bask
