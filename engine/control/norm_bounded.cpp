#include "engine/control/norm_bounded.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr int kMaxSteps = 60;
constexpr double kGap = 1e-12;      ///< of the scaled objective
constexpr double kResidual = 1e-9;  ///< of stationarity and of the bounds, scaled
constexpr double kBoundary = 0.995; ///< of the way to the boundary of s, z > 0
constexpr double kMaxChange = 1.0;  ///< of an unknown in one step: from farther off the norms look too flat

/// The program with every row of unit size and an objective of slope about 1.
class Program {
public:
    Program(const SmallMatrix& H, const SmallVector& f, const SmallRows& G, const RowVector& h,
            const std::vector<NormBound>& norms)
        : m_norms(norms), m_linear(G.rows()) {
        const double size =
            std::max({H.cwiseAbs().maxCoeff(), f.cwiseAbs().maxCoeff(), std::numeric_limits<double>::min()});
        m_H = H / size;
        m_f = f / size;
        m_rows.resize(m_linear + static_cast<Eigen::Index>(norms.size()), f.size());
        m_rows.topRows(m_linear) = G;
        m_h = h;
        for (Eigen::Index i = 0; i < m_linear; ++i) {
            const double norm = std::max(G.row(i).norm(), 1e-12);
            m_rows.row(i) /= norm;
            m_h[i] /= norm;
        }
    }

    Eigen::Index rows() const { return m_rows.rows(); }
    const SmallMatrix& H() const { return m_H; }
    const SmallVector& f() const { return m_f; }

    /// c(y) >= 0 are the bounds; `gradient` gets their derivatives.
    void evaluate(const SmallVector& y, RowVector& c, SmallRows& gradient) {
        c.resize(rows());
        c.head(m_linear) = m_rows.topRows(m_linear) * y - m_h;
        for (std::size_t j = 0; j < m_norms.size(); ++j) {
            const NormBound& norm = m_norms[j];
            const auto i = m_linear + static_cast<Eigen::Index>(j);
            const Eigen::Vector3d r = (norm.B * y - norm.b) / norm.radius;
            c[i] = 1.0 - r.squaredNorm();
            m_rows.row(i) = -2.0 / norm.radius * (r.transpose() * norm.B);
        }
        gradient = m_rows;
    }

    /// Hessian of the Lagrangian.
    SmallMatrix curvature(const RowVector& z) const {
        SmallMatrix out = m_H;
        for (std::size_t j = 0; j < m_norms.size(); ++j) {
            const NormBound& norm = m_norms[j];
            const double weight =
                2.0 * z[m_linear + static_cast<Eigen::Index>(j)] / (norm.radius * norm.radius);
            out.noalias() += weight * norm.B.transpose() * norm.B;
        }
        return out;
    }

private:
    SmallMatrix m_H;
    SmallVector m_f;
    SmallRows m_rows;
    RowVector m_h;
    const std::vector<NormBound>& m_norms;
    Eigen::Index m_linear;
};

/// Largest step, at most 1, that keeps value + step * change >= 0.
double longestStep(const RowVector& value, const RowVector& change) {
    double step = 1.0;
    for (Eigen::Index i = 0; i < value.size(); ++i)
        if (change[i] < 0.0)
            step = std::min(step, -value[i] / change[i]);
    return step;
}

} // namespace

NormBoundedSolution solveNormBounded(const SmallMatrix& H, const SmallVector& f, const SmallRows& G,
                                     const RowVector& h, const std::vector<NormBound>& norms) {
    if (G.rows() != h.size() || G.rows() + static_cast<Eigen::Index>(norms.size()) > kMaxRows)
        throw std::invalid_argument("solveNormBounded: too many bounds");
    Program program(H, f, G, h, norms);
    NormBoundedSolution out;
    RowVector c;
    SmallRows J;
    out.y = program.H().llt().solve(program.f());
    program.evaluate(out.y, c, J);
    if (c.size() == 0 || c.minCoeff() >= 0.0) { // usually no bound is active
        out.converged = true;
        return out;
    }
    out.y.setZero();
    program.evaluate(out.y, c, J);
    RowVector s = c.cwiseMax(0.1);
    RowVector z = s.cwiseInverse() * 0.1;
    const auto count = static_cast<double>(c.size());
    for (int step = 0; step < kMaxSteps; ++step) {
        const RowVector gap = c - s;
        const SmallVector slope = program.H() * out.y - program.f() - J.transpose() * z;
        const double mu = s.dot(z) / count;
        if (mu < kGap && gap.cwiseAbs().maxCoeff() < kResidual &&
            slope.cwiseAbs().maxCoeff() < kResidual * (1.0 + z.maxCoeff())) {
            out.converged = true;
            break;
        }
        const RowVector ratio = z.cwiseQuotient(s);
        SmallMatrix K = program.curvature(z);
        K.noalias() += J.transpose() * ratio.asDiagonal() * J;
        const Eigen::LLT<SmallMatrix> factor(K);
        SmallVector dy;
        RowVector ds, dz;
        const auto newton = [&](const RowVector& centre) { // centre: wanted s z beyond 0
            const RowVector pull = centre.cwiseQuotient(s) - z;
            dy = factor.solve(-slope + J.transpose() * (pull - ratio.cwiseProduct(gap)));
            ds = gap + J * dy;
            dz = pull - ratio.cwiseProduct(ds);
        };
        newton(RowVector::Zero(c.size()));
        const double reach = std::min(longestStep(s, ds), longestStep(z, dz));
        const double ahead = (s + reach * ds).dot(z + reach * dz) / count;
        const double centring = std::pow(std::max(ahead, 0.0) / mu, 3);
        newton(RowVector::Constant(c.size(), centring * mu) - ds.cwiseProduct(dz));
        const double reachable = kBoundary * std::min(longestStep(s, ds), longestStep(z, dz));
        const double length = std::min({1.0, reachable, kMaxChange / dy.cwiseAbs().maxCoeff()});
        if (!std::isfinite(length) || !dy.allFinite())
            break;
        out.y += length * dy;
        s += length * ds;
        z += length * dz;
        program.evaluate(out.y, c, J);
    }
    for (Eigen::Index i = 0; i < z.size(); ++i)
        if (z[i] > s[i] && s[i] < 1e-6)
            out.active.push_back(static_cast<int>(i));
    return out;
}

} // namespace bask
