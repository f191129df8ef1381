// The computer kept awake, by a logind of this test's own.

#include "engine/drivers/sleep_inhibitor.h"
#include "tests/support/wait_for.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusUnixFileDescriptor>
#include <QDBusVirtualObject>
#include <QProcess>
#include <QStandardPaths>

#include <gtest/gtest.h>

#include <array>
#include <poll.h>
#include <unistd.h>

namespace bask {
namespace {

/// Hands out the writing end of a pipe for each lock: it is given back when nobody has it any more.
class Logind final : public QDBusVirtualObject {
public:
    QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& connection) override {
        std::array<int, 2> ends{};
        if (message.member() != QLatin1String("Inhibit") || ::pipe(ends.data()) != 0)
            return false;
        what = message.arguments().value(0).toString() + ' ' + message.arguments().value(3).toString();
        m_end = ends[0];
        connection.send(message.createReply(QVariant::fromValue(QDBusUnixFileDescriptor(ends[1]))));
        ::close(ends[1]);
        return true;
    }
    bool isHeld() const {
        pollfd end{m_end, POLLIN, 0};
        return m_end >= 0 && ::poll(&end, 1, 0) == 0;
    }
    ~Logind() override {
        if (m_end >= 0)
            ::close(m_end);
    }
    QString what;

private:
    int m_end = -1;
};

} // namespace

TEST(SleepInhibitor, HoldsALockWhileItIsWanted) {
    if (QStandardPaths::findExecutable(QStringLiteral("dbus-daemon")).isEmpty())
        GTEST_SKIP() << "dbus-daemon is not there";
    QProcess daemon;
    daemon.start(QStringLiteral("dbus-daemon"), {QStringLiteral("--session"), QStringLiteral("--nofork"),
                                                 QStringLiteral("--print-address=1")});
    ASSERT_TRUE(daemon.waitForReadyRead(10000));
    const QString address = QString::fromUtf8(daemon.readLine()).trimmed();
    {
        QDBusConnection bus = QDBusConnection::connectToBus(address, QStringLiteral("logind"));
        Logind logind;
        ASSERT_TRUE(bus.registerVirtualObject(QStringLiteral("/org/freedesktop/login1"), &logind));
        ASSERT_TRUE(bus.registerService(QStringLiteral("org.freedesktop.login1")));
        SleepInhibitor sleep(address.toStdString());
        EXPECT_FALSE(sleep.isKept());
        sleep.keepAwake(true);
        ASSERT_TRUE(test::waitFor([&] { return sleep.isKept(); }, 10000)) << sleep.problem();
        EXPECT_EQ(logind.what, QStringLiteral("sleep:idle block"));
        EXPECT_TRUE(logind.isHeld());
        sleep.keepAwake(false);
        EXPECT_TRUE(test::waitFor([&] { return !logind.isHeld(); }, 10000));
        EXPECT_FALSE(sleep.isKept());
        sleep.keepAwake(true);
        ASSERT_TRUE(test::waitFor([&] { return sleep.isKept(); }, 10000));
    }
    QDBusConnection::disconnectFromBus(QStringLiteral("logind"));
    daemon.kill();
    daemon.waitForFinished();
}

// Catches an engine that waits for a system without logind, or never says that it has none.
TEST(SleepInhibitor, SaysWhyItCannot) {
    SleepInhibitor sleep("unix:path=/nowhere/bus");
    sleep.keepAwake(true);
    EXPECT_TRUE(test::waitFor([&] { return !sleep.problem().empty(); }, 10000));
    EXPECT_FALSE(sleep.isKept());
    sleep.keepAwake(false);
    EXPECT_TRUE(sleep.problem().empty());
}

} // namespace bask
