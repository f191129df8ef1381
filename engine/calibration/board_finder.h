#pragma once
// Calibration boards in pictures: where their corners are, and whether the board is the one that was set.

#include "engine/base/result.h"
#include "engine/calibration/board.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bask {

/// Corners of a board in a picture, between the pixels (pixel centres at whole numbers).
struct BoardView {
    std::vector<int> corners; ///< as cornerOf numbers them; a chessboard's are all there
    std::vector<Eigen::Vector2d> corners_px;
};

/// The board in a picture. A chessboard must be seen whole (and is the same board with columns and rows
/// exchanged); of a ChArUco board six corners that are not in one line will do, each between two seen
/// markers. Errors: BoardNotSeen, BoardCornersFew.
Result<BoardView> findBoard(const GreyPicture& picture, const Board& board, const std::string& where);

/// The board that a picture shows, as far as it tells: a chessboard's counts; a ChArUco board's dictionary,
/// columns, pattern and how large its markers are in their squares. Equal to `board` when that fits. One
/// picture may be misread: mostSeen asks several. No picture tells how large a square is.
std::optional<Board> boardSeen(const GreyPicture& picture, const Board& board);

/// The board that most pictures show: `board` unless at least two show another, and more than show this.
Board mostSeen(std::span<const Board> seen, const Board& board);

} // namespace bask
