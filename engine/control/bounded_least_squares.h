#pragma once
// Small strictly convex quadratic programs under linear inequalities, by a primal active set.

#include <Eigen/Core>

namespace bask {

/// Minimiser of y'Hy/2 - f'y with G y >= h.
struct BoundedSolution {
    Eigen::VectorXd y;
    bool constrained = false; ///< an inequality is active at the minimum
    bool converged = false;   ///< optimal; otherwise y is feasible, but not the minimum
};

/// Solves the program. H: n x n symmetric positive definite, G: m x n, h: m with every h <= 0, so that y = 0
/// is feasible (throws std::invalid_argument otherwise). Source: Nocedal & Wright, Numerical Optimization,
/// algorithm 16.3.
BoundedSolution solveBounded(const Eigen::MatrixXd& H, const Eigen::VectorXd& f, const Eigen::MatrixXd& G,
                             const Eigen::VectorXd& h);

} // namespace bask
