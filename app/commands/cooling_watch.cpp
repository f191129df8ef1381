#include "app/commands/cooling_watch.h"

#include "engine/base/message_code.h"
#include "engine/model/hand_warm.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kCooled_K = 2.0; // for kCooled_s: no scatter, nor a controller's swing
constexpr double kCooled_s = 3.0;
constexpr double kRisen_K = 1.0;
constexpr double kStill_s = 10.0;
constexpr double kSilent_s = 10.0; // nothing more is learnt from a source that tells nothing

} // namespace

bool CoolingWatch::isAlarmed(const Snapshot& snapshot) {
    return isActive(snapshot.alarms, MessageCode::SafetySourceHeatsUnasked) ||
           isActive(snapshot.alarms, MessageCode::SafetySourceNotCooling);
}

bool CoolingWatch::isOver(const Snapshot& snapshot) {
    if (snapshot.pending || snapshot.state == RunState::Stopping)
        return false;
    if (snapshot.isSourceManual || isAlarmed(snapshot))
        return true;
    if (!snapshot.source_K)
        return !(snapshot.sourceAge_s < kSilent_s);
    m_hottest_K = std::max(m_hottest_K, *snapshot.source_K);
    m_coolest_K = std::min(m_coolest_K, *snapshot.source_K);
    // What a hand bears need not be seen to cool, only not to heat.
    const bool isHot = *snapshot.source_K > m_room_K + kHandWarm_K;
    if (m_rose_s < 0.0 || isHot || *snapshot.source_K >= m_coolest_K + kRisen_K) {
        m_rose_s = snapshot.clock_s;
        m_coolest_K = *snapshot.source_K;
    }
    if (snapshot.clock_s - m_rose_s >= kStill_s)
        return true;
    if (m_warm_s < 0.0 || *snapshot.source_K > m_hottest_K - kCooled_K)
        m_warm_s = snapshot.clock_s;
    return snapshot.clock_s - m_warm_s >= kCooled_s;
}

} // namespace bask
