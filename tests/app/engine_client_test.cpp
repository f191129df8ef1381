#include "app/document.h"
#include "app/engine_client.h"
#include "engine/base/message_code.h"
#include "tests/support/wait_for.h"

#include <QElapsedTimer>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

// Catches: commands or snapshots that do not cross the threads, and a rig whose readings do not move before a
// run.
TEST(EngineClient, ReadingsComeWithoutARun) {
    EngineClient client;
    Snapshot last;
    QObject::connect(&client, &EngineClient::snapshot, [&](const Snapshot& snapshot) { last = snapshot; });
    client.start();
    client.send(LoadExperiment{Document::blank()});
    client.send(SetSimulationSpeed{20.0});
    ASSERT_TRUE(waitFor([&] { return last.state == RunState::Ready; }));
    ASSERT_EQ(last.latest.objects.size(), 1U);
    EXPECT_TRUE(client.answering());
}

TEST(EngineClient, ARefusalComesBack) {
    EngineClient client;
    Message refusal;
    QObject::connect(&client, &EngineClient::snapshot, [&](const Snapshot& snapshot) {
        if (snapshot.refusal.code != MessageCode::None)
            refusal = snapshot.refusal;
    });
    client.start();
    client.send(Start{});
    ASSERT_TRUE(waitFor([&] { return refusal.code != MessageCode::None; }));
    EXPECT_EQ(refusal.code, MessageCode::ReasonNoExperiment);
}

// Catches: a shutdown that hangs, and one after which snapshots still arrive.
TEST(EngineClient, ShutsDownWithinItsBound) {
    EngineClient client;
    bool over = false;
    bool late = false;
    QObject::connect(&client, &EngineClient::snapshot, [&] { late = late || over; });
    client.start();
    client.send(LoadExperiment{Document::blank()});
    QElapsedTimer timer;
    timer.start();
    EXPECT_TRUE(client.shutDown(std::chrono::seconds(30)));
    over = true;
    EXPECT_LT(timer.elapsed(), 30'000);
    client.send(EmergencyStop{}); // must not crash
    QCoreApplication::processEvents();
    EXPECT_FALSE(late);
}

} // namespace
} // namespace bask::test
