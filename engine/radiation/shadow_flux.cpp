#include "engine/radiation/shadow_flux.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"
#include "engine/radiation/shadow_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

namespace bask {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.7;    // of the smallest plate's size
constexpr double kNudge = 1e-11; // of a plate's size

// Rules on [0, 1], each with the nodes of the one before (T. Patterson, The optimum addition of points to
// quadrature formulae, Math. Comp. 22, 1968): of 1, 3, 7 and 15 nodes.
struct Node {
    double at, weight;
    double before, beforeThat; ///< weights of the two rules inside
};
constexpr std::array<Node, 7> kSeven{{
    {0.01975436564598985829, 0.052328113013233632597, 0.0, 0.0},
    {0.11270166537925831148, 0.13424404493416672036, 0.27777777777777777778, 0.0},
    {0.282878125326598721, 0.20069870738798111145, 0.0, 0.0},
    {0.5, 0.22545826932923707117, 0.44444444444444444444, 1.0},
    {0.717121874673401279, 0.20069870738798111145, 0.0, 0.0},
    {0.88729833462074168852, 0.13424404493416672036, 0.27777777777777777778, 0.0},
    {0.98024563435401014171, 0.052328113013233632597, 0.0, 0.0},
}};
constexpr std::array<Node, 15> kFifteen{{
    {0.003084018393622488895, 0.00850085981497013017, 0.0, 0.0},
    {0.01975436564598985829, 0.02580164149853986985, 0.052328113013233632597, 0.0},
    {0.055770383563871500555, 0.046463597657562268845, 0.0, 0.0},
    {0.11270166537925831148, 0.06720762762189211018, 0.13424404493416672036, 0.27777777777777777778},
    {0.18944852663138679853, 0.085755954568195690395, 0.0, 0.0},
    {0.282878125326598721, 0.100314264688494510515, 0.20069870738798111145, 0.0},
    {0.388306656785516559185, 0.1095784292007937482, 0.0, 0.0},
    {0.5, 0.112755249899103343695, 0.22545826932923707117, 0.44444444444444444444},
    {0.611693343214483440815, 0.1095784292007937482, 0.0, 0.0},
    {0.717121874673401279, 0.100314264688494510515, 0.20069870738798111145, 0.0},
    {0.81055147336861320147, 0.085755954568195690395, 0.0, 0.0},
    {0.88729833462074168852, 0.06720762762189211018, 0.13424404493416672036, 0.27777777777777777778},
    {0.944229616436128499445, 0.046463597657562268845, 0.0, 0.0},
    {0.98024563435401014171, 0.02580164149853986985, 0.052328113013233632597, 0.0},
    {0.996915981606377511105, 0.00850085981497013017, 0.0, 0.0},
}};

/// A smooth part of an outline in S, with a parameter from 0 to 1.
struct Curve {
    Vector3d origin, e1, e2; ///< of the plate; of a straight part: its start, its step and nothing
    Vector3d normal;         ///< about which the outline runs counter-clockwise
    double nudge_m = 0.0;
    const RadiatingContour::Impl* smooth = nullptr; ///< null if it is straight
    double speed_m = 0.0;                           ///< largest length of the derivative
    int panels = 1;                                 ///< at first, of the whole

