#include "engine/shape/contour.h"

#include "engine/base/message_code.h"
#include "engine/shape/crossing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

constexpr std::size_t kMinVertices = 3;
constexpr double kLargest_m = 1e6; // beyond it squares and cubes lose their meaning
constexpr double kFlat = 1e-10;    // width over length under which an outline is a line
constexpr double kSame = 1e-13;    // neighbours nearer than this times the extent are one point

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double signedArea(const Points& points) {
    double twice = 0.0;
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
        twice += cross(points[k] - points[0], points[k + 1] - points[0]);
    return 0.5 * twice;
}

double extent(const Points& points) {
    Vector2d min = points.front(), max = points.front();
    for (const Vector2d& p : points) {
        min = min.cwiseMin(p);
        max = max.cwiseMax(p);
    }
    return (max - min).norm();
}

bool isLine(const Points& points) {
    const Vector2d& a = points.front();
    const auto far =
        std::ranges::max_element(points, {}, [&](const Vector2d& p) { return (p - a).squaredNorm(); });
    const Vector2d along = *far - a;
    return std::ranges::all_of(points, [&](const Vector2d& p) {
        return std::abs(cross(along, p - a)) <= kFlat * along.squaredNorm();
    });
}

Result<void> checkCoordinates(const Points& points, const std::string& where) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].allFinite())
            return Error{MessageCode::ContourNotFinite, where, {"point " + std::to_string(k + 1)}};
        if (const double max = points[k].cwiseAbs().maxCoeff(); max > kLargest_m)
            return Error{MessageCode::ValueOutOfRange,
                         where,
                         {formatNumber(max), formatNumber(-kLargest_m), formatNumber(kLargest_m), "m"}};
    }
    return {};
}

// Keeps the first of equal neighbours; `numbers` are the places of the kept points in the input.
std::pair<Points, std::vector<std::size_t>> withoutRepeats(const Points& points) {
    const double same = points.empty() ? 0.0 : kSame * extent(points);
    std::pair<Points, std::vector<std::size_t>> kept;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (kept.first.empty() || (points[k] - kept.first.back()).norm() > same) {
            kept.first.push_back(points[k]);
            kept.second.push_back(k);
        }
    while (kept.first.size() > 1 && (kept.first.front() - kept.first.back()).norm() <= same) {
        kept.first.pop_back();
        kept.second.pop_back();
    }
    return kept;
}

double distanceToSegment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
    const Vector2d along = b - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0.0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
    return (p - a - t * along).norm();
}

// Marks the points between `first` and `last` (which may wrap round once) that Douglas-Peucker keeps.
void keepBetween(const Points& points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& keep) {
    const std::size_t n = points.size();
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double max = tolerance;
        std::size_t worst = from;
        for (std::size_t k = from + 1; k < to; ++k)
            if (const double d = distanceToSegment(points[k % n], points[from % n], points[to % n]);
                d > max) {
                max = d;
                worst = k;
            }
        if (worst == from)
            continue;
        keep[worst % n] = true;
        open.emplace_back(from, worst);
        open.emplace_back(worst, to);
    }
}

Points thinned(const Points& points, double tolerance) {
    // The ring is cut at two points that are corners of it for certain: the leftmost and the one farthest
    // from it.
    const auto leftmost = std::ranges::min_element(points, {}, [](const Vector2d& p) { return p.x(); });
    const auto far = std::ranges::max_element(
        points, {}, [&](const Vector2d& p) { return (p - *leftmost).squaredNorm(); });
    const auto a = static_cast<std::size_t>(std::min(leftmost, far) - points.begin());
    const auto b = static_cast<std::size_t>(std::max(leftmost, far) - points.begin());
    std::vector<bool> keep(points.size(), false);
    keep[a] = keep[b] = true;
    keepBetween(points, a, b, tolerance, keep);
    keepBetween(points, b, a + points.size(), tolerance, keep);
    Points out;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (keep[k])
            out.push_back(points[k]);
    return out;
}

} // namespace

