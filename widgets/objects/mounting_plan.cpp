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
constexpr double kTiltHandle_px = 36.0;  ///< from the object's centre
constexpr double kObjectReach_px = 14.0; ///< about its centre, where the outline is smaller
constexpr double kEdgeReach_px = 7.0;    ///< of an object seen edge-on
constexpr double kGridMin_px = 18.0;
constexpr double kArrow_px = 16.0;
constexpr double kFacing_px = 13.0, kFacingHead_px = 3.5;
constexpr double kUnseen = 0.05; ///< length of a direction in a view, below which it is along the sight

double snapped(double value, double step) {
    return step * std::round(value / step);
}

/// Within -180 to 180 degrees.
double turned_rad(double angle_deg) {
    return radFromDeg(std::remainder(angle_deg, 360.0));
}

/// From up, y up.
double clockwise_deg(const QPointF& direction) {
    return degFromRad(std::atan2(direction.x(), direction.y()));
}

/// A direction with y up, in pixels.
QPointF onScreen(const QPointF& direction, double length_px) {
    return {length_px * direction.x(), -length_px * direction.y()};
}

} // namespace

double gridStep_mm(double pixelsPerMm) {
    const double min_mm = kGridMin_px / pixelsPerMm;
    const double below_mm = niceLength(min_mm);
    return below_mm < min_mm ? niceLength(2.501 * below_mm) : below_mm; // 1, 2, 5: the next one
}

MountingPlan::MountingPlan(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setObjects({}, -1);
    retranslate();
}

void MountingPlan::setView(MountingView view) {
    m_view = view;
    setObjects(std::vector(m_objects), m_selected, m_remarked, m_reach_m);
    retranslate();
}

