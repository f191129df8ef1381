// The operator calibrates a camera: views by themselves, solved, judged, left out, kept.

#include "widgets/calibrate/camera_panel.h"

#include "engine/base/message_code.h"
#include "engine/calibration/camera_file.h"
#include "tests/engine/calibration/calibration_samples.h"
#include "tests/support/longer_translator.h"
#include "tests/support/wait_for.h"
#include "tests/widgets/calibrate/vision_scene.h"
#include "widgets/calibrate/calibrate_page.h"
#include "widgets/calibrate/live_picture.h"
#include "widgets/calibrate/view_list.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/theme.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

const Board kBoard = *parseBoard("chessboard:9x6:0.025");

struct CameraPanelTest : testing::Test {
    test::VisionScene scene{kBoard};
    CalibratePage page;
    std::vector<std::optional<Board>> wanted;
    std::vector<CameraModel> chosen;

    CameraPanelTest() {
        auto* panel = child<CameraPanel>("cameraPanel");
        QObject::connect(panel, &CameraPanel::boardWanted, &page,
                         [this](const std::optional<Board>& board) { wanted.push_back(board); });
        QObject::connect(&page, &CalibratePage::visionEdited, &page,
                         [this](const VisionSpec& vision) { chosen.push_back(vision.camera.value()); });
        page.resize(1280, 800);
        page.show();
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        auto* found = page.cameraPanel()->findChild<T*>(name); // the sheets have a board, too
        if (!found)
            found = page.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    ViewList* list() { return child<ViewList>("viewList"); }
    QString text(const char* name) { return child<QLabel>(name)->text(); }
    QString message() { return child<MessageBar>("cameraMessage")->sentence(); }
    void click(const char* name) { child<QPushButton>(name)->click(); }
    QString status() { return text("captureStatus"); }
    /// Held there for half a second.
    void hold(const Pose& X_CB, double noise_px = 0.15) {
        for (int k = 0; k < 15; ++k)
            page.setView(scene.look(X_CB, noise_px));
    }
    void showAll() {
        for (const Pose& X_CB : test::patientPoses())
            hold(X_CB);
    }
    bool solved() {
        return test::waitFor([&] { return !child<QProgressBar>("solveProgress")->isVisible(); });
    }
    void calibrate() {
        click("captureStart");
        showAll();
        click("captureStart");
        click("solve");
        ASSERT_TRUE(solved());
    }
};

// Catches: a part of the way from the board to a camera that does not work: looking for it, taking views by
// itself, saying what is missing, solving, judging, handing over.
TEST_F(CameraPanelTest, FromABoardToACamera) {
    page.setView(scene.look());
    EXPECT_TRUE(wanted.empty()) << "nobody asked for a board yet";
    EXPECT_FALSE(child<QPushButton>("solve")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("cameraUse")->isEnabled());
    click("captureStart");
    ASSERT_EQ(wanted.size(), 1U);
    EXPECT_EQ(wanted.back(), kBoard);
    hold(test::patientPoses()[1]); // at the left edge
    EXPECT_EQ(list()->count(), 1);
    EXPECT_TRUE(status().contains("move the board on")) << status().toStdString();
    EXPECT_TRUE(text("coverageMissing").contains("right edge")) << text("coverageMissing").toStdString();
    showAll();
    EXPECT_GE(list()->count(), 15);
    EXPECT_TRUE(text("coverageMissing").contains("enough")) << text("coverageMissing").toStdString();
    EXPECT_EQ(child<QProgressBar>("coverageX")->value(), 100);
    click("captureStart");
    EXPECT_EQ(wanted.back(), std::nullopt);
    const int count = list()->count();
    hold(test::patientPoses()[0]);
    EXPECT_EQ(list()->count(), count) << "it is not looking";

    page.resize(1100, 560);
    QApplication::processEvents();
    EXPECT_TRUE(child<QLabel>("cameraVerdict")->visibleRegion().isEmpty()) << "far down";
    QSignalSpy steps(child<QProgressBar>("solveProgress"), &QProgressBar::valueChanged);
    click("solve");
    EXPECT_FALSE(child<QPushButton>("solve")->isEnabled());
    ASSERT_TRUE(solved());
    EXPECT_GE(steps.count(), 2) << "progress is told";
    EXPECT_EQ(text("cameraVerdict"), "Good");
    QApplication::processEvents();
    EXPECT_FALSE(child<QLabel>("cameraVerdict")->visibleRegion().isEmpty()) << "the answer is shown";
    EXPECT_TRUE(text("cameraReason").contains("at 0.6 m are")) << text("cameraReason").toStdString();
    EXPECT_TRUE(list()->topLevelItem(0)->text(1).endsWith("px"));
    click("cameraUse");
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_NEAR(chosen[0].fx, scene.camera.fx, 1.5);
    EXPECT_EQ(chosen[0].board, "chessboard:9x6:0.025");
    child<CameraPanel>("cameraPanel")->setCamera(chosen[0]);
    EXPECT_EQ(text("cameraVerdict"), "Good, in use");
    EXPECT_FALSE(child<QPushButton>("cameraUse")->isEnabled());
    child<CameraPanel>("cameraPanel")->setDistance(3.0);
    EXPECT_NE(text("cameraVerdict"), "Good, in use") << "millimetres grow with the distance";
    EXPECT_TRUE(text("cameraReason").contains("at 3 m are"));
}

// Catches: a bad view that is not pointed at, cannot be left out, or goes on counting; keys that do not work.
TEST_F(CameraPanelTest, AViewThatStandsOutIsLeftOutAndSolvedAgain) {
    click("captureStart");
    showAll();
    child<QCheckBox>("captureAutomatic")->click();
    page.setView(scene.look(test::patientPoses()[3], 4.0));
    EXPECT_TRUE(child<QPushButton>("captureTake")->isEnabled());
    const int bad = list()->count();
    click("captureTake");
    ASSERT_EQ(list()->count(), bad + 1);
    hold(test::patientPoses()[0]);
    EXPECT_EQ(list()->count(), bad + 1) << "not by itself any more";
    click("solve");
    ASSERT_TRUE(solved());
    EXPECT_TRUE(list()->topLevelItem(bad)->text(1).contains("stands out"));
    EXPECT_FALSE(list()->topLevelItem(0)->text(1).contains("stands out"));
    const QString before = text("cameraFacts");
    ASSERT_TRUE(child<QPushButton>("leaveOut")->isVisible());
    click("leaveOut");
    EXPECT_FALSE(list()->isUsed(bad));
    ASSERT_TRUE(solved());
    EXPECT_NE(text("cameraFacts"), before);
    EXPECT_FALSE(child<QPushButton>("leaveOut")->isVisible());
    EXPECT_FALSE(list()->topLevelItem(bad)->text(1).endsWith("px")) << "it has no residual now";
    EXPECT_EQ(text("cameraVerdict"), "Good");
    list()->setFocus();
    list()->setCurrentItem(list()->topLevelItem(bad));
    QTest::keyClick(list(), Qt::Key_Space);
    EXPECT_TRUE(list()->isUsed(bad));
    ASSERT_TRUE(solved());
    EXPECT_EQ(text("cameraFacts"), before);
}

// Catches: a wrong setting that leaves the operator waving the board for ever.
TEST_F(CameraPanelTest, AnotherBoardIsToldAndCanBeTaken) {
    click("captureStart");
    const Board other = *parseBoard("chessboard:8x6:0.025");
    VisionView view = scene.look();
    view.board = Result<BoardView>(Error{MessageCode::BoardNotSeen, "", {"9 x 6"}});
    page.setView(view);
    EXPECT_TRUE(status().contains("9 x 6"));
    EXPECT_TRUE(message().isEmpty());
    for (int k = 0; k < 2; ++k) {
        VisionView next = scene.look();
        next.board = view.board;
        next.boardSeen = other;
        page.setView(next);
    }
    EXPECT_TRUE(message().contains("8x6")) << message().toStdString();
    auto* action =
        page.cameraPanel()->findChild<MessageBar*>("cameraMessage")->findChild<QPushButton*>("messageAction");
    action->click();
    EXPECT_TRUE(message().isEmpty());
    EXPECT_EQ(wanted.back(), other);
    EXPECT_EQ(child<QDoubleSpinBox>("boardColumns")->value(), 8);
    scene.board = other;
    hold(test::patientPoses()[0]);
    EXPECT_EQ(list()->count(), 1);
}

// Catches: a lost camera that goes unsaid, or whose last picture is taken for a still view.
TEST_F(CameraPanelTest, ALostCameraIsTold) {
    auto* picture = child<LivePicture>("livePicture");
    EXPECT_TRUE(picture->sentence().contains("No picture"));
    click("captureStart");
    for (int k = 0; k < 5; ++k)
        page.setView(scene.look(test::patientPoses()[0]));
    VisionView lost = scene.look(test::patientPoses()[0]);
    lost.problem = {MessageCode::CameraLost, {"camera 0", "unplugged"}};
    for (int k = 0; k < 30; ++k)
        page.setView(lost);
    EXPECT_TRUE(picture->sentence().contains("unplugged"));
    EXPECT_TRUE(picture->accessibleDescription().contains("unplugged"));
    EXPECT_TRUE(status().contains("Waiting"));
    EXPECT_FALSE(child<QPushButton>("captureTake")->isEnabled());
    EXPECT_EQ(list()->count(), 0);
    for (int k = 0; k < 3; ++k)
        page.setView(scene.look(test::patientPoses()[0]));
    EXPECT_TRUE(picture->sentence().isEmpty());
    EXPECT_EQ(list()->count(), 0) << "stillness begins anew";
}

// Catches: a camera computed from pictures of two.
TEST_F(CameraPanelTest, ViewsOfAnotherCameraAreDropped) {
    click("captureStart");
    showAll();
    click("solve");
    VisionView other = scene.look(test::patientPoses()[0]);
    other.cameraName = "camera 1";
    page.setView(other);
    EXPECT_EQ(list()->count(), 0);
    EXPECT_FALSE(child<QProgressBar>("solveProgress")->isVisible());
    EXPECT_TRUE(child<QPushButton>("captureStart")->isChecked()) << "it is still looking";
    hold(test::patientPoses()[1]);
    EXPECT_EQ(list()->count(), 1);
    VisionView lost = scene.look();
    lost.problem = {MessageCode::CameraLost, {"camera 0", "unplugged"}};
    page.setView(lost);
    EXPECT_EQ(list()->count(), 1) << "it is the same when it is back";
}

// Catches: a camera that is used, or saved, as that of another one.
TEST_F(CameraPanelTest, WhatWasComputedOfAnotherCameraIsDropped) {
    calibrate();
    ASSERT_TRUE(child<QPushButton>("cameraUse")->isEnabled());
    VisionView other = scene.look(test::patientPoses()[0]);
    other.cameraName = "camera 1";
    page.setView(other);
    EXPECT_FALSE(child<QPushButton>("cameraUse")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("cameraSave")->isEnabled());
    EXPECT_FALSE(child<QPushButton>("captureTake")->isEnabled());
    EXPECT_EQ(text("cameraVerdict"), "No camera yet");

    CameraModel inUse = scene.camera;
    inUse.fx += 10.0;
    child<CameraPanel>("cameraPanel")->setCamera(inUse);
    page.setView(scene.look(test::patientPoses()[0]));
    EXPECT_EQ(text("cameraVerdict"), "The camera in use");
    EXPECT_FALSE(child<QPushButton>("cameraUse")->isEnabled());
}

// Catches: one frame shown twice that counts as two, and a view of another size mixed in.
TEST_F(CameraPanelTest, EachFrameCountsOnceAndHasOneSize) {
    click("captureStart");
    const VisionView same = scene.look(test::patientPoses()[0]);
    for (int k = 0; k < 40; ++k)
        page.setView(same);
    EXPECT_EQ(list()->count(), 0);
    hold(test::patientPoses()[0]);
    EXPECT_EQ(list()->count(), 1);
    scene.setPicture({640, 480, std::vector<std::uint8_t>(640 * 480, 90)});
    hold(test::patientPoses()[1]);
    EXPECT_EQ(list()->count(), 1);
    EXPECT_TRUE(status().contains("640 x 480")) << status().toStdString();
}

// Catches: a setting that is no board and is looked for all the same; a board changed under its views.
TEST_F(CameraPanelTest, TheBoardsSettingIsChecked) {
    child<QComboBox>("boardKind")->setCurrentIndex(1);
    child<QDoubleSpinBox>("boardMarker")->setValue(30.0);
    click("captureStart");
    EXPECT_FALSE(child<QPushButton>("captureStart")->isChecked());
    EXPECT_FALSE(message().isEmpty());
    child<QDoubleSpinBox>("boardMarker")->setValue(18.0);
    EXPECT_TRUE(message().isEmpty());
    click("captureStart");
    ASSERT_TRUE(wanted.back());
    EXPECT_EQ(wanted.back()->kind, BoardKind::Charuco);
    scene.board = *wanted.back();
    hold(test::patientPoses()[0]);
    ASSERT_EQ(list()->count(), 1);
    EXPECT_FALSE(child<QDoubleSpinBox>("boardColumns")->isEnabled());
    click("captureAgain");
    EXPECT_EQ(list()->count(), 0);
    EXPECT_TRUE(child<QDoubleSpinBox>("boardColumns")->isEnabled());
    child<QDoubleSpinBox>("boardColumns")->setValue(8);
    EXPECT_EQ(wanted.back()->columns, 8) << "it is still looking, for the new one";
}

// Catches: a GUI that waits for the solver; a calibration that was cancelled and comes all the same.
TEST_F(CameraPanelTest, SolvingHoldsNobodyUpAndCanBeCancelled) {
    click("captureStart");
    showAll();
    QElapsedTimer timer;
    timer.start();
    click("solve");
    EXPECT_LT(timer.elapsed(), 5000);
    ASSERT_TRUE(child<QPushButton>("solveCancel")->isVisible());
    click("solveCancel");
    EXPECT_FALSE(child<QProgressBar>("solveProgress")->isVisible());
    EXPECT_TRUE(child<QPushButton>("solve")->isEnabled());
    click("solve"); // waits for what was cancelled to end
    ASSERT_TRUE(solved());
    EXPECT_EQ(text("cameraVerdict"), "Good");
    QSignalSpy shown(child<QProgressBar>("solveProgress"), &QProgressBar::valueChanged);
    click("solve");
    click("solveCancel");
    list()->setUsed(0, false);
    EXPECT_FALSE(child<QProgressBar>("solveProgress")->isVisible()) << "nobody wants a camera now";
}

// Catches: numbers lost on the way to a file and back, and a file that cannot be read passed over in silence.
TEST_F(CameraPanelTest, ACameraIsSavedAndLoaded) {
    QTemporaryDir folder;
    calibrate();
    auto* panel = child<CameraPanel>("cameraPanel");
    QSignalSpy exported(panel, &CameraPanel::exported);
    for (const bool asRos : {false, true}) {
        const QString path = folder.filePath(asRos ? "ros.yaml" : "camera.yml");
        panel->saveCamera(path, asRos);
        ASSERT_TRUE(test::waitFor([&] { return exported.count() == (asRos ? 2 : 1); }));
        EXPECT_TRUE(exported.back()[0].toString().contains(QFileInfo(path).fileName()));
        EXPECT_EQ(exported.back()[1].toStringList(), QStringList{path}) << "it is opened from its message";
    }
    click("cameraUse");
    for (const char* name : {"camera.yml", "ros.yaml"}) {
        const auto read = readCamera(folder.filePath(name).toStdString());
        ASSERT_TRUE(read) << name;
        EXPECT_NEAR(read->fx, chosen[0].fx, 1e-6) << name;
    }
    panel->loadCamera(folder.filePath("camera.yml"));
    ASSERT_TRUE(test::waitFor([&] { return text("cameraVerdict").contains("camera.yml"); }));
    EXPECT_TRUE(text("cameraReason").contains("not checked"));
    click("cameraUse");
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[1].deviations.size(), 9U);
    panel->loadCamera(folder.filePath("missing.yml"));
    ASSERT_TRUE(test::waitFor([&] { return message().contains("missing.yml"); }));
    panel->saveCamera(folder.filePath("no/such/folder.yml"), false);
    ASSERT_TRUE(test::waitFor([&] { return message().contains("folder.yml"); }));
    EXPECT_EQ(exported.count(), 2);
}

