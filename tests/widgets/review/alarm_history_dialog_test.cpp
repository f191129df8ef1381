#include "widgets/review/alarm_history_dialog.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/stop_button.h"

#include <QApplication>
#include <QClipboard>
#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace bask {
namespace {

SessionHeader pastRun(const char* name, const char* created, bool isSimulated) {
    SessionHeader run;
    run.path = std::string("/runs/") + name + ".bask";
    run.title = "title";
    run.created = created;
    run.simulated = isSimulated;
    return run;
}

Message hot(const char* object, const char* t_degC) {
    return {MessageCode::SafetyObjectHot, {object, t_degC, "90"}};
}

/// "hand" was hot twelve times in the younger run and once in the older one, where "foot" was hot twice; the
/// younger one did not settle.
AlarmHistory somePast() {
    AlarmHistory past;
    past.runs = {pastRun("older", "2026-03-14T09:26:53Z", false),
                 pastRun("younger", "2026-03-16T09:26:53Z", true)};
    PastAlarm hand;
    hand.runs = {{1, {}}, {0, {{hot("hand", "91"), 5.0, 2.0}}}};
    for (int k = 0; k < 12; ++k)
        hand.runs[0].spells.push_back({hot("hand", "92"), 60.0 * k, 300.0});
    PastAlarm foot;
    foot.runs = {{0, {{hot("foot", "95"), 7.0, 20.0}, {hot("foot", "96"), 70.0, 9.0}}}};
    PastAlarm notSettled;
    notSettled.runs = {{1, {{{MessageCode::EventNotSettled, {"hand +2.1 K"}}, 600.0}}}};
    past.alarms = {foot, hand, notSettled};
    return past;
}

struct AlarmHistoryDialogTest : testing::Test {
    AlarmHistoryDialog dialog;
    QTreeWidget* alarms = dialog.findChild<QTreeWidget*>("alarmHistoryAlarms");
    QTreeWidget* runs = dialog.findChild<QTreeWidget*>("alarmHistoryRuns");
    QLineEdit* filter = dialog.findChild<QLineEdit*>("alarmHistoryFilter");
    QPushButton* open = dialog.findChild<QPushButton*>("alarmHistoryOpen");

    AlarmHistoryDialogTest() {
        dialog.show();
        dialog.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&dialog));
    }
    ~AlarmHistoryDialogTest() override { setReadersUnit(TemperatureUnit::Celsius); }

    QTreeWidgetItem* alarm(const char* word) {
        for (int k = 0; k < alarms->topLevelItemCount(); ++k)
            if (alarms->topLevelItem(k)->text(0).contains(QLatin1String(word)))
                return alarms->topLevelItem(k);
        ADD_FAILURE() << word;
        return nullptr;
    }
    static QStringList cells(const QTreeWidgetItem* row) {
        QStringList texts;
        for (int column = 1; column < row->columnCount(); ++column)
            texts << row->text(column);
        return texts;
    }
    /// The first words of the alarms, from the top.
    QStringList order() {
        QStringList words;
        for (int k = 0; k < alarms->topLevelItemCount(); ++k)
            if (!alarms->topLevelItem(k)->isHidden())
                words << alarms->topLevelItem(k)->text(0).section(u' ', 0, 0);
        return words;
    }
    QString said(const char* label) {
        const auto* found = dialog.findChild<QLabel*>(QLatin1String(label));
        return found->isVisible() ? found->text() : QString();
    }
    /// When a recording began, as the reader's clock told it.
    static QString date(const char* created) {
        return QDateTime::fromString(QLatin1String(created), Qt::ISODate)
            .toLocalTime()
            .toString("yyyy-MM-dd HH:mm:ss");
    }
};

