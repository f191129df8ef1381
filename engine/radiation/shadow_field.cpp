#include "engine/radiation/shadow_field.h"

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
constexpr int kNoRun = -100;
constexpr int kMaxSteps = 40;     // from edge to edge
constexpr double kEdgeOn = 1e-12; // of a figure's size: nearer to its plane, a point sees nothing of it
double valueOf(const Conic& f, const Eigen::Vector2d& u) {
    const double cos2 = u.x() * u.x() - u.y() * u.y(), sin2 = 2.0 * u.x() * u.y();
    return f.mean + f.c1 * u.x() + f.s1 * u.y() + f.c2 * cos2 + f.s2 * sin2;
}
double slopeOf(const Conic& f, const Eigen::Vector2d& u) { // along the circle
    const double cos2 = u.x() * u.x() - u.y() * u.y(), sin2 = 2.0 * u.x() * u.y();
    return f.s1 * u.x() - f.c1 * u.y() + 2.0 * (f.s2 * cos2 - f.c2 * sin2);
}
/// Returns the next edge of the same smooth line, back or on; -1 if there is none.
int neighbour(const SightFigure& figure, int edge, bool isBack) {
    const auto& edges = figure.edges();
    const int next = isBack ? edge - 1 : edge + 1;
    if (next < 0 || next >= static_cast<int>(edges.size()))
        return -1;
    const SightFigure::Edge& here = edges[static_cast<std::size_t>(edge)];
    const SightFigure::Edge& there = edges[static_cast<std::size_t>(next)];
    return here.run != there.run || (isBack ? here.isFirst : there.isFirst) ? -1 : next;
}
Eigen::Vector2d pointOn(const SightFigure& figure, int number, double along) {
    const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(number)];
    const Eigen::Vector2d& start = figure.corners()[static_cast<std::size_t>(edge.from)];
    return start + along * (figure.corners()[static_cast<std::size_t>(edge.to)] - start);
}
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
        const SightFigure& figure = scene.figure(members[i].figure);
        m_seen[i].figure = &figure;
        m_seen[i].axes << figure.e1, figure.e2, figure.n;
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

// The form of B's circle along A's.
Conic ShadowField::conic(std::size_t a, std::size_t b) const {
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
    return {product(c, c) + 0.5 * (pp + qq), 2.0 * product(c, p), 2.0 * product(c, q), 0.5 * (pp - qq),
            product(p, q)};
}

void ShadowField::cutCircles(std::size_t a, std::size_t b) {
    const Conic f = conic(a, b);
    const ConicRoots roots = rootsOf(f);
    for (std::size_t k = 0; k < roots.count; ++k) {
        const Eigen::Vector2d& u = roots.at[k];
        Crossing crossing{a, b, Place(u), Place(u), slopeOf(f, u) > 0.0};
        if (!placeOnB(crossing))
            continue;
        const auto number = static_cast<int>(m_sight.crossings.size());
        const Eigen::Vector2d& on = crossing.onB.on;
        m_seen[a].circleCuts.push_back({u, angleOrder(u), static_cast<int>(b), number});
        m_seen[b].circleCuts.push_back({on, angleOrder(on), static_cast<int>(a), number});
        m_sight.crossings.push_back(crossing);
    }
}

