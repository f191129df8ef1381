#include "app/commands/fit_contour_report.h"

#include "engine/base/units.h"
#include "engine/media/painting.h"
#include "engine/shape/shape.h"

#include <nlohmann/json.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

Json pair(const Eigen::Vector2d& p, double scale = 1.0) {
    return {p.x() * scale, p.y() * scale};
}

Json ring(const Contour& contour, double scale = 1.0) {
    Json points = Json::array();
    for (const Eigen::Vector2d& p : contour.points_m)
        points.push_back(pair(p, scale));
    return points;
}

Eigen::AlignedBox2d boxOf(const std::vector<Eigen::Vector2d>& points) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : points)
        box.extend(p);
    return box;
}

std::vector<Eigen::Vector2d> pointsOf(const FourierFit& fit) {
    constexpr int kChords = 2048;
    std::vector<Eigen::Vector2d> points;
    for (int k = 0; k < kChords; ++k) {
        const std::complex<double> z = fit.contour.point(static_cast<double>(k) / kChords);
        points.push_back(fit.centre_m + Eigen::Vector2d(z.real(), z.imag()));
    }
    return points;
}

/// From metres to the pixels of a square picture, y up.
struct View {
    Eigen::Vector2d middle_m;
    double scale = 1.0; // px per m
    int size_px = 0;

    Eigen::Vector2d operator()(const Eigen::Vector2d& p_m) const {
        const Eigen::Vector2d d = scale * (p_m - middle_m);
        return {0.5 * size_px + d.x(), 0.5 * size_px - d.y()};
    }
    std::vector<Eigen::Vector2d> operator()(const std::vector<Eigen::Vector2d>& points_m) const {
        std::vector<Eigen::Vector2d> out;
        out.reserve(points_m.size());
        for (const Eigen::Vector2d& p : points_m)
            out.push_back((*this)(p));
        return out;
    }
};

PictureLayer gridOf(const View& view) {
    PictureLayer grid{.lines_px = {}, .isClosed = false, .ink = {0xdd, 0xdd, 0xdd}};
    const double width_m = view.size_px / view.scale;
    const double step_m = std::pow(10.0, std::floor(std::log10(width_m / 3.0)));
    const Eigen::Vector2d min = view.middle_m - Eigen::Vector2d::Constant(0.5 * width_m);
    for (const int axis : {0, 1})
        for (double k = std::ceil(min[axis] / step_m); k * step_m < min[axis] + width_m; ++k) {
            Eigen::Vector2d from = view(Eigen::Vector2d::Constant(k * step_m));
            from[1 - axis] = 0.0;
            Eigen::Vector2d to = from;
            to[1 - axis] = view.size_px;
            grid.lines_px.push_back({from, to});
        }
    return grid;
}

} // namespace

Json outlineList(const OutlineFile& file) {
    Json list = Json::array();
    for (const FileOutline& outline : file.outlines) {
        const Eigen::AlignedBox2d box = boxOf(outline.points_m);
        list.push_back(
            {{"index", list.size()},
             {"closed", outline.closed},
             {"area_mm2", outline.area_m2() * 1e6},
             {"perimeter_mm", outline.perimeter_m() * 1e3},
             {"bbox_mm",
              {box.min().x() * 1e3, box.min().y() * 1e3, box.max().x() * 1e3, box.max().y() * 1e3}},
             {"hole", outline.hole}});
    }
    return list;
}

Json fitReport(const PickedOutline& picked, const FourierFit& fit, const std::string& unit) {
    Json coefficients = Json::array(), sentences = Json::array(), holes_mm = Json::array();
    for (int j = -fit.contour.harmonics(); j <= fit.contour.harmonics(); ++j)
        coefficients.push_back({j, fit.contour.coefficient(j).real(), fit.contour.coefficient(j).imag()});
    for (const Message& warning : picked.warnings)
        sentences.push_back(describe(warning));
    for (const Contour& hole : picked.holes)
        holes_mm.push_back(ring(hole, kMmPerM));
    const Shape shape = shapeOfFit(fit, picked.holes);
    Json report{{"type", "fourier"},
                {"coefficients", std::move(coefficients)},
                {"area_mm2", fit.contour.area() * 1e6},
                {"net_area_mm2", shapeArea(shape) * 1e6},
                {"perimeter_mm", fit.contour.perimeter() * 1e3},
                {"rms_mm", fit.rms_m * 1e3},
                {"max_mm", fit.max_m * 1e3},
                {"hausdorff_mm", fit.hausdorff_m * 1e3},
                {"area_error", fit.areaError},
                {"centre_mm", pair(fit.centre_m, kMmPerM)},
                {"unit", unit},
                {"warnings", std::move(sentences)},
                {"outline", ring(picked.contour, kMmPerM)},
                {"holes", std::move(holes_mm)}};
    for (const Contour& hole : holesOf(shape))
        report["holes_m"].push_back(ring(hole));
    return report;
}

std::string fitPreview(const PickedOutline& picked, const FourierFit& fit) {
    constexpr int kSize_px = 1000;
    constexpr double kFilled = 0.85; // of the picture
    const std::vector<Eigen::Vector2d> series = pointsOf(fit);
    const Eigen::AlignedBox2d box = boxOf(picked.contour.points_m).merged(boxOf(series));
    const View view{box.center(), kFilled * kSize_px / box.sizes().maxCoeff(), kSize_px};
    PictureLayer face{.lines_px = {view(picked.contour.points_m)},
                      .ink = {0x55, 0x5f, 0x6b},
                      .width_px = 1.5,
                      .fillOpacity = 0x40};
    for (const Contour& hole : picked.holes)
        face.lines_px.push_back(view(hole.points_m));
    const PictureLayer fitted{.lines_px = {view(series)}, .ink = {0xd0, 0x2b, 0x2b}, .width_px = 2.0};
    return painting().png(kSize_px, kPreviewMark, {gridOf(view), face, fitted});
}

} // namespace bask
