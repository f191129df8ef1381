// The list of recorded runs with the files behind it.

#include "app/examples.h"
#include "app/resources.h"
#include "app/session_library.h"
#include "engine/base/message_code.h"
#include "engine/recording/session_store.h"
#include "tests/support/wait_for.h"
#include "widgets/review/session_list.h"

#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

#include <algorithm>

namespace bask::test {
namespace {

constexpr const char* kCommand = "{\"kp\":1.25}"; ///< of each run: on a page that a list does not read

class SessionLibraryTest : public testing::Test {
protected:
    void SetUp() override {
        initResources();
        QObject::connect(&library, &SessionLibrary::problem,
                         [this](const QString& sentence) { problems << sentence; });
        list.show();
    }

    /// A short run; without an outcome as a crash leaves it.
    QString record(const QString& name, const std::string& outcome) {
        const QString path = folder.filePath(name);
        auto writer = SessionWriter::create(path.toStdString(), readExample("three-objects").value(), true,
                                            0.5, SessionWriter::Earlier::Replaced);
        EXPECT_TRUE(writer);
        for (int k = 0; k < 20; ++k) {
            TraceSample sample;
            sample.time_s = 0.1 * k;
            sample.objects.resize(3);
            EXPECT_TRUE((*writer)->add(sample));
        }
        EXPECT_TRUE((*writer)->add(CommandRow{0.0, "gains", kCommand}));
        if (!outcome.empty()) {
            EXPECT_TRUE((*writer)->finish(outcome));
        }
        return path;
    }
    /// A page that a list does not read.
    static void writeOver(const QString& path) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::ReadWrite));
        constexpr qsizetype kPage = 16384; // as SessionWriter has it
        const qsizetype place = file.readAll().indexOf(kCommand);
        ASSERT_GT(place, kPage);
        ASSERT_TRUE(file.seek(place / kPage * kPage));
        ASSERT_EQ(file.write(QByteArray(kPage, '\x55')), kPage);
    }
    bool waitForRows(int rows) {
        return waitFor([&] { return tree->topLevelItemCount() == rows; });
    }
    QString cell(const QString& path, int column) {
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (tree->topLevelItem(k)->toolTip(0) == path)
                return tree->topLevelItem(k)->text(column);
        return {};
    }
    void choose(const QString& path) {
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (tree->topLevelItem(k)->toolTip(0) == path)
                tree->setCurrentItem(tree->topLevelItem(k));
    }

    QTemporaryDir folder;
    SessionList list;
    SessionLibrary library{list};
    QTreeWidget* tree = list.findChild<QTreeWidget*>("sessionTree");
    QStringList problems;
};

// Catches: a folder that is not read, tags that do not reach the file, an interrupted run that stays one.
TEST_F(SessionLibraryTest, RunsAreListedTaggedAndClosed) {
    const QString a = record("a.bask", "settled"), cut = record("cut.bask", "");
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    EXPECT_EQ(cell(cut, 2), "Interrupted");

    choose(a);
    auto* tags = list.findChild<QLineEdit*>("sessionTags");
    tags->setText("good, evening");
    QTest::keyClick(tags, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return readSessionHeader(a.toStdString()).tags.size() == 2; }));
    library.refresh();
    ASSERT_TRUE(waitFor([&] { return cell(a, 7) == "good, evening"; }));

    QString closed;
    QObject::connect(&library, &SessionLibrary::closed, [&](const QString& path) { closed = path; });
    choose(cut);
    QTest::mouseClick(list.findChild<QPushButton*>("messageAction"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return closed == cut; }));
    ASSERT_TRUE(waitFor([&] { return list.findChild<QLineEdit*>("sessionTags")->isEnabled(); }));
    EXPECT_EQ(readSession(cut.toStdString())->outcome, kOutcomeInterrupted);
    EXPECT_TRUE(problems.isEmpty()) << problems.join('\n').toStdString();
}