// Finds the place on B's circle of a crossing of two circles. Returns whether it is ahead.
bool ShadowField::placeOnB(Crossing& crossing) const {
    const Seen& onto = m_seen[crossing.b];
    const SightScene::Relation& from = relation(crossing.a, crossing.b);
    const Eigen::Vector2d on = m_seen[crossing.a].figure->radius() * crossing.onA.on;
    const Image at = image(onto, from.origin + on.x() * from.e1 + on.y() * from.e2);
    if (!isAhead(onto, at.w * travel(crossing.a, on)))
        return false;
    crossing.onB.on = Eigen::Vector2d(at.u, at.v) / (onto.figure->radius() * at.w);
    return true;
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
            const auto number = static_cast<int>(m_sight.crossings.size());
            onto.circleCuts.push_back(
                {on, angleOrder(on), static_cast<int>(straight) + 16 * (edge.run + 1), number});
            own.edgeCuts.push_back({i, s, static_cast<int>(circle), number});
            m_sight.crossings.push_back({straight, circle, {i, s}, Place(on), half + square * s > 0.0});
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
            const auto number = static_cast<int>(m_sight.crossings.size());
            const double t = sideP / (sideP - sideQ);
            own.edgeCuts.push_back({i, s, static_cast<int>(b) + 16 * (crossed.run + 1), number});
            onto.edgeCuts.push_back({j, t, static_cast<int>(a) + 16 * (edge.run + 1), number});
            m_sight.crossings.push_back({a, b, {i, s}, {j, t}});
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

void ShadowField::findArcs(std::size_t own, std::uint64_t& pattern) {
    Seen& seen = m_seen[own];
    const SightFigure& figure = *seen.figure;
    auto& cuts = seen.circleCuts;
    for (const Eigen::Vector2d& end : figure.arcEnds())
        cuts.push_back({end, angleOrder(end), 15, -1});
    const auto consider = [&](const Eigen::Vector2d& middle, Piece piece, std::uint64_t key) {
        const Eigen::Vector2d at = figure.radius() * middle;
        for (const Eigen::Vector3d& cut : figure.cuts())
            if (cut.x() * at.x() + cut.y() * at.y() + cut.z() <= 0.0)
                return;
        const double way = travel(own, at);
        if (!counts(own, at, way))
            return;
        const double turn = seen.h * way > 0.0 ? 1.0 : -1.0; // of the outline about the direction of travel
        pattern = mixed(pattern, key * 4 + (turn > 0.0 ? 1 : 2));
        piece.sign = own < m_targets || m_through ? turn : -turn;
        m_sight.pieces.push_back(piece);
    };
    if (cuts.empty()) {
        const Eigen::Vector2d anywhere(1.0, 0.0);
        consider(anywhere, {own, 0.0, -1, -1, Place(anywhere), Place(anywhere), kWholeTurn}, own);
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
        Eigen::Vector2d middle = from.at + to.at;
        if (cuts.size() == 1)
            middle = -from.at;
        else if (middle.squaredNorm() < 1e-20)
            middle = {-from.at.y(), from.at.x()};
        else
            middle *= (turn > 0.5 * kWholeTurn ? -1.0 : 1.0) / middle.norm();
        consider(middle, {own, 0.0, from.crossing, to.crossing, Place(from.at), Place(to.at), turn},
                 (static_cast<std::uint64_t>(from.by) * 1048573 + static_cast<std::uint64_t>(to.by)) * 16 +
                     own);
    }
}

void ShadowField::findLines(std::size_t own, std::uint64_t& pattern) {
    Seen& seen = m_seen[own];
    const SightFigure& figure = *seen.figure;
    auto& cuts = seen.edgeCuts;
    std::ranges::sort(cuts, [](const EdgeCut& a, const EdgeCut& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.at < b.at;
    });
    const std::vector<SightFigure::Edge>& edges = figure.edges();
    const auto consider = [&](const Place& first, const EdgeCut* from, const Place& last, const EdgeCut* to) {
        if (first.edge == last.edge && last.along - first.along <= 0.0)
            return;
        const Eigen::Vector2d middle =
            pointOn(figure, first.edge, 0.5 * (first.along + (first.edge == last.edge ? last.along : 1.0)));
        const double way = travel(own, middle);
        if (!counts(own, middle, way))
            return;
        const double turn = seen.h * way > 0.0 ? 1.0 : -1.0; // of the outline about the direction of travel
        const auto note = [&](int what) {
            pattern =
                mixed(pattern, static_cast<std::uint64_t>(what + 2) * 64 + own * 4 + (turn > 0.0 ? 1 : 2));
        };
        note(from ? from->by : -1);
        int run = kNoRun;
        for (int i = first.edge; i <= last.edge; ++i)
            if (const int here = edges[static_cast<std::size_t>(i)].run; here != run) {
                run = here;
                note(run);
            }
        note(to ? to->by : -1);
        m_sight.pieces.push_back({own, own < m_targets || m_through ? turn : -turn,
                                  from ? from->crossing : -1, to ? to->crossing : -1, first, last, 0.0});
    };
    auto cut = cuts.begin();
    for (int first = 0; first < static_cast<int>(edges.size());) { // a ring
        int end = first + 1;
        while (end < static_cast<int>(edges.size()) && !edges[static_cast<std::size_t>(end)].isFirst)
            ++end;
        Place from(first, 0.0);
        const EdgeCut* last = nullptr;
        for (; cut != cuts.end() && cut->edge < end; ++cut) {
            const Place to(cut->edge, cut->at);
            consider(from, last, to, &*cut);
            from = to;
            last = &*cut;
        }
        consider(from, last, {end - 1, 1.0}, nullptr);
        first = end;
    }
}

// Whether the rule on the smooth line that the chain stands for is exact enough, to 1e-8 of what it gives.
bool ShadowField::isFarFrom(const Seen& seen, const SightFigure::Chain& chain) {
    constexpr double kFar2 = 9.0; // distances of three lengths
    const Eigen::Vector2d aside = 0.5 * (chain.low + chain.high) - Eigen::Vector2d(seen.x, seen.y);
    return chain.nodes >= 0 &&
           aside.squaredNorm() + seen.h * seen.h > kFar2 * (chain.high - chain.low).squaredNorm();
}

Eigen::Vector3d ShadowField::smoothField(const Seen& seen, const SightFigure::Chain& chain) {
    const SightFigure& figure = *seen.figure;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const double z = seen.h;
    for (int i = 0; i < kNodesOfChain; ++i) {
        const SightNode& node =
            figure.nodes()[static_cast<std::size_t>(chain.nodes) + static_cast<std::size_t>(i)];
        const double x = node.at.x() - seen.x, y = node.at.y() - seen.y;
        const double scale = 1.0 / (x * x + y * y + z * z);
        sum.x() -= scale * z * node.step.y();
        sum.y() += scale * z * node.step.x();
        sum.z() += scale * (x * node.step.y() - y * node.step.x());
    }
    return sum.x() * figure.e1 + sum.y() * figure.e2 + sum.z() * figure.n;
}

const ShadowField::Place& ShadowField::begin(const Piece& piece) const {
    if (piece.from < 0)
        return piece.first;
    const Crossing& crossing = m_sight.crossings[static_cast<std::size_t>(piece.from)];
    return crossing.a == piece.own ? crossing.onA : crossing.onB;
}

const ShadowField::Place& ShadowField::end(const Piece& piece) const {
    if (piece.to < 0)
        return piece.last;
    const Crossing& crossing = m_sight.crossings[static_cast<std::size_t>(piece.to)];
    return crossing.a == piece.own ? crossing.onA : crossing.onB;
}

void ShadowField::addArc(const Piece& piece, LambertBatch& batch, int point, double factor) const {
    const Seen& seen = m_seen[piece.own];
    const bool isWhole = piece.turn == kWholeTurn;
    const Eigen::Vector2d& from = begin(piece).on;
    batch.addArc(point, factor, seen.figure->radius(), {seen.x, seen.y, -seen.h}, from,
                 isWhole ? from : end(piece).on, piece.turn > 0.5 * kWholeTurn, seen.axes);
}

// Along edges, and along the smooth line where that is far enough; between the two, it goes from the corner
// to the line or back.
void ShadowField::addLine(const Piece& piece, LambertBatch& batch, int point, double factor) const {
    const Seen& seen = m_seen[piece.own];
    const SightFigure& figure = *seen.figure;
    const Place& first = begin(piece);
    const Place& last = end(piece);
    const auto straight = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        batch.addStraight(point, factor, a, b);
    };
    const auto inS = [&](const Eigen::Vector2d& v) { return Eigen::Vector3d(figure.inS(v) - m_p); };
    const auto corner = [&](int i) { return inS(figure.corners()[static_cast<std::size_t>(i)]); };
    const SightFigure::Chain* line = nullptr; // on which the sum has come here
    Eigen::Vector3d here = Eigen::Vector3d::Zero();
    for (int i = first.edge; i <= last.edge; ++i) {
        const SightFigure::Edge& edge = figure.edges()[static_cast<std::size_t>(i)];
        const SightFigure::Chain& chain = figure.chains()[static_cast<std::size_t>(edge.chain)];
        const bool isWhole = chain.first == i && (i > first.edge || first.along == 0.0) &&
                             (chain.end <= last.edge || (chain.end == last.edge + 1 && last.along == 1.0));
        const bool isSmooth = isWhole && isFarFrom(seen, chain);
        if (isSmooth || line || i == first.edge) {
            here = corner(edge.from);
            if (i == first.edge && first.along > 0.0)
                here += first.along * (corner(edge.to) - here);
        }
        if (isSmooth && !line)
            straight(here, inS(chain.start));
        if (!isSmooth && line)
            straight(inS(line->stop), here);
        line = isSmooth ? &chain : nullptr;
        if (isSmooth) {
            batch.add(point, factor, smoothField(seen, chain));
            i = chain.end - 1;
            continue;
        }
        Eigen::Vector3d there = corner(edge.to);
        if (i == last.edge && last.along < 1.0) {
            const Eigen::Vector3d start = corner(edge.from);
            there = start + last.along * (there - start);
        }
        straight(here, there);
        here = there;
    }
    if (line)
        straight(inS(line->stop), corner(figure.edges()[static_cast<std::size_t>(last.edge)].to));
}

