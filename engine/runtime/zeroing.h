#pragma once
// The result of zeroing the sensors.

#include <string>
#include <vector>

namespace bask {

/// Measured while all objects were at the room's temperature.
struct Zeroing {
    double utc_s = 0.0;            ///< time of the zeroing, seconds since 1970
    double environment_K = 0.0;    ///< T3: the mean of all sensors
    std::vector<double> offsets_K; ///< added to what each sensor reads
    bool operator==(const Zeroing&) const = default;
};

/// Returns the zeroing as JSON, as the commands of a session contain it.
std::string zeroingJson(const Zeroing& zeroing);

} // namespace bask
