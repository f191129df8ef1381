#include "engine/shape/crossing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace bask {
namespace {

using Eigen::Vector2d;

bool before(const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

// Twice the signed area of a, b, c, in extended precision since its sign decides.
long double orientation(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
    using Real = long double;
    const Real bx = Real(b.x()) - Real(a.x()), by = Real(b.y()) - Real(a.y());
    const Real cx = Real(c.x()) - Real(a.x()), cy = Real(c.y()) - Real(a.y());
    return bx * cy - by * cx;
}

int sign(long double value) {
    return (value > 0) - (value < 0);
}

bool inBox(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
    return (a.cwiseMin(b).array() <= p.array()).all() && (p.array() <= a.cwiseMax(b).array()).all();
}

std::optional<Vector2d> meeting(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
    if ((a.cwiseMax(b).array() < c.cwiseMin(d).array()).any() ||
        (c.cwiseMax(d).array() < a.cwiseMin(b).array()).any())
        return std::nullopt;
    const long double oc = orientation(a, b, c), od = orientation(a, b, d);
    const long double oa = orientation(c, d, a), ob = orientation(c, d, b);
    if (sign(oc) * sign(od) < 0 && sign(oa) * sign(ob) < 0)
        return Vector2d(a + static_cast<double>(oa / (oa - ob)) * (b - a));
    if (oc == 0 && inBox(c, a, b))
        return c;
    if (od == 0 && inBox(d, a, b))
        return d;
    if (oa == 0 && inBox(a, c, d))
        return a;
    if (ob == 0 && inBox(b, c, d))
        return b;
    return std::nullopt;
}

class Sweep {
public:
    explicit Sweep(const std::vector<Vector2d>& points) : m_points(points), m_places(points.size()) {}

    std::optional<Crossing> run() {
        std::vector<std::size_t> order(m_points.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::sort(order,
                          [&](std::size_t a, std::size_t b) { return before(m_points[a], m_points[b]); });
        // Vertices that coincide are reported here, so that below every vertex has a place of its own.
        for (std::size_t k = 0; k + 1 < order.size(); ++k)
            if (m_points[order[k]] == m_points[order[k + 1]])
                return crossing(order[k], order[k + 1], m_points[order[k]]);
        for (std::size_t v : order)
            if (auto found = visit(v))
                return found;
        return std::nullopt;
    }

private:
    struct Below {
        const Sweep* sweep;
        bool operator()(std::size_t a, std::size_t b) const { return sweep->below(a, b); }
    };
    using Active = std::set<std::size_t, Below>;

    std::size_t next(std::size_t k) const { return k + 1 == m_points.size() ? 0 : k + 1; }
    std::size_t previous(std::size_t k) const { return k == 0 ? m_points.size() - 1 : k - 1; }
    const Vector2d& left(std::size_t e) const {
        return before(m_points[e], m_points[next(e)]) ? m_points[e] : m_points[next(e)];
    }
    const Vector2d& right(std::size_t e) const {
        return before(m_points[e], m_points[next(e)]) ? m_points[next(e)] : m_points[e];
    }

    // Order along the sweep line of two edges that are both cut by it.
    bool below(std::size_t a, std::size_t b) const {
        if (a == b)
            return false;
        if (before(left(b), left(a)))
            return side(b, a) < 0;
        return side(a, b) > 0;
    }

    // On which side of `older` does `newer`, which starts later, lie? Index order when on it.
    int side(std::size_t older, std::size_t newer) const {
        if (const int s = sign(orientation(left(older), right(older), left(newer))))
            return s;
        if (const int s = sign(orientation(left(older), right(older), right(newer))))
            return s;
        return older < newer ? 1 : -1;
    }

    static Crossing crossing(std::size_t a, std::size_t b, const Vector2d& point) {
        return {std::min(a, b), std::max(a, b), point};
    }

    std::optional<Crossing> check(std::size_t a, std::size_t b) const {
        if (next(a) == b || next(b) == a)
            return std::nullopt;
        if (const auto point = meeting(m_points[a], m_points[next(a)], m_points[b], m_points[next(b)]))
            return crossing(a, b, *point);
        return std::nullopt;
    }

    std::optional<Crossing> visit(std::size_t v) {
        const Vector2d& p = m_points[v];
        const Vector2d in = p - m_points[previous(v)], out = m_points[next(v)] - p;
        if (orientation(m_points[previous(v)], p, m_points[next(v)]) == 0 && in.dot(out) < 0)
            return crossing(previous(v), v, p);
        for (std::size_t e : {previous(v), v})
            if (right(e) == p)
                if (auto found = remove(e))
                    return found;
        for (std::size_t e : {previous(v), v})
            if (left(e) == p)
                if (auto found = insert(e))
                    return found;
        return std::nullopt;
    }

    std::optional<Crossing> insert(std::size_t e) {
        const auto it = m_active.insert(e).first;
        m_places[e] = it;
        if (it != m_active.begin())
            if (auto found = check(*std::prev(it), e))
                return found;
        if (std::next(it) != m_active.end())
            if (auto found = check(*std::next(it), e))
                return found;
        return std::nullopt;
    }

    std::optional<Crossing> remove(std::size_t e) {
        const auto after = m_active.erase(m_places[e]);
        if (after == m_active.begin() || after == m_active.end())
            return std::nullopt;
        return check(*std::prev(after), *after);
    }

    const std::vector<Vector2d>& m_points;
    Active m_active{Below{this}};
    std::vector<Active::iterator> m_places;
};

using Edge = std::pair<Vector2d, Vector2d>;

Eigen::AlignedBox2d boxOf(const Edge& edge) {
    return {edge.first.cwiseMin(edge.second), edge.first.cwiseMax(edge.second)};
}

/// Boxes about runs of edges, so that two rings close to each other need not be tried edge by edge: box i of
/// level l is about the edges from i 2^l on, 2^l of them.
class EdgeRuns {
public:
    explicit EdgeRuns(std::vector<Edge> edges) : m_edges(std::move(edges)), m_levels(1) {
        for (const Edge& edge : m_edges)
            m_levels[0].push_back(boxOf(edge));
        while (m_levels.back().size() > 1) {
            const std::vector<Eigen::AlignedBox2d>& below = m_levels.back();
            std::vector<Eigen::AlignedBox2d> runs;
            for (std::size_t i = 0; i < below.size(); i += 2)
                runs.push_back(i + 1 < below.size() ? below[i].merged(below[i + 1]) : below[i]);
            m_levels.push_back(std::move(runs));
        }
    }

    std::optional<Vector2d> meeting(const EdgeRuns& other) const {
        if (m_edges.empty() || other.m_edges.empty())
            return std::nullopt;
        return meeting({m_levels.size() - 1, 0}, other, {other.m_levels.size() - 1, 0});
    }

private:
    struct Run {
        std::size_t level, index;
    };

    std::optional<Vector2d> meeting(Run run, const EdgeRuns& other, Run its) const {
        if (!m_levels[run.level][run.index].intersects(other.m_levels[its.level][its.index]))
            return std::nullopt;
        if (run.level < its.level)
            return other.meeting(its, *this, run);
        if (run.level == 0)
            return bask::meeting(m_edges[run.index].first, m_edges[run.index].second,
                                 other.m_edges[its.index].first, other.m_edges[its.index].second);
        const std::size_t half = 2 * run.index;
        if (const auto point = meeting({run.level - 1, half}, other, its))
            return point;
        if (half + 1 < m_levels[run.level - 1].size())
            return meeting({run.level - 1, half + 1}, other, its);
        return std::nullopt;
    }

    std::vector<Edge> m_edges;
    std::vector<std::vector<Eigen::AlignedBox2d>> m_levels;
};

} // namespace

std::optional<Crossing> findCrossing(const std::vector<Eigen::Vector2d>& points) {
    return Sweep(points).run();
}

std::optional<Vector2d> findMeeting(const std::vector<Vector2d>& a, const std::vector<Vector2d>& b) {
    const auto boxOfRing = [](const std::vector<Vector2d>& points) {
        Eigen::AlignedBox2d box;
        for (const Vector2d& p : points)
            box.extend(p);
        return box;
    };
    const Eigen::AlignedBox2d common = boxOfRing(a).intersection(boxOfRing(b));
    if (common.isEmpty())
        return std::nullopt;
    // Edges of either that come into the part of the plane where both are.
    const auto within = [&](const std::vector<Vector2d>& points) {
        std::vector<Edge> edges;
        for (std::size_t k = 0; k < points.size(); ++k)
            if (const Edge edge{points[k], points[(k + 1) % points.size()]}; common.intersects(boxOf(edge)))
                edges.push_back(edge);
        return edges;
    };
    return EdgeRuns(within(a)).meeting(EdgeRuns(within(b)));
}

} // namespace bask
