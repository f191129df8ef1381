#include "engine/thermography/usual_thermal_camera.h"

#include <cmath>

namespace bask {

CameraModel usualThermalLens(const ThermalProfile& profile) {
    constexpr double kAngle_rad = radFromDeg(57.0);
    CameraModel camera;
    camera.width = profile.width;
    camera.height = profile.height;
    camera.fx = camera.fy = 0.5 * profile.width / std::tan(0.5 * kAngle_rad);
    camera.cx = 0.5 * (profile.width - 1);
    camera.cy = 0.5 * (profile.height - 1);
    return camera;
}

Pose usualThermalPose() {
    Pose X_RC = Pose::Identity();
    X_RC.linear() = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
    X_RC.translation().z() = 1.1;
    return X_RC;
}

} // namespace bask
