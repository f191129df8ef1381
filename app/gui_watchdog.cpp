#include "app/gui_watchdog.h"

#include <QEvent>

#include <algorithm>

namespace bask {
namespace {

bool paints(QEvent::Type type) {
    return type == QEvent::UpdateRequest || type == QEvent::Paint || type == QEvent::Expose;
}

} // namespace

bool MeasuredApplication::notify(QObject* receiver, QEvent* event) {
    if (!paints(event->type()))
        return QApplication::notify(receiver, event);
    if (m_depth++ == 0)
        m_timer.start();
    const bool handled = QApplication::notify(receiver, event);
    if (--m_depth == 0)
        m_paint_s += static_cast<double>(m_timer.nsecsElapsed()) * 1e-9;
    return handled;
}

GuiWatchdog::GuiWatchdog(QObject* parent) : QObject(parent) {
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &GuiWatchdog::tick);
    m_timer.start(kTick_ms);
    restart();
}

void GuiWatchdog::restart() {
    const auto* application = dynamic_cast<const MeasuredApplication*>(qApp);
    m_paintBefore_s = application != nullptr ? application->paintTime_s() : 0.0;
    m_longest_s = 0.0;
    m_blocks_s.clear();
    m_clock.start();
}

void GuiWatchdog::tick() {
    const double gap_s = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
    m_clock.start();
    const auto* application = dynamic_cast<const MeasuredApplication*>(qApp);
    const double paint_s = application != nullptr ? application->paintTime_s() : 0.0;
    const double blocked_s = gap_s - (paint_s - m_paintBefore_s);
    m_paintBefore_s = paint_s;
    m_longest_s = std::max(m_longest_s, blocked_s);
    m_blocks_s.push_back(blocked_s);
}

} // namespace bask
