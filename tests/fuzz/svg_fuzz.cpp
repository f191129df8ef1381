// Fuzz target: any bytes as an SVG drawing. They may be refused, but never crash, hang or fill the memory.

#include "engine/shape/svg_outlines.h"

#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    (void)bask::svgOutlines(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
    return 0;
}
