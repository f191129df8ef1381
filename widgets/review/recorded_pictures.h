#pragma once
// The recorded pictures of a run's thermal camera with the objects in them.

#include "engine/model/experiment_rig.h"
#include "engine/recording/recorded_session.h"
#include "engine/thermography/face_pixels.h"
#include "engine/thermography/thermal_view.h"

#include <memory>

namespace bask {

/// Of a run that has pictures and a thermal camera. Outlines and pixels are worked out again, for the place
/// of the objects between the samples around a picture and the camera as the experiment has it; temperatures
/// are those of the sample after it.
class RecordedPictures {
public:
    explicit RecordedPictures(std::shared_ptr<RecordedSession> run);

    /// Returns the picture of a moment, and the same view again until there is another picture. Errors: those
    /// of RecordedSession, and a picture that cannot be read.
    Result<ThermalView> at(double time_s);

private:
    void addObjects(ThermalView& view, const Vector6d& q, const TraceSample& sample) const;

    std::shared_ptr<RecordedSession> m_run;
    ThermalProfile m_profile;
    PlacedThermalCamera m_camera;
    SilhouetteScene m_scene;
    PixelRays m_rays;
    std::int64_t m_number = 0; ///< of the picture in m_view
    ThermalView m_view;
};

} // namespace bask
