// Modbus RTU over bytes, to the simulated line by hand's time.

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/drivers/rtu_link.h"
#include "engine/protocols/modbus_frame.h"
#include "tests/engine/drivers/modbus_fixture.h"
#include "tests/engine/drivers/test_links.h"

namespace bask {
namespace {

using Registers = std::vector<std::uint16_t>;

class RtuLinkTest : public testing::Test {
protected:
    RtuLinkTest() {
        sim.addThermometer(3, test::shipped("modmux-pm6rtd"), 293.15);
        sim.setTemperature(3, 1, 333.15);
        sim.addController(4, test::shipped("pixsys-drr245"));
        auto made = std::make_unique<test::DeviceLink>(sim, clock);
        line = made.get();
        link = std::make_unique<RtuLink>(std::move(made), SerialSettings{19200, 8, 'N', 1}, clock);
        link->open();
    }
    template <class Condition> bool until(Condition condition, double limit_s = 3.0) {
        for (const double end_s = clock.now_s() + limit_s; !condition(); clock.advance(0.002)) {
            if (clock.now_s() > end_s)
                return false;
            line->work();
        }
        return true;
    }
    ModbusReply ask(const ModbusRequest& request) {
        EXPECT_TRUE(until([&] { return link->isFree(); }));
        const int number = link->send(request);
        std::optional<ModbusReply> reply;
        EXPECT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
        return reply.value_or(Error(MessageCode::None, "no reply"));
    }
    MessageCode refusal(const ModbusRequest& request) {
        const ModbusReply reply = ask(request);
        return reply ? MessageCode::None : reply.error().code();
    }
    void fault(const char* name) { ASSERT_TRUE(sim.setFault(name).ok()); }

    ManualClock clock;
    ModbusSimulator sim;
    test::DeviceLink* line = nullptr;
    std::unique_ptr<RtuLink> link;
};

} // namespace

// Catches requests or replies that are put together or taken apart wrongly.
TEST_F(RtuLinkTest, ReadsAndWrites) {
    EXPECT_EQ(ask({3, 4, 1, 3}).value(), (Registers{200, 600, 200}));
    EXPECT_TRUE(ask({4, 6, 1001, 1, {800}}).value().empty());
    EXPECT_EQ(ask({4, 3, 1000, 2}).value(), (Registers{230, 800}));
    EXPECT_TRUE(ask({4, 16, 1001, 1, {700}}).value().empty());
    EXPECT_EQ(sim.registerAt(4, 3, 1001), 700);
    EXPECT_EQ(link->discarded(), 0);
}

// Catches a refusal taken for silence or for registers.
TEST_F(RtuLinkTest, ExceptionsAreTold) {
    const ModbusReply reply = ask({3, 4, 500, 1});
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().code(), MessageCode::DeviceException);
    EXPECT_EQ(argTexts(reply.error().message), (std::vector<std::string>{"port", "3", "2"}));
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200}) << "and the line goes on";
}

// Catches a reply that does not fit and is used, or that keeps the next one from being used.
TEST_F(RtuLinkTest, RepliesThatDoNotFitAreNotUsed) {
    const ModbusRequest two{3, 4, 1, 2};
    for (const auto& [name, code] :
         {std::pair("short-reply", MessageCode::DeviceAnswersWrong),
          std::pair("wrong-unit", MessageCode::DeviceSilent), std::pair("bad-crc", MessageCode::DeviceSilent),
          std::pair("silent", MessageCode::DeviceSilent)}) {
        fault(name);
        EXPECT_EQ(refusal(two), code) << name;
        fault("none");
        EXPECT_EQ(ask(two).value(), (Registers{200, 600})) << name;
    }
    EXPECT_EQ(link->discarded(), 1);
}

// Catches a reply that is lost because of noise before it.
TEST_F(RtuLinkTest, NoiseBeforeAReplyIsSkipped) {
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({3, 4, 1, 1});
    line->inject(std::string("\x00\xff\x03", 3));
    std::optional<ModbusReply> reply;
    ASSERT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
    EXPECT_EQ(reply->value(), Registers{200});
}

// Catches 60.0 degC of channel 2 told for channel 1: a late reply fits by unit and function.
TEST_F(RtuLinkTest, ALateReplyIsNotTakenForTheNextOne) {
    fault("late-reply");
    EXPECT_EQ(refusal({3, 4, 2, 1}), MessageCode::DeviceSilent);
    fault("none");
    EXPECT_FALSE(ask({3, 4, 1, 1}).ok()) << "a reply, but to which question?";
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
}

