// What is published of a run, to a real broker and to files, whatever becomes of them.

#include "engine/base/message_code.h"
#include "engine/monitor/monitor.h"
#include "engine/monitor/status_files.h"
#include "tests/support/listening_sockets.h"
#include "tests/support/mqtt_broker.h"

#include <nlohmann/json.hpp>

#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QHostAddress>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

#include <dlfcn.h>
#include <fcntl.h>
#include <netdb.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace bask;
using nlohmann::json;
using test::waitFor;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Snapshot runningSnapshot() {
    Snapshot s;
    s.state = RunState::Running;
    s.simulated = false;
    s.experiment = "two \"disks\"";
    s.objects = {"left", "ri\nght"};
    s.targets_K = {313.15, 323.15};
    s.latest.objects.resize(2);
    s.latest.objects[0].measured_K = 300.15;
    s.latest.objects[0].estimated_K = 300.25;
    s.latest.objects[1].measured_K = kUnknown;
    s.latest.objects[1].estimated_K = kUnknown;
    s.sensors = {SensorTrust::Trusted, SensorTrust::Stale};
    s.readingAges_s = {0.1, std::numeric_limits<double>::infinity()};
    s.labels = {"A. Hu", "plate 7", "B"};
    s.source_K = 573.15;
    s.place = PlaceState::Sure;
    return s;
}

Snapshot withEvent(Snapshot snapshot, int number) {
    snapshot.newEvents.push_back({1.0 * number, {MessageCode::EventFault, {std::to_string(number)}}});
    return snapshot;
}

MonitorSettings settingsFor(const test::MqttBroker& broker) {
    MonitorSettings settings;
    settings.usesBroker = true;
    settings.broker.address = broker.address();
    return settings;
}

