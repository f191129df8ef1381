#include "engine/session/session_identification.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {
namespace {

constexpr double kZeroing_K = 0.03; ///< standard error of zeroing a sensor that shows tenths
constexpr double kSensor_K = 0.2;   ///< of a sensor that was not zeroed, as far as the record tells

/// Sets T3 and how well it is known.
void setEnvironment(IdentificationOptions& options, const SessionRecord& session) {
    options.environment_K = session.experiment.environment_K;
    options.environmentDeviation_K = kSensor_K;
    const auto start = std::ranges::find(session.commands, "start", &CommandRow::name);
    if (start == session.commands.end())
        return;
    const auto value = nlohmann::json::parse(start->value, nullptr, false);
    if (!value.is_object() || !value.contains("environment_K") || !value["environment_K"].is_number())
        return;
    options.environment_K = value["environment_K"].get<double>();
    options.environmentDeviation_K = kZeroing_K;
}

std::vector<HeatSample> recordOf(const std::vector<TraceSample>& samples, std::size_t object,
                                 const SourceSpec& source, double environment_K) {
    const auto power = [&](double T1_K) {
        return netSourcePower_W_m2(source.model, T1_K, source.emittance, environment_K);
    };
    std::vector<HeatSample> record;
    for (const TraceSample& sample : samples) {
        if (!record.empty() && !(sample.time_s > record.back().time_s))
            continue;
        const ObjectSample& row = sample.objects[object];
        record.push_back({sample.time_s, row.measured_K, row.viewFactor,
                          power(sample.source_K) / power(source.temperature_K), row.valid});
    }
    return record;
}

} // namespace

std::vector<IdentifiedRates> identifySession(const SessionRecord& session,
                                             const SessionIdentification& wanted) {
    IdentificationOptions options;
    options.freeAmbient = wanted.freeAmbient;
    options.convection = wanted.convection;
    setEnvironment(options, session);
    const std::vector<TraceSample> samples = session.controlledSamples();
    std::vector<IdentifiedRates> out;
    for (std::size_t i = 0; i < session.experiment.objects.size(); ++i) {
        const Material& material = session.experiment.objects[i].material;
        options.absorptanceOverEmittance = material.absorptance / material.emittance;
        out.push_back(
            identifyRates(recordOf(samples, i, session.experiment.source, options.environment_K), options));
    }
    return out;
}

} // namespace bask
