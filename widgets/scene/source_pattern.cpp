#include "widgets/scene/source_pattern.h"

#include "engine/model/uneven_source.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kPartPoints = 120; // of a curved outline

using Outline = std::vector<Eigen::Vector2d>;

std::vector<Outline> projectedRings(const SourcePartSpec& part, int points) {
    const Pose X_SP = poseFromCoordinates(part.pose);
    std::vector<Outline> rings = shapeRings(part.shape, points);
    for (Outline& ring : rings)
        for (Eigen::Vector2d& p : ring)
            p = (X_SP * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
    return rings;
}

/// The weight at a radius: linear temperatures between the points of the profile.
double weightAt(const Experiment& experiment, double radius_m) {
    const SourceSpec& source = experiment.source;
    const std::vector<ProfilePoint>& profile = source.uneven.profile;
    const auto next = std::ranges::lower_bound(profile, radius_m, {}, &ProfilePoint::radius_m);
    ProfilePoint at = next == profile.end() ? profile.back() : *next;
    if (next != profile.end() && next != profile.begin()) {
        const ProfilePoint& before = *(next - 1);
        const double share = (radius_m - before.radius_m) / (next->radius_m - before.radius_m);
        at.temperatureRatio = std::lerp(before.temperatureRatio, next->temperatureRatio, share);
        at.temperatureOffset_K = std::lerp(before.temperatureOffset_K, next->temperatureOffset_K, share);
    }
    const SourceEmission one{source.model,
                             source.emittance,
                             experiment.environment_K,
                             {{source.emittance, {at.temperatureRatio, at.temperatureOffset_K}}},
                             {}};
    return one.factors(source.temperature_K).front();
}

} // namespace

std::vector<Outline> partRings(const Unevenness& uneven, int points) {
    std::vector<Outline> all;
    for (const SourcePartSpec& part : uneven.parts)
        for (Outline& ring : projectedRings(part, points))
            all.push_back(std::move(ring));
    return all;
}

std::vector<double> sourcePattern(const Experiment& experiment, const Eigen::AlignedBox2d& box, int n) {
    const SourceSpec& source = experiment.source;
    const std::vector<double> weights = emissionWithoutRings(experiment).weights(source.temperature_K);
    std::vector<std::vector<Outline>> parts;
    for (const SourcePartSpec& part : source.uneven.parts)
        parts.push_back(projectedRings(part, kPartPoints));
    std::vector<double> out;
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const Eigen::Vector2d share((column + 0.5) / n, (row + 0.5) / n);
            const Eigen::Vector2d p = box.min() + share.cwiseProduct(box.sizes());
            double weight = parts.empty() ? weightAt(experiment, p.norm()) : 0.0;
            for (std::size_t k = 0; k < parts.size(); ++k)
                if (std::ranges::count_if(parts[k], [&](const Outline& ring) { return encloses(ring, p); }) %
                        2 ==
                    1)
                    weight = weights[k];
            out.push_back(weight);
        }
    return out;
}

} // namespace bask
