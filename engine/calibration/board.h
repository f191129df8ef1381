#pragma once
// Calibration boards: what they look like, as one value, and how they are written on a command line.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace bask {

enum class BoardKind { Chessboard, Charuco };

/// A board's setting. Its frame: x right, y down, in metres; the origin is a chessboard's first inner corner
/// and a ChArUco board's upper left corner.
struct Board {
    BoardKind kind = BoardKind::Chessboard;
    int columns = 0, rows = 0; ///< inner corners of a chessboard, squares of a ChArUco board
    double square_m = 0.0;
    double marker_m = 0.0;  ///< ChArUco
    std::string dictionary; ///< ChArUco: name of a known one
    bool isLegacy =
        false; ///< ChArUco: the lower left square is black, not the upper left (OpenCV before 4.6)

    bool operator==(const Board&) const = default;
};

/// "chessboard:9x6:0.025" (inner corners, square in metres) or "charuco:5x7:0.04:0.02:6X6_250" (squares,
/// square and marker in metres, dictionary), with ":legacy" behind it. Errors: BoardUnreadable,
/// ValueOutOfRange, ValueUnknown, MarkerNotSmaller, DictionaryTooSmall.
Result<Board> parseBoard(const std::string& text);
std::string boardText(const Board& board);

int squareColumns(const Board& board);
int squareRows(const Board& board);
/// Inner corners, numbered row by row from the upper left.
int cornerCount(const Board& board);
Eigen::Vector2d cornerOf(const Board& board, int corner);

/// A square of a ChArUco board that has a marker in its middle; the id is its place in the list of
/// charucoMarkers.
struct MarkerPlace {
    int column = 0, row = 0;
};
std::vector<MarkerPlace> charucoMarkers(const Board& board);
/// Corners of the marker there, clockwise from the upper left.
std::array<Eigen::Vector2d, 4> markerCorners(const Board& board, const MarkerPlace& place);

/// A black square of a printed pattern: upper left corner and side, x right, y down from the pattern's upper
/// left corner.
struct DarkSquare {
    Eigen::Vector2d corner_m = Eigen::Vector2d::Zero();
    double side_m = 0.0;
};
std::vector<DarkSquare> darkSquares(const Board& board);
/// Of one marker, border included, `side_m` wide.
std::vector<DarkSquare> darkSquares(const MarkerDictionary& dictionary, int id, double side_m);

} // namespace bask