    bool isClosed() const { return smooth != nullptr; }
    std::pair<Vector3d, Vector3d> at(double t) const { // point and derivative
        if (!smooth)
            return {origin + t * e1, e1};
        const OutlinePoint p = smooth->at(t);
        return {origin + p.x * e1 + p.y * e2, p.dx * e1 + p.dy * e2};
    }
    /// Returns the point from which to look: a hair outside, since on the outline itself another plate's edge
    /// or shadow may end in the same line, as with squares above one another.
    Vector3d lookout(const Vector3d& p, const Vector3d& step) const {
        return p + nudge_m / step.norm() * step.cross(normal);
    }
};

std::vector<Curve> curvesOf(const PlacedShape& placed) {
    std::vector<Curve> curves;
    const RadiatingContour::Impl& outline = placed.contour.impl();
    const double nudge_m = kNudge * outline.plate().reach_m();
    const Vector3d normal = placed.X_S.linear().col(2), origin = placed.X_S.translation(),
                   e1 = placed.X_S.linear().col(0), e2 = placed.X_S.linear().col(1);
    const auto addRing = [&](const Contour& ring, bool isHole) {
        for (std::size_t i = 0; i < ring.points_m.size(); ++i) {
            Eigen::Vector2d a = ring.points_m[i], b = ring.points_m[(i + 1) % ring.points_m.size()];
            if (isHole)
                std::swap(a, b);
            const Eigen::Vector2d along = b - a;
            curves.push_back({origin + a.x() * e1 + a.y() * e2, along.x() * e1 + along.y() * e2,
                              Vector3d::Zero(), normal, nudge_m, nullptr, along.norm(), 1});
        }
    };
    if (const auto* polygon = outlineAs<Contour>(outline.shape))
        addRing(*polygon, false);
    else
        curves.push_back({origin, e1, e2, normal, nudge_m, &outline, outline.maxSpeed_m,
                          outline.disk ? 4 : 4 + outline.harmonics});
    for (const Contour& hole : holesOf(outline.shape))
        addRing(hole, true);
    return curves;
}

/// A line integral of the forces dl x B at arms from the object's origin.
struct Sum {
    double stretch = 0.0;                ///< of arm . force
    Vector6d moments = Vector6d::Zero(); ///< of force, arm x force

    void add(double weight, const Vector3d& arm, const Vector3d& force) {
        stretch += weight * arm.dot(force);
        moments.head<3>() += weight * force;
        moments.tail<3>() += weight * arm.cross(force);
    }
};

/// The outline of one plate, and the fields of the rays through its points.
struct Outline {
    struct Part {
        ShadowField field;
        double sign; ///< of the flux that grows where the outline moves outward
    };
    std::vector<Curve> curves;
    std::vector<Part> parts;
    bool inFront = true, above = true; ///< only points in front of the object and above the source count
};

/// A part of a curve. Where the pattern changes, the field has a root or a kink, so panels end there.
struct Panel {
    double from = 0.0, to = 1.0;
    bool changesFrom = false, changesTo = false;
    std::size_t outline = 0;
    const Curve* curve = nullptr;
    std::uint64_t pattern = 0;
    bool isFine = false;             ///< of fifteen nodes, not seven
    std::optional<std::size_t> kept; ///< its seven nodes
    int sights = -1;                 ///< what is seen from its middle, if that is `pattern`
    Sum sum;
    double error = 0.0;      ///< estimated, of the stretch
    double difference = 0.0; ///< of two rules: what the error hardly exceeds
};

class LineIntegrals {
public:
    LineIntegrals(std::vector<Outline>& outlines, const HalfSpace& front, const Vector3d& p_SO)
        : m_outlines(outlines), m_front(front), m_p_SO(p_SO) {}

    /// `allowed_m2`: error of the stretch; `step_m`: what is narrower may be missed at first.
    void integrate(double tolerance, double allowed_m2, double step_m, int maxPoints) {
        // What lies between a change and where it was found counts with the power of 5/2.
        m_precision = std::clamp(std::pow(tolerance, 0.5), 1e-6, 1e-3);
        m_startFine = tolerance < 1e-7;
        // What was missed is searched in smaller steps, as long as that helps.
        constexpr int kTries = 3;
        double openBefore_m2 = std::numeric_limits<double>::infinity();
        for (int attempt = 0; attempt < kTries; ++attempt, step_m *= 0.25, m_precision *= 0.1) {
            m_step_m = step_m;
            m_panels.clear();
            m_kept.clear();
            m_usedSights = 0;
            for (std::size_t k = 0; k < m_outlines.size(); ++k)
                for (const Curve& curve : m_outlines[k].curves)
                    addPanels(k, curve);
            refine(
                &Panel::error, [&] { return sumOf(&Panel::error) > allowed_m2; }, maxPoints);
            // The forces add up to nothing. If they do not, something was missed or an estimate was too
            // small.
            const int enough = std::min(maxPoints, m_points + m_points / 2);
            refine(
                &Panel::difference, [&] { return openness_m2() > allowed_m2; }, enough);
            const double open_m2 = openness_m2();
            if (open_m2 <= allowed_m2 || open_m2 > 0.5 * openBefore_m2 || m_points >= maxPoints)
                return;
            openBefore_m2 = open_m2;
        }
    }

