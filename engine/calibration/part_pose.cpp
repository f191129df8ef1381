#include "engine/calibration/part_pose.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/corner_fit.h"
#include "engine/calibration/marker_pose.h"
#include "engine/calibration/projection.h"
#include "engine/calibration/rigid_fit.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kGross_px = 3.0;   // a marker that misses by more is not where or what it is said to be
constexpr double kCoarse_px = 10.0; // by which one marker's pose may show the others wrongly
constexpr double kFine_px = 1.0;
constexpr double kMinCorner_px = 0.02; // no detector is surer
constexpr double kOther_rad = 0.05;    // poses so far apart are two

std::vector<SeenCorner> cornersOf(const SeenMarker& seen) {
    std::vector<SeenCorner> corners;
    const auto places = seen.marker.corners();
    for (std::size_t k = 0; k < 4; ++k)
        corners.push_back({places[k], seen.corners_px[k], static_cast<double>(seen.frames)});
    return corners;
}

std::vector<SeenCorner> cornersOf(std::span<const SeenMarker> markers) {
    std::vector<SeenCorner> all;
    for (const SeenMarker& seen : markers)
        std::ranges::copy(cornersOf(seen), std::back_inserter(all));
    return all;
}

double rmsOf(std::span<const SeenCorner> corners, const CameraModel& camera, const Pose& X_CP) {
    double squares = 0.0;
    for (const SeenCorner& corner : corners)
        squares += std::pow(missOf(corner, camera, X_CP), 2);
    return std::sqrt(squares / static_cast<double>(corners.size()));
}

double robustCost(std::span<const SeenCorner> corners, const CameraModel& camera, const Pose& X_CP,
                  double scale_px) {
    double cost = 0.0;
    for (const SeenCorner& corner : corners)
        cost += std::log1p(std::pow(missOf(corner, camera, X_CP) / scale_px, 2));
    return cost;
}

double angleBetween(const Pose& a, const Pose& b) {
    return displacementBetween(a, b).tail<3>().norm();
}

// The part's pose by each marker alone, both where there are two; those that suit all markers best first.
std::vector<Pose> candidates(std::span<const SeenMarker> markers, const CameraModel& camera) {
    const std::vector<SeenCorner> corners = cornersOf(markers);
    std::vector<std::pair<double, Pose>> rated;
    for (const SeenMarker& seen : markers) {
        const auto poses = markerPoses(seen.corners_px, seen.marker.side_m, camera);
        if (!poses)
            continue;
        const auto add = [&](const MarkerPose& pose) {
            const Pose X_CP = pose.X_CM() * seen.marker.X_PM.inverse();
            rated.emplace_back(robustCost(corners, camera, X_CP, kCoarse_px), X_CP);
        };
        add(poses->best);
        if (poses->second)
            add(*poses->second);
    }
    std::ranges::sort(rated, {}, [](const auto& r) { return r.first; });
    std::vector<Pose> result;
    for (const auto& [cost, pose] : rated)
        result.push_back(pose);
    return result;
}

// Wrong markers are among the corners: distances that are much too large hardly count.
std::optional<Pose> consensus(std::span<const SeenCorner> corners, const CameraModel& camera,
                              std::span<const Pose> starts) {
    constexpr std::size_t kStarts = 4;
    std::optional<Pose> best;
    for (const Pose& start : starts.first(std::min(kStarts, starts.size()))) {
        const auto coarse = fitCorners(corners, camera, start, kCoarse_px);
        const auto fine = coarse ? fitCorners(corners, camera, coarse->X_CP, kFine_px) : std::nullopt;
        if (fine && (!best || robustCost(corners, camera, fine->X_CP, kFine_px) <
                                  robustCost(corners, camera, *best, kFine_px)))
            best = fine->X_CP;
    }
    return best;
}

struct Sides {
    std::vector<SeenMarker> kept, out;
};

Sides sidesAt(std::span<const SeenMarker> markers, const CameraModel& camera, const Pose& X_CP) {
    Sides sides;
    for (const SeenMarker& seen : markers)
        (rmsOf(cornersOf(seen), camera, X_CP) > kGross_px ? sides.out : sides.kept).push_back(seen);
    return sides;
}

