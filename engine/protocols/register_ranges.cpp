#include "engine/protocols/register_ranges.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace bask {

std::vector<RegisterRange> joinedRanges(std::vector<RegisterRange> ranges) {
    std::sort(ranges.begin(), ranges.end(), [](const RegisterRange& a, const RegisterRange& b) {
        return std::tie(a.function, a.address) < std::tie(b.function, b.address);
    });
    std::vector<RegisterRange> out;
    for (const RegisterRange& next : ranges) {
        RegisterRange* last = out.empty() ? nullptr : &out.back();
        const int end = next.address + next.count;
        const bool meets = last != nullptr && last->function == next.function &&
                           next.address <= last->address + last->count &&
                           end - last->address <= kMaxRegisters;
        if (meets)
            last->count = std::max(last->count, end - last->address);
        else
            out.push_back(next);
    }
    return out;
}

void RegisterImage::store(const RegisterRange& range, const std::vector<std::uint16_t>& values) {
    if (static_cast<int>(values.size()) != range.count)
        throw std::invalid_argument("RegisterImage: as many values as registers");
    for (int i = 0; i < range.count; ++i)
        m_registers[{range.function, range.address + i}] = values[static_cast<std::size_t>(i)];
}

std::vector<std::uint16_t> RegisterImage::registers(const RegisterRange& range) const {
    std::vector<std::uint16_t> out;
    for (int i = 0; i < range.count; ++i)
        out.push_back(m_registers.at({range.function, range.address + i}));
    return out;
}

} // namespace bask
