#pragma once
// How strongly the parts of an uneven source radiate, relative to the source itself.

#include "engine/thermal/heat_balance.h"

#include <optional>
#include <vector>

namespace bask {

/// A part is at most this many times as far above the room as the source itself.
inline constexpr double kMaxPartRatio = 2.0;

/// Temperature of a part: T = T3 + ratio (T1 - T3) + offset_K, with the source's own T1 and the room's T3,
/// but never below T3, nor above T3 + kMaxPartRatio (T1 - T3).
struct PartTemperature {
    double ratio = 1.0;
    double offset_K = 0.0;

    double at_K(double source_K, double environment_K) const;
    bool operator==(const PartTemperature&) const = default;
};

/// One summand of an uneven source: what the factor of its view factor comes from.
struct EmissionTerm {
    double emittance = 0.25;
    PartTemperature temperature;
    /// Empty: a part; its factor is its weight. Else the edge of a ring of a radial profile, by which the
    /// temperature's ratio and offset rise outwards: its factor is by how much the weight falls.
    std::optional<PartTemperature> rise{};

    bool operator==(const EmissionTerm&) const = default;
};

/// The weight of a part is w = (J_p - J_env) / (J_ref - J_env) with J_ref of the source at its own
/// temperature and emittance: by the source model, so that a part like the source itself has w = 1. Where the
/// source hardly heats, weights are those of the gray source at the limit.
struct SourceEmission {
    SourceModel model = SourceModel::Gray;
    double emittance = 0.25;
    double environment_K = 298.15;
    std::vector<EmissionTerm> terms{};      ///< empty: the source is even
    std::vector<PartTemperature> profile{}; ///< the points of a radial profile, for maxWeight()

    bool isEven() const { return terms.empty(); }
    /// Returns the factor of each term with the source at T1 = source_K.
    std::vector<double> factors(double source_K) const;
    /// Returns the weights of the parts, or of the points of a profile.
    std::vector<double> weights(double source_K) const;
    /// Returns the largest of them, 1 at least: no view factor of the source is larger.
    double maxWeight(double source_K) const;

    bool operator==(const SourceEmission&) const = default;

private:
    double weight(double emittance, double part_K, double source_K) const;
    double maxPaperWeight(double emittance) const;
    double slope_1_K(double emittance, double part_K, double source_K) const;
};

} // namespace bask
