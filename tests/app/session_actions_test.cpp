#include "app/examples.h"
#include "app/resources.h"
#include "app/session_actions.h"
#include "app/settings_store.h"
#include "tests/support/held_pool.h"
#include "tests/support/wait_for.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/trace_plot.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QWidget>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>

namespace bask::test {
namespace {

class SessionActionsTest : public testing::Test {
protected:
    void SetUp() override {
        initResources();
        setFileFolders(&settings);
        QObject::connect(&files, &SessionActions::problem,
                         [this](const QString& sentence) { problems << sentence; });
    }
    void TearDown() override { setFileFolders(nullptr); }
    Document document;
    SettingsStore settings;
    SessionActions files{document, settings, nullptr};
    QStringList problems;
};

// Catches: an example that was changed and can no longer be read, or whose contours are not in the binary.
TEST_F(SessionActionsTest, EveryExampleReads) {
    const QStringList names = exampleNames();
    ASSERT_FALSE(names.isEmpty());
    EXPECT_EQ(names.first(), QStringLiteral("three-objects"));
    for (const QString& name : names) {
        const auto read = readExample(name);
        EXPECT_TRUE(read.ok()) << name.toStdString() << ": " << (read.ok() ? "" : describe(read.error()));
    }
}

TEST_F(SessionActionsTest, TheFirstExampleIsTheOneOfTheManual) {
    files.openExample(QStringLiteral("three-objects"));
    ASSERT_TRUE(waitFor([&] { return document.experiment().objects.size() == 3; }));
    EXPECT_EQ(document.experiment().objects[0].name, "circle");
    EXPECT_EQ(document.experiment().objects[1].name, "bunny");
    EXPECT_EQ(document.experiment().objects[2].name, "hand");
    EXPECT_TRUE(document.path().isEmpty());
}

// Catches: a truncated or foreign session shown as a run.
TEST_F(SessionActionsTest, WhatIsNoSessionIsRefusedByName) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("cut.bask"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("SQLite format 3");
    file.close();
    files.open(path);
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_TRUE(problems[0].contains(QStringLiteral("cut.bask"))) << problems[0].toStdString();
}

TEST_F(SessionActionsTest, AMissingFileLeavesTheRecentList) {
    settings.addRecentFile(QStringLiteral("/nowhere/gone.json"));
    files.open(QStringLiteral("/nowhere/gone.json"));
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_FALSE(settings.recentFiles().contains(QStringLiteral("/nowhere/gone.json")));
}

// Catches: limits of a real rig that come in with a file, unasked; and a question on the way down.
TEST_F(SessionActionsTest, LooserLimitsOfARealRigAreAskedAbout) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("rig.json"));
    ASSERT_TRUE(QFile::copy(QStringLiteral(BASK_TEST_DATA "/rig/three-thin-disks.json"), path));
    QWidget window;
    SessionActions asking(document, settings, &window);
    const auto box = [&] { return window.findChild<QMessageBox*>(QStringLiteral("limitsOfFile")); };
    asking.open(path);
    ASSERT_TRUE(waitFor([&] { return box() != nullptr; }));
    EXPECT_TRUE(box()->text().contains(QStringLiteral("0.2 rad/s"))) << box()->text().toStdString();
    EXPECT_EQ(box()->buttonRole(box()->defaultButton()), QMessageBox::RejectRole);
    EXPECT_FALSE(document.experiment().rig);
    box()->defaultButton()->click();
    EXPECT_FALSE(document.experiment().rig);
    asking.open(path);
    ASSERT_TRUE(waitFor([&] { return box() != nullptr && box()->isVisible(); }));
    for (QAbstractButton* button : box()->buttons())
        if (box()->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    ASSERT_TRUE(document.experiment().rig);
    EXPECT_EQ(document.path(), path);
    const int before = document.generation();
    asking.open(path); // nothing more than now
    ASSERT_TRUE(waitFor([&] { return document.generation() != before; }));
}

// Catches: a file with a slip in it that must be looked for again once it is mended.
TEST_F(SessionActionsTest, ABadFileStaysInTheRecentList) {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bad.json"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{");
    file.close();
    settings.addRecentFile(path);
    files.open(path);
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_EQ(settings.recentFiles().value(0), path);
}

