
#include "engine/base/version.h"
#include "tests/support/program_answer.h"
// The program as a script sees it: exit codes, help and refusals, with no display and no QT_QPA_PLATFORM.

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QThread>

#include <gtest/gtest.h>

#include <array>
#include <csignal>

namespace bask::test {
namespace {

Answer bask(const QStringList& arguments, const QString& display = {}, const QString& output = {}) {
    QProcess process;
    if (!output.isEmpty())
        process.setStandardOutputFile(output);
    QProcessEnvironment environment = withoutDisplay();
    if (!display.isEmpty())
        environment.insert(QStringLiteral("DISPLAY"), display);
    process.setProcessEnvironment(environment);
    return answerOf(process, arguments);
}

/// As `bask --help` lists them.
QStringList subcommandNames() {
    QStringList names;
    static const QRegularExpression kLine(QStringLiteral("^  ([a-z-]+) {2,}\\S"),
                                          QRegularExpression::MultilineOption);
    const QString help = bask({QStringLiteral("--help")}).out;
    for (const QRegularExpressionMatch& line :
         kLine.globalMatch(help.section(QStringLiteral("Options:"), 0, 0)))
        names << line.captured(1);
    return names;
}

QString textOf(const char* path) {
    QFile file(QString::fromUtf8(path));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path;
    return QString::fromUtf8(file.readAll());
}

TEST(CommandLine, HelpAndVersion) {
    const Answer help = bask({QStringLiteral("--help")});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_GE(subcommandNames().size(), 16);
    const Answer version = bask({QStringLiteral("--version")});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_TRUE(version.out.startsWith(QStringLiteral("Bask " BASK_VERSION))) << version.out.toStdString();
}

// Catches: a subcommand that needs a display, or has no help.
// Catches a command that loads at its start what only the window, a picture or a camera needs: 200 libraries.
TEST(CommandLine, LoadsNeitherViewsNorCodecsNorCameras) {
    QProcess ldd;
    ldd.start(QStringLiteral("ldd"), {QStringLiteral(BASK_PROGRAM)});
    ASSERT_TRUE(ldd.waitForFinished());
    const QString libraries = QString::fromUtf8(ldd.readAllStandardOutput());
    EXPECT_TRUE(libraries.contains(QStringLiteral("libQt6Core")));
    for (const char* heavy :
         {"libvtkRendering", "libopencv_imgcodecs", "libopencv_videoio", "libgdal", "libavcodec"})
        EXPECT_FALSE(libraries.contains(QLatin1String(heavy))) << heavy;
    std::printf("| %lld libraries\n", static_cast<long long>(libraries.count(u'\n')));
}

TEST(CommandLine, EverySubcommandHasHelp) {
    for (const QString& name : subcommandNames()) {
        const Answer help = bask({name, QStringLiteral("--help")});
        EXPECT_EQ(help.exitCode, 0) << name.toStdString();
        EXPECT_TRUE(help.out.contains(QStringLiteral("bask %1").arg(name))) << help.out.toStdString();
    }
}

// Catches: a command that the documents leave out, and an option there that the program does not take.
TEST(CommandLine, TheDocumentsHaveEveryCommandAndNoOtherOption) {
    const QString document = textOf(BASK_DOCS "/commands.md"), page = textOf(BASK_MAN_PAGE);
    static const QRegularExpression kOption(QStringLiteral("(--[a-z][a-z-]*)"));
    for (const QString& name : subcommandNames()) {
        QString escaped = name;
        EXPECT_TRUE(
            page.contains(QStringLiteral(".B ") + escaped.replace(u'-', QStringLiteral("\\-")) + u'\n'))
            << name.toStdString() << " is not in bask.1";
        const QString help = bask({name, QStringLiteral("--help")}).out;
        int rows = 0;
        for (const QString& line : document.split(u'\n')) {
            if (!line.startsWith(QStringLiteral("| `bask %1 ").arg(name)))
                continue;
            ++rows;
            const QString command = line.section(u'`', 1, 1);
            for (const QRegularExpressionMatch& option : kOption.globalMatch(command))
                EXPECT_TRUE(help.contains(option.captured(1)))
                    << name.toStdString() << ' ' << option.captured(1).toStdString();
        }
        EXPECT_GT(rows, 0) << name.toStdString() << " is not in docs/commands.md";
    }
}

// Catches a rig that the tour asks for and that is not there: it is read before the time is refused.
TEST(CommandLine, SimulateRigHasARigOfItsOwn) {
    const Answer answer =
        bask({QStringLiteral("simulate-rig"), QStringLiteral("--heating-time"), QStringLiteral("0")});
    EXPECT_EQ(answer.exitCode, 2);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("--heating-time is in seconds")))
        << answer.err.toStdString();
    // Its ports would be the far end's own, of one that serves them already.
    const Answer opened = bask({QStringLiteral("simulate-rig"), QStringLiteral("--open")});
    EXPECT_EQ(opened.exitCode, 2);
    EXPECT_TRUE(opened.err.contains(QStringLiteral("--open is for"))) << opened.err.toStdString();
    EXPECT_EQ(bask({QStringLiteral("simulate-rig"), QStringLiteral("one.json"), QStringLiteral("two.json")})
                  .exitCode,
              2);
}

