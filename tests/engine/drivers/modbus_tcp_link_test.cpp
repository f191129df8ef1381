// Modbus TCP over bytes, to simulated units by hand's time.

#include "engine/base/message_code.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/protocols/modbus_frame.h"
#include "tests/engine/drivers/modbus_fixture.h"
#include "tests/engine/drivers/test_links.h"

namespace bask {
namespace {

using Registers = std::vector<std::uint16_t>;

/// The frames and the behaviour are those of the protocol; the bytes are a test's or a simulator's.
template <class Bytes> class TcpOver : public testing::Test {
protected:
    void join(std::unique_ptr<Bytes> made) {
        line = made.get();
        link = std::make_unique<ModbusTcpLink>(std::move(made), clock);
        link->open();
    }

    ManualClock clock;
    Bytes* line = nullptr;
    std::unique_ptr<ModbusTcpLink> link;
};

class ModbusTcpLinkTest : public TcpOver<test::DeviceLink> {
protected:
    ModbusTcpLinkTest() {
        units.addThermometer(1, test::shipped("labjack-t7-thermocouples"), 300.0);
        units.addThermometer(3, test::shipped("modmux-pm6rtd"), 293.15);
        units.setTemperature(3, 1, 333.15);
        units.addController(4, test::shipped("pixsys-drr245"));
        join(std::make_unique<test::DeviceLink>(units, clock));
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
    void fault(const char* name) { ASSERT_TRUE(units.setFault(name).ok()) << name; }

    ModbusSimulator units{ModbusSimulator::Frames::Tcp};
};

class ModbusTcpBytesTest : public TcpOver<test::ScriptedLink> {
protected:
    ModbusTcpBytesTest() { join(std::make_unique<test::ScriptedLink>()); }
    /// The answer to reading one register of unit 3, with its number there.
    static std::string answer(int transaction, int value, int unit = 3, int function = 4) {
        return modbusTcpFrame(transaction,
                              std::string{static_cast<char>(unit), static_cast<char>(function), 2,
                                          static_cast<char>(value >> 8), static_cast<char>(value)});
    }
    int askOne() { return link->send({3, 4, 1, 1}); }
    static int sentTransaction(const std::string& bytes) {
        return static_cast<unsigned char>(bytes.at(0)) << 8 | static_cast<unsigned char>(bytes.at(1));
    }
    std::string wrong(const std::string& bytes) {
        const int number = askOne();
        line->say(bytes);
        const auto reply = link->takeReply(number);
        if (!reply)
            return "no reply";
        EXPECT_FALSE(reply->ok());
        return describe(reply->error());
    }
};

} // namespace

// Catches requests or replies that are put together or taken apart wrongly, and units that are mixed up.
TEST_F(ModbusTcpLinkTest, ReadsAndWrites) {
    EXPECT_EQ(ask({3, 4, 1, 3}).value(), (Registers{200, 600, 200}));
    EXPECT_TRUE(ask({4, 6, 1001, 1, {800}}).value().empty());
    EXPECT_EQ(ask({4, 3, 1000, 2}).value(), (Registers{230, 800}));
    EXPECT_TRUE(ask({4, 16, 1001, 1, {700}}).value().empty());
    EXPECT_EQ(units.registerAt(4, 3, 1001), 700);
    EXPECT_EQ(link->discarded(), 0);
    const ModbusReply refused = ask({3, 4, 500, 1});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::DeviceException);
    EXPECT_EQ(argTexts(refused.error().message), (std::vector<std::string>{"port", "3", "2"}));
}

// Promise: a reply that does not fit is never used; the next question is answered rightly again.
TEST_F(ModbusTcpLinkTest, RepliesThatDoNotFitAreNotUsed) {
    for (const auto& [name, code] :
         {std::pair("short-reply", MessageCode::DeviceAnswersWrong),
          std::pair("wrong-unit", MessageCode::DeviceAnswersWrong),
          std::pair("wrong-id", MessageCode::DeviceSilent), std::pair("silent", MessageCode::DeviceSilent),
          std::pair("garbage", MessageCode::DeviceSilent),
          std::pair("exception", MessageCode::DeviceException)}) {
        fault(name);
        EXPECT_EQ(refusal({3, 4, 1, 2}), code) << name;
        fault("none");
        if (!link->isOpen())
            link->open();
        EXPECT_EQ(ask({3, 4, 1, 2}).value(), (Registers{200, 600})) << name;
    }
}

// Catches 60.0 degC of channel 2 told for channel 1, and a line that is kept silent for nothing.
TEST_F(ModbusTcpLinkTest, ALateReplyIsNotTakenForTheNextOne) {
    fault("late-reply");
    EXPECT_EQ(refusal({3, 4, 2, 1}), MessageCode::DeviceSilent);
    EXPECT_TRUE(link->isFree());
    fault("none");
    for (int i = 0; i < 50; ++i)
        EXPECT_EQ(ask({3, 4, 1, 1}).value(), Registers{200});
    EXPECT_EQ(link->discarded(), 1);
}

// Catches a request that is left open by a cut, and a link that is open although nobody answers.
TEST_F(ModbusTcpLinkTest, ACutAndALongSilenceEndTheLink) {
    const int number = link->send({3, 4, 1, 1});
    line->unplug();
    EXPECT_FALSE(link->isFree());
    const auto reply = link->takeReply(number);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->error().code(), MessageCode::DeviceSilent);
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    line->plug();
    link->open();
    EXPECT_EQ(link->problem().code, MessageCode::None);
    fault("silent");
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(refusal({3, 4, 1, 1}), MessageCode::DeviceSilent) << i;
    EXPECT_FALSE(link->isOpen()) << "a host that vanished is not told by its own end of the connection";
    EXPECT_EQ(link->problem().code, MessageCode::DeviceSilent);
}

