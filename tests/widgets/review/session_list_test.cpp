#include "widgets/review/session_list.h"

#include "engine/base/message_code.h"
#include "widgets/common/theme.h"
#include "widgets/review/two_line_delegate.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDateTime>
#include <QElapsedTimer>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace bask {
namespace {

SessionHeader header(const char* name, const char* created, const char* outcome) {
    SessionHeader made;
    made.path = std::string("/runs/") + name + ".bask";
    made.title = std::string("title of ") + name;
    made.objects = {ListedObject{"circle"}};
    made.created = created;
    made.simulated = true;
    made.outcome = outcome;
    made.samples = 1234;
    made.end_s = 200.0;
    made.isVerified = true;
    return made;
}

struct SessionListTest : testing::Test {
    SessionList list;
    QTreeWidget* tree = list.findChild<QTreeWidget*>("sessionTree");
    QLineEdit* search = list.findChild<QLineEdit*>("sessionSearch");
    QLineEdit* tags = list.findChild<QLineEdit*>("sessionTags");

    SessionListTest() {
        SessionHeader a = header("a", "2026-03-14T09:26:53Z", "settled");
        a.notes = {"door opened"};
        a.tags = {"good", "paper"};
        a.labels = {"A. Hu", "plate 7", "B3"};
        SessionHeader b = header("b", "2026-03-15T09:26:53Z", "fault");
        b.simulated = false;
        const SessionHeader cut = header("cut", "2026-03-13T09:26:53Z", "");
        SessionHeader bad;
        bad.path = "/runs/bad.bask";
        bad.error = Error(MessageCode::SessionDamaged, bad.path, {"it is cut short"});
        list.setSessions({a, b, cut, bad});
        list.resize(500, 500);
        list.show();
        list.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&list));
    }
    QTreeWidgetItem* row(const char* name) {
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (tree->topLevelItem(k)->toolTip(0) == QString("/runs/%1.bask").arg(name))
                return tree->topLevelItem(k);
        return nullptr;
    }
    QStringList found() {
        QStringList paths;
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (!tree->topLevelItem(k)->isHidden())
                paths << tree->topLevelItem(k)->toolTip(0).mid(6).chopped(5);
        paths.sort();
        return paths;
    }
    /// The runs that are shown, from the top.
    QStringList order() {
        QStringList paths;
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (!tree->isRowHidden(k, {}))
                paths << tree->topLevelItem(k)->toolTip(0).mid(6).chopped(5);
        return paths;
    }
    void clickHeading(int column) {
        const QHeaderView* header = tree->header();
        const QPoint middle(header->sectionViewportPosition(column) + header->sectionSize(column) / 2,
                            header->height() / 2);
        ASSERT_TRUE(header->viewport()->rect().contains(middle)) << column;
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, middle);
    }
    /// Of the selected run, as by the menu key.
    QMenu* openMenu() {
        const QPoint at = tree->viewport()->rect().center();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, at, tree->viewport()->mapToGlobal(at));
        QApplication::sendEvent(tree->viewport(), &event);
        return list.findChild<QMenu*>("sessionMenu");
    }
    /// Chooses an entry; whether it is there and possible.
    static bool choose(QMenu* menu, const char* text) {
        for (QAction* entry : menu->actions())
            if (entry->text() == QLatin1String(text) && entry->isEnabled()) {
                entry->trigger();
                return true;
            }
        return false;
    }
    QString message() {
        auto* bar = list.findChild<QWidget*>("sessionMessage");
        return bar->isVisible() ? bar->findChild<QLabel*>("message")->text() : QString();
    }
};

