#include "engine/radiation/shadow_field.h"

#include "engine/radiation/conic_roots.h"
#include "engine/radiation/lambert_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {
    hash ^= value + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
    return hash * 0xff51afd7ed558ccdULL;
}

// Ascends with the angle from 0 to kWholeTurn.
constexpr double kWholeTurn = 4.0;
constexpr double kSameCut = 1e-13; // between two cuts at one place
constexpr double kEdgeOn = 1e-12;  // of a figure's size: nearer to its plane, a point sees nothing of it
double angleOrder(const Eigen::Vector2d& u) {
    return u.y() >= 0.0 ? 1.0 - u.x() : 3.0 + u.x();
}

} // namespace

ShadowField::ShadowField(const SightScene& scene, std::span<const SightMember> targets,
                         std::span<const SightMember> blockers, bool through)
    : m_targets(targets.size()), m_through(through) {
    std::vector<SightMember> members(targets.begin(), targets.end());
    members.insert(members.end(), blockers.begin(), blockers.end());
    m_seen.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
        m_seen[i].figure = &scene.figure(members[i].figure);
        m_seen[i].side = members[i].side;
        m_seen[i].isTarget = i < m_targets;
    }
    for (const SightMember& of : members)
        for (const SightMember& to : members)
            m_relations.push_back(&scene.relation(of.figure, to.figure));
}

// The sign that turns the way from p to a point of the figure into the direction of travel.
double ShadowField::travel(std::size_t own, const Eigen::Vector2d& at) const {
    const Seen& seen = m_seen[own];
    if (seen.side != 0)
        return seen.side;
    const SightFigure& figure = *seen.figure;
    return figure.origin.z() + at.x() * figure.e1.z() + at.y() * figure.e2.z() < m_p.z() ? 1.0 : -1.0;
}

