#include "widgets/common/alarm_list.h"

#include "engine/base/message_code.h"
#include "widgets/common/alarm_button.h"

#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTextEdit>
#include <QToolButton>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <algorithm>

using namespace bask;

namespace {

const QDateTime kNoon(QDate::currentDate(), QTime(12, 0, 5));

Alarm hot(std::uint64_t id, const std::string& name) {
    Alarm alarm;
    alarm.id = id;
    alarm.key = "SafetyObjectHot:" + name;
    alarm.message = {MessageCode::SafetyObjectHot, {name, "152.3", "150"}};
    alarm.raised_s = static_cast<double>(kNoon.toSecsSinceEpoch());
    return alarm;
}

class AlarmListTest : public testing::Test {
protected:
    QTreeWidget* tree() { return list.findChild<QTreeWidget*>(QStringLiteral("alarmListTree")); }
    QString cell(int row, int column) { return tree()->topLevelItem(row)->text(column); }
    QString guidance() { return list.findChild<QTextEdit*>(QStringLiteral("alarmGuidance"))->toPlainText(); }
    QPushButton* button(const char* name) { return list.findChild<QPushButton*>(QLatin1String(name)); }
    bool canAcknowledge() { return button("acknowledgeAlarm")->isEnabled(); }
    bool canAcknowledgeAll() { return button("acknowledgeAllAlarms")->isEnabled(); }
    void choose(int row) { tree()->setCurrentItem(tree()->topLevelItem(row)); }
    int chosenRow() {
        const auto items = tree()->selectedItems();
        return items.isEmpty() ? -1 : tree()->indexOfTopLevelItem(items.first());
    }

    AlarmList list;
};

// Catches: conditions and acknowledgement that cannot be told apart, in words or by their look; repeats, the
// first and those from before that nobody sees.
TEST_F(AlarmListTest, SaysWhatEachIs) {
    Alarm over = hot(2, "plate");
    over.isActive = false;
    over.isFromBefore = true;
    over.raised_s -= 86400.0;
    Alarm seen = hot(3, "foot");
    seen.isAcknowledged = true;
    seen.priority = 2;
    Alarm first = hot(1, "hand");
    first.isFirst = true;
    first.count = 3;
    list.setAlarms({first, over, seen});
    ASSERT_EQ(tree()->topLevelItemCount(), 3);
    EXPECT_EQ(cell(0, 1), QStringLiteral("Active, new, first"));
    EXPECT_EQ(cell(2, 1), QStringLiteral("Over, new, from before"));
    EXPECT_EQ(cell(1, 1), QStringLiteral("Active, seen"));
    EXPECT_EQ(cell(0, 2), QStringLiteral("12:00:05"));
    EXPECT_TRUE(cell(2, 2).endsWith(QStringLiteral(" 12:00:05"))) << cell(2, 2).toStdString();
    EXPECT_EQ(cell(0, 3), QStringLiteral("3×"));
    EXPECT_EQ(cell(2, 3), QString());
    EXPECT_TRUE(
        cell(0, 4).startsWith(QStringLiteral("\"hand\" is at 152.3\u00a0°C, above its trip limit of 150")));
    EXPECT_EQ(tree()->topLevelItem(1)->data(0, Qt::AccessibleTextRole).toString(),
              QStringLiteral("Priority 2"));
    EXPECT_FALSE(tree()->topLevelItem(1)->icon(0).isNull());
    const auto look = [&](int row) {
        const QFont font = tree()->topLevelItem(row)->font(1);
        return std::pair(font.bold(), font.italic());
    };
    EXPECT_EQ(look(0), std::pair(true, false));
    EXPECT_EQ(look(2), std::pair(false, true)) << "what is over does not call";
    EXPECT_NE(tree()->topLevelItem(2)->foreground(1), tree()->topLevelItem(0)->foreground(1));
    EXPECT_EQ(look(1), std::pair(false, false));

    choose(0);
    EXPECT_TRUE(guidance().contains(QStringLiteral("Reset when it has cooled.")));
    EXPECT_TRUE(guidance().contains(QStringLiteral("3 times since it was last acknowledged")));
    EXPECT_TRUE(guidance().contains(QStringLiteral("likely their cause")));
    choose(2);
    EXPECT_TRUE(guidance().contains(QStringLiteral("active when Bask was last left")));
    list.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_TRUE(cell(0, 4).contains(QStringLiteral("306.1\u00a0°F"))) << cell(0, 4).toStdString();
    EXPECT_TRUE(guidance().contains(QStringLiteral("°F")));
}

// Catches: a list that jumps under the person who reads it, or takes the keyboard, at every snapshot.
TEST_F(AlarmListTest, WhatIsChosenScrolledAndFocusedStays) {
    std::vector<Alarm> alarms;
    for (std::uint64_t id = 1; id <= 30; ++id)
        alarms.push_back(hot(id, "object " + std::to_string(id)));
    list.resize(700, 140);
    list.setAlarms(alarms);
    list.show();
    list.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&list));
    choose(11);
    tree()->verticalScrollBar()->setValue(7);
    tree()->setFocus();
    std::rotate(alarms.begin(), alarms.begin() + 29, alarms.end()); // the newest comes first
    alarms[0].count = 2;
    list.setAlarms(alarms);
    QCoreApplication::processEvents();
    EXPECT_EQ(chosenRow(), 12);
    EXPECT_TRUE(guidance().contains(QStringLiteral("object 12")));
    EXPECT_EQ(tree()->verticalScrollBar()->value(), 7);
    EXPECT_TRUE(tree()->hasFocus());

    button("acknowledgeAllAlarms")->setFocus();
    alarms.push_back(hot(31, "object 31"));
    list.setAlarms(alarms);
    EXPECT_TRUE(button("acknowledgeAllAlarms")->hasFocus());
    QSignalSpy changes(tree()->model(), &QAbstractItemModel::dataChanged);
    list.setAlarms(alarms); // the same again
    EXPECT_EQ(changes.count(), 0);
}