void ShadowField::addField(LambertBatch& batch, int point, double factor) const {
    for (const Piece& piece : m_sight.pieces)
        if (piece.first.edge < 0)
            addArc(piece, batch, point, 0.5 * factor * piece.sign);
        else
            addLine(piece, batch, point, 0.5 * factor * piece.sign);
}

bool ShadowField::followCircles(Crossing& crossing) const {
    constexpr int kSteps = 16;
    const Conic f = conic(crossing.a, crossing.b);
    Eigen::Vector2d& u = crossing.onA.on;
    for (int step = 0; step < kSteps; ++step) {
        const double turn = -valueOf(f, u) / slopeOf(f, u);
        if (!(std::abs(turn) < 0.5))
            return false;
        u = (u + turn * Eigen::Vector2d(-u.y(), u.x())).normalized();
        if (std::abs(turn) < 1e-8)
            return (slopeOf(f, u) > 0.0) == crossing.rises && placeOnB(crossing);
    }
    return false;
}

bool ShadowField::followCircleAndEdge(Crossing& crossing) const {
    const Seen& own = m_seen[crossing.a];
    const Seen& onto = m_seen[crossing.b];
    const SightScene::Relation& from = relation(crossing.a, crossing.b);
    const double radius = onto.figure->radius(), radius2 = radius * radius;
    for (int step = 0; step < kMaxSteps; ++step) {
        const SightFigure::Edge& edge = own.figure->edges()[static_cast<std::size_t>(crossing.onA.edge)];
        const Image a = image(onto, from.corners[static_cast<std::size_t>(edge.from)]),
                    b = image(onto, from.corners[static_cast<std::size_t>(edge.to)]);
        const double faa = formOf(a, a, radius2), fab = formOf(a, b, radius2), fbb = formOf(b, b, radius2);
        const double square = faa - 2.0 * fab + fbb, half = fab - faa, root2 = half * half - square * faa;
        if (root2 < 0.0)
            return false;
        const double q = -(half + (half < 0.0 ? -1.0 : 1.0) * std::sqrt(root2));
        const double s = (half >= 0.0) == crossing.rises ? faa / q : q / square;
        if (s >= 0.0 && s <= 1.0) {
            const double w = a.w + s * (b.w - a.w);
            crossing.onA.along = s;
            crossing.onB.on = Eigen::Vector2d(a.u + s * (b.u - a.u), a.v + s * (b.v - a.v)) / (radius * w);
            return isAhead(onto, w * travel(crossing.a, pointOn(*own.figure, crossing.onA.edge, s)));
        }
        crossing.onA.edge = neighbour(*own.figure, crossing.onA.edge, s < 0.0);
        if (crossing.onA.edge < 0)
            return false;
    }
    return false;
}

