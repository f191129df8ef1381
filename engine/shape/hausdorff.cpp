#include "engine/shape/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

double squaredDistanceToEdge(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
    const Vector2d edge = b - a;
    const double length2 = edge.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    return (p - a - t * edge).squaredNorm();
}

// Boxes about runs of neighbouring edges, a binary tree over them: node k has 2k + 1 and 2k + 2 below it.
class EdgeTree {
public:
    explicit EdgeTree(const Points& ring) : m_ring(ring) {
        while (kRun << m_levels < ring.size())
            ++m_levels;
        m_boxes.resize((std::size_t{2} << m_levels) - 1);
        build(0, 0, ring.size());
    }

    /// Distance of a point to the ring; any number not above `enough` when it is not above that.
    double distance(const Vector2d& p, double enough) {
        double best2 = std::numeric_limits<double>::infinity();
        const double enough2 = enough * enough;
        tryEdge(p, m_last, best2); // the nearest edge of the point before is seldom far off
        if (best2 > enough2)
            search(p, 0, 0, m_ring.size(), enough2, best2);
        return std::sqrt(best2);
    }

    /// The farther end's distance to the edge that was nearest last: no point between is farther from it.
    double maxBetween(const Vector2d& a, const Vector2d& b) const {
        const Vector2d &from = at(m_last), &to = at(m_last + 1);
        return std::sqrt(std::max(squaredDistanceToEdge(a, from, to), squaredDistanceToEdge(b, from, to)));
    }

private:
    static constexpr std::size_t kRun = 4; // edges of a leaf, about
    struct Box {
        Vector2d min = Vector2d::Constant(std::numeric_limits<double>::infinity());
        Vector2d max = -min;

        double squaredDistance(const Vector2d& p) const {
            return (min - p).cwiseMax(p - max).cwiseMax(0.0).squaredNorm();
        }
    };

    const Vector2d& at(std::size_t k) const { return m_ring[k < m_ring.size() ? k : 0]; }
    bool isLeaf(std::size_t node) const { return 2 * node + 2 >= m_boxes.size(); }

    Box build(std::size_t node, std::size_t first, std::size_t last) {
        Box box;
        if (isLeaf(node)) {
            for (std::size_t k = first; k <= last && first < last; ++k) {
                box.min = box.min.cwiseMin(at(k));
                box.max = box.max.cwiseMax(at(k));
            }
        } else {
            const std::size_t middle = (first + last) / 2;
            const Box left = build(2 * node + 1, first, middle), right = build(2 * node + 2, middle, last);
            box.min = left.min.cwiseMin(right.min);
            box.max = left.max.cwiseMax(right.max);
        }
        return m_boxes[node] = box;
    }

    void tryEdge(const Vector2d& p, std::size_t k, double& best2) {
        if (const double d2 = squaredDistanceToEdge(p, at(k), at(k + 1)); d2 < best2) {
            best2 = d2;
            m_last = k;
        }
    }

    void search(const Vector2d& p, std::size_t node, std::size_t first, std::size_t last, double enough2,
                double& best2) {
        if (isLeaf(node)) {
            for (std::size_t k = first; k < last; ++k)
                tryEdge(p, k, best2);
            return;
        }
        const std::size_t left = 2 * node + 1, middle = (first + last) / 2;
        const double toLeft2 = m_boxes[left].squaredDistance(p);
        const double toRight2 = m_boxes[left + 1].squaredDistance(p);
        for (const bool isLeft : {toLeft2 <= toRight2, toLeft2 > toRight2}) {
            if ((isLeft ? toLeft2 : toRight2) >= best2 || best2 <= enough2)
                continue;
            if (isLeft)
                search(p, left, first, middle, enough2, best2);
            else
                search(p, left + 1, middle, last, enough2, best2);
        }
    }

    const Points& m_ring;
    std::size_t m_levels = 0;
    std::vector<Box> m_boxes;
    std::size_t m_last = 0;
};

// The largest distance of a point of `from` to `to`. A piece of an edge is halved while it could hold more
// than was found.
double oneWay(const Points& from, const Points& to, double tolerance, double max) {
    EdgeTree tree(to);
    struct Piece {
        Vector2d a, b;
    };
    std::vector<Piece> open;
    for (std::size_t k = 0; k < from.size(); ++k) {
        max = std::max(max, tree.distance(from[k], max));
        open.push_back({from[k], from[(k + 1) % from.size()]});
        while (!open.empty()) {
            const Piece piece = open.back();
            open.pop_back();
            const double allowed = max + tolerance, half = 0.5 * (piece.b - piece.a).norm();
            if (half <= tolerance || tree.maxBetween(piece.a, piece.b) <= allowed)
                continue;
            const Vector2d middle = 0.5 * (piece.a + piece.b);
            const double d = tree.distance(middle, max);
            max = std::max(max, d);
            if (tree.maxBetween(piece.a, piece.b) <= allowed)
                continue;
            open.push_back({middle, piece.b});
            open.push_back({piece.a, middle});
        }
    }
    return max;
}

} // namespace

double hausdorffDistance(const Points& a, const Points& b, double tolerance_m) {
    return oneWay(b, a, tolerance_m, oneWay(a, b, tolerance_m, 0.0));
}

std::vector<double> distancesTo(const Points& ring, const Points& points) {
    EdgeTree tree(ring);
    std::vector<double> distances;
    distances.reserve(points.size());
    for (const Vector2d& p : points)
        distances.push_back(tree.distance(p, 0.0));
    return distances;
}

} // namespace bask
