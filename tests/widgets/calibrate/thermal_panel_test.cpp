// The operator finds where the thermal camera is, by the pictures of a true rig and a robot that goes where
// it is sent, and calibrates its lens.

#include "widgets/calibrate/thermal_panel.h"

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"
#include "engine/rig/rig_setup.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "tests/engine/calibration/calibration_samples.h"
#include "tests/support/wait_for.h"
#include "widgets/calibrate/calibrate_page.h"
#include "widgets/calibrate/camera_panel.h"
#include "widgets/calibrate/thermal_board_watch.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace bask {
namespace {

Experiment exampleWithCamera() {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    ThermalCalibration believed; // as somebody measured it with a tape
    believed.pose = coordinatesFromPose(trueThermalPose(experiment));
    *believed.pose += Vector6d{{0.02, -0.015, 0.03, 0.03, -0.02, 0.04}};
    calibrateThermalCamera(experiment, believed);
    return experiment;
}

struct ThermalPanelTest : testing::Test {
    Experiment experiment = exampleWithCamera();
    SimulatedThermalCamera camera{*simulatedRigConfig(experiment).thermalCamera};
    double object_K = 333.15;
    Vector6d robot = experiment.start;
    std::optional<Vector6d> goal;
    bool mayMove = true;
    int holds = 0, calibrations = 0;
    std::vector<bool> watched, lightWatched;
    CalibratePage page;
    QWidget& panel = *page.findChild<QWidget*>("thermalPanel");

    ThermalPanelTest() {
        QObject::connect(&page, &CalibratePage::thermalCalibrated, &page,
                         [this](const ThermalCalibration& calibration) {
                             ++calibrations;
                             calibrateThermalCamera(experiment, calibration);
                             page.setExperiment(experiment);
                         });
        QObject::connect(&page, &CalibratePage::moveWanted, &page, [this](const Vector6d& q) { goal = q; });
        QObject::connect(&page, &CalibratePage::holdWanted, &page, [this] {
            ++holds;
            goal.reset();
        });
        QObject::connect(&page, &CalibratePage::thermalWatchWanted, &page,
                         [this](bool isWatched) { watched.push_back(isWatched); });
        QObject::connect(&page, &CalibratePage::watchWanted, &page,
                         [this](bool isWatched) { lightWatched.push_back(isWatched); });
        page.setExperiment(experiment);
        page.resize(1280, 800);
        page.show();
        QApplication::processEvents();
        choose(1);
        page.findChild<QTabWidget*>("calibrateTabs")->setCurrentIndex(3);
        QApplication::processEvents();
    }

