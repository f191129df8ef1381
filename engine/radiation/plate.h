#pragma once
// What shade needs of a plate's shape, prepared once.

#include "engine/radiation/sight_figure.h"
#include "engine/radiation/view_factor.h"

namespace bask {

struct PlateOutline {
    SightOutline outline;
    double error = 0.0; ///< estimated, of a shadow's flux, relative
};

/// A point of a face and the area for which it stands: negative where a hole or a bay takes away.
struct FaceNode {
    Eigen::Vector2d at; ///< m
    double area_m2 = 0.0;
};

/// Immutable.
class Plate {
public:
    explicit Plate(const Shape& shape);

    /// Returns the outline with as many corners as the tolerance (of a view factor) asks for.
    const PlateOutline& outline(double tolerance) const {
        return tolerance < kFineBelow ? m_fine : tolerance < kCoarseFrom ? m_medium : m_coarse;
    }
    const SightOutline& roughOutline() const { return m_rough; } ///< to about a thousandth of a shadow
    /// Returns the other side, in the frame turned by half a turn about x.
    const RadiatingContour& back() const { return m_back; }
    /// Returns whether it is known to be convex and without holes: a Fourier outline never is.
    bool isConvex() const { return m_isConvex; }
    /// Returns the nodes of a rough rule over the face; their areas add up to its own.
    const std::vector<FaceNode>& faceNodes() const { return m_faceNodes; }
    double reach_m() const { return m_reach; } ///< largest distance of a point from the origin
    /// Returns how far (m, along d from S's origin) a point may lie at most.
    double reachAlong_m(const Pose& X_S, const Eigen::Vector3d& d) const {
        return m_hull.empty()
                   ? X_S.translation().dot(d) + m_reach * (X_S.linear().leftCols<2>().transpose() * d).norm()
                   : farthest(X_S, d).dot(d) + margin_m(X_S, d);
    }
    /// Returns the point (S, m) of the convex hull that lies farthest along d, a unit vector.
    Eigen::Vector3d farthest(const Pose& X_S, const Eigen::Vector3d& d) const;
    /// Returns how much farther (m) than that a point may lie.
    double margin_m(const Pose& X_S, const Eigen::Vector3d& d) const {
        return m_margin == 0.0 ? 0.0 : m_margin * (X_S.linear().leftCols<2>().transpose() * d).norm();
    }

private:
    static constexpr double kFineBelow = 3e-7, kCoarseFrom = 3e-6;

    PlateOutline m_coarse, m_medium, m_fine;
    SightOutline m_rough;
    RadiatingContour m_back;
    std::vector<FaceNode> m_faceNodes;
    std::vector<Eigen::Vector2d> m_hull; // contains it to the margin; of a disk empty
    double m_margin = 0.0;
    bool m_isConvex = false;
    double m_reach = 0.0;
};

} // namespace bask
