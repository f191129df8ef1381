// A recipe in the window: opened, edited, started, watched through its steps, stopped, its runs looked at.

#include "app/recipe_control.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/message_bar.h"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTreeWidget>

#include <fstream>

namespace bask::test {
namespace {

constexpr int kUntil = 2, kState = 5; ///< columns

class RecipeTest : public WindowTest {
protected:
    QTemporaryDir folder;
    QString path = folder.filePath("short.json");

    void SetUp() override {
        WindowTest::SetUp();
        write(R"({"run_example": "two-circles", "until": {"time_s": 15}},
            {"wait": {"time_s": 20}},
            {"run_example": "two-circles", "until": {"settled_for_s": 900}, "at_most_s": 1000})");
    }
    void write(const char* steps) {
        std::ofstream(path.toStdString())
            << R"({"format": "bask-recipe", "version": 1, "steps": [)" << steps << "]}";
    }
    /// In the rig's time.
    void expectNoRunFor(double time_s) {
        const double from_s = window->lastSnapshot().clock_s;
        EXPECT_TRUE(waitFor([&] {
            EXPECT_NE(state(), RunState::Running);
            return HasFailure() || window->lastSnapshot().clock_s - from_s > time_s;
        }));
    }
    QTreeWidget* tree() { return find<QTreeWidget>("recipeTree"); }
    QString stateOf(int row) { return tree()->topLevelItem(row)->text(kState); }
    void choose(int row) { tree()->setCurrentItem(tree()->topLevelItem(row)); }
    void openAndAsk() {
        ASSERT_NO_FATAL_FAILURE(openWindow());
        window->files().open(path);
        ASSERT_TRUE(tree()->isVisible());
        ASSERT_TRUE(waitForState(RunState::Ready));
        click("recipeStart");
        ASSERT_TRUE(waitFor([this] { return question() != nullptr; }));
        EXPECT_FALSE(window->recipe().isOn());
    }
    void go() {
        click("recipeGo");
        ASSERT_TRUE(window->recipe().isOn());
    }
    QMessageBox* question() { return window->findChild<QMessageBox*>("recipeQuestion"); }
    QString bar() { return find<QLabel>("recipeState")->text(); }
};

} // namespace

TEST_F(RecipeTest, goesThroughItsStepsUntilItIsStopped) {
    ASSERT_NO_FATAL_FAILURE(openAndAsk());
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_EQ(tree()->topLevelItemCount(), 3);
    EXPECT_TRUE(question()->text().contains(QStringLiteral("3. two-circles until all have been settled for "
                                                           "15:00, at most 16:40")))
        << question()->text().toStdString();
    // All of it, as it comes: a step lasts less than a second here, and this thread may be held up for
    // longer.
    bool saysRunning = false, restsInWait = false, isTold = true;
    auto* told = find<MessageBar>("recipeBar");
    EXPECT_FALSE(told->isVisible());
    QObject::connect(window.get(), &MainWindow::snapshotApplied, window.get(), [&](const Snapshot& snapshot) {
        saysRunning |= bar().startsWith("Step 1 of 3: running");
        restsInWait |= stateOf(0) == "Done" && stateOf(1) == "Under way" &&
                       snapshot.state == RunState::Stopped && !snapshot.heatOn;
        isTold &= !window->recipe().isOn() || told->isVisible(); // also while the rig rests
    });
    ASSERT_NO_FATAL_FAILURE(go());
    EXPECT_EQ(stateOf(0), "Under way");
    EXPECT_FALSE(find<QPushButton>("recipeEdit")->isEnabled());
    ASSERT_TRUE(waitFor([&] { return saysRunning; }));
    EXPECT_EQ(window->document().experiment().objects.size(), 2u); // the pages show what is run
    ASSERT_TRUE(waitFor([&] { return restsInWait; }));
    ASSERT_TRUE(waitFor([this] { return stateOf(2) == "Under way" && state() == RunState::Running; }));
    EXPECT_EQ(stateOf(1), "Done");
    keepPicture("recipe");
    click("recipeStopNow");
    ASSERT_TRUE(waitFor([this] { return !window->recipe().isOn(); }));
    EXPECT_EQ(state(), RunState::Stopped);
    EXPECT_EQ(stateOf(2), "Stopped");
    EXPECT_TRUE(isTold);
    EXPECT_FALSE(told->isVisible());
    EXPECT_TRUE(bar().startsWith("The recipe was stopped.")) << bar().toStdString();

    choose(1);
    EXPECT_FALSE(find<QPushButton>("recipeSession")->isEnabled()); // a wait has no recording
    choose(0);
    std::shared_ptr<RecordedSession> opened;
    QObject::connect(&window->files(), &SessionActions::sessionOpened, window.get(),
                     [&](const std::shared_ptr<RecordedSession>& session) { opened = session; });
    click("recipeSession");
    ASSERT_TRUE(waitFor([&] { return opened != nullptr; }));
    EXPECT_EQ(opened->facts().experiment.objects.size(), 2u);
    EXPECT_FALSE(opened->facts().interrupted());
    EXPECT_EQ(window->pages().page(), Page::Review);

    // A window that draws for a minute cannot watch over a recipe.
    window->pages().show(Page::Run);
    window->files().open(path);
    click("recipeStart");
    ASSERT_TRUE(waitFor([this] { return question() != nullptr; }));
    ASSERT_NO_FATAL_FAILURE(go());
    QStringList problems;
    QObject::connect(&window->files(), &SessionActions::problem, window.get(),
                     [&](const QString& sentence) { problems << sentence; });
    window->files().setFileChooser([](const FileQuestion&) { return QString(); });
    window->files().exportSession(SessionForm::Figures);
    EXPECT_EQ(problems.size(), 1) << "nothing has been armed yet, but the recipe is on";
}

// Catches a recipe that goes on after a person has taken the run in hand.
TEST_F(RecipeTest, aPersonsStopEndsIt) {
    write(R"({"run_example": "two-circles", "until": {"time_s": 3000}}, {"wait": {"time_s": 5}},
        {"run_example": "two-circles", "until": {"time_s": 5}})");
    ASSERT_NO_FATAL_FAILURE(openAndAsk());
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_NO_FATAL_FAILURE(go());
    ASSERT_TRUE(waitForState(RunState::Running));
    click("stopRunButton");
    ASSERT_TRUE(waitFor([this] { return !window->recipe().isOn(); }));
    ASSERT_TRUE(waitForState(RunState::Stopped));
    EXPECT_EQ(stateOf(0), "Stopped");
    EXPECT_EQ(stateOf(1), "To come");
    expectNoRunFor(30.0);
    EXPECT_EQ(state(), RunState::Stopped);
}

TEST_F(RecipeTest, stopEndsItInAWaitToo) {
    write(R"({"wait": {"time_s": 30}}, {"run_example": "two-circles", "until": {"time_s": 15}})");
    ASSERT_NO_FATAL_FAILURE(openAndAsk()); // in real time, as long as it waits
    ASSERT_NO_FATAL_FAILURE(go());
    EXPECT_EQ(stateOf(0), "Under way");
    ASSERT_TRUE(waitFor([this] { return bar().startsWith("Step 1 of 2: waiting"); })) << bar().toStdString();
    click("stopButton");
    ASSERT_TRUE(waitFor([this] { return !window->recipe().isOn(); }));
    EXPECT_EQ(stateOf(0), "Stopped");
    ASSERT_TRUE(waitForState(RunState::Fault));
    click("resetButton");
    ASSERT_NO_FATAL_FAILURE(goFast());
    expectNoRunFor(60.0);
    EXPECT_EQ(stateOf(1), "To come");
}

// Catches a question, asked before STOP, whose answer takes the latch off.
TEST_F(RecipeTest, stopTakesTheQuestionBack) {
    ASSERT_NO_FATAL_FAILURE(openAndAsk());
    click("stopButton");
    EXPECT_EQ(question(), nullptr);
    ASSERT_TRUE(waitForState(RunState::Fault));
    EXPECT_FALSE(find<QPushButton>("recipeStart")->isEnabled());
    EXPECT_FALSE(window->recipe().isOn());
}

// Catches a rig that starts by itself while somebody moves it by hand.
TEST_F(RecipeTest, aMoveByHandEndsIt) {
    write(R"({"wait": {"time_s": 30}}, {"run_example": "two-circles", "until": {"time_s": 15}})");
    ASSERT_NO_FATAL_FAILURE(openAndAsk());
    ASSERT_NO_FATAL_FAILURE(go());
    ASSERT_TRUE(waitFor([this] { return bar().startsWith("Step 1 of 2: waiting"); })) << bar().toStdString();
    Vector6d goal = window->lastSnapshot().latest.coordinates;
    goal[2] += 0.01;
    emit window->pages().commandIssued(MoveTo{goal});
    EXPECT_FALSE(window->recipe().isOn());
    EXPECT_EQ(stateOf(0), "Stopped");
    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().latest.coordinates.isApprox(goal, 1e-6); }));
}

