#include "engine/calibration/view_collector.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

struct Box {
    Eigen::Vector2d min = Eigen::Vector2d::Constant(HUGE_VAL);
    Eigen::Vector2d max = Eigen::Vector2d::Constant(-HUGE_VAL);
};

Box boxOf(const BoardView& view) {
    Box box;
    for (const Eigen::Vector2d& p : view.corners_px) {
        box.min = box.min.cwiseMin(p);
        box.max = box.max.cwiseMax(p);
    }
    return box;
}

// 0 at the near edge, 1 at the far one; in the middle for what nearly fills the picture, where the margins
// tell nothing.
double placeBetween(double before, double behind, double whole) {
    constexpr double kMinRoom = 0.2;
    const double room = std::max(before + behind, kMinRoom * whole);
    return std::clamp(0.5 + 0.5 * (before - behind) / room, 0.0, 1.0);
}

/// The board's plane in the picture around the middle of the seen corners.
struct PlaneFit {
    Eigen::Matrix2d px_m;      ///< pixels by metres
    Eigen::Vector2d recession; ///< relative growth of depth by metres
};

struct Scaled {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double spread = 0.0;

    explicit Scaled(const std::vector<Eigen::Vector2d>& points) {
        for (const Eigen::Vector2d& p : points)
            middle += p / static_cast<double>(points.size());
        for (const Eigen::Vector2d& p : points)
            spread += (p - middle).norm() / static_cast<double>(points.size());
    }
    Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return (p - middle) / spread; }
};

// A homography (h00 X + h01 Y + h02) / (h20 X + h21 Y + 1) by linear least squares.
std::optional<PlaneFit> planeFit(const BoardView& view, const Board& board) {
    constexpr double kMinRank = 1e-4;
    std::vector<Eigen::Vector2d> onBoard;
    for (const int corner : view.corners)
        onBoard.push_back(cornerOf(board, corner));
    const Scaled flat(onBoard), seen(view.corners_px);
    const auto count = static_cast<Eigen::Index>(onBoard.size());
    Eigen::MatrixXd rows(2 * count, 8);
    Eigen::VectorXd values(2 * count);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Vector2d p = flat(onBoard[static_cast<std::size_t>(k)]);
        const Eigen::Vector2d q = seen(view.corners_px[static_cast<std::size_t>(k)]);
        rows.row(2 * k) << p.x(), p.y(), 1, 0, 0, 0, -q.x() * p.x(), -q.x() * p.y();
        rows.row(2 * k + 1) << 0, 0, 0, p.x(), p.y(), 1, -q.y() * p.x(), -q.y() * p.y();
        values.segment<2>(2 * k) = q;
    }
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(rows);
    solver.setThreshold(kMinRank);
    if (!rows.allFinite() || solver.rank() < 8)
        return std::nullopt;
    const Eigen::VectorXd h = solver.solve(values);
    const Eigen::Vector2d recession = h.tail<2>(), middle(h[2], h[5]);
    Eigen::Matrix2d linear;
    linear << h[0], h[1], h[3], h[4];
    linear -= middle * recession.transpose();
    return PlaneFit{linear * seen.spread / flat.spread, recession / flat.spread};
}

Eigen::Vector2d tiltOf(const PlaneFit& fit) {
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(fit.px_m, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double angle = std::acos(svd.singularValues()[1] / svd.singularValues()[0]);
    const bool isFarther = fit.recession.dot(svd.matrixV().col(1)) > 0.0;
    return (isFarther ? angle : -angle) * svd.matrixU().col(1);
}

// Mean over the corners that both show; infinite when those are less than half.
double motionBetween(const BoardView& a, const BoardView& b) {
    double sum = 0.0;
    std::size_t common = 0;
    for (std::size_t k = 0; k < a.corners.size(); ++k) {
        const auto same = std::ranges::find(b.corners, a.corners[k]);
        if (same == b.corners.end())
            continue;
        sum += (b.corners_px[static_cast<std::size_t>(same - b.corners.begin())] - a.corners_px[k]).norm();
        ++common;
    }
    return 2 * common < std::max(a.corners.size(), b.corners.size()) ? HUGE_VAL
                                                                     : sum / static_cast<double>(common);
}

struct Range {
    double min, max;

    double length() const { return max - min; }
};

template <class Value> Range rangeOf(std::span<const ViewPlace> places, Value value) {
    Range range{value(places.front()), value(places.front())};
    for (const ViewPlace& place : places) {
        range.min = std::min(range.min, value(place));
        range.max = std::max(range.max, value(place));
    }
    return range;
}

double share(double part, double whole) {
    return std::clamp(part / whole, 0.0, 1.0);
}

} // namespace

