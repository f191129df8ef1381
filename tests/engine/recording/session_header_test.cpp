// Lists of sessions, their tags, and the end of a recording that was cut off.

#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/run_metrics.h"
#include "engine/recording/session_header.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <algorithm>
#include <atomic>
#include <optional>
#include <thread>

namespace bask {
namespace {

using test::madeUpSample;
using test::twoDisks;

class SessionHeaderTest : public ::testing::Test {
protected:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }

    std::string recorded(const char* name, int samples, const std::string& outcome) const {
        Experiment experiment = twoDisks();
        experiment.title = "two disks, evening";
        auto writer =
            SessionWriter::create(file(name), experiment, true, 0.5, SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        for (int k = 0; k < samples; ++k)
            EXPECT_TRUE((*writer)->add(madeUpSample(experiment, k)));
        EXPECT_TRUE((*writer)->add(TraceNote{1.0, "door opened"}));
        if (!outcome.empty()) {
            EXPECT_TRUE((*writer)->finish(outcome));
        }
        return file(name);
    }

    /// A recording whose process was killed in its midst.
    std::string killed(const char* name) const {
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(),
                    {"--record-until-killed", QString::fromStdString(file(name))});
        EXPECT_TRUE(child.waitForStarted());
        double last_s = 0.0;
        while (last_s < 1.5 && child.waitForReadyRead(20'000))
            while (child.canReadLine())
                last_s = child.readLine().toDouble();
        child.kill();
        EXPECT_TRUE(child.waitForFinished());
        EXPECT_TRUE(QFile::exists(QString::fromStdString(file(name) + "-wal")));
        return file(name);
    }

    QTemporaryDir m_folder;
};

// Catches a header that tells another run than the file holds.
TEST_F(SessionHeaderTest, TellsWhatTheWholeFileTells) {
    const SessionHeader header = readSessionHeader(recorded("a.bask", 30, "settled"));
    const auto record = readSession(header.path);
    ASSERT_TRUE(record);
    EXPECT_FALSE(header.error);
    EXPECT_EQ(header.title, "two disks, evening");
    ASSERT_EQ(header.objects.size(), record->experiment.objects.size());
    const ObjectSpec& second = record->experiment.objects[1];
    EXPECT_EQ(header.objects[1].name, second.name);
    EXPECT_DOUBLE_EQ(header.objects[1].target_K, second.target_K);
    EXPECT_EQ(header.objects[1].material, second.material.name);
    EXPECT_DOUBLE_EQ(header.objects[1].emittance, second.material.emittance);
    EXPECT_EQ(header.controller, record->experiment.controller.kind.key());
    EXPECT_EQ(header.created, record->created);
    EXPECT_EQ(header.simulated, record->simulated);
    EXPECT_EQ(header.outcome, "settled");
    EXPECT_EQ(header.samples, 30U);
    EXPECT_EQ(header.end_s, record->samples.back().time_s);
    EXPECT_EQ(header.notes, std::vector<std::string>{"door opened"});
    EXPECT_TRUE(header.tags.empty());
    EXPECT_FALSE(QFile::exists(QString::fromStdString(header.path + "-shm"))) << "nothing is left beside it";
}

// Catches the time of the cooling in the length of a run that STOP has ended.
TEST_F(SessionHeaderTest, TheLengthOfARunEndsWithItsStop) {
    const std::string path = file("stop.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true);
    ASSERT_TRUE(writer);
    for (int k = 0; k < 30; ++k)
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
    for (const double time_s : {12.0, 25.0}) // the second one is pressed while it cools
        ASSERT_TRUE((*writer)->add(TraceEvent{time_s, {MessageCode::EventEmergencyStop, {}}}));
    ASSERT_TRUE((*writer)->finish("emergency-stop"));
    const SessionHeader header = readSessionHeader(path);
    EXPECT_EQ(header.length_s(), 12.0);
    EXPECT_EQ(header.length_s(), runMetrics(*readSession(path)).duration_s) << "one length of one run";
    EXPECT_GT(header.end_s, 28.0);
    const SessionHeader unended = readSessionHeader(recorded("a.bask", 30, "fault"));
    EXPECT_FALSE(unended.stopped_s);
    EXPECT_EQ(unended.length_s(), unended.end_s);
}

// Catches: a run that looks as if it had ended for an alarm of another priority, and one that a person ended.
TEST_F(SessionHeaderTest, TellsThePriorityOfTheAlarmThatEndedTheRun) {
    const Message slow{MessageCode::RobotSlow, {"4"}},
        hot{MessageCode::SafetyObjectHot, {"left", "91", "90"}};
    ASSERT_EQ(alarmPriority(slow.code), 2);
    ASSERT_EQ(alarmPriority(hot.code), 1);
    const Message ended = messageAbout(MessageCode::EventStoppedFor, slow);
    const auto ends = [&](const char* name, const std::vector<TraceEvent>& events) {
        const std::string path = file(name);
        auto writer = SessionWriter::create(path, twoDisks(), true);
        EXPECT_TRUE(writer);
        for (int k = 0; k < 30; ++k)
            EXPECT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
        for (const TraceEvent& event : events)
            EXPECT_TRUE((*writer)->add(event));
        EXPECT_TRUE((*writer)->finish("fault"));
        writer->reset();
        const int priority = readSessionHeader(path).endPriority;
        EXPECT_EQ(endPriority(readSession(path).value()), priority) << "one priority of one run";
        return priority;
    };
    EXPECT_EQ(ends("slow.bask", {{12.0, ended}, {15.0, hot}}), 2) << "what came later has not ended it";
    EXPECT_EQ(ends("person.bask", {{9.0, {MessageCode::EventStopped, {}}}, {12.0, ended}}), 0);
    EXPECT_EQ(ends("armed.bask", {{0.0, hot}}), 0);
}

// Catches a run that has no length, or no samples, because of what was stopped before its Start.
TEST_F(SessionHeaderTest, AStopBeforeStartEndsNoRun) {
    const std::string path = file("early.bask");
    auto writer = SessionWriter::create(path, twoDisks(), true);
    ASSERT_TRUE(writer);
    for (int k = 0; k < 30; ++k)
        ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), k)));
    for (const double time_s : {-8.0, 12.0})
        ASSERT_TRUE((*writer)->add(TraceEvent{time_s, {MessageCode::EventStopped, {}}}));
    ASSERT_TRUE((*writer)->finish("stopped"));
    EXPECT_EQ(readSessionHeader(path).stopped_s, 12.0);
    EXPECT_EQ(controlledUntil_s(readSession(path).value()), 12.0);
}

