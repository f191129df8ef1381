#include "engine/radiation/field_sampler.h"

#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/radiation/pose_batch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr int kOutlinePoints = 64; // points of a curved outline, for its height
constexpr std::size_t kRow = PoseBatch::kPoses;
constexpr std::size_t kChunk = 256; // samples that a thread takes at a time: whole rows
constexpr double kProgressStep = 0.01;
constexpr double kMinStep = 1e-11; // relative to the largest value: smaller steps are lost in rounding
constexpr double kMinTolerance = 1e-14;
constexpr double kMaxTolerance = 1e-2;
constexpr int kMaxThreads = 1024;

Result<void> checkRange(const std::string& where, double value, double min, double max, const char* unit) {
    if (value >= min && value <= max)
        return {};
    return Error(MessageCode::ValueOutOfRange, where,
                 {formatNumber(value, 10), formatNumber(min), formatNumber(max), unit});
}

Error tooLarge(const std::string& where, double count, double max) {
    return {MessageCode::FieldTooLarge, where, {formatNumber(count, 12), formatNumber(max, 12)}};
}

Result<void> checkAxis(const FieldAxis& axis, const std::string& where) {
    const char* unit = coordinateUnit(axis.coordinate);
    if (axis.count < 1)
        return Error(MessageCode::ValueNotPositive, where + ": count", {std::to_string(axis.count)});
    if (axis.count > kMaxAxisSamples)
        return tooLarge(where, axis.count, kMaxAxisSamples);
    if (!(axis.step > 0.0))
        return Error(MessageCode::ValueNotPositive, where + ": step", {formatNumber(axis.step)});
    if (auto first = checkRange(where + ": first", axis.first, -kFieldReach, kFieldReach, unit); !first)
        return first;
    const double last = axis.at(axis.count - 1);
    if (auto valid = checkRange(where + ": last", last, -kFieldReach, kFieldReach, unit); !valid)
        return valid;
    const double min = kMinStep * std::max(std::abs(axis.first), std::abs(last));
    return checkRange(where + ": step", axis.step, min, 2.0 * kFieldReach, unit);
}

Result<void> check(const FieldRequest& request, double maxNumbers) {
    if (auto axes = checkRange("axes", static_cast<double>(request.axes.size()), 1, kMaxAxes, "axes"); !axes)
        return axes;
    std::array<bool, 6> isAxis{};
    double samples = 1.0;
    for (const FieldAxis& axis : request.axes) {
        const std::string name = kCoordinateNames[axis.coordinate];
        if (std::exchange(isAxis[axis.coordinate], true))
            return Error(MessageCode::AxisTwice, "axes", {name});
        if (auto valid = checkAxis(axis, "axes: " + name); !valid)
            return valid;
        samples *= axis.count;
    }
    const double max = request.withGradient ? std::floor(maxNumbers / 7.0) : maxNumbers;
    if (samples > max)
        return tooLarge("axes", samples, max);
    for (std::size_t i = 0; i < isAxis.size(); ++i)
        if (!isAxis[i])
            if (auto fixed = checkRange(std::string("held: ") + kCoordinateNames[i],
                                        request.fixed[static_cast<int>(i)], -kFieldReach, kFieldReach,
                                        coordinateUnit(static_cast<Coordinate>(i)));
                !fixed)
                return fixed;
    return checkRange("tolerance", request.tolerance, kMinTolerance, kMaxTolerance, "");
}

struct Turn {
    double sin = 0.0;
    double cos = 1.0;
};

Turn turnBy(double angle_rad) {
    return {std::sin(angle_rad), std::cos(angle_rad)};
}

bool isIdentity(const Pose& X) {
    return X.matrix() == Pose::Identity().matrix();
}

} // namespace

