// Which verbs the window offers by what the engine reports.

#include "app/actions.h"

#include <QWidget>

#include <gtest/gtest.h>

namespace bask {

// Catches a robot that moves by itself, to calibrate a camera, while Hold and its key F7 are greyed out.
TEST(Actions, HoldIsOfferedWhileTheRobotMovesWithoutARun) {
    QWidget window;
    Actions actions(&window);
    for (const RunState state : {RunState::NotReady, RunState::Ready, RunState::Stopped}) {
        Snapshot snapshot;
        snapshot.state = state;
        actions.apply(snapshot);
        EXPECT_FALSE(actions.verb(Verb::Hold)->isEnabled());
        snapshot.isMoving = true;
        actions.apply(snapshot);
        EXPECT_TRUE(actions.verb(Verb::Hold)->isEnabled());
        EXPECT_TRUE(actions.verb(Verb::EmergencyStop)->isEnabled());
        EXPECT_FALSE(actions.verb(Verb::Resume)->isEnabled());
    }
}

} // namespace bask