TEST_F(RecipeTest, isEditedSavedAndAskedAbout) {
    ASSERT_NO_FATAL_FAILURE(openWindow({1280, 800}, path)); // as by a double click on the file
    ASSERT_EQ(tree()->topLevelItemCount(), 3);
    EXPECT_EQ(find<QPushButton>("recipeSave")->isEnabled(), false);
    choose(1);
    QAction* add = find<QMenu>("recipeAddMenu")->actions().at(3); // until an object has cooled
    add->trigger();
    find<QDialog>("recipeStepDialog")->reject();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_EQ(tree()->topLevelItemCount(), 3) << "cancelled";
    EXPECT_FALSE(find<QPushButton>("recipeSave")->isEnabled());
    add->trigger();
    auto* form = find<QDialog>("recipeStepDialog");
    ASSERT_TRUE(form->isVisible());
    EXPECT_EQ(form->findChild<QComboBox*>("object")->currentText(), "circle");
    EXPECT_FALSE(form->findChild<QDoubleSpinBox*>("duration")->isVisible());
    form->findChild<QDoubleSpinBox*>("atMost")->setValue(120.0);
    form->accept();
    ASSERT_EQ(tree()->topLevelItemCount(), 4);
    EXPECT_EQ(tree()->topLevelItem(2)->text(kUntil),
              QStringLiteral("circle is at 30.0\u00a0\u00b0C or below"));
    EXPECT_EQ(tree()->currentItem(), tree()->topLevelItem(2));
    click("recipeUp");
    EXPECT_EQ(tree()->topLevelItem(1)->text(kUntil),
              QStringLiteral("circle is at 30.0\u00a0\u00b0C or below"));
    choose(3);
    click("recipeRemove");
    EXPECT_TRUE(bar().contains("short.json, changed")) << bar().toStdString();
    click("recipeSave");
    const auto saved = readRecipe(path.toStdString());
    ASSERT_TRUE(saved);
    ASSERT_EQ(saved->steps.size(), 3u);
    EXPECT_EQ(saved->steps[1].object, "circle");
    EXPECT_EQ(saved->steps[1].maxDuration_s, 120.0);
    EXPECT_EQ(saved->steps[0].example, "two-circles");
    EXPECT_TRUE(window->recipe().mayDiscard()); // nothing to ask

    // A run without that object cannot be begun.
    click("recipeStart");
    ASSERT_TRUE(waitFor([this] {
        const auto labels = find<QWidget>("messageBar")->findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
            return label->text().contains(QStringLiteral("steps[1].wait.object"));
        });
    }));
    EXPECT_EQ(question(), nullptr);
}

} // namespace bask::test