// Catches: two runs armed in one second recorded over each other.
TEST_F(SessionActionsTest, RecordingsNeverShareAName) {
    const QString first = files.nextRecordingPath();
    ASSERT_FALSE(first.isEmpty());
    QFile file(first);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    EXPECT_NE(files.nextRecordingPath(), first);
}

// Catches: a rig that cannot be taken from one experiment to another, and a bad rig file that is not told by
// its name.
TEST_F(SessionActionsTest, ARigGoesThroughItsFile) {
    const QTemporaryDir folder;
    Experiment experiment = Document::blank();
    experiment.rig.emplace().name = "bench";
    experiment.rig->source.emplace();
    document.open(experiment, {});
    std::vector<RigSpec> read;
    QObject::connect(&files, &SessionActions::rigRead, [&](const RigSpec& rig) { read.push_back(rig); });
    FileQuestion::Kind asked = FileQuestion::Kind::Folder;
    files.setFileChooser([&](const FileQuestion& question) {
        asked = question.kind;
        return folder.filePath(QStringLiteral("bench")); // without the suffix, as people type it
    });
    files.saveRig();
    EXPECT_EQ(asked, FileQuestion::Kind::SaveFile);
    ASSERT_TRUE(QFile::exists(folder.filePath(QStringLiteral("bench.json"))));
    files.setFileChooser([&](const FileQuestion&) { return folder.filePath(QStringLiteral("bench.json")); });
    files.openRig();
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read.back(), *experiment.rig);
    EXPECT_TRUE(problems.isEmpty());

    files.open(folder.filePath(QStringLiteral("bench.json"))); // as after a drop: known by what it says
    EXPECT_EQ(read.size(), 2U);
    files.setRunGuard([] { return true; });
    files.openRig();
    EXPECT_EQ(read.size(), 2U) << "other devices under a run";
    EXPECT_EQ(problems.size(), 1);
    problems.clear();
    files.setRunGuard({});
    read.resize(1);

    QFile file(folder.filePath(QStringLiteral("bench.json")));
    ASSERT_TRUE(file.resize(file.size() / 2));
    files.openRig();
    EXPECT_EQ(read.size(), 1U);
    ASSERT_EQ(problems.size(), 1);
    EXPECT_TRUE(problems[0].contains(QStringLiteral("bench.json"))) << problems[0].toStdString();
}

/// A short run of an example, recorded and closed.
QString recorded(const QTemporaryDir& folder) {
    const QString path = folder.filePath(QStringLiteral("my \"run\" <b>.bask"));
    const Experiment experiment = readExample(QStringLiteral("two-circles")).value();
    const auto writer = SessionWriter::create(path.toStdString(), experiment, true);
    for (int k = 0; k < 5; ++k) {
        TraceSample sample;
        sample.time_s = k;
        sample.coordinates = experiment.start;
        sample.source = experiment.source.pose;
        for (const ObjectSpec& object : experiment.objects) {
            ObjectSample row;
            row.measured_K = row.estimated_K = row.true_K = row.target_K = object.target_K;
            row.rate_K_s = 1.0 / 3.0;
            sample.objects.push_back(row);
        }
        EXPECT_TRUE((*writer)->add(sample));
    }
    EXPECT_TRUE((*writer)->finish("settled"));
    return path;
}

/// Presses a button of the question that comes next.
void answerQuestion(QMessageBox::ButtonRole role) {
    QTimer::singleShot(0, [role] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        ASSERT_NE(box, nullptr) << "nothing was asked";
        for (QAbstractButton* button : box->buttons())
            if (box->buttonRole(button) == role)
                return button->click();
    });
}