// Catches: an alarm acknowledged that nobody has read, since the next took the place of one that left; a
// button that stays pressable with nothing to acknowledge; one that names another alarm.
TEST_F(AlarmListTest, AcknowledgesTheChosenOneOnly) {
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    QSignalSpy all(&list, &AlarmList::acknowledgeAllRequested);
    EXPECT_FALSE(canAcknowledge() || canAcknowledgeAll());
    EXPECT_EQ(guidance(), QStringLiteral("No alarms."));
    list.setAlarms({hot(7, "hand")});
    EXPECT_EQ(chosenRow(), 0); // its guidance is seen at once
    list.setAlarms({hot(9, "foot"), hot(7, "hand")});
    EXPECT_EQ(chosenRow(), 1);
    QTest::mouseClick(button("acknowledgeAlarm"), Qt::LeftButton);
    ASSERT_EQ(one.count(), 1);
    EXPECT_EQ(one.first().first().toULongLong(), 7U);

    list.setAlarms({hot(9, "foot")});
    EXPECT_EQ(chosenRow(), -1);
    EXPECT_FALSE(canAcknowledge());
    EXPECT_TRUE(canAcknowledgeAll());
    EXPECT_EQ(guidance(), QStringLiteral("Choose an alarm to read what to do."));
    QTest::mouseClick(button("acknowledgeAllAlarms"), Qt::LeftButton);
    EXPECT_EQ(all.count(), 1);

    Alarm seen = hot(9, "foot");
    seen.isAcknowledged = true;
    list.setAlarms({seen});
    choose(0);
    EXPECT_FALSE(canAcknowledge() || canAcknowledgeAll());
}

