#include "engine/shape/principal_axes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace bask {

// Green's theorem, edge by edge, about the first point of all, so that no digits are lost far from the
// origin.
PrincipalAxes principalAxes(const std::vector<std::vector<Eigen::Vector2d>>& rings) {
    using Eigen::Matrix2d;
    using Eigen::Vector2d;
    const Vector2d start = rings.at(0).at(0);
    double twiceArea = 0.0;
    Vector2d first = Vector2d::Zero();
    Matrix2d second = Matrix2d::Zero();
    for (const auto& ring : rings) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Vector2d a = ring[k] - start, b = ring[(k + 1) % ring.size()] - start;
            const double cross = a.x() * b.y() - a.y() * b.x();
            const Vector2d sum = a + b;
            twiceArea += cross;
            first += cross * sum;
            second += cross * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
        }
    }
    const Vector2d centroid = first / (3.0 * twiceArea);
    const Matrix2d spread = second / (12.0 * twiceArea) - centroid * centroid.transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix2d> solver(spread);

    PrincipalAxes axes;
    axes.centroid_m = start + centroid;
    axes.minor_m = std::sqrt(std::max(solver.eigenvalues()[0], 0.0));
    axes.major_m = std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
    if (axes.major_m - axes.minor_m > 1e-6 * axes.major_m)
        axes.major = solver.eigenvectors().col(1);
    if (axes.major.x() < 0.0)
        axes.major = -axes.major;
    return axes;
}

} // namespace bask