// Catches: numbers of another alarm, a sentence or a date of another run than the newest, a duration that is
// not known and looks like none.
TEST_F(AlarmHistoryDialogTest, ARowTellsAnAlarm) {
    dialog.setHistory(somePast());
    ASSERT_EQ(alarms->topLevelItemCount(), 3);
    EXPECT_EQ(alarm("hand\"")->text(0), sentenceText(hot("hand", "92")));
    EXPECT_EQ(cells(alarm("hand\"")),
              (QStringList{"1", "2", "13", "1:00:02", date("2026-03-16T09:26:53Z") + " + 11:00",
                           "younger, " + date("2026-03-16T09:26:53Z")}))
        << "raised last 11 minutes after Start, which is no date: simulated time may be faster";
    EXPECT_EQ(alarm("foot")->text(0), sentenceText(hot("foot", "96")));
    EXPECT_EQ(cells(alarm("foot")),
              (QStringList{"1", "1", "2", "0:29", date("2026-03-14T09:26:53Z") + " + 1:10",
                           "older, " + date("2026-03-14T09:26:53Z")}));
    EXPECT_EQ(alarm("settled")->text(4), kNoValue);
    for (int k = 0; k < 3; ++k) {
        EXPECT_FALSE(alarms->topLevelItem(k)->icon(0).isNull());
        EXPECT_EQ(alarms->topLevelItem(k)->toolTip(0), alarms->topLevelItem(k)->text(0));
    }
    EXPECT_TRUE(alarm("foot")->data(0, Qt::AccessibleTextRole).toString().startsWith("Priority 1: "));
    EXPECT_TRUE(said("alarmHistorySummary").startsWith("Alarms in 2 of 2 run"));
}

// Catches: runs of another alarm, and a row without the times at which it was raised.
TEST_F(AlarmHistoryDialogTest, TheRunsAreThoseOfTheSelectedAlarm) {
    dialog.setHistory(somePast());
    EXPECT_EQ(alarms->currentItem(), alarm("hand\"")) << "the gravest that was raised last";
    ASSERT_EQ(runs->topLevelItemCount(), 2);
    EXPECT_EQ(runs->topLevelItem(0)->text(0), date("2026-03-16T09:26:53Z")) << "the newest first";
    EXPECT_EQ(cells(runs->topLevelItem(0)).mid(0, 4), (QStringList{"younger", "SIMULATED", "12", "1:00:00"}));
    EXPECT_EQ(cells(runs->topLevelItem(1)), (QStringList{"older", "LIVE", "1", "0:02", "0:05"}));
    alarms->setCurrentItem(alarm("foot"));
    ASSERT_EQ(runs->topLevelItemCount(), 1);
    EXPECT_EQ(cells(runs->topLevelItem(0)), (QStringList{"older", "LIVE", "2", "0:29", "0:07, 1:10"}));
}

// Catches: a sum that hides that a recording ended before the alarm.
TEST_F(AlarmHistoryDialogTest, ASumOfWhatWasCutIsAtLeastThat) {
    AlarmHistory past = somePast();
    past.alarms[0].runs.push_back({1, {{hot("foot", "97"), 0.0, 0.0, true}}});
    dialog.setHistory(past);
    EXPECT_EQ(alarm("foot")->text(4), "at least 0:29");
    alarms->setCurrentItem(alarm("foot"));
    ASSERT_EQ(runs->topLevelItemCount(), 2);
    EXPECT_EQ(runs->topLevelItem(0)->text(4), "at least 0:00");
    EXPECT_EQ(runs->topLevelItem(1)->text(4), "0:29");
    alarms->sortByColumn(4, Qt::AscendingOrder);
    EXPECT_EQ(order(), (QStringList{"Not", "\"foot\"", "\"hand\""})) << "by the number";
}