// Catches columns without their facts, and outcomes that only an icon or only a colour tells.
TEST_F(SessionListTest, ARowTellsTheRun) {
    ASSERT_EQ(tree->topLevelItemCount(), 4);
    EXPECT_EQ(row("a")->text(1), "a") << "a person named its file so";
    EXPECT_EQ(row("a")->data(1, TwoLineDelegate::kDetailRole).toString(), "title of a");
    EXPECT_EQ(row("a")->text(2), "Settled");
    EXPECT_EQ(row("a")->text(3), "3:20");
    EXPECT_EQ(row("a")->text(4), "A. Hu");
    EXPECT_EQ(row("a")->text(5), "plate 7 / B3");
    EXPECT_FALSE(tree->isColumnHidden(4));
    EXPECT_EQ(row("a")->text(6), "SIMULATED");
    EXPECT_EQ(row("a")->text(7), "good, paper");
    EXPECT_EQ(row("b")->text(2), "Fault");
    EXPECT_EQ(row("b")->text(6), "LIVE");
    EXPECT_EQ(row("cut")->text(2), "Interrupted");
    EXPECT_EQ(row("bad")->text(2), "Damaged");
    for (const char* name : {"a", "b", "cut", "bad"})
        EXPECT_FALSE(row(name)->icon(2).isNull()) << name;
    tree->sortByColumn(0, Qt::DescendingOrder);
    EXPECT_EQ(tree->indexOfTopLevelItem(row("b")) + 1, tree->indexOfTopLevelItem(row("a")));
    EXPECT_EQ(list.findChild<QLabel*>("sessionCount")->text(), "4 session(s)")
        << "English plurals are a translation";
}

// Catches: the mark of the gravest alarm on a run that another one has ended, or of which nobody knows.
TEST_F(SessionListTest, AFaultHasTheMarkOfItsAlarm) {
    std::vector<SessionHeader> faults;
    for (const char* name : {"unknown", "first", "second", "third"}) {
        faults.push_back(header(name, "2026-03-15T09:26:53Z", "fault"));
        faults.back().endPriority = static_cast<int>(faults.size()) - 1;
    }
    list.setSessions(faults);
    const auto mark = [&](const char* name) {
        return row(name)->icon(2).pixmap(QSize(16, 16), 1.0).toImage();
    };
    const auto alarm = [&](int priority) { // of an alarm that is over: grey
        return alarmPixmap(priority, isDark(&list), 16, 1.0, true).toImage();
    };
    EXPECT_EQ(mark("first"), alarm(1));
    EXPECT_EQ(mark("second"), alarm(2));
    EXPECT_EQ(mark("third"), alarm(3));
    for (const int priority : {1, 2, 3})
        EXPECT_NE(mark("unknown"), alarm(priority));
    EXPECT_EQ(row("third")->text(2), "Fault");
    EXPECT_EQ(row("third")->toolTip(2), "Fault, by an alarm of priority 3");
    EXPECT_EQ(row("unknown")->data(2, Qt::AccessibleTextRole).toString(), "Fault");
}

// Catches: an outcome that nobody has verified and that looks, and is read out, as if it were.
TEST_F(SessionListTest, AnOutcomeIsInItalicsUntilItIsVerified) {
    SessionHeader unsure = header("unsure", "2026-03-15T09:26:53Z", "fault"),
                  sure = header("sure", "2026-03-15T09:26:53Z", "settled");
    unsure.isVerified = false;
    unsure.endPriority = 1;
    list.setSessions({unsure, sure});
    EXPECT_FALSE(row("sure")->font(2).italic());
    ASSERT_TRUE(row("unsure")->font(2).italic());
    EXPECT_EQ(row("unsure")->data(2, Qt::AccessibleTextRole).toString(),
              "Fault, by an alarm of priority 1, not verified");
    EXPECT_TRUE(row("unsure")->toolTip(2).startsWith("Fault, by an alarm of priority 1\nNot verified"));
    list.setVerified("/runs/unsure.bask");
    EXPECT_FALSE(row("unsure")->font(2).italic());
    EXPECT_EQ(row("unsure")->toolTip(2), "Fault, by an alarm of priority 1");
    list.setRecording("/runs/unsure.bask");
    EXPECT_FALSE(row("unsure")->font(2).italic());
}

