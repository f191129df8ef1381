// The alarms of many recorded runs: how often, for how long, and in which.

#include "engine/base/message_code.h"
#include "engine/recording/alarm_history.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/first_version.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using test::madeUpSample;
using test::twoDisks;

using Events = std::vector<TraceEvent>;

TraceEvent overAt(double time_s, const Message& message) {
    return {time_s, messageAbout(MessageCode::EventAlarmOver, message)};
}

class AlarmHistoryTest : public ::testing::Test {
protected:
    std::string file(const char* name) const { return m_folder.filePath(name).toStdString(); }

    /// A run of a minute and a half with these events.
    SessionHeader recorded(const char* name, const char* created, const Events& events) const {
        const Experiment experiment = twoDisks();
        auto writer = SessionWriter::create(file(name), experiment, true);
        EXPECT_TRUE(writer);
        for (int k = 0; k < 91; ++k)
            EXPECT_TRUE((*writer)->add(madeUpSample(experiment, k)));
        for (const TraceEvent& event : events)
            EXPECT_TRUE((*writer)->add(event));
        EXPECT_TRUE((*writer)->finish("stopped"));
        writer->reset();
        SessionHeader header = readSessionHeader(file(name));
        EXPECT_FALSE(header.error);
        header.created = created;
        return header;
    }

    static const PastAlarm* find(const AlarmHistory& history, MessageCode code, const char* object = "") {
        const auto found = std::ranges::find_if(history.alarms, [&](const PastAlarm& alarm) {
            return alarm.message().code == code &&
                   (*object == '\0' || alarm.message().args.front().text() == object);
        });
        return found == history.alarms.end() ? nullptr : &*found;
    }

    QTemporaryDir m_folder;
};

const Message kLeftHot{MessageCode::SafetyObjectHot, {"left, the", "91.2", "90"}};
const Message kLeftHotter{MessageCode::SafetyObjectHot, {"left, the", "95.7", "90"}};
const Message kRightHot{MessageCode::SafetyObjectHot, {"right", "90.1", "90"}};
const Message kLate{MessageCode::SafetyLoopLate, {"0.4", "0.2"}};

constexpr double kEnd_s = 90 * 1.0001; // the last sample of a recorded run

struct Ending {
    const char* what;
    Events events;
    double active_s;
};

// Catches: an alarm that ends with another one's end, at a reset that leaves it, or never.
TEST(AlarmSpells, LastUntilWhatEndsThem) {
    const Message disk{MessageCode::SafetyDiskLow, {"90", "100"}};
    const Message notHeating{MessageCode::SafetySourceNotHeating, {"40", "200", "120"}};
    const Message open{MessageCode::SafetySensorOpen, {"left"}};
    const Message link{MessageCode::LinkLost, {"/dev/ttyUSB0", "unplugged"}};
    const Message silent{MessageCode::DeviceSilent, {"/dev/ttyUSB0", "2"}};
    const Message otherPort{MessageCode::DeviceSilent, {"/dev/ttyUSB1", "2"}};
    const Message pose{MessageCode::ReasonSourcePoseLost, {}};
    const TraceEvent reset{50.0, {MessageCode::EventReset, {}}};
    const std::vector<Ending> cases{
        {"over with newer values", {{10.0, kLeftHot}, overAt(25.5, kLeftHotter)}, 15.5},
        {"another object is over", {{10.0, kLeftHot}, overAt(25.5, kRightHot)}, 90.0},
        {"latched until reset, whatever is over",
         {{30.0, notHeating}, overAt(31.0, notHeating), reset},
         20.0},
        {"STOP until reset", {{45.0, {MessageCode::EventEmergencyStop, {}}}, reset}, 5.0},
        {"a note outlasts a reset", {{40.0, disk}, reset, overAt(60.0, disk)}, 20.0},
        {"the sensor is back",
         {{5.0, open},
          {6.0, {MessageCode::EventSensorBack, {"right"}}},
          {6.5, {MessageCode::EventSourcePoseBack, {}}},
          {8.0, {MessageCode::EventSensorBack, {"left"}}}},
         3.0},
        {"the source's pose is back",
         {{5.0, pose},
          {6.0, {MessageCode::EventSensorBack, {"left"}}},
          {9.0, {MessageCode::EventSourcePoseBack, {}}}},
         4.0},
        {"a device ends with other words",
         {{12.0, link}, overAt(13.0, otherPort), overAt(14.0, silent)},
         2.0},
        {"never over", {{10.0, kLeftHot}}, 90.0},
    };
    for (const Ending& each : cases) {
        const std::vector<AlarmSpell> spells = alarmSpells(each.events, 100.0);
        ASSERT_EQ(spells.size(), 1U) << each.what;
        EXPECT_EQ(spells[0].message, each.events[0].message) << each.what;
        EXPECT_DOUBLE_EQ(spells[0].raised_s, each.events[0].time_s) << each.what;
        EXPECT_DOUBLE_EQ(spells[0].active_s, each.active_s) << each.what;
    }
}