// Catches: numbers sorted as words, 2 behind 13, and an alarm without a duration between others.
TEST_F(AlarmHistoryDialogTest, ColumnsAreSortedByWhatTheySay) {
    dialog.setHistory(somePast());
    EXPECT_EQ(order(), (QStringList{"\"hand\"", "\"foot\"", "Not"})) << "at first the gravest";
    alarms->sortByColumn(3, Qt::AscendingOrder);
    EXPECT_EQ(order(), (QStringList{"Not", "\"foot\"", "\"hand\""}));
    alarms->sortByColumn(4, Qt::AscendingOrder);
    EXPECT_EQ(order(), (QStringList{"Not", "\"foot\"", "\"hand\""}));
    alarms->sortByColumn(5, Qt::AscendingOrder);
    EXPECT_EQ(order().first(), "\"foot\"");
    alarms->sortByColumn(0, Qt::DescendingOrder);
    EXPECT_EQ(order().last(), "\"foot\"");
    runs->sortByColumn(3, Qt::AscendingOrder);
    alarms->setCurrentItem(alarm("hand\""));
    EXPECT_EQ(runs->topLevelItem(0)->text(1), "older") << "once before twelve times";
}

// Catches: a grave alarm below frequent trifles, an order within a priority by what is not told, and a late
// time in an older run taken for a later one.
TEST_F(AlarmHistoryDialogTest, TheGravestAreFirstThenTheLatest) {
    AlarmHistory past = somePast();
    PastAlarm often, early, damaged;
    const AlarmSpell trifle{{MessageCode::SafetySensorOpen, {"hand"}}, 900.0, 2.0};
    often.runs = {{1, std::vector<AlarmSpell>(100, trifle)}};
    early.runs = {{1, {{hot("early", "92"), 3.0, 2.0}}}};
    damaged.runs = {{0, {{hot("damaged", "92"), 1e300, 2.0}}}};
    past.alarms.insert(past.alarms.begin(), {often, damaged, early});
    dialog.setHistory(past);
    QStringList ranks;
    for (int k = 0; k < alarms->topLevelItemCount(); ++k)
        ranks << alarms->topLevelItem(k)->text(1);
    EXPECT_TRUE(std::ranges::is_sorted(ranks)) << ranks.join(u' ').toStdString();
    EXPECT_EQ(order().mid(0, 4), (QStringList{"\"hand\"", "\"early\"", "\"damaged\"", "\"foot\""}))
        << "11 minutes and 3 s into the younger run, at any time and 70 s into the older one";
}

// Catches: a filter for any word instead of all, one that leaves a hidden alarm selected, and one that finds
// nothing and says so by an empty table alone.
TEST_F(AlarmHistoryDialogTest, TheFilterLeavesWhatHasEveryWord) {
    dialog.setHistory(somePast());
    QTest::keyClicks(filter, "TRIP foot");
    EXPECT_EQ(order(), QStringList{"\"foot\""});
    EXPECT_EQ(alarms->currentItem(), alarm("foot"));
    EXPECT_EQ(runs->topLevelItemCount(), 1);
    filter->setText("foot nowhere");
    EXPECT_TRUE(order().isEmpty());
    EXPECT_EQ(said("alarmHistorySummary"), "No alarm matches \"foot nowhere\".");
    EXPECT_EQ(runs->topLevelItemCount(), 0);
    EXPECT_FALSE(open->isEnabled());
    filter->clear();
    EXPECT_EQ(order().size(), 3);
    EXPECT_TRUE(open->isEnabled());
}

// Catches: a run that is seen here and cannot be opened, by mouse, keyboard or button; another one opened.
TEST_F(AlarmHistoryDialogTest, ARunIsOpened) {
    dialog.setHistory(somePast());
    QSignalSpy chosen(&dialog, &AlarmHistoryDialog::runChosen);
    runs->setFocus();
    QTest::keyClick(runs, Qt::Key_Down);
    QTest::keyClick(runs, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().at(1).toDouble(), 5.0) << "when the alarm was raised in it";
    EXPECT_EQ(chosen.takeFirst().at(0).toString(), "/runs/older.bask");
    const QPoint first = runs->visualItemRect(runs->topLevelItem(0)).center();
    QTest::mouseClick(runs->viewport(), Qt::LeftButton, {}, first);
    QTest::mouseDClick(runs->viewport(), Qt::LeftButton, {}, first);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().at(1).toDouble(), 660.0) << "the last time";
    EXPECT_EQ(chosen.takeFirst().at(0).toString(), "/runs/younger.bask");
    QTest::mouseClick(open, Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.takeFirst().at(0).toString(), "/runs/younger.bask");
    EXPECT_TRUE(dialog.isVisible()) << "others are looked at next";
    QTest::keyClick(filter, Qt::Key_Return);
    EXPECT_TRUE(dialog.isVisible());
    EXPECT_EQ(chosen.count(), 0);
}