// Catches: views that no camera explains, or too few, without a word.
TEST_F(CameraPanelTest, WhatCannotBeSolvedIsSaid) {
    click("captureStart");
    child<QCheckBox>("captureAutomatic")->click();
    for (int k = 0; k < 3; ++k) {
        page.setView(scene.look(test::patientPoses()[0]));
        click("captureTake");
    }
    click("solve");
    ASSERT_TRUE(solved());
    // Three views straight on: OpenCV 4.6 has a camera for them, 4.10 none.
    if (text("cameraVerdict") == "Redo")
        EXPECT_TRUE(text("cameraReason").contains("straight on"));
    else
        EXPECT_TRUE(message().contains("no camera explains these pictures")) << message().toStdString();
    list()->setUsed(0, false);
    ASSERT_TRUE(solved());
    EXPECT_TRUE(message().contains("too few")) << message().toStdString();
    EXPECT_FALSE(child<QPushButton>("solve")->isEnabled());
}

// Catches: the heat map drawn without being asked for, or not.
TEST_F(CameraPanelTest, TheHeatMapIsShownOnDemand) {
    std::vector<std::optional<HeatMap>> maps;
    QObject::connect(child<CameraPanel>("cameraPanel"), &CameraPanel::heatMapChanged, &page,
                     [&](const std::optional<HeatMap>& map) { maps.push_back(map); });
    click("captureStart");
    hold(test::patientPoses()[0]);
    EXPECT_FALSE(maps.back());
    child<QCheckBox>("coverageShown")->click();
    ASSERT_TRUE(maps.back());
    EXPECT_GT(maps.back()->corners[HeatMap::kColumns * 4 + 8], 0);
    child<QCheckBox>("coverageShown")->click();
    EXPECT_FALSE(maps.back());
}

