#include "engine/shape/outline_chains.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <unordered_map>

namespace bask {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// Numbers places: the same number within the tolerance. Cells of the tolerance's size hold the places seen.
class Nodes {
public:
    Nodes(const Eigen::Vector2d& corner, double tolerance) : m_corner(corner), m_tolerance(tolerance) {}

    std::size_t of(const Eigen::Vector2d& p) {
        const Eigen::Vector2d at = (p - m_corner) / m_tolerance;
        const auto column = static_cast<std::int64_t>(at.x()), row = static_cast<std::int64_t>(at.y());
        for (std::int64_t dx = -1; dx <= 1; ++dx)
            for (std::int64_t dy = -1; dy <= 1; ++dy)
                if (const auto cell = m_cells.find(key(column + dx, row + dy)); cell != m_cells.end())
                    for (const std::size_t node : cell->second)
                        if ((m_places[node] - p).norm() <= m_tolerance)
                            return node;
        m_cells[key(column, row)].push_back(m_places.size());
        m_places.push_back(p);
        return m_places.size() - 1;
    }
    std::size_t count() const { return m_places.size(); }

private:
    static std::uint64_t key(std::int64_t column, std::int64_t row) {
        const auto mixed = static_cast<std::uint64_t>(column) * 0x9E3779B97F4A7C15u;
        return (mixed ^ (mixed >> 29)) + static_cast<std::uint64_t>(row) * 0xBF58476D1CE4E5B9u;
    }

    Eigen::Vector2d m_corner;
    double m_tolerance;
    std::vector<Eigen::Vector2d> m_places;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> m_cells;
};

double lengthOf(const Points& points) {
    double length = 0.0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
        length += (points[k + 1] - points[k]).norm();
    return length;
}

class Chainer {
public:
    Chainer(std::vector<Points> pieces, double tolerance)
        : m_pieces(std::move(pieces)), m_tolerance(tolerance) {}

    std::vector<FileOutline> run() {
        findEnds();
        setSpursApart();
        meet(false);
        for (std::size_t k = 0; k < m_pieces.size(); ++k)
            if (!m_taken[k] && !m_spur[k])
                walk(k, m_ends[k][0]);
        meet(true);
        std::vector<std::size_t> degree;
        for (const auto& here : m_at)
            degree.push_back(here.size());
        for (const bool fromTip : {true, false})
            for (std::size_t k = 0; k < m_pieces.size(); ++k)
                for (const std::size_t node : m_ends[k])
                    if (!m_taken[k] && (!fromTip || degree[node] == 1))
                        walk(k, node);
        return std::move(m_outlines);
    }

private:
    struct Step {
        std::size_t piece, from; // from: the node where it is entered
    };

    void findEnds() {
        Eigen::AlignedBox2d box;
        for (const Points& piece : m_pieces)
            box.extend(piece.front()).extend(piece.back());
        Nodes nodes(box.isEmpty() ? Eigen::Vector2d(0, 0) : box.min(), m_tolerance);
        m_ends.resize(m_pieces.size());
        m_taken.assign(m_pieces.size(), 0);
        m_spur.assign(m_pieces.size(), 0);
        std::set<std::array<std::size_t, 2>> straight;
        for (std::size_t k = 0; k < m_pieces.size(); ++k) {
            const std::size_t a = nodes.of(m_pieces[k].front()), b = nodes.of(m_pieces[k].back());
            m_ends[k] = {a, b};
            if (a == b) {
                m_taken[k] = 1;
                if (lengthOf(m_pieces[k]) > 2.0 * m_tolerance)
                    emit({{k, a}}, true);
            } else if (m_pieces[k].size() == 2) {
                m_taken[k] = !straight.insert({std::min(a, b), std::max(a, b)}).second;
            }
        }
        m_at.resize(nodes.count());
        m_on_path.assign(nodes.count(), kNowhere);
    }

    // Lists the pieces that are left at each node: those on loops, or the spurs.
    void meet(bool spurs) {
        for (auto& here : m_at)
            here.clear();
        for (std::size_t k = 0; k < m_pieces.size(); ++k)
            if (!m_taken[k] && (m_spur[k] != 0) == spurs)
                for (const std::size_t node : m_ends[k])
                    m_at[node].push_back(k);
    }

