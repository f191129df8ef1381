// The link to Modbus devices, by real bytes through a pseudo-terminal to the simulated line.

#include "engine/base/units.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_thermometer.h"
#include "tests/engine/drivers/modbus_line_fixture.h"
#include "tests/support/shipped_profile.h"

#include <QEventLoop>
#include <QTimer>

#include <ctime>

namespace bask {
namespace {

using Registers = std::vector<std::uint16_t>;

using test::shipped;

double processorTime_s() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Events alone, nothing asked: what an idle program spends.
void idle(int ms) {
    QEventLoop loop;
    QTimer::singleShot(ms, &loop, &QEventLoop::quit);
    loop.exec();
}

class SimulatedLineTest : public test::ModbusLineTest {
protected:
    SimulatedLineTest() {
        sim.addThermometer(3, shipped("modmux-pm6rtd"), 293.15);
        sim.setTemperature(3, 1, 333.15);
        sim.addController(4, shipped("pixsys-drr245"));
        plugIn();
    }
    ~SimulatedLineTest() override { link.reset(); }

    void plugIn() { server = PtyServer::create(sim, port).value(); }
    void farEnd() override {
        if (server && !isStopped)
            server->work(clock.now_s());
    }
    void fault(const char* name) { ASSERT_TRUE(sim.setFault(name).ok()); }

    ModbusSimulator sim;
    std::unique_ptr<PtyServer> server;
    bool isStopped = false; ///< as by SIGSTOP: what is sent waits in the line
};

// Catches requests or replies that are put together or taken apart wrongly.
TEST_F(SimulatedLineTest, ReadsAndWrites) {
    EXPECT_FALSE(link);
    openLink();
    ASSERT_TRUE(link->isOpen()) << describe(link->problem());
    EXPECT_EQ(link->name(), port);
    EXPECT_EQ(answered({3, 4, 1, 3}).value(), (Registers{200, 600, 200}));
    EXPECT_TRUE(answered({4, 6, 1001, 1, {800}}).value().empty());
    EXPECT_EQ(answered({4, 3, 1000, 2}).value(), (Registers{230, 800}));
    EXPECT_TRUE(answered({4, 16, 1001, 1, {700}}).value().empty());
    EXPECT_EQ(sim.registerAt(4, 3, 1001), 700);
    EXPECT_EQ(link->discarded(), 0);
}

// Catches a refusal taken for silence or for registers.
TEST_F(SimulatedLineTest, ExceptionsAreTold) {
    openLink();
    const ModbusReply reply = ask({3, 4, 500, 1});
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().code(), MessageCode::DeviceException);
    EXPECT_EQ(argTexts(reply.error().message), (std::vector<std::string>{port, "3", "2"}));
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200}) << "and the line goes on";
}

// Promise: a reply that does not fit is never used; the next question is answered rightly again.
TEST_F(SimulatedLineTest, RepliesThatDoNotFitAreNotUsed) {
    openLink();
    const ModbusRequest two{3, 4, 1, 2};
    for (const auto& [name, code] :
         {std::pair("short-reply", MessageCode::DeviceAnswersWrong),
          std::pair("wrong-unit", MessageCode::DeviceSilent), std::pair("bad-crc", MessageCode::DeviceSilent),
          std::pair("silent", MessageCode::DeviceSilent)}) {
        fault(name);
        EXPECT_EQ(refusal(two), code) << name;
        fault("none");
        EXPECT_EQ(answered(two).value(), (Registers{200, 600})) << name;
    }
    EXPECT_EQ(link->discarded(), 1) << "the short one";
}

// Catches a silent device that holds up the line for longer than it must.
TEST_F(SimulatedLineTest, ADeadlineOfItsOwn) {
    openLink();
    fault("silent");
    const double before_s = clock.now_s();
    EXPECT_EQ(refusal({3, 4, 1, 1}), MessageCode::DeviceSilent);
    const double silence_s = clock.now_s() - before_s;
    EXPECT_GT(silence_s, 0.29);
    EXPECT_LT(silence_s, 0.6);
    EXPECT_FALSE(link->isFree()) << "the line is kept silent";
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    EXPECT_GT(clock.now_s() - before_s, 0.59);
}