// Catches files that are left out of a list because they cannot be read, and ones that are no sessions in it.
TEST_F(SessionHeaderTest, AFolderListsDamagedFilesWithTheirError) {
    QFile whole(QString::fromStdString(recorded("whole.bask", 200, "settled")));
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    QFile cut(m_folder.filePath("cut.bask")), other(m_folder.filePath("notes.txt"));
    ASSERT_TRUE(cut.open(QIODevice::WriteOnly) && other.open(QIODevice::WriteOnly));
    cut.write(whole.readAll().left(20'000));
    cut.close();
    auto files = sessionFiles(m_folder.path().toStdString());
    std::ranges::sort(files);
    ASSERT_EQ(files, (std::vector{file("cut.bask"), file("whole.bask")}));
    const SessionHeader damaged = readSessionHeader(files[0]);
    ASSERT_TRUE(damaged.error);
    EXPECT_EQ(damaged.error->code(), MessageCode::SessionDamaged);
    EXPECT_EQ(damaged.path, files[0]);
    EXPECT_TRUE(sessionFiles("/nowhere/at/all").empty());
    EXPECT_EQ(readSessionHeader("/nowhere.bask").error->code(), MessageCode::FileNotFound);
}

// Catches tags that cost a sample, are lost in a copy, or leave a log beside the file.
TEST_F(SessionHeaderTest, TagsChangeNothingElse) {
    const std::string path = recorded("a.bask", 300, "stopped");
    const auto before = readSession(path);
    ASSERT_TRUE(before);
    ASSERT_TRUE(writeSessionTags(path, {"good run", "caf\xc3\xa9 \"A\""}));
    ASSERT_TRUE(writeSessionTags(path, {"caf\xc3\xa9 \"A\"", "b"})) << "the second time the file has tags";
    EXPECT_EQ(readSessionHeader(path).tags, (std::vector<std::string>{"caf\xc3\xa9 \"A\"", "b"}));
    const auto after = readSession(path);
    ASSERT_TRUE(after) << describe(after.error());
    ASSERT_EQ(after->samples.size(), before->samples.size());
    for (std::size_t k = 0; k < after->samples.size(); ++k)
        EXPECT_TRUE(test::sameSample(after->samples[k], before->samples[k])) << k;
    EXPECT_EQ(after->outcome, "stopped");
    EXPECT_EQ(after->created, before->created);
    EXPECT_FALSE(QFile::exists(QString::fromStdString(path + "-wal")));
    ASSERT_TRUE(copySession(path, file("copy.bask")));
    EXPECT_EQ(readSessionHeader(file("copy.bask")).tags.size(), 2U);
    ASSERT_TRUE(writeSessionTags(file("copy.bask"), {}));
    EXPECT_TRUE(readSessionHeader(file("copy.bask")).tags.empty());
    EXPECT_TRUE(readSession(file("copy.bask")));
}

// Catches tags written into a run that is being recorded, or into what is no session.
TEST_F(SessionHeaderTest, TagsAreRefusedWhereTheyCouldHarm) {
    auto writer = SessionWriter::create(file("live.bask"), twoDisks(), true);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
    ASSERT_TRUE((*writer)->flush());
    const auto busy = writeSessionTags(file("live.bask"), {"x"});
    ASSERT_FALSE(busy);
    EXPECT_EQ(busy.error().code(), MessageCode::SessionBusy);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 1)));
    QFile foreign(m_folder.filePath("foreign.bask"));
    ASSERT_TRUE(foreign.open(QIODevice::WriteOnly));
    foreign.write("a text");
    foreign.close();
    EXPECT_EQ(writeSessionTags(file("foreign.bask"), {"x"}).error().code(), MessageCode::NotASession);
    ASSERT_TRUE(foreign.open(QIODevice::ReadOnly));
    EXPECT_EQ(foreign.readAll(), "a text");
}

