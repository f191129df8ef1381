#include "tests/engine/radiation/face_pairs.h"

#include <algorithm>

namespace bask::test {
namespace {

// Where the outline crosses the plane through `p` with the normal `n`, along `direction`, in order.
std::vector<double> crossings(const Shape& shape, const Pose& X, const Eigen::Vector3d& p,
                              const Eigen::Vector3d& n, const Eigen::Vector3d& direction) {
    std::vector<double> found;
    const auto outline = shapeOutline(shape, 2000);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Eigen::Vector2d &q = outline[i], &r = outline[(i + 1) % outline.size()];
        const Eigen::Vector3d a = X * Eigen::Vector3d(q.x(), q.y(), 0.0);
        const Eigen::Vector3d b = X * Eigen::Vector3d(r.x(), r.y(), 0.0);
        const double ha = n.dot(a - p), hb = n.dot(b - p);
        if ((ha > 0.0) != (hb > 0.0))
            found.push_back(direction.dot(a + (b - a) * (ha / (ha - hb))));
    }
    std::ranges::sort(found);
    return found;
}

} // namespace

Contour star(double radius_m, int points, double inner) {
    Contour contour;
    for (int i = 0; i < 2 * points; ++i) {
        const auto p = std::polar(i % 2 == 0 ? radius_m : inner * radius_m, kPi * i / points + 0.1);
        contour.points_m.emplace_back(p.real(), p.imag());
    }
    return contour;
}

Contour horseshoe(double radius_m) {
    Contour contour;
    for (const auto& [x, y] : {std::pair(-0.7, -0.7),
                               {0.7, -0.7},
                               {0.7, 0.6},
                               {0.4, 0.7},
                               {0.3, -0.3},
                               {-0.3, -0.3},
                               {-0.3, 0.65},
                               {-0.7, 0.7}})
        contour.points_m.emplace_back(radius_m * x, radius_m * y);
    return contour;
}

FourierContour clover(double radius_m, int lobes, double depth) {
    // r (1 + depth cos(lobes t)) e^(it), scaled to fit into the radius.
    const int h = lobes + 1;
    std::vector<std::complex<double>> c(static_cast<std::size_t>(2 * h + 1));
    const double r = radius_m / (1.0 + depth);
    c[static_cast<std::size_t>(h + 1)] = r;
    c[static_cast<std::size_t>(h + 1 + lobes)] += 0.5 * depth * r;
    c[static_cast<std::size_t>(h + 1 - lobes)] += 0.5 * depth * r;
    return FourierContour(c);
}

Shape drawShape(Draw& draw, int kind, double radius_m) {
    const double choice = draw.between(0.0, 4.0);
    if (kind == 0)
        return Disk{radius_m};
    if (kind == 1)
        return choice < 2.0 ? draw.fourier(radius_m, 0.25)
                            : clover(radius_m, choice < 3.0 ? 3 : 4, draw.between(0.3, 0.6));
    if (choice < 1.0)
        return star(radius_m, 5, 0.35);
    if (choice < 2.0)
        return horseshoe(radius_m);
    return draw.polygon(radius_m, choice < 3.0 ? 4 : 9);
}

FacePair drawPair(Draw& draw, int sourceKind, int objectKind, int variety) {
    const double ratio = std::exp(draw.between(-std::log(50.0), std::log(50.0)));
    const double r1 = 0.1, r2 = 0.1 * ratio;
    const double large = std::max(r1, r2), small = std::min(r1, r2);
    FacePair pair{drawShape(draw, sourceKind, r1), drawShape(draw, objectKind, r2), Pose::Identity(), small};
    const double azimuth = draw.between(-kPi, kPi);
    const Pose around = poseAt(0, 0, 0, 0, 0, azimuth);
    const Pose spin = poseAt(0, 0, 0, 0, 0, draw.between(-kPi, kPi));
    switch (variety % 4) {
    case 0: // above, a little tilted
        pair.X_SO = poseFromRotationVector({draw.between(-1.0, 1.0) * large, draw.between(-1.0, 1.0) * large,
                                            draw.between(0.3, 1.5) * large},
                                           draw.vector(0.3));
        break;
    case 1: // beside, leaning towards it: the object dips, and where it is large cuts the source too
        pair.X_SO = around * poseAt(large * draw.between(0.4, 1.6), 0, small * draw.between(-0.5, 0.9), 0,
                                    draw.between(0.6, 2.0), 0);
        break;
    case 2: // close to the larger's plane
        pair.X_SO = around * poseAt(large * draw.between(0.0, 1.2), 0, small * draw.between(0.2, 2.0), 0,
                                    draw.between(-1.5, 1.5), 0);
        break;
    default:
        pair.X_SO = poseFromRotationVector(draw.vector(1.5 * large), draw.vector(2.5));
    }
    pair.X_SO = pair.X_SO * spin;
    return pair;
}

Shape movedInPlane(const Shape& shape, std::complex<double> shift, double angle) {
    const std::complex<double> turn = std::polar(1.0, angle);
    if (const auto* polygon = std::get_if<Contour>(&shape)) {
        Contour result;
        for (const Eigen::Vector2d& p : polygon->points_m) {
            const auto q = shift + turn * std::complex(p.x(), p.y());
            result.points_m.emplace_back(q.real(), q.imag());
        }
        return result;
    }
    if (const auto* fourier = std::get_if<FourierContour>(&shape)) {
        auto c = fourier->coefficients();
        for (auto& one : c)
            one *= turn;
        c[c.size() / 2] += shift;
        return FourierContour(c);
    }
    return shape;
}

Shape scaled(const Shape& shape, double factor) {
    if (const auto* disk = std::get_if<Disk>(&shape))
        return Disk{factor * disk->radius_m};
    if (const auto* fourier = std::get_if<FourierContour>(&shape)) {
        auto c = fourier->coefficients();
        for (auto& one : c)
            one *= factor;
        return FourierContour(c);
    }
    Contour result = std::get<Contour>(shape);
    for (Eigen::Vector2d& p : result.points_m)
        p *= factor;
    return result;
}

FacePair exchanged(const FacePair& pair) {
    const Pose flip = poseAt(0, 0, 0, kPi);
    return {mirrored(pair.object), mirrored(pair.source), flip * pair.X_SO.inverse() * flip, pair.size_m};
}

bool runThroughEachOther(const FacePair& pair) {
    const Eigen::Vector3d n = pair.X_SO.linear().col(2), up = Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d direction = n.cross(up).normalized();
    const auto a = crossings(pair.source, Pose::Identity(), pair.X_SO.translation(), n, direction);
    const auto b = crossings(pair.object, pair.X_SO, Eigen::Vector3d::Zero(), up, direction);
    for (std::size_t i = 0; i + 1 < a.size(); i += 2)
        for (std::size_t k = 0; k + 1 < b.size(); k += 2)
            if (std::max(a[i], b[k]) < std::min(a[i + 1], b[k + 1]))
                return true;
    return false;
}

} // namespace bask::test