std::string textOf(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// As the engine does it: 20 a second, from a thread of its own. Remembers the longest call.
class Feeder {
public:
    explicit Feeder(Monitor& monitor)
        : m_thread([this, inlet = monitor.inlet().tell] {
              for (int k = 0; !m_isOver; ++k) {
                  const Snapshot snapshot = withEvent(runningSnapshot(), k);
                  const auto begun = std::chrono::steady_clock::now();
                  inlet(snapshot);
                  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
                  m_longest_s = std::max(m_longest_s.load(), took.count());
                  m_count = k + 1;
                  std::this_thread::sleep_for(std::chrono::milliseconds(50));
              }
          }) {}
    ~Feeder() { stop(); }
    Feeder(const Feeder&) = delete;
    Feeder& operator=(const Feeder&) = delete;

    void stop() {
        m_isOver = true;
        if (m_thread.joinable())
            m_thread.join();
    }
    double longest_s() const { return m_longest_s; }
    int count() const { return m_count; }

private:
    std::atomic<bool> m_isOver = false;
    std::atomic<double> m_longest_s = 0.0;
    std::atomic<int> m_count = 0;
    std::thread m_thread;
};

/// A machine that is busy holds up any thread; a network or a disk would for seconds.
constexpr double kMoment_s = 0.25;

/// The one name that getaddrinfo() below knows of itself: this address, then 127.0.0.1.
constexpr const char* kTwoPlaces = "two.places.example";
std::string g_firstPlace;

/// An address where nobody answers, as behind a firewall: what waits to be accepted there is full.
class DeadPlace {
public:
    DeadPlace(const std::string& address, int port) {
        addrinfo wanted{}, *place = nullptr;
        wanted.ai_socktype = SOCK_STREAM;
        wanted.ai_flags = AI_NUMERICHOST;
        if (::getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &place) != 0)
            return;
        const int listener = newSocket(*place);
        m_exists = ::bind(listener, place->ai_addr, place->ai_addrlen) == 0 && ::listen(listener, 0) == 0;
        for (int k = 0; m_exists && k < 4; ++k)
            (void)::connect(newSocket(*place), place->ai_addr, place->ai_addrlen);
        ::freeaddrinfo(place);
    }
    ~DeadPlace() {
        for (const int socket : m_sockets)
            ::close(socket);
    }
    DeadPlace(const DeadPlace&) = delete;
    DeadPlace& operator=(const DeadPlace&) = delete;

    bool exists() const { return m_exists; }

private:
    int newSocket(const addrinfo& place) {
        m_sockets.push_back(::socket(place.ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        return m_sockets.back();
    }

    std::vector<int> m_sockets;
    bool m_exists = false;
};

} // namespace

extern "C" int getaddrinfo(const char* host, const char* service, const addrinfo* wanted, addrinfo** found) {
    const auto systems = reinterpret_cast<decltype(&getaddrinfo)>(::dlsym(RTLD_NEXT, "getaddrinfo"));
    if (host == nullptr || std::string(host) != kTwoPlaces)
        return systems(host, service, wanted, found);
    const int code = systems(g_firstPlace.c_str(), service, wanted, found);
    return code != 0 ? code : systems("127.0.0.1", service, wanted, &(*found)->ai_next);
}

TEST(MonitorStatus, IsJsonWithNullForWhatIsNotKnown) {
    const json status = json::parse(statusJson({1700000000.25, false, runningSnapshot()}));
    EXPECT_EQ(status["time"], "2023-11-14T22:13:20.250Z");
    EXPECT_EQ(status["state"], "Running");
    EXPECT_EQ(status["operator"], "A. Hu");
    EXPECT_EQ(status["experiment"], "two \"disks\"");
    EXPECT_NEAR(status["objects"][0]["measured_C"].get<double>(), 27.0, 1e-9);
    EXPECT_NEAR(status["objects"][1]["target_C"].get<double>(), 50.0, 1e-9);
    EXPECT_TRUE(status["objects"][1]["measured_C"].is_null());
    EXPECT_TRUE(status["objects"][1]["age_s"].is_null());
    EXPECT_NEAR(status["source"]["temperature_C"].get<double>(), 300.0, 1e-9);

    Snapshot unknown;
    unknown.objects = {"left"}; // no sample has come yet
    const json empty = json::parse(statusJson({0.0, true, unknown}));
    EXPECT_TRUE(empty["objects"][0]["measured_C"].is_null());
    EXPECT_TRUE(empty["source"]["temperature_C"].is_null());
    EXPECT_TRUE(empty["robot"]["coordinates"].is_null());
    EXPECT_EQ(empty["closed"], true);
}

// Catches "off" that is told elsewhere beside a plate which heats though off.
TEST(MonitorStatus, TellsASourceThatHeatsUnasked) {
    MonitorStatus status{1700000000.25, false, runningSnapshot()};
    const auto heat = [&] { return json::parse(statusJson(status))["source"]["heat"]; };
    const auto isTold = [&] {
        const std::string text = statusMetrics(status);
        EXPECT_NE(text.find("bask_heat_on 0\n"), std::string::npos) << "nobody commands it";
        const bool isOne = text.find("bask_heats_unasked 1\n") != std::string::npos;
        EXPECT_NE(isOne, text.find("bask_heats_unasked 0\n") != std::string::npos);
        return isOne;
    };
    status.snapshot.heat = HeatState::Off;
    EXPECT_EQ(heat(), "off");
    EXPECT_FALSE(isTold());

    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    alarm.isAcknowledged = true; // it heats on
    status.snapshot.alarms = {alarm};
    EXPECT_EQ(heat(), "unasked");
    EXPECT_TRUE(isTold());

    status.snapshot.heat = HeatState::Unknown;
    EXPECT_EQ(heat(), "unknown");
    EXPECT_NE(statusMetrics(status).find("bask_heats_unasked 1\n"), std::string::npos)
        << "its end was not seen";
    status.snapshot.heat = HeatState::On;
    EXPECT_EQ(heat(), "on");
    EXPECT_FALSE(isTold());

    status.snapshot.heat = HeatState::Off;
    status.snapshot.alarms[0].isActive = false; // over, and still listed
    EXPECT_EQ(heat(), "off");
    EXPECT_FALSE(isTold());
}

TEST(MonitorStatus, IsInTheTextFormatOfPrometheus) {
    const std::string text = statusMetrics({1700000000.25, false, runningSnapshot()});
    const std::regex sample(
        R"(bask_[a-z_]+(\{[a-z_]+="([^"\\]|\\.)*"(,[a-z_]+="([^"\\]|\\.)*")*\})? ([-+0-9.e]+|NaN|[-+]Inf))");
    const std::regex comment("# (HELP bask_[a-z_]+ .+|TYPE bask_[a-z_]+ (gauge|counter))");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        EXPECT_TRUE(std::regex_match(line, line.starts_with('#') ? comment : sample)) << line;
    EXPECT_NE(text.find("bask_state{state=\"Running\"} 1\n"), std::string::npos);
    EXPECT_NE(text.find("bask_state{state=\"Fault\"} 0\n"), std::string::npos);
    EXPECT_NE(text.find("bask_object_measured_celsius{object=\"ri\\nght\"} NaN\n"), std::string::npos);
    EXPECT_NE(text.find("bask_source_celsius 300\n"), std::string::npos);
}

TEST(MonitorSettings, AreKeptAndRefuseWhatTheyAreNot) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("monitor.json").toStdString();
    EXPECT_FALSE(readMonitorSettings(path)->isOn()); // no file: nothing is on
    MonitorSettings settings;
    settings.usesBroker = true;
    settings.broker = {"mqtt.lab:8883", true, "/etc/ca.pem", "bask", "/etc/secret", "lab2/bask"};
    settings.statusFolder = "/var/lib/bask"; // set up, and switched off
    ASSERT_TRUE(writeMonitorSettings(settings, path));
    EXPECT_EQ(readMonitorSettings(path).value(), settings);

    const auto refused = [&](const std::string& text) {
        std::ofstream(path) << text;
        const auto read = readMonitorSettings(path);
        return read ? MessageCode::None : read.error().code();
    };
    const std::string head = R"({"format":"bask-monitor","version":1,)";
    EXPECT_EQ(refused(""), MessageCode::FileEmpty);
    EXPECT_EQ(refused("{"), MessageCode::JsonSyntax);
    EXPECT_EQ(refused(head + R"("password":"x"})"), MessageCode::JsonUnknownKey);
    EXPECT_EQ(refused(head + R"("broker":{"address":"two words"}})"), MessageCode::MonitorAddressWrong);
    EXPECT_EQ(refused(head + R"("broker":{"address":"a","topic":"all/#"}})"), MessageCode::MonitorTopicWrong);
    EXPECT_EQ(refused(head + R"("broker":{"address":"a","topic":"$SYS"}})"), MessageCode::MonitorTopicWrong);
    EXPECT_EQ(refused(head + R"("broker":{"address":"a","topic":"a//b"}})"), MessageCode::MonitorTopicWrong);
    EXPECT_EQ(refused(head + R"("broker":{"address":"a","topic":""}})"), MessageCode::MonitorTopicWrong);
    EXPECT_EQ(refused(head + R"("broker":{}})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(head + R"("broker":{"address":"a","password_file":"b"}})"),
              MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(head + R"("status_folder":""})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(refused(R"({"format":"bask-monitor","version":2})"), MessageCode::VersionTooNew);
}

TEST(MonitorSettings, ReadAPasswordThatNobodyElseMayRead) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("secret").toStdString();
    std::ofstream(path) << "open sesame\n";
    ::chmod(path.c_str(), 0644);
    EXPECT_EQ(readPassword(path).error().code(), MessageCode::MonitorSecretOpen);
    ::chmod(path.c_str(), 0600);
    EXPECT_EQ(readPassword(path).value(), "open sesame");
    std::ofstream(path) << "\n";
    EXPECT_EQ(readPassword(path).error().code(), MessageCode::FileEmpty);
    EXPECT_EQ(readPassword(path + "2").error().code(), MessageCode::FileNotFound);
}

TEST(MonitorWithBroker, PublishesToABroker) {
    test::MqttBroker broker;
    broker.start();
    {
        Monitor monitor;
        monitor.use(settingsFor(broker));
        const auto inlet = monitor.inlet().tell;
        Snapshot snapshot = runningSnapshot();
        Alarm alarm;
        alarm.message = {MessageCode::SafetyStartUp, {}};
        snapshot.alarms.push_back(alarm);
        inlet(withEvent(snapshot, 1));
        ASSERT_TRUE(waitFor([&] { return monitor.state().sent >= 4; })); // presence is the link's own
        test::MqttSubscriber late(broker.port()); // what is retained it gets all the same
        ASSERT_TRUE(waitFor([&] { return !late.last("status").empty() && !late.last("alarms").empty(); }));
        EXPECT_EQ(json::parse(late.last("status"))["state"], "Running");
        EXPECT_EQ(json::parse(late.last("alarms"))[0]["code"], "SafetyStartUp");
        EXPECT_EQ(late.last("presence"), "here");
        EXPECT_TRUE(late.last("event").empty());
        inlet(withEvent(snapshot, 2));
        ASSERT_TRUE(waitFor([&] { return !late.last("event").empty(); }));
        EXPECT_EQ(json::parse(late.last("event"))["code"], "EventFault");
        EXPECT_TRUE(monitor.state().isConnected);
        EXPECT_EQ(monitor.state().brokerProblem.code, MessageCode::None);
        EXPECT_EQ(test::listeningSockets(), "") << "it publishes only";
    }
    test::MqttSubscriber after(broker.port());
    ASSERT_TRUE(waitFor([&] { return after.last("presence") == "closed"; }));
    ASSERT_TRUE(waitFor([&] { return !after.last("status").empty(); }));
    EXPECT_EQ(json::parse(after.last("status"))["closed"], true);
}

/// 10 here; 100 in the soak.
void killAgainAndAgain(int times) {
    test::MqttBroker broker;
    Monitor monitor;
    Feeder feeder(monitor);
    monitor.use(settingsFor(broker)); // nobody is there yet
    ASSERT_TRUE(waitFor([&] { return monitor.state().brokerProblem.code == MessageCode::MonitorNoBroker; }));
    for (int k = 0; k < times; ++k) {
        broker.start();
        QElapsedTimer since;
        since.start();
        ASSERT_TRUE(waitFor([&] { return monitor.state().isConnected; })) << k;
        EXPECT_LT(since.elapsed(), 5000) << k;
        EXPECT_EQ(monitor.state().brokerProblem.code, MessageCode::None);
        const auto sent = monitor.state().sent;
        ASSERT_TRUE(waitFor([&] { return monitor.state().sent > sent + 3; }));
        broker.kill();
        ASSERT_TRUE(waitFor([&] { return !monitor.state().isConnected; })) << k;
    }
    feeder.stop();
    EXPECT_GT(feeder.count(), 10);
    EXPECT_LT(feeder.longest_s(), kMoment_s);
}

TEST(MonitorWithBroker, ConnectsAgainToABrokerThatWasKilled) {
    killAgainAndAgain(10);
}

TEST(MonitorWithBroker, SendsAgainWhatAKilledBrokerHasNotAcknowledged) {
    test::MqttBroker broker;
    broker.start();
    Monitor monitor;
    monitor.use(settingsFor(broker));
    ASSERT_TRUE(waitFor([&] { return monitor.state().isConnected; }));
    broker.freeze(); // takes what is sent, and acknowledges nothing
    const auto inlet = monitor.inlet().tell;
    const auto sent = monitor.state().sent;
    for (int k = 0; k < 5; ++k)
        inlet(withEvent(runningSnapshot(), k));
    ASSERT_TRUE(waitFor([&] { return monitor.state().sent >= sent + 5; }));
    broker.kill();
    const auto before = monitor.state().sent;
    broker.start();
    EXPECT_TRUE(waitFor([&] { return monitor.state().sent >= before + 5; }));
}

TEST(MonitorWithBroker, TellsOfABrokerThatDoesNotAcknowledgeAndForgetsTheOldest) {
    test::MqttBroker broker;
    broker.start();
    Monitor monitor;
    monitor.use(settingsFor(broker));
    ASSERT_TRUE(waitFor([&] { return monitor.state().isConnected; }));
    const Feeder feeder(monitor);
    broker.freeze();
    // It is told as slow first, and as lost when it has answered no ping.
    EXPECT_TRUE(waitFor([&] { return monitor.state().brokerProblem.code == MessageCode::MonitorSlow; }));
    const auto inlet = monitor.inlet().tell;
    for (int k = 0; k < 3000; ++k)
        inlet(withEvent(runningSnapshot(), k));
    EXPECT_GE(monitor.state().leftOut, 1900u);
    EXPECT_TRUE(waitFor([&] { return monitor.state().brokerProblem.code == MessageCode::MonitorNoBroker; }));
    const std::string lost = describe(monitor.state().brokerProblem);
    EXPECT_NE(lost.find("no answer"), std::string::npos) << lost;
    broker.thaw();
    EXPECT_TRUE(waitFor([&] {
        return monitor.state().isConnected && monitor.state().brokerProblem.code == MessageCode::None;
    }));
    EXPECT_LT(feeder.longest_s(), kMoment_s);
}

// Catches the last words of a run that nobody hears.
TEST(MonitorWithBroker, SendsAtItsEndWhatStillWaits) {
    test::MqttBroker broker;
    broker.start();
    auto monitor = std::make_unique<Monitor>();
    monitor->use(settingsFor(broker));
    ASSERT_TRUE(waitFor([&] { return monitor->state().isConnected; }));
    test::MqttSubscriber subscriber(broker.port());
    monitor->inlet().tell(withEvent(runningSnapshot(), 1));
    ASSERT_TRUE(waitFor([&] { return subscriber.heard().count("event") == 1; }));
    const auto inlet = monitor->inlet().tell;
    for (int k = 2; k <= 30; ++k)
        inlet(withEvent(runningSnapshot(), k));
    monitor.reset();
    inlet(withEvent(runningSnapshot(), 31)); // after its end, into nothing
    EXPECT_TRUE(waitFor([&] { return subscriber.last("presence") == "closed"; }));
    EXPECT_EQ(subscriber.heard().count("event"), 30u);
}

// Catches a folder in which the files of one Bask lead out of it, and a disk that holds up the engine.
TEST(MonitorWithBroker, WritesThroughNoLinkAndWaitsForNoDisk) {
    const QTemporaryDir folder, other;
    const std::string victim = other.filePath("victim").toStdString();
    std::ofstream(victim) << "mine";
    std::filesystem::create_symlink(victim, folder.filePath(kStatusFile).toStdString());
    ASSERT_TRUE(writeStatusFiles({1.0, false, runningSnapshot()}, folder.path().toStdString()));
    EXPECT_EQ(textOf(victim), "mine");
    EXPECT_FALSE(std::filesystem::is_symlink(folder.filePath(kStatusFile).toStdString()));

    // A CA file that is a pipe hangs whoever reads it, as a dead mount would.
    const std::string pipe = other.filePath("pipe").toStdString();
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    test::MqttBroker broker;
    broker.start();
    MonitorSettings settings = settingsFor(broker);
    settings.broker.usesTls = true;
    settings.broker.caFile = pipe;
    QElapsedTimer since;
    {
        Monitor monitor;
        monitor.use(settings);
        const Feeder feeder(monitor);
        ASSERT_TRUE(waitFor([&] { return feeder.count() > 20; }));
        EXPECT_LT(feeder.longest_s(), kMoment_s);
        since.start();
    }
    EXPECT_LT(since.elapsed(), 3000) << "the thread that hangs is left to itself";
    const int end = ::open(pipe.c_str(), O_WRONLY | O_NONBLOCK); // lets it go
    ::close(end);
}

// Catches one that waits for ever, and one that waits with a whole core.
TEST(Monitor, GivesUpABrokerThatSaysNothing) {
    QTcpServer silent;
    ASSERT_TRUE(silent.listen(QHostAddress::LocalHost));
    for (const bool usesTls : {false, true}) {
        MonitorSettings settings;
        settings.usesBroker = true;
        settings.broker.address = "127.0.0.1:" + std::to_string(silent.serverPort());
        settings.broker.usesTls = usesTls;
        rusage before{}, after{};
        ::getrusage(RUSAGE_SELF, &before);
        const auto tried = tryMonitor(settings);
        ::getrusage(RUSAGE_SELF, &after);
        ASSERT_FALSE(tried);
        EXPECT_NE(describe(tried.error()).find("no answer"), std::string::npos) << describe(tried.error());
        EXPECT_LT(after.ru_utime.tv_sec - before.ru_utime.tv_sec, 2);
        QElapsedTimer since;
        {
            Monitor monitor;
            monitor.use(settings);
            ASSERT_TRUE(
                waitFor([&] { return monitor.state().brokerProblem.code == MessageCode::MonitorNoBroker; }));
            since.start();
        }
        EXPECT_LT(since.elapsed(), 2000) << "the end does not wait for it";
    }
}

TEST(MonitorWithBroker, IsReachedAtItsSecondAddressWhereNobodyAnswersAtTheFirst) {
    test::MqttBroker broker;
    broker.start();
    MonitorSettings settings = settingsFor(broker);
    settings.broker.address = std::string(kTwoPlaces) + ':' + std::to_string(broker.port());
    g_firstPlace = "127.0.0.2";
    const DeadPlace dead(g_firstPlace, broker.port());
    ASSERT_TRUE(dead.exists());
    QElapsedTimer since;
    since.start();
    const auto tried = tryMonitor(settings);
    EXPECT_TRUE(tried) << describe(tried.error());
    EXPECT_GT(since.elapsed(), 3000) << "the first address was not dead";
    EXPECT_LT(since.elapsed(), 8000);
}

TEST(MonitorWithBroker, TellsWhyAPasswordIsRefused) {
    const QTemporaryDir folder;
    const std::string secret = folder.filePath("secret").toStdString();
    std::ofstream(secret) << "right\n";
    ::chmod(secret.c_str(), 0600);
    const QString users = folder.filePath("users");
    QProcess passwords;
    passwords.start("mosquitto_passwd", {"-b", "-c", users, "bask", "right"});
    ASSERT_TRUE(passwords.waitForFinished());
    test::MqttBroker broker(QStringLiteral("allow_anonymous false\npassword_file %1").arg(users));
    broker.start();
    MonitorSettings settings = settingsFor(broker);
    const auto nobody = tryMonitor(settings);
    ASSERT_FALSE(nobody);
    EXPECT_NE(describe(nobody.error()).find("not authorised"), std::string::npos) << describe(nobody.error());
    settings.broker.user = "bask";
    settings.broker.passwordFile = secret;
    EXPECT_TRUE(tryMonitor(settings));
    ::chmod(secret.c_str(), 0640);
    EXPECT_EQ(tryMonitor(settings).error().code(), MessageCode::MonitorSecretOpen);
}

namespace {

/// Certificates made by openssl, below one authority.
class Certificates {
public:
    Certificates() {
        openssl({"req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                 "-keyout", "ca.key", "-out", "ca.pem", "-days", "2", "-subj", "/CN=test authority"});
        openssl({"req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                 "-keyout", "other.key", "-out", "other.pem", "-days", "2", "-subj",
                 "/CN=another authority"});
        std::ofstream(path("names").toStdString()) << "subjectAltName=IP:127.0.0.1,DNS:two.places.example\n";
        std::ofstream(path("index").toStdString()).flush();
        std::ofstream(path("authority").toStdString())
            << "[ca]\ndefault_ca=test\n[test]\ndatabase=index\nrand_serial=yes\nnew_certs_dir=.\ndefault_md="
               "sha256\n"
               "unique_subject=no\npolicy=any\n[any]\ncommonName=supplied\n";
    }

    QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    /// Lines for a broker with a certificate that is valid for so many days; negative: it has expired.
    QString broker(int days) {
        openssl({"req", "-new", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                 "-keyout", "server.key", "-out", "server.csr", "-subj", "/CN=127.0.0.1"});
        const auto inDays = [now = QDateTime::currentDateTimeUtc()](int number) {
            return now.addDays(number).toString(QStringLiteral("yyyyMMddHHmmss'Z'"));
        };
        // Not x509, whose -days are no longer negative from OpenSSL 3.5 on.
        openssl({"ca", "-config", "authority", "-batch", "-notext", "-cert", "ca.pem", "-keyfile", "ca.key",
                 "-in", "server.csr", "-out", "server.pem", "-extfile", "names", "-startdate", inDays(-2),
                 "-enddate", inDays(days)});
        return QStringLiteral("allow_anonymous true\ncafile %1\ncertfile %2\nkeyfile %3")
            .arg(path("ca.pem"), path("server.pem"), path("server.key"));
    }

private:
    void openssl(const QStringList& arguments) {
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start("openssl", arguments);
        EXPECT_TRUE(process.waitForFinished());
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }

    QTemporaryDir m_folder;
};

} // namespace

TEST(MonitorWithBroker, SpeaksToABrokerThatHasTheRightCertificateAndNoOther) {
    Certificates certificates;
    const auto answerOf = [&](int days, const char* trusted) {
        test::MqttBroker broker(certificates.broker(days));
        broker.start();
        MonitorSettings settings = settingsFor(broker);
        settings.broker.usesTls = true;
        settings.broker.caFile =
            trusted[0] == '\0' ? std::string() : certificates.path(trusted).toStdString();
        const Result<void> tried = tryMonitor(settings);
        return tried ? std::string("it works") : describe(tried.error());
    };
    EXPECT_EQ(answerOf(2, "ca.pem"), "it works");
    EXPECT_NE(answerOf(2, "other.pem").find("certificate verify failed"), std::string::npos)
        << answerOf(2, "other.pem");
    EXPECT_NE(answerOf(2, "").find("certificate verify failed"), std::string::npos);
    EXPECT_NE(answerOf(-1, "ca.pem").find("certificate"), std::string::npos) << answerOf(-1, "ca.pem");
    EXPECT_NE(answerOf(2, "names").find("Unable to load CA certificates"), std::string::npos)
        << answerOf(2, "names");
    EXPECT_NE(answerOf(2, "nothing").find("cannot be read"), std::string::npos) << answerOf(2, "nothing");
    {
        test::MqttBroker broker(certificates.broker(2)); // not started
        MonitorSettings settings = settingsFor(broker);
        settings.broker.usesTls = true;
        EXPECT_NE(describe(tryMonitor(settings).error()).find("Connection refused"), std::string::npos);
    }
}

TEST(MonitorWithBroker, SpeaksTlsAtItsOldAddressWhereNobodyAnswersAtTheNewOne) {
    Certificates certificates;
    test::MqttBroker broker(certificates.broker(2));
    broker.start();
    MonitorSettings settings = settingsFor(broker);
    settings.broker.usesTls = true;
    settings.broker.caFile = certificates.path("ca.pem").toStdString();
    settings.broker.address = std::string(kTwoPlaces) + ':' + std::to_string(broker.port());
    g_firstPlace = "::1";
    const DeadPlace dead(g_firstPlace, broker.port());
    if (!dead.exists())
        GTEST_SKIP() << "this machine has no IPv6";
    QElapsedTimer since;
    since.start();
    const auto tried = tryMonitor(settings);
    EXPECT_TRUE(tried) << describe(tried.error());
    EXPECT_LT(since.elapsed(), 8000);
}

TEST(Monitor, WritesStatusFilesThatAreAlwaysWhole) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(kStatusFile).toStdString();
    {
        Monitor monitor;
        MonitorSettings settings;
        settings.usesFiles = true;
        settings.statusFolder = folder.path().toStdString();
        ASSERT_TRUE(tryMonitor(settings));
        monitor.use(settings);
        const Feeder feeder(monitor);
        ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(path); }));
        for (int k = 0; k < 300; ++k) {
            EXPECT_EQ(json::parse(textOf(path))["state"], "Running");
            QThread::msleep(5);
        }
        EXPECT_NE(textOf(folder.filePath(kMetricsFile).toStdString()).find("bask_up 1\n"), std::string::npos);
    }
    EXPECT_EQ(json::parse(textOf(path))["closed"], true);
    EXPECT_NE(textOf(folder.filePath(kMetricsFile).toStdString()).find("bask_up 0\n"), std::string::npos);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2); // and nothing beside them
}

TEST(Monitor, TellsThatStatusFilesCannotBeWrittenAndGoesOn) {
    const QTemporaryDir folder;
    const QString sub = folder.filePath("status");
    MonitorSettings settings;
    settings.usesFiles = true;
    settings.statusFolder = sub.toStdString();
    EXPECT_EQ(tryMonitor(settings).error().code(), MessageCode::FileUnwritable);
    Monitor monitor;
    monitor.use(settings);
    const Feeder feeder(monitor);
    ASSERT_TRUE(waitFor([&] { return monitor.state().fileProblem.code == MessageCode::MonitorNoFile; }));
    ASSERT_TRUE(QDir().mkpath(sub));
    EXPECT_TRUE(waitFor([&] { return monitor.state().fileProblem.code == MessageCode::None; }));
    EXPECT_LT(feeder.longest_s(), kMoment_s);
}

TEST(Monitor, KeepsTheOldStatusFileOnAFullDisk) {
    const QTemporaryDir folder;
    const std::string place = folder.path().toStdString();
    ASSERT_TRUE(writeStatusFiles({1.0, false, runningSnapshot()}, place));
    const std::string before = textOf(place + '/' + kStatusFile);
    rlimit old{};
    ::getrlimit(RLIMIT_FSIZE, &old);
    const auto handler = ::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100, old.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto written = writeStatusFiles({2.0, false, runningSnapshot()}, place);
    ::setrlimit(RLIMIT_FSIZE, &old);
    ::signal(SIGXFSZ, handler);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code(), MessageCode::FileUnwritable);
    EXPECT_EQ(textOf(place + '/' + kStatusFile), before);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

TEST(MonitorWithBroker, EndsWhatWasSwitchedOff) {
    test::MqttBroker broker;
    broker.start();
    Monitor monitor;
    monitor.use(settingsFor(broker));
    Feeder feeder(monitor);
    ASSERT_TRUE(waitFor([&] { return monitor.state().sent > 0; }));
    monitor.use({});
    EXPECT_FALSE(monitor.state().isOn);
    test::MqttSubscriber subscriber(broker.port());
    EXPECT_TRUE(waitFor([&] { return subscriber.last("presence") == "closed"; }));
    monitor.use(settingsFor(broker));
    EXPECT_TRUE(waitFor([&] { return subscriber.last("presence") == "here"; }));
    feeder.stop();
}

TEST(MonitorSoak, ConnectsAgainToABrokerThatWasKilledAHundredTimes) {
    killAgainAndAgain(100);
}
