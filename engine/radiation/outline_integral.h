#pragma once
// Integrates the source's potential along the visible part of the object's outline (the circulation) to a
// given error.
//
// Where the whole outline is visible and far enough from the source's outline, one tabulated rule is enough:
// the trapezoidal rule on a smooth outline converges like exp(-n b), where b is the half width of the strip
// of complex parameters in which the integrand is regular (L. N. Trefethen, J. A. C. Weideman, The
// exponentially convergent trapezoidal rule, SIAM Review 56, 2014); Gauss rules on the edges of a polygon
// converge in the same way. Elsewhere the outline is halved into panels until each is short compared with its
// distance from the source's outline. Therefore the number of points follows from the distance, and the error
// is known in advance.

#include "engine/radiation/gauss_rule.h"
#include "engine/radiation/visible_source.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace bask {

constexpr double kHalfError = 0.7; ///< log 2: object and source share the error

/// Returns an upper bound of the logarithm, at most log 2 too large; faster than std::log.
inline double logAbove(double x) {
    const int power = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1022;
    return power * std::numbers::ln2;
}

/// The required accuracy of an integral, and its limit.
struct IntegralGoal {
    double allowed_m2 = 0.0; ///< error of the circulation
    double sourcePerimeter_m = 0.0;
    int maxPoints = 0;
};

struct OutlineIntegral {
    double circulation_m2 = 0.0;
    Vector6d moments = Vector6d::Zero(); ///< force (m) and torque about O's origin (m2), S axes
    double error_m2 = 0.0;               ///< estimated error of the circulation
};

