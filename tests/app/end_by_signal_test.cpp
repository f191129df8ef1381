// A signal at any moment of a command: nothing half is left, and the program ends by that signal, as a shell
// expects.

#include "engine/base/replaced_files.h"
#include "engine/base/unfinished.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace bask::test {
namespace {

/// All files and folders below.
QStringList below(const QString& folder) {
    QStringList all;
    const auto kinds = QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot;
    for (const QFileInfo& entry : QDir(folder).entryInfoList(kinds)) {
        all << entry.filePath();
        if (entry.isDir())
            all << below(entry.filePath());
    }
    return all;
}

/// Starts a command, and sends it the signal after a time. Returns false if it ended before.
bool interrupted(const QStringList& arguments, int after_ms, int signal) {
    QProcess process;
    process.start(QStringLiteral(BASK_PROGRAM), arguments);
    if (!process.waitForStarted() || process.waitForFinished(after_ms)) {
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_NE(process.exitCode(), 2) << process.readAllStandardError().toStdString();
        return false;
    }
    ::kill(static_cast<pid_t>(process.processId()), signal);
    EXPECT_TRUE(process.waitForFinished(20000)) << "does not end";
    return process.exitStatus() == QProcess::CrashExit; // else it had just ended by itself
}

class EndBySignal : public testing::Test {
protected:
    QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    /// So many cases of view factors, in a file beside the outputs' folder.
    QString manyCases(int count) const {
        const QString path = m_inputs.filePath(QStringLiteral("cases.json"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write("{\"cases\": [");
        for (int k = 0; k < count; ++k)
            file.write(QStringLiteral(R"(%1{"id":"%2","source":{"type":"disk","radius_m":0.15},)"
                                      R"("object":{"type":"disk","radius_m":0.015},"pose":)"
                                      R"({"translation_m":[0,0,0.05],"rotation_vector_rad":[0.%3,0,0]}})")
                           .arg(QLatin1String(k > 0 ? "," : ""))
                           .arg(k)
                           .arg(k)
                           .toUtf8());
        file.write("]}");
        return path;
    }
    QTemporaryDir m_folder, m_inputs;
};

// Catches: an empty folder of a study, a temporary file of a field, a stage of an export.
TEST_F(EndBySignal, leavesNothingHalf) {
    const QString examples = QStringLiteral(BASK_EXAMPLES);
    const QString session = at("run.bask");
    QProcess record;
    record.start(QStringLiteral(BASK_PROGRAM), {"run", examples + "/two-circles.json", "-o", session});
    ASSERT_TRUE(record.waitForFinished(120000));
    ASSERT_TRUE(QFile::exists(session));
    const QStringList field{"field",    examples + "/two-circles.json",
                            "--object", "left",
                            "--shade",  "none",
                            "--axes",   "x=-0.2:0.2:0.001,y=-0.2:0.2:0.001,z=0.01:0.3:0.0005",
                            "-o"};
    const QList<QStringList> commands{
        {"study", "closed-loop", "--count", "40", "-o", at("out")},
        {"study", "view-factor", "-o", at("out")},
        {"reproduce", "-o", at("out")},
        field + QStringList{at("out.vti")},
        field + QStringList{at("out.h5")},
        {"export", session, "--csv", at("out"), "--vtk", at("out"), "--nexus", at("out")},
        {"export", session, "--figures", at("out")},
        {"report", session, "-o", at("out.pdf")},
        {"isosurface", examples + "/two-circles.json", "--object", "left", "--step", "0.2", "-o",
         at("out.vtp")},
        {"view-factor", manyCases(30000), "-o", at("out.json")}};
    for (const QStringList& command : commands)
        for (const int after_ms : {150, 700, 1500})
            for (const int signal : {SIGINT, SIGTERM}) {
                if (!interrupted(command, after_ms, signal)) {
                    QDir(at("out")).removeRecursively();
                    for (const char* name : {"out.vti", "out.h5", "out.pdf", "out.vtp", "out.json"})
                        QFile::remove(at(name));
                    break;
                }
                QStringList left = below(m_folder.path());
                left.removeAll(session);
                // One of several exports may be done.
                for (const QString& file : QStringList(left))
                    if (command.front() == "export" && !file.contains(QStringLiteral("/.")))
                        left.removeAll(file);
                EXPECT_TRUE(left.isEmpty()) << command.join(u' ').toStdString() << " after " << after_ms
                                            << " ms left " << left.join(u' ').toStdString();
                QDir(at("out")).removeRecursively();
            }
}

// Catches: a stage of a killed process that lies there for ever, or one in use that is deleted.
TEST_F(EndBySignal, whatAKillLeavesIsDeletedByTheNextExport) {
    const QString session = at("run.bask");
    QProcess record;
    record.start(QStringLiteral(BASK_PROGRAM),
                 {"run", QStringLiteral(BASK_EXAMPLES) + "/two-circles.json", "-o", session});
    ASSERT_TRUE(record.waitForFinished(120000));
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    QString name = QString::fromLatin1(host.data());
    name.replace(QRegularExpression(QStringLiteral("[^0-9A-Za-z-]")), QStringLiteral("_"));
    QDir().mkpath(at("out") + QStringLiteral("/.bask-export-%1-1-1/inner").arg(name));
    QProcess next;
    next.start(QStringLiteral(BASK_PROGRAM), {"export", session, "--csv", at("out")});
    ASSERT_TRUE(next.waitForFinished(120000));
    EXPECT_EQ(next.exitCode(), 0);
    EXPECT_GT(below(at("out")).size(), 5);
    for (const QString& file : below(at("out")))
        EXPECT_FALSE(file.contains(QStringLiteral("/.bask"))) << file.toStdString();
}

// Catches: a part of a field as large as the whole that a kill leaves for ever.
TEST_F(EndBySignal, whatAKillLeavesIsDeletedByTheNextField) {
    for (const char* name : {"out.vti", "out.h5"}) {
        const QStringList command{"field",    QStringLiteral(BASK_EXAMPLES "/two-circles.json"),
                                  "--object", "left",
                                  "--shade",  "none",
                                  "--axes",   "x=-0.2:0.2:0.001,y=-0.2:0.2:0.001,z=0.01:0.3:0.0005",
                                  "-o",       at(name)};
        ASSERT_TRUE(interrupted(command, 1500, SIGKILL)) << name;
        QProcess next;
        next.start(QStringLiteral(BASK_PROGRAM),
                   {"field", "--preset", "paper-translation", "-o", at("next.vti")});
        ASSERT_TRUE(next.waitForFinished(120000));
        EXPECT_EQ(next.exitCode(), 0) << next.readAllStandardError().toStdString();
        EXPECT_EQ(below(m_folder.path()), QStringList{at("next.vti")}) << name;
    }
}

// Catches: a check that a signal has cut short, told as one that has passed.
TEST_F(EndBySignal, endsACheckOfADeviceWithItsProgram) {
    EXPECT_TRUE(interrupted({"check-device", "--role", "thermometer", "--", "sleep", "1000"}, 500, SIGINT));
}

/// In a process of its own: runs `body`, which waits for the signal.
template <class Body> int signalled(int signal, const Body& body) {
    std::array<int, 2> ready{};
    EXPECT_EQ(::pipe(ready.data()), 0);
    const pid_t child = ::fork();
    if (child == 0) {
        deleteUnfinishedOnSignals();
        body(ready[1]);
        ::_exit(0);
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    ::close(ready[0]);
    ::close(ready[1]);
    return status;
}

TEST_F(EndBySignal, deletesWhatIsUnfinishedAndKeepsTheRest) {
    const std::string half = at("half").toStdString(), done = at("done").toStdString(),
                      folder = at("folder").toStdString();
    const int status = signalled(SIGTERM, [&](int ready) {
        QDir().mkpath(at("folder"));
        const Unfinished empty(folder, Unfinished::What::EmptyFolder);
        const Unfinished first(half);
        Unfinished second(done);
        for (const std::string& path : {half, done})
            QFile(QString::fromStdString(path)).open(QIODevice::WriteOnly);
        second.keep();
        (void)::write(ready, "x", 1);
        for (;;)
            ::pause();
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
    EXPECT_FALSE(QFile::exists(at("half")));
    EXPECT_FALSE(QFile::exists(at("folder")));
    EXPECT_TRUE(QFile::exists(at("done")));
}

TEST_F(EndBySignal, waitsForAStepThatIsNotInterrupted) {
    const int status = signalled(SIGINT, [&](int ready) {
        {
            const Uninterrupted step;
            (void)::write(ready, "x", 1);
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            QFile(at("whole")).open(QIODevice::WriteOnly);
        }
        for (;;)
            ::pause();
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
    EXPECT_TRUE(QFile::exists(at("whole")));
}

// Catches: old files under hidden names, and new ones beside them, of a program that a signal ends.
TEST_F(EndBySignal, waitsForFilesThatAreReplacedTogether) {
    const auto write = [this](const char* name, const char* text) {
        QFile file(at(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) > 0);
    };
    write("old", "old");
    const int status = signalled(SIGTERM, [&](int ready) {
        {
            ReplacedFiles replaced;
            (void)replaced.setAside(at("old").toStdString());
            write("old", "new");
            (void)replaced.setAside(at("other").toStdString());
            (void)::write(ready, "x", 1);
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            write("other", "new");
            replaced.keepNew();
        }
        for (;;)
            ::pause();
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGTERM);
    EXPECT_EQ(below(m_folder.path()), (QStringList{at("old"), at("other")}));
}

} // namespace
} // namespace bask::test
