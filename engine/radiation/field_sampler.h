#pragma once
// View factors on a grid of poses: one to four of the six pose coordinates along axes, the others held.

#include "engine/radiation/view_factor.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>

namespace bask {

/// "m" or "rad".
const char* coordinateUnit(Coordinate coordinate);

/// Equally spaced values of one coordinate.
struct FieldAxis {
    Coordinate coordinate = kX;
    double first = 0.0; ///< m or rad
    double step = 1.0;  ///< greater than zero
    int count = 1;

    double at(int i) const { return first + step * i; }
    bool operator==(const FieldAxis&) const = default;
};

inline constexpr int kMaxAxes = 4;
inline constexpr int kMaxAxisSamples = 100'000;
inline constexpr double kMaxFieldNumbers = 1e8; ///< a sample has one, or seven with its gradient
inline constexpr double kFieldReach = 1e6;      ///< m and rad, of every coordinate, either way

/// What is sampled: the view factor, or what a function makes of it.
struct FieldQuantity {
    std::string name = "view_factor";
    std::string unit = {};
    std::function<double(double)> fromViewFactor = {}; ///< called from many threads; empty: F itself
};

struct FieldRequest {
    RadiatingContour source;
    RadiatingContour object;
    std::vector<FieldAxis> axes;
    /// Coordinates that have no axis stay here.
    Vector6d held = Vector6d::Zero();
    /// Mounting: X_SO = poseFromCoordinates(q) * X_EO. Identity: q is of the object's own centre.
    Pose X_EO = Pose::Identity();
    /// The source in R, the frame of the coordinates: X_SO = X_RS^-1 * poseFromCoordinates(q) * X_EO.
    Pose X_RS = Pose::Identity();
    /// Samples with a point of the object's outline lower than this over the source's plane (m) are left out,
    /// NaN: plates cannot go through each other, and what they would exchange there takes long.
    std::optional<double> leastHeight_m = {};
    double tolerance = 1e-9; ///< of F, absolute
    bool withGradient = false;
    FieldQuantity quantity = {};
};

/// Samples in one block, the first axis fastest: sample (i, j, ...) is values[i + axes[0].count * (j + ...)].
struct Field {
    std::vector<FieldAxis> axes;
    Vector6d held = Vector6d::Zero(); ///< as asked for; only the coordinates without an axis mean something
    std::string quantity;
    std::string unit;
    double tolerance = 0.0;
    std::vector<double> values;
    /// dF/dq by the six pose coordinates (1/m, 1/rad), six numbers a sample; empty when not asked for.
    std::vector<double> gradient;
    /// Samples where object and source overlap in one plane, or that are left out: their numbers are NaN.
    std::size_t undefinedSamples = 0;
    /// Samples whose error estimate is above the tolerance (points ran out, or rounding), and the largest
    /// estimate.
    std::size_t unreachedSamples = 0;
    double largestErrorEstimate = 0.0;
};

struct FieldRun {
    int threads = 0; ///< 0: one a core
    std::stop_token stop = {};
    /// Gets the part that is done, in (0, 1], rising, some hundred times at most; called in the thread that
    /// called sampleField, which works too.
    std::function<void(double)> progress = {};
};

/// Samples a field and returns when it is done. The numbers do not depend on the threads. Errors: axes,
/// held values or tolerance out of range (`where` says which), too many samples (before memory is taken),
/// FieldCancelled. What the caller's functions throw comes through.
Result<std::shared_ptr<const Field>> sampleField(const FieldRequest& request, const FieldRun& run = {});

} // namespace bask
