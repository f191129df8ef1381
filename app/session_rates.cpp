#include "app/session_rates.h"

#include "engine/base/message_code.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/material_library.h"
#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace bask {

Result<SessionRates> sessionRates(const SessionRecord& facts, const HeatRecords& records) {
    try {
        return SessionRates{records.identify(),
                            nominalRates(facts.experiment, facts.experiment.environment_K),
                            records.identify({.freeAmbient = false, .convection = true})};
    } catch (const std::exception& exception) {
        return Error(MessageCode::ReasonInternalFault, facts.path, {exception.what()});
    }
}

Estimate convection_W_m2K(const IdentifiedRates& withAir, const Experiment& experiment, std::size_t object) {
    if (!withAir.usable())
        return {};
    const double capacity_J_m2K = experiment.objects[object].material.absorptance *
                                  surroundingsOf(experiment).netSourcePower_W_m2 / withAir.lambda1.value;
    const Estimate& rate = withAir.convection;
    return {rate.value * capacity_J_m2K,
            capacity_J_m2K * std::hypot(rate.standardError,
                                        rate.value * withAir.lambda1.standardError / withAir.lambda1.value)};
}

StartValues withStartValues(const Experiment& experiment, const Experiment& recorded,
                            const SessionRates& rates) {
    StartValues out{experiment, {}};
    const SourceSpec& source = recorded.source;
    const bool sameHeat =
        source.temperature_K == experiment.source.temperature_K &&
        source.emittance == experiment.source.emittance && source.model == experiment.source.model &&
        recorded.environment_K == experiment.environment_K && recorded.air == experiment.air;
    for (std::size_t i = 0; i < rates.identified.size() && sameHeat; ++i) {
        const ObjectSpec& from = recorded.objects[i];
        const auto to = std::ranges::find(out.experiment.objects, from.name, &ObjectSpec::name);
        if (to == out.experiment.objects.end() || !haveSameValues(to->material, from.material) ||
            !rates.identified[i].usable())
            continue;
        to->estimatedRates = rates.identified[i].rates().withoutAir(); // that is the experiment's
        out.objects.push_back(to->name);
    }
    return out;
}

} // namespace bask
