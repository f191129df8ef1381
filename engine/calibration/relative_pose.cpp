#include "engine/calibration/relative_pose.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>

namespace bask {
namespace {

std::vector<MessageArg> numbersOf(const PoseSpread& spread) {
    return {formatNumber(1e3 * spread.position_m, 2), formatNumber(degFromRad(spread.angle_rad), 2)};
}

int framesOf(const PartPose& pose) {
    int frames = 0;
    for (const SeenMarker& seen : pose.used)
        frames = std::max(frames, seen.frames);
    return frames;
}

MarkerLayout usedOf(const PartPose& a, const PartPose& b) {
    MarkerLayout layout;
    for (const PartPose* part : {&a, &b})
        for (const SeenMarker& seen : part->used)
            layout.markers.push_back(seen.marker);
    return layout;
}

} // namespace

Result<RelativePose> relativePose(std::span<const MarkerFrame> frames, const MarkerLayout& layout, Part a,
                                  Part b, const CameraModel& camera, std::optional<double> corner_px) {
    auto ofA = partPose(frames, layout, a, camera, corner_px);
    if (!ofA)
        return ofA.error();
    auto ofB = partPose(frames, layout, b, camera, corner_px);
    if (!ofB)
        return ofB.error();
    RelativePose pose;
    pose.X_AB = ofA->X_CP.inverse() * ofB->X_CP;
    pose.covariance = covarianceBetween(ofA->X_CP, ofA->covariance, ofB->X_CP, ofB->covariance);
    const auto predicted = [&](const MarkerLayout& markers, int count, double deviation_px) -> Matrix6d {
        return predictedCovariance(markers, a, ofA->X_CP, b, ofB->X_CP, camera, count, deviation_px)
            .value_or(Matrix6d::Zero());
    };
    const int count = std::max(framesOf(*ofA), framesOf(*ofB));
    pose.spread = spreadOf(pose.covariance + predicted(usedOf(*ofA, *ofB), 1, kLastingCorner_px));
    pose.possible =
        spreadOf(predicted(layout, count, kUsualCorner_px) + predicted(layout, 1, kLastingCorner_px));
    pose.a = std::move(*ofA);
    pose.b = std::move(*ofB);
    return pose;
}

std::optional<Matrix6d> predictedCovariance(const MarkerLayout& layout, Part a, const Pose& X_CA, Part b,
                                            const Pose& X_CB, const CameraModel& camera, int frames,
                                            double corner_px) {
    const auto ofA = predictedCovariance(layout, a, camera, X_CA, frames, corner_px);
    const auto ofB = predictedCovariance(layout, b, camera, X_CB, frames, corner_px);
    return ofA && ofB ? std::optional(covarianceBetween(X_CA, *ofA, X_CB, *ofB)) : std::nullopt;
}

Verdict verdictOn(const PoseSpread& spread) {
    const auto within = [&](double max_mm, double max_deg) {
        return spread.position_m <= 1e-3 * max_mm && spread.angle_rad <= radFromDeg(max_deg);
    };
    return within(1.0, 0.3) ? Verdict::Good : within(3.0, 1.0) ? Verdict::Usable : Verdict::Redo;
}

Judgement judged(const RelativePose& pose) {
    for (const PartPose* part : {&pose.a, &pose.b})
        if (part->mirrored)
            return {Verdict::Redo,
                    *std::ranges::find(part->remarks, MessageCode::PoseAmbiguous, &Message::code)};
    const Verdict verdict = verdictOn(pose.spread);
    std::vector<MessageArg> numbers = numbersOf(pose.spread);
    if (verdict == Verdict::Good)
        return {verdict, {MessageCode::PoseGood, numbers}};
    std::ranges::copy(numbersOf(pose.possible), std::back_inserter(numbers));
    const bool couldBeBetter = verdictOn(pose.possible) < verdict;
    return {verdict, {couldBeBetter ? MessageCode::PoseUncertain : MessageCode::PoseLimited, numbers}};
}

} // namespace bask