// Catches an order to switch off that waits for an answer that does not come, or that goes out into a
// question or an answer on the line; and what it went before taken for its answer.
TEST_F(RtuLinkTest, AnOffOvertakesWhatIsUnderWay) {
    const ModbusRequest off{4, 6, 1001, 1, {0}};
    fault("silent");
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int question = link->send({4, 3, 1001, 1});
    EXPECT_FALSE(link->mayOvertake());
    EXPECT_THROW(link->overtake(off), std::logic_error);
    const double sent_s = clock.now_s();
    ASSERT_TRUE(until([&] { return link->mayOvertake(); }));
    EXPECT_GE(clock.now_s() - sent_s, RtuLink::kOvertake_s);
    EXPECT_LE(clock.now_s() - sent_s, RtuLink::kOvertake_s + 0.02) << "16 bytes and a gap at 19200 baud";
    fault("none");
    const int number = link->overtake(off);
    const auto given = link->takeReply(question);
    ASSERT_TRUE(given.has_value());
    EXPECT_EQ(given->error().code(), MessageCode::DeviceSilent);
    line->inject(modbusReadReply(4, 3, {800})); // late
    std::optional<ModbusReply> reply;
    ASSERT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
    EXPECT_TRUE(reply->ok()) << "the late answer is of another function";
    EXPECT_EQ(sim.registerAt(4, 3, 1001), 0);
    EXPECT_FALSE(ask({4, 3, 1000, 1}).ok()) << "it may be the late one";
    EXPECT_TRUE(ask({4, 3, 1000, 1}).ok());

    fault("silent");
    EXPECT_EQ(refusal({3, 4, 1, 1}), MessageCode::DeviceSilent);
    EXPECT_FALSE(link->isFree()) << "silence after it";
    EXPECT_TRUE(link->mayOvertake()) << "which is not for an off";
}

// Catches an off, or a question, that is lost in an exception since a byte came after the line was asked
// whether it is free.
TEST_F(RtuLinkTest, AByteThatComesInBetweenThrowsNothing) {
    const ModbusRequest off{4, 6, 1001, 1, {0}};
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    line->inject("x");
    EXPECT_NO_THROW(link->send({4, 3, 1001, 1}));
    clock.advance(0.05);
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    ASSERT_TRUE(link->mayOvertake());
    line->inject("x");
    EXPECT_NO_THROW(link->overtake(off));
    ASSERT_TRUE(until([&] { return sim.registerAt(4, 3, 1001) == 0; }));
}

// Catches a value that looks newer than it is: it waited in the line while the engine was held up.
TEST_F(RtuLinkTest, WhatWaitedThroughAHoldUpIsNotUsed) {
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({3, 4, 1, 1});
    for (int i = 0; i < 250; ++i) { // nobody looks
        clock.advance(0.002);
        line->work();
    }
    const auto reply = link->takeReply(number);
    ASSERT_TRUE(reply.has_value());
    ASSERT_FALSE(reply->ok());
    EXPECT_EQ(reply->error().code(), MessageCode::DeviceSilent);
    EXPECT_FALSE(link->isFree()) << "the line is kept silent";
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
}

// Catches two requests on the line at once, and a frame that follows another without a gap.
TEST_F(RtuLinkTest, OneRequestAtATime) {
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({3, 4, 1, 1});
    EXPECT_FALSE(link->isFree());
    EXPECT_THROW(link->send({3, 4, 1, 1}), std::logic_error);
    ASSERT_TRUE(until([&] { return link->takeReply(number).has_value(); }));
    EXPECT_FALSE(link->isFree()) << "three and a half bytes of silence";
    EXPECT_FALSE(link->takeReply(number).has_value()) << "once";
    clock.advance(0.0025);
    EXPECT_TRUE(link->isFree());
}

// Catches a request that is left open for ever, or a line that does not come back, when it is unplugged.
TEST_F(RtuLinkTest, UnpluggedItEndsTheRequestAndComesBack) {
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({3, 4, 1, 1});
    line->unplug();
    EXPECT_FALSE(link->isOpen());
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    const auto reply = link->takeReply(number);
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(reply->error().code(), MessageCode::DeviceSilent);
    link->open();
    EXPECT_EQ(link->problem().code, MessageCode::LinkNotOpened);
    line->plug();
    link->open();
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
}

// Catches a port that hangs and is never opened anew.
TEST_F(RtuLinkTest, APortWithoutAnyAnswerIsClosedToBeOpenedAnew) {
    fault("silent");
    int asked = 0;
    for (; link->isOpen() && asked < 20; ++asked) {
        EXPECT_EQ(refusal({3, 4, 1, 1}), MessageCode::DeviceSilent);
        until([&] { return link->isFree() || !link->isOpen(); });
    }
    EXPECT_EQ(asked, 10);
    EXPECT_EQ(link->problem().code, MessageCode::DeviceSilent);
    link->open();
    fault("none");
    EXPECT_EQ(link->problem().code, MessageCode::None);
    EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
}

} // namespace bask
