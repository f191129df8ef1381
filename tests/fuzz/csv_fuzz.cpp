// Any bytes as a CSV: refused in words or a contour with a finite area, never a crash or a hang.
#include "engine/shape/contour_import.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    const auto file = bask::csvOutlines(bytes, "fuzz", bask::LengthUnit::Millimetre);
    if (!file)
        return 0;
    const auto contour = bask::contourOf(file->outlines.front());
    if (contour && !(bask::contourArea(*contour) > 0.0 && std::isfinite(bask::contourArea(*contour))))
        std::abort();
    return 0;
}
