#pragma once
// After a live run: whether its source is seen to be off. A register that says "off" is no proof.

#include "engine/runtime/snapshot.h"

namespace bask {

/// Of each snapshot since the run is over.
class CoolingWatch {
public:
    explicit CoolingWatch(double room_K) : m_room_K(room_K) {}

    /// Nothing more is to be seen: the source has cooled by 2 K, is not hot and grows no warmer, is told to
    /// be an alarm by the engine since it does not, or tells no temperature for long. A retreat that is
    /// announced is waited for.
    bool isOver(const Snapshot& snapshot);
    /// The engine says that the source heats on, or does not cool.
    static bool isAlarmed(const Snapshot& snapshot);

private:
    double m_room_K;
    double m_hottest_K = 0.0;
    double m_coolest_K = 1e300; ///< since it rose by kRisen_K
    double m_warm_s = -1.0;     ///< when it was last seen not to have cooled, by the rig's clock
    double m_rose_s = -1.0;     ///< when it was last seen hot, or to have grown warmer
};

} // namespace bask