// Catches an outcome told of a run whose samples cannot be read, and tags written into such a file.
TEST_F(SessionListTest, ADamagedRunHasNoOutcome) {
    SessionHeader hurt = header("hurt", "2026-03-14T09:26:53Z", "settled");
    hurt.damage = Error(MessageCode::SessionDamaged, hurt.path, {"its database is not whole"});
    SessionHeader gone;
    gone.path = "/runs/gone.bask";
    gone.error = Error(MessageCode::FileNotFound, gone.path);
    list.setSessions({hurt, gone});
    EXPECT_EQ(row("hurt")->text(2), "Damaged");
    EXPECT_EQ(row("gone")->text(2), "Unreadable");
    tree->setCurrentItem(row("hurt"));
    EXPECT_TRUE(message().contains("hurt.bask")) << message().toStdString();
    EXPECT_TRUE(list.findChild<QPushButton*>("sessionOpen")->isEnabled()) << "the rest can be seen";
    EXPECT_FALSE(tags->isEnabled());
}

// Catches a search that misses a field, or takes any word for all.
TEST_F(SessionListTest, TheSearchLooksIntoAll) {
    const std::pair<const char*, QStringList> cases[] = {
        {"DOOR", {"a"}},   {"paper", {"a"}},        {"title", {"a", "b", "cut"}},  {"bad.bask", {"bad"}},
        {"live", {"b"}},   {"door good", {"a"}},    {"hu plate", {"a"}},           {"b3", {"a"}},
        {"door live", {}}, {"circle fault", {"b"}}, {"", {"a", "b", "bad", "cut"}}};
    for (const auto& [text, wanted] : cases) {
        search->setText(text);
        EXPECT_EQ(found(), wanted) << text;
    }
    const QDateTime date = QDateTime::fromString("2026-03-15T09:26:53Z", Qt::ISODate).toLocalTime();
    search->setText(date.toString("yyyy-MM-dd HH:mm"));
    EXPECT_EQ(found(), QStringList{"b"}) << "when it was recorded, as the list shows it";
    search->setText("3:20");
    EXPECT_EQ(found(), (QStringList{"a", "b", "cut"})) << "how long it took";
}

// Catches a search that finds nothing and looks like an empty folder, or has to be cleared letter by letter.
TEST_F(SessionListTest, ASearchWithoutAnAnswerSaysSo) {
    search->setFocus();
    QTest::keyClicks(search, "door  live");
    EXPECT_TRUE(found().isEmpty());
    EXPECT_EQ(list.findChild<QLabel*>("sessionCount")->text(), "0 of 4 session(s)");
    EXPECT_EQ(message(), "No run matches \"door live\".");
    list.setReading(); // as when a run is recorded meanwhile
    list.setSessions({header("a", "2026-03-14T09:26:53Z", "settled")});
    EXPECT_EQ(message(), "No run matches \"door live\".");
    QSignalSpy close(&list, &SessionList::closeRequested);
    QTest::mouseClick(list.findChild<QPushButton*>("messageAction"), Qt::LeftButton);
    EXPECT_TRUE(search->text().isEmpty());
    EXPECT_TRUE(search->hasFocus());
    EXPECT_EQ(found(), QStringList{"a"});
    EXPECT_TRUE(message().isEmpty());
    EXPECT_EQ(close.count(), 0);
    list.setSessions({});
    search->setText("anything");
    EXPECT_TRUE(message().isEmpty()) << "the folder is empty, which is said already";
}

// Catches alarms asked for of other runs than those that a person sees.
TEST_F(SessionListTest, TheListedRunsAreThoseThatTheSearchHasLeft) {
    const auto listed = [this] {
        QStringList names;
        for (const SessionHeader& run : list.listed())
            names << QString::fromStdString(run.path).mid(6).chopped(5);
        names.sort();
        return names;
    };
    EXPECT_EQ(listed(), (QStringList{"a", "b", "bad", "cut"}));
    search->setText("live");
    EXPECT_EQ(listed(), QStringList{"b"});
    QSignalSpy asked(&list, &SessionList::alarmsRequested);
    QTest::mouseClick(list.findChild<QPushButton*>("sessionAlarms"), Qt::LeftButton);
    EXPECT_EQ(asked.count(), 1);
}