    double error_m2() const { return std::max(sumOf(&Panel::error), openness_m2()); }
    const std::vector<Panel>& panels() const { return m_panels; }

private:
    double sumOf(double Panel::*what) const {
        double sum = 0.0;
        for (const Panel& panel : m_panels)
            sum += panel.*what;
        return sum;
    }

    double openness_m2() const {
        Vector3d force = Vector3d::Zero();
        for (const Panel& panel : m_panels)
            force += panel.sum.moments.head<3>();
        return force.norm() * m_p_SO.norm();
    }

    // Refines the panels that are worst in some respect while the condition holds.
    template <class Condition> void refine(double Panel::*worst, const Condition& goesOn, int maxPoints) {
        const auto isBetter = [worst](const Panel& a, const Panel& b) { return a.*worst < b.*worst; };
        std::ranges::make_heap(m_panels, isBetter);
        while (!m_panels.empty() && m_points < maxPoints && m_panels.front().*worst > 0.0 && goesOn()) {
            std::ranges::pop_heap(m_panels, isBetter);
            Panel& panel = m_panels.back();
            if (!panel.isFine) {
                panel.isFine = true;
                evaluate(panel);
            } else {
                panel.kept.reset();
                Panel right = panel;
                panel.to = right.from = 0.5 * (panel.from + panel.to);
                panel.changesTo = right.changesFrom = false;
                evaluate(panel);
                evaluate(right);
                std::ranges::push_heap(m_panels, isBetter);
                m_panels.push_back(std::move(right));
            }
            std::ranges::push_heap(m_panels, isBetter);
        }
    }

    bool isSeen(const Outline& outline, const Vector3d& p) const {
        return (!outline.inFront || m_front.height(p) > 0.0) && (!outline.above || p.z() > 0.0);
    }

    std::uint64_t patternAt(Outline& outline, const Curve& curve, double t) {
        const auto [p, step] = curve.at(t);
        if (!isSeen(outline, p))
            return 0;
        const Vector3d eye = curve.lookout(p, step);
        std::uint64_t pattern = 0;
        for (Outline::Part& part : outline.parts)
            pattern = pattern * 31 + part.field.at(eye, false).pattern;
        return pattern;
    }

    struct Change {
        double at;
        std::uint64_t then; ///< pattern from there on
    };

    void findChanges(Outline& outline, const Curve& curve, Change a, Change b, std::vector<Change>& changes) {
        while (b.at - a.at > m_precision && a.then != b.then) {
            const double at = 0.5 * (a.at + b.at);
            const Change middle{at, patternAt(outline, curve, at)};
            if (middle.then == a.then) {
                a = middle;
            } else if (middle.then == b.then || b.at - a.at < 4.0 * m_precision) {
                b = middle;
            } else {
                findChanges(outline, curve, a, middle, changes);
                a = middle;
            }
        }
        if (a.then != b.then)
            changes.push_back({0.5 * (a.at + b.at), b.then});
    }

    // Asks what is seen in steps, but not where nothing can be.
    void sample(Outline& outline, const Curve& curve, double from, double to, std::vector<Change>& samples) {
        const double middle = 0.5 * (from + to), slack_m = 0.5 * (to - from) * curve.speed_m;
        const Vector3d p = curve.at(middle).first;
        if (std::ranges::none_of(outline.parts,
                                 [&](Outline::Part& part) { return part.field.mayBeSeen(p, slack_m); })) {
            samples.push_back({from, 0});
            samples.push_back({to, 0});
        } else if (2.0 * slack_m > m_step_m && to - from > kMinStep) {
            sample(outline, curve, from, middle, samples);
            sample(outline, curve, middle, to, samples);
        } else {
            samples.push_back({middle, patternAt(outline, curve, middle)});
        }
    }

