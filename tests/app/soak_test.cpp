// The control loop at 10 Hz over three serial ports, watched from outside: no sample lost, memory flat, and
// how late its steps begin; also beside a broker that is killed again and again. The short forms run in CI,
// the long ones by hand (CONTRIBUTING.md).

#include "engine/recording/session_file.h"
#include "engine/runtime/lateness.h"
#include "tests/app/hogs.h"
#include "tests/app/rig_processes.h"
#include "tests/support/mqtt_broker.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <atomic>
#include <cstdio>
#include <thread>

namespace bask::test {
namespace {

/// A thread that does nothing but wake up each 100 ms: as late as the machine makes anybody.
class BareThread {
public:
    BareThread()
        : m_thread([this] {
              auto due = std::chrono::steady_clock::now();
              while (!m_isOver) {
                  due += std::chrono::milliseconds(100);
                  std::this_thread::sleep_until(due);
                  const std::chrono::duration<double> late = std::chrono::steady_clock::now() - due;
                  m_lateness.add(late.count());
              }
          }) {}
    ~BareThread() { end(); }
    const Lateness& end() {
        m_isOver = true;
        if (m_thread.joinable())
            m_thread.join();
        return m_lateness;
    }

private:
    std::atomic<bool> m_isOver = false;
    Lateness m_lateness;
    std::thread m_thread;
};

/// Least squares, in units of y per unit of x, of equidistant values.
double slope(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size()), middle = 0.5 * (n - 1.0);
    double xy = 0.0, xx = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double x = static_cast<double>(i) - middle;
        xy += x * values[i];
        xx += x * x;
    }
    return xx > 0.0 ? xy / xx : 0.0;
}

/// From then on the log of the traffic, of the last ten minutes, takes as much memory as it will.
constexpr std::size_t kLogIsFull_s = 660;

class SoakTest : public RigProcesses {
protected:
    /// Memory of the engine's process, MB.
    double resident_MB() const {
        QFile status(QStringLiteral("/proc/%1/status").arg(engine.processId()));
        if (!status.open(QIODevice::ReadOnly))
            return 0.0;
        const QByteArray text = status.readAll();
        const qsizetype at = text.indexOf("VmRSS:");
        return at < 0 ? 0.0 : text.mid(at + 6).trimmed().split(' ').first().toDouble() / 1024.0;
    }

