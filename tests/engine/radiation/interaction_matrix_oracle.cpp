#include "tests/engine/radiation/interaction_matrix_oracle.h"

#include <cmath>
#include <numbers>

namespace bask::test {

// The inner integral of the paper runs from 2 pi to 0, since the two faces look at each other: hence the
// minus. No correction was needed here but for the letter h, which stands for r1 r2 cos(w1 - w2)/(2 pi A2
// s^2).
Eigen::Vector3d paperTranslationRow(double r1, double r2, const Eigen::Vector3d& p, int points) {
    constexpr double kTwoPi = 2.0 * std::numbers::pi;
    const double area2 = std::numbers::pi * r2 * r2;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < points; ++i)
        for (int k = 0; k < points; ++k) {
            const double w1 = kTwoPi * i / points, w2 = kTwoPi * k / points;
            const Eigen::Vector3d s(p.x() + r2 * std::cos(w2) - r1 * std::cos(w1),
                                    p.y() + r2 * std::sin(w2) - r1 * std::sin(w1), p.z());
            sum += r1 * r2 * std::cos(w1 - w2) / (kTwoPi * area2 * s.squaredNorm()) * s;
        }
    return -sum * (kTwoPi / points) * (kTwoPi / points);
}

Vector6d paperForwardDifferences(const std::function<double(const Vector6d&)>& viewFactorAt,
                                 const Vector6d& coordinates, double step_m, double step_rad) {
    const double here = viewFactorAt(coordinates);
    Vector6d row;
    for (int i = 0; i < 6; ++i) {
        const double step = i < kThetaX ? step_m : step_rad;
        Vector6d moved = coordinates;
        moved[i] += step;
        row[i] = (viewFactorAt(moved) - here) / step;
    }
    return row;
}

} // namespace bask::test