void MountingPlan::setObjects(const std::vector<ObjectSpec>& objects, int selected,
                              const std::set<int>& remarked, double reach_m) {
    m_objects = objects;
    m_content_mm = QRectF(-10.0, -10.0, 20.0, 20.0);
    for (ObjectSpec& object : m_objects) {
        object.shape = thinned(object.shape); // drawn at every move of the mouse
        m_content_mm = m_content_mm.united(projected_mm(object).boundingRect());
    }
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

void MountingPlan::showDragged(int index, const Vector6d& mounting) {
    m_objects[static_cast<std::size_t>(index)].mounting = mounting;
    update();
}

void MountingPlan::setReadOnly(bool readOnly) {
    m_readOnly = readOnly;
    endDrag();
}

void MountingPlan::setMaxScale(double scale) {
    m_maxScale = scale;
    update();
}

void MountingPlan::retranslate() {
    if (isFromTop()) {
        setAccessibleName(tr("Plan of the objects on the end-effector"));
        setToolTip(tr(
            "The objects on the end-effector, to scale. Drag one to move it in steps of 5 mm, its handle to "
            "turn it in steps of 5\u00b0; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up "
            "and Page Down turn it."));
        return;
    }
    setAccessibleName(m_view == MountingView::Front ? tr("Objects on the end-effector from the front")
                                                    : tr("Objects on the end-effector from the side"));
    setToolTip(
        tr("The objects edge-on, to the scale of the plan. Drag one to change its height in steps of 5 mm, "
           "its handle to tilt it in steps of 5\u00b0; with Alt finely. Arrow keys move the selected one by "
           "1 mm, Page Up and Page Down tilt it."));
}

void MountingPlan::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

QSize MountingPlan::minimumSizeHint() const {
    return isFromTop() ? QSize(180, 160) : QSize(180, 130);
}

double MountingPlan::footHeight() const {
    return fontMetrics().height() + 12.0;
}

QPointF MountingPlan::centre_mm(const Vector6d& mounting) const {
    return {kMmPerM * mounting[right()], kMmPerM * mounting[up()]};
}

QPainterPath MountingPlan::projected_mm(const ObjectSpec& object) const {
    return face_mm(mountedRings(object, 240, right(), up()));
}

QRectF MountingPlan::canvas() const {
    const double handle =
        isFromTop() ? kHandleBeyond_px + kHandleRadius_px + 12.0 : kTiltHandle_px + kHandleRadius_px + 4.0;
    const double below = isFromTop() ? 4.0 : kFacing_px + fontMetrics().height() + 4.0;
    return QRectF(rect()).adjusted(handle, handle, -handle, -footHeight() - below);
}

double MountingPlan::fittedScale() const {
    return fitted(m_content_mm, canvas()).m11();
}

QTransform MountingPlan::map() const {
    QRectF content = m_content_mm;
    if (const double scale = fittedScale(); m_maxScale > 0.0 && scale > m_maxScale) {
        content.setSize(content.size() * (scale / m_maxScale));
        content.moveCenter(m_content_mm.center());
    }
    return fitted(content, canvas());
}

/// From the top it turns with the object, from the sides it stands on the back of the plate.
QPointF MountingPlan::handleDirection(const Vector6d& mounting) const {
    if (isFromTop())
        return {-std::sin(mounting[kThetaZ]), std::cos(mounting[kThetaZ])};
    const Eigen::Vector3d back = poseFromCoordinates(mounting).linear().col(2);
    const QPointF seen(back[right()], back[up()]);
    const double length = std::hypot(seen.x(), seen.y());
    return length < kUnseen ? QPointF(0.0, 1.0) : seen / length;
}

MountingPlan::Turn MountingPlan::turnOf(const Vector6d& mounting) const {
    if (isFromTop())
        return {kThetaZ, -1.0};
    const Eigen::Vector3d clockwise =
        m_view == MountingView::Front ? Eigen::Vector3d::UnitY() : Eigen::Vector3d(-Eigen::Vector3d::UnitX());
    const Eigen::Vector3d along = rotationAxes(mounting).transpose() * clockwise;
    const double x = std::abs(along[0]), y = std::abs(along[1]);
    const bool isAboutX = std::abs(x - y) < 1e-9 ? m_view == MountingView::Side : x > y;
    return isAboutX ? Turn{kThetaX, along[0] < 0.0 ? -1.0 : 1.0} : Turn{kThetaY, along[1] < 0.0 ? -1.0 : 1.0};
}

QPointF MountingPlan::handle(const QTransform& map) const {
    const QPointF direction = handleDirection(selected().mounting);
    const QPointF centre = centre_mm(selected().mounting);
    double out_px = kTiltHandle_px;
    if (isFromTop()) {
        double edge_mm = 0.0;
        for (const QPolygonF& ring : projected_mm(selected()).toSubpathPolygons())
            for (const QPointF& p : ring)
                edge_mm = std::max(edge_mm, QPointF::dotProduct(p - centre, direction));
        out_px = edge_mm * map.m11() + kHandleBeyond_px;
    }
    return map.map(centre) + onScreen(direction, out_px);
}

QPointF MountingPlan::objectPosition(int index) const {
    return map().map(centre_mm(m_objects[static_cast<std::size_t>(index)].mounting));
}

bool MountingPlan::onHandle(const QTransform& map, const QPointF& at) const {
    return canMove() && QLineF(at, handle(map)).length() <= kHandleReach_px;
}

bool MountingPlan::holds(const QTransform& map, int index, const QPointF& at) const {
    const QPainterPath face = map.map(projected_mm(m_objects[static_cast<std::size_t>(index)]));
    if (isFromTop() || face.contains(at))
        return face.contains(at);
    QRectF about(0.0, 0.0, 2.0 * kEdgeReach_px, 2.0 * kEdgeReach_px);
    about.moveCenter(at);
    return face.intersects(about);
}

/// The selected one before those that lie over it, an outline before a centre that is only near.
int MountingPlan::objectAt(const QTransform& map, const QPointF& at) const {
    if (m_selected >= 0 && holds(map, m_selected, at))
        return m_selected;
    int nearest = -1;
    double nearest_px = kObjectReach_px;
    for (int i = 0; i < static_cast<int>(m_objects.size()); ++i) {
        if (holds(map, i, at))
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
        m_drag = Drag{{}, selected().mounting, true};
        return;
    }
    const int index = objectAt(map, at);
    if (index < 0)
        return;
    emit objectClicked(index); // which selects it
    if (canMove())
        m_drag = Drag{map.inverted().map(at) - centre_mm(selected().mounting), selected().mounting};
}

Vector6d MountingPlan::dragged(const QPointF& at_mm, bool fine) const {
    Vector6d mounting = m_drag->before;
    if (m_drag->turns) {
        const Turn turn = turnOf(mounting);
        const double by_deg =
            clockwise_deg(at_mm - centre_mm(mounting)) - clockwise_deg(handleDirection(mounting));
        mounting[turn.coordinate] =
            turned_rad(snapped(degFromRad(mounting[turn.coordinate]) + turn.clockwise * by_deg,
                               fine ? kFineSnap_deg : kSnap_deg));
        return mounting;
    }
    const double step_mm = fine ? kFineSnap_mm : kSnap_mm;
    const QPointF to_mm = at_mm - m_drag->grip_mm;
    if (isFromTop())
        mounting[kX] = snapped(to_mm.x(), step_mm) / kMmPerM;
    mounting[up()] = snapped(to_mm.y(), step_mm) / kMmPerM;
    return mounting;
}

void MountingPlan::mouseMoveEvent(QMouseEvent* event) {
    const QTransform map = this->map();
    if (!m_drag) {
        const bool grips = onHandle(map, event->position()) || objectAt(map, event->position()) >= 0;
        setCursor(grips ? Qt::PointingHandCursor : Qt::ArrowCursor);
        return;
    }
    const QPointF at_mm = map.inverted().map(event->position());
    const QPointF from_mm = m_drag->grip_mm + centre_mm(m_drag->before);
    if (!m_drag->turns && !m_drag->moved && QLineF(from_mm, at_mm).length() * map.m11() < 4.0)
        return; // a click with an unsteady hand
    const Vector6d mounting = dragged(at_mm, event->modifiers().testFlag(Qt::AltModifier));
    if (mounting == selected().mounting)
        return;
    m_drag->moved = true;
    selected().mounting = mounting;
    update();
    emit objectDragged(m_selected, mounting);
}

void MountingPlan::endDrag() {
    if (m_drag && m_drag->moved) {
        selected().mounting = m_drag->before;
        emit objectDragged(m_selected, m_drag->before);
    }
    m_drag.reset();
    update();
}

void MountingPlan::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !m_drag)
        return;
    const Vector6d before = m_drag->before;
    const Vector6d mounting = selected().mounting;
    m_drag.reset();
    update();
    if (mounting != before)
        emit objectMoved(m_selected, mounting);
}

