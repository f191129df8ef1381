// The guard process itself, between the engine's side and a simulated heater on a pseudo-terminal. The test
// is the engine: it beats when it calls work().

#include "engine/base/units.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/terminal_server.h"
#include "engine/drivers/byte_link_on_thread.h"
#include "engine/drivers/guarded_heater.h"
#include "engine/drivers/guarded_link.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/rtu_link.h"
#include "engine/drivers/serial_link.h"
#include "engine/protocols/modbus_frame.h"
#include "tests/support/guard_processes.h"
#include "tests/support/held_calls.h"
#include "tests/support/shipped_profile.h"
#include "tests/support/wait_for.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <mutex>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace bask {
namespace {

using State = HeaterGuard::State;

using test::shipped;

/// A device on a pseudo-terminal that lives by itself.
class FarEnd {
public:
    FarEnd(ByteDevice& device, std::string path) : m_device(device), m_path(std::move(path)) {
        plug();
        m_thread = std::thread([this] {
            while (!m_isOver) {
                if (isToBePlugged.exchange(false))
                    plug();
                with([this] {
                    if (m_server && !isStopped)
                        m_server->work(m_clock.now_s());
                });
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        });
    }
    ~FarEnd() {
        m_isOver = true;
        m_thread.join();
    }
    /// The device is looked at, or changed, while it does not work.
    template <class Do> std::invoke_result_t<Do> with(Do work) {
        const std::lock_guard lock(m_mutex);
        return work();
    }
    void plug() {
        with([this] { m_server = PtyServer::create(m_device, m_path).value(); });
    }
    void unplug() {
        with([this] { m_server.reset(); });
    }
    std::atomic<bool> isStopped = false;
    std::atomic<bool> isToBePlugged = false; ///< by its own thread, whose calls nobody holds

private:
    ByteDevice& m_device;
    std::string m_path;
    SteadyClock m_clock;
    std::mutex m_mutex;
    std::unique_ptr<PtyServer> m_server;
    std::atomic<bool> m_isOver = false;
    std::thread m_thread;
};

/// A new pseudo-terminal, linked at the path; its far end.
int openTerminal(const std::string& path) {
    const int master = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ::grantpt(master);
    ::unlockpt(master);
    termios raw{};
    ::tcgetattr(master, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(master, TCSANOW, &raw);
    return ::symlink(::ptsname(master), path.c_str()) == 0 ? master : -1;
}

/// Says back at once what it hears, on two lines.
class Echo {
public:
    Echo(int first, int second) : m_masters{first, second} {
        m_thread = std::thread([this] {
            std::array<char, 256> bytes{};
            while (!m_isOver) {
                pollfd ends[] = {{m_masters[0], POLLIN, 0}, {m_masters[1], POLLIN, 0}};
                ::poll(ends, 2, 20);
                for (int i = 0; i < 2; ++i)
                    if ((ends[i].revents & POLLIN) != 0)
                        if (const ssize_t count = ::read(m_masters[i], bytes.data(), bytes.size()); count > 0)
                            (void)!::write(m_masters[i], bytes.data(), static_cast<std::size_t>(count));
            }
        });
    }
    ~Echo() {
        m_isOver = true;
        m_thread.join();
        ::close(m_masters[0]);
        ::close(m_masters[1]);
    }

private:
    int m_masters[2];
    std::atomic<bool> m_isOver = false;
    std::thread m_thread;
};

/// From the question until all of it has come back.
template <class Ask, class Hear>
double secondsFor(const Clock& clock, const std::string& question, Ask ask, Hear hear) {
    std::array<char, 256> bytes{};
    const double begun_s = clock.now_s();
    ask();
    for (std::size_t heard = 0; heard < question.size() && clock.now_s() < begun_s + 1.0;)
        if (const ssize_t count = hear(bytes.data(), bytes.size()); count > 0)
            heard += static_cast<std::size_t>(count);
        else
            std::this_thread::sleep_for(std::chrono::microseconds(20));
    return clock.now_s() - begun_s;
}

/// The engine's side, as RealRig has it.
class GuardTest : public testing::Test {
protected:
    GuardTest() { guard.emplace(port, SerialSettings{9600, 8, 'N', 1}, log, clock); }

    ~GuardTest() override {
        heater.reset();
        guard.reset();
        test::endGuardsOf(folder.path());
    }

    std::unique_ptr<GuardedLink> newLink() {
        return std::make_unique<GuardedLink>(
            *guard,
            [this] {
                return std::make_unique<ByteLinkOnThread>(
                    port, [this] { return std::make_unique<SerialLink>(port, SerialSettings{}); });
            },
            clock);
    }
    void makeNamur(const std::string& program = guardProgram()) {
        namurLink = newLink();
        auto made = std::make_unique<NamurHeater>(*namurLink, clock, NamurHeaterConfig{});
        device = made.get();
        heater = std::make_unique<GuardedHeater>(std::move(made), *guard, program, &NamurHeater::offProgram,
                                                 clock);
    }
    void makeModbus(const char* profile) {
        modbusLink = std::make_unique<RtuLink>(newLink(), SerialSettings{9600, 8, 'N', 1}, clock);
        auto made = ModbusHeater::create(*modbusLink, clock, {4, shipped(profile)}).value();
        const ModbusHeater& of = *made;
        device = made.get();
        heater = std::make_unique<GuardedHeater>(
            std::move(made), *guard, guardProgram(),
            [&of] {
                return of.offProgram({9600, 8, 'N', 1});
            },
            clock);
    }
    void work() {
        guard->work();
        device->work();
        heater->work();
    }
    template <class Condition> bool until(Condition condition, int limit_ms = 5000) {
        return test::waitFor(
            [&] {
                work();
                return condition();
            },
            limit_ms);
    }
    /// Without a beat, as an engine that is dead or hangs.
    template <class Condition> static bool untilWithoutBeat(Condition condition, int limit_ms) {
        return test::waitFor(condition, limit_ms);
    }
    void heatUp(double setPoint_degC = 80.0) {
        ASSERT_TRUE(until([&] { return device->status().link == LinkState::Live && heater->read().ok(); }))
            << describe(device->status().problem);
        ASSERT_TRUE(until([&] { return heats(setPoint_degC) && isOn(); }))
            << describe(heater->cannotHeat()) << " | " << describe(device->status().problem);
    }
    bool heats(double setPoint_degC) {
        return heater->keepHeating(kelvinFromCelsius(setPoint_degC), 1.0).ok();
    }
    bool isOn() {
        return end.with([&] { return plate.isOn() && plate.setPoint_K() > kelvinFromCelsius(1.0); });
    }
    std::string logText() const {
        std::ifstream file(log);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool signalGuard(int number) const {
        const auto process = guard->processId();
        return process && ::kill(*process, number) == 0;
    }
    /// Bask's own thread waits for it.
    bool isGone(int process) const { return ::kill(process, 0) != 0; }
    /// On a thread of its own, whose calls of that kind may be held: of all that it starts, too.
    template <class Body> void withFixed(test::HeldCalls::Which which, Body body) {
        std::string problem;
        std::thread([&] {
            test::HeldCalls calls;
            problem = calls.begin(which);
            if (problem.empty())
                body(calls);
        }).join();
        if (!problem.empty())
            GTEST_SKIP() << "no calls can be held here: " << problem;
    }

    QTemporaryDir folder;
    std::string port = folder.filePath("heater").toStdString(),
                log = folder.filePath("guard.log").toStdString();
    NamurSimulator plate;
    FarEnd end{plate, port};
    SteadyClock clock;
    std::optional<HeaterGuard> guard;
    std::unique_ptr<GuardedLink> namurLink;
    std::unique_ptr<RtuLink> modbusLink;
    Device* device = nullptr;
    std::unique_ptr<GuardedHeater> heater;
};

} // namespace

// Catches a plate that a person has switched on past its driver, with no guard until the driver knows.
TEST_F(GuardTest, WhatAPersonMayHaveSwitchedOnIsWatched) {
    makeNamur();
    ASSERT_TRUE(until([&] { return heater->heatState() == HeatState::Off; }));
    ASSERT_TRUE(until([&] { return heater->cannotHeat().code == MessageCode::None; }));
    EXPECT_FALSE(heater->heating());
    namurLink->close();
    work();
    heater->doubt();
    work();
    EXPECT_TRUE(heater->heating());
    EXPECT_TRUE(guard->isArmed());
    EXPECT_TRUE(until([&] { return !heater->heating() && !guard->isArmed(); }, 10000))
        << "the plate says that it is off";
}

// Catches a plate that stays hot when the engine's thread hangs, and a guard that acts before its time.
TEST_F(GuardTest, AnEngineThatHangsIsSwitchedOffWithinThreeSeconds) {
    makeNamur();
    heatUp();
    const double hung_s = clock.now_s();
    EXPECT_FALSE(untilWithoutBeat([&] { return !isOn(); }, 1500)) << "too early";
    ASSERT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 3000));
    EXPECT_LT(clock.now_s() - hung_s, 3.0);
    EXPECT_FALSE(isOn());
    EXPECT_NE(logText().find("sent \"STOP_1 <0d><0a>\""), std::string::npos) << logText();

