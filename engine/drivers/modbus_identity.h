#pragma once
// Whether a Modbus unit is the expected one, from the registers that its profile names for this.

#include "engine/base/message_code.h"
#include "engine/devices/device.h"
#include "engine/protocols/modbus_profile.h"
#include "engine/protocols/register_ranges.h"
#include "engine/protocols/register_values.h"

#include <optional>
#include <string>

namespace bask {

class ModbusIdentity {
public:
    explicit ModbusIdentity(const std::optional<IdentitySpec>& spec) : m_spec(spec) {}

    void expect(const std::string& signature) { m_expected = signature; }
    /// Returns the registers to read with each poll; empty if it has none.
    std::optional<RegisterRange> range() const {
        return m_spec ? std::optional(RegisterRange{m_spec->function, m_spec->address, m_spec->count})
                      : std::nullopt;
    }
    /// Takes the registers as read. The first unit found is the expected one, unless another one was given.
    void take(const RegisterImage& image) {
        if (!m_spec)
            return;
        m_signature = signatureFromRegisters(image.registers(*range()));
        if (!m_expected)
            m_expected = m_signature;
    }
    /// Call when the unit is lost: what returns may be a different one.
    void forget() { m_signature.reset(); }
    bool isKnown() const { return !m_spec || (m_signature && m_signature == m_expected); }
    bool isOther() const { return m_spec && m_signature && m_signature != m_expected; }
    Message exchanged(const std::string& port) const {
        return {MessageCode::DeviceExchanged, {port, m_expected.value_or(""), m_signature.value_or("")}};
    }
    /// Returns a status with what is known here.
    DeviceStatus told(DeviceStatus status, const std::string& port) const {
        status.signature = m_spec ? m_signature : std::optional<std::string>("");
        if (isOther()) {
            status.link = LinkState::Opening;
            status.problem = exchanged(port);
        }
        return status;
    }

private:
    std::optional<IdentitySpec> m_spec;
    std::optional<std::string> m_expected, m_signature;
};

} // namespace bask
