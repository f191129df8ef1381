#include "engine/vision/pose_filter.h"

#include "engine/calibration/part_pose.h"
#include "engine/calibration/rigid_fit.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bask {
namespace {

/// Root mean square acceleration that is another one in every thirtieth of a second.
struct Motion {
    double position_m_s2, angle_rad_s2;
};
constexpr Motion kCalm{0.2, 1.0}, kBrisk{4.0, 20.0};
constexpr double kAnew_s = 1.0 / 30.0;
// Of a part of which nothing but the place is known.
constexpr double kUnknown_m_s = 0.3, kUnknown_rad_s = 1.5;

Matrix6d diagonal(double position, double angle) {
    Vector6d d;
    d << Eigen::Vector3d::Constant(position), Eigen::Vector3d::Constant(angle);
    return d.asDiagonal();
}

MotionState carried(const MotionState& from, double time_s, const Motion& motion) {
    const double dt = time_s - from.time_s, t = std::abs(dt);
    const Vector6d way = dt * from.velocity;
    MotionState to = from;
    to.time_s = time_s;
    to.X_CP = displaced(from.X_CP, way);
    Matrix12d F = Matrix12d::Identity();
    F.block<3, 3>(3, 3) = displaced(Pose::Identity(), way).linear(); // an error turns with the part
    F.topRightCorner<6, 6>() = dt * Matrix6d::Identity();
    const Matrix6d density =
        kAnew_s * diagonal(std::pow(motion.position_m_s2, 2), std::pow(motion.angle_rad_s2, 2));
    Matrix12d Q;
    Q << t * t * t / 3.0 * density, dt * t / 2.0 * density, dt * t / 2.0 * density, t * density;
    to.covariance = F * from.covariance * F.transpose() + Q;
    return to;
}

/// The pose that suits prediction and corners best. Squares are in units of their variances.
class BestPose {
public:
    BestPose(const MotionState& predicted, std::span<const SeenCorner> corners, const CameraModel& camera,
             double variance_px2)
        : m_predicted(predicted), m_corners(corners), m_camera(camera), m_variance(variance_px2),
          m_prior(predicted.covariance.topLeftCorner<6, 6>().ldlt().solve(Matrix6d::Identity())),
          m_kept(corners.size()) {
        std::iota(m_kept.begin(), m_kept.end(), std::size_t{0});
    }

    /// Whether the corners fit; `mayLeaveOut`: after some are left out, the worst first.
    bool find(bool mayLeaveOut) {
        while (solve()) {
            const Misfit corner = worst(1);
            const double bound = chiSquareBound(2.0 * static_cast<double>(m_kept.size()));
            if (corner.gain <= kGross && m_cost <= bound)
                return true;
            const Misfit marker = worst(4);
            const Misfit& out = marker.gain / 4.0 > corner.gain ? marker : corner;
            const std::size_t left = m_kept.size() - out.count;
            if (!mayLeaveOut || 2 * left <= m_corners.size() || left < 3)
                return false;
            const auto first = m_kept.begin() + static_cast<std::ptrdiff_t>(out.first);
            m_kept.erase(first, first + static_cast<std::ptrdiff_t>(out.count));
        }
        return false;
    }

    MotionState updated() const {
        MotionState state = m_predicted;
        state.X_CP = m_X_CP;
        state.X_CP.linear() = Eigen::Quaterniond(m_X_CP.linear()).normalized().toRotationMatrix();
        const Matrix6d before = m_predicted.covariance.topLeftCorner<6, 6>();
        const Matrix6d after = m_information.ldlt().solve(Matrix6d::Identity());
        const Matrix6d gain = m_predicted.covariance.bottomLeftCorner<6, 6>() * m_prior;
        state.velocity += gain * m_moved;
        state.covariance.topLeftCorner<6, 6>() = after;
        state.covariance.bottomLeftCorner<6, 6>() = gain * after;
        state.covariance.bottomRightCorner<6, 6>() -= gain * (before - after) * gain.transpose();
        state.covariance.topRightCorner<6, 6>() = state.covariance.bottomLeftCorner<6, 6>().transpose();
        state.covariance = 0.5 * (state.covariance + state.covariance.transpose().eval());
        return state;
    }

    std::size_t keptCount() const { return m_kept.size(); }
    double cost() const { return m_cost; }
    double squares_px2() const { return m_total.squares_px2; }
    std::vector<std::size_t> leftOut() const {
        std::vector<std::size_t> out;
        for (std::size_t k = 0; k < m_corners.size(); ++k)
            if (!std::ranges::binary_search(m_kept, k))
                out.push_back(k);
        return out;
    }

private:
    static constexpr double kGross = 25.0; // one corner's share: five deviations

