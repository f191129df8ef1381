#include "engine/calibration/board.h"

#include "engine/base/message_code.h"

#include <charconv>
#include <cmath>
#include <optional>

namespace bask {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

template <class Number> std::optional<Number> numberFrom(const std::string& text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

Result<void> checkRange(double value, double min, double max, const char* unit, const std::string& where) {
    if (value >= min && value <= max)
        return {};
    return Error{MessageCode::ValueOutOfRange,
                 where,
                 {formatNumber(value), formatNumber(min), formatNumber(max), unit}};
}

Result<void> checkMarkers(const Board& board, const std::string& where) {
    if (!isMarkerDictionary(board.dictionary))
        return Error{MessageCode::ValueUnknown, where, {board.dictionary, markerDictionaries()}};
    if (!(board.marker_m > 0.0 && board.marker_m < board.square_m))
        return Error{MessageCode::MarkerNotSmaller,
                     where,
                     {formatNumber(board.marker_m), formatNumber(board.square_m)}};
    const int needed = static_cast<int>(charucoMarkers(board).size());
    const int there = markerCount({board.dictionary});
    if (needed > there)
        return Error{MessageCode::DictionaryTooSmall,
                     where,
                     {board.dictionary, std::to_string(there), std::to_string(needed)}};
    return {};
}

// The text of a length in metres without the rest of a division.
std::string length(double value_m) {
    return formatNumber(value_m, 6);
}

} // namespace

Result<Board> parseBoard(const std::string& text) {
    const Error unreadable{MessageCode::BoardUnreadable, "", {text}};
    std::vector<std::string> parts = split(text, ':');
    Board board;
    if (parts.front() == "charuco")
        board.kind = BoardKind::Charuco;
    else if (parts.front() != "chessboard")
        return unreadable;
    const bool isCharuco = board.kind == BoardKind::Charuco;
    if (isCharuco && parts.size() == 6 && parts.back() == "legacy") {
        board.isLegacy = true;
        parts.pop_back();
    }
    if (parts.size() != (isCharuco ? 5U : 3U))
        return unreadable;
    const std::vector<std::string> sides = split(parts[1], 'x');
    const auto columns = numberFrom<int>(sides.front()), rows = numberFrom<int>(sides.back());
    const auto square = numberFrom<double>(parts[2]);
    const auto marker = isCharuco ? numberFrom<double>(parts[3]) : std::optional(0.0);
    if (sides.size() != 2 || !columns || !rows || !square || !marker)
        return unreadable;
    board.columns = *columns;
    board.rows = *rows;
    board.square_m = *square;
    board.marker_m = *marker;
    for (const int side : {board.columns, board.rows})
        if (auto checked =
                checkRange(side, kMinBoardSide, kMaxBoardSide, isCharuco ? "squares" : "inner corners", text);
            !checked)
            return checked.error();
    if (auto checked = checkRange(board.square_m, kMinSquare_m, kMaxSquare_m, "m", text); !checked)
        return checked.error();
    if (isCharuco) {
        board.dictionary = parts[4];
        if (auto checked = checkMarkers(board, text); !checked)
            return checked.error();
    }
    return board;
}

std::string boardText(const Board& board) {
    const std::string sides = std::to_string(board.columns) + "x" + std::to_string(board.rows);
    if (board.kind == BoardKind::Chessboard)
        return "chessboard:" + sides + ":" + length(board.square_m);
    return "charuco:" + sides + ":" + length(board.square_m) + ":" + length(board.marker_m) + ":" +
           board.dictionary + (board.isLegacy ? ":legacy" : "");
}

int squareColumns(const Board& board) {
    return board.kind == BoardKind::Charuco ? board.columns : board.columns + 1;
}

int squareRows(const Board& board) {
    return board.kind == BoardKind::Charuco ? board.rows : board.rows + 1;
}

int cornerCount(const Board& board) {
    return (squareColumns(board) - 1) * (squareRows(board) - 1);
}

Eigen::Vector2d cornerOf(const Board& board, int corner) {
    const int columns = squareColumns(board) - 1;
    const int first = board.kind == BoardKind::Charuco ? 1 : 0;
    return board.square_m * Eigen::Vector2d(first + corner % columns, first + corner / columns);
}

std::vector<MarkerPlace> charucoMarkers(const Board& board) {
    std::vector<MarkerPlace> places;
    const int shift = board.isLegacy ? board.rows - 1 : 0;
    for (int row = 0; row < board.rows; ++row)
        for (int column = 0; column < board.columns; ++column)
            if ((row + shift + column) % 2 != 0)
                places.push_back({column, row});
    return places;
}

std::array<Eigen::Vector2d, 4> markerCorners(const Board& board, const MarkerPlace& place) {
    const double near = 0.5 * (board.square_m - board.marker_m), far = near + board.marker_m;
    const Eigen::Vector2d corner = board.square_m * Eigen::Vector2d(place.column, place.row);
    return {corner + Eigen::Vector2d(near, near), corner + Eigen::Vector2d(far, near),
            corner + Eigen::Vector2d(far, far), corner + Eigen::Vector2d(near, far)};
}

std::vector<DarkSquare> darkSquares(const Board& board) {
    std::vector<DarkSquare> squares;
    const int shift = board.kind == BoardKind::Charuco && board.isLegacy ? board.rows - 1 : 0;
    for (int row = 0; row < squareRows(board); ++row)
        for (int column = 0; column < squareColumns(board); ++column)
            if ((row + shift + column) % 2 == 0)
                squares.push_back({board.square_m * Eigen::Vector2d(column, row), board.square_m});
    if (board.kind == BoardKind::Chessboard)
        return squares;
    const std::vector<MarkerPlace> places = charucoMarkers(board);
    for (std::size_t id = 0; id < places.size(); ++id) {
        const Eigen::Vector2d corner = markerCorners(board, places[id]).front();
        for (DarkSquare cell : darkSquares({board.dictionary}, static_cast<int>(id), board.marker_m)) {
            cell.corner_m += corner;
            squares.push_back(cell);
        }
    }
    return squares;
}

std::vector<DarkSquare> darkSquares(const MarkerDictionary& dictionary, int id, double side_m) {
    const std::vector<std::string> rows = markerCells(dictionary, id);
    const double cell = side_m / static_cast<double>(rows.size());
    std::vector<DarkSquare> squares;
    for (std::size_t y = 0; y < rows.size(); ++y)
        for (std::size_t x = 0; x < rows[y].size(); ++x)
            if (rows[y][x] == '0')
                squares.push_back(
                    {cell * Eigen::Vector2d(static_cast<double>(x), static_cast<double>(y)), cell});
    return squares;
}

} // namespace bask