// Catches an order that is lost with the next recording, runs that are alike in any order, and an order that
// the next start does not have.
TEST_F(SessionListTest, TheChosenOrderStays) {
    const auto run = [](const char* name, const char* created, double end_s, const char* controller) {
        SessionHeader made = header(name, created, "settled");
        made.end_s = end_s;
        made.controller = controller;
        return made;
    };
    const std::vector<SessionHeader> runs{run("a", "2026-03-14T09:26:53Z", 300, "adaptive"),
                                          run("b", "2026-03-15T09:26:53Z", 100, "z-law"),
                                          run("c", "2026-03-13T09:26:53Z", 300, "adaptive")};
    list.resize(1300, 500);
    list.setSessions(runs);
    QApplication::processEvents();
    EXPECT_EQ(order(), (QStringList{"b", "a", "c"})) << "the newest first";
    QSignalSpy changed(&list, &SessionList::sortingChanged);
    ASSERT_NO_FATAL_FAILURE(clickHeading(3));
    EXPECT_EQ(order(), (QStringList{"b", "a", "c"})) << "the shortest first, of two the newer";
    ASSERT_NO_FATAL_FAILURE(clickHeading(3));
    EXPECT_EQ(order(), (QStringList{"a", "c", "b"})) << "the longest first, of two the newer";
    ASSERT_EQ(changed.count(), 2);
    EXPECT_EQ(changed[1][0].toString(), "duration descending");

    search->setText("adaptive");
    list.setRecording("/runs/new.bask");
    list.setReading();
    std::vector<SessionHeader> more = runs;
    more.push_back(run("new", "2026-03-16T09:26:53Z", 200, "adaptive"));
    list.setSessions(more);
    EXPECT_EQ(order(), (QStringList{"a", "c", "new"}));
    EXPECT_EQ(list.findChild<QLabel*>("sessionCount")->text(), "3 of 4 session(s)");
    search->clear();
    EXPECT_EQ(order(), (QStringList{"a", "c", "new", "b"}));

    SessionList next;
    next.setSorting(list.sorting());
    EXPECT_EQ(next.sorting(), "duration descending");
    next.setSorting("smell"); // of a settings file that somebody has changed
    EXPECT_EQ(next.sorting(), "duration descending");
}

// Catches a menu that is about another run, and an order that only the mouse can choose.
TEST_F(SessionListTest, TheMenuActsOnTheRunAndSorts) {
    QSignalSpy experiment(&list, &SessionList::experimentRequested);
    QSignalSpy opened(&list, &SessionList::sessionChosen);
    tree->setCurrentItem(row("b"));
    QMenu* menu = openMenu();
    ASSERT_NE(menu, nullptr);
    EXPECT_FALSE(choose(menu, "O&verlay")) << "there is none to lay it over";
    EXPECT_TRUE(choose(menu, "Open as &new experiment"));
    EXPECT_TRUE(choose(menu, "&Open"));
    menu->close();
    ASSERT_EQ(experiment.count(), 1);
    EXPECT_EQ(experiment[0][0].toString(), "/runs/b.bask");
    ASSERT_EQ(opened.count(), 1);
    EXPECT_EQ(opened[0][0].toString(), "/runs/b.bask");

    tree->setCurrentItem(row("bad"));
    menu = openMenu();
    ASSERT_NE(menu, nullptr);
    EXPECT_FALSE(choose(menu, "Open as &new experiment")) << "it cannot be read";
    auto* sorting = menu->findChild<QMenu*>("sessionSorting");
    ASSERT_NE(sorting, nullptr);
    EXPECT_TRUE(choose(sorting, "Operator"));
    menu->close();
    EXPECT_EQ(list.sorting(), "operator");
    EXPECT_EQ(order().last(), "a") << "of the others nobody has told the operator";
    menu = openMenu();
    sorting = menu->findChild<QMenu*>("sessionSorting");
    EXPECT_TRUE(choose(sorting, "Operator"));
    menu->close();
    EXPECT_EQ(list.sorting(), "operator descending");
    EXPECT_EQ(order(), (QStringList{"a", "b", "cut", "bad"}));
}

