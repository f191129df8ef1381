#include "engine/shape/outline_file.h"

#include "engine/base/message_code.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

Eigen::AlignedBox2d boxOf(const FileOutline& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline.points_m)
        box.extend(p);
    return box;
}

} // namespace

double FileOutline::area_m2() const {
    return closed ? std::abs(contourArea(Contour{points_m})) : 0.0;
}

double FileOutline::perimeter_m() const {
    if (closed)
        return contourPerimeter(Contour{points_m});
    double length_m = 0.0;
    for (std::size_t k = 0; k + 1 < points_m.size(); ++k)
        length_m += (points_m[k + 1] - points_m[k]).norm();
    return length_m;
}

void OutlineFile::enlarge(double factor) {
    for (FileOutline& outline : outlines)
        for (Eigen::Vector2d& p : outline.points_m)
            p *= factor;
}

void OutlineFile::arrange() {
    struct Sized {
        FileOutline outline;
        double area_m2, length_m;
        Eigen::AlignedBox2d box;
    };
    std::vector<Sized> sized;
    for (FileOutline& outline : outlines) {
        const double area_m2 = outline.area_m2(), length_m = outline.perimeter_m();
        const Eigen::AlignedBox2d box = boxOf(outline);
        sized.push_back({std::move(outline), area_m2, length_m, box});
    }
    std::ranges::stable_sort(sized, [](const Sized& a, const Sized& b) {
        if (a.outline.closed != b.outline.closed)
            return a.outline.closed;
        return a.outline.closed ? a.area_m2 > b.area_m2 : a.length_m > b.length_m;
    });
    for (std::size_t i = 0; i < sized.size(); ++i) {
        FileOutline& inner = sized[i].outline;
        inner.hole = false;
        inner.holeIn.reset();
        for (std::size_t k = 0; k < i && inner.closed; ++k) // a larger one only can hold it
            if (sized[k].outline.region == inner.region && sized[k].box.contains(sized[i].box) &&
                encloses(sized[k].outline.points_m, inner.points_m.front())) {
                inner.hole = !inner.hole;
                inner.holeIn = k; // the last is the smallest that holds it
            }
        if (!inner.hole)
            inner.holeIn.reset();
    }
    outlines.clear();
    for (Sized& each : sized)
        outlines.push_back(std::move(each.outline));
}

Result<Contour> contourOf(const FileOutline& outline, const std::string& where) {
    if (!outline.closed && outline.points_m.size() > 1) {
        const double gap_m = (outline.points_m.front() - outline.points_m.back()).norm();
        return Error{MessageCode::ContourOpen, where, {formatNumber(gap_m * 1e3), "0"}};
    }
    return makeContour(outline.points_m, where);
}

} // namespace bask
