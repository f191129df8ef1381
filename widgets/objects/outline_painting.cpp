#include "widgets/objects/outline_painting.h"

#include "engine/base/units.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {

QPolygonF outline_mm(const Shape& shape, int n) {
    QPolygonF polygon;
    for (const Eigen::Vector2d& p : shapeOutline(shape, n))
        polygon << QPointF(p.x() * kMmPerM, p.y() * kMmPerM);
    return polygon;
}

QPolygonF polygon_mm(const Contour& contour) {
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(contour.points_m.size()));
    for (const Eigen::Vector2d& p : contour.points_m)
        polygon << QPointF(p.x() * kMmPerM, p.y() * kMmPerM);
    return polygon;
}

QPainterPath face_mm(const std::vector<std::vector<Eigen::Vector2d>>& rings_m) {
    QPainterPath face;
    for (const std::vector<Eigen::Vector2d>& ring : rings_m) {
        face.addPolygon(polygon_mm(Contour{ring}));
        face.closeSubpath();
    }
    return face;
}

QTransform fitted(const QRectF& content_mm, const QRectF& view) {
    const double width = std::max(content_mm.width(), 1e-3);
    const double height = std::max(content_mm.height(), 1e-3);
    const double scale = std::max(std::min(view.width() / width, view.height() / height), 1e-6);
    QTransform transform;
    transform.translate(view.center().x(), view.center().y());
    transform.scale(scale, -scale);
    transform.translate(-content_mm.center().x(), -content_mm.center().y());
    return transform;
}

double niceLength(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-9))));
    const double lead = value / decade;
    return decade * (lead >= 5.0 ? 5.0 : lead >= 2.0 ? 2.0 : 1.0);
}

QString harmonicsText(int harmonics) {
    return harmonics == 1 ? QCoreApplication::translate("OutlinePainting", "1 harmonic")
                          : QCoreApplication::translate("OutlinePainting", "%1 harmonics").arg(harmonics);
}

QString holesText(std::size_t holes) {
    return holes == 1 ? QCoreApplication::translate("OutlinePainting", "1 hole")
                      : QCoreApplication::translate("OutlinePainting", "%1 holes").arg(holes);
}

QString lengthText_mm(double length_mm) {
    return QCoreApplication::translate("OutlinePainting", "%1 mm").arg(QLocale().toString(length_mm, 'g', 4));
}

void paintScaleBar(QPainter& painter, const QRectF& view, double pixelsPerMm) {
    const double length_mm = niceLength(view.width() / 5.0 / pixelsPerMm);
    const double length = length_mm * pixelsPerMm;
    const QPointF left(view.left(), view.bottom() - 1.0);
    painter.drawLine(left, left + QPointF(length, 0.0));
    painter.drawLine(left + QPointF(0.0, -5.0), left);
    painter.drawLine(left + QPointF(length, -5.0), left + QPointF(length, 0.0));
    painter.drawText(left + QPointF(0.0, -8.0), lengthText_mm(length_mm));
}

} // namespace bask