bool ShadowField::followEdges(Crossing& crossing) const {
    const Seen& own = m_seen[crossing.a];
    const Seen& onto = m_seen[crossing.b];
    const SightScene::Relation& relationA = relation(crossing.a, crossing.b);
    for (int step = 0; step < kMaxSteps; ++step) {
        const SightFigure::Edge& edge = own.figure->edges()[static_cast<std::size_t>(crossing.onA.edge)];
        const SightFigure::Edge& crossed = onto.figure->edges()[static_cast<std::size_t>(crossing.onB.edge)];
        const Image from = image(onto, relationA.corners[static_cast<std::size_t>(edge.from)]),
                    to = image(onto, relationA.corners[static_cast<std::size_t>(edge.to)]);
        const Eigen::Vector2d& p = onto.figure->corners()[static_cast<std::size_t>(crossed.from)];
        const Eigen::Vector2d& q = onto.figure->corners()[static_cast<std::size_t>(crossed.to)];
        const auto side = [&, x = from.v * to.w - from.w * to.v, y = from.w * to.u - from.u * to.w,
                           c = from.u * to.v - from.v * to.u](const Eigen::Vector2d& at) {
            return x * at.x() + y * at.y() + c;
        };
        const auto across = [&, x = p.y() - q.y(), y = q.x() - p.x(), c = p.x() * q.y() - p.y() * q.x()](
                                const Image& at) { return x * at.u + y * at.v + c * at.w; };
        const double u = across(from), v = across(to), sideP = side(p), sideQ = side(q);
        const double s = u / (u - v), t = sideP / (sideP - sideQ);
        const bool isOnA = s >= 0.0 && s <= 1.0, isOnB = t >= 0.0 && t <= 1.0;
        if (isOnA && isOnB) {
            crossing.onA.along = s;
            crossing.onB.along = t;
            return isAhead(onto, (from.w + s * (to.w - from.w)) *
                                     travel(crossing.a, pointOn(*own.figure, crossing.onA.edge, s)));
        }
        if (!isOnA)
            crossing.onA.edge = neighbour(*own.figure, crossing.onA.edge, s < 0.0);
        if (!isOnB)
            crossing.onB.edge = neighbour(*onto.figure, crossing.onB.edge, t < 0.0);
        if (crossing.onA.edge < 0 || crossing.onB.edge < 0)
            return false;
    }
    return false;
}

