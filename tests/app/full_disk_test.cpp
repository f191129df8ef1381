// Commands whose output finds no room: exit code 2, the reason in words, and nothing half. A limit on the
// size of files stands for a full disk.

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

class FullDisk : public testing::Test {
protected:
    QString at(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
    /// Runs a command that may write files of so many blocks of 512 bytes.
    void expectRefused(const QStringList& arguments, int blocks) const {
        QProcess process;
        process.start(QStringLiteral("sh"),
                      QStringList{"-c", QStringLiteral("trap '' XFSZ; ulimit -f %1; exec \"$@\"").arg(blocks),
                                  "sh", QStringLiteral(BASK_PROGRAM)} +
                          arguments);
        ASSERT_TRUE(process.waitForFinished(120000));
        const QByteArray said = process.readAllStandardError();
        EXPECT_EQ(process.exitCode(), 2) << arguments.join(u' ').toStdString() << said.toStdString();
        EXPECT_FALSE(said.contains("Unknown error")) << said.toStdString();
        EXPECT_TRUE(said.contains("File too large") || said.contains("disk is full") ||
                    said.contains("disk I/O error"))
            << said.toStdString();
        EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                  QStringList())
            << arguments.join(u' ').toStdString();
        QDir(m_folder.path()).removeRecursively();
        QDir().mkpath(m_folder.path());
    }

    QTemporaryDir m_folder, m_inputs;
    QString m_examples = QStringLiteral(BASK_EXAMPLES);
};

TEST_F(FullDisk, isToldAndLeavesNothingHalf) {
    // The table finds room, the figures do not.
    expectRefused({"study", "view-factor", "--elements", "10", "-o", at("out")}, 8);
    // The summary finds room, the maps do not.
    expectRefused({"feasibility", m_examples + "/two-circles.json", "--no-prediction", "--summary",
                   at("s.json"), "--reachable", at("maps")},
                  12);
    expectRefused({"fit-contour", m_examples + "/contours/bunny_1200.png", "--harmonics", "8", "--scale",
                   "10", "-o", at("c.json")},
                  0);
    // The contour finds room, its picture does not.
    expectRefused({"fit-contour", m_examples + "/contours/bunny_1200.png", "--harmonics", "8", "--scale",
                   "10", "-o", at("c.json"), "--preview", at("p.png")},
                  120);
    expectRefused({"make-board", "chessboard:6x5:0.02", "-o", at("b.pdf")}, 1);
    expectRefused({"field", "--preset", "paper-translation", "-o", at("f.vti")}, 100);
    expectRefused({"field", "--preset", "paper-translation", "-o", at("f.h5")}, 100);
    expectRefused(
        {"run", "--recipe", m_examples + "/recipes/two-circles-by-degrees.json", "--out", at("runs")}, 300);
    // The table and the first figure find room, the others do not.
    expectRefused({"study", "closed-loop", "--count", "1", "-o", at("out")}, 165);
    const QString session = m_inputs.filePath("run.bask");
    QProcess record;
    record.start(QStringLiteral(BASK_PROGRAM),
                 {"run", m_examples + "/two-circles.json", "--duration", "20", "-o", session});
    ASSERT_TRUE(record.waitForFinished(120000));
    ASSERT_TRUE(QFile::exists(session));
    expectRefused({"report", session, "-o", at("r.html")}, 40);
    expectRefused({"report", session, "-o", at("r.pdf")}, 8);
    // The runs find room, the report does not.
    expectRefused({"reproduce", "--only", "target-coefficient-40", "-o", at("out")}, 200);
}

} // namespace
} // namespace bask::test
