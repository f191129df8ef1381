#include "engine/model/uneven_source.h"

#include "engine/model/experiment_parameters.h"
#include "engine/model/passing_shapes.h"
#include "engine/model/shape_check.h"
#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kRingTolerance = 1e-6; // of a view factor
constexpr double kNearestFace_m = 1e-3; // where the clearance is less
constexpr double kMaxPartPlace_cm = 1000.0;
constexpr int kPartPoints = 120; // of a curved outline that is checked
constexpr double kOutOfPlane_m = 1e-6;
constexpr double kRimShare = 0.01;    // of the contour's radius: outlines from pictures are no better
constexpr double kMinUpright = 0.017; // cosine of a part's tilt: less is on edge, or faces away

PartTemperature temperatureOf(const ProfilePoint& point) {
    return {point.temperatureRatio, point.temperatureOffset_K};
}

// One rule on each panel of the profile: between two of its points temperatures are linear.
struct Panel {
    double from_m = 0.0, to_m = 0.0;
    PartTemperature from, to;
    int nodes = 1;
};

PartTemperature between(const PartTemperature& a, const PartTemperature& b, double share) {
    return {std::lerp(a.ratio, b.ratio, share), std::lerp(a.offset_K, b.offset_K, share)};
}

// Of a face at height z over the radius r the view factor to a disk of radius s is regular in s within z of
// the real axis: Gauss's rule on a panel of half length h errs as exp(-2 n asinh(z / h)).
int nodesFor(double half_m, double height_m, double error) {
    const double exponent = std::asinh(height_m / half_m);
    const double nodes = std::ceil(-std::log(error) / (2.0 * exponent));
    return static_cast<int>(std::clamp(nodes, 1.0, double{kMaxGaussPoints}));
}

std::vector<Panel> panelsOf(const std::vector<ProfilePoint>& profile, double height_m, double error) {
    std::vector<Panel> panels;
    const double span_m = profile.back().radius_m - profile.front().radius_m;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
        const PartTemperature from = temperatureOf(profile[i]), to = temperatureOf(profile[i + 1]);
        if (from == to)
            continue;
        const double length_m = profile[i + 1].radius_m - profile[i].radius_m;
        // As many rings as its part of the radius has, where the clearance asks for more than there may be.
        const double share = static_cast<double>(kMaxRings) * length_m / span_m / kMaxGaussPoints;
        const int count = static_cast<int>(
            std::clamp(std::ceil(0.5 * length_m / height_m), 1.0, std::max(1.0, std::floor(share))));
        for (int k = 0; k < count; ++k) {
            const double first = static_cast<double>(k) / count, last = static_cast<double>(k + 1) / count;
            panels.push_back({std::lerp(profile[i].radius_m, profile[i + 1].radius_m, first),
                              std::lerp(profile[i].radius_m, profile[i + 1].radius_m, last),
                              between(from, to, first), between(from, to, last),
                              nodesFor(0.5 * length_m / count, height_m, error)});
        }
    }
    return panels;
}

std::vector<Panel> halved(const std::vector<Panel>& panels) {
    std::vector<Panel> out;
    for (const Panel& panel : panels) {
        const double middle_m = 0.5 * (panel.from_m + panel.to_m);
        const PartTemperature middle = between(panel.from, panel.to, 0.5);
        out.push_back({panel.from_m, middle_m, panel.from, middle, kMaxGaussPoints});
        out.push_back({middle_m, panel.to_m, middle, panel.to, kMaxGaussPoints});
    }
    return out;
}

struct Rings {
    std::vector<double> radii_m;
    std::vector<EmissionTerm> emission;
};

// F = w(R) F(R) - integral of dw/dr F(r) dr, with F(r) the view factor to a disk of radius r.
Rings ringsOf(const std::vector<Panel>& panels, double radius_m, const PartTemperature& rim,
              double emittance) {
    Rings rings{{radius_m}, {{emittance, rim}}};
    for (const Panel& panel : panels) {
        const GaussRule rule = gaussRule(panel.nodes);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const PartTemperature rise{rule.weights[k] * (panel.to.ratio - panel.from.ratio),
                                       rule.weights[k] * (panel.to.offset_K - panel.from.offset_K)};
            rings.radii_m.push_back(std::lerp(panel.from_m, panel.to_m, rule.nodes[k]));
            rings.emission.push_back({emittance, between(panel.from, panel.to, rule.nodes[k]), rise});
        }
    }
    return rings;
}

