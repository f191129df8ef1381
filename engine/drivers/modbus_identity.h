#pragma once
// Whether a Modbus unit is the expected one, from the registers that its profile names for this.

#include "engine/base/message_code.h"
#include "engine/devices/device.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/profile_registers.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/register_values.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace bask {

class ModbusIdentity {
public:
    explicit ModbusIdentity(const ModbusProfile& profile)
        : m_spec(profile.identity), m_type(profile.deviceType), m_types(profile.deviceTypes) {}

    void expect(const std::string& signature) { m_expected = signature; }
    /// Takes the registers as read. The first unit found is the expected one, unless another one was given.
    void take(const RegisterImage& image) {
        if (m_type)
            m_told = quantityFromRegisters(*m_type, image.registers(rangeOf(*m_type)));
        if (!m_spec || isOtherKind())
            return;
        m_signature = signatureFromRegisters(image.registers(rangeOf(*m_spec)));
        if (!m_expected)
            m_expected = m_signature;
    }
    /// Call when the unit is lost: what returns may be a different one.
    void forget() {
        m_signature.reset();
        m_told.reset();
    }
    bool isKnown() const {
        return (!m_type || (m_told && !isOtherKind())) &&
               (!m_spec || (m_signature && m_signature == m_expected));
    }
    bool isOther() const { return isOtherKind() || (m_spec && m_signature && m_signature != m_expected); }
    /// Returns why it is another one.
    Message problem(const std::string& port) const {
        if (isOtherKind())
            return {MessageCode::DeviceAnswersWrong,
                    {port, "it is not a device of this profile: the register of its type holds " +
                               formatNumber(*m_told, 6)}};
        return {MessageCode::DeviceExchanged, {port, m_expected.value_or(""), m_signature.value_or("")}};
    }
    /// Returns a status with what is known here.
    DeviceStatus told(DeviceStatus status, const std::string& port) const {
        status.signature = m_spec ? m_signature : std::optional<std::string>("");
        if (isOther()) {
            status.link = LinkState::Opening;
            status.problem = problem(port);
        }
        return status;
    }

private:
    bool isOtherKind() const { return m_told && std::ranges::find(m_types, *m_told) == m_types.end(); }

    std::optional<IdentitySpec> m_spec;
    std::optional<RegisterSpec> m_type;
    std::vector<double> m_types;
    std::optional<double> m_told; ///< what the register of its type holds
    std::optional<std::string> m_expected, m_signature;
};

} // namespace bask
