#pragma once
// Heat rates of a recorded run as the Review page shows them, and as start values of the open experiment.

#include "engine/model/experiment.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_identification.h"

#include <string>
#include <vector>

namespace bask {

/// Rates in the session's order of objects; lambda1 at the set temperature of its source.
struct SessionRates {
    std::vector<IdentifiedRates> identified;
    std::vector<HeatRates> material;
    std::vector<IdentifiedRates> withAir; ///< with an h' fitted, whatever the experiment states of the air
};

/// Returns h, W/(m2 K), of rates that were fitted with the air, for an object whose absorptance is known: m c
/// / A follows from lambda1. NaN, with the reason in the rates, where the record does not tell h.
Estimate convection_W_m2K(const IdentifiedRates& withAir, const Experiment& experiment, std::size_t object);

/// Takes about 0.3 s, for a long run some seconds: run it as a job. Error: the record cannot be evaluated.
Result<SessionRates> sessionRates(const SessionRecord& facts, const HeatRecords& records);

struct StartValues {
    Experiment experiment;
    std::vector<std::string> objects; ///< objects that received start values
};

/// Returns the experiment with the usable rates as estimated ones, for the objects with the same name and
/// material as those recorded under the same source and environment.
StartValues withStartValues(const Experiment& experiment, const Experiment& recorded,
                            const SessionRates& rates);

} // namespace bask