// Catches: controls that a screen reader or the keyboard cannot find.
TEST_F(CameraPanelTest, EveryControlHasANameAndTheKeyboard) {
    child<QComboBox>("boardKind")->setCurrentIndex(1);
    for (QWidget* widget : page.findChildren<QWidget*>()) {
        auto* button = qobject_cast<QAbstractButton*>(widget);
        const bool isControl = button || qobject_cast<QAbstractSpinBox*>(widget) ||
                               qobject_cast<QComboBox*>(widget) || qobject_cast<ViewList*>(widget) ||
                               qobject_cast<QProgressBar*>(widget) || qobject_cast<LivePicture*>(widget);
        const bool hasName = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        const QString name = widget->objectName();
        if (isControl && widget->isVisibleTo(&page) && widget->focusPolicy() != Qt::NoFocus &&
            !name.isEmpty() && !name.startsWith("qt_")) {
            EXPECT_TRUE(hasName) << name.toStdString() << " " << widget->metaObject()->className();
        }
        if (button && !name.isEmpty() && name != "messageClose") {
            EXPECT_NE(button->focusPolicy() & Qt::TabFocus, 0) << name.toStdString();
        }
    }
}

// Catches: text that stays in the old language or has no room in a longer one.
TEST_F(CameraPanelTest, LanguageChangeWithLongerText) {
    calibrate();
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (int i = 0; i < 6; ++i)
        QApplication::processEvents();
    page.grab().save("calibrate_longer.png");
    static const QRegularExpression kWords("[A-Za-z]{4}");
    for (QLabel* label : page.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(kWords)) {
            EXPECT_TRUE(label->text().contains('[')) << label->text().toStdString();
        }
    for (QPushButton* button : page.findChildren<QPushButton*>())
        if (button->isVisible()) {
            EXPECT_TRUE(button->text().startsWith('[')) << button->text().toStdString();
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
        }
    auto* panel = child<CameraPanel>("cameraPanel");
    EXPECT_LE(panel->minimumSizeHint().width(), panel->width());
    qApp->removeTranslator(&longer);
    QApplication::processEvents();
    EXPECT_EQ(child<QPushButton>("solve")->text(), "&Calibrate");
}

