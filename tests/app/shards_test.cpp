// Studies and fields in shards, as a script sees them: killed, resumed and merged they give the bytes of one
// process.

#include "engine/studies/part_file.h"
#include "tests/support/program_answer.h"

#include <QDateTime>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class Shards : public testing::Test {
protected:
    QString at(const QString& name) const { return m_folder.filePath(name); }

    /// Computes all shards, and merges them.
    Answer divided(const QStringList& what, int of, const QString& parts, const QString& output,
                   const QString& merged) {
        for (int number = 1; number <= of; ++number) {
            const Answer answer = answerOf(what + QStringList{"-o", output, "--resume", "--shard",
                                                              QStringLiteral("%1/%2").arg(number).arg(of)});
            EXPECT_EQ(answer.exitCode, 0) << answer.err.toStdString();
        }
        return answerOf({"merge", parts, "-o", merged});
    }

    QTemporaryDir m_folder;
};

const QStringList kStudy{"study", "closed-loop", "--count", "6", "--seed", "7"};

// Catches: a study whose table, figures or summary depend on how it was divided.
TEST_F(Shards, ofAStudyGiveTheBytesOfOneProcess) {
    const Answer whole = answerOf(kStudy + QStringList{"-o", at("whole")});
    ASSERT_EQ(whole.exitCode, 0) << whole.err.toStdString();
    for (const int of : {1, 4, 7}) {
        const QString parts = at(QStringLiteral("parts%1").arg(of)),
                      merged = at(QStringLiteral("merged%1").arg(of));
        const Answer answer = divided(kStudy, of, parts, parts, merged);
        ASSERT_EQ(answer.exitCode, 0) << answer.err.toStdString();
        EXPECT_EQ(answer.out, whole.out);
        const QStringList names = QDir(at("whole")).entryList(QDir::Files);
        EXPECT_EQ(names.size(), 4);
        EXPECT_EQ(QDir(merged).entryList(QDir::Files), names);
        for (const QString& name : names)
            EXPECT_EQ(contents(merged + u'/' + name), contents(at("whole/") + name))
                << of << ' ' << name.toStdString();
    }
}

TEST_F(Shards, ofTheAlarmsGiveTheBytesOfOneProcess) {
    const QStringList study{"study", "alarms", "--kind", "faulty", "--count", "4", "--first", "3"};
    const Answer whole = answerOf(study + QStringList{"-o", at("whole")});
    const Answer answer = divided(study, 3, at("parts"), at("parts"), at("merged"));
    EXPECT_EQ(answer.exitCode, whole.exitCode) << answer.err.toStdString();
    EXPECT_EQ(answer.out, whole.out);
    const QByteArray table = contents(at("whole/alarm_study_faulty.csv"));
    EXPECT_FALSE(table.isEmpty());
    EXPECT_EQ(contents(at("merged/alarm_study_faulty.csv")), table);
}

TEST_F(Shards, ofTheAlarmsKnowWhatReadsTheObjects) {
    const QStringList study{"study", "alarms", "--count",   "1",       "--first",
                            "6",     "-o",     at("parts"), "--shard", "1/1"};
    ASSERT_EQ(answerOf(study + QStringList{"--read-by", "both"}).exitCode, 0);
    const Answer other = answerOf(study + QStringList{"--resume"});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_TRUE(other.err.contains("read-by is contact here and both there")) << other.err.toStdString();
    ASSERT_EQ(answerOf({"merge", at("parts"), "-o", at("merged")}).exitCode, 0);
    EXPECT_TRUE(contents(at("merged/alarm_study_healthy.csv")).contains(",both,"));
}

