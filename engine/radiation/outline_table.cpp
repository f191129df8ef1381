#include "engine/radiation/outline_table.h"

#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bask {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kMinArea_m2 = 1e-22; // of a face; smaller ones reach the guards against division by zero
constexpr int kTrapezoidPoints[] = {8, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512};
constexpr double kGaussDistances[] = {1.0, 0.5, 0.25, 0.125, 0.0625}; // in perimeters

std::vector<std::complex<double>> seriesOf(const Shape& shape) {
    if (const auto* disk = outlineAs<Disk>(shape))
        return {0.0, 0.0, disk->radius_m};
    if (const auto* fourier = outlineAs<FourierContour>(shape))
        return fourier->coefficients();
    return {};
}

} // namespace

void OutlineTable::add(double x, double y, double dx, double dy) {
    m_x.push_back(x);
    m_y.push_back(y);
    m_dx.push_back(dx);
    m_dy.push_back(dy);
}

void OutlineTable::add(const OutlineTable& other, int first, int count) {
    const auto append = [&](std::vector<double>& to, const std::vector<double>& from) {
        to.insert(to.end(), from.begin() + first, from.begin() + first + count);
    };
    append(m_x, other.m_x);
    append(m_y, other.m_y);
    append(m_dx, other.m_dx);
    append(m_dy, other.m_dy);
}

void OutlineTable::clear() {
    m_x.clear();
    m_y.clear();
    m_dx.clear();
    m_dy.clear();
}

void OutlineTable::seal() {
    while (m_x.size() % kernels::kPadding != 0)
        add(m_x.back(), m_y.back(), 0.0, 0.0);
}

double squaredDistance(const kernels::Edge& edge, const Eigen::Vector3d& p) {
    const double r1 = p.x() - edge.a1, r2 = p.y() - edge.a2;
    const double along = r1 * edge.t1 + r2 * edge.t2;
    const double aside = r2 * edge.t1 - r1 * edge.t2;
    const double beyond = std::max({0.0, -along, along - edge.length});
    return aside * aside + p.z() * p.z() + beyond * beyond;
}

namespace {

const std::array<double, AnalyticStrip::kSteps>& stripWidths() {
    static const auto widths = [] {
        std::array<double, AnalyticStrip::kSteps> made{};
        for (int k = 0; k < AnalyticStrip::kSteps; ++k)
            made[static_cast<std::size_t>(k)] = 0.01 * std::pow(1.075, k);
        return made;
    }();
    return widths;
}

} // namespace

// With p + iy -> u = sum c_j e^(ij phi) and its conjugate v made complex apart, a point s at distance D of O
// is met where D^2 - D (|u| + |v|) - |u||v| <= 0 at worst. A straight stretch meets a singularity when the
// step is as long as the distance; bends make it a little sooner.
AnalyticStrip::AnalyticStrip(const std::vector<std::complex<double>>& coefficients, int harmonics,
                             double perimeter_m) {
    constexpr double kKeepAway = 0.9;
    constexpr double kBend = 1.25;
    for (std::size_t k = 0; k < kSteps; ++k) {
        const double b = stripWidths()[k];
        double u = 0.0, v = 0.0, shift = 0.0, speed = 0.0;
        for (int j = -harmonics; j <= harmonics; ++j) {
            const double c = std::abs(coefficients[static_cast<std::size_t>(j + harmonics)]);
            u += c * std::exp(-j * b);
            v += c * std::exp(j * b);
            shift += c * std::expm1(std::abs(j) * b);
            speed += std::abs(j) * c * std::exp(std::abs(j) * b);
        }
        m_reach[k] = 0.5 * (u + v + std::sqrt((u + v) * (u + v) + 4.0 * u * v)) / kKeepAway;
        m_shift[k] = kBend * shift / kKeepAway;
        m_growth[k] = std::log(kTwoPi * speed / perimeter_m);
    }
}

double AnalyticStrip::width(int step) {
    return stripWidths()[static_cast<std::size_t>(step)];
}

double AnalyticStrip::radius(double distance_m) const {
    const int step = fromOutline(distance_m);
    const double b = step < 0 ? width(0) * std::max(distance_m, 0.0) / m_shift[0] : width(step);
    return b / kTwoPi;
}

