// bask-sleep.so: see sleep_inhibitor.h.

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusReply>
#include <QDBusUnixFileDescriptor>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>

namespace bask {
namespace {

constexpr int kAnswer_ms = 5000;

int stayAwake(const std::string& bus, std::string& problem) {
    static std::atomic<int> count = 0;
    const QString name = QStringLiteral("bask-sleep-%1").arg(++count);
    QDBusConnection connection = bus.empty()
                                     ? QDBusConnection::connectToBus(QDBusConnection::SystemBus, name)
                                     : QDBusConnection::connectToBus(QString::fromStdString(bus), name);
    int descriptor = -1;
    if (!connection.isConnected()) {
        problem = "no D-Bus of the system";
    } else {
        QDBusMessage call = QDBusMessage::createMethodCall(
            QStringLiteral("org.freedesktop.login1"), QStringLiteral("/org/freedesktop/login1"),
            QStringLiteral("org.freedesktop.login1.Manager"), QStringLiteral("Inhibit"));
        call.setArguments({QStringLiteral("sleep:idle"), QStringLiteral("Bask"),
                           QStringLiteral("A heat source is on"), QStringLiteral("block")});
        const QDBusReply<QDBusUnixFileDescriptor> reply = connection.call(call, QDBus::Block, kAnswer_ms);
        if (!reply.isValid())
            problem = "logind: " + reply.error().message().toStdString();
        else if (descriptor = ::fcntl(reply.value().fileDescriptor(), F_DUPFD_CLOEXEC, 3); descriptor < 0)
            problem = std::strerror(errno); // the reply's own is closed with it
    }
    connection = QDBusConnection(QString());
    QDBusConnection::disconnectFromBus(name);
    return descriptor;
}

} // namespace
} // namespace bask

extern "C" int baskStayAwake(const std::string& bus, std::string& problem) {
    return bask::stayAwake(bus, problem);
}
