// What a script relies on: options without an effect are refused, summaries are the same again, and on a
// terminal a long command says how long it takes.

#include "tests/support/program_answer.h"
#include "tests/support/terminal.h"

#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QThread>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <unistd.h>

namespace bask::test {
namespace {

QString example(const char* name) {
    return QStringLiteral(BASK_EXAMPLES "/") + QLatin1String(name);
}

class ScriptedCommands : public testing::Test {
protected:
    QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    /// An experiment with one object.
    QString alone() const {
        QFile shipped(example("two-circles.json")), file(at("alone.json"));
        EXPECT_TRUE(shipped.open(QIODevice::ReadOnly) && file.open(QIODevice::WriteOnly));
        auto experiment = nlohmann::json::parse(shipped.readAll().toStdString());
        experiment["objects"].erase(1);
        file.write(QByteArray::fromStdString(experiment.dump()));
        return file.fileName();
    }
    QTemporaryDir m_folder;
};

// Catches a damaged recording that is told in the database's words, or as no session.
TEST_F(ScriptedCommands, verifyTellsDamage) {
    const QString run = at("run.bask");
    answerOf({"run", example("two-circles.json"), "--duration", "600", "-o", run});
    const Answer whole = answerOf({"verify", run});
    EXPECT_EQ(whole.exitCode, 0) << whole.err.toStdString();
    QFile file(run);
    ASSERT_TRUE(file.resize(file.size() / 4 * 3));
    const Answer cut = answerOf({"verify", run});
    EXPECT_EQ(cut.exitCode, 3) << cut.err.toStdString();
    static const QRegularExpression kStep(
        QStringLiteral(R"(step: damaged; the first \d+ rows can be read, until )"));
    EXPECT_TRUE(cut.out.contains(kStep)) << cut.out.toStdString();
    EXPECT_TRUE(cut.out.contains("what to do: ")) << cut.out.toStdString();
    EXPECT_FALSE((cut.out + cut.err).contains("malformed"));
    EXPECT_FALSE(cut.out.contains("intact"));
    EXPECT_FALSE(cut.out.contains(": added")) << cut.out.toStdString();
    ASSERT_TRUE(file.resize(50));
    EXPECT_EQ(answerOf({"verify", run}).exitCode, 3);
    ASSERT_TRUE(file.resize(0));
    EXPECT_EQ(answerOf({"verify", run}).exitCode, 2) << "nothing says that it was a session";
}

// Catches an option that is passed over in silence: a script believes that it has done something.
TEST_F(ScriptedCommands, refuseOptionsWithoutAnEffect) {
    const QString two = example("two-circles.json"), list = example("contours/bunny_mm.csv"),
                  picture = example("contours/bunny_1200.png"), out = at("out");
    struct Case {
        QStringList arguments;
        const char* words;
    };
    const Case cases[] = {
        {{"run", two, "--home"}, "--home is for --live"},
        {{"run", two, "--confirm-place"}, "--confirm-place is for --live"},
        {{"run", two, "--accept-limits"}, "--accept-limits is for --live"},
        {{"run", two, "--allow-program"}, "--allow-program is for --live"},
        {{"run", two, "--monitor", "m.json"}, "--monitor is for --live"},
        {{"run", two, "--live", "--seed", "3"}, "--seed is for the simulated rig"},
        {{"run", two, "--overwrite"}, "--overwrite is for -o"},
        {{"run", two, "--operator", "A"}, "--operator is for a recording"},
        {{"run", two, "-o", out, "--operator", ""}, "--operator: the name is empty"},
        {{"run", two, "-o", out, "--batch", " "}, "--batch: the name is empty"},
        {{"run", two, "--out", out}, "--out is for recipes"},
        {{"run", "--recipe", "r.json", "--targets", "40,40"}, "--targets is not for recipes"},
        {{"run", "--recipe", "r.json", "--duration", "9"}, "--duration is not for recipes"},
        {{"run", "--recipe", "r.json", "--seed", "3"}, "--seed is not for recipes"},
        {{"run", "--recipe", "r.json", "-o", out}, "-o is not for recipes"},
        {{"run", "--recipe", "r.json", "--batch", "B"}, "--batch is for a recording"},
        {{"run", "--recipe", "r.json", "--summary", ""}, "--summary: the name is empty"},
        {{"fit-contour", list, "--list", "--harmonics", "5"}, "--harmonics is for a fit"},
        {{"fit-contour", list, "--list", "--tolerance", "1"}, "--tolerance is for a fit"},
        {{"fit-contour", list, "--list", "--pick", "0"}, "--pick is for a fit"},
        {{"fit-contour", list, "--list", "--json"}, "--json is for a fit"},
        {{"fit-contour", list, "--list", "-o", out}, "--list writes no file"},
        {{"fit-contour", list, "--harmonics", "5", "--tolerance", "1"}, "is for --harmonics auto"},
        {{"fit-contour", list, "--harmonics", "5", "--scale", "15"}, "--scale is for pictures"},
        {{"fit-contour", list, "--harmonics", "5", "--known-length", "0,0,9,0,5"},
         "--known-length is for pictures"},
        {{"fit-contour", list, "--harmonics", "5", "--marker-size", "40"}, "--marker-size is for pictures"},
        {{"fit-contour", list, "--harmonics", "5", "--colour", "#222222"}, "--colour is for pictures"},
        {{"fit-contour", picture, "--harmonics", "5", "--scale", "15", "--unit", "cm"},
         "--unit is for lists and drawings"},
        {{"fit-contour", picture, "--harmonics", "5", "--scale", "15", "--factor", "2"},
         "--factor is for lists and drawings"},
        {{"export", "s.bask", "--csv", out, "--language", "fr"}, "--language is for --figures"},
        {{"export", "s.bask", "--vtk", out, "--all-digits"}, "--all-digits is for --csv"},
        {{"export", "s.bask", "--csv", out, "--vtk", ""}, "--vtk: the name of its folder is empty"},
        {{"merge", "--status", "a.part", "-o", out}, "--status writes no files"},
        {{"merge", two, two, "-o", out}, "two-circles.json is named twice"},
        {{"merge", "--status", two, example("./two-circles.json")}, "two-circles.json is named twice"},
        {{"field", alone(), "--axes", "x=0:0.1:0.1", "--shade", "none", "-o", out + ".vti"}, "--shade"},
        {{"field", "--preset", "paper-translation", "--shade", "exact"}, "--shade"},
        {{"field", "--preset", "paper-translation", "--resume"}, "--resume"},
        {{"study", "view-factor", "--count", "3", "-o", out}, "--count is no option of the study"},
        {{"study", "view-factor", "--threads", "3", "-o", out}, "--threads is no option of the study"},
        {{"study", "closed-loop", "--first", "3", "-o", out}, "--first is no option of the study"},
        {{"study", "closed-loop", "--elements", "30", "-o", out}, "--elements is no option of the study"},
        {{"study", "alarms", "--lag", "3", "-o", out}, "--lag is no option of the study"},
        {{"study", "alarms", "--resume", "-o", out}, "--resume"},
        {{"detect-markers", picture, "--dictionary", "6X6_250", "--size", "0.05"}, "--size and --camera"},
        {{"scan-modbus", "127.0.0.1:1", "--line", "9600-8N1"}, "--line is for serial ports"},
        {{"check-device", "--role", "thermometer", "--home", "--", "true"}, "--home is for a robot"},
        {{"check-device", "--role", "robot", "--home", "--no-motion", "--", "true"},
         "--home moves the robot"},
        {{"check-device", "--role", "thermometer", "--no-motion", "--", "true"},
         "--no-motion is for a robot"},
        {{"simulate-device", "heater", "--driver", "modbus_tcp", "--link", "0", "--open"},
         "--open is for terminals"},
    };
    for (const Case& each : cases) {
        const Answer answer = answerOf(each.arguments);
        const std::string what = each.arguments.join(' ').toStdString();
        EXPECT_EQ(answer.exitCode, 2) << what;
        EXPECT_TRUE(answer.err.contains(QLatin1String(each.words))) << what << '\n'
                                                                    << answer.err.toStdString();
        EXPECT_TRUE(answer.out.isEmpty()) << what;
    }
    EXPECT_FALSE(QFile::exists(out));
}

/// As `bask --help` lists them.
QStringList commandsWith(const QString& option) {
    QStringList names;
    static const QRegularExpression kLine(QStringLiteral("^  ([a-z-]+) {2,}\\S"),
                                          QRegularExpression::MultilineOption);
    const QString help = answerOf({QStringLiteral("--help")}).out.section(QStringLiteral("Options:"), 0, 0);
    for (const QRegularExpressionMatch& line : kLine.globalMatch(help))
        if (answerOf({line.captured(1), QStringLiteral("--help")}).out.contains(option))
            names << line.captured(1);
    return names;
}

nlohmann::json jsonIn(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return nlohmann::json::parse(file.readAll().toStdString());
}

// Catches a time, a path or a random number in a summary that scripts compare.
TEST_F(ScriptedCommands, haveTheSameSummaryAgainButForTheNamedKeys) {
    ASSERT_EQ(commandsWith(QStringLiteral("--summary")), (QStringList{"run", "feasibility"}))
        << "add it here, and its keys to docs/commands.md";
    QFile recipe(at("recipe.json"));
    ASSERT_TRUE(recipe.open(QIODevice::WriteOnly));
    recipe.write(R"({"format": "bask-recipe", "version": 1, "steps": [
        {"run_example": "two-circles", "until": {"time_s": 60}}, {"wait": {"time_s": 5}}]})");
    recipe.close();
    const QString experiment = example("two-circles.json");
    for (const QStringList& command :
         {QStringList{"run", experiment, "--duration", "60"},
          QStringList{"run", "--recipe", at("recipe.json")}, QStringList{"feasibility", experiment}}) {
        const std::string what = command.join(' ').toStdString();
        nlohmann::json summaries[2];
        for (nlohmann::json& summary : summaries) {
            const Answer answer = answerOf(command + QStringList{"--summary", at("summary.json")});
            ASSERT_TRUE(answer.exitCode == 0 || answer.exitCode == 3) << what << answer.err.toStdString();
            summary = jsonIn(at("summary.json"));
            ASSERT_TRUE(QFile::remove(at("summary.json")));
        }
        const bool isTimed = summaries[0].contains("wall_s");
        EXPECT_EQ(isTimed, command.front() == "run") << what;
        for (nlohmann::json& summary : summaries)
            summary.erase("wall_s");
        EXPECT_EQ(summaries[0], summaries[1]) << what;
        EXPECT_GE(summaries[0].size(), 2U) << what;
    }
    QFile page(QStringLiteral(BASK_DOCS "/commands.md"));
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    const QByteArray document = page.readAll();
    for (const char* key : {"`wall_s`", "`control_steps`"}) // the second one only of a live run
        EXPECT_TRUE(document.contains(key)) << key;
}