    /// Runs for so long; takes the memory every second, and then calls `eachSecond` with its number.
    void run(int duration_s, int hogs, const QStringList& arguments = {},
             const std::function<void(int)>& eachSecond = {}) {
        startBench();
        const QString summary = QFileInfo(session()).path() + QStringLiteral("/summary.json");
        startEngine(QStringList{QStringLiteral("--duration"), QString::number(duration_s),
                                QStringLiteral("--summary"), summary} +
                    arguments);
        ASSERT_NO_FATAL_FAILURE(waitUntilHeating());
        const Hogs busy(hogs);
        BareThread bareThread;
        const auto begun = std::chrono::steady_clock::now();
        for (int i = 1; i < duration_s; ++i) {
            std::this_thread::sleep_until(begun +
                                          std::chrono::seconds(i)); // waitFor would be one more busy thread
            memory_MB.push_back(resident_MB());
            ASSERT_GT(memory_MB.back(), 0.0) << "it has ended after " << i << " s: " << output();
            if (eachSecond)
                eachSecond(i);
        }
        bare = bareThread.end();
        ASSERT_TRUE(ended(120000).has_value());
        QFile file(summary);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << engine.readAll().toStdString();
        late = QJsonDocument::fromJson(file.readAll()).object()[QStringLiteral("control_steps")].toObject();
        const auto record = readSession(session().toStdString());
        ASSERT_TRUE(record.ok()) << describe(record.error());
        samples = record->controlledSamples();
        tell();
    }
    /// The same, published to a broker that is started, frozen for a second and killed, every so many
    /// seconds.
    void runBesideABroker(int duration_s, int period_s) {
        MqttBroker broker;
        const QString settings = QFileInfo(session()).path() + QStringLiteral("/monitor.json");
        QFile file(settings);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QStringLiteral(R"({"format": "bask-monitor", "version": 1, "broker": {"on": true, )"
                                  R"("address": "%1"}})")
                       .arg(QString::fromStdString(broker.address()))
                       .toUtf8());
        file.close();
        const auto eachSecond = [&](int second) {
            if (second % period_s == 1) {
                broker.start();
                ++starts;
            }
            if (second % period_s == period_s - 1) {
                MqttSubscriber subscriber(broker.port()); // what is retained was published since it started
                heard += waitFor([&] { return subscriber.last("presence") == "here"; }, 500) ? 1 : 0;
                broker.freeze();
            }
            if (second % period_s == 0)
                broker.kill();
        };
        run(duration_s, 0, {QStringLiteral("--monitor"), settings}, eachSecond);
    }
    void tell() const {
        std::printf("control steps: %d, late by %.1f ms (median), %.1f ms (99.9 %%), %.1f ms (worst)",
                    late_("count") > 0.0 ? static_cast<int>(late_("count")) : 0, late_("late_ms_p50"),
                    late_("late_ms_p99_9"), late_("late_ms_worst"));
        std::printf("\na bare thread meanwhile: late by %.1f ms (median), %.1f ms (99.9 %%), %.1f ms (worst)",
                    1e3 * bare.quantile_s(0.5), 1e3 * bare.quantile_s(0.999), 1e3 * bare.worst_s());
        std::printf("\nmemory:");
        for (std::size_t i = 0; i < memory_MB.size(); i += std::max<std::size_t>(1, memory_MB.size() / 10))
            std::printf(" %.2f", memory_MB[i]);
        std::printf(" MB\n");
    }
    std::string output() {
        engine.waitForFinished(1000);
        return engine.readAll().toStdString();
    }
    double late_(const char* name) const { return late[QLatin1String(name)].toDouble(); }

    /// Each step that the engine made, and each one that was due.
    void expectComplete() const {
        const double steps = late_("count");
        EXPECT_GE(static_cast<double>(samples.size()), steps);
        EXPECT_LE(static_cast<double>(samples.size()), steps + 3.0) << "the first and the last";
        for (std::size_t i = 1; i < samples.size(); ++i)
            EXPECT_GT(samples[i].time_s, samples[i - 1].time_s) << i;
    }
    /// Over the time from `from_s` on.
    double growth_MB(std::size_t from_s) const {
        const auto from = memory_MB.begin() + static_cast<std::ptrdiff_t>(std::min(from_s, memory_MB.size()));
        const std::vector<double> settled(from, memory_MB.end());
        return slope(settled) * static_cast<double>(settled.size());
    }

    std::vector<double> memory_MB; ///< each second
    QJsonObject late;
    Lateness bare;
    std::vector<TraceSample> samples;
    int starts = 0; ///< of the broker
    int heard = 0;  ///< and so often it had heard of the run
};

} // namespace

// Catches samples that are lost on their way into the file, and memory that each step costs.
TEST_F(SoakTest, twentySeconds) {
    ASSERT_NO_FATAL_FAILURE(run(20, 0));
    expectComplete();
    EXPECT_GE(samples.size(), 190U);
    EXPECT_LT(growth_MB(10), 1.0);
}

// Catches the same over time and under load, and steps that come late.
TEST_F(SoakTest, twentyMinutesBesideTwoBusyThreads) {
    ASSERT_NO_FATAL_FAILURE(run(1200, 2));
    expectComplete();
    EXPECT_GE(samples.size(), 12000U) << "none that was due is missing";
    EXPECT_LT(late_("late_ms_p99_9"), 20.0);
    EXPECT_LT(growth_MB(kLogIsFull_s), 1.0);
}

// Catches a broker that holds the loop up: one that is not there, that comes, that says nothing, that is
// lost.
TEST_F(SoakTest, twentySecondsBesideABrokerThatComesAndGoes) {
    ASSERT_NO_FATAL_FAILURE(runBesideABroker(20, 6));
    expectComplete();
    EXPECT_GE(samples.size(), 190U);
    EXPECT_LT(late_("late_ms_p50"), 1e3 * bare.quantile_s(0.5) + 10.0);
    EXPECT_EQ(starts, 4);
    EXPECT_GE(heard, 2);
}

TEST_F(SoakTest, twentyMinutesBesideABrokerThatIsKilledTwoHundredTimes) {
    ASSERT_NO_FATAL_FAILURE(runBesideABroker(1200, 6));
    expectComplete();
    EXPECT_GE(samples.size(), 12000U) << "none that was due is missing";
    EXPECT_LT(late_("late_ms_p99_9"), 20.0);
    EXPECT_LT(growth_MB(kLogIsFull_s), 1.0);
    EXPECT_EQ(starts, 200);
    EXPECT_GE(heard, 190);
    std::printf("brokers: %d, which had heard of the run: %d\n", starts, heard);
}

} // namespace bask::test
