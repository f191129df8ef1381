#include "widgets/objects/mounting_plan.h"

#include "engine/base/units.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLineF>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kSnap_mm = 5.0, kFineSnap_mm = 0.1;
constexpr double kSnap_deg = 5.0, kFineSnap_deg = 0.1;
// Large enough for a hand in a glove.
constexpr double kHandleBeyond_px = 18.0;
constexpr double kHandleRadius_px = 6.5;
constexpr double kHandleReach_px = 16.0;
constexpr double kObjectReach_px = 14.0; ///< about its centre, where the outline is smaller
constexpr double kGridMin_px = 18.0;
constexpr double kArrow_px = 16.0;

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

double gridStep_mm(double pixelsPerMm) {
    const double min_mm = kGridMin_px / pixelsPerMm;
    const double below_mm = niceLength(min_mm);
    return below_mm < min_mm ? niceLength(2.501 * below_mm) : below_mm; // 1, 2, 5: the next one
}

MountingPlan::MountingPlan(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    retranslate();
}

void MountingPlan::setObjects(const std::vector<ObjectSpec>& objects, int selected,
                              const std::set<int>& remarked, double reach_m) {
    m_objects = objects;
    for (ObjectSpec& object : m_objects)
        object.shape = thinned(object.shape); // drawn at every move of the mouse
    m_remarked = remarked;
    m_selected = selected < static_cast<int>(objects.size()) ? selected : -1;
    m_reach_m = reach_m;
    m_drag.reset();
    update();
}

void MountingPlan::setRemarked(const std::set<int>& remarked) {
    m_remarked = remarked;
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
        tr("The objects on the end-effector, to scale. Drag one to move it in steps of 5 mm, its handle to "
           "turn it in steps of 5\u00b0; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up "
           "and Page Down turn it."));
}

void MountingPlan::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

int MountingPlan::heightForWidth(int width) const {
    return std::clamp(width, minimumSizeHint().height(), 460);
}

double MountingPlan::footHeight() const {
    return fontMetrics().height() + 12.0;
}

QTransform MountingPlan::map() const {
    if (m_drag)
        return m_drag->map;
    QRectF content(-10.0, -10.0, 20.0, 20.0);
    for (const ObjectSpec& object : m_objects)
        content = content.united(face_mm(object).boundingRect());
    const double margin = 12.0 + kHandleBeyond_px + kHandleRadius_px;
    return fitted(content, QRectF(rect()).adjusted(margin, margin, -margin, -footHeight() - 4.0));
}

QPointF MountingPlan::handle(const QTransform& map) const {
    const Vector6d& mounting = m_drag ? m_drag->mounting : selected().mounting;
    const double out_px = kMmPerM * shapeRadius(selected().shape) * map.m11() + kHandleBeyond_px;
    const double angle = mounting[kThetaZ] + 0.5 * M_PI; // upwards where it is not turned
    return map.map(centre_mm(mounting)) + out_px * QPointF(std::cos(angle), -std::sin(angle));
}

QPointF MountingPlan::objectPosition(int index) const {
    return map().map(centre_mm(m_objects[static_cast<std::size_t>(index)].mounting));
}

bool MountingPlan::onHandle(const QTransform& map, const QPointF& at) const {
    return canMove() && QLineF(at, handle(map)).length() <= kHandleReach_px;
}

/// The selected one before those that lie over it, an outline before a centre that is only near.
int MountingPlan::objectAt(const QTransform& map, const QPointF& at) const {
    const auto holds = [&](int index) {
        const ObjectSpec& object = m_objects[static_cast<std::size_t>(index)];
        return map.map(face_mm(object)).contains(at);
    };
    if (m_selected >= 0 && holds(m_selected))
        return m_selected;
    int nearest = -1;
    double nearest_px = kObjectReach_px;
    for (int i = 0; i < static_cast<int>(m_objects.size()); ++i) {
        if (holds(i))
            return i;
        if (const double away_px = QLineF(at, objectPosition(i)).length(); away_px < nearest_px) {
            nearest_px = away_px;
            nearest = i;
        }
    }
    return nearest;
}

void MountingPlan::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    const QTransform map = this->map();
    const QPointF at = event->position();
    if (onHandle(map, at)) {
        m_drag = Drag{map, {}, selected().mounting, true};
        return;
    }
    const int index = objectAt(map, at);
    if (index < 0)
        return;
    emit objectClicked(index); // which selects it
    if (canMove())
        m_drag = Drag{map, map.inverted().map(at) - centre_mm(selected().mounting), selected().mounting};
}

