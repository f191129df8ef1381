#pragma once
// Sounds the desktop's bell until every active alarm is acknowledged or shelved.

#include "engine/runtime/snapshot.h"

#include <QObject>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <set>
#include <utility>

namespace bask {

/// When the horn sounds.
enum class HornMode { Off, RealRig, Always };

/// Sounds for priority 1 every kGrave_ms, for priority 2 every kLesser_ms, for priority 3 once, and for a
/// notice never. An engine that does not answer sounds like priority 1, kUnanswered times, since there is
/// nothing to acknowledge.
class Horn : public QObject {
    Q_OBJECT

public:
    static constexpr int kGrave_ms = 2000;
    static constexpr int kLesser_ms = 10000;
    static constexpr int kUnanswered = 15;

    explicit Horn(QObject* parent = nullptr);

    void setMode(HornMode mode);
    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);
    /// Sounds once, so that a person hears the sound, or that the desktop has no bell.
    void sample() { m_sound(); }
    /// Replaces the desktop's bell.
    void setSound(std::function<void()> sound) { m_sound = std::move(sound); }
    bool isSounding() const { return m_again.isActive(); }

private:
    void update(bool once = false);
    void sound();

    HornMode m_mode = HornMode::RealRig;
    bool m_isSimulated = true;
    bool m_isAnswering = true;
    int m_priority = 0; ///< priority of the most serious alarm that sounds; 0 for none
    /// alarms of priority 3 that have sounded, by id and count
    std::set<std::pair<std::uint64_t, int>> m_once;
    int m_unanswered = 0;
    std::function<void()> m_sound;
    QTimer m_again;
};

} // namespace bask
