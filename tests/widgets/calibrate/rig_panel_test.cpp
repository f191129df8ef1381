// The operator measures where the camera stands and where the source is, by a true rig's projected markers
// and a robot that goes where it is sent.

#include "widgets/calibrate/rig_panel.h"

#include "tests/support/longer_translator.h"
#include "tests/support/marker_pictures.h"
#include "tests/support/wait_for.h"
#include "tests/widgets/calibrate/rig_bench.h"
#include "widgets/calibrate/calibrate_page.h"
#include "widgets/common/theme.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// As coordinates of a thing that the camera sees at the source.
double offAtSource_m(const Pose& X_RC, const test::RigBench& bench) {
    const Eigen::Vector3d p_C = bench.X_RC.inverse() * bench.X_RS.translation();
    return (X_RC * p_C - bench.X_RS.translation()).norm();
}

struct RigPanelTest : testing::Test {
    test::RigBench bench;
    Experiment experiment = bench.experiment;
    CalibratePage page;
    RigPanel& panel = *page.findChild<RigPanel*>("rigPanel");
    bool mayMove = true;
    bool robotObeys = true;
    int moves = 0, holds = 0;
    std::vector<bool> follows;

    RigPanelTest() {
        experiment.vision.cameraPose.reset();
        connectAll();
        page.setExperiment(experiment);
        page.resize(1280, 800);
        child<QTabWidget>("calibrateTabs")->setCurrentIndex(1);
        page.show();
        QApplication::processEvents();
    }
    void connectAll() {
        QObject::connect(&page, &CalibratePage::visionEdited, &page, [this](const VisionSpec& vision) {
            experiment.vision = vision;
            page.setExperiment(experiment);
        });
        QObject::connect(&page, &CalibratePage::sourceMeasured, &page,
                         [this](const VisionSpec& vision, const Vector6d& pose) {
                             experiment.vision = vision;
                             experiment.source.pose = pose;
                             page.setExperiment(experiment);
                         });
        QObject::connect(&page, &CalibratePage::moveWanted, &page, [this](const Vector6d& goal) {
            ++moves;
            if (robotObeys)
                bench.goal = goal;
        });
        QObject::connect(&page, &CalibratePage::holdWanted, &page, [this] {
            ++holds;
            bench.goal.reset();
        });
        QObject::connect(&page, &CalibratePage::followWanted, &page,
                         [this](bool follow) { follows.push_back(follow); });
    }
    template <class T> T* child(const char* name) {
        auto* found = panel.findChild<T*>(name); // the thermal camera has a survey, too
        if (!found)
            found = page.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString text(const char* name) { return child<QLabel>(name)->text(); }
    QString status() { return text("surveyStatus"); }
    QPushButton* button(const char* name) { return child<QPushButton>(name); }
    bool isBusy() { return child<QProgressBar>("surveyProgress")->isVisible(); }
    void looks(int count) {
        for (int k = 0; k < count; ++k) {
            bench.move();
            page.setRobot(bench.robot, bench.goal.has_value(), mayMove);
            page.setView(bench.look());
        }
    }
    /// Until the panel has its answer; the robot and the camera go on meanwhile.
    bool measured(const char* name) {
        looks(1);
        EXPECT_TRUE(button(name)->isEnabled()) << name << ": " << status().toStdString();
        button(name)->click();
        for (int k = 0; k < 200 && isBusy(); ++k) {
            looks(8); // to each that is painted
            QApplication::processEvents();
        }
        return test::waitFor([&] { return !isBusy(); });
    }
};

} // namespace

// Catches: a place in other axes or of another pose; one that is in use before the operator says so; a date
// that is missing; the robot moved where it was told to stay.
TEST_F(RigPanelTest, WhereTheCameraStandsFromHere) {
    EXPECT_EQ(text("placeVerdict"), "Not measured");
    ASSERT_TRUE(measured("placeHere"));
    EXPECT_EQ(status(), QString());
    EXPECT_EQ(moves, 0);
    EXPECT_FALSE(experiment.vision.cameraPose);
    EXPECT_TRUE(text("placeText").contains("by 1 pose")) << text("placeText").toStdString();
    button("placeUse")->click();
    ASSERT_TRUE(experiment.vision.cameraPose);
    EXPECT_FALSE(experiment.vision.cameraPoseDate.empty());
    EXPECT_LT(offAtSource_m(poseFromCoordinates(*experiment.vision.cameraPose), bench), 5e-3);
    EXPECT_TRUE(text("placeVerdict").contains("in use"));
    EXPECT_FALSE(button("placeUse")->isEnabled());
}

