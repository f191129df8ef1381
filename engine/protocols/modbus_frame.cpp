#include "engine/protocols/modbus_frame.h"

namespace bask {
namespace {

constexpr std::size_t kShortest = 8; // unit, function, two words, CRC
constexpr int kWriteMany = 16, kWriteOne = 6;
constexpr std::size_t kTcpHeader = 6;                      // transaction, protocol, length
constexpr std::size_t kShortestTcp = 3, kLongestTcp = 254; // from the unit on: an exception, and the longest

int byteAt(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]);
}

int registerAt(std::string_view bytes, std::size_t i) {
    return byteAt(bytes, i) << 8 | byteAt(bytes, i + 1);
}

void append(std::string& out, int word) {
    out += static_cast<char>(word >> 8);
    out += static_cast<char>(word & 0xff);
}

/// Length of the request that begins there; 0: more bytes are needed to tell.
std::size_t requestLength(std::string_view bytes) {
    if (bytes.size() < 2)
        return 0;
    if (byteAt(bytes, 1) != kWriteMany)
        return kShortest;
    return bytes.size() < 7 ? 0 : 9 + static_cast<std::size_t>(byteAt(bytes, 6));
}

bool isSound(std::string_view frame) {
    const std::size_t end = frame.size() - 2;
    return modbusCrc(frame.substr(0, end)) == (byteAt(frame, end) | byteAt(frame, end + 1) << 8);
}

ModbusQuery parsed(std::string_view frame) {
    ModbusQuery out;
    out.unit = byteAt(frame, 0);
    out.function = byteAt(frame, 1);
    out.address = registerAt(frame, 2);
    out.count = registerAt(frame, 4);
    switch (out.function) {
    case 3:
    case 4:
        break;
    case kWriteOne:
        out.values = {static_cast<std::uint16_t>(out.count)};
        out.count = 1;
        break;
    case kWriteMany:
        for (std::size_t i = 7; i + 3 < frame.size(); i += 2)
            out.values.push_back(static_cast<std::uint16_t>(registerAt(frame, i)));
        out.isKnown = byteAt(frame, 6) == 2 * out.count;
        break;
    default:
        out.isKnown = false;
    }
    return out;
}

} // namespace

std::uint16_t modbusCrc(std::string_view bytes) {
    unsigned crc = 0xffff;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1U) != 0 ? crc >> 1U ^ 0xa001U : crc >> 1U;
    }
    return static_cast<std::uint16_t>(crc);
}

std::string modbusFrame(int unit, std::string_view functionAndData) {
    std::string out(1, static_cast<char>(unit));
    out += functionAndData;
    const int crc = modbusCrc(out);
    out += static_cast<char>(crc & 0xff);
    out += static_cast<char>(crc >> 8);
    return out;
}

std::string modbusRequest(const ModbusQuery& query) {
    std::string pdu(1, static_cast<char>(query.function));
    append(pdu, query.address);
    if (query.function != kWriteOne)
        append(pdu, query.values.empty() ? query.count : static_cast<int>(query.values.size()));
    if (query.function == kWriteMany)
        pdu += static_cast<char>(2 * query.values.size());
    for (const std::uint16_t value : query.values)
        append(pdu, value);
    return modbusFrame(query.unit, pdu);
}

std::optional<ModbusQuery> takeModbusQuery(std::string& bytes) {
    std::string_view left = bytes;
    std::optional<ModbusQuery> found;
    while (!found) {
        const std::size_t length = requestLength(left);
        if (length == 0 || length > left.size())
            break;
        if (isSound(left.substr(0, length))) {
            found = parsed(left.substr(0, length));
            left.remove_prefix(length);
        } else {
            left.remove_prefix(1);
        }
    }
    bytes.erase(0, bytes.size() - left.size());
    return found;
}

std::string modbusReadReply(int unit, int function, const std::vector<std::uint16_t>& values) {
    std::string pdu(1, static_cast<char>(function));
    pdu += static_cast<char>(2 * values.size());
    for (const std::uint16_t value : values)
        append(pdu, value);
    return modbusFrame(unit, pdu);
}

std::string modbusWriteReply(const ModbusQuery& query) {
    std::string pdu(1, static_cast<char>(query.function));
    append(pdu, query.address);
    append(pdu, query.function == kWriteOne ? query.values.front() : query.count);
    return modbusFrame(query.unit, pdu);
}

std::string modbusTcpFrame(int transaction, std::string_view unitAndPdu) {
    std::string out;
    append(out, transaction);
    append(out, 0);
    append(out, static_cast<int>(unitAndPdu.size()));
    out += unitAndPdu;
    return out;
}

bool isModbusTcpBroken(std::string_view bytes) {
    if (bytes.size() >= 4 && registerAt(bytes, 2) != 0)
        return true;
    if (bytes.size() < kTcpHeader)
        return false;
    const auto length = static_cast<std::size_t>(registerAt(bytes, 4));
    return length < kShortestTcp || length > kLongestTcp;
}

std::optional<ModbusTcpFrame> takeModbusTcpFrame(std::string_view& bytes) {
    if (bytes.size() < kTcpHeader || isModbusTcpBroken(bytes))
        return std::nullopt;
    const auto length = static_cast<std::size_t>(registerAt(bytes, 4));
    if (bytes.size() < kTcpHeader + length)
        return std::nullopt;
    ModbusTcpFrame frame{registerAt(bytes, 0), std::string(bytes.substr(kTcpHeader, length))};
    bytes.remove_prefix(kTcpHeader + length);
    return frame;
}

std::string modbusException(int unit, int function, int exception) {
    const char pdu[] = {static_cast<char>(function | 0x80), static_cast<char>(exception)};
    return modbusFrame(unit, {pdu, sizeof pdu});
}

} // namespace bask
