#include "engine/radiation/view_factor.h"

#include "engine/radiation/disk_field.h"
#include "engine/radiation/outline_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace bask {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// What the two half-space cuts leave of the two faces.
enum class SourceSide { Whole, Segment, None };

/// The field of the visible part of the source, whole disk or segment; moments in the axes that it names.
class VisibleSource {
public:
    VisibleSource(double radius_m, const Pose& X_SO, SourceSide side) : m_whole(radius_m, X_SO) {
        if (side == SourceSide::Segment)
            m_segment.emplace(radius_m, X_SO);
    }

    bool isCut() const { return m_segment.has_value(); }
    const DiskSegment& segment() const { return *m_segment; }

    LoopSums at(const OutlinePoint& point, bool arcOnly = false) const {
        return m_segment ? m_segment->at(point, arcOnly) : m_whole.at(point);
    }
    LoopSums sums(const OutlinePoints& points) const {
        return m_segment ? m_segment->sums(points) : wholeDiskSums(m_whole, points);
    }
    double circulation(const OutlinePoints& points) const {
        return m_segment ? m_segment->sums(points).circulation : wholeDiskValue(m_whole, points).circulation;
    }

    /// Moments as force and torque in S axes.
    Vector6d moments(const LoopSums& sums, const Pose& X_SO) const {
        const Eigen::Matrix3d toS = m_segment ? m_segment->axes() : Eigen::Matrix3d(X_SO.linear());
        Vector6d result;
        result << toS * Eigen::Vector3d(sums.moments[0], sums.moments[1], sums.moments[2]),
            toS * Eigen::Vector3d(sums.moments[3], sums.moments[4], sums.moments[5]);
        return result;
    }

private:
    WholeDisk m_whole;
    std::optional<DiskSegment> m_segment;
};

struct Scene {
    SourceSide source = SourceSide::None;
    PlaneSide object = PlaneSide::Behind;
    HeightPlane height;

    bool hidden() const { return source == SourceSide::None || object == PlaneSide::Behind; }
};

// The source's points have clearance -n.(p_O - s) over the object's plane, between c - r sin(tilt) and c + r
// sin(tilt).
Scene lookAt(const Disk& source, const RadiatingContour::Impl& object, const Pose& X_SO) {
    const Eigen::Vector3d p = X_SO.translation();
    const Eigen::Vector3d axis = X_SO.linear().col(2);
    if (!(source.radius_m > 0.0) || !std::isfinite(source.radius_m) || !p.allFinite() ||
        !X_SO.linear().allFinite())
        throw std::invalid_argument("viewFactor: radius and pose must be finite, the radius positive");
    Scene scene;
    const double clearance = axis.dot(p);
    const double swing = source.radius_m * std::hypot(axis.x(), axis.y());
    if (clearance + swing <= 0.0)
        return scene;
    scene.source = clearance - swing >= 0.0 ? SourceSide::Whole : SourceSide::Segment;
    scene.height = {p.z(), X_SO.linear()(2, 0), X_SO.linear()(2, 1)};
    scene.object = object.side(scene.height);
    return scene;
}

AdaptiveResult sumOf(const AdaptiveResult& a, const AdaptiveResult& b) {
    AdaptiveResult result = a;
    result.sums.add(b.sums);
    result.error += b.error;
    return result;
}

/// Integrates over pieces of the outline, each with its share of the allowed error.
class PieceIntegrator {
public:
    PieceIntegrator(const VisibleSource& source, const RadiatingContour::Impl& object,
                    const AdaptiveGoal& goal)
        : m_source(source), m_object(object), m_goal(goal) {}

    AdaptiveResult over(const std::vector<OutlinePiece>& pieces) {
        m_goal.circulation /= static_cast<double>(pieces.size());
        m_goal.moments /= static_cast<double>(pieces.size());
        AdaptiveResult total;
        for (const OutlinePiece& piece : pieces)
            total = sumOf(total, !piece.straight ? smooth(piece)
                                 : piece.onCut   ? alongCut(piece)
                                                 : straight(piece.a, piece.b, false));
        return total;
    }

private:
    AdaptiveResult smooth(const OutlinePiece& piece) const {
        const double width = piece.to - piece.from;
        const int start =
            std::max(1, static_cast<int>(std::ceil(std::max(4.0, 0.5 * m_object.harmonics) * width)));
        const auto sample = [&](double phi) { return m_source.at(m_object.at(phi)); };
        return integrateAdaptively(sample, piece.from, piece.to, start, m_object.maxSpeed, m_goal);
    }

