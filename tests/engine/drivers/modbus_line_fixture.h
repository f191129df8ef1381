#pragma once
// The link to Modbus devices by real time: a port, questions, and programs at the far end.

#include "engine/base/message_code.h"
#include "engine/drivers/rtu_link.h"
#include "engine/drivers/serial_link.h"
#include "tests/support/wait_for.h"

#include <QProcess>
#include <QStandardPaths>

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace bask::test {

class ModbusLineTest : public testing::Test {
protected:
    ModbusLineTest() { std::filesystem::create_directories(folder); }
    ~ModbusLineTest() override {
        link.reset();
        for (QProcess* program : {&peer, &wires}) {
            if (program->state() != QProcess::NotRunning) {
                program->kill();
                program->waitForFinished();
            }
        }
        std::filesystem::remove_all(folder);
    }

    /// What the far end does while the test waits.
    virtual void farEnd() {}

    template <class Condition> bool until(Condition condition, int limit_ms = 5000) {
        return waitFor(
            [&] {
                farEnd();
                return condition();
            },
            limit_ms);
    }
    void pass(double s) {
        const double end_s = clock.now_s() + s;
        until([&] { return clock.now_s() >= end_s; }, 60000);
    }
    void openLink(const SerialSettings& settings = {19200, 8, 'N', 1}, double replyTime_s = 0.3) {
        link = std::make_unique<RtuLink>(std::make_unique<SerialLink>(port, settings), settings, clock,
                                         replyTime_s);
        link->open();
    }
    /// Sends as soon as the line is free, and waits for its reply.
    ModbusReply ask(const ModbusRequest& request) {
        EXPECT_TRUE(until([&] { return link->isFree(); })) << describe(link->problem());
        const int number = link->send(request);
        std::optional<ModbusReply> reply;
        EXPECT_TRUE(until([&] { return (reply = link->takeReply(number)).has_value(); }));
        return reply.value_or(Error(MessageCode::None, "no reply"));
    }
    /// Asked again while there is silence: a busy machine may be late.
    ModbusReply answered(const ModbusRequest& request) {
        ModbusReply reply = ask(request);
        for (int i = 0; i < 10 && !reply && reply.error().code() == MessageCode::DeviceSilent; ++i)
            reply = ask(request);
        return reply;
    }
    MessageCode refusal(const ModbusRequest& request) {
        const ModbusReply reply = ask(request);
        return reply ? MessageCode::None : reply.error().code();
    }

    /// Two terminals back to back, `port` and `farPort`; false without socat.
    bool join() {
        if (QStandardPaths::findExecutable("socat").isEmpty())
            return false;
        wires.start("socat", {"pty,raw,echo=0,link=" + QString::fromStdString(port),
                              "pty,raw,echo=0,link=" + QString::fromStdString(farPort)});
        return until([&] { return std::filesystem::exists(port) && std::filesystem::exists(farPort); });
    }

    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("bask_modbus_" + std::to_string(::getpid()));
    std::string port = folder / "port", farPort = folder / "far";
    SteadyClock clock;
    QProcess wires, peer;
    std::unique_ptr<RtuLink> link;
};

} // namespace bask::test
