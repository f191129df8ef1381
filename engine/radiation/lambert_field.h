#pragma once
// Lambert's integral of r x dr / |r|^2 along a line, r being the way from a point to it, in closed form.
// Round a figure it is twice the integral of the directions over the solid angle of the figure.

#include <Eigen/Core>

namespace bask {

/// Along the straight line from r = a to r = b.
Eigen::Vector3d straightField(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// Along arcs of a circle about the origin, as seen from p, both in the circle's frame: |r|^2 is a - b
/// cos(angle), and the integrals of 1, cos and sin over it are elementary.
class ArcField {
public:
    ArcField(double radius, const Eigen::Vector3d& p);

    Eigen::Vector3d whole() const;
    /// From one unit vector to another, counter-clockwise, by more than half a turn or not.
    Eigen::Vector3d between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool isLong) const;

private:
    Eigen::Vector2d rotated(const Eigen::Vector2d& u) const {
        return {u.dot(m_azimuth), u.y() * m_azimuth.x() - u.x() * m_azimuth.y()};
    }
    Eigen::Vector3d assembled(double turn, double swing, double sine) const;

    double m_radius, m_z, m_rho, m_a, m_b, m_s;
    Eigen::Vector2d m_azimuth;
};

} // namespace bask