// Catches: empty tables without a word, whatever the reason.
TEST_F(AlarmHistoryDialogTest, WhatIsEmptySaysWhy) {
    dialog.setReading(40);
    EXPECT_EQ(said("alarmHistorySummary"), "Reading the runs: 40 %");
    dialog.setHistory({});
    EXPECT_EQ(said("alarmHistorySummary"), "The list has no run.");
    AlarmHistory quiet = somePast();
    quiet.alarms.clear();
    dialog.setHistory(quiet);
    EXPECT_TRUE(said("alarmHistorySummary").startsWith("No alarm was raised in 2 run"));
    EXPECT_FALSE(open->isEnabled());
    EXPECT_FALSE(dialog.findChild<QPushButton*>("alarmHistoryCopy")->isEnabled());
    EXPECT_TRUE(said("alarmHistoryUnread").isEmpty());
    dialog.setHistory(somePast());
    dialog.setHistory(quiet);
    EXPECT_EQ(alarms->topLevelItemCount() + runs->topLevelItemCount(), 0) << "of the history before";
}

// Catches: files that are left out without a word, or without the reason.
TEST_F(AlarmHistoryDialogTest, UnreadableFilesAreNamed) {
    AlarmHistory past = somePast();
    for (int k = 0; k < 7; ++k) {
        past.unreadable.push_back(past.runs.size());
        past.runs.push_back(pastRun(qPrintable(QString("bad%1").arg(k)), "", false));
        past.runs.back().error =
            Error(MessageCode::SessionDamaged, past.runs.back().path, {"it is cut short"});
    }
    dialog.setHistory(past);
    EXPECT_TRUE(said("alarmHistorySummary").startsWith("Alarms in 2 of 2 run"));
    EXPECT_TRUE(said("alarmHistoryUnread").startsWith("7 recording"));
    EXPECT_TRUE(said("alarmHistoryUnread")
                    .endsWith(": bad0.bask, bad1.bask, bad2.bask, bad3.bask, bad4.bask, \u2026"));
    const QString tip = dialog.findChild<QLabel*>("alarmHistoryUnread")->toolTip();
    EXPECT_TRUE(tip.contains("bad6.bask: " + sentenceText(past.runs.back().error->message)))
        << tip.toStdString();
}

// Catches: a copy of what the filter hides, or in another order than it is seen.
TEST_F(AlarmHistoryDialogTest, WhatIsShownIsCopied) {
    dialog.setHistory(somePast());
    filter->setText("trip");
    QTest::mouseClick(dialog.findChild<QPushButton*>("alarmHistoryCopy"), Qt::LeftButton);
    const QChar space(0x00a0); // which this platform's clipboard does not keep
    const QStringList lines = QApplication::clipboard()->text().replace(space, u' ').split(u'\n');
    ASSERT_EQ(lines.size(), 3);
    EXPECT_EQ(lines[0], "Alarm\tPriority\tRuns\tTimes\tActive\tLast raised\tLast run");
    EXPECT_EQ(lines[1].section(u'\t', 1, 4), "1\t2\t13\t1:00:02");
    EXPECT_EQ(lines[2].section(u'\t', 0, 0), sentenceText(hot("foot", "96")).replace(space, u' '));
}