// Catches a column that says the same in every row, and one that is missing where it tells runs apart.
TEST_F(SessionListTest, ControllersAreAColumnWhereTheyDiffer) {
    constexpr int kControllers = 8;
    const auto under = [](const char* name, const char* controller) {
        SessionHeader made = header(name, "2026-03-14T09:26:53Z", "settled");
        made.controller = controller;
        return made;
    };
    SessionHeader bad;
    bad.path = "/runs/bad.bask";
    bad.error = Error(MessageCode::SessionDamaged, bad.path, {"it is cut short"});
    list.setSessions({under("a", "adaptive"), under("b", "adaptive"), bad});
    EXPECT_TRUE(tree->isColumnHidden(kControllers));
    list.setSessions({under("a", "adaptive"), under("b", "z-law"), bad});
    EXPECT_FALSE(tree->isColumnHidden(kControllers));
    EXPECT_EQ(row("a")->text(kControllers), "Adaptive");
    EXPECT_EQ(row("b")->text(kControllers), "z-law");
    EXPECT_LT(tree->header()->visualIndex(kControllers), tree->header()->visualIndex(7)) << "before the tags";
}

// Catches a damaged file without its reason, and one that can be opened all the same.
TEST_F(SessionListTest, ADamagedFileSaysWhy) {
    QSignalSpy chosen(&list, &SessionList::sessionChosen);
    tree->setCurrentItem(row("bad"));
    EXPECT_TRUE(message().contains("cut short")) << message().toStdString();
    EXPECT_FALSE(list.findChild<QPushButton*>("sessionOpen")->isEnabled());
    EXPECT_FALSE(tags->isEnabled());
    emit tree->itemActivated(row("bad"), 0);
    EXPECT_EQ(chosen.count(), 0);
    tree->setCurrentItem(row("a"));
    EXPECT_TRUE(message().isEmpty());
    emit tree->itemActivated(row("a"), 0);
    QTest::mouseClick(list.findChild<QPushButton*>("sessionOpen"), Qt::LeftButton);
    ASSERT_EQ(chosen.count(), 2);
    EXPECT_EQ(chosen[0][0].toString(), "/runs/a.bask");
}

// Catches an interrupted run that says nothing of what is there and what is missing, or cannot be closed.
TEST_F(SessionListTest, AnInterruptedRunSaysWhatIsMissingAndIsClosed) {
    tree->setCurrentItem(row("cut"));
    for (const char* part : {"1234", "3:20", "0.5 s"})
        EXPECT_TRUE(message().contains(part)) << part << ": " << message().toStdString();
    EXPECT_FALSE(tags->isEnabled()) << "it may be being recorded into";
    QSignalSpy close(&list, &SessionList::closeRequested);
    QTest::mouseClick(list.findChild<QWidget*>("sessionMessage")->findChild<QPushButton*>("messageAction"),
                      Qt::LeftButton);
    ASSERT_EQ(close.count(), 1);
    EXPECT_EQ(close[0][0].toString(), "/runs/cut.bask");
    list.setRecording("/runs/cut.bask");
    EXPECT_EQ(row("cut")->text(2), "Recording");
    EXPECT_FALSE(message().contains("0.5 s"));
    EXPECT_FALSE(list.findChild<QPushButton*>("messageAction")->isVisible()) << "it is on";
}

