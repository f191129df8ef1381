#pragma once
// Three objects over a hot plate, as the simulated thermal camera shows and reads them.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/projection.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "engine/thermography/face_thermometer.h"
#include "engine/thermography/thermal_view.h"
#include "engine/thermography/usual_thermal_camera.h"

#include <QString>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace bask::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline const std::vector<QString> kThermalNames{QStringLiteral("circle"), QStringLiteral("bunny"),
                                                QStringLiteral("hand")};

/// A closed shape with `lobes` lobes.
inline Shape lobed(double radius_m, int lobes) {
    Contour contour;
    constexpr int kPoints = 72;
    for (int k = 0; k < kPoints; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kPoints;
        const double radius = radius_m * (1.0 + 0.25 * std::cos(lobes * angle));
        contour.points_m.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return contour;
}

/// Bare metal is the last of them, which the camera refuses. `height_m`: of the camera over the source.
inline ThermalView thermalScene(double height_m = 0.5, const char* profile = "p2-pro") {
    SimulatedThermalCameraConfig config;
    config.profile = *findThermalProfile(profile);
    config.camera = usualThermalLens(config.profile);
    config.errors.gain = config.errors.offset_K = 0.0; // zeroed
    config.X_RC = lookingAt({0.0, 0.0, height_m}, Eigen::Vector3d::Zero());
    config.source.push_back({Disk{0.12}, Pose::Identity(), 0.25});
    const Shape shapes[] = {Disk{0.022}, lobed(0.032, 3), lobed(0.03, 5)};
    const double x_m[] = {0.0, -0.055, 0.055}, y_m[] = {0.05, -0.03, -0.035};
    const double T_degC[] = {40.2, 38.6, 42.1}, emittance[] = {0.9, 0.95, 0.04};
    for (int i = 0; i < 3; ++i) {
        Pose X_EO = Pose::Identity();
        X_EO.translation() << x_m[i], y_m[i], 0.0;
        config.objects.push_back({shapes[i], X_EO});
    }
    SimulatedThermalCamera camera(config);
    ThermalMoment moment;
    moment.X_RE.translation().z() = 0.12;
    moment.source_K = {kelvinFromCelsius(200.0)};
    std::vector<ReadObject> objects;
    for (std::size_t i = 0; i < 3; ++i) {
        const FaceSurroundings back{emittance[i], {}, config.environment_K};
        const FaceSurroundings front{emittance[i], {{0.4, moment.source_K[0], 0.25}}, config.environment_K};
        moment.objects.push_back({kelvinFromCelsius(T_degC[i]), front, back});
        objects.push_back({{shapes[i], moment.X_RE * config.objects[i].X_EO},
                           {front, 0.01, 0.3, {{0.01, 1.0, 0.0}}},
                           {back, 0.01, 0.3, {}}});
    }
    camera.observe(moment);
    const ThermalPicture& picture = camera.newest().value()->frame.picture;

    ThermalView view;
    view.cameraName = config.profile.name;
    view.picture = std::make_shared<ThermalPicture>(picture);
    view.time_s = 12.0;
    view.age_s = 0.04;
    const std::vector<std::optional<CameraZero>> zeros(3, CameraZero{0.0, 0.05, config.environment_K});
    const auto readings = readObjects(thermalBand(), picture, PixelRays(config.camera), config.X_RC, objects,
                                      {}, zeros, {0.01, 0.07, 0.03}, 20.0);
    for (std::size_t i = 0; i < 3; ++i) {
        ThermalObjectView object;
        const Pose X_CO = config.X_RC.inverse() * objects[i].plate.X_WO;
        for (const Eigen::Vector2d& point : shapeOutline(shapes[i], 72))
            object.outline_px.push_back(shownAt(
                Lens(config.camera), Eigen::Vector3d(X_CO * Eigen::Vector3d(point.x(), point.y(), 0.0))));
        if (readings[i]) {
            object.pixels = readings[i]->seen.pixels;
            object.T_K = readings[i]->face.T_K;
            object.uncertainty_K = readings[i]->face.standardUncertainty_K;
            if (const auto& difference = readings[i]->region.difference)
                object.spread_K = difference->value_K;
        } else {
            object.reason = readings[i].error().message;
        }
        view.objects.push_back(object);
    }
    return view;
}

} // namespace bask::test