// Catches a long run whose user does not learn when it ends, or learns it in two lines that write over one
// another.
TEST_F(ScriptedCommands, sayOnATerminalHowMuchIsDoneAndHowLongTheRestTakes) {
    QFile shipped(example("two-circles.json")), longer(at("longer.json"));
    ASSERT_TRUE(shipped.open(QIODevice::ReadOnly) && longer.open(QIODevice::WriteOnly));
    const QByteArray text = shipped.readAll();
    ASSERT_TRUE(text.contains("\"duration_limit_s\": 1800"));
    longer.write(QByteArray(text).replace("\"duration_limit_s\": 1800", "\"duration_limit_s\": 1e6"));
    longer.close();
    struct Case {
        QStringList arguments;
        const char* line;
    };
    const Case cases[] = {
        {{"run", example("two-circles.json"), "--duration", "1e6"},
         R"(^\d+ of 1000000 s of the run \(\d+ %\), about [^,]+ left, (\S+ ){2}degC\x1b\[K$)"},
        {{"run", longer.fileName(), "--targets", "98,30"}, // too hot to settle, so that it lasts
         R"(^\d+ of at most 1000000 s of the run \(\d+ %\), at most [^,]+ left, (\S+ ){2}degC\x1b\[K$)"}};
    for (const Case& each : cases) {
        Terminal terminal;
        ASSERT_GE(terminal.far(), 0);
        QProcess process;
        process.setChildProcessModifier([far = terminal.far()] { ::dup2(far, STDERR_FILENO); });
        process.start(QStringLiteral(BASK_PROGRAM), each.arguments);
        ASSERT_TRUE(process.waitForStarted());
        for (int i = 0; i < 6000 && terminal.written().count("of the run") < 4; ++i)
            QThread::msleep(10);
        ASSERT_EQ(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
        ASSERT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        const QRegularExpression line(QString::fromLatin1(each.line));
        int told = 0;
        for (const QByteArray& part : terminal.written().split('\r'))
            if (part.contains("of the run") && told++ < 3) { // the last ones may be cut
                EXPECT_TRUE(line.match(QString::fromUtf8(part)).hasMatch()) << part.toStdString();
            }
        EXPECT_GE(told, 3) << terminal.written().toStdString();
    }
}

} // namespace
} // namespace bask::test
