#include "engine/radiation/outline_table.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bask {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr int kFirstPoints = 16;

std::vector<std::complex<double>> seriesOf(const Shape& shape) {
    if (const auto* disk = std::get_if<Disk>(&shape))
        return {0.0, 0.0, disk->radius_m};
    if (const auto* fourier = std::get_if<FourierContour>(&shape))
        return fourier->coefficients();
    return {};
}

double seriesArea(const std::vector<std::complex<double>>& coefficients, int harmonics) {
    double sum = 0.0;
    for (int j = -harmonics; j <= harmonics; ++j)
        sum += j * std::norm(coefficients[static_cast<std::size_t>(j + harmonics)]);
    return std::numbers::pi * sum;
}

double polygonArea(const std::vector<Eigen::Vector2d>& points) {
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Eigen::Vector2d a = points[i] - points[0];
        const Eigen::Vector2d b = points[(i + 1) % points.size()] - points[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * twice;
}

} // namespace

RadiatingContour::Impl::Impl(const Shape& outline) : shape(outline), m_coefficients(seriesOf(outline)) {
    if (const auto* polygon = std::get_if<Contour>(&shape)) {
        isPolygon = true;
        area = polygonArea(polygon->points_m);
        if (!(area > 0.0))
            throw std::invalid_argument("RadiatingContour: an outline without area");
        tabulatePolygon(*polygon);
        return;
    }
    harmonics = (static_cast<int>(m_coefficients.size()) - 1) / 2;
    area = harmonics < 1 ? 0.0 : seriesArea(m_coefficients, harmonics);
    if (!(area > 0.0) || !std::isfinite(area))
        throw std::invalid_argument("RadiatingContour: an outline without area");
    tabulateSmooth();
}

OutlinePoint RadiatingContour::Impl::at(double phi) const {
    const std::complex<double> turn = std::polar(1.0, kTwoPi * phi);
    if (std::holds_alternative<Disk>(shape)) {
        const std::complex<double> p = m_coefficients[2] * turn;
        return {p.real(), p.imag(), -kTwoPi * p.imag(), kTwoPi * p.real()};
    }
    // Horner's scheme in both directions, the derivative beside the value.
    const std::complex<double> back = std::conj(turn);
    std::complex<double> up = 0.0, down = 0.0, upSlope = 0.0, downSlope = 0.0;
    for (int j = harmonics; j >= 1; --j) {
        const std::complex<double> cp = m_coefficients[static_cast<std::size_t>(harmonics + j)];
        const std::complex<double> cm = m_coefficients[static_cast<std::size_t>(harmonics - j)];
        up = (up + cp) * turn;
        upSlope = (upSlope + static_cast<double>(j) * cp) * turn;
        down = (down + cm) * back;
        downSlope = (downSlope - static_cast<double>(j) * cm) * back;
    }
    const std::complex<double> p = m_coefficients[static_cast<std::size_t>(harmonics)] + up + down;
    const std::complex<double> d = std::complex<double>(0.0, kTwoPi) * (upSlope + downSlope);
    return {p.real(), p.imag(), d.real(), d.imag()};
}

OutlinePoints RadiatingContour::Impl::level(int l) const {
    const auto begin = static_cast<std::size_t>(m_begin[static_cast<std::size_t>(l)]);
    const int end = m_begin[static_cast<std::size_t>(l) + 1];
    return {&m_x[begin], &m_y[begin], &m_dx[begin], &m_dy[begin], end - static_cast<int>(begin)};
}

void RadiatingContour::Impl::tabulateSmooth() {
    const auto append = [&](double phi) {
        const OutlinePoint p = at(phi);
        m_x.push_back(p.x);
        m_y.push_back(p.y);
        m_dx.push_back(p.dx);
        m_dy.push_back(p.dy);
        maxSpeed = std::max(maxSpeed, std::hypot(p.dx, p.dy));
        perimeter += std::hypot(p.dx, p.dy) / kMostTabulated;
    };
    m_begin = {0};
    for (int i = 0; i < kFirstPoints; ++i)
        append(static_cast<double>(i) / kFirstPoints);
    m_begin.push_back(kFirstPoints);
    for (int n = kFirstPoints; n < kMostTabulated; n *= 2) {
        for (int i = 0; i < n; ++i)
            append((i + 0.5) / n);
        m_begin.push_back(2 * n);
    }
    while (m_firstLevel + 2 < levels() && (kFirstPoints << m_firstLevel) <= 2 * harmonics)
        ++m_firstLevel;
    const int scan = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(128, 16 * harmonics))));
    for (int i = 0; i < scan; ++i)
        m_scan.push_back(at(static_cast<double>(i) / scan));
    for (const std::complex<double>& c : m_coefficients)
        reach += std::abs(c);
    for (const OutlinePoint& p : m_scan)
        size = std::max(size, std::hypot(p.x, p.y));
}