Error disagreement(std::span<const SeenMarker> markers) {
    std::vector<int> ids;
    for (const SeenMarker& seen : markers)
        ids.push_back(seen.marker.id);
    return {MessageCode::MarkersDisagree, "", {idsText(ids), formatNumber(kGross_px)}};
}

// The side with which a marker would miss least at this pose, when that explains most of the miss.
std::optional<double> otherSide(const SeenMarker& seen, const CameraModel& camera, const Pose& X_CP,
                                double noise_px) {
    constexpr double kMinChange = 0.01, kExplained = 0.5, kDeviations = 5.0;
    const double before = rmsOf(cornersOf(seen), camera, X_CP);
    if (before < kDeviations * noise_px)
        return std::nullopt;
    SeenMarker other = seen;
    const auto missWith = [&](double side_m) {
        other.marker.side_m = side_m;
        return rmsOf(cornersOf(other), camera, X_CP);
    };
    double min = 0.2 * seen.marker.side_m, max = 5.0 * seen.marker.side_m;
    for (int k = 0; k < 60; ++k) { // one valley: a third of the interval goes each time
        const double third = (max - min) / 3.0;
        if (missWith(min + third) < missWith(max - third))
            max -= third;
        else
            min += third;
    }
    const double side_m = 0.5 * (min + max);
    const bool isOther =
        std::abs(side_m / seen.marker.side_m - 1.0) > kMinChange && missWith(side_m) < kExplained * before;
    return isOther ? std::optional(side_m) : std::nullopt;
}

void remarkOnMarkers(PartPose& pose, const Sides& sides, const CameraModel& camera) {
    for (const auto* group : {&sides.out, &sides.kept})
        for (const SeenMarker& seen : *group) {
            const bool isOut = group == &sides.out;
            const double noise_px = std::sqrt(2.0 / seen.frames) * pose.corner_px;
            if (const auto side_m = otherSide(seen, camera, pose.X_CP, noise_px);
                side_m && pose.used.size() > 1)
                pose.remarks.push_back({MessageCode::MarkerSideOther,
                                        {std::to_string(seen.marker.id), formatNumber(1e3 * *side_m, 3),
                                         formatNumber(1e3 * seen.marker.side_m, 3)}});
            else if (isOut)
                pose.remarks.push_back({MessageCode::MarkerLeftOut,
                                        {std::to_string(seen.marker.id),
                                         formatNumber(rmsOf(cornersOf(seen), camera, pose.X_CP), 2)}});
        }
}

// Of a corner's coordinate in one frame: more than its scatter where the markers are no squares by that.
double varianceFor(const PartPose& pose, double ownSquares_px2) {
    const double variance = pose.corner_px * pose.corner_px;
    const double freedom = 2.0 * static_cast<double>(pose.used.size());
    return ownSquares_px2 <= variance * chiSquareBound(freedom) ? variance : ownSquares_px2 / freedom;
}

// Each marker by itself: where its corners ask it to go from where the part's pose puts it.
struct MarkerPlaces {
    std::vector<RigidSight> sights; ///< noise by a variance of 1
    double ownSquares_px2 = 0.0;    ///< that remain when each marker goes there
};

MarkerPlaces markerPlaces(const PartPose& pose, const CameraModel& camera) {
    MarkerPlaces places;
    for (const SeenMarker& seen : pose.used) {
        const Pose X_CM = pose.X_CP * seen.marker.X_PM;
        std::vector<SeenCorner> corners = cornersOf(seen);
        for (SeenCorner& corner : corners)
            corner.p_PQ = seen.marker.X_PM.inverse() * corner.p_PQ;
        const CornerSums sums = cornerSums(corners, camera, X_CM);
        RigidSight sight;
        sight.noise = sums.information.inverse();
        sight.moved = sight.noise * sums.gradient;
        sight.byUnknowns = carriedBy(X_CM.translation() - pose.X_CP.translation());
        places.ownSquares_px2 += sums.squares_px2 - sums.gradient.dot(sight.moved);
        places.sights.push_back(sight);
    }
    return places;
}

