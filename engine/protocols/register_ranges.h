#pragma once
// Which registers are read together, and the values read.

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace bask {

/// `count` registers from `address`, read by function 3 or 4.
struct RegisterRange {
    int function = 3;
    int address = 0;
    int count = 1;
    bool contains(const RegisterRange& other) const {
        return function == other.function && address <= other.address &&
               other.address + other.count <= address + count;
    }
    bool operator==(const RegisterRange&) const = default;
};

/// Maximum number of registers that one request may read.
inline constexpr int kMaxRegisters = 125;

/// Joins ranges into as few requests as possible without reading a register that is in none of them, because
/// the device may have none there. Sorted by function and address.
std::vector<RegisterRange> joinedRanges(std::vector<RegisterRange> ranges);

/// The last values read from the registers of a device.
class RegisterImage {
public:
    /// Throws std::invalid_argument unless there are range.count values.
    void store(const RegisterRange& range, const std::vector<std::uint16_t>& values);
    /// Throws std::out_of_range for a register that has not been read.
    std::vector<std::uint16_t> registers(const RegisterRange& range) const;
    void clear() { m_registers.clear(); }

private:
    std::map<std::pair<int, int>, std::uint16_t> m_registers; ///< by function and address
};

} // namespace bask
