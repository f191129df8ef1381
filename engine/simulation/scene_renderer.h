#pragma once
// Pictures of flat objects on a bench, through a lens with distortion.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/projection.h"
#include "engine/shape/marker.h"
#include "engine/simulation/area_paint.h"
#include "engine/simulation/picture_sensor.h"

namespace bask {

/// A flat object in the xy-plane of its own frame, in metres; its front is towards +z.
struct SceneFace {
    std::vector<Ring> rings; ///< outlines counter-clockwise, holes clockwise
    float front = 0.0F, behind = 0.0F;
    std::vector<Ring> marks = {}; ///< painted on the front, as rings
    float markGrey = 0.0F;
    int layer = 0; ///< in the same plane a higher layer covers a lower one
};

/// A face with its pose. The face must outlive the rendering.
struct PlacedFace {
    const SceneFace* face = nullptr;
    Pose X_CF = Pose::Identity();
};

/// Returns the faces that the camera shows, sorted so that each one covers the earlier ones correctly. The
/// order depends on which side of each other's planes they are, and is correct for all faces that do not pass
/// through one another.
std::vector<PlacedFace> inPaintingOrder(std::span<const PlacedFace> faces);

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
    void paintBench(const Pose& X_RC);
    void setBounds();
    void paint(const PlacedFace& placed);
    std::vector<Ring> shown(const std::vector<Ring>& rings, const Pose& X_CF) const;

    Lens m_lens;
    Eigen::AlignedBox2d m_seen; ///< (x, y) / z of everything in the picture, with a small margin
    GreyCanvas m_bench, m_canvas;
    AreaPainter m_painter;
    PictureSensor m_sensor;
};

} // namespace bask
