#include "engine/model/shape_check.h"

#include "engine/base/edge_units.h"
#include "engine/base/message_code.h"
#include "engine/model/coordinate_range.h"
#include "engine/shape/winding.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using std::to_string;

constexpr std::size_t kMaxOutlinePoints = 200'000;

void checkPoints(Checker& check, const std::string& where, const std::vector<Eigen::Vector2d>& points) {
    if (points.size() > kMaxOutlinePoints)
        check.range(where, static_cast<double>(points.size()), 3.0, static_cast<double>(kMaxOutlinePoints),
                    "points");
    for (std::size_t i = 0; i < points.size() && !check.failed(); ++i) {
        if (!points[i].allFinite())
            check.fail(MessageCode::ContourNotFinite, where, {"point " + to_string(i + 1)});
    }
}

void checkCoefficients(Checker& check, const std::string& where, const FourierContour& contour) {
    const int harmonics = contour.harmonics();
    if (contour.coefficients().empty() || harmonics < 1 || harmonics > kMaxHarmonics)
        return check.fail(MessageCode::HarmonicsOutOfRange, where,
                          {to_string(std::max(harmonics, 0)), "1", to_string(kMaxHarmonics)});
    for (const auto& c : contour.coefficients()) {
        if (!std::isfinite(c.real()) || !std::isfinite(c.imag()))
            return check.fail(MessageCode::ContourNotFinite, where, {"a coefficient"});
    }
}

} // namespace

void checkShape(Checker& check, const std::string& path, const Shape& shape, const ContourOrigin& origin,
                double max_m) {
    if (const auto* disk = outlineAs<Disk>(shape)) {
        check.positive(path + ".radius_m", disk->radius_m, max_m, "m");
    } else if (const auto* fourier = outlineAs<FourierContour>(shape)) {
        checkCoefficients(check, path + ".coefficients", *fourier);
    } else {
        const auto& points = outlineAs<Contour>(shape)->points_m;
        if (points.size() < 3)
            check.fail(MessageCode::ContourTooFewPoints, path + ".points_m", {to_string(points.size()), "3"});
        checkPoints(check, path + ".points_m", points);
    }
    checkPoints(check, path + ".outline_m", origin.outline.points_m);
    check.range(path + ".harmonics", origin.harmonics, 0.0, kMaxHarmonics);
    if (!check.failed())
        check.take(checkHoles(shape, path + ".holes_m"));
    if (!check.failed())
        check.take(checkHoles(withHoles(origin.outline, origin.holes), path + ".outline_holes_m"));
    if (check.failed())
        return;
    if (!(shapeArea(shape) > 0.0))
        return check.fail(MessageCode::ContourZeroArea, path);
    const double radius_m = shapeRadius(shape);
    if (!(radius_m <= max_m) || radius_m < kMinShapeRadius_m)
        return check.fail(MessageCode::ValueOutOfRange, path,
                          {"a radius of " + formatNumber(radius_m), formatNumber(kMinShapeRadius_m),
                           formatNumber(max_m), "m"});
    const auto* fourier = outlineAs<FourierContour>(shape);
    const double uneven = fourier ? unevenShare(*fourier) : 0.0;
    if (uneven > kMaxUneven)
        return check.fail(MessageCode::SeriesUneven, path + ".coefficients",
                          {formatNumber(100.0 * uneven, 2)});
    const auto* polygon = outlineAs<Contour>(shape);
    std::size_t corners = polygon ? polygon->points_m.size() : 0;
    for (const Contour& hole : holesOf(shape))
        corners += hole.points_m.size();
    if (corners > kMaxCorners)
        check.fail(MessageCode::ValueOutOfRange, path + (polygon ? ".points_m" : ".holes_m"),
                   {to_string(corners), "3", to_string(kMaxCorners), "corners"});
}

void checkCoordinates(Checker& check, const std::string& path, const Vector6d& q, double max_cm,
                      bool unique) {
    for (int k = 0; k < 6 && !check.failed(); ++k) {
        const ValidRange range = coordinateRange(k, max_cm, unique);
        check.quantity(path, kCoordinateNames[static_cast<std::size_t>(k)], coordinateUnit(k), q[k],
                       range.min, range.max);
    }
}

} // namespace bask