// Catches: a selection that follows the row or the gravest alarm, so that Acknowledge hits another one than
// was read; one of a person that is taken away; and one that stays where there is nothing to acknowledge.
TEST_F(AlarmListTest, WhatIsSelectedStaysUntilItNeedsNothing) {
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    Alarm slight = hot(1, "hand"), grave = hot(2, "foot"), later = hot(3, "plate");
    slight.priority = 3;
    grave.raised_s += 1.0;
    later.raised_s += 2.0;
    list.setAlarms({slight});
    EXPECT_TRUE(guidance().contains(QStringLiteral("hand"))) << "nobody has clicked a line";
    later.priority = grave.priority = 2;
    list.setAlarms({grave, slight});
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << "a graver one came later";
    list.setAlarms({slight});
    grave.priority = later.priority = slight.priority;
    list.setAlarms({grave, slight});
    EXPECT_TRUE(guidance().contains(QStringLiteral("hand"))) << "one of the same priority";
    slight.isActive = false;
    list.setAlarms({later, grave, slight});
    EXPECT_EQ(chosenRow(), 2) << "it is over";
    ASSERT_TRUE(QTest::qWaitFor([&] { // what came has to be there for a while
        QTest::mouseClick(button("acknowledgeAlarm"), Qt::LeftButton);
        return one.count() == 1;
    }));
    EXPECT_EQ(one.first().first().toULongLong(), 1U);

    list.setAlarms({later, grave});
    EXPECT_EQ(chosenRow(), -1) << "a second click acknowledges nothing";
    later.count = 2;
    list.setAlarms({later, grave});
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << "the first of its priority";
    grave.isAcknowledged = true; // elsewhere
    list.setAlarms({later, grave});
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << "still the gravest";
    grave.isActive = false;
    list.setAlarms({later, grave});
    EXPECT_TRUE(guidance().contains(QStringLiteral("plate"))) << "the other needs nothing";
    choose(1);
    ASSERT_TRUE(guidance().contains(QStringLiteral("foot")));
    later.count = 4;
    list.setAlarms({later, grave});
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << "a person has chosen it";
    list.setAlarms({later});
    EXPECT_EQ(chosenRow(), -1);
}

// Catches a priority 1 that nobody reads, since a person once selected another that is over by now.
TEST_F(AlarmListTest, WhatIsDealtWithHidesNoGraverOne) {
    for (const int dealtWith : {0, 1, 2}) {
        Alarm slight = hot(1, "hand"), grave = hot(2, "foot");
        slight.priority = 2;
        list.setAlarms({slight});
        list.choose(slight.id); // as a person does
        list.setAlarms({grave, slight});
        EXPECT_TRUE(guidance().contains(QStringLiteral("hand"))) << "active, not seen: it stays";
        list.setAlarms({slight});
        slight.isActive = dealtWith != 0;
        slight.isAcknowledged = dealtWith == 1;
        slight.shelvedUntil_s = dealtWith == 2 ? 2.0e9 : 0.0;
        list.setAlarms({slight});
        EXPECT_TRUE(guidance().contains(QStringLiteral("hand")));
        list.setAlarms({grave, slight});
        EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << dealtWith;
        list.setAlarms({});
    }
}

// Catches: Space that acknowledges all alarms, since the button that had the keyboard cannot be pressed any
// more, and one that nobody can have read.
TEST_F(AlarmListTest, SpaceNeverAcknowledgesMoreThanTheOneThatWasRead) {
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    QSignalSpy all(&list, &AlarmList::acknowledgeAllRequested);
    const auto space = [] { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space); };
    list.show();
    list.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&list));
    Alarm slight = hot(1, "hand"), grave = hot(2, "foot");
    slight.priority = 3;
    list.setAlarms({slight});
    button("acknowledgeAlarm")->setFocus();
    list.setAlarms({grave, slight});
    ASSERT_TRUE(guidance().contains(QStringLiteral("foot"))) << "a graver one came";
    EXPECT_TRUE(button("acknowledgeAlarm")->hasFocus());
    space();
    EXPECT_EQ(one.count(), 0) << "nobody can have read it yet";
    EXPECT_TRUE(QTest::qWaitFor([&] {
        space();
        return one.count() > 0;
    }));
    EXPECT_EQ(one.first().first().toULongLong(), 2U);

    grave.isAcknowledged = true;
    list.setAlarms({grave, slight});
    ASSERT_FALSE(canAcknowledge());
    ASSERT_TRUE(canAcknowledgeAll());
    EXPECT_TRUE(tree()->hasFocus());
    space();
    EXPECT_EQ(all.count(), 0);
}

