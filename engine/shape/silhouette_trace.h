#pragma once
// Traces the outlines of silhouettes in a picture, and of their holes, between the pixels.

#include "engine/base/result.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// A field over the pixels, row by row: positive inside the silhouettes and negative on the ground.
struct SignedField {
    int width = 0, height = 0;
    std::vector<float> values;
    float contrast = 1.0F; ///< step between inside and ground
};

/// Zero lines of a field in pixels, x right and y down, pixel centres at whole numbers.
struct Silhouettes {
    std::vector<std::vector<Eigen::Vector2d>> rings_px; ///< closed, first point not repeated; holes too
    double uncertainty_px = 0.0;                        ///< uncertainty given by the edges in the picture
    /// Number of silhouettes left out because they touch the picture's border.
    int atBorder = 0;
};

/// Traces every 4-connected region where the field is positive and every hole in one (8-connected), by
/// marching squares; regions of fewer than 64 pixels or a thousandth of the largest count as dust. In a
/// picture that is black and white only, edges are stairs known to half a pixel: they are smoothed first.
/// Errors: NoSilhouette (none, more than a hundred, or more dust than silhouette), SilhouetteAtBorder (the
/// largest touches the border, or with `leaveOutBorder` all do).
Result<Silhouettes> traceSilhouettes(const SignedField& field, bool leaveOutBorder, const std::string& where);

} // namespace bask
