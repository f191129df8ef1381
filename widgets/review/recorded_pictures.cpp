#include "widgets/review/recorded_pictures.h"

#include "engine/calibration/picture_outline.h"
#include "engine/thermography/face_thermometer.h"
#include "engine/thermography/frame_picture_file.h"

#include <algorithm>
#include <cmath>

namespace bask {

RecordedPictures::RecordedPictures(std::shared_ptr<RecordedSession> run)
    : m_run(std::move(run)),
      m_profile(thermalProfile(m_run->facts().experiment, m_run->facts().simulated).value()),
      m_camera(believedThermalCamera(m_run->facts().experiment, m_run->facts().simulated).value()),
      m_scene(silhouetteScene(m_run->facts().experiment)), m_rays(m_camera.lens) {}

Result<ThermalView> RecordedPictures::at(double time_s) {
    const auto recorded = m_run->thermalFrameAt(time_s);
    if (!recorded)
        return recorded.error();
    if (recorded->number == m_number)
        return m_view;
    auto frame = frameOfImage(recorded->png, m_profile, m_run->facts().path);
    if (!frame)
        return frame.error();
    const auto before = m_run->sampleAt(recorded->time_s);
    if (!before)
        return before.error();
    const auto after = m_run->sampleFrom(recorded->time_s); // read it: a picture has to be delivered
    if (!after)
        return after.error();
    m_number = recorded->number;
    m_view = {};
    m_view.cameraName = cameraName(m_profile);
    m_view.picture = std::make_shared<ThermalPicture>(std::move(frame->picture));
    m_view.time_s = recorded->time_s;
    const double between_s = after->time_s - before->time_s, since_s = recorded->time_s - before->time_s;
    const double share = between_s > 0.0 ? std::clamp(since_s / between_s, 0.0, 1.0) : 0.0;
    addObjects(m_view, before->coordinates + share * (after->coordinates - before->coordinates), *after);
    return m_view;
}

void RecordedPictures::addObjects(ThermalView& view, const Vector6d& q, const TraceSample& sample) const {
    const Pose X_RE = poseFromCoordinates(q);
    const auto placed = [&](const std::vector<MountedPlate>& plates) {
        std::vector<PlacedPlate> out;
        out.reserve(plates.size());
        for (const MountedPlate& plate : plates)
            out.push_back({plate.shape, X_RE * plate.X_EO});
        return out;
    };
    const std::vector<PlacedPlate> objects = placed(m_scene.objects);
    std::vector<PlacedPlate> screens = placed(m_scene.fixtures);
    screens.insert(screens.end(), m_scene.fixed.begin(), m_scene.fixed.end());
    std::vector<Result<FacePixels>> pixels;
    if (m_camera.X_RC)
        pixels = facePixels(m_rays, *m_camera.X_RC, objects, screens, rigPixels(m_camera.sight));
    for (std::size_t i = 0; i < objects.size(); ++i) {
        ThermalObjectView object;
        if (m_camera.X_RC)
            object.outline_px = outlineInPicture(m_rays.camera(), m_camera.X_RC->inverse() * objects[i].X_WO,
                                                 objects[i].shape);
        const CameraSample& told = sample.objects[i].camera;
        if (std::isfinite(told.T_K)) {
            object.T_K = told.T_K;
            object.uncertainty_K = told.uncertainty_K;
            object.spread_K = told.spread_K;
            if (m_camera.X_RC && pixels[i]) {
                object.pixels = pixels[i]->pixels;
                object.isPartlyOutside = !pixels[i]->isWhole;
            }
        } else if (m_camera.X_RC && !pixels[i]) {
            object.reason = pixels[i].error().message;
        }
        view.objects.push_back(std::move(object));
    }
}

} // namespace bask
