// Boards in pictures: where their corners are, and settings that are not the board's.

#include "engine/calibration/board_finder.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/calibration_samples.h"

namespace bask {
namespace {

Board board(const std::string& text) {
    const auto parsed = parseBoard(text);
    EXPECT_TRUE(parsed) << text;
    return *parsed;
}

std::string seenIn(const std::vector<std::string>& paths, const std::string& set) {
    std::vector<Board> seen;
    for (const std::string& path : paths)
        if (const auto one = boardSeen(test::greyOf(path), board(set)))
            seen.push_back(*one);
    return boardText(mostSeen(seen, board(set)));
}

Pose tilted() {
    return poseFromRotationVector({-0.09, -0.13, 0.42}, {0.35, -0.25, 0.1});
}

// Catches: views that are not found, or not by all their corners. First and last corner as OpenCV 4.6 found
// them.
TEST(BoardFinder, FindsTheChessboards) {
    for (const std::string& path : test::chessboardViews()) {
        const auto view = findBoard(test::greyOf(path), board("chessboard:9x6:0.025"), path);
        ASSERT_TRUE(view) << describe(view.error());
        EXPECT_EQ(view->corners.size(), 54U);
    }
    const auto view =
        findBoard(test::greyOf(test::viewPath("left01.jpg")), board("chessboard:9x6:0.025"), "");
    EXPECT_LT((view->corners_px.front() - Eigen::Vector2d(244.41, 94.14)).norm(), 0.1);
    EXPECT_LT((view->corners_px.back() - Eigen::Vector2d(510.37, 266.20)).norm(), 0.1);
}

TEST(BoardFinder, FindsTheCharucoBoards) {
    const std::size_t min[] = {24, 24, 22, 24}; // by OpenCV 4.6; 4.10 finds a marker more in the third
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string path = test::charucoViews()[k];
        const auto view = findBoard(test::greyOf(path), board("charuco:5x7:0.04:0.02:6X6_250"), path);
        ASSERT_TRUE(view) << describe(view.error());
        EXPECT_GE(view->corners.size(), min[k]) << path;
    }
}

// Catches: corners beside their place or with another's number, in either pattern; drawn and seen in a
// perspective that is known.
TEST(BoardFinder, CornersLieWhereTheyAreDrawn) {
    const CameraModel camera = test::smallCamera();
    for (const char* text : {"chessboard:7x5:0.025", "charuco:5x7:0.03:0.022:4X4_50",
                             "charuco:5x6:0.03:0.022:4X4_50", "charuco:5x6:0.03:0.022:4X4_50:legacy"}) {
        const Board drawn = board(text);
        const GreyPicture picture = test::pictureOf(darkSquares(drawn), tilted(), camera);
        const auto view = findBoard(picture, drawn, text);
        ASSERT_TRUE(view) << describe(view.error());
        ASSERT_EQ(static_cast<int>(view->corners.size()), cornerCount(drawn)) << text;
        const double first = drawn.kind == BoardKind::Chessboard ? drawn.square_m : 0.0;
        const bool isTurned = drawn.kind == BoardKind::Chessboard && view->corners_px[0].x() > 320.0;
        for (std::size_t k = 0; k < view->corners.size(); ++k) {
            const int corner = isTurned ? cornerCount(drawn) - 1 - view->corners[k] : view->corners[k];
            const Eigen::Vector2d p = cornerOf(drawn, corner);
            const Eigen::Vector3d at = tilted() * Eigen::Vector3d(p.x() + first, p.y() + first, 0);
            EXPECT_LT((view->corners_px[k] - test::shown(camera, at)).norm(), 0.25) << text << " " << corner;
        }
    }
}

// Catches: a wrong setting that goes by unsaid: counts, exchanged columns and rows, dictionary, marker size,
// pattern.
TEST(BoardFinder, TellsTheBoardThatItSees) {
    auto chess = test::chessboardViews();
    chess.resize(7);
    EXPECT_EQ(seenIn(chess, "chessboard:9x6:0.025"), "chessboard:9x6:0.025");
    EXPECT_EQ(seenIn(chess, "chessboard:6x9:0.025"), "chessboard:6x9:0.025") << "the same board";
    EXPECT_EQ(seenIn(chess, "chessboard:8x6:0.025"), "chessboard:9x6:0.025")
        << "a part of it is found everywhere";
    EXPECT_EQ(seenIn(chess, "chessboard:10x7:0.025"), "chessboard:9x6:0.025");
    const auto charuco = test::charucoViews();
    for (const char* set :
         {"charuco:5x7:0.04:0.02:6X6_250", "charuco:7x5:0.04:0.02:6X6_250", "charuco:6x7:0.04:0.02:6X6_250",
          "charuco:5x5:0.04:0.02:6X6_250", "charuco:5x7:0.04:0.03:6X6_250"})
        EXPECT_EQ(seenIn(charuco, set), "charuco:5x7:0.04:0.02:6X6_250") << set;
    EXPECT_EQ(seenIn(charuco, "charuco:5x7:0.04:0.02:5X5_100"), "charuco:5x7:0.04:0.02:6X6_50")
        << "the first fifty markers of 6X6_250";
}

// Catches: a right setting doubted for one picture that is misread.
TEST(BoardFinder, OneMisreadPictureIsNoMajority) {
    const Board set = board("chessboard:9x6:0.025"), other = board("chessboard:8x6:0.025");
    EXPECT_EQ(mostSeen({}, set), set);
    EXPECT_EQ(mostSeen(std::vector{other}, set), set);
    EXPECT_EQ(mostSeen(std::vector{other, other, set, set}, set), set);
    EXPECT_EQ(mostSeen(std::vector{other, other, set}, set), other);
}

// Catches: a board of before OpenCV 4.6 taken for one of today, and the other way round.
TEST(BoardFinder, TellsThePatternOfTheBoard) {
    const std::string now = "charuco:5x6:0.03:0.022:4X4_50", before = now + ":legacy";
    for (const auto& [drawn, set] : {std::pair{now, before}, std::pair{before, now}}) {
        const GreyPicture picture = test::pictureOf(darkSquares(board(drawn)), tilted(), test::smallCamera());
        for (const std::string& text : {drawn, set}) {
            const auto seen = boardSeen(picture, board(text));
            ASSERT_TRUE(seen);
            EXPECT_EQ(boardText(*seen), drawn);
        }
    }
}

// Catches: boards where there is none, a crash on pictures smaller than a filter, and minutes spent on noise.
TEST(BoardFinder, SeesNothingInNothing) {
    const auto chess = board("chessboard:9x6:0.025"), charuco = board("charuco:5x7:0.04:0.02:6X6_250");
    for (const GreyPicture& picture :
         {test::flat(1, 1, 0), test::flat(1, 2000, 255), test::flat(3, 3, 9), test::flat(12, 12, 128),
          test::flat(640, 480, 255), test::noise(1200, 900)}) {
        EXPECT_EQ(findBoard(picture, chess, "").error().code(), MessageCode::BoardNotSeen);
        EXPECT_EQ(findBoard(picture, charuco, "").error().code(), MessageCode::BoardCornersFew);
        EXPECT_FALSE(boardSeen(picture, chess));
        EXPECT_FALSE(boardSeen(picture, charuco));
    }
}

} // namespace
} // namespace bask
