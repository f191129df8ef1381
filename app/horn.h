#pragma once
// Sounds the desktop's bell until every alarm that still is so has been acknowledged or shelved.

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

/// Priority 1 every kGrave_ms, priority 2 every kLesser_ms, priority 3 once, a notice never. An engine that
/// does not answer sounds like priority 1, kUnanswered times: there is nothing to acknowledge.
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
    /// Once, so that a person hears what it is like, or that the desktop has no bell.
    void sample() { m_sound(); }
    /// Instead of the desktop's bell.
    void setSound(std::function<void()> sound) { m_sound = std::move(sound); }
    bool isSounding() const { return m_again.isActive(); }

private:
    void update(bool once = false);
    void sound();

    HornMode m_mode = HornMode::RealRig;
    bool m_isSimulated = true;
    bool m_isAnswering = true;
    int m_priority = 0;                             ///< of the gravest that calls; 0: none
    std::set<std::pair<std::uint64_t, int>> m_once; ///< those of priority 3 that called, by id and count
    int m_unanswered = 0;
    std::function<void()> m_sound;
    QTimer m_again;
};

} // namespace bask
