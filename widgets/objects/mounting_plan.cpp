#include "widgets/objects/mounting_plan.h"

#include "engine/base/units.h"
#include "engine/session/mounting_check.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <cmath>

namespace bask {
namespace {

constexpr double kMmPerM = 1000.0;
constexpr double kSnap_mm = 5.0, kFineSnap_mm = 0.1;
constexpr double kSnap_deg = 5.0, kFineSnap_deg = 0.1;
constexpr double kHandleBeyond_px = 16.0;
constexpr double kHandleRadius_px = 5.0;
constexpr double kHandleReach_px = 9.0;

QPainterPath face_mm(const ObjectSpec& object) {
    return bask::face_mm(mountedRings(object, 240));
}

QPointF centre_mm(const Vector6d& mounting) {
    return {kMmPerM * mounting[kX], kMmPerM * mounting[kY]};
}

double snapped(double value, double step) {
    return step * std::round(value / step);
}

/// Within -180 to 180 degrees.
double turned_rad(double angle_deg) {
    return radFromDeg(std::remainder(angle_deg, 360.0));
}

} // namespace

MountingPlan::MountingPlan(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    retranslate();
}

void MountingPlan::setObjects(const std::vector<ObjectSpec>& objects, int selected,
                              const std::set<int>& remarked, double reach_m) {
    m_objects = objects;
    m_remarked = remarked;
    m_selected = selected < static_cast<int>(objects.size()) ? selected : -1;
    m_reach_m = reach_m;
    m_drag.reset();
    update();
}

void MountingPlan::setReadOnly(bool readOnly) {
    m_readOnly = readOnly;
    m_drag.reset();
    update();
}

void MountingPlan::retranslate() {
    setAccessibleName(tr("Plan of the objects on the end-effector"));
    setToolTip(
        tr("The objects on the end-effector, to scale. Drag one to move it, its handle to turn it; with Alt "
           "in fine steps. Arrow keys move the selected one, Page Up and Page Down turn it."));
}

void MountingPlan::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

QTransform MountingPlan::map() const {
    if (m_drag)
        return m_drag->map;
    QRectF content(-10.0, -10.0, 20.0, 20.0);
    for (const ObjectSpec& object : m_objects)
        content = content.united(face_mm(object).boundingRect());
    const double margin = 12.0 + kHandleBeyond_px + kHandleRadius_px;
    const double line = fontMetrics().height();
    return fitted(content, QRectF(rect()).adjusted(margin, margin, -margin, -line - 14.0));
}

QPointF MountingPlan::handle(const QTransform& map) const {
    const Vector6d& mounting = m_drag ? m_drag->mounting : selected().mounting;
    const double out_px = kMmPerM * shapeRadius(selected().shape) * map.m11() + kHandleBeyond_px;
    const double angle = mounting[kThetaZ] + 0.5 * M_PI; // upwards where it is not turned
    return map.map(centre_mm(mounting)) + out_px * QPointF(std::cos(angle), -std::sin(angle));
}

void MountingPlan::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    const QTransform map = this->map();
    const QPointF at = event->position();
    if (canMove() && QLineF(at, handle(map)).length() <= kHandleReach_px) {
        m_drag = Drag{map, {}, selected().mounting, true};
        return;
    }
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        if (!map.map(face_mm(m_objects[i])).contains(at))
            continue;
        emit objectClicked(static_cast<int>(i)); // which selects it
        if (canMove())
            m_drag = Drag{map, map.inverted().map(at) - centre_mm(selected().mounting), selected().mounting};
        return;
    }
}

void MountingPlan::mouseMoveEvent(QMouseEvent* event) {
    if (!m_drag) {
        const bool grips = canMove() && QLineF(event->position(), handle(map())).length() <= kHandleReach_px;
        setCursor(grips ? Qt::PointingHandCursor : Qt::ArrowCursor);
        return;
    }
    const bool fine = event->modifiers().testFlag(Qt::AltModifier);
    const QPointF at_mm = m_drag->map.inverted().map(event->position());
    Vector6d mounting = selected().mounting;
    if (m_drag->turns) {
        const QPointF arm = at_mm - centre_mm(mounting);
        const double angle_deg = degFromRad(std::atan2(arm.y(), arm.x())) - 90.0;
        mounting[kThetaZ] = turned_rad(snapped(angle_deg, fine ? kFineSnap_deg : kSnap_deg));
    } else {
        const double step_mm = fine ? kFineSnap_mm : kSnap_mm;
        mounting[kX] = snapped(at_mm.x() - m_drag->grip_mm.x(), step_mm) / kMmPerM;
        mounting[kY] = snapped(at_mm.y() - m_drag->grip_mm.y(), step_mm) / kMmPerM;
        const bool clicked =
            !m_drag->moved &&
            QLineF(m_drag->grip_mm + centre_mm(selected().mounting), at_mm).length() * m_drag->map.m11() <
                4.0;
        if (clicked)
            return; // a click with an unsteady hand
    }
    m_drag->moved = m_drag->moved || mounting != selected().mounting;
    m_drag->mounting = mounting;
    update();
}

