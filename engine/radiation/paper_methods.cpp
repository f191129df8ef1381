#include "engine/radiation/paper_methods.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace bask {
namespace {

constexpr double kPi = std::numbers::pi;

/// Centres of the squares of side `side` whose centres lie inside of the first ring and of no other, row by
/// row.
std::vector<Eigen::Vector2d> squaresInside(const std::vector<std::vector<Eigen::Vector2d>>& rings,
                                           double side) {
    Eigen::Vector2d low = rings[0][0], high = rings[0][0];
    for (const Eigen::Vector2d& p : rings[0]) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    // Centred on the bounding box.
    const Eigen::Vector2d middle = 0.5 * (low + high);
    const Eigen::Vector2d half = 0.5 * (high - low);
    const int columns = static_cast<int>(std::ceil(2.0 * half.x() / side));
    const int rows = static_cast<int>(std::ceil(2.0 * half.y() / side));
    std::vector<Eigen::Vector2d> centres;
    std::vector<double> crossings;
    for (int row = 0; row < rows; ++row) {
        const double y = middle.y() + (row - 0.5 * (rows - 1)) * side;
        crossings.clear();
        for (const auto& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Eigen::Vector2d& a = ring[i];
                const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
                if ((a.y() > y) != (b.y() > y))
                    crossings.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
            }
        std::ranges::sort(crossings);
        std::size_t passed = 0;
        for (int column = 0; column < columns; ++column) {
            const double x = middle.x() + (column - 0.5 * (columns - 1)) * side;
            while (passed < crossings.size() && crossings[passed] < x)
                ++passed;
            if (passed % 2 == 1)
                centres.emplace_back(x, y);
        }
    }
    return centres;
}

/// A face as equal squares: centres in S, the area of each, the common normal.
struct Elements {
    std::vector<Eigen::Vector3d> centres;
    double area = 0.0;
    Eigen::Vector3d normal;
};

Elements elementsOf(const Shape& shape, const Pose& X_SF, const Eigen::Vector3d& normal, int count) {
    constexpr int kOutlinePoints = 2048; // of a smooth outline, for the inside test
    const double side = std::sqrt(shapeArea(shape) / count);
    Elements result{{}, side * side, normal};
    for (const Eigen::Vector2d& p : squaresInside(shapeRings(shape, kOutlinePoints), side))
        result.centres.push_back(X_SF * Eigen::Vector3d(p.x(), p.y(), 0.0));
    return result;
}

/// Points of a contour with its steps, Simpson's weights in them.
struct Nodes {
    std::vector<Eigen::Vector3d> points, steps;
};

using Curve = std::function<void(double, Eigen::Vector3d&, Eigen::Vector3d&)>; // point, derivative

Nodes simpsonNodes(const Curve& curve, double from, double to, int n) {
    Nodes nodes;
    const double h = (to - from) / n;
    for (int j = 0; j <= n; ++j) {
        const double weight = h / 3.0 * (j == 0 || j == n ? 1.0 : j % 2 == 1 ? 4.0 : 2.0);
        Eigen::Vector3d point, slope;
        curve(from + j * h, point, slope);
        nodes.points.push_back(point);
        nodes.steps.push_back(weight * slope);
    }
    return nodes;
}

Curve circle(double radius) {
    return [radius](double angle, Eigen::Vector3d& point, Eigen::Vector3d& slope) {
        const double c = radius * std::cos(angle), s = radius * std::sin(angle);
        point = {c, s, 0.0};
        slope = {-s, c, 0.0};
    };
}

/// The whole contour in its own frame.
Nodes contourNodes(const Shape& shape, int n) {
    if (const auto* disk = std::get_if<Disk>(&shape))
        return simpsonNodes(circle(disk->radius_m), 0.0, 2.0 * kPi, n);
    const auto* fourier = std::get_if<FourierContour>(&shape);
    if (fourier == nullptr)
        throw std::invalid_argument(
            "simpsonViewFactor: the paper has circles and Fourier contours without holes only");
    const Curve series = [fourier](double phi, Eigen::Vector3d& point, Eigen::Vector3d& slope) {
        const std::complex<double> p = fourier->point(phi), d = fourier->derivative(phi);
        point = {p.real(), p.imag(), 0.0};
        slope = {d.real(), d.imag(), 0.0};
    };
    return simpsonNodes(series, 0.0, 1.0, n);
}

/// Loop of ln|s2 - s1| ds2 . ds1.
double doubleSum(const Nodes& source, const Nodes& object) {
    double sum = 0.0;
    for (std::size_t i = 0; i < source.points.size(); ++i)
        for (std::size_t k = 0; k < object.points.size(); ++k)
            sum += 0.5 * std::log((object.points[k] - source.points[i]).squaredNorm()) *
                   object.steps[k].dot(source.steps[i]);
    return sum;
}

/// The part of the source in front of the object's plane, as contours to be summed over: none, the whole, or
/// arc and chord. Corrected here: the cut formula of the paper's text leaves out the factor ds2 . ds1, and
/// its slope form of the chord fails where the chord is vertical, so it runs between its end points.
std::vector<Nodes> visibleSource(const Shape& source, const Pose& X_SO, int n) {
    const Eigen::Vector3d normal = -X_SO.linear().col(2);
    const double middle = -normal.dot(X_SO.translation());
    const auto* disk = std::get_if<Disk>(&source);
    if (disk == nullptr) {
        Nodes whole = contourNodes(source, n);
        const auto isSeen = [&](const Eigen::Vector3d& p) { return normal.dot(p) + middle > 0.0; };
        if (std::ranges::all_of(whole.points, isSeen))
            return {whole};
        if (std::ranges::none_of(whole.points, isSeen))
            return {};
        throw std::invalid_argument("simpsonViewFactor: the paper cuts circular sources only");
    }
    const double tilt = disk->radius_m * std::hypot(normal.x(), normal.y());
    if (middle >= tilt)
        return {contourNodes(source, n)};
    if (middle <= -tilt)
        return {};
    const double direction = std::atan2(normal.y(), normal.x());
    const double half = std::acos(-middle / tilt);
    const Nodes arc = simpsonNodes(circle(disk->radius_m), direction - half, direction + half, n);
    const Eigen::Vector3d from = arc.points.back(), way = arc.points.front() - from;
    const Curve chord = [&](double t, Eigen::Vector3d& point, Eigen::Vector3d& slope) {
        point = from + t * way;
        slope = way;
    };
    return {arc, simpsonNodes(chord, 0.0, 1.0, n)};
}

} // namespace