// Whether the ray through a point of `own` meets `other`; `way` is 1 if that point lies ahead, -1 if behind.
bool ShadowField::meets(std::size_t own, std::size_t other, const Eigen::Vector2d& at, double way) const {
    const Seen& seen = m_seen[other];
    const SightFigure& figure = *seen.figure;
    const SightScene::Relation& from = relation(own, other);
    const Image ray = image(seen, from.origin + at.x() * from.e1 + at.y() * from.e2);
    if (!isAhead(seen, way * ray.w))
        return false;
    bool inside = false;
    if (figure.isCircle()) {
        if (ray.u * ray.u + ray.v * ray.v >= figure.radius() * figure.radius() * ray.w * ray.w)
            return false;
        for (const Eigen::Vector3d& cut : figure.cuts())
            if ((cut.x() * ray.u + cut.y() * ray.v + cut.z() * ray.w) * ray.w <= 0.0)
                return false;
        inside = true;
    }
    if (figure.edges().empty())
        return inside;
    const double x = ray.u / ray.w, y = ray.v / ray.w;
    const auto& corners = figure.corners();
    for (const SightFigure::Chain& chain : figure.chains()) {
        if (y < chain.low.y() || y > chain.high.y() || x > chain.high.x())
            continue;
        for (int i = chain.first; i < chain.end; ++i) {
            const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
            const Eigen::Vector2d& a = corners[static_cast<std::size_t>(edge.from)];
            const Eigen::Vector2d& b = corners[static_cast<std::size_t>(edge.to)];
            if ((a.y() > y) != (b.y() > y) && !edge.isChord &&
                x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
                inside = !inside;
        }
    }
    return inside;
}

// Whether the outline of `own` at this point bounds the solid angle.
bool ShadowField::counts(std::size_t own, const Eigen::Vector2d& at, double way) const {
    for (std::size_t i = 0; i < m_targets; ++i)
        if (i != own && !meets(own, i, at, way))
            return false;
    bool blocked = false;
    for (std::size_t i = m_targets; i < m_seen.size() && !blocked; ++i)
        blocked = i != own && m_seen[i].isActive && meets(own, i, at, way);
    return own < m_targets && m_through ? blocked : !blocked;
}

void ShadowField::cutCircles(std::size_t a, std::size_t b) {
    const Seen& onto = m_seen[b];
    const SightScene::Relation& from = relation(a, b);
    const double radiusA = m_seen[a].figure->radius(), radiusB = onto.figure->radius();
    const Image c = image(onto, from.origin);
    const auto axis = [&](const Eigen::Vector3d& e) {
        return Image{radiusA * (onto.h * e.x() + onto.x * e.z()), radiusA * (onto.h * e.y() + onto.y * e.z()),
                     radiusA * e.z()};
    };
    const Image p = axis(from.e1), q = axis(from.e2);
    const auto product = [r2 = radiusB * radiusB](const Image& s, const Image& t) {
        return formOf(s, t, r2);
    };
    const double pp = product(p, p), qq = product(q, q);
    const Conic f{product(c, c) + 0.5 * (pp + qq), 2.0 * product(c, p), 2.0 * product(c, q), 0.5 * (pp - qq),
                  product(p, q)};
    const ConicRoots roots = rootsOf(f);
    for (std::size_t k = 0; k < roots.count; ++k) {
        const Eigen::Vector2d& u = roots.at[k];
        const double w = c.w + u.x() * p.w + u.y() * q.w;
        if (!isAhead(onto, w * travel(a, radiusA * u)))
            continue;
        m_seen[a].circleCuts.push_back({u, angleOrder(u), static_cast<int>(b)});
        const double scale = 1.0 / (radiusB * w);
        const Eigen::Vector2d on(scale * (c.u + u.x() * p.u + u.y() * q.u),
                                 scale * (c.v + u.x() * p.v + u.y() * q.v));
        m_seen[b].circleCuts.push_back({on, angleOrder(on), static_cast<int>(a)});
    }
}

// A ray r from p meets the plane at h r / (n . r); if r changes by at most the radius, so much does that
// change.
ShadowField::Shadow ShadowField::shadow(const Seen& onto, const std::pair<Eigen::Vector3d, double>& chain) {
    const auto& [middle, radius] = chain;
    const Image at = image(onto, middle);
    const double w = std::abs(at.w);
    if (w <= 1.01 * radius)
        return {Eigen::Vector2d::Zero(), std::numeric_limits<double>::infinity()};
    const double away = std::sqrt((middle.x() - onto.x) * (middle.x() - onto.x) +
                                  (middle.y() - onto.y) * (middle.y() - onto.y) + w * w);
    return {Eigen::Vector2d(at.u / at.w, at.v / at.w),
            std::abs(onto.h) * radius / (w - radius) * (1.0 + away / w)};
}

void ShadowField::cutCircleByEdges(std::size_t circle, std::size_t straight) {
    Seen& onto = m_seen[circle];
    Seen& own = m_seen[straight];
    const SightFigure& figure = *own.figure;
    const SightScene::Relation& from = relation(straight, circle);
    const double radius = onto.figure->radius(), radius2 = radius * radius;
    const auto product = [radius2](const Image& s, const Image& t) { return formOf(s, t, radius2); };
    const auto cut = [&](int i, const Image& a, double faa, const Image& b, double fbb) {
        if (faa < 0.0 && fbb < 0.0 && a.w * b.w > 0.0) // a circle is convex
            return;
        const double fab = product(a, b);
        const double square = faa - 2.0 * fab + fbb, half = fab - faa;
        if (faa > 0.0 && fbb > 0.0 && (half >= 0.0 || half + square <= 0.0))
            return;
        const double root2 = half * half - square * faa;
        if (root2 < 0.0)
            return;
        const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
        const Eigen::Vector2d& start = figure.corners()[static_cast<std::size_t>(edge.from)];
        const Eigen::Vector2d& end = figure.corners()[static_cast<std::size_t>(edge.to)];
        const double q = -(half + (half < 0.0 ? -1.0 : 1.0) * std::sqrt(root2));
        for (const double s : {q / square, faa / q}) {
            if (!(s > 0.0 && s < 1.0))
                continue;
            const double w = a.w + s * (b.w - a.w);
            if (!isAhead(onto, w * travel(straight, start + s * (end - start))))
                continue;
            const Eigen::Vector2d on =
                Eigen::Vector2d(a.u + s * (b.u - a.u), a.v + s * (b.v - a.v)) / (radius * w);
            onto.circleCuts.push_back({on, angleOrder(on), static_cast<int>(straight) + 16 * (edge.run + 1)});
            own.edgeCuts.push_back({i, s, static_cast<int>(circle)});
        }
    };
    for (std::size_t k = 0; k < figure.chains().size(); ++k) {
        const SightFigure::Chain& chain = figure.chains()[k];
        const Shadow around = shadow(onto, from.chains[k]);
        if (std::abs(around.middle.norm() - radius) > around.radius)
            continue;
        const SightFigure::Edge* last = nullptr;
        Image b{};
        double fbb = 0.0;
        for (int i = chain.first; i < chain.end; ++i) {
            const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
            const bool follows = last && last->to == edge.from;
            const Image a = follows ? b : image(onto, from.corners[static_cast<std::size_t>(edge.from)]);
            const double faa = follows ? fbb : product(a, a);
            b = image(onto, from.corners[static_cast<std::size_t>(edge.to)]);
            fbb = product(b, b);
            cut(i, a, faa, b, fbb);
            last = &edge;
        }
    }
}

void ShadowField::cutEdges(std::size_t a, std::size_t b) {
    Seen& own = m_seen[a];
    Seen& onto = m_seen[b];
    const SightFigure& figure = *own.figure;
    const SightFigure& other = *onto.figure;
    const SightScene::Relation& relationA = relation(a, b);
    m_images.resize(relationA.corners.size());
    const auto& cornersA = figure.corners();
    const auto& cornersB = other.corners();
    const auto compare = [&](int i, const SightFigure::Chain& against) {
        const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
        const Image& from = m_images[static_cast<std::size_t>(edge.from)];
        const Image& to = m_images[static_cast<std::size_t>(edge.to)];
        // The line through both images, and on which side of it the other's corners lie.
        const double lineX = from.v * to.w - from.w * to.v, lineY = from.w * to.u - from.u * to.w,
                     line = from.u * to.v - from.v * to.u;
        const auto side = [&](int corner) {
            const Eigen::Vector2d& at = cornersB[static_cast<std::size_t>(corner)];
            return lineX * at.x() + lineY * at.y() + line;
        };
        int last = -1;
        double sideQ = 0.0;
        for (int j = against.first; j < against.end; ++j) {
            const SightFigure::Edge& crossed = other.edges()[static_cast<std::size_t>(j)];
            const double sideP = crossed.from == last ? sideQ : side(crossed.from);
            sideQ = side(crossed.to);
            last = crossed.to;
            if ((sideP > 0.0) == (sideQ > 0.0))
                continue;
            const Eigen::Vector2d& p = cornersB[static_cast<std::size_t>(crossed.from)];
            const Eigen::Vector2d& q = cornersB[static_cast<std::size_t>(crossed.to)];
            const double acrossX = p.y() - q.y(), acrossY = q.x() - p.x(),
                         across = p.x() * q.y() - p.y() * q.x();
            const double u = acrossX * from.u + acrossY * from.v + across * from.w;
            const double v = acrossX * to.u + acrossY * to.v + across * to.w;
            if ((u > 0.0) == (v > 0.0))
                continue;
            const double s = u / (u - v);
            const Eigen::Vector2d& start = cornersA[static_cast<std::size_t>(edge.from)];
            const Eigen::Vector2d& end = cornersA[static_cast<std::size_t>(edge.to)];
            if (!isAhead(onto, (from.w + s * (to.w - from.w)) * travel(a, start + s * (end - start))))
                continue;
            own.edgeCuts.push_back({i, s, static_cast<int>(b) + 16 * (crossed.run + 1)});
            onto.edgeCuts.push_back({j, sideP / (sideP - sideQ), static_cast<int>(a) + 16 * (edge.run + 1)});
        }
    };
    for (std::size_t k = 0; k < figure.chains().size(); ++k) {
        const SightFigure::Chain& chain = figure.chains()[k];
        const Shadow around = shadow(onto, relationA.chains[k]);
        if (around.middle.norm() - around.radius > other.reach())
            continue;
        // The box around the image: infinite if the chain passes the plane through p.
        Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
        int sides = 0;
        for (int i = chain.first; i < chain.end; ++i) {
            const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
            for (const int corner : {edge.from, edge.to}) {
                if (corner == edge.from && i > chain.first)
                    continue;
                Image& at = m_images[static_cast<std::size_t>(corner)];
                at = image(onto, relationA.corners[static_cast<std::size_t>(corner)]);
                sides |= at.w > 0.0 ? 1 : 2;
                const Eigen::Vector2d point = Eigen::Vector2d(at.u, at.v) / at.w;
                low = low.cwiseMin(point);
                high = high.cwiseMax(point);
            }
        }
        for (const SightFigure::Chain& against : other.chains()) {
            if (sides != 3 && (low.x() > against.high.x() || high.x() < against.low.x() ||
                               low.y() > against.high.y() || high.y() < against.low.y()))
                continue;
            for (int i = chain.first; i < chain.end; ++i) {
                const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
                const Image& from = m_images[static_cast<std::size_t>(edge.from)];
                const Image& to = m_images[static_cast<std::size_t>(edge.to)];
                const auto isBeyond = [&](double Image::*axis, double bound, double sign) {
                    return sign * (from.*axis - bound * from.w) * from.w > 0.0 &&
                           sign * (to.*axis - bound * to.w) * to.w > 0.0;
                };
                if (sides != 3 && (isBeyond(&Image::u, against.high.x(), 1.0) ||
                                   isBeyond(&Image::u, against.low.x(), -1.0) ||
                                   isBeyond(&Image::v, against.high.y(), 1.0) ||
                                   isBeyond(&Image::v, against.low.y(), -1.0)))
                    continue;
                compare(i, against);
            }
        }
    }
}

void ShadowField::addCircle(std::size_t own, bool withField, ShadowLook& look) {
    Seen& seen = m_seen[own];
    const SightFigure& figure = *seen.figure;
    auto& cuts = seen.circleCuts;
    for (const Eigen::Vector2d& end : figure.arcEnds())
        cuts.push_back({end, angleOrder(end), 15});
    const auto consider = [&](const Eigen::Vector2d& middle, auto&& field, std::uint64_t key) {
        const Eigen::Vector2d at = figure.radius() * middle;
        for (const Eigen::Vector3d& cut : figure.cuts())
            if (cut.x() * at.x() + cut.y() * at.y() + cut.z() <= 0.0)
                return;
        const double way = travel(own, at);
        if (!counts(own, at, way))
            return;
        const double turn = seen.h * way > 0.0 ? 1.0 : -1.0; // of the outline about the direction of travel
        look.pattern = mixed(look.pattern, key * 4 + (turn > 0.0 ? 1 : 2));
        if (withField) {
            const Eigen::Vector3d local = (own < m_targets || m_through ? turn : -turn) * field();
            look.field += local.x() * figure.e1 + local.y() * figure.e2 + local.z() * figure.n;
        }
    };
    const auto arc = [&] { return ArcField(figure.radius(), {seen.x, seen.y, -seen.h}); };
    if (cuts.empty()) {
        consider(
            {1.0, 0.0}, [&] { return arc().whole(); }, own);
        return;
    }
    std::ranges::sort(cuts, {}, &CircleCut::order);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        const CircleCut& from = cuts[i];
        const bool isLast = i + 1 == cuts.size();
        const CircleCut& to = cuts[isLast ? 0 : i + 1];
        const double turn = to.order - from.order + (isLast ? kWholeTurn : 0.0);
        if (turn < kSameCut)
            continue;
        const bool isLong = turn > 0.5 * kWholeTurn;
        Eigen::Vector2d middle = from.at + to.at;
        if (cuts.size() == 1)
            middle = -from.at;
        else if (middle.squaredNorm() < 1e-20)
            middle = {-from.at.y(), from.at.x()};
        else
            middle *= (isLong ? -1.0 : 1.0) / middle.norm();
        consider(
            middle, [&] { return cuts.size() == 1 ? arc().whole() : arc().between(from.at, to.at, isLong); },
            (static_cast<std::uint64_t>(from.by) * 1048573 + static_cast<std::uint64_t>(to.by)) * 16 + own);
    }
}