    work(); // the engine is back
    EXPECT_EQ(heater->guardProblem().code, MessageCode::HeaterGuardTookOver);
    EXPECT_FALSE(heats(80.0)) << "heat again only after a reset";
    EXPECT_TRUE(until([&] { return guard->state() == State::Ended && heater->read().ok(); }))
        << "by itself now";
    EXPECT_EQ(heater->guardProblem().code, MessageCode::HeaterGuardTookOver);
    heater->renewGuard();
    EXPECT_EQ(heater->guardProblem().code, MessageCode::None);
    bool wasLost = false;
    EXPECT_TRUE(until([&] {
        wasLost = wasLost || !heater->read().ok();
        return heater->cannotHeat().code == MessageCode::None && heats(80.0) && isOn();
    }));
    EXPECT_FALSE(wasLost) << "the new guard gets the port without a loss";
}

// Catches an off that comes late, or never, when the engine is no more.
TEST_F(GuardTest, AnEngineThatEndsIsSwitchedOffAtOnce) {
    makeNamur();
    heatUp();
    const double ended_s = clock.now_s();
    heater.reset();
    namurLink.reset();
    guard.reset();
    ASSERT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 3000));
    EXPECT_LT(clock.now_s() - ended_s, 1.0);
    EXPECT_FALSE(isOn());
}