// A late reply fits the next request by unit and function. Catches 60.0 degC of
// channel 2 told for channel 1.
TEST_F(SimulatedLineTest, ALateReplyIsNotTakenForTheNextOne) {
    openLink();
    fault("late-reply"); // 0.75 s: when the next question is under way
    EXPECT_EQ(refusal({3, 4, 2, 1}), MessageCode::DeviceSilent);
    fault("none");
    const ModbusReply next = ask({3, 4, 1, 1});
    EXPECT_FALSE(next.ok()) << "a reply, but to which question?";
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
}

// The same with a backlog, as after SIGSTOP and SIGCONT: every question that was sent meanwhile is answered
// at once. Catches the second of them taken for the answer to the third.
TEST_F(SimulatedLineTest, ABacklogOfRepliesIsDrained) {
    openLink();
    isStopped = true;
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(refusal({3, 4, 2, 1}), MessageCode::DeviceSilent);
    ASSERT_TRUE(until([&] { return link->isFree(); }));
    const int number = link->send({3, 4, 2, 1});
    isStopped = false;
    std::optional<ModbusReply> reply;
    ASSERT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
    ASSERT_TRUE(reply->ok()) << "the same question was asked each time";
    EXPECT_EQ(reply->value(), Registers{600});
    EXPECT_FALSE(link->isFree());
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
    EXPECT_EQ(answered({3, 4, 3, 1}).value(), Registers{200});
}

// Promise: no value looks newer than it is. Catches a reply that waited in the line while the engine was held
// up, and is then stamped with now.
TEST_F(SimulatedLineTest, WhatWaitedThroughAHoldUpIsNotUsed) {
    openLink();
    const int number = link->send({3, 4, 1, 1});
    test::waitFor([&] { return false; }, 20); // sent by Qt's timer
    const double until_s = clock.now_s() + 0.5;
    while (clock.now_s() < until_s) // the thread is busy: no event loop, but the device answers
        farEnd();
    const auto reply = link->takeReply(number);
    ASSERT_TRUE(reply.has_value());
    ASSERT_FALSE(reply->ok());
    EXPECT_EQ(reply->error().code(), MessageCode::DeviceSilent);
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
}

// Catches two requests on the line at once.
TEST_F(SimulatedLineTest, OneRequestAtATime) {
    openLink();
    EXPECT_TRUE(link->isFree());
    const int number = link->send({3, 4, 1, 1});
    EXPECT_FALSE(link->isFree());
    EXPECT_THROW(link->send({3, 4, 1, 1}), std::logic_error);
    ASSERT_TRUE(until([&] { return link->takeReply(number).has_value(); }));
    EXPECT_FALSE(link->takeReply(number).has_value()) << "once";
}

// Catches an unplugged port that floods the loop (two million errors in Qt 6.4), leaves its request open for
// ever, or is not there again under its path.
TEST_F(SimulatedLineTest, UnpluggedItCostsNothingAndEndsTheRequest) {
    openLink();
    ASSERT_TRUE(link->isOpen());
    isStopped = true;
    const int number = link->send({3, 4, 1, 1});
    test::waitFor([&] { return false; }, 20);
    server.reset();
    const double before_s = processorTime_s();
    test::waitFor([&] { return link->takeReply(-1).has_value(); },
                  1000); // asked all the time, as by its thread
    const double spent_s = processorTime_s() - before_s;
    RecordProperty("processor_us_in_a_second", static_cast<int>(1e6 * spent_s));
    EXPECT_LT(spent_s, 0.1) << "of one second";
    EXPECT_FALSE(link->isOpen());
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    const auto reply = link->takeReply(number);
    ASSERT_TRUE(reply.has_value());
    EXPECT_EQ(reply->error().code(), MessageCode::DeviceSilent);

    link->open();
    EXPECT_FALSE(link->isOpen());
    EXPECT_EQ(link->problem().code, MessageCode::LinkNotOpened);
    EXPECT_EQ(link->problem().args.at(1), "there is no such port");
    isStopped = false;
    plugIn();
    link->open();
    ASSERT_TRUE(link->isOpen()) << describe(link->problem());
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
}

