#include "engine/device_simulators/modbus_tcp_simulator.h"

#include "engine/protocols/modbus_frame.h"

#include <algorithm>

namespace bask {
namespace {

constexpr std::size_t kHeader = 7;   // transaction, protocol, length, unit
constexpr std::size_t kShortest = 5; // unit, function, exception or count, CRC

int wordAt(std::string_view bytes, std::size_t i) {
    return static_cast<unsigned char>(bytes[i]) << 8 | static_cast<unsigned char>(bytes[i + 1]);
}

std::string word(std::size_t value) {
    return {static_cast<char>(value >> 8U), static_cast<char>(value & 0xffU)};
}

/// Of the reply that begins there.
std::size_t lengthOf(const std::string& line) {
    const int function = static_cast<unsigned char>(line[1]);
    if (function > 0x80)
        return kShortest;
    return function == 3 || function == 4 ? kShortest + static_cast<unsigned char>(line[2]) : 8;
}

} // namespace

void ModbusTcpSimulator::opened(double) {
    m_partial.clear();
    m_open.clear();
}

void ModbusTcpSimulator::receive(std::string_view bytes, double now_s) {
    m_partial += bytes;
    while (m_partial.size() > kHeader) {
        const auto length = static_cast<std::size_t>(wordAt(m_partial, 4)); // from the unit on
        if (m_partial.size() < kHeader - 1 + length)
            return;
        const std::string unitAndPdu = m_partial.substr(kHeader - 1, length);
        const int unit = static_cast<unsigned char>(unitAndPdu.at(0));
        m_functions.push_back(static_cast<unsigned char>(unitAndPdu.at(1)));
        const bool reads = m_functions.back() == 3 || m_functions.back() == 4;
        if (!m_isSilent)
            m_open.push_back({wordAt(m_partial, 0), unit,
                              reads ? 5 + 2 * static_cast<std::size_t>(wordAt(unitAndPdu, 4)) : 8});
        m_partial.erase(0, kHeader - 1 + length);
        m_units.receive(modbusFrame(unit, unitAndPdu.substr(1)), now_s);
    }
}

std::string ModbusTcpSimulator::transmit(double now_s) {
    std::string out;
    for (std::string line = m_units.transmit(now_s); line.size() >= kShortest && !m_open.empty();) {
        const std::size_t length = std::min(lengthOf(line), line.size());
        out += wrapped(line.substr(0, length));
        line.erase(0, length);
    }
    return out;
}

/// A frame tells its request by its unit and length, or else it is the oldest one's.
std::string ModbusTcpSimulator::wrapped(const std::string& frame) {
    auto open = std::ranges::find_if(m_open, [&](const Open& each) {
        return each.unit == static_cast<unsigned char>(frame[0]) && each.length == frame.size();
    });
    if (open == m_open.end())
        open = m_open.begin();
    const auto id = static_cast<std::size_t>(open->id + (m_isIdWrong ? 1000 : 0));
    m_open.erase(open);
    const std::string unitAndPdu = frame.substr(0, frame.size() - 2);
    return word(id) + word(0) + word(unitAndPdu.size()) + unitAndPdu;
}

std::vector<std::string> ModbusTcpSimulator::faults() const {
    auto out = m_units.faults();
    out.emplace_back("wrong-id");
    return out;
}

Result<void> ModbusTcpSimulator::setFault(const std::string& name) {
    m_isIdWrong = name == "wrong-id";
    m_isSilent = name == "silent";
    return m_units.setFault(m_isIdWrong ? "none" : name);
}

} // namespace bask