// Catches: words that only tell what has happened counted as alarms, or as active until the end.
TEST(AlarmSpells, AreAlarmsOnly) {
    const Events events{{0.0, {MessageCode::EventStarted, {}}},
                        {5.0, messageAbout(MessageCode::EventStoppedFor, kLeftHot)},
                        {5.0, kLeftHot},
                        {6.0, {MessageCode::EventNotSettled, {"left +2.1 K"}}},
                        {7.0, {MessageCode::EventStopped, {}}}};
    const std::vector<AlarmSpell> spells = alarmSpells(events, 100.0);
    ASSERT_EQ(spells.size(), 2U);
    EXPECT_EQ(spells[0].message, kLeftHot);
    EXPECT_EQ(spells[1].message.code, MessageCode::EventNotSettled);
    EXPECT_TRUE(std::isnan(spells[1].active_s)) << "nothing tells its end";
}

// Catches: an alarm that came again while its end was not recorded, counted twice for the same time.
TEST(AlarmSpells, OneThatComesAgainHasEnded) {
    const std::vector<AlarmSpell> spells = alarmSpells({{70.0, kLate}, {75.0, kLate}}, 100.0);
    ASSERT_EQ(spells.size(), 2U);
    EXPECT_DOUBLE_EQ(spells[0].active_s, 5.0);
    EXPECT_DOUBLE_EQ(spells[1].active_s, 25.0);
}

// Catches: runs counted as times, objects mixed up, the newest run not known, an alarm without an end left
// out or counted beyond the recording.
TEST_F(AlarmHistoryTest, CountsRunsTimesAndDurations) {
    const SessionHeader old = recorded("old.bask", "2026-03-14T09:26:53Z",
                                       {{10.0, kLeftHot}, overAt(12.0, kLeftHot), {20.0, kLate}});
    const SessionHeader quiet = recorded("quiet.bask", "2026-03-15T09:26:53Z", {});
    const SessionHeader young =
        recorded("young.bask", "2026-03-16T09:26:53Z",
                 {{30.0, kLeftHot}, overAt(31.0, kLeftHot), {40.0, kLeftHotter}, {41.0, kRightHot}});
    const AlarmHistory history = readAlarmHistory({old, quiet, young});
    EXPECT_EQ(history.runs.size(), 3U);
    EXPECT_TRUE(history.unreadable.empty());
    ASSERT_EQ(history.alarms.size(), 3U);
    const PastAlarm* left = find(history, MessageCode::SafetyObjectHot, "left, the");
    ASSERT_NE(left, nullptr);
    EXPECT_EQ(left->priority(), 1);
    EXPECT_EQ(left->times(), 3U);
    ASSERT_EQ(left->runs.size(), 2U);
    EXPECT_EQ(history.runs[left->runs[0].run].path, young.path) << "the newest run first";
    EXPECT_EQ(history.runs[left->runs[1].run].path, old.path);
    EXPECT_EQ(left->message(), kLeftHotter) << "with the values of the last time";
    EXPECT_NEAR(left->runs[0].active_s(), 1.0 + kEnd_s - 40.0, 1e-9);
    EXPECT_NEAR(left->active_s(), 2.0 + 1.0 + kEnd_s - 40.0, 1e-9);
    const PastAlarm* right = find(history, MessageCode::SafetyObjectHot, "right");
    ASSERT_NE(right, nullptr);
    EXPECT_EQ(right->times(), 1U);
    const PastAlarm* late = find(history, MessageCode::SafetyLoopLate);
    ASSERT_NE(late, nullptr);
    EXPECT_EQ(late->priority(), 3);
    EXPECT_NEAR(late->active_s(), kEnd_s - 20.0, 1e-9);
}