// Catches a guard that writes to a heater that is known to be off, or stays.
TEST_F(GuardTest, AGoodbyeWithTheHeatOffWritesNothing) {
    makeNamur();
    heatUp();
    ASSERT_TRUE(heater->heatOff().ok());
    ASSERT_TRUE(until([&] { return !heater->heating(); }));
    EXPECT_FALSE(isOn());
    const int process = guard->processId().value();
    guard.reset();
    EXPECT_TRUE(untilWithoutBeat([&] { return isGone(process); }, 2000));
    EXPECT_EQ(logText(), "");
}

// Catches an end that is heard before the last orders: here a word of the guard's is left unread, too.
TEST_F(GuardTest, AGoodbyeBehindUnreadWordsIsHeard) {
    makeNamur();
    heatUp();
    ASSERT_TRUE(heater->heatOff().ok());
    ASSERT_TRUE(until([&] { return !isOn(); }));
    guard->work();
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    guard->work(); // a beat, whose answer is not read
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const int process = guard->processId().value();
    ASSERT_EQ(::kill(process, SIGSTOP), 0);
    guard->disarm();
    heater.reset();
    const double dismissed_s = clock.now_s();
    guard.reset();
    EXPECT_LT(clock.now_s() - dismissed_s, 0.1) << "nobody waits for it";
    ASSERT_EQ(::kill(process, SIGCONT), 0);
    EXPECT_TRUE(untilWithoutBeat([&] { return isGone(process); }, 2000));
    EXPECT_EQ(logText(), "");
}

// Catches a heater that nobody guards any more and that goes on heating.
TEST_F(GuardTest, AGuardThatIsKilledIsNoticedAndTheEngineSwitchesOff) {
    for (const int number : {SIGKILL, SIGSTOP}) {
        SCOPED_TRACE(number);
        if (!heater)
            makeNamur();
        heater->renewGuard();
        heatUp();
        const double killed_s = clock.now_s();
        ASSERT_TRUE(signalGuard(number));
        ASSERT_TRUE(until([&] { return heater->guardProblem().code == MessageCode::HeaterGuardLost; }, 1000));
        ASSERT_TRUE(until([&] { return !isOn(); }, 3000));
        EXPECT_LT(clock.now_s() - killed_s, 2.0);
        EXPECT_FALSE(heats(80.0));
    }
}

// Catches an engine that waits for the disk that has the guard's program, and a Bask without a guard that
// cannot read its heater.
TEST_F(GuardTest, AProgramThatStartsSlowlyHoldsNobodyUp) {
    withFixed({SYS_execve}, [this](test::HeldCalls& starting) {
        starting.hold();
        const double begun_s = clock.now_s();
        makeNamur();
        EXPECT_LT(clock.now_s() - begun_s, 0.3);
        EXPECT_TRUE(until([&] { return starting.held() > 0; }));
        EXPECT_EQ(argTexts(heater->cannotHeat()), std::vector<std::string>{"it is being started"});
        starting.release();
        heatUp();
        if (HasFatalFailure())
            return;
        EXPECT_TRUE(heater->heatOff().ok());
        EXPECT_TRUE(until([&] { return !heater->heating(); }));

        EXPECT_TRUE(signalGuard(SIGKILL));
        EXPECT_TRUE(until([&] { return heater->guardProblem().code == MessageCode::HeaterGuardLost; }));
        starting.hold();
        const double renewed_s = clock.now_s();
        heater->renewGuard(); // as Reset does
        EXPECT_LT(clock.now_s() - renewed_s, 0.3);
        EXPECT_EQ(heater->guardProblem().code, MessageCode::None);
        EXPECT_TRUE(until([&] { return guard->state() == State::None; }));
        EXPECT_EQ(argTexts(heater->cannotHeat()), std::vector<std::string>{"bask-guard does not start"});
        EXPECT_TRUE(until([&] { return heater->read().ok(); })) << "by itself";
        starting.release();
        heater->renewGuard();
        heatUp();
    });
}

