#include "engine/recording/session_identification.h"

#include "engine/recording/recorded_session.h"

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

} // namespace

HeatRecords::HeatRecords(const SessionRecord& facts)
    : m_until_s(controlledUntil_s(facts)), m_source(facts.experiment.source) {
    setEnvironment(m_options, facts);
    for (const ObjectSpec& object : facts.experiment.objects)
        m_environmentShares.push_back(environmentShare(m_source.model, object.material));
    m_records.resize(m_environmentShares.size());
}

double HeatRecords::power_W_m2(double T1_K) const {
    return netSourcePower_W_m2(m_source.model, T1_K, m_source.emittance, m_options.environment_K);
}

void HeatRecords::add(const TraceSample& sample) {
    if (m_records.empty() || sample.time_s > m_until_s ||
        (!m_records.front().empty() && !(sample.time_s > m_records.front().back().time_s)))
        return;
    if (m_seen++ % m_every != 0)
        return;
    if (size() >= kMax)
        thin();
    const double strength = power_W_m2(sample.source_K) / power_W_m2(m_source.temperature_K);
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const ObjectSample& row = sample.objects[i];
        m_records[i].push_back({sample.time_s, row.measured_K, row.viewFactor, strength, row.valid});
    }
}

/// The first, third, fifth ... stay, so that what comes next goes on in their rhythm.
void HeatRecords::thin() {
    for (std::vector<HeatSample>& record : m_records) {
        for (std::size_t k = 0; 2 * k < record.size(); ++k)
            record[k] = record[2 * k];
        record.resize((record.size() + 1) / 2);
    }
    m_every *= 2;
}

std::vector<IdentifiedRates> HeatRecords::identify(const SessionIdentification& wanted) const {
    IdentificationOptions options = m_options;
    options.freeAmbient = wanted.freeAmbient;
    options.convection = wanted.convection;
    std::vector<IdentifiedRates> out;
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        options.environmentShare = m_environmentShares[i];
        out.push_back(identifyRates(m_records[i], options));
    }
    return out;
}

} // namespace bask