// Markers that sit elsewhere than they are said to: their corners are wrong together, and no average of
// frames tells. Answers the variance of a corner's coordinate.
double allowForMisfit(PartPose& pose, const CornerFit& fit, const CameraModel& camera) {
    constexpr double kTold_px = 0.5;
    constexpr int kSteps = 3;
    MarkerPlaces places = markerPlaces(pose, camera);
    const double variance = varianceFor(pose, places.ownSquares_px2);
    const double freedom = 8.0 * static_cast<double>(pose.used.size()) - 6.0;
    pose.covariance = variance * fit.information.inverse();
    if (pose.used.size() < 2 || fit.squares_px2 <= variance * freedom) // what noise alone leaves
        return variance;
    for (int step = 0; step < kSteps; ++step) {
        for (RigidSight& sight : places.sights)
            sight.noise *= variance;
        const RigidFit moved = fitRigid(places.sights);
        pose.X_CP = displaced(pose.X_CP, moved.unknowns);
        pose.covariance = moved.covariance;
        places = markerPlaces(pose, camera);
    }
    pose.rms_px = rmsOf(cornersOf(pose.used), camera, pose.X_CP);
    if (pose.rms_px > kTold_px)
        pose.remarks.push_back({MessageCode::MarkersMisfit, {formatNumber(pose.rms_px, 2)}});
    return std::max(variance, fit.squares_px2 / freedom);
}

// Another pose whose squares exceed those of the best by less than nine variances.
void findMirrored(PartPose& pose, const CornerFit& best, double variance, const CameraModel& camera,
                  std::span<const Pose> starts) {
    constexpr double kVariances = 9.0;
    const std::vector<SeenCorner> corners = cornersOf(pose.used);
    for (const Pose& start : starts) {
        if (angleBetween(start, pose.X_CP) < kOther_rad)
            continue;
        const auto other = fitCorners(corners, camera, start);
        if (!other || angleBetween(other->X_CP, pose.X_CP) < kOther_rad ||
            other->squares_px2 - best.squares_px2 > kVariances * variance)
            continue;
        pose.mirrored = other->X_CP;
        pose.remarks.push_back({MessageCode::PoseAmbiguous,
                                {formatNumber(degFromRad(angleBetween(other->X_CP, pose.X_CP)), 2)}});
        return;
    }
}

} // namespace

Result<PartPose> partPose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part part,
                          const CameraModel& camera, std::optional<double> corner_px) {
    const auto seen = seenMarkers(frames, layout, part);
    if (!seen)
        return seen.error();
    const std::vector<Pose> starts = candidates(*seen, camera);
    const auto agreed = consensus(cornersOf(*seen), camera, starts);
    if (!agreed)
        return disagreement(*seen);
    Sides sides = sidesAt(*seen, camera, *agreed);
    if (sides.kept.size() <= sides.out.size())
        return disagreement(*seen);
    const auto fit = fitCorners(cornersOf(sides.kept), camera, *agreed);
    if (!fit)
        return disagreement(*seen);
    PartPose pose;
    pose.X_CP = fit->X_CP;
    pose.used = sides.kept;
    pose.corner_px = corner_px.value_or(scatterOf(pose.used).value_or(kUsualCorner_px));
    pose.corner_px = std::max(pose.corner_px, kMinCorner_px);
    pose.rms_px = rmsOf(cornersOf(pose.used), camera, pose.X_CP);
    const double variance = allowForMisfit(pose, *fit, camera);
    remarkOnMarkers(pose, sides, camera);
    findMirrored(pose, *fit, variance, camera, starts);
    return pose;
}

bool showsMarker(const CameraModel& camera, const PlacedMarker& marker, const Pose& X_CP) {
    static const double kMinCosine = std::cos(radFromDeg(75.0));
    const Pose X_CM = X_CP * marker.X_PM;
    const Eigen::Vector3d towards = -X_CM.translation().normalized();
    if (X_CM.linear().col(2).dot(towards) < kMinCosine)
        return false;
    return std::ranges::all_of(marker.corners(),
                               [&](const Eigen::Vector3d& p_PQ) { return isInPicture(camera, X_CP * p_PQ); });
}

std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                            const Pose& X_CP, int frames, double corner_px) {
    std::vector<SeenCorner> corners;
    for (const PlacedMarker& marker : layout.markers)
        if (marker.part == part && showsMarker(camera, marker, X_CP))
            for (const Eigen::Vector3d& p_PQ : marker.corners())
                corners.push_back({p_PQ, Eigen::Vector2d::Zero(), static_cast<double>(frames)});
    if (corners.empty())
        return std::nullopt;
    return corner_px * corner_px * cornerSums(corners, camera, X_CP).information.inverse();
}

} // namespace bask
