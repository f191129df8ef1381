#pragma once
// A search for Modbus units at one port or address: opens it, scans it with one setting of the line after the
// other, and closes it.

#include "engine/base/clock.h"
#include "engine/drivers/modbus_scan.h"
#include "engine/protocols/serial_settings.h"

#include <memory>

namespace bask {

struct ModbusSearchSpec {
    std::string port; ///< path of a serial port, or address of a host
    bool isNetwork = false;
    /// Settings of a serial port, tried until a unit answers; at least one, also for a network.
    std::vector<SerialSettings> lines{{}};
    int firstUnit = 1, lastUnit = 16;

    bool operator==(const ModbusSearchSpec&) const = default;
};

/// The state of a search; `found` is complete if it is over.
struct ModbusSearchState {
    std::vector<FoundUnit> found;
    double progress = 0.0; ///< 0 to 1
    int unit = 0;          ///< the one that is asked now
    SerialSettings line;   ///< the setting that is tried now, or was last
    bool isOver = false;
    Message problem; ///< why it ended early; code None if it did not
};

/// Needs a thread with Qt's event loop; a search of a network belongs to that thread. Its end closes the
/// port.
class ModbusSearch {
public:
    explicit ModbusSearch(ModbusSearchSpec spec);
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

    ModbusSearchSpec m_spec;
    SteadyClock m_clock;
    std::size_t m_line = 0;
    std::unique_ptr<ModbusLink> m_link;
    std::unique_ptr<ModbusScan> m_scan;
    double m_opening_s = 0.0; ///< since when it is being opened
    ModbusSearchState m_state;
};

} // namespace bask