std::optional<ViewPlace> placeOf(const BoardView& view, const Board& board, int width, int height) {
    constexpr std::size_t kMinCorners = 4; // that a homography needs
    if (view.corners.size() < kMinCorners ||
        std::ranges::any_of(view.corners, [&](int k) { return k < 0 || k >= cornerCount(board); }))
        return std::nullopt;
    const auto fit = planeFit(view, board);
    if (!fit)
        return std::nullopt;
    Box box = boxOf(view);
    const Eigen::Vector2d square_px = board.square_m * fit->px_m.cwiseAbs().rowwise().sum(); // around them
    box.min = (box.min - square_px).cwiseMax(Eigen::Vector2d::Zero());
    box.max = (box.max + square_px).cwiseMin(Eigen::Vector2d(width, height));
    const int columns = squareColumns(board) - 2, rows = squareRows(board) - 2; // between the inner corners
    const double area_px =
        std::abs(fit->px_m.determinant()) * columns * rows * board.square_m * board.square_m;
    return ViewPlace{placeBetween(box.min.x(), width - box.max.x(), width),
                     placeBetween(box.min.y(), height - box.max.y(), height),
                     std::min(1.0, std::sqrt(area_px / (static_cast<double>(width) * height))), tiltOf(*fit)};
}

Coverage coverageOf(std::span<const ViewPlace> places) {
    constexpr double kPlaceRange = 0.7, kSize = 0.4;
    constexpr double kTiltRange = radFromDeg(40.0); // from one side to the other
    Coverage coverage;
    coverage.views = places.size();
    const auto want = [&](bool isMissing, MessageCode code) {
        if (isMissing)
            coverage.missing.push_back({code, {}});
    };
    const ViewPlace kNothing{0.5, 0.5, 0.0, Eigen::Vector2d::Zero()};
    const std::span<const ViewPlace> some = places.empty() ? std::span(&kNothing, 1) : places;
    const Range x = rangeOf(some, [](const ViewPlace& p) { return p.x; });
    const Range y = rangeOf(some, [](const ViewPlace& p) { return p.y; });
    const Range size = rangeOf(some, [](const ViewPlace& p) { return p.size; });
    const Range sideways = rangeOf(some, [](const ViewPlace& p) { return p.tilt.x(); });
    const Range upDown = rangeOf(some, [](const ViewPlace& p) { return p.tilt.y(); });
    coverage.x = share(x.length(), kPlaceRange);
    coverage.y = share(y.length(), kPlaceRange);
    coverage.size = share(size.max, kSize);
    const double aside = share(sideways.length(), kTiltRange), up = share(upDown.length(), kTiltRange);
    coverage.tilt = 0.5 * (aside + up);

    constexpr double kAtEdge = 0.5 * (1.0 - kPlaceRange);
    want(coverage.x < 1.0 && x.min > kAtEdge, MessageCode::CoverageLeft);
    want(coverage.x < 1.0 && x.max < 1.0 - kAtEdge, MessageCode::CoverageRight);
    want(coverage.y < 1.0 && y.min > kAtEdge, MessageCode::CoverageTop);
    want(coverage.y < 1.0 && y.max < 1.0 - kAtEdge, MessageCode::CoverageBottom);
    want(coverage.size < 1.0, MessageCode::CoverageNearer);
    want(aside < 1.0, MessageCode::CoverageTiltSideways);
    want(up < 1.0, MessageCode::CoverageTiltUpDown);
    if (coverage.views < Coverage::kEnoughViews)
        coverage.missing.push_back(
            {MessageCode::CoverageViews,
             {std::to_string(coverage.views), std::to_string(Coverage::kEnoughViews)}});
    return coverage;
}

