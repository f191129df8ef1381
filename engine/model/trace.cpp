#include "engine/model/trace.h"

#include <cmath>

namespace bask {

std::optional<double> settlingTime_s(const std::vector<TraceSample>& samples, std::size_t i, double band_K) {
    std::optional<double> since_s;
    for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample) {
        if (i >= sample->objects.size())
            break;
        const ObjectSample& object = sample->objects[i];
        if (!(std::abs(judgedTemperature_K(object) - object.target_K) <= band_K))
            break;
        since_s = sample->time_s;
    }
    return since_s;
}

} // namespace bask