void MountingPlan::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && m_drag) {
        endDrag();
        return;
    }
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    const double step_m = shift ? 0.01 : 0.001;
    const double turn_deg = shift ? 1.0 : 5.0;
    double right_m = 0.0, up_m = 0.0, angle_deg = 0.0;
    switch (event->key()) {
    case Qt::Key_Left:
        right_m = -step_m;
        break;
    case Qt::Key_Right:
        right_m = step_m;
        break;
    case Qt::Key_Up:
        up_m = step_m;
        break;
    case Qt::Key_Down:
        up_m = -step_m;
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
    mounting[right()] += right_m;
    mounting[up()] += up_m;
    if (angle_deg != 0.0) {
        double& turned = mounting[turnOf(mounting).coordinate];
        turned = turned_rad(degFromRad(turned) + angle_deg);
    }
    emit objectMoved(m_selected, mounting);
}

void MountingPlan::paintObjects(QPainter& painter, const QTransform& map) const {
    const bool dark = isDark(this);
    const int count = static_cast<int>(m_objects.size());
    for (int i = 1; i <= count; ++i) { // the selected one last, over those that it hides
        const int index = (m_selected + i) % count;
        const QPainterPath face = map.map(projected_mm(m_objects[static_cast<std::size_t>(index)]));
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

/// An arrow from the middle of each heated face.
void MountingPlan::paintFacing(QPainter& painter, const QTransform& map) const {
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        const Eigen::Vector3d back = poseFromCoordinates(m_objects[i].mounting).linear().col(2);
        const QPointF out = onScreen({-back[right()], -back[up()]}, 1.0), across(-out.y(), out.x());
        if (std::hypot(out.x(), out.y()) < kUnseen)
            continue;
        const QPointF from = map.map(centre_mm(m_objects[i].mounting)), tip = from + kFacing_px * out;
        painter.setPen(QPen(seriesColor(static_cast<int>(i), isDark(this)), 1.2));
        painter.drawLine(from, tip);
        painter.drawLine(tip, tip - kFacingHead_px * (out + across));
        painter.drawLine(tip, tip - kFacingHead_px * (out - across));
    }
}

/// From the top in the middle of its object, else below it, and below names that would be covered.
void MountingPlan::paintNames(QPainter& painter, const QTransform& map) const {
    painter.setPen(palette().color(QPalette::Text));
    QColor ground = palette().color(QPalette::Base);
    ground.setAlphaF(0.75f);
    std::vector<QRectF> taken;
    for (const ObjectSpec& object : m_objects) {
        const double room_px = std::max(2.0 * kMmPerM * shapeRadius(object.shape) * map.m11(), 64.0);
        const QString name = fontMetrics().elidedText(QString::fromStdString(object.name), Qt::ElideRight,
                                                      static_cast<int>(room_px));
        QRectF box(fontMetrics().boundingRect(name));
        box.moveCenter(map.map(centre_mm(object.mounting)));
        if (!isFromTop()) {
            const double below = map.mapRect(projected_mm(object).boundingRect()).bottom();
            box.moveTop(std::max(below, map.map(centre_mm(object.mounting)).y() + kFacing_px) + 1.0);
            const auto covered = [&] {
                return std::ranges::find_if(taken, [&](const QRectF& one) { return one.intersects(box); });
            };
            for (auto one = covered(); one != taken.end(); one = covered())
                box.moveTop(one->bottom());
            taken.push_back(box);
        }
        painter.fillRect(box.adjusted(-2.0, 0.0, 2.0, 0.0), ground);
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, name);
    }
}

