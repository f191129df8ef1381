#pragma once
// The position of a replay in a record, which moves with the clock.

#include "engine/base/clock.h"

namespace bask {

/// Plays from the record's first to its last moment, 0.1 to 100 times as fast as it was. Passive:
/// position_s() returns the current position.
class Replay {
public:
    static constexpr double kSlowest = 0.1;
    static constexpr double kFastest = 100.0;

    /// The clock must outlive the replay.
    explicit Replay(const Clock& clock) : m_clock(clock) {}

    /// Sets another record, at its beginning. An end before the beginning counts as the beginning.
    void setSpan(double begin_s, double end_s);
    double begin_s() const { return m_begin_s; }
    double end_s() const { return m_end_s; }

    void play(); ///< at the end it starts from the beginning
    void pause();
    bool isPlaying() const; ///< false when the end is reached
    /// Continues from this position; outside of the record it is the nearer end.
    void seek(double time_s);
    double position_s() const;

    void setSpeed(double factor); ///< clamped to kSlowest ... kFastest
    double speed() const { return m_speed; }

private:
    const Clock& m_clock;
    double m_begin_s = 0.0, m_end_s = 0.0;
    double m_speed = 1.0;
    bool m_isPlaying = false;
    double m_from_s = 0.0;  ///< position at m_since_s
    double m_since_s = 0.0; ///< time of the clock then
};

} // namespace bask
