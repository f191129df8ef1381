#include "app/undo_actions.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

struct UndoActionsTest : testing::Test {
    QWidget window;
    QAction undo, redo;
    Document document;
    UndoActions* actions;

    UndoActionsTest() {
        undo.setShortcut(QKeySequence::Undo);
        redo.setShortcut(QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)); // as the window has it
        window.addActions({&undo, &redo});
        window.setLayout(new QVBoxLayout);
        document.open(Document::blank(), {});
        actions = new UndoActions(document, &undo, &redo, &window);
    }
    void show() {
        window.show();
        window.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    template <class Change> void edit(const Change& change) {
        Experiment experiment = document.experiment();
        change(experiment);
        ASSERT_TRUE(document.edit(experiment).ok());
    }
    void editTarget() { ASSERT_TRUE(document.setTargets({320.0}).ok()); }
    void editStart() {
        edit([](Experiment& e) { e.start[kZ] += 0.01; });
    }
    QMessageBox* question() { return window.findChild<QMessageBox*>(QStringLiteral("undoQuestion")); }
    void answer(QMessageBox::ButtonRole role) {
        ASSERT_TRUE(question());
        for (QAbstractButton* button : question()->buttons())
            if (question()->buttonRole(button) == role)
                return QTest::mouseClick(button, Qt::LeftButton);
        FAIL();
    }
};

// Catches actions that can be pressed for nothing, or that do not say what they would do.
TEST_F(UndoActionsTest, TellWhatTheyDo) {
    EXPECT_FALSE(undo.isEnabled());
    EXPECT_EQ(undo.text(), QStringLiteral("&Undo"));
    edit([](Experiment& e) { e.objects[0].name = "salt & pepper"; });
    editTarget();
    EXPECT_TRUE(undo.isEnabled());
    EXPECT_EQ(undo.text(), QStringLiteral("&Undo: target of “salt && pepper”"));
    EXPECT_EQ(undo.toolTip(), QStringLiteral("Undo: target of “salt & pepper”"));
    EXPECT_FALSE(redo.isEnabled());
    const QSignalSpy undone(actions, &UndoActions::undone), redone(actions, &UndoActions::redone);
    undo.trigger();
    undo.trigger();
    EXPECT_EQ(document.experiment(), Document::blank());
    EXPECT_EQ(undone.count(), 2);
    EXPECT_EQ(redo.text(), QStringLiteral("&Redo: renaming of “disk”"));
    redo.trigger();
    EXPECT_EQ(redone.count(), 1);
    EXPECT_EQ(document.experiment().objects[0].name, "salt & pepper");
}

// Catches an object, the source or a limit changed under a run by an undo; targets and gains may be.
TEST_F(UndoActionsTest, ARunAllowsWhatItAllowsToEdit) {
    editStart();
    for (const RunState state : {RunState::Armed, RunState::Running, RunState::Holding, RunState::Settled}) {
        actions->setState(state);
        EXPECT_FALSE(undo.isEnabled());
        EXPECT_TRUE(undo.toolTip().contains(QStringLiteral("A run is armed or on")));
    }
    editTarget();
    EXPECT_TRUE(undo.isEnabled());
    actions->setState(RunState::Ready);
    ASSERT_TRUE(document.setTargets({500.0}).ok()); // over its limit, from before the run
    editStart();
    undo.trigger();
    ASSERT_TRUE(redo.isEnabled());
    editTarget();
    for (const RunState state : {RunState::Armed, RunState::Running}) {
        actions->setState(state);
        EXPECT_FALSE(undo.isEnabled());
    }
    actions->setState(RunState::Ready);
    EXPECT_TRUE(undo.isEnabled());
    actions->setState(RunState::Stopping); // the engine refuses targets then
    EXPECT_FALSE(undo.isEnabled());
    undo.trigger();
    EXPECT_EQ(document.experiment().objects[0].target_K, 320.0);
    actions->setState(RunState::Running);
    ControllerSettings gains = document.experiment().controller;
    gains.levelServo.timeConstant_s *= 2.0;
    ASSERT_TRUE(document.setController(gains).ok());
    actions->setState(RunState::Stopping);
    EXPECT_TRUE(undo.isEnabled());
    actions->setState(RunState::Stopped);
    while (undo.isEnabled())
        undo.trigger();
    EXPECT_EQ(document.experiment(), Document::blank());
}

