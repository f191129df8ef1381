// The thermal pictures of a run in its replay.

#include "widgets/review/recorded_pictures.h"

#include "engine/experiment/experiment_file.h"
#include "engine/recording/session_file.h"
#include "engine/rig/rig_setup.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "widgets/review/replay_view.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QApplication>
#include <QTabWidget>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr double kObject_K = 330.0;
constexpr int kPictures = 6;

struct RecordedPicturesTest : testing::Test {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/thermal-camera.json").value();
    QTemporaryDir folder;

    static double told_K(int k, std::size_t object) {
        return kObject_K + 0.1 * k + static_cast<double>(object);
    }

    /// Of the robot that moves to one side. Pictures are taken 0.7 s before the samples that read them.
    std::shared_ptr<RecordedSession> recorded(int pictures) {
        const std::string path = folder.filePath("run%1.bask").arg(pictures).toStdString();
        SimulatedThermalCamera camera(*simulatedRigConfig(experiment).thermalCamera);
        auto writer =
            SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced).value();
        for (int k = 0; k < kPictures; ++k) {
            TraceSample sample;
            sample.time_s = k;
            sample.coordinates = experiment.start;
            sample.coordinates[kX] += 0.02 * k;
            Vector6d then = sample.coordinates; // when the picture was taken
            then[kX] -= 0.02 * 0.7;
            ThermalMoment moment;
            moment.time_s = k - 0.7;
            moment.X_RE = poseFromCoordinates(then);
            moment.source_K = {298.15};
            for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
                ObjectSample object;
                object.measured_K = told_K(k, i);
                object.valid = true;
                object.camera = {told_K(k, i), 0.3, 0.5, 40.0};
                sample.objects.push_back(object);
                const FaceSurroundings face{0.9, {}, 298.15};
                moment.objects.push_back({kObject_K, face, face});
            }
            camera.observe(moment);
            ThermalMoment later = moment; // when its frame is there
            later.time_s += 0.2;
            camera.observe(later);
            EXPECT_TRUE(writer->add(sample));
            if (k == 0 || k > pictures)
                continue;
            const ThermalPicture& picture = camera.newest().value()->frame.picture;
            EXPECT_TRUE(writer->add(TraceFrame{k - 0.7, std::make_shared<ThermalPicture>(picture)}));
        }
        EXPECT_TRUE(writer->finish("settled"));
        writer.reset();
        return RecordedSession::open(path).value();
    }
};

} // namespace

// Catches outlines of another moment, and another moment's temperatures.
TEST_F(RecordedPicturesTest, ShowTheObjectsWhereTheyWere) {
    RecordedPictures pictures(recorded(kPictures));
    double before_px = -1.0;
    for (int k = 1; k < kPictures; ++k) {
        const auto view = pictures.at(k - 0.5);
        ASSERT_TRUE(view) << describe(view.error());
        EXPECT_EQ(view->time_s, k - 0.7);
        ASSERT_EQ(view->objects.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const ThermalObjectView& object = view->objects[i];
            EXPECT_EQ(object.T_K, told_K(k, i));
            EXPECT_EQ(object.uncertainty_K, 0.3);
            ASSERT_GT(object.pixels.size(), 9U);
            for (const int pixel : object.pixels) // the object, not what is behind it
                EXPECT_GT(view->picture->T_K[static_cast<std::size_t>(pixel)], 320.0);
        }
        double middle_px = 0.0;
        for (const Eigen::Vector2d& point : view->objects[0].outline_px)
            middle_px += point.x() / static_cast<double>(view->objects[0].outline_px.size());
        EXPECT_GT(middle_px, before_px + 2.0);
        before_px = middle_px;
    }
}

TEST_F(RecordedPicturesTest, AreATabOfTheReplayWhereThereAreSome) {
    ReplayView replay;
    replay.resize(900, 700);
    replay.show();
    auto* tabs = replay.findChild<QTabWidget*>("reviewTabs");
    auto* picture = replay.findChild<ThermalPictureView*>("reviewPicture");
    replay.setRun(recorded(0));
    EXPECT_EQ(tabs->indexOf(picture), -1);
    replay.setRun(recorded(kPictures));
    ASSERT_GE(tabs->indexOf(picture), 0);
    tabs->setCurrentWidget(picture);
    replay.seek(3.4);
    QApplication::processEvents();
    EXPECT_TRUE(picture->isVisible());
    EXPECT_EQ(picture->sentence(), QString());
    EXPECT_TRUE(picture->statusText().contains("0:03")) << picture->statusText().toStdString();
    replay.seek(0.0);
    EXPECT_TRUE(picture->statusText().contains("0:00")) << picture->statusText().toStdString();
    replay.setRun(recorded(0));
    EXPECT_EQ(tabs->indexOf(picture), -1);
    replay.clear();
}

} // namespace bask
