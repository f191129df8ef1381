// Who operates, what is heated, and who watches: as a person sets it up, and where it is found again.

#include "app/labels_dialog.h"
#include "app/monitor_dialog.h"
#include "engine/recording/session_header.h"
#include "tests/app/window_fixture.h"
#include "tests/support/listening_sockets.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <fstream>

namespace bask::test {
namespace {

class LabelsTest : public WindowTest {
protected:
    void TearDown() override {
        WindowTest::TearDown();
        QFile::remove(qEnvironmentVariable("BASK_SETTINGS_DIR") + "/monitor.json");
    }
    void trigger(const char* action) { window->findChild<QAction*>(QLatin1String(action))->trigger(); }
    /// Types the three names into the dialog and takes them.
    void name(const char* who, const char* sample, const char* batch) {
        ASSERT_NE(window->findChild<LabelsDialog*>(), nullptr);
        find<QComboBox>("operatorName")->setEditText(who);
        if (find<QLineEdit>("sampleName")->isEnabled()) {
            find<QLineEdit>("sampleName")->setText(sample);
            find<QLineEdit>("batchName")->setText(batch);
        }
        keepPicture(QStringLiteral("labels-dialog"));
        click("takeLabels");
    }
    std::string recorded() {
        const auto files = sessionFiles(recordingFolder().toStdString());
        return files.empty() ? std::string() : *std::ranges::max_element(files);
    }
};

} // namespace

// Catches names that are asked for and lost, and a sample that changes under a run.
TEST_F(LabelsTest, NamesGoIntoTheBarTheRunAndTheList) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    EXPECT_TRUE(find<QToolButton>("operatorButton")->isHidden()) << "nobody has said";
    trigger("labels");
    ASSERT_NO_FATAL_FAILURE(name("A. Hu", "plate 7", "B3"));
    ASSERT_TRUE(waitFor([this] { return find<QToolButton>("operatorButton")->text().startsWith("A. Hu"); }));
    keepPicture(QStringLiteral("labels-bar"));

    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_EQ(window->findChild<LabelsDialog*>(), nullptr) << "it was not to ask";
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    click("operatorButton");
    EXPECT_FALSE(find<QLineEdit>("sampleName")->isEnabled());
    ASSERT_NO_FATAL_FAILURE(name("B. Li", "", ""));
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().labels.operatorName == "B. Li"; }));
    window->engine().send(AddNote{"door opened"});
    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopped));
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().recordingPath.empty(); }));
    const SessionHeader header = readSessionHeader(recorded());
    EXPECT_EQ(header.labels, (RunLabels{"A. Hu", "plate 7", "B3"}));
    EXPECT_EQ(readSession(recorded())->notes.front().operatorName, "B. Li");
}

// Catches a question that is not asked, or that arms without an answer.
TEST_F(LabelsTest, AsksBeforeARunIfThatIsWanted) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_TRUE(waitForState(RunState::Ready));
    trigger("labels");
    find<QCheckBox>("askLabels")->setChecked(true);
    ASSERT_NO_FATAL_FAILURE(name("A. Hu", "", ""));
    ASSERT_TRUE(waitFor([this] { return window->lastSnapshot().labels.operatorName == "A. Hu"; }));
    click("armButton");
    auto* dialog = find<LabelsDialog>("labelsDialog");
    EXPECT_EQ(dialog->labels().operatorName, "A. Hu") << "as it was";
    find<QLineEdit>("sampleName")->setText(QStringLiteral("tab\there"));
    EXPECT_FALSE(find<QPushButton>("takeLabels")->isEnabled()) << "that is no name";
    dialog->reject();
    EXPECT_EQ(state(), RunState::Ready);
    ASSERT_TRUE(waitFor([this] { return window->findChild<LabelsDialog*>() == nullptr; }));
    click("armButton");
    ASSERT_NO_FATAL_FAILURE(name("A. Hu", "plate 8", ""));
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_EQ(window->lastSnapshot().labels.sample, "plate 8");
    closeWindow();
    SettingsStore settings;
    EXPECT_TRUE(settings.asksLabels());
    EXPECT_EQ(settings.recentOperators(), QStringList("A. Hu"));
    settings.setAsksLabels(false);
}

// Catches a port that is open to others, in any state, and monitoring that does not begin by itself at the
// next start.
TEST_F(LabelsTest, PublishesAsSetUpAndListensNowhere) {
    const QTemporaryDir status;
    ASSERT_NO_FATAL_FAILURE(openWindow());
    EXPECT_EQ(listeningSockets(), "");
    EXPECT_TRUE(find<QLabel>("monitoring")->isHidden());
    trigger("monitoring");
    auto* dialog = find<MonitorDialog>("monitorDialog");
    find<QGroupBox>("monitorBroker")->setChecked(true);
    EXPECT_FALSE(find<QPushButton>("takeMonitor")->isEnabled()) << "it has no address";
    find<QLineEdit>("brokerAddress")->setText(QStringLiteral("127.0.0.1:1")); // where nobody is
    find<QGroupBox>("monitorFiles")->setChecked(true);
    find<QLineEdit>("statusFolder")->setText(status.path());
    click("tryMonitor");
    ASSERT_TRUE(waitFor([this] { return find<QLabel>("monitorAnswer")->text().contains("127.0.0.1:1"); }));
    keepPicture(QStringLiteral("monitor-dialog"));
    EXPECT_EQ(dialog->settings().statusFolder, status.path().toStdString());
    click("takeMonitor");
    ASSERT_TRUE(waitFor([this] { return find<QLabel>("monitoring")->text() == "monitoring fails"; }));
    EXPECT_TRUE(find<QLabel>("monitoring")->toolTip().contains("127.0.0.1:1"));
    EXPECT_TRUE(window->lastSnapshot().alarms.empty()) << "a run does not depend on it";
    keepPicture(QStringLiteral("monitoring-fails"));
    EXPECT_EQ(listeningSockets(), "");
    closeWindow();

    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    click("armButton");
    ASSERT_TRUE(waitForState(RunState::Armed));
    EXPECT_EQ(listeningSockets(), "");
    click("startButton");
    ASSERT_TRUE(waitForState(RunState::Running));
    EXPECT_EQ(listeningSockets(), "");
    const std::string file = status.filePath("bask.json").toStdString();
    const auto says = [&](const char* word) {
        std::ifstream in(file);
        std::string text;
        std::getline(in, text);
        return text.find(word) != std::string::npos;
    };
    EXPECT_TRUE(waitFor([&] { return says("\"state\":\"Running\""); }));
    click("holdButton");
    ASSERT_TRUE(waitForState(RunState::Holding));
    EXPECT_EQ(listeningSockets(), "");
    click("holdButton"); // goes on
    ASSERT_TRUE(waitForState(RunState::Running));
    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopping));
    EXPECT_EQ(listeningSockets(), "");
    ASSERT_TRUE(waitForState(RunState::Stopped));
    EXPECT_EQ(listeningSockets(), "");
    click("stopButton");
    ASSERT_TRUE(waitForState(RunState::Fault));
    EXPECT_EQ(listeningSockets(), "");
    EXPECT_TRUE(waitFor([&] { return says("\"state\":\"Fault\""); }));
    closeWindow();
    EXPECT_TRUE(says("\"closed\":true"));
}

} // namespace bask::test