// Catches a guard that is killed because its port opens slowly: it must answer meanwhile.
TEST_F(GuardTest, APortThatOpensSlowlyIsNoGuardThatStandsStill) {
    constexpr std::uint32_t kFlags = O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC; // the guard's
    withFixed({SYS_openat, 2, kFlags}, [this](test::HeldCalls& opening) {
        opening.hold();
        makeNamur();
        EXPECT_TRUE(until([&] { return opening.held() > 0; }));
        EXPECT_FALSE(
            until([&] { return guard->state() == State::None || guard->state() == State::Ended; }, 2000));
        EXPECT_EQ(guard->state(), State::Guarding);
        EXPECT_FALSE(namurLink->isOpen());
        EXPECT_FALSE(heater->read().ok());
        opening.release();
        heatUp();
    });
}

// Catches a guard that takes over while its port is being opened, and gives up, or never comes to its off.
TEST_F(GuardTest, ItTakesOverAPortThatOpensSlowly) {
    constexpr std::uint32_t kFlags = O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC; // the guard's
    withFixed({SYS_openat, 2, kFlags}, [this](test::HeldCalls& opening) {
        makeNamur();
        heatUp();
        if (HasFatalFailure())
            return;
        end.unplug();
        opening.hold();
        end.isToBePlugged = true;
        EXPECT_TRUE(until([&] { return opening.held() > 0; }));
        EXPECT_EQ(guard->state(), State::Guarding);
        heater.reset();
        guard.reset();
        EXPECT_TRUE(
            untilWithoutBeat([&] { return logText().find("takes over") != std::string::npos; }, 3000));
        EXPECT_FALSE(
            untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 1000));
        EXPECT_TRUE(isOn());
        opening.release();
        EXPECT_TRUE(
            untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 3000))
            << logText();
        EXPECT_FALSE(isOn());
    });
}

// Catches a port's thread that ends with the port, so that the next off never goes out.
TEST_F(GuardTest, APortThatComesAndGoesIsSwitchedOffInTheEnd) {
    makeNamur();
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(until([&] { return namurLink->isOpen(); }));
        end.unplug();
        ASSERT_TRUE(until([&] { return namurLink->problem().code == MessageCode::LinkNotOpened; }));
        end.plug();
    }
    heatUp();
    heater.reset();
    guard.reset();
    EXPECT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 3000));
    EXPECT_FALSE(isOn());
}

// Catches a port that nobody can open any more, a pseudo-terminal's, after its guard was killed: the system
// keeps it exclusive until its other end is closed.
TEST_F(GuardTest, APseudoTerminalIsNotLeftExclusive) {
    makeNamur();
    ASSERT_TRUE(until([&] { return namurLink->isOpen(); }));
    const int other = ::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(other, 0);
    int isExclusive = -1;
    EXPECT_EQ(::ioctl(other, TIOCGEXCL, &isExclusive), 0);
    EXPECT_EQ(isExclusive, 0);
    ::close(other);
}

// Catches a guard that what ends Bask ends too.
TEST_F(GuardTest, SignalsDoNotEndItAndATermSwitchesOffFirst) {
    makeNamur();
    heatUp();
    const int process = guard->processId().value();
    for (const int number : {SIGINT, SIGHUP, SIGQUIT, SIGPIPE})
        ASSERT_EQ(::kill(process, number), 0);
    until([] { return false; }, 300);
    EXPECT_EQ(guard->state(), State::Guarding);
    EXPECT_TRUE(isOn() && heats(80.0));
    ASSERT_EQ(::kill(process, SIGTERM), 0);
    EXPECT_TRUE(until([&] { return guard->state() == State::Ended; }));
    EXPECT_FALSE(isOn());
    EXPECT_NE(logText().find("told to end"), std::string::npos);
}