// Catches: a copy that is listed as if it were the run that it was copied from, and facts that are not read.
TEST_F(SessionLibraryTest, ACopyIsListedByItsName) {
    const QString run = record("20260314T092653Z.bask", "settled");
    const QString copy = folder.filePath("figure 3.bask");
    ASSERT_TRUE(copySession(run.toStdString(), copy.toStdString()));
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    const std::string title = readSessionHeader(run.toStdString()).title;
    ASSERT_FALSE(title.empty());
    EXPECT_EQ(cell(run, 1).toStdString(), title);
    EXPECT_EQ(cell(copy, 1), "figure 3");
    auto* search = list.findChild<QLineEdit*>("sessionSearch");
    for (const auto& [words, isFound] : {std::pair{"PLA Level", true}, std::pair{"PLA Adaptive", false}}) {
        search->setText(words); // a material and a controller
        for (int k = 0; k < 2; ++k)
            EXPECT_EQ(tree->topLevelItem(k)->isHidden(), !isFound) << words;
    }
}

// Catches: a run that was written over where a list does not read, and is listed as settled.
TEST_F(SessionLibraryTest, ADamagedRunIsListedAsSuchOnceItIsSelected) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled");
    writeOver(a);
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    choose(b);
    choose(a);
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Damaged"; }));
    EXPECT_EQ(cell(b, 2), "Settled");
}

// Catches: an altered run that is listed as settled once it is known, and one that stays so as another file.
TEST_F(SessionLibraryTest, AnAlteredRunIsListedAsSuch) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled");
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    SessionVerdict verdict;
    verdict.hasChain = true;
    verdict.findings = {{SessionFinding::Kind::Changed, "step", 12, 1.1}};
    verdict.allFindings = 1;
    library.takeVerdict(a, verdict);
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Altered"; }));
    EXPECT_EQ(cell(b, 2), "Settled");
    library.refresh();
    choose(a);
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Altered"; }));
    EXPECT_TRUE(list.findChild<QLabel*>("message")->text().contains("row 12"));
    ASSERT_TRUE(QFile::remove(a));
    ASSERT_TRUE(QFile::copy(b, a));
    library.refresh();
    EXPECT_TRUE(waitFor([&] { return cell(a, 2) == "Settled"; })) << "another file";
}

// Catches: an outcome that nobody has verified and that looks as if it were; runs that stay so while there is
// time; and one that was altered before Bask was started, listed as settled.
TEST_F(SessionLibraryTest, ListedRunsAreVerifiedWhileThereIsTime) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled");
    {
        const auto store = SessionStore::create(b.toStdString());
        ASSERT_TRUE(store);
        ASSERT_TRUE((*store)->execute("UPDATE command SET value = '{\"kp\":9.25}'"));
    }
    const auto row = [this](const QString& path) -> QTreeWidgetItem* {
        for (int k = 0; k < tree->topLevelItemCount(); ++k)
            if (tree->topLevelItem(k)->toolTip(0) == path)
                return tree->topLevelItem(k);
        return nullptr;
    };
    library.setPaused(true);
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    for (const QString& path : {a, b}) {
        EXPECT_TRUE(row(path)->font(2).italic());
        EXPECT_EQ(row(path)->data(2, Qt::AccessibleTextRole).toString(), "Settled, not verified");
        EXPECT_TRUE(row(path)->toolTip(2).contains("Not verified"));
    }
    QTest::qWait(600);
    EXPECT_TRUE(row(a)->font(2).italic()) << "something else is to be done";
    library.setPaused(false);
    ASSERT_TRUE(waitFor([&] { return !row(a)->font(2).italic(); }));
    EXPECT_FALSE(row(a)->data(2, Qt::AccessibleTextRole).isValid());
    EXPECT_EQ(row(a)->toolTip(2), "Settled");
    ASSERT_TRUE(waitFor([&] { return cell(b, 2) == "Altered"; }));
    library.refresh();
    QTest::qWait(300);
    EXPECT_FALSE(row(a)->font(2).italic()) << "known until the file changes";
    EXPECT_TRUE(problems.isEmpty());
}

