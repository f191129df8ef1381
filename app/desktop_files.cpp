#include "app/desktop_files.h"

#include "widgets/common/desktop_opener.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QFileInfo>
#include <QUrl>

#include <atomic>

namespace bask {
namespace {

constexpr int kFileManager_ms = 5000; // it may have to be started first

/// What an export wrote into folders of its folder is not shown.
QString folderOf(const QStringList& files) {
    QString folder;
    for (const QString& file : files)
        if (const QString its = QFileInfo(file).absolutePath();
            folder.isEmpty() || its.size() < folder.size())
            folder = its;
    return folder;
}

QStringList addressesIn(const QString& folder, const QStringList& files) {
    QStringList addresses;
    for (const QString& file : files)
        if (QFileInfo(file).absolutePath() == folder)
            addresses << QUrl::fromLocalFile(QFileInfo(file).absoluteFilePath()).toString(QUrl::FullyEncoded);
    return addresses;
}

/// https://www.freedesktop.org/wiki/Specifications/file-manager-interface
bool isShownByFileManager(const QStringList& addresses, const QString& bus) {
    static std::atomic<int> count = 0;
    const QString name = QStringLiteral("bask-files-%1").arg(++count);
    QDBusConnection connection = bus.isEmpty()
                                     ? QDBusConnection::connectToBus(QDBusConnection::SessionBus, name)
                                     : QDBusConnection::connectToBus(bus, name);
    bool isShown = false;
    if (connection.isConnected()) {
        const QString service = QStringLiteral("org.freedesktop.FileManager1");
        QDBusMessage call = QDBusMessage::createMethodCall(
            service, QStringLiteral("/org/freedesktop/FileManager1"), service, QStringLiteral("ShowItems"));
        call.setArguments({addresses, QString()});
        isShown = connection.call(call, QDBus::Block, kFileManager_ms).type() == QDBusMessage::ReplyMessage;
    }
    connection = QDBusConnection(QString());
    QDBusConnection::disconnectFromBus(name);
    return isShown;
}

} // namespace

DesktopFiles::DesktopFiles(const QString& bus) : m_opener(&openOnDesktop), m_bus(bus) {
    m_pool.setMaxThreadCount(1);
}

void DesktopFiles::openAddress(const QUrl& address) {
    m_open.run([address, opener = m_opener] { return opener(address) ? Opening::Begun : Opening::NoProgram; },
               [this, what = address.toString()](Opening opening) { tell(opening, what); });
}

void DesktopFiles::open(const QStringList& files) {
    if (!files.isEmpty())
        openPath(files.size() == 1 ? files.front() : folderOf(files));
}

void DesktopFiles::showInFolder(const QStringList& files) {
    const QString folder = folderOf(files);
    m_ask.run([addresses = addressesIn(folder, files),
               bus = m_bus] { return isShownByFileManager(addresses, bus); },
              [this, folder](bool isShown) {
                  if (!isShown)
                      openPath(folder);
              });
}

void DesktopFiles::openPath(const QString& path) {
    m_open.run(
        [path, opener = m_opener] {
            if (!QFileInfo::exists(path))
                return Opening::NotThere;
            return opener(QUrl::fromLocalFile(path)) ? Opening::Begun : Opening::NoProgram;
        },
        [this, path](Opening opening) { tell(opening, path); });
}

void DesktopFiles::tell(Opening opening, const QString& what) {
    if (opening == Opening::NotThere)
        emit problem(tr("%1 is no longer there.").arg(what));
    else if (opening == Opening::NoProgram)
        emit problem(tr("The desktop has no program that opens %1.").arg(what));
}

} // namespace bask