TEST(CommandLine, UnknownWordsAreRefusedWithTheList) {
    for (const char* word : {"frobnicate", "--frobnicate"}) {
        const Answer answer = bask({QLatin1String(word)});
        EXPECT_EQ(answer.exitCode, 2) << word;
        EXPECT_TRUE(answer.err.contains(QStringLiteral("fit-contour")));
        EXPECT_TRUE(answer.out.isEmpty());
    }
}

// Catches: Qt's abort (exit 134) in place of a sentence.
TEST(CommandLine, TheWindowWithoutADisplayIsOneSentence) {
    const Answer answer = bask({});
    EXPECT_EQ(answer.exitCode, 1);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("DISPLAY"))) << answer.err.toStdString();
}

TEST(CommandLine, ADisplayThatDoesNotAnswerIsOneSentence) {
    const Answer answer = bask({}, QStringLiteral(":4711"));
    EXPECT_EQ(answer.exitCode, 1);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("DISPLAY=:4711"))) << answer.err.toStdString();
}

// Catches: success reported for figures that went nowhere.
TEST(CommandLine, AFullStandardOutputIsNoSuccess) {
    for (const QStringList& arguments :
         {QStringList{"--help"}, QStringList{"--version"}, QStringList{"run", "--help"},
          QStringList{"fit-contour", BASK_EXAMPLES "/contours/bunny_mm.csv", "--harmonics", "5"},
          QStringList{"run", BASK_EXAMPLES "/two-circles.json", "--duration", "1"}}) {
        const Answer answer = bask(arguments, {}, QStringLiteral("/dev/full"));
        EXPECT_EQ(answer.exitCode, 2) << arguments.join(' ').toStdString();
        EXPECT_TRUE(answer.err.contains(QStringLiteral("standard output cannot be written")))
            << answer.err.toStdString();
    }
}

// Catches: "no such file" for a name that Qt has decoded to another one. (The shell makes the odd bytes:
// QProcess encodes its arguments.)
TEST(CommandLine, ANameThatIsNotUtf8IsSaid) {
    for (const char* words : {"", "run ", "fit-contour --harmonics 5 "}) {
        QProcess shell;
        shell.start(QStringLiteral("/bin/sh"),
                    {QStringLiteral("-c"), QStringLiteral("exec '%1' %2\"$(printf 'caf\\351.json')\"")
                                               .arg(QStringLiteral(BASK_PROGRAM), QLatin1String(words))});
        ASSERT_TRUE(shell.waitForFinished(60000));
        EXPECT_EQ(shell.exitCode(), 2) << words;
        const QByteArray err = shell.readAllStandardError();
        EXPECT_TRUE(err.contains("caf\\xe9.json\", is not valid UTF-8")) << err.toStdString();
    }
}

