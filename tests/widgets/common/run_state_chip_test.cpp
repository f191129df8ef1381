#include "widgets/common/run_state_chip.h"

#include "engine/base/message_code.h"
#include "widgets/common/display.h"

#include <QAction>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace bask;

// Catches a chip that shows a state but not why, or lists reasons of an earlier state.
TEST(RunStateChip, ClickListsEachReasonWithItsRemedy) {
    RunStateChip chip;
    const QString first = QStringLiteral("No experiment is loaded. Open one or make a new one.");
    const QString second = QStringLiteral("The source is not at its temperature yet. Wait until it is warm.");
    chip.setState(RunState::NotReady, {first, second});
    chip.show();
    EXPECT_EQ(chip.text(), QStringLiteral("Not ready (2)"));
    EXPECT_TRUE(chip.accessibleName().contains(QStringLiteral("Not ready")));

    QTest::mouseClick(&chip, Qt::LeftButton);
    QMenu* menu = chip.reasonsMenu();
    ASSERT_TRUE(menu->isVisible());
    ASSERT_EQ(menu->actions().size(), 2);
    EXPECT_EQ(menu->actions()[0]->text(), first);
    EXPECT_EQ(menu->actions()[1]->text(), second);

    QSignalSpy chosen(&chip, &RunStateChip::reasonActivated);
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Down);
    QTest::keyClick(menu, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen.first().first().toInt(), 1);
    menu->close();

    chip.setState(RunState::Ready, {});
    EXPECT_EQ(chip.text(), QStringLiteral("Ready"));
    ASSERT_EQ(menu->actions().size(), 1) << "says in words that nothing stands in the way";
}

// Catches "Nothing stands in the way" of what Arm or Start will ask about, and words that outlive it.
TEST(RunStateChip, WhatIsAskedStandsInPlaceOfItsSentence) {
    RunStateChip chip;
    chip.setState(RunState::Ready, {});
    const auto line = [&] { return chip.reasonsMenu()->actions().front()->text(); };
    const QString own = runStateExplanation(RunState::Ready), asked = QStringLiteral("Ready, but: Arm asks.");
    EXPECT_EQ(line(), own);
    chip.setExplanation(asked);
    EXPECT_EQ(line(), asked);
    EXPECT_TRUE(chip.toolTip().startsWith(asked));
    EXPECT_FALSE(chip.toolTip().contains(own));
    EXPECT_EQ(chip.accessibleDescription(), asked);
    const QString reason = QStringLiteral("No experiment is loaded.");
    chip.setState(RunState::NotReady, {reason});
    EXPECT_EQ(line(), reason);
    chip.setState(RunState::Ready, {});
    chip.setExplanation({});
    EXPECT_EQ(line(), own);
}

// Catches a remedy that is chosen and does nothing, and lines that look as if something could be done.
TEST(RunStateChip, TheRemedyIsTheVerbItself) {
    RunStateChip chip;
    QAction reset(QStringLiteral("Reset"));
    QSignalSpy done(&reset, &QAction::triggered);
    const QString remedy = QStringLiteral("Reset when the rig is safe.");
    chip.setState(RunState::Fault, {QStringLiteral("STOP was pressed.")});
    chip.setRemedy(remedy, &reset);
    const auto lines = [&] { return chip.reasonsMenu()->actions(); };
    ASSERT_EQ(lines().size(), 4) << "reason, separator, remedy, verb";
    EXPECT_TRUE(lines()[0]->isEnabled());
    EXPECT_EQ(lines()[2]->text(), remedy);
    EXPECT_FALSE(lines()[2]->isEnabled()) << "a sentence only";
    EXPECT_TRUE(chip.accessibleDescription().contains(remedy));
    ASSERT_EQ(lines()[3], &reset);
    lines()[3]->trigger();
    EXPECT_EQ(done.count(), 1);
    chip.setRemedy(QStringLiteral("Reset is possible when this is over."), nullptr);
    EXPECT_FALSE(lines().contains(&reset));
    chip.setState(RunState::Stopped, {});
    chip.setRemedy({}, nullptr);
    chip.setNotes({QStringLiteral("The camera was calibrated long ago.")});
    for (const QAction* line : lines())
        EXPECT_TRUE(line->isSeparator() || !line->isEnabled()) << line->text().toStdString();
}

// Catches a state told by colour alone: the pictures of any two states differ also in shades of grey.
TEST(RunStateChip, StatesDifferWithoutColour) {
    QList<QImage> seen;
    for (int i = static_cast<int>(RunState::Idle); i <= static_cast<int>(RunState::Fault); ++i) {
        RunStateChip chip;
        chip.setState(static_cast<RunState>(i), {});
        chip.resize(chip.sizeHint());
        const QImage picture = chip.grab().toImage().convertToFormat(QImage::Format_Grayscale8);
        EXPECT_FALSE(seen.contains(picture)) << "state " << i;
        seen << picture;
    }
}

