#include "engine/studies/camera_sight.h"

#include "engine/thermography/face_thermometer.h"
#include "engine/thermography/usual_thermal_camera.h"

#include <algorithm>

namespace bask {
namespace {

constexpr std::size_t kToSpare = 3; // times as many pixels as are read

} // namespace

CameraSight::CameraSight(const Experiment& experiment)
    : m_X_RC(trueThermalPose(experiment)), m_scene(silhouetteScene(experiment)) {
    for (const ObjectSpec& object : experiment.objects)
        m_readBy.push_back(object.readBy);
    if (const auto profile = thermalProfile(experiment, true))
        m_rays.emplace(usualThermalLens(*profile));
}

std::vector<std::size_t> CameraSight::pixels(const Vector6d& q) const {
    std::vector<std::size_t> out(m_scene.objects.size(), 0);
    if (!m_rays)
        return out;
    const Pose X_RE = poseFromCoordinates(q);
    const auto placed = [&](const std::vector<MountedPlate>& plates) {
        std::vector<PlacedPlate> there;
        for (const MountedPlate& plate : plates)
            there.push_back({plate.shape, X_RE * plate.X_EO});
        return there;
    };
    std::vector<PlacedPlate> screens = placed(m_scene.fixtures);
    screens.insert(screens.end(), m_scene.fixed.begin(), m_scene.fixed.end());
    FacePixelOptions any = rigPixels();
    any.minPixels = 1;
    const auto seen = facePixels(*m_rays, m_X_RC, placed(m_scene.objects), screens, any);
    for (std::size_t i = 0; i < seen.size(); ++i)
        out[i] = seen[i] ? seen[i]->pixels.size() : 0;
    return out;
}

bool CameraSight::isGood(const Vector6d& q) const {
    if (std::ranges::find(m_readBy, ReadBy::Camera) == m_readBy.end())
        return true;
    const std::vector<std::size_t> seen = pixels(q);
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (m_readBy[i] == ReadBy::Camera &&
            seen[i] < kToSpare * static_cast<std::size_t>(rigPixels().minPixels))
            return false;
    return true;
}

} // namespace bask