// Catches: a tour that does not come back, does not pay, or whose check measures nothing.
TEST_F(RigPanelTest, WhereTheCameraStandsBySeveralPosesAndChecked) {
    EXPECT_FALSE(button("placeCheck")->isEnabled()) << "nothing to check";
    ASSERT_TRUE(measured("placeTour"));
    EXPECT_EQ(status(), QString());
    EXPECT_GE(moves, 5);
    EXPECT_TRUE(bench.robot.isApprox(experiment.start, 1e-9));
    EXPECT_NE(text("placeVerdict"), "Redo");
    EXPECT_TRUE(text("placeText").contains(QString("by %1 pose").arg(moves)))
        << text("placeText").toStdString();
    button("placeUse")->click();
    EXPECT_LT(offAtSource_m(poseFromCoordinates(experiment.vision.cameraPose.value()), bench), 1.5e-3);

    moves = 0;
    ASSERT_TRUE(measured("placeCheck"));
    EXPECT_TRUE(text("placeText").contains("Checked at another pose")) << text("placeText").toStdString();
    looks(20);
    EXPECT_EQ(moves, 2) << "there and back";
    EXPECT_TRUE(bench.robot.isApprox(experiment.start, 1e-9));
}

// Catches: a check of the pose by itself, which is always right.
TEST_F(RigPanelTest, ARobotThatDoesNotMoveChecksNothing) {
    ASSERT_TRUE(measured("placeHere"));
    robotObeys = false;
    ASSERT_TRUE(measured("placeCheck"));
    EXPECT_TRUE(status().contains("did not move")) << status().toStdString();
    EXPECT_FALSE(text("placeText").contains("Checked"));
}

// Catches: the inverse of the pose, or one of a source as typed; a source that moves without being asked.
TEST_F(RigPanelTest, WhereTheSourceIs) {
    EXPECT_EQ(text("sourceVerdict"), "As typed");
    ASSERT_TRUE(measured("sourceMeasure"));
    EXPECT_NE(text("sourceVerdict"), "Redo") << text("sourceText").toStdString();
    EXPECT_TRUE(text("sourceText").contains("from where the experiment has it"));
    EXPECT_EQ(experiment.source.pose, bench.experiment.source.pose);
    button("sourceUse")->click();
    const Pose X_RS = poseFromCoordinates(experiment.source.pose);
    EXPECT_LT((X_RS.translation() - bench.X_RS.translation()).norm(), 2e-3);
    EXPECT_LT(Eigen::AngleAxisd(X_RS.linear()).angle(), 0.01);
    EXPECT_FALSE(experiment.vision.sourcePoseDate.empty());
    EXPECT_TRUE(text("sourceVerdict").contains("in use"));
    EXPECT_FALSE(text("sourceText").contains("from where the experiment has it"));
    EXPECT_FALSE(button("sourceUse")->isEnabled());
}

// Catches: a button that does nothing without a word why.
TEST_F(RigPanelTest, SaysWhyNothingCanBeMeasured) {
    EXPECT_TRUE(status().contains("No picture")) << status().toStdString();
    mayMove = false;
    looks(1);
    EXPECT_TRUE(status().contains("armed")) << status().toStdString();
    for (const char* name :
         {"placeHere", "placeTour", "placeCheck", "sourceMeasure", "placeUse", "sourceUse"})
        EXPECT_FALSE(button(name)->isEnabled()) << name;
    mayMove = true;
    looks(1);
    EXPECT_EQ(status(), QString());
    EXPECT_TRUE(button("placeHere")->isEnabled());

    VisionView lost = bench.look();
    lost.problem = {MessageCode::CameraLost, {"camera 0", "unplugged"}};
    page.setView(lost);
    EXPECT_TRUE(status().contains("unplugged"));
    EXPECT_FALSE(button("placeHere")->isEnabled());

    const auto markers = experiment.vision.markers;
    std::erase_if(experiment.vision.markers, [](const auto& m) { return m.part == Part::EndEffector; });
    page.setExperiment(experiment);
    EXPECT_TRUE(status().contains("markers on the end-effector"));
    experiment.vision.markers = markers;
    std::erase_if(experiment.vision.markers, [](const auto& m) { return m.part == Part::Source; });
    page.setExperiment(experiment);
    looks(1);
    EXPECT_TRUE(button("placeHere")->isEnabled());
    EXPECT_FALSE(button("sourceMeasure")->isEnabled());
    experiment.vision.camera.reset();
    page.setExperiment(experiment);
    EXPECT_TRUE(status().contains("Calibrate the camera"));
}

