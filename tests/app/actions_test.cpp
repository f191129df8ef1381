// Which verbs the window offers by what the engine reports; what its keys say that cannot act, and its
// mnemonics.

#include "app/actions.h"

#include "app/document.h"
#include "app/examples.h"
#include "app/resources.h"
#include "app/undo_actions.h"
#include "tests/app/mnemonics.h"
#include "widgets/common/language.h"

#include <QMainWindow>
#include <QMenuBar>
#include <QTest>
#include <QWidget>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// A window that has the keyboard, and what its keys say.
struct Keys {
    QMainWindow window;
    Actions actions{&window};
    QStringList said;
    QList<Verb> refused;

    Keys() {
        QObject::connect(&actions, &Actions::keyRefused, &window,
                         [this](const QString& why) { said << why; });
        QObject::connect(&actions, &Actions::verbRefused, &window, [this](Verb verb) { refused << verb; });
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) { QTest::keyClick(&window, key, with); }
};

} // namespace

// Catches a robot that moves by itself, to calibrate a camera, while Hold and its key F7 are greyed out.
TEST(Actions, HoldIsOfferedWhileTheRobotMovesWithoutARun) {
    QWidget window;
    Actions actions(&window);
    for (const RunState state : {RunState::NotReady, RunState::Ready, RunState::Stopped}) {
        Snapshot snapshot;
        snapshot.state = state;
        actions.apply(snapshot);
        EXPECT_FALSE(actions.verb(Verb::Hold)->isEnabled());
        snapshot.isMoving = true;
        actions.apply(snapshot);
        EXPECT_TRUE(actions.verb(Verb::Hold)->isEnabled());
        EXPECT_TRUE(actions.verb(Verb::EmergencyStop)->isEnabled());
        EXPECT_FALSE(actions.verb(Verb::Resume)->isEnabled());
    }
}

// Catches an error of targets that the window does not know: it offers to arm, and the engine refuses.
TEST(Actions, ArmIsNotOfferedOverTargetsThatDoNotFit) {
    initResources();
    QWidget window;
    Actions actions(&window);
    Snapshot snapshot;
    snapshot.state = RunState::Stopped;
    actions.apply(snapshot);
    EXPECT_TRUE(actions.verb(Verb::Arm)->isEnabled());
    Experiment experiment = readExample(QStringLiteral("thermal-camera")).value();
    ASSERT_TRUE(checkTargets(experiment));
    experiment.objects[0].target_K = kelvinFromCelsius(180.0);
    const auto tooHot = checkTargets(experiment);
    experiment.objects[0].warning_K = kelvinFromCelsius(200.0);
    const auto notTold = checkTargets(experiment);
    for (const auto& fit : {tooHot, notTold}) {
        ASSERT_FALSE(fit);
        snapshot.reasons = {fit.error().message};
        actions.apply(snapshot);
        EXPECT_FALSE(actions.verb(Verb::Arm)->isEnabled()) << describe(fit.error());
    }
    EXPECT_NE(tooHot.error().code(), notTold.error().code());
}