// Catches: a recorded experiment that would be saved over another file, comes in under a run, or replaces
// edits unasked.
TEST_F(SessionActionsTest, ARecordedExperimentOpensAsANewOne) {
    const QTemporaryDir folder;
    const QString path = recorded(folder);
    const Experiment ran = readExample(QStringLiteral("two-circles")).value();
    const Experiment before = Document::blank();
    QStringList told;
    QObject::connect(&files, &SessionActions::told, [&](const QString& sentence) { told << sentence; });
    document.open(before, QStringLiteral("/tmp/mine.json"));
    bool runIsOn = true;
    files.setRunGuard([&] { return runIsOn; });
    files.openAsNew(path);
    files.open(QStringLiteral("/tmp/other.json"));
    ASSERT_EQ(problems.size(), 2);
    EXPECT_EQ(problems[0], problems[1]) << "what File > Open says";
    EXPECT_EQ(document.experiment(), before);

    runIsOn = false;
    problems.clear();
    files.openAsNew(QStringLiteral("/nowhere/gone.bask"));
    ASSERT_TRUE(waitFor([&] { return !problems.isEmpty(); }));
    EXPECT_TRUE(problems[0].contains(QStringLiteral("gone.bask"))) << problems[0].toStdString();
    EXPECT_EQ(document.experiment(), before);

    files.openAsNew(path);
    ASSERT_TRUE(waitFor([&] { return document.path().isEmpty(); }));
    EXPECT_EQ(document.experiment().title, ran.title);
    ASSERT_EQ(document.experiment().objects.size(), ran.objects.size());
    EXPECT_EQ(document.experiment().objects[1].name, ran.objects[1].name);
    EXPECT_TRUE(document.modified()) << "it has no file";
    EXPECT_EQ(document.toUndo(), nullptr);
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told[0].contains(QStringLiteral("my \"run\" <b>.bask"))) << told[0].toStdString();
    EXPECT_FALSE(settings.recentFiles().contains(path)) << "it was not opened itself";

    Experiment edited = document.experiment();
    edited.title = "edited since";
    ASSERT_TRUE(document.edit(edited));
    const auto session = RecordedSession::open(path.toStdString());
    ASSERT_TRUE(session);
    answerQuestion(QMessageBox::RejectRole);
    files.openAsNew((*session)->facts());
    EXPECT_EQ(document.experiment().title, "edited since");
    answerQuestion(QMessageBox::DestructiveRole);
    files.openAsNew((*session)->facts());
    EXPECT_EQ(document.experiment().title, ran.title);
    EXPECT_EQ(document.toUndo(), nullptr);
}

// Catches: a dialog that starts where files of another kind were used last.
TEST_F(SessionActionsTest, EachKindOfFilesIsAskedForInItsFolder) {
    const QTemporaryDir experiments, recordings, others, exports;
    int opened = 0, written = 0;
    QObject::connect(&files, &SessionActions::sessionOpened, [&] { ++opened; });
    QObject::connect(&files, &SessionActions::exported, [&] { ++written; });
    QString answer, asked;
    files.setFileChooser([&](const FileQuestion& question) {
        asked = question.kind == FileQuestion::Kind::SaveFile ? QFileInfo(question.folder).path()
                                                              : question.folder;
        return answer;
    });
    answer = recorded(recordings);
    files.askAndOpenSession();
    ASSERT_TRUE(waitFor([&] { return opened == 1; }));
    answer = experiments.filePath(QStringLiteral("mine"));
    document.open(Document::blank(), {});
    ASSERT_TRUE(files.save());
    answer = exports.path();
    files.exportSession(SessionForm::Csv);
    ASSERT_TRUE(waitFor([&] { return written + problems.size() == 1; }));
    EXPECT_EQ(written, 1) << problems.join('\n').toStdString();
    answer = recorded(others);
    files.askAndOpen();
    ASSERT_TRUE(waitFor([&] { return opened == 2; }));

    answer.clear(); // all are cancelled now
    document.open(Document::blank(), {});
    const std::pair<std::function<void()>, QString> cases[] = {
        {[&] { files.askAndOpen(); }, experiments.path()},
        {[&] { files.saveAs(); }, experiments.path()},
        {[&] { files.openRig(); }, experiments.path()},
        {[&] { files.askAndOpenSession(); }, others.path()},
        {[&] { files.exportSession(SessionForm::Nexus); }, exports.path()},
        {[&] { files.exportSession(SessionForm::ReportPdf); }, exports.path()},
        {[&] { files.exportComparison(QStringLiteral("a,b\n")); }, exports.path()},
        {[&] { files.saveReport(QStringLiteral("text")); }, exports.path()}};
    for (std::size_t k = 0; k < std::size(cases); ++k) {
        asked.clear();
        cases[k].first();
        EXPECT_EQ(asked.toStdString(), cases[k].second.toStdString()) << k;
    }
}

