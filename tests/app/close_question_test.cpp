// Heat that is not known to be off, and exports that are not finished, when a window closes.

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/grbl_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/stream_simulator.h"
#include "engine/drivers/driver_catalogue.h"
#include "tests/app/window_fixture.h"
#include "tests/support/guard_processes.h"
#include "tests/support/held_pool.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"

#include <QAbstractButton>
#include <QDir>
#include <QElapsedTimer>
#include <QMessageBox>
#include <QTimer>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

namespace bask::test {
namespace {

/// A rig's devices at the far ends of pseudo-terminals. They work while the window waits for its engine.
class DevicesBeside {
public:
    DevicesBeside() {
        for (std::size_t i = 0; i < m_servers.size(); ++i)
            m_servers[i] = PtyServer::create(*m_devices[i], port(i)).value();
        m_thread = std::thread([this] {
            for (; !m_isOver; QThread::msleep(2)) {
                const std::scoped_lock lock(m_mutex);
                for (const auto& server : m_servers)
                    server->work(m_clock.now_s());
            }
        });
    }
    ~DevicesBeside() {
        m_isOver = true;
        m_thread.join();
        endGuardsOf(m_folder.path());
    }
    std::string port(std::size_t i) const { return m_folder.filePath(QString::number(i)).toStdString(); }
    void setPlateFault(const std::string& fault) {
        const std::scoped_lock lock(m_mutex);
        EXPECT_TRUE(m_plate.setFault(fault));
    }
    bool isPlateOn() {
        const std::scoped_lock lock(m_mutex);
        return m_plate.isOn();
    }
    /// One that needs no homing, and where the axes read zero, the objects are well above the source.
    RigSpec spec(const Vector6d& start) const {
        RigSpec rig;
        rig.robot.emplace().port = port(0);
        for (AxisSpec& axis : rig.robot->axes)
            axis.origin = start[axis.coordinate];
        rig.robot->serial = driverOf(*rig.robot).serial;
        rig.robot->mustHome = false;
        rig.thermometer.emplace().driver = "stream";
        rig.thermometer->port = port(1);
        rig.thermometer->serial = driverOf(*rig.thermometer).serial;
        rig.thermometer->channels = {0, 1, 2};
        rig.source.emplace().driver = "namur";
        rig.source->port = port(2);
        rig.source->serial = driverOf(*rig.source).serial;
        return rig;
    }

private:
    QTemporaryDir m_folder;
    SteadyClock m_clock;
    GrblSimulator m_grbl{{}};
    StreamSimulator m_stream{{}};
    NamurSimulator m_plate{{}};
    std::array<ByteDevice*, 3> m_devices{&m_grbl, &m_stream, &m_plate};
    std::array<std::unique_ptr<PtyServer>, 3> m_servers;
    std::mutex m_mutex;
    std::atomic<bool> m_isOver = false;
    std::thread m_thread;
};

class CloseQuestionTest : public WindowTest {
protected:
    /// A person has looked, and heats by hand.
    void heatOn(DevicesBeside& devices) {
        openWindow();
        Experiment experiment = window->document().experiment();
        experiment.rig = devices.spec(experiment.start);
        experiment.sampling.period_s = 0.2;
        experiment.safety.stalePeriods = 20.0; // a busy machine is no fault
        ASSERT_TRUE(window->document().edit(experiment).ok());
        const auto& last = window->lastSnapshot();
        ASSERT_TRUE(waitFor([&] {
            const auto isLive = [](const RigDeviceState& device) {
                return device.status.link == LinkState::Live;
            };
            return !last.simulated && last.devices.size() == 3 && std::ranges::all_of(last.devices, isLive);
        }));
        ASSERT_TRUE(comes([&] { return last.state == RunState::Ready; }, Reset{})) << reasons();
        ASSERT_TRUE(comes([&] { return last.heat == HeatState::On && devices.isPlateOn(); },
                          SetHeat{kelvinFromCelsius(100.0)}))
            << reasons();
    }
    std::string reasons() const {
        std::string out = runStateName(state());
        for (const Message& reason : window->lastSnapshot().reasons)
            out += " | " + describe(reason);
        return out + " | refused: " + describe(refusal);
    }
    /// Says it until it is so: a busy machine's readings may not be fresh at once.
    template <class Condition> bool comes(Condition condition, const Command& command) {
        QElapsedTimer said;
        return waitFor([&] {
            if (const Message& told = window->lastSnapshot().refusal; told.code != MessageCode::None)
                refusal = told;
            if (!condition() && (!said.isValid() || said.elapsed() > 500)) {
                if (!window->lastSnapshot().isPlaceSure)
                    window->engine().send(ClearRobotAlarm{});
                window->engine().send(command);
                said.start();
            }
            return condition();
        });
    }
    /// How many boxes came meanwhile, each answered by a key, `look`ed at before.
    int boxesAtClosing(const std::function<void(QMessageBox&)>& look = {}) {
        int boxes = 0;
        QTimer answer;
        QObject::connect(&answer, &QTimer::timeout, [&] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                ++boxes;
                answer.stop(); // or it comes again while a picture is taken
                if (look)
                    look(*box);
                EXPECT_TRUE(window->isVisible()) << "until it is answered";
                QTest::keyClick(box, Qt::Key_Escape);
                answer.start();
            }
        });
        answer.start(20);
        window->document().markSaved({}); // no question about changes
        EXPECT_TRUE(window->close());
        EXPECT_FALSE(window->isVisible());
        return boxes;
    }