// Catches: a damaged file with thousands of names that keeps the window from answering, and grave alarms left
// out for others.
TEST_F(AlarmHistoryDialogTest, OfTooManyTheGravestAreShown) {
    AlarmHistory past = somePast();
    constexpr std::size_t kMany = AlarmHistoryDialog::kMaxShown + 100;
    std::vector<PastAlarm> many(kMany);
    for (std::size_t k = 0; k < kMany; ++k)
        many[k].runs = {{0, {{{MessageCode::SafetySensorOpen, {"name" + std::to_string(k)}}, 1.0, 2.0}}}};
    past.alarms.insert(past.alarms.begin(), many.begin(), many.end());
    dialog.setHistory(past);
    EXPECT_EQ(alarms->topLevelItemCount(), static_cast<int>(AlarmHistoryDialog::kMaxShown));
    EXPECT_NE(alarm("hand\""), nullptr);
    EXPECT_NE(alarm("foot"), nullptr);
    EXPECT_TRUE(said("alarmHistorySummary").contains("Only 1000 of 1103 alarms"))
        << said("alarmHistorySummary").toStdString();
    dialog.setHistory(somePast());
    EXPECT_FALSE(said("alarmHistorySummary").contains("Only"));
}

// Catches: a selected alarm that is lost when the runs are read again.
TEST_F(AlarmHistoryDialogTest, ReadingAnewKeepsTheSelection) {
    dialog.setHistory(somePast());
    alarms->setCurrentItem(alarm("foot"));
    AlarmHistory later = somePast();
    std::ranges::reverse(later.alarms);
    later.alarms.back().runs.front().spells.push_back({hot("foot", "97"), 80.0, 1.0});
    dialog.setHistory(later);
    EXPECT_EQ(alarms->currentItem(), alarm("foot")) << "with other values";
    EXPECT_EQ(cells(runs->topLevelItem(0)).at(2), "3");
}

// Catches: a run that is not selected any more after a letter in the filter that leaves its alarm.
TEST_F(AlarmHistoryDialogTest, TheFilterLeavesTheRunsOfTheSameAlarm) {
    dialog.setHistory(somePast());
    runs->setCurrentItem(runs->topLevelItem(1));
    QTest::keyClicks(filter, "hand");
    EXPECT_EQ(alarms->currentItem(), alarm("hand\""));
    EXPECT_EQ(runs->currentItem(), runs->topLevelItem(1));
}

// Catches: temperatures in a unit that the reader has left, and a selection that is lost with it.
TEST_F(AlarmHistoryDialogTest, AnotherUnitKeepsTheSelection) {
    dialog.setHistory(somePast());
    alarms->setCurrentItem(alarm("foot"));
    setReadersUnit(TemperatureUnit::Fahrenheit);
    dialog.retranslate();
    EXPECT_EQ(alarm("foot")->text(0), sentenceText(hot("foot", "96"), TemperatureUnit::Fahrenheit));
    EXPECT_EQ(alarms->currentItem(), alarm("foot"));
    EXPECT_EQ(runs->topLevelItemCount(), 1);
}

// Catches: a window that takes F12 from STOP.
TEST_F(AlarmHistoryDialogTest, StopIsHeardFromHere) {
    QWidget window;
    StopButton stop(&window);
    QSignalSpy requested(&stop, &StopButton::stopRequested);
    dialog.setHistory(somePast());
    EXPECT_FALSE(dialog.isModal());
    for (QWidget* part : {static_cast<QWidget*>(filter), static_cast<QWidget*>(runs)}) {
        part->setFocus();
        QTest::keyClick(part, Qt::Key_F12);
    }
    EXPECT_EQ(requested.count(), 2);
    EXPECT_TRUE(dialog.isVisible());
}

/// "hand" was hot once without a run, after the younger run, and "foot" before any run; the source heated by
/// itself without a run alone.
AlarmHistory somePastWithoutRun() {
    AlarmHistory past = somePast();
    const auto utc_s = [](const char* date) {
        return static_cast<double>(
            QDateTime::fromString(QLatin1String(date), Qt::ISODate).toSecsSinceEpoch());
    };
    past.alarms[0].withoutRun = {{hot("foot", "99"), 1, false, utc_s("2026-03-01T08:00:00Z"), 5.0}};
    past.alarms[1].withoutRun = {{hot("hand", "98"), 1, true, utc_s("2026-03-17T08:00:00Z"), 8.0}};
    PastAlarm source;
    source.withoutRun = {{{MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}},
                          1,
                          true,
                          utc_s("2026-03-17T09:00:00Z")}};
    past.alarms.push_back(source);
    return past;
}

