#include "widgets/targets/reach_map.h"

#include "widgets/common/colour_map.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QTextDocument>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kBeyond = 0.08; // of the map's span, shown on each side of it
constexpr double kSamePoint_K = 1e-6;
constexpr double kPoint = 5.5;      // radius of the target's point
constexpr double kPointGrab = 12.0; // px around it that take hold of it
constexpr int kMarkSize = 18;
constexpr double kTenthsBelow_K = 8.0; // span of an axis that may have ticks between whole degrees

bool isSame(const Eigen::Vector2d& a_K, const Eigen::Vector2d& b_K) {
    return (a_K - b_K).cwiseAbs().maxCoeff() < kSamePoint_K;
}

/// To a tenth in the unit shown: what fields show is what is set.
double rounded_K(double t_K, TemperatureUnit unit) {
    return kelvinFromDisplay(std::round(displayTemperature(t_K, unit) * 10.0) / 10.0, unit);
}

/// A pixel a cell; transparent where no pose comes.
QImage cellPicture(const ReachableMap& map, const QPalette& palette) {
    const bool dark = isDark(palette);
    double min = 1.0, max = 0.0;
    for (const double share : map.density)
        if (share > 0.0) {
            min = std::min(min, share);
            max = std::max(max, share);
        }
    const double decades = std::log(std::max(max / min, 1.001));
    QImage picture(map.cells, map.cells, QImage::Format_ARGB32);
    picture.fill(Qt::transparent);
    for (int y = 0; y < map.cells; ++y)
        for (int x = 0; x < map.cells; ++x) {
            const auto k = static_cast<std::size_t>(y * map.cells + x);
            if (map.reachable[k])
                picture.setPixelColor(x, map.cells - 1 - y,
                                      map.density[k] > 0.0
                                          ? mapColour(std::log(map.density[k] / min) / decades, dark)
                                          : rareColour(palette));
        }
    return picture;
}

} // namespace

QColor rareColour(const QPalette& palette) {
    const double share = isDark(palette) ? 0.16 : 0.28; // between the ground and the lowest colour
    const QColor ground = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
    const auto mixed = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
    return {mixed(ground.red(), text.red()), mixed(ground.green(), text.green()),
            mixed(ground.blue(), text.blue())};
}

/// Where temperatures lie in the widget.
struct ReachMap::Axes {
    QRectF frame;
    Eigen::Vector2d low_K{273.15, 273.15};
    Eigen::Vector2d high_K{373.15, 373.15};

    QPointF place(const Eigen::Vector2d& pair_K) const {
        const Eigen::Vector2d t = (pair_K - low_K).cwiseQuotient(high_K - low_K);
        return {frame.left() + t.x() * frame.width(), frame.bottom() - t.y() * frame.height()};
    }
    Eigen::Vector2d pair_K(const QPointF& place) const {
        const Eigen::Vector2d t((place.x() - frame.left()) / frame.width(),
                                (frame.bottom() - place.y()) / frame.height());
        return low_K + t.cwiseMax(0.0).cwiseMin(1.0).cwiseProduct(high_K - low_K);
    }
};

ReachMap::ReachMap(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    describe();
}

void ReachMap::setNames(const QString& first, const QString& second) {
    m_names = {first, second};
    describe();
}

void ReachMap::setMap(const ReachableMap& map) {
    m_map = map;
    m_stale = false;
    m_cells = cellPicture(map, palette());
    describe();
}

void ReachMap::setStale(bool stale) {
    m_stale = stale;
    describe();
}

void ReachMap::setTarget_K(const Eigen::Vector2d& target_K) {
    m_target_K = target_K;
    describe();
}

void ReachMap::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    describe();
}

void ReachMap::setEditable(bool editable) {
    m_editable = editable;
    if (!editable)
        dropDrag();
    describe();
}

bool ReachMap::answered() const {
    return m_map && !m_stale && isSame(m_map->target_K, m_target_K);
}

QString ReachMap::words() const {
    if (!answered())
        return tr("Checking\u2026");
    const QString distance = QLocale().toString(displayDifference(m_map->distance_K, m_unit), 'f', 1) +
                             QChar(0x00a0) + differenceUnitSymbol(m_unit);
    return (m_map->targetReachable ? tr("%1 inside") : tr("%1 outside")).arg(distance);
}