// Catches: a sum that one alarm without an end makes unknown, and one of nothing that is zero.
TEST_F(AlarmHistoryTest, AnUnknownDurationIsNotZero) {
    const Message notSettled{MessageCode::EventNotSettled, {"left +2.1 K"}};
    const AlarmHistory history =
        readAlarmHistory({recorded("a.bask", "2026-03-14T09:26:53Z", {{10.0, notSettled}})});
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_TRUE(std::isnan(history.alarms[0].active_s()));
    const AlarmInRun mixed{0, {{notSettled, 1.0}, {notSettled, 2.0, 5.0}, {notSettled, 3.0}}};
    EXPECT_DOUBLE_EQ(mixed.active_s(), 5.0);
}

// Catches: one damaged file that keeps all others from being read, or is left out without a word.
TEST_F(AlarmHistoryTest, DamagedFilesAreNamed) {
    const SessionHeader whole = recorded("whole.bask", "2026-03-14T09:26:53Z", {{10.0, kLeftHot}});
    const SessionHeader without = recorded("without.bask", "2026-03-15T09:26:53Z", {{10.0, kLeftHot}});
    {
        const auto store = SessionStore::create(without.path);
        ASSERT_TRUE(store);
        ASSERT_TRUE((*store)->execute("DROP TABLE event"));
    }
    QFile cut(m_folder.filePath("cut.bask"));
    ASSERT_TRUE(cut.open(QIODevice::WriteOnly));
    cut.write("SQLite format 3");
    cut.close();
    SessionHeader gone = whole;
    gone.path = file("gone.bask");
    const AlarmHistory history =
        readAlarmHistory({without, whole, readSessionHeader(file("cut.bask")), gone});
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_EQ(history.alarms[0].times(), 1U);
    EXPECT_EQ(history.alarms[0].runs[0].run, 1U);
    auto unreadable = history.unreadable;
    std::ranges::sort(unreadable);
    EXPECT_EQ(unreadable, (std::vector<std::size_t>{0, 2, 3}));
    for (const std::size_t k : unreadable)
        EXPECT_TRUE(history.runs[k].error) << k;
    EXPECT_EQ(history.runs[3].error->code(), MessageCode::FileNotFound);
    EXPECT_FALSE(history.runs[1].error);
}

// Catches: a reading that goes on through a year of files when nobody wants it any more.
TEST_F(AlarmHistoryTest, EndsWhenItIsAskedTo) {
    const std::vector<SessionHeader> runs{recorded("a.bask", "2026-03-14T09:26:53Z", {{10.0, kLeftHot}}),
                                          recorded("b.bask", "2026-03-15T09:26:53Z", {{10.0, kLeftHot}}),
                                          recorded("c.bask", "2026-03-16T09:26:53Z", {{10.0, kLeftHot}})};
    std::stop_source stop;
    std::vector<double> shares;
    const AlarmHistory part = readAlarmHistory(runs, stop.get_token(), [&](double share) {
        shares.push_back(share);
        if (share > 0.5)
            stop.request_stop();
    });
    ASSERT_EQ(part.alarms.size(), 1U);
    EXPECT_EQ(part.alarms[0].times(), 2U);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
    EXPECT_TRUE(readAlarmHistory(runs, stop.get_token()).alarms.empty());
}

// Catches: a file of version 1, which has no steps, that counts as damaged.
TEST_F(AlarmHistoryTest, ReadsTheFirstVersion) {
    const SessionHeader run = recorded("a.bask", "2026-03-14T09:26:53Z", {{10.0, kLeftHot}});
    ASSERT_TRUE(test::makeFirstVersion(run.path));
    const AlarmHistory history = readAlarmHistory({run});
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_NEAR(history.alarms[0].active_s(), kEnd_s - 10.0, 1e-9);
}

// Catches: a reading of samples or pictures, with which a year of a lab takes minutes.
TEST_F(AlarmHistoryTest, AHundredRunsAreReadAtOnce) {
    const SessionHeader first = recorded("run.bask", "2026-03-14T09:26:53Z", {{10.0, kLeftHot}});
    std::vector<SessionHeader> runs(100, first);
    for (std::size_t k = 1; k < runs.size(); ++k) {
        runs[k].path = file(("run" + std::to_string(k) + ".bask").c_str());
        ASSERT_TRUE(QFile::copy(QString::fromStdString(first.path), QString::fromStdString(runs[k].path)));
    }
    QElapsedTimer timer;
    timer.start();
    const AlarmHistory history = readAlarmHistory(runs);
    RecordProperty("ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 10'000);
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_EQ(history.alarms[0].runs.size(), 100U);
}

} // namespace
} // namespace bask
