#include "engine/calibration/pose_covariance.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace bask {
namespace {

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& a) {
    Eigen::Matrix3d m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

double twoSigma(const Eigen::Matrix3d& covariance) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
    return 2.0 * std::sqrt(solver.eigenvalues().maxCoeff());
}

} // namespace

Pose displaced(const Pose& X_AB, const Vector6d& displacement) {
    Pose X = poseFromRotationVector(X_AB.translation() + displacement.head<3>(), displacement.tail<3>());
    X.linear() = X.linear() * X_AB.linear();
    return X;
}

Vector6d displacementBetween(const Pose& from, const Pose& to) {
    const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
    Vector6d result;
    result << to.translation() - from.translation(), turn.angle() * turn.axis();
    return result;
}

Matrix6d carriedBy(const Eigen::Vector3d& offset) {
    Matrix6d J = Matrix6d::Identity();
    J.topRightCorner<3, 3>() = -crossMatrix(offset);
    return J;
}

PoseSpread spreadOf(const Matrix6d& covariance) {
    return {twoSigma(covariance.topLeftCorner<3, 3>()), twoSigma(covariance.bottomRightCorner<3, 3>())};
}

BetweenJacobian betweenJacobian(const Pose& X_CA, const Pose& X_CB) {
    const Eigen::Matrix3d R_AC = X_CA.linear().transpose();
    BetweenJacobian J;
    J.byB.setZero();
    J.byB.topLeftCorner<3, 3>() = J.byB.bottomRightCorner<3, 3>() = R_AC;
    J.byA = -J.byB; // A turned by w about its origin moves B by -w x p, as A sees it
    J.byA.topRightCorner<3, 3>() = R_AC * crossMatrix(X_CB.translation() - X_CA.translation());
    return J;
}

Matrix6d covarianceBetween(const Pose& X_CA, const Matrix6d& ofA, const Pose& X_CB, const Matrix6d& ofB) {
    const BetweenJacobian J = betweenJacobian(X_CA, X_CB);
    return J.byA * ofA * J.byA.transpose() + J.byB * ofB * J.byB.transpose();
}

} // namespace bask
