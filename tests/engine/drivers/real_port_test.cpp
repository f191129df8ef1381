// Drivers on real serial ports: simulated devices behind pseudo-terminals whose cable is pulled.

#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/stream_simulator.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/serial_link.h"
#include "engine/drivers/stream_thermometer.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QTimer>

#include <gtest/gtest.h>

#include <ctime>
#include <filesystem>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

double usedTime_s() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

class RealPortTest : public testing::Test {
protected:
    RealPortTest() {
        fs::create_directories(m_folder);
        plugIn();
    }
    ~RealPortTest() override { fs::remove_all(m_folder); }

    void plugIn() {
        m_plateServer = std::move(PtyServer::create(m_plate, m_folder / "plate").value());
        m_streamServer = std::move(PtyServer::create(m_stream, m_folder / "sensors").value());
    }
    void unplug() {
        m_plateServer.reset();
        m_streamServer.reset();
    }

    /// As the engine does, every 5 ms, until `condition` holds or the time is over; answers the time taken.
    template <class Condition> double runUntil(Condition condition, double limit_s) {
        const double begin_s = m_clock.now_s();
        QEventLoop loop;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &loop, [&] {
            const double now_s = m_clock.now_s();
            if (m_plateServer)
                m_plateServer->work(now_s);
            if (m_streamServer)
                m_streamServer->work(now_s);
            m_heater.work();
            m_thermometer.work();
            if (condition() || now_s - begin_s > limit_s)
                loop.quit();
        });
        timer.start(5);
        loop.exec();
        return m_clock.now_s() - begin_s;
    }
    bool areLive() const {
        return m_heater.status().link == LinkState::Live && m_thermometer.status().link == LinkState::Live;
    }

    fs::path m_folder = fs::temp_directory_path() / ("bask_ports_" + std::to_string(::getpid()));
    SteadyClock m_clock;
    NamurSimulator m_plate;
    StreamSimulator m_stream;
    std::unique_ptr<PtyServer> m_plateServer, m_streamServer;
    SerialLink m_plateLink{m_folder / "plate", {9600, 7, 'E', 1}}, m_streamLink{m_folder / "sensors", {}};
    NamurHeater m_heater{m_plateLink, m_clock, {}};
    StreamThermometer m_thermometer{m_streamLink, m_clock, 3};
};

// Catches drivers that work on scripts only, unplugged ports that cost time, and ports that come back late.
TEST_F(RealPortTest, bothDevicesLiveArePulledAndComeBack) {
    EXPECT_LT(runUntil([&] { return areLive(); }, 5.0), 2.0);
    ASSERT_TRUE(areLive());
    ASSERT_TRUE(m_heater.keepHeating(350.0, 5.0).ok());
    runUntil([&] { return m_plate.isOn(); }, 3.0);
    EXPECT_TRUE(m_plate.isOn());
    EXPECT_NEAR(m_heater.read().value().value_K, m_plate.temperature_K(), 1.0);
    EXPECT_TRUE(m_thermometer.read().value().at(2).valid);

    unplug();
    const auto areLost = [&] {
        return m_heater.status().link == LinkState::Lost && m_thermometer.status().link == LinkState::Lost;
    };
    EXPECT_LT(runUntil(areLost, 5.0), 0.5);
    EXPECT_TRUE(areLost());
    EXPECT_FALSE(m_heater.read().ok());
    EXPECT_FALSE(m_thermometer.read().ok());
    const double before_s = usedTime_s();
    runUntil([] { return false; }, 1.5);
    const double cost = (usedTime_s() - before_s) / 1.5;
    RecordProperty("processor_ppm_of_two_dead_ports", static_cast<int>(cost * 1e6));
    EXPECT_LT(cost, 0.1);

    plugIn();
    const double back_s = runUntil([&] { return areLive(); }, 5.0);
    RecordProperty("back_after_ms", static_cast<int>(back_s * 1e3));
    EXPECT_LT(back_s, 2.0);
    EXPECT_TRUE(areLive());
    EXPECT_FALSE(m_heater.heating()) << "not by itself";
}

} // namespace
} // namespace bask