bool ShadowField::follow(Crossing& crossing) const {
    if (crossing.onA.edge < 0)
        return followCircles(crossing);
    return crossing.onB.edge < 0 ? followCircleAndEdge(crossing) : followEdges(crossing);
}

bool ShadowField::follow(const Eigen::Vector3d& p) {
    lookFrom(p);
    for (Crossing& crossing : m_sight.crossings)
        crossing.isHere = false;
    for (Piece& piece : m_sight.pieces) {
        for (const int number : {piece.from, piece.to})
            if (number >= 0 && !m_sight.crossings[static_cast<std::size_t>(number)].isHere) {
                Crossing& crossing = m_sight.crossings[static_cast<std::size_t>(number)];
                if (!follow(crossing))
                    return false;
                crossing.isHere = true;
            }
        const Place& first = begin(piece);
        const Place& last = end(piece);
        if (first.edge >= 0) {
            if (first.edge > last.edge || (first.edge == last.edge && first.along > last.along))
                return false;
        } else if (piece.turn != kWholeTurn) {
            double turn = angleOrder(last.on) - angleOrder(first.on);
            if (turn < 0.0)
                turn += kWholeTurn;
            if (std::abs(turn - piece.turn) > 1.0)
                return false;
            piece.turn = turn;
        }
    }
    return true;
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

void ShadowField::lookFrom(const Eigen::Vector3d& p) {
    m_p = p;
    for (Seen& seen : m_seen) {
        const Eigen::Vector3d back = p - seen.figure->origin;
        seen.x = seen.figure->e1.dot(back);
        seen.y = seen.figure->e2.dot(back);
        seen.h = -seen.figure->n.dot(back);
    }
}

ShadowLook ShadowField::at(const Eigen::Vector3d& p, bool withField) {
    ShadowLook look;
    m_sight.crossings.clear();
    m_sight.pieces.clear();
    lookFrom(p);
    if (!findActive(0.0))
        return look;
    for (Seen& seen : m_seen) {
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
            findArcs(own, look.pattern);
        if (!m_seen[own].figure->edges().empty())
            findLines(own, look.pattern);
    }
    if (withField) {
        LambertBatch batch;
        addField(batch, 0, 1.0);
        batch.finish();
        look.field = batch.field(0);
    }
    return look;
}

} // namespace bask
