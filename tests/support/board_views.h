#pragma once
// A board moved before a true camera as a patient operator would: the poses of a good calibration, and what
// the camera shows of it.

#include "engine/calibration/board_finder.h"
#include "engine/calibration/projection.h"

#include <random>

namespace bask::test {

inline CameraModel trueCamera() {
    CameraModel camera;
    camera.width = 1280;
    camera.height = 720;
    camera.fx = 1000.0;
    camera.fy = 1003.0;
    camera.cx = 630.0;
    camera.cy = 365.0;
    camera.distortion = {-0.1, 0.05, 0.0005, -0.0003, 0.0};
    return camera;
}

/// Where a board of 0.2 x 0.125 m between its outer corners is held: all edges of the picture, near and far,
/// tilted to all sides.
inline std::vector<Pose> patientPoses() {
    struct Held {
        Eigen::Vector3d middle_m, turn_rad;
    };
    constexpr double kA = 0.6;
    const std::vector<Held> held{{{0, 0, 0.45}, {0, 0, 0}},
                                 {{-0.2, 0, 0.5}, {0, kA, 0}},
                                 {{0.2, 0, 0.5}, {0, -kA, 0.1}},
                                 {{0, -0.1, 0.5}, {kA, 0, 0}},
                                 {{0, 0.1, 0.5}, {-kA, 0, 0}},
                                 {{-0.2, -0.1, 0.5}, {-0.4, 0.4, 0}},
                                 {{0.2, -0.1, 0.5}, {-0.4, -0.4, 0}},
                                 {{-0.2, 0.1, 0.5}, {0.4, 0.4, 0}},
                                 {{0.2, 0.1, 0.5}, {0.4, -0.4, 0.2}},
                                 {{0, 0, 0.33}, {0, 0, 0.1}},
                                 {{0.02, 0, 0.35}, {kA, 0, 0}},
                                 {{-0.02, 0, 0.35}, {-kA, 0, 0}},
                                 {{0, 0, 0.35}, {0, kA, 0}},
                                 {{0, 0, 0.35}, {0, -kA, 0}},
                                 {{0, 0, 0.8}, {0.5, 0.5, 0}},
                                 {{-0.25, 0.1, 0.8}, {-0.5, 0.5, 0.8}},
                                 {{0.25, -0.1, 0.8}, {0.5, -0.5, 0.5}},
                                 {{-0.1, -0.05, 0.4}, {0.5, -0.3, 0.3}},
                                 {{0.1, 0.05, 0.4}, {-0.5, 0.3, -0.3}},
                                 {{0.1, -0.05, 0.4}, {-0.3, -0.5, 0}}};
    std::vector<Pose> poses;
    for (const Held& h : held) {
        const Pose turn = poseFromRotationVector(Eigen::Vector3d::Zero(), h.turn_rad);
        poses.push_back(
            poseFromRotationVector(h.middle_m - turn * Eigen::Vector3d(0.1, 0.0625, 0.0), h.turn_rad));
    }
    return poses;
}

/// The corners that fall into the picture, wrong by normal noise.
template <class Random>
BoardView viewOf(const Board& board, const Pose& X_CB, const CameraModel& camera, double noise_px,
                 Random& random) {
    std::normal_distribution<double> noise(0.0, noise_px);
    BoardView view;
    for (int corner = 0; corner < cornerCount(board); ++corner) {
        const Eigen::Vector2d p = cornerOf(board, corner);
        const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(p.x(), p.y(), 0.0);
        if (!isInPicture(camera, p_C))
            continue;
        view.corners.push_back(corner);
        view.corners_px.push_back(shownAt(Lens(camera), p_C) + Eigen::Vector2d(noise(random), noise(random)));
    }
    return view;
}

} // namespace bask::test
