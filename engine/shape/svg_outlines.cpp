#include "engine/shape/svg_outlines.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/svg_filter.h"

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bask {
namespace {

constexpr double kMetresPerPixel = 0.0254 / 96.0;
constexpr double kSizeTolerance = 1e-4; // of an outline's size: small ones keep their form

using Points = std::vector<Eigen::Vector2d>;

/// Makes flattened outlines of painted paths, until there are too many.
class Outlines {
public:
    Outlines(const Eigen::Affine2d& toPixels, double tolerance_m) : m_tolerance_m(tolerance_m) {
        m_toMetres = Eigen::Scaling(kMetresPerPixel, -kMetresPerPixel) * toPixels;
    }

    /// `closed`: its subpaths are, however they end.
    void add(const QPainterPath& path, const QTransform& transform, bool closed) {
        for (int from = 0, to = 1; from < path.elementCount() && !m_refusal; from = to++) {
            while (to < path.elementCount() && !path.elementAt(to).isMoveTo())
                ++to;
            addSubpath(path, from, to, transform, closed);
        }
        ++m_region;
    }

    bool full() const { return m_refusal.has_value(); }
    const std::optional<Error>& refusal() const { return m_refusal; }
    std::vector<FileOutline>& outlines() { return m_outlines; }

    void refuse(Error error) {
        if (!m_refusal)
            m_refusal = std::move(error);
    }

private:
    // Elements [from, to): a move, then lines and curves.
    void addSubpath(const QPainterPath& path, int from, int to, const QTransform& transform, bool closed) {
        Points controls_m;
        Eigen::AlignedBox2d box;
        for (int k = from; k < to; ++k) {
            const QPointF p = transform.map(QPointF(path.elementAt(k)));
            controls_m.push_back(m_toMetres * Eigen::Vector2d(p.x(), p.y()));
            box.extend(controls_m.back());
            if (!(controls_m.back().cwiseAbs().maxCoeff() <= kLargestSvgOutline_m))
                return refuse({MessageCode::DrawingTooWide, {}, {formatNumber(kLargestSvgOutline_m)}});
        }
        const double tolerance_m = std::min(m_tolerance_m, kSizeTolerance * box.diagonal().norm());
        FileOutline outline;
        for (int k = 0; k < to - from; ++k) {
            if (path.elementAt(from + k).isCurveTo()) {
                addCurve(&controls_m[k - 1], tolerance_m, outline.points_m);
                k += 2;
            } else {
                addPoint(controls_m[k], outline.points_m);
            }
            if (m_refusal)
                return;
        }
        finish(std::move(outline), closed, tolerance_m);
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

/// Paint engine that keeps shapes instead of drawing them. QtSvg paints each shape twice: first what is
/// filled, without a pen (also when nothing is), then its stroke.
class Recorder final : public QPaintEngine {
public:
    explicit Recorder(Outlines& outlines) : QPaintEngine(AllFeatures), m_outlines(outlines) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawTextItem(const QPointF&, const QTextItem&) override {}
    Type type() const override { return User; }

    void drawPath(const QPainterPath& path) override {
        if (path.elementCount() > kMaxSvgPathParts)
            m_outlines.refuse({MessageCode::PathTooLong, {}, {std::to_string(kMaxSvgPathParts)}});
        paint(path, true, false);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        if (m_outlines.full() || count < 1)
            return;
        QPainterPath path(points[0]);
        for (int k = 1; k < count; ++k)
            path.lineTo(points[k]);
        paint(path, mode != PolylineMode, mode != PolylineMode);
    }
    using QPaintEngine::drawPolygon;

private:
    void paint(const QPainterPath& path, bool fillable, bool closed) {
        const QPen pen = painter()->pen();
        const bool filled = fillable && painter()->brush() != Qt::NoBrush;
        const bool stroked = pen.style() != Qt::NoPen && pen.brush() != Qt::NoBrush;
        if (m_outlines.full() || !(painter()->opacity() > 0.0))
            return;
        const QTransform transform = painter()->combinedTransform();
        const bool same = stroked && !filled && path == m_filled && transform == m_transform;
        m_filled = filled ? path : QPainterPath();
        m_transform = transform;
        if ((filled || stroked) && !same)
            m_outlines.add(path, transform, filled || closed);
    }

    Outlines& m_outlines;
    QPainterPath m_filled; // of the shape whose stroke may come
    QTransform m_transform;
};

class RecorderDevice final : public QPaintDevice {
public:
    explicit RecorderDevice(Outlines& outlines) : m_recorder(outlines) {}
    QPaintEngine* paintEngine() const override { return &m_recorder; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
        case PdmHeight:
            return kSide;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmDevicePixelRatio:
            return 1;
        case PdmDevicePixelRatioScaled:
            return static_cast<int>(devicePixelRatioFScale());
        default:
            return 0;
        }
    }

public:
    static constexpr int kSide = 1000; // of page and view alike, so that QtSvg scales nothing

private:
    mutable Recorder m_recorder;
};

Result<OutlineFile> painted(const PlainSvg& plain, const std::string& where, double tolerance_m) {
    QSvgRenderer renderer;
#if QT_VERSION >= QT_VERSION_CHECK(6, 7, 0)
    // The limits are svg_filter's and ours. Qt's own leave out, in silence, what would take long to fill.
    renderer.setOptions(QtSvg::AssumeTrustedSource);
#endif
    if (!renderer.load(QByteArray::fromRawData(plain.xml.data(), static_cast<qsizetype>(plain.xml.size()))))
        return Error{MessageCode::NotSvg, where};
    Outlines outlines(plain.toPixels, tolerance_m);
    RecorderDevice device(outlines);
    const QRectF page(0, 0, RecorderDevice::kSide, RecorderDevice::kSide);
    renderer.setViewBox(page);
    QPainter painter(&device);
    renderer.render(&painter, page);
    painter.end();
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
