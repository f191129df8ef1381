#pragma once
// Calibration boards: their layout as one value, and their spelling on a command line.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace bask {

enum class BoardKind { Chessboard, Charuco };

/// Valid ranges: of columns and rows, and of a square's side.
inline constexpr int kMinBoardSide = 3, kMaxBoardSide = 50;
inline constexpr double kMinSquare_m = 1e-3, kMaxSquare_m = 1.0;

/// A board's layout. Its frame has x right and y down, in metres; the origin is the first inner corner of a
/// chessboard and the upper left corner of a ChArUco board.
struct Board {
    BoardKind kind = BoardKind::Chessboard;
    int columns = 0, rows = 0; ///< inner corners of a chessboard, squares of a ChArUco board
    double square_m = 0.0;
    double marker_m = 0.0;  ///< ChArUco only
    std::string dictionary; ///< ChArUco only: name of a known dictionary
    bool isLegacy =
        false; ///< ChArUco: the lower left square is black, not the upper left (OpenCV before 4.6)

    bool operator==(const Board&) const = default;
};

/// Parses "chessboard:9x6:0.025" (inner corners, square in metres) or "charuco:5x7:0.04:0.02:6X6_250"
/// (squares, square and marker in metres, dictionary), optionally followed by ":legacy". Errors:
/// BoardUnreadable, ValueOutOfRange, ValueUnknown, MarkerNotSmaller, DictionaryTooSmall.
Result<Board> parseBoard(const std::string& text);
std::string boardText(const Board& board);

int squareColumns(const Board& board);
int squareRows(const Board& board);
/// Returns the number of inner corners; they are numbered row by row from the upper left.
int cornerCount(const Board& board);
Eigen::Vector2d cornerOf(const Board& board, int corner);

/// A square of a ChArUco board with a marker in its middle; the marker's id is its index in charucoMarkers.
struct MarkerPlace {
    int column = 0, row = 0;
};
std::vector<MarkerPlace> charucoMarkers(const Board& board);
/// Returns the corners of the marker there, clockwise from the upper left.
std::array<Eigen::Vector2d, 4> markerCorners(const Board& board, const MarkerPlace& place);

/// A black square of a printed pattern: upper left corner and side; x right, y down from the pattern's upper
/// left corner.
struct DarkSquare {
    Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();
    double side_m = 0.0;
};
std::vector<DarkSquare> darkSquares(const Board& board);
/// Returns the black squares of one marker, border included, `side_m` wide.
std::vector<DarkSquare> darkSquares(const MarkerDictionary& dictionary, int id, double side_m);

} // namespace bask