    AdaptiveResult straight(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool arcOnly) const {
        const Eigen::Vector2d step = b - a;
        if (step.squaredNorm() == 0.0)
            return {};
        const auto sample = [&](double t) {
            return m_source.at({a.x() + t * step.x(), a.y() + t * step.y(), step.x(), step.y()}, arcOnly);
        };
        return integrateAdaptively(sample, 0.0, 1.0, 1, step.norm(), m_goal);
    }

    // On the line of the chord: the chord in closed form, the arc in stretches that end where the chord does.
    AdaptiveResult alongCut(const OutlinePiece& piece) const {
        if (!m_source.isCut())
            return straight(piece.a, piece.b, false);
        const DiskSegment& segment = m_source.segment();
        AdaptiveResult total{segment.chordAlongItself(piece.a, piece.b), 0.0};
        const double from = segment.along_m(piece.a);
        const double to = segment.along_m(piece.b);
        std::vector<double> ends{0.0, 1.0};
        for (double end : {-segment.halfChord_m(), segment.halfChord_m()})
            if ((from < end && end < to) || (to < end && end < from))
                ends.push_back((end - from) / (to - from));
        std::sort(ends.begin(), ends.end());
        for (std::size_t i = 0; i + 1 < ends.size(); ++i)
            total = sumOf(total, straight(piece.a + ends[i] * (piece.b - piece.a),
                                          piece.a + ends[i + 1] * (piece.b - piece.a), true));
        return total;
    }

    const VisibleSource& m_source;
    const RadiatingContour::Impl& m_object;
    AdaptiveGoal m_goal;
};

/// Doubling over the tabulated levels of an uncut outline; nothing when the finest does not meet the goal.
std::optional<AdaptiveResult> overLevels(const VisibleSource& source, const RadiatingContour::Impl& object,
                                         const AdaptiveGoal& goal) {
    LoopSums sum;
    LoopSums previous;
    int points = 0;
    for (int l = 0; l < object.levels(); ++l) {
        const OutlinePoints table = object.level(l);
        const LoopSums added = source.sums(table);
        LoopSums current;
        if (object.isPolygon) {
            current = added;
        } else {
            points += table.count;
            sum.add(added);
            current.add(sum, 1.0 / points);
            if (l < object.firstLevel())
                continue;
        }
        // The rule sees singularities no farther off than this as smooth; nearer ones it could miss
        // altogether.
        const double spacing_m = object.isPolygon ? 0.4 * object.maxSpeed : 3.0 * object.maxSpeed / points;
        if (l > object.firstLevel() && current.distance_m >= spacing_m) {
            const LoopDifference change = difference(current, previous, goal.length_m);
            if (change.circulation <= goal.circulation && change.moments <= goal.moments)
                return AdaptiveResult{current, change.circulation};
        }
        if ((object.isPolygon ? table.count : points) >= goal.maxPoints)
            break;
        previous = current;
    }
    return std::nullopt;
}

// What rounding alone leaves, m2: a few relative epsilons of the size of W times the length of the way, and
// more than was ever seen.
double roundingFloor(const Disk& source, const RadiatingContour::Impl& object, const Pose& X_SO) {
    const double rho = X_SO.translation().head<2>().norm() + object.reach;
    const double square = X_SO.translation().squaredNorm() + source.radius_m * source.radius_m;
    const double potential =
        std::min(std::numbers::pi * source.radius_m,
                 2.0 * std::numbers::pi * source.radius_m * source.radius_m * rho / square);
    return 16.0 * kEpsilon * object.perimeter * potential;
}

double asFraction(double circulation, double area) {
    return std::clamp(-circulation / (2.0 * std::numbers::pi * area), 0.0, 1.0);
}

