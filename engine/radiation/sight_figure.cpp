#include "engine/radiation/sight_figure.h"

#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

// The corners are moved outward by two thirds of the sagitta: the polygon then has the area of the outline,
// edge by edge.
SightRing polygonOf(const FourierContour& contour, int points) {
    const auto n = static_cast<std::size_t>(points);
    std::vector<Eigen::Vector2d> on;
    for (std::size_t i = 0; i < n; ++i) {
        const std::complex<double> p = contour.point(static_cast<double>(i) / points);
        on.emplace_back(p.real(), p.imag());
    }
    SightRing ring;
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d& next = on[(i + 1) % n];
        const Eigen::Vector2d& last = on[(i + n - 1) % n];
        // Of equal steps of the parameter, the second difference is eight times the sagitta, inward.
        const Eigen::Vector2d bend = next - 2.0 * on[i] + last, along = (next - last).normalized();
        ring.corners.push_back({on[i] - (bend - bend.dot(along) * along) / 12.0});
    }
    const GaussRule rule = gaussRule(kNodesOfChain);
    const double chain = static_cast<double>(kEdgesOfChain) / points;
    for (int i = 0; i < points / kEdgesOfChain; ++i) {
        ring.starts.push_back(on[static_cast<std::size_t>(i) * kEdgesOfChain]);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
            const double phi = (i + rule.nodes[k]) * chain;
            const std::complex<double> p = contour.point(phi),
                                       d = rule.weights[k] * chain * contour.derivative(phi);
            ring.nodes.push_back({{p.real(), p.imag()}, {d.real(), d.imag()}});
        }
    }
    return ring;
}

constexpr int kCutRun = -1;
constexpr int kRunsOfRing = 100000;
constexpr double kCorner = 0.2; // sine of the turn from which a vertex of a polygon counts as a corner

} // namespace

SightOutline::SightOutline(const Shape& shape, int smoothPoints) {
    const auto addRing = [this](const std::vector<Eigen::Vector2d>& points, bool isHole) {
        SightRing ring;
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i)
            ring.corners.push_back({points[isHole ? count - 1 - i : i]});
        auto run = static_cast<int>(rings.size()) * kRunsOfRing;
        for (std::size_t i = 0; i < count; ++i) {
            const Eigen::Vector2d in = ring.corners[i].at - ring.corners[(i + count - 1) % count].at;
            const Eigen::Vector2d out = ring.corners[(i + 1) % count].at - ring.corners[i].at;
            const double turn = std::abs(in.x() * out.y() - in.y() * out.x());
            if (turn > kCorner * in.norm() * out.norm() || in.dot(out) < 0.0)
                ++run;
            ring.corners[i].run = run;
        }
        rings.push_back(std::move(ring));
    };
    if (const auto* disk = outlineAs<Disk>(shape))
        radius_m = disk->radius_m;
    else if (const auto* polygon = outlineAs<Contour>(shape))
        addRing(polygon->points_m, false);
    else
        rings.push_back(polygonOf(*outlineAs<FourierContour>(shape), smoothPoints));
    for (const Contour& hole : holesOf(shape))
        addRing(hole.points_m, true);
    reach_m = radius_m;
    for (const SightRing& ring : rings)
        for (const SightRing::Corner& corner : ring.corners)
            reach_m = std::max(reach_m, corner.at.norm());
}

SightFigure::SightFigure(const SightOutline& outline, const Pose& X_S)
    : origin(X_S.translation()), e1(X_S.linear().col(0)), e2(X_S.linear().col(1)), n(X_S.linear().col(2)),
      m_radius(outline.radius_m), m_reach(outline.reach_m), m_rings(outline.rings) {
    layEdges();
}

void SightFigure::layEdges() {
    m_corners.clear();
    m_edges.clear();
    m_chains.clear();
    m_nodes.clear();
    const auto add = [this](const Edge& edge) {
        if (edge.isFirst || static_cast<int>(m_edges.size()) - m_chains.back().first == kEdgesOfChain) {
            const auto here = static_cast<int>(m_edges.size());
            const Eigen::Vector2d& start = m_corners[static_cast<std::size_t>(edge.from)];
            m_chains.push_back({here, here, start, start});
        }
        Chain& chain = m_chains.back();
        ++chain.end;
        for (const int end : {edge.from, edge.to}) {
            const Eigen::Vector2d& corner = m_corners[static_cast<std::size_t>(end)];
            chain.low = chain.low.cwiseMin(corner);
            chain.high = chain.high.cwiseMax(corner);
        }
        m_edges.push_back(edge);
        m_edges.back().chain = static_cast<int>(m_chains.size()) - 1;
    };
    for (const SightRing& ring : m_rings) {
        const auto first = static_cast<int>(m_corners.size()), count = static_cast<int>(ring.corners.size());
        for (const SightRing::Corner& corner : ring.corners)
            m_corners.push_back(corner.at);
        for (int i = 0; i < count; ++i)
            add({first + i, first + (i + 1) % count, ring.corners[static_cast<std::size_t>(i)].run, i == 0,
                 false});
        if (!ring.nodes.empty()) {
            const std::size_t chains = ring.nodes.size() / kNodesOfChain;
            for (std::size_t i = 0; i < chains; ++i) {
                Chain& chain = m_chains[m_chains.size() - chains + i];
                chain.nodes = static_cast<int>(m_nodes.size() + i * kNodesOfChain);
                chain.start = ring.starts[i];
                chain.stop = ring.starts[(i + 1) % chains];
            }
            m_nodes.insert(m_nodes.end(), ring.nodes.begin(), ring.nodes.end());
        }
    }
    for (const auto& [a, b] : m_chords) {
        const auto first = static_cast<int>(m_corners.size());
        m_corners.push_back(a);
        m_corners.push_back(b);
        add({first, first + 1, kCutRun, true, true});
    }
}

