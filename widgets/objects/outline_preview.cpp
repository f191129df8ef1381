#include "widgets/objects/outline_preview.h"

#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>

#include <cmath>

namespace bask {
namespace {

constexpr double kMargin = 14.0;
constexpr int kCurvePoints = 720;

QColor faded(const QPalette& palette, double weight) {
    return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), weight);
}

} // namespace

Contour registered(const Contour& raw, const Shape& shape) {
    const auto* series = outlineAs<FourierContour>(shape);
    if (series == nullptr || raw.points_m.empty())
        return raw;
    // The least-squares constant term is the mean over arc length, so the two means coincide.
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double length = 0.0;
    for (std::size_t i = 0; i < raw.points_m.size(); ++i) {
        const Eigen::Vector2d& a = raw.points_m[i];
        const Eigen::Vector2d& b = raw.points_m[(i + 1) % raw.points_m.size()];
        const double edge = (b - a).norm();
        sum += 0.5 * edge * (a + b);
        length += edge;
    }
    const std::complex<double> c0 = series->coefficient(0);
    const Eigen::Vector2d shift = Eigen::Vector2d(c0.real(), c0.imag()) - sum / length;
    Contour moved = raw;
    for (Eigen::Vector2d& p : moved.points_m)
        p += shift;
    return moved;
}

OutlinePreview::OutlinePreview(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    retranslate();
}

void OutlinePreview::setObject(const QString& name, const Shape& shape, const Contour& raw,
                               const QColor& color) {
    m_name = name;
    m_used_mm = outline_mm(shape, kCurvePoints);
    m_raw_mm = polygon_mm(registered(raw, shape));
    m_color = color;
    const auto* series = outlineAs<FourierContour>(shape);
    m_harmonics = series != nullptr ? series->harmonics() : 0;
    retranslate();
    update();
}

void OutlinePreview::clear() {
    m_name.clear();
    m_used_mm.clear();
    m_raw_mm.clear();
    m_harmonics = 0;
    retranslate();
    update();
}

void OutlinePreview::retranslate() {
    setAccessibleName(tr("Outline"));
    const QRectF box = m_used_mm.boundingRect();
    setAccessibleDescription(m_used_mm.isEmpty() ? QString()
                                                 : tr("%1, %2 mm wide and %3 mm high")
                                                       .arg(m_name, QLocale().toString(box.width(), 'f', 1),
                                                            QLocale().toString(box.height(), 'f', 1)));
}

void OutlinePreview::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

void OutlinePreview::paintGrid(QPainter& painter, const QTransform& map) const {
    const double pixelsPerMm = map.m11();
    const double step = niceLength(std::max(60.0 / pixelsPerMm, 1e-6));
    const QRectF visible = map.inverted().mapRect(QRectF(rect()));
    painter.setPen(QPen(faded(palette(), 0.09), 1.0));
    for (double x = std::ceil(visible.left() / step) * step; x <= visible.right(); x += step)
        painter.drawLine(QLineF(map.map(QPointF(x, visible.top())), map.map(QPointF(x, visible.bottom()))));
    for (double y = std::ceil(visible.top() / step) * step; y <= visible.bottom(); y += step)
        painter.drawLine(QLineF(map.map(QPointF(visible.left(), y)), map.map(QPointF(visible.right(), y))));
}

void OutlinePreview::paintLegend(QPainter& painter, const QRectF& area) const {
    const double line = fontMetrics().height() + 3.0;
    QPointF at(area.left(), area.top() + line / 2.0);
    const auto entry = [&](const QPen& pen, const QString& text) {
        painter.setPen(pen);
        painter.drawLine(at, at + QPointF(22.0, 0.0));
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(QRectF(at.x() + 30.0, at.y() - line / 2.0, area.width() - 30.0, line),
                         Qt::AlignLeft | Qt::AlignVCenter, text);
        at += QPointF(0.0, line);
    };
    if (!m_raw_mm.isEmpty())
        entry(QPen(faded(palette(), 0.8), 1.2, Qt::DashLine),
              tr("Imported outline, %1 points").arg(m_raw_mm.size()));
    entry(QPen(m_color, 2.2),
          m_harmonics > 0 ? tr("Fourier outline, %1").arg(harmonicsText(m_harmonics)) : tr("Outline used"));
}

void OutlinePreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QRectF area = QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
    if (m_used_mm.isEmpty()) {
        painter.setPen(faded(palette(), 0.65));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Drop a drawing, a CSV or a picture of a silhouette here, or add a disk."));
        return;
    }
    const double legend = 2.0 * (fontMetrics().height() + 3.0) + 6.0;
    const QRectF view = area.adjusted(0.0, legend, 0.0, -fontMetrics().height() - 14.0);
    QRectF content = m_used_mm.boundingRect().united(m_raw_mm.boundingRect());
    const QTransform map = fitted(content, view);
    paintGrid(painter, map);

    QColor fill = m_color;
    fill.setAlphaF(0.16f);
    painter.setBrush(fill);
    painter.setPen(QPen(m_color, 2.2));
    painter.drawPolygon(map.map(m_used_mm));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(faded(palette(), 0.8), 1.2, Qt::DashLine));
    painter.drawPolygon(map.map(m_raw_mm));

    const QPointF centre = map.map(QPointF(0.0, 0.0));
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    painter.drawLine(centre - QPointF(7.0, 0.0), centre + QPointF(7.0, 0.0));
    painter.drawLine(centre - QPointF(0.0, 7.0), centre + QPointF(0.0, 7.0));

    paintLegend(painter, area);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    paintScaleBar(painter, area, map.m11());
    const QRectF box = m_used_mm.boundingRect();
    painter.drawText(
        area, Qt::AlignRight | Qt::AlignBottom,
        tr("%1 mm \u00d7 %2 mm")
            .arg(QLocale().toString(box.width(), 'f', 1), QLocale().toString(box.height(), 'f', 1)));
}

} // namespace bask
