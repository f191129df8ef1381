// What Help offers: the manual that is in the program, and the report of a problem.

#include "app/actions.h"
#include "app/manual_window.h"
#include "app/problem_report.h"
#include "app/resources.h"
#include "engine/base/message_code.h"

#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextBrowser>

#include <gtest/gtest.h>

namespace bask {
namespace {

QString textOf(const QString& page) {
    QFile file(QStringLiteral(":/manual/") + page);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList anchorsOf(const QString& page) {
    static const QRegularExpression kHeading(QStringLiteral("^#+ (.*)$"),
                                             QRegularExpression::MultilineOption);
    QStringList out;
    for (const auto& match : kHeading.globalMatch(textOf(page)))
        out << ManualWindow::anchorOf(match.captured(1).remove(u'`'));
    return out;
}

struct HelpTest : testing::Test {
    HelpTest() { initResources(); }
};

} // namespace

// Catches a page that is not in the program, and a link that leads nowhere.
TEST_F(HelpTest, EveryLinkOfTheManualLeadsToAHeading) {
    ASSERT_TRUE(ManualWindow::pages().contains(QStringLiteral("manual.md")));
    static const QRegularExpression kLink(QStringLiteral("\\]\\(([^)\\s]+)\\)"));
    int links = 0;
    for (const QString& page : ManualWindow::pages()) {
        for (const auto& match : kLink.globalMatch(textOf(page))) {
            const QString link = match.captured(1);
            if (link.startsWith(QLatin1String("http")))
                continue;
            ++links;
            const QString to = link.startsWith(u'#') ? page : link.section(u'#', 0, 0);
            EXPECT_TRUE(ManualWindow::pages().contains(to))
                << page.toStdString() << ": " << link.toStdString();
            if (const QString anchor = link.section(u'#', 1); !anchor.isEmpty()) {
                EXPECT_TRUE(anchorsOf(to).contains(anchor))
                    << page.toStdString() << ": " << link.toStdString();
            }
        }
    }
    EXPECT_GT(links, 15);
}

// Catches a key that works and stands nowhere.
TEST_F(HelpTest, EveryShortcutIsInTheManual) {
    QWidget window;
    const Actions actions(&window);
    const QString text = textOf(QStringLiteral("manual.md"));
    int keys = 0;
    for (const QAction* action : window.actions()) {
        const QString key = action->shortcut().toString(QKeySequence::PortableText);
        static const QRegularExpression kPage(QStringLiteral("^Ctrl\\+[1-6]$"));
        if (key.isEmpty() || kPage.match(key).hasMatch()) // "Ctrl+1 to Ctrl+6"
            continue;
        ++keys;
        EXPECT_TRUE(text.contains(key)) << action->objectName().toStdString() << ": " << key.toStdString();
    }
    EXPECT_GT(keys, 10);
}

// Catches a link that shows the top of its page, a Back that forgets, a search that ends with the page.
TEST_F(HelpTest, TheManualIsReadAndSearched) {
    ManualWindow manual(nullptr);
    auto* text = manual.findChild<QTextBrowser*>(QStringLiteral("manualText"));
    manual.open(QStringLiteral("manual.md#keys"));
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("Keys"));
    emit text->anchorClicked(QUrl(QStringLiteral("safety.md")));
    EXPECT_TRUE(text->toPlainText().startsWith(QStringLiteral("What the engine watches")));
    manual.findChild<QPushButton*>(QStringLiteral("manualBack"))->click();
    EXPECT_TRUE(text->toPlainText().startsWith(QStringLiteral("Bask: the manual")));
    auto* find = manual.findChild<QLineEdit*>(QStringLiteral("manualFind"));
    find->setText(QStringLiteral("MAX31865"));
    emit find->returnPressed();
    EXPECT_EQ(text->textCursor().selectedText(), QStringLiteral("MAX31865")) << "on another page";
    manual.open(QStringLiteral("nothing.md"));
    EXPECT_TRUE(text->toPlainText().startsWith(QStringLiteral("Bask: the manual")));
}

// Catches a report that leaves out what a developer needs, and one that is saved otherwise than it was read.
TEST_F(HelpTest, AProblemReportHasTheFactsAndIsSavedAsItIsSeen) {
    Snapshot snapshot;
    snapshot.state = RunState::Fault;
    snapshot.simulated = false;
    snapshot.reasons = {{MessageCode::RobotSlow, {"0.9"}}};
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceSilent, {"3.1"}};
    snapshot.alarms = {alarm};
    RigDeviceState robot;
    robot.port = "/dev/ttyUSB7";
    robot.status.identity = "Grbl 1.1h";
    snapshot.devices = {robot};
    Experiment experiment;
    experiment.title = "a title of its own";
    std::vector<TraceEvent> events(1000, TraceEvent{1.0, {MessageCode::EventStarted, {}}});
    events.back().message = {MessageCode::EventSettled, {}};
    const QString report = problemReport(snapshot, events, experiment);
    for (const char* fact : {"Bask ", "Qt 6", "Fault, LIVE", "for 0.9 s", "3.1 s", "/dev/ttyUSB7",
                             "Grbl 1.1h", "a title of its own"})
        EXPECT_TRUE(report.contains(QLatin1String(fact))) << fact;
    EXPECT_TRUE(report.contains(QString::fromStdString(describe(events.back().message))));
    EXPECT_LT(report.count(u'\n'), 1000) << "the newest events only";

    ProblemDialog dialog(report, nullptr);
    auto* text = dialog.findChild<QPlainTextEdit*>(QStringLiteral("problemText"));
    EXPECT_TRUE(text->toPlainText().contains(report));
    EXPECT_FALSE(text->isReadOnly());
    text->setPlainText(QStringLiteral("shortened"));
    QStringList saved;
    QObject::connect(&dialog, &ProblemDialog::saveWanted, [&](const QString& wanted) { saved << wanted; });
    dialog.findChild<QPushButton*>(QStringLiteral("problemSave"))->click();
    EXPECT_EQ(saved, QStringList{QStringLiteral("shortened")});
}

} // namespace bask