/// The request's axes with sine and cosine of every angle on them.
struct FieldSampler::Grid {
    explicit Grid(FieldRequest asked)
        : request(std::move(asked)), X_SR(request.X_RS.inverse()), isMoved(!isIdentity(request.X_RS)),
          isMounted(!isIdentity(request.X_EO)), turns(request.axes.size()),
          samples(sampleCount(request.axes)) {
        for (std::size_t a = 0; a < turns.size(); ++a) {
            const FieldAxis& axis = request.axes[a];
            for (int i = 0; axis.coordinate >= kThetaX && i < axis.count; ++i)
                turns[a].push_back(turnBy(axis.at(i)));
        }
        std::vector<MountedContour> mounted{{request.object, request.X_EO}};
        mounted.insert(mounted.end(), request.others.begin(), request.others.end());
        if (MountedObjects all(std::move(mounted), {{}, request.shields}, request.X_RS); all.mayBeShaded(0)) {
            held = std::move(all);
            X_OE = request.X_EO.inverse();
        }
        tolerance =
            held && !request.isShadeRough ? std::max(request.tolerance, kShadeTolerance) : request.tolerance;
        if (!held && !request.minHeight_m)
            batch = PoseBatch::of(request.source, request.object, request.tolerance);
        if (request.minHeight_m)
            outline = shapeOutline(request.object.shape(), kOutlinePoints);
    }

    const FieldRequest request;
    Pose X_SR;
    bool isMoved;   ///< false: the product with X_SR is left out, which costs more than the rest of a pose
    bool isMounted; ///< the same of X_EO
    std::vector<std::vector<Turn>> turns; ///< one list an axis, empty for a translation
    std::vector<Eigen::Vector2d> outline; ///< of the object, where its height matters
    std::optional<MountedObjects> held;   ///< the object, then the others; empty if none may shade it
    Pose X_OE = Pose::Identity();         ///< only where there is shade
    double tolerance = 0.0;               ///< see Field
    std::optional<PoseBatch> batch;       ///< where samples can be taken together
    const std::size_t samples;
};

/// Iterates over the grid, first axis fastest; the rotation is recomputed only if an angle has changed.
class FieldSampler::Cursor {
public:
    Cursor(const Grid& grid, std::size_t sample) : m_grid(grid), m_p_RE(grid.request.fixed.head<3>()) {
        for (int k = 0; k < 3; ++k)
            m_turns[static_cast<std::size_t>(k)] = turnBy(grid.request.fixed[kThetaX + k]);
        for (std::size_t a = 0; a < grid.turns.size(); ++a) {
            const auto count = static_cast<std::size_t>(grid.request.axes[a].count);
            set(a, static_cast<int>(sample % count));
            sample /= count;
        }
        rotate();
        translate();
    }

    void advance() {
        bool turned = false;
        for (std::size_t a = 0; a < m_grid.turns.size(); ++a) {
            const bool wraps = m_index[a] + 1 == m_grid.request.axes[a].count;
            set(a, wraps ? 0 : m_index[a] + 1);
            turned |= !m_grid.turns[a].empty();
            if (!wraps)
                break;
        }
        if (turned)
            rotate();
        translate();
    }

    const Pose& X_SO() const { return m_X_SO; }
    /// Goes on by `count` - 1 samples along the first axis and writes their places, from the second on.
    /// Returns false where it is an angle or ends before; then nothing is done.
    bool goAlong(PoseBatch::Poses& poses, std::size_t count) {
        const FieldAxis& axis = m_grid.request.axes.front();
        const auto first = static_cast<std::size_t>(m_index[0]);
        if (m_grid.isMoved || axis.coordinate >= kThetaX ||
            first + count > static_cast<std::size_t>(axis.count))
            return false;
        const Eigen::Vector3d place = m_X_SO.translation();
        for (int i = 0; i < 3; ++i)
            std::fill_n(poses.p[i] + 1, count - 1, place[i]);
        for (std::size_t k = 1; k < count; ++k)
            poses.p[axis.coordinate][k] = axis.at(static_cast<int>(first + k)) + m_arm[axis.coordinate];
        set(0, static_cast<int>(first + count) - 1);
        translate();
        return true;
    }
    unsigned turns() const { return m_turnCount; } ///< how often the rotation has changed

    bool isTooLow() const {
        const auto& min_m = m_grid.request.minHeight_m;
        return min_m && m_X_SO.translation().z() + m_lowest_m < *min_m;
    }