void ReachMap::describe() {
    setAccessibleName(tr("Temperatures that %1 and %2 can have together").arg(m_names[0], m_names[1]));
    setAccessibleDescription(tr("Targets %1 and %2: %3")
                                 .arg(formatTemperature(m_target_K.x(), m_unit),
                                      formatTemperature(m_target_K.y(), m_unit), words()));
    update();
}

ReachMap::Axes ReachMap::axes(const QSizeF& size) const {
    Axes axes;
    if (m_map) {
        const Eigen::Vector2d beyond_K = kBeyond * (m_map->upper_K - m_map->lower_K);
        axes.low_K = m_map->lower_K - beyond_K;
        axes.high_K = m_map->upper_K + beyond_K;
    }
    const QFontMetricsF metrics(font());
    const double line = metrics.height();
    const bool tenths = axes.high_K.y() - axes.low_K.y() < kTenthsBelow_K;
    const double left =
        line + 12.0 + metrics.horizontalAdvance(tenths ? QStringLiteral("000.0") : QStringLiteral("000"));
    axes.frame = QRectF(QPointF(0.0, 0.0), size).adjusted(left, 8.0, -12.0, -3.0 * line - 18.0);
    return axes;
}

/// The targets' point, at the edge where it lies beyond the axes.
QPointF ReachMap::pointPlace(const Axes& axes) const {
    const QPointF exact = axes.place(m_target_K);
    return {std::clamp(exact.x(), axes.frame.left(), axes.frame.right()),
            std::clamp(exact.y(), axes.frame.top(), axes.frame.bottom())};
}

bool ReachMap::isOnPoint(const QPointF& place) const {
    const QPointF way = place - pointPlace(axes(size()));
    return m_editable && m_map && std::hypot(way.x(), way.y()) <= kPointGrab;
}

/// Whether it is another pair than before.
bool ReachMap::movePoint(const QPointF& place) {
    const Eigen::Vector2d at_K = axes(size()).pair_K(place);
    const Eigen::Vector2d pair_K(rounded_K(at_K.x(), m_unit), rounded_K(at_K.y(), m_unit));
    if (isSame(pair_K, m_target_K))
        return false;
    m_target_K = pair_K;
    describe();
    return true;
}

void ReachMap::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isOnPoint(event->position()))
        return QWidget::mousePressEvent(event);
    m_drag = Drag::Held;
    m_pressed = event->position();
    m_grip = m_pressed - pointPlace(axes(size()));
}

void ReachMap::mouseMoveEvent(QMouseEvent* event) {
    if (m_drag != Drag::No && !event->buttons().testFlag(Qt::LeftButton))
        dropDrag(); // let go where nobody heard of it
    if (m_drag == Drag::No)
        return setCursor(isOnPoint(event->position()) ? Qt::SizeAllCursor : Qt::ArrowCursor);
    const QPointF way = event->position() - m_pressed;
    if (m_drag == Drag::Held && way.manhattanLength() < QApplication::startDragDistance())
        return; // a hand that trembles on a click
    if (!movePoint(event->position() - m_grip))
        return;
    m_drag = Drag::Moved;
    emit targetsDragged(m_target_K.x(), m_target_K.y());
}

void ReachMap::dropDrag() {
    if (std::exchange(m_drag, Drag::No) == Drag::Moved)
        emit dragDropped();
}

void ReachMap::hideEvent(QHideEvent* event) {
    dropDrag();
    QWidget::hideEvent(event);
}

void ReachMap::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(m_drag, Drag::No) == Drag::Moved)
        emit targetsPicked(m_target_K.x(), m_target_K.y());
}

void ReachMap::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && m_editable && m_map &&
        axes(size()).frame.contains(event->position()) && movePoint(event->position()))
        emit targetsPicked(m_target_K.x(), m_target_K.y());
}

void ReachMap::keyPressEvent(QKeyEvent* event) {
    constexpr double kStep = 0.5;
    const int key = event->key();
    const bool first = key == Qt::Key_Left || key == Qt::Key_Right;
    const bool second = key == Qt::Key_Up || key == Qt::Key_Down;
    if (!m_editable || !(first || second))
        return QWidget::keyPressEvent(event);
    const double way = key == Qt::Key_Right || key == Qt::Key_Up ? kStep : -kStep;
    double& t_K = m_target_K[first ? 0 : 1];
    t_K = rounded_K(kelvinFromDisplay(displayTemperature(t_K, m_unit) + way, m_unit), m_unit);
    emit targetsPicked(m_target_K.x(), m_target_K.y());
    describe();
}

