#pragma once
// What a person at the command line says of a real robot's place before a run, and the order that makes it
// sure.

#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <optional>

namespace bask {

enum class LivePlace {
    AsFound,   ///< it must be sure already
    Confirmed, ///< it is where its controller says
    Home       ///< it is to be found by the robot's switches: it moves
};

class PlaceOrders {
public:
    explicit PlaceOrders(LivePlace place) : m_place(place) {}

    /// Whether there is something to do or to wait for still: a robot that answers and is not sure.
    bool isPending(const Snapshot& snapshot) const {
        return m_place != LivePlace::AsFound && !snapshot.isPlaceSure;
    }
    /// At most one in kAgain_s, and none while the robot moves.
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
