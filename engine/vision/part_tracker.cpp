#include "engine/vision/part_tracker.h"

#include "engine/calibration/marker_pose.h"
#include "engine/calibration/part_pose.h"
#include "engine/calibration/rigid_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kOther_rad = 0.05;  // poses so far apart are two
constexpr double kRounding_s = 1e-6; // of times a second apart

double angleBetween(const Pose& a, const Pose& b) {
    return displacementBetween(a, b).tail<3>().norm();
}

PoseFilter filterAt(double time_s, const Pose& X_CP, std::span<const SeenCorner> corners,
                    const CameraModel& camera, double corner_px) {
    const Matrix6d information = cornerSums(corners, camera, X_CP).information / (corner_px * corner_px);
    return {time_s, X_CP, information.ldlt().solve(Matrix6d::Identity()), corner_px};
}

// What the corners of two markers or more leave beyond the usual.
double cornerDeviation(const PartPose& pose) {
    const double corners = 4.0 * static_cast<double>(pose.used.size());
    return corners < 8.0 ? kUsualCorner_px : pose.rms_px * std::sqrt(corners / (2.0 * corners - 6.0));
}

std::vector<int> without(std::vector<int> ids, const std::vector<SeenMarker>& used) {
    std::erase_if(ids, [&](int id) {
        return std::ranges::any_of(used, [&](const SeenMarker& seen) { return seen.marker.id == id; });
    });
    return ids;
}

} // namespace

PartTracker::PartTracker(MarkerLayout layout, Part part, CameraModel camera)
    : m_layout(std::move(layout)), m_part(part), m_camera(std::move(camera)) {}

void PartTracker::lose() {
    m_filter.reset();
    m_mirrored.reset();
    m_isOpen = m_confirmed = false;
    m_rejected = 0;
}

void PartTracker::forget() {
    lose();
    m_schedule = SearchSchedule();
    m_last_s = -1e300;
}

TrackStep PartTracker::step(const CameraFrame& frame) {
    const double now_s = frame.time_s;
    if (now_s < m_last_s || (m_filter && now_s - m_seen_s > kPredicted_s + kRounding_s))
        lose();
    m_last_s = now_s;
    TrackStep step;
    look(frame, step);
    const Seen seen = seenOf(step.found);
    if ((m_filter && follow(now_s, seen, step)) || begin(now_s, seen, step)) {
        m_seen_s = now_s;
        m_rejected = 0;
    } else if (!m_confirmed) {
        lose();
    }
    if (m_confirmed)
        step.state = m_seen_s == now_s ? TrackState::Tracking : TrackState::Predicting;
    return step;
}

std::optional<TrackedPose> PartTracker::at(double time_s) const {
    if (!m_confirmed || time_s - m_seen_s > kPredicted_s)
        return std::nullopt;
    const MotionState state = m_filter->at(time_s);
    TrackedPose pose{time_s, m_seen_s, state.X_CP, state.velocity, state.covariance.topLeftCorner<6, 6>()};
    if (m_mirrored) {
        const Vector6d there = displacementBetween(state.X_CP, m_mirrored->at(time_s).X_CP);
        pose.covariance += 0.5 * there * there.transpose(); // one is as likely as the other
        pose.isAmbiguous = true;
    }
    return pose;
}

void PartTracker::look(const CameraFrame& frame, TrackStep& step) {
    const GreyPicture& picture = frame.picture;
    if (m_camera.width != 0 && (picture.width != m_camera.width || picture.height != m_camera.height))
        return;
    int expected = 0, seen = 0;
    if (m_filter) {
        const MotionState there = m_filter->at(frame.time_s);
        const ExpectedMarkers near =
            expectedMarkers(m_layout, m_part, m_camera, there.X_CP, there.covariance.topLeftCorner<6, 6>());
        if (pixelsIn(near.regions) < 0.5 * pixelsIn({wholeOf(picture)}))
            step.found = findMarkersIn(picture, near.regions, m_layout.dictionary);
        expected = near.count;
        seen = static_cast<int>(seenOf(step.found).ids.size());
    }
    step.searchedAll = m_schedule.wantsAll(frame.time_s, expected, seen);
    if (step.searchedAll)
        step.found = findMarkersIn(picture, {wholeOf(picture)}, m_layout.dictionary);
}

PartTracker::Seen PartTracker::seenOf(const std::vector<FoundMarker>& found) const {
    Seen seen;
    for (const PlacedMarker& marker : m_layout.markers) {
        const auto isIt = [&](const FoundMarker& other) { return other.id == marker.id; };
        if (marker.part != m_part || std::ranges::count_if(found, isIt) != 1)
            continue;
        seen.ids.push_back(marker.id);
        const auto places = marker.corners();
        const FoundMarker& it = *std::ranges::find_if(found, isIt);
        for (std::size_t k = 0; k < 4; ++k)
            seen.corners.push_back({places[k], it.corners_px[k]});
    }
    return seen;
}