// Edges are cut into stretches of at most an eighth of the perimeter; short ones get fewer points.
void RadiatingContour::Impl::tabulatePolygon(const Contour& polygon) {
    const auto& points = polygon.points_m;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        perimeter += (points[(i + 1) % n] - points[i]).norm();
        reach = std::max(reach, points[i].norm());
    }
    size = reach;
    m_begin = {0};
    for (int order : {2, 4, 8}) {
        for (std::size_t i = 0; i < n; ++i) {
            const Eigen::Vector2d edge = points[(i + 1) % n] - points[i];
            const int parts = std::max(1, static_cast<int>(std::ceil(8.0 * edge.norm() / perimeter)));
            const Eigen::Vector2d step = edge / parts;
            maxSpeed = std::max(maxSpeed, step.norm());
            const GaussRule rule = gaussRule(step.norm() > perimeter / 32.0 ? order * 3 / 2 : order);
            for (int part = 0; part < parts; ++part)
                for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                    const Eigen::Vector2d p = points[i] + step * (part + rule.nodes[k]);
                    m_x.push_back(p.x());
                    m_y.push_back(p.y());
                    m_dx.push_back(step.x() * rule.weights[k]);
                    m_dy.push_back(step.y() * rule.weights[k]);
                }
        }
        m_begin.push_back(static_cast<int>(m_x.size()));
    }
}

PlaneSide RadiatingContour::Impl::side(const HeightPlane& height) const {
    const double slope = std::hypot(height.kx, height.ky);
    if (height.z0 - reach * slope >= 0.0)
        return height.z0 > 0.0 ? PlaneSide::Front : PlaneSide::Behind;
    if (height.z0 + reach * slope <= 0.0)
        return PlaneSide::Behind;
    if (const auto* polygon = std::get_if<Contour>(&shape)) {
        double least = 1e300;
        double most = -1e300;
        for (const Eigen::Vector2d& p : polygon->points_m) {
            least = std::min(least, height.at(p.x(), p.y()));
            most = std::max(most, height.at(p.x(), p.y()));
        }
        return most <= 0.0 ? PlaneSide::Behind : least >= 0.0 ? PlaneSide::Front : PlaneSide::Across;
    }
    if (std::holds_alternative<Disk>(shape))
        return PlaneSide::Across;
    const std::vector<double> found = crossings(height);
    if (!found.empty())
        return PlaneSide::Across;
    return height.at(m_scan[0].x, m_scan[0].y) > 0.0 ? PlaneSide::Front : PlaneSide::Behind;
}

namespace {

// Root of the height (or of its slope) between two parameters of opposite sign: bisection with secant steps.
template <class F> double rootBetween(const F& f, double a, double fa, double b, double fb) {
    for (int step = 0; step < 200 && b - a > 1e-16; ++step) {
        double middle = step % 3 == 2 ? 0.5 * (a + b) : a - fa * (b - a) / (fb - fa);
        if (!(middle > a && middle < b))
            middle = 0.5 * (a + b);
        if (middle <= a || middle >= b)
            break;
        const double value = f(middle);
        if (value == 0.0)
            return middle;
        if ((value > 0.0) == (fa > 0.0)) {
            a = middle;
            fa = value;
        } else {
            b = middle;
            fb = value;
        }
    }
    return std::abs(fa) < std::abs(fb) ? a : b;
}

} // namespace

// Changes of sign between scanned points, and the pairs that hide where the height turns back between two of
// them.
std::vector<double> RadiatingContour::Impl::crossings(const HeightPlane& height) const {
    std::vector<double> found;
    const auto value = [&](double phi) {
        const OutlinePoint p = at(phi);
        return height.at(p.x, p.y);
    };
    const auto slope = [&](double phi) {
        const OutlinePoint p = at(phi);
        return height.kx * p.dx + height.ky * p.dy;
    };
    const std::size_t n = m_scan.size();
    const double width = 1.0 / static_cast<double>(n);
    const auto heightOf = [&](const OutlinePoint& p) { return height.at(p.x, p.y); };
    const auto slopeOf = [&](const OutlinePoint& p) { return height.kx * p.dx + height.ky * p.dy; };
    for (std::size_t i = 0; i < n; ++i) {
        const OutlinePoint& here = m_scan[i];
        const OutlinePoint& next = m_scan[(i + 1) % n];
        const double a = static_cast<double>(i) * width;
        const double b = static_cast<double>(i + 1) * width;
        const double za = heightOf(here);
        const double zb = heightOf(next);
        if ((za > 0.0) != (zb > 0.0)) {
            found.push_back(za == 0.0 ? a : zb == 0.0 ? b : rootBetween(value, a, za, b, zb));
            continue;
        }
        const double sa = slopeOf(here);
        const double sb = slopeOf(next);
        const bool turnsBack = za > 0.0 ? sa < 0.0 && sb > 0.0 : sa > 0.0 && sb < 0.0;
        if (!turnsBack || std::min(std::abs(za), std::abs(zb)) > width * std::max(std::abs(sa), std::abs(sb)))
            continue;
        const double turn = rootBetween(slope, a, sa, b, sb);
        const double zTurn = value(turn);
        if ((zTurn > 0.0) != (za > 0.0) && zTurn != 0.0 && za != 0.0 && zb != 0.0) {
            found.push_back(rootBetween(value, a, za, turn, zTurn));
            found.push_back(rootBetween(value, turn, zTurn, b, zb));
        }
    }
    return found;
}

