#pragma once
// Rows of a run, as recorded, shown and exported.

#include "engine/base/message.h"
#include "engine/base/pose.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// One object at one sample. A value that is not known yet or not valid is NaN (NULL in the file).
struct ObjectSample {
    double measured_K = 0.0;
    double estimated_K = 0.0;
    double rate_K_s = 0.0;
    double target_K = 0.0;
    double viewFactor = 0.0;
    double lambda1 = 0.0; ///< the controller's present belief, K/s; NaN if it has none
    double lambda2 = 0.0; ///< 1/(K3 s)
    double true_K = 0.0;  ///< the simulated plant's own temperature; NaN on a real rig
    bool valid = false;   ///< measured_K is a fresh, plausible reading
};

/// One sample of a run.
struct TraceSample {
    double time_s = 0.0;                     ///< since Start
    std::vector<ObjectSample> objects;       ///< in the experiment's order
    Vector6d coordinates = Vector6d::Zero(); ///< end-effector in R, m and rad
    Vector6d twist = Vector6d::Zero();       ///< commanded, R axes, m/s and rad/s
    double source_K = 0.0;                   ///< measured
    Vector6d source = Vector6d::Zero();      ///< coordinates of X_RS as the controllers take them, m and rad
    double smallestSingularValue = 0.0;      ///< of the interaction matrix, rotation scaled
    bool limited = false;                    ///< a limit was active in the command
};

/// Something that happened.
struct TraceEvent {
    double time_s = 0.0;
    Message message;
};

struct TraceNote {
    double time_s = 0.0;
    std::string text;
};

/// Temperature band about the target that counts as settled, K (MODEL section 8).
inline constexpr double kSettledBand_K = 0.5;

/// Time from which object `i` stays within +-band of its target until the end, judged on the plant's true
/// temperature where there is one, else on the estimate. Empty when it is outside at the end.
std::optional<double> settlingTime_s(const std::vector<TraceSample>& samples, std::size_t i,
                                     double band_K = kSettledBand_K);

} // namespace bask