// Catches a limit of the real rig that comes back by a key without a question, a question that holds the STOP
// key up, and a yes to what is not asked any more.
TEST_F(UndoActionsTest, ALimitOfTheRealRigIsRaisedAfterAQuestion) {
    Experiment live = Document::blank();
    live.rig.emplace();
    document.open(live, {});
    edit([](Experiment& e) { e.robot.upper[kZ] -= 0.05; }); // lowered without one
    const Experiment narrow = document.experiment();
    undo.trigger();
    ASSERT_TRUE(question());
    EXPECT_FALSE(question()->isModal());
    EXPECT_TRUE(question()->text().startsWith(QStringLiteral("Undo: workspace")))
        << qPrintable(question()->text());
    EXPECT_EQ(document.experiment(), narrow);
    QTest::keyClick(question(), Qt::Key_Return); // the default answer
    EXPECT_EQ(document.experiment(), narrow);
    undo.trigger();
    answer(QMessageBox::AcceptRole);
    EXPECT_EQ(document.experiment(), live);
    redo.trigger(); // narrower: without one
    EXPECT_FALSE(question() != nullptr && question()->isVisible());
    EXPECT_EQ(document.experiment(), narrow);
    undo.trigger();
    ASSERT_TRUE(question());
    editTarget();
    EXPECT_FALSE(question());
    undo.trigger(); // the target
    undo.trigger();
    ASSERT_TRUE(question());
    actions->setState(RunState::Armed);
    EXPECT_FALSE(question());
    EXPECT_EQ(document.experiment(), narrow);
}

// Catches a rig that comes back with wider limits than those in use, without a question.
TEST_F(UndoActionsTest, ARigThatComesBackWithWiderLimitsIsAskedAbout) {
    Experiment live = Document::blank();
    live.rig.emplace();
    document.open(live, {});
    edit([](Experiment& e) { e.rig.reset(), e.robot.upper[kZ] -= 0.05; });
    undo.trigger();
    EXPECT_TRUE(question());
    EXPECT_FALSE(document.experiment().rig);
}

// Catches Ctrl+Z that does nothing in a field, since the field takes the key, and one that takes an edit back
// while a number is being typed.
TEST_F(UndoActionsTest, TheKeysWorkInFields) {
    auto* number = new QuantitySpinBox(&window);
    auto* count = new WholeNumberField(&window);
    auto* line = new QLineEdit(QStringLiteral("name"), &window);
    auto* choice = new QComboBox(&window);
    for (QWidget* field : std::initializer_list<QWidget*>{number, count, line, choice})
        window.layout()->addWidget(field);
    ASSERT_NO_FATAL_FAILURE(show());
    for (QWidget* field : std::initializer_list<QWidget*>{number, count, line, choice}) {
        SCOPED_TRACE(field->metaObject()->className());
        editTarget();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier);
        EXPECT_EQ(document.experiment(), Document::blank());
        QTest::keyClick(field, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        EXPECT_EQ(document.experiment().objects[0].target_K, 320.0);
        document.undo();
    }
    editTarget();
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QStringLiteral("45"));
    QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document.experiment().objects[0].target_K, 320.0) << "the field's own";
    QTest::keyClicks(number, QStringLiteral("45"));
    QTest::keyClick(number, Qt::Key_Return);
    QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document.experiment(), Document::blank());
    line->setFocus();
    QTest::keyClicks(line, QStringLiteral("x"));
    editTarget();
    QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(line->text(), QStringLiteral("name"));
    EXPECT_EQ(document.experiment().objects[0].target_K, 320.0);
}

} // namespace
} // namespace bask::test
