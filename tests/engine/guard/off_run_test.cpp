// Which answers the guard takes for "off".

#include "engine/base/units.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/off_program.h"
#include "engine/guard/guard_log.h"
#include "engine/guard/off_run.h"
#include "engine/protocols/register_values.h"
#include "tests/engine/drivers/modbus_fixture.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <poll.h>
#include <string_view>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace bask::guard {
namespace {

bool fitsText(const OffStep& step, std::string_view text) {
    return fits(step, reinterpret_cast<const unsigned char*>(text.data()), text.size());
}

} // namespace

// Catches a set point that is not off taken for off, and another channel's number for the set point.
TEST(OffRun, ANumberIsReadByItsLine) {
    const OffStep step = offWhenNumber("IN_SP_1 \r\n", 0.6, "1", 500);
    for (const char* off :
         {"0.0 1\r\n", "0.0 1 \r\n", "0 1\r\n", "-0.5 1\r\n", "80.0 2\r\n0.0 1\r\n", ".0 1\r\n"})
        EXPECT_TRUE(fitsText(step, off)) << off;
    for (const char* other : {"80.0 1\r\n", "0.0 2\r\n", "0.0 1", "0.0 12\r\n", "0.01\r\n", "x0.0 1\r\n",
                              "nan 1\r\n", "1\r\n", "", "0.0\r\n"})
        EXPECT_FALSE(fitsText(step, other)) << other;
}

// Catches a reply that is not found after noise, and half of one taken for it.
TEST(OffRun, BytesAreFoundAnywhere) {
    const std::string_view answer("\x02\x03\x02\x00\x00\xfc\x44", 7);
    const OffStep step = offWhenBytes("?", answer, 300);
    EXPECT_TRUE(fitsText(step, answer));
    EXPECT_TRUE(fitsText(step, "noise" + std::string(answer) + "more"));
    EXPECT_FALSE(fitsText(step, answer.substr(0, 6)));
    EXPECT_FALSE(fitsText(step, ""));
    EXPECT_FALSE(fitsText(offWhenBytes("?", "", 300), "anything")) << "no answer confirms nothing";
}

// Catches a controller that rounds or limits its set point and is never confirmed off, and a hot one that is.
TEST(OffRun, ARegisterIsOffByTheMeasureOfItsHeater) {
    const ManualClock clock;
    test::ScriptedModbusLink link(clock, [](const ModbusRequest&) { return std::nullopt; });
    for (const char* name : {"eurotherm-2400", "watlow-ez-zone"}) {
        SCOPED_TRACE(name);
        const ModbusProfile& profile = test::shipped(name);
        const RegisterSpec& spec = profile.setPointWritten ? *profile.setPointWritten : *profile.setPoint;
        const auto heater = ModbusHeater::create(link, clock, {4, profile}).value();
        const OffStep step = heater->offProgram({9600, 8, 'N', 1}).steps[1];
        const auto isOff = [&](double t_degC, int unit = 4) {
            const auto held = registersFromTemperature(profile, spec, kelvinFromCelsius(t_degC)).value();
            return fitsText(step, "noise" + modbusReadReply(unit, spec.function, held) + "x");
        };
        const double off_degC = profile.setPointOff_degC;
        EXPECT_TRUE(isOff(off_degC) && isOff(off_degC - 5.0));
        EXPECT_FALSE(isOff(off_degC + 2.0) || isOff(80.0) || isOff(300.0));
        EXPECT_FALSE(isOff(off_degC, 5)) << "another unit";
        std::string broken = modbusReadReply(
            4, spec.function, registersFromTemperature(profile, spec, kelvinFromCelsius(off_degC)).value());
        EXPECT_FALSE(fitsText(step, broken.substr(0, broken.size() - 1)));
        broken.back() = static_cast<char>(broken.back() ^ 1);
        EXPECT_FALSE(fitsText(step, broken));
    }
    const auto eurotherm = ModbusHeater::create(link, clock, {4, test::shipped("eurotherm-2400")}).value();
    EXPECT_FALSE(fitsText(eurotherm->offProgram({}).steps[1], modbusReadReply(4, 3, {0x8000})))
        << "no set point";
}

// Catches a slow line, on which an answer takes longer than it is waited for.
TEST(OffRun, ASlowLineIsGivenItsTime) {
    const ManualClock clock;
    test::ScriptedModbusLink link(clock, [](const ModbusRequest&) { return std::nullopt; });
    const auto heater = ModbusHeater::create(link, clock, {4, test::shipped("pixsys-drr245")}).value();
    const OffProgram slow = heater->offProgram({300, 8, 'N', 1}),
                     fast = heater->offProgram({115200, 8, 'N', 1});
    EXPECT_GE(slow.steps[0].timeout_ms, 300 + 1000 * 16 * 11 / 300);
    EXPECT_GE(slow.steps[1].timeout_ms, 300 + 1000 * 15 * 11 / 300);
    EXPECT_GE(slow.steps[0].pause_ms, 3500 * 11 / 300);
    EXPECT_LE(fast.steps[0].timeout_ms, 310);
}

// Catches a log that reads a file on the guard's thread before the heat is off: here the zone's file is a
// pipe without a writer, which is a disk that hangs.
TEST(GuardLog, ItWaitsForNoFile) {
    char folder[] = "/tmp/bask-guard-log-XXXXXX";
    ASSERT_NE(::mkdtemp(folder), nullptr);
    const std::string zone = std::string(folder) + "/zone";
    ASSERT_EQ(::mkfifo(zone.c_str(), 0600), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        ::setenv("TZ", (":" + zone).c_str(), 1);
        GuardLog log("", "port");
        log.say("takes over");
        ::_exit(0);
    }
    int ended = 0;
    for (int i = 0; i < 200 && ended == 0; ++i) {
        ended = ::waitpid(child, nullptr, WNOHANG);
        ::poll(nullptr, 0, 10);
    }
    EXPECT_EQ(ended, child);
    ::kill(child, SIGKILL);
    ::unlink(zone.c_str());
    ::rmdir(folder);
}

// Catches a step that is cut, so that half a frame is sent.
TEST(OffRun, AStepThatIsTooLongIsRefused) {
    EXPECT_THROW(offWrite(std::string(65, 'x'), {}, 0, 0), std::invalid_argument);
    OffProgram program;
    for (std::size_t i = 0; i < OffProgram::kMaxSteps; ++i)
        add(program, offWrite("x", {}, 0, 0));
    EXPECT_THROW(add(program, offWrite("x", {}, 0, 0)), std::invalid_argument);
}

} // namespace bask::guard