// Catches: a walk through the list with the arrow keys that has each run on the way looked at.
TEST_F(SessionLibraryTest, ARunThatIsNoLongerSelectedIsNotLookedAt) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled"),
                  busy = record("busy.bask", "settled");
    writeOver(a);
    writeOver(b);
    library.setPaused(true);
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(3));
    const auto store = SessionStore::create(busy.toStdString());
    ASSERT_TRUE(store);
    ASSERT_TRUE((*store)->execute("BEGIN EXCLUSIVE"));
    emit list.tagsEdited(busy, {"waits"}); // holds up what comes after it
    choose(a);
    choose(b);
    ASSERT_TRUE((*store)->execute("ROLLBACK"));
    ASSERT_TRUE(waitFor([&] { return cell(b, 2) == "Damaged"; }));
    EXPECT_EQ(cell(a, 2), "Settled") << "passed over";
}

// Catches: damage of a run that was opened through a link, and is listed as settled.
TEST_F(SessionLibraryTest, DamageIsListedByWhateverPathTheRunWasOpened) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled");
    const QTemporaryDir elsewhere;
    const QString link = elsewhere.filePath("folder");
    ASSERT_TRUE(QFile::link(folder.path(), link));
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(2));
    library.takeDamage(Error(MessageCode::SessionDamaged, (link + "/a.bask").toStdString(), {kNotWhole}));
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Damaged"; }));
    EXPECT_EQ(cell(b, 2), "Settled");
}

// Catches: damage that is forgotten while another folder is listed, or was found before its folder was.
TEST_F(SessionLibraryTest, DamageIsRememberedForOtherFolders) {
    const QString a = record("a.bask", "settled"), b = record("b.bask", "settled"),
                  c = record("c.bask", "settled");
    const QTemporaryDir empty;
    library.takeDamage(Error(MessageCode::SessionDamaged, b.toStdString(), {kNotWhole}));
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(3));
    EXPECT_EQ(cell(b, 2), "Damaged") << "it was opened before";
    writeOver(a); // after it was listed
    choose(a);
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Damaged"; }));
    library.setFolder(empty.path());
    ASSERT_TRUE(waitForRows(0));
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(3));
    EXPECT_EQ(cell(a, 2), "Damaged");
    EXPECT_EQ(cell(b, 2), "Damaged");
    EXPECT_EQ(cell(c, 2), "Settled");
    ASSERT_TRUE(QFile::remove(a));
    ASSERT_TRUE(QFile::copy(c, a));
    library.refresh();
    EXPECT_TRUE(waitFor([&] { return cell(a, 2) == "Settled"; })) << "another file";
}

// Catches: a list that is read anew for each time that the same damage is met.
TEST_F(SessionLibraryTest, KnownDamageIsNotListedAnew) {
    const QString a = record("a.bask", "settled");
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(1));
    QSignalSpy listed(&list, &SessionList::sessionsChanged);
    const Error damage(MessageCode::SessionDamaged, a.toStdString(), {kNotWhole});
    library.takeDamage(damage);
    ASSERT_TRUE(waitFor([&] { return cell(a, 2) == "Damaged"; }));
    bool isDone = false;
    QObject::connect(&library, &SessionLibrary::overlayRead, [&] { isDone = true; });
    library.takeDamage(damage);
    emit list.compareRequested(a); // after it
    ASSERT_TRUE(waitFor([&] { return isDone; }));
    EXPECT_FALSE(list.findChild<QLabel*>("sessionCount")->text().startsWith("Reading"));
    EXPECT_EQ(listed.count(), 1);
}

/// How often an object was called from another thread.
class CallCount : public QObject {
public:
    int calls = 0;

protected:
    bool eventFilter(QObject* object, QEvent* event) override {
        calls += event->type() == QEvent::MetaCall ? 1 : 0;
        return QObject::eventFilter(object, event);
    }
};

