#include "engine/control/bounded_least_squares.h"

#include <Eigen/LU>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace bask {
namespace {

/// Step p and multipliers of min (y+p)'H(y+p)/2 - f'(y+p) with the working rows held.
struct KktStep {
    Eigen::VectorXd p;
    Eigen::VectorXd multipliers;
};

KktStep kktStep(const Eigen::MatrixXd& H, const Eigen::VectorXd& residual, const Eigen::MatrixXd& G,
                const std::vector<int>& working) {
    const auto n = H.rows();
    const auto m = static_cast<Eigen::Index>(working.size());
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + m, n + m);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n + m);
    K.topLeftCorner(n, n) = H;
    rhs.head(n) = residual;
    for (Eigen::Index i = 0; i < m; ++i) {
        K.block(0, n + i, n, 1) = -G.row(working[static_cast<std::size_t>(i)]).transpose();
        K.block(n + i, 0, 1, n) = G.row(working[static_cast<std::size_t>(i)]);
    }
    const Eigen::VectorXd solution = K.partialPivLu().solve(rhs);
    return {solution.head(n), solution.tail(m)};
}

} // namespace

BoundedSolution solveBounded(const Eigen::MatrixXd& H, const Eigen::VectorXd& f, const Eigen::MatrixXd& G,
                             const Eigen::VectorXd& h) {
    if (h.size() > 0 && h.maxCoeff() > 0.0)
        throw std::invalid_argument("solveBounded: zero must be feasible");
    BoundedSolution out;
    out.y = Eigen::VectorXd::Zero(H.rows());
    std::vector<int> working;
    const int maxSteps = 20 * static_cast<int>(h.size() + H.rows() + 1);
    for (int step = 0; step < maxSteps; ++step) {
        const KktStep kkt = kktStep(H, f - H * out.y, G, working);
        if (kkt.p.norm() <= 1e-12 * (1.0 + out.y.norm())) {
            Eigen::Index worst = 0;
            if (working.empty() || kkt.multipliers.minCoeff(&worst) >= -1e-12) {
                out.converged = true;
                break;
            }
            working.erase(working.begin() + worst);
            continue;
        }
        double length = 1.0;
        int blocking = -1;
        for (int i = 0; i < h.size(); ++i) {
            if (std::ranges::find(working, i) != working.end())
                continue;
            const double slope = G.row(i).dot(kkt.p);
            if (slope >= -1e-14)
                continue;
            const double reach = std::max(0.0, (h[i] - G.row(i).dot(out.y)) / slope);
            if (reach < length) {
                length = reach;
                blocking = i;
            }
        }
        out.y += length * kkt.p;
        if (blocking >= 0)
            working.push_back(blocking);
    }
    out.constrained = !working.empty();
    return out;
}

} // namespace bask
