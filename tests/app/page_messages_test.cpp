// How long a refusal is shown.

#include "app/page_messages.h"

#include "engine/base/message_code.h"
#include "tests/support/wait_for.h"
#include "widgets/common/message_bar.h"

#include <QPushButton>
#include <QTest>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

using namespace std::chrono_literals;

const QString kRefused = QStringLiteral("There is nothing to resume: no run is held.");

Snapshot in(RunState state) {
    Snapshot snapshot;
    snapshot.state = state;
    return snapshot;
}

} // namespace

// Catches: "There is nothing to resume" over a run that has begun since, in the same words.
TEST(PageMessages, ARefusalGoesWithItsState) {
    MessageBar bar;
    PageMessages messages(bar, 1h);
    messages.showWhile(kRefused, RunState::Ready);
    EXPECT_TRUE(messages.keepWhile(kRefused, RunState::Ready));
    EXPECT_EQ(bar.sentence(), kRefused);
    EXPECT_FALSE(messages.keepWhile(kRefused, RunState::Armed));
    EXPECT_EQ(bar.sentence(), QString());

    messages.showRefusal(kRefused, in(RunState::Ready), {MessageCode::CommandNotNow, {"resume", "Ready"}});
    messages.keepRefusal(in(RunState::Ready));
    EXPECT_EQ(bar.sentence(), kRefused);
    messages.keepRefusal(in(RunState::Running));
    EXPECT_EQ(bar.sentence(), QString());
}

// Catches: a refused Reset or Start without an answer, because its reason was told with another temperature
// with the next reading of the hot object.
TEST(PageMessages, ARefusalStaysWhileItsReasonChangesItsValue) {
    MessageBar bar;
    PageMessages messages(bar, 1h);
    const auto hot = [](const char* object, const char* value_degC) {
        return Message{MessageCode::SafetyObjectHot, {object, value_degC, "150"}};
    };
    Snapshot snapshot = in(RunState::Fault);
    snapshot.reasons = {hot("left", "195.7")};
    messages.showRefusal(kRefused, snapshot, hot("left", "195.7"));
    messages.keepRefusal(snapshot);
    snapshot.reasons = {hot("right", "160"), hot("left", "195.1")};
    messages.keepRefusal(snapshot);
    EXPECT_EQ(bar.sentence(), kRefused);
    snapshot.reasons.pop_back();
    messages.keepRefusal(snapshot);
    EXPECT_EQ(bar.sentence(), QString()) << "the other object is another reason";
}

// Catches: a refusal that stays for good where nothing happens any more, and another message that goes with
// it.
TEST(PageMessages, ARefusalGoesInTime) {
    QWidget page; // not shown: no pointer is over it
    MessageBar bar(&page);
    PageMessages messages(bar, 20ms);
    const auto isGone = [&] { return bar.sentence().isEmpty(); };
    messages.showWhile(kRefused, RunState::Ready);
    EXPECT_TRUE(waitFor(isGone));
    EXPECT_FALSE(messages.keepWhile(kRefused, RunState::Ready));
    messages.showRefusal(kRefused);
    EXPECT_TRUE(waitFor(isGone));
    messages.showRefusal(kRefused, in(RunState::Ready), {MessageCode::CommandNotNow, {"resume", "Ready"}});
    EXPECT_TRUE(waitFor(isGone));

    messages.showRefusal(kRefused);
    messages.showProblem(QStringLiteral("The file cannot be opened."));
    EXPECT_FALSE(waitFor(isGone, 100)) << "that is for a person to close";
}

// Catches: a note that stays for minutes over what is below it, and one for who comes back later that does
// not.
TEST(PageMessages, ANoteGoesInTime) {
    QWidget page;
    MessageBar bar(&page);
    PageMessages messages(bar, 20ms);
    const auto isGone = [&] { return bar.sentence().isEmpty(); };
    messages.showBriefly(QStringLiteral("The experiment is open as a new one."));
    EXPECT_TRUE(waitFor(isGone));
    messages.showOfEdit(QStringLiteral("Undone: title"));
    EXPECT_TRUE(waitFor(isGone));
    messages.showNote(QStringLiteral("The recipe has ended."));
    EXPECT_FALSE(waitFor(isGone, 100));
}

// Catches: "run.pdf written" that stays over the plots until it is closed by hand, one that goes while its
// buttons have the keyboard, and one that is over an armed rig.
TEST(PageMessages, WhatWasWrittenGoesInTimeAndWithArm) {
    QWidget page;
    auto* other = new QPushButton(&page);
    auto* bar = new MessageBar(&page);
    bar->move(100, 100); // away from the pointer
    const QString kWritten = QStringLiteral("run.pdf written to /home/somebody");
    const auto isGone = [&] { return bar->sentence().isEmpty(); };
    page.show();
    page.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&page));
    {
        PageMessages messages(*bar, 1h, 20ms);
        messages.showWritten(kWritten, QStringLiteral("Open"), QStringLiteral("Show in folder"));
        bar->findChild<QPushButton*>(QStringLiteral("messageAction"))->setFocus();
        EXPECT_FALSE(waitFor(isGone, 100));
        other->setFocus();
        EXPECT_TRUE(waitFor(isGone));
    }
    PageMessages messages(*bar, 1h, 1h);
    messages.dropWritten(RunState::Ready);
    messages.showWritten(kWritten, QStringLiteral("Open"), QStringLiteral("Show in folder"));
    messages.dropWritten(RunState::Ready);
    EXPECT_EQ(bar->sentence(), kWritten);
    messages.dropWritten(RunState::Armed);
    EXPECT_TRUE(isGone());
    messages.showWritten(kWritten, QStringLiteral("Open"), QStringLiteral("Show in folder"));
    messages.dropWritten(RunState::Armed);
    EXPECT_EQ(bar->sentence(), kWritten) << "written since";
    messages.showProblem(QStringLiteral("The file cannot be opened."));
    messages.dropWritten(RunState::Ready);
    messages.dropWritten(RunState::Armed);
    EXPECT_FALSE(isGone()) << "that is for a person to close";
}

// Catches: a refusal that goes while somebody reads it.
TEST(PageMessages, ARefusalStaysUnderThePointer) {
    MessageBar bar;
    PageMessages messages(bar, 10ms);
    bar.setAttribute(Qt::WA_UnderMouse);
    messages.showRefusal(kRefused);
    const auto isGone = [&] { return bar.sentence().isEmpty(); };
    EXPECT_FALSE(waitFor(isGone, 100));
    bar.setAttribute(Qt::WA_UnderMouse, false);
    EXPECT_TRUE(waitFor(isGone));
}

} // namespace bask::test