// Catches: markers that nobody sees, or that sit elsewhere than said, measured in silence.
TEST_F(RigPanelTest, MissingAndMisplacedMarkersAreTold) {
    bench.hidesEndEffector = true;
    ASSERT_TRUE(measured("placeHere"));
    EXPECT_TRUE(status().contains("seen")) << status().toStdString();
    EXPECT_FALSE(button("placeUse")->isEnabled());
    ASSERT_TRUE(measured("sourceMeasure"));
    EXPECT_TRUE(status().contains("10, 11, 12")) << status().toStdString();
    bench.hidesEndEffector = false;
    for (MarkerSpec& marker : bench.markers)
        if (marker.id == 12)
            marker.pose[kX] += 0.03;
    ASSERT_TRUE(measured("placeTour"));
    EXPECT_TRUE(status().contains("12") || text("placeText").contains("marker 12"))
        << status().toStdString() << text("placeText").toStdString();
}

// Catches: a measurement that goes on into a run, a robot that is not stopped on its way, and one that is
// told to hold when the run has it.
TEST_F(RigPanelTest, CancelStopsTheRobotAndARunEndsItAll) {
    page.resize(1100, 560);
    QApplication::processEvents();
    looks(1);
    button("placeTour")->click();
    looks(3);
    EXPECT_TRUE(status().contains("pose 1 of")) << status().toStdString();
    EXPECT_FALSE(button("surveyCancel")->visibleRegion().isEmpty()) << "scrolled to";
    QTest::mouseClick(button("surveyCancel"), Qt::LeftButton);
    EXPECT_EQ(holds, 1);
    EXPECT_FALSE(isBusy());
    EXPECT_EQ(status(), QString());
    looks(5);
    button("placeTour")->click();
    looks(3);
    mayMove = false;
    looks(1);
    EXPECT_EQ(holds, 1) << "the run has the robot";
    EXPECT_FALSE(isBusy());
    EXPECT_TRUE(status().contains("armed"));
    const int before = moves;
    looks(50);
    EXPECT_EQ(moves, before);
    EXPECT_FALSE(button("placeTour")->isEnabled());
}

// Catches: a place measured with one camera, or with other markers, used for another.
TEST_F(RigPanelTest, AnotherCameraOrOtherMarkersDropWhatWasMeasured) {
    const auto remeasured = [this] {
        return measured("placeHere") && measured("sourceMeasure") && button("placeUse")->isEnabled() &&
               button("sourceUse")->isEnabled();
    };
    const auto dropped = [this] {
        return !button("placeUse")->isEnabled() && !button("sourceUse")->isEnabled() &&
               text("placeVerdict") == "Not measured";
    };
    ASSERT_TRUE(remeasured());
    experiment.title = "another title";
    page.setExperiment(experiment);
    EXPECT_TRUE(button("placeUse")->isEnabled()) << "the rig is the same";
    experiment.vision.camera->fx += 1.0;
    page.setExperiment(experiment);
    EXPECT_TRUE(dropped());
    experiment.vision.camera->fx -= 1.0;
    page.setExperiment(experiment);
    ASSERT_TRUE(remeasured());
    experiment.vision.markers[0].side_m = 0.049;
    page.setExperiment(experiment);
    EXPECT_TRUE(dropped());
    ASSERT_TRUE(remeasured());
    VisionView other = bench.look();
    other.cameraName = "camera 1";
    page.setView(other);
    EXPECT_TRUE(dropped());

    looks(1);
    button("placeHere")->click();
    looks(3);
    ASSERT_TRUE(isBusy());
    other = bench.look();
    other.cameraName = "camera 1";
    page.setView(other);
    EXPECT_FALSE(isBusy()) << "pictures of two cameras are never mixed";
}

// Catches: corners of a picture of another size measured with the calibration of this one.
TEST_F(RigPanelTest, PicturesOfAnotherSizeAreNotMeasuredIn) {
    bench.picture = {640, 360, std::vector<std::uint8_t>(640 * 360, 90)};
    looks(1);
    EXPECT_TRUE(status().contains("640 x 360")) << status().toStdString();
    EXPECT_FALSE(button("placeHere")->isEnabled());
}

// Catches: following offered without what it takes, a tick that says what is not so.
TEST_F(RigPanelTest, FollowingTheSourceTakesACamerasPlace) {
    auto* follow = child<QCheckBox>("sourceFollow");
    experiment.source.tracked = false;
    page.setExperiment(experiment);
    looks(1);
    EXPECT_FALSE(follow->isEnabled());
    experiment.vision.cameraPose = bench.experiment.vision.cameraPose;
    page.setExperiment(experiment);
    EXPECT_TRUE(follow->isEnabled());
    follow->click();
    EXPECT_EQ(follows, std::vector<bool>{true});
    experiment.source.tracked = true;
    page.setExperiment(experiment);
    EXPECT_TRUE(follow->isChecked());
}

