#pragma once
// Checks after a live run that the source is seen to be off. A register that says "off" is no proof.

#include "engine/runtime/snapshot.h"

namespace bask {

/// Takes every snapshot after the end of the run.
class CoolingWatch {
public:
    explicit CoolingWatch(double room_K) : m_room_K(room_K) {}

    /// Returns whether the wait is over: the source has cooled by 2 K, is not hot and does not become warmer,
    /// the engine has raised an alarm about it, it has given no temperature for long, or it is manual. Waits
    /// for an announced retreat and for one in progress.
    bool isOver(const Snapshot& snapshot);
    /// Returns whether the engine has an alarm that the source heats by itself or does not cool.
    static bool isAlarmed(const Snapshot& snapshot);

private:
    double m_room_K;
    double m_hottest_K = 0.0;
    double m_coolest_K = 1e300; ///< minimum since it rose by kRisen_K
    double m_warm_s = -1.0;     ///< when it was last seen not to have cooled, by the rig's clock
    double m_rose_s = -1.0;     ///< when it was last seen hot, or to have grown warmer
};

} // namespace bask
