// Exported files that are opened and shown, by a file manager of this test's own.

#include "app/desktop_files.h"
#include "tests/support/wait_for.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVirtualObject>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QThread>
#include <QUrl>

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

namespace bask::test {
namespace {

const QString kNoBus = QStringLiteral("unix:path=/nowhere/bus");

/// Takes what it is asked to show, and refuses it if it is told to.
class FileManager final : public QDBusVirtualObject {
public:
    QString introspect(const QString&) const override { return {}; }
    bool handleMessage(const QDBusMessage& message, const QDBusConnection& connection) override {
        if (message.interface() != QLatin1String("org.freedesktop.FileManager1") ||
            message.member() != QLatin1String("ShowItems"))
            return false;
        signature = message.signature();
        shown = message.arguments().value(0).toStringList();
        connection.send(isRefusing ? message.createErrorReply(QDBusError::Failed, QStringLiteral("no"))
                                   : message.createReply());
        return true;
    }
    QString signature;
    QStringList shown;
    bool isRefusing = false;
};

class DesktopFilesTest : public testing::Test {
protected:
    QString file(const QString& name) const {
        QFile made(folder.filePath(name));
        EXPECT_TRUE(made.open(QIODevice::WriteOnly)) << name.toStdString();
        return made.fileName();
    }
    /// Called on the thread of the files.
    DesktopFiles::Opener opener() {
        return [this](const QUrl& address) {
            const std::scoped_lock lock(m_mutex);
            m_opened << (address.isLocalFile() ? address.toLocalFile() : address.toString());
            m_thread = QThread::currentThread();
            return isOpened.load();
        };
    }
    QStringList opened() {
        const std::scoped_lock lock(m_mutex);
        return m_opened;
    }
    const QThread* openedBy() {
        const std::scoped_lock lock(m_mutex);
        return m_thread;
    }
    const QTemporaryDir folder;
    std::atomic<bool> isOpened = true;

private:
    std::mutex m_mutex;
    QStringList m_opened;
    const QThread* m_thread = nullptr;
};

} // namespace

// Catches: another file than the one that was written, and a failure without a word.
TEST_F(DesktopFilesTest, AFileIsOpenedAndOfSeveralTheirFolder) {
    DesktopFiles desktop(kNoBus);
    desktop.setOpener(opener());
    QSignalSpy problem(&desktop, &DesktopFiles::problem);
    const QString one = file(QStringLiteral("a report \u00e9.pdf")), two = file(QStringLiteral("b.csv"));
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("outlines")));
    const QString below = file(QStringLiteral("outlines/c.vtp"));
    desktop.open({one});
    ASSERT_TRUE(waitFor([&] { return opened().size() == 1; }));
    EXPECT_EQ(opened()[0], one);
    desktop.open({below, one, two});
    ASSERT_TRUE(waitFor([&] { return opened().size() == 2; }));
    EXPECT_EQ(opened()[1], folder.path());
    EXPECT_EQ(problem.count(), 0);
    isOpened = false;
    desktop.open({one});
    ASSERT_TRUE(waitFor([&] { return problem.count() == 1; }));
    EXPECT_TRUE(problem[0][0].toString().contains(one));
    desktop.open({folder.filePath(QStringLiteral("gone.pdf"))});
    ASSERT_TRUE(waitFor([&] { return problem.count() == 2; }));
    EXPECT_EQ(opened().size(), 3) << "what is not there is not opened";
}

// Catches: a window that looks for the desktop's program on disks which hang, with its STOP dead.
TEST_F(DesktopFilesTest, TheWindowsThreadOpensNothing) {
    DesktopFiles desktop(kNoBus);
    desktop.setOpener(opener());
    QSignalSpy problem(&desktop, &DesktopFiles::problem);
    desktop.open({file(QStringLiteral("a.csv"))});
    ASSERT_TRUE(waitFor([&] { return opened().size() == 1; }));
    EXPECT_NE(openedBy(), QThread::currentThread());
    desktop.openAddress(QUrl(QStringLiteral("https://example.org/a")));
    ASSERT_TRUE(waitFor([&] { return opened().size() == 2; }));
    EXPECT_NE(openedBy(), QThread::currentThread());
    EXPECT_EQ(opened()[1], QStringLiteral("https://example.org/a"));
    EXPECT_EQ(problem.count(), 0);
    isOpened = false;
    desktop.openAddress(QUrl(QStringLiteral("https://example.org/b")));
    ASSERT_TRUE(waitFor([&] { return problem.count() == 1; }));
    EXPECT_TRUE(problem[0][0].toString().contains(QStringLiteral("https://example.org/b")));
}

// Catches: a file manager that is asked for nothing, and files that nobody shows where there is none.
TEST_F(DesktopFilesTest, FilesAreShownInTheFileManagerOrTheirFolderIsOpened) {
    const QString one = file(QStringLiteral("a report.pdf")), two = file(QStringLiteral("b.csv"));
    DesktopFiles without(kNoBus);
    without.setOpener(opener());
    without.showInFolder({one});
    ASSERT_TRUE(waitFor([&] { return opened().size() == 1; }));
    EXPECT_EQ(opened()[0], folder.path());

    if (QStandardPaths::findExecutable(QStringLiteral("dbus-daemon")).isEmpty())
        GTEST_SKIP() << "dbus-daemon is not there";
    QProcess daemon;
    daemon.start(QStringLiteral("dbus-daemon"), {QStringLiteral("--session"), QStringLiteral("--nofork"),
                                                 QStringLiteral("--print-address=1")});
    ASSERT_TRUE(daemon.waitForReadyRead(10000));
    const QString address = QString::fromUtf8(daemon.readLine()).trimmed();
    {
        QDBusConnection bus = QDBusConnection::connectToBus(address, QStringLiteral("fileManager"));
        FileManager manager;
        ASSERT_TRUE(bus.registerVirtualObject(QStringLiteral("/org/freedesktop/FileManager1"), &manager));
        ASSERT_TRUE(bus.registerService(QStringLiteral("org.freedesktop.FileManager1")));
        DesktopFiles desktop(address);
        desktop.setOpener(opener());
        desktop.showInFolder({one, two});
        ASSERT_TRUE(waitFor([&] { return !manager.shown.isEmpty(); }, 10000));
        EXPECT_EQ(manager.signature, QStringLiteral("ass"));
        EXPECT_EQ(manager.shown, (QStringList{QUrl::fromLocalFile(one).toString(QUrl::FullyEncoded),
                                              QUrl::fromLocalFile(two).toString(QUrl::FullyEncoded)}));
        EXPECT_TRUE(manager.shown[0].endsWith(QLatin1String("/a%20report.pdf")));
        manager.isRefusing = true;
        desktop.showInFolder({two});
        ASSERT_TRUE(waitFor([&] { return opened().size() == 2; }, 20000))
            << "it refuses: the folder is opened";
        EXPECT_EQ(opened()[1], folder.path());
    }
    QDBusConnection::disconnectFromBus(QStringLiteral("fileManager"));
    daemon.kill();
    daemon.waitForFinished();
}

} // namespace bask::test