// Catches a guard that gives up on a device that does not answer, or takes its silence for off.
TEST_F(GuardTest, ItGoesOnUntilTheDeviceSaysOff) {
    makeNamur();
    heatUp();
    end.isStopped = true;
    heater.reset();
    guard.reset();
    EXPECT_FALSE(
        untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 2500));
    EXPECT_NE(logText().find("which is not off"), std::string::npos) << logText();
    end.isStopped = false;
    EXPECT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 3000));
    EXPECT_FALSE(isOn());
}

// Catches a cable that is pulled while the guard switches off, and a guard that gives up.
TEST_F(GuardTest, ItOpensAPortThatComesBack) {
    makeNamur();
    heatUp();
    end.unplug();
    heater.reset();
    guard.reset();
    EXPECT_TRUE(
        untilWithoutBeat([&] { return logText().find("cannot be opened") != std::string::npos; }, 3000));
    end.plug();
    EXPECT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 5000));
    EXPECT_FALSE(isOn());
}

// Catches an unplugged port that looks open, or does not come back.
TEST_F(GuardTest, AnUnpluggedPortIsToldAsWithoutAGuard) {
    makeNamur();
    ASSERT_TRUE(until([&] { return namurLink->isOpen(); }));
    end.unplug();
    EXPECT_TRUE(until([&] { return namurLink->problem().code == MessageCode::LinkLost; }));
    EXPECT_FALSE(namurLink->isOpen());
    EXPECT_TRUE(until([&] { return namurLink->problem().code == MessageCode::LinkNotOpened; }));
    EXPECT_EQ(namurLink->problem().args.at(1), "there is no such port");
    end.plug();
    EXPECT_TRUE(until([&] { return namurLink->isOpen(); }));
}

// Catches a port that is another one's by now, and is written to: by its own name, as the system links it.
TEST_F(GuardTest, AnotherPortAtItsPlaceIsNotOpened) {
    const QString ids = folder.filePath("by-id");
    ASSERT_TRUE(QDir().mkpath(ids));
    const auto be = [&](const QString& name) {
        QFile::remove(ids + "/usb-one");
        QFile::remove(ids + "/usb-two");
        ASSERT_TRUE(QFile::link(QString::fromStdString(port), ids + '/' + name));
    };
    be("usb-one");
    guard.emplace(port, SerialSettings{9600, 8, 'N', 1}, log, clock, std::string(), ids.toStdString());
    makeNamur();
    ASSERT_TRUE(until([&] { return namurLink->isOpen(); }));
    EXPECT_EQ(namurLink->portId(), "usb-one") << "the first one counts";
    heatUp();
    end.unplug();
    be("usb-two");
    end.plug();
    EXPECT_TRUE(until([&] { return namurLink->problem().code == MessageCode::DeviceExchanged; }));
    EXPECT_EQ(argTexts(namurLink->problem()), (std::vector<std::string>{port, "usb-one", "usb-two"}));
    end.with([&] { plate.receive("START_1 \r\n", 0.0); });
    heater.reset();
    guard.reset(); // which takes over, and does not write there either
    EXPECT_TRUE(untilWithoutBeat(
        [&] { return logText().find("another one is at its place") != std::string::npos; }, 3000));
    EXPECT_EQ(logText().find("sent"), std::string::npos) << logText();
    be("usb-one");
    EXPECT_TRUE(untilWithoutBeat([&] { return logText().find("confirmed off") != std::string::npos; }, 6000));
    EXPECT_FALSE(isOn());
    guard.emplace(port, SerialSettings{9600, 8, 'N', 1}, log, clock, "usb-two", ids.toStdString());
    makeNamur();
    EXPECT_TRUE(until([&] { return namurLink->problem().code == MessageCode::DeviceExchanged; }))
        << "as remembered";
}

// Catches two programs on one port.
TEST_F(GuardTest, APortHasOneGuard) {
    makeNamur();
    ASSERT_TRUE(until([&] { return namurLink->isOpen(); }));
    HeaterGuard second(port, {}, {}, clock);
    second.start(guardProgram());
    second.openPort();
    EXPECT_TRUE(until([&] {
        second.work();
        return second.portProblem().code == MessageCode::LinkNotOpened;
    }));
    EXPECT_EQ(second.portProblem().args.at(1), "another program has it open");
    SerialLink direct(port, {});
    direct.open();
    EXPECT_FALSE(direct.isOpen());
    EXPECT_EQ(direct.problem().args.at(1), "another program has it open");
}

