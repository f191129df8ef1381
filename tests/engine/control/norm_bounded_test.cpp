// The interior point against a method of another kind: projected gradient, projecting by Dykstra's algorithm.

#include "engine/control/norm_bounded.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace bask {
namespace {

struct Program {
    SmallMatrix H;
    SmallVector f;
    SmallRows G;
    RowVector h;
    std::vector<NormBound> norms; ///< of coordinate subsets, so that projecting on one is elementary

    double cost(const SmallVector& y) const { return 0.5 * y.dot(H * y) - f.dot(y); }
    double violation(const SmallVector& y) const {
        double worst = std::max(0.0, -(G * y - h).minCoeff());
        for (const NormBound& norm : norms)
            worst = std::max(worst, (norm.B * y - norm.b).norm() - norm.radius);
        return worst;
    }
    /// Nearest point to y that meets bound `i` alone.
    SmallVector projected(SmallVector y, Eigen::Index i) const {
        if (i < G.rows()) {
            const double missing = h[i] - G.row(i).dot(y);
            return missing <= 0.0 ? y
                                  : SmallVector(y + missing / G.row(i).squaredNorm() * G.row(i).transpose());
        }
        const NormBound& norm = norms[static_cast<std::size_t>(i - G.rows())];
        const Eigen::Vector3d r = norm.B * y - norm.b;
        return r.norm() <= norm.radius
                   ? y
                   : SmallVector(y - (1.0 - norm.radius / r.norm()) * norm.B.transpose() * r);
    }
    /// Nearest point that meets all.
    SmallVector projected(SmallVector y) const {
        const auto count = G.rows() + static_cast<Eigen::Index>(norms.size());
        std::vector<SmallVector> correction(static_cast<std::size_t>(count), SmallVector::Zero(y.size()));
        for (int sweep = 0; sweep < 3000; ++sweep) {
            const SmallVector before = y;
            for (Eigen::Index i = 0; i < count; ++i) {
                SmallVector& c = correction[static_cast<std::size_t>(i)];
                const SmallVector from = y + c;
                y = projected(from, i);
                c = from - y;
            }
            if ((y - before).norm() < 1e-13)
                break;
        }
        return y;
    }
    SmallVector slowMinimum() const {
        const double steepest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues().maxCoeff();
        SmallVector y = projected(SmallVector::Zero(f.size()));
        for (int step = 0; step < 3000; ++step) {
            const SmallVector next = projected(y - (H * y - f) / steepest);
            if ((next - y).norm() < 1e-12)
                break;
            y = next;
        }
        return y;
    }
};

NormBound normOf(Eigen::Index from, Eigen::Index count, Eigen::Index n) {
    NormBound norm;
    norm.B.setZero(3, n);
    for (Eigen::Index k = 0; k < count; ++k)
        norm.B(k, from + k) = 1.0;
    return norm;
}

/// Like a velocity solve: a box about 0, slanted rows, two norms about 0 and two small ones about another
/// point.
Program randomProgram(std::mt19937& random) {
    std::normal_distribution<double> normal;
    const Eigen::Index n = 6;
    Program p;
    const SmallMatrix A = SmallMatrix::NullaryExpr(3, n, [&] { return normal(random); });
    p.H = A.transpose() * A + 0.05 * SmallMatrix::Identity(n, n);
    p.f = SmallVector::NullaryExpr(n, [&] { return std::exp(normal(random)) * normal(random); });
    p.G.setZero(2 * n + 2, n);
    p.G.topRows(n).setIdentity();
    p.G.middleRows(n, n) = -SmallMatrix::Identity(n, n);
    p.G.bottomRows(2) = SmallRows::NullaryExpr(2, n, [&] { return normal(random); });
    p.h = RowVector::NullaryExpr(2 * n + 2, [&] { return -std::abs(normal(random)); });
    for (const Eigen::Index from : {Eigen::Index(0), Eigen::Index(3)}) {
        p.norms.push_back(normOf(from, 3, n));
        p.norms.push_back(normOf(from, 3, n));
        p.norms.back().radius = 0.3;
        p.norms.back().b =
            0.29 * Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    }
    return p;
}

} // namespace