std::vector<OutlinePiece> RadiatingContour::Impl::smoothPieces(const HeightPlane& height) const {
    std::vector<double> cuts;
    if (std::holds_alternative<Disk>(shape)) {
        const double slope = reach * std::hypot(height.kx, height.ky);
        const double middle = std::atan2(height.ky, height.kx) / kTwoPi;
        const double half = std::acos(std::clamp(-height.z0 / slope, -1.0, 1.0)) / kTwoPi;
        cuts = {middle - half, middle + half};
    } else {
        cuts = crossings(height);
        if (cuts.size() < 2)
            return {};
        const OutlinePoint between = at(0.5 * (cuts[0] + cuts[1]));
        if (height.at(between.x, between.y) <= 0.0) {
            cuts.push_back(cuts.front() + 1.0);
            cuts.erase(cuts.begin());
        }
    }
    std::vector<OutlinePiece> pieces;
    const auto pointAt = [&](double phi) {
        const OutlinePoint p = at(phi);
        return Eigen::Vector2d(p.x, p.y);
    };
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
        const double next = i + 2 < cuts.size() ? cuts[i + 2] : cuts[0];
        pieces.push_back({.from = cuts[i], .to = cuts[i + 1]});
        pieces.push_back({.straight = true, .onCut = true, .a = pointAt(cuts[i + 1]), .b = pointAt(next)});
    }
    return pieces;
}

std::vector<OutlinePiece> RadiatingContour::Impl::polygonPieces(const HeightPlane& height) const {
    const auto& points = std::get<Contour>(shape).points_m;
    const std::size_t n = points.size();
    const auto z = [&](std::size_t i) { return height.at(points[i % n].x(), points[i % n].y()); };
    std::size_t start = 0; // an edge that comes out of the plane
    while (start < n && !(z(start) <= 0.0 && z(start + 1) > 0.0))
        ++start;
    std::vector<OutlinePiece> pieces;
    Eigen::Vector2d first = Eigen::Vector2d::Zero();
    Eigen::Vector2d exit = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < n && start < n; ++k) {
        const std::size_t i = (start + k) % n;
        const Eigen::Vector2d a = points[i];
        const Eigen::Vector2d b = points[(i + 1) % n];
        const double za = z(i);
        const double zb = z(i + 1);
        if (za <= 0.0 && zb <= 0.0)
            continue;
        const Eigen::Vector2d cut =
            za == zb ? a : Eigen::Vector2d(a + (b - a) * std::clamp(za / (za - zb), 0.0, 1.0));
        if (za <= 0.0) {
            if (k == 0)
                first = cut;
            else
                pieces.push_back({.straight = true, .onCut = true, .a = exit, .b = cut});
            pieces.push_back({.straight = true, .a = cut, .b = b});
        } else if (zb <= 0.0) {
            pieces.push_back({.straight = true, .a = a, .b = cut});
            exit = cut;
        } else {
            pieces.push_back({.straight = true, .a = a, .b = b});
        }
    }
    if (!pieces.empty())
        pieces.push_back({.straight = true, .onCut = true, .a = exit, .b = first});
    return pieces;
}

std::vector<OutlinePiece> RadiatingContour::Impl::piecesInFront(const HeightPlane& height) const {
    return isPolygon ? polygonPieces(height) : smoothPieces(height);
}

std::vector<OutlinePiece> RadiatingContour::Impl::allPieces() const {
    if (!isPolygon)
        return {{.from = 0.0, .to = 1.0}};
    const auto& points = std::get<Contour>(shape).points_m;
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < points.size(); ++i)
        pieces.push_back({.straight = true, .a = points[i], .b = points[(i + 1) % points.size()]});
    return pieces;
}

} // namespace bask