// Catches heat without a guard, and anything else than heat that is refused.
TEST_F(GuardTest, WithoutItsProgramThereIsNoHeatAndEverythingElse) {
    makeNamur("/nowhere/bask-guard");
    EXPECT_EQ(heater->cannotHeat().code, MessageCode::HeaterGuardMissing);
    EXPECT_EQ(heater->guardProblem().code, MessageCode::None) << "no fault";
    EXPECT_TRUE(until([&] { return heater->read().ok(); }));
    const auto refused = heater->keepHeating(kelvinFromCelsius(80.0), 1.0);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code(), MessageCode::HeaterGuardMissing);
    EXPECT_FALSE(isOn());
}

// The guard is on the way of every byte. Catches a way that takes longer than 2 ms more: of the questions of
// a thermometer on the heater's line, asked in turn with and without it.
TEST(GuardDelay, BytesGoThroughWithinTwoMilliseconds) {
    constexpr int kQuestions = 400, kRounds = 3;
    QTemporaryDir folder;
    const std::string ports[] = {folder.filePath("direct").toStdString(),
                                 folder.filePath("guarded").toStdString()};
    int masters[2]{};
    for (int i = 0; i < 2; ++i) {
        masters[i] = openTerminal(ports[i]);
        ASSERT_GE(masters[i], 0);
    }
    Echo echo(masters[0], masters[1]);
    const int direct = openRawTerminal(ports[0]);
    ASSERT_GE(direct, 0);
    const SteadyClock clock;
    HeaterGuard guard(ports[1], SerialSettings{9600, 8, 'N', 1}, {}, clock);
    guard.start(guardProgram());
    guard.openPort();
    ASSERT_TRUE(test::waitFor([&] {
        guard.work();
        return guard.isPortOpen();
    }));
    const std::string question = modbusRequest({1, 4, 0, 3, {}});
    double median_ms = 1e9, max_ms = 1e9; // another's work only adds
    for (int round = 0; round < kRounds && max_ms > 2.0; ++round) {
        std::vector<double> took_s[2];
        for (int i = 0; i < kQuestions; ++i) {
            guard.work();
            took_s[0].push_back(secondsFor(
                clock, question, [&] { (void)!::write(direct, question.data(), question.size()); },
                [&](char* bytes, std::size_t max) { return ::read(direct, bytes, max); }));
            took_s[1].push_back(secondsFor(
                clock, question, [&] { guard.write(question); },
                [&](char* bytes, std::size_t max) {
                    const std::string come = guard.read();
                    come.copy(bytes, max);
                    return static_cast<ssize_t>(come.size());
                }));
        }
        const auto quantile_ms = [&](int way, double share) {
            std::vector<double> sorted = took_s[way];
            std::ranges::sort(sorted);
            return 1e3 * sorted[static_cast<std::size_t>(share * (kQuestions - 1))];
        };
        std::printf("| there and back, ms    | median | p99    |\n| without the guard     | %6.3f | %6.3f |\n"
                    "| through it            | %6.3f | %6.3f |\n",
                    quantile_ms(0, 0.5), quantile_ms(0, 0.99), quantile_ms(1, 0.5), quantile_ms(1, 0.99));
        median_ms = std::min(median_ms, quantile_ms(1, 0.5) - quantile_ms(0, 0.5));
        max_ms = std::min(max_ms, quantile_ms(1, 0.99) - quantile_ms(0, 0.99));
    }
    ::close(direct);
    EXPECT_LE(median_ms, 2.0);
    EXPECT_LE(max_ms, 2.0);
}

/// A line that loses some of its answers, and has bytes that nobody asked for.
class LossyDevice final : public ByteDevice {
public:
    explicit LossyDevice(ByteDevice& device) : m_device(device) {}

    void receive(std::string_view bytes, double now_s) override {
        if (!isDeaf)
            m_device.receive(bytes, now_s);
    }
    std::string transmit(double now_s) override {
        const std::string bytes = m_device.transmit(now_s);
        const std::string besides = std::exchange(toSay, babbles ? "U" : "");
        return besides + (!bytes.empty() && toLose-- > 0 ? std::string() : bytes);
    }
    std::vector<std::string> faults() const override { return m_device.faults(); }
    Result<void> setFault(const std::string& name) override { return m_device.setFault(name); }

    int toLose = 0;
    bool isDeaf = false, babbles = false;
    std::string toSay;

private:
    ByteDevice& m_device;
};

/// A controller with its guard on a line of its own.
struct GuardedController {
    explicit GuardedController(const char* name) {
        sim.addController(4, shipped(name));
        end.emplace(lossy, port);
        auto made = ModbusHeater::create(link, clock, {4, shipped(name)}).value();
        device = made.get();
        heater.emplace(
            std::move(made), guard, guardProgram(),
            [this] {
                return device->offProgram({9600, 8, 'N', 1});
            },
            clock);
    }
    ~GuardedController() { test::endGuardsOf(folder.path()); }