    void choose(int item) {
        auto* choice = page.findChild<QComboBox*>("cameraChoice");
        choice->setCurrentIndex(item);
        emit choice->activated(item);
        QApplication::processEvents();
    }
    template <class T> T* child(const char* name) {
        T* found = panel.findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString text(const char* name) { return child<QLabel>(name)->text(); }
    bool isBusy() { return child<QProgressBar>("surveyProgress")->isVisible(); }

    /// A fifth of a second later.
    void look() {
        if (goal) {
            const Vector6d way = *goal - robot;
            const double far = way.cwiseAbs().maxCoeff();
            robot += far > 0.02 ? Vector6d(way * (0.02 / far)) : way;
            if (far <= 0.02)
                goal.reset();
        }
        m_time_s += 0.2;
        ThermalMoment moment;
        moment.time_s = m_time_s;
        moment.X_RE = poseFromCoordinates(robot);
        moment.source_K = {298.15};
        for (const ObjectSpec& object : experiment.objects) {
            const FaceSurroundings face{object.material.emittance, {}, 298.15};
            moment.objects.push_back({object_K, face, face});
        }
        camera.observe(moment);
        ThermalView view;
        view.cameraName = "p2-pro";
        const auto frame = camera.newest().value();
        view.picture = std::make_shared<ThermalPicture>(frame->frame.picture);
        view.time_s = frame->time_s;
        page.setRobot(robot, goal.has_value(), mayMove);
        page.setThermalView(view);
        QApplication::processEvents();
    }
    void survey() {
        look();
        ASSERT_TRUE(child<QPushButton>("thermalTour")->isEnabled()) << text("surveyStatus").toStdString();
        child<QPushButton>("thermalTour")->click();
        for (int k = 0; k < 400 && isBusy() && !text("surveyStatus").startsWith("Computing"); ++k)
            look();
        ASSERT_TRUE(test::waitFor([&] { return !isBusy(); }));
    }
    double offAtObjects_m(const Vector6d& pose) const {
        const Pose X_RC = trueThermalPose(experiment);
        const Eigen::Vector3d p_R(0.0, 0.0, 0.15);
        return (poseFromCoordinates(pose) * (X_RC.inverse() * p_R) - p_R).norm();
    }

private:
    double m_time_s = 0.0;
};

} // namespace

// Catches: pictures of another moment than their pose, a pose used before anybody says so, one in other axes.
TEST_F(ThermalPanelTest, FindsWhereItIs) {
    EXPECT_EQ(text("thermalVerdict"), "As typed");
    EXPECT_FALSE(child<QPushButton>("thermalUse")->isEnabled());
    survey();
    EXPECT_EQ(text("surveyStatus"), "");
    EXPECT_TRUE(text("thermalVerdict") == "Good" || text("thermalVerdict") == "Usable")
        << text("thermalText").toStdString();
    EXPECT_TRUE(text("thermalText").contains("from where the experiment has it"));
    EXPECT_EQ(calibrations, 0);
    EXPECT_GT(offAtObjects_m(*thermalCalibration(experiment, true).pose), 0.02);
    EXPECT_LT((robot - experiment.start).cwiseAbs().maxCoeff(), 2e-3) << "it is back";
    child<QPushButton>("thermalUse")->click();
    ASSERT_EQ(calibrations, 1);
    const ThermalCalibration used = thermalCalibration(experiment, true);
    EXPECT_LT(offAtObjects_m(*used.pose), 1e-3);
    EXPECT_FALSE(used.poseDate.empty());
    ASSERT_TRUE(used.poseUncertainty_m);
    EXPECT_GT(*used.poseUncertainty_m, 0.0);
    EXPECT_LT(*used.poseUncertainty_m, 1e-3);
    EXPECT_TRUE(text("thermalVerdict").contains("in use"));
    EXPECT_FALSE(child<QPushButton>("thermalUse")->isEnabled());
}

TEST_F(ThermalPanelTest, SaysWhyItCannot) {
    object_K = 298.15;
    survey();
    EXPECT_TRUE(text("surveyStatus").contains("warmer or colder")) << text("surveyStatus").toStdString();
    EXPECT_EQ(text("thermalVerdict"), "As typed");
    mayMove = false;
    look();
    EXPECT_FALSE(child<QPushButton>("thermalTour")->isEnabled());
    EXPECT_TRUE(text("surveyStatus").contains("armed"));
}

// Catches a robot that goes on, or is held, when a run has taken it.
TEST_F(ThermalPanelTest, EndsWhenARunBeginsOrItIsCancelled) {
    look();
    child<QPushButton>("thermalTour")->click();
    look();
    ASSERT_TRUE(isBusy());
    mayMove = false;
    look();
    EXPECT_FALSE(isBusy());
    EXPECT_EQ(holds, 0);
    mayMove = true;
    goal.reset();
    look();
    child<QPushButton>("thermalTour")->click();
    look();
    child<QPushButton>("surveyCancel")->click();
    EXPECT_FALSE(isBusy());
    EXPECT_EQ(holds, 1);
}

// Catches a robot that goes on where nobody sees it, or by itself when the page is seen again.
TEST_F(ThermalPanelTest, EndsWhenItIsSeenNoMoreOrSeesNothing) {
    auto* tabs = page.findChild<QTabWidget*>("calibrateTabs");
    const auto begin = [&] {
        tabs->setCurrentIndex(3);
        goal.reset();
        look();
        look();
        child<QPushButton>("thermalTour")->click();
        look();
        ASSERT_TRUE(isBusy()) << text("surveyStatus").toStdString();
    };
    const auto expectEnded = [&](int held) {
        EXPECT_EQ(holds, held);
        for (int k = 0; k < 20; ++k)
            look();
        EXPECT_FALSE(isBusy());
        EXPECT_FALSE(goal);
    };
    begin();
    page.hide();
    page.show();
    expectEnded(1);
    begin();
    choose(0);
    choose(1);
    tabs->setCurrentIndex(3);
    expectEnded(2);
    begin();
    ThermalView lost;
    lost.problem = {MessageCode::CameraLost, {"0", "unplugged"}};
    page.setThermalView(lost);
    EXPECT_FALSE(text("surveyStatus").isEmpty());
    expectEnded(3);

    RigSpec& rig = experiment.rig.emplace();
    rig.thermalCamera.emplace().profile = findThermalProfile("p2-pro").value();
    rig.thermalCamera->calibration = experiment.simulation.thermalCamera->calibration;
    page.setExperiment(experiment);
    begin();
    experiment.rig->thermalCamera->calibration.pose.reset();
    page.setExperiment(experiment);
    expectEnded(4);
    EXPECT_TRUE(text("surveyStatus").contains("Rig page"));
}

// Catches a place that was found with the simulated camera and is used for a true one.
TEST_F(ThermalPanelTest, AnotherCameraIsMeasuredAnew) {
    survey();
    ASSERT_TRUE(child<QPushButton>("thermalUse")->isEnabled());
    experiment.objects[0].target_K += 1.0;
    page.setExperiment(experiment);
    EXPECT_TRUE(child<QPushButton>("thermalUse")->isEnabled());
    RigSpec& rig = experiment.rig.emplace();
    rig.thermalCamera.emplace().profile = findThermalProfile("p2-pro").value();
    rig.thermalCamera->calibration = experiment.simulation.thermalCamera->calibration;
    page.setExperiment(experiment);
    EXPECT_FALSE(child<QPushButton>("thermalUse")->isEnabled());
    EXPECT_EQ(text("thermalVerdict"), "As typed");
}

// Catches two cameras that are watched at once, and panels of one with the other's pictures.
TEST_F(ThermalPanelTest, IsThereForTheThermalCameraOnly) {
    auto* tabs = page.findChild<QTabWidget*>("calibrateTabs");
    auto* picture = page.findChild<ThermalPictureView*>();
    EXPECT_TRUE(watched.back());
    EXPECT_FALSE(lightWatched.back());
    EXPECT_TRUE(picture->isVisible());
    EXPECT_FALSE(tabs->isTabVisible(0));
    EXPECT_TRUE(tabs->isTabVisible(3));
    choose(0);
    EXPECT_FALSE(watched.back());
    EXPECT_TRUE(lightWatched.back());
    EXPECT_FALSE(picture->isVisible());
    EXPECT_TRUE(tabs->isTabVisible(0));
    EXPECT_FALSE(tabs->isTabVisible(3));
    choose(1);
    page.hide();
    EXPECT_FALSE(watched.back());
    page.show();
    EXPECT_TRUE(watched.back());
    experiment.simulation.thermalCamera.reset();
    for (ObjectSpec& object : experiment.objects)
        object.readBy = ReadBy::Contact;
    page.setExperiment(experiment);
    EXPECT_FALSE(watched.back());
    EXPECT_EQ(page.findChild<QComboBox*>("cameraChoice")->count(), 1);
}

// Catches a place that counts as typed and is told as if it were measured well enough.
TEST_F(ThermalPanelTest, TellsAPlaceThatAnEarlierVersionMeasured) {
    ThermalCalibration believed = thermalCalibration(experiment, true);
    believed.poseDate = "2026-11-20T22:45:00Z";
    calibrateThermalCamera(experiment, believed);
    page.setExperiment(experiment);
    EXPECT_EQ(text("thermalVerdict"), "Measured by an earlier version: measure it again");
    believed.poseUncertainty_m = 0.0003;
    calibrateThermalCamera(experiment, believed);
    page.setExperiment(experiment);
    EXPECT_EQ(text("thermalVerdict"), "In use");
}

// Catches views of a lens that are never taken from thermal pictures, or in another size.
TEST_F(ThermalPanelTest, ItsLensIsCalibratedByABoard) {
    ThermalCalibration measured = thermalCalibration(experiment, true);
    measured.poseUncertainty_m = 0.0003;
    calibrateThermalCamera(experiment, measured);
    page.setExperiment(experiment);
    auto& lens = *page.findChild<CameraPanel*>("thermalLensPanel");
    lens.setBoard(parseBoard("chessboard:9x6:0.025").value());
    look(); // no run is on
    lens.findChild<QPushButton*>("captureStart")->click();
    double time_s = 10.0;
    auto* list = lens.findChild<QTreeWidget*>();
    ASSERT_NE(list, nullptr);
    ThermalView last;
    int looks = 0;
    QObject::connect(page.findChild<ThermalBoardWatch*>(), &ThermalBoardWatch::looked, &page,
                     [&looks] { ++looks; });
    for (const std::string& path : test::chessboardViews()) {
        const GreyPicture photo = test::greyOf(path);
        ThermalView view;
        auto picture = std::make_shared<ThermalPicture>();
        picture->width = photo.width;
        picture->height = photo.height;
        for (const std::uint8_t value : photo.values)
            picture->T_K.push_back(300.0 + 0.02 * (255 - value));
        view.picture = picture;
        for (int k = 0; k < 4; ++k) { // the board stands still
            const int before = looks;
            view.time_s = time_s += 0.2;
            page.setThermalView(view);
            ASSERT_TRUE(test::waitFor([&] { return looks > before; }));
        }
        last = view;
    }
    EXPECT_GE(list->topLevelItemCount(), 10);
    lens.findChild<QPushButton*>("solve")->click();
    auto* use = lens.findChild<QPushButton*>("cameraUse");
    ASSERT_TRUE(test::waitFor([&] { return use->isEnabled(); }));
    use->click();
    ASSERT_EQ(calibrations, 1);
    const ThermalCalibration used = thermalCalibration(experiment, true);
    ASSERT_TRUE(used.lens);
    EXPECT_EQ(used.lens->width, 640);
    EXPECT_NEAR(used.lens->fx, 535.0, 10.0); // OpenCV's own for these pictures: 536
    EXPECT_FALSE(used.lensDate.empty());
    EXPECT_FALSE(used.poseUncertainty_m) << "that place was found with another lens";

    experiment.objects[0].target_K += 1.0;
    page.setExperiment(experiment);
    EXPECT_GE(list->topLevelItemCount(), 10);
    RigSpec& rig = experiment.rig.emplace(); // the same kind of camera, but another one
    rig.thermalCamera.emplace().profile = thermalProfile(experiment, true).value();
    std::vector<std::string> lookedAt;
    QObject::connect(page.findChild<ThermalBoardWatch*>(), &ThermalBoardWatch::looked, &page,
                     [&lookedAt](const VisionView& view) { lookedAt.push_back(view.cameraName); });
    last.cameraName = "before";
    last.time_s = time_s += 0.2;
    page.setThermalView(last);
    page.setExperiment(experiment);
    EXPECT_EQ(list->topLevelItemCount(), 0);
    EXPECT_FALSE(use->isEnabled());
    EXPECT_FALSE(lens.findChild<QPushButton*>("cameraSave")->isEnabled());
    EXPECT_EQ(lens.findChild<QLabel*>("cameraVerdict")->text(), "No camera yet");
    last.cameraName = "after";
    ASSERT_TRUE(test::waitFor([&] {
        last.time_s = time_s += 0.2;
        page.setThermalView(last);
        return !lookedAt.empty();
    }));
    EXPECT_EQ(lookedAt.front(), "after") << "a picture of the camera before counts no more";
}

} // namespace bask
