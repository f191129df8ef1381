#include "widgets/scene/scene_frame.h"

#include "widgets/common/theme.h"

namespace bask {

namespace {

constexpr int kLabelOutline = 24;

} // namespace

std::vector<Eigen::Vector3d> labelOutline(const Shape& shape) {
    std::vector<Eigen::Vector3d> points;
    for (const Eigen::Vector2d& p : shapeOutline(shape, kLabelOutline))
        points.emplace_back(p.x(), p.y(), 0.0);
    return points;
}

Box frameOf(const Experiment& experiment) {
    Box box(experiment.robot.lower.head<3>().eval());
    box.extend(experiment.robot.upper.head<3>().eval());
    TimeTable<Vector6d> places = experiment.simulation.sourceMotion;
    places.push_back({0.0, experiment.source.pose});
    for (const auto& [time_s, place] : places)
        for (const Eigen::Vector2d& p : shapeOutline(experiment.source.shape, kOutlinePoints))
            box.extend(poseFromCoordinates(place) * Eigen::Vector3d(p.x(), p.y(), 0.0));
    // A plane or a line is no box: give it some height.
    const double min = 0.1 * box.diagonal().norm();
    for (int axis = 0; axis < 3; ++axis)
        if (box.sizes()[axis] < min)
            box.extend(Eigen::Vector3d(box.max() + min * Eigen::Vector3d::Unit(axis)));
    return box;
}

SceneColours sceneColours(const QPalette& palette) {
    const QColor ground = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    return {isDark(palette), ground, mixed(text, ground, 0.10), mixed(text, ground, 0.34),
            mixed(text, ground, 0.5)};
}

} // namespace bask