    bool heats() {
        return end->with([&] { return sim.isOn(4) && sim.setPoint_K(4) > kelvinFromCelsius(79.0); });
    }
    bool heatUp() {
        return test::waitFor(
            [&] {
                guard.work();
                device->work();
                heater->work();
                return heater->keepHeating(kelvinFromCelsius(80.0), 1.0).ok() && heats();
            },
            5000);
    }
    std::string logText() const {
        std::ifstream file(log);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    bool isConfirmed() {
        return test::waitFor([&] { return logText().find("confirmed off") != std::string::npos; }, 3000);
    }

    QTemporaryDir folder;
    std::string port = folder.filePath("heater").toStdString(),
                log = folder.filePath("guard.log").toStdString();
    ModbusSimulator sim;
    LossyDevice lossy{sim};
    std::optional<FarEnd> end;
    SteadyClock clock;
    HeaterGuard guard{port, SerialSettings{9600, 8, 'N', 1}, log, clock};
    RtuLink link{
        std::make_unique<GuardedLink>(
            guard,
            [this]() -> std::unique_ptr<ByteLink> { throw std::runtime_error(describe(guard.problem())); },
            clock),
        {9600, 8, 'N', 1},
        clock};
    ModbusHeater* device = nullptr;
    std::optional<GuardedHeater> heater;
};

// Catches an off that is confirmed late: a wait beyond the answer, and a pause after one lost frame.
TEST(ModbusGuard, OffIsConfirmedWithoutIdleTime) {
    for (const auto& [lost, max_s] : {std::pair(0, 0.3), std::pair(2, 1.1)}) {
        SCOPED_TRACE(lost);
        GuardedController rig("pixsys-drr245");
        ASSERT_TRUE(rig.heatUp());
        rig.end->with([&, count = lost] { rig.lossy.toLose = count; });
        const double begun_s = rig.clock.now_s();
        ASSERT_TRUE(rig.guard.handOver(1.0));
        ASSERT_TRUE(rig.isConfirmed()) << rig.logText();
        EXPECT_LT(rig.clock.now_s() - begun_s, max_s) << rig.logText();
    }
}

// Catches a program of frames that does not switch such a controller off; each is read back.
TEST(ModbusGuard, EveryControllerIsSwitchedOffByItsFrames) {
    for (const char* name : {"eurotherm-2400", "watlow-ez-zone", "pixsys-drr245"}) {
        SCOPED_TRACE(name);
        GuardedController rig(name);
        ASSERT_TRUE(rig.heatUp());
        ASSERT_TRUE(rig.guard.handOver(1.0)) << "and the engine's bytes are blocked";
        EXPECT_TRUE(rig.isConfirmed()) << rig.logText();
        EXPECT_FALSE(rig.heats());
    }
}

// Catches an answer from before the guard took over that is taken for one to its own question: here the
// system hands it on late, as a busy one does.
TEST(ModbusGuard, ALateAnswerConfirmsNothing) {
    std::string problem;
    std::thread([&] {
        constexpr std::uint32_t kAtOnce = 1024; // bytes, as the guard reads its port
        test::HeldCalls reading;
        problem = reading.begin({SYS_read, 2, kAtOnce});
        if (!problem.empty())
            return;
        GuardedController rig("eurotherm-2400");
        ASSERT_TRUE(rig.heatUp());
        rig.end->with([&] { rig.lossy.isDeaf = true; });
        ASSERT_TRUE(rig.guard.handOver(1.0));
        std::this_thread::sleep_for(std::chrono::milliseconds(150)); // it waits for an echo, for 0.3 s
        reading.hold();
        rig.end->with([&] { rig.lossy.toSay = modbusReadReply(4, 3, {0}); }); // of a set point of 0 degC
        ASSERT_TRUE(test::waitFor([&] { return reading.held() > 0; }, 2000));
        std::this_thread::sleep_for(std::chrono::milliseconds(500)); // it has gone on to its question
        reading.release();
        EXPECT_FALSE(
            test::waitFor([&] { return rig.logText().find("confirmed off") != std::string::npos; }, 1500))
            << rig.logText();
        EXPECT_NE(rig.logText().find("which is not off"), std::string::npos) << rig.logText();
        rig.end->with([&] { rig.lossy.isDeaf = false; });
        EXPECT_TRUE(rig.isConfirmed()) << rig.logText();
        EXPECT_FALSE(rig.heats());
    }).join();
    if (!problem.empty())
        GTEST_SKIP() << "no calls can be held here: " << problem;
}

// Catches a guard that waits for a silence which never comes, or does not find the answer in the noise.
TEST(ModbusGuard, OffIsConfirmedOnALineThatBabbles) {
    for (const char* name : {"eurotherm-2400", "watlow-ez-zone", "pixsys-drr245"}) {
        SCOPED_TRACE(name);
        GuardedController rig(name);
        ASSERT_TRUE(rig.heatUp());
        rig.end->with([&] { rig.lossy.babbles = true; });
        const double begun_s = rig.clock.now_s();
        ASSERT_TRUE(rig.guard.handOver(1.0));
        ASSERT_TRUE(rig.isConfirmed()) << rig.logText();
        EXPECT_LT(rig.clock.now_s() - begun_s, 1.5) << rig.logText();
        EXPECT_FALSE(rig.heats());
    }
}

/// A controller on a line with a device that does not answer.
class ModbusOff : public testing::TestWithParam<bool> {
protected:
    static constexpr int kTimes = 10;

