#pragma once
// Heat rates of every object of a recorded run.

#include "engine/session/session_file.h"
#include "engine/thermal/identification.h"

#include <vector>

namespace bask {

/// Which terms are fitted besides lambda1 and lambda2.
struct SessionIdentification {
    bool freeAmbient = false; ///< lambda3, otherwise tied to lambda2 by the room's temperature
    bool convection = false;
};

/// Rates in the experiment's order, lambda1 at the source's set temperature. Takes the samples until Stop,
/// since the heat is off afterwards whatever the source's temperature; the room's temperature is that of the
/// sensors' zeroing, where it was recorded.
std::vector<IdentifiedRates> identifySession(const SessionRecord& session,
                                             const SessionIdentification& options = {});

} // namespace bask
