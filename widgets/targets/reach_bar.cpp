#include "widgets/targets/reach_bar.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/common/verdict_words.h"

#include <QApplication>
#include <QEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {
constexpr double kSide = 26.0;
constexpr double kTrackHeight = 14.0;
constexpr double kGrab = 9.0;     // px to each side of the mark
constexpr double kDragStep = 0.5; // degrees of the unit shown
} // namespace

ReachBar::ReachBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setMouseTracking(true);
    describe();
}

void ReachBar::setAxis_K(double low_K, double high_K) {
    m_low_K = low_K;
    m_high_K = std::max(high_K, low_K + 1.0);
    update();
}

void ReachBar::setTarget_K(double target_K) {
    m_target_K = target_K;
    describe();
}

void ReachBar::setVerdict(const std::optional<TargetVerdict>& verdict) {
    m_verdict = verdict;
    describe();
}

void ReachBar::setStale(bool stale) {
    m_stale = stale;
    describe();
}

void ReachBar::setSeries(int index) {
    m_series = index;
    update();
}

void ReachBar::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    describe();
}

void ReachBar::describe() {
    setAccessibleName(tr("Reachable temperatures"));
    const QString text = !m_verdict ? tr("The range is being worked out.")
                                    : tr("Target %1. Here it can be held between %2 and %3; with nothing but "
                                         "the source in view, up to %4.")
                                          .arg(formatTemperature(m_target_K, m_unit),
                                               formatTemperature(m_verdict->reachableMin_K, m_unit),
                                               formatTemperature(m_verdict->reachableMax_K, m_unit),
                                               formatTemperature(m_verdict->highest_K, m_unit));
    setAccessibleDescription(text);
    setToolTip(text);
    update();
}

void ReachBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        describe();
    QWidget::changeEvent(event);
}

void ReachBar::setEditable(bool editable) {
    m_editable = editable;
    if (editable)
        return;
    unsetCursor();
    dropDrag();
}

void ReachBar::dropDrag() {
    m_grip.reset();
    if (std::exchange(m_moved, false))
        emit dragDropped();
}

void ReachBar::hideEvent(QHideEvent* event) {
    dropDrag();
    QWidget::hideEvent(event);
}

bool ReachBar::isOnMark(QPointF place) const {
    return m_editable && std::abs(place.x() - x(m_target_K)) <= kGrab;
}

void ReachBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || !isOnMark(event->position()))
        return QWidget::mousePressEvent(event);
    m_pressed = event->position().x();
    m_grip = m_pressed - x(m_target_K);
    event->accept();
}

void ReachBar::mouseMoveEvent(QMouseEvent* event) {
    if (m_grip && !event->buttons().testFlag(Qt::LeftButton))
        dropDrag(); // let go where nobody heard of it
    if (m_grip && !m_moved && std::abs(event->position().x() - m_pressed) < QApplication::startDragDistance())
        return; // a hand that trembles on a click
    if (!m_grip)
        return isOnMark(event->position()) ? setCursor(Qt::SizeHorCursor) : unsetCursor();
    const double share = (event->position().x() - *m_grip - kSide) / (width() - 2.0 * kSide);
    const double t_K = m_low_K + std::clamp(share, 0.0, 1.0) * (m_high_K - m_low_K);
    const double step = std::round(displayTemperature(t_K, m_unit) / kDragStep) * kDragStep;
    m_moved = true;
    emit targetDragged(kelvinFromDisplay(step, m_unit));
}

void ReachBar::mouseReleaseEvent(QMouseEvent* event) {
    if (!m_grip || event->button() != Qt::LeftButton)
        return QWidget::mouseReleaseEvent(event);
    m_grip.reset();
    if (std::exchange(m_moved, false))
        emit targetDropped();
}

QSize ReachBar::sizeHint() const {
    return {360, 2 * fontMetrics().height() + 20 + static_cast<int>(kTrackHeight)};
}

