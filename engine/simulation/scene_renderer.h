#pragma once
// Pictures of flat things on a bench, through a lens with distortion.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/projection.h"
#include "engine/shape/marker.h"
#include "engine/simulation/area_paint.h"
#include "engine/simulation/picture_sensor.h"

namespace bask {

/// A flat thing in the xy-plane of its own frame, in metres; its front looks along +z.
struct SceneFace {
    std::vector<Ring> rings; ///< outlines counter-clockwise, holes clockwise
    float front = 0.0F, behind = 0.0F;
    std::vector<Ring> marks = {}; ///< painted on the front, as rings
    float markGrey = 0.0F;
    int layer = 0; ///< the higher covers the lower in the same plane
};

/// Where it is. The face outlives the rendering.
struct PlacedFace {
    const SceneFace* face = nullptr;
    Pose X_CF = Pose::Identity();
};

/// Faces that the camera shows, in an order in which each covers those before it as it should: by which side
/// of whose plane they are on, so that it is right for all that do not pass through one another.
std::vector<PlacedFace> inPaintingOrder(std::span<const PlacedFace> faces);

/// The bench is the plane z = kBench_m of R. One thread. Throws std::invalid_argument for a camera without
/// size or focal lengths.
class SceneRenderer {
public:
    static constexpr double kBench_m = -0.05;

    SceneRenderer(const CameraModel& camera, const Pose& X_RC, const PictureQuality& quality);

    /// `number` chooses the noise: the same again gives the same picture. Faces painted in the order of
    /// inPaintingOrder, then those `onTop` as they come.
    GreyPicture render(std::span<const PlacedFace> faces, std::span<const PlacedFace> onTop,
                       std::uint64_t number);

private:
    void paintBench(const Pose& X_RC);
    void setBounds();
    void paint(const PlacedFace& placed);
    std::vector<Ring> shown(const std::vector<Ring>& rings, const Pose& X_CF) const;

    Lens m_lens;
    Eigen::AlignedBox2d m_seen; ///< (x, y) / z of all that is in the picture, and a little more
    GreyCanvas m_bench, m_canvas;
    AreaPainter m_painter;
    PictureSensor m_sensor;
};

} // namespace bask
