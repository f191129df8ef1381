#include "app/horn.h"

#include "engine/base/notice.h"
#include "widgets/common/alarm_groups.h"

#include <QApplication>

#include <algorithm>

namespace bask {
namespace {

constexpr int kHeardOnce = 3; ///< priority

bool calls(const AlarmGroup& group) {
    return group.isCalling() && !isNotice(group.alarm.message.code);
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
    m_isSimulated = snapshot.simulated && std::ranges::none_of(snapshot.alarms, &Alarm::isLive);
    m_priority = 0;
    std::set<std::pair<std::uint64_t, int>> once;
    for (const AlarmGroup& group : groupAlarms(snapshot.alarms).present) {
        if (!calls(group))
            continue;
        const Alarm& alarm = group.alarm;
        m_priority = m_priority == 0 ? alarm.priority : std::min(m_priority, alarm.priority);
        if (alarm.priority == kHeardOnce)
            once.emplace(alarm.id, alarm.count);
    }
    const bool isNew = !std::ranges::includes(m_once, once);
    m_once = std::move(once);
    update(isNew);
}

void Horn::setAnswering(bool answering) {
    m_isAnswering = answering;
    m_unanswered = 0;
    update();
}

void Horn::update(bool once) {
    const bool isOn = m_mode == HornMode::Always || (m_mode == HornMode::RealRig && !m_isSimulated);
    const int priority = m_isAnswering ? m_priority : 1;
    if (!isOn || priority == 0 || priority == kHeardOnce) {
        m_again.stop();
        if (isOn && once)
            m_sound();
        return;
    }
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