// A small face at height z over the radius r, parallel to a disk of radius s.
double viewFactorToDisk(double s_m, double r_m, double z_m) {
    const double near = r_m * r_m + z_m * z_m - s_m * s_m;
    const double sum = r_m * r_m + z_m * z_m + s_m * s_m;
    return 0.5 * (1.0 - near / std::sqrt(sum * sum - 4.0 * r_m * r_m * s_m * s_m));
}

double viewFactorToRings(const Rings& rings, const std::vector<double>& factors, double r_m, double z_m) {
    double sum = 0.0;
    for (std::size_t k = 0; k < factors.size(); ++k)
        sum += factors[k] * viewFactorToDisk(rings.radii_m[k], r_m, z_m);
    return sum;
}

/// The largest difference of two sets of rings over the disk, for a face at height z.
double largestDifference(const Rings& a, const std::vector<double>& factorsA, const Rings& b,
                         const std::vector<double>& factorsB, double radius_m, double z_m) {
    constexpr int kLooks = 40;
    double largest = 0.0;
    for (int k = 0; k <= kLooks; ++k) {
        const double r_m = radius_m * k / kLooks;
        largest = std::max(largest, std::abs(viewFactorToRings(a, factorsA, r_m, z_m) -
                                             viewFactorToRings(b, factorsB, r_m, z_m)));
    }
    return largest;
}

void addRings(const std::vector<ProfilePoint>& profile, double radius_m, double clearance_m, double source_K,
              UnevenSource& out) {
    const double height_m = std::max(clearance_m, kNearestFace_m);
    const PartTemperature rim = temperatureOf(profile.back());
    SourceEmission& emission = out.emission;
    const auto factorsOf = [&](const Rings& rings) {
        SourceEmission other = emission;
        other.terms = rings.emission;
        return other.factors(source_K);
    };
    const Rings fine =
        ringsOf(halved(panelsOf(profile, height_m, kRingTolerance)), radius_m, rim, emission.emittance);
    const std::vector<double> reference = factorsOf(fine);
    // The bound of the rule's error is many times too large, so rings begin at a rougher one.
    Rings rings;
    for (double error = 0.1; error >= kRingTolerance; error *= 0.1) {
        rings = ringsOf(panelsOf(profile, height_m, error), radius_m, rim, emission.emittance);
        out.ringError = largestDifference(rings, factorsOf(rings), fine, reference, radius_m, height_m);
        if (out.ringError <= kRingTolerance)
            break;
    }
    for (const double ring_m : rings.radii_m)
        out.terms.push_back({RadiatingContour(Disk{ring_m})});
    emission.terms = rings.emission;
}

/// By how much a point of S's plane lies outside an outline, m; not positive inside.
double beyond_m(const Shape& contour, const Eigen::Vector2d& p) {
    if (const auto* disk = outlineAs<Disk>(contour))
        return p.norm() - disk->radius_m;
    const std::vector<Eigen::Vector2d> ring = shapeOutline(contour, 4 * kPartPoints);
    double distance_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Eigen::Vector2d& a = ring[i];
        const Eigen::Vector2d edge = ring[(i + 1) % ring.size()] - a;
        const double share = std::clamp((p - a).dot(edge) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
        distance_m = std::min(distance_m, (a + share * edge - p).norm());
    }
    return encloses(ring, p) ? -distance_m : distance_m;
}

std::vector<Eigen::Vector3d> outlineInSource(const SourcePartSpec& part) {
    const Pose X_SP = poseFromCoordinates(part.pose);
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& p : shapeOutline(part.shape, kPartPoints))
        points.emplace_back(X_SP * Eigen::Vector3d(p.x(), p.y(), 0.0));
    return points;
}

std::string partName(const std::string& prefix, std::size_t k) {
    return prefix + "parts[" + std::to_string(k) + ']';
}

std::string millimetres(double value_m) {
    return formatNumber(1e3 * value_m, 3);
}