// Catches: a case that is lost or counted twice when its process is killed, and a status that says more than
// is there.
TEST_F(Shards, areKilledAtAnyMomentAndGoOn) {
    const Answer whole = answerOf(kStudy + QStringList{"-o", at("whole")});
    ASSERT_EQ(whole.exitCode, 0);
    const QStringList shard =
        kStudy + QStringList{"-o", at("parts"), "--shard", "1/1", "--resume", "--threads", "1"};
    int kills = 0;
    for (int wait_ms = 100;; wait_ms += 400) {
        QProcess process;
        process.start(QStringLiteral(BASK_PROGRAM), shard);
        if (process.waitForFinished(wait_ms)) {
            EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
            break;
        }
        if (kills == 2) { // while it is alive nobody else may write
            const Answer second = answerOf(shard);
            const bool isRefused = second.exitCode == 2 && second.err.contains("another process");
            EXPECT_TRUE(isRefused || process.waitForFinished(0)) << second.err.toStdString();
        }
        process.kill();
        process.waitForFinished();
        ++kills;
    }
    EXPECT_GE(kills, 1);
    const Answer status = answerOf({"merge", "--status", at("parts")});
    EXPECT_EQ(status.exitCode, 0);
    EXPECT_TRUE(status.out.contains("6 of 6 cases (100.0 %)")) << status.out.toStdString();
    ASSERT_EQ(answerOf({"merge", at("parts"), "-o", at("merged")}).exitCode, 0);
    EXPECT_EQ(contents(at("merged/closed_loop_study.csv")), contents(at("whole/closed_loop_study.csv")));
}

/// A part of a hundred cases, four seconds of one thread each.
std::unique_ptr<PartWriter> part(const QString& folder, int number, int records) {
    const QString path = folder + QStringLiteral("/study.%1-of-4.part").arg(number);
    const Shard shard{number, 4};
    auto writer = PartWriter::open(path.toStdString(), {R"({"study": "a test"})", 100, shard, 2}, false);
    EXPECT_TRUE(writer);
    for (int k = 0; k < records; ++k)
        EXPECT_TRUE((*writer)->add(4 * k + number - 1, "a record", 4.0));
    return std::move(*writer);
}

void makeOlder(const QString& path, int by_s) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    const QDateTime then = QDateTime::currentDateTimeUtc().addSecs(-by_s);
    ASSERT_TRUE(file.setFileTime(then, QFileDevice::FileModificationTime));
}

// Catches: a remaining time that counts shards which nobody computes, or not all cases that are missing.
TEST_F(Shards, tellHowFarTheyAreAndHowLongTheRestTakes) {
    ASSERT_TRUE(QDir().mkdir(at("parts")));
    const QString first = at("parts/study.1-of-4.part"), second = at("parts/study.2-of-4.part");
    part(at("parts"), 2, 25).reset();
    auto first4 = part(at("parts"), 1, 5);
    auto third4 = part(at("parts"), 3, 10);
    makeOlder(second, 6000);
    const auto status = [&] { return answerOf({"merge", "--status", at("parts")}); };
    const auto lines = [](const Answer& answer) { return answer.out.split(u'\n', Qt::SkipEmptyParts); };
    // Two at half a case a second each: 60 cases are left.
    Answer answer = status();
    EXPECT_EQ(answer.exitCode, 3);
    ASSERT_EQ(lines(answer).size(), 5) << answer.out.toStdString();
    EXPECT_EQ(lines(answer)[0], first + ": 5 of 25, under way");
    EXPECT_EQ(lines(answer)[1], second + ": 25 of 25, done");
    EXPECT_EQ(lines(answer)[3], "1 of 4 shards have not begun");
    EXPECT_EQ(lines(answer)[4], "40 of 100 cases (40.0 %), about 60 s left");
    // One of them was killed: the other one alone.
    first4.reset();
    makeOlder(first, 1200);
    answer = status();
    EXPECT_EQ(lines(answer)[0], first + ": 5 of 25, rests for 20 min");
    EXPECT_EQ(lines(answer)[4], "40 of 100 cases (40.0 %), about 2 min left");
    // Nobody computes: nothing tells how long it takes.
    third4.reset();
    makeOlder(at("parts/study.3-of-4.part"), 1200);
    EXPECT_EQ(lines(status())[4], "40 of 100 cases (40.0 %)");
}

