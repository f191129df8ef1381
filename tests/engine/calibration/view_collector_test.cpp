// Which looks at a board are kept, and what is said to be missing.

#include "engine/calibration/view_collector.h"

#include "engine/base/message_code.h"
#include "engine/base/pose.h"
#include "engine/base/units.h"
#include "tests/support/board_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace bask {
namespace {

using Look = ViewCollector::Look;
const Board kChessboard = *parseBoard("chessboard:9x6:0.025");
const Eigen::Vector3d kMiddle(0.1, 0.0625, 0.0);

/// Held with its middle there (m, camera axes), turned.
Pose held(const Eigen::Vector3d& middle_m, const Eigen::Vector3d& turn_rad) {
    const Pose turn = poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
    return poseFromRotationVector(middle_m - turn * kMiddle, turn_rad);
}

struct ViewCollectorTest : testing::Test {
    CameraModel camera = test::trueCamera();
    std::mt19937 random{4};
    ViewCollector collector{kChessboard, 1280, 720};
    double time_s = 0.0;

    BoardView view(const Pose& X_CB, double noise_px = 0.1) {
        return test::viewOf(kChessboard, X_CB, camera, noise_px, random);
    }
    ViewPlace place(const Pose& X_CB) { return *placeOf(view(X_CB), kChessboard, 1280, 720); }
    Look look(const Pose& X_CB) { return collector.look(view(X_CB), time_s += 1.0 / 30.0); }
    /// Held there for half a second.
    Look holdAt(const Pose& X_CB) {
        Look last = Look::Moving;
        for (int k = 0; k < 15; ++k)
            if (last = look(X_CB); last == Look::Kept)
                break;
        return last;
    }
    bool isMissing(MessageCode code) const {
        const auto missing = collector.coverage().missing;
        return std::ranges::find(missing, code, &Message::code) != missing.end();
    }
};

// Catches: a tilt of wrong size or side, which would send the operator the wrong way. The camera is unknown,
// so perspective takes some degrees.
TEST_F(ViewCollectorTest, TheTiltIsToldWithoutACamera) {
    for (const double a : {-0.6, -0.3, 0.3, 0.6}) {
        const Eigen::Vector2d sideways = place(held({0, 0, 0.5}, {0, a, 0})).tilt;
        EXPECT_NEAR(sideways.x(), -a, 0.05) << a;
        EXPECT_NEAR(sideways.y(), 0.0, 0.05) << a;
        const Eigen::Vector2d upDown = place(held({0, 0, 0.5}, {a, 0, 0})).tilt;
        EXPECT_NEAR(upDown.y(), a, 0.05) << a;
        EXPECT_NEAR(upDown.x(), 0.0, 0.05) << a;
    }
    EXPECT_LT(place(held({0.15, 0.08, 0.5}, {0, 0, 0.4})).tilt.norm(), radFromDeg(15.0))
        << "straight on; the lens's distortion looks like a tilt near the edges";
}

// Catches: a place that follows from how the corners are numbered: a chessboard may be found from either end.
TEST_F(ViewCollectorTest, TheSameBoardFromTheOtherEndIsThereAsWell) {
    const BoardView one = view(held({0.1, -0.05, 0.5}, {0.3, -0.4, 0.2}), 0.0);
    BoardView other = one;
    std::ranges::reverse(other.corners_px);
    const ViewPlace a = *placeOf(one, kChessboard, 1280, 720), b = *placeOf(other, kChessboard, 1280, 720);
    EXPECT_NEAR(a.x, b.x, 1e-9);
    EXPECT_NEAR(a.size, b.size, 1e-6);
    EXPECT_LT((a.tilt - b.tilt).norm(), 1e-6);
}

// Catches: a moving view taken (blurred, and not where the others say), or one that is still never.
TEST_F(ViewCollectorTest, OnlyStillViewsAreKept) {
    for (int k = 0; k < 60; ++k) // 1.2 px from look to look
        EXPECT_EQ(look(held({-0.05 + 0.0006 * k, 0, 0.5}, {0, 0, 0})), Look::Moving);
    EXPECT_TRUE(collector.views().empty());
    const double begin_s = time_s;
    const Pose rest = held({-0.02, 0, 0.5}, {0, 0, 0});
    while (look(rest) != Look::Kept)
        ASSERT_LT(time_s, begin_s + 1.0);
    EXPECT_GE(time_s - begin_s, 0.3);
    EXPECT_LE(time_s - begin_s, 0.4);
    EXPECT_EQ(collector.views().size(), 1U);
}

// Catches: a pause without the board counted as stillness.
TEST_F(ViewCollectorTest, AGapBeginsAnew) {
    const Pose rest = held({0, 0, 0.5}, {0, 0, 0});
    for (int k = 0; k < 8; ++k)
        EXPECT_EQ(look(rest), Look::Moving);
    collector.lookedInVain();
    for (int k = 0; k < 8; ++k)
        EXPECT_EQ(look(rest), Look::Moving) << k;
}

// Catches: the same view taken again and again; and none at another place, size or tilt.
TEST_F(ViewCollectorTest, OnlyNewViewsAreKept) {
    EXPECT_EQ(holdAt(held({0, 0, 0.5}, {0, 0.3, 0})), Look::Kept);
    EXPECT_EQ(holdAt(held({0, 0, 0.5}, {0, 0.3, 0})), Look::Known);
    EXPECT_EQ(holdAt(held({0.01, 0, 0.5}, {0, 0.32, 0})), Look::Known);
    EXPECT_EQ(holdAt(held({0.1, 0, 0.5}, {0, 0.3, 0})), Look::Kept);
    EXPECT_EQ(holdAt(held({0, 0.06, 0.5}, {0, 0.3, 0})), Look::Kept);
    EXPECT_EQ(holdAt(held({0, 0, 0.33}, {0, 0.3, 0})), Look::Kept);
    EXPECT_EQ(holdAt(held({0, 0, 0.5}, {0, -0.3, 0})), Look::Kept) << "tilted to the other side";
    collector.setUsed(0, false);
    EXPECT_EQ(holdAt(held({0, 0, 0.5}, {0, 0.3, 0})), Look::Kept) << "in place of the one left out";
    EXPECT_EQ(collector.used().size(), 5U);
    EXPECT_EQ(collector.views().back().view.name, "6");
}

// Catches: a far board, whose tilt noise turns over, taken twice where it is held.
TEST_F(ViewCollectorTest, OneViewForEachRest) {
    for (const Pose& X_CB : test::patientPoses()) {
        const std::size_t before = collector.views().size();
        for (int k = 0; k < 60; ++k)
            collector.look(view(X_CB, 0.18), time_s += 1.0 / 30.0);
        EXPECT_LE(collector.views().size(), before + 1);
    }
}

// Catches: an operator told to go where he was, or sent away before all is covered.
TEST_F(ViewCollectorTest, WhatIsMissingIsSaid) {
    EXPECT_EQ(collector.coverage().missing.size(), 8U) << "everything";
    holdAt(held({-0.22, 0, 0.5}, {0, 0, 0}));
    EXPECT_FALSE(isMissing(MessageCode::CoverageLeft));
    EXPECT_TRUE(isMissing(MessageCode::CoverageRight));
    EXPECT_TRUE(isMissing(MessageCode::CoverageTop));
    EXPECT_TRUE(isMissing(MessageCode::CoverageNearer));
    holdAt(held({0.22, 0, 0.5}, {0, 0, 0}));
    EXPECT_FALSE(isMissing(MessageCode::CoverageRight));
    EXPECT_DOUBLE_EQ(collector.coverage().x, 1.0);
    EXPECT_LT(collector.coverage().y, 0.2);
    holdAt(held({0, -0.1, 0.5}, {0, 0.4, 0}));
    holdAt(held({0, -0.1, 0.5}, {0, -0.4, 0}));
    EXPECT_FALSE(isMissing(MessageCode::CoverageTop));
    EXPECT_TRUE(isMissing(MessageCode::CoverageBottom));
    EXPECT_FALSE(isMissing(MessageCode::CoverageTiltSideways));
    EXPECT_TRUE(isMissing(MessageCode::CoverageTiltUpDown));
    EXPECT_GE(collector.coverage().tilt, 0.5);
    EXPECT_LT(collector.coverage().tilt, 0.7);
    holdAt(held({0, 0, 0.33}, {0, 0, 0}));
    EXPECT_FALSE(isMissing(MessageCode::CoverageNearer));
    EXPECT_EQ(collector.coverage().missing.back(), (Message{MessageCode::CoverageViews, {"5", "15"}}));
}

// Catches: an operator who does all that is asked and is never told that it is enough; views that are enough
// by these rules and still no good camera.
TEST_F(ViewCollectorTest, APatientOperatorIsDone) {
    std::size_t enoughAt = 0;
    for (const Pose& X_CB : test::patientPoses()) {
        EXPECT_EQ(holdAt(X_CB), Look::Kept) << collector.views().size();
        if (enoughAt == 0 && collector.coverage().missing.empty())
            enoughAt = collector.views().size();
    }
    EXPECT_EQ(enoughAt, Coverage::kEnoughViews);
    const auto camera5 = calibrateCamera(collector.used(), kChessboard, 1280, 720, 5);
    ASSERT_TRUE(camera5);
    EXPECT_NEAR(camera5->camera.fx, camera.fx, 1.5);
    EXPECT_EQ(judged(*camera5, 0.6).verdict, Verdict::Good) << describe(judged(*camera5, 0.6).reason);
}

// Catches: a heat map that is transposed, shifted, or counts what was left out.
TEST_F(ViewCollectorTest, TheHeatMapCountsTheCornersWhereTheyAre) {
    const auto total = [](const HeatMap& map) {
        int sum = 0;
        for (const int count : map.corners)
            sum += count;
        return sum;
    };
    BoardView corner = view(held({0.25, -0.12, 0.8}, {0, 0, 0}));
    ASSERT_TRUE(collector.keep(corner));
    const HeatMap map = collector.heatMap();
    EXPECT_EQ(total(map), 54);
    EXPECT_GT(map.corners[HeatMap::kColumns * 2 + 11], 0) << "upper right";
    EXPECT_EQ(map.corners[HeatMap::kColumns * 6 + 4], 0);
    collector.setUsed(0, false);
    EXPECT_EQ(total(collector.heatMap()), 0);
}

// Catches: what another board's finder left (a view under way while the setting changes), corners in a line
// and a ChArUco board's few corners taken for views.
TEST_F(ViewCollectorTest, WhatTellsNoPlaceIsUseless) {
    BoardView row = view(held({0, 0, 0.5}, {0, 0, 0}), 0.0);
    row.corners.resize(8);
    row.corners_px.resize(8);
    EXPECT_FALSE(collector.keep(row));
    EXPECT_EQ(collector.look(row, 1.0), Look::Useless);
    EXPECT_EQ(collector.look({}, 1.0), Look::Useless);
    const Board larger = *parseBoard("chessboard:11x8:0.02");
    EXPECT_FALSE(collector.keep(test::viewOf(larger, held({0, 0, 0.5}, {0, 0, 0}), camera, 0.0, random)));
    BoardView few = view(held({0, 0, 0.5}, {0, 0, 0}));
    std::erase_if(few.corners, [](int k) { return k % 9 > 1 || k / 9 > 4; });
    few.corners_px = {few.corners_px[0],  few.corners_px[1],  few.corners_px[9],  few.corners_px[10],
                      few.corners_px[18], few.corners_px[19], few.corners_px[27], few.corners_px[28],
                      few.corners_px[36], few.corners_px[37]};
    EXPECT_EQ(collector.look(few, 2.0), Look::Useless) << "10 of 54";
    EXPECT_TRUE(collector.keep(few)) << "who insists gets it";
}

// Catches: a wrong setting that goes unsaid, and one misread picture that raises an alarm.
TEST_F(ViewCollectorTest, AnotherBoardIsTold) {
    const Board other = *parseBoard("chessboard:8x6:0.025");
    collector.saw(other);
    EXPECT_FALSE(collector.otherBoard());
    collector.saw(other);
    EXPECT_EQ(collector.otherBoard(), other);
    for (int k = 0; k < 9; ++k)
        collector.saw(kChessboard);
    EXPECT_FALSE(collector.otherBoard()) << "it was changed back";
}

} // namespace
} // namespace bask
