#include "engine/calibration/rigid_fit.h"

#include <cmath>

namespace bask {
namespace {

struct Deviations {
    double position2 = 0.0, angle2 = 0.0;

    Matrix6d covariance() const {
        Vector6d d;
        d << Eigen::Vector3d::Constant(position2), Eigen::Vector3d::Constant(angle2);
        return d.asDiagonal();
    }
};

RigidFit solvedWith(const std::vector<RigidSight>& sights, const Deviations& own) {
    const Eigen::Index n = sights.front().byUnknowns.cols();
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(n);
    for (const RigidSight& sight : sights) {
        const Matrix6d weight = (sight.noise + own.covariance()).inverse();
        information += sight.byUnknowns.transpose() * weight * sight.byUnknowns;
        sum += sight.byUnknowns.transpose() * weight * sight.moved;
    }
    RigidFit fit;
    fit.covariance = information.inverse();
    fit.unknowns = fit.covariance * sum;
    return fit;
}

// What each thing's own displacement is expected to be, squared, given what was seen.
Deviations expected(const std::vector<RigidSight>& sights, const RigidFit& fit, const Deviations& own) {
    const Matrix6d D = own.covariance();
    Vector6d squares = Vector6d::Zero();
    for (const RigidSight& sight : sights) {
        const Matrix6d weight = (sight.noise + D).inverse();
        const Vector6d mean = D * weight * (sight.moved - sight.byUnknowns * fit.unknowns);
        const Matrix6d byFit =
            weight * sight.byUnknowns * fit.covariance * sight.byUnknowns.transpose() * weight;
        squares += mean.cwiseAbs2() + (D - D * (weight - byFit) * D).diagonal();
    }
    const double count = 3.0 * static_cast<double>(sights.size());
    return {squares.head<3>().sum() / count, squares.tail<3>().sum() / count};
}

} // namespace

double chiSquareBound(double freedom) {
    constexpr double kNormal = 3.090;
    const double v = 2.0 / (9.0 * freedom);
    return freedom * std::pow(1.0 - v + kNormal * std::sqrt(v), 3);
}

RigidFit fitRigid(const std::vector<RigidSight>& sights) {
    constexpr int kSteps = 200;
    constexpr double kSettled = 3e-3;
    Deviations own;
    for (const RigidSight& sight : sights) {
        const double count = 3.0 * static_cast<double>(sights.size());
        own.position2 += sight.moved.head<3>().squaredNorm() / count;
        own.angle2 += sight.moved.tail<3>().squaredNorm() / count;
    }
    RigidFit fit = solvedWith(sights, own);
    for (int step = 0; step < kSteps; ++step) {
        const Deviations next = expected(sights, fit, own);
        const bool isSettled = std::abs(next.position2 - own.position2) < kSettled * own.position2 &&
                               std::abs(next.angle2 - own.angle2) < kSettled * own.angle2;
        own = next;
        fit = solvedWith(sights, own);
        if (isSettled)
            break;
    }
    // Few things tell their deviations badly: the variance of Student's distribution, each deviation with
    // half of the freedom.
    const double freedom =
        3.0 * static_cast<double>(sights.size()) - 0.5 * static_cast<double>(fit.unknowns.size());
    const double widened = freedom / (freedom - 2.0);
    fit.covariance = solvedWith(sights, {widened * own.position2, widened * own.angle2}).covariance;
    fit.position_m = std::sqrt(own.position2);
    fit.angle_rad = std::sqrt(own.angle2);
    return fit;
}

} // namespace bask