TEST_F(Shards, ofOtherWorkOrWithoutAllCasesAreRefused) {
    const QStringList small{"study", "closed-loop", "--count", "2", "-o", at("parts")};
    ASSERT_EQ(answerOf(small + QStringList{"--shard", "1/2"}).exitCode, 0);
    const Answer missing = answerOf({"merge", at("parts"), "-o", at("merged")});
    EXPECT_EQ(missing.exitCode, 2);
    EXPECT_TRUE(missing.err.contains("1 of 2 cases are not there yet (2/2)")) << missing.err.toStdString();
    const Answer status = answerOf({"merge", "--status", at("parts")});
    EXPECT_EQ(status.exitCode, 3);
    EXPECT_TRUE(status.out.contains("1 of 2 shards have not begun")) << status.out.toStdString();
    const Answer again = answerOf(small + QStringList{"--shard", "1/2"});
    EXPECT_EQ(again.exitCode, 2);
    EXPECT_TRUE(again.err.contains("--resume")) << again.err.toStdString();
    ASSERT_EQ(
        answerOf({"study", "closed-loop", "--count", "2", "--seed", "9", "-o", at("parts"), "--shard", "2/2"})
            .exitCode,
        0);
    const Answer other = answerOf({"merge", at("parts"), "-o", at("merged")});
    EXPECT_EQ(other.exitCode, 2);
    EXPECT_TRUE(other.err.contains("seed is 1 here and 9 there")) << other.err.toStdString();
    EXPECT_FALSE(QDir(at("merged")).exists());
}

// Catches: a merge that cannot write, told in the name of another command.
TEST_F(Shards, ofAStudyAreRefusedInTheNameOfTheMerge) {
    ASSERT_EQ(
        answerOf({"study", "closed-loop", "--count", "1", "-o", at("parts"), "--shard", "1/1"}).exitCode, 0);
    QFile file(at("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    const Answer refused = answerOf({"merge", at("parts"), "-o", at("file")});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_TRUE(refused.err.contains("bask merge: ")) << refused.err.toStdString();
}

// Catches: a field whose bytes depend on how it was divided, in the image and in the store.
TEST_F(Shards, ofAFieldGiveTheBytesOfOneProcess) {
    for (const QStringList& more : {QStringList{"--preset", "paper-translation"},
                                    QStringList{"--preset", "paper-translation", "--gradient"}})
        for (const QString& name : {QStringLiteral("field.vti"), QStringLiteral("field.h5")}) {
            SCOPED_TRACE(name.toStdString() + more.back().toStdString());
            QDir(at("parts")).removeRecursively();
            QDir().mkpath(at("parts"));
            QFile::remove(at(name));
            const Answer whole = answerOf(QStringList{"field", "-o", at(name)} + more);
            ASSERT_EQ(whole.exitCode, 0) << whole.err.toStdString();
            const Answer answer = divided(QStringList{"field"} + more, 4, at("parts"), at("parts/") + name,
                                          at("parts/") + name);
            ASSERT_EQ(answer.exitCode, 0) << answer.err.toStdString();
            EXPECT_TRUE(whole.out.startsWith(answer.out)) << answer.out.toStdString();
            const QByteArray bytes = contents(at("parts/") + name);
            EXPECT_GT(bytes.size(), 380000);
            EXPECT_TRUE(bytes == contents(at(name)));
        }
}

TEST_F(Shards, refuseWrongWords) {
    const QString to = at("out");
    for (const QStringList& arguments :
         {QStringList{"study", "closed-loop", "-o", to, "--shard", "0/3"},
          QStringList{"study", "closed-loop", "-o", to, "--shard", "4/3"},
          QStringList{"study", "closed-loop", "-o", to, "--shard", "three"},
          QStringList{"study", "closed-loop", "-o", to, "--resume"},
          QStringList{"study", "closed-loop", "-o", to, "--threads", "0"},
          QStringList{"study", "closed-loop", "-o", to, "--processor", "z80"},
          QStringList{"study", "view-factor", "-o", to, "--shard", "1/2"},
          QStringList{"field", "--preset", "paper-translation", "--shard", "1/2"}, QStringList{"merge", to},
          QStringList{"merge", m_folder.path(), "-o", to},
          QStringList{"merge", QStringLiteral("/etc/hostname"), "-o", to}, QStringList{"merge"}}) {
        const Answer answer = answerOf(arguments);
        EXPECT_EQ(answer.exitCode, 2) << arguments.join(u' ').toStdString();
        EXPECT_FALSE(answer.err.isEmpty()) << arguments.join(u' ').toStdString();
    }
    EXPECT_FALSE(QFile::exists(to));
}

} // namespace
} // namespace bask::test