    void addPanels(std::size_t k, const Curve& curve) {
        Outline& outline = m_outlines[k];
        std::vector<Change> samples;
        sample(outline, curve, 0.0, 1.0, samples);
        if (curve.isClosed()) {
            samples.push_back({1.0 + samples[0].at, samples[0].then});
        } else {
            if (samples.front().at > 0.0)
                samples.insert(samples.begin(), {m_precision, patternAt(outline, curve, m_precision)});
            if (samples.back().at < 1.0)
                samples.push_back({1.0 - m_precision, patternAt(outline, curve, 1.0 - m_precision)});
        }
        std::vector<Change> changes;
        for (std::size_t i = 0; i + 1 < samples.size(); ++i)
            findChanges(outline, curve, samples[i], samples[i + 1], changes);
        const bool isWhole = changes.empty();
        if (curve.isClosed() && !isWhole)
            changes.insert(changes.begin(), {changes.back().at - 1.0, changes.back().then});
        else
            changes.insert(changes.begin(), {0.0, samples[0].then});
        if (!curve.isClosed() || isWhole)
            changes.push_back({1.0, 0});
        for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
            if (changes[i].then == 0)
                continue;
            const double from = changes[i].at, length = changes[i + 1].at - from;
            const int pieces = std::max(1, static_cast<int>(std::ceil(length * curve.panels - 0.3)));
            for (int piece = 0; piece < pieces; ++piece) {
                Panel panel;
                panel.outline = k;
                panel.isFine = m_startFine;
                panel.curve = &curve;
                panel.pattern = changes[i].then;
                panel.from = from + length * piece / pieces;
                panel.to = from + length * (piece + 1) / pieces;
                panel.changesFrom = piece == 0 && !isWhole && (curve.isClosed() || i > 0);
                panel.changesTo =
                    piece == pieces - 1 && !isWhole && (curve.isClosed() || i + 2 < changes.size());
                evaluate(panel);
                m_panels.push_back(panel);
            }
        }
    }

    /// What a node adds to the integrals, but for the rule's weight; the force is at first a step of the
    /// curve.
    struct Share {
        Vector3d arm = Vector3d::Zero(), force = Vector3d::Zero();
    };

    Share shareAt(const Panel& panel, double u, LambertBatch& batch, int point) {
        Outline& outline = m_outlines[panel.outline];
        const double length = panel.to - panel.from;
        double slope = 1.0;
        // A root (t - t0)^(3/2) at an end becomes a cube.
        if (panel.changesFrom && panel.changesTo) {
            slope = 6.0 * u * (1.0 - u);
            u *= u * (3.0 - 2.0 * u);
        } else if (panel.changesFrom) {
            slope = 2.0 * u;
            u *= u;
        } else if (panel.changesTo) {
            slope = 2.0 * (1.0 - u);
            u *= 2.0 - u;
        }
        const auto [p, step] = panel.curve->at(panel.from + length * u);
        if (!isSeen(outline, p)) {
            m_follows = false;
            return {};
        }
        ++m_points;
        const Vector3d eye = panel.curve->lookout(p, step);
        for (Outline::Part& part : outline.parts)
            m_follows = m_follows && part.field.follow(eye);
        if (!m_follows) {
            std::uint64_t pattern = 0;
            for (Outline::Part& part : outline.parts)
                pattern = pattern * 31 + part.field.at(eye, false).pattern;
            m_follows = pattern == panel.pattern;
        }
        for (Outline::Part& part : outline.parts)
            part.field.addField(batch, point, part.sign);
        return {p - m_p_SO, step * (length * slope / std::numbers::pi)};
    }

