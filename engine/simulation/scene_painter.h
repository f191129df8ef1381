#pragma once
// Flat objects as a lens with distortion shows them, each pixel with the exact share of what it shows.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/projection.h"
#include "engine/simulation/area_paint.h"

#include <span>
#include <vector>

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

/// Returns (x, y) / z of what a lens shows at a pixel, from a guess, by repeated substitution.
Eigen::Vector2d rayAt(const Lens& lens, const Eigen::Vector2d& pixel, Eigen::Vector2d guess, int times);

/// Returns the camera. Throws std::invalid_argument for one without size or focal lengths.
const CameraModel& paintable(const CameraModel& camera);

/// Not thread-safe. Throws as paintable, and std::invalid_argument for a background of another size.
class ScenePainter {
public:
    ScenePainter(const CameraModel& camera, GreyCanvas background);

    /// Paints faces before the background, in the order of inPaintingOrder, then those of `onTop` in their
    /// order. The picture is valid until the next one.
    const GreyCanvas& paint(std::span<const PlacedFace> faces, std::span<const PlacedFace> onTop = {});

private:
    void paint(const PlacedFace& placed);
    std::vector<Ring> shown(const std::vector<Ring>& rings, const Pose& X_CF) const;

    Lens m_lens;
    Eigen::AlignedBox2d m_bounds; ///< of raysInPicture
    GreyCanvas m_background, m_canvas;
    AreaPainter m_painter;
};

} // namespace bask