// Whether the rule on the smooth line that the chain stands for is exact enough, to 1e-8 of what it gives.
bool ShadowField::isFarFrom(const Seen& seen, const SightFigure::Chain& chain) {
    constexpr double kFar2 = 9.0; // distances of three lengths
    const Eigen::Vector2d aside = 0.5 * (chain.low + chain.high) - Eigen::Vector2d(seen.x, seen.y);
    return chain.nodes >= 0 &&
           aside.squaredNorm() + seen.h * seen.h > kFar2 * (chain.high - chain.low).squaredNorm();
}

void ShadowField::addLine(const Seen& seen, const SightFigure::Chain& chain, double sign, ShadowLook& look) {
    const SightFigure& figure = *seen.figure;
    const Eigen::Vector2d p(seen.x, seen.y);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const double z = seen.h;
    for (int i = 0; i < kNodesOfChain; ++i) {
        const SightNode& node =
            figure.nodes()[static_cast<std::size_t>(chain.nodes) + static_cast<std::size_t>(i)];
        const double x = node.at.x() - p.x(), y = node.at.y() - p.y();
        const double scale = 1.0 / (x * x + y * y + z * z);
        sum.x() -= scale * z * node.step.y();
        sum.y() += scale * z * node.step.x();
        sum.z() += scale * (x * node.step.y() - y * node.step.x());
    }
    look.field += sign * (sum.x() * figure.e1 + sum.y() * figure.e2 + sum.z() * figure.n);
}

