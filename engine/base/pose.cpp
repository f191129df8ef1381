#include "engine/base/pose.h"

#include <cmath>

namespace bask {

Pose poseFromRotationVector(const Eigen::Vector3d& translation_m, const Eigen::Vector3d& rotation_rad) {
    Pose X = Pose::Identity();
    const double angle = rotation_rad.norm();
    if (angle > 0.0)
        X.linear() = Eigen::AngleAxisd(angle, rotation_rad / angle).toRotationMatrix();
    X.translation() = translation_m;
    return X;
}

Pose poseBetween(const Pose& from, const Pose& to, double share) {
    Pose X = Pose::Identity();
    X.linear() = Eigen::Quaterniond(from.linear())
                     .slerp(share, Eigen::Quaterniond(to.linear()))
                     .normalized()
                     .toRotationMatrix();
    X.translation() = (1.0 - share) * from.translation() + share * to.translation();
    return X;
}

Pose poseFromCoordinates(const Vector6d& q) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    Pose X = Pose::Identity();
    X.linear() = (AngleAxisd(q[kThetaZ], Vector3d::UnitZ()) * AngleAxisd(q[kThetaY], Vector3d::UnitY()) *
                  AngleAxisd(q[kThetaX], Vector3d::UnitX()))
                     .toRotationMatrix();
    X.translation() = q.head<3>();
    return X;
}

Vector6d coordinatesFromPose(const Pose& X) {
    const Eigen::Matrix3d R = X.linear();
    Vector6d q;
    q.head<3>() = X.translation();
    q[kThetaX] = std::atan2(R(2, 1), R(2, 2));
    q[kThetaY] = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
    q[kThetaZ] = std::atan2(R(1, 0), R(0, 0));
    return q;
}

Eigen::Matrix3d rotationAxes(const Vector6d& q) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    const AngleAxisd Rz(q[kThetaZ], Vector3d::UnitZ());
    const AngleAxisd Ry(q[kThetaY], Vector3d::UnitY());
    Eigen::Matrix3d axes;
    axes.col(0) = Rz * (Ry * Vector3d::UnitX());
    axes.col(1) = Rz * Vector3d::UnitY();
    axes.col(2) = Vector3d::UnitZ();
    return axes;
}

Vector6d coordinateGradient(const Vector6d& q, const Vector6d& gradient) {
    Vector6d out;
    out.head<3>() = gradient.head<3>();
    out.tail<3>() = rotationAxes(q).transpose() * gradient.tail<3>();
    return out;
}

} // namespace bask