// Catches: controls that a screen reader or the keyboard cannot find, or that are reached in another order
// than they are read.
TEST_F(RigPanelTest, EveryControlHasANameAndTheKeyboard) {
    ASSERT_TRUE(measured("placeHere"));
    ASSERT_TRUE(measured("sourceMeasure"));
    for (QWidget* widget : panel.findChildren<QWidget*>()) {
        auto* asButton = qobject_cast<QAbstractButton*>(widget);
        const bool isControl = asButton || qobject_cast<QAbstractSpinBox*>(widget) ||
                               qobject_cast<QComboBox*>(widget) || qobject_cast<QTreeWidget*>(widget) ||
                               qobject_cast<QProgressBar*>(widget);
        const QString name = widget->objectName();
        if (!isControl || name.isEmpty() || name.startsWith("qt_"))
            continue;
        EXPECT_TRUE(!widget->accessibleName().isEmpty() || (asButton && !asButton->text().isEmpty()))
            << name.toStdString();
        if (asButton) {
            EXPECT_NE(asButton->focusPolicy() & Qt::TabFocus, 0) << name.toStdString();
        }
    }
    QStringList order;
    QWidget* at = child<QComboBox>("markerDictionary");
    for (int k = 0; k < 300 && panel.isAncestorOf(at); ++k, at = at->nextInFocusChain()) {
        const QString name = at->objectName();
        if ((at->focusPolicy() & Qt::TabFocus) != 0 && !name.isEmpty() && !name.startsWith("qt_"))
            order << name;
    }
    const QStringList read{
        "markerDictionary", "markerAdd",    "markerRemove", "markerList", "markerPart",     "markerId",
        "markerSide",       "marker.x",     "marker.y",     "marker.z",   "marker.theta_x", "marker.theta_y",
        "marker.theta_z",   "placeHere",    "placeTour",    "placeCheck", "placeUse",       "sourceMeasure",
        "sourceUse",        "sourceFollow", "surveyCancel"};
    EXPECT_EQ(order.join(' ').toStdString(), read.join(' ').toStdString());
}

// Catches: text that stays in the old language or has no room in a longer one.
TEST_F(RigPanelTest, LanguageChangeWithLongerText) {
    ASSERT_TRUE(measured("placeHere"));
    ASSERT_TRUE(measured("sourceMeasure"));
    LongerTranslator longer;
    qApp->installTranslator(&longer);
    for (int i = 0; i < 6; ++i)
        QApplication::processEvents();
    static const QRegularExpression kWords("[A-Za-z]{4}");
    for (QLabel* label : panel.findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(kWords)) {
            EXPECT_TRUE(label->text().contains('[')) << label->text().toStdString();
        }
    for (QPushButton* each : panel.findChildren<QPushButton*>())
        if (each->isVisible()) {
            EXPECT_TRUE(each->text().startsWith('[')) << each->text().toStdString();
            EXPECT_GE(each->width(), each->minimumSizeHint().width()) << each->text().toStdString();
        }
    EXPECT_LE(panel.minimumSizeHint().width(), panel.width());
    qApp->removeTranslator(&longer);
    QApplication::processEvents();
    EXPECT_EQ(button("placeTour")->text(), "&Several poses");
}

// Keeps pictures of the tab in both themes, and catches one that is wider than its room.
TEST_F(RigPanelTest, Pictures) {
    test::MarkerPictures pictures(bench.camera);
    GreyPicture picture = pictures.blank();
    CameraModel straight = bench.camera;
    straight.distortion.assign(5, 0.0);
    bench.camera = straight;
    const test::MarkerPictures drawing(straight);
    for (const MarkerSpec& marker : bench.markers) {
        const Pose X_RP = marker.part == Part::Source ? bench.X_RS : poseFromCoordinates(bench.robot);
        drawing.draw(picture, {marker.part, marker.id, marker.side_m, poseFromCoordinates(marker.pose)},
                     {"4X4_50"}, bench.X_RC.inverse() * X_RP);
    }
    bench.picture = picture;
    experiment.vision.camera = straight;
    page.setExperiment(experiment);
    ASSERT_TRUE(measured("placeTour"));
    ASSERT_TRUE(measured("placeCheck"));
    looks(20);
    ASSERT_TRUE(measured("sourceMeasure"));
    for (const char* name : {"light", "dark", "measuring"}) {
        applyTheme(*qApp, name == QLatin1String("dark") ? Theme::Dark : Theme::Light);
        if (name == QLatin1String("measuring")) {
            button("placeTour")->click();
            looks(15);
        }
        auto* scroll = qobject_cast<QScrollArea*>(panel.parentWidget()->parentWidget()->parentWidget());
        for (const int place : {0, 10000}) {
            for (int i = 0; i < 4; ++i)
                QApplication::processEvents();
            scroll->verticalScrollBar()->setValue(place);
            QApplication::processEvents();
            EXPECT_TRUE(page.grab().save(QString("rig_%1_%2.png").arg(name, place == 0 ? "top" : "bottom")));
        }
        EXPECT_LE(panel.minimumSizeHint().width(), panel.width()) << name;
    }
}

} // namespace bask