// Catches: a mark of priority that has the colour of the selected row.
TEST_F(AlarmListTest, TheMarkIsSeenInTheSelectedRow) {
    list.setAlarms({hot(1, "hand")});
    const QIcon icon = tree()->topLevelItem(0)->icon(0);
    const QImage selected = icon.pixmap(QSize(16, 16), 1.0, QIcon::Selected).toImage();
    const QImage usual = icon.pixmap(QSize(16, 16), 1.0, QIcon::Normal).toImage();
    ASSERT_EQ(selected.size(), usual.size());
    EXPECT_EQ(usual.pixelColor(1, 5).alpha(), 0);
    EXPECT_EQ(selected.pixelColor(1, 5), list.palette().color(QPalette::Base)) << "a ground of its own";
    EXPECT_EQ(selected.pixelColor(4, 14).rgb(), usual.pixelColor(4, 14).rgb()) << "and not tinted";
}

// Catches: old alarms shown as if they were of now.
TEST_F(AlarmListTest, OldAlarmsLookOldAndCannotBeAcknowledged) {
    list.setAlarms({hot(1, "hand")});
    ASSERT_TRUE(canAcknowledge() && canAcknowledgeAll());
    const QBrush before = tree()->topLevelItem(0)->foreground(4);
    list.setStale(true);
    EXPECT_FALSE(canAcknowledge() || canAcknowledgeAll());
    EXPECT_TRUE(guidance().contains(QStringLiteral("may be old")));
    EXPECT_NE(tree()->topLevelItem(0)->foreground(4), before);
    list.setStale(false);
    EXPECT_TRUE(canAcknowledge() && canAcknowledgeAll());
}

// Catches: ten rows for one lost link, what follows hidden for good, and one that is told where it belongs
// only while nothing changes.
TEST_F(AlarmListTest, WhatFollowsIsFoldedUnderItsCause) {
    Alarm cause = hot(1, "hand");
    Alarm first = hot(2, "foot"), second = hot(3, "plate");
    first.cause = second.cause = cause.key;
    list.setAlarms({cause, first, second});
    ASSERT_EQ(tree()->topLevelItemCount(), 1);
    EXPECT_EQ(tree()->topLevelItem(0)->childCount(), 2);
    EXPECT_FALSE(tree()->topLevelItem(0)->isExpanded());
    EXPECT_TRUE(cell(0, 1).startsWith(QStringLiteral("Active, new, 2 follow"))) << cell(0, 1).toStdString();
    EXPECT_TRUE(guidance().contains(QStringLiteral("hand"))) << "the cause is the one to read";
    tree()->topLevelItem(0)->setExpanded(true);
    cause.count = 2;
    list.setAlarms({hot(4, "ear"), cause, first, second});
    ASSERT_EQ(tree()->topLevelItemCount(), 2);
    EXPECT_FALSE(tree()->topLevelItem(0)->isExpanded());
    EXPECT_TRUE(tree()->topLevelItem(1)->isExpanded());
    tree()->setCurrentItem(tree()->topLevelItem(1)->child(1));
    EXPECT_TRUE(guidance().contains(QStringLiteral("plate"))) << guidance().toStdString();
    EXPECT_TRUE(guidance().contains(QStringLiteral("follows from the alarm over it")));
    EXPECT_FALSE(list.findChild<QToolButton*>(QStringLiteral("shelveAlarm"))->isEnabled());
    tree()->topLevelItem(1)->setExpanded(false);
    list.choose(3);
    EXPECT_TRUE(tree()->topLevelItem(1)->isExpanded()) << "a person has asked for it";
}

