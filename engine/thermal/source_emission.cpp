#include "engine/thermal/source_emission.h"

#include "engine/base/units.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kLeastExcess_K = 1e-3; // nearer to the room's temperature, weights are those at this

double awayFromRoom_K(double source_K, double environment_K) {
    const double excess_K = source_K - environment_K;
    return std::abs(excess_K) < kLeastExcess_K ? environment_K + kLeastExcess_K : source_K;
}

} // namespace

double PartTemperature::at_K(double source_K, double environment_K) const {
    const double excess_K = source_K - environment_K;
    const double most_K = kMaxPartRatio * excess_K;
    const double wanted_K =
        std::clamp(ratio * excess_K + offset_K, std::min(0.0, most_K), std::max(0.0, most_K));
    // So that a part like the source has the very same temperature.
    return source_K + (wanted_K - excess_K);
}

// In the paper's model the net power of a part in the room is not zero, and that of the source passes zero
// above the room's temperature: weights are bounded there by what those of a gray source can be.
double SourceEmission::weight(double ofPart, double part_K, double source_K) const {
    const auto power = [this](SourceModel by, double eps, double T_K) {
        return netSourcePower_W_m2(by, T_K, eps, environment_K);
    };
    const double own = power(model, emittance, source_K);
    if (model == SourceModel::Gray || !(own > 0.0))
        return power(SourceModel::Gray, ofPart, part_K) / power(SourceModel::Gray, emittance, source_K);
    return std::clamp(power(model, ofPart, part_K) / own, 0.0, maxPaperWeight(ofPart));
}

double SourceEmission::maxPaperWeight(double ofPart) const {
    return std::pow(kMaxPartRatio, 4) * std::max(1.0, ofPart / emittance);
}

double SourceEmission::slope_1_K(double ofPart, double part_K, double source_K) const {
    const double own = netSourcePower_W_m2(model, source_K, emittance, environment_K);
    const bool isPaper = model == SourceModel::Paper && own > 0.0;
    if (isPaper)
        if (const double w = weight(ofPart, part_K, source_K); w <= 0.0 || w >= maxPaperWeight(ofPart))
            return 0.0;
    return 4.0 * kStefanBoltzmann * ofPart * part_K * part_K * part_K /
           (isPaper ? own : netSourcePower_W_m2(SourceModel::Gray, source_K, emittance, environment_K));
}

std::vector<double> SourceEmission::factors(double ofSource_K) const {
    const double source_K = awayFromRoom_K(ofSource_K, environment_K);
    const double excess_K = source_K - environment_K;
    std::vector<double> out;
    for (const EmissionTerm& term : terms) {
        const double part_K = term.temperature.at_K(source_K, environment_K);
        if (!term.rise) {
            out.push_back(weight(term.emittance, part_K, source_K));
            continue;
        }
        const double asked_K = environment_K + term.temperature.ratio * excess_K + term.temperature.offset_K;
        const bool isBounded = std::abs(asked_K - part_K) > 1e-9;
        const double rise_K = term.rise->ratio * excess_K + term.rise->offset_K;
        out.push_back(isBounded ? 0.0 : -rise_K * slope_1_K(term.emittance, part_K, source_K));
    }
    return out;
}

std::vector<double> SourceEmission::weights(double ofSource_K) const {
    const double source_K = awayFromRoom_K(ofSource_K, environment_K);
    std::vector<double> out;
    for (const PartTemperature& point : profile)
        out.push_back(weight(emittance, point.at_K(source_K, environment_K), source_K));
    if (profile.empty())
        for (const EmissionTerm& part : terms)
            out.push_back(weight(part.emittance, part.temperature.at_K(source_K, environment_K), source_K));
    return out;
}

double SourceEmission::maxWeight(double source_K) const {
    double max = 1.0;
    for (const double weight : weights(source_K))
        max = std::max(max, weight);
    return max;
}

} // namespace bask
