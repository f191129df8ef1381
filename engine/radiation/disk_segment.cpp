#include "engine/radiation/disk_field.h"

#include <algorithm>

namespace bask {

namespace {

// log(1 + x)/x, 1 at 0.
double log1pOver(double x) {
    return std::abs(x) < 1e-9 ? 1.0 - 0.5 * x : std::log1p(x) / x;
}

// v log|v| less v, and its integral.
double primitive(double v) {
    return v == 0.0 ? 0.0 : v * v * (0.5 * std::log(std::abs(v)) - 0.75);
}

} // namespace

DiskSegment::DiskSegment(double radius_m, const Pose& X_SO) : m_radius(radius_m) {
    const Eigen::Vector3d normal = -X_SO.linear().col(2);
    m_sinTilt = std::hypot(normal.x(), normal.y());
    m_normal3 = normal.z();
    const Eigen::Vector3d e1(normal.x() / m_sinTilt, normal.y() / m_sinTilt, 0.0);
    const Eigen::Vector3d e3 = Eigen::Vector3d::UnitZ();
    m_axes << e1, e3.cross(e1), e3;
    m_turn = m_axes.transpose() * X_SO.linear();
    m_origin = m_axes.transpose() * X_SO.translation() / radius_m;
    // Kept: cos(theta) > cosBeta, theta from e1.
    const double clearance = -normal.dot(X_SO.translation()) / radius_m;
    m_cosBeta = std::clamp(-clearance / m_sinTilt, -1.0, 1.0);
    m_sinBeta = std::sqrt((1.0 - m_cosBeta) * (1.0 + m_cosBeta));
    m_beta = std::atan2(m_sinBeta, m_cosBeta);
}

double DiskSegment::along_m(const Eigen::Vector2d& p) const {
    return m_radius * m_origin[1] + m_turn(1, 0) * p.x() + m_turn(1, 1) * p.y();
}

// The arc's integrals over psi, the angle from p's azimuth, with D = a - b cos(psi) the squared distance:
// of ln D sin, ln D cos (for W) and of 1/D, cos/D, sin/D (for B), each in closed form and regular at b = 0.
LoopSums DiskSegment::at(const OutlinePoint& point, bool arcOnly) const {
    const Eigen::Vector3d lever = m_turn.col(0) * point.x + m_turn.col(1) * point.y;
    const Eigen::Vector3d step = m_turn.col(0) * point.dx + m_turn.col(1) * point.dy;
    const Eigen::Vector3d p = m_origin + lever / m_radius;
    const double rho2 = p[0] * p[0] + p[1] * p[1];
    const double rho = std::sqrt(rho2);
    const double c = rho > 0.0 ? p[0] / rho : 1.0;
    const double s = rho > 0.0 ? p[1] / rho : 0.0;
    const double z = p[2];
    const double a = rho2 + z * z + 1.0;
    const double b = 2.0 * rho;
    const double t = a - 2.0;
    const double root = std::max(std::sqrt(t * t + 4.0 * z * z), 1e-150);
    const double kappa = b / (a + root);

    // psi at the arc's ends theta = -beta and +beta.
    const double cos0 = m_cosBeta * c - m_sinBeta * s, sin0 = -m_sinBeta * c - m_cosBeta * s;
    const double cos1 = m_cosBeta * c + m_sinBeta * s, sin1 = m_sinBeta * c - m_cosBeta * s;
    const double squared0 = std::max(
        (p[0] - m_cosBeta) * (p[0] - m_cosBeta) + (p[1] + m_sinBeta) * (p[1] + m_sinBeta) + z * z, 1e-300);
    const double squared1 = std::max(
        (p[0] - m_cosBeta) * (p[0] - m_cosBeta) + (p[1] - m_sinBeta) * (p[1] - m_sinBeta) + z * z, 1e-300);
    const double log0 = std::log(squared0);
    const double log1 = std::log(squared1);
    const double turn = 2.0 * m_beta;
    const double sinTurn = 2.0 * m_sinBeta * m_cosBeta;
    const double cosTurn = m_cosBeta * m_cosBeta - m_sinBeta * m_sinBeta;
    const double numerator = sin1 - sin0 - kappa * sinTurn;
    const double denominator = 1.0 - kappa * (cos0 + cos1) + kappa * kappa * cosTurn;
    const double swing = std::atan2(kappa * numerator, denominator);
    const double swingOverKappa = kappa > 1e-100 ? swing / kappa : numerator / denominator;

    // [D ln D - D]/b and [ln D]/b, taken from the farther end so that neither a small b nor a near end spoils
    // them.
    const double dCos = cos0 - cos1; // (D1 - D0)/b
    const bool from0 = squared0 >= squared1;
    const double far = from0 ? squared0 : squared1;
    const double ratio = b * (from0 ? dCos : -dCos) / far; // near/far - 1
    const double quotient = ratio > -0.5 ? log1pOver(ratio) : (from0 ? log1 - log0 : log0 - log1) / ratio;
    const double logOverB = dCos / far * quotient;
    const double wRho = -0.5 * dCos * ((from0 ? log1 : log0) + quotient - 1.0);
    const double wPhi = 0.5 * (sin1 * log1 - sin0 * log0 - (sin1 - sin0) - kappa * turn +
                               2.0 * root / (a + root) * swingOverKappa);

    const double inverse = (turn + 2.0 * swing) / root;
    const double cosine = (kappa * turn + 2.0 * a / (a + root) * swingOverKappa) / root;
    const double bRho = -z * cosine;
    const double bPhi = -z * logOverB;
    Eigen::Vector3d w(wRho * c - wPhi * s, wRho * s + wPhi * c, 0.0);
    Eigen::Vector3d field(bRho * c - bPhi * s, bRho * s + bPhi * c, rho * cosine - inverse);

    // Distance to the arc (to the whole rim at least), in radii.
    double distance = root / std::sqrt(z * z + (rho + 1.0) * (rho + 1.0));
    if (!arcOnly) {
        const double away =
            std::max(m_sinTilt * z - m_normal3 * (p[0] - m_cosBeta), 0.0); // from the chord's line
        const double end1 = m_sinBeta - p[1];
        const double end0 = -m_sinBeta - p[1];
        const double angle = std::atan2(away * 2.0 * m_sinBeta, away * away + end0 * end1);
        w[1] -= 0.5 * (end1 * log1 - end0 * log0) - 2.0 * m_sinBeta + away * angle;
        field += angle * Eigen::Vector3d(m_sinTilt, 0.0, m_normal3);
        const double beyond = std::max({0.0, -end1, end0});
        distance = std::min(distance, std::hypot(away, beyond));
    }

    const Eigen::Vector3d force = step.cross(field);
    const Eigen::Vector3d torque = lever.cross(force);
    return {.circulation = m_radius * w.dot(step),
            .moments = {force[0], force[1], force[2], torque[0], torque[1], torque[2]},
            .distance_m = m_radius * distance};
}

LoopSums DiskSegment::sums(const OutlinePoints& points) const {
    LoopSums sum;
    for (int i = 0; i < points.count; ++i)
        sum.add(at({points.x[i], points.y[i], points.dx[i], points.dy[i]}));
    return sum;
}

// Both lie on one line: the double integral of ln|u - s| and the overlap, where the chord is seen under the
// angle pi.
LoopSums DiskSegment::chordAlongItself(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    const double from = along_m(a) / m_radius;
    const double to = along_m(b) / m_radius;
    const auto potential = [&](double u) { return primitive(u + m_sinBeta) - primitive(u - m_sinBeta); };
    LoopSums sum;
    sum.circulation = -m_radius * m_radius * (potential(to) - potential(from));
    const double u0 = std::clamp(from, -m_sinBeta, m_sinBeta);
    const double u1 = std::clamp(to, -m_sinBeta, m_sinBeta);
    if (u0 != u1) {
        const Eigen::Vector3d normal(m_sinTilt, 0.0, m_normal3);
        const Eigen::Vector3d force =
            std::numbers::pi * m_radius * (u1 - u0) * Eigen::Vector3d::UnitY().cross(normal);
        const Eigen::Vector3d lever =
            m_radius * (Eigen::Vector3d(m_cosBeta, 0.5 * (u0 + u1), 0.0) - m_origin);
        const Eigen::Vector3d torque = lever.cross(force);
        sum.moments = {force[0], force[1], force[2], torque[0], torque[1], torque[2]};
    }
    return sum;
}

} // namespace bask
