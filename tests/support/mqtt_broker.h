#pragma once
// A real broker and a subscriber as processes, for tests of what is published.

#include "tests/support/wait_for.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <map>
#include <string>

#include <signal.h>

namespace bask::test {

class MqttBroker {
public:
    /// `more` are lines of its configuration.
    explicit MqttBroker(const QString& more = {}) : m_port(freePort()) {
        QFile file(m_folder.filePath("broker.conf"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QStringLiteral("listener %1 127.0.0.1\nuser root\npersistence false\n%2\n")
                       .arg(m_port)
                       .arg(more.isEmpty() ? QStringLiteral("allow_anonymous true") : more)
                       .toUtf8());
    }
    ~MqttBroker() { kill(); }
    MqttBroker(const MqttBroker&) = delete;
    MqttBroker& operator=(const MqttBroker&) = delete;

    void start() {
        m_process.start("/usr/sbin/mosquitto", {"-c", m_folder.filePath("broker.conf")});
        ASSERT_TRUE(m_process.waitForStarted()) << "mosquitto is not installed";
        ASSERT_TRUE(waitFor([this] {
            QTcpSocket socket;
            socket.connectToHost(QHostAddress::LocalHost, static_cast<quint16>(m_port));
            return socket.waitForConnected(100);
        }));
    }
    void kill() {
        if (m_process.state() == QProcess::NotRunning)
            return;
        m_process.kill();
        m_process.waitForFinished();
    }
    void freeze() { ::kill(static_cast<pid_t>(m_process.processId()), SIGSTOP); }
    /// Goes on from freeze(); kill() needs no thaw.
    void thaw() { ::kill(static_cast<pid_t>(m_process.processId()), SIGCONT); }

    int port() const { return m_port; }
    std::string address() const { return "127.0.0.1:" + std::to_string(m_port); }
    QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

private:
    static int freePort() {
        QTcpServer server;
        EXPECT_TRUE(server.listen(QHostAddress::LocalHost));
        return server.serverPort();
    }

    QTemporaryDir m_folder;
    int m_port;
    QProcess m_process;
};

/// Hears all below bask/, from its construction on: the broker tells its version once it has subscribed.
class MqttSubscriber {
public:
    explicit MqttSubscriber(int port) {
        m_process.start("mosquitto_sub", {"-h", "127.0.0.1", "-p", QString::number(port), "-q", "1", "-t",
                                          "bask/#", "-t", "$SYS/broker/version", "-F", "%r %t %p"});
        EXPECT_TRUE(m_process.waitForStarted()) << "mosquitto-clients is not installed";
        EXPECT_TRUE(waitFor([this] { return heard().contains("$SYS"); }));
    }
    ~MqttSubscriber() {
        m_process.kill();
        m_process.waitForFinished();
    }
    MqttSubscriber(const MqttSubscriber&) = delete;
    MqttSubscriber& operator=(const MqttSubscriber&) = delete;

    /// Returns the payloads that have come, by topic without "bask/", in their order.
    std::multimap<std::string, std::string> heard() {
        m_process.waitForReadyRead(20);
        while (m_process.canReadLine()) {
            const QByteArray line = m_process.readLine().trimmed();
            const qsizetype topic = line.indexOf(' ') + 1, payload = line.indexOf(' ', topic) + 1;
            const bool isOurs = line.mid(topic).startsWith("bask/");
            m_heard.emplace(isOurs ? line.mid(topic + 5, payload - topic - 6).toStdString() : "$SYS",
                            line.mid(payload).toStdString());
        }
        return m_heard;
    }
    /// The newest of a topic; empty if there is none.
    std::string last(const std::string& topic) {
        const auto all = heard();
        const auto [from, to] = all.equal_range(topic);
        return from == to ? std::string() : std::prev(to)->second;
    }

private:
    QProcess m_process;
    std::multimap<std::string, std::string> m_heard;
};

} // namespace bask::test
