#include "app/horn.h"

#include "widgets/common/alarm_groups.h"

#include <QApplication>

#include <algorithm>

namespace bask {
namespace {

constexpr int kLeastUrgentHeard = 2;

/// 0: none.
int callingPriority(const std::vector<Alarm>& alarms) {
    int gravest = 0;
    for (const AlarmGroup& group : groupAlarms(alarms).present)
        if (group.isActive() && !group.alarm.isAcknowledged && group.alarm.priority <= kLeastUrgentHeard)
            gravest = gravest == 0 ? group.alarm.priority : std::min(gravest, group.alarm.priority);
    return gravest;
}

} // namespace

Horn::Horn(QObject* parent) : QObject(parent), m_sound([] { QApplication::beep(); }) {
    connect(&m_again, &QTimer::timeout, this, &Horn::sound);
}

void Horn::setMode(HornMode mode) {
    m_mode = mode;
    update();
}

void Horn::apply(const Snapshot& snapshot) {
    m_isSimulated = snapshot.simulated;
    m_priority = callingPriority(snapshot.alarms);
    update();
}

void Horn::setAnswering(bool answering) {
    m_isAnswering = answering;
    m_unanswered = 0;
    update();
}

void Horn::update() {
    const bool isOn = m_mode == HornMode::Always || (m_mode == HornMode::RealRig && !m_isSimulated);
    const int priority = m_isAnswering ? m_priority : 1;
    if (!isOn || priority == 0)
        return m_again.stop();
    const int every_ms = priority == 1 ? kGrave_ms : kLesser_ms;
    if (m_again.isActive() && m_again.interval() == every_ms)
        return;
    m_again.start(every_ms);
    sound();
}

void Horn::sound() {
    m_sound();
    if (!m_isAnswering && ++m_unanswered >= kUnanswered)
        m_again.stop();
}

} // namespace bask