    void evaluate(Panel& panel) {
        const std::span<const Node> rule =
            panel.isFine ? std::span<const Node>(kFifteen) : std::span<const Node>(kSeven);
        std::array<Share, kFifteen.size()> shares;
        const bool hasSeven = panel.isFine && panel.kept;
        LambertBatch batch;
        const auto fill = [&](std::size_t i) {
            const bool isKnown = hasSeven && i % 2 == 1;
            shares[i] =
                isKnown ? m_kept[*panel.kept][i / 2] : shareAt(panel, rule[i].at, batch, static_cast<int>(i));
        };
        // From the middle to either end: between changes, what is seen can be followed from node to node.
        Outline& outline = m_outlines[panel.outline];
        const std::size_t middle = rule.size() / 2;
        if (!hasSeven) {
            m_follows = false;
            fill(middle);
            panel.sights = m_follows ? keepSights(outline) : -1;
        } else {
            fill(middle);
            m_follows = panel.sights >= 0;
            if (m_follows)
                resumeSights(outline, panel.sights);
        }
        for (std::size_t i = middle; i-- > 0;)
            fill(i);
        m_follows = panel.sights >= 0;
        if (m_follows)
            resumeSights(outline, panel.sights);
        for (std::size_t i = middle + 1; i < rule.size(); ++i)
            fill(i);
        batch.finish();
        for (std::size_t i = 0; i < rule.size(); ++i)
            if (!hasSeven || i % 2 == 0)
                shares[i].force = shares[i].force.cross(batch.field(static_cast<int>(i))).eval();
        if (!panel.isFine) {
            panel.kept = m_kept.size();
            std::ranges::copy_n(shares.begin(), kSeven.size(), m_kept.emplace_back().begin());
        }
        Sum sum;
        double size = 0.0, before = 0.0, beforeThat = 0.0;
        for (std::size_t i = 0; i < rule.size(); ++i) {
            const Node& node = rule[i];
            const double value = shares[i].arm.dot(shares[i].force);
            sum.add(node.weight, shares[i].arm, shares[i].force);
            before += node.before * value;
            beforeThat += node.beforeThat * value;
            size += node.weight * std::abs(value);
        }
        panel.sum = sum;
        // The differences between the rules fall; so will the next.
        panel.difference = std::abs(sum.stretch - before);
        const double last = std::abs(before - beforeThat);
        const double ratio = last > 0.0 ? std::min(1.0, kCaution * panel.difference / last) : 1.0;
        panel.error =
            std::max(panel.difference * ratio, 16.0 * std::numeric_limits<double>::epsilon() * size);
    }

    int keepSights(const Outline& outline) {
        const auto first = static_cast<std::size_t>(m_usedSights);
        m_usedSights += static_cast<int>(outline.parts.size());
        if (first + outline.parts.size() > m_sights.size())
            m_sights.resize(first + outline.parts.size());
        for (std::size_t i = 0; i < outline.parts.size(); ++i)
            m_sights[first + i] = outline.parts[i].field.sight();
        return static_cast<int>(first);
    }

    void resumeSights(Outline& outline, int first) {
        for (std::size_t i = 0; i < outline.parts.size(); ++i)
            outline.parts[i].field.resume(m_sights[static_cast<std::size_t>(first) + i]);
    }

    static constexpr double kCaution = 3.0;
    static constexpr double kMinStep = 1.0 / 1024; // of a curve

    std::vector<Outline>& m_outlines;
    HalfSpace m_front;
    Vector3d m_p_SO;
    double m_precision = 0.0; ///< of a curve: how near a change is found
    double m_step_m = 0.0;
    bool m_follows = false; ///< the last point saw what its panel sees
    bool m_startFine = false;
    std::vector<Panel> m_panels;
    std::vector<std::array<Share, kSeven.size()>> m_kept;
    std::vector<ShadowField::Sight> m_sights;
    int m_usedSights = 0;
    int m_points = 0;
};

} // namespace