template <bool kMoments, class Source> class OutlineIntegrator {
public:
    OutlineIntegrator(Source& source, const RadiatingContour::Impl& object, const Sight& sight,
                      const IntegralGoal& goal)
        : m_source(source), m_object(object), m_sight(sight), m_goal(goal),
          m_exponent(logAbove(kRuleSafety * goal.sourcePerimeter_m * object.perimeter / goal.allowed_m2)) {}

    /// Integrates over the whole outline, which must lie in front of the source plane.
    OutlineIntegral whole() {
        const Eigen::Vector3d o = m_sight.X_SO.translation();
        const HeightPlane& height = m_sight.overSource;
        const double fromCentre = m_source.distance_m(o);
        const double nearest =
            std::max(fromCentre - m_object.reach, height.z0 - m_object.reach * height.slope);
        if (const auto [table, exponent] = tabulated(fromCentre, nearest); table) {
            const double reached = m_source.prepare(o, m_object.reach, nearest, m_exponent + kHalfError);
            if (reached > m_exponent) {
                addSums(sumsOver(table->view()));
                m_error = 2.0 * errorAt(std::min(exponent, reached));
                return total();
            }
        }
        if (!m_object.isPolygon && !m_object.disk && doubled(fromCentre, nearest))
            return total();
        return over(m_object.allPieces());
    }

    /// Integrates over pieces that together are a closed loop in front of the source plane.
    OutlineIntegral over(const std::vector<OutlinePiece>& pieces) {
        int left = static_cast<int>(pieces.size());
        for (const OutlinePiece& piece : pieces) {
            panels(piece, m_laid + (m_goal.maxPoints - m_laid) / left--);
            if (kMoments && piece.onCut)
                m_moments += m_source.alongCut(inS(piece.a), inS(piece.b));
        }
        return total();
    }

private:
    static constexpr int kMaxDoubled = 512;
    static constexpr double kDense = 3.0; // spacings to the source's outline

    /// Interval of a piece's parameter.
    struct Panel {
        double from, to;
        double middle() const { return 0.5 * (from + to); }
        double width() const { return to - from; }
    };

    struct Buffer {
        static constexpr int kSize = 128;
        int count = 0;
        double x[kSize], y[kSize], dx[kSize], dy[kSize];

        void add(double px, double py, double step1, double step2) {
            x[count] = px;
            y[count] = py;
            dx[count] = step1;
            dy[count++] = step2;
        }
    };

    struct Choice {
        const OutlineTable* table;
        double exponent;
    };
    Choice tabulated(double fromCentre, double nearest) const {
        if (m_object.isPolygon) {
            const GaussTable* rule = m_exponent < kTableExponent ? m_object.gauss(nearest) : nullptr;
            return {rule ? &rule->table : nullptr, kTableExponent};
        }
        const auto [rule, exponent] = m_object.foreseen(fromCentre, nearest, m_exponent + kHalfError);
        return {rule ? &rule->table : nullptr, exponent};
    }

    // The bound of an outline of many harmonics is far too pessimistic: there the points are doubled until
    // the sums agree, provided that they are so dense that no peak of the field can hide between them.
    bool doubled(double fromCentre, double nearest) {
        const Eigen::Vector3d o = m_sight.X_SO.translation();
        int n = std::max(32, static_cast<int>(std::bit_ceil(static_cast<unsigned>(4 * m_object.harmonics))));
        const auto dense = [&](int points) { return nearest * points >= kDense * m_object.maxSpeed_m; };
        if (!dense(2 * n))
            nearest = std::max(nearest, sampledNearest());
        while (!dense(2 * n) && 2 * n < kMaxDoubled)
            n *= 2;
        if (!dense(2 * n) || fromCentre <= 0.0)
            return false;
        const double reached = m_source.prepare(o, m_object.reach, nearest, m_exponent + kHalfError);
        if (reached <= m_exponent)
            return false;
        kernels::Sums coarse = sumsOver(m_object.trapezoid(n)->table.view());
        for (; 2 * n <= kMaxDoubled; n *= 2) {
            const kernels::Sums between = sumsOver(m_object.trapezoid(n)->shifted.view());
            kernels::Sums fine;
            fine.value = 0.5 * (coarse.value + between.value);
            for (int i = 0; i < 6; ++i)
                fine.moments[i] = 0.5 * (coarse.moments[i] + between.moments[i]);
            if (const double change = agreement(coarse, fine, m_goal.allowed_m2); change >= 0.0) {
                m_sums = fine;
                m_error = change + errorAt(reached);
                return true;
            }
            coarse = fine;
        }
        return false;
    }

    // Smallest distance of the outline from the source's, from points of it.
    double sampledNearest() const {
        const TrapezoidTable& rule = *m_object.trapezoid(64);
        const kernels::Outline points = rule.table.view();
        double min = 1e300;
        for (int i = 0; i < rule.points; ++i)
            min = std::min(min, m_source.distance_m(inS({points.x[i], points.y[i]})));
        return min - 0.5 * m_object.maxSpeed_m / rule.points;
    }

    // Change of the circulation (m2) between two sums; -1 if it or the change of the moments is more than
    // allowed. Moments are derivatives: they may be a hundred times less accurate.
    double agreement(const kernels::Sums& a, const kernels::Sums& b, double allowed) const {
        const double change = std::abs(m_source.circulation(b.value - a.value));
        if (change > allowed)
            return -1.0;
        if constexpr (kMoments) {
            double raw[6];
            for (int i = 0; i < 6; ++i)
                raw[i] = b.moments[i] - a.moments[i];
            const Vector6d moments = m_source.moments(raw);
            if (std::max(m_object.reach * moments.head<3>().norm(), moments.tail<3>().norm()) > 1e2 * allowed)
                return -1.0;
        }
        return change;
    }

    kernels::Sums sumsOver(const kernels::Outline& points, bool onCut = false) const {
        if constexpr (kMoments)
            return m_source.sums(points, onCut);
        kernels::Sums sums;
        sums.value = m_source.value(points);
        return sums;
    }

    double errorAt(double exponent) const {
        return kRuleSafety * m_goal.sourcePerimeter_m * m_object.perimeter * std::exp(-exponent);
    }

    Eigen::Vector3d inS(const Eigen::Vector2d& p) const {
        return m_sight.X_SO * Eigen::Vector3d(p.x(), p.y(), 0.0);
    }

    // Distance of a panel from the source's outline, in half lengths of the panel.
    double roomOf(const OutlinePiece& piece, double half, double away) const {
        if (piece.straight)
            return away / (half * (piece.b - piece.a).norm());
        return m_object.strip.radius(away) / half;
    }

    // Halves the piece until each panel is short compared with its distance from the source's outline, or
    // agrees with its halves.
    void panels(const OutlinePiece& piece, int maxLaid) {
        if (piece.straight && piece.a == piece.b)
            return;
        m_source.follow(inS(piece.a), inS(piece.b), piece.onCut); // of a smooth piece a and b are equal
        const double exponent = m_exponent + kHalfError;
        // The error of a panel this short is below its share, whatever the field is.
        const double min_m = 0.3 * m_goal.allowed_m2 / m_object.perimeter;
        std::vector<Panel> open{piece.straight ? Panel{0.0, 1.0} : Panel{piece.from, piece.to}};
        // Wide panels come first: when no points are left, all remaining panels are short.
        for (std::size_t next = 0; next < open.size(); ++next) {
            const Panel panel = open[next];
            const OutlinePoint p = m_object.at(piece, panel.middle());
            const double length = panel.width() * std::sqrt(p.dx * p.dx + p.dy * p.dy);
            const Eigen::Vector3d middle_S = inS({p.x, p.y});
            const double away = m_source.distance_m(middle_S);
            const double room = roomOf(piece, 0.5 * panel.width(), away);
            const double max = 2.0 * kMaxGaussPoints * ellipseExponent(room);
            if (max < exponent && length > min_m &&
                m_laid + 16 * static_cast<int>(open.size() - next) < maxLaid) {
                if (mayTry(piece, panel, length, away) && tried(piece, panel, length, middle_S, away))
                    continue;
                open.push_back({panel.from, panel.middle()});
                open.push_back({panel.middle(), panel.to});
                continue;
            }
            lay(piece, panel, gaussOrder(room, exponent));
            if (max < exponent) { // too short to matter, or points have run out
                m_error += length * std::min(length, kRuleSafety * m_goal.sourcePerimeter_m * std::exp(-max));
                m_source.prepare(middle_S, 0.0, std::max(away, length), exponent);
            } else {
                m_reached = std::min(m_reached, prepareForLaid(middle_S, away));
            }
            if (!m_source.closedForm())
                flush(piece.onCut);
        }
        flush(piece.onCut);
    }

    // The bound of a curved panel is too pessimistic as well: a panel is tried directly if its points resolve
    // all its waves and no point between them can be much nearer to the source's outline than they are.
    bool mayTry(const OutlinePiece& piece, const Panel& panel, double length, double away) const {
        const double waves = piece.straight ? 0.0 : panel.width() * m_object.harmonics;
        if (waves > 1.0)
            return false;
        const double speed_m = piece.straight  ? (piece.b - piece.a).norm()
                               : m_object.disk ? m_object.maxSpeed_m
                                               : m_object.speedBetween_m(panel.from, panel.to);
        return 0.6 * panel.width() * speed_m <= away || runsAlong(piece, panel, length, away);
    }

    // Along an outline that it follows, a panel may be long compared with its distance.
    bool runsAlong(const OutlinePiece& piece, const Panel& panel, double length, double away) const {
        constexpr int kMaxSamples = 64;
        const int samples = static_cast<int>(std::min(std::ceil(length / away), 1e3));
        if (!m_source.closedForm() || samples > kMaxSamples)
            return false;
        OutlinePoint last = m_object.at(piece, panel.from);
        double there = m_source.distance_m(inS({last.x, last.y}));
        for (int i = 1; i <= samples; ++i) {
            const OutlinePoint p = m_object.at(piece, panel.from + panel.width() * i / samples);
            const double here = m_source.distance_m(inS({p.x, p.y}));
            const double between = 1.1 * std::hypot(p.x - last.x, p.y - last.y);
            if (here + there - between < 0.5 * std::max(here, there))
                return false;
            last = p;
            there = here;
        }
        return true;
    }

    // Compares sixteen points with two times sixteen, which are far more accurate; the result is used if they
    // agree to the panel's share of the error.
    bool tried(const OutlinePiece& piece, const Panel& panel, double length, const Eigen::Vector3d& middle_S,
               double away) {
        flush(piece.onCut);
        const kernels::Sums before = std::exchange(m_sums, {});
        lay(piece, panel, 16);
        const double reached = prepareForLaid(middle_S, away);
        flush(piece.onCut);
        const kernels::Sums once = std::exchange(m_sums, {});
        lay(piece, {panel.from, panel.middle()}, 16);
        lay(piece, {panel.middle(), panel.to}, 16);
        flush(piece.onCut);
        const kernels::Sums twice = std::exchange(m_sums, before);
        const double change = agreement(once, twice, 0.5 * m_goal.allowed_m2 * length / m_object.perimeter);
        if (change < 0.0 || reached < m_exponent)
            return false;
        m_error += change;
        m_reached = std::min(m_reached, reached);
        addSums(twice);
        return true;
    }

    // Points are collected, because the kernels are fast on long rows, and summed when the buffer is full.
    void lay(const OutlinePiece& piece, const Panel& panel, int order) {
        if (m_buffer.count + kMaxGaussPoints > Buffer::kSize)
            flush(piece.onCut);
        const GaussRule rule = gaussRule(order);
        m_object.atNodes(piece, panel.from, panel.width(), rule.nodes,
                         [&](std::size_t i, const OutlinePoint& p) {
                             const double weight = panel.width() * rule.weights[i];
                             m_buffer.add(p.x, p.y, weight * p.dx, weight * p.dy);
                         });
        m_laid += order;
    }

    // Prepares the source for the waiting points, all near the middle of one panel. Returns the exponent
    // reached.
    double prepareForLaid(const Eigen::Vector3d& middle_S, double away) {
        double radius = 0.0;
        for (int i = 0; i < m_buffer.count && !m_source.closedForm(); ++i)
            radius = std::max(radius, (inS({m_buffer.x[i], m_buffer.y[i]}) - middle_S).norm());
        return m_source.prepare(middle_S, radius, std::max(away - radius, 0.0), m_exponent + kHalfError);
    }

    void flush(bool onCut) {
        if (m_buffer.count == 0)
            return;
        while (m_buffer.count % kernels::kPadding != 0)
            m_buffer.add(m_buffer.x[0], m_buffer.y[0], 0.0, 0.0);
        addSums(sumsOver({m_buffer.x, m_buffer.y, m_buffer.dx, m_buffer.dy, m_buffer.count}, onCut));
        m_buffer.count = 0;
    }

    void addSums(const kernels::Sums& sums) {
        m_sums.value += sums.value;
        for (int i = 0; i < 6; ++i)
            m_sums.moments[i] += sums.moments[i];
    }

    OutlineIntegral total() const {
        OutlineIntegral result;
        result.circulation_m2 = m_source.circulation(m_sums.value);
        if (kMoments)
            result.moments = m_moments + m_source.moments(m_sums.moments);
        result.error_m2 = m_error + (m_laid > 0 ? 2.0 * errorAt(m_reached) : 0.0);
        return result;
    }

    Source& m_source;
    const RadiatingContour::Impl& m_object;
    const Sight& m_sight;
    const IntegralGoal& m_goal;
    double m_exponent;

    kernels::Sums m_sums;
    Vector6d m_moments = Vector6d::Zero();
    double m_error = 0.0;
    double m_reached = 1e3;
    int m_laid = 0; // points of panels so far
    Buffer m_buffer;
};

} // namespace bask
