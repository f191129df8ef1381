#pragma once
// The part of the source in front of the object's plane, one class for each kind of source: distance to its
// outline and sums of its field over points of the object's outline. All three have the same functions for
// the integrator (outline_integral.h).

#include "engine/radiation/gauss_rule.h"
#include "engine/radiation/outline_table.h"

#include <Eigen/Geometry>

#include <array>
#include <numbers>
#include <utility>
#include <vector>

namespace bask {

/// The positions of the two planes: O in S, and the height of the source's points in front of the object's
/// plane as a plane over S.
struct Sight {
    const Pose& X_SO;
    HeightPlane overObject; ///< of points of the source's plane, S
    HeightPlane overSource; ///< of points of the object's plane, O

    explicit Sight(const Pose& X)
        : X_SO(X), overObject{X.linear().col(2).dot(X.translation()), -X.linear()(0, 2), -X.linear()(1, 2)},
          overSource{X.translation().z(), X.linear()(2, 0), X.linear()(2, 1)} {}
};

/// Whole disk, closed form.
class WholeDiskSource {
public:
    WholeDiskSource(double radius_m, const Pose& X_SO)
        : m_radius(radius_m), m_factor(-2.0 * std::numbers::pi * radius_m * radius_m), m_R(X_SO.linear()),
          m_disk(seen(radius_m, X_SO)) {}

    /// The disk in O axes; inlined, so that it gets to the kernel in registers.
    [[gnu::always_inline]] static kernels::WholeDisk seen(double radius_m, const Pose& X_SO) {
        const auto R = X_SO.linear();
        const auto p = X_SO.translation();
        return {radius_m * radius_m,
                {R.col(0).dot(p), R.col(1).dot(p), R.col(2).dot(p)},
                {R(2, 0), R(2, 1), R(2, 2)}};
    }

    /// Returns a lower bound of the distance (m) of a point of S to the visible outline, without the edges
    /// that are followed.
    double distance_m(const Eigen::Vector3d& p_S) const {
        const double aside = std::sqrt(p_S.x() * p_S.x() + p_S.y() * p_S.y()) - m_radius;
        return std::sqrt(aside * aside + p_S.z() * p_S.z());
    }
    /// Declares that the next points lie on the line through a and b (S; on none if they are equal); `onCut`:
    /// this is where the planes meet. Edges on that line are followed: the potential along them is regular.
    void follow(const Eigen::Vector3d& /*a*/, const Eigen::Vector3d& /*b*/, bool /*onCut*/) {}
    /// Prepares for points within `radius_m` of `centre_S` at a distance of at least `nearest_m` from the
    /// outline, to a relative error exp(-exponent). Returns the exponent reached.
    double prepare(const Eigen::Vector3d& /*centre_S*/, double /*radius_m*/, double /*nearest_m*/,
                   double exponent) {
        return exponent;
    }
    bool closedForm() const { return true; } ///< the field is exact at any distance
    double value(const kernels::Outline& points) const {
        return kernels::kernels().diskValue(m_disk, points);
    }
    kernels::Sums sums(const kernels::Outline& points, bool /*onCut*/) const {
        return kernels::kernels().diskSums(m_disk, points);
    }
    double circulation(double value) const { return m_factor * value; } ///< m2
    Vector6d moments(const double* raw) const;                          ///< force (m), torque about O (m2), S
    /// Returns the field of the source's outline on the line of a straight piece from a to b (S) of the
    /// object: moments as above.
    Vector6d alongCut(const Eigen::Vector3d& /*a*/, const Eigen::Vector3d& /*b*/) const {
        return Vector6d::Zero();
    }

private:
    double m_radius, m_factor;
    Eigen::Matrix3d m_R;
    kernels::WholeDisk m_disk;
};

/// Segment of a disk cut by the object's plane, closed form.
class DiskSegmentSource {
public:
    DiskSegmentSource(double radius_m, const Sight& sight);

    double distance_m(const Eigen::Vector3d& p_S) const;
    void follow(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool onCut);
    double prepare(const Eigen::Vector3d&, double, double, double exponent) { return exponent; }
    bool closedForm() const { return true; }
    double value(const kernels::Outline& points) const {
        return kernels::kernels().segmentValue(m_segment, points);
    }
    kernels::Sums sums(const kernels::Outline& points, bool onCut) const {
        return kernels::kernels().segmentSums(m_segment, points, onCut);
    }
    double circulation(double value) const { return m_radius * value; }
    Vector6d moments(const double* raw) const;
    Vector6d alongCut(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

private:
    double m_radius;
    Eigen::Matrix3d m_axes; // e1, e2, e3 in S
    Eigen::Vector3d m_normal, m_o;
    kernels::Segment m_segment;
    kernels::Edge m_chord;
    bool m_chordFollowed = false;
};

/// Fourier contour or polygon, whole or cut: nodes on smooth parts, closed form on straight parts.
class LoopSource {
public:
    /// `cut`: the object's plane crosses the outline.
    LoopSource(const RadiatingContour::Impl& source, const Sight& sight, bool cut);
    LoopSource(const LoopSource&) = delete; // refers to its own edges and nodes
    LoopSource& operator=(const LoopSource&) = delete;

    double distance_m(const Eigen::Vector3d& p_S) const;
    void follow(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool onCut);
    double prepare(const Eigen::Vector3d& centre_S, double radius_m, double nearest_m, double exponent);
    bool closedForm() const { return m_smooth.empty(); }
    double value(const kernels::Outline& points) const {
        return kernels::kernels().loopValue(m_loop, m_placement, points);
    }
    kernels::Sums sums(const kernels::Outline& points, bool onCut) const {
        return kernels::kernels().loopSums(m_loop, m_placement, points, onCut);
    }
    double circulation(double value) const { return value; }
    Vector6d moments(const double* raw) const { return Eigen::Map<const Vector6d>(raw); }
    Vector6d alongCut(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

private:
    /// A part of a smooth stretch. Its nodes are computed once and serve all points of the object, most of
    /// which need the same.
    struct Panel {
        double from, to;
        OutlinePoint middle;
        int halves = -1; ///< the first of the two; -1: not halved yet
        /// First node of the rule of n points; -1: not computed yet.
        std::array<int, kMaxGaussPoints + 1> nodes{};
    };
    /// The distance (m) of a panel's middle from which n points are enough.
    using Reaches = std::array<double, kMaxGaussPoints + 1>;
    struct Stretch {
        double width;
        int whole;                   ///< its panel
        std::vector<Reaches> levels; ///< of panels halved so many times
    };

    int addPanel(double from, double to);
    const Reaches& reaches(Stretch& stretch, std::size_t level);
    void prepareStretches(double exponent);
    void layPanels(Stretch& stretch, const Eigen::Vector3d& centre_S, double radius_m, double nearest_m);
    void layNodes(int panel, int points);

    const RadiatingContour::Impl& m_source;
    Eigen::Vector3d m_normal, m_o;
    std::vector<OutlinePiece> m_smooth;
    std::vector<kernels::Edge> m_edges, m_cutEdges;
    std::vector<kernels::Edge> m_followed; ///< of both
    std::vector<Stretch> m_stretches;      ///< of m_smooth, once they are needed
    std::vector<Panel> m_panels;           ///< of all stretches
    OutlineTable m_panelNodes;
    double m_exponent = 0.0;                         ///< for which m_stretches are prepared
    Reaches m_gaussDistances{};                      ///< gaussDistance() for it
    std::vector<std::pair<int, std::size_t>> m_open; ///< panel and level
    OutlineTable m_nodes;
    kernels::Placement m_placement;
    kernels::Loop m_loop;
};

} // namespace bask