double AnalyticStrip::distanceFor(double radius) const {
    const double b = kTwoPi * radius;
    if (b < width(0))
        return m_shift[0] * b / width(0);
    const auto& widths = stripWidths();
    const auto step = std::ranges::lower_bound(widths, b);
    return step == widths.end() ? std::numeric_limits<double>::infinity()
                                : m_shift[static_cast<std::size_t>(step - widths.begin())];
}

int AnalyticStrip::widest(const Table& table, double distance_m) {
    return static_cast<int>(std::upper_bound(table.begin(), table.end(), distance_m) - table.begin()) - 1;
}

RadiatingContour::Impl::Impl(const Shape& outline)
    : shape(outline), netArea(shapeArea(outline)), area(netArea), m_coefficients(seriesOf(outline)) {
    disk = outlineAs<Disk>(shape);
    if (!(netArea > kMinArea_m2) || !std::isfinite(netArea) || (disk && !(disk->radius_m > 0.0)))
        throw std::invalid_argument("RadiatingContour: an outline without area");
    for (const Contour& hole : holesOf(shape))
        area += holes.emplace_back(hole).area;
    if (const auto* polygon = outlineAs<Contour>(shape)) {
        isPolygon = true;
        tabulatePolygon(*polygon);
        return;
    }
    harmonics = (static_cast<int>(m_coefficients.size()) - 1) / 2;
    tabulateSmooth();
}

OutlinePoint RadiatingContour::Impl::at(double phi) const {
    const std::complex<double> turn = std::polar(1.0, kTwoPi * phi);
    if (disk) {
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

OutlinePoint RadiatingContour::Impl::at(const OutlinePiece& piece, double t) const {
    if (!piece.straight)
        return at(t);
    const Eigen::Vector2d step = piece.b - piece.a;
    const Eigen::Vector2d p = piece.a + t * step;
    return {p.x(), p.y(), step.x(), step.y()};
}

kernels::SeriesPoints RadiatingContour::Impl::seriesAt(double from, double width,
                                                       std::span<const double> nodes) const {
    constexpr auto kMax = static_cast<std::size_t>(kernels::kMaxSeriesPoints);
    constexpr auto kPadding = static_cast<std::size_t>(kernels::kPadding);
    double cosines[kMax], sines[kMax];
    const std::size_t count = (nodes.size() + kPadding - 1) / kPadding * kPadding;
    for (std::size_t i = 0; i < count; ++i) {
        if (i < nodes.size()) {
            const double angle = kTwoPi * (from + width * nodes[i]);
            cosines[i] = std::cos(angle);
            sines[i] = std::sin(angle);
        } else {
            cosines[i] = sines[i] = 0.0;
        }
    }
    kernels::SeriesPoints points;
    // A complex number is laid out as its two parts (C++20, [complex.numbers]).
    kernels::kernels().seriesPoints({reinterpret_cast<const double*>(m_coefficients.data()), harmonics},
                                    cosines, sines, static_cast<int>(count), points);
    return points;
}

const TrapezoidTable* RadiatingContour::Impl::trapezoid(double points) const {
    for (const TrapezoidTable& table : m_trapezoids)
        if (table.points >= points)
            return &table;
    return nullptr;
}

const GaussTable* RadiatingContour::Impl::gauss(double distance_m) const {
    for (const GaussTable& table : m_gauss)
        if (table.distance_m <= distance_m)
            return &table;
    return nullptr;
}

void RadiatingContour::Impl::tabulateSmooth() {
    for (const int n : kTrapezoidPoints) {
        TrapezoidTable& made = m_trapezoids.emplace_back();
        made.points = n;
        const auto fill = [&](OutlineTable& table, double shift) {
            for (int i = 0; i < n; ++i) {
                const OutlinePoint p = at((i + shift) / n);
                table.add(p.x, p.y, p.dx / n, p.dy / n);
            }
            table.seal();
        };
        fill(made.table, 0.0);
        if (!disk && std::has_single_bit(static_cast<unsigned>(n)))
            fill(made.shifted, 0.5);
    }
    for (std::size_t i = 0; i < m_quick.size(); ++i)
        m_quick[i] = trapezoid(8.0 * static_cast<double>(i + 1))->table.view();
    const int scan = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::max(128, 16 * harmonics))));
    for (int i = 0; i < scan; ++i)
        m_scan.push_back(at(static_cast<double>(i) / scan));
    for (const OutlinePoint& p : m_scan) {
        reach = std::max(reach, std::hypot(p.x, p.y));
        maxSpeed_m = std::max(maxSpeed_m, std::hypot(p.dx, p.dy));
        perimeter += std::hypot(p.dx, p.dy) / scan;
    }
    // Between two points the velocity leaves its chord by at most h^2/8 times its second derivative, which
    // Bernstein's inequality bounds by (2 pi harmonics)^2 of its maximum: 0.0193 with 16 points a wave.
    constexpr double kBetween = 0.02;
    for (std::size_t i = 0; i < m_scan.size(); ++i) {
        const OutlinePoint& next = m_scan[(i + 1) % m_scan.size()];
        m_speeds.push_back(std::max(std::hypot(m_scan[i].dx, m_scan[i].dy), std::hypot(next.dx, next.dy)) +
                           kBetween * maxSpeed_m);
    }
    maxSpeed_m *= disk ? 1.0 : 1.1; // between the scanned points, too
    reach += disk ? 0.0 : 0.5 * maxSpeed_m / scan;
    strip = AnalyticStrip(m_coefficients, harmonics, perimeter);
}

