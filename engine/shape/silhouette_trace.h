#pragma once
// Outlines of the silhouettes in a picture and of the holes in them, between the pixels.

#include "engine/base/result.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Field over the pixels, row by row: positive inside of the silhouettes and negative on the ground.
struct SignedField {
    int width = 0, height = 0;
    std::vector<float> values;
    float contrast = 1.0F; ///< step between the two
};

/// Zero lines of a field in pixels, x right and y down, pixel centres at whole numbers.
struct Silhouettes {
    std::vector<std::vector<Eigen::Vector2d>> rings_px; ///< closed, first point not repeated; holes too
    double uncertainty_px = 0.0;                        ///< what the edges in the picture tell
    int atBorder = 0; ///< silhouettes left out since they touch the picture's border
};

/// Every 4-connected region where the field is positive and every hole in one (8-connected), by marching
/// squares; those of fewer than 64 pixels or a thousandth of the largest count as dust. Where a picture is
/// black and white only, its edges are stairs that are known to half a pixel: they are smoothed first.
/// Errors: NoSilhouette (none, more than a hundred, or more dust than silhouette), SilhouetteAtBorder (the
/// largest touches it, or with `leaveOutBorder` all do).
Result<Silhouettes> traceSilhouettes(const SignedField& field, bool leaveOutBorder, const std::string& where);

} // namespace bask
