// Any bytes as a DXF: refused in words or read, never a crash, a hang or a point that is no number.
#include "engine/shape/dxf_outlines.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const auto file = bask::dxfOutlines(bytes, "fuzz", 1e-4);
    if (!file)
        return 0;
    for (const bask::FileOutline& outline : file->outlines)
        for (const Eigen::Vector2d& p : outline.points_m)
            if (!p.allFinite())
                std::abort();
    return 0;
}
