#include "widgets/review/replay.h"

#include <gtest/gtest.h>

using namespace bask;

// Catches a replay of the wrong speed, or one that runs on while it pauses.
TEST(Replay, GoesWithTheClock) {
    ManualClock clock;
    clock.advance(1000.0);
    Replay replay(clock);
    replay.setSpan(2.0, 102.0);
    EXPECT_EQ(replay.position_s(), 2.0);
    clock.advance(5.0);
    EXPECT_EQ(replay.position_s(), 2.0) << "it stands until it is played";
    replay.play();
    clock.advance(3.0);
    EXPECT_DOUBLE_EQ(replay.position_s(), 5.0);
    replay.setSpeed(10.0);
    clock.advance(1.0);
    EXPECT_DOUBLE_EQ(replay.position_s(), 15.0);
    replay.pause();
    clock.advance(60.0);
    EXPECT_DOUBLE_EQ(replay.position_s(), 15.0);
    replay.setSpeed(0.1);
    replay.play();
    clock.advance(10.0);
    EXPECT_DOUBLE_EQ(replay.position_s(), 16.0);
}

// Catches a position outside of the record, and an end that still counts as playing.
TEST(Replay, EndsAtTheEndAndBeginsAgain) {
    ManualClock clock;
    Replay replay(clock);
    replay.setSpan(0.0, 10.0);
    replay.setSpeed(100.0);
    replay.play();
    EXPECT_TRUE(replay.isPlaying());
    clock.advance(1.0);
    EXPECT_EQ(replay.position_s(), 10.0);
    EXPECT_FALSE(replay.isPlaying());
    replay.seek(4.0); // while it was on: it goes on from there
    EXPECT_TRUE(replay.isPlaying());
    clock.advance(0.01);
    EXPECT_DOUBLE_EQ(replay.position_s(), 5.0);
    clock.advance(1.0);
    replay.pause();
    replay.play();
    EXPECT_EQ(replay.position_s(), 0.0) << "played from the end it begins anew";
    replay.seek(-5.0);
    EXPECT_EQ(replay.position_s(), 0.0);
    replay.seek(50.0);
    EXPECT_EQ(replay.position_s(), 10.0);
    replay.setSpan(0.0, 3.0);
    EXPECT_FALSE(replay.isPlaying());
    EXPECT_EQ(replay.position_s(), 0.0);
}

// Catches a jump when the speed changes in mid-play, and speeds that make no sense.
TEST(Replay, ASpeedChangeDoesNotJump) {
    ManualClock clock;
    Replay replay(clock);
    replay.setSpan(0.0, 1000.0);
    replay.play();
    clock.advance(100.0);
    for (const double factor : {0.5, 20.0, 0.0, 1e9}) {
        const double before_s = replay.position_s();
        replay.setSpeed(factor);
        EXPECT_DOUBLE_EQ(replay.position_s(), before_s) << factor;
        EXPECT_GE(replay.speed(), Replay::kSlowest);
        EXPECT_LE(replay.speed(), Replay::kFastest);
    }
    replay.setSpan(5.0, 1.0);
    EXPECT_EQ(replay.end_s(), 5.0);
    replay.play();
    EXPECT_FALSE(replay.isPlaying()) << "nothing to play";
}
