#pragma once
// The circulation of the source's potential along the visible part of the object's outline, to a wanted
// error.
//
// Where the whole outline is visible and the source's outline keeps its distance, one tabulated rule does it:
// the trapezoidal rule on a smooth outline converges like exp(-n b), where b is the half width of the strip
// of complex parameters in which the integrand is regular (L. N. Trefethen, J. A. C. Weideman, The
// exponentially convergent trapezoidal rule, SIAM Review 56, 2014); Gauss rules on the edges of a polygon in
// the same manner. Elsewhere the outline is halved into panels until each is short beside its distance from
// the source's outline. So the number of points follows from the distance, and the error is known beforehand.

#include "engine/radiation/gauss_rule.h"
#include "engine/radiation/visible_source.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

namespace bask {

/// What is wanted of an integral.
struct IntegralGoal {
    double allowed_m2 = 0.0; ///< error of the circulation
    double sourcePerimeter_m = 0.0;
    int mostPoints = 0;
};

struct OutlineIntegral {
    double circulation_m2 = 0.0;
    Vector6d moments = Vector6d::Zero(); ///< force (m) and torque about O's origin (m2), S axes
    double error_m2 = 0.0;               ///< of the circulation, as estimated
};

template <bool kMoments, class Source> class OutlineIntegrator {
public:
    OutlineIntegrator(Source& source, const RadiatingContour::Impl& object, const Sight& sight,
                      const IntegralGoal& goal)
        : m_source(source), m_object(object), m_sight(sight), m_goal(goal),
          m_exponent(std::log(kSafety * goal.sourcePerimeter_m * object.perimeter / goal.allowed_m2)) {}

    /// The whole outline, which lies in front of the source plane.
    OutlineIntegral whole() {
        const Eigen::Vector3d o = m_sight.X_SO.translation();
        const HeightPlane& height = m_sight.overSource;
        const double fromCentre = m_source.distance_m(o, false);
        const double nearest =
            std::max(fromCentre - m_object.reach, height.z0 - m_object.reach * height.slope);
        if (const auto [table, exponent] = tabulated(fromCentre, nearest); table) {
            const double reached = m_source.prepare(o, m_object.reach, nearest, m_exponent + kHalf);
            if (reached > m_exponent) {
                add(table->view(), false);
                m_error = 2.0 * errorAt(std::min(exponent, reached));
                return total();
            }
        }
        if (!m_object.isPolygon && !m_object.disk && doubled(fromCentre, nearest))
            return total();
        m_sums = {};
        return over(m_object.allPieces());
    }

    /// Pieces that together are a closed loop in front of the source plane.
    OutlineIntegral over(const std::vector<OutlinePiece>& pieces) {
        for (const OutlinePiece& piece : pieces) {
            panels(piece);
            flush(piece.onCut);
            if (kMoments && piece.onCut)
                m_moments += m_source.alongCut(inS(piece.a), inS(piece.b));
        }
        return total();
    }

private:
    // Before the exponential: twice from the rule, the rest for the potential's size in the complex.
    static constexpr double kSafety = 24.0;
    static constexpr double kHalf = 0.7; // log 2: object and source share the error
    static constexpr int kBuffer = 128;
    static constexpr int kMostForeseen = 64; // points of an outline of many harmonics, without trying
    static constexpr int kMostDoubled = 512;
    static constexpr double kDense = 3.0; // spacings to the source's outline

    struct Choice {
        const OutlineTable* table;
        double exponent;
    };
    Choice tabulated(double fromCentre, double nearest) const {
        if (m_object.isPolygon) {
            const GaussTable* rule = m_object.gauss(nearest);
            return {rule ? &rule->table : nullptr, kTableExponent};
        }
        const int step = std::max(m_object.strip.fromCentre(fromCentre), m_object.strip.fromOutline(nearest));
        if (step < 0)
            return {nullptr, 0.0};
        const double b = AnalyticStrip::width(step);
        const double growth = m_object.strip.growth(step);
        const TrapezoidTable* rule = m_object.trapezoid((m_exponent + kHalf + growth) / b);
        if (!m_object.disk && rule && rule->points > kMostForeseen)
            return {nullptr, 0.0};
        return rule ? Choice{&rule->table, rule->points * b - growth} : Choice{nullptr, 0.0};
    }

    // The bound of an outline of many harmonics is far too careful: there the points are doubled until the
    // sums agree, provided that they lie too dense for a peak of the field to hide between them.
    bool doubled(double fromCentre, double nearest) {
        const Eigen::Vector3d o = m_sight.X_SO.translation();
        int n = std::max(32, static_cast<int>(std::bit_ceil(static_cast<unsigned>(4 * m_object.harmonics))));
        const auto dense = [&](int points) { return nearest * points >= kDense * m_object.mostSpeed_m; };
        if (!dense(2 * n))
            nearest = std::max(nearest, sampledNearest());
        while (!dense(2 * n) && 2 * n < kMostDoubled)
            n *= 2;
        if (!dense(2 * n) || fromCentre <= 0.0)
            return false;
        const double reached = m_source.prepare(o, m_object.reach, nearest, m_exponent + kHalf);
        if (reached <= m_exponent)
            return false;
        kernels::Sums coarse = sumsOver(m_object.trapezoid(n)->table.view());
        for (; 2 * n <= kMostDoubled; n *= 2) {
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

    // Least distance of the outline to the source's, from points of it.
    double sampledNearest() const {
        const TrapezoidTable& rule = *m_object.trapezoid(64);
        const kernels::Outline points = rule.table.view();
        double least = 1e300;
        for (int i = 0; i < rule.points; ++i)
            least = std::min(least, m_source.distance_m(inS({points.x[i], points.y[i]}), false));
        return least - 0.5 * m_object.mostSpeed_m / rule.points;
    }

    // Change of the circulation (m2) between two sums, -1 if it or that of the moments is more than allowed.
    // Moments are derivatives: they may be a hundred times less sharp.
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

    kernels::Sums sumsOver(const kernels::Outline& points) const {
        if constexpr (kMoments)
            return m_source.sums(points, false);
        kernels::Sums sums;
        sums.value = m_source.value(points);
        return sums;
    }

    double errorAt(double exponent) const {
        return kSafety * m_goal.sourcePerimeter_m * m_object.perimeter * std::exp(-exponent);
    }

    Eigen::Vector3d inS(const Eigen::Vector2d& p) const {
        return m_sight.X_SO * Eigen::Vector3d(p.x(), p.y(), 0.0);
    }

    OutlinePoint pointAt(const OutlinePiece& piece, double t) const {
        if (!piece.straight)
            return m_object.at(t);
        const Eigen::Vector2d step = piece.b - piece.a;
        const Eigen::Vector2d p = piece.a + t * step;
        return {p.x(), p.y(), step.x(), step.y()};
    }

    // Half lengths of a panel that fit into its distance from the source's outline.
    double roomOf(const OutlinePiece& piece, double half, double away) const {
        if (piece.straight)
            return away / (half * (piece.b - piece.a).norm());
        return m_object.strip.radius(away) / half;
    }

    void panels(const OutlinePiece& piece) {
        if (piece.straight && piece.a == piece.b)
            return;
        const double exponent = m_exponent + kHalf;
        // A panel so short errs by less than its share, whatever the field does.
        const double least_m = 0.3 * m_goal.allowed_m2 / m_object.perimeter;
        std::vector<std::pair<double, double>> open{piece.straight ? std::pair(0.0, 1.0)
                                                                   : std::pair(piece.from, piece.to)};
        while (!open.empty()) {
            const auto [from, to] = open.back();
            open.pop_back();
            const double middle = 0.5 * (from + to);
            const double half = 0.5 * (to - from);
            const OutlinePoint p = pointAt(piece, middle);
            const double length = 2.0 * half * std::hypot(p.dx, p.dy);
            const Eigen::Vector3d p_S = inS({p.x, p.y});
            const double away = m_source.distance_m(p_S, piece.onCut);
            const double room = roomOf(piece, half, away);
            const double most = 2.0 * kMostGaussPoints * ellipseExponent(room);
            if (most < exponent && length > least_m && m_points < m_goal.mostPoints) {
                if (mayTry(piece, from, to, away) && tried(piece, from, 2.0 * half, length, p_S, away))
                    continue;
                open.emplace_back(from, middle);
                open.emplace_back(middle, to);
                continue;
            }
            if (most < exponent)
                m_error += length * std::min(length, kSafety * m_goal.sourcePerimeter_m * std::exp(-most));
            // Points of a panel are within half its length or so of its middle; the rest of the distance
            // is the source's.
            const double reached = prepare(p_S, 0.6 * length, away, exponent);
            lay(piece, from, 2.0 * half, gaussRule(gaussOrder(room, exponent)));
            m_reached = std::min(m_reached, reached);
        }
    }

    // The bound of a bent panel is too careful as well: a panel is tried out if it holds no more waves than
    // its points resolve and no point between them can be much nearer to the source's outline than they are.
    bool mayTry(const OutlinePiece& piece, double from, double to, double away) const {
        const double waves = piece.straight ? 0.0 : (to - from) * m_object.harmonics;
        const double length =
            piece.straight ? (to - from) * (piece.b - piece.a).norm() : (to - from) * m_object.mostSpeed_m;
        return waves <= 1.5 && (0.6 * length <= away || runsAlong(piece, from, to, away));
    }

    // Beside an outline that it follows, a panel may be long for its distance.
    bool runsAlong(const OutlinePiece& piece, double from, double to, double away) const {
        constexpr int kSamples = 16;
        if (!m_source.closedForm())
            return false;
        OutlinePoint last = pointAt(piece, from);
        double there = m_source.distance_m(inS({last.x, last.y}), piece.onCut);
        if (std::max(there, away) > 2.0 * kSamples * std::min(there, away))
            return false;
        for (int i = 1; i <= kSamples; ++i) {
            const OutlinePoint p = pointAt(piece, from + (to - from) * i / kSamples);
            const double here = m_source.distance_m(inS({p.x, p.y}), piece.onCut);
            const double between = 1.1 * std::hypot(p.x - last.x, p.y - last.y);
            if (here + there - between < 0.5 * std::max(here, there))
                return false;
            last = p;
            there = here;
        }
        return true;
    }

    // Sixteen points against two times eight; taken when they agree to the panel's share of the error.
    bool tried(const OutlinePiece& piece, double from, double width, double length,
               const Eigen::Vector3d& p_S, double away) {
        flush(m_bufferOnCut);
        const double reached = prepare(p_S, 0.6 * length, away, m_exponent + kHalf);
        if (reached < m_exponent)
            return false;
        const kernels::Sums before = std::exchange(m_sums, {});
        lay(piece, from, width, gaussRule(16));
        flush(piece.onCut);
        const kernels::Sums once = std::exchange(m_sums, {});
        lay(piece, from, 0.5 * width, gaussRule(8));
        lay(piece, from + 0.5 * width, 0.5 * width, gaussRule(8));
        flush(piece.onCut);
        const kernels::Sums twice = std::exchange(m_sums, before);
        const double allowed = 0.5 * m_goal.allowed_m2 * length / m_object.perimeter;
        const double change = agreement(once, twice, allowed);
        if (change < 0.0)
            return false;
        m_error += 2.0 * change;
        m_reached = std::min(m_reached, reached);
        addSums(twice);
        return true;
    }

    double prepare(const Eigen::Vector3d& centre_S, double radius, double away, double exponent) {
        if constexpr (std::is_same_v<Source, LoopSource>) {
            flush(m_bufferOnCut);
            return m_source.prepare(centre_S, radius, std::max(away - radius, 0.0), exponent);
        }
        return exponent;
    }

    void lay(const OutlinePiece& piece, double from, double width, const GaussRule& rule) {
        if (m_count + kMostGaussPoints > kBuffer)
            flush(piece.onCut);
        m_bufferOnCut = piece.onCut;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i, ++m_count) {
            const OutlinePoint p = pointAt(piece, from + width * rule.nodes[i]);
            m_x[m_count] = p.x;
            m_y[m_count] = p.y;
            m_dx[m_count] = width * rule.weights[i] * p.dx;
            m_dy[m_count] = width * rule.weights[i] * p.dy;
        }
        m_points += static_cast<int>(rule.nodes.size());
    }

    void flush(bool onCut) {
        if (m_count == 0)
            return;
        for (; m_count % kernels::kPadding != 0; ++m_count) {
            m_x[m_count] = m_x[m_count - 1];
            m_y[m_count] = m_y[m_count - 1];
            m_dx[m_count] = m_dy[m_count] = 0.0;
        }
        add({m_x, m_y, m_dx, m_dy, m_count}, onCut);
        m_count = 0;
    }

    void add(const kernels::Outline& points, bool onCut) {
        if constexpr (kMoments)
            addSums(m_source.sums(points, onCut));
        else
            m_sums.value += m_source.value(points);
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
        result.error_m2 = m_error + (m_points > 0 ? 2.0 * errorAt(m_reached) : 0.0);
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
    int m_points = 0;
    int m_count = 0;
    bool m_bufferOnCut = false;
    double m_x[kBuffer], m_y[kBuffer], m_dx[kBuffer], m_dy[kBuffer];
};

} // namespace bask
