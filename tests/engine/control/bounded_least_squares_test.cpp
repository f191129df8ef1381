#include "engine/control/bounded_least_squares.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace bask {

TEST(BoundedLeastSquares, WithoutActiveLimitsItIsThePlainSolution) {
    Eigen::Matrix2d H;
    H << 4.0, 1.0, 1.0, 3.0;
    const Eigen::Vector2d f(1.0, 2.0);
    const auto solution =
        solveBounded(H, f, Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-100.0, -100.0));
    EXPECT_TRUE(solution.converged);
    EXPECT_FALSE(solution.constrained);
    EXPECT_LT((H * solution.y - f).norm(), 1e-12);
}

TEST(BoundedLeastSquares, RandomProgramsSatisfyTheOptimalityConditions) {
    // Compared with projected gradient descent on the dual, a wholly different method.
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 90; ++trial) {
        const int n = 1 + trial % 6;
        const int m = 2 * n + 3;
        Eigen::MatrixXd A(n, n);
        Eigen::MatrixXd G(m, n);
        Eigen::VectorXd f(n);
        Eigen::VectorXd h(m);
        for (int i = 0; i < n; ++i) {
            f[i] = 3.0 * normal(random);
            for (int k = 0; k < n; ++k)
                A(i, k) = normal(random);
        }
        for (int i = 0; i < m; ++i) {
            h[i] = -std::abs(normal(random));
            for (int k = 0; k < n; ++k)
                G(i, k) = normal(random);
        }
        const Eigen::MatrixXd H = A.transpose() * A + 0.5 * Eigen::MatrixXd::Identity(n, n);
        const auto solution = solveBounded(H, f, G, h);
        ASSERT_TRUE(solution.converged);
        EXPECT_GT((G * solution.y - h).minCoeff(), -1e-9);

        const Eigen::MatrixXd inverse = H.inverse();
        const Eigen::MatrixXd dual = G * inverse * G.transpose();
        const Eigen::VectorXd linear = G * inverse * f - h;
        Eigen::VectorXd price = Eigen::VectorXd::Zero(m);
        for (int sweep = 0; sweep < 4000; ++sweep)
            for (int i = 0; i < m; ++i)
                price[i] = std::max(0.0, price[i] - (dual.row(i).dot(price) + linear[i]) / dual(i, i));
        const Eigen::VectorXd y = inverse * (f + G.transpose() * price);
        const auto cost = [&](const Eigen::VectorXd& v) { return 0.5 * v.dot(H * v) - f.dot(v); };
        EXPECT_NEAR(cost(solution.y), cost(y), 1e-6 * (1.0 + std::abs(cost(y))));
    }
}

// Catches a working set of rows that depend on each other (a plate that lies on the clearance with all its
// corners and on the workspace's floor): its equations are singular, the step is not a number.
TEST(BoundedLeastSquares, RowsThatDependOnEachOtherAreNotHeldTogether) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 300; ++trial) {
        Eigen::MatrixXd A(4, 4), G(6, 4);
        Eigen::VectorXd f(4);
        for (int i = 0; i < 4; ++i) {
            f[i] = 1e3 * normal(random);
            for (int k = 0; k < 4; ++k)
                A(i, k) = normal(random) * std::pow(10.0, k);
        }
        G << 0, 0, 1, 0, 0, 0, 1, 0.05, 0, 0, 1, -0.025, 0, 0, 1, -0.02, 0, 0, 1, 0.031, 0, 0, 1, 1e-7;
        const Eigen::MatrixXd H = A.transpose() * A + 1e-2 * Eigen::MatrixXd::Identity(4, 4);
        const auto solution = solveBounded(H, f, G, Eigen::VectorXd::Zero(6));
        ASSERT_TRUE(solution.y.allFinite());
        EXPECT_TRUE(solution.converged);
        EXPECT_GT((G * solution.y).minCoeff(), -1e-9 * (1.0 + solution.y.norm()));
    }
}

TEST(BoundedLeastSquares, RefusesAnInfeasibleStart) {
    EXPECT_THROW((void)solveBounded(Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero(),
                                    Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(0.1, 0.0)),
                 std::invalid_argument);
}

} // namespace bask