void checkPart(Checker& check, const std::string& path, const SourcePartSpec& part, const Shape& contour) {
    checkShape(check, path + ".contour", part.shape, part.origin, 0.01 * kMaxPartPlace_cm);
    checkCoordinates(check, path + ".pose.", part.pose, kMaxPartPlace_cm, false);
    check.parameters(path + '.', sourcePartParameters(), part);
    if (check.failed())
        return;
    if (poseFromCoordinates(part.pose).linear()(2, 2) < kMinUpright)
        return check.fail(MessageCode::SourcePartTurned, path + ".pose");
    double beyond = 0.0, above_m = 0.0;
    for (const Eigen::Vector3d& p : outlineInSource(part)) {
        beyond = std::max(beyond, beyond_m(contour, p.head<2>()));
        above_m = std::max(above_m, p.z());
    }
    if (above_m > kOutOfPlane_m)
        check.fail(MessageCode::SourcePartRaised, path, {millimetres(above_m)});
    else if (beyond > kRimShare * shapeRadius(contour))
        check.fail(MessageCode::SourcePartOutside, path, {millimetres(beyond)});
}

void checkPartsTogether(Checker& check, const std::string& prefix, const std::vector<SourcePartSpec>& parts) {
    std::size_t corners = 0;
    for (const SourcePartSpec& part : parts)
        for (const auto& ring : shapeRings(part.shape, kPartPoints))
            corners += ring.size();
    const std::size_t max = kMaxCorners + kMaxSourceParts * kPartPoints;
    if (corners > max)
        return check.range(prefix + "parts", static_cast<double>(corners), 3.0, static_cast<double>(max),
                           "corners");
    for (std::size_t k = 1; k < parts.size() && !check.failed(); ++k)
        for (std::size_t other = 0; other < k && !check.failed(); ++other) {
            const Pose X_SK = poseFromCoordinates(parts[k].pose),
                       X_SOther = poseFromCoordinates(parts[other].pose);
            const double apart_m = (X_SK.translation() - X_SOther.translation()).norm();
            if (apart_m < shapeRadius(parts[k].shape) + shapeRadius(parts[other].shape) &&
                passageOf(parts[other].shape, X_SOther, parts[k].shape, X_SK) != Passage::None)
                return check.fail(MessageCode::SourcePartsOverlap, partName(prefix, k),
                                  {partName(prefix, other)});
            const auto isOver = [](const SourcePartSpec& upper, const Pose& X_SLower) {
                return std::ranges::any_of(outlineInSource(upper), [&](const Eigen::Vector3d& p) {
                    return X_SLower.linear().col(2).dot(p - X_SLower.translation()) > kOutOfPlane_m;
                });
            };
            if (isOver(parts[k], X_SOther))
                check.fail(MessageCode::SourcePartShades, partName(prefix, k), {partName(prefix, other)});
            else if (isOver(parts[other], X_SK))
                check.fail(MessageCode::SourcePartShades, partName(prefix, other), {partName(prefix, k)});
        }
}

void checkProfile(Checker& check, const std::string& path, const std::vector<ProfilePoint>& profile,
                  const Shape& contour) {
    const auto* disk = std::get_if<Disk>(&contour);
    if (disk == nullptr)
        return check.fail(MessageCode::ProfileNeedsDisk, path);
    if (profile.size() > kMaxProfilePoints)
        check.range(path, static_cast<double>(profile.size()), 1.0, static_cast<double>(kMaxProfilePoints),
                    "points");
    for (std::size_t i = 0; i < profile.size() && !check.failed(); ++i) {
        const std::string point = path + '[' + std::to_string(i) + "].";
        check.parameters(point, profilePointParameters(), profile[i]);
        check.range(point + "radius_mm", 1e3 * profile[i].radius_m, 0.0, 1e3 * disk->radius_m * (1.0 + 1e-9),
                    "mm");
        if (i > 0 && !(profile[i].radius_m > profile[i - 1].radius_m))
            check.fail(
                MessageCode::RadiiNotGrowing, point + "radius_mm",
                {formatNumber(1e3 * profile[i].radius_m, 6), formatNumber(1e3 * profile[i - 1].radius_m, 6)});
    }
}