// Catches: the words of an alarm whose row is folded under another one's, so that Acknowledge is of nothing
// that is seen.
TEST_F(AlarmListTest, TheWordsAreThoseOfTheSelectedRow) {
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    const auto acknowledge = [&] { QTest::mouseClick(button("acknowledgeAlarm"), Qt::LeftButton); };
    Alarm hand = hot(1, "hand"), ear = hot(3, "ear");
    const Alarm cause = hot(2, "foot");
    ear.raised_s -= 1.0;
    list.setAlarms({hand});
    ASSERT_TRUE(guidance().contains(QStringLiteral("hand")));
    hand.cause = cause.key;
    list.setAlarms({cause, hand});
    EXPECT_EQ(chosenRow(), 0) << "the one that was selected has no row any more";
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << guidance().toStdString();
    acknowledge();
    EXPECT_EQ(one.count(), 0) << "nobody can have read it yet";
    ASSERT_TRUE(QTest::qWaitFor([&] {
        acknowledge();
        return one.count() > 0;
    }));
    EXPECT_EQ(one.first().first().toULongLong(), 2U);

    list.setAlarms({});
    hand.cause.clear();
    list.setAlarms({ear, hand});
    ASSERT_EQ(chosenRow(), 0);
    choose(1);
    hand.cause = cause.key;
    list.setAlarms({ear, cause, hand});
    QTreeWidgetItem* over = tree()->topLevelItem(1);
    EXPECT_TRUE(over->isExpanded()) << "a person has chosen what is under it";
    EXPECT_TRUE(over->child(0)->isSelected());
    EXPECT_TRUE(guidance().contains(QStringLiteral("hand"))) << guidance().toStdString();
    over->setExpanded(false);
    EXPECT_EQ(chosenRow(), 1);
    EXPECT_TRUE(guidance().contains(QStringLiteral("foot"))) << guidance().toStdString();
}

// Catches: an alarm put aside without a reason or for longer than its priority allows, one that is out of
// sight for good, and one that cannot be taken back.
TEST_F(AlarmListTest, IsShelvedWithAReasonListedAndTakenBack) {
    QSignalSpy shelved(&list, &AlarmList::shelveRequested);
    QSignalSpy back(&list, &AlarmList::unshelveRequested);
    list.resize(700, 140);
    list.show();
    Alarm alarm = hot(7, "hand");
    list.setAlarms({alarm});
    auto* shelve = list.findChild<QToolButton*>(QStringLiteral("shelveAlarm"));
    QTest::mouseClick(shelve, Qt::LeftButton);
    auto* popup = list.findChild<QWidget*>(QStringLiteral("shelfPopup"));
    ASSERT_TRUE(popup->isVisible());
    EXPECT_FALSE(button("shelve.15")->isEnabled()) << "no reason yet";
    auto* reason = popup->findChild<QLineEdit*>(QStringLiteral("shelfReason"));
    QTest::keyClicks(reason, QStringLiteral("  the fan is off "));
    EXPECT_TRUE(button("shelve.15")->isEnabled());
    EXPECT_FALSE(button("shelve.60")->isEnabled()) << "priority 1";
    QTest::mouseClick(button("shelve.15"), Qt::LeftButton);
    EXPECT_FALSE(popup->isVisible());
    ASSERT_EQ(shelved.count(), 1);
    EXPECT_EQ(shelved.first()[0].toULongLong(), 7U);
    EXPECT_EQ(shelved.first()[1].toDouble(), 900.0);
    EXPECT_EQ(shelved.first()[2].toString(), QStringLiteral("the fan is off"));

    alarm.shelvedUntil_s = alarm.raised_s + 900.0;
    alarm.shelfReason = "the fan is off";
    alarm.isAcknowledged = true;
    list.setAlarms({alarm, hot(8, "foot")});
    ASSERT_EQ(tree()->topLevelItemCount(), 2);
    EXPECT_TRUE(cell(0, 4).contains(QStringLiteral("foot")));
    QTreeWidgetItem* shelf = tree()->topLevelItem(1);
    EXPECT_EQ(shelf->text(0), QStringLiteral("Shelved: 1"));
    ASSERT_EQ(shelf->childCount(), 1);
    EXPECT_TRUE(shelf->isExpanded());
    EXPECT_EQ(shelf->child(0)->text(1), QStringLiteral("Shelved until 12:15:05: the fan is off"));
    EXPECT_FALSE(shelf->child(0)->font(4).bold());
    tree()->setCurrentItem(shelf->child(0));
    EXPECT_TRUE(shelve->accessibleName().contains(QStringLiteral("back")));
    QTest::mouseClick(shelve, Qt::LeftButton);
    ASSERT_EQ(back.count(), 1);
    EXPECT_EQ(back.first().first().toULongLong(), 7U);
    list.setAlarms({});
    EXPECT_EQ(tree()->topLevelItemCount(), 0);
}

