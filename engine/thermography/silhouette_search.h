#pragma once
// Brings a rough pose of a thermal camera so near that the edges of the objects can be told.

#include "engine/base/share_done.h"
#include "engine/thermography/silhouette_edges.h"

#include <span>
#include <vector>

namespace bask {

/// A picture and where the end-effector was when it was taken.
struct LinearView {
    LinearPicture picture;
    Pose X_RE = Pose::Identity();
};

/// How far a rough pose may be off.
struct StartUncertainty {
    double position_m = 0.06;
    double angle_rad = 0.105;
};

/// Returns the likeliest poses, most likely first, at most four: those where the inside of the outlines is of
/// one temperature and what is close outside differs by `minContrast_K`. Turns of the camera are tried on a
/// grid, since they move a picture nearly as displacements do; then all six coordinates are fitted to the
/// half-level points along the outlines' normals, within smaller and smaller distances. `done` is told the
/// share.
std::vector<Pose> likelyPoses(const SilhouetteOutlines& outlines, std::span<const LinearView> views,
                              const Pose& start, const StartUncertainty& uncertainty, double minContrast_K,
                              const ShareDone& done = {});

/// Fits the pose to the half-level points within `reach_px` of the outlines, which it halves twice.
Pose roughlyFitted(const SilhouetteOutlines& outlines, std::span<const LinearView> views, const Pose& start,
                   const StartUncertainty& uncertainty, double reach_px, double minContrast_K);

} // namespace bask