    // Gauss and Newton, from the prediction. False when a corner is behind the camera or it does not settle.
    bool solve() {
        constexpr int kSteps = 10;
        constexpr double kSettled = 1e-3;
        m_X_CP = m_predicted.X_CP;
        for (int step = 0; step < kSteps; ++step) {
            if (!look())
                return false;
            const Vector6d move = m_information.ldlt().solve(m_gradient);
            if (!move.allFinite())
                return false;
            if (m_gradient.dot(move) < kSettled)
                return true;
            m_X_CP = displaced(m_X_CP, move);
        }
        return false;
    }

    bool look() {
        m_each.clear();
        m_total = CornerSums();
        for (const std::size_t k : m_kept) {
            const CornerSums sums = cornerSums(m_corners.subspan(k, 1), m_camera, m_X_CP);
            if (sums.information.isZero(0.0))
                return false;
            m_total.information += sums.information;
            m_total.gradient += sums.gradient;
            m_total.squares_px2 += sums.squares_px2;
            m_each.push_back(sums);
        }
        m_moved = displacementBetween(m_predicted.X_CP, m_X_CP);
        m_information = m_prior + m_total.information / m_variance;
        m_gradient = m_total.gradient / m_variance - m_prior * m_moved;
        m_cost = m_total.squares_px2 / m_variance + m_moved.dot(m_prior * m_moved);
        return std::isfinite(m_cost);
    }

    struct Misfit {
        std::size_t first = 0, count = 1; ///< of m_kept
        double gain = 0.0;                ///< by which the cost falls without them, to first order
    };

    // Of the corners (1) or markers (4), the one that costs most.
    Misfit worst(std::size_t together) const {
        Misfit worst;
        for (std::size_t first = 0, next = 0; first < m_kept.size(); first = next) {
            Matrix6d information = m_information;
            Vector6d gradient = m_gradient;
            double gain = 0.0;
            for (; next < m_kept.size() && m_kept[next] / together == m_kept[first] / together; ++next) {
                information -= m_each[next].information / m_variance;
                gradient -= m_each[next].gradient / m_variance;
                gain += m_each[next].squares_px2 / m_variance;
            }
            gain += gradient.dot(information.ldlt().solve(gradient));
            if (gain > worst.gain)
                worst = {first, next - first, gain};
        }
        return worst;
    }

    const MotionState& m_predicted;
    std::span<const SeenCorner> m_corners;
    const CameraModel& m_camera;
    double m_variance;
    Matrix6d m_prior; // information
    std::vector<std::size_t> m_kept;

    Pose m_X_CP;
    Vector6d m_moved, m_gradient;
    Matrix6d m_information;
    std::vector<CornerSums> m_each;
    CornerSums m_total;
    double m_cost = 0.0;
};

} // namespace

PoseFilter::PoseFilter(double time_s, const Pose& X_CP, const Matrix6d& covariance, double corner_px)
    : m_state{time_s, X_CP, Vector6d::Zero(), Matrix12d::Zero()},
      m_variance_px2(std::pow(std::max(corner_px, kUsualCorner_px), 2)) {
    m_state.covariance.topLeftCorner<6, 6>() = covariance;
    m_state.covariance.bottomRightCorner<6, 6>() =
        diagonal(std::pow(kUnknown_m_s, 2), std::pow(kUnknown_rad_s, 2));
}

FilterStep PoseFilter::take(double time_s, std::span<const SeenCorner> corners, const CameraModel& camera) {
    constexpr double kFrames = 30.0; // over which the corners' noise is averaged
    constexpr double kMinFreedom = 10.0;
    if (corners.size() < 3)
        return {};
    for (const bool mayLeaveOut : {false, true})
        for (const Motion& motion : {kCalm, kBrisk}) {
            const MotionState predicted = carried(m_state, time_s, motion);
            BestPose best(predicted, corners, camera, m_variance_px2);
            if (!best.find(mayLeaveOut))
                continue;
            m_state = best.updated();
            const double freedom = 2.0 * static_cast<double>(best.keptCount()) - 6.0;
            if (freedom >= kMinFreedom)
                m_variance_px2 += (best.squares_px2() / freedom - m_variance_px2) / kFrames;
            m_variance_px2 = std::max(m_variance_px2, kUsualCorner_px * kUsualCorner_px);
            return {true, best.leftOut(), best.cost()};
        }
    return {};
}

MotionState PoseFilter::at(double time_s) const {
    return carried(m_state, time_s, kCalm);
}

double PoseFilter::corner_px() const {
    return std::sqrt(m_variance_px2);
}

} // namespace bask