void HeatMap::add(const BoardView& view, int width, int height) {
    for (const Eigen::Vector2d& p : view.corners_px) {
        const int column = std::clamp(static_cast<int>((p.x() + 0.5) * kColumns / width), 0, kColumns - 1);
        const int row = std::clamp(static_cast<int>((p.y() + 0.5) * kRows / height), 0, kRows - 1);
        ++corners[static_cast<std::size_t>(row * kColumns + column)];
    }
}

ViewCollector::ViewCollector(Board board, int width, int height)
    : m_board(std::move(board)), m_width(width), m_height(height) {}

ViewCollector::Look ViewCollector::look(const BoardView& view, double time_s) {
    constexpr double kStill_px = 0.5, kStill_s = 0.3;
    constexpr std::size_t kMinShare = 4; // of a board's corners a fourth, or a view tells little
    const auto place = placeOf(view, m_board, m_width, m_height);
    if (!place || kMinShare * view.corners.size() < static_cast<std::size_t>(cornerCount(m_board))) {
        lookedInVain();
        return Look::Useless;
    }
    const bool isStill = m_last && motionBetween(m_last->view, view) < kStill_px;
    m_last = isStill ? LastLook{view, m_last->still_s, m_last->isTaken} : LastLook{view, time_s};
    // A far board's tilt may seem to change sides while it keeps still.
    if (m_last->isTaken || isKnown(*place))
        return Look::Known;
    if (time_s - m_last->still_s < kStill_s)
        return Look::Moving;
    m_last->isTaken = true;
    add(view, *place);
    return Look::Kept;
}

bool ViewCollector::keep(const BoardView& view) {
    const auto place = placeOf(view, m_board, m_width, m_height);
    if (place)
        add(view, *place);
    return place.has_value();
}

void ViewCollector::add(const BoardView& view, const ViewPlace& place) {
    m_views.push_back({{std::to_string(m_views.size() + 1), view}, place});
}

// By the sum of the differences, like camera_calibration of ROS.
bool ViewCollector::isKnown(const ViewPlace& place) const {
    constexpr double kNew = 0.15, kFullTilt = radFromDeg(45.0);
    return std::ranges::any_of(m_views, [&](const KeptView& kept) {
        const ViewPlace& other = kept.place;
        return kept.isUsed && std::abs(place.x - other.x) + std::abs(place.y - other.y) +
                                      std::abs(place.size - other.size) +
                                      (place.tilt - other.tilt).lpNorm<1>() / kFullTilt <
                                  kNew;
    });
}

std::vector<CalibrationView> ViewCollector::used() const {
    std::vector<CalibrationView> views;
    for (const KeptView& kept : m_views)
        if (kept.isUsed)
            views.push_back(kept.view);
    return views;
}

Coverage ViewCollector::coverage() const {
    std::vector<ViewPlace> places;
    for (const KeptView& kept : m_views)
        if (kept.isUsed)
            places.push_back(kept.place);
    return coverageOf(places);
}

HeatMap ViewCollector::heatMap() const {
    HeatMap map;
    for (const KeptView& kept : m_views)
        if (kept.isUsed)
            map.add(kept.view.board, m_width, m_height);
    return map;
}

void ViewCollector::saw(const Board& board) {
    constexpr std::size_t kLastSeen = 9;
    m_seen.push_back(board);
    if (m_seen.size() > kLastSeen)
        m_seen.pop_front();
}

std::optional<Board> ViewCollector::otherBoard() const {
    const std::vector<Board> seen(m_seen.begin(), m_seen.end());
    const Board seenBoard = mostSeen(seen, m_board);
    return seenBoard == m_board ? std::nullopt : std::optional(seenBoard);
}

} // namespace bask