// Keeps pictures of the page in both themes, and catches one that needs more room than a laptop has.
TEST_F(CameraPanelTest, PictureInBothThemes) {
    const Pose X_CB = test::patientPoses()[8];
    CameraModel straight = scene.camera;
    straight.distortion.assign(5, 0.0);
    scene.camera = straight;
    const Pose corner = X_CB * Pose(Eigen::Translation3d(-0.025, -0.025, 0.0)); // of the pattern
    scene.setPicture(test::pictureOf(darkSquares(kBoard), corner, straight));
    click("captureStart");
    showAll();
    page.setView(scene.look(test::patientPoses()[1], 3.0));
    click("captureTake");
    child<QCheckBox>("coverageShown")->click();
    click("solve");
    ASSERT_TRUE(solved());
    page.setView(scene.look(X_CB, 0.0));
    for (const bool dark : {false, true}) {
        applyTheme(*qApp, dark ? Theme::Dark : Theme::Light);
        auto* scroll = page.findChild<QScrollArea*>();
        for (const int place : {0, 10000}) {
            scroll->verticalScrollBar()->setValue(place);
            QApplication::processEvents();
            EXPECT_TRUE(page.grab().save(QStringLiteral("calibrate_%1_%2.png")
                                             .arg(dark ? "dark" : "light", place == 0 ? "top" : "bottom")));
        }
    }
    applyTheme(*qApp, Theme::Light);
    EXPECT_LE(page.minimumSizeHint().width(), 1100);
    EXPECT_LE(page.minimumSizeHint().height(), 560);
}

} // namespace
} // namespace bask