// Catches: an experiment, an outline or a session lost to an output of the run.
TEST(CommandLine, RunReplacesNothingButItsOwnOutputs) {
    const QTemporaryDir folder;
    const QString experiment = folder.filePath("e.json"), session = folder.filePath("s.bask"),
                  summary = folder.filePath("s.json");
    ASSERT_TRUE(QFile::copy(BASK_EXAMPLES "/two-circles.json", experiment));
    QFile::setPermissions(experiment, QFile::ReadOwner | QFile::WriteOwner);
    const auto run = [&](const QStringList& outputs) {
        return bask(QStringList{"run", experiment, "--duration", "2"} + outputs);
    };
    for (const QStringList& outputs :
         {QStringList{"-o", experiment}, QStringList{"--summary", experiment},
          QStringList{"-o", session, "--summary", session},
          QStringList{"-o", session, "--summary", folder.filePath("./s.bask")},
          QStringList{"-o", "/dev/null"}, QStringList{"-o", session, "--summary", "/dev/stdout"},
          QStringList{"-o", session, "--summary", folder.filePath("gone/s.json")},
          QStringList{"--summary", ""}}) {
        const Answer answer = run(outputs);
        EXPECT_EQ(answer.exitCode, 2) << outputs.join(' ').toStdString();
        EXPECT_TRUE(answer.out.isEmpty()) << outputs.join(' ').toStdString();
        EXPECT_FALSE(QFile::exists(session)) << outputs.join(' ').toStdString();
    }
    EXPECT_EQ(run({"-o", session, "--summary", summary}).exitCode, 3);
    const qint64 size = QFile(session).size();
    const Answer again = run({"-o", session, "--summary", summary});
    EXPECT_EQ(again.exitCode, 2);
    EXPECT_TRUE(again.err.contains("--overwrite")) << again.err.toStdString();
    EXPECT_EQ(QFile(session).size(), size);
    EXPECT_EQ(run({"-o", session, "--overwrite", "--summary", summary}).exitCode, 3);
    EXPECT_EQ(run({"-o", summary, "--overwrite"}).exitCode, 2) << "a summary is no session";
    EXPECT_EQ(run({"--summary", session}).exitCode, 2) << "a session is no summary";
    EXPECT_EQ(QFile(experiment).size(), QFile(BASK_EXAMPLES "/two-circles.json").size());
}

// Catches two runs into one file, of which both fail, or one is lost.
TEST(CommandLine, OfTwoRunsIntoOneFileOneIsRecorded) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("s.bask");
    const QString experiment = QStringLiteral(BASK_EXAMPLES "/two-circles.json");
    for (const bool mayReplace : {false, true}) {
        for (int round = 0; round < 3; ++round) {
            QFile::remove(session);
            std::array<QProcess, 2> runs;
            for (QProcess& each : runs)
                each.start(QStringLiteral(BASK_PROGRAM),
                           QStringList{"run", experiment, "--duration", "3000", "-o", session} +
                               (mayReplace ? QStringList{"--overwrite"} : QStringList()));
            int recorded = 0;
            for (QProcess& each : runs) {
                ASSERT_TRUE(each.waitForFinished(60000));
                ASSERT_EQ(each.exitStatus(), QProcess::NormalExit);
                const QString said = QString::fromUtf8(each.readAllStandardError());
                recorded += each.exitCode() == 2 ? 0 : 1;
                if (each.exitCode() == 2) {
                    EXPECT_TRUE(said.contains("in use") || said.contains("of that name"))
                        << said.toStdString();
                }
            }
            // With --overwrite the second may come after the first one's end, and replace it as it is told.
            EXPECT_TRUE(recorded == 1 || (mayReplace && recorded == 2)) << recorded;
            EXPECT_EQ(
                bask({"export", session, "--csv", folder.filePath(QString::number(round) + "csv")}).exitCode,
                0);
        }
        QDir(folder.path()).removeRecursively();
        QDir().mkpath(folder.path());
    }
}

// Catches options that are given twice, or do nothing, and are passed over in silence.
TEST(CommandLine, OptionsThatComeTwiceOrDoNothingAreRefused) {
    const QString experiment = BASK_EXAMPLES "/two-circles.json";
    for (const QStringList& arguments :
         {QStringList{"run", experiment, "--duration", "2", "--duration", "3"},
          QStringList{"feasibility", experiment, "--targets", "50,40", "--targets", "40,40"},
          QStringList{"run", experiment, "--live", "--live"},
          QStringList{"run", experiment, "--accept-limits"}, QStringList{"run", experiment, "--overwrite"},
          QStringList{"run", experiment, "--live", "--seed", "3"},
          QStringList{"view-factor", experiment, "-o", "one.json", "--output", "other.json"}}) {
        const Answer answer = bask(arguments);
        EXPECT_EQ(answer.exitCode, 2) << arguments.join(' ').toStdString();
        EXPECT_TRUE(answer.err.contains("is given twice") || answer.err.contains("is for"))
            << answer.err.toStdString();
    }
    EXPECT_EQ(
        bask({"feasibility", experiment, "--no-prediction", "--hold", "left", "--hold", "right"}).exitCode,
        0);
}

