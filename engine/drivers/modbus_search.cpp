#include "engine/drivers/modbus_search.h"

#include "engine/base/message_code.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/rtu_link.h"
#include "engine/drivers/serial_link.h"
#include "engine/drivers/tcp_link.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/network_address.h"

namespace bask {

ModbusSearch::ModbusSearch(ModbusSearchSpec spec, std::shared_ptr<TrafficLog> traffic)
    : m_spec(std::move(spec)), m_traffic(std::move(traffic)) {
    if (m_spec.isNetwork && !networkAddress(m_spec.port, kModbusTcpPort))
        end({MessageCode::LinkNotOpened,
             {m_spec.port, "it is no address such as 192.168.1.20, logger:1502 or [fe80::1]:502"}});
    else
        begin();
}

ModbusSearch::~ModbusSearch() = default;

std::unique_ptr<ByteLink> ModbusSearch::logged(std::unique_ptr<ByteLink> link) const {
    if (!m_traffic)
        return link;
    return std::make_unique<LoggedLink>(std::move(link), m_traffic, m_clock, nullptr);
}

void ModbusSearch::begin() {
    m_scan.reset();
    m_link.reset(); // its port is free before it is opened again
    m_state.line = m_spec.lines.at(m_line);
    if (const auto address = networkAddress(m_spec.port, kModbusTcpPort); m_spec.isNetwork && address)
        m_link = std::make_unique<ModbusTcpLink>(
            logged(std::make_unique<TcpLink>(address->host, address->port)), m_clock);
    else
        m_link = std::make_unique<RtuLink>(
            logged(std::make_unique<ByteLinkOnThread>(m_spec.port,
                                                      [port = m_spec.port, line = m_state.line] {
                                                          return std::make_unique<SerialLink>(port, line);
                                                      })),
            m_state.line, m_clock);
    m_scan = std::make_unique<ModbusScan>(*m_link, m_spec.firstUnit, m_spec.lastUnit);
    m_link->open();
    m_opening_s = m_clock.now_s();
}

void ModbusSearch::end(const Message& problem) {
    m_state.isOver = true;
    m_state.problem = problem;
    m_scan.reset();
    m_link.reset();
}

void ModbusSearch::work() {
    if (m_state.isOver)
        return;
    const bool goesOn = m_scan->work();
    m_state.found = m_scan->found();
    m_state.unit = m_scan->unit();
    m_state.progress =
        (static_cast<double>(m_line) + m_scan->progress()) / static_cast<double>(m_spec.lines.size());
    const double now_s = m_clock.now_s();
    if (m_link->isOpen())
        m_opening_s = now_s;
    if (goesOn && now_s - m_opening_s > kOpens_s)
        return end({MessageCode::LinkNotOpened, {m_spec.port, "it does not answer"}});
    if (goesOn)
        return;
    if (m_scan->progress() < 1.0)
        return end(m_link->problem());
    if (m_state.found.empty() && ++m_line < m_spec.lines.size())
        return begin();
    m_state.progress = 1.0;
    end({});
}

ModbusSearchState ModbusSearch::state() const {
    return m_state;
}

} // namespace bask