// Catches: an export that does nothing, asks for the wrong thing or fails without a word.
TEST_F(SessionActionsTest, TheOpenSessionIsExportedInEveryForm) {
    const QTemporaryDir folder;
    int opened = 0;
    QStringList told, written;
    QObject::connect(&files, &SessionActions::sessionOpened, [&] { ++opened; });
    QObject::connect(&files, &SessionActions::exported, [&](const QString& text, const QStringList& paths) {
        told << text;
        written << paths;
    });
    QStringList asked;
    QString folderOfAnswers = folder.path();
    files.setFileChooser([&](const FileQuestion& question) {
        asked << QFileInfo(question.folder).fileName();
        return question.kind == FileQuestion::Kind::Folder
                   ? folderOfAnswers
                   : folderOfAnswers + u'/' + asked.last().section(u'.', 0, -2); // suffix left out
    });
    files.exportSession(SessionForm::Csv);
    EXPECT_TRUE(asked.isEmpty()) << "no session is open";
    files.open(recorded(folder));
    ASSERT_TRUE(waitFor([&] { return opened == 1; }));
    constexpr std::array kForms{SessionForm::Csv,     SessionForm::Nexus,     SessionForm::Vtk,
                                SessionForm::Figures, SessionForm::ReportPdf, SessionForm::ReportHtml};
    for (const SessionForm form : kForms) // all at the same time
        files.exportSession(form);
    ASSERT_TRUE(waitFor([&] { return told.size() == 6 || !problems.isEmpty(); }));
    EXPECT_TRUE(problems.isEmpty()) << problems.join('\n').toStdString();
    const QString own =
        folder.filePath(QStringLiteral("my \"run\" <b>")); // other runs' files have the same names
    for (const char* name : {"traces.csv", "outlines.pvd", "errors.svg"})
        EXPECT_TRUE(QFile::exists(own + u'/' + QLatin1String(name))) << name;
    for (const char* name : {"my \"run\" <b>.nxs", "my \"run\" <b>.pdf", "my \"run\" <b>.html"})
        EXPECT_TRUE(QFile::exists(folder.filePath(QString::fromUtf8(name)))) << name;
    EXPECT_TRUE(written.contains(folder.filePath(QStringLiteral("my \"run\" <b>.pdf"))));
    EXPECT_TRUE(told.contains(QStringLiteral("my \"run\" <b>.pdf written to %1").arg(folder.path())))
        << told.join('\n').toStdString();
    EXPECT_TRUE(written.contains(own + QStringLiteral("/traces.csv")));
    for (const QString& file : written)
        EXPECT_TRUE(QFile::exists(file)) << file.toStdString();

    folderOfAnswers = folder.filePath(QStringLiteral("all/my \"run\" <b>")); // the run's own: taken as it is
    files.exportSession(SessionForm::CsvAllDigits);
    ASSERT_TRUE(waitFor([&] { return told.size() == 7 || !problems.isEmpty(); }));
    EXPECT_GT(QFileInfo(folderOfAnswers + QStringLiteral("/traces.csv")).size(),
              QFileInfo(own + QStringLiteral("/traces.csv")).size());

    folderOfAnswers = QStringLiteral("/proc/no-such-place");
    for (const SessionForm form : kForms)
        files.exportSession(form);
    ASSERT_TRUE(waitFor([&] { return problems.size() == 6; })) << problems.join('\n').toStdString();
    for (const QString& problem : problems)
        EXPECT_TRUE(problem.contains(QStringLiteral("/proc/no-such-place"))) << problem.toStdString();
}

