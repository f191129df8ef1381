#pragma once
// Rows of a run, as recorded, shown and exported.

#include "engine/base/message.h"
#include "engine/model/trace_sample.h"
#include "engine/thermography/thermal_picture.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// An event of a run.
struct TraceEvent {
    double time_s = 0.0;
    Message message;
};

/// A recorded picture of the thermal camera.
struct TraceFrame {
    double time_s = 0.0;
    std::shared_ptr<const ThermalPicture> picture;
};

struct TraceNote {
    double time_s = 0.0;
    std::string text;
    std::string operatorName{}; ///< who wrote it; empty if not known
};

/// Temperature band about the target that counts as settled, K (MODEL section 8).
inline constexpr double kSettledBand_K = 0.5;

/// A run is settled (EventSettled) after all objects were within the band for this time by their estimates,
/// and once the robot stands or goes to where it will.
inline constexpr double kRunSettledAfter_s = 30.0;

/// Returns the time from which object `i` stays within +-band of its target until the end, judged on the
/// plant's true temperature if it is known, else on the estimate. Empty if it is outside at the end.
std::optional<double> settlingTime_s(const std::vector<TraceSample>& samples, std::size_t i,
                                     double band_K = kSettledBand_K);

} // namespace bask
