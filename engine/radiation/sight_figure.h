#pragma once
// A plate in space, cut to the part that counts, prepared for asking what a ray meets.

#include "engine/base/pose.h"
#include "engine/shape/shape.h"

#include <utility>
#include <vector>

namespace bask {

/// A half space of S: the points v with normal . v + offset > 0.
struct HalfSpace {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    double offset = 0.0; ///< m

    double height(const Eigen::Vector3d& v) const { return normal.dot(v) + offset; }
};

/// A point of a smooth line with its step, weighted for a sum over a chain of edges.
struct SightNode {
    Eigen::Vector2d at, step;
};
inline constexpr int kEdgesOfChain = 8, kNodesOfChain = 4;

/// A closed line of straight edges.
struct SightRing {
    struct Corner {
        Eigen::Vector2d at;
        int run = 0; ///< of the edge that begins here: edges that share it are parts of a smooth line
    };
    std::vector<Corner> corners;
    /// Of a smooth line: kNodesOfChain for every kEdgesOfChain edges, and where the first of these begins.
    std::vector<SightNode> nodes;
    std::vector<Eigen::Vector2d> starts;
};

/// A shape as a circle or a polygon, in its own frame (m): the outline runs counter-clockwise, holes
/// clockwise.
struct SightOutline {
    /// A Fourier outline becomes a polygon of `smoothPoints` corners with the same area, piece by piece.
    SightOutline(const Shape& shape, int smoothPoints);

    double radius_m = 0.0; ///< of a circle; else 0
    double reach_m = 0.0;  ///< largest distance of a point from the origin
    std::vector<SightRing> rings;
};

/// An outline at its pose, or what is left of it in some half spaces.
class SightFigure {
public:
    /// A straight part of the outline, of a hole or of a cut, between two of `corners()`.
    struct Edge {
        int from = 0, to = 0;
        int run = 0;
        bool isFirst = false; ///< of its ring
        bool isChord = false; ///< closes the circle where it is cut
        int chain = 0;
    };
    /// Up to kEdgesOfChain edges that follow one another, and the box around them.
    struct Chain {
        int first = 0, end = 0; ///< edges
        Eigen::Vector2d low, high;
        /// Of the circle around the box, m.
        Eigen::Vector2d middle() const { return 0.5 * (low + high); }
        double radius() const { return 0.5 * (high - low).norm(); }
        int nodes = -1; ///< first node of the smooth line for which they stand; -1: they stand for themselves
        /// Of that line; the corners lie a little outside it.
        Eigen::Vector2d start = Eigen::Vector2d::Zero(), stop = Eigen::Vector2d::Zero();
    };

    SightFigure(const SightOutline& outline, const Pose& X_S);

    /// Keeps only what lies in the half space. Returns whether that is less than before.
    bool clip(const HalfSpace& space);
    /// Returns whether there is nothing left.
    bool empty() const { return m_empty; }
    /// Returns the least and the greatest height (m) of a point.
    std::pair<double, double> heights(const HalfSpace& space) const;

    bool isCircle() const { return m_radius > 0.0; }
    double radius() const { return m_radius; }
    double reach() const { return m_reach; }                                  ///< at most, from `origin`, m
    const std::vector<Eigen::Vector2d>& corners() const { return m_corners; } ///< in the figure's frame, m
    const std::vector<Edge>& edges() const { return m_edges; }
    const std::vector<Chain>& chains() const { return m_chains; } ///< of all edges
    const std::vector<SightNode>& nodes() const { return m_nodes; }
    /// Lines that cut the circle: l . (x, y, 1) > 0 is kept.
    const std::vector<Eigen::Vector3d>& cuts() const { return m_cuts; }
    /// Where the cuts meet the circle, as unit vectors.
    const std::vector<Eigen::Vector2d>& arcEnds() const { return m_arcEnds; }
    Eigen::Vector3d inS(const Eigen::Vector2d& v) const { return origin + v.x() * e1 + v.y() * e2; }

    Eigen::Vector3d origin, e1, e2, n; ///< S

private:
    using Chord = std::pair<Eigen::Vector2d, Eigen::Vector2d>;
    void clipCircle(const Eigen::Vector3d& line);
    void layEdges();

    double m_radius = 0.0, m_reach = 0.0;
    bool m_empty = false;
    std::vector<SightRing> m_rings;
    std::vector<Chord> m_chords;
    std::vector<Eigen::Vector3d> m_cuts;
    std::vector<Eigen::Vector2d> m_arcEnds;
    std::vector<Eigen::Vector2d> m_corners;
    std::vector<Edge> m_edges;
    std::vector<Chain> m_chains;
    std::vector<SightNode> m_nodes;
};

} // namespace bask