QString ReachMap::tip(const QPointF& place) const {
    const Axes axes = this->axes(size());
    if (!m_map || !axes.frame.contains(place))
        return {};
    const Eigen::Vector2d pair_K = axes.pair_K(place);
    const Eigen::Vector2d cell = (pair_K - m_map->lower_K).cwiseQuotient(m_map->cell_K());
    const bool within = cell.minCoeff() >= 0.0 && cell.maxCoeff() < m_map->cells;
    const bool together =
        within && m_map->reachable[static_cast<std::size_t>(static_cast<int>(cell.y()) * m_map->cells +
                                                            static_cast<int>(cell.x()))];
    const QString first = formatTemperature(pair_K.x(), m_unit),
                  second = formatTemperature(pair_K.y(), m_unit);
    return (together ? tr("%1 %2 and %3 %4: some pose has both") : tr("%1 %2 and %3 %4: no pose has both"))
        .arg(m_names[0], first, m_names[1], second);
}

bool ReachMap::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString text = tip(help->pos());
        QToolTip::showText(help->globalPos(), Qt::mightBeRichText(text) ? text.toHtmlEscaped() : text, this);
        return true;
    }
    return QWidget::event(event);
}

void ReachMap::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_map)
        m_cells = cellPicture(*m_map, palette());
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        describe();
    QWidget::changeEvent(event);
}

void ReachMap::paintTicks(QPainter& painter, const Axes& axes, int axis) const {
    const bool dark = isDark(this);
    const double low = displayTemperature(axes.low_K[axis], m_unit);
    const double high = displayTemperature(axes.high_K[axis], m_unit);
    const double length = axis == 0 ? axes.frame.width() : axes.frame.height();
    const double step =
        std::max(niceRange(low, high, std::max(2, static_cast<int>(length / 30.0))).step, 0.1);
    const double line = QFontMetricsF(font()).height();
    for (double value = std::ceil(low / step) * step; value <= high; value += step) {
        Eigen::Vector2d pair_K = axes.low_K;
        pair_K[axis] = kelvinFromDisplay(value, m_unit);
        const QPointF at = axes.place(pair_K);
        const QString label = QLocale().toString(value + 0.0, 'f', step < 1.0 ? 1 : 0);
        painter.setPen(hairline(dark));
        painter.drawLine(at,
                         axis == 0 ? QPointF(at.x(), axes.frame.top()) : QPointF(axes.frame.right(), at.y()));
        painter.setPen(secondaryText(dark));
        if (axis == 0)
            painter.drawText(QRectF(at.x() - 30.0, axes.frame.bottom() + 3.0, 60.0, line), Qt::AlignCenter,
                             label);
        else
            painter.drawText(QRectF(0.0, at.y() - line / 2.0, axes.frame.left() - 5.0, line),
                             Qt::AlignRight | Qt::AlignVCenter, label);
    }
}

/// A sample of the object's line, its name and the unit, in the middle of a box that lies.
void ReachMap::paintName(QPainter& painter, const QRectF& box, int axis) const {
    constexpr QSize kSample(22, 10);
    constexpr double kGap = 6.0;
    const QFontMetricsF metrics(font());
    const QString text =
        metrics.elidedText(QStringLiteral("%1, %2").arg(m_names.at(static_cast<std::size_t>(axis)),
                                                        temperatureUnitSymbol(m_unit)),
                           Qt::ElideMiddle, box.width() - kSample.width() - kGap);
    const double wide = kSample.width() + kGap + metrics.horizontalAdvance(text);
    const double left = box.center().x() - wide / 2.0;
    const int series = !m_map ? 0 : axis == 0 ? m_map->first : m_map->second;
    painter.drawPixmap(QPointF(left, box.center().y() - kSample.height() / 2.0),
                       seriesSwatch(series, isDark(this), kSample, painter.device()->devicePixelRatioF()));
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(left + kSample.width() + kGap, box.top(), wide, box.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, text);
}

