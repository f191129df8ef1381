#include "engine/radiation/field_sampler.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace bask {
namespace {

constexpr int kOutlinePoints = 64;  // points of a curved outline, for its height
constexpr std::size_t kChunk = 256; // samples that a thread takes at a time
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

Result<void> check(const FieldRequest& request, const FieldRun& run) {
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
    const double max = request.withGradient ? std::floor(kMaxFieldNumbers / 7.0) : kMaxFieldNumbers;
    if (samples > max)
        return tooLarge("axes", samples, max);
    for (std::size_t i = 0; i < isAxis.size(); ++i)
        if (!isAxis[i])
            if (auto fixed = checkRange(std::string("held: ") + kCoordinateNames[i],
                                        request.fixed[static_cast<int>(i)], -kFieldReach, kFieldReach,
                                        coordinateUnit(static_cast<Coordinate>(i)));
                !fixed)
                return fixed;
    if (auto threads = checkRange("threads", run.threads, 0, kMaxThreads, ""); !threads)
        return threads;
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

/// The request's axes with sine and cosine of every angle on them.
struct Grid {
    explicit Grid(const FieldRequest& asked)
        : request(asked), X_SR(asked.X_RS.inverse()), isMoved(!isIdentity(asked.X_RS)),
          isMounted(!isIdentity(asked.X_EO)), turns(asked.axes.size()) {
        for (std::size_t a = 0; a < turns.size(); ++a) {
            const FieldAxis& axis = request.axes[a];
            samples *= static_cast<std::size_t>(axis.count);
            for (int i = 0; axis.coordinate >= kThetaX && i < axis.count; ++i)
                turns[a].push_back(turnBy(axis.at(i)));
        }
        std::vector<MountedContour> mounted{{request.object, request.X_EO}};
        mounted.insert(mounted.end(), request.others.begin(), request.others.end());
        if (MountedObjects all(std::move(mounted), {{}, request.shields}, request.X_RS); all.mayBeShaded(0)) {
            held = std::move(all);
            X_OE = request.X_EO.inverse();
        }
        if (request.minHeight_m)
            outline = shapeOutline(request.object.shape(), kOutlinePoints);
    }

    const FieldRequest& request;
    Pose X_SR;
    bool isMoved;   ///< false: the product with X_SR is left out, which costs more than the rest of a pose
    bool isMounted; ///< the same of X_EO
    std::vector<std::vector<Turn>> turns; ///< one list an axis, empty for a translation
    std::vector<Eigen::Vector2d> outline; ///< of the object, where its height matters
    std::optional<MountedObjects> held;   ///< the object, then the others; empty if none may shade it
    Pose X_OE = Pose::Identity();         ///< only where there is shade
    std::size_t samples = 1;
};

/// Iterates over the grid, first axis fastest; the rotation is recomputed only if an angle has changed.
class Cursor {
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

    bool isTooLow() const {
        const auto& min_m = m_grid.request.minHeight_m;
        return min_m && m_X_SO.translation().z() + m_lowest_m < *min_m;
    }

    /// Gradient by the pose coordinates, from the gradient by position and rotation in S axes about O's
    /// origin.
    void writeGradient(const Vector6d& aboutO, double* out) const {
        Vector6d aboutE = gradientAbout(aboutO, m_X_SO.translation(), m_X_SO.translation() - m_arm);
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
};

/// The work that the threads share.
class Sampling {
public:
    Sampling(const Grid& grid, const FieldRun& run, Field& field)
        : m_grid(grid), m_run(run), m_field(field) {}

    /// Takes chunks until there are none; only the thread that `reports` calls progress.
    void work(bool reports) {
        try {
            double reported = 0.0;
            while (!m_halted && !m_run.stop.stop_requested()) {
                const std::size_t begin = m_next.fetch_add(kChunk, std::memory_order_relaxed);
                if (begin >= m_grid.samples)
                    return;
                const std::size_t end = std::min(begin + kChunk, m_grid.samples);
                book(sample(begin, end));
                m_done += end - begin;
                const double done = static_cast<double>(m_done) / static_cast<double>(m_grid.samples);
                if (reports && m_run.progress && done < 1.0 && done >= reported + kProgressStep)
                    m_run.progress(reported = done);
            }
        } catch (...) {
            const std::lock_guard lock(m_mutex);
            m_failure = std::current_exception();
            m_halted = true;
        }
    }

    /// Call after all threads have ended: true if every sample was taken.
    bool finish() {
        if (m_failure)
            std::rethrow_exception(m_failure);
        m_field.undefinedSamples = m_tally.undefined;
        m_field.unreachedSamples = m_tally.unreached;
        m_field.largestErrorEstimate = m_tally.largestError;
        if (m_done < m_grid.samples)
            return false;
        if (m_run.progress)
            m_run.progress(1.0);
        return true;
    }

private:
    struct Tally {
        std::size_t undefined = 0, unreached = 0;
        double largestError = 0.0;
    };

    void book(const Tally& more) {
        const std::lock_guard lock(m_mutex);
        m_tally.undefined += more.undefined;
        m_tally.unreached += more.unreached;
        m_tally.largestError = std::max(m_tally.largestError, more.largestError);
    }

    Tally sample(std::size_t begin, std::size_t end) {
        const FieldQuantity& quantity = m_grid.request.quantity;
        // An estimate contains the error of the rule and of rounding.
        const double reached = 1.01 * m_field.tolerance;
        Tally tally;
        Cursor cursor(m_grid, begin);
        for (std::size_t i = begin; i < end; ++i) {
            double error = 0.0;
            const double F = viewFactorAt(cursor, i, error);
            tally.undefined += std::isnan(F);
            tally.unreached += error > reached;
            tally.largestError = std::max(tally.largestError, error);
            m_field.values[i] = quantity.fromViewFactor && !std::isnan(F) ? quantity.fromViewFactor(F) : F;
            if (i + 1 < end)
                cursor.advance();
        }
        return tally;
    }

    /// Writes also the gradient of sample i. NaN if object and source overlap in one plane or the sample is
    /// left out.
    double viewFactorAt(const Cursor& cursor, std::size_t i, double& error) {
        constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
        const FieldRequest& request = m_grid.request;
        const auto none = [&] {
            if (request.withGradient)
                std::fill_n(&m_field.gradient[6 * i], 6, kUndefined);
            return kUndefined;
        };
        if (cursor.isTooLow())
            return none();
        try {
            if (m_grid.held)
                return shadedAt(cursor, i, error);
            if (!request.withGradient)
                return viewFactorValue(request.source, request.object, cursor.X_SO(), request.tolerance,
                                       &error);
            ViewFactorOptions options;
            options.tolerance = request.tolerance;
            const ViewFactor factor = viewFactor(request.source, request.object, cursor.X_SO(), options);
            error = factor.errorEstimate;
            cursor.writeGradient(factor.gradient, &m_field.gradient[6 * i]);
            return factor.value;
        } catch (const std::invalid_argument&) {
            return none();
        }
    }

    double shadedAt(const Cursor& cursor, std::size_t i, double& error) {
        const FieldRequest& request = m_grid.request;
        const MountedObjects& held = *m_grid.held;
        const Pose X_SE = cursor.X_SO() * m_grid.X_OE;
        if (request.isShadeRough && !request.withGradient) {
            const double unshaded =
                viewFactorValue(request.source, request.object, cursor.X_SO(), request.tolerance, &error);
            return unshaded * held.roughShare(request.source, 0, X_SE, unshaded);
        }
        if (request.isShadeRough) {
            const RigidViewFactor factor = held.roughViewFactor(request.source, 0, X_SE, request.tolerance);
            cursor.writeGradient(factor.gradient, &m_field.gradient[6 * i]);
            return factor.value;
        }
        const ViewFactor factor = held.viewFactor(request.source, 0, X_SE, {.tolerance = request.tolerance});
        error = factor.errorEstimate;
        if (request.withGradient)
            cursor.writeGradient(factor.gradient, &m_field.gradient[6 * i]);
        return factor.value;
    }

    const Grid& m_grid;
    const FieldRun& m_run;
    Field& m_field;
    std::atomic<std::size_t> m_next{0};
    std::atomic<std::size_t> m_done{0};
    Tally m_tally;
    std::atomic<bool> m_halted{false};
    std::mutex m_mutex;
    std::exception_ptr m_failure;
};

void workOnThreads(Sampling& sampling, int asked, std::size_t samples) {
    const auto wanted = static_cast<std::size_t>(
        asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
    const std::size_t count = std::min(wanted, (samples + kChunk - 1) / kChunk);
    std::vector<std::jthread> others;
    try {
        for (std::size_t i = 1; i < count; ++i)
            others.emplace_back([&] { sampling.work(false); });
    } catch (const std::system_error&) {
        // The system gives no more threads: the existing ones do the work.
    }
    sampling.work(true);
}

} // namespace

const char* coordinateUnit(Coordinate coordinate) {
    return coordinate < kThetaX ? "m" : "rad";
}

Result<std::shared_ptr<const Field>> sampleField(const FieldRequest& request, const FieldRun& run) {
    if (const auto valid = check(request, run); !valid)
        return valid.error();
    const Grid grid(request);
    auto field = std::make_shared<Field>();
    field->axes = request.axes;
    field->fixed = request.fixed;
    field->quantity = request.quantity.name;
    field->unit = request.quantity.unit;
    field->tolerance =
        grid.held && !request.isShadeRough ? std::max(request.tolerance, kShadeTolerance) : request.tolerance;
    field->isShadeRough = grid.held && request.isShadeRough;
    field->values.resize(grid.samples);
    field->gradient.resize(request.withGradient ? 6 * grid.samples : 0);
    Sampling sampling(grid, run, *field);
    workOnThreads(sampling, run.threads, grid.samples);
    if (!sampling.finish())
        return Error(MessageCode::FieldCancelled, "");
    return std::shared_ptr<const Field>(std::move(field));
}

} // namespace bask