void ShadowField::addEdges(std::size_t own, bool withField, ShadowLook& look) {
    Seen& seen = m_seen[own];
    const SightFigure& figure = *seen.figure;
    auto& cuts = seen.edgeCuts;
    std::ranges::sort(cuts, [](const EdgeCut& a, const EdgeCut& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.at < b.at;
    });
    std::size_t cut = 0;
    bool known = false, included = false;
    double turn = 1.0;
    std::uint64_t lastKey = 0;
    const double outward = own < m_targets || m_through ? 1.0 : -1.0;
    const auto decide = [&](const Eigen::Vector2d& at) {
        const double way = travel(own, at);
        included = counts(own, at, way);
        turn = seen.h * way > 0.0 ? 1.0 : -1.0; // of the outline about the direction of travel
        known = true;
        lastKey = 0;
    };
    const auto note = [&](int by, int run) {
        if (!included)
            return;
        const std::uint64_t key =
            (static_cast<std::uint64_t>(by) * 1048573 + static_cast<std::uint64_t>(run + 2)) * 64 + own * 4 +
            (turn > 0.0 ? 1 : 2);
        if (key != lastKey)
            look.pattern = mixed(look.pattern, key);
        lastKey = key;
    };
    // Where the sum passes from edges to the smooth line or back, it goes from the corner to the line or
    // back.
    const SightFigure::Chain* ring = nullptr; // its first chain
    bool onLine = false, beganOnLine = false;
    const auto passTo = [&](bool line, const SightFigure::Chain& chain) {
        if (included && line != onLine) {
            const int corner = figure.edges()[static_cast<std::size_t>(chain.first)].from;
            const Eigen::Vector3d a = figure.inS(figure.corners()[static_cast<std::size_t>(corner)]) - m_p;
            const Eigen::Vector3d b = figure.inS(chain.start) - m_p;
            look.field += (line ? outward : -outward) * turn * straightField(a, b);
        }
        onLine = line;
    };
    for (const SightFigure::Chain& chain : figure.chains()) {
        const SightFigure::Edge& first = figure.edges()[static_cast<std::size_t>(chain.first)];
        const bool changes = cut < cuts.size() && cuts[cut].edge < chain.end;
        const bool asLine = withField && !changes && isFarFrom(seen, chain);
        if (first.isFirst) {
            if (ring)
                passTo(beganOnLine, *ring);
            ring = &chain;
            onLine = beganOnLine = asLine;
            known = false;
        }
        if (!changes) {
            if (!known)
                decide(0.5 * (figure.corners()[static_cast<std::size_t>(first.from)] +
                              figure.corners()[static_cast<std::size_t>(first.to)]));
            if (!included)
                continue;
            if (asLine || (!withField && chain.nodes >= 0))
                note(0, first.run);
        }
        passTo(asLine, chain);
        if (asLine)
            addLine(seen, chain, outward * turn, look);
        if (!changes && (asLine || (!withField && chain.nodes >= 0)))
            continue;
        for (int i = chain.first; i < chain.end; ++i) {
            const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
            const Eigen::Vector2d& start = figure.corners()[static_cast<std::size_t>(edge.from)];
            const Eigen::Vector2d& end = figure.corners()[static_cast<std::size_t>(edge.to)];
            double from = 0.0;
            int by = 0;
            for (bool more = true; more;) {
                more = cut < cuts.size() && cuts[cut].edge == i;
                const double to = more ? cuts[cut].at : 1.0;
                const Eigen::Vector2d a = start + from * (end - start);
                const Eigen::Vector2d b = start + to * (end - start);
                if (!known)
                    decide(0.5 * (a + b));
                note(by, edge.run);
                if (included && withField)
                    look.field += outward * turn * straightField(figure.inS(a) - m_p, figure.inS(b) - m_p);
                if (more) {
                    from = to;
                    by = cuts[cut].by + 1;
                    known = false;
                    if (included)
                        look.pattern = mixed(look.pattern, static_cast<std::uint64_t>(by));
                    ++cut;
                }
            }
        }
    }
    if (ring)
        passTo(beganOnLine, *ring);
}