void ReachMap::paintCells(QPainter& painter, const Axes& axes) const {
    const QRectF cells(axes.place({m_map->lower_K.x(), m_map->upper_K.y()}),
                       axes.place({m_map->upper_K.x(), m_map->lower_K.y()}));
    painter.setOpacity(m_stale ? 0.4 : 1.0);
    painter.drawImage(cells, m_cells);
    painter.setOpacity(1.0);
    painter.setPen(
        QPen(palette().color(m_stale ? QPalette::Disabled : QPalette::Active, QPalette::WindowText), 1.5,
             Qt::SolidLine, Qt::SquareCap));
    painter.setRenderHint(QPainter::Antialiasing, false); // all lie along the axes
    for (const auto& [a_K, b_K] : m_map->boundary)
        painter.drawLine(axes.place(a_K), axes.place(b_K));
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_stale)
        painter.fillRect(axes.frame, QBrush(palette().color(QPalette::Window), Qt::BDiagPattern));
}

void ReachMap::paintTarget(QPainter& painter, const Axes& axes) const {
    const QColor text = palette().color(QPalette::WindowText);
    const QPointF at = pointPlace(axes);
    if (answered() && !m_map->targetReachable) {
        const QPointF nearest = axes.place(m_map->nearest_K);
        painter.setPen(QPen(text, 1.5, Qt::DashLine));
        painter.drawLine(at, nearest);
        painter.setPen(QPen(Qt::black, 1.5));
        painter.setBrush(Qt::white);
        painter.drawEllipse(nearest, 3.5, 3.5);
        painter.drawPixmap(at - QPointF(kMarkSize, kMarkSize) / 2.0,
                           alarmPixmap(3, isDark(this), kMarkSize, painter.device()->devicePixelRatioF()));
        return;
    }
    painter.setPen(QPen(Qt::black, 2.0));
    painter.setBrush(Qt::white);
    painter.drawEllipse(at, kPoint, kPoint);
}

void ReachMap::paintWords(QPainter& painter, const QRectF& box) const {
    constexpr double kMark = 16.0, kGap = 6.0;
    const bool outside = answered() && !m_map->targetReachable;
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    painter.setFont(bold);
    const double wide = QFontMetricsF(bold).horizontalAdvance(words()) + 2.0;
    const double left = box.center().x() - (outside ? wide + kMark + kGap : wide) / 2.0;
    if (outside)
        painter.drawPixmap(
            QPointF(left, box.center().y() - kMark / 2.0),
            alarmPixmap(3, isDark(this), static_cast<int>(kMark), painter.device()->devicePixelRatioF()));
    painter.setPen(palette().color(answered() ? QPalette::Active : QPalette::Disabled, QPalette::WindowText));
    painter.drawText(QRectF(outside ? left + kMark + kGap : left, box.top(), wide, box.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, words());
    painter.setFont(font());
}

void ReachMap::paint(QPainter& painter, const QSizeF& size) const {
    const Axes axes = this->axes(size);
    const QRectF& frame = axes.frame;
    const double line = QFontMetricsF(font()).height();
    painter.setFont(font());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(frame, palette().color(QPalette::Base));
    if (m_map) {
        paintTicks(painter, axes, 0);
        paintTicks(painter, axes, 1);
        painter.save();
        painter.setClipRect(frame);
        paintCells(painter, axes);
        painter.restore();
    }
    painter.setPen(secondaryText(isDark(this)));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame);
    if (m_map)
        paintTarget(painter, axes);
    paintName(painter, QRectF(frame.left(), frame.bottom() + line + 6.0, frame.width(), line), 0);
    paintWords(painter, QRectF(0.0, frame.bottom() + 2.0 * line + 12.0, size.width(), line));
    painter.save();
    painter.translate(0.0, frame.bottom());
    painter.rotate(-90.0);
    paintName(painter, QRectF(0.0, 2.0, frame.height(), line), 1);
    painter.restore();
}

QImage ReachMap::picture(const QSize& size, double devicePixelRatio) const {
    QImage picture(size * devicePixelRatio, QImage::Format_RGB32);
    picture.setDevicePixelRatio(devicePixelRatio);
    picture.fill(palette().color(QPalette::Window));
    QPainter painter(&picture);
    paint(painter, size);
    return picture;
}

void ReachMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paint(painter, size());
    if (!hasFocus())
        return;
    painter.setPen(QPen(accentColor(isDark(this)), 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(axes(size()).frame);
}

} // namespace bask
