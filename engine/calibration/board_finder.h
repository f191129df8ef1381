#pragma once
// Finds calibration boards in pictures: the positions of their corners, and whether it is the expected board.

#include "engine/base/result.h"
#include "engine/calibration/board.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// Corners of a board in a picture, subpixel (pixel centres are at whole numbers).
struct BoardView {
    std::vector<int> corners; ///< numbers as in cornerOf; a chessboard has all of them
    std::vector<Eigen::Vector2d> corners_px;
};

/// Finds the board in a picture. A chessboard must be completely visible (and is the same board with columns
/// and rows exchanged). Of a ChArUco board, six corners that are not on one line are enough, each between two
/// visible markers. Errors: BoardNotSeen, BoardCornersFew.
Result<BoardView> findBoard(const GreyPicture& picture, const Board& board, const std::string& where);

/// Returns the board that a picture shows, as far as it can be determined: the counts of a chessboard; the
/// dictionary, columns, pattern and relative marker size of a ChArUco board. Equal to `board` if that fits.
/// One picture may be misread; mostSeen uses several. The size of a square cannot be determined.
std::optional<Board> boardSeen(const GreyPicture& picture, const Board& board);

/// Returns the board that most pictures show: `board`, unless at least two pictures show another one, and
/// more than show `board`.
Board mostSeen(std::span<const Board> seen, const Board& board);

} // namespace bask
