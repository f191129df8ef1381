// bask study as a script sees it: no display, no QT_QPA_PLATFORM, its table and figures.

#include "engine/radiation/view_factor.h"
#include "engine/shape/contour_import.h"
#include "tests/support/program_answer.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

Answer study(const QStringList& arguments) {
    QProcess process;
    process.setProcessEnvironment(withoutDisplay());
    return answerOf(process, QStringList{"study"} + arguments);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
}

class StudyCommand : public testing::Test {
protected:
    QString folder(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    static QStringList quick(const QString& to) { return {"view-factor", "--elements", "500", "-o", to}; }

    struct Table {
        QStringList header;
        QList<QStringList> rows;
        QString comments;
    };
    static Table tableIn(const QString& path) {
        Table table;
        for (const QString& line : QString::fromUtf8(contents(path)).split(u'\n', Qt::SkipEmptyParts)) {
            if (line.startsWith(u'#'))
                table.comments += line + u'\n';
            else if (table.header.isEmpty())
                table.header = line.split(u',');
            else // the methods' names are quoted, since two of them have a comma
                table.rows << QStringList(line.section(u'"', 1, 1)) +
                                  line.section(u'"', 2).mid(1).split(u',');
        }
        return table;
    }

private:
    QTemporaryDir m_folder;
};

// Catches: a study that needs a display, a table that does not parse or is not what the solver says, figures
// that are empty or of another size.
TEST_F(StudyCommand, WritesATableAndFiguresWithoutADisplay) {
    const QString to = folder("new/study");
    const Answer answer = study(quick(to));
    ASSERT_EQ(answer.exitCode, 0) << answer.err.toStdString();
    EXPECT_TRUE(answer.out.contains(QStringLiteral("surface integral")));
    EXPECT_LT(answer.out.count(u'\n'), 30);

    const Table table = tableIn(to + "/view_factor_study.csv");
    EXPECT_TRUE(table.comments.contains(QStringLiteral("0.764602 belongs to another bunny")));
    ASSERT_EQ(table.header.size(), 9);
    EXPECT_EQ(table.header.back(), QStringLiteral("time_us"));
    ASSERT_EQ(table.rows.size(), 6 + 20 * 7 + 4);

    const auto outline = readContourCsv(BASK_EXAMPLES "/contours/bunny_mm.csv", LengthUnit::Millimetre);
    ASSERT_TRUE(outline);
    Pose X_SO = Pose::Identity();
    X_SO.translation().z() = 0.05;
    const double exact =
        viewFactor(RadiatingContour(Disk{0.1}), RadiatingContour(centred(*outline)), X_SO, {1e-12}).value;
    for (const QStringList& row : table.rows) {
        ASSERT_EQ(row.size(), 9) << row.join(u',').toStdString();
        const double value = row[5].toDouble(), error = row[6].toDouble();
        EXPECT_NEAR(std::abs(value - exact), error, 1e-11);
        EXPECT_GT(row[8].toDouble(), 0.0);
        if (row[0] == QLatin1String("Bask, outline")) {
            EXPECT_LE(error, row[4].toDouble());
        }
        if (row[0] == QLatin1String("Bask, Fourier")) {
            EXPECT_LE(row[7].toDouble(), 1e-9);
        }
        if (row[3] == QLatin1String("256")) {
            EXPECT_LE(row[7].toDouble(), 1e-9) << "Simpson does not converge";
        }
        if (row[2] == QLatin1String("20") && row[3] == QLatin1String("256")) {
            EXPECT_LE(error, 1e-4);
        }
        if (row[1] == QLatin1String("500")) {
            EXPECT_LE(error, 2e-2);
        }
    }

    for (const char* name : {"elements", "harmonics", "points", "time"}) {
        const QImage image(to + QStringLiteral("/view_factor_study_%1.png").arg(QLatin1String(name)));
        EXPECT_EQ(image.size(), QSize(1800, 1200)) << name;
        QSet<QRgb> colours;
        for (int y = 0; y < image.height(); y += 2)
            for (int x = 0; x < image.width(); x += 2)
                colours.insert(image.pixel(x, y));
        EXPECT_GT(colours.size(), 20) << name;
    }
    EXPECT_EQ(QDir(to).entryList(QDir::Files).size(), 5);
}

// Catches: a second run that is refused because of the first one's files.
TEST_F(StudyCommand, ReplacesItsOwnFilesAndNoOthers) {
    ASSERT_EQ(study(quick(folder("out"))).exitCode, 0);
    EXPECT_EQ(study(quick(folder("out"))).exitCode, 0);
    for (const char* name : {"view_factor_study.csv", "view_factor_study_time.png"}) {
        const QString foreign = folder("out") + u'/' + QLatin1String(name);
        write(foreign, "mine");
        const Answer answer = study(quick(folder("out")));
        EXPECT_EQ(answer.exitCode, 2) << name;
        EXPECT_TRUE(answer.err.contains(QStringLiteral("choose another name"))) << answer.err.toStdString();
        EXPECT_EQ(contents(foreign), QByteArray("mine"));
        QFile::remove(foreign);
    }
}

// Catches: a bad folder found out after the work, or told in no words.
TEST_F(StudyCommand, RefusesABadFolderBeforeTheWork) {
    write(folder("file"), "text");
    for (const QString& to : {folder("file"), folder("file") + "/below", QStringLiteral("/proc/nowhere")}) {
        const Answer answer = study({"view-factor", "-o", to});
        EXPECT_EQ(answer.exitCode, 2) << to.toStdString();
        EXPECT_TRUE(answer.err.contains(to)) << answer.err.toStdString();
        EXPECT_TRUE(answer.err.contains(QStringLiteral("choose another"))) << answer.err.toStdString();
        EXPECT_TRUE(answer.out.isEmpty());
    }
}

// Catches: last lines that a script cannot read, a table that is not there or not the same at a second run, a
// first study's files that stop the second one.
TEST_F(StudyCommand, ClosedLoopEndsWithItsThreeNumbersAndIsReproducible) {
    const QStringList arguments{"closed-loop", "--count",    "2",      "--seed", "7",          "--controller",
                                "level",       "--mounting", "random", "-o",     folder("out")};
    const Answer answer = study(arguments);
    ASSERT_EQ(answer.exitCode, 0) << answer.err.toStdString();
    const QRegularExpression lastLines(
        QStringLiteral("\\nsuccess rate: (\\d+\\.\\d) %\\nmedian settling over bound: (\\d+\\.\\d\\d|none)\\n"
                       "worst overshoot: (\\d+\\.\\d\\d) K\\n\\z"));
    const auto match = lastLines.match(answer.out);
    ASSERT_TRUE(match.hasMatch()) << answer.out.toStdString();
    EXPECT_EQ(answer.out.count(QStringLiteral(" failed: ")), 2 - qRound(match.captured(1).toDouble() / 50.0));

    const QByteArray table = contents(folder("out") + "/closed_loop_study.csv");
    int runs = 0;
    for (const QByteArray& line : table.split('\n'))
        runs += !line.isEmpty() && !line.startsWith('#');
    EXPECT_EQ(runs, 3) << "header and two runs";
    for (const char* name : {"settling", "ratio", "overshoot"})
        EXPECT_EQ(QImage(folder("out") + QStringLiteral("/closed_loop_study_%1.png").arg(QLatin1String(name)))
                      .size(),
                  QSize(1800, 1200))
            << name;
    EXPECT_EQ(study(arguments).out, answer.out);
    EXPECT_EQ(contents(folder("out") + "/closed_loop_study.csv"), table);
}

// Catches: wrong words taken for right ones.
TEST_F(StudyCommand, RefusesWrongWords) {
    const QString to = folder("out");
    for (const QStringList& arguments : {QStringList{},
                                         QStringList{"view-factor"},
                                         QStringList{"tomography", "-o", to},
                                         QStringList{"view-factor", "-o", ""},
                                         QStringList{"view-factor", "-o", to, "--elements", "many"},
                                         QStringList{"view-factor", "-o", to, "--elements", "20001"},
                                         QStringList{"view-factor", "-o", to, "--count", "3"},
                                         QStringList{"closed-loop"},
                                         QStringList{"closed-loop", "-o", to, "--elements", "500"},
                                         QStringList{"closed-loop", "-o", to, "--controller", "pid"},
                                         QStringList{"closed-loop", "-o", to, "--source-model", "black"},
                                         QStringList{"closed-loop", "-o", to, "--mounting", "circle"},
                                         QStringList{"closed-loop", "-o", to, "--rate-error", "0.5"},
                                         QStringList{"closed-loop", "-o", to, "--rate-error", "nan"},
                                         QStringList{"closed-loop", "-o", to, "--convection", "-1"},
                                         QStringList{"closed-loop", "-o", to, "--lag", "soon"},
                                         QStringList{"alarms", "-o", to, "--latency", "0.1"},
                                         QStringList{"alarms", "-o", to, "--uneven", "5"},
                                         QStringList{"alarms", "-o", to, "--read-by", "hand"},
                                         QStringList{"closed-loop", "-o", to, "--read-by", "both"},
                                         QStringList{"closed-loop", "-o", to, "--uneven", "60"},
                                         QStringList{"closed-loop", "-o", to, "--count", "0"},
                                         QStringList{"closed-loop", "-o", to, "--seed", "-1"},
                                         QStringList{"view-factor", "-o", to, "-platform", "xcb"}}) {
        const Answer answer = study(arguments);
        EXPECT_EQ(answer.exitCode, 2) << arguments.join(u' ').toStdString();
        EXPECT_TRUE(answer.err.contains(QStringLiteral("bask study --help"))) << answer.err.toStdString();
    }
    EXPECT_FALSE(QDir(to).exists());
}

} // namespace
} // namespace bask::test
