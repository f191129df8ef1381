// What goes over a link, as the device console has it, and what a person sends there.

#include "engine/drivers/logged_link.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

struct LoggedLinkTest : testing::Test {
    ManualClock clock;
    std::shared_ptr<TrafficLog> log = std::make_shared<TrafficLog>();
    LinkDesk desk;
    test::ScriptedLink* line = nullptr;
    std::unique_ptr<LoggedLink> link;

    LoggedLinkTest() {
        auto made = std::make_unique<test::ScriptedLink>();
        line = made.get();
        link = std::make_unique<LoggedLink>(std::move(made), log, clock, &desk);
    }
    /// "sent ?, received ok"
    std::string told(std::uint64_t from = 0) const {
        std::string out;
        for (const TrafficLog::Line& each : log->from(from)) {
            out += out.empty() ? "" : ", ";
            out += trafficKindWord(each->kind);
            if (!each->bytes.empty())
                out += " " + shownBytes(each->bytes);
        }
        return out;
    }
};

} // namespace

// Catches bytes that are lost on their way, or told in another order.
TEST_F(LoggedLinkTest, BothDirectionsAreKeptInOrderWithTheirTimes) {
    link->open();
    clock.advance(1.0);
    link->write("?");
    clock.advance(0.5);
    line->say("<Idle>\r\n");
    EXPECT_EQ(link->read(), "<Idle>\r\n");
    EXPECT_EQ(link->read(), "");
    EXPECT_EQ(line->takeSent(), "?");
    EXPECT_EQ(told(), "opened, sent ?, received <Idle>\\r\\n");
    const auto lines = log->from(2);
    ASSERT_EQ(lines.size(), 2U);
    EXPECT_EQ(lines[0]->time_s, 1.0);
    EXPECT_EQ(lines[1]->time_s, 1.5);
    EXPECT_EQ(lines[1]->link, "port");
    line->unplug();
    EXPECT_FALSE(link->isOpen());
    link->write("nobody");
    EXPECT_EQ(told(4), "closed") << "nothing is told as sent to a link that is not there";
}

// Catches an answer to a person that a driver takes for one to its own question, and a driver that does not
// set the device up anew.
TEST_F(LoggedLinkTest, APersonTakesTheLinkFromItsDriver) {
    EXPECT_FALSE(desk.send("port", "$$\n").ok()) << "not open";
    link->open();
    EXPECT_EQ(log->openLinks(), std::vector<std::string>{"port"});
    EXPECT_FALSE(desk.send("other", "$$\n").ok());
    EXPECT_FALSE(desk.send("port", std::string(257, 'x')).ok());
    EXPECT_FALSE(desk.send("port", "").ok());
    line->say("ok");
    EXPECT_TRUE(link->isOpen());
    ASSERT_TRUE(desk.send("port", "$$\n").ok());
    EXPECT_FALSE(link->isOpen());
    EXPECT_EQ(link->problem().code, MessageCode::LinkByHand);
    EXPECT_EQ(link->read(), "");
    link->write("?");
    link->close();
    link->open();
    EXPECT_FALSE(link->isOpen()) << "for 3 s";
    desk.work();
    line->say("$0=10\r\n");
    desk.work();
    EXPECT_EQ(told(2), "sent-by-hand $$\\n, received ok, received $0=10\\r\\n");
    EXPECT_EQ(line->takeSent(), "$$\n");
    clock.advance(2.0);
    ASSERT_TRUE(desk.send("port", "$G\n").ok());
    clock.advance(2.9);
    link->open();
    EXPECT_FALSE(link->isOpen());
    clock.advance(0.2);
    line->say("late");
    EXPECT_FALSE(link->isOpen()) << "until the driver opens it";
    link->open();
    EXPECT_TRUE(link->isOpen());
    EXPECT_EQ(line->opened(), 1) << "opening a port resets an Arduino";
    EXPECT_EQ(link->read(), "");
    EXPECT_EQ(link->problem(), Message{});
}

// Catches a program that goes on counting its lines where its driver begins anew.
TEST_F(LoggedLinkTest, ALinkThatCountsIsOpenedAnewAfterAPerson) {
    auto made = std::make_unique<test::ScriptedLink>("program");
    test::ScriptedLink& program = *made;
    LoggedLink counted(std::move(made), log, clock, &desk, LoggedLink::After::Restarted);
    counted.open();
    ASSERT_TRUE(desk.send("program", "{}\n").ok());
    desk.end();
    counted.open();
    EXPECT_TRUE(counted.isOpen());
    EXPECT_EQ(program.opened(), 2);
}

// Catches a person who keeps a link that is gone, or that a stop needs.
TEST_F(LoggedLinkTest, TheLinkIsGivenBackAtOnce) {
    link->open();
    ASSERT_TRUE(desk.send("port", "?").ok());
    desk.end();
    link->open();
    EXPECT_TRUE(link->isOpen());
    ASSERT_TRUE(desk.send("port", "?").ok());
    line->unplug();
    desk.work();
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    line->plug();
    link->open();
    EXPECT_TRUE(link->isOpen());
    link.reset();
    EXPECT_TRUE(log->openLinks().empty());
    EXPECT_FALSE(desk.send("port", "?").ok());
}

// Catches a log that grows for ever, by time or by a device that babbles.
TEST_F(LoggedLinkTest, TenMinutesAreKeptAndSoMuchMemory) {
    for (int i = 0; i < 700; ++i) {
        log->add(TrafficKind::Received, "port", "x", clock.now_s());
        clock.advance(1.0);
    }
    EXPECT_EQ(log->from(0).size(), 601U);
    EXPECT_EQ(log->from(0).front()->time_s, 99.0);
    EXPECT_EQ(log->from(0, 10).size(), 10U);
    EXPECT_TRUE(log->from(701).empty());
    const std::string megabyte(1 << 20, 'x');
    for (int i = 0; i < 300; ++i)
        log->add(TrafficKind::Received, "port", megabyte, clock.now_s());
    EXPECT_LE(log->from(0).size(), 128U);
    EXPECT_EQ(log->from(0).back()->number, 1000U);
}

// Catches bytes that a person cannot read, or takes for others.
TEST(ShownBytes, TextAsTextTheRestAsNumbers) {
    EXPECT_EQ(shownBytes("G1 X2\r\n"), "G1 X2\\r\\n");
    EXPECT_EQ(shownBytes(std::string("\x11\x04\x00\xff", 4)), "11 04 00 ff");
    EXPECT_EQ(shownBytes(""), "");
}

} // namespace bask