// Catches: a comparison that is not written, or is written over what Bask has not made.
TEST_F(SessionActionsTest, AComparisonIsSaved) {
    const QTemporaryDir folder;
    QStringList told, written;
    QObject::connect(&files, &SessionActions::exported, [&](const QString& text, const QStringList& paths) {
        told << text;
        written << paths;
    });
    QString answer = folder.filePath(QStringLiteral("two")); // without the suffix
    files.setFileChooser([&](const FileQuestion&) { return answer; });
    const QString csv = QStringLiteral("metric,object,A,B,B - A\nfinal (degC),h\u00e4nd,40,41,1\n");
    files.exportComparison(csv);
    ASSERT_TRUE(waitFor([&] { return told.size() + problems.size() == 1; }));
    EXPECT_TRUE(told.value(0).contains(QStringLiteral("two.csv"))) << problems.join('\n').toStdString();
    EXPECT_EQ(written, QStringList{folder.filePath(QStringLiteral("two.csv"))});
    QFile file(folder.filePath(QStringLiteral("two.csv")));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(QString::fromUtf8(file.readAll()), csv);
    file.close();
    files.exportComparison(csv);
    ASSERT_TRUE(waitFor([&] { return told.size() + problems.size() == 2; }));
    EXPECT_EQ(told.size(), 2) << "an earlier one is replaced";

    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("my own table");
    file.close();
    files.exportComparison(csv);
    ASSERT_TRUE(waitFor([&] { return problems.size() == 1; }));
    EXPECT_TRUE(problems[0].contains(QStringLiteral("two.csv")));
    answer.clear();
    files.exportComparison(csv);
    EXPECT_EQ(told.size(), 2) << "cancelled";
}

// Catches: a plot that is not written in the chosen form, is written over what Bask has not made, or is drawn
// under a run.
TEST_F(SessionActionsTest, APlotIsExported) {
    const QTemporaryDir folder;
    PlotPlace place(new TracePlot);
    place.plot()->setObjects({QStringLiteral("disk")});
    TraceSample sample;
    sample.time_s = 1.0;
    ObjectSample object;
    object.measured_K = 300.0;
    object.valid = true;
    sample.objects = {object};
    place.plot()->append({sample});
    QStringList written;
    bool runIsOn = false;
    files.setRunGuard([&] { return runIsOn; });
    QObject::connect(&files, &SessionActions::exported,
                     [&](const QString&, const QStringList& paths) { written << paths; });
    QString proposed;
    files.setFileChooser([&](const FileQuestion& question) {
        proposed = QFileInfo(question.folder).fileName();
        return folder.filePath(QStringLiteral("plot")); // without the suffix
    });
    for (const auto& [form, ending] : {std::pair{PlotForm::Pdf, "pdf"}, std::pair{PlotForm::Svg, "svg"},
                                       std::pair{PlotForm::Png, "png"}, std::pair{PlotForm::Csv, "csv"}}) {
        for (int times = 0; times < 2; ++times) { // an earlier one is replaced
            written.clear();
            files.exportPlot(place, form);
            ASSERT_TRUE(waitFor([&] { return written.size() + problems.size() > 0; }));
            EXPECT_TRUE(problems.isEmpty()) << problems.join('\n').toStdString();
            EXPECT_EQ(written, QStringList{folder.filePath(QStringLiteral("plot.") + QLatin1String(ending))});
            EXPECT_EQ(proposed, QStringLiteral("temperatures.") + QLatin1String(ending));
        }
    }
    QFile foreign(folder.filePath(QStringLiteral("plot.svg")));
    ASSERT_TRUE(foreign.open(QIODevice::WriteOnly));
    foreign.write("my own drawing");
    foreign.close();
    files.exportPlot(place, PlotForm::Svg);
    ASSERT_TRUE(waitFor([&] { return problems.size() == 1; }));
    foreign.setFileName(folder.filePath(QStringLiteral("plot.csv")));
    for (const char* other :
         {"time (s),volts\n1,2\n", "time (s),source (degC),note\n1,20,\"exported by Bask\"\n"}) {
        problems.clear();
        ASSERT_TRUE(foreign.open(QIODevice::WriteOnly));
        foreign.write(other);
        foreign.close();
        files.exportPlot(place, PlotForm::Csv);
        ASSERT_TRUE(waitFor([&] { return problems.size() == 1; })) << other;
        ASSERT_TRUE(foreign.open(QIODevice::ReadOnly));
        EXPECT_EQ(foreign.readAll(), other);
        foreign.close();
    }
    runIsOn = true;
    proposed.clear();
    files.exportPlot(place, PlotForm::Pdf);
    EXPECT_EQ(problems.size(), 2);
    EXPECT_TRUE(proposed.isEmpty()) << "a question whose answer is of no use";
}