void MountingPlan::mouseMoveEvent(QMouseEvent* event) {
    if (!m_drag) {
        const QTransform map = this->map();
        const bool grips = onHandle(map, event->position()) || objectAt(map, event->position()) >= 0;
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

void MountingPlan::paintNames(QPainter& painter, const QTransform& map) const {
    painter.setPen(palette().color(QPalette::Text));
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.75f);
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const bool dragged = m_drag && static_cast<int>(i) == m_selected;
        const Vector6d& mounting = dragged ? m_drag->mounting : m_objects[i].mounting;
        const double room_px = std::max(2.0 * kMmPerM * shapeRadius(m_objects[i].shape) * map.m11(), 64.0);
        const QString name = fontMetrics().elidedText(QString::fromStdString(m_objects[i].name),
                                                      Qt::ElideRight, static_cast<int>(room_px));
        QRectF box(fontMetrics().boundingRect(name));
        box.moveCenter(map.map(centre_mm(mounting)));
        painter.fillRect(box.adjusted(-2.0, 0.0, 2.0, 0.0), ground);
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, name);
    }
}

void MountingPlan::paintHandle(QPainter& painter, const QTransform& map) const {
    const Vector6d& mounting = m_drag ? m_drag->mounting : selected().mounting;
    const QPointF at = handle(map);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
    painter.drawLine(map.map(centre_mm(mounting)), at);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at, kHandleRadius_px, kHandleRadius_px);
}

/// Where the dragged object is.
void MountingPlan::paintReadout(QPainter& painter) const {
    const QLocale locale;
    const Vector6d& mounting = m_drag->mounting;
    const QString text =
        tr("x %1 cm, y %2 cm, %3\u00b0")
            .arg(locale.toString(100.0 * mounting[kX], 'f', 2), locale.toString(100.0 * mounting[kY], 'f', 2),
                 locale.toString(degFromRad(mounting[kThetaZ]), 'f', 1));
    painter.setPen(palette().color(QPalette::Text));
    painter.fillRect(QRectF(1.0, 1.0, width() - 2.0, fontMetrics().height() + 8.0),
                     palette().color(QPalette::Base));
    painter.drawText(QRectF(rect()).adjusted(8.0, 5.0, -8.0, 0.0), Qt::AlignTop | Qt::AlignHCenter, text);
}

void MountingPlan::paintGround(QPainter& painter, const QTransform& map) const {
    const bool dark = isDark(this);
    const double step_mm = gridStep_mm(map.m11());
    const QRectF shown = map.inverted().mapRect(QRectF(rect()));
    const auto first = [step_mm](double min_mm) { return static_cast<int>(std::floor(min_mm / step_mm)); };
    for (int k = first(shown.left()); k * step_mm < shown.right(); ++k) {
        painter.setPen(QPen(hairline(dark), k == 0 ? 1.8 : 0.7));
        painter.drawLine(map.map(QPointF(k * step_mm, shown.top())),
                         map.map(QPointF(k * step_mm, shown.bottom())));
    }
    for (int k = first(shown.top()); k * step_mm < shown.bottom(); ++k) {
        painter.setPen(QPen(hairline(dark), k == 0 ? 1.8 : 0.7));
        painter.drawLine(map.map(QPointF(shown.left(), k * step_mm)),
                         map.map(QPointF(shown.right(), k * step_mm)));
    }
    if (m_reach_m > 0.0) {
        const double radius_px = kMmPerM * m_reach_m * map.m11();
        painter.setPen(QPen(secondaryText(dark), 1.0, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(map.map(QPointF(0.0, 0.0)), radius_px, radius_px);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(secondaryText(dark));
    painter.drawEllipse(map.map(QPointF(0.0, 0.0)), 2.5, 2.5);
}

/// Below the drawing, where no object hides it: how wide the grid is, and the axes.
void MountingPlan::paintFoot(QPainter& painter, const QTransform& map) const {
    const QRectF foot(1.0, height() - footHeight(), width() - 2.0, footHeight() - 1.0);
    painter.fillRect(foot, palette().color(QPalette::Base));
    painter.setPen(QPen(secondaryText(isDark(this)), 1.2));
    painter.drawText(
        foot.adjusted(8.0, 0.0, -48.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
        tr("Grid %1, snap %2").arg(lengthText_mm(gridStep_mm(map.m11())), lengthText_mm(kSnap_mm)));
    const QPointF corner(foot.right() - 32.0, foot.bottom() - 6.0);
    painter.drawLine(corner, corner + QPointF(kArrow_px, 0.0));
    painter.drawLine(corner, corner - QPointF(0.0, kArrow_px));
    painter.drawText(corner + QPointF(kArrow_px + 3.0, 3.0), QStringLiteral("x"));
    painter.drawText(corner + QPointF(-10.0, -kArrow_px + 8.0), QStringLiteral("y"));
}

void MountingPlan::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight), 1.4)
                              : QPen(hairline(isDark(this))));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    painter.setClipRect(rect().adjusted(1, 1, -1, -1));

    const QTransform map = this->map();
    paintGround(painter, map);
    paintObjects(painter, map);
    if (canMove())
        paintHandle(painter, map);
    paintNames(painter, map);
    paintFoot(painter, map);
    if (m_drag && m_drag->moved)
        paintReadout(painter);
}

} // namespace bask
