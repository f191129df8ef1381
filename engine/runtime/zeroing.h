#pragma once
// What zeroing the sensors has found.

#include <string>
#include <vector>

namespace bask {

/// While all objects were at the room's temperature.
struct Zeroing {
    double utc_s = 0.0;            ///< since 1970
    double environment_K = 0.0;    ///< T3: the mean of all sensors
    std::vector<double> offsets_K; ///< added to what each sensor reads
    bool operator==(const Zeroing&) const = default;
};

/// As a session's commands have it.
std::string zeroingJson(const Zeroing& zeroing);

} // namespace bask
