// What Help offers: the manual that is in the program, and the report of a problem.

#include "app/actions.h"
#include "app/manual_window.h"
#include "app/problem_report.h"
#include "app/resources.h"
#include "engine/base/message_code.h"
#include "tests/support/fake_opener.h"
#include "tests/support/wait_for.h"
#include "widgets/common/language.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>

#include <gtest/gtest.h>

namespace bask {
namespace {

QString textOf(const QString& page) {
    QFile file(QStringLiteral(":/manual/") + page);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Of docs/, as the program has them: "safety.md", "fr/safety.md".
QStringList files() {
    const QDir folder(QStringLiteral(":/manual"));
    QStringList out;
    for (QDirIterator it(folder.path(), QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        out << folder.relativeFilePath(it.next());
    return out;
}

QStringList captured(const char* pattern, const QString& text) {
    const QRegularExpression expression(QString::fromLatin1(pattern), QRegularExpression::MultilineOption);
    QStringList out;
    for (const auto& match : expression.globalMatch(text))
        out << match.captured(1);
    return out;
}

QStringList anchorsOf(const QString& page) {
    QStringList out;
    for (QString& heading : captured("^#+ (.*)$", textOf(page)))
        out << ManualWindow::anchorOf(heading.remove(u'`'));
    return out;
}

struct Link {
    QString text, page, anchor; ///< the page is a file, "fr/safety.md"
};

/// To other pages and headings.
QList<Link> linksOf(const QString& page) {
    QList<Link> out;
    for (const QString& link : captured("\\]\\(([^)\\s]+)\\)", textOf(page))) {
        if (link.startsWith(QLatin1String("http")))
            continue;
        const QString to = QDir::cleanPath(page + QStringLiteral("/../") + link.section(u'#', 0, 0));
        out << Link{link, link.startsWith(u'#') ? page : to, link.section(u'#', 1)};
    }
    return out;
}

/// What a translation leaves as it is, a line each.
QStringList frameOf(const QString& page) {
    QString text = textOf(page);
    text.remove(QRegularExpression(QStringLiteral("(?<=\\d),(?=\\d{3})"))); // 3,000
    QStringList out;
    for (const QString& heading : captured("^(#+) ", text))
        out << QStringLiteral("heading ") + heading;
    for (const QString& row : captured("^(\\|.*)$", text))
        out << QStringLiteral("row of %1 bars").arg(row.count(u'|'));
    for (const QString& item : captured("^(-|\\d\\.) ", text))
        out << QStringLiteral("item ") + item;
    for (const QString& code : captured("`([^`\n]+)`", text))
        out << QStringLiteral("code ") + code;
    for (const Link& link : linksOf(page))
        out << QStringLiteral("link to %1, heading %2")
                   .arg(link.page.section(u'/', -1))
                   .arg(anchorsOf(link.page).indexOf(link.anchor));
    text.remove(QRegularExpression(QStringLiteral("`[^`\n]+`|\\]\\([^)]*\\)")));
    for (const QString& number : captured("(\\d+(?:\\.\\d+)?)", text))
        out << QStringLiteral("number ") + number;
    return out;
}

/// The lines of `a` that `b` does not have, or not as often.
std::string missing(QStringList a, const QStringList& b) {
    for (const QString& line : b)
        a.removeOne(line);
    return a.join(u'\n').toStdString();
}

struct HelpTest : testing::Test {
    HelpTest() { initResources(); }
};

} // namespace

// Catches a page that is not in the program, a link that leads nowhere, and one that leads out of a language
// though the page is translated.
TEST_F(HelpTest, EveryLinkOfTheManualLeadsToAHeading) {
    ASSERT_TRUE(ManualWindow::pages().contains(QStringLiteral("manual.md")));
    const QStringList all = files();
    int links = 0;
    for (const QString& page : all) {
        const QString folder = page.section(u'/', 0, -2);
        for (const Link& link : linksOf(page)) {
            SCOPED_TRACE((page + QStringLiteral(": ") + link.text).toStdString());
            ++links;
            EXPECT_TRUE(all.contains(link.page));
            EXPECT_TRUE(link.anchor.isEmpty() || anchorsOf(link.page).contains(link.anchor));
            if (!folder.isEmpty() && !link.page.contains(u'/')) {
                EXPECT_FALSE(all.contains(folder + u'/' + link.page)) << "it is there in this language";
            }
        }
    }
    EXPECT_GT(links, 60);
}

// Catches an English page that was changed without its translations: each has its headings, rows, items,
// links, code and numbers. And emphasis that stays as stars, as it does between Han characters and their
// punctuation.
TEST_F(HelpTest, TranslatedPagesSayWhatTheEnglishOnesSay) {
    int translated = 0;
    for (const QString& page : files()) {
        if (!page.contains(u'/'))
            continue;
        SCOPED_TRACE(page.toStdString());
        ++translated;
        const QStringList english = frameOf(page.section(u'/', -1)), own = frameOf(page);
        EXPECT_GT(english.size(), 30);
        EXPECT_EQ(missing(english, own), "") << "in the translation";
        EXPECT_EQ(missing(own, english), "") << "in English";
        QTextDocument shown;
        shown.setMarkdown(textOf(page));
        for (const char* mark : {"**", "](", "`"})
            EXPECT_FALSE(shown.toPlainText().contains(QLatin1String(mark))) << mark;
    }
    EXPECT_GE(translated, 12);
}

// Catches a key that works and stands nowhere.
TEST_F(HelpTest, EveryShortcutIsInTheManual) {
    QWidget window;
    const Actions actions(&window);
    for (const QString& page : files().filter(QRegularExpression(QStringLiteral("(^|/)manual\\.md$")))) {
        const QString text = textOf(page).replace(QLatin1String("Maj+"), QLatin1String("Shift+"));
        int keys = 0;
        for (const QAction* action : window.actions()) {
            const QString key = action->shortcut().toString(QKeySequence::PortableText);
            static const QRegularExpression kPage(QStringLiteral("^Ctrl\\+[1-6]$"));
            if (key.isEmpty() || kPage.match(key).hasMatch()) // "Ctrl+1 to Ctrl+6"
                continue;
            ++keys;
            EXPECT_TRUE(text.contains(key))
                << page.toStdString() << ", " << action->objectName().toStdString() << ": "
                << key.toStdString();
        }
        EXPECT_GT(keys, 10);
    }
}

// Catches a link that shows the top of its page, a Back that forgets, a search that ends with the page.
TEST_F(HelpTest, TheManualIsReadAndSearched) {
    Language language;
    language.set(QStringLiteral("en"));
    ManualWindow manual(language, nullptr);
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

// Catches a link into the web that nothing opens, without a word.
TEST_F(HelpTest, TheManualOpensTheWebOrSaysThatNothingDoes) {
    Language language;
    language.set(QStringLiteral("en"));
    ManualWindow manual(language, nullptr);
    const QSignalSpy problem(&manual, &ManualWindow::problem);
    auto* text = manual.findChild<QTextBrowser*>(QStringLiteral("manualText"));
    const QUrl link(QStringLiteral("https://example.org/a"));
    const test::FakeOpener desktop, broken({}, "/nowhere/sh");
    manual.desktop().setOpener(desktop.opener());
    emit text->anchorClicked(link);
    EXPECT_TRUE(test::waitFor([&] { return desktop.asked() == link; }));
    EXPECT_EQ(problem.count(), 0);
    manual.desktop().setOpener(broken.opener());
    emit text->anchorClicked(link);
    ASSERT_TRUE(test::waitFor([&] { return problem.count() == 1; }));
    EXPECT_TRUE(problem[0][0].toString().contains(link.toString()));
}

// Catches a page that stays in the language before, a link and a search that leave the language, an anchor in
// English that leads nowhere, and an English page that does not say why it is one.
TEST_F(HelpTest, TheManualSpeaksTheWindowsLanguage) {
    Language language;
    language.set(QStringLiteral("en"));
    ManualWindow manual(language, nullptr);
    auto* text = manual.findChild<QTextBrowser*>(QStringLiteral("manualText"));
    const auto begins = [&](const char* words) {
        return text->toPlainText().startsWith(QString::fromUtf8(words));
    };
    manual.open(QStringLiteral("safety.md"));
    const QScrollBar& bar = *text->verticalScrollBar();
    text->verticalScrollBar()->setValue(bar.maximum() / 2);
    language.set(QStringLiteral("fr"));
    QCoreApplication::sendPostedEvents();
    EXPECT_TRUE(begins("Ce que le moteur surveille"));
    EXPECT_NEAR(bar.value(), bar.maximum() / 2.0, 0.05 * bar.maximum());
    emit text->anchorClicked(QUrl(QStringLiteral("../experiment-format.md#safety")));
    EXPECT_TRUE(begins("Cette page n’existe qu’en anglais."));
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("safety"));
    manual.open(QStringLiteral("manual.md#metrics"));
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("Grandeurs"));
    emit text->anchorClicked(QUrl(QStringLiteral("#les-cinq-premières-minutes")));
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("Les cinq premières minutes"));
    auto* find = manual.findChild<QLineEdit*>(QStringLiteral("manualFind"));
    find->setText(QString::fromUtf8("clé qui n’y est pas"));
    emit find->returnPressed();
    EXPECT_EQ(text->textCursor().block().text(), QStringLiteral("Les cinq premières minutes")) << "stays";
    find->setText(QStringLiteral("chien de garde"));
    emit find->returnPressed();
    EXPECT_EQ(text->textCursor().selectedText(), QStringLiteral("chien de garde"));
    language.set(QStringLiteral("zh_TW"));
    manual.open(QStringLiteral("safety.md"));
    QCoreApplication::sendPostedEvents();
    EXPECT_TRUE(begins("引擎監視什麼"));
    language.set(QStringLiteral("en"));
    QCoreApplication::sendPostedEvents();
    EXPECT_TRUE(begins("What the engine watches"));
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
