// The alarms of many recorded runs: how often, for how long, and in which.

#include "engine/base/message_code.h"
#include "engine/experiment/unrecorded_alarms.h"
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
        auto writer =
            SessionWriter::create(file(name), experiment, true, 0.5, SessionWriter::Earlier::Replaced);
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
    const Message unasked{MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    const Message open{MessageCode::SafetySensorOpen, {"left"}};
    const Message link{MessageCode::LinkLost, {"/dev/ttyUSB0", "unplugged"}};
    const Message silent{MessageCode::DeviceSilent, {"/dev/ttyUSB0", "2"}};
    const Message otherPort{MessageCode::DeviceSilent, {"/dev/ttyUSB1", "2"}};
    const Message pose{MessageCode::ReasonSourcePoseLost, {}};
    const Message back{MessageCode::EventSensorBack, {"left"}};
    const TraceEvent reset{50.0, {MessageCode::EventReset, {}}};
    const std::vector<Ending> cases{
        {"over with newer values", {{10.0, kLeftHot}, overAt(25.5, kLeftHotter)}, 15.5},
        {"another object is over", {{10.0, kLeftHot}, overAt(25.5, kRightHot)}, 90.0},
        {"latched until reset, whatever is over",
         {{30.0, notHeating}, overAt(31.0, notHeating), reset},
         20.0},
        {"latched, and over before the reset", {{30.0, unasked}, overAt(42.0, unasked), reset}, 12.0},
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
        {"a device whose words name it by others",
         {{12.0, {MessageCode::DeviceExchanged, {"/dev/ttyUSB0", "a", "b"}}},
          overAt(13.0, {MessageCode::DeviceOther, {"/dev/ttyUSB1", "a"}}),
          overAt(14.0, {MessageCode::DeviceOther, {"/dev/ttyUSB0", "c"}})},
         2.0},
        {"the robot with other words",
         {{12.0, {MessageCode::RobotAlarm, {"1", "hard limit"}}},
          overAt(13.0, {MessageCode::HeaterGuardLost, {}}),
          overAt(15.0, {MessageCode::RobotRestarted, {}})},
         3.0},
        {"the heater's guard with other words",
         {{12.0, {MessageCode::HeaterGuardTookOver, {"silent"}}},
          overAt(15.0, {MessageCode::RobotHeld, {"Hold"}}),
          overAt(18.0, {MessageCode::HeaterGuardLost, {}})},
         6.0},
        {"a device that goes on after a reset", {{12.0, link}, reset, overAt(60.0, silent)}, 48.0},
        {"a device of which nothing is heard after a reset",
         {{12.0, link}, reset, overAt(60.0, otherPort)},
         38.0},
        {"latched, and over only after a reset", {{30.0, notHeating}, reset, overAt(60.0, notHeating)}, 20.0},
        {"told again while it is on", {{10.0, open}, {40.0, open}, {70.0, back}}, 60.0},
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

// Catches: an alarm that came again after its end, or after a reset, taken for the one before.
TEST(AlarmSpells, OneThatComesAgainIsAnother) {
    const Message link{MessageCode::LinkLost, {"/dev/ttyUSB0", "unplugged"}};
    const TraceEvent reset{50.0, {MessageCode::EventReset, {}}};
    const std::vector<AlarmSpell> spells = alarmSpells({{10.0, kLeftHot},
                                                        {11.0, kRightHot},
                                                        overAt(40.0, kLeftHot),
                                                        {45.0, link},
                                                        reset,
                                                        {60.0, kLeftHotter},
                                                        {70.0, link},
                                                        overAt(75.0, link)},
                                                       100.0);
    std::vector<double> active_s;
    active_s.reserve(spells.size());
    for (const AlarmSpell& spell : spells)
        active_s.push_back(spell.active_s);
    EXPECT_EQ(active_s, (std::vector<double>{30.0, 39.0, 5.0, 40.0, 5.0}));
}

// Catches: a device that ends the newest alarm of another, and sentences of a device counted as many alarms
// because it says something else each time.
TEST(AlarmSpells, WhatADeviceSaysMakesNoOtherAlarm) {
    const auto other = [](const char* said) {
        return Message{MessageCode::DeviceOther, {"/dev/ttyUSB0", said}};
    };
    EXPECT_EQ(alarmSpells({{1.0, other("x")}, {2.0, other("y")}}, 100.0).size(), 1U);
    EXPECT_TRUE(isSameAlarm(other("x"), other("y")));
    EXPECT_TRUE(isSameAlarm(kLeftHot, kLeftHotter));
    EXPECT_FALSE(isSameAlarm(kLeftHot, kRightHot));
    EXPECT_FALSE(isSameAlarm({MessageCode::RobotAlarm, {"1", "hard limit"}},
                             {MessageCode::RobotAlarm, {"2", "soft limit"}}));
}

// Catches: a damaged recording with a name for each event, with which each event is compared with all before:
// hours.
TEST(AlarmSpells, ManyNamesTakeNoLongerThanFew) {
    Events events;
    constexpr int kMany = 100'000;
    events.reserve(kMany);
    for (int k = 0; k < kMany; ++k)
        events.push_back({1.0, {MessageCode::SafetyObjectHot, {std::to_string(k), "91", "90"}}});
    QElapsedTimer timer;
    timer.start();
    EXPECT_EQ(alarmSpells(events, 100.0).size(), events.size());
    EXPECT_LT(timer.elapsed(), 30'000);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_TRUE(alarmSpells(events, 100.0, stop.get_token()).empty());
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
    const AlarmHistory history = readAlarmHistory({young, quiet, old});
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
    EXPECT_NEAR(left->runs[0].active().sum_s, 1.0 + kEnd_s - 40.0, 1e-9);
    EXPECT_NEAR(left->active().sum_s, 2.0 + 1.0 + kEnd_s - 40.0, 1e-9);
    const PastAlarm* right = find(history, MessageCode::SafetyObjectHot, "right");
    ASSERT_NE(right, nullptr);
    EXPECT_EQ(right->times(), 1U);
    const PastAlarm* late = find(history, MessageCode::SafetyLoopLate);
    ASSERT_NE(late, nullptr);
    EXPECT_EQ(late->priority(), 3);
    EXPECT_NEAR(late->active().sum_s, kEnd_s - 20.0, 1e-9);
}

// Catches: a sum that one alarm without an end makes unknown, and one of nothing that is zero.
TEST_F(AlarmHistoryTest, AnUnknownDurationIsNotZero) {
    const Message notSettled{MessageCode::EventNotSettled, {"left +2.1 K"}};
    const AlarmHistory history =
        readAlarmHistory({recorded("a.bask", "2026-03-14T09:26:53Z", {{10.0, notSettled}})});
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_TRUE(std::isnan(history.alarms[0].active().sum_s));
    const AlarmInRun mixed{0, {{notSettled, 1.0}, {notSettled, 2.0, 5.0}, {notSettled, 3.0}}};
    EXPECT_DOUBLE_EQ(mixed.active().sum_s, 5.0);
    EXPECT_TRUE(mixed.active().isAtLeast);
}

// Catches: 5 s told of an alarm that stood for 24 s and 5 s, since the first recording ended before it.
TEST_F(AlarmHistoryTest, WhatOutlastsItsRecordingIsAtLeastSoLong) {
    const SessionHeader cut = recorded("cut.bask", "2026-03-14T09:26:53Z", {{90.0, kLeftHot}});
    const SessionHeader whole =
        recorded("whole.bask", "2026-03-15T09:26:53Z", {{10.0, kLeftHot}, overAt(15.0, kLeftHot)});
    const AlarmHistory history = readAlarmHistory({whole, cut});
    ASSERT_EQ(history.alarms.size(), 1U);
    const PastAlarm& hot = history.alarms[0];
    ASSERT_EQ(hot.runs.size(), 2U);
    EXPECT_FALSE(hot.runs[0].active().isAtLeast);
    EXPECT_TRUE(hot.runs[1].active().isAtLeast);
    EXPECT_TRUE(hot.active().isAtLeast);
    EXPECT_NEAR(hot.active().sum_s, 5.0 + kEnd_s - 90.0, 1e-9);
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
    EXPECT_NEAR(history.alarms[0].active().sum_s, kEnd_s - 10.0, 1e-9);
}

// Catches: a damaged recording that fills the memory, keeps the program from its end, or has alarms that are
// active for ever.
TEST_F(AlarmHistoryTest, AHostileRecordingIsReadInPart) {
    const SessionHeader run = recorded("a.bask", "2026-03-14T09:26:53Z", {});
    {
        const auto store = SessionStore::create(run.path);
        ASSERT_TRUE(store);
        const char* many = R"(INSERT INTO event SELECT 1.0, 'LinkLost', '[' ||
            substr(replace(hex(zeroblob(500)), '0', '"x",'), 1, 3999) || ']', '')";
        const char* names = R"(WITH RECURSIVE n(k) AS (SELECT 1 UNION ALL SELECT k + 1 FROM n WHERE k < 20000)
            INSERT INTO event SELECT 2.0, 'SafetyObjectHot', '["name' || k || '","91","90"]', '' FROM n)";
        const char* never = "INSERT INTO event VALUES(9e999, 'SafetyDiskLow', '[]', '')";
        for (const char* statement : {many, names, never})
            ASSERT_TRUE((*store)->execute(statement)) << statement;
    }
    QElapsedTimer timer;
    timer.start();
    const AlarmHistory history = readAlarmHistory({run});
    EXPECT_LT(timer.elapsed(), 10'000);
    EXPECT_EQ(history.alarms.size(), 10'000U);
    const PastAlarm* link = find(history, MessageCode::LinkLost);
    ASSERT_NE(link, nullptr);
    EXPECT_EQ(link->message().args.size(), 10U);
    EXPECT_NEAR(link->active().sum_s, kEnd_s - 1.0, 1e-9);
}

// Catches: alarms without a run that are not those of the runs, an end of another time, an order that is not
// theirs, and a file that is not there or cannot be read taken for one.
TEST_F(AlarmHistoryTest, AddsWhatNoRunTells) {
    const auto change = [](AlarmChange what, double raised_s, double utc_s, const Message& message) {
        return UnrecordedChange{what, utc_s, raised_s, "key", message, 1, true, "A. Hu"};
    };
    const Message unasked{MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    using enum AlarmChange;
    const std::string without = file("alarms-without-run.jsonl");
    ASSERT_TRUE(appendUnrecordedAlarms(
        {change(Raised, 1e9, 1e9, unasked), change(Acknowledged, 1e9, 1e9 + 1.0, unasked),
         change(Raised, 2e9, 2e9, unasked), change(Over, 2e9, 2e9 + 30.0, unasked),
         change(Over, 3e9, 3e9 + 5.0, unasked), change(Raised, 1.5e9, 1.5e9, kLeftHotter)},
        without));
    QFile text(QString::fromStdString(without));
    ASSERT_TRUE(text.open(QIODevice::Append) && text.write("damaged\n") == 8);
    text.close();

    AlarmHistory history = readAlarmHistory({recorded("a.bask", "2026-03-14T09:26:53Z", {{10.0, kLeftHot}})});
    addUnrecorded(history, {});
    addUnrecorded(history, file("none.jsonl"));
    ASSERT_EQ(history.alarms.size(), 1U);
    EXPECT_TRUE(history.alarms[0].withoutRun.empty());
    addUnrecorded(history, without);
    EXPECT_EQ(history.damagedLines, 1U);
    EXPECT_FALSE(history.failure);
    ASSERT_EQ(history.alarms.size(), 2U);
    const PastAlarm* hot = find(history, MessageCode::SafetyObjectHot);
    ASSERT_NE(hot, nullptr);
    EXPECT_EQ(hot->times(), 2U) << "one in a run, one without";
    EXPECT_EQ(hot->message(), kLeftHot);
    EXPECT_NEAR(hot->active().sum_s, kEnd_s - 10.0, 1e-9) << "the other one's end is not known";
    const PastAlarm* alone = find(history, MessageCode::SafetySourceHeatsUnasked);
    ASSERT_NE(alone, nullptr);
    ASSERT_EQ(alone->times(), 2U);
    EXPECT_EQ(alone->message(), unasked);
    EXPECT_EQ(alone->priority(), 1);
    EXPECT_EQ(alone->withoutRun[0].raised_s, 2e9) << "the newest first";
    EXPECT_EQ(alone->withoutRun[0].active_s, 30.0);
    EXPECT_TRUE(std::isnan(alone->withoutRun[1].active_s)) << "it ended in a run, or with Bask";
    EXPECT_EQ(alone->active().sum_s, 30.0);
    addUnrecorded(history, m_folder.path().toStdString());
    EXPECT_TRUE(history.failure);
}

} // namespace
} // namespace bask
