#pragma once
// Heat rates of a recorded run as the Review page shows them, and as start values of the open experiment.

#include "engine/model/experiment.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_identification.h"

#include <string>
#include <vector>

namespace bask {

/// In the session's order; lambda1 at its source's set temperature.
struct SessionRates {
    std::vector<IdentifiedRates> identified;
    std::vector<HeatRates> material;
};

/// Takes some 0.1 s, of a long run some seconds: run it as a job. A record that cannot be judged is an Error.
Result<SessionRates> sessionRates(const SessionRecord& facts, const HeatRecords& records);

struct StartValues {
    Experiment experiment;
    std::vector<std::string> objects; ///< that got them
};

/// The experiment with the usable rates as believed ones, in the objects that have the name and the material
/// of those recorded under the same source and environment.
StartValues withStartValues(const Experiment& experiment, const Experiment& recorded,
                            const SessionRates& rates);

} // namespace bask
