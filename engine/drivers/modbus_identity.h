#pragma once
// Whether a Modbus unit is the one that is meant, by the registers that its profile names for that.

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
    /// To be read with each poll; empty: it has none.
    std::optional<RegisterRange> range() const {
        return m_spec ? std::optional(RegisterRange{m_spec->function, m_spec->address, m_spec->count})
                      : std::nullopt;
    }
    /// As read; the first one is the one that is meant, unless another was named.
    void take(const RegisterImage& image) {
        if (!m_spec)
            return;
        m_signature = signatureFromRegisters(image.registers(*range()));
        if (!m_expected)
            m_expected = m_signature;
    }
    /// It is away: what comes back may be another one.
    void forget() { m_signature.reset(); }
    bool isKnown() const { return !m_spec || (m_signature && m_signature == m_expected); }
    bool isOther() const { return m_spec && m_signature && m_signature != m_expected; }
    Message exchanged(const std::string& port) const {
        return {MessageCode::DeviceExchanged, {port, m_expected.value_or(""), m_signature.value_or("")}};
    }
    /// A status, with what is known here.
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
