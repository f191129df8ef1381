#include "engine/vision/marker_search.h"

#include "engine/calibration/part_pose.h"
#include "engine/calibration/projection.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kMaxCoordinate_px = 1e6; // keeps what is far outside of a picture within int

// Where the corners are shown, and a margin for the marker's light surround and for how unsure the pose is.
PictureRegion regionAbout(const PlacedMarker& marker, const CameraModel& camera, const Pose& X_CP,
                          const Matrix6d& covariance) {
    constexpr double kMin_px = 8.0, kOfSide = 0.3, kSpreads = 1.5; // a spread is two deviations
    Eigen::Vector2d min = Eigen::Vector2d::Constant(kMaxCoordinate_px), max = -min;
    for (const Eigen::Vector3d& p_PQ : marker.corners()) {
        const Eigen::Vector2d shown = shownAt(Lens(camera), Eigen::Vector3d(X_CP * p_PQ));
        min = min.cwiseMin(shown);
        max = max.cwiseMax(shown);
    }
    const Eigen::Vector3d p_CM = X_CP * marker.X_PM.translation();
    const Matrix6d J = carriedBy(p_CM - X_CP.translation());
    const double unsure_m = spreadOf(J * covariance * J.transpose()).position_m;
    const double margin =
        kMin_px + kOfSide * (max - min).maxCoeff() + kSpreads * camera.fx * unsure_m / p_CM.z();
    const auto pixel = [](double x) {
        return static_cast<int>(std::clamp(std::round(x), -kMaxCoordinate_px, kMaxCoordinate_px));
    };
    PictureRegion region{pixel(min.x() - margin), pixel(min.y() - margin)};
    region.width = pixel(max.x() + margin) - region.x;
    region.height = pixel(max.y() + margin) - region.y;
    return region;
}

bool overlap(const PictureRegion& a, const PictureRegion& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

PictureRegion around(const PictureRegion& a, const PictureRegion& b) {
    PictureRegion both{std::min(a.x, b.x), std::min(a.y, b.y)};
    both.width = std::max(a.x + a.width, b.x + b.width) - both.x;
    both.height = std::max(a.y + a.height, b.y + b.height) - both.y;
    return both;
}

void add(std::vector<PictureRegion>& regions, PictureRegion region) {
    for (auto it = regions.begin(); it != regions.end();)
        if (overlap(*it, region)) {
            region = around(*it, region);
            regions.erase(it);
            it = regions.begin(); // the larger one may reach others
        } else {
            ++it;
        }
    regions.push_back(region);
}

GreyPicture cut(const GreyPicture& from, const PictureRegion& wanted) {
    const int left = std::clamp(wanted.x, 0, from.width), top = std::clamp(wanted.y, 0, from.height);
    GreyPicture piece;
    piece.width = std::clamp(wanted.x + wanted.width, left, from.width) - left;
    piece.height = std::clamp(wanted.y + wanted.height, top, from.height) - top;
    piece.values.reserve(static_cast<std::size_t>(piece.width) * static_cast<std::size_t>(piece.height));
    for (int y = top; y < top + piece.height; ++y) {
        const auto row = from.values.begin() + static_cast<std::ptrdiff_t>(y) * from.width + left;
        piece.values.insert(piece.values.end(), row, row + piece.width);
    }
    return piece;
}

} // namespace

ExpectedMarkers expectedMarkers(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                const Pose& X_CP, const Matrix6d& covariance) {
    ExpectedMarkers expected;
    for (const PlacedMarker& marker : layout.markers)
        if (marker.part == part && showsMarker(camera, marker, X_CP)) {
            ++expected.count;
            add(expected.regions, regionAbout(marker, camera, X_CP, covariance));
        }
    return expected;
}

std::vector<FoundMarker> findMarkersIn(const GreyPicture& picture, const std::vector<PictureRegion>& regions,
                                       const MarkerDictionary& dictionary) {
    std::vector<FoundMarker> all;
    if (picture.width <= 0 || picture.height <= 0 ||
        picture.values.size() !=
            static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height))
        return all;
    for (const PictureRegion& region : regions) {
        const bool isWhole = region.x <= 0 && region.y <= 0 && region.x + region.width >= picture.width &&
                             region.y + region.height >= picture.height;
        if (isWhole)
            return findMarkers(picture, dictionary);
        const Eigen::Vector2d corner(std::max(region.x, 0), std::max(region.y, 0));
        for (FoundMarker& marker : findMarkers(cut(picture, region), dictionary)) {
            for (Eigen::Vector2d& p : marker.corners_px)
                p += corner;
            all.push_back(marker);
        }
    }
    return all;
}

PictureRegion wholeOf(const GreyPicture& picture) {
    return {0, 0, picture.width, picture.height};
}

double pixelsIn(const std::vector<PictureRegion>& regions) {
    double sum = 0.0;
    for (const PictureRegion& region : regions)
        sum += static_cast<double>(region.width) * region.height;
    return sum;
}

bool SearchSchedule::wantsAll(double time_s, int expected, int seen) {
    constexpr double kJitter_s = 0.01;
    m_fewer = seen < expected ? m_fewer + 1 : 0;
    if (seen > 0 && m_fewer < kFewerFrames)
        return false;
    const double pause_s = seen > 0 ? kFewer_s : kLost_s;
    if (std::abs(time_s - m_last_s) < pause_s - kJitter_s)
        return false;
    m_last_s = time_s;
    return true;
}

} // namespace bask