    /// Gradient by the pose coordinates, from the gradient by position and rotation in S axes about O's
    /// origin. Depends on the rotation only.
    void writeGradient(const Vector6d& aboutO, double* out) const {
        Vector6d aboutE = m_grid.isMounted ? gradientAbout(aboutO, m_arm, Eigen::Vector3d::Zero()) : aboutO;
        if (m_grid.isMoved) {
            const Eigen::Matrix3d R_RS = m_grid.X_SR.linear().transpose();
            aboutE << R_RS * aboutE.head<3>(), R_RS * aboutE.tail<3>();
        }
        const Eigen::Vector3d torque = aboutE.tail<3>();
        const Turn& z = m_turns[2];
        for (int k = 0; k < 3; ++k)
            out[k] = aboutE[k];
        // The axes about which theta_x, theta_y and theta_z turn, as in rotationAxes.
        out[kThetaX] = m_R_RE.col(0).dot(torque);
        out[kThetaY] = z.cos * torque.y() - z.sin * torque.x();
        out[kThetaZ] = torque.z();
    }

private:
    void set(std::size_t a, int i) {
        const FieldAxis& axis = m_grid.request.axes[a];
        m_index[a] = i;
        if (axis.coordinate < kThetaX)
            m_p_RE[axis.coordinate] = axis.at(i);
        else
            m_turns[static_cast<std::size_t>(axis.coordinate - kThetaX)] =
                m_grid.turns[a][static_cast<std::size_t>(i)];
    }

    // Rz Ry Rx
    void rotate() {
        ++m_turnCount;
        const auto& [x, y, z] = m_turns;
        m_R_RE << z.cos * y.cos, z.cos * y.sin * x.sin - z.sin * x.cos,
            z.cos * y.sin * x.cos + z.sin * x.sin, //
            z.sin * y.cos, z.sin * y.sin * x.sin + z.cos * x.cos,
            z.sin * y.sin * x.cos - z.cos * x.sin, //
            -y.sin, y.cos * x.sin, y.cos * x.cos;
        Eigen::Matrix3d R_SE = m_R_RE;
        if (m_grid.isMoved)
            R_SE = m_grid.X_SR.linear() * m_R_RE;
        m_X_SO.linear() = R_SE;
        if (m_grid.isMounted) {
            m_X_SO.linear() = R_SE * m_grid.request.X_EO.linear();
            m_arm = R_SE * m_grid.request.X_EO.translation();
        }
        m_lowest_m = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d& p_OQ : m_grid.outline)
            m_lowest_m = std::min(m_lowest_m, m_X_SO.linear().row(2).head<2>().dot(p_OQ));
    }

    void translate() {
        const Eigen::Vector3d p_SE = m_grid.isMoved ? Eigen::Vector3d(m_grid.X_SR * m_p_RE) : m_p_RE;
        m_X_SO.translation() = p_SE + m_arm;
    }

    const Grid& m_grid;
    std::array<int, kMaxAxes> m_index{};
    std::array<Turn, 3> m_turns;
    Eigen::Vector3d m_p_RE;
    Eigen::Matrix3d m_R_RE;
    Eigen::Vector3d m_arm = Eigen::Vector3d::Zero(); ///< from E's to O's origin, S axes
    Pose m_X_SO = Pose::Identity();
    double m_lowest_m = 0.0; ///< the outline's lowest point over O's origin
    unsigned m_turnCount = 0;
};

void FieldTally::add(const FieldTally& more) {
    undefined += more.undefined;
    unreached += more.unreached;
    largestError = std::max(largestError, more.largestError);
}

Result<FieldSampler> FieldSampler::of(FieldRequest request) {
    if (const auto valid = check(request, kMaxStoredNumbers); !valid)
        return valid.error();
    return FieldSampler(std::make_unique<const Grid>(std::move(request)));
}

/// An object whose centre is on the axis of a disk sees the same of it however it is turned about that axis:
/// samples at one theta_z are those at all.
struct FieldSampler::Turned {
    std::size_t below = 1;                        ///< product of the counts of the axes before theta_z
    std::vector<Turn> turns;                      ///< of theta_z
    std::vector<double> values, errors, gradient; ///< at theta_z = 0, the other axes in their order

