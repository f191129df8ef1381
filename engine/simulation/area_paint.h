#pragma once
// Polygons painted into a grey picture, each pixel by the exact share of it that they cover.

#include <Eigen/Core>

#include <span>
#include <vector>

namespace bask {

/// Brightness row by row, 0 to 255.
struct GreyCanvas {
    int width = 0, height = 0;
    std::vector<float> values;
};

using Ring = std::vector<Eigen::Vector2d>;

/// Closed rings in pixels (centres at whole numbers), wholly, partly or not at all within the picture. All
/// outlines go round the same way and holes the other; rings that meet edge to edge show no seam.
class AreaPainter {
public:
    void paint(GreyCanvas& canvas, std::span<const Ring> rings, float grey);

private:
    std::vector<float> m_change; ///< of the share covered, from each pixel to the next of its row
};

} // namespace bask