double contourArea(const Contour& contour) {
    return contour.points_m.empty() ? 0.0 : signedArea(contour.points_m);
}

double contourPerimeter(const Contour& contour) {
    const Points& points = contour.points_m;
    double sum = 0.0;
    for (std::size_t k = 0; k < points.size(); ++k)
        sum += (points[(k + 1) % points.size()] - points[k]).norm();
    return sum;
}

Vector2d contourCentroid(const Contour& contour) {
    const Points& points = contour.points_m;
    if (points.empty())
        return Vector2d::Zero();
    double twice = 0.0;
    Vector2d moment = Vector2d::Zero();
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        const Vector2d a = points[k] - points[0], b = points[k + 1] - points[0];
        const double c = cross(a, b);
        twice += c;
        moment += c * (a + b);
    }
    return twice == 0.0 ? points[0] : Vector2d(points[0] + moment / (3.0 * twice));
}

Result<Contour> makeContour(std::vector<Vector2d> points_m, const std::string& where) {
    if (const auto checked = checkCoordinates(points_m, where); !checked)
        return checked.error();
    auto [points, numbers] = withoutRepeats(points_m);
    if (points.size() < kMinVertices)
        return Error{MessageCode::ContourTooFewPoints,
                     where,
                     {std::to_string(points.size()), std::to_string(kMinVertices)}};
    if (isLine(points))
        return Error{MessageCode::ContourZeroArea, where};
    if (const auto found = findCrossing(points))
        return Error{MessageCode::ContourCrossing,
                     where,
                     {std::to_string(numbers[found->first] + 1), std::to_string(numbers[found->second] + 1),
                      formatNumber(found->point.x() * 1e3), formatNumber(found->point.y() * 1e3)}};
    if (signedArea(points) < 0.0)
        std::ranges::reverse(points);
    if (!(signedArea(points) > 0.0))
        return Error{MessageCode::ContourZeroArea, where};
    return Contour{std::move(points)};
}

bool encloses(const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& p) {
    bool inside = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d& a = ring[k];
        const Eigen::Vector2d& b = ring[(k + 1) % ring.size()];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
            inside = !inside;
    }
    return inside;
}

Contour shifted(const Contour& contour, const Vector2d& by_m) {
    Contour moved = contour;
    for (Vector2d& p : moved.points_m)
        p += by_m;
    return moved;
}

Contour centred(const Contour& contour) {
    return shifted(contour, -contourCentroid(contour));
}

Contour simplified(const Contour& contour, double tolerance_m) {
    constexpr int kTries = 8;
    double tolerance = tolerance_m;
    for (int k = 0; k < kTries && contour.points_m.size() > kMinVertices && tolerance > 0.0; ++k) {
        Points points = thinned(contour.points_m, tolerance);
        // Leaving points out can make narrow necks touch: then less is left out.
        if (points.size() >= kMinVertices && !isLine(points) && !findCrossing(points) &&
            signedArea(points) > 0.0)
            return Contour{std::move(points)};
        tolerance *= 0.5;
    }
    return contour;
}

Contour simplifiedTo(const Contour& contour, std::size_t max) {
    const double perimeter_m = contourPerimeter(contour);
    Contour fewer = contour;
    for (double share = 1e-6; fewer.points_m.size() > max && share < 1.0; share *= 2.0)
        fewer = simplified(contour, share * perimeter_m);
    return fewer;
}

std::vector<Vector2d> pointsAlong(const Contour& contour, double step_m) {
    std::vector<Vector2d> points;
    points.reserve(contour.points_m.size());
    for (std::size_t k = 0; k < contour.points_m.size(); ++k) {
        const Vector2d& a = contour.points_m[k];
        const Vector2d edge = contour.points_m[(k + 1) % contour.points_m.size()] - a;
        const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / step_m)));
        for (int piece = 0; piece < pieces; ++piece)
            points.push_back(a + edge * (static_cast<double>(piece) / pieces));
    }
    return points;
}

} // namespace bask