// Whether the spheres around two figures overlap as seen from p.
bool ShadowField::mayOverlap(const Seen& a, const Seen& b) {
    if (a.tangent < 0.0 || b.tangent < 0.0)
        return true;
    const double cosine = a.centre.dot(b.centre), most = a.tangent * b.tangent - a.reach * b.reach;
    return (a.side != 0 && b.side != 0 ? cosine : std::abs(cosine)) > most;
}

// Returns whether the solid angle may be more than nothing.
bool ShadowField::findActive(double slack_m) {
    for (Seen& seen : m_seen) {
        const SightFigure& figure = *seen.figure;
        seen.centre = (seen.side < 0 ? -1.0 : 1.0) * (figure.origin - m_p);
        seen.reach = figure.reach() + slack_m;
        const double tangent2 = seen.centre.squaredNorm() - seen.reach * seen.reach;
        seen.tangent = tangent2 > 0.0 ? std::sqrt(tangent2) : -1.0;
        seen.isActive = true;
    }
    for (std::size_t i = 1; i < m_targets; ++i)
        if (!mayOverlap(m_seen[0], m_seen[i]))
            return false;
    bool any = !m_through;
    for (std::size_t i = m_targets; i < m_seen.size(); ++i) {
        for (std::size_t j = 0; j < m_targets; ++j)
            m_seen[i].isActive = m_seen[i].isActive && mayOverlap(m_seen[i], m_seen[j]);
        any = any || m_seen[i].isActive;
    }
    return any;
}