// Catches: "Home it" in words alone, and a button that moves the robot beside any other alarm.
TEST_F(AlarmListTest, AnUnsurePlaceOffersHome) {
    QAction home;
    int homed = 0;
    QObject::connect(&home, &QAction::triggered, &home, [&] { ++homed; });
    list.setHomeAction(&home);
    list.resize(900, 160);
    list.show();
    const auto* button = list.findChild<QToolButton*>(QStringLiteral("homeFromAlarm"));
    Alarm place;
    place.id = 2;
    place.key = "RobotPlaceUnsure";
    place.message = {MessageCode::RobotPlaceUnsure, {}};
    list.setAlarms({hot(1, "hand"), place});
    choose(0);
    EXPECT_FALSE(button->isVisible());
    choose(1);
    ASSERT_TRUE(button->isVisible());
    home.trigger();
    EXPECT_EQ(homed, 1);
    home.setEnabled(false);
    EXPECT_FALSE(button->isEnabled());
    place.isActive = false;
    list.setAlarms({hot(1, "hand"), place});
    EXPECT_FALSE(button->isVisible()) << "it is over";
}

// Catches: a right click that does nothing, or works on another alarm than the one under the pointer.
TEST_F(AlarmListTest, ARightClickOffersWhatCanBeDone) {
    QSignalSpy history(&list, &AlarmList::historyRequested);
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    list.resize(900, 200);
    list.setAlarms({hot(1, "hand"), hot(2, "foot")});
    list.show();
    const QPoint second = tree()->visualItemRect(tree()->topLevelItem(1)).center();
    emit tree()->customContextMenuRequested(second);
    auto* menu = list.findChild<QMenu*>(QStringLiteral("alarmMenu"));
    ASSERT_NE(menu, nullptr);
    const auto act = [&](const char* words) {
        for (QAction* action : menu->actions())
            if (action->text() == QString::fromUtf8(words))
                return action->trigger();
        ADD_FAILURE() << words;
    };
    EXPECT_EQ(chosenRow(), 1);
    act("All alarms…");
    EXPECT_EQ(history.count(), 1);
    act("Acknowledge");
    ASSERT_EQ(one.count(), 1);
    EXPECT_EQ(one.first().first().toULongLong(), 2U);
    EXPECT_EQ(list.findChild<QToolButton*>(QStringLiteral("shelveAlarm"))->text(), QStringLiteral("Shelve…"));
    menu->close();
}

// Catches: a menu that stays open and works on the alarm that came meanwhile.
TEST_F(AlarmListTest, AMenuIsOfTheAlarmItWasOpenedFor) {
    QSignalSpy one(&list, &AlarmList::acknowledgeRequested);
    list.resize(900, 200);
    list.setAlarms({hot(1, "hand"), hot(2, "foot")});
    list.show();
    emit tree()->customContextMenuRequested(tree()->visualItemRect(tree()->topLevelItem(0)).center());
    auto* menu = list.findChild<QMenu*>(QStringLiteral("alarmMenu"));
    ASSERT_NE(menu, nullptr);
    ASSERT_TRUE(menu->isVisible());
    QAction* acknowledge = menu->actions().first();
    Alarm other = hot(2, "foot");
    other.count = 2;
    list.setAlarms({hot(1, "hand"), other});
    EXPECT_TRUE(menu->isVisible()) << "another line has changed";
    list.choose(2);
    EXPECT_FALSE(menu->isVisible());
    acknowledge->trigger(); // deleted by the event loop only
    EXPECT_EQ(one.count(), 0);
}