    // Pieces that lead to a free end are no part of a loop.
    void setSpursApart() {
        meet(false);
        std::vector<std::size_t> degree, tips;
        for (std::size_t node = 0; node < m_at.size(); ++node) {
            degree.push_back(m_at[node].size());
            if (degree.back() == 1)
                tips.push_back(node);
        }
        while (!tips.empty()) {
            const std::size_t node = tips.back();
            tips.pop_back();
            for (const std::size_t k : m_at[node])
                if (!m_spur[k]) {
                    m_spur[k] = 1;
                    const std::size_t other = otherEnd(k, node);
                    --degree[node];
                    if (--degree[other] == 1)
                        tips.push_back(other);
                }
        }
    }

    std::size_t otherEnd(std::size_t piece, std::size_t node) const {
        return m_ends[piece][0] == node ? m_ends[piece][1] : m_ends[piece][0];
    }

    // Follows pieces from one that is entered at `node` until none goes on.
    void walk(std::size_t piece, std::size_t node) {
        std::vector<Step> path;
        m_on_path[node] = 0;
        for (;;) {
            m_taken[piece] = 1;
            path.push_back({piece, node});
            node = otherEnd(piece, node);
            if (m_on_path[node] != kNowhere)
                cutLoop(path, node);
            else
                m_on_path[node] = path.size();
            const std::size_t next = nextAt(node, path);
            if (next == kNowhere)
                break;
            piece = next;
        }
        for (const Step& step : path)
            m_on_path[step.from] = kNowhere;
        m_on_path[node] = kNowhere;
        if (!path.empty())
            emit(path, false);
    }

    void cutLoop(std::vector<Step>& path, std::size_t node) {
        const auto begin = path.begin() + static_cast<std::ptrdiff_t>(m_on_path[node]);
        emit({begin, path.end()}, true);
        for (auto step = begin + 1; step != path.end(); ++step)
            m_on_path[step->from] = kNowhere;
        path.erase(begin, path.end());
    }

    // The free piece at the node that turns least from the path's last; of a great many, of the first few.
    std::size_t nextAt(std::size_t node, const std::vector<Step>& path) {
        constexpr std::size_t kCompared = 16;
        std::vector<std::size_t>& here = m_at[node];
        std::size_t best = kNowhere;
        double straightest = -2.0;
        for (std::size_t k = 0; k < std::min(here.size(), kCompared);) {
            if (m_taken[here[k]]) {
                here[k] = here.back();
                here.pop_back();
                continue;
            }
            const double cosine =
                path.empty() ? 0.0 : -direction(path.back().piece, node).dot(direction(here[k], node));
            if (cosine > straightest) {
                straightest = cosine;
                best = here[k];
            }
            ++k;
        }
        return best;
    }

    // Of a piece where it leaves a node.
    Eigen::Vector2d direction(std::size_t piece, std::size_t node) const {
        const Points& p = m_pieces[piece];
        const bool forward = m_ends[piece][0] == node;
        return (forward ? p[1] - p[0] : p[p.size() - 2] - p.back()).stableNormalized();
    }

    void emit(const std::vector<Step>& steps, bool closed) {
        FileOutline outline;
        outline.closed = closed;
        Points& points = outline.points_m;
        for (const auto& [piece, from] : steps) {
            Points& next = m_pieces[piece];
            if (m_ends[piece][0] != from)
                std::ranges::reverse(next);
            points.insert(points.end(), next.begin() + (points.empty() ? 0 : 1), next.end());
            next = {};
        }
        if (closed)
            points.pop_back();
        points.erase(std::unique(points.begin(), points.end()), points.end());
        if (points.size() >= (closed ? 3u : 2u))
            m_outlines.push_back(std::move(outline));
    }

    static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

    std::vector<Points> m_pieces;
    double m_tolerance;
    std::vector<std::array<std::size_t, 2>> m_ends; // nodes
    std::vector<std::vector<std::size_t>> m_at;     // pieces at each node
    std::vector<std::size_t> m_on_path;             // place of each node on the path being walked
    std::vector<char> m_taken, m_spur;
    std::vector<FileOutline> m_outlines;
};

} // namespace

std::vector<FileOutline> chained(std::vector<Points> pieces, double tolerance_m) {
    return Chainer(std::move(pieces), tolerance_m).run();
}

} // namespace bask
