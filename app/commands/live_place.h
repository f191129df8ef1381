#pragma once
// What a person states at the command line about a real robot's position before a run, and the command that
// makes it sure.

#include "engine/monitor/monitor_settings.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <optional>
#include <vector>

namespace bask {

enum class LivePlace {
    AsFound,   ///< it must be sure already
    Confirmed, ///< the position that its controller reports is right
    Home       ///< home the robot with its switches: it moves
};

/// How a run on a real rig begins.
struct LiveStart {
    LivePlace place = LivePlace::AsFound;
    std::vector<Command> allowed{}; ///< by allowedPrograms()
    MonitorSettings monitor{};      ///< where the run is published
};

class PlaceOrders {
public:
    explicit PlaceOrders(LivePlace place) : m_place(place) {}

    /// Returns whether something must still be done or awaited: the robot answers and its position is not
    /// sure.
    bool isPending(const Snapshot& snapshot) const {
        return m_place != LivePlace::AsFound && !snapshot.isPlaceSure;
    }
    /// Returns at most one command in kAgain_s, and none while the robot moves.
    std::optional<Command> next(const Snapshot& snapshot) {
        constexpr double kAgain_s = 2.0;
        if (!isPending(snapshot) || snapshot.isMoving || snapshot.clock_s < m_next_s)
            return std::nullopt;
        m_next_s = snapshot.clock_s + kAgain_s;
        if (m_place == LivePlace::Home)
            return HomeRobot{};
        return ClearRobotAlarm{};
    }

private:
    LivePlace m_place;
    double m_next_s = 0.0;
};

} // namespace bask