double ReachBar::x(double t_K) const {
    const double t = (t_K - m_low_K) / (m_high_K - m_low_K);
    return kSide + std::clamp(t, 0.0, 1.0) * (width() - 2.0 * kSide);
}

void ReachBar::paintBands(QPainter& painter, const QRectF& track) const {
    const bool dark = isDark(this);
    painter.setPen(Qt::NoPen);
    painter.setBrush(hairline(dark));
    painter.drawRoundedRect(track, 4.0, 4.0);
    if (!m_verdict)
        return;
    QColor color =
        m_stale ? palette().color(QPalette::Disabled, QPalette::Text) : seriesColor(m_series, dark);
    const auto band = [&](double from_K, double to_K) {
        return QRectF(QPointF(x(from_K), track.top()), QPointF(x(to_K), track.bottom()));
    };
    painter.setPen(QPen(color, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(band(m_verdict->lowest_K, m_verdict->highest_K).adjusted(0.5, 0.5, -0.5, -0.5),
                            4.0, 4.0);
    color.setAlphaF(0.55f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const QRectF reachable = band(m_verdict->reachableMin_K, m_verdict->reachableMax_K);
    painter.drawRoundedRect(reachable, 4.0, 4.0);
    if (m_stale) {
        painter.setBrush(QBrush(palette().color(QPalette::Window), Qt::BDiagPattern));
        painter.drawRoundedRect(reachable, 4.0, 4.0);
    }
    painter.setPen(secondaryText(dark));
    const double line = fontMetrics().height();
    const auto label = [&](double t_K, double centre) {
        const QRectF box(centre - 40.0, track.bottom() + 3.0, 80.0, line);
        painter.drawText(box, Qt::AlignHCenter | Qt::AlignTop, formatTemperatureNumber(t_K, m_unit));
    };
    const double left = reachable.left();
    const double right = std::max(reachable.right(), left + fontMetrics().horizontalAdvance("000.0") + 8.0);
    label(m_verdict->reachableMin_K, left);
    label(m_verdict->reachableMax_K, right);
}

void ReachBar::paintTarget(QPainter& painter, const QRectF& track) const {
    const bool dark = isDark(this);
    const bool bad = m_verdict && !m_stale && verdictHere(*m_verdict) != FeasibilityVerdict::Reachable;
    const QColor text = palette().color(m_stale ? QPalette::Disabled : QPalette::Active, QPalette::Text);
    const double at = x(m_target_K);
    painter.setPen(QPen(text, 2.0));
    painter.drawLine(QPointF(at, track.top() - 2.0), QPointF(at, track.bottom() + 2.0));
    painter.setPen(QPen(text, 1.0));
    painter.setBrush(bad ? alarmColor(3, dark) : text);
    const double top = track.top() - 10.0;
    if (m_target_K > m_high_K || m_target_K < m_low_K) { // off the axis: the mark points there
        const double way = m_target_K > m_high_K ? 1.0 : -1.0;
        painter.drawPolygon(QPolygonF{{at, top}, {at, top + 10.0}, {at + way * 9.0, top + 5.0}});
    } else {
        painter.drawPolygon(QPolygonF{{at - 5.5, top}, {at + 5.5, top}, {at, top + 9.0}});
    }
    const QString value = formatTemperature(m_target_K, m_unit);
    const double w = fontMetrics().horizontalAdvance(value) + 4.0;
    const double left = std::clamp(at - w / 2.0, 0.0, std::max(width() - w, 0.0));
    painter.setPen(text);
    painter.drawText(QRectF(left, top - fontMetrics().height() - 1.0, w, fontMetrics().height()),
                     Qt::AlignCenter, value);
}

void ReachBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double top = fontMetrics().height() + 12.0;
    const QRectF track(kSide, top, width() - 2.0 * kSide, kTrackHeight);
    paintBands(painter, track);
    paintTarget(painter, track);
}

} // namespace bask
