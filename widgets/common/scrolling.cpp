#include "widgets/common/scrolling.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QScrollArea>

namespace bask {

namespace {

/// It would have the keyboard by the first turn.
void refuseWheel(QWidget* widget) {
    if (widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus);
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

ScrollHabits::ScrollHabits(QWidget* window) : QObject(window), m_window(window) {
    for (QWidget* made : window->findChildren<QWidget*>())
        if (qobject_cast<QAbstractSpinBox*>(made) || qobject_cast<QComboBox*>(made))
            refuseWheel(made);
    qApp->installEventFilter(this);
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { show(now); });
}

bool ScrollHabits::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish)
        return false;
    if (!qobject_cast<QAbstractSpinBox*>(watched) && !qobject_cast<QComboBox*>(watched))
        return false;
    auto* widget = static_cast<QWidget*>(watched);
    if (event->type() == QEvent::Polish) {
        refuseWheel(widget);
        return false;
    }
    if (!m_window->isAncestorOf(widget) || widget->hasFocus())
        return false;
    event->ignore(); // what it lies in is scrolled
    return true;
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
