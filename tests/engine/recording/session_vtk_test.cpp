// A run as VTK files, read back as ParaView does.

#include "engine/recording/session_vtk.h"

#include "engine/base/message_code.h"
#include "engine/model/experiment_rig.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/told_shares.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>

namespace bask {
namespace {

using test::madeUpSample;

SessionRecord recordOf(int samples) {
    SessionRecord session;
    session.path = "run.bask";
    session.experiment = test::twoDisks();
    const Contour hole{{{0.002, 0.0}, {0.0, 0.002}, {-0.002, 0.0}, {0.0, -0.002}}};
    session.experiment.objects[1].shape = withHoles(Disk{0.015}, {hole});
    RobotLimits& robot = session.experiment.robot;
    robot.lower.head<3>() << -0.05, -0.05, 0.05; // few samples of the fields
    robot.upper.head<3>() << 0.05, 0.05, 0.10;
    session.experiment.start[kZ] = 0.08;
    session.simulated = true;
    session.outcome = "settled";
    for (int k = 0; k < samples; ++k) {
        session.samples.push_back(madeUpSample(session.experiment, k));
        session.samples.back().source.setZero();
        session.samples.back().coordinates << 0.001 * k, 0.0, 0.08, 0.0, 0.0, 0.01 * k;
    }
    return session;
}

class SessionVtk : public ::testing::Test {
protected:
    std::vector<std::string> exported(const SessionRecord& session) const {
        const auto files = exportVtk(session, m_folder.path().toStdString());
        if (!files) {
            ADD_FAILURE() << describe(files.error());
            return {};
        }
        return *files;
    }
    vtkSmartPointer<vtkPolyData> poly(const char* name) const {
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(m_folder.filePath(name).toUtf8().constData());
        reader->Update();
        return reader->GetOutput();
    }
    vtkSmartPointer<vtkImageData> image(const char* name) const {
        vtkNew<vtkXMLImageDataReader> reader;
        reader->SetFileName(m_folder.filePath(name).toUtf8().constData());
        reader->Update();
        return reader->GetOutput();
    }