bool PartTracker::follow(double time_s, const Seen& seen, TrackStep& step) {
    if (seen.ids.empty())
        return false;
    const MotionState predicted = m_filter->at(time_s);
    FilterStep taken = m_filter->take(time_s, seen.corners, m_camera);
    if (m_mirrored)
        weighMirrored(time_s, seen, taken);
    else if (seen.ids.size() > 1)
        m_isOpen = false;
    else if (taken.accepted)
        seekMirrored(time_s, seen, predicted);
    if (!taken.accepted) {
        ++m_rejected;
        return false;
    }
    for (const std::size_t corner : taken.left_out)
        if (const int id = seen.ids[corner / 4]; step.left_out.empty() || step.left_out.back() != id)
            step.left_out.push_back(id);
    m_confirmed = true;
    return true;
}

// Both poses are followed; the one that the frames suit worse by nine variances, of some ten frames, goes.
void PartTracker::weighMirrored(double time_s, const Seen& seen, FilterStep& taken) {
    constexpr double kForgotten = 0.1, kVariances = 9.0;
    const FilterStep other = m_mirrored->take(time_s, seen.corners, m_camera);
    if (!taken.accepted && !other.accepted)
        return;
    if (taken.left_out.size() == other.left_out.size())
        m_evidence = (1.0 - kForgotten) * m_evidence + taken.chiSquare - other.chiSquare;
    const bool isOther = other.accepted && (!taken.accepted || m_evidence > kVariances);
    const bool isThis = taken.accepted && (!other.accepted || m_evidence < -kVariances);
    if (isOther) {
        m_filter = m_mirrored;
        taken = other;
    }
    const bool isDecided = isOther || isThis;
    m_isOpen = !isDecided;
    if (isDecided || angleBetween(m_filter->at(time_s).X_CP, m_mirrored->at(time_s).X_CP) < kOther_rad)
        m_mirrored.reset();
}

// A marker that has turned to face the camera may turn either way from there, as far as the prediction
// allows.
void PartTracker::seekMirrored(double time_s, const Seen& seen, const MotionState& predicted) {
    const PlacedMarker& marker = *std::ranges::find(m_layout.markers, seen.ids.front(), &PlacedMarker::id);
    std::array<Eigen::Vector2d, 4> corners_px;
    std::ranges::transform(seen.corners, corners_px.begin(), &SeenCorner::seen_px);
    const auto poses = markerPoses(corners_px, marker.side_m, m_camera);
    if (!poses || !poses->isAmbiguous || !poses->second)
        return;
    const Matrix6d covariance = predicted.covariance.topLeftCorner<6, 6>();
    for (const MarkerPose& pose : {poses->best, *poses->second}) {
        const Pose X_CP = pose.X_CM() * marker.X_PM.inverse();
        const Vector6d way = displacementBetween(predicted.X_CP, X_CP);
        if (angleBetween(m_filter->at(time_s).X_CP, X_CP) < kOther_rad ||
            (!m_isOpen && way.dot(covariance.ldlt().solve(way)) > chiSquareBound(6.0)))
            continue;
        m_mirrored = filterAt(time_s, X_CP, seen.corners, m_camera, m_filter->corner_px());
        m_evidence = 0.0;
        return;
    }
}

bool PartTracker::begin(double time_s, const Seen& seen, TrackStep& step) {
    if (seen.ids.empty())
        return false;
    const std::vector<MarkerFrame> frames{step.found};
    const auto pose = partPose(frames, m_layout, m_part, m_camera);
    step.left_out = pose ? without(seen.ids, pose->used) : seen.ids;
    if (!pose)
        return false;
    const bool isAgreed = pose->used.size() > 1;
    if (m_confirmed && !isAgreed && m_rejected < kRejected) {
        step.left_out = seen.ids;
        return false;
    }
    Pose X_CP = pose->X_CP;
    std::optional<Pose> other = pose->mirrored;
    if (m_confirmed && other) {
        const Pose before = m_filter->at(time_s).X_CP;
        if (angleBetween(before, *other) < angleBetween(before, X_CP))
            std::swap(X_CP, *other);
    }
    m_filter = PoseFilter(time_s, X_CP, pose->covariance, cornerDeviation(*pose));
    m_mirrored.reset();
    m_isOpen = false;
    if (other)
        m_mirrored = filterAt(time_s, *other, seen.corners, m_camera, m_filter->corner_px());
    m_evidence = 0.0;
    m_confirmed = m_confirmed || isAgreed;
    return true;
}

} // namespace bask
