// Unsaved edits over a crash: written soon, found by the next process only, gone once they are saved. This
// program also is the one that is killed: with BASK_RECOVERY_CHILD it edits and says so until it ends.

#include "app/autosave.h"
#include "tests/support/wait_for.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstdio>

namespace bask::test {
namespace {

const QString kPath = QStringLiteral("/somewhere/mine.json");

void setTarget(Document& document, double target_K) {
    ASSERT_TRUE(document.setTargets({target_K}).ok());
}

QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList(QDir::Files | QDir::Hidden);
}

/// Edits every 50 ms: targets 300 K, 300.01 K and so on, each printed with its time (ms).
int editUntilKilled(const QString& folder) {
    Document document;
    document.open(Document::blank(), kPath);
    Autosave autosave(document, folder);
    QTimer timer;
    QElapsedTimer clock;
    clock.start();
    int edits = 0;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        setTarget(document, 300.0 + 0.01 * ++edits);
        std::printf("%d %lld\n", edits, static_cast<long long>(clock.elapsed()));
        std::fflush(stdout);
    });
    timer.start(50);
    return QCoreApplication::exec();
}

struct RecoveryTest : testing::Test {
    QTemporaryDir folder;
    Document document;
    RecoveryTest() { document.open(Document::blank(), kPath); }
    bool isKept() { return filesIn(folder.path()).size() == 2; } // with its lock
    std::size_t left() { return UnsavedFile::left(folder.path()).size(); }
};

// Catches an autosave that never comes, that another running Bask takes for its own, or that stays after all
// was saved or undone.
TEST_F(RecoveryTest, WhatIsUnsavedIsKeptUntilItIsSaved) {
    Autosave autosave(document, folder.path());
    QElapsedTimer sinceEdit;
    sinceEdit.start();
    setTarget(document, 320.0);
    ASSERT_TRUE(waitFor([&] { return isKept(); }));
    EXPECT_GE(sinceEdit.elapsed(), Autosave::kDelay.count() - 100);
    EXPECT_EQ(left(), 0U) << "its process lives";
    document.markSaved(kPath);
    ASSERT_TRUE(waitFor([&] { return filesIn(folder.path()).isEmpty(); }));
    setTarget(document, 330.0);
    ASSERT_TRUE(waitFor([&] { return isKept(); }));
    document.undo();
    EXPECT_TRUE(waitFor([&] { return filesIn(folder.path()).isEmpty(); }));
}

// Catches a file written for edits that were saved at once, and one that a person gave up and that comes
// back.
TEST_F(RecoveryTest, NothingIsLeftBehind) {
    {
        Autosave autosave(document, folder.path());
        setTarget(document, 320.0);
        document.markSaved(kPath);
        EXPECT_FALSE(waitFor([&] { return isKept(); }, 2 * static_cast<int>(Autosave::kDelay.count())));
        setTarget(document, 330.0);
        ASSERT_TRUE(waitFor([&] { return isKept(); }));
        setTarget(document, 340.0);
        autosave.end();
        EXPECT_TRUE(filesIn(folder.path()).isEmpty());
    }
    EXPECT_TRUE(filesIn(folder.path()).isEmpty());
}

// Catches edits that are lost when the program is ended by a signal, where nobody is asked.
TEST_F(RecoveryTest, AnEndWithoutAQuestionKeepsThem) {
    {
        const Autosave autosave(document, folder.path());
        setTarget(document, 320.0);
    }
    const auto files = UnsavedFile::left(folder.path());
    ASSERT_EQ(files.size(), 1U);
    const auto read = files[0]->read();
    ASSERT_TRUE(read.ok()) << describe(read.error());
    EXPECT_EQ(read->experiment, document.experiment());
    EXPECT_EQ(read->path, kPath);
    EXPECT_EQ(files[0]->name(), QStringLiteral("mine.json"));
    EXPECT_EQ(left(), 0U) << "offered twice";
}

// Catches what was recovered lost when the program ends again before it is saved, and a file that is left
// over when it was saved.
TEST_F(RecoveryTest, WhatIsRecoveredStaysKept) {
    setTarget(document, 320.0);
    const UnsavedEdits edits{document.experiment(), kPath, QStringLiteral("mine.json")};
    ASSERT_TRUE(UnsavedFile(folder.path()).write(edits).ok());
    const Experiment unsaved = document.experiment();
    {
        Document next;
        Autosave autosave(next, folder.path());
        auto files = UnsavedFile::left(folder.path());
        ASSERT_EQ(files.size(), 1U);
        autosave.adopt(files[0]);
        next.openUnsaved(unsaved, kPath);
        EXPECT_TRUE(isKept());
    }
    auto files = UnsavedFile::left(folder.path());
    ASSERT_EQ(files.size(), 1U);
    Document next;
    Autosave autosave(next, folder.path());
    autosave.adopt(files[0]);
    next.openUnsaved(unsaved, kPath);
    next.markSaved(kPath);
    EXPECT_TRUE(waitFor([&] { return filesIn(folder.path()).isEmpty(); }));
}

