#pragma once
// Paints polygons into a picture; each pixel gets the exact share that they cover.

#include <Eigen/Core>

#include <span>
#include <vector>

namespace bask {

/// Brightness row by row: 0 to 255, or a radiance.
struct GreyCanvas {
    int width = 0, height = 0;
    std::vector<float> values;
};

using Ring = std::vector<Eigen::Vector2d>;

/// Paints closed rings in pixels (centres at whole numbers), which may lie partly or completely outside the
/// picture. All outlines go round in the same direction and holes in the other; rings with a common edge show
/// no seam.
class AreaPainter {
public:
    void paint(GreyCanvas& canvas, std::span<const Ring> rings, float grey);

private:
    std::vector<float> m_change; ///< change of the covered share, from each pixel to the next of its row
};

} // namespace bask