/// Where a temperature is bounded the profile has a kink between its points, which its rings do not follow.
void checkWithinBounds(Checker& check, const std::string& path, const std::vector<ProfilePoint>& profile,
                       double excess_K) {
    for (std::size_t i = 0; i < profile.size() && !check.failed(); ++i) {
        const double ratio = profile[i].temperatureRatio + profile[i].temperatureOffset_K / excess_K;
        check.range(path + '[' + std::to_string(i) + "].temperature", ratio, 0.0, kMaxPartRatio,
                    "of the source's height above the room");
    }
}

} // namespace

SourceEmission emissionWithoutRings(const Experiment& experiment, const Unevenness& uneven,
                                    double emittance) {
    SourceEmission emission{experiment.source.model, emittance, experiment.environment_K};
    for (const SourcePartSpec& part : uneven.parts)
        emission.terms.push_back(
            {part.emittance.value_or(emittance), {part.temperatureRatio, part.temperatureOffset_K}});
    for (const ProfilePoint& point : uneven.profile)
        emission.profile.push_back(temperatureOf(point));
    return emission;
}

SourceEmission emissionWithoutRings(const Experiment& experiment) {
    return emissionWithoutRings(experiment, experiment.source.uneven, experiment.source.emittance);
}

UnevenSource unevenSource(const Experiment& experiment, const Unevenness& uneven, double emittance) {
    const SourceSpec& source = experiment.source;
    UnevenSource out{{}, emissionWithoutRings(experiment, uneven, emittance)};
    for (const SourcePartSpec& part : uneven.parts)
        out.terms.push_back({RadiatingContour(part.shape), poseFromCoordinates(part.pose)});
    if (!uneven.profile.empty())
        addRings(uneven.profile, std::get<Disk>(source.shape).radius_m, experiment.robot.clearance_m,
                 source.temperature_K, out);
    return out;
}

std::string unevennessWords(const Experiment& experiment) {
    const SourceSpec& source = experiment.source;
    const UnevenSource uneven = unevenSource(experiment, source.uneven, source.emittance);
    const std::vector<double> weights = uneven.emission.weights(source.temperature_K);
    const auto [min, max] = std::ranges::minmax(weights);
    const std::string range = formatNumber(min, 3) + " to " + formatNumber(max, 3);
    if (source.uneven.profile.empty())
        return std::to_string(weights.size()) + " parts that radiate " + range +
               " of what an even source does";
    return "a radial profile that radiates " + range + " of what an even source does, as " +
           std::to_string(uneven.terms.size()) + " rings, view factors right to " +
           formatNumber(uneven.ringError, 2);
}

RadiatingSource radiatingSource(const Experiment& experiment) {
    const SourceSpec& source = experiment.source;
    if (source.uneven.isEven())
        return RadiatingContour(source.shape);
    UnevenSource uneven = unevenSource(experiment, source.uneven, source.emittance);
    return {std::move(uneven.terms), uneven.emission.factors(source.temperature_K)};
}

void checkUnevenness(Checker& check, const std::string& prefix, const Unevenness& uneven,
                     const Experiment& experiment, double emittance) {
    if (check.failed() || uneven.isEven())
        return;
    const Shape& contour = experiment.source.shape;
    if (!uneven.parts.empty() && !uneven.profile.empty())
        return check.fail(MessageCode::JsonTwoSpellings, prefix + "profile",
                          {prefix + "parts", prefix + "profile"});
    if (!uneven.profile.empty())
        checkProfile(check, prefix + "profile", uneven.profile, contour);
    const double source_K = experiment.source.temperature_K;
    if (!check.failed())
        checkWithinBounds(check, prefix + "profile", uneven.profile, source_K - experiment.environment_K);
    if (uneven.parts.size() > kMaxSourceParts)
        check.range(prefix + "parts", static_cast<double>(uneven.parts.size()), 1.0,
                    static_cast<double>(kMaxSourceParts), "parts");
    for (std::size_t k = 0; k < uneven.parts.size() && !check.failed(); ++k)
        checkPart(check, partName(prefix, k), uneven.parts[k], contour);
    if (!check.failed())
        checkPartsTogether(check, prefix, uneven.parts);
    if (check.failed())
        return;
    const std::vector<double> weights = emissionWithoutRings(experiment, uneven, emittance).weights(source_K);
    if (std::ranges::all_of(weights, [](double weight) { return weight == 0.0; }))
        check.fail(MessageCode::SourceTooWeak, prefix + (uneven.parts.empty() ? "profile" : "parts"), {"0"});
}

} // namespace bask
