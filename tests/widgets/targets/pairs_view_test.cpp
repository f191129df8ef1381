// The maps of all pairs: how many, when stale, and what their export holds.

#include "engine/experiment/experiment_file.h"
#include "widgets/targets/pairs_view.h"

#include "app/commands/command_line.h"
#include "engine/exchange/reachable_file.h"
#include "engine/rig/rig_setup.h"
#include "tests/support/captured_command.h"
#include "tests/support/longer_translator.h"
#include "tests/support/wait_for.h"
#include "widgets/targets/reach_map.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

const QString kTriangle = QStringLiteral(BASK_EXAMPLES "/three-objects.json");

const Experiment& shipped() {
    static const Experiment example = readExperiment(kTriangle.toStdString()).value();
    return example;
}

struct PairsViewTest : testing::Test {
    PairsView view;
    QTemporaryDir folder;
    QSignalSpy told{&view, &PairsView::exported};
    QSignalSpy problem{&view, &PairsView::problem};
    Experiment experiment = shipped();

    PairsViewTest() {
        view.resize(620, 600);
        view.setExperiment(experiment);
        view.show();
        QApplication::processEvents();
    }
    /// Of the shipped example, made once.
    void setMaps() {
        static const auto maps = reachablePairs(feasibilityRequest(shipped())).value();
        view.setMaps(maps);
    }
    int mapsShown() {
        int shown = 0;
        for (const ReachMap* map : view.findChildren<ReachMap*>())
            shown += map->isVisible();
        return shown;
    }
    QLabel* note() { return view.findChild<QLabel*>("mapsNote"); }
    bool mayExport() { return view.findChild<QPushButton*>("exportMaps")->isEnabled(); }
    QByteArray bytes(const QString& path) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
        return file.readAll();
    }
};

// Catches: pairs without a map, maps left over, and an empty view without a word.
TEST_F(PairsViewTest, AMapAPairOrWordsWhyNone) {
    EXPECT_EQ(mapsShown(), 3);
    EXPECT_FALSE(note()->isVisible());
    Experiment other = experiment;
    while (other.objects.size() < 6)
        other.objects.push_back(other.objects[0]);
    view.setExperiment(other);
    QApplication::processEvents();
    EXPECT_EQ(mapsShown(), 15);
    other.objects.resize(1);
    view.setExperiment(other);
    QApplication::processEvents();
    EXPECT_EQ(mapsShown(), 0);
    EXPECT_TRUE(note()->isVisible());
    view.setExperiment(experiment);
    view.setMaps({});
    EXPECT_EQ(mapsShown(), 0);
    EXPECT_TRUE(note()->text().contains("clearance"));
}

// Catches: maps that look fresh although the source changed, and ones hatched for a target that moved.
TEST_F(PairsViewTest, OtherObjectsMakeMapsStaleOtherTargetsTheirWords) {
    setMaps();
    auto* map = view.findChild<ReachMap*>("map0");
    EXPECT_TRUE(map->words().endsWith("inside")) << map->words().toStdString();
    EXPECT_TRUE(mayExport());
    Experiment moved = experiment;
    moved.objects[0].target_K += 1.0;
    view.setExperiment(moved);
    EXPECT_TRUE(map->words().startsWith("Checking"));
    EXPECT_TRUE(view.findChild<ReachMap*>("map2")->words().endsWith("inside")) << "has another pair";
    EXPECT_FALSE(mayExport());
    view.setExperiment(experiment);
    EXPECT_TRUE(map->words().endsWith("inside"));
    Experiment warmer = experiment;
    warmer.source.temperature_K += 1.0;
    view.setExperiment(warmer);
    for (const ReachMap* each : view.findChildren<ReachMap*>())
        EXPECT_TRUE(each->words().startsWith("Checking"));
}