// Catches: a dialog that asks whether to replace a file that is then refused, or replaces one without asking.
TEST_F(SessionActionsTest, ReplacingIsAskedOnce) {
    const QTemporaryDir folder;
    settings.setLastFolder(FileFolder::Exports, folder.path());
    const auto write = [&](const char* name, const QByteArray& bytes) {
        QFile file(folder.filePath(QLatin1String(name)));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    };
    write("mine.csv", "my own table\n");
    write("earlier.csv", "metric,object,A\n");
    QStringList shown, names{QStringLiteral("mine.csv"), QStringLiteral("earlier.csv")};
    const QWidget* last = nullptr;
    QTimer look;
    look.setInterval(10);
    look.callOnTimeout([&] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (dialog == nullptr || dialog == last)
            return;
        last = dialog;
        if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
            shown << box->objectName();
            EXPECT_EQ(box->textFormat(), Qt::PlainText) << "the name of the file is in it";
            for (QAbstractButton* button : box->buttons())
                if (box->buttonRole(button) == QMessageBox::AcceptRole)
                    return button->click();
        }
        if (auto* file = qobject_cast<QFileDialog*>(dialog)) {
            shown << names.front();
            file->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))
                ->setText(folder.filePath(names.takeFirst()));
            static_cast<QDialog*>(file)->accept();
        }
    });
    look.start();
    int written = 0;
    QObject::connect(&files, &SessionActions::exported, [&] { ++written; });
    files.exportComparison(QStringLiteral("metric,object,A,B,B - A\n"));
    EXPECT_EQ(shown.join(u' ').toStdString(), "mine.csv replaceRefusal earlier.csv replaceQuestion");
    ASSERT_TRUE(waitFor([&] { return written + problems.size() == 1; }));
    EXPECT_EQ(written, 1);
    QFile mine(folder.filePath(QStringLiteral("mine.csv")));
    ASSERT_TRUE(mine.open(QIODevice::ReadOnly));
    EXPECT_EQ(mine.readAll(), "my own table\n");

    const QByteArray large((1 << 20) + 1, 'x');
    write("large.csv", large);
    write("large.nxs", large);
    shown.clear();
    names = {QStringLiteral("large.csv")};
    files.exportComparison(QStringLiteral("metric,object,A,B,B - A\n"));
    EXPECT_EQ(shown.join(u' ').toStdString(), "large.csv replaceQuestion") << "the window would wait for it";
    ASSERT_TRUE(waitFor([&] { return problems.size() == 1; })) << "the export itself refuses it";
    int opened = 0;
    QObject::connect(&files, &SessionActions::sessionOpened, [&] { ++opened; });
    files.open(recorded(folder));
    ASSERT_TRUE(waitFor([&] { return opened == 1; }));
    shown.clear();
    names = {QStringLiteral("large.nxs"), QStringLiteral("new.nxs")};
    files.exportSession(SessionForm::Nexus);
    EXPECT_EQ(shown.join(u' ').toStdString(), "large.nxs replaceRefusal new.nxs") << "its first bytes tell";
    ASSERT_TRUE(waitFor([&] { return files.unfinishedExports().isEmpty(); }));
}