// Number of points on an edge for which a rule of order n leaves only rounding errors: the ratio of half
// length and distance gives the ellipse in which the field is smooth.
void RadiatingContour::Impl::tabulatePolygon(const Contour& polygon) {
    const auto& points = polygon.points_m;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d edge = points[(i + 1) % n] - points[i];
        const double length = edge.norm();
        if (length == 0.0)
            continue;
        perimeter += length;
        reach = std::max(reach, points[i].norm());
        edges.push_back({points[i].x(), points[i].y(), edge.x() / length, edge.y() / length, length});
    }
    for (const double share : kGaussDistances) {
        GaussTable& made = m_gauss.emplace_back();
        made.distance_m = share * perimeter;
        for (const kernels::Edge& edge : edges) {
            const int parts = std::max(1, static_cast<int>(std::ceil(edge.length / made.distance_m)));
            const double half = 0.5 * edge.length / parts;
            const GaussRule rule = gaussRule(gaussOrder(made.distance_m / half, kTableExponent));
            const Eigen::Vector2d start(edge.a1, edge.a2);
            const Eigen::Vector2d step = 2.0 * half * Eigen::Vector2d(edge.t1, edge.t2);
            for (int part = 0; part < parts; ++part)
                for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
                    const Eigen::Vector2d p = start + step * (part + rule.nodes[k]);
                    made.table.add(p.x(), p.y(), step.x() * rule.weights[k], step.y() * rule.weights[k]);
                }
        }
        made.table.seal();
    }
}

double RadiatingContour::Impl::speedBetween_m(double from, double to) const {
    const auto n = static_cast<std::ptrdiff_t>(m_scan.size());
    const auto first = static_cast<std::ptrdiff_t>(std::floor(from * static_cast<double>(n)));
    const auto end = std::min(static_cast<std::ptrdiff_t>(std::ceil(to * static_cast<double>(n))), first + n);
    double max = 0.0;
    for (std::ptrdiff_t i = first; i < end; ++i)
        max = std::max(max, m_speeds[static_cast<std::size_t>((i % n + n) % n)]);
    return max;
}

