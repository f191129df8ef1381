#pragma once
// Finds the Modbus units that answer at a port, and which of the shipped profiles fit. It only reads.

#include "engine/drivers/found_units.h"
#include "engine/drivers/modbus_link.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_ranges.h"

#include <deque>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

namespace bask {

/// Asks one unit after the other for one register by function 3. One that answers, also by an exception, is
/// asked for the registers of each profile by functions 3 and 4. Nothing is ever written. A unit that does
/// not answer takes the time of one reply if the link allows to overtake, and twice that time otherwise.
class ModbusScan {
public:
    /// Calls open() of `link` again if it closes because nobody answers. `link` must outlive it.
    ModbusScan(ModbusLink& link, int firstUnit, int lastUnit);

    /// Sends what is due and takes what has come; false when all is done, or the link is lost.
    bool work();
    /// Returns the unit that is asked now.
    int unit() const { return m_unit; }
    /// Returns how much of it is done, 0 to 1.
    double progress() const;
    /// Returns the units that were found; the last one is incomplete while unit() is that unit.
    const std::vector<FoundUnit>& found() const { return m_found; }

private:
    using RangeKey = std::tuple<int, int, int>; ///< function, address, count

    bool isLinkThere();
    void ask();
    void take(const ModbusReply& reply);
    void begin(int unit);
    void conclude();
    bool has(const RegisterRange& range) const;
    std::optional<ProfileFit> judged(const ModbusProfile& profile) const;

    ModbusLink& m_link;
    int m_first, m_unit, m_last;
    std::deque<RegisterRange> m_ranges; ///< still to be asked for
    std::size_t m_all = 1;              ///< number of them in the beginning
    std::optional<int> m_asked;
    bool m_isThere = false, m_isOver = false;
    std::map<RangeKey, bool> m_has; ///< ranges that were asked for, and whether the unit has them
    RegisterImage m_image;
    std::vector<FoundUnit> m_found;
};

} // namespace bask