// Catches: a figure whose size is not the chosen one, is forgotten, or is asked for where it is of no use.
TEST_F(SessionActionsTest, TheSizeOfAFigureIsAskedForAndKept) {
    const QTemporaryDir folder;
    PlotPlace place(new TracePlot);
    int written = 0, asked = 0;
    QObject::connect(&files, &SessionActions::exported, [&] { ++written; });
    files.setFileChooser([&](const FileQuestion&) { return folder.filePath(QStringLiteral("plot")); });
    std::optional<FigureLayout> answer = FigureLayout{89.0, false};
    FigureLayout offered;
    files.setFigureChooser([&](const FigureLayout& last) {
        ++asked;
        offered = last;
        return answer;
    });
    files.exportPlot(place, PlotForm::Png);
    ASSERT_TRUE(waitFor([&] { return written + problems.size() == 1; }));
    const QImage image(folder.filePath(QStringLiteral("plot.png")));
    EXPECT_NEAR(1e3 * image.width() / std::max(1, image.dotsPerMeterX()), 89.0, 0.2);
    EXPECT_EQ(settings.figureLayout(), *answer);
    answer.reset();
    files.exportPlot(place, PlotForm::Pdf);
    EXPECT_EQ(offered, (FigureLayout{89.0, false})) << "the last one";
    EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("plot.pdf")))) << "cancelled";
    asked = 0;
    files.exportPlot(place, PlotForm::Csv);
    EXPECT_EQ(asked, 0) << "a table has no size on paper";
    ASSERT_TRUE(waitFor([&] { return written + problems.size() == 2; }));
}

// Catches: a plot that is written while another is, and of which nobody is told.
TEST_F(SessionActionsTest, PlotsExportedAtOnceAreAllTold) {
    const QTemporaryDir folder;
    PlotPlace place(new TracePlot);
    QStringList written;
    QObject::connect(&files, &SessionActions::exported,
                     [&](const QString&, const QStringList& paths) { written << paths; });
    files.setFileChooser(
        [&](const FileQuestion& question) { return folder.filePath(QFileInfo(question.folder).fileName()); });
    for (const PlotForm form : {PlotForm::Svg, PlotForm::Csv, PlotForm::Pdf})
        files.exportPlot(place, form);
    EXPECT_TRUE(waitFor([&] { return written.size() == 3 || !problems.isEmpty(); }, 20000));
    EXPECT_EQ(written.size(), 3) << problems.join('\n').toStdString();
    for (const QString& file : written)
        EXPECT_TRUE(QFile::exists(file)) << file.toStdString();
}

// Catches: an export that nobody knows to be under way, and one that is dropped for the next of its form.
TEST_F(SessionActionsTest, AnExportIsUnfinishedUntilItIsTold) {
    const QTemporaryDir folder, first, second;
    PlotPlace place(new TracePlot);
    int opened = 0, written = 0;
    QObject::connect(&files, &SessionActions::sessionOpened, [&] { ++opened; });
    QObject::connect(&files, &SessionActions::exported, [&] { ++written; });
    files.open(recorded(folder));
    ASSERT_TRUE(waitFor([&] { return opened == 1; }));
    QString answer;
    files.setFileChooser([&](const FileQuestion&) { return answer; });
    EXPECT_TRUE(files.unfinishedExports().isEmpty());
    HeldPool pool;
    const QString run = QStringLiteral("/my \"run\" <b>");
    QStringList places{first.path() + run, second.path() + run, folder.filePath(QStringLiteral("run.html")),
                       folder.filePath(QStringLiteral("again.html")),
                       folder.filePath(QStringLiteral("plot.csv"))};
    for (const QString& to : {places[0], places[1]}) {
        answer = to;
        files.exportSession(SessionForm::Csv);
    }
    for (const QString& to : {places[2], places[3]}) {
        answer = to;
        files.exportSession(SessionForm::ReportHtml);
    }
    answer = places[4];
    files.exportPlot(place, PlotForm::Csv);
    QStringList unfinished = files.unfinishedExports();
    places.sort();
    unfinished.sort();
    EXPECT_EQ(unfinished, places);
    EXPECT_EQ(written, 0);
    pool.release();
    ASSERT_TRUE(waitFor([&] { return written + problems.size() == 5; }));
    EXPECT_EQ(written, 5) << problems.join('\n').toStdString();
    EXPECT_TRUE(files.unfinishedExports().isEmpty());
    for (const QTemporaryDir* each : {&first, &second})
        EXPECT_TRUE(QFile::exists(each->path() + run + QStringLiteral("/traces.csv")));
    for (const char* report : {"run.html", "again.html"})
        EXPECT_TRUE(QFile::exists(folder.filePath(QLatin1String(report)))) << report;
}