// Branch and bound: the distance of an interval is at least that of its middle minus half its length. The
// scanned points come first; only intervals that may be nearest are halved.
double RadiatingContour::Impl::curveDistance_m(const Eigen::Vector3d& p) const {
    constexpr double kGoodEnough = 0.7;
    struct Interval {
        double min, middle, half, speed;
    };
    const double speed = maxSpeed_m;
    const double half = 0.5 / static_cast<double>(m_scan.size());
    double nearest2 = 1e300;
    for (const OutlinePoint& s : m_scan) {
        const double dx = p.x() - s.x, dy = p.y() - s.y;
        nearest2 = std::min(nearest2, dx * dx + dy * dy);
    }
    double nearest = std::sqrt(nearest2 + p.z() * p.z());
    if (nearest - speed * half >= kGoodEnough * nearest)
        return nearest - speed * half;
    std::vector<Interval> open;
    const auto farther = [](const Interval& a, const Interval& b) { return a.min > b.min; };
    const double within = kGoodEnough * nearest + speed * half;
    const double within2 = 1.000001 * within * within - p.z() * p.z(); // tells most apart without a root
    for (std::size_t i = 0; i < m_scan.size(); ++i) {
        const double dx = p.x() - m_scan[i].x, dy = p.y() - m_scan[i].y;
        if (dx * dx + dy * dy > within2)
            continue;
        const double away = std::hypot(dx, dy, p.z());
        const double local = std::max(m_speeds[i], m_speeds[(i == 0 ? m_scan.size() : i) - 1]);
        open.push_back({away - local * half, static_cast<double>(i) * 2.0 * half, half, local});
    }
    std::make_heap(open.begin(), open.end(), farther);
    while (open.front().min < kGoodEnough * nearest && nearest > 1e-15 * reach) {
        const Interval wide = open.front();
        std::pop_heap(open.begin(), open.end(), farther);
        open.pop_back();
        constexpr double kHalves[] = {-0.5, 0.5};
        atNodes({}, wide.middle, wide.half, kHalves, [&](std::size_t i, const OutlinePoint& s) {
            const double away = std::hypot(p.x() - s.x, p.y() - s.y, p.z());
            nearest = std::min(nearest, away);
            open.push_back({away - 0.5 * wide.speed * wide.half, wide.middle + kHalves[i] * wide.half,
                            0.5 * wide.half, wide.speed});
            std::push_heap(open.begin(), open.end(), farther);
        });
    }
    return std::clamp(open.front().min, 0.0, nearest);
}

ForeseenRule RadiatingContour::Impl::foreseen(double fromCentre, double nearest, double exponent) const {
    constexpr int kNarrow = 40;      // step of a strip that needs more than a hundred points
    constexpr int kMaxForeseen = 64; // points of an outline of many harmonics, without a test
    int step = strip.fromCentre(fromCentre);
    if (!disk || step < kNarrow)
        step = std::max(step, strip.fromOutline(nearest));
    if (step < 0)
        return {};
    const double b = AnalyticStrip::width(step);
    const double growth = strip.growth(step);
    const TrapezoidTable* rule = trapezoid((exponent + growth) / b);
    if (!rule || (!disk && rule->points > kMaxForeseen))
        return {};
    return {rule, rule->points * b - growth};
}

PlaneSide RadiatingContour::Impl::side(const HeightPlane& height) const {
    if (height.z0 - reach * height.slope >= 0.0)
        return height.z0 > 0.0 ? PlaneSide::Front : PlaneSide::Behind;
    if (height.z0 + reach * height.slope <= 0.0)
        return PlaneSide::Behind;
    if (const auto* polygon = outlineAs<Contour>(shape)) {
        double min = 1e300;
        double max = -1e300;
        for (const Eigen::Vector2d& p : polygon->points_m) {
            min = std::min(min, height.at(p.x(), p.y()));
            max = std::max(max, height.at(p.x(), p.y()));
        }
        return max <= 0.0 ? PlaneSide::Behind : min >= 0.0 ? PlaneSide::Front : PlaneSide::Across;
    }
    if (disk)
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

// Changes of sign between scanned points, and pairs of them where the height turns back between two points.
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
    if (disk) {
        const double slope = reach * height.slope;
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
    const auto& points = outlineAs<Contour>(shape)->points_m;
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
    const auto& points = outlineAs<Contour>(shape)->points_m;
    std::vector<OutlinePiece> pieces;
    for (std::size_t i = 0; i < points.size(); ++i)
        pieces.push_back({.straight = true, .a = points[i], .b = points[(i + 1) % points.size()]});
    return pieces;
}

} // namespace bask
