// The program as a script sees it: exit codes, help and refusals, with no display and no QT_QPA_PLATFORM.

#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

struct Answer {
    int exitCode = -1;
    QString out, err;
};

Answer bask(const QStringList& arguments, const QString& display = {}) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QLatin1String(name));
    if (!display.isEmpty())
        environment.insert(QStringLiteral("DISPLAY"), display);
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(BASK_PROGRAM), arguments);
    if (!process.waitForFinished(60000) || process.exitStatus() != QProcess::NormalExit)
        return {};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

TEST(CommandLine, HelpAndVersion) {
    const Answer help = bask({QStringLiteral("--help")});
    EXPECT_EQ(help.exitCode, 0);
    for (const char* name : {"run", "fit-contour", "view-factor", "export"})
        EXPECT_TRUE(help.out.contains(QLatin1String(name))) << name;
    const Answer version = bask({QStringLiteral("--version")});
    EXPECT_EQ(version.exitCode, 0);
    EXPECT_TRUE(version.out.startsWith(QStringLiteral("Bask " BASK_VERSION))) << version.out.toStdString();
}

// Catches: a subcommand that needs a display, or has no help.
TEST(CommandLine, EverySubcommandHasHelp) {
    for (const char* name : {"run", "fit-contour", "view-factor", "export"}) {
        const Answer help = bask({QLatin1String(name), QStringLiteral("--help")});
        EXPECT_EQ(help.exitCode, 0) << name;
        EXPECT_TRUE(help.out.contains(QStringLiteral("bask %1").arg(QLatin1String(name))))
            << help.out.toStdString();
    }
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

TEST(CommandLine, AMissingFileIsBadInput) {
    const Answer answer = bask({QStringLiteral("/nowhere/gone.json")});
    EXPECT_EQ(answer.exitCode, 2);
    EXPECT_TRUE(answer.err.contains(QStringLiteral("gone.json")));
}

} // namespace
} // namespace bask::test
