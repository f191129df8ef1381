#pragma once
// Where a thermal picture has the edge of an object, beside where its outline is expected.

#include "engine/thermography/silhouette_outline.h"
#include "engine/thermography/thermal_picture.h"

#include <vector>

namespace bask {

/// A picture's radiances over dL/dT at 300 K: blur and shares of pixels are linear in them, as they are not
/// in temperatures, and near room temperature they are in K.
struct LinearPicture {
    int width = 0, height = 0;
    std::vector<double> value_K; ///< row by row; NaN where the pixel tells nothing
    double noise_K = 0.0;        ///< of a pixel, from differences of neighbours

    double at(int column, int row) const {
        return value_K[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)];
    }
    /// Between pixel centres, bilinear; NaN outside of the picture.
    double between(const Eigen::Vector2d& p) const;
};
LinearPicture linearPicture(const ThermalPicture& picture);

/// A short piece of an object's outline, whose edge was found in the picture.
struct OutlineEdge {
    std::size_t object = 0;
    int piece = 0;                                 ///< counts along the outline
    Eigen::Vector3d p_E = Eigen::Vector3d::Zero(); ///< the middle of the piece
    Eigen::Vector2d shown_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
    double shift_px = 0.0;     ///< of the edge from the shown outline, outwards
    double deviation_px = 0.0; ///< its standard deviation by the noise of the pixels
    double contrast_K = 0.0;   ///< inside less outside
};

struct FoundEdges {
    std::vector<OutlineEdge> edges;
    int clear = 0;    ///< pieces that should be seen
    int contrast = 0; ///< of these, pieces with enough contrast
    /// Sums over the edges for a better estimate of the blur: it is too small by blurSum / blurWeight.
    double blurSum_px = 0.0, blurWeight = 0.0;
};

/// Fits to the pixels near each clear piece of 2.5 px of the outlines the profile of a blurred edge,
///   value = outside + contrast Phi((shift - c s^2 / 2 - d) / s),
/// with the pixel's distance d from the outline, outwards, and the spread s of blur and pixel (s^2 = blur^2 +
/// 1/12 px^2); c is the outline's curvature, and the term with it is by how far a blurred convex edge
/// shrinks. No pixel is used by two pieces.
FoundEdges findEdges(const LinearPicture& picture, const std::vector<ShownOutline>& outlines, double blur_px,
                     double minContrast_K);

/// How far from an outline pixels are used for its edge, px.
double edgeReach_px(double blur_px);

} // namespace bask