bool SightFigure::clip(const HalfSpace& space) {
    const Eigen::Vector3d line(space.normal.dot(e1), space.normal.dot(e2), space.height(origin));
    const auto [low, high] = heights(space);
    if (low >= 0.0 && high > 0.0)
        return false;
    if (high <= 0.0) {
        m_empty = true;
        return true;
    }
    const auto heightOf = [&line](const Eigen::Vector2d& v) {
        return line.x() * v.x() + line.y() * v.y() + line.z();
    };
    std::vector<SightRing> kept;
    for (const SightRing& ring : m_rings) {
        SightRing part;
        for (std::size_t i = 0; i < ring.corners.size(); ++i) {
            const SightRing::Corner& here = ring.corners[i];
            const Eigen::Vector2d& next = ring.corners[(i + 1) % ring.corners.size()].at;
            const double a = heightOf(here.at);
            const double b = heightOf(next);
            const Eigen::Vector2d cut = here.at + (a == b ? 0.0 : a / (a - b)) * (next - here.at);
            if (a > 0.0)
                part.corners.push_back(here);
            if (a > 0.0 && b <= 0.0)
                part.corners.push_back({cut, kCutRun});
            else if (a <= 0.0 && b > 0.0)
                part.corners.push_back({cut, here.run});
        }
        if (part.corners.size() > 2)
            kept.push_back(std::move(part));
    }
    m_rings = std::move(kept);
    if (isCircle())
        clipCircle(line);
    m_empty = !isCircle() && m_rings.empty();
    layEdges();
    return true;
}

void SightFigure::clipCircle(const Eigen::Vector3d& line) {
    const auto shortened = [](Chord chord, const Eigen::Vector3d& by, std::vector<Chord>& to) {
        const double a = by.x() * chord.first.x() + by.y() * chord.first.y() + by.z();
        const double b = by.x() * chord.second.x() + by.y() * chord.second.y() + by.z();
        if (a <= 0.0 && b <= 0.0)
            return;
        const Eigen::Vector2d cut = chord.first + (a == b ? 0.0 : a / (a - b)) * (chord.second - chord.first);
        if (a < 0.0)
            chord.first = cut;
        if (b < 0.0)
            chord.second = cut;
        to.push_back(chord);
    };
    std::vector<Chord> chords;
    for (const auto& chord : m_chords)
        shortened(chord, line, chords);
    const Eigen::Vector2d gradient = line.head<2>();
    const double slope = gradient.norm();
    const Eigen::Vector2d along(gradient.y() / slope, -gradient.x() / slope);
    const Eigen::Vector2d foot = -line.z() / (slope * slope) * gradient;
    const double half2 = m_radius * m_radius - foot.squaredNorm();
    if (half2 > 0.0) {
        Chord chord{foot - std::sqrt(half2) * along, foot + std::sqrt(half2) * along};
        m_arcEnds.push_back(chord.first / m_radius);
        m_arcEnds.push_back(chord.second / m_radius);
        std::vector<Chord> left{chord};
        for (const Eigen::Vector3d& other : m_cuts) {
            std::vector<Chord> shorter;
            for (const auto& part : left)
                shortened(part, other, shorter);
            left = std::move(shorter);
        }
        chords.insert(chords.end(), left.begin(), left.end());
    }
    m_chords = std::move(chords);
    m_cuts.push_back(line);
}

std::pair<double, double> SightFigure::heights(const HalfSpace& space) const {
    const double middle = space.height(origin);
    if (isCircle() && m_cuts.empty()) {
        const double swing = m_radius * std::hypot(space.normal.dot(e1), space.normal.dot(e2));
        return {middle - swing, middle + swing};
    }
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const auto take = [&](double height) {
        low = std::min(low, height);
        high = std::max(high, height);
    };
    for (const Eigen::Vector2d& corner : m_corners)
        take(space.height(inS(corner)));
    if (isCircle()) {
        const double swing = m_radius * std::hypot(space.normal.dot(e1), space.normal.dot(e2));
        take(middle - swing);
        take(middle + swing);
    }
    return {low, high};
}

} // namespace bask
