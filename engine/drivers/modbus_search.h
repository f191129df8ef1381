#pragma once
// A search for Modbus units at one port or address: opens it, scans it with one setting of the line after the
// other, and closes it.

#include "engine/base/clock.h"
#include "engine/drivers/found_units.h"
#include "engine/drivers/logged_link.h"
#include "engine/drivers/modbus_scan.h"

#include <memory>

namespace bask {

/// Needs a thread with Qt's event loop; a search of a network belongs to that thread. Its end closes the
/// port.
class ModbusSearch {
public:
    /// What goes over its link is added to `traffic`; null: it is not kept.
    explicit ModbusSearch(ModbusSearchSpec spec, std::shared_ptr<TrafficLog> traffic = nullptr);
    ~ModbusSearch();

    /// Sends what is due and takes what has come; never waits.
    void work();
    ModbusSearchState state() const;
    /// Returns whether another thread may destroy it.
    bool mayEndElsewhere() const { return !m_spec.isNetwork; }

private:
    static constexpr double kOpens_s = 3.5; ///< a host that has not answered until then is not there

    void begin();
    void end(const Message& problem);

    std::unique_ptr<ByteLink> logged(std::unique_ptr<ByteLink> link) const;

    ModbusSearchSpec m_spec;
    std::shared_ptr<TrafficLog> m_traffic;
    SteadyClock m_clock;
    std::size_t m_line = 0;
    std::unique_ptr<ModbusLink> m_link;
    std::unique_ptr<ModbusScan> m_scan;
    double m_opening_s = 0.0; ///< since when it is being opened
    ModbusSearchState m_state;
};

} // namespace bask
