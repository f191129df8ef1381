#pragma once
// How far surfaces of different objects keep apart.

#include "engine/exchange/isosurface.h"

#include <memory>
#include <optional>
#include <span>

namespace bask {

/// Where two surfaces come closest: points of theirs, in their coordinates.
struct SurfaceGap {
    std::size_t first = 0; ///< numbers of the surfaces
    std::size_t second = 0;
    Eigen::Vector3d from = Eigen::Vector3d::Zero(); ///< on the first
    Eigen::Vector3d to = Eigen::Vector3d::Zero();   ///< on the second

    double distance() const { return (to - from).norm(); }
};

/// The widest of the gaps between two surfaces that meet nowhere: what keeps the targets apart. Nothing when
/// every two meet (three may have no common point all the same) or are not there. Surface i is of field i;
/// all fields are over the same three axes. The ends are good to a part of the grid's step. Takes some
/// milliseconds. Throws std::invalid_argument on another number of fields than surfaces.
std::optional<SurfaceGap> widestGap(std::span<const std::shared_ptr<const Field>> fields,
                                    std::span<const Isosurface> surfaces);

} // namespace bask
