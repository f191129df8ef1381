#include "engine/exchange/target_surfaces.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kSlack = 1e-6; // of a step

FieldAxis axisOver(Coordinate coordinate, double min, double max, double step) {
    const double span = max - min;
    if (span < step)
        return {coordinate, 0.5 * (min + max) - step, step, 3};
    const double steps = std::min(std::ceil(span / step - kSlack), static_cast<double>(kMaxAxisSamples));
    return {coordinate, min, span / steps, static_cast<int>(steps) + 1};
}

/// How far an object moves from sample to sample, about.
double largestStep_m(const std::vector<FieldAxis>& axes) {
    constexpr double kArm_m = 0.1;
    double step_m = 0.0;
    for (const FieldAxis& axis : axes)
        step_m = std::max(step_m, axis.coordinate < kThetaX ? axis.step : kArm_m * axis.step);
    return step_m;
}

/// The same numbers over other positions.
std::shared_ptr<const Field> moved(Field field, const Eigen::Vector3d& by_m) {
    for (FieldAxis& axis : field.axes) {
        if (axis.coordinate >= kThetaX)
            throw std::invalid_argument("targetFields: an object's own centre has no angles");
        axis.first += by_m[axis.coordinate];
    }
    return std::make_shared<const Field>(std::move(field));
}

} // namespace

Eigen::Vector3d centreOffset(const Pose& X_EO, const Vector6d& fixed) {
    return poseFromCoordinates(fixed).linear() * X_EO.translation();
}

std::vector<FieldAxis> surfaceAxes(PoseSubset subset, const RobotLimits& limits, double step) {
    if (!(step > 0.0))
        throw std::invalid_argument("surfaceAxes: the step must be positive");
    constexpr double kRightAngle = std::numbers::pi / 2.0;
    std::vector<FieldAxis> axes;
    for (const Coordinate k : {kX, kY, kZ})
        if (subset == PoseSubset::Rotation)
            axes.push_back(axisOver(static_cast<Coordinate>(kThetaX + k), -kRightAngle, kRightAngle, step));
        else
            axes.push_back(axisOver(k, limits.lower[k], limits.upper[k], step));
    return axes;
}

Result<std::vector<std::shared_ptr<const Field>>>
targetFields(const TargetGeometry& geometry, const std::stop_token& stop, const ShareDone& done) {
    std::vector<std::shared_ptr<const Field>> fields;
    const double all = geometry.only ? 1.0 : static_cast<double>(geometry.objects.size());
    for (std::size_t i = 0; i < geometry.objects.size(); ++i) {
        if (geometry.only && i != *geometry.only)
            continue;
        const MountedContour& object = geometry.objects[i];
        FieldRequest request{geometry.source, object.contour, geometry.axes,
                             geometry.fixed,  object.X_EO,    geometry.X_RS};
        request.tolerance = geometry.tolerance;
        request.minHeight_m = geometry.clearance_m + shieldTop_m(geometry.screens, geometry.X_RS) -
                              largestStep_m(geometry.axes);
        request.isShadeRough = true;
        for (std::size_t other = 0; other < geometry.objects.size(); ++other)
            if (other != i)
                request.others.push_back(geometry.objects[other]);
        const Screens& screens = geometry.screens;
        request.others.insert(request.others.end(), screens.fixtures.begin(), screens.fixtures.end());
        request.shields = screens.shields;
        const auto before = static_cast<double>(fields.size());
        auto field = sampleField(
            request, {.stop = stop, .progress = partOf(done, before / all, (before + 1.0) / all)});
        if (!field)
            return field.error();
        fields.push_back(geometry.ofOwnCentres ? moved(**field, centreOffset(object.X_EO, geometry.fixed))
                                               : std::move(*field));
    }
    return fields;
}

std::optional<std::vector<Isosurface>> targetSurfaces(std::span<const std::shared_ptr<const Field>> fields,
                                                      std::span<const double> viewFactors,
                                                      const std::stop_token& stop) {
    if (fields.size() != viewFactors.size())
        throw std::invalid_argument("targetSurfaces: one view factor a field is needed");
    std::vector<Isosurface> surfaces;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (stop.stop_requested())
            return std::nullopt;
        surfaces.push_back(std::move(isosurfaces(*fields[i], {viewFactors[i]}).front()));
    }
    return surfaces;
}

Result<std::vector<SurfaceFrame>> targetSweep(const TargetGeometry& geometry, Coordinate coordinate,
                                              std::span<const double> values,
                                              std::span<const double> viewFactors,
                                              const std::stop_token& stop) {
    if (std::ranges::find(geometry.axes, coordinate, &FieldAxis::coordinate) != geometry.axes.end())
        throw std::invalid_argument("targetSweep: an axis is not held");
    TargetGeometry at = geometry;
    std::vector<SurfaceFrame> frames;
    for (const double value : values) {
        at.fixed[coordinate] = value;
        const auto fields = targetFields(at, stop);
        if (!fields)
            return fields.error();
        auto surfaces = targetSurfaces(*fields, viewFactors, stop);
        if (!surfaces)
            return Error(MessageCode::FieldCancelled, "");
        frames.push_back({at.fixed, *std::move(surfaces)});
    }
    return frames;
}

} // namespace bask