// Catches tags that go to another session than they were typed for.
TEST_F(SessionListTest, TagsBelongToTheRunTheyWereTypedFor) {
    QSignalSpy edited(&list, &SessionList::tagsEdited);
    tree->setCurrentItem(row("a"));
    ASSERT_TRUE(tags->isEnabled());
    EXPECT_EQ(tags->text(), "good, paper");
    tags->setFocus();
    tags->setText(" paper,  new  one,,paper ");
    QTest::keyClick(tags, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_EQ(edited[0][0].toString(), "/runs/a.bask");
    EXPECT_EQ(edited[0][1].toStringList(), (QStringList{"paper", "new one"}));
    QTest::keyClick(tags, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 1) << "nothing changed since";
    tree->setCurrentItem(row("b"));
    tags->setFocus();
    tags->setText("x");
    tree->setFocus(); // as a click on another row does
    tree->setCurrentItem(row("a"));
    ASSERT_EQ(edited.count(), 2);
    EXPECT_EQ(edited[1][0].toString(), "/runs/b.bask");
}

// Catches: nobody sees which of the runs is the one on the page.
TEST_F(SessionListTest, TheRunOnThePageIsMarkedAndChosen) {
    const auto isMarked = [&](const char* title) { return row(title)->font(1).bold(); };
    list.setOpened("/runs/b.bask");
    EXPECT_TRUE(isMarked("b"));
    EXPECT_FALSE(isMarked("a"));
    EXPECT_EQ(tree->currentItem(), row("b"));
    list.setRecording("/runs/new.bask"); // its rows are made anew
    EXPECT_TRUE(isMarked("b"));
    list.setOpened({});
    EXPECT_FALSE(isMarked("b"));
}

// Catches tags, Open and Overlay that go to a run which the search has hidden.
TEST_F(SessionListTest, WhatTheSearchHidesIsNotSelected) {
    QSignalSpy edited(&list, &SessionList::tagsEdited);
    list.setOpened("/runs/b.bask");
    tree->setCurrentItem(row("a"));
    search->setFocus();
    search->setText("live");
    ASSERT_EQ(found(), QStringList{"b"});
    EXPECT_FALSE(tags->isEnabled());
    EXPECT_TRUE(tags->text().isEmpty());
    for (const char* button : {"sessionOpen", "sessionCompare"})
        EXPECT_FALSE(list.findChild<QPushButton*>(button)->isEnabled()) << button;
    emit tags->editingFinished();
    EXPECT_EQ(edited.count(), 0);
    search->clear();
    EXPECT_EQ(tags->text(), "good, paper");
    EXPECT_TRUE(list.findChild<QPushButton*>("sessionOpen")->isEnabled());
}

// Catches a list in which Ctrl and a click leave one run selected, and several that cannot be laid over each
// other without opening one first.
TEST_F(SessionListTest, SeveralSelectedRunsAreLaidOverEachOther) {
    QSignalSpy compared(&list, &SessionList::comparisonRequested),
        added(&list, &SessionList::compareRequested);
    auto* overlay = list.findChild<QPushButton*>("sessionCompare");
    const auto click = [&](const char* name, Qt::KeyboardModifiers keys) {
        tree->scrollToItem(row(name));
        QTest::mouseClick(tree->viewport(), Qt::LeftButton, keys, tree->visualItemRect(row(name)).center());
    };
    click("a", {});
    EXPECT_FALSE(overlay->isEnabled()) << "over what";
    click("b", Qt::ControlModifier);
    EXPECT_TRUE(row("a")->isSelected() && row("b")->isSelected());
    ASSERT_TRUE(overlay->isEnabled());
    QTest::mouseClick(overlay, Qt::LeftButton);
    ASSERT_EQ(compared.count(), 1);
    const bool isAFirst = tree->indexOfTopLevelItem(row("a")) < tree->indexOfTopLevelItem(row("b"));
    const QString first = isAFirst ? "/runs/a.bask" : "/runs/b.bask";
    const QString second = isAFirst ? "/runs/b.bask" : "/runs/a.bask";
    EXPECT_EQ(compared.first().at(0).toString(), first);
    EXPECT_EQ(compared.first().at(1).toStringList(), QStringList{second});
    EXPECT_EQ(added.count(), 0);

    list.setOpened(first);
    click("a", {});
    click("b", Qt::ControlModifier);
    QTest::mouseClick(overlay, Qt::LeftButton);
    ASSERT_EQ(added.count(), 1) << "not the open one over itself";
    EXPECT_EQ(added.first().at(0).toString(), second);
}

// Catches outcomes and durations that are cut short, also when longer ones come later.
TEST_F(SessionListTest, OutcomesAreNotCutShort) {
    list.setSessions({header("a", "2026-03-14T09:26:53Z", "fault")});
    SessionHeader bad = header("bad", "2026-03-14T09:26:53Z", "");
    bad.error = Error(MessageCode::SessionDamaged, bad.path, {"it is cut short"});
    SessionHeader longest = header("b", "2026-03-15T09:26:53Z", "settled");
    longest.end_s = 360000.0;
    list.setSessions({header("cut", "2026-03-13T09:26:53Z", ""), bad, longest});
    QApplication::processEvents();
    for (int k = 0; k < tree->topLevelItemCount(); ++k)
        for (const int column : {2, 3}) {
            const QString text = tree->topLevelItem(k)->text(column);
            const int mark = column == 2 ? 20 : 0;
            EXPECT_GE(tree->columnWidth(column), tree->fontMetrics().horizontalAdvance(text) + mark)
                << text.toStdString();
        }
    EXPECT_EQ(row("b")->toolTip(2), "Settled");
    EXPECT_TRUE(tree->headerItem()->toolTip(2).contains("Damage")) << "what the word does not promise";
}

// Catches a selection that is lost, or another run's, when the folder is read again.
TEST_F(SessionListTest, TheSelectionStaysWhenTheListIsReadAgain) {
    tree->setCurrentItem(row("cut"));
    list.setSessions({header("new", "2026-03-16T09:26:53Z", "settled"),
                      header("cut", "2026-03-13T09:26:53Z", "interrupted")});
    ASSERT_NE(tree->currentItem(), nullptr);
    EXPECT_EQ(tree->currentItem()->toolTip(0), "/runs/cut.bask");
    EXPECT_TRUE(message().isEmpty()) << "it has its end";
    EXPECT_TRUE(tags->isEnabled());
    list.setSessions({});
    EXPECT_EQ(list.findChild<QLabel*>("sessionCount")->text(), "No recorded runs in this folder.");
}

// Catches runs of one experiment that look alike, a second line that is cut off, is not told to a screen
// reader or stays in the old unit, and rows that are higher without one.
TEST_F(SessionListTest, RunsOfOneExperimentAreToldApart) {
    const auto named = [](const char* name, double target_degC, const char* title) {
        SessionHeader made = header(name, "2026-03-14T09:26:53Z", "settled");
        made.title = title;
        made.objects = {ListedObject{"hand", kelvinFromCelsius(target_degC)}};
        return made;
    };
    const char *first = "20260314T092653Z", *second = "20260314T102653Z", *other = "20260314T112653Z";
    const auto detail = [&](const char* name) {
        return row(name)->data(1, TwoLineDelegate::kDetailRole).toString().replace(QChar(0x00a0), ' ');
    };
    list.setSessions({named(first, 40, "paper"), named(other, 40, "warm-up")});
    const int one = tree->visualItemRect(tree->topLevelItem(0)).height();
    EXPECT_EQ(row(first)->text(1), "paper");
    EXPECT_EQ(detail(first), "");
    list.setSessions({named(first, 40, "paper"), named(second, 55, "paper"), named("figure 3", 55, "paper"),
                      named(other, 40, "warm-up")});
    EXPECT_EQ(row(second)->text(1), "paper");
    EXPECT_EQ(detail(first).toStdString(), "hand 40.0 °C");
    EXPECT_EQ(detail(second).toStdString(), "hand 55.0 °C");
    EXPECT_EQ(row("figure 3")->text(1), "figure 3") << "a copy that was saved under that name";
    EXPECT_EQ(detail("figure 3").toStdString(), "paper · hand 55.0 °C");
    EXPECT_EQ(detail(other), "");
    EXPECT_TRUE(row(first)->data(1, Qt::AccessibleTextRole).toString().contains("40.0"));
    EXPECT_TRUE(row(first)->toolTip(1).contains("40.0"));
    const int line = tree->fontMetrics().height();
    for (int k = 0; k < 4; ++k)
        EXPECT_GE(tree->visualItemRect(tree->topLevelItem(k)).height(), one + line - 1) << k;
    EXPECT_TRUE(list.grab().save("session_list_differences.png"));
    search->setText("55.0");
    EXPECT_EQ(found(), (QStringList{second, "figure 3"})) << "what the second line shows";
    search->clear();
    list.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(detail(second).toStdString(), "hand 328.2 K");
    search->setText("paper");
    EXPECT_EQ(found(), (QStringList{first, second, "figure 3"}));
    search->clear();
    list.setSessions({named(first, 40, "paper")});
    EXPECT_EQ(tree->visualItemRect(tree->topLevelItem(0)).height(), one);
}

// Catches a year of a lab that makes the window wait, when it comes or while it is scrolled.
TEST_F(SessionListTest, TenThousandRunsAreShownAndScrolled) {
    std::vector<SessionHeader> year;
    for (int k = 0; k < 10'000; ++k) {
        SessionHeader made = header(qPrintable(QString("20260314T%1Z").arg(k, 6, 10, QChar(u'0'))),
                                    "2026-03-14T09:26:53Z", "settled");
        made.title = k % 3 == 0 ? "paper" : "warm-up";
        made.objects.clear();
        for (const char* name : {"one", "two", "three", "four", "five", "six", "seven", "eight"})
            made.objects.push_back({name, 313.15 + k % 40, "painted aluminium", 0.9});
        year.push_back(std::move(made));
    }
    QElapsedTimer timer;
    timer.start();
    list.setSessions(year);
    QApplication::processEvents();
    RecordProperty("shown_ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 20'000);
    timer.restart();
    for (int k = 0; k < 10'000; k += 100) {
        tree->scrollToItem(tree->topLevelItem(k));
        tree->viewport()->repaint();
    }
    RecordProperty("hundred_scrolls_ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 20'000);
    timer.restart();
    list.setOpened("/runs/20260314T000007Z.bask");
    RecordProperty("opened_ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 5'000);
    EXPECT_TRUE(row("20260314T000007Z")->font(1).bold());
}

// Catches a search or an order of a year's runs that leaves some out, after each letter and each recording.
TEST_F(SessionListTest, TenThousandRunsAreSearchedAndSorted) {
    std::vector<SessionHeader> year;
    for (int k = 0; k < 10'000; ++k) {
        SessionHeader made = header(qPrintable(QString("20260314T%1Z").arg(k, 6, 10, QChar(u'0'))),
                                    "2026-03-14T09:26:53Z", "settled");
        made.title = k % 3 == 0 ? "paper" : "warm-up";
        made.labels.operatorName = k % 7 == 0 ? "A. Hu" : "B. Roy";
        made.end_s = 1 + k * 7919 % 10'007; // each another one
        year.push_back(std::move(made));
    }
    list.setSessions(year);
    list.setSorting("duration descending");
    QString typed;
    for (const QChar letter : QStringLiteral("paper hu")) {
        typed += letter;
        QTest::keyClick(search, letter.toLatin1());
        ASSERT_EQ(search->text(), typed);
    }
    const auto shownOf = [&] {
        std::vector<SessionHeader> wanted;
        std::ranges::copy_if(year, std::back_inserter(wanted), [](const SessionHeader& each) {
            return each.title == "paper" && each.labels.operatorName == "A. Hu";
        });
        std::ranges::sort(wanted, std::ranges::greater(), &SessionHeader::end_s);
        QStringList names;
        for (const SessionHeader& each : wanted)
            names << QString::fromStdString(each.path).mid(6).chopped(5);
        return names;
    };
    EXPECT_EQ(order().size(), 477);
    EXPECT_EQ(order(), shownOf());
    year[21].end_s = 20'000.0; // the next recording
    list.setSessions(year);
    EXPECT_EQ(order(), shownOf());
    EXPECT_EQ(order().first(), "20260314T000021Z");
    search->clear();
    EXPECT_EQ(order().size(), 10'000);
}

// Catches a list that makes the window wait when there are many.
TEST_F(SessionListTest, ManyRunsAreShownAtOnce) {
    std::vector<SessionHeader> many;
    for (int k = 0; k < 500; ++k)
        many.push_back(header(qPrintable(QString("run%1").arg(k)), "2026-03-16T09:26:53Z", "settled"));
    QElapsedTimer timer;
    timer.start();
    list.setSessions(many);
    search->setText("run49");
    RecordProperty("ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 5000);
    EXPECT_EQ(found().size(), 11);
}

} // namespace
} // namespace bask