// Catches: a table of a long live run without its first samples, and nobody is told.
TEST_F(SessionActionsTest, ATableWhoseSamplesAreGoneIsRefused) {
    PlotPlace place(new TracePlot);
    place.plot()->setObjects({QStringLiteral("disk")});
    std::vector<TraceSample> samples(TraceStore::kMaxRows * 5 / 4);
    for (std::size_t k = 0; k < samples.size(); ++k)
        samples[k].time_s = static_cast<double>(k);
    place.plot()->append(samples);
    samples.front().time_s = static_cast<double>(samples.size());
    samples.resize(1);
    place.plot()->append(samples);
    place.plot()->setTimeRange(0.0, 100.0);
    files.setFileChooser([](const FileQuestion&) -> QString {
        ADD_FAILURE() << "a question whose answer is of no use";
        return {};
    });
    files.exportPlot(place, PlotForm::Csv);
    ASSERT_EQ(problems.size(), 1);
    EXPECT_TRUE(problems[0].contains(QStringLiteral("Review")));
}

// Catches: a plot drawn under a run that began behind the question for its file, or while a source is heated
// or the robot moves without a run.
TEST_F(SessionActionsTest, APlotIsNotDrawnBehindAQuestionOrOnAHotRig) {
    const QTemporaryDir folder;
    PlotPlace place(new TracePlot);
    bool runIsOn = false, rigIsActive = false;
    int asked = 0;
    files.setRunGuard([&] { return runIsOn; });
    files.setRigGuard([&] { return rigIsActive; });
    files.setFileChooser([&](const FileQuestion&) {
        ++asked;
        runIsOn = true;
        return folder.filePath(QStringLiteral("plot"));
    });
    files.exportPlot(place, PlotForm::Svg);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(problems.size(), 1);
    runIsOn = false;
    rigIsActive = true;
    files.exportPlot(place, PlotForm::Svg);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(problems.size(), 2);
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
    EXPECT_EQ(QGuiApplication::overrideCursor(), nullptr);
}

// Catches: a window that draws for a minute, its STOP dead, under a run or recipe that was on or has begun
// while the session was read.
TEST_F(SessionActionsTest, NothingIsDrawnUnderARunOrRecipe) {
    const QTemporaryDir folder, out;
    int opened = 0, asked = 0;
    QStringList told, written;
    bool runIsOn = false, recipeIsOn = false, rigIsActive = false;
    QObject::connect(&files, &SessionActions::sessionOpened, [&] { ++opened; });
    QObject::connect(&files, &SessionActions::exported, [&](const QString& text, const QStringList& paths) {
        told << text;
        written << paths;
    });
    files.setRunGuard([&] { return runIsOn; });
    files.setRecipeGuard([&] { return recipeIsOn; });
    files.setRigGuard([&] { return rigIsActive; });
    files.setFileChooser([&](const FileQuestion& question) {
        ++asked;
        return question.kind == FileQuestion::Kind::Folder ? out.path() : out.filePath(QStringLiteral("run"));
    });
    files.open(recorded(folder));
    ASSERT_TRUE(waitFor([&] { return opened == 1; }));
    constexpr std::array kDrawn{SessionForm::Figures, SessionForm::ReportPdf, SessionForm::ReportHtml};
    for (bool* isOn : {&runIsOn, &recipeIsOn, &rigIsActive}) {
        asked = 0;
        problems.clear();
        for (const SessionForm form : kDrawn)
            files.exportSession(form);
        *isOn = true; // before the first is read
        ASSERT_TRUE(waitFor([&] { return problems.size() + told.size() == 3; }));
        EXPECT_EQ(asked, 3);
        for (const SessionForm form : kDrawn)
            files.exportSession(form);
        EXPECT_EQ(asked, 3) << "a question whose answer is of no use";
        EXPECT_EQ(problems.size(), 6);
        *isOn = false;
    }
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_TRUE(QDir(out.path()).isEmpty());

    recipeIsOn = true; // the other forms need no more of the window than their answer
    files.exportSession(SessionForm::Csv);
    EXPECT_TRUE(waitFor([&] { return told.size() == 1; }));
}

} // namespace
} // namespace bask::test