bool ShadowField::mayBeSeen(const Eigen::Vector3d& p, double slack_m) {
    m_p = p;
    return findActive(slack_m);
}

ShadowLook ShadowField::at(const Eigen::Vector3d& p, bool withField) {
    m_p = p;
    ShadowLook look;
    if (!findActive(0.0))
        return look;
    for (Seen& seen : m_seen) {
        const Eigen::Vector3d back = p - seen.figure->origin;
        seen.x = seen.figure->e1.dot(back);
        seen.y = seen.figure->e2.dot(back);
        seen.h = -seen.figure->n.dot(back);
        seen.circleCuts.clear();
        seen.edgeCuts.clear();
        if (std::abs(seen.h) > kEdgeOn * seen.figure->reach())
            continue;
        if (seen.isTarget)
            return look;
        seen.isActive = false;
    }
    for (std::size_t a = 0; a < m_seen.size(); ++a)
        for (std::size_t b = a + 1; b < m_seen.size(); ++b) {
            if (!m_seen[a].isActive || !m_seen[b].isActive || !mayOverlap(m_seen[a], m_seen[b]))
                continue;
            const bool roundA = m_seen[a].figure->isCircle(), roundB = m_seen[b].figure->isCircle();
            const bool edgesA = !m_seen[a].figure->edges().empty(),
                       edgesB = !m_seen[b].figure->edges().empty();
            if (roundA && roundB)
                cutCircles(a, b);
            if (roundA && edgesB)
                cutCircleByEdges(a, b);
            if (roundB && edgesA)
                cutCircleByEdges(b, a);
            if (edgesA && edgesB)
                cutEdges(a, b);
        }
    for (std::size_t own = 0; own < m_seen.size(); ++own) {
        if (!m_seen[own].isActive)
            continue;
        if (m_seen[own].figure->isCircle())
            addCircle(own, withField, look);
        if (!m_seen[own].figure->edges().empty())
            addEdges(own, withField, look);
    }
    look.field *= 0.5;
    return look;
}

} // namespace bask
