#include "engine/runtime/zeroing.h"

#include "engine/base/message.h"

namespace bask {

std::string zeroingJson(const Zeroing& zeroing) {
    std::string offsets;
    for (const double offset_K : zeroing.offsets_K)
        offsets += (offsets.empty() ? "" : ",") + formatNumber(offset_K, 6);
    return R"({"environment_K":)" + formatNumber(zeroing.environment_K, 10) + R"(,"offsets_K":[)" + offsets +
           R"(],"zeroed_utc_s":)" + formatNumber(zeroing.utc_s, 13) + "}";
}

} // namespace bask
