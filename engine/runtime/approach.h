#pragma once
// Detects whether a robot comes nearer to its goal.

#include "engine/base/message.h"

namespace bask {

/// Returns the fault of a robot that does not come nearer, with the remaining distance.
Message doesNotMove(double left_m);

class Approach {
public:
    void begin(double now_s);
    /// Takes the remaining distance, m or rad.
    void add(double now_s, double left, double period_s);
    /// Returns whether the robot has not come nearer for so long that it will not arrive.
    bool isStill() const { return m_isStill; }

private:
    double m_nearer_s = 0.0, m_left = 0.0;
    bool m_isStill = false;
};

} // namespace bask