TEST(NormBounded, AgreesWithProjectedGradient) {
    std::mt19937 random(17);
    int clamped = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Program p = randomProgram(random);
        const auto fast = solveNormBounded(p.H, p.f, p.G, p.h, p.norms);
        ASSERT_TRUE(fast.converged) << trial;
        EXPECT_LT(p.violation(fast.y), 1e-8) << trial;
        const SmallVector slow = p.slowMinimum();
        EXPECT_NEAR(p.cost(fast.y), p.cost(slow), 1e-7 * (1.0 + std::abs(p.cost(slow)))) << trial;
        EXPECT_LT((fast.y - slow).norm(), 1e-4) << trial;
        clamped += fast.active.size() >= 2 ? 1 : 0;
    }
    EXPECT_GT(clamped, 30); // several bounds at once in most
}

// Catches an iteration that circles far outside of the norms: rates that a flat tilt can hardly change ask
// for steps of many times what the robot may do.
TEST(NormBounded, ConvergesWhereMuchMoreIsWantedThanAllowed) {
    std::mt19937 random(29);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 3000; ++trial) {
        Program p = randomProgram(random);
        const SmallMatrix A = SmallMatrix::NullaryExpr(3, 6, [&] { return normal(random); });
        p.H = A.transpose() * A + 1e-6 * SmallMatrix::Identity(6, 6);
        p.f = 10.0 * A.transpose() * SmallVector::NullaryExpr(3, [&] { return normal(random); });
        if (trial % 2 == 0) // at the floor
            p.h.tail(3).setZero();
        p.norms = {p.norms[0], p.norms[2]};
        const auto solution = solveNormBounded(p.H, p.f, p.G, p.h, p.norms);
        ASSERT_TRUE(solution.converged) << trial;
        EXPECT_LT(p.violation(solution.y), 1e-8) << trial;
        if (trial % 100 == 0) { // no small step within the bounds is better
            const SmallVector ahead = p.projected(solution.y - 1e-3 * (p.H * solution.y - p.f));
            EXPECT_GE(p.cost(ahead), p.cost(solution.y) - 1e-6 * (1.0 + std::abs(p.cost(solution.y))))
                << trial;
        }
    }
}

TEST(NormBounded, TellsWhichBoundsHoldItBack) {
    Program p;
    p.H = SmallMatrix::Identity(3, 3);
    p.f = Eigen::Vector3d(5.0, 0.5, 0.0);
    p.G.setIdentity(3, 3);
    p.h = RowVector::Constant(3, -10.0);
    p.norms = {normOf(0, 3, 3)};
    auto solution = solveNormBounded(p.H, p.f, p.G, p.h, p.norms);
    EXPECT_EQ(solution.active, std::vector<int>{3});
    EXPECT_LT((solution.y - p.f.normalized()).norm(), 1e-8);
    p.h[1] = 0.2; // and 0 need not be feasible
    solution = solveNormBounded(p.H, p.f, p.G, p.h, p.norms);
    EXPECT_EQ(solution.active, (std::vector<int>{1, 3}));
    p.f *= 0.1;
    p.h[1] = -1.0;
    EXPECT_TRUE(solveNormBounded(p.H, p.f, p.G, p.h, p.norms).active.empty());
}

TEST(NormBounded, FindsTheOnlyPointThereIs) {
    // A robot of one axis that brakes at full strength before a wall: ball and row meet in one point.
    Program p;
    p.H = SmallMatrix::Identity(1, 1);
    p.f = SmallVector::Constant(1, 30.0);
    p.G = SmallRows::Constant(1, 1, -1.0);
    p.h = RowVector::Zero(1);
    p.norms = {normOf(0, 1, 1)};
    p.norms[0].b[0] = 1.0;
    const auto solution = solveNormBounded(p.H, p.f, p.G, p.h, p.norms);
    ASSERT_TRUE(solution.converged);
    EXPECT_NEAR(solution.y[0], 0.0, 1e-6);
}

TEST(NormBounded, RefusesMoreBoundsThanItHasRoomFor) {
    EXPECT_THROW((void)solveNormBounded(SmallMatrix::Identity(1, 1), SmallVector::Zero(1),
                                        SmallRows::Zero(kMaxRows, 1), RowVector::Zero(kMaxRows),
                                        {normOf(0, 1, 1)}),
                 std::invalid_argument);
}

} // namespace bask