    /// Of what the Run page shows.
    void exportTable(const QString& to) {
        window->files().setFileChooser([to](const FileQuestion&) { return to; });
        for (const PlotPlace* place : window->findChildren<PlotPlace*>())
            if (place->plot()->objectName() == QLatin1String("plot.measured_K"))
                window->files().exportPlot(*place, PlotForm::Csv);
        EXPECT_EQ(window->files().unfinishedExports(), QStringList{to});
    }
    /// Closes, and answers the question about exports: by a button, or by Escape. Returns what it said.
    QString closeOverExport(const char* button = nullptr) {
        QString said;
        QTimer answer;
        QObject::connect(&answer, &QTimer::timeout, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr || box->objectName() != QLatin1String("exportQuestion"))
                return;
            answer.stop();
            said = box->text();
            if (button == nullptr)
                QTest::keyClick(box, Qt::Key_Escape);
            else
                box->findChild<QAbstractButton*>(QLatin1String(button))->click();
        });
        answer.start(20);
        window->document().markSaved({}); // no question about changes
        window->close();
        return said;
    }

    Message refusal; ///< the last one
};

// Catches a window that goes away over a plate which may still be heating, and says nothing.
TEST_F(CloseQuestionTest, HeatThatIsNotKnownToBeOffIsTold) {
    DevicesBeside devices;
    ASSERT_NO_FATAL_FAILURE(heatOn(devices));
    devices.setPlateFault("silent");
    QString name, text, more;
    EXPECT_EQ(boxesAtClosing([&](QMessageBox& box) {
                  name = box.objectName();
                  text = box.text();
                  more = box.informativeText();
                  for (const Theme theme : {Theme::Light, Theme::Dark}) {
                      window->setTheme(theme);
                      keepPicture(QStringLiteral("heat-left-") + (theme == Theme::Dark ? "dark" : "light"));
                  }
              }),
              1);
    EXPECT_TRUE(devices.isPlateOn()) << "it is heard no more, and hears nothing";
    EXPECT_EQ(name, QStringLiteral("heatLeft"));
    EXPECT_TRUE(text.contains(QStringLiteral("has not said that it is off"))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("mains"))) << text.toStdString();
    EXPECT_TRUE(more.contains(QStringLiteral("next start"))) << more.toStdString();

    openWindow(); // as it promised
    EXPECT_TRUE(waitFor([this] {
        return std::ranges::any_of(window->lastSnapshot().alarms, [](const Alarm& alarm) {
            return alarm.message.code == MessageCode::HeatLeftUnknown;
        });
    }));
}

// Catches a box at every closing, which nobody reads any more.
TEST_F(CloseQuestionTest, ARealRigThatIsSeenOffClosesWithoutAWord) {
    DevicesBeside devices;
    ASSERT_NO_FATAL_FAILURE(heatOn(devices));
    const auto& last = window->lastSnapshot();
    ASSERT_TRUE(comes([&] { return last.heat == HeatState::Off && !last.heatOn; }, SetHeat{}));
    EXPECT_EQ(boxesAtClosing(), 0);
    EXPECT_FALSE(devices.isPlateOn());
}

// Catches an export that is dropped without a word, and a question about one that is finished.
TEST_F(CloseQuestionTest, AnExportThatIsNotFinishedIsAskedAbout) {
    openWindow();
    const QTemporaryDir folder;
    const QString table = folder.filePath(QStringLiteral("the <b>day.csv"));
    HeldPool pool;
    exportTable(table);
    const QString said = closeOverExport();
    EXPECT_TRUE(said.contains(table)) << said.toStdString();
    EXPECT_TRUE(window->isVisible());
    pool.release();
    ASSERT_TRUE(waitFor([&] { return window->files().unfinishedExports().isEmpty(); }));
    EXPECT_TRUE(QFile::exists(table)) << "it was waited for";
    EXPECT_EQ(boxesAtClosing(), 0);
}

// Catches a window that cannot be closed over an export, and half a file of one.
TEST_F(CloseQuestionTest, AnExportCanBeLeft) {
    openWindow();
    const QTemporaryDir folder;
    const QString table = folder.filePath(QStringLiteral("day.csv"));
    HeldPool pool;
    exportTable(table);
    EXPECT_FALSE(closeOverExport("closeAnyway").isEmpty());
    EXPECT_FALSE(window->isVisible());
    testing::internal::CaptureStderr();
    window.reset();
    EXPECT_NE(testing::internal::GetCapturedStderr().find(table.toStdString()), std::string::npos);
    pool.release();
    ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(60'000));
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

// Catches an alarm over heat that is simulated: here it stays on, whatever it is told.
TEST_F(CloseQuestionTest, SimulatedHeatIsNobodysDanger) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const auto& last = window->lastSnapshot();
    ASSERT_TRUE(comes([&] { return last.heat == HeatState::On; }, SetHeat{kelvinFromCelsius(100.0)}));
    window->engine().send(SimulateFault{SimulatedFault::SourceKeepsHeat, 0});
    window->engine().send(SetHeat{});
    EXPECT_EQ(boxesAtClosing(), 0);
}

} // namespace
} // namespace bask::test
