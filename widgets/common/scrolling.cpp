#include "widgets/common/scrolling.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QWheelEvent>

namespace bask {

namespace {

/// It would have the keyboard by the first turn.
void refuseWheel(QWidget* widget) {
    if (widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus);
}

bool isField(const QObject* object) {
    return qobject_cast<const QAbstractSpinBox*>(object) || qobject_cast<const QComboBox*>(object);
}

/// The widget or what it is a part of that is zoomed by the wheel; null for none.
const QWidget* zoomedBy(const QWidget* widget) {
    for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget())
        if (widget->property(kZoomsByWheel).toBool())
            return widget;
    return nullptr;
}

/// Whether it lies in something that can be scrolled up and down, also where that is at its end.
bool isInScrolled(const QWidget* widget) {
    for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget())
        if (const auto* scroll = qobject_cast<const QAbstractScrollArea*>(widget))
            if (const QScrollBar* bar = scroll->verticalScrollBar(); bar->maximum() > bar->minimum())
                return true;
    return false;
}

} // namespace

QScrollArea* scrolled(QWidget* content) {
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("partScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidgetResizable(true);
    scroll->setWidget(content);
    return scroll;
}

ScrollHabits::ScrollHabits(QWidget* window, std::chrono::milliseconds gesture)
    : QObject(window), m_window(window), m_gesture(gesture) {
    for (QWidget* made : window->findChildren<QWidget*>())
        if (isField(made))
            refuseWheel(made);
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { show(now); });
}

bool ScrollHabits::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Polish && isField(watched))
        refuseWheel(static_cast<QWidget*>(watched));
    if (event->type() != QEvent::Wheel)
        return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!m_window->isAncestorOf(widget) || !isForWhatIsAround(widget, *static_cast<QWheelEvent*>(event)))
        return false;
    event->ignore(); // what it lies in is scrolled
    return true;
}

bool ScrollHabits::isForWhatIsAround(QWidget* widget, const QWheelEvent& event) {
    if (isField(widget))
        return !widget->hasFocus();
    if (!isInScrolled(widget))
        return false;
    const QWidget* zoomed = zoomedBy(widget);
    const bool goesOn = m_sinceScroll.isValid() && m_sinceScroll.elapsed() < m_gesture.count();
    if (zoomed != nullptr &&
        (event.modifiers().testFlag(Qt::ControlModifier) || (zoomed->hasFocus() && !goesOn)))
        return false;
    m_sinceScroll.start();
    return zoomed != nullptr;
}

/// Innermost first. Not what was clicked: it would move away from under the mouse.
void ScrollHabits::show(QWidget* focused) {
    if (!m_window->isAncestorOf(focused) || QApplication::mouseButtons() != Qt::NoButton)
        return;
    for (QWidget* part = focused->parentWidget(); part != nullptr; part = part->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(part))
            scroll->ensureWidgetVisible(focused);
}

} // namespace bask
