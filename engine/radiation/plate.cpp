#include "engine/radiation/plate.h"

#include "engine/radiation/outline_table.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>

namespace bask {
namespace {

constexpr int kHull = 48; // points of a Fourier outline that stand for its hull

// Estimate of the relative error of a shadow if a Fourier outline is a polygon of so many corners: of the
// fourth order in the step, from scenes compared with finer polygons.
double polygonError(const FourierContour& contour, double reach_m, int corners) {
    double sum = 0.0;
    for (int j = -contour.harmonics(); j <= contour.harmonics(); ++j)
        sum += std::pow(2.0 * std::numbers::pi * j / corners, 4) * std::abs(contour.coefficient(j));
    return 0.02 * sum / reach_m;
}

PlateOutline outlineFor(const Shape& shape, double tolerance) {
    const auto* contour = outlineAs<FourierContour>(shape);
    if (!contour)
        return {SightOutline(shape, 0), 0.0};
    constexpr int kMin = 16, kMax = 1024;
    const double reach_m = shapeRadius(shape);
    int corners = kMin;
    while (corners < kMax && polygonError(*contour, reach_m, corners) > tolerance)
        corners += kEdgesOfChain;
    return {SightOutline(shape, corners), polygonError(*contour, reach_m, corners)};
}

// A smooth outline, scaled towards its origin: Gauss' rule of two nodes for the weight t, and even steps
// round.
void addSmooth(const Shape& outline, std::vector<FaceNode>& nodes) {
    constexpr int kAround = 10;
    constexpr std::array<std::pair<double, double>, 2> kInward{
        {{0.35505102572168219, 0.18195861825602283}, {0.84494897427831781, 0.31804138174397717}}};
    const RadiatingContour contour(outline);
    for (int k = 0; k < kAround; ++k) {
        const OutlinePoint p = contour.impl().at((k + 0.25) / kAround);
        const double twice = (p.x * p.dy - p.y * p.dx) / kAround;
        for (const auto& [t, weight] : kInward)
            nodes.push_back({{t * p.x, t * p.y}, weight * twice});
    }
}

// Triangles from a corner-free middle to the edges, each with one or three nodes.
void addPolygon(const Contour& ring, double sign, std::vector<FaceNode>& nodes) {
    constexpr std::size_t kMost = 24, kFew = 8;
    const std::vector<Eigen::Vector2d> points =
        (ring.points_m.size() > kMost ? simplifiedTo(ring, kMost) : ring).points_m;
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points)
        middle += point / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d a = points[i], b = points[(i + 1) % points.size()];
        const Eigen::Vector2d toA = a - middle, toB = b - middle;
        const double area = 0.5 * sign * (toA.x() * toB.y() - toA.y() * toB.x());
        const Eigen::Vector2d centre = (middle + a + b) / 3.0;
        if (points.size() > kFew) {
            nodes.push_back({centre, area});
            continue;
        }
        for (const Eigen::Vector2d& corner : {middle, a, b})
            nodes.push_back({0.5 * (centre + corner), area / 3.0});
    }
}

std::vector<FaceNode> nodesOf(const Shape& shape, double area_m2) {
    std::vector<FaceNode> nodes;
    if (const auto* polygon = outlineAs<Contour>(shape))
        addPolygon(*polygon, 1.0, nodes);
    else
        addSmooth(std::visit([](const auto& outline) { return Shape(outline); }, outlineOf(shape)), nodes);
    for (const Contour& hole : holesOf(shape))
        addPolygon(hole, -1.0, nodes);
    double sum = 0.0;
    for (const FaceNode& node : nodes)
        sum += node.area_m2;
    for (FaceNode& node : nodes)
        node.area_m2 *= area_m2 / sum;
    return nodes;
}

bool hasOnlyLeftTurns(const std::vector<Eigen::Vector2d>& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d a = ring[(i + 1) % n] - ring[i], b = ring[(i + 2) % n] - ring[(i + 1) % n];
        if (a.x() * b.y() - a.y() * b.x() < 0.0)
            return false;
    }
    return true;
}

} // namespace

Plate::Plate(const Shape& shape)
    : m_coarse(outlineFor(shape, 1e-5)), m_medium(outlineFor(shape, 1e-6)), m_fine(outlineFor(shape, 1e-8)),
      m_rough(outlineFor(shape, 2e-3).outline), m_back(mirrored(shape)),
      m_faceNodes(nodesOf(shape, shapeArea(shape))), m_reach(shapeRadius(shape)) {
    const bool isPolygon = outlineAs<Contour>(shape) != nullptr;
    if (isPolygon)
        m_hull = outlineAs<Contour>(shape)->points_m;
    if (const auto* contour = outlineAs<FourierContour>(shape)) {
        m_hull = shapeOutline(shape, std::max(kHull, 4 * contour->harmonics()));
        // Between two points the outline leaves the chord by an eighth of its second derivative, at most.
        double bend = 0.0;
        for (int j = -contour->harmonics(); j <= contour->harmonics(); ++j)
            bend += 40.0 * j * j * std::abs(contour->coefficient(j)); // (2 pi j)^2
        m_margin = bend / (8.0 * static_cast<double>(m_hull.size() * m_hull.size()));
    }
    m_isConvex = holesOf(shape).empty() && (m_hull.empty() || (isPolygon && hasOnlyLeftTurns(m_hull)));
}

Eigen::Vector3d Plate::farthest(const Pose& X_S, const Eigen::Vector3d& d) const {
    const Eigen::Vector2d inPlane(X_S.linear().col(0).dot(d), X_S.linear().col(1).dot(d));
    Eigen::Vector2d best = Eigen::Vector2d::Zero();
    if (m_hull.empty()) {
        const double length = inPlane.norm();
        if (length > 0.0)
            best = m_reach / length * inPlane;
    } else {
        best =
            *std::ranges::max_element(m_hull, {}, [&](const Eigen::Vector2d& v) { return v.dot(inPlane); });
    }
    return X_S.translation() + X_S.linear().leftCols<2>() * best;
}

struct RadiatingContour::Impl::LatePlate {
    std::once_flag once;
    std::unique_ptr<const Plate> plate;
    std::atomic<const Plate*> made = nullptr; // asking the flag takes longer
};

std::shared_ptr<RadiatingContour::Impl::LatePlate> RadiatingContour::Impl::latePlate() {
    return std::make_shared<LatePlate>();
}

const Plate& RadiatingContour::Impl::plate() const {
    if (const Plate* made = m_plate->made.load(std::memory_order_acquire))
        return *made;
    std::call_once(m_plate->once, [this] {
        m_plate->plate = std::make_unique<const Plate>(shape);
        m_plate->made.store(m_plate->plate.get(), std::memory_order_release);
    });
    return *m_plate->plate;
}

} // namespace bask
