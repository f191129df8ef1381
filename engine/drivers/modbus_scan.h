#pragma once
// Finds the Modbus units that answer at a port, and which of the shipped profiles fit. It only reads.

#include "engine/drivers/modbus_link.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_ranges.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A profile all of whose registers a unit has, with temperatures that a laboratory can have.
struct ProfileFit {
    std::string profile;
    std::vector<double> temperatures_K; ///< of its channels, or process value and set point; NaN: none
};

struct FoundUnit {
    int unit = 0;
    std::vector<ProfileFit> fits;
};

/// Asks one unit after the other. Each is asked for one register by functions 3 and 4; one that answers, also
/// by an exception, for the registers of each profile. Nothing is ever written.
class ModbusScan {
public:
    /// `link` must be open, and outlive it.
    ModbusScan(ModbusLink& link, int firstUnit, int lastUnit);

    /// Sends what is due and takes what has come; false when all is done, or the link is lost.
    bool work();
    /// Returns the unit that is asked now.
    int unit() const { return m_unit; }
    const std::vector<FoundUnit>& found() const { return m_found; }

private:
    struct Question {
        const ModbusProfile* profile; ///< null: whether it is there
        RegisterRange range;
    };

    bool isLinkThere();
    void ask();
    void take(const ModbusReply& reply);
    void judge(const ModbusProfile& profile);

    ModbusLink& m_link;
    int m_unit, m_last;
    std::deque<Question> m_questions;
    std::optional<int> m_asked;
    bool m_isThere = false, m_isFit = true;
    RegisterImage m_image;
    std::vector<FoundUnit> m_found;
};

} // namespace bask
