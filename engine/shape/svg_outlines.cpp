#include "engine/shape/svg_outlines.h"

#include "engine/base/message_code.h"
#include "engine/media/painting.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/svg_filter.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kMetresPerPixel = 0.0254 / 96.0;
constexpr double kSizeTolerance = 1e-4; // of an outline's size: small ones keep their form

using Points = std::vector<Eigen::Vector2d>;

/// Makes flattened outlines of painted paths, until there are too many.
class Outlines final : public PaintedShapes {
public:
    Outlines(const Eigen::Affine2d& toPixels, double tolerance_m) : m_tolerance_m(tolerance_m) {
        m_toMetres = Eigen::Scaling(kMetresPerPixel, -kMetresPerPixel) * toPixels;
    }

    bool wants(int points) override {
        if (points > kMaxSvgPathParts)
            refuse({MessageCode::PathTooLong, {}, {std::to_string(kMaxSvgPathParts)}});
        return !m_refusal;
    }

    void add(const std::vector<PaintedPoint>& path, bool isClosed) override {
        for (std::size_t from = 0, to = 1; from < path.size() && !m_refusal; from = to++) {
            while (to < path.size() && path[to].kind != PaintedPoint::Kind::Move)
                ++to;
            addSubpath(std::span(path).subspan(from, to - from), isClosed);
        }
        ++m_region;
    }

    const std::optional<Error>& refusal() const { return m_refusal; }
    std::vector<FileOutline>& outlines() { return m_outlines; }

private:
    void refuse(Error error) {
        if (!m_refusal)
            m_refusal = std::move(error);
    }

    // A move, then lines and curves.
    void addSubpath(std::span<const PaintedPoint> path, bool isClosed) {
        Points controls_m;
        Eigen::AlignedBox2d box;
        for (const PaintedPoint& point : path) {
            controls_m.push_back(m_toMetres * point.at_px);
            box.extend(controls_m.back());
            if (!(controls_m.back().cwiseAbs().maxCoeff() <= kLargestSvgOutline_m))
                return refuse({MessageCode::DrawingTooWide, {}, {formatNumber(kLargestSvgOutline_m)}});
        }
        const double tolerance_m = std::min(m_tolerance_m, kSizeTolerance * box.diagonal().norm());
        FileOutline outline;
        for (std::size_t k = 0; k < path.size(); ++k) {
            if (path[k].kind == PaintedPoint::Kind::Curve) {
                addCurve(&controls_m[k - 1], tolerance_m, outline.points_m);
                k += 2;
            } else {
                addPoint(controls_m[k], outline.points_m);
            }
            if (m_refusal)
                return;
        }
        finish(std::move(outline), isClosed, tolerance_m);
    }

    void addPoint(const Eigen::Vector2d& point_m, Points& points_m) {
        if (!points_m.empty() && points_m.back() == point_m)
            return;
        points_m.push_back(point_m);
        if (++m_points > kMaxSvgPoints)
            refuse({MessageCode::DrawingTooFull, {}});
    }

    // Chords of equal parameter steps are off by at most 3/4 of the largest second difference over the steps'
    // square.
    void addCurve(const Eigen::Vector2d* b, double tolerance_m, Points& points_m) {
        const double bend_m = std::max((b[0] - 2.0 * b[1] + b[2]).norm(), (b[1] - 2.0 * b[2] + b[3]).norm());
        const double steps =
            std::clamp(std::ceil(std::sqrt(0.75 * bend_m / tolerance_m)), 1.0, 1.0 * kMaxSvgPoints);
        for (int k = 1; k <= steps && !m_refusal; ++k) {
            const double t = k / steps, u = 1.0 - t;
            addPoint(k == steps ? b[3]
                                : Eigen::Vector2d(u * u * u * b[0] + 3.0 * u * u * t * b[1] +
                                                  3.0 * u * t * t * b[2] + t * t * t * b[3]),
                     points_m);
        }
    }

    void finish(FileOutline outline, bool closed, double tolerance_m) {
        Points& points_m = outline.points_m;
        if (points_m.size() < 2)
            return;
        const bool meets = points_m.size() > 3 && (points_m.front() - points_m.back()).norm() <= tolerance_m;
        if (meets)
            points_m.pop_back();
        outline.closed = points_m.size() > 2 && (closed || meets);
        outline.region = m_region;
        m_outlines.push_back(std::move(outline));
        if (m_outlines.size() > kMaxSvgOutlines)
            refuse({MessageCode::DrawingTooFull, {}});
    }

    Eigen::Affine2d m_toMetres;
    double m_tolerance_m;
    std::vector<FileOutline> m_outlines;
    int m_region = 0, m_points = 0;
    std::optional<Error> m_refusal;
};

Result<OutlineFile> painted(const PlainSvg& plain, const std::string& where, double tolerance_m) {
    Outlines outlines(plain.toPixels, tolerance_m);
    try {
        if (!painting().svg(plain.xml, outlines))
            return Error{MessageCode::NotSvg, where};
    } catch (const std::runtime_error&) { // a part of the program is not there, which has been said
        return Error{MessageCode::NotSvg, where};
    }
    if (outlines.refusal())
        return Error{outlines.refusal()->code(), where, outlines.refusal()->message.args};
    if (outlines.outlines().empty())
        return Error{MessageCode::NoOutline, where};
    OutlineFile file;
    file.outlines = std::move(outlines.outlines());
    file.arrange();
    return file;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list;
}

} // namespace

Result<OutlineFile> svgOutlines(const std::string& bytes, const std::string& where, double tolerance_m) {
    if (!(tolerance_m > 0.0) || !std::isfinite(tolerance_m))
        return Error{MessageCode::ValueNotPositive, where, {formatNumber(tolerance_m)}};
    if (bytes.size() > kLargestSvg)
        return Error{MessageCode::DrawingTooFull, where};
    const auto plain = plainSvg(bytes, where);
    if (!plain)
        return plain.error();
    auto file = painted(*plain, where, tolerance_m);
    if (!file)
        return file;
    file->unit = plain->unit;
    if (plain->unit == "px")
        file->warnings.push_back({MessageCode::SvgSizeInPixels, {}});
    if (!plain->unread.empty())
        file->warnings.push_back({MessageCode::ElementsUnread, {listed(plain->unread)}});
    return file;
}

Result<OutlineFile> readSvgOutlines(const std::string& path, double tolerance_m) {
    const auto bytes = readFileBytes(path, kLargestSvg);
    if (!bytes)
        return bytes.error();
    return svgOutlines(*bytes, path, tolerance_m);
}

} // namespace bask