    QTemporaryDir m_folder;
};

TEST_F(SessionVtk, TrajectoriesHaveTheSamplesNumbers) {
    const SessionRecord session = recordOf(25);
    exported(session);
    const auto ways = poly("trajectories.vtp");
    ASSERT_EQ(ways->GetNumberOfPoints(), 50);
    ASSERT_EQ(ways->GetNumberOfLines(), 2);
    EXPECT_EQ(ways->GetCellData()->GetArray("object")->GetTuple1(1), 2.0);
    EXPECT_STREQ(ways->GetPointData()->GetScalars()->GetName(), "measured_K");
    for (int k = 0; k < 25; ++k) {
        const TraceSample& sample = session.samples[static_cast<std::size_t>(k)];
        const Eigen::Vector3d centre =
            poseFromCoordinates(sample.coordinates) * Eigen::Vector3d(0.04, 0.0, 0.0);
        double point[3];
        ways->GetPoint(25 + k, point);
        EXPECT_NEAR((Eigen::Vector3d(point[0], point[1], point[2]) - centre).norm(), 0.0, 1e-15);
        const auto value = [&](const char* name) {
            return ways->GetPointData()->GetArray(name)->GetTuple1(25 + k);
        };
        EXPECT_EQ(value("measured_K"), sample.objects[1].measured_K);
        EXPECT_EQ(value("true_K"), sample.objects[1].true_K);
        EXPECT_EQ(value("error_K"), sample.objects[1].measured_K - sample.objects[1].target_K)
            << "as in traces.csv";
        EXPECT_EQ(value("view_factor"), sample.objects[1].viewFactor);
        EXPECT_EQ(value("time_s"), sample.time_s);
        EXPECT_EQ(std::isnan(value("estimated_K")), k < 10);
    }
    const auto effector = poly("end_effector.vtp");
    ASSERT_EQ(effector->GetNumberOfPoints(), 25);
    EXPECT_EQ(effector->GetPointData()->GetArray("velocity_m_s")->GetComponent(3, 2), 1.0 / 3.0);
}

TEST_F(SessionVtk, OutlinesFollowTheObjectsAndTheCollectionNamesThem) {
    const SessionRecord session = recordOf(25);
    exported(session);
    QFile collection(m_folder.filePath("outlines.pvd"));
    ASSERT_TRUE(collection.open(QIODevice::ReadOnly));
    const QString xml = collection.readAll();
    auto found = QRegularExpression("timestep=\"([^\"]+)\"[^>]*file=\"([^\"]+)\"").globalMatch(xml);
    int steps = 0;
    while (found.hasNext()) {
        const auto match = found.next();
        EXPECT_NEAR(match.captured(1).toDouble(), session.samples[static_cast<std::size_t>(steps)].time_s,
                    1e-9);
        EXPECT_TRUE(QFile::exists(m_folder.filePath(match.captured(2)))) << match.captured(2).toStdString();
        ++steps;
    }
    EXPECT_EQ(steps, 25);
    const auto last = poly("outlines/0024.vtp");
    ASSERT_EQ(last->GetNumberOfLines(), 4) << "source, disk, disk and its hole";
    vtkDataArray* object = last->GetCellData()->GetArray("object");
    EXPECT_EQ(object->GetTuple1(0), 0.0);
    EXPECT_EQ(object->GetTuple1(3), 2.0);
    EXPECT_EQ(last->GetCellData()->GetArray("temperature_K")->GetTuple1(2),
              session.samples[24].objects[1].true_K);
    // Every point of the last object is a radius or less from its centre.
    const Eigen::Vector3d centre =
        poseFromCoordinates(session.samples[24].coordinates) * Eigen::Vector3d(0.04, 0.0, 0.0);
    for (vtkIdType cell = 2; cell < 4; ++cell) {
        vtkNew<vtkIdList> points;
        last->GetCellPoints(cell, points);
        EXPECT_EQ(points->GetId(0), points->GetId(points->GetNumberOfIds() - 1)) << "closed";
        for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k) {
            const Eigen::Vector3d point = Eigen::Map<const Eigen::Vector3d>(last->GetPoint(points->GetId(k)));
            EXPECT_NEAR((point - centre).norm(), cell == 2 ? 0.015 : 0.002, 1e-9);
        }
    }
}

// Catches: a field over the end-effector's positions that claims to be over the object's own.
TEST_F(SessionVtk, FieldsAreOverTheObjectsOwnCentresAtTheLastAngles) {
    const SessionRecord session = recordOf(25);
    const auto files = exported(session);
    const auto factors = image("view_factor_1_left__the.vti");
    const auto steady = image("steady_temperature_1_left__the.vti");
    vtkDataArray* F = factors->GetPointData()->GetArray("view_factor");
    vtkDataArray* T = steady->GetPointData()->GetArray("steady_temperature_K");
    ASSERT_TRUE(F != nullptr && T != nullptr);
    const auto rig = rigGeometry(session.experiment);
    const Vector6d& last = session.samples.back().coordinates;
    const Eigen::Vector3d offset = poseFromCoordinates(last).linear() * Eigen::Vector3d(-0.04, 0.0, 0.0);
    int compared = 0;
    for (vtkIdType k = 0; k < factors->GetNumberOfPoints(); k += 37) {
        if (std::isnan(F->GetTuple1(k)))
            continue;
        Vector6d q = last;
        q.head<3>() = Eigen::Map<const Eigen::Vector3d>(factors->GetPoint(k)) - offset;
        EXPECT_NEAR(F->GetTuple1(k), rig->viewFactors(q).F[0], 1e-5);
        const ObjectSpec& object = session.experiment.objects[0];
        const HeatRates rates =
            heatRates(object.material, surroundingsOf(SourceModel::Gray, 473.15, 0.25, 298.15));
        EXPECT_NEAR(T->GetTuple1(k), rates.steadyTemperature_K(F->GetTuple1(k)), 1e-9);
        ++compared;
    }
    EXPECT_GT(compared, 10);
    EXPECT_EQ(files.size(), 2u + 25u + 1u + 4u + 1u);
}

TEST_F(SessionVtk, AnEmptyRunHasOutlinesAtItsStartAndFields) {
    exported(recordOf(0));
    EXPECT_FALSE(QFile::exists(m_folder.filePath("trajectories.vtp")));
    EXPECT_EQ(poly("outlines/0000.vtp")->GetNumberOfLines(), 4);
    EXPECT_TRUE(QFile::exists(m_folder.filePath("outlines.pvd")));
}

TEST_F(SessionVtk, LongRunsAreThinnedForTheOutlinesOnly) {
    exported(recordOf(1001));
    EXPECT_EQ(poly("trajectories.vtp")->GetNumberOfPoints(), 2002);
    EXPECT_EQ(QDir(m_folder.filePath("outlines")).entryList(QDir::Files).size(), kMaxOutlineSteps);
    EXPECT_NEAR(poly("outlines/0199.vtp")->GetPoint(0)[0], 0.1, 1e-9) << "source";
}

TEST_F(SessionVtk, TellsHowFarItIs) {
    test::ToldShares shares;
    ASSERT_TRUE(exportVtk(recordOf(25), m_folder.path().toStdString(), {}, shares.told()));
    shares.expectAWhole(25);
}

TEST_F(SessionVtk, NothingIsWrittenWhereAnothersFileIsInTheWay) {
    QFile mine(m_folder.filePath("outlines.pvd"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("<VTKFile type=\"Collection\"/>") > 0);
    mine.close();
    const auto refused = exportVtk(recordOf(5), m_folder.path().toStdString());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::OutputForeign);
    EXPECT_EQ(QDir(m_folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
              QStringList{"outlines.pvd"});
    ASSERT_TRUE(mine.remove());
    exported(recordOf(5));
    exported(recordOf(5));
}

TEST_F(SessionVtk, ACancelledOneLeavesNothing) {
    std::stop_source stop;
    stop.request_stop();
    const auto refused = exportVtk(recordOf(5), m_folder.filePath("new").toStdString(), stop.get_token());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::FieldCancelled);
    EXPECT_FALSE(QDir(m_folder.filePath("new")).exists());
}

} // namespace
} // namespace bask