ShadowFlux shadowFlux(const PlacedShape& source, const PlacedShape& object,
                      std::span<const PlacedShape> blockers, const ShadowFluxGoal& goal) {
    ShadowFlux flux;
    flux.byBlocker.assign(blockers.size(), Vector6d::Zero());
    SightScene scene;
    const auto add = [&](const PlacedShape& placed) {
        return scene.add(
            SightFigure(placed.contour.impl().plate().outline(goal.tolerance).outline, placed.X_S));
    };
    const Vector3d face = -object.X_S.linear().col(2), p_SO = object.X_S.translation();
    const HalfSpace above, front{face, -face.dot(p_SO)};
    const std::size_t seenSource = scene.clipped(add(source), front),
                      seenObject = scene.clipped(add(object), above);
    // From a point of a face, its plane is the horizon: the other face is cut there, and a blocker that were
    // cut there too would share this edge.
    struct Between {
        std::size_t number, fromSource, fromObject, fromBlocker;
    };
    std::vector<Between> between;
    for (std::size_t i = 0; i < blockers.size(); ++i) {
        const std::size_t whole = add(blockers[i]);
        const std::size_t aboveSource = scene.clipped(whole, above);
        const std::size_t both =
            scene.figure(aboveSource).empty() ? aboveSource : scene.clipped(aboveSource, front);
        if (!scene.figure(both).empty())
            between.push_back({i, scene.clipped(whole, front), aboveSource, both});
    }
    if (scene.figure(seenSource).empty() || scene.figure(seenObject).empty() || between.empty())
        return flux;
    // Through a blocker's outline, rays may pass from either side.
    struct Half {
        std::size_t object;
        double side;
    };
    std::vector<std::vector<Half>> halves(between.size());
    for (std::size_t i = 0; i < between.size(); ++i)
        for (const double side : {1.0, -1.0}) {
            const SightFigure& blocker = scene.figure(between[i].fromBlocker);
            const Vector3d normal = side * blocker.n;
            const std::size_t half = scene.clipped(seenObject, {normal, -normal.dot(blocker.origin)});
            if (!scene.figure(half).empty())
                halves[i].push_back({half, side});
        }
    // No figure is added from here on.
    const auto members = [&between](std::size_t Between::*figure, int side, const Between* but = nullptr) {
        std::vector<SightMember> all;
        for (const Between& blocker : between)
            if (&blocker != but)
                all.push_back({blocker.*figure, side});
        return all;
    };
    const SightMember upToObject{seenObject, -1}, downToSource{seenSource, 1};
    std::vector<Outline> outlines(2);
    outlines[0].curves = curvesOf(source);
    outlines[0].above = false;
    outlines[0].parts.push_back(
        {ShadowField(scene, std::span(&upToObject, 1), members(&Between::fromSource, -1), true), -1.0});
    outlines[1].curves = curvesOf(object);
    outlines[1].inFront = false;
    outlines[1].parts.push_back(
        {ShadowField(scene, std::span(&downToSource, 1), members(&Between::fromObject, 1), true), -1.0});
    for (std::size_t i = 0; i < between.size(); ++i) {
        Outline& outline = outlines.emplace_back();
        outline.curves = curvesOf(blockers[between[i].number]);
        for (const Half& half : halves[i]) {
            const std::array<SightMember, 2> targets{SightMember{half.object, -1}, downToSource};
            outline.parts.push_back(
                {ShadowField(scene, targets, members(&Between::fromBlocker, 0, &between[i]), false),
                 -half.side});
        }
    }
    double narrowest = std::min(scene.figure(seenSource).reach(), scene.figure(seenObject).reach());
    for (const Between& blocker : between)
        narrowest = std::min(narrowest, scene.figure(blocker.fromBlocker).reach());
    const double area = object.contour.area_m2();
    LineIntegrals integrals(outlines, front, p_SO);
    integrals.integrate(goal.tolerance, 2.0 * goal.tolerance * area, kStep * narrowest, goal.maxPoints);
    for (const Panel& panel : integrals.panels()) {
        flux.value_m2 += 0.5 * panel.sum.stretch;
        (panel.outline == 0   ? flux.bySource
         : panel.outline == 1 ? flux.byObject
                              : flux.byBlocker[between[panel.outline - 2].number]) += panel.sum.moments;
    }
    double polygons = 0.0;
    const auto addError = [&](const PlacedShape& placed) {
        polygons += placed.contour.impl().plate().outline(goal.tolerance).error;
    };
    addError(source);
    addError(object);
    std::ranges::for_each(blockers, addError);
    flux.error_m2 = 0.5 * integrals.error_m2() + polygons * std::abs(flux.value_m2);
    return flux;
}

namespace {

/// Adds the integrals of a field along an outline, by the middles of even steps: round a closed curve, as
/// good as Gauss' rule. `fieldAt(p, eye)` is zero where nothing is seen.
template <class FieldAt>
void addAround(const PlacedShape& placed, const Vector3d& p_SO, const FieldAt& fieldAt, Vector6d& moments) {
    constexpr double kAround = 48.0;
    const std::vector<Curve> curves = curvesOf(placed);
    double length_m = 0.0;
    for (const Curve& curve : curves)
        length_m += curve.speed_m;
    Sum sum;
    for (const Curve& curve : curves) {
        const int steps = std::max(2, static_cast<int>(std::lround(kAround * curve.speed_m / length_m)));
        for (int k = 0; k < steps; ++k) {
            const auto [p, step] = curve.at((k + 0.5) / steps);
            const Vector3d field = fieldAt(p, curve.lookout(p, step));
            if (!field.isZero(0.0))
                sum.add(1.0 / (std::numbers::pi * steps), p - p_SO, step.cross(field));
        }
    }
    moments += sum.moments;
}

} // namespace

