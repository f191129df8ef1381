#pragma once
// Small convex quadratic programs under linear inequalities and bounds on norms, by a primal-dual interior
// point.

#include <Eigen/Core>

#include <vector>

namespace bask {

inline constexpr int kMaxUnknowns = 6;
inline constexpr int kMaxRows = 32; ///< linear ones and norms together

using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxUnknowns, 1>;
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxUnknowns, kMaxUnknowns>;
using SmallRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxRows, kMaxUnknowns>;
using RowVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxRows, 1>;

/// |B y - b| <= radius.
struct NormBound {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxUnknowns> B;
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double radius = 1.0;
};

/// Minimiser of y'Hy/2 - f'y with G y >= h and every norm within its bound.
struct NormBoundedSolution {
    SmallVector y;
    std::vector<int> active; ///< rows of G, then norms, that are active at the minimum; sorted
    bool converged = false;  ///< otherwise y may violate a bound
};

/// Solves the program, whose unknowns should be of the size of their bounds (a step changes none by more than
/// 1). H: n x n symmetric positive definite, G: m x n, h: m; n at most 6, m and the norms
/// together at most 32 (throws std::invalid_argument otherwise). The bounds are satisfied within about 1e-9
/// of their own size. The feasible set may be a single point, but not empty. Source: Nocedal & Wright,
/// Numerical Optimization, section 16.6 (Mehrotra's predictor and corrector), with the norms' curvature in
/// the Hessian of the Lagrangian.
NormBoundedSolution solveNormBounded(const SmallMatrix& H, const SmallVector& f, const SmallRows& G,
                                     const RowVector& h, const std::vector<NormBound>& norms);

} // namespace bask