// Catches: a click that is told of the wrong objects.
TEST_F(PairsViewTest, PicksSayForWhichObjects) {
    setMaps();
    QSignalSpy picked(&view, &PairsView::targetsPicked);
    auto* map = view.findChild<ReachMap*>("map1");
    QTest::mouseDClick(map, Qt::LeftButton, {}, map->rect().center());
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked[0][0].toInt(), 0);
    EXPECT_EQ(picked[0][1].toInt(), 2);
    EXPECT_NEAR(picked[0][2].toDouble(), kelvinFromCelsius(60.0), 25.0);
}

// Catches: tables other than the command's, pictures that do not say what they are, and a file of the user's
// that is lost.
TEST_F(PairsViewTest, ExportWritesWhatTheCommandWrites) {
    setMaps();
    view.exportTo(folder.path());
    ASSERT_TRUE(test::waitFor([&] { return told.count() + problem.count() > 0; }));
    ASSERT_EQ(told.count(), 1) << problem.value(0).value(0).toString().toStdString();
    EXPECT_TRUE(told[0][0].toString().contains(folder.path()));
    const QStringList files = told[0][1].toStringList();
    EXPECT_EQ(files.size(), 6) << "a table and a picture of each pair";
    for (const QString& file : files)
        EXPECT_TRUE(QFile::exists(file)) << file.toStdString();
    const QString commands = folder.filePath("commands");
    ASSERT_EQ(test::captured(feasibilityCommand, {kTriangle, "--reachable", commands}).code, 0);
    for (const char* stem : {"/reachable-1-2", "/reachable-1-3", "/reachable-2-3"}) {
        EXPECT_EQ(bytes(folder.path() + stem + ".csv"), bytes(commands + stem + ".csv"));
        EXPECT_TRUE(bytes(commands + stem + ".csv").startsWith(kReachableMark));
        const QImage picture(folder.path() + stem + ".png");
        EXPECT_EQ(picture.size(), QSize(960, 960));
        EXPECT_EQ(picture.text("Description"), QString(kReachableMark));
    }
    view.exportTo(folder.path()); // over its own
    ASSERT_TRUE(test::waitFor([&] { return told.count() == 2; }));
    for (const char* name : {"/reachable-1-3.csv", "/reachable-1-3.png"}) {
        const QByteArray before = bytes(folder.path() + name);
        QFile mine(folder.path() + name);
        ASSERT_TRUE(mine.open(QIODevice::WriteOnly));
        mine.write("my notes");
        mine.close();
        problem.clear();
        view.exportTo(folder.path());
        ASSERT_TRUE(test::waitFor([&] { return problem.count() == 1; }));
        EXPECT_TRUE(problem[0][0].toString().contains(name)) << problem[0][0].toString().toStdString();
        EXPECT_EQ(bytes(folder.path() + name), "my notes");
        ASSERT_TRUE(mine.open(QIODevice::WriteOnly));
        mine.write(before);
        mine.close();
    }
}

// Catches: maps made for a view that nobody sees.
TEST_F(PairsViewTest, AsksForMapsOnlyWhileShown) {
    QSignalSpy wanted(&view, &PairsView::wanted);
    view.hide();
    view.show();
    ASSERT_EQ(wanted.count(), 2);
    EXPECT_FALSE(wanted[0][0].toBool());
    EXPECT_TRUE(wanted[1][0].toBool());
}

// Catches: a key too wide for the room that a window of 1100 has beside the table, which then covers it.
TEST_F(PairsViewTest, ItFitsANarrowWindow) {
    EXPECT_LE(view.minimumSizeHint().width(), 365);
}

// Catches: words that stay in the old language or have no room in a longer one, and maps wider than the view.
TEST_F(PairsViewTest, LongerTextHasRoom) {
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (const int width : {280, 620, 1100}) {
        view.resize(width, 600);
        for (int i = 0; i < 6; ++i)
            QApplication::processEvents();
        for (const QLabel* label : view.findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty())
                continue;
            EXPECT_TRUE(label->text().contains('[')) << label->text().toStdString();
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
        }
        for (const ReachMap* map : view.findChildren<ReachMap*>())
            EXPECT_LE(map->mapTo(&view, QPoint(map->width(), 0)).x(), view.width()) << width;
    }
    qApp->removeTranslator(&longer);
}

} // namespace
} // namespace bask