// Catches: bold red for what is over, and consequences and shelved ones counted.
TEST(AlarmButton, CallsOnlyForWhatStillIsSo) {
    const auto isCallingRed = [](AlarmButton& button) {
        button.resize(button.sizeHint());
        const QImage picture = button.grab().toImage();
        int red = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                const QColor pixel = picture.pixelColor(x, y);
                red += pixel.red() > 150 && pixel.green() < 90 && pixel.blue() < 90 ? 1 : 0;
            }
        return red > 20;
    };
    QWidget bar;
    AlarmButton button(&bar);
    Alarm cause = hot(1, "hand"), follows = hot(2, "foot"), over = hot(3, "plate"), shelved = hot(4, "ear");
    follows.cause = cause.key;
    over.isActive = false;
    shelved.shelvedUntil_s = 1e9;
    button.setAlarms({over, cause, follows, shelved});
    EXPECT_TRUE(button.text().contains(QStringLiteral("hand"))) << "it still is so";
    EXPECT_TRUE(button.accessibleName().endsWith(QStringLiteral(" 1 more.")))
        << button.accessibleName().toStdString();
    EXPECT_TRUE(isCallingRed(button));
    button.setAlarms({over, shelved});
    EXPECT_TRUE(button.text().contains(QStringLiteral("plate")));
    EXPECT_FALSE(isCallingRed(button));
    button.setAlarms({shelved});
    EXPECT_TRUE(button.isHidden());
}

// Catches: a button that keeps its room without alarms, hides how many there are, or says by colour alone
// what it is.
TEST(AlarmButton, ShowsTheFirstAndCountsTheOthers) {
    QWidget bar;
    AlarmButton button(&bar);
    QSignalSpy chosen(&button, &AlarmButton::alarmChosen);
    bar.show();
    EXPECT_FALSE(button.isVisible());
    button.setAlarms({hot(4, "hand"), hot(5, "foot"), hot(6, "plate")});
    EXPECT_TRUE(button.isVisible());
    EXPECT_EQ(button.text(),
              QStringLiteral("\"hand\" is at 152.3\u00a0°C, above its trip limit of 150.0\u00a0°C."));
    EXPECT_TRUE(button.accessibleName().startsWith(QStringLiteral("Alarm of priority 1 (Active, new): ")));
    EXPECT_TRUE(button.accessibleName().endsWith(QStringLiteral(" 2 more.")));
    const int withOthers = button.minimumSizeHint().width();
    EXPECT_LT(withOthers, 100);
    QTest::mouseClick(&button, Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.first().first().toULongLong(), 4U);
    button.setStale(true);
    EXPECT_TRUE(button.accessibleName().contains(QStringLiteral("may be old")));
    button.setAlarms({hot(4, "hand")});
    EXPECT_LT(button.minimumSizeHint().width(), withOthers);
    button.setAlarms({});
    EXPECT_FALSE(button.isVisible());
}

// Catches: an alarm of little weight on the bar because nobody has seen it yet, and a bar that falls silent
// beside it.
TEST(AlarmButton, ShowsTheGravestAndCallsForAny) {
    QWidget bar;
    AlarmButton button(&bar);
    QSignalSpy chosen(&button, &AlarmButton::alarmChosen);
    button.resize(400, 30);
    Alarm slight = hot(1, "hand"), grave = hot(2, "foot");
    slight.priority = 3;
    grave.isAcknowledged = true;
    button.setAlarms({slight, grave});
    EXPECT_TRUE(button.text().contains(QStringLiteral("foot")));
    bar.show();
    const QImage loud = button.grab().toImage();
    QTest::mouseClick(&button, Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.first().first().toULongLong(), 2U);
    slight.isAcknowledged = true;
    button.setAlarms({slight, grave});
    EXPECT_NE(button.grab().toImage(), loud) << "it still calls";
}

} // namespace