    ModbusOff() {
        sim.addController(4, shipped("pixsys-drr245"));
        if (GetParam())
            guard.start(guardProgram());
    }
    ~ModbusOff() override { test::endGuardsOf(folder.path()); }

    void work() {
        guard.work();
        heater->work();
    }
    template <class Condition> bool until(Condition condition, int limit_ms = 5000) {
        return test::waitFor(
            [&] {
                work();
                return condition();
            },
            limit_ms);
    }
    bool isOn() {
        return end.with([&] { return sim.isOn(4); });
    }

    QTemporaryDir folder;
    std::string port = folder.filePath("heater").toStdString();
    ModbusSimulator sim;
    LossyDevice line{sim};
    FarEnd end{line, port};
    SteadyClock clock;
    HeaterGuard guard{port, SerialSettings{9600, 8, 'N', 1}, {}, clock};
    RtuLink link{std::make_unique<GuardedLink>(
                     guard,
                     [this] {
                         return std::make_unique<ByteLinkOnThread>(
                             port, [this] { return std::make_unique<SerialLink>(port, SerialSettings{}); });
                     },
                     clock),
                 {9600, 8, 'N', 1},
                 clock};
    std::unique_ptr<ModbusHeater> heater =
        ModbusHeater::create(link, clock, {4, shipped("pixsys-drr245")}).value();
};

// From the word to the device, at the worst moment: a question has just gone out to a device of the line that
// does not answer. Catches an off that waits for that answer, and for the silence after it (0.6 s).
TEST_P(ModbusOff, IsAtTheDeviceWhateverIsUnderWay) {
    std::vector<double> took_ms;
    for (int i = 0; i < kTimes; ++i) {
        ASSERT_TRUE(until([&] { return heater->keepHeating(kelvinFromCelsius(80.0), 1.0).ok() && isOn(); }));
        ASSERT_TRUE(until([&] { return link.isFree(); }));
        (void)link.send({9, 4, 0, 2}); // nobody
        const double begun_s = clock.now_s();
        (void)heater->heatOff();
        ASSERT_TRUE(until([&] { return !isOn(); }));
        took_ms.push_back(1e3 * (clock.now_s() - begun_s));
        ASSERT_TRUE(until([&] { return !heater->heating() && heater->heatState() == HeatState::Off; }));
    }
    std::ranges::sort(took_ms);
    std::printf("| off at a Modbus device behind a silent one, %s: %.0f ms (median), %.0f ms (most of %d)\n",
                GetParam() ? "guarded" : "direct", took_ms[kTimes / 2], took_ms.back(), kTimes);
    EXPECT_LE(took_ms.back(), 250.0);
}

// Catches an off that waits for a gap which never comes: who talks for longer than the longest frame of this
// speed (0.29 s) and the wait for an answer (0.1 s) has no end.
TEST_P(ModbusOff, IsAtTheDeviceThoughTheLineBabbles) {
    ASSERT_TRUE(until([&] { return heater->keepHeating(kelvinFromCelsius(80.0), 1.0).ok() && isOn(); }));
    end.with([this] { line.babbles = true; });
    until([] { return false; }, 50);
    const double begun_s = clock.now_s();
    (void)heater->heatOff();
    ASSERT_TRUE(until([&] { return !isOn(); }));
    const double took_s = clock.now_s() - begun_s;
    std::printf("| off at a Modbus device on a line that babbles, %s: %.0f ms\n",
                GetParam() ? "guarded" : "direct", 1e3 * took_s);
    EXPECT_LE(took_s, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Ways, ModbusOff, testing::Bool(),
                         [](const auto& way) { return way.param ? "Guarded" : "Direct"; });

} // namespace bask
