#include "app/commands/command_line.h"
#include "engine/base/units.h"
#include "engine/control/rig_geometry.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "tests/engine/exchange/read_image.h"
#include "tests/support/captured_command.h"

#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

namespace bask {
namespace {

using test::numbersIn;
using test::samplesIn;
using test::wordsIn;

const QString kThreeObjects = BASK_EXAMPLES "/three-objects.json";

test::Captured run(const QStringList& arguments) {
    return test::captured(isosurfaceCommand, arguments);
}

class IsosurfaceCommand : public testing::Test {
protected:
    QString path(const char* name = "surface.vtp") const { return m_folder.filePath(name); }
    vtkSmartPointer<vtkPolyData> surface(const QStringList& arguments) {
        const test::Captured outcome =
            run(QStringList{kThreeObjects} + arguments + QStringList{"-o", path()});
        EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        vtkNew<vtkXMLPolyDataReader> reader;
        reader->SetFileName(qPrintable(path()));
        reader->Update();
        return reader->GetOutput();
    }

private:
    QTemporaryDir m_folder;
};

/// Largest error of the view factor that the file says its points have, against the controllers' solver.
double worst(vtkPolyData* data, int object) {
    const auto experiment = readExperiment(kThreeObjects.toStdString());
    EXPECT_TRUE(experiment);
    std::vector<Shape> shapes;
    std::vector<Vector6d> mountings;
    for (const ObjectSpec& spec : experiment->objects) {
        shapes.push_back(spec.shape);
        mountings.push_back(spec.mounting);
    }
    const RigGeometry rig(experiment->source.shape, shapes, mountings, experiment->robot,
                          poseFromCoordinates(experiment->source.pose));
    const std::vector<double> F = samplesIn(data, "view_factor");
    const auto axes = wordsIn(data, "axis_names");
    const auto fixed = wordsIn(data, "held_names");
    const auto values = numbersIn(data, "held_values");
    const auto coordinate = [](const std::string& name) {
        return std::ranges::find(kCoordinateNames, name) - kCoordinateNames.begin();
    };
    double error = 0.0;
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += 1 + data->GetNumberOfPoints() / 200) {
        Vector6d q;
        for (std::size_t k = 0; k < 3; ++k) {
            q[coordinate(axes[k])] = data->GetPoint(i)[k];
            q[coordinate(fixed[k])] = values[k];
        }
        if (q[kZ] > 0.06) // steep near the source's edge
            error = std::max(error, std::abs(rig.viewFactors(q).F[object] - F[static_cast<std::size_t>(i)]));
    }
    return error;
}

// Catches: another object, its own centre instead of the end-effector's coordinates, radians for degrees.
TEST_F(IsosurfaceCommand, theSurfaceIsTheEndEffectorsInTheGivenPose) {
    const auto bunny = surface({"--object", "bunny", "--value", "F=0.3", "--held", "theta_x=10,theta_z=-20"});
    EXPECT_GT(bunny->GetNumberOfPolys(), 1000);
    EXPECT_LT(worst(bunny, 1), 5e-3);
    EXPECT_EQ(wordsIn(bunny, "held_names"), (std::vector<std::string>{"theta_x", "theta_y", "theta_z"}));
    const std::vector<double> fixed = numbersIn(bunny, "held_values");
    EXPECT_NEAR(fixed[0], radFromDeg(10.0), 1e-15);
    EXPECT_NEAR(fixed[2], radFromDeg(-20.0), 1e-15);
    EXPECT_EQ(
        wordsIn(bunny, "title").front(),
        "end-effector where object \"bunny\" has the view factors over the source of three-objects.json");

    const auto turned =
        surface({"--object", "circle", "--value", "F=0.3", "--subset", "rotation", "--held", "x=2,z=10"});
    EXPECT_EQ(wordsIn(turned, "axis_names"), (std::vector<std::string>{"theta_x", "theta_y", "theta_z"}));
    EXPECT_NEAR(numbersIn(turned, "held_values")[0], 0.02, 1e-15);
    EXPECT_LT(worst(turned, 0), 2e-2);
}

// Catches: temperatures by another formula than the heat balance's; Kelvin for Celsius; the source model
// passed over. 0.12, 0.37 and 0.65 at 25 C are the paper's.
TEST_F(IsosurfaceCommand, temperaturesBecomeTheViewFactorsOfTheModel) {
    const auto data = surface({"--object", "circle", "--source-model", "paper", "--value", "T=30", "--value",
                               "T=40", "--value", "T=50"});
    const std::vector<double> F = numbersIn(data, "values");
    ASSERT_EQ(F.size(), 3u);
    const std::array<double, 3> known{0.1175, 0.3705, 0.6488};
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(F[i], known[i], 1e-4);
    EXPECT_NEAR(samplesIn(data, "steady_temperature_K").front(), 303.15, 1e-9);
    EXPECT_NEAR(samplesIn(data, "steady_temperature_K").back(), 323.15, 1e-9);
}

// Catches: nothing, or another object's target, where no value is given.
TEST_F(IsosurfaceCommand, withoutAValueItIsTheTarget) {
    const auto experiment = readExperiment(kThreeObjects.toStdString());
    ASSERT_TRUE(experiment);
    const auto data = surface({"--object", "hand"});
    EXPECT_NEAR(samplesIn(data, "steady_temperature_K").front(), experiment->objects[2].target_K, 1e-6);
}

// Catches: a step that is not the grid's.
TEST_F(IsosurfaceCommand, theStepIsInCentimetres) {
    const auto coarse = surface({"--object", "circle", "--value", "F=0.3", "--step", "2"});
    EXPECT_NEAR(numbersIn(coarse, "axis_step")[0], 0.02, 1e-12);
    EXPECT_EQ(numbersIn(coarse, "axis_count")[0], 21);
}

// Catches: a surface that is nowhere answered as if it were there, or an empty file for it.
TEST_F(IsosurfaceCommand, aValueThatIsNowhereIsANegativeVerdict) {
    const test::Captured outcome =
        run({kThreeObjects, "--object", "circle", "--value", "F=0.999", "-o", path()});
    EXPECT_EQ(outcome.code, kExitNegative);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("is nowhere on the grid, where F goes from 0"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(QFile::exists(path()));
    const test::Captured one =
        run({kThreeObjects, "--object", "circle", "--value", "F=0.999", "--value", "F=0.5"});
    EXPECT_EQ(one.code, kExitDone);
    EXPECT_TRUE(one.out.starts_with("F = 0.5 (")) << one.out;
}

// Catches: bad input answered, or refused without saying what and where.
TEST_F(IsosurfaceCommand, refusesBadInputInWords) {
    const auto with = [](const QStringList& more) {
        return QStringList{kThreeObjects, "--object", "circle"} + more;
    };
    const std::pair<QStringList, const char*> bad[] = {
        {{}, "1 argument expected, 0 given"},
        {{"/no/such.json"}, "/no/such.json: there is no such file"},
        {{kThreeObjects}, "--object: one of circle, bunny, hand expected, nothing found"},
        {{kThreeObjects, "--object", "cat"}, "--object: \"cat\" is not known; known: circle, bunny"},
        {with({"--value", "0.3"}), "--value: F=0.3 or T=50 (degrees Celsius) expected, \"0.3\" found"},
        {with({"--value", "F=much"}), "--value F=much: a finite number expected, \"much\" found"},
        {with({"--value", "F=nan"}), "a finite number expected, \"nan\" found"},
        {with({"--value", "F=1.01"}), "--value F=1.01: 1.01 is out of range; allowed: 0 to 1"},
        {with({"--value", "T=20"}), "--value T=20: 20 is out of range; allowed: 25 to 95"},
        {with({"--value", "T=200"}), "degC"},
        {with({"--held", "x=1"}), "--held: \"x\" is an axis and cannot be held as well"},
        {with({"--held", "w=1"}), "--held: \"w\" is not known"},
        {with({"--held", "theta_x=1,theta_x=2"}), "--held: the key \"theta_x\" is given twice"},
        {with({"--subset", "rotation", "--held", "theta_x=1"}), "--held: \"theta_x\" is an axis"},
        {with({"--subset", "both"}), "--subset: \"both\" is not known; known: translation, rotation"},
        {with({"--step", "0"}), "--step: 0 is out of range; allowed: 0.01 to 90 cm"},
        {with({"--step", "fine"}), "--step: a finite number expected, \"fine\" found"},
        {with({"--step", "0.01"}), "samples, more than the 100000000"},
        {with({"--source-model", "black"}), "--source-model: \"black\" is not known; known: gray, paper"},
        {with({"-o", path("surface.vti")}), "surface.vti: \".vti\" is not known; known: .vtp"},
        {with({"-o", path("no/folder.vtp")}), "there is no folder"},
        {with({"--frobnicate"}), "frobnicate"},
    };
    for (const auto& [arguments, words] : bad) {
        const test::Captured outcome = run(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_EQ(outcome.out, "") << arguments.join(' ').toStdString();
        EXPECT_TRUE(outcome.err.starts_with("bask isosurface: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
    }
}

// Catches: the user's file lost to a surface.
TEST_F(IsosurfaceCommand, replacesNothingButSurfaces) {
    QFile mine(path("mine.vtp"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
    mine.close();
    const test::Captured refused = run({kThreeObjects, "--object", "circle", "-o", path("mine.vtp")});
    EXPECT_EQ(refused.code, kExitBadInput);
    EXPECT_NE(refused.err.find("is not a surface file written by Bask"), std::string::npos) << refused.err;
    EXPECT_EQ(mine.size(), 4);
}

TEST_F(IsosurfaceCommand, helps) {
    const test::Captured outcome = run({"--help"});
    EXPECT_EQ(outcome.code, kExitDone);
    for (const char* words :
         {"bask isosurface [options] EXPERIMENT.json", "--value", "--held", "Exit code 3"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
}

} // namespace
} // namespace bask
