#pragma once
// What a simulated thermal camera can truly read, for the studies: to draw rigs that it reads, and to judge
// what is told of those that it does not.

#include "engine/model/experiment_rig.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace bask {

class CameraSight {
public:
    explicit CameraSight(const Experiment& experiment);

    /// Returns how many pixels show nothing but the object, with the end-effector there; without a thermal
    /// camera none.
    std::vector<std::size_t> pixels(const Vector6d& q) const;
    /// Returns whether all objects that only the camera reads have pixels to spare.
    bool isGood(const Vector6d& q) const;

private:
    std::vector<ReadBy> m_readBy;
    std::optional<PixelRays> m_rays; ///< empty without a camera
    Pose m_X_RC = Pose::Identity();
    SilhouetteScene m_scene;
};

} // namespace bask