RoughShadowFlux roughShadowFlux(const PlacedShape& source, const PlacedShape& object,
                                std::span<const PlacedShape> blockers, bool withGradient) {
    RoughShadowFlux flux;
    SightScene scene;
    const auto add = [&](const PlacedShape& placed) {
        return scene.add(SightFigure(placed.contour.impl().plate().roughOutline(), placed.X_S));
    };
    const Vector3d face = -object.X_S.linear().col(2), p_SO = object.X_S.translation();
    const HalfSpace above, front{face, -face.dot(p_SO)};
    const SightMember downToSource{scene.clipped(add(source), front), 1};
    struct Between {
        const PlacedShape* placed;
        std::size_t whole, fromObject;
    };
    std::vector<Between> between;
    std::vector<SightMember> downToBlockers;
    for (const PlacedShape& blocker : blockers) {
        const std::size_t whole = add(blocker);
        if (const std::size_t part = scene.clipped(whole, above); !scene.figure(part).empty()) {
            between.push_back({&blocker, whole, part});
            downToBlockers.push_back({part, 1});
        }
    }
    if (scene.figure(downToSource.figure).empty() || downToBlockers.empty())
        return flux;
    ShadowField down(scene, std::span(&downToSource, 1), downToBlockers, true);
    for (const FaceNode& node : object.contour.impl().plate().faceNodes())
        if (const Vector3d p = object.X_S * Vector3d(node.at.x(), node.at.y(), 0.0); p.z() > 0.0)
            flux.value_m2 += node.area_m2 * face.dot(down.at(p, true).field) / std::numbers::pi;
    if (!withGradient || flux.value_m2 == 0.0)
        return flux;
    const SightMember upToObject{scene.clipped(add(object), above), -1};
    std::vector<SightMember> upToBlockers;
    for (const Between& blocker : between)
        if (const std::size_t part = scene.clipped(blocker.whole, front); !scene.figure(part).empty())
            upToBlockers.push_back({part, -1});
    if (scene.figure(upToObject.figure).empty() || upToBlockers.empty())
        return flux;
    {
        ShadowField up(scene, std::span(&upToObject, 1), upToBlockers, true);
        addAround(
            source, p_SO,
            [&](const Vector3d& p, const Vector3d& eye) -> Vector3d {
                if (!(front.height(p) > 0.0) || !up.mayBeSeen(p, 0.0))
                    return Vector3d::Zero();
                return -up.at(eye, true).field;
            },
            flux.byStanding);
    }
    std::vector<std::size_t> parts; // of the blockers, between the two faces
    for (const Between& blocker : between)
        parts.push_back(scene.clipped(blocker.fromObject, front));
    for (std::size_t i = 0; i < between.size(); ++i) {
        const SightFigure& plate = scene.figure(parts[i]);
        if (between[i].placed->isHeld || plate.empty())
            continue;
        const Vector3d normal = plate.n, origin = plate.origin;
        std::vector<SightMember> others;
        for (std::size_t k = 0; k < parts.size(); ++k)
            if (k != i && !scene.figure(parts[k]).empty())
                others.push_back({parts[k], 0});
        for (const double side : {1.0, -1.0}) { // rays pass through the outline from either side
            const std::size_t half =
                scene.clipped(upToObject.figure, {side * normal, -side * normal.dot(origin)});
            if (scene.figure(half).empty())
                continue;
            const std::array<SightMember, 2> targets{SightMember{half, -1}, downToSource};
            ShadowField through(scene, targets, others, false);
            addAround(
                *between[i].placed, p_SO,
                [&](const Vector3d& p, const Vector3d& eye) -> Vector3d {
                    if (!(front.height(p) > 0.0) || !(p.z() > 0.0) || !through.mayBeSeen(p, 0.0))
                        return Vector3d::Zero();
                    return -side * through.at(eye, true).field;
                },
                flux.byStanding);
        }
    }
    return flux;
}

} // namespace bask