// Catches a loss that only Qt's error tells (never since Qt 6.8), and a close put off that hits the port
// opened anew.
TEST_F(SimulatedLineTest, ALossIsSeenWithoutTheEventLoop) {
    openLink();
    server.reset();
    EXPECT_FALSE(link->isFree()); // looks
    EXPECT_FALSE(link->isOpen());
    EXPECT_EQ(link->problem().code, MessageCode::LinkLost);
    plugIn();
    link->open();
    ASSERT_TRUE(link->isOpen());
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
    EXPECT_TRUE(link->isOpen());
}

// Catches a line that is never opened anew when no device answers, which an adapter that hangs needs.
TEST_F(SimulatedLineTest, APortWithoutAnyAnswerIsClosedToBeOpenedAnew) {
    openLink({19200, 8, 'N', 1}, 0.05);
    fault("silent");
    int asked = 0;
    while (link->isOpen() && asked < 20) {
        ++asked;
        EXPECT_EQ(refusal({3, 4, 1, 1}), MessageCode::DeviceSilent);
        until([&] { return link->isFree() || !link->isOpen(); });
    }
    EXPECT_EQ(asked, 10);
    EXPECT_EQ(link->problem().code, MessageCode::DeviceSilent);
    link->open();
    fault("none");
    EXPECT_EQ(answered({3, 4, 1, 1}).value(), Registers{200});
}

// The whole way: two drivers on one line at once, a plate that heats, and the cable out and in again.
TEST_F(SimulatedLineTest, DriversShareTheLineAndComeBack) {
    openLink();
    const auto thermometer =
        ModbusThermometer::create(*link, clock, {3, shipped("modmux-pm6rtd"), {0, 1}}).value();
    const auto heater = ModbusHeater::create(*link, clock, {4, shipped("pixsys-drr245")}).value();
    const auto work = [&](auto condition, int limit_ms) {
        return until(
            [&] {
                thermometer->work();
                heater->work();
                return condition();
            },
            limit_ms);
    };
    const auto areLive = [&] {
        return thermometer->status().link == LinkState::Live && thermometer->read().ok() &&
               heater->read().ok();
    };
    ASSERT_TRUE(work(areLive, 3000)) << describe(thermometer->status().problem);
    EXPECT_NEAR((*thermometer->read())[1].value_K, 333.15, 1e-9);
    EXPECT_TRUE(heater->keepHeating(kZeroCelsius_K + 80.0, 2.0).ok());
    ASSERT_TRUE(work([&] { return sim.isOn(4); }, 2000));
    work([] { return false; }, 1000);
    EXPECT_GT(thermometer->status().rate_Hz, 6.0);
    RecordProperty("thermometer_rate_mHz", static_cast<int>(1000.0 * thermometer->status().rate_Hz));
    EXPECT_EQ(link->discarded(), 0);

    server.reset();
    ASSERT_TRUE(work([&] { return thermometer->status().link == LinkState::Lost; }, 1000));
    EXPECT_FALSE(heater->read().ok());
    const auto spent_s = [&](bool works) { // in two seconds of an engine's loop, every 5 ms
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &timer, [&] {
            if (works) {
                thermometer->work();
                heater->work();
            }
        });
        timer.start(5);
        const double before_s = processorTime_s();
        idle(2000);
        return processorTime_s() - before_s;
    };
    const double share = (spent_s(true) - spent_s(false)) / 2.0;
    RecordProperty("unplugged_processor_share_ppm", static_cast<int>(1e6 * share));
    EXPECT_LT(share, 0.05);
    plugIn();
    const double plugged_s = clock.now_s();
    ASSERT_TRUE(work([&] { return areLive() && !heater->heating(); }, 3000));
    RecordProperty("back_after_ms", static_cast<int>(1000.0 * (clock.now_s() - plugged_s)));
    EXPECT_LT(clock.now_s() - plugged_s, 2.0);
    EXPECT_FALSE(sim.isOn(4)) << "switched off first";
}

} // namespace
} // namespace bask
