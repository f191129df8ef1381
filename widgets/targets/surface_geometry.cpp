#include "widgets/targets/surface_geometry.h"

#include "engine/model/experiment_rig.h"
#include "engine/model/uneven_source.h"

namespace bask {

TargetGeometry surfaceGeometry(const Experiment& experiment, PoseSubset subset, const Vector6d& fixed,
                               SurfaceGrid grid) {
    const double step = (subset == PoseSubset::Rotation ? kSurfaceStep_rad : kSurfaceStep_m) *
                        (grid == SurfaceGrid::Coarse ? 2.0 : 1.0);
    return {.source = radiatingSource(experiment),
            .X_RS = poseFromCoordinates(experiment.source.pose),
            .objects = mountedContours(experiment),
            .screens = screensOf(experiment),
            .axes = surfaceAxes(subset, experiment.robot, step),
            .fixed = fixed,
            .ofOwnCentres = subset == PoseSubset::OwnTranslation,
            .clearance_m = experiment.robot.clearance_m};
}

std::vector<double> neededViewFactors(const JointVerdict& verdict) {
    std::vector<double> viewFactors;
    for (const TargetVerdict& own : verdict.conditions1)
        viewFactors.push_back(own.neededViewFactor);
    return viewFactors;
}

std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> surfaceGap(const JointVerdict& verdict) {
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> widest;
    for (const Eigen::Vector3d& a : verdict.surfacePoints)
        for (const Eigen::Vector3d& b : verdict.surfacePoints)
            if (!widest || (a - b).norm() > (widest->first - widest->second).norm())
                widest.emplace(a, b);
    return widest;
}

bool isOtherGeometry(const Experiment& a, const Experiment& b) {
    const auto differ = [](const ObjectSpec& x, const ObjectSpec& y) {
        return x.shape != y.shape || x.mounting != y.mounting;
    };
    const auto isHeatOther = [](const Experiment& x, const Experiment& y) {
        return x.source.uneven != y.source.uneven || x.source.temperature_K != y.source.temperature_K ||
               x.source.emittance != y.source.emittance || x.source.model != y.source.model ||
               x.environment_K != y.environment_K;
    };
    const bool isUneven = !a.source.uneven.isEven() || !b.source.uneven.isEven();
    if ((isUneven && isHeatOther(a, b)) || a.source.shape != b.source.shape ||
        a.source.pose != b.source.pose || a.robot != b.robot || a.fixtures != b.fixtures ||
        a.shields != b.shields || a.objects.size() != b.objects.size())
        return true;
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        if (differ(a.objects[i], b.objects[i]))
            return true;
    return false;
}

std::vector<Coordinate> fixedCoordinates(PoseSubset subset, const RobotLimits& robot) {
    std::vector<Coordinate> fixed;
    const int first = subset == PoseSubset::Rotation ? kX : kThetaX;
    for (int k = first; k < first + 3; ++k)
        if (robot.free[static_cast<std::size_t>(k)] && robot.lower[k] < robot.upper[k])
            fixed.push_back(static_cast<Coordinate>(k));
    return fixed;
}

std::optional<Coordinate> sweptCoordinate(PoseSubset subset, const RobotLimits& robot) {
    const std::vector<Coordinate> fixed = fixedCoordinates(subset, robot);
    if (fixed.empty())
        return std::nullopt;
    return subset == PoseSubset::Rotation ? fixed.back() : fixed.front();
}

std::vector<double> sweptValues(const RobotLimits& robot, Coordinate coordinate, int count) {
    std::vector<double> values;
    const double span = robot.upper[coordinate] - robot.lower[coordinate];
    for (int i = 0; i < count; ++i)
        values.push_back(robot.lower[coordinate] + span * i / (count - 1));
    return values;
}

} // namespace bask
