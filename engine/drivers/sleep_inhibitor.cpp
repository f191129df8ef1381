#include "engine/drivers/sleep_inhibitor.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusReply>
#include <QDBusUnixFileDescriptor>
#include <QThreadPool>

#include <atomic>
#include <mutex>

namespace bask {
namespace {

constexpr int kAnswer_ms = 5000;

struct Answer {
    QDBusUnixFileDescriptor descriptor; ///< as long as it is open, the computer stays awake
    std::string problem;
};

Answer ask(const std::string& bus) {
    static std::atomic<int> count = 0;
    const QString name = QStringLiteral("bask-sleep-%1").arg(++count);
    QDBusConnection connection = bus.empty()
                                     ? QDBusConnection::connectToBus(QDBusConnection::SystemBus, name)
                                     : QDBusConnection::connectToBus(QString::fromStdString(bus), name);
    Answer out;
    if (!connection.isConnected()) {
        out.problem = "no D-Bus of the system";
    } else {
        QDBusMessage call = QDBusMessage::createMethodCall(
            QStringLiteral("org.freedesktop.login1"), QStringLiteral("/org/freedesktop/login1"),
            QStringLiteral("org.freedesktop.login1.Manager"), QStringLiteral("Inhibit"));
        call.setArguments({QStringLiteral("sleep:idle"), QStringLiteral("Bask"),
                           QStringLiteral("A heat source is on"), QStringLiteral("block")});
        const QDBusReply<QDBusUnixFileDescriptor> reply = connection.call(call, QDBus::Block, kAnswer_ms);
        if (reply.isValid())
            out.descriptor = reply.value();
        else
            out.problem = "logind: " + reply.error().message().toStdString();
    }
    connection = QDBusConnection(QString());
    QDBusConnection::disconnectFromBus(name);
    return out;
}

} // namespace

struct SleepInhibitor::Lock {
    mutable std::mutex mutex;
    bool isAsking = false, isWanted = false;
    Answer answer;

    /// On another thread, once at a time.
    static void work(const std::shared_ptr<Lock>& lock, const std::string& bus) {
        Answer answer = ask(bus);
        const std::lock_guard guard(lock->mutex);
        lock->isAsking = false;
        lock->answer = lock->isWanted ? std::move(answer) : Answer();
    }
};

SleepInhibitor::SleepInhibitor(std::string bus) : m_lock(std::make_shared<Lock>()), m_bus(std::move(bus)) {}

SleepInhibitor::~SleepInhibitor() {
    keepAwake(false);
}

void SleepInhibitor::keepAwake(bool isWanted) {
    if (isWanted == m_isWanted)
        return;
    m_isWanted = isWanted;
    const std::lock_guard guard(m_lock->mutex);
    m_lock->isWanted = isWanted;
    m_lock->answer = {};
    if (!isWanted || m_lock->isAsking)
        return;
    m_lock->isAsking = true;
    QThreadPool::globalInstance()->start([lock = m_lock, bus = m_bus] { Lock::work(lock, bus); });
}

bool SleepInhibitor::isKept() const {
    const std::lock_guard guard(m_lock->mutex);
    return m_lock->answer.descriptor.isValid();
}

std::string SleepInhibitor::problem() const {
    const std::lock_guard guard(m_lock->mutex);
    return m_lock->answer.problem;
}

} // namespace bask
