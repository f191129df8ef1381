// Where markers are sought, and when everywhere.

#include "engine/vision/marker_search.h"

#include "tests/support/marker_pictures.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

const Matrix6d kSure = 1e-8 * Matrix6d::Identity();

} // namespace

// Catches corners told in the region's pixels, a region without room for the markers' margin, and places of
// markers that are hidden by the part itself.
TEST(MarkerSearch, FindsNearWhatItFindsEverywhere) {
    const MarkerLayout layout = test::fourOnTheSource();
    test::MarkerPictures pictures(test::plainCamera());
    const Pose X_CS = test::facingFrom({-0.03, 0.02, 0.6}, {0.35, 0.2, 0.1});
    const GreyPicture picture = pictures.of(layout, X_CS);
    const ExpectedMarkers near = expectedMarkers(layout, Part::Source, test::plainCamera(), X_CS, kSure);
    EXPECT_EQ(near.count, 4);
    EXPECT_LT(pixelsIn(near.regions), 0.15 * pixelsIn({wholeOf(picture)}));
    auto found = findMarkersIn(picture, near.regions, layout.dictionary);
    auto all = findMarkersIn(picture, {wholeOf(picture)}, layout.dictionary);
    ASSERT_EQ(found.size(), 4U);
    ASSERT_EQ(all.size(), 4U);
    std::ranges::sort(found, {}, &FoundMarker::id);
    std::ranges::sort(all, {}, &FoundMarker::id);
    for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_LT((found[m].corners_px[k] - all[m].corners_px[k]).norm(), 0.05);

    const Pose fromBehind = X_CS * poseFromRotationVector(Eigen::Vector3d::Zero(), {0, std::numbers::pi, 0});
    EXPECT_EQ(expectedMarkers(layout, Part::Source, test::plainCamera(), fromBehind, kSure).count, 0);
    EXPECT_EQ(expectedMarkers(layout, Part::Base, test::plainCamera(), X_CS, kSure).count, 0);
}

// Catches a marker that is found twice, in two regions that overlap, and chains of them.
TEST(MarkerSearch, RegionsThatOverlapAreOne) {
    const MarkerLayout layout = test::fourOnTheSource();
    const Pose far = test::facingFrom({0.0, 0.0, 0.6}, {0.1, 0.1, 0.1});
    Matrix6d unsure = kSure;
    unsure.diagonal().head<3>().setConstant(0.03 * 0.03);
    const ExpectedMarkers near = expectedMarkers(layout, Part::Source, test::plainCamera(), far, unsure);
    EXPECT_EQ(near.count, 4);
    EXPECT_EQ(near.regions.size(), 1U);
}

// Catches a crash by regions at or beyond the border, and by pictures that are smaller than they say.
TEST(MarkerSearch, RegionsBeyondThePicture) {
    const MarkerLayout layout = test::fourOnTheSource();
    test::MarkerPictures pictures(test::plainCamera());
    const GreyPicture picture = pictures.of(layout, test::facingFrom({0.0, 0.0, 0.6}, {0.1, 0.1, 0.1}));
    const std::vector<PictureRegion> regions{{-100, -100, 50, 50},
                                             {-30, -30, 60, 60},
                                             {1270, 710, 500, 500},
                                             {5000, 5000, 10, 10},
                                             {100, 100, 0, 0}};
    EXPECT_TRUE(findMarkersIn(picture, regions, layout.dictionary).empty());
    EXPECT_EQ(findMarkersIn(picture, {{-10, -10, 2000, 2000}}, layout.dictionary).size(), 4U);
    EXPECT_TRUE(findMarkersIn({}, regions, layout.dictionary).empty());
    EXPECT_TRUE(findMarkersIn({1280, 720, {1, 2, 3}}, {{0, 0, 9, 9}}, layout.dictionary).empty());
}

// Catches a lost tracker that searches every frame, one that searches too seldom to be found soon, and a
// marker that is covered for long costing as much as a loss.
TEST(SearchSchedule, IsSeldomerWhereLessIsAtStake) {
    const auto looks = [](int expected, int seen) {
        SearchSchedule schedule;
        int count = 0;
        for (int k = 0; k < 300; ++k)
            count += schedule.wantsAll(k / 30.0, expected, seen) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(looks(0, 0), 100);
    EXPECT_EQ(looks(4, 0), 100);
    EXPECT_EQ(looks(4, 3), 10);
    EXPECT_EQ(looks(4, 4), 0);
    SearchSchedule schedule;
    EXPECT_TRUE(schedule.wantsAll(10.0, 0, 0));
    EXPECT_FALSE(schedule.wantsAll(10.03, 0, 0));
    EXPECT_TRUE(schedule.wantsAll(3.0, 0, 0)) << "time went back";
}

} // namespace bask
