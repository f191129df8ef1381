#pragma once
// A true rig before a true camera, and a robot that goes where it is sent: what the panel of a rig is shown.

#include "engine/base/clock.h"
#include "engine/calibration/projection.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/vision/vision_view.h"

#include <random>
#include <string>

namespace bask::test {

struct RigBench {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/moving-source.json").value();
    CameraModel camera = *experiment.vision.camera; ///< as it truly is
    std::vector<MarkerSpec> markers = experiment.vision.markers;
    Pose X_RC = poseFromCoordinates(*experiment.vision.cameraPose);
    Pose X_RS = Pose(Eigen::Translation3d(0.004, -0.003, 0.0));
    Vector6d robot = experiment.start;
    std::optional<Vector6d> goal;
    bool hidesEndEffector = false;
    double corner_px = 0.1;

    /// A fifteenth of a second later.
    VisionView look() {
        auto frame = std::make_shared<CameraFrame>();
        frame->number = ++m_number;
        frame->time_s = static_cast<double>(m_number) / 15.0;
        frame->caught_s = SteadyClock().now_s() - 0.04;
        frame->picture = picture;
        VisionView view;
        view.cameraName = "simulated";
        view.frame = frame;
        view.rate_Hz = 14.9;
        view.latency_s = 0.031;
        for (const MarkerSpec& marker : markers)
            if (marker.part != Part::EndEffector || !hidesEndEffector)
                view.markers.push_back(seen(marker));
        return view;
    }

    /// The robot goes on to its goal, a step of it at most.
    void move(double step = 0.02) {
        if (!goal)
            return;
        const Vector6d way = *goal - robot;
        const double far = way.cwiseAbs().maxCoeff();
        robot += far > step ? Vector6d(way * (step / far)) : way;
        if (far <= step)
            goal.reset();
    }

    GreyPicture picture{
        camera.width, camera.height,
        std::vector<std::uint8_t>(static_cast<std::size_t>(camera.width* camera.height), 120)};

private:
    ViewedMarker seen(const MarkerSpec& marker) {
        std::normal_distribution<double> noise(0.0, corner_px);
        const Pose X_RP = marker.part == Part::Source        ? X_RS
                          : marker.part == Part::EndEffector ? poseFromCoordinates(robot)
                                                             : Pose::Identity();
        ViewedMarker viewed;
        viewed.marker.id = marker.id;
        const PlacedMarker placed{marker.part, marker.id, marker.side_m, poseFromCoordinates(marker.pose)};
        const auto places = placed.corners();
        for (std::size_t k = 0; k < 4; ++k)
            viewed.marker.corners_px[k] =
                shownAt(Lens(camera), Eigen::Vector3d(X_RC.inverse() * X_RP * places[k])) +
                Eigen::Vector2d(noise(m_random), noise(m_random));
        viewed.part = marker.part;
        viewed.side_m = marker.side_m;
        viewed.poses = markerPoses(viewed.marker.corners_px, marker.side_m, camera);
        return viewed;
    }

    std::uint64_t m_number = 0;
    std::mt19937 m_random{7};
};

} // namespace bask::test