    /// Sample number i of the whole field.
    double take(std::size_t i, double& error, double* slopes) const {
        const std::size_t beside = i / below, k = beside % turns.size();
        const std::size_t at = i % below + below * (beside / turns.size());
        error = errors[at];
        if (slopes != nullptr) {
            std::copy_n(&gradient[6 * at], 6, slopes);
            const Turn& turn = turns[k];
            slopes[kX] = turn.cos * gradient[6 * at + kX] - turn.sin * gradient[6 * at + kY];
            slopes[kY] = turn.sin * gradient[6 * at + kX] + turn.cos * gradient[6 * at + kY];
        }
        return values[at];
    }
};

FieldSampler::FieldSampler(std::unique_ptr<const Grid> grid)
    : m_grid(std::move(grid)), m_turned(turned(*m_grid)) {}
FieldSampler::FieldSampler(FieldSampler&&) noexcept = default;
FieldSampler::~FieldSampler() = default;

Field FieldSampler::header() const {
    const FieldRequest& request = m_grid->request;
    Field field;
    field.axes = request.axes;
    field.fixed = request.fixed;
    field.quantity = request.quantity.name;
    field.unit = request.quantity.unit;
    field.tolerance = m_grid->tolerance;
    field.isShadeRough = m_grid->held && request.isShadeRough;
    return field;
}

std::size_t FieldSampler::samples() const {
    return m_grid->samples;
}

std::unique_ptr<const FieldSampler::Turned> FieldSampler::turned(const Grid& grid) {
    constexpr std::size_t kMaxSamples = 1 << 18; // in the table, which is made on one thread
    const FieldRequest& request = grid.request;
    const SourceTerm& term = request.source.terms().front();
    const bool isRound = request.source.isEven() && term.X_SP.matrix().isIdentity(0.0) &&
                         std::holds_alternative<Disk>(term.contour.shape());
    const auto axis = std::ranges::find(request.axes, kThetaZ, &FieldAxis::coordinate);
    const bool isOnAxis = request.fixed[kX] == 0.0 && request.fixed[kY] == 0.0 &&
                          std::ranges::none_of(request.axes, [](const FieldAxis& each) {
                              return each.coordinate == kX || each.coordinate == kY;
                          });
    if (!isRound || !isOnAxis || grid.isMoved || grid.isMounted || grid.held || axis == request.axes.end() ||
        axis->count == 1 || request.axes.size() == 1 ||
        grid.samples / static_cast<std::size_t>(axis->count) > kMaxSamples)
        return nullptr;
    auto table = std::make_unique<Turned>();
    const auto number = axis - request.axes.begin();
    for (auto before = request.axes.begin(); before != axis; ++before)
        table->below *= static_cast<std::size_t>(before->count);
    table->turns = grid.turns[static_cast<std::size_t>(number)];
    FieldRequest others = request;
    others.axes.erase(others.axes.begin() + number);
    others.fixed[kThetaZ] = 0.0;
    const FieldSampler sampler(std::make_unique<const Grid>(std::move(others)));
    const std::size_t samples = sampler.samples();
    table->values.resize(samples);
    table->errors.resize(samples);
    table->gradient.resize(request.withGradient ? 6 * samples : 0);
    Cursor cursor(*sampler.m_grid, 0);
    for (std::size_t at = 0; at < samples; at += kRow)
        sampler.takeRow(cursor, std::min(kRow, samples - at), &table->values[at], &table->errors[at],
                        request.withGradient ? &table->gradient[6 * at] : nullptr);
    return table;
}

void FieldSampler::takeRow(Cursor& cursor, std::size_t count, double* values, double* errors,
                           double* gradient) const {
    if (m_grid->batch) {
        sampleRow(*m_grid->batch, cursor, count, values, errors, gradient);
        return;
    }
    for (std::size_t k = 0; k < count; ++k, cursor.advance()) {
        errors[k] = 0.0;
        values[k] = viewFactorAt(cursor, gradient ? gradient + 6 * k : nullptr, errors[k]);
    }
}

