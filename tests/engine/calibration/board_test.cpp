// Boards as text, and what is drawn of them.

#include "engine/base/message_code.h"
#include "engine/calibration/board.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

// Catches: a setting that is read as another, or comes back as another.
TEST(Board, IsReadAsItIsWritten) {
    for (const char* text : {"chessboard:9x6:0.025", "charuco:5x7:0.04:0.02:6X6_250",
                             "charuco:6x8:0.03:0.0225:4X4_50:legacy", "charuco:5x7:0.04:0.02:DICT_6X6_250"}) {
        const auto board = parseBoard(text);
        ASSERT_TRUE(board) << describe(board.error());
        EXPECT_EQ(boardText(*board), text);
    }
    const Board board = *parseBoard("charuco:6x8:0.03:0.0225:4X4_50:legacy");
    EXPECT_EQ(board, (Board{BoardKind::Charuco, 6, 8, 0.03, 0.0225, "4X4_50", true}));
}

// Catches: a wrong setting that is taken, or refused without a reason.
TEST(Board, RefusesWhatIsNoBoard) {
    const std::pair<const char*, MessageCode> cases[] = {
        {"", MessageCode::BoardUnreadable},
        {"chess:9x6:0.025", MessageCode::BoardUnreadable},
        {"chessboard", MessageCode::BoardUnreadable},
        {"chessboard:9x6", MessageCode::BoardUnreadable},
        {"chessboard:9:0.025", MessageCode::BoardUnreadable},
        {"chessboard:9x6x2:0.025", MessageCode::BoardUnreadable},
        {"chessboard:9x6:0.025:0.02", MessageCode::BoardUnreadable},
        {"chessboard:9x6:25mm", MessageCode::BoardUnreadable},
        {"chessboard:99999999999x6:0.025", MessageCode::BoardUnreadable},
        {"chessboard:9x6:nan", MessageCode::ValueOutOfRange},
        {"chessboard:9x6:25", MessageCode::ValueOutOfRange},
        {"chessboard:9x6:-0.025", MessageCode::ValueOutOfRange},
        {"chessboard:2x6:0.025", MessageCode::ValueOutOfRange},
        {"chessboard:9x600:0.025", MessageCode::ValueOutOfRange},
        {"charuco:5x7:0.04:0.02", MessageCode::BoardUnreadable},
        {"charuco:5x7:0.04:0.02:8X8_250", MessageCode::ValueUnknown},
        {"charuco:5x7:0.04:0.04:6X6_250", MessageCode::MarkerNotSmaller},
        {"charuco:5x7:0.04:nan:6X6_250", MessageCode::MarkerNotSmaller},
        {"charuco:5x7:0.04:0.02:6X6_250:new", MessageCode::BoardUnreadable},
        {"charuco:11x10:0.04:0.02:6X6_50", MessageCode::DictionaryTooSmall},
    };
    for (const auto& [text, code] : cases) {
        const auto board = parseBoard(text);
        ASSERT_FALSE(board) << text;
        EXPECT_EQ(board.error().code(), code) << text;
    }
}

// Catches: corners numbered another way than the finder has them.
TEST(Board, NumbersCornersRowByRow) {
    const Board chess = *parseBoard("chessboard:9x6:0.025");
    EXPECT_EQ(cornerCount(chess), 54);
    EXPECT_EQ(cornerOf(chess, 10), Eigen::Vector2d(0.025, 0.025));
    const Board charuco = *parseBoard("charuco:5x7:0.04:0.02:6X6_250");
    EXPECT_EQ(cornerCount(charuco), 24);
    EXPECT_EQ(cornerOf(charuco, 5), Eigen::Vector2d(0.08, 0.08));
}

// Catches: markers on black squares. Boards of OpenCV before 4.6 differ where the rows are even: there the
// lower left square is the black one.
TEST(Board, MarkersLieOnWhiteSquares) {
    const auto first = [](const char* text) { return charucoMarkers(*parseBoard(text)).front(); };
    EXPECT_EQ(charucoMarkers(*parseBoard("charuco:5x7:0.04:0.02:6X6_250")).size(), 17U);
    EXPECT_EQ(first("charuco:5x7:0.04:0.02:6X6_250").column, 1);
    EXPECT_EQ(first("charuco:5x7:0.04:0.02:6X6_250:legacy").column, 1);
    EXPECT_EQ(first("charuco:5x8:0.04:0.02:6X6_250").column, 1);
    EXPECT_EQ(first("charuco:5x8:0.04:0.02:6X6_250:legacy").column, 0);
    for (const char* text : {"charuco:5x8:0.04:0.02:6X6_250", "charuco:5x8:0.04:0.02:6X6_250:legacy"}) {
        const Board board = *parseBoard(text);
        const auto squares = darkSquares(board);
        for (const MarkerPlace& place : charucoMarkers(board)) {
            const Eigen::Vector2d corner = 0.04 * Eigen::Vector2d(place.column, place.row);
            EXPECT_TRUE(std::ranges::none_of(squares, [&](const DarkSquare& s) {
                return s.side_m > 0.03 && (s.corner_m - corner).norm() < 1e-9;
            })) << text;
        }
    }
}

// Catches: a pattern that is not the size that it says. Black areas by counting: 35 of a chessboard's 70
// squares.
TEST(Board, IsDrawnToItsSize) {
    const auto squares = darkSquares(*parseBoard("chessboard:9x6:0.025"));
    EXPECT_EQ(squares.size(), 35U);
    EXPECT_EQ(squares.front().corner_m, Eigen::Vector2d::Zero());
    EXPECT_TRUE(squares.back().corner_m.isApprox(Eigen::Vector2d(8 * 0.025, 6 * 0.025)));
    EXPECT_DOUBLE_EQ(squares.back().side_m, 0.025);
    const auto cells = darkSquares({"6X6_250"}, 23, 0.05);
    for (const DarkSquare& cell : cells)
        EXPECT_DOUBLE_EQ(cell.side_m, 0.05 / 8);
    EXPECT_GE(cells.size(), 28U); // the border at least
}

} // namespace
} // namespace bask
