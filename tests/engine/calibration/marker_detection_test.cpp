// Markers in pictures of other projects: all that are there, no others, and where they are.

#include "engine/calibration/camera_file.h"
#include "engine/calibration/dictionary_file.h"
#include "engine/calibration/marker_pose.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace bask {
namespace {

using Json = nlohmann::json;

std::vector<FoundMarker> foundIn(const std::string& name, const Json& expected) {
    const std::string dictionary = expected["dictionary"];
    return findSmallMarkersToo(test::greyOf(test::markersPath(name)),
                               isMarkerDictionary(dictionary)
                                   ? MarkerDictionary{dictionary}
                                   : *readDictionary(test::markersPath(dictionary + ".yml")));
}

/// Farthest corner from its place in a list of four.
double farthest(const FoundMarker& marker, const Json& corners, std::size_t corner) {
    return (marker.corners_px[corner] - Eigen::Vector2d(corners[corner][0], corners[corner][1])).norm();
}

// Catches: a marker that is missed, one that is not there, a corner beside its place or with another's
// number. Corners as OpenCV 4.6 found them, in whole pixels or refined, whichever is nearer: the two lie up
// to 3 px apart themselves.
TEST(MarkerDetection, FindsAllThatAreThereAndNoOthers) {
    const Json files = Json::parse(test::textOf(test::markersPath("expected.json")));
    EXPECT_EQ(files.size(), 7U);
    for (const auto& [name, expected] : files.items()) {
        const std::vector<FoundMarker> markers = foundIn(name, expected);
        std::vector<int> ids;
        for (const FoundMarker& marker : markers)
            ids.push_back(marker.id);
        std::ranges::sort(ids);
        EXPECT_EQ(ids, expected["ids"].get<std::vector<int>>()) << name;
        for (const Json& one : expected["markers"]) {
            const bool isThere = std::ranges::any_of(markers, [&](const FoundMarker& marker) {
                if (marker.id != one["id"])
                    return false;
                double worst = 0.0;
                for (std::size_t k = 0; k < 4; ++k)
                    worst = std::max(worst, std::min(farthest(marker, one["corners_px"], k),
                                                     farthest(marker, one["refined_px"], k)));
                return worst <= 1.0;
            });
            EXPECT_TRUE(isThere) << name << " " << one["id"];
        }
    }
}

// Catches: a pose in other axes or another unit. The project that the picture is of asserts the marker's
// place to 1 mm.
TEST(MarkerDetection, PoseOfTheFiducialIsAsItsProjectSays) {
    CameraModel camera;
    camera.fx = 1006.126285753055;
    camera.fy = 1004.015433012594;
    camera.cx = 655.8639244150409;
    camera.cy = 490.6140221242933;
    camera.distortion = {0.1349735087283542, -0.2335869827451621, 0.0006697030315075139, 0.004846737465872353,
                         0.0};
    const auto markers = findSmallMarkersToo(test::greyOf(test::markersPath("403.jpg")), {"5X5_1000"});
    ASSERT_EQ(markers.size(), 1U);
    const auto poses = markerPoses(markers[0].corners_px, 0.145, camera);
    ASSERT_TRUE(poses);
    const double expected[] = {-0.02765, 0.01598, 0.77868};
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(poses->best.translation_m[k], expected[k], 1e-3) << k;
    const Pose X = poseFromRotationVector(Eigen::Vector3d::Zero(), {2.7748, 0.02108, -0.09821});
    EXPECT_LT(Eigen::AngleAxisd(X.linear().transpose() * poses->best.X_CM().linear()).angle(), 0.01);
    EXPECT_LT(poses->best.rms_px, 0.2);
    EXPECT_GT(poses->second.value().rms_px, 2.0);
    EXPECT_FALSE(poses->isAmbiguous);
}

// Catches: a marker found twice by the second look; needs a light margin, so marker23.png has none until it
// gets one.
TEST(MarkerDetection, AMarkerWithAMarginIsFoundOnce) {
    const GreyPicture bare = test::greyOf(test::markersPath("marker23.png"));
    GreyPicture framed = test::flat(bare.width + 60, bare.height + 60, 255);
    for (int y = 0; y < bare.height; ++y)
        for (int x = 0; x < bare.width; ++x)
            framed.values[static_cast<std::size_t>((y + 30) * framed.width + x + 30)] =
                bare.values[static_cast<std::size_t>(y * bare.width + x)];
    const auto markers = findSmallMarkersToo(framed, {"6X6_250"});
    ASSERT_EQ(markers.size(), 1U);
    EXPECT_EQ(markers[0].id, 23);
}

// Catches gigabytes for a picture that is full of quadrangles: none is a marker, which is a negative verdict.
TEST(MarkerDetection, SeesNothingInALargeChessboard) {
    constexpr int kSide = 4000;
    for (const int square : {1, 100}) {
        GreyPicture board = test::flat(kSide, kSide, 0);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                if ((x / square + y / square) % 2 == 0)
                    board.values[static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x)] = 255;
        EXPECT_TRUE(findSmallMarkersToo(board, {"6X6_250"}).empty()) << square;
    }
}

// Catches: markers in nothing, and a crash on pictures smaller than a marker.
TEST(MarkerDetection, SeesNothingInNothing) {
    for (const GreyPicture& picture : {GreyPicture(), test::flat(1, 1, 0), test::flat(1, 500, 255),
                                       test::flat(7, 7, 3), test::flat(640, 480, 255), test::noise(320, 240)})
        for (const char* name : {"6X6_250", "4X4_50", "ARUCO_ORIGINAL"})
            EXPECT_TRUE(findSmallMarkersToo(picture, {name}).empty()) << picture.width << " " << name;
}

} // namespace
} // namespace bask