// Catches a recording that is closed with a loss, or that still counts as cut off afterwards.
TEST_F(SessionHeaderTest, AKilledRecordingIsClosedWithAllItHad) {
    const std::string path = killed("killed.bask");
    const auto before = readSession(path);
    ASSERT_TRUE(before);
    EXPECT_TRUE(readSessionHeader(path).outcome.empty());
    EXPECT_FALSE(writeSessionTags(path, {"x"})) << "it has no end yet";
    const auto closed = closeInterrupted(path);
    ASSERT_TRUE(closed) << describe(closed.error());
    EXPECT_FALSE(QFile::exists(QString::fromStdString(path + "-wal")));
    const auto after = readSession(path);
    ASSERT_TRUE(after) << describe(after.error());
    EXPECT_EQ(after->outcome, kOutcomeInterrupted);
    ASSERT_EQ(after->samples.size(), before->samples.size());
    EXPECT_TRUE(test::sameSample(after->samples.back(), before->samples.back()));
    EXPECT_EQ(after->events.size(), before->events.size());
    EXPECT_TRUE(closeInterrupted(path)) << "once more changes nothing";
    EXPECT_TRUE(writeSessionTags(path, {"x"}));
}

// Catches a run that is closed while another hand still records into it.
TEST_F(SessionHeaderTest, ARunThatIsOnIsNotClosed) {
    auto writer = SessionWriter::create(file("live.bask"), twoDisks(), true, 0.0);
    ASSERT_TRUE(writer);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 0)));
    const auto refused = closeInterrupted(file("live.bask"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SessionBusy);
    ASSERT_TRUE((*writer)->add(madeUpSample(twoDisks(), 1)));
    ASSERT_TRUE((*writer)->finish("settled"));
    writer->reset();
    EXPECT_EQ(readSession(file("live.bask"))->samples.size(), 2U);
}

// Catches an attempt to mend a damaged file that makes it worse.
TEST_F(SessionHeaderTest, ADamagedFileIsLeftAsItIs) {
    QFile whole(QString::fromStdString(recorded("whole.bask", 400, "")));
    ASSERT_TRUE(whole.open(QIODevice::ReadOnly));
    QByteArray bytes = whole.readAll();
    ASSERT_GT(bytes.size(), 60'000);
    bytes.replace(30'000, 20'000, QByteArray(20'000, '\x5a'));
    QFile damaged(m_folder.filePath("damaged.bask"));
    ASSERT_TRUE(damaged.open(QIODevice::WriteOnly));
    damaged.write(bytes);
    damaged.close();
    const auto refused = closeInterrupted(file("damaged.bask"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::SessionDamaged) << describe(refused.error());
    ASSERT_TRUE(damaged.open(QIODevice::ReadOnly));
    EXPECT_EQ(damaged.readAll(), bytes);
}

// Catches a header that reads the whole file: a list of hundreds would take minutes.
TEST_F(SessionHeaderTest, ReadingDoesNotGrowWithTheRun) {
    const std::string path = recorded("long.bask", 20'000, "settled");
    QElapsedTimer timer;
    timer.start();
    for (int k = 0; k < 100; ++k)
        ASSERT_EQ(readSessionHeader(path).samples, 20'000U);
    RecordProperty("ms_each", std::to_string(static_cast<double>(timer.elapsed()) / 100.0));
    EXPECT_LT(timer.elapsed(), 3000) << "100 headers";
}

// Catches a recording that cannot be given its end because a page shows it.
TEST_F(SessionHeaderTest, ARunThatIsShownCanBeClosed) {
    const std::string path = killed("shown.bask");
    const auto session = RecordedSession::open(path);
    ASSERT_TRUE(session) << describe(session.error());
    ASSERT_TRUE((*session)->sampleAt(0.5));
    std::optional<Result<void>> done;
    std::atomic<bool> isOver = false;
    std::thread closing([&] {
        done = closeInterrupted(path);
        isOver = true;
    });
    while (!isOver)
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    closing.join();
    ASSERT_TRUE(*done) << describe(done->error());
    EXPECT_EQ(readSessionHeader(path).outcome, kOutcomeInterrupted);
    EXPECT_TRUE((*session)->sampleAt(1.0));
}

} // namespace
} // namespace bask
