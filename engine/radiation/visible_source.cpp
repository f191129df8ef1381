#include "engine/radiation/visible_source.h"

#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <span>

namespace bask {

namespace {

kernels::Edge edgeBetween(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d step = b - a;
    const double length = step.norm();
    return {a.x(), a.y(), step.x() / length, step.y() / length, length};
}

// From its own line an edge appears under the angle pi, from the kept side: its B is pi times the object's
// normal, with the sign of the edge's direction.
Vector6d fieldOnLine(const kernels::Edge& edge, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                     const Eigen::Vector3d& o, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d t(edge.t1, edge.t2, 0.0);
    const Eigen::Vector3d start(edge.a1, edge.a2, 0.0);
    const double from = std::clamp(t.dot(a - start), 0.0, edge.length);
    const double to = std::clamp(t.dot(b - start), 0.0, edge.length);
    const double side = edge.t1 * normal.y() - edge.t2 * normal.x() >= 0.0 ? 1.0 : -1.0;
    const Eigen::Vector3d force = side * std::numbers::pi * (to - from) * t.cross(normal);
    Vector6d moments;
    moments << force, (start + 0.5 * (from + to) * t - o).cross(force);
    return moments;
}

// Both ends of the edge within rounding of the line through a and b.
bool isOnLine(const kernels::Edge& edge, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const Eigen::Vector3d along = b - a;
    const double length = along.norm();
    const auto away = [&](double from) {
        const Eigen::Vector3d p(edge.a1 + from * edge.t1, edge.a2 + from * edge.t2, 0.0);
        return (p - a).cross(along).norm() / length;
    };
    return length > 0.0 &&
           std::max(away(0.0), away(edge.length)) <= 1e-13 * (length + edge.length + a.norm());
}

} // namespace

Vector6d WholeDiskSource::moments(const double* raw) const {
    Vector6d result;
    result << m_factor * (m_R * Eigen::Map<const Eigen::Vector3d>(raw)),
        m_factor * (m_R * Eigen::Map<const Eigen::Vector3d>(raw + 3));
    return result;
}

DiskSegmentSource::DiskSegmentSource(double radius_m, const Sight& sight)
    : m_radius(radius_m), m_normal(-sight.X_SO.linear().col(2)), m_o(sight.X_SO.translation()) {
    kernels::Segment& s = m_segment;
    s.inverseRadius = 1.0 / radius_m;
    s.sinTilt = std::hypot(m_normal.x(), m_normal.y());
    s.normal3 = m_normal.z();
    const Eigen::Vector3d e1(m_normal.x() / s.sinTilt, m_normal.y() / s.sinTilt, 0.0);
    m_axes << e1, Eigen::Vector3d::UnitZ().cross(e1), Eigen::Vector3d::UnitZ();
    const Eigen::Matrix3d turn = m_axes.transpose() * sight.X_SO.linear();
    const Eigen::Vector3d origin = m_axes.transpose() * m_o / radius_m;
    for (int i = 0; i < 3; ++i) {
        s.turn[i][0] = turn(i, 0);
        s.turn[i][1] = turn(i, 1);
        s.origin[i] = origin[i];
    }
    // Kept: cos(theta) > cosBeta, theta from e1.
    s.cosBeta = std::clamp(-sight.overObject.z0 / (radius_m * s.sinTilt), -1.0, 1.0);
    s.sinBeta = std::sqrt((1.0 - s.cosBeta) * (1.0 + s.cosBeta));
    s.beta = std::atan2(s.sinBeta, s.cosBeta);
    const Eigen::Vector3d foot = radius_m * s.cosBeta * e1;
    const Eigen::Vector3d half = radius_m * s.sinBeta * m_axes.col(1);
    const Eigen::Vector3d a = foot + half;
    m_chord = {a.x(), a.y(), -m_axes(0, 1), -m_axes(1, 1), 2.0 * radius_m * s.sinBeta};
}

double DiskSegmentSource::distance_m(const Eigen::Vector3d& p_S) const {
    const double p1 = m_axes.col(0).dot(p_S);
    const double p2 = m_axes.col(1).dot(p_S);
    const double rho = std::sqrt(p1 * p1 + p2 * p2);
    const double z2 = p_S.z() * p_S.z();
    const double away = rho - m_radius;
    double square = away * away + z2;
    if (p1 < rho * m_segment.cosBeta) { // beyond the arc's ends
        const double away1 = p1 - m_radius * m_segment.cosBeta;
        const double away2 = std::abs(p2) - m_radius * m_segment.sinBeta;
        square = away1 * away1 + away2 * away2 + z2;
    }
    return std::sqrt(m_chordFollowed ? square : std::min(square, squaredDistance(m_chord, p_S)));
}

void DiskSegmentSource::follow(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool onCut) {
    m_chordFollowed = onCut || isOnLine(m_chord, a, b);
}

Vector6d DiskSegmentSource::moments(const double* raw) const {
    Vector6d result;
    result << m_axes * Eigen::Map<const Eigen::Vector3d>(raw),
        m_axes * Eigen::Map<const Eigen::Vector3d>(raw + 3);
    return result;
}

Vector6d DiskSegmentSource::alongCut(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return fieldOnLine(m_chord, a, b, m_o, m_normal);
}

LoopSource::LoopSource(const RadiatingContour::Impl& source, const Sight& sight, bool cut)
    : m_source(source), m_normal(-sight.X_SO.linear().col(2)), m_o(sight.X_SO.translation()) {
    for (int i = 0; i < 3; ++i) {
        m_placement.axes[i][0] = sight.X_SO.linear()(i, 0);
        m_placement.axes[i][1] = sight.X_SO.linear()(i, 1);
        m_placement.origin[i] = m_o[i];
    }
    if (!cut) {
        if (source.isPolygon) {
            m_loop.edges = source.edges.data();
            m_loop.edgeCount = static_cast<int>(source.edges.size());
        } else {
            m_smooth = source.allPieces();
        }
        return;
    }
    for (const OutlinePiece& piece : source.piecesInFront(sight.overObject)) {
        if (!piece.straight)
            m_smooth.push_back(piece);
        else if (piece.a != piece.b)
            (piece.onCut ? m_cutEdges : m_edges).push_back(edgeBetween(piece.a, piece.b));
    }
    m_loop.edges = m_edges.data();
    m_loop.edgeCount = static_cast<int>(m_edges.size());
    m_loop.cutEdges = m_cutEdges.data();
    m_loop.cutEdgeCount = static_cast<int>(m_cutEdges.size());
}

double LoopSource::distance_m(const Eigen::Vector3d& p_S) const {
    double square = 1e300;
    const auto look = [&](const kernels::Edge* edges, int count) {
        for (const kernels::Edge& edge : std::span(edges, static_cast<std::size_t>(count)))
            if (m_followed.empty() || std::ranges::find(m_followed, edge) == m_followed.end())
                square = std::min(square, squaredDistance(edge, p_S));
    };
    look(m_loop.edges, m_loop.edgeCount);
    look(m_loop.cutEdges, m_loop.cutEdgeCount);
    const double straight = std::sqrt(square);
    return m_smooth.empty() ? straight : std::min(straight, m_source.curveDistance_m(p_S));
}

void LoopSource::follow(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool onCut) {
    m_followed.clear();
    if (a == b)
        return;
    for (int i = 0; i < m_loop.edgeCount; ++i)
        if (isOnLine(m_loop.edges[i], a, b))
            m_followed.push_back(m_loop.edges[i]);
    for (const kernels::Edge& edge : m_cutEdges)
        if (onCut ||
            isOnLine(edge, a, b)) // as computed from either face, the cut may differ by more than rounding
            m_followed.push_back(edge);
}

double LoopSource::prepare(const Eigen::Vector3d& centre_S, double radius_m, double nearest_m,
                           double exponent) {
    if (m_smooth.empty())
        return exponent;
    const bool whole = m_smooth.size() == 1 && m_loop.cutEdgeCount == 0;
    if (const int step = m_source.strip.fromOutline(nearest_m); whole && step >= 0) {
        const double b = AnalyticStrip::width(step);
        const double growth = m_source.strip.growth(step);
        if (const TrapezoidTable* rule = m_source.trapezoid((exponent + growth) / b)) {
            m_loop.nodes = rule->table.view();
            return rule->points * b - growth;
        }
    }
    if (m_stretches.empty() || m_exponent != exponent)
        prepareStretches(exponent);
    m_nodes.clear();
    for (Stretch& stretch : m_stretches)
        layPanels(stretch, centre_S, radius_m, nearest_m);
    m_nodes.seal();
    m_loop.nodes = m_nodes.view();
    return exponent;
}

void LoopSource::prepareStretches(double exponent) {
    m_exponent = exponent;
    for (int n = 1; n <= kMaxGaussPoints; ++n)
        m_gaussDistances[static_cast<std::size_t>(n)] = gaussDistance(n, exponent);
    m_panels.clear();
    m_panelNodes.clear();
    m_stretches.clear();
    for (const OutlinePiece& piece : m_smooth)
        m_stretches.push_back({piece.to - piece.from, addPanel(piece.from, piece.to), {}});
}

int LoopSource::addPanel(double from, double to) {
    Panel& made = m_panels.emplace_back(Panel{from, to, m_source.at(0.5 * (from + to))});
    made.nodes.fill(-1);
    return static_cast<int>(m_panels.size()) - 1;
}

const LoopSource::Reaches& LoopSource::reaches(Stretch& stretch, std::size_t level) {
    while (stretch.levels.size() <= level) {
        const double half = std::ldexp(0.5 * stretch.width, -static_cast<int>(stretch.levels.size()));
        Reaches& made = stretch.levels.emplace_back();
        for (std::size_t n = 1; n < made.size(); ++n)
            made[n] = m_source.strip.distanceFor(half * m_gaussDistances[n]);
    }
    return stretch.levels[level];
}

// Gauss panels, each short compared with its distance from the object's points.
void LoopSource::layPanels(Stretch& stretch, const Eigen::Vector3d& centre_S, double radius_m,
                           double nearest_m) {
    constexpr double kMinHalf = 1e-12; // shorter panels have no effect
    m_open.assign(1, {stretch.whole, 0});
    while (!m_open.empty()) {
        const auto [index, level] = m_open.back();
        m_open.pop_back();
        const Panel& panel = m_panels[static_cast<std::size_t>(index)];
        const double away =
            (Eigen::Vector3d(panel.middle.x, panel.middle.y, 0.0) - centre_S).norm() - radius_m;
        const double distance = std::max(away, nearest_m);
        const Reaches& enough = reaches(stretch, level);
        int points = kMaxGaussPoints;
        if (distance < enough[kMaxGaussPoints] && 0.5 * (panel.to - panel.from) > kMinHalf) {
            int halves = panel.halves;
            if (halves < 0) {
                const double from = panel.from, to = panel.to, middle = 0.5 * (from + to);
                halves = addPanel(from, middle);
                addPanel(middle, to);
                m_panels[static_cast<std::size_t>(index)].halves = halves;
            }
            m_open.emplace_back(halves, level + 1);
            m_open.emplace_back(halves + 1, level + 1);
            continue;
        }
        while (points > 1 && distance >= enough[static_cast<std::size_t>(points - 1)])
            --points;
        layNodes(index, points);
    }
}

void LoopSource::layNodes(int index, int points) {
    Panel& panel = m_panels[static_cast<std::size_t>(index)];
    // A point or two more cost less than points of another rule.
    for (int more = points; more <= std::min(points + 2, kMaxGaussPoints); ++more)
        if (panel.nodes[static_cast<std::size_t>(more)] >= 0) {
            m_nodes.add(m_panelNodes, panel.nodes[static_cast<std::size_t>(more)], more);
            return;
        }
    int& first = panel.nodes[static_cast<std::size_t>(points)];
    first = m_panelNodes.size();
    const double half = 0.5 * (panel.to - panel.from);
    const GaussRule rule = gaussRule(points);
    m_source.atNodes({}, panel.from, 2.0 * half, rule.nodes, [&](std::size_t i, const OutlinePoint& p) {
        const double weight = 2.0 * half * rule.weights[i];
        m_panelNodes.add(p.x, p.y, weight * p.dx, weight * p.dy);
    });
    m_nodes.add(m_panelNodes, first, points);
}

Vector6d LoopSource::alongCut(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    Vector6d moments = Vector6d::Zero();
    for (const kernels::Edge& edge : m_cutEdges)
        moments += fieldOnLine(edge, a, b, m_o, m_normal);
    return moments;
}

} // namespace bask