FieldTally FieldSampler::sample(std::size_t begin, std::size_t end, double* values, double* gradient) const {
    const FieldQuantity& quantity = m_grid->request.quantity;
    // An estimate contains the error of the rule and of rounding.
    const double reached = 1.01 * m_grid->tolerance;
    FieldTally tally;
    Cursor cursor(*m_grid, begin);
    std::array<double, kRow> F, errors;
    for (std::size_t at = begin; at < end; at += kRow) {
        const std::size_t count = std::min(kRow, end - at);
        if (m_turned)
            for (std::size_t k = 0; k < count; ++k)
                F[k] = m_turned->take(at + k, errors[k], gradient ? gradient + 6 * k : nullptr);
        else
            takeRow(cursor, count, F.data(), errors.data(), gradient);
        for (std::size_t k = 0; k < count; ++k) {
            tally.undefined += std::isnan(F[k]);
            tally.unreached += errors[k] > reached;
            tally.largestError = std::max(tally.largestError, errors[k]);
            *values++ = quantity.fromViewFactor && !std::isnan(F[k]) ? quantity.fromViewFactor(F[k]) : F[k];
        }
        if (gradient != nullptr)
            gradient += 6 * count;
    }
    return tally;
}

/// The next `count` samples: together where they can be, else one by one. Moves the cursor behind them.
void FieldSampler::sampleRow(const PoseBatch& batch, Cursor& cursor, std::size_t count, double* values,
                             double* errors, double* gradient) const {
    PoseBatch::Poses poses;
    std::vector<Cursor> turned; // of each rotation, where gradients are turned back
    const auto takePlace = [&](std::size_t k) {
        for (int i = 0; i < 3; ++i)
            poses.p[i][k] = cursor.X_SO().translation()[i];
    };
    const auto takeTurn = [&](std::size_t k) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                poses.R[i][j][k] = cursor.X_SO().linear()(i, j);
    };
    takePlace(0);
    takeTurn(0);
    if (!cursor.goAlong(poses, count)) {
        const unsigned turns = cursor.turns();
        if (gradient != nullptr)
            turned.push_back(cursor);
        for (std::size_t k = 1; k < count; ++k) {
            cursor.advance();
            takePlace(k);
            if (poses.isOneRotation && cursor.turns() != turns) {
                poses.isOneRotation = false;
                for (std::size_t before = 1; before < k; ++before) {
                    poses.copyRotation(0, before);
                    if (gradient != nullptr)
                        turned.push_back(turned.front());
                }
            }
            if (!poses.isOneRotation) {
                takeTurn(k);
                if (gradient != nullptr)
                    turned.push_back(cursor);
            }
        }
    }
    for (std::size_t k = count; k < kRow; ++k) // of a short row
        poses.copy(count - 1, k);
    PoseBatch::Factors factors;
    batch.compute(poses, static_cast<int>(count), gradient != nullptr, factors);
    for (std::size_t k = 0; k < count; ++k) {
        const Cursor* const at = turned.empty() ? &cursor : &turned[poses.isOneRotation ? 0 : k];
        double* const slopes = gradient != nullptr ? gradient + 6 * k : nullptr;
        if ((factors.computed >> k & 1U) != 0U) {
            values[k] = factors.values[k];
            errors[k] = factors.error;
            if (slopes != nullptr) {
                Vector6d aboutO;
                for (int i = 0; i < 6; ++i)
                    aboutO[i] = factors.gradients[i][k];
                at->writeGradient(aboutO, slopes);
            }
        } else {
            errors[k] = 0.0;
            values[k] = plainAt(poses.pose(k), at, slopes, errors[k]);
        }
    }
    cursor.advance();
}

namespace {

/// No value and, if it is asked for, no gradient.
double noFactor(double* gradient) {
    constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
    if (gradient != nullptr)
        std::fill_n(gradient, 6, kUndefined);
    return kUndefined;
}

} // namespace

/// Writes also the gradient. NaN if object and source overlap in one plane or the sample is left out.
double FieldSampler::viewFactorAt(const Cursor& cursor, double* gradient, double& error) const {
    if (cursor.isTooLow())
        return noFactor(gradient);
    if (!m_grid->held)
        return plainAt(cursor.X_SO(), &cursor, gradient, error);
    try {
        return shadedAt(cursor, gradient, error);
    } catch (const std::invalid_argument&) {
        return noFactor(gradient);
    }
}

