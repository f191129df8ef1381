#pragma once
// Pictures of flat objects on a bench, as an ordinary camera takes them.

#include "engine/shape/marker.h"
#include "engine/simulation/picture_sensor.h"
#include "engine/simulation/scene_painter.h"

namespace bask {

/// The bench is the plane z = kBench_m of R. Not thread-safe. Throws std::invalid_argument for a camera
/// without size or focal lengths.
class SceneRenderer {
public:
    static constexpr double kBench_m = -0.05;

    SceneRenderer(const CameraModel& camera, const Pose& X_RC, const PictureQuality& quality);

    /// Renders a picture. `number` selects the noise: the same number gives the same picture. Faces are
    /// painted in the order of inPaintingOrder, then those of `onTop` in their order.
    GreyPicture render(std::span<const PlacedFace> faces, std::span<const PlacedFace> onTop,
                       std::uint64_t number);

private:
    ScenePainter m_painter;
    PictureSensor m_sensor;
};

} // namespace bask
