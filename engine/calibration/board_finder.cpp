#include "engine/calibration/board_finder.h"

#include "engine/base/message_code.h"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace bask {
namespace {

using Points = std::vector<cv::Point2f>;

cv::Mat1b imageOf(const GreyPicture& picture) {
    return {picture.height, picture.width, const_cast<std::uint8_t*>(picture.values.data())};
}

cv::Point2f pointOf(const Eigen::Vector2d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

double distance(const cv::Point2f& a, const cv::Point2f& b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

// The picture at most so large: chessboards are looked for in seconds then, and refined in the whole one.
struct Reduced {
    cv::Mat1b image;
    double factor = 1.0; // of its lengths

    explicit Reduced(const cv::Mat1b& whole) : image(whole) {
        constexpr double kMaxPixels = 1.5e6;
        factor = std::min(1.0, std::sqrt(kMaxPixels / static_cast<double>(whole.total())));
        if (factor < 1.0)
            cv::resize(whole, image, {}, factor, factor, cv::INTER_AREA);
    }

    cv::Point2f inWhole(const cv::Point2f& p) const {
        return {static_cast<float>((p.x + 0.5) / factor - 0.5),
                static_cast<float>((p.y + 0.5) / factor - 0.5)};
    }
};

void refine(const cv::Mat1b& image, Points& corners, double reach_px) {
    const int half = std::clamp(static_cast<int>(reach_px), 2, 11);
    if (std::min(image.cols, image.rows) < 2 * half + 5) // OpenCV asks for that
        return;
    const cv::TermCriteria criteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 50, 1e-3);
    cv::cornerSubPix(image, corners, cv::Size(half, half), cv::Size(-1, -1), criteria);
}

double minSpacing(const Points& corners, int columns) {
    double min = HUGE_VAL;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if ((k + 1) % static_cast<std::size_t>(columns) != 0)
            min = std::min(min, distance(corners[k], corners[k + 1]));
        if (k + static_cast<std::size_t>(columns) < corners.size())
            min = std::min(min, distance(corners[k], corners[k + static_cast<std::size_t>(columns)]));
    }
    return min;
}

std::optional<Points> chessboardCorners(const cv::Mat1b& image, const Board& board) {
    const Reduced reduced(image);
    const cv::Size size(board.columns, board.rows);
    Points corners;
    // Without the fast check noise takes minutes; what it wrongly rejects is left to the second way.
    if (!cv::findChessboardCorners(reduced.image, size, corners,
                                   cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE |
                                       cv::CALIB_CB_FAST_CHECK) &&
        !cv::findChessboardCornersSB(reduced.image, size, corners, cv::CALIB_CB_NORMALIZE_IMAGE))
        return std::nullopt;
    for (cv::Point2f& corner : corners)
        corner = reduced.inWhole(corner);
    refine(image, corners, 0.4 * minSpacing(corners, board.columns)); // a larger window meets the next corner
    return corners;
}

/// Markers by their id, without those that are seen twice.
std::map<int, FoundMarker> markersById(const std::vector<FoundMarker>& markers) {
    std::map<int, FoundMarker> byId;
    std::map<int, int> times;
    for (const FoundMarker& marker : markers) {
        byId.emplace(marker.id, marker);
        ++times[marker.id];
    }
    std::erase_if(byId, [&](const auto& entry) { return times[entry.first] > 1; });
    return byId;
}

// Where the corner between two diagonal squares is, by the markers in them, and how far the nearest marker.
struct Between {
    cv::Point2f corner;
    double gap_px = 0.0;
};

std::optional<Between> between(const Board& board, const Eigen::Vector2d& corner_m,
                               const std::array<std::pair<MarkerPlace, const FoundMarker*>, 2>& neighbours) {
    Points plane, seen;
    for (const auto& [place, marker] : neighbours) {
        const auto corners_m = markerCorners(board, place);
        for (std::size_t k = 0; k < 4; ++k) {
            plane.push_back(pointOf((corners_m[k] - corner_m) / board.square_m));
            seen.push_back(pointOf(marker->corners_px[k]));
        }
    }
    const cv::Mat toPicture = cv::findHomography(plane, seen);
    if (toPicture.empty())
        return std::nullopt;
    Points at;
    cv::perspectiveTransform(Points{{0.0F, 0.0F}}, at, toPicture);
    Between result{at.front(), HUGE_VAL};
    for (const cv::Point2f& p : seen)
        result.gap_px = std::min(result.gap_px, distance(result.corner, p));
    return std::isfinite(at.front().x + at.front().y) ? std::optional(result) : std::nullopt;
}

BoardView charucoView(const cv::Mat1b& image, const std::vector<FoundMarker>& found, const Board& board) {
    const std::map<int, FoundMarker> markers = markersById(found);
    std::map<std::pair<int, int>, std::pair<MarkerPlace, const FoundMarker*>> bySquare;
    const std::vector<MarkerPlace> places = charucoMarkers(board);
    for (const auto& [id, marker] : markers)
        if (id < static_cast<int>(places.size())) {
            const MarkerPlace& place = places[static_cast<std::size_t>(id)];
            bySquare[{place.column, place.row}] = {place, &marker};
        }
    BoardView view;
    for (int k = 0; k < cornerCount(board); ++k) {
        const int column = k % (board.columns - 1), row = k / (board.columns - 1); // of the upper left square
        const bool isFalling = bySquare.contains({column, row}); // the diagonal that has the markers
        const auto first = bySquare.find({column + (isFalling ? 0 : 1), row});
        const auto second = bySquare.find({column + (isFalling ? 1 : 0), row + 1});
        if (first == bySquare.end() || second == bySquare.end())
            continue;
        const auto at = between(board, cornerOf(board, k), {first->second, second->second});
        if (!at || !cv::Rect2f(0, 0, static_cast<float>(image.cols), static_cast<float>(image.rows))
                        .contains(at->corner))
            continue;
        Points corner{at->corner};
        refine(image, corner, 0.9 * at->gap_px / std::sqrt(2.0));
        view.corners.push_back(k);
        view.corners_px.emplace_back(corner.front().x, corner.front().y);
    }
    return view;
}

bool isInOneLine(const BoardView& view, const Board& board) {
    const int columns = squareColumns(board) - 1;
    const auto alike = [&](auto place) {
        return std::ranges::all_of(view.corners, [&](int k) { return place(k) == place(view.corners[0]); });
    };
    return view.corners.empty() || alike([&](int k) { return k % columns; }) ||
           alike([&](int k) { return k / columns; }) ||
           alike([&](int k) { return k % columns + k / columns; }) ||
           alike([&](int k) { return k % columns - k / columns; });
}

Result<BoardView> findIn(const GreyPicture& picture, const Board& board, const std::string& where) {
    constexpr std::size_t kMinCorners = 6;
    const cv::Mat1b image = imageOf(picture);
    BoardView view;
    if (board.kind == BoardKind::Charuco) {
        view = charucoView(image, findMarkers(picture, {board.dictionary}), board);
        if (view.corners.size() < kMinCorners || isInOneLine(view, board))
            return Error{MessageCode::BoardCornersFew,
                         where,
                         {std::to_string(view.corners.size()), std::to_string(kMinCorners)}};
        return view;
    }
    const auto corners = chessboardCorners(image, board);
    if (!corners)
        return Error{MessageCode::BoardNotSeen,
                     where,
                     {std::to_string(board.columns) + " x " + std::to_string(board.rows)}};
    for (std::size_t k = 0; k < corners->size(); ++k) {
        view.corners.push_back(static_cast<int>(k));
        view.corners_px.emplace_back((*corners)[k].x, (*corners)[k].y);
    }
    return view;
}

// -- which board it is -----------------------------------------------------------------------------------

std::optional<Board> chessboardSeen(const cv::Mat1b& image, Board board) {
    const Reduced reduced(image);
    Points corners;
    cv::Mat meta; // one element a corner
    if (!cv::findChessboardCornersSB(
            reduced.image, cv::Size(3, 3), corners,
            cv::CALIB_CB_LARGER | cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_NORMALIZE_IMAGE, meta))
        return std::nullopt;
    const auto [less, more] = std::minmax(meta.cols, meta.rows);
    if (less == std::min(board.columns, board.rows) && more == std::max(board.columns, board.rows))
        return board;
    if (less == 3) // what was asked for at least: a few corners of a board, or of noise
        return std::nullopt;
    board.columns = more;
    board.rows = less;
    return board;
}

// How the markers lie on a board, judged by their middles.
struct Fit {
    double error = HUGE_VAL; // that four fifths keep below, in squares
    double marker = 0.0;     // mean side, in squares
};

Fit fitOf(const Board& board, const std::map<int, FoundMarker>& markers) {
    const std::vector<MarkerPlace> places = charucoMarkers(board);
    Points plane, seen;
    for (const auto& [id, marker] : markers) {
        if (id >= static_cast<int>(places.size()))
            return {};
        const MarkerPlace& place = places[static_cast<std::size_t>(id)];
        const auto& c = marker.corners_px;
        const Eigen::Vector2d a = c[2] - c[0], b = c[3] - c[1], d = c[1] - c[0];
        const double t = (d.x() * b.y() - d.y() * b.x()) / (a.x() * b.y() - a.y() * b.x());
        seen.push_back(pointOf(c[0] + t * a)); // where the diagonals meet: the middle in any perspective
        plane.emplace_back(static_cast<float>(place.column) + 0.5F, static_cast<float>(place.row) + 0.5F);
    }
    const cv::Mat toPlane = cv::findHomography(seen, plane, cv::LMEDS);
    if (toPlane.empty())
        return {};
    Points fitted;
    cv::perspectiveTransform(seen, fitted, toPlane);
    std::vector<double> errors;
    for (std::size_t k = 0; k < seen.size(); ++k)
        errors.push_back(distance(fitted[k], plane[k]));
    Fit fit;
    double turned = 0.0; // twice the markers' area there: below zero when they would be mirror images
    for (const auto& [id, marker] : markers) {
        Points corners, flat;
        for (const Eigen::Vector2d& corner : marker.corners_px)
            corners.push_back(pointOf(corner));
        cv::perspectiveTransform(corners, flat, toPlane);
        turned += cv::contourArea(flat, true);
        fit.marker += cv::arcLength(flat, true) / 4.0 / static_cast<double>(markers.size());
    }
    std::ranges::sort(errors);
    if (turned > 0.0)
        fit.error = errors[errors.size() * 4 / 5];
    return fit;
}

// The known dictionary that finds most markers, the smallest of such.
std::string bestDictionary(const GreyPicture& picture, const std::string& set) {
    constexpr std::size_t kMinMarkers = 4;
    std::size_t max = std::max(findMarkers(picture, {set}).size(), kMinMarkers - 1);
    std::string best = set;
    for (const char* sides : {"4X4_", "5X5_", "6X6_", "7X7_"})
        for (const char* count : {"50", "100", "250", "1000"})
            if (const auto found = findMarkers(picture, {std::string(sides) + count}); found.size() > max) {
                max = found.size();
                best = std::string(sides) + count;
            }
    return findMarkers(picture, {"ARUCO_ORIGINAL"}).size() > max ? "ARUCO_ORIGINAL" : best;
}

std::optional<Board> charucoSeen(const GreyPicture& picture, Board board) {
    constexpr std::size_t kEnoughMarkers = 6;
    constexpr double kGoodError = 0.15, kMarkerTolerance = 0.08;
    std::map<int, FoundMarker> markers = markersById(findMarkers(picture, {board.dictionary}));
    if (markers.size() < kEnoughMarkers) {
        board.dictionary = bestDictionary(picture, board.dictionary);
        markers = markersById(findMarkers(picture, {board.dictionary}));
    }
    if (markers.size() < kEnoughMarkers)
        return std::nullopt;
    Fit fit = fitOf(board, markers);
    if (!(fit.error < kGoodError)) {
        const Board set = board;
        for (int columns = 3; columns <= 20; ++columns)
            for (const bool isLegacy : {false, true}) {
                Board other = set;
                other.columns = columns;
                other.rows = columns == set.rows ? set.columns : set.rows;
                other.isLegacy = isLegacy;
                while (static_cast<int>(charucoMarkers(other).size()) <= markers.rbegin()->first)
                    other.rows += isLegacy ? 2 : 1; // the pattern stays
                if (const Fit better = fitOf(other, markers); better.error < fit.error) {
                    fit = better;
                    board = other;
                }
            }
    }
    if (!(fit.error < kGoodError))
        return std::nullopt;
    if (std::abs(fit.marker * board.square_m / board.marker_m - 1.0) > kMarkerTolerance)
        board.marker_m = std::round(fit.marker * 50.0) / 50.0 * board.square_m;
    return board;
}

} // namespace

Result<BoardView> findBoard(const GreyPicture& picture, const Board& board, const std::string& where) {
    try {
        return findIn(picture, board, where);
    } catch (const cv::Exception&) { // of pictures too small for its filters
        return Error{MessageCode::BoardNotSeen,
                     where,
                     {std::to_string(board.columns) + " x " + std::to_string(board.rows)}};
    }
}

std::optional<Board> boardSeen(const GreyPicture& picture, const Board& board) {
    try {
        return board.kind == BoardKind::Charuco ? charucoSeen(picture, board)
                                                : chessboardSeen(imageOf(picture), board);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
}

Board mostSeen(std::span<const Board> seen, const Board& board) {
    Board chosen = board;
    std::ptrdiff_t count = std::max<std::ptrdiff_t>(std::ranges::count(seen, board), 1);
    for (const Board& other : seen)
        if (const auto more = std::ranges::count(seen, other); more > count) {
            chosen = other;
            count = more;
        }
    return chosen;
}

} // namespace bask