// Catches a 2 on the state beside a 3 on the alarm that it is for.
TEST(RunStateChip, HasThePriorityOfItsGravestReason) {
    EXPECT_EQ(statePriority(RunState::Holding), 2);
    EXPECT_EQ(statePriority(RunState::Holding, 3), 3);
    EXPECT_EQ(statePriority(RunState::Fault, 3), 3);
    EXPECT_EQ(statePriority(RunState::NotReady, 1), 1);
    EXPECT_EQ(statePriority(RunState::Running, 2), 0);
    RunStateChip chip;
    chip.resize(chip.sizeHint());
    chip.setState(RunState::Holding, {QStringLiteral("a")}, 2);
    const QImage two = chip.grab().toImage();
    chip.setState(RunState::Holding, {QStringLiteral("a")}, 3);
    EXPECT_NE(chip.grab().toImage(), two);
}

// Catches "Fault (latched)", or what was told last, of an engine that tells nothing.
TEST(RunStateChip, UnknownIsAStateOfItsOwn) {
    RunStateChip chip, fault;
    chip.setState(RunState::Running, {});
    chip.setUnknown(QStringLiteral("The engine is not answering."));
    fault.setState(RunState::Fault, {QStringLiteral("The engine is not answering.")});
    EXPECT_EQ(chip.text(), QStringLiteral("UNKNOWN"));
    EXPECT_TRUE(chip.isUnknown());
    EXPECT_TRUE(chip.toolTip().contains(QStringLiteral("not answering")));
    EXPECT_EQ(chip.sizeHint(), fault.sizeHint());
    chip.resize(chip.sizeHint());
    fault.resize(fault.sizeHint());
    EXPECT_NE(chip.grab().toImage().convertToFormat(QImage::Format_Grayscale8),
              fault.grab().toImage().convertToFormat(QImage::Format_Grayscale8));
    chip.setState(RunState::Running, {});
    EXPECT_FALSE(chip.isUnknown());
    EXPECT_EQ(chip.text(), QStringLiteral("Running"));
}

// Catches "Ready" alone over a hot plate, and a bar that jumps with what is said besides.
TEST(RunStateChip, TheCaptionIsSaidAndTakesNoRoom) {
    RunStateChip chip;
    chip.setState(RunState::Ready, {});
    const QSize size = chip.sizeHint();
    chip.resize(size);
    const QImage without = chip.grab().toImage();
    chip.setCaption(QStringLiteral("source 212 °C below"));
    EXPECT_EQ(chip.sizeHint(), size);
    EXPECT_NE(chip.grab().toImage(), without);
    EXPECT_TRUE(chip.accessibleName().contains(QStringLiteral("Ready, source 212 °C below")));
}

// Catches a word that is cut where it is needed: in a fault, beside a count and a caption, in a narrow bar.
TEST(RunStateChip, TheWordOfAStateIsWholeHoweverNarrow) {
    RunStateChip chip, alone;
    for (const bool isCompact : {false, true}) {
        chip.setCompact(isCompact);
        chip.resize(chip.sizeHint());
        alone.resize(chip.size());
        chip.setCaption(QStringLiteral("over hot source: 160 °C"));
        chip.setState(RunState::Fault, QStringList(12, QStringLiteral("STOP was pressed.")));
        alone.setCompact(isCompact);
        alone.setState(RunState::Fault, {});
        QFont bold = chip.font();
        bold.setBold(true);
        const int needed = QFontMetrics(bold).horizontalAdvance(runStateWord(RunState::Fault));
        if (needed > chip.width() - 54) { // it takes both lines, and the caption gives way
            EXPECT_EQ(chip.grab().toImage(), alone.grab().toImage()) << isCompact;
        } else {
            EXPECT_NE(chip.grab().toImage(), alone.grab().toImage()) << isCompact;
        }
    }
}

// Catches a narrow bar whose verbs slide under the hand with every state.
TEST(RunStateChip, KeepsItsWidthWhereItIsNarrow) {
    RunStateChip chip;
    chip.setCompact(true);
    chip.setState(RunState::Idle, {});
    const int idle = chip.sizeHint().width();
    chip.setState(RunState::Fault, {QStringLiteral("a"), QStringLiteral("b")});
    EXPECT_EQ(chip.sizeHint().width(), idle);
}

// Catches a state bar that jumps when the state changes.
TEST(RunStateChip, KeepsItsWidth) {
    RunStateChip chip;
    chip.setState(RunState::Idle, {});
    const int idle = chip.sizeHint().width();
    chip.setState(RunState::Fault, {});
    EXPECT_EQ(chip.sizeHint().width(), idle);
}
