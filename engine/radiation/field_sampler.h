#pragma once
// View factors on a grid of poses: one to six of the pose coordinates vary along axes, the others are fixed.

#include "engine/radiation/mounted_objects.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

class PoseBatch;

/// Returns "m" or "rad".
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

/// Returns how many samples a grid of these axes has.
std::size_t sampleCount(const std::vector<FieldAxis>& axes);

inline constexpr int kMaxAxes = 6;
inline constexpr int kMaxAxisSamples = 100'000;
/// A sample has one number, or seven with its gradient: largest count of them in memory, and of a field that
/// is sampled range by range.
inline constexpr double kMaxFieldNumbers = 1e8, kMaxStoredNumbers = 5e10;
inline constexpr double kFieldReach = 1e6; ///< m and rad; largest absolute value of every coordinate

/// What is sampled: the view factor, or a function of it.
struct FieldQuantity {
    std::string name = "view_factor";
    std::string unit = {};
    /// Called from many threads; if empty, F itself is sampled.
    std::function<double(double)> fromViewFactor = {};
};

struct FieldRequest {
    RadiatingSource source;
    RadiatingContour object;
    std::vector<FieldAxis> axes;
    /// Values of the coordinates that have no axis.
    Vector6d fixed = Vector6d::Zero();
    /// Mounting: X_SO = poseFromCoordinates(q) * X_EO. With identity, q is the pose of the object's own
    /// centre.
    Pose X_EO = Pose::Identity();
    /// Pose of the source in R, the frame of the coordinates: X_SO = X_RS^-1 * poseFromCoordinates(q) * X_EO.
    Pose X_RS = Pose::Identity();
    /// If set, samples in which a point of the object's outline is lower than this above the source's plane
    /// (m) are left out (NaN), whatever the others do: plates cannot pass through each other, and view
    /// factors there take long to compute.
    std::optional<double> minHeight_m = {};
    double tolerance = 1e-9; ///< of F, absolute
    bool withGradient = false;
    FieldQuantity quantity = {};
    /// The other objects and the fixtures on the end-effector, with the object's own X_EO: those of them that
    /// may stand in its light are counted. Without such ones the field is that of the object alone, bit for
    /// bit.
    std::vector<MountedContour> others = {};
    /// Plates that stand in R; they count as the others do, at whatever height.
    std::vector<StandingContour> shields = {};
    /// Whether the shade is rough (see roughShadedViewFactor), for some ten times as many samples a second;
    /// else it is found to max(tolerance, kShadeTolerance). The error of a rough shade is not estimated.
    bool isShadeRough = false;
};

/// Samples in one block, the first axis fastest: sample (i, j, ...) is values[i + axes[0].count * (j + ...)].
struct Field {
    std::vector<FieldAxis> axes;
    Vector6d fixed = Vector6d::Zero(); ///< as requested; only the coordinates without an axis are used
    std::string quantity;
    std::string unit;
    double tolerance = 0.0; ///< as requested, or kShadeTolerance where the shade is found to that
    /// Whether others may stand in the object's light, and how much they take is known roughly only: that is
    /// not in the error estimates.
    bool isShadeRough = false;
    std::vector<double> values;
    /// dF/dq by the six pose coordinates (1/m, 1/rad), six numbers for each sample; empty if not requested.
    std::vector<double> gradient;
    /// Number of samples in which object and source overlap in one plane, or that are left out: their values
    /// are NaN.
    std::size_t undefinedSamples = 0;
    /// Number of samples whose error estimate is above the tolerance (too few points, or rounding), and the
    /// largest estimate.
    std::size_t unreachedSamples = 0;
    double largestErrorEstimate = 0.0;
};

/// What is not as usual among samples.
struct FieldTally {
    std::size_t undefined = 0; ///< as Field::undefinedSamples
    std::size_t unreached = 0; ///< and the next two
    double largestError = 0.0;

    void add(const FieldTally& more);
};

/// A field that is sampled range by range, in any order and by any process: the numbers are those of
/// sampleField.
class FieldSampler {
public:
    /// Errors: those of sampleField, but for kMaxStoredNumbers samples and not kMaxFieldNumbers.
    static Result<FieldSampler> of(FieldRequest request);
    FieldSampler(FieldSampler&&) noexcept;
    ~FieldSampler();

    /// A field without samples, and how many it will have.
    Field header() const;
    std::size_t samples() const;
    /// Writes the samples `begin` to `end` - 1 to `values`, and six numbers for each to `gradient` if it was
    /// asked for. Thread-safe.
    FieldTally sample(std::size_t begin, std::size_t end, double* values, double* gradient) const;

private:
    struct Grid;
    class Cursor;
    struct Turned;
    explicit FieldSampler(std::unique_ptr<const Grid> grid);
    static std::unique_ptr<const Turned> turned(const Grid& grid);
    void takeRow(Cursor& cursor, std::size_t count, double* values, double* errors, double* gradient) const;
    void sampleRow(const PoseBatch& batch, Cursor& cursor, std::size_t count, double* values, double* errors,
                   double* gradient) const;
    double viewFactorAt(const Cursor& cursor, double* gradient, double& error) const;
    double plainAt(const Pose& X_SO, const Cursor* cursor, double* gradient, double& error) const;
    double shadedAt(const Cursor& cursor, double* gradient, double& error) const;

    std::unique_ptr<const Grid> m_grid;
    std::unique_ptr<const Turned> m_turned; ///< null: there is no symmetry
};

struct FieldRun {
    int threads = 0; ///< 0: one for each core
    std::stop_token stop = {};
    /// Receives the part that is done, in (0, 1], ascending, at most a few hundred times. Called in the
    /// thread that called sampleField, which also computes.
    std::function<void(double)> progress = {};
};

/// Samples a field and returns when it is complete. The numbers do not depend on the number of threads.
/// Errors: axes, fixed values or tolerance out of range (`where` says which), too many samples (before memory
/// is allocated), FieldCancelled. Exceptions of the caller's functions are passed on.
Result<std::shared_ptr<const Field>> sampleField(const FieldRequest& request, const FieldRun& run = {});

} // namespace bask
