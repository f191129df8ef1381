#include "engine/radiation/lambert_field.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr double kWholeCircle = 2.0 * std::numbers::pi;

} // namespace

Eigen::Vector3d straightField(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d cross = a.cross(b);
    const double length = cross.norm();
    const double dot = a.dot(b);
    if (length == 0.0)
        return Eigen::Vector3d::Zero();
    if (length < 0.1 * dot) { // atan(x)/x for a small x
        const double x2 = (length / dot) * (length / dot);
        return (1.0 -
                x2 * (1.0 / 3.0 -
                      x2 * (0.2 - x2 * (1.0 / 7.0 - x2 * (1.0 / 9.0 - x2 * (1.0 / 11.0 - x2 / 13.0)))))) /
               dot * cross;
    }
    return std::atan2(length, dot) / length * cross;
}

ArcField::ArcField(double radius, const Eigen::Vector3d& p)
    : m_radius(radius), m_z(p.z()), m_rho(std::hypot(p.x(), p.y())),
      m_azimuth(m_rho > 0.0 ? Eigen::Vector2d(p.head<2>() / m_rho) : Eigen::Vector2d(1.0, 0.0)) {
    m_a = m_rho * m_rho + m_z * m_z + radius * radius;
    m_b = 2.0 * radius * m_rho;
    m_s = std::sqrt(((radius - m_rho) * (radius - m_rho) + m_z * m_z) *
                    ((radius + m_rho) * (radius + m_rho) + m_z * m_z));
}

Eigen::Vector3d ArcField::whole() const {
    return assembled(kWholeCircle, 0.0, 0.0);
}

Eigen::Vector3d ArcField::between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool isLong) const {
    double turn = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
    if (isLong && turn < 1.0) // not where rounding makes a whole turn a little more
        turn += kWholeCircle;
    const Eigen::Vector2d a = rotated(from), b = rotated(to);
    const double q = 1.0 / (m_a + m_s);
    const double ratio = m_b * q;
    double swing; // over b
    if (ratio > 1e-12) {
        const Eigen::Vector2d za(1.0 - ratio * a.x(), ratio * a.y()), zb(1.0 - ratio * b.x(), ratio * b.y());
        swing = std::atan2(za.x() * zb.y() - za.y() * zb.x(), za.dot(zb)) / m_b;
    } else {
        swing = q * (b.y() - a.y());
    }
    const double step = (a.x() - b.x()) / (m_a - m_b * a.x());
    const double sine =
        std::abs(m_b * step) > 1e-9 ? std::log1p(m_b * step) / m_b : step * (1.0 - 0.5 * m_b * step);
    return assembled(turn, swing, sine);
}

Eigen::Vector3d ArcField::assembled(double turn, double swing, double sine) const {
    const double cosine = (turn * m_b / (m_a + m_s) + 2.0 * m_a * swing) / m_s;
    const double one = (turn + 2.0 * m_b * swing) / m_s;
    const double along = m_z * m_radius * cosine;
    const double across = m_z * m_radius * sine;
    return {m_azimuth.x() * along - m_azimuth.y() * across, m_azimuth.y() * along + m_azimuth.x() * across,
            m_radius * m_radius * one - m_rho * m_radius * cosine};
}

} // namespace bask
