#pragma once
// How fast a simulated run went by the clock.

#include "engine/recording/session_file.h"

#include <optional>
#include <string>

namespace bask {

/// The times of a simulation that was faster than real time.
struct SimulationPace {
    double run_s = 0.0;   ///< from Start to the last sample, of the simulated rig
    double clock_s = 0.0; ///< from Arm until the recording was closed, by the computer's clock
};

/// Returns them where the first is clearly the longer, `last_s` being the time of the last sample; empty
/// else, and of a recording that was not closed. Since what passed before Start is in the clock's, the
/// simulation went at least run_s / clock_s times as fast as a rig. The clock's times are recorded in whole
/// seconds.
std::optional<SimulationPace> simulationPace(const SessionRecord& facts, double last_s);

/// Returns it in English, for files: "516.7 s of the simulated rig in 57 s by the clock".
std::string paceText(const SimulationPace& pace);

} // namespace bask
