#pragma once
// Which registers are read together, and what was read.

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

/// Most registers that one request may read.
inline constexpr int kMaxRegisters = 125;

/// As few requests as cover them without reading a register that is in none: the device may have none there.
/// In the order of function and address.
std::vector<RegisterRange> joinedRanges(std::vector<RegisterRange> ranges);

/// The registers of a device as they were read last.
class RegisterImage {
public:
    /// Throws std::invalid_argument unless there are range.count values.
    void store(const RegisterRange& range, const std::vector<std::uint16_t>& values);
    /// Throws std::out_of_range for one that has not been read.
    std::vector<std::uint16_t> registers(const RegisterRange& range) const;
    void clear() { m_registers.clear(); }

private:
    std::map<std::pair<int, int>, std::uint16_t> m_registers; ///< by function and address
};

} // namespace bask