// Catches a damaged file that ends the program or passes for an experiment.
TEST_F(RecoveryTest, ADamagedFileIsRefusedInWords) {
    setTarget(document, 320.0);
    const UnsavedEdits edits{document.experiment(), kPath, QStringLiteral("mine.json")};
    ASSERT_TRUE(UnsavedFile(folder.path()).write(edits).ok());
    const QString path = folder.filePath(QDir(folder.path()).entryList({QStringLiteral("*.json")}).value(0));
    for (const QByteArray& text : {QByteArray(), QByteArray("{}\n{}"), QByteArray("\xff\xfe")}) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text);
        file.close();
        const auto files = UnsavedFile::left(folder.path());
        ASSERT_EQ(files.size(), 1U);
        EXPECT_FALSE(files[0]->read().ok());
        EXPECT_FALSE(files[0]->name().isEmpty());
    }
}

// Catches a full or forbidden disk that nobody hears of, or hears of every two seconds.
TEST_F(RecoveryTest, WhatCannotBeKeptIsToldOnce) {
    QFile file(folder.filePath(QStringLiteral("file")));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    Autosave autosave(document, folder.filePath(QStringLiteral("file/unsaved"))); // no folder can be there
    int failures = 0;
    QObject::connect(&autosave, &Autosave::failed, &autosave, [&](const Error& error) {
        ++failures;
        EXPECT_FALSE(error.message.args.empty());
    });
    setTarget(document, 320.0);
    ASSERT_TRUE(waitFor([&] { return failures > 0; }));
    setTarget(document, 330.0);
    EXPECT_FALSE(waitFor([&] { return failures > 1; }, 2 * static_cast<int>(Autosave::kDelay.count())));
}

// The promise: kill -9 at any moment loses the last few seconds at most, and never the file before.
TEST_F(RecoveryTest, AKilledProcessLosesTheLastSecondsAtMost) {
    for (const int life_ms : {2300, 3100, 4700}) {
        QProcess child;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("BASK_RECOVERY_CHILD"), folder.path());
        child.setProcessEnvironment(environment);
        child.start(QCoreApplication::applicationFilePath(), {});
        ASSERT_TRUE(child.waitForStarted());
        std::vector<std::pair<int, int>> seen; // which edit, and when in the child's time
        ASSERT_TRUE(waitFor([&] {
            while (child.canReadLine()) {
                const QList<QByteArray> words = child.readLine().trimmed().split(' ');
                seen.emplace_back(words.value(0).toInt(), words.value(1).toInt());
            }
            return !seen.empty() && seen.back().second >= life_ms;
        }));
        EXPECT_EQ(left(), 0U) << "it lives";
        child.kill();
        ASSERT_TRUE(child.waitForFinished());
        EXPECT_EQ(child.exitStatus(), QProcess::CrashExit);
        // Edits of before the delay and a write, and of a few others, where it was held up for as long.
        const auto [last, killed_ms] = seen.back();
        int wasOldEnough = 0;
        for (const auto& [edit, when_ms] : seen)
            if (when_ms < killed_ms - Autosave::kDelay.count() - 1500 && edit < last - 5)
                wasOldEnough = edit;
        const auto files = UnsavedFile::left(folder.path());
        ASSERT_LE(files.size(), 1U);
        if (wasOldEnough == 0 && files.empty())
            continue;
        ASSERT_EQ(files.size(), 1U);
        const auto read = files[0]->read();
        ASSERT_TRUE(read.ok()) << describe(read.error());
        const int kept = static_cast<int>(std::lround((read->experiment.objects[0].target_K - 300.0) / 0.01));
        EXPECT_GE(kept, wasOldEnough) << "of " << last << " edits";
        std::printf("killed after %d ms and %d edits: %d were kept\n", life_ms, last, kept);
        files[0]->remove();
    }
}

} // namespace
} // namespace bask::test

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    QCoreApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    const QString folder = qEnvironmentVariable("BASK_RECOVERY_CHILD");
    return folder.isEmpty() ? RUN_ALL_TESTS() : bask::test::editUntilKilled(folder);
}
