#pragma once
// The largest silhouette of a field of brightness or opacity, traced between the pixels. For .cpp files only.

#include "engine/base/result.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <vector>

namespace bask {

/// Field over the pixels, positive inside of the silhouettes and negative on the ground; `contrast` is the
/// step between the two.
struct SignedField {
    cv::Mat1f values;
    float contrast = 1.0F;
};

/// A traced ring: zero line of the field in pixels, x right and y down, pixel centres at whole numbers.
struct TracedRing {
    std::vector<Eigen::Vector2d> points_px;
    double sharpness =
        0.0; ///< share of the points where the field takes the whole step from one pixel to the next
};

/// Outer zero line of the largest 4-connected region where the field is positive (marching squares).
/// Errors: NoSilhouette (none, tiny, or less than half of all that is positive), SilhouetteAtBorder.
Result<TracedRing> traceLargest(const SignedField& field, const std::string& where);

} // namespace bask