/// Without shade; `cursor` is needed for the gradient only.
double FieldSampler::plainAt(const Pose& X_SO, const Cursor* cursor, double* gradient, double& error) const {
    const FieldRequest& request = m_grid->request;
    try {
        if (gradient == nullptr)
            return viewFactorValue(request.source, request.object, X_SO, request.tolerance, &error);
        ViewFactorOptions options;
        options.tolerance = request.tolerance;
        const ViewFactor factor = viewFactor(request.source, request.object, X_SO, options);
        error = factor.errorEstimate;
        cursor->writeGradient(factor.gradient, gradient);
        return factor.value;
    } catch (const std::invalid_argument&) {
        return noFactor(gradient);
    }
}

double FieldSampler::shadedAt(const Cursor& cursor, double* gradient, double& error) const {
    const FieldRequest& request = m_grid->request;
    const MountedObjects& held = *m_grid->held;
    const Pose X_SE = cursor.X_SO() * m_grid->X_OE;
    if (request.isShadeRough && gradient == nullptr) {
        const double unshaded =
            viewFactorValue(request.source, request.object, cursor.X_SO(), request.tolerance, &error);
        return unshaded * held.roughShare(request.source, 0, X_SE, unshaded);
    }
    if (request.isShadeRough) {
        const RigidViewFactor factor = held.roughViewFactor(request.source, 0, X_SE, request.tolerance);
        cursor.writeGradient(factor.gradient, gradient);
        return factor.value;
    }
    const ViewFactor factor = held.viewFactor(request.source, 0, X_SE, {.tolerance = request.tolerance});
    error = factor.errorEstimate;
    if (gradient != nullptr)
        cursor.writeGradient(factor.gradient, gradient);
    return factor.value;
}

std::size_t sampleCount(const std::vector<FieldAxis>& axes) {
    std::size_t samples = 1;
    for (const FieldAxis& axis : axes)
        samples *= static_cast<std::size_t>(axis.count);
    return samples;
}

const char* coordinateUnit(Coordinate coordinate) {
    return coordinate < kThetaX ? "m" : "rad";
}

Result<std::shared_ptr<const Field>> sampleField(const FieldRequest& request, const FieldRun& run) {
    if (const auto valid = check(request, kMaxFieldNumbers); !valid)
        return valid.error();
    if (const auto threads = checkRange("threads", run.threads, 0, kMaxThreads, ""); !threads)
        return threads.error();
    const auto sampler = FieldSampler::of(request);
    if (!sampler)
        return sampler.error();
    auto field = std::make_shared<Field>(sampler->header());
    field->values.resize(sampler->samples());
    field->gradient.resize(request.withGradient ? 6 * sampler->samples() : 0);
    const std::size_t samples = sampler->samples();
    const auto chunks = static_cast<int>((samples + kChunk - 1) / kChunk);
    std::mutex mutex;
    FieldTally tally;
    std::size_t taken = 0;
    double reported = 0.0;
    runInParallel(
        chunks, run.threads,
        [&](int index) {
            if (run.stop.stop_requested())
                return;
            const std::size_t begin = static_cast<std::size_t>(index) * kChunk;
            const std::size_t end = std::min(begin + kChunk, samples);
            const FieldTally more =
                sampler->sample(begin, end, &field->values[begin],
                                field->gradient.empty() ? nullptr : &field->gradient[6 * begin]);
            const std::lock_guard lock(mutex);
            tally.add(more);
            taken += end - begin;
        },
        [&](int done) {
            const double share = static_cast<double>(done) / chunks;
            if (run.progress && !run.stop.stop_requested() && share < 1.0 &&
                share >= reported + kProgressStep)
                run.progress(reported = share);
        });
    if (taken < samples)
        return Error(MessageCode::FieldCancelled, "");
    field->undefinedSamples = tally.undefined;
    field->unreachedSamples = tally.unreached;
    field->largestErrorEstimate = tally.largestError;
    if (run.progress)
        run.progress(1.0);
    return std::shared_ptr<const Field>(std::move(field));
}

} // namespace bask
