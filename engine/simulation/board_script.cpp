#include "engine/simulation/board_script.h"

#include "engine/base/units.h"
#include "engine/calibration/projection.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

/// Place in the picture (-1 to 1: the sheet touches the border, almost), size as a share of the picture's
/// width or height, whichever is fuller, and turns about x, y and z.
struct BoardPose {
    double x, y, size, tiltX_deg, tiltY_deg, roll_deg;
};

constexpr std::array<BoardPose, kBoardViews> kViews{{
    {0, 0, 0.92, 0, 0, 0},           {0, 0, 0.85, 30, 0, 3},      {0, 0, 0.85, -30, 0, -4},
    {0, 0, 0.85, 0, 35, 5},          {0, 0, 0.85, 0, -35, -2},    {-1, -1, 0.68, 15, -20, 2},
    {1, -1, 0.68, 15, 20, -3},       {1, 1, 0.68, -15, 20, 4},    {-1, 1, 0.68, -15, -20, -5},
    {0, 0, 0.6, 40, 0, 0},           {0, 0, 0.6, 0, 40, 10},      {0, 0, 0.6, -25, -25, -15},
    {-1, 0, 0.75, 20, 30, 0},        {1, 0, 0.75, -20, -30, 2},   {0, -1, 0.75, -30, 10, -2},
    {0, 1, 0.75, 30, -10, 6},        {-1, -1, 0.62, -20, 25, 12}, {1, -1, 0.62, -20, -25, -12},
    {1, 1, 0.62, 25, -20, 0},        {-1, 1, 0.62, 25, 20, 8},    {-0.4, 0.2, 0.95, 12, -12, 20},
    {0.4, -0.2, 0.95, -12, 12, -20},
}};

Eigen::Vector2d sheet_m(const Board& board) {
    return board.square_m * Eigen::Vector2d(squareColumns(board), squareRows(board));
}

// The picture's share that the sheet takes.
Eigen::AlignedBox2d sheetIn(const CameraModel& camera, const Board& board, const Pose& X_CB) {
    constexpr int kSteps = 8;
    const double margin = boardMargin_m(board);
    const Eigen::Vector2d first(-margin, -margin), size = sheet_m(board) - 2.0 * first;
    const Lens lens(camera);
    Eigen::AlignedBox2d box;
    for (int k = 0; k <= kSteps; ++k)
        for (const auto& [u, v] : {std::pair(k, 0), {k, kSteps}, {0, k}, {kSteps, k}}) {
            const Eigen::Vector2d p = first + Eigen::Vector2d(u, v).cwiseProduct(size) / kSteps;
            box.extend(shownAt(lens, Eigen::Vector3d(X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0))));
        }
    return box;
}

Eigen::Matrix3d turned(const BoardPose& view, bool isAcross) {
    const auto about = [](double angle_deg, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(radFromDeg(angle_deg), axis);
    };
    return (about(view.tiltX_deg, Eigen::Vector3d::UnitX()) *
            about(view.tiltY_deg, Eigen::Vector3d::UnitY()) *
            about(view.roll_deg + (isAcross ? 90.0 : 0.0), Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

} // namespace

double boardMargin_m(const Board& board) {
    return 0.6 * board.square_m;
}

Pose scriptedBoardPose(const Board& board, const CameraModel& camera, int number) {
    const BoardPose& view = kViews[static_cast<std::size_t>(number) % kViews.size()];
    const Eigen::Vector2d sheet = sheet_m(board), picture(camera.width, camera.height);
    const bool isAcross = (sheet.x() < sheet.y()) != (picture.x() < picture.y());
    Pose X_CB = Pose::Identity();
    X_CB.linear() = turned(view, isAcross);
    const Eigen::Vector3d toMiddle = X_CB.linear() * Eigen::Vector3d(0.5 * sheet.x(), 0.5 * sheet.y(), 0.0);
    Eigen::Vector3d middle(0, 0, 3.0 * camera.fx * sheet.maxCoeff() / picture.minCoeff());
    constexpr int kSteps = 40; // towards place and size, each a part of the way: the lens bends both
    for (int k = 0; k < kSteps; ++k) {
        X_CB.translation() = middle - toMiddle;
        const Eigen::AlignedBox2d box = sheetIn(camera, board, X_CB);
        const Eigen::Vector2d free = 0.98 * (picture - box.sizes()).cwiseMax(0.0);
        const Eigen::Vector2d wanted =
            0.5 * (picture + free.cwiseProduct(Eigen::Vector2d(view.x, view.y))) - Eigen::Vector2d(0.5, 0.5);
        const Eigen::Vector2d off = wanted - box.center();
        const double size = (box.sizes().array() / picture.array()).maxCoeff() / view.size;
        middle.head<2>() += 0.7 * middle.z() * (off.array() / Eigen::Array2d(camera.fx, camera.fy)).matrix();
        middle *= std::clamp(std::pow(size, 0.7), 0.8, 1.25);
    }
    X_CB.translation() = middle - toMiddle;
    return X_CB;
}

Pose boardPoseAt(const Board& board, const CameraModel& camera, double time_s) {
    constexpr double kPeriod_s = kBoardMoving_s + kBoardStill_s;
    const double views = std::floor(std::max(time_s, 0.0) / kPeriod_s);
    const int number = static_cast<int>(std::fmod(views, kBoardViews));
    const double t = std::min((std::max(time_s, 0.0) - views * kPeriod_s) / kBoardMoving_s, 1.0);
    const Pose at = scriptedBoardPose(board, camera, number);
    if (t >= 1.0)
        return at;
    const Pose from = scriptedBoardPose(board, camera, (number + kBoardViews - 1) % kBoardViews);
    return poseBetween(from, at, t * t * (3.0 - 2.0 * t));
}

double stillTime_s(int number) {
    return (number + 1) * (kBoardMoving_s + kBoardStill_s) - 0.5 * kBoardStill_s;
}

} // namespace bask