double discreteSurfaceIntegral(const Shape& source, const Shape& object, const Pose& X_SO, int elements) {
    if (elements < 1)
        throw std::invalid_argument("discreteSurfaceIntegral: too few elements");
    const Elements e1 = elementsOf(source, Pose::Identity(), Eigen::Vector3d::UnitZ(), elements);
    const Elements e2 = elementsOf(object, X_SO, -X_SO.linear().col(2), elements);
    if (e2.centres.empty())
        throw std::invalid_argument("discreteSurfaceIntegral: too few elements for this object");
    double sum = 0.0;
    for (const Eigen::Vector3d& p2 : e2.centres)
        for (const Eigen::Vector3d& p1 : e1.centres) {
            const Eigen::Vector3d r = p1 - p2;
            const double cos2 = e2.normal.dot(r), cos1 = -e1.normal.dot(r); // times |r|
            if (cos1 > 0.0 && cos2 > 0.0) {
                const double r2 = r.squaredNorm();
                sum += cos1 * cos2 / (kPi * r2 * r2);
            }
        }
    return sum * e1.area / static_cast<double>(e2.centres.size());
}

double simpsonViewFactor(const Shape& source, const Shape& object, const Pose& X_SO, int points) {
    if (points < 2 || points % 2 != 0)
        throw std::invalid_argument("simpsonViewFactor: an even number of subintervals, 2 or more");
    Nodes outline = contourNodes(object, points);
    for (Eigen::Vector3d& p : outline.points)
        p = X_SO * p;
    for (Eigen::Vector3d& step : outline.steps)
        step = X_SO.linear() * step;
    double sum = 0.0;
    for (const Nodes& part : visibleSource(source, X_SO, points))
        sum += doubleSum(part, outline);
    // Both contours run counter-clockwise in their own frames, hence the minus.
    return -sum / (2.0 * kPi * shapeArea(object));
}

SimpsonGradient simpsonGradient(const Shape& source, const Shape& object, const Vector6d& coordinates,
                                int points, double step_m, double step_rad) {
    SimpsonGradient result;
    result.value = simpsonViewFactor(source, object, poseFromCoordinates(coordinates), points);
    for (int i = 0; i < 6; ++i) {
        const double step = i < kThetaX ? step_m : step_rad;
        Vector6d moved = coordinates;
        moved[i] += step;
        result.gradient[i] =
            (simpsonViewFactor(source, object, poseFromCoordinates(moved), points) - result.value) / step;
    }
    return result;
}

} // namespace bask