// Catches a key that does nothing and says nothing, one that says why and acts, and a reason that stays when
// the action is possible.
TEST(Actions, AKeyThatCannotActSaysWhy) {
    Keys keys;
    Snapshot snapshot;
    snapshot.state = RunState::Running;
    keys.actions.apply(snapshot);
    int begun = 0, acknowledged = 0;
    QObject::connect(keys.actions.newExperiment, &QAction::triggered, &keys.window, [&] { ++begun; });
    QObject::connect(keys.actions.acknowledgeAlarms, &QAction::triggered, &keys.window,
                     [&] { ++acknowledged; });
    const auto lastSays = [&](const char* text) {
        return !keys.said.isEmpty() && keys.said.back().contains(QLatin1String(text));
    };
    keys.press(Qt::Key_N, Qt::ControlModifier);
    EXPECT_TRUE(lastSays("A run is armed or on"));
    keys.press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(lastSays("no recording to save yet"));
    keys.press(Qt::Key_F9);
    EXPECT_TRUE(lastSays("no alarm to acknowledge"));
    EXPECT_EQ(keys.said.size(), 3);
    EXPECT_EQ(begun + acknowledged, 0);
    EXPECT_EQ(keys.actions.newExperiment->toolTip(), keys.said[0]) << "the menu says the same";

    snapshot.state = RunState::Ready;
    Alarm alarm;
    alarm.isActive = true;
    snapshot.alarms = {alarm};
    keys.actions.apply(snapshot);
    keys.actions.saveSession->setEnabled(true);
    keys.press(Qt::Key_N, Qt::ControlModifier);
    keys.press(Qt::Key_F9);
    keys.press(Qt::Key_E, Qt::ControlModifier);
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(acknowledged, 1);
    EXPECT_EQ(keys.said.size(), 3);
    EXPECT_FALSE(keys.actions.newExperiment->toolTip().contains(QStringLiteral("run")));

    keys.press(Qt::Key_F6); // a verb has its own place for that
    EXPECT_EQ(keys.refused, QList<Verb>{Verb::Start});
    EXPECT_EQ(keys.said.size(), 3);
}

// Catches an action with a key that is greyed in some state and whose tip does not say why.
TEST(Actions, WhatIsGreyHasAReasonInItsTip) {
    QMainWindow window;
    Actions actions(&window);
    Document document;
    document.open(Document::blank(), {});
    const UndoActions undo(document, actions.undo, actions.redo, &window);
    QMap<QAction*, QString> usual;
    for (QAction* action : {actions.endRecording, actions.acknowledgeAlarms}) {
        Snapshot possible;
        possible.recordingPath = "run.bask";
        possible.alarms.resize(1);
        actions.apply(possible);
        ASSERT_TRUE(action->isEnabled());
        usual[action] = action->toolTip();
    }
    for (int state = 0; state <= static_cast<int>(RunState::Fault); ++state) {
        Snapshot snapshot;
        snapshot.state = static_cast<RunState>(state);
        actions.apply(snapshot);
        for (const QAction* action : window.actions())
            if (!action->isEnabled()) {
                const QString plain = QString(action->text()).remove(u'&');
                EXPECT_NE(action->toolTip(), plain)
                    << action->objectName().toStdString() << " in " << runStateName(snapshot.state);
            }
        for (QAction* action : usual.keys()) {
            EXPECT_FALSE(action->isEnabled());
            EXPECT_NE(action->toolTip(), usual[action]) << action->objectName().toStdString();
        }
    }
}

// Catches a letter that chooses neither of two entries, in any of the languages.
TEST(Actions, NoMnemonicIsTwiceInAMenuOrTheMenuBar) {
    initResources();
    QMainWindow window;
    Actions actions(&window);
    actions.fillMenus(window.menuBar());
    actions.setRecent({QStringLiteral("/home/me/salt & pepper.json")});
    Document document;
    document.open(Document::blank(), {});
    UndoActions undo(document, actions.undo, actions.redo, &window);
    Language language;
    for (const QString& code : Language::codes()) {
        language.set(code);
        actions.retranslate();
        undo.refresh();
        const QStringList twice = test::mnemonicsTwice(window.menuBar()->actions());
        EXPECT_TRUE(twice.isEmpty()) << code.toStdString() << ": "
                                     << twice.join(QStringLiteral("; ")).toStdString();
        int menus = 0;
        for (const QAction* top : window.menuBar()->actions()) {
            EXPECT_FALSE(QKeySequence::mnemonic(top->text()).isEmpty())
                << code.toStdString() << ": " << top->text().toStdString();
            menus += top->menu() != nullptr ? 1 : 0;
        }
        EXPECT_EQ(menus, 6);
    }
    language.set(QStringLiteral("en"));
    QAction one(QStringLiteral("&Save")), other(QStringLiteral("Re&set")); // the walk itself works
    EXPECT_EQ(test::mnemonicsTwice({&one, &other}).size(), 1);
}

} // namespace bask
