#include "engine/control/bounded_least_squares.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace bask {
namespace {

/// Step p and multipliers of min (y+p)'H(y+p)/2 - f'(y+p) with the working rows as equalities.
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

/// Whether row i is a linear combination of the working rows: then only rounding makes a step along them
/// violate it.
bool depends(const Eigen::MatrixXd& G, const std::vector<int>& working, int i) {
    constexpr double kDependent = 1e-9; // relative to the row's length
    if (working.empty())
        return false;
    Eigen::MatrixXd held(G.cols(), static_cast<Eigen::Index>(working.size()));
    for (Eigen::Index k = 0; k < held.cols(); ++k)
        held.col(k) = G.row(working[static_cast<std::size_t>(k)]).transpose();
    const Eigen::VectorXd row = G.row(i).transpose();
    const Eigen::VectorXd share = held.colPivHouseholderQr().solve(row);
    return (row - held * share).norm() <= kDependent * row.norm();
}

/// Index in `working` of the row with the smallest number that has a multiplier of the wrong sign, or -1. The
/// smallest number (Bland's rule) prevents cycles where many rows meet.
int wrongRow(const std::vector<int>& working, const Eigen::VectorXd& multipliers, double tolerance) {
    int wrong = -1;
    for (int k = 0; k < static_cast<int>(working.size()); ++k) {
        const bool earlier =
            wrong < 0 || working[static_cast<std::size_t>(k)] < working[static_cast<std::size_t>(wrong)];
        if (multipliers[k] < -tolerance && earlier)
            wrong = k;
    }
    return wrong;
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
    for (int step = 0; step < maxSteps && !out.converged; ++step) {
        const KktStep kkt = kktStep(H, f - H * out.y, G, working);
        double length = 1.0;
        int blocking = -1;
        for (int i = 0; i < h.size(); ++i) {
            if (std::ranges::find(working, i) != working.end())
                continue;
            const double slope = G.row(i).dot(kkt.p);
            if (slope >= -1e-14)
                continue;
            const double reach = std::max(0.0, (h[i] - G.row(i).dot(out.y)) / slope);
            if (reach < length && !depends(G, working, i)) {
                length = reach;
                blocking = i;
            }
        }
        out.y += length * kkt.p;
        if (blocking >= 0) {
            working.push_back(blocking);
            continue;
        }
        const int wrong = wrongRow(working, kkt.multipliers, 1e-10 * f.norm());
        out.converged = wrong < 0;
        if (wrong >= 0)
            working.erase(working.begin() + wrong);
    }
    out.constrained = !working.empty();
    return out;
}

} // namespace bask
