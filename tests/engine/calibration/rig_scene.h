#pragma once
// Simulated scenes for rig calibration: what a camera sees of markers whose places are known.

#include "engine/base/units.h"
#include "engine/calibration/hand_eye.h"
#include "engine/calibration/marker_layout.h"
#include "engine/calibration/relative_pose.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <random>

namespace bask::test {

inline CameraModel rigCamera() {
    CameraModel camera;
    camera.width = 1280;
    camera.height = 720;
    camera.fx = camera.fy = 1000.0;
    camera.cx = 639.5;
    camera.cy = 359.5;
    camera.distortion = {-0.1, 0.03, 0.0005, -0.0003, 0.0};
    return camera;
}

inline Pose shifted(double x, double y, double z = 0.0) {
    return Pose(Eigen::Translation3d(x, y, z));
}

/// Four 50 mm markers in the corners of a square of 20 cm on the source (0 to 3); three on the end-effector
/// (10 to 12), one of them tilted.
inline MarkerLayout standardLayout() {
    MarkerLayout layout{{"4X4_50"}, {}};
    int id = 0;
    for (const auto& [x, y] : {std::pair(-0.1, 0.1), {0.1, 0.1}, {0.1, -0.1}, {-0.1, -0.1}})
        layout.markers.push_back({Part::Source, id++, 0.05, shifted(x, y)});
    const Pose tilted = poseFromRotationVector({0.0, -0.06, 0.02}, {0.5, 0.1, 0.0});
    layout.markers.push_back({Part::EndEffector, 10, 0.05, shifted(-0.05, 0.04)});
    layout.markers.push_back({Part::EndEffector, 11, 0.05, shifted(0.05, 0.04)});
    layout.markers.push_back({Part::EndEffector, 12, 0.05, tilted});
    return layout;
}

/// A part so far before the camera that faces it and is then turned about its own axes.
inline Pose facingCamera(const Eigen::Vector3d& p_CP, const Eigen::Vector3d& turn_rad) {
    return poseFromRotationVector(p_CP, {std::numbers::pi, 0, 0}) *
           poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
}

struct RigScene {
    CameraModel camera = rigCamera();
    MarkerLayout layout = standardLayout(); ///< as it is, whatever the calibration believes
    Pose X_CS = facingCamera({-0.12, 0.02, 0.62}, {0.35, 0.2, 0.1});
    Pose X_CE = facingCamera({0.17, -0.03, 0.55}, {-0.3, 0.25, -0.4});
    double corner_px = 0.2;

    Pose X_SE() const { return X_CS.inverse() * X_CE; }

    MarkerFrame frame(std::mt19937& random) const {
        std::normal_distribution<double> noise(0.0, corner_px);
        MarkerFrame frame;
        for (const PlacedMarker& marker : layout.markers) {
            const Pose& X_CP = marker.part == Part::Source ? X_CS : X_CE;
            FoundMarker found{marker.id, {}};
            const auto places = marker.corners();
            for (std::size_t k = 0; k < 4; ++k) {
                found.corners_px[k] = shown(camera, X_CP * places[k]);
                for (double& coordinate : found.corners_px[k])
                    coordinate += noise(random);
            }
            frame.push_back(found);
        }
        return frame;
    }

    std::vector<MarkerFrame> frames(int count, std::mt19937& random) const {
        std::vector<MarkerFrame> result;
        for (int k = 0; k < count; ++k)
            result.push_back(frame(random));
        return result;
    }
};

/// Squared error in units of the covariance: chi square with six degrees of freedom when that is honest.
inline double normalisedError(const Pose& estimate, const Matrix6d& covariance, const Pose& truth) {
    const Vector6d d = displacementBetween(estimate, truth);
    return d.dot(covariance.ldlt().solve(d));
}
inline constexpr double kChiSquare6At95 = 12.592;

inline bool says(const std::vector<Message>& remarks, MessageCode code, const std::string& firstArgument) {
    return std::ranges::any_of(
        remarks, [&](const Message& m) { return m.code == code && m.args.at(0) == firstArgument; });
}

} // namespace bask::test