/// Fixed rule over one piece: panels of at most 16 Gauss points, `points` to the whole outline's length or
/// so.
double circulationOver(const OutlinePiece& piece, const VisibleSource& source,
                       const RadiatingContour::Impl& object, int points) {
    const double share = piece.straight ? (piece.b - piece.a).norm() / object.perimeter : 1.0;
    const int wanted = std::clamp(static_cast<int>(std::ceil(2.0 * share * points)), 4, std::max(points, 4));
    const int panels = (wanted + 15) / 16;
    const GaussRule rule = gaussRule((wanted + panels - 1) / panels);
    const bool arcOnly = piece.onCut && source.isCut();
    double sum = arcOnly ? source.segment().chordAlongItself(piece.a, piece.b).circulation : 0.0;
    const Eigen::Vector2d step = piece.b - piece.a;
    const double from = piece.straight ? 0.0 : piece.from;
    const double width = (piece.straight ? 1.0 : piece.to - piece.from) / panels;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = from + width * (panel + rule.nodes[i]);
            const OutlinePoint point =
                piece.straight
                    ? OutlinePoint{piece.a.x() + t * step.x(), piece.a.y() + t * step.y(), step.x(), step.y()}
                    : object.at(t);
            sum += width * rule.weights[i] * source.at(point, arcOnly).circulation;
        }
    return sum;
}

} // namespace

const char* visibilityName(Visibility visibility) {
    switch (visibility) {
    case Visibility::Full:
        return "full";
    case Visibility::Partial:
        return "partial";
    case Visibility::Hidden:
        break;
    }
    return "hidden";
}

RadiatingContour::RadiatingContour(const Shape& shape) : m_impl(std::make_shared<const Impl>(shape)) {}
RadiatingContour::~RadiatingContour() = default;
RadiatingContour::RadiatingContour(const RadiatingContour&) = default;
RadiatingContour& RadiatingContour::operator=(const RadiatingContour&) = default;

double RadiatingContour::area_m2() const {
    return m_impl->area;
}

const Shape& RadiatingContour::shape() const {
    return m_impl->shape;
}

ViewFactor viewFactor(const Disk& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options) {
    const RadiatingContour::Impl& outline = object.impl();
    const Scene scene = lookAt(source, outline, X_SO);
    if (scene.hidden())
        return {};
    const VisibleSource visible(source.radius_m, X_SO, scene.source);
    const double perCirculation = 1.0 / (2.0 * std::numbers::pi * outline.area);
    const double floor = roundingFloor(source, outline, X_SO);
    // Moments are derivatives: they may be a hundred times less sharp.
    const double allowed = std::max(options.tolerance / perCirculation, floor);
    const AdaptiveGoal goal{allowed, 1e2 * allowed, outline.size, options.maxPoints, 1e-6};

    std::optional<AdaptiveResult> result;
    if (scene.object == PlaneSide::Front)
        result = overLevels(visible, outline, goal);
    if (!result) {
        const auto pieces =
            scene.object == PlaneSide::Front ? outline.allPieces() : outline.piecesInFront(scene.height);
        if (pieces.empty())
            return {};
        result = PieceIntegrator(visible, outline, goal).over(pieces);
    }
    ViewFactor factor;
    factor.value = asFraction(result->sums.circulation, outline.area);
    factor.gradient = -perCirculation * visible.moments(result->sums, X_SO);
    factor.visibility = scene.source == SourceSide::Whole && scene.object == PlaneSide::Front
                            ? Visibility::Full
                            : Visibility::Partial;
    factor.errorEstimate = perCirculation * (result->error + floor);
    return factor;
}

double viewFactorFast(const Disk& source, const RadiatingContour& object, const Pose& X_SO, int points) {
    const RadiatingContour::Impl& outline = object.impl();
    const Scene scene = lookAt(source, outline, X_SO);
    if (scene.hidden())
        return 0.0;
    const VisibleSource visible(source.radius_m, X_SO, scene.source);
    double circulation = 0.0;
    if (scene.object != PlaneSide::Front) {
        for (const OutlinePiece& piece : outline.piecesInFront(scene.height))
            circulation += circulationOver(piece, visible, outline, points);
    } else if (outline.isPolygon) {
        circulation = visible.circulation(outline.level(points <= 16 ? 0 : points <= 64 ? 1 : 2));
    } else {
        int used = 0;
        for (int l = 0; l < outline.levels() && used < points; ++l) {
            circulation += visible.circulation(outline.level(l));
            used += outline.level(l).count;
        }
        circulation /= used;
    }
    return asFraction(circulation, outline.area);
}

Vector6d gradientAbout(const Vector6d& gradient, const Eigen::Vector3d& p_SO, const Eigen::Vector3d& p_SE) {
    Vector6d result = gradient;
    result.tail<3>() += (p_SO - p_SE).cross(gradient.head<3>());
    return result;
}

} // namespace bask