// Catches: a folder that is read anew for each of many damaged runs, and a list that is filled as often.
TEST_F(SessionLibraryTest, ManyDamagedRunsAreListedAtOnce) {
    constexpr int kRuns = 8;
    const QString first = record("run0.bask", "settled");
    for (int k = 1; k < kRuns; ++k)
        ASSERT_TRUE(QFile::copy(first, folder.filePath(QStringLiteral("run%1.bask").arg(k))));
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(kRuns));
    const QSignalSpy filled(tree->model(), &QAbstractItemModel::modelReset);
    CallCount answers; // of the thread that looks at files
    library.installEventFilter(&answers);
    const std::vector<std::string> runs = sessionFiles(folder.path().toStdString());
    for (const std::string& run : runs)
        library.takeDamage(Error(MessageCode::SessionDamaged, run, {kNotWhole}));
    ASSERT_TRUE(waitFor([&] {
        return std::ranges::all_of(
            runs, [&](const std::string& run) { return cell(QString::fromStdString(run), 2) == "Damaged"; });
    }));
    EXPECT_LE(answers.calls, kRuns + 1) << "of each file, and one list";
    EXPECT_LE(filled.count(), 2) << "the first may be known before the others are asked about";
}

// Catches: a refused change that stays on the screen as if it had been written.
TEST_F(SessionLibraryTest, WhatCannotBeWrittenIsToldAndTakenBack) {
    const QString a = record("a.bask", "settled");
    library.setFolder(folder.path());
    ASSERT_TRUE(waitForRows(1));
    choose(a);
    ASSERT_TRUE(QFile::remove(a));
    auto* tags = list.findChild<QLineEdit*>("sessionTags");
    tags->setText("lost");
    QTest::keyClick(tags, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_TRUE(problems[0].contains("a.bask")) << problems[0].toStdString();
    EXPECT_TRUE(waitForRows(0));
}

// Catches: an overlay that is not read, and an error of one that is not told.
TEST_F(SessionLibraryTest, AnOverlayIsReadOrRefused) {
    const QString a = record("a.bask", "settled");
    QFile bad(folder.filePath("bad.bask"));
    ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
    bad.write("nothing");
    bad.close();
    std::shared_ptr<RecordedSession> read;
    QObject::connect(&library, &SessionLibrary::overlayRead,
                     [&](const std::shared_ptr<RecordedSession>& session) { read = session; });
    emit list.compareRequested(a);
    ASSERT_TRUE(waitFor([&] { return read != nullptr; }));
    EXPECT_EQ(read->size(), 20U);
    emit list.compareRequested(bad.fileName());
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
}

// Catches: a folder of hundreds that takes long, above all the second time, or that keeps the window waiting.
TEST_F(SessionLibraryTest, FiveHundredFilesAreListedQuickly) {
    const QString first = record("run0.bask", "settled");
    for (int k = 1; k < 500; ++k)
        ASSERT_TRUE(QFile::copy(first, folder.filePath(QStringLiteral("run%1.bask").arg(k))));
    QElapsedTimer timer;
    timer.start();
    library.setFolder(folder.path());
    EXPECT_LT(timer.elapsed(), 1000) << "reading is not the window's work";
    ASSERT_TRUE(waitForRows(500));
    RecordProperty("first_ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 100'000);
    QFile::remove(folder.filePath("run7.bask"));
    timer.restart();
    library.refresh();
    ASSERT_TRUE(waitForRows(499));
    RecordProperty("again_ms", std::to_string(timer.elapsed()));
    EXPECT_LT(timer.elapsed(), 20'000);
}

// Catches: an end that waits for hundreds of files, or is told of one when it is gone.
TEST_F(SessionLibraryTest, ItEndsInTheMidstOfAFolder) {
    const QString first = record("run0.bask", "settled");
    for (int k = 1; k < 200; ++k)
        ASSERT_TRUE(QFile::copy(first, folder.filePath(QStringLiteral("run%1.bask").arg(k))));
    QElapsedTimer timer;
    {
        SessionList other;
        SessionLibrary brief(other);
        brief.setFolder(folder.path());
        timer.start();
    }
    EXPECT_LT(timer.elapsed(), 10'000);
    QCoreApplication::processEvents();
}

} // namespace
} // namespace bask::test