void MountingPlan::paintHandle(QPainter& painter, const QTransform& map) const {
    const QPointF at = handle(map);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.0));
    painter.drawLine(map.map(centre_mm(selected().mounting)), at);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at, kHandleRadius_px, kHandleRadius_px);
}

QString MountingPlan::readout() const {
    const QLocale locale;
    const Vector6d& mounting = selected().mounting;
    const auto cm = [&](Coordinate c) { return locale.toString(100.0 * mounting[c], 'f', 2); };
    const auto deg = [&](Coordinate c) { return locale.toString(degFromRad(mounting[c]), 'f', 1); };
    return isFromTop() ? tr("x %1 cm, y %2 cm, %3\u00b0").arg(cm(kX), cm(kY), deg(kThetaZ))
                       : tr("z %1 cm, tilt %2\u00b0 about x, %3\u00b0 about y")
                             .arg(cm(kZ), deg(kThetaX), deg(kThetaY));
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
        const QPointF middle = map.map(QPointF(0.0, 0.0));
        if (isFromTop())
            painter.drawEllipse(middle, radius_px, radius_px);
        for (const double x : {middle.x() - radius_px, middle.x() + radius_px})
            if (!isFromTop())
                painter.drawLine(QPointF(x, 0.0), QPointF(x, height()));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(secondaryText(dark));
    painter.drawEllipse(map.map(QPointF(0.0, 0.0)), 2.5, 2.5);
}

/// Below the drawing, where it hides no object: where the dragged one is, or what is drawn; and the axes.
void MountingPlan::paintFoot(QPainter& painter, const QTransform& map) const {
    const QRectF foot(1.0, height() - footHeight(), width() - 2.0, footHeight() - 1.0);
    painter.fillRect(foot, palette().color(QPalette::Base));
    const bool isMoved = m_drag && m_drag->moved;
    painter.setPen(isMoved ? palette().color(QPalette::Text) : secondaryText(isDark(this)));
    const QString text =
        isMoved ? readout()
        : isFromTop()
            ? tr("Grid %1, snap %2").arg(lengthText_mm(gridStep_mm(map.m11())), lengthText_mm(kSnap_mm))
            : tr("Arrows: where the heated faces look");
    painter.drawText(foot.adjusted(8.0, 0.0, -48.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.setPen(QPen(secondaryText(isDark(this)), 1.2));
    const QPointF corner(foot.right() - 32.0, foot.bottom() - 6.0);
    painter.drawLine(corner, corner + QPointF(kArrow_px, 0.0));
    painter.drawLine(corner, corner - QPointF(0.0, kArrow_px));
    painter.drawText(corner + QPointF(kArrow_px + 3.0, 3.0), QLatin1String(kCoordinateNames[right()]));
    painter.drawText(corner + QPointF(-10.0, -kArrow_px + 8.0), QLatin1String(kCoordinateNames[up()]));
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
    if (!isFromTop())
        paintFacing(painter, map);
    paintNames(painter, map);
    paintFoot(painter, map);
}

} // namespace bask
