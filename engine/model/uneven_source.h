#pragma once
// What radiates of an uneven source: its parts, or the rings of a radial profile.

#include "engine/model/checker.h"
#include "engine/model/experiment.h"
#include "engine/radiation/radiating_source.h"
#include "engine/thermal/source_emission.h"

#include <string>
#include <vector>

namespace bask {

inline constexpr std::size_t kMaxSourceParts = 64;
inline constexpr std::size_t kMaxProfilePoints = 200;
inline constexpr std::size_t kMaxRings = 256;

/// Outlines in S and their emission, one for each. Empty for an even source.
struct UnevenSource {
    std::vector<SourceTerm> terms;
    SourceEmission emission;
    /// What rings leave of the profile: the largest error of the view factor of a small face parallel to the
    /// source that is as near as the clearance allows, at the source's set temperature. 0 for parts.
    double ringError = 0.0;
};

/// Returns what radiates of the source, if `uneven` is how. Parts have their own emittance, else `emittance`.
/// A profile becomes rings: on the pieces between its points the weight's fall is integrated by Gauss's rule,
/// each node a disk, so that the error falls exponentially with their number while no temperature is bounded.
/// There are as many as bring it to about 1e-6 at the clearance, for which pieces are cut into kMaxRings at
/// most; a profile of many points has one or two on each piece. The experiment must validate.
UnevenSource unevenSource(const Experiment& experiment, const Unevenness& uneven, double emittance);

/// Returns how the parts or the points of a profile emit, as above: for weights, at a fraction of the cost.
SourceEmission emissionWithoutRings(const Experiment& experiment, const Unevenness& uneven, double emittance);
/// The same of the source as the experiment assumes it.
SourceEmission emissionWithoutRings(const Experiment& experiment);

/// Returns "7 parts that radiate 0.91 to 1.08 of what an even source does" or the like, for an uneven source
/// as the experiment assumes it, at its set temperature; of a profile also the rings and their error.
std::string unevennessWords(const Experiment& experiment);

/// Returns the source as the experiment assumes it, in its parts and at its set temperature.
RadiatingSource radiatingSource(const Experiment& experiment);

/// Checks parts and profile, with places such as "source.parts[1].emittance" for the prefix "source.".
/// Parts must not overlap, must not reach beyond the source's contour, must not stand out of its plane, since
/// clearances are measured from there, and none may lie in front of another, since what they hide from one
/// another is not computed. Temperatures of a profile must be within the bounds of PartTemperature at the set
/// temperature. Source and environment must be valid, and so must `emittance`, that of the source.
void checkUnevenness(Checker& check, const std::string& prefix, const Unevenness& uneven,
                     const Experiment& experiment, double emittance);

} // namespace bask
