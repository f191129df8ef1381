#include "engine/drivers/link_watch.h"

#include "engine/base/message_code.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

class LinkWatchTest : public testing::Test {
protected:
    /// How often it was just opened.
    int run(double time_s, double answerEvery_s = 1e9) {
        int opened = 0;
        for (double t = 0.0; t < time_s - 1e-9; t += 0.01) {
            const auto turn = m_watch.work();
            opened += turn == LinkWatch::Turn::Opened ? 1 : 0;
            if (turn == LinkWatch::Turn::Open && m_clock.now_s() - m_answered_s >= answerEvery_s) {
                m_answered_s = m_clock.now_s();
                m_watch.answered(0.02);
            }
            m_clock.advance(0.01);
        }
        return opened;
    }

    ManualClock m_clock;
    test::ScriptedLink m_link{"/dev/ttyTEST"};
    LinkWatch m_watch{m_link, m_clock, 1.0};
    double m_answered_s = 0.0;
};

// Catches states that are not what the window shows in words.
TEST_F(LinkWatchTest, statesFollowTheDevicesOwnAnswers) {
    EXPECT_EQ(m_watch.status().link, LinkState::Closed);
    run(0.5);
    EXPECT_EQ(m_watch.status().link, LinkState::Opening);
    EXPECT_EQ(m_watch.error().code(), MessageCode::DeviceSilent);
    run(2.0, 0.1);
    EXPECT_EQ(m_watch.status().link, LinkState::Live);
    EXPECT_NEAR(m_watch.status().rate_Hz, 10.0, 0.5);
    EXPECT_DOUBLE_EQ(m_watch.status().replyTime_s, 0.02);
    run(1.2);
    EXPECT_EQ(m_watch.status().link, LinkState::Lost);
    EXPECT_EQ(m_watch.status().problem.code, MessageCode::DeviceSilent);
    EXPECT_EQ(m_watch.status().rate_Hz, 0.0);
}

// Catches a dead port that is tried again and again, or not at all.
TEST_F(LinkWatchTest, aDeadPortIsTriedEveryHalfSecond) {
    m_link.unplug();
    EXPECT_EQ(run(10.0), 0);
    EXPECT_GE(m_link.opened(), 19);
    EXPECT_LE(m_link.opened(), 20);
    EXPECT_EQ(m_watch.status().link, LinkState::Opening);
    EXPECT_EQ(m_watch.status().problem.code, MessageCode::LinkNotOpened);
    m_link.plug();
    EXPECT_EQ(run(0.55), 1);
}

// Catches a silent device on a good cable that is never opened anew.
TEST_F(LinkWatchTest, aSilentDeviceIsOpenedAnew) {
    EXPECT_EQ(run(0.5), 1);
    EXPECT_EQ(run(15.0), 10) << "each after a second of silence and half a second of rest";
    run(2.0, 0.1);
    EXPECT_EQ(m_watch.status().link, LinkState::Live);
    EXPECT_EQ(m_watch.status().problem, Message{});
}

// Catches a device called silent because the engine did not listen.
TEST_F(LinkWatchTest, anEngineThatWasHeldUpListensFirst) {
    run(1.0, 0.1);
    m_clock.advance(30.0);
    EXPECT_FALSE(m_watch.isLive()) << "nobody knows";
    EXPECT_EQ(m_watch.work(), LinkWatch::Turn::Open);
    m_watch.answered();
    EXPECT_TRUE(m_watch.isLive());
    EXPECT_EQ(m_link.opened(), 1);
}

// Catches a wrong answer that is not told, or for ever, or with bytes that cannot be shown.
TEST_F(LinkWatchTest, aDiscardedAnswerIsToldForAWhile) {
    run(1.0, 0.1);
    m_watch.discarded("ok\x93 " + std::string(100, 'x'));
    EXPECT_EQ(m_watch.discards(), 1);
    EXPECT_EQ(m_watch.status().link, LinkState::Live);
    EXPECT_EQ(m_watch.status().problem, (Message{MessageCode::DeviceAnswersWrong,
                                                 {"/dev/ttyTEST", "\"ok. " + std::string(36, 'x') + "\""}}));
    run(2.1, 0.1);
    EXPECT_EQ(m_watch.status().problem, Message{});
}

} // namespace
} // namespace bask