// Catches heat that stays on for the sake of a question that is not answered.
TEST_F(ModbusTcpLinkTest, OffOvertakesAQuestion) {
    fault("silent");
    const int number = link->send({3, 4, 1, 1});
    EXPECT_FALSE(link->mayOvertake());
    EXPECT_THROW(link->overtake({4, 6, 1016, 1, {0}}), std::logic_error);
    EXPECT_THROW(link->send({4, 6, 1016, 1, {0}}), std::logic_error);
    clock.advance(ModbusTcpLink::kOvertake_s + 0.01);
    fault("none");
    ASSERT_TRUE(link->mayOvertake());
    const int off = link->overtake({4, 6, 1016, 1, {0}});
    EXPECT_EQ(link->takeReply(number).value().error().code(), MessageCode::DeviceSilent);
    std::optional<ModbusReply> reply;
    EXPECT_TRUE(until([&] { return (reply = link->takeReply(off)).has_value(); }));
    EXPECT_TRUE(reply.value().ok());
}

// Catches a header that no other Modbus device understands.
TEST_F(ModbusTcpBytesTest, HasTheFramesOfTheSpecification) {
    const int number = askOne();
    const std::string sent = line->takeSent();
    ASSERT_EQ(sent.size(), 12U);
    EXPECT_EQ(sent.substr(2), std::string({0, 0, 0, 6, 3, 4, 0, 1, 0, 1}));
    const std::string whole = answer(sentTransaction(sent), 215);
    for (std::size_t i = 0; i < whole.size(); ++i) { // a network may cut anywhere
        EXPECT_FALSE(link->takeReply(number)) << i;
        line->say(whole.substr(i, 1));
    }
    EXPECT_EQ(link->takeReply(number).value().value(), Registers{215});
    const int next = askOne();
    EXPECT_NE(sentTransaction(line->takeSent()), sentTransaction(sent));
    EXPECT_FALSE(link->takeReply(next));
}

// Catches a reply that is believed although its unit, function or size is another's.
TEST_F(ModbusTcpBytesTest, EveryPartOfAReplyMustFit) {
    EXPECT_NE(wrong(answer(1, 215, 4)).find("another unit"), std::string::npos);
    EXPECT_NE(wrong(answer(2, 215, 3, 3)).find("another function"), std::string::npos);
    EXPECT_NE(wrong(modbusTcpFrame(3, std::string({3, 4, 2, 0}))).find("number of registers"),
              std::string::npos);
    EXPECT_NE(wrong(modbusTcpFrame(4, std::string({3, 4, 4, 0, 1, 0, 2}))).find("number of registers"),
              std::string::npos);
    EXPECT_NE(wrong(modbusTcpFrame(5, std::string({3, 4, 0}))).find("number of registers"),
              std::string::npos);
    EXPECT_TRUE(link->isOpen());
    EXPECT_EQ(link->discarded(), 5);
}

// Catches a link that waits for the rest of a frame that never was one, and answers out of it.
TEST_F(ModbusTcpBytesTest, GarbageEndsTheLinkAtOnce) {
    for (const std::string& garbage :
         {std::string("HTTP/1.1 400 Bad Request\r\n"), std::string("\0\1\0\0\xff\xff\x03\x04", 8),
          std::string("\0\1\0\0\0\1\x03", 7), std::string(300, '\xff'), std::string(70000, 'x')}) {
        link->open();
        const int number = askOne();
        line->say(garbage + answer(number, 999));
        const auto reply = link->takeReply(number);
        ASSERT_TRUE(reply && !reply->ok());
        EXPECT_FALSE(link->isOpen());
        EXPECT_EQ(link->problem().code, MessageCode::DeviceAnswersWrong);
    }
    link->open();
    const int number = askOne();
    line->say(answer(number, 215));
    EXPECT_EQ(link->takeReply(number).value().value(), Registers{215}) << "nothing of before is left";
}

// Catches a number of requests beyond 16 bits, which is no longer that of the reply.
TEST_F(ModbusTcpBytesTest, TheNumberOfARequestBeginsAnew) {
    int number = 0;
    for (int i = 0; i < 65537; ++i) {
        number = askOne();
        line->say(answer(sentTransaction(line->takeSent()), i & 0x7fff));
        ASSERT_TRUE(link->takeReply(number).value().ok()) << i;
    }
    EXPECT_EQ(number, 65537);
}

} // namespace bask
