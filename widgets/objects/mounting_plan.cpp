#include "widgets/objects/mounting_plan.h"

#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

namespace bask {

QPolygonF mountedOutline_mm(const ObjectSpec& object) {
    const Pose X_EO = poseFromCoordinates(object.mounting);
    QPolygonF polygon;
    for (const Eigen::Vector2d& p : shapeOutline(object.shape, 240)) {
        const Eigen::Vector3d q = X_EO * Eigen::Vector3d(p.x(), p.y(), 0.0);
        polygon << QPointF(1000.0 * q.x(), 1000.0 * q.y());
    }
    return polygon;
}

MountingPlan::MountingPlan(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    retranslate();
}

void MountingPlan::setObjects(const std::vector<ObjectSpec>& objects, int selected) {
    m_items.clear();
    for (const ObjectSpec& object : objects)
        m_items.push_back({QString::fromStdString(object.name), mountedOutline_mm(object)});
    m_selected = selected;
    update();
}

void MountingPlan::retranslate() {
    setAccessibleName(tr("Plan of the objects on the end-effector"));
    setToolTip(tr("The objects on the end-effector, to scale; click one to select it."));
}

void MountingPlan::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

QTransform MountingPlan::map() const {
    QRectF content(-10.0, -10.0, 20.0, 20.0);
    for (const Item& item : m_items)
        content = content.united(item.outline_mm.boundingRect());
    const double line = fontMetrics().height();
    return fitted(content, QRectF(rect()).adjusted(12.0, 12.0, -12.0, -line - 14.0));
}

void MountingPlan::mousePressEvent(QMouseEvent* event) {
    const QTransform map = this->map();
    for (std::size_t i = 0; i < m_items.size(); ++i)
        if (map.map(m_items[i].outline_mm).containsPoint(event->position(), Qt::OddEvenFill))
            emit objectClicked(static_cast<int>(i));
}

void MountingPlan::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    painter.setPen(hairline(dark));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);

    const QTransform map = this->map();
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        const int index = static_cast<int>(i);
        QColor color = seriesColor(index, dark);
        painter.setPen(QPen(color, index == m_selected ? 2.4 : 1.2));
        color.setAlphaF(index == m_selected ? 0.28f : 0.10f);
        painter.setBrush(color);
        painter.drawPolygon(map.map(m_items[i].outline_mm));
    }
    const QPointF origin = map.map(QPointF(0.0, 0.0));
    painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
    painter.drawLine(origin, origin + QPointF(26.0, 0.0));
    painter.drawLine(origin, origin - QPointF(0.0, 26.0));
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawEllipse(origin, 2.5, 2.5);
    painter.drawText(origin + QPointF(29.0, 4.0), QStringLiteral("x"));
    painter.drawText(origin + QPointF(-3.0, -29.0), QStringLiteral("y"));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(secondaryText(dark), 1.2));
    paintScaleBar(painter, QRectF(rect()).adjusted(10.0, 0.0, -10.0, -8.0), map.m11());
}

} // namespace bask