// Catches a simulated run or recipe that Ctrl+C kills: no outcome, and a recording without its end.
TEST(CommandLine, CtrlCEndsARunInOrder) {
    for (const bool isRecipe : {false, true}) {
        const QTemporaryDir folder;
        const QString summary = folder.filePath("summary.json"),
                      session = folder.filePath("01-two-circles.bask");
        QFile recipe(folder.filePath("recipe.json"));
        ASSERT_TRUE(recipe.open(QIODevice::WriteOnly));
        recipe.write(R"({"format": "bask-recipe", "version": 1, "steps": [
            {"run_example": "two-circles", "until": {"time_s": 1e6}}, {"wait": {"time_s": 5}}]})");
        recipe.close();
        QStringList arguments{"run", "--summary", summary};
        if (isRecipe)
            arguments << "--recipe" << recipe.fileName() << "--out" << folder.path();
        else
            arguments << BASK_EXAMPLES "/two-circles.json"
                      << "--duration"
                      << "1e6"
                      << "-o" << session;
        QProcess process;
        process.start(QStringLiteral(BASK_PROGRAM), arguments);
        ASSERT_TRUE(process.waitForStarted());
        for (int i = 0; i < 6000 && !QFile::exists(session); ++i)
            QThread::msleep(10);
        ASSERT_EQ(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
        ASSERT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        EXPECT_EQ(process.exitCode(), 3) << process.readAllStandardError().toStdString();
        EXPECT_TRUE(QFile::exists(summary));
        EXPECT_FALSE(QFile::exists(session + "-wal"));
    }
}

// Catches a run under nohup that its terminal's end stops.
TEST(CommandLine, ARunUnderNohupOutlivesItsTerminal) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("s.bask");
    QProcess process;
    process.setChildProcessModifier([] { (void)std::signal(SIGHUP, SIG_IGN); });
    process.start(QStringLiteral(BASK_PROGRAM),
                  {"run", BASK_EXAMPLES "/two-circles.json", "--duration", "1e6", "-o", session});
    ASSERT_TRUE(process.waitForStarted());
    for (int i = 0; i < 6000 && !QFile::exists(session); ++i)
        QThread::msleep(10);
    ASSERT_EQ(::kill(static_cast<pid_t>(process.processId()), SIGHUP), 0);
    EXPECT_FALSE(process.waitForFinished(500)) << process.readAllStandardError().toStdString();
    ASSERT_EQ(::kill(static_cast<pid_t>(process.processId()), SIGTERM), 0);
    ASSERT_TRUE(process.waitForFinished(60000));
    EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
    EXPECT_TRUE(process.exitCode() == 0 || process.exitCode() == 3) << "settled or not by then";
}

// Catches a recording of one recipe that is lost to another in the same folder.
TEST(CommandLine, OfTwoRecipesIntoOneFolderNoRunIsLost) {
    const QTemporaryDir folder;
    QFile recipe(folder.filePath("r.json"));
    ASSERT_TRUE(recipe.open(QIODevice::WriteOnly));
    const char* step = R"({"run_example": "two-circles", "until": {"time_s": 2000}, "otherwise": "next"})";
    recipe.write(QStringLiteral(R"({"format": "bask-recipe", "version": 1, "steps": [%1, %1]})")
                     .arg(QLatin1String(step))
                     .toUtf8());
    recipe.close();
    for (int round = 0; round < 3; ++round) {
        const QString out = folder.filePath(QString::number(round));
        std::array<QProcess, 2> runs;
        for (QProcess& each : runs)
            each.start(QStringLiteral(BASK_PROGRAM), {"run", "--recipe", recipe.fileName(), "--out", out});
        int done = 0;
        for (QProcess& each : runs) {
            ASSERT_TRUE(each.waitForFinished(120000));
            done += static_cast<int>(each.readAllStandardError().count(": done after"));
        }
        EXPECT_EQ(QDir(out).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(), 2);
        EXPECT_EQ(done, 2) << "a run that is told as done is there";
    }
}

TEST(CommandLine, AMissingFileIsBadInput) {
    const Answer answer = bask({QStringLiteral("/nowhere/gone.json")});
    EXPECT_EQ(answer.exitCode, 2);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("gone.json")));
}

// Catches: several files chosen in a file manager of which all but one are passed over in silence.
TEST(CommandLine, ASecondFileIsRefused) {
    const Answer answer = bask({QStringLiteral(BASK_EXAMPLES "/two-circles.json"),
                                QStringLiteral(BASK_EXAMPLES "/three-objects.json")});
    EXPECT_EQ(answer.exitCode, 2);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("three-objects.json: one file at a time")))
        << answer.err.toStdString();
}

} // namespace
} // namespace bask::test