// Catches: an alarm that came without a run and is in no row, an older one that is taken for the last, and a
// date in the time of another place.
TEST_F(AlarmHistoryDialogTest, AlarmsWithoutARunAreInTheTable) {
    dialog.setHistory(somePastWithoutRun());
    ASSERT_EQ(alarms->topLevelItemCount(), 4);
    EXPECT_EQ(cells(alarm("warmed")),
              (QStringList{"1", "0", "1", kNoValue, date("2026-03-17T09:00:00Z"), "No run"}));
    EXPECT_EQ(alarm("hand\"")->text(0), sentenceText(hot("hand", "98"))) << "as the last time";
    EXPECT_EQ(cells(alarm("hand\"")),
              (QStringList{"1", "2", "14", "1:00:10", date("2026-03-17T08:00:00Z"), "No run"}));
    EXPECT_EQ(alarm("foot")->text(0), sentenceText(hot("foot", "96")));
    EXPECT_EQ(cells(alarm("foot")).mid(1, 4),
              (QStringList{"1", "3", "0:34", date("2026-03-14T09:26:53Z") + " + 1:10"}));
    EXPECT_EQ(order().first(), "The") << "the gravest that was raised last: the source";
    EXPECT_TRUE(said("alarmHistorySummary").contains("3 time")) << said("alarmHistorySummary").toStdString();
}

// Catches: a time without a run that opens another run, or an empty one, by mouse, keyboard or button.
TEST_F(AlarmHistoryDialogTest, WhatHasNoRunIsNotOpened) {
    dialog.setHistory(somePastWithoutRun());
    QSignalSpy chosen(&dialog, &AlarmHistoryDialog::runChosen);
    alarms->setCurrentItem(alarm("hand\""));
    ASSERT_EQ(runs->topLevelItemCount(), 3);
    EXPECT_EQ(runs->topLevelItem(0)->text(0), date("2026-03-17T08:00:00Z")) << "the newest first";
    EXPECT_EQ(cells(runs->topLevelItem(0)), (QStringList{"No run", "LIVE", "1", "0:08", kNoValue}));
    EXPECT_FALSE(open->isEnabled());
    runs->setFocus();
    QTest::keyClick(runs, Qt::Key_Return);
    const QPoint first = runs->visualItemRect(runs->topLevelItem(0)).center();
    QTest::mouseClick(runs->viewport(), Qt::LeftButton, {}, first);
    QTest::mouseDClick(runs->viewport(), Qt::LeftButton, {}, first);
    EXPECT_EQ(chosen.count(), 0);
    runs->setCurrentItem(runs->topLevelItem(1));
    EXPECT_TRUE(open->isEnabled());
    QTest::mouseClick(open, Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.front().at(0).toString(), "/runs/younger.bask");
}

// Catches: alarms hidden where no run is listed, and a damaged file without a word.
TEST_F(AlarmHistoryDialogTest, WithoutAnyRunTheyAreShown) {
    AlarmHistory past;
    past.alarms = {somePastWithoutRun().alarms.back()};
    past.damagedLines = 2;
    dialog.setHistory(past);
    EXPECT_EQ(alarms->topLevelItemCount(), 1);
    EXPECT_TRUE(said("alarmHistorySummary").contains("1 time"));
    EXPECT_TRUE(said("alarmHistoryUnread").startsWith("2 line"));
    past = {};
    past.failure = Error(MessageCode::FileUnreadable, "/data/alarms-without-run.jsonl", {"access refused"});
    dialog.setHistory(past);
    EXPECT_TRUE(said("alarmHistoryUnread").contains("while nothing was recorded"));
    EXPECT_TRUE(dialog.findChild<QLabel*>("alarmHistoryUnread")
                    ->toolTip()
                    .startsWith("/data/alarms-without-run.jsonl: "));
}

} // namespace
} // namespace bask
