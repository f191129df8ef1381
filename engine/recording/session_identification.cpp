#include "engine/recording/session_identification.h"

#include "engine/model/experiment_rig.h"
#include "engine/recording/recorded_session.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

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
    : m_until_s(controlledUntil_s(facts)), m_source(facts.experiment.source),
      m_geometry(rigGeometry(facts.experiment)) {
    setEnvironment(m_options, facts);
    m_options.isAirKnown = facts.experiment.air.isKnown();
    const Surroundings surroundings = surroundingsOf(facts.experiment, m_options.environment_K);
    for (const ObjectSpec& object : facts.experiment.objects) {
        const HeatRates rates = heatRates(object, surroundings);
        m_environmentShares.push_back(environmentShare(m_source.model, object.material));
        m_airPerLambda2.push_back(rates.air.scaled(1.0 / rates.lambda2));
    }
    m_records.resize(m_environmentShares.size());
    m_since_s.assign(m_records.size(), 0.0);
}

double HeatRecords::power_W_m2(double T1_K) const {
    return netSourcePower_W_m2(m_source.model, T1_K, m_source.emittance, m_options.environment_K);
}

void HeatRecords::add(const TraceSample& sample) {
    if (m_records.empty() || sample.time_s > m_until_s || (m_before && !(sample.time_s > m_before->time_s)))
        return;
    if (m_before)
        integrate(*m_before, sample);
    m_before = sample;
    if (m_seen++ % m_every != 0)
        return;
    if (size() >= kMax)
        thin();
    const double strength = power_W_m2(sample.source_K) / power_W_m2(m_source.temperature_K);
    const Eigen::VectorXd neighbours_K4 = neighbourGains_K4(sample);
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const ObjectSample& row = sample.objects[i];
        std::vector<HeatSample>& record = m_records[i];
        HeatSample added{sample.time_s, row.measured_K, row.viewFactor, strength, row.valid};
        added.neighbours_K4 = neighbours_K4[static_cast<Eigen::Index>(i)];
        if (!record.empty())
            added.meanViewFactor = m_since_s[i] / (sample.time_s - record.back().time_s);
        record.push_back(added);
        m_since_s[i] = 0.0;
    }
}

/// A neighbour whose temperature is not known counts as one that rests in the room.
Eigen::VectorXd HeatRecords::neighbourGains_K4(const TraceSample& sample) const {
    Eigen::VectorXd excess_K4(static_cast<Eigen::Index>(m_records.size()));
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        const double rest_K4 = m_environmentShares[i] * std::pow(m_options.environment_K, 4);
        const double T_K = sample.objects[i].estimated_K;
        excess_K4[static_cast<Eigen::Index>(i)] = std::isfinite(T_K) ? std::pow(T_K, 4) - rest_K4 : 0.0;
    }
    return m_geometry->neighbours().gains_K4(excess_K4);
}

void HeatRecords::integrate(const TraceSample& before, const TraceSample& sample) {
    constexpr double kMoved = 1e-4; // of the view factor; below, a straight line will do
    const double dt_s = sample.time_s - before.time_s;
    const auto objects = static_cast<std::size_t>(m_geometry->objects());
    bool isMoved = false;
    for (std::size_t i = 0; i < objects; ++i)
        isMoved = isMoved || std::abs(sample.objects[i].viewFactor - before.objects[i].viewFactor) > kMoved;
    // An angle that goes on at its other end, or a pose that is not known, has no middle.
    const Vector6d moved = sample.coordinates - before.coordinates,
                   sourceMoved = sample.source - before.source;
    constexpr double kTurn_rad = 1.0;
    const bool hasMiddle = moved.tail<3>().cwiseAbs().maxCoeff() < kTurn_rad &&
                           sourceMoved.tail<3>().cwiseAbs().maxCoeff() < kTurn_rad && moved.allFinite() &&
                           sourceMoved.allFinite();
    Eigen::VectorXd middle;
    if (isMoved && hasMiddle) {
        auto geometry = m_geometry->withSourceAt(poseFromCoordinates(before.source + 0.5 * sourceMoved));
        const double source_K = 0.5 * (before.source_K + sample.source_K);
        if (!geometry->isSourceEven() && std::isfinite(source_K))
            geometry = geometry->withSourceTemperature(source_K);
        middle = geometry->viewFactorsFast(before.coordinates + 0.5 * moved);
    }
    for (std::size_t i = 0; i < objects; ++i) {
        const double ends = before.objects[i].viewFactor + sample.objects[i].viewFactor;
        m_since_s[i] += dt_s * (middle.size() > 0 ? (ends + 4.0 * middle[static_cast<Eigen::Index>(i)]) / 6.0
                                                  : 0.5 * ends);
    }
}

/// The first, third, fifth ... stay, so that what comes next goes on in their rhythm.
void HeatRecords::thin() {
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        std::vector<HeatSample>& record = m_records[i];
        if (record.size() % 2 == 0) // the last one goes
            m_since_s[i] +=
                record.back().meanViewFactor * (record.back().time_s - record[record.size() - 2].time_s);
        for (std::size_t k = 1; 2 * k < record.size(); ++k) {
            HeatSample& kept = record[2 * k];
            const HeatSample& gone = record[2 * k - 1];
            const double first_s = gone.time_s - record[2 * k - 2].time_s,
                         second_s = kept.time_s - gone.time_s;
            kept.meanViewFactor =
                (first_s * gone.meanViewFactor + second_s * kept.meanViewFactor) / (first_s + second_s);
        }
        for (std::size_t k = 0; 2 * k < record.size(); ++k)
            record[k] = record[2 * k];
        record.resize((record.size() + 1) / 2);
    }
    m_every *= 2;
}

std::vector<IdentifiedRates> HeatRecords::identify(const SessionIdentification& wanted,
                                                   const ShareDone& done) const {
    IdentificationOptions options = m_options;
    options.freeAmbient = wanted.freeAmbient;
    options.convection = wanted.convection;
    std::vector<IdentifiedRates> out;
    ShareCount count(done, static_cast<double>(m_records.size()));
    for (std::size_t i = 0; i < m_records.size(); ++i) {
        options.environmentShare = m_environmentShares[i];
        options.airPerLambda2 = m_airPerLambda2[i];
        out.push_back(identifyRates(m_records[i], options));
        count.add();
    }
    return out;
}

} // namespace bask
