#pragma once
// Counts the pictures of a camera that could not be used.

#include "engine/base/result.h"

#include <cstdint>
#include <optional>

namespace bask {

/// Pictures that were left out, since others followed: damaged ones, those of a closed shutter.
struct LeftOutPictures {
    std::uint64_t count = 0;
    std::optional<Error> last; ///< why the last one could not be used, and which it was
};

} // namespace bask
