#include "engine/model/passing_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace bask {
namespace {

constexpr int kPoints = 120;
constexpr double kSamePlane_m = 1e-6;
constexpr double kOnePlace = 0.9; ///< of the smaller face's area
constexpr double kTouch = 0.01;   ///< of the smaller face's size: outlines from pictures are no better

using Ring = std::vector<Eigen::Vector3d>;
using Interval = std::pair<double, double>;

std::vector<Ring> ringsIn(const Shape& shape, const Pose& X) {
    std::vector<Ring> rings;
    for (const auto& ring : shapeRings(shape, kPoints)) {
        Ring& moved = rings.emplace_back();
        for (const Eigen::Vector2d& p : ring)
            moved.push_back(X * Eigen::Vector3d(p.x(), p.y(), 0.0));
    }
    return rings;
}

template <class F> void forEdges(const std::vector<Ring>& rings, const F& take) {
    for (const Ring& ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            take(ring[i], ring[(i + 1) % ring.size()]);
}

// The parts of the line along `direction` that lie in the shape: the line is where `height` is zero.
template <class Height>
std::vector<Interval> insideOnLine(const std::vector<Ring>& rings, const Height& height,
                                   const Eigen::Vector3d& direction) {
    std::vector<double> crossings;
    forEdges(rings, [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        const double ha = height(a), hb = height(b);
        if ((ha > 0.0) != (hb > 0.0))
            crossings.push_back(direction.dot(a + (b - a) * (ha / (ha - hb))));
    });
    std::ranges::sort(crossings);
    std::vector<Interval> inside;
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
        inside.emplace_back(crossings[i], crossings[i + 1]);
    return inside;
}

double shared(const std::vector<Interval>& one, const std::vector<Interval>& other) {
    double sum = 0.0;
    for (const auto& [a, b] : one)
        for (const auto& [c, d] : other)
            sum += std::max(0.0, std::min(b, d) - std::max(a, c));
    return sum;
}

// Both in the xy-plane: strips between the corners of both, where all edges are straight.
double sharedArea_m2(const std::vector<Ring>& one, const std::vector<Ring>& other) {
    std::vector<double> corners;
    for (const std::vector<Ring>* rings : {&one, &other})
        for (const Ring& ring : *rings)
            for (const Eigen::Vector3d& p : ring)
                corners.push_back(p.y());
    std::ranges::sort(corners);
    double area_m2 = 0.0;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const double y = 0.5 * (corners[i] + corners[i + 1]);
        const auto height = [y](const Eigen::Vector3d& p) { return p.y() - y; };
        const Eigen::Vector3d direction = Eigen::Vector3d::UnitX();
        area_m2 += (corners[i + 1] - corners[i]) *
                   shared(insideOnLine(one, height, direction), insideOnLine(other, height, direction));
    }
    return area_m2;
}

// The paper itself reckons with circles that overlap in one plane, where neither shades the other.
Passage passageInPlane(double share) {
    return share > kOnePlace ? Passage::Through : share > kTouch ? Passage::Overlap : Passage::None;
}

} // namespace

Passage passageOf(const Shape& one, const Pose& X_WOne, const Shape& other, const Pose& X_WOther) {
    // In the frame of the first: its plane is z = 0.
    const Pose X = X_WOne.inverse() * X_WOther;
    const std::vector<Ring> a = ringsIn(one, Pose::Identity()), b = ringsIn(other, X);
    const double smaller_m2 = std::min(shapeArea(one), shapeArea(other));
    const auto height = [](const Eigen::Vector3d& p) { return p.z(); };
    const double min = std::ranges::min_element(b.front(), {}, height)->z();
    const double max = std::ranges::max_element(b.front(), {}, height)->z();
    if (std::max(std::abs(min), std::abs(max)) <= kSamePlane_m)
        return passageInPlane(sharedArea_m2(a, b) / smaller_m2);
    if (min > -kSamePlane_m || max < kSamePlane_m)
        return Passage::None;
    const Eigen::Vector3d normal = X.linear().col(2);
    const Eigen::Vector3d direction = normal.cross(Eigen::Vector3d::UnitZ()).normalized();
    const auto overOther = [&](const Eigen::Vector3d& p) { return normal.dot(p - X.translation()); };
    const double along_m = shared(insideOnLine(a, overOther, direction), insideOnLine(b, height, direction));
    return along_m > kTouch * std::sqrt(smaller_m2) ? Passage::Through : Passage::None;
}

} // namespace bask