void MountingPlan::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    const Drag drag = *m_drag;
    m_drag.reset();
    update();
    if (drag.mounting != selected().mounting)
        emit objectMoved(m_selected, drag.mounting);
}

void MountingPlan::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_drag) {
        m_drag.reset();
        update();
        return;
    }
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    const double step_m = shift ? 0.01 : 0.001;
    const double turn_deg = shift ? 1.0 : 5.0;
    double x_m = 0.0, y_m = 0.0, angle_deg = 0.0;
    switch (event->key()) {
    case Qt::Key_Left:
        x_m = -step_m;
        break;
    case Qt::Key_Right:
        x_m = step_m;
        break;
    case Qt::Key_Up:
        y_m = step_m;
        break;
    case Qt::Key_Down:
        y_m = -step_m;
        break;
    case Qt::Key_PageUp:
        angle_deg = turn_deg;
        break;
    case Qt::Key_PageDown:
        angle_deg = -turn_deg;
        break;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    if (!canMove() || m_drag)
        return;
    Vector6d mounting = selected().mounting;
    mounting[kX] += x_m;
    mounting[kY] += y_m;
    mounting[kThetaZ] = turned_rad(degFromRad(mounting[kThetaZ]) + angle_deg);
    emit objectMoved(m_selected, mounting);
}

void MountingPlan::paintObjects(QPainter& painter, const QTransform& map) const {
    const bool dark = isDark(this);
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const int index = static_cast<int>(i);
        ObjectSpec object = m_objects[i];
        if (m_drag && index == m_selected)
            object.mounting = m_drag->mounting;
        const QPainterPath face = map.map(face_mm(object));
        QColor color = seriesColor(index, dark);
        painter.setPen(QPen(color, index == m_selected ? 2.4 : 1.2));
        color.setAlphaF(index == m_selected ? 0.28f : 0.10f);
        painter.setBrush(color);
        painter.drawPath(face);
        if (m_remarked.contains(index)) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(QBrush(secondaryText(dark), Qt::BDiagPattern));
            painter.drawPath(face);
        }
    }
}

void MountingPlan::paintHandle(QPainter& painter, const QTransform& map) const {
    const Vector6d& mounting = m_drag ? m_drag->mounting : selected().mounting;
    const QPointF at = handle(map);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
    painter.drawLine(map.map(centre_mm(mounting)), at);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at, kHandleRadius_px, kHandleRadius_px);
    if (!m_drag)
        return;
    const QLocale locale;
    painter.drawText(QRectF(rect()).adjusted(10.0, 8.0, -10.0, 0.0), Qt::AlignTop | Qt::AlignLeft,
                     tr("x %1 cm, y %2 cm, %3\u00b0")
                         .arg(locale.toString(100.0 * mounting[kX], 'f', 2),
                              locale.toString(100.0 * mounting[kY], 'f', 2),
                              locale.toString(degFromRad(mounting[kThetaZ]), 'f', 1)));
}

void MountingPlan::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool dark = isDark(this);
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 1.4) : QPen(hairline(dark)));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));

    const QTransform map = this->map();
    const QPointF origin = map.map(QPointF(0.0, 0.0));
    if (m_reach_m > 0.0) {
        painter.setPen(QPen(hairline(dark), 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(origin, kMmPerM * m_reach_m * map.m11(), kMmPerM * m_reach_m * map.m11());
    }
    paintObjects(painter, map);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
    painter.drawLine(origin, origin + QPointF(26.0, 0.0));
    painter.drawLine(origin, origin - QPointF(0.0, 26.0));
    painter.setBrush(palette().color(QPalette::Text));
    painter.drawEllipse(origin, 2.5, 2.5);
    painter.drawText(origin + QPointF(29.0, 4.0), QStringLiteral("x"));
    painter.drawText(origin + QPointF(-3.0, -29.0), QStringLiteral("y"));
    if (canMove())
        paintHandle(painter, map);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(secondaryText(dark), 1.2));
    paintScaleBar(painter, QRectF(rect()).adjusted(10.0, 0.0, -10.0, -8.0), map.m11());
}

} // namespace bask
