// Any bytes as a frame of a thermal camera or as its profile: refused in words or read, never a crash, a
// hang, or a pixel that is a number outside of what the camera can tell. The first byte says as what.
#include "engine/thermography/frame_decoder.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

const bask::ThermalProfile& smallCamera() {
    static const bask::ThermalProfile kProfile = [] {
        bask::ThermalProfile profile;
        profile.name = "small";
        profile.width = profile.height = 8;
        profile.skipTop = profile.optionalBottom = 1;
        profile.scale = 0.01;
        profile.min_K = 200.0;
        profile.max_K = 600.0;
        return profile;
    }();
    return kProfile;
}

/// A camera that sends a picture for people above the temperatures.
const bask::ThermalProfile& yuyvCamera() {
    static const bask::ThermalProfile kProfile = [] {
        bask::ThermalProfile profile = smallCamera();
        profile.skipTop = 8;
        profile.optionalBottom = 0;
        profile.pixelFormat = "YUYV";
        profile.scale = 1.0 / 64.0;
        return profile;
    }();
    return kProfile;
}

bask::Result<bask::ThermalFrame> frameAs(std::uint8_t kind, const std::string& bytes) {
    if (kind >= 0xC0)
        return bask::frameOfBytes(bytes, yuyvCamera(), "fuzz");
    if (kind >= 0x80)
        return bask::frameOfImage(bytes, smallCamera(), "fuzz", kind & 0x3U);
    switch (kind % 4) {
    case 0:
        return bask::frameOfBytes(bytes, smallCamera(), "fuzz");
    case 1:
        return bask::frameOfImage(bytes, smallCamera(), "fuzz");
    case 2:
        return bask::frameOfCsv(bytes, smallCamera(), "fuzz");
    default:
        return bask::frameOfCsv(bytes, std::nullopt, "fuzz");
    }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    if (data[0] == '{') { // a profile begins like this anyway
        (void)bask::thermalProfileFromJson('{' + bytes, "fuzz");
        return 0;
    }
    const auto frame = frameAs(data[0], bytes);
    if (!frame)
        return 0;
    const bask::ThermalPicture& picture = frame->picture;
    if (picture.T_K.size() !=
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
        std::abort();
    for (const double T_K : picture.T_K)
        if (std::isnan(T_K) || (std::isfinite(T_K) && !(T_K > 0.0 && T_K <= 3000.0)))
            std::abort();
    return 0;
}
