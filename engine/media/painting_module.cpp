// bask-painting.so: see painting.h.

#include "engine/media/painting.h"

#include <QBuffer>
#include <QImage>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QSvgRenderer>

namespace bask {
namespace {

PaintedPoint::Kind kindOf(QPainterPath::ElementType type) {
    switch (type) {
    case QPainterPath::MoveToElement:
        return PaintedPoint::Kind::Move;
    case QPainterPath::LineToElement:
        return PaintedPoint::Kind::Line;
    default:
        return PaintedPoint::Kind::Curve;
    }
}

/// Paint engine that keeps shapes instead of drawing them. QtSvg paints each shape twice: first what is
/// filled, without a pen (also when nothing is), then its stroke.
class Recorder final : public QPaintEngine {
public:
    explicit Recorder(PaintedShapes& shapes) : QPaintEngine(AllFeatures), m_shapes(shapes) {}

    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState&) override {}
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawTextItem(const QPointF&, const QTextItem&) override {}
    Type type() const override { return User; }

    void drawPath(const QPainterPath& path) override {
        if (m_shapes.wants(path.elementCount()))
            paint(path, true, false);
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        if (count < 1 || !m_shapes.wants(1)) // whatever their number
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
        if (!(painter()->opacity() > 0.0))
            return;
        const QTransform transform = painter()->combinedTransform();
        const bool same = stroked && !filled && path == m_filled && transform == m_transform;
        m_filled = filled ? path : QPainterPath();
        m_transform = transform;
        if ((!filled && !stroked) || same)
            return;
        std::vector<PaintedPoint> points;
        points.reserve(static_cast<std::size_t>(path.elementCount()));
        for (int k = 0; k < path.elementCount(); ++k) {
            const QPainterPath::Element element = path.elementAt(k);
            const QPointF at = transform.map(QPointF(element));
            points.push_back({kindOf(element.type), {at.x(), at.y()}});
        }
        m_shapes.add(points, filled || closed);
    }

    PaintedShapes& m_shapes;
    QPainterPath m_filled; // of the shape whose stroke may come
    QTransform m_transform;
};

class RecorderDevice final : public QPaintDevice {
public:
    explicit RecorderDevice(PaintedShapes& shapes) : m_recorder(shapes) {}
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

QPolygonF polygonOf(const std::vector<Eigen::Vector2d>& points_px) {
    QPolygonF polygon;
    for (const Eigen::Vector2d& p : points_px)
        polygon << QPointF(p.x(), p.y());
    return polygon;
}

void paintLayer(QPainter& painter, const PictureLayer& layer) {
    QColor ink(layer.ink[0], layer.ink[1], layer.ink[2]);
    painter.setPen(QPen(ink, layer.width_px));
    ink.setAlpha(layer.fillOpacity.value_or(0));
    painter.setBrush(layer.fillOpacity ? QBrush(ink) : QBrush(Qt::NoBrush));
    QPainterPath path; // odd-even
    for (const auto& line_px : layer.lines_px) {
        path.addPolygon(polygonOf(line_px));
        if (layer.isClosed)
            path.closeSubpath();
    }
    painter.drawPath(path);
}

class QtPainting final : public Painting {
public:
    bool svg(const std::string& xml, PaintedShapes& out) const override {
        QSvgRenderer renderer;
#if QT_VERSION >= QT_VERSION_CHECK(6, 7, 0)
        // Whoever asks has limits. Qt's own leave out, in silence, what would take long to fill.
        renderer.setOptions(QtSvg::AssumeTrustedSource);
#endif
        if (!renderer.load(QByteArray::fromRawData(xml.data(), static_cast<qsizetype>(xml.size()))))
            return false;
        RecorderDevice device(out);
        const QRectF page(0, 0, RecorderDevice::kSide, RecorderDevice::kSide);
        renderer.setViewBox(page);
        QPainter painter(&device);
        renderer.render(&painter, page);
        return true;
    }

    std::string png(int size_px, const std::string& software,
                    const std::vector<PictureLayer>& layers) const override {
        QImage image(size_px, size_px, QImage::Format_RGB32);
        image.fill(Qt::white);
        image.setText(QStringLiteral("Software"), QString::fromStdString(software));
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        for (const PictureLayer& layer : layers)
            paintLayer(painter, layer);
        painter.end();
        QByteArray bytes;
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        image.save(&buffer, "PNG");
        return bytes.toStdString();
    }
};

} // namespace
} // namespace bask

extern "C" const bask::Painting* baskPainting() {
    static const bask::QtPainting kPainting;
    return &kPainting;
}
