#include "app/commands/command_line.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/radiation/mounted_objects.h"
#include "tests/engine/exchange/read_image.h"
#include "tests/support/captured_command.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <regex>

namespace bask {
namespace {

using test::numbersIn;
using test::readImage;
using test::samplesIn;
using test::wordsIn;

const QString kThreeObjects = BASK_EXAMPLES "/three-objects.json";

test::Captured run(const QStringList& arguments) {
    return test::captured(fieldCommand, arguments);
}

std::string lastLine(const std::string& text) {
    EXPECT_TRUE(text.ends_with('\n')) << text;
    const std::string body = text.substr(0, text.size() - 1);
    return body.substr(body.rfind('\n') + 1);
}

class FieldCommand : public testing::Test {
protected:
    QString path(const char* name = "field.vti") const { return m_folder.filePath(name); }
    vtkSmartPointer<vtkImageData> image(const QStringList& arguments) {
        const test::Captured outcome = run(arguments + QStringList{"-o", path()});
        EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return readImage(path().toStdString());
    }

private:
    QTemporaryDir m_folder;
};

// Catches: a last line that a script cannot read, figures among the messages, a wrong count.
TEST_F(FieldCommand, lastLineIsSamplesSecondsAndRate) {
    const std::regex form(R"((\d+) samples, (\d+|\d*\.\d+) s, (\d\.\de-?\d+) samples/s)");
    const std::pair<const char*, const char*> presets[] = {{"paper-translation", "48000"},
                                                           {"paper-rotation", "729000"}};
    for (const auto& [preset, count] : presets) {
        const test::Captured outcome = run({"--preset", preset, "--tolerance", "1e-6"});
        EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const std::string line = lastLine(outcome.out);
        std::smatch parts;
        ASSERT_TRUE(std::regex_match(line, parts, form)) << line;
        EXPECT_EQ(parts[1], count);
        const double time_s = std::stod(parts[2]);
        const double rate = std::stod(parts[3]);
        EXPECT_NEAR(rate * time_s, std::stod(count), 0.12 * std::stod(count)) << "both to two digits";
    }
}

// Catches: a preset on another grid, with other shapes or held somewhere else than in the paper.
TEST_F(FieldCommand, presetsAreThePapersSubsets) {
    const auto translation = image({"--preset", "paper-translation"});
    EXPECT_EQ(numbersIn(translation, "axis_count"), (std::vector<double>{40, 40, 30}));
    EXPECT_EQ(numbersIn(translation, "axis_first"), (std::vector<double>{-0.2, -0.2, 0.01}));
    EXPECT_EQ(numbersIn(translation, "held_values"), (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(numbersIn(translation, "tolerance"), std::vector<double>{1e-9});
    // Coaxial disks in closed form, at (0, 0, 5) cm.
    const double r1 = 0.10 / 0.05;
    const double r2 = 0.015 / 0.05;
    const double s = 1.0 + (1.0 + r1 * r1) / (r2 * r2);
    const double coaxial = 0.5 * (s - std::sqrt(s * s - 4.0 * std::pow(r1 / r2, 2)));
    EXPECT_NEAR(translation->GetScalarComponentAsDouble(20, 20, 4, 0), coaxial, 1e-9);

    const auto rotation = image({"--preset", "paper-rotation"});
    EXPECT_EQ(wordsIn(rotation, "axis_names"), (std::vector<std::string>{"theta_x", "theta_y", "theta_z"}));
    EXPECT_EQ(numbersIn(rotation, "axis_count"), (std::vector<double>{90, 90, 90}));
    EXPECT_EQ(numbersIn(rotation, "held_values"), (std::vector<double>{0, 0, 0.05}));
    const double step = rotation->GetSpacing()[0];
    EXPECT_NEAR(rotation->GetOrigin()[0] + 89 * step, 88.0 * step / 2.0, 1e-12);
    EXPECT_NEAR(rotation->GetScalarComponentAsDouble(45, 45, 0, 0), coaxial, 1e-9);

    const auto fixed = image({"--preset", "paper-translation", "--hold", "theta_x=0.5,theta_z=-1"});
    EXPECT_EQ(numbersIn(fixed, "held_values"), (std::vector<double>{0.5, 0, -1}));
}

// Catches: an inclusive last value lost to rounding, or one too many.
TEST_F(FieldCommand, axesIncludeTheirLastValue) {
    const std::pair<const char*, double> axes[] = {{"x=-0.2:0.2:0.01", 41},  {"z=0.01:0.3:0.01", 30},
                                                   {"z=0.1:0.35:0.1", 3},    {"y=0.1:0.1:1", 1},
                                                   {"theta_x=0:0.3:0.1", 4}, {" x = 0 : 1 : 0.25 ", 5}};
    for (const auto& [axis, count] : axes)
        EXPECT_EQ(numbersIn(image({kThreeObjects, "--object", "circle", "--axes", axis, "--hold",
                                   axis[0] == 'z' ? "x=0" : "z=0.1"}),
                            "axis_count"),
                  std::vector<double>{count})
            << axis;
}

// Catches: a temperature by another formula than the model's, or of another object's material.
TEST_F(FieldCommand, temperaturesFollowTheHeatBalance) {
    const auto experiment = readExperiment(kThreeObjects.toStdString());
    ASSERT_TRUE(experiment);
    const QStringList common{kThreeObjects, "--object", "bunny", "--axes",
                             "x=-0.1:0.1:0.05,z=0.02:0.1:0.02,theta_x=-0.5:0.5:0.5"};
    const std::vector<double> F = samplesIn(image(common), "view_factor");
    const std::vector<double> T =
        samplesIn(image(common + QStringList{"--quantity", "T"}), "steady_temperature_K");
    ASSERT_EQ(F.size(), 75u);
    ASSERT_EQ(T.size(), 75u);
    const auto object = std::ranges::find(experiment->objects, std::string("bunny"), &ObjectSpec::name);
    const double T1 = experiment->source.temperature_K;
    const double T3 = experiment->environment_K;
    const Material& m = object->material;
    ASSERT_EQ(experiment->source.model, SourceModel::Gray);
    for (std::size_t i = 0; i < F.size(); ++i) {
        const double received = experiment->source.emittance * (std::pow(T1, 4) - std::pow(T3, 4)) * F[i];
        EXPECT_NEAR(T[i], std::pow(m.absorptance / m.emittance * (received + std::pow(T3, 4)), 0.25), 1e-9);
    }
    EXPECT_EQ(wordsIn(readImage(path().toStdString()), "title").front(),
              "object \"bunny\" over the source of three-objects.json");
}

TEST_F(FieldCommand, gradientsAndAFourthAxisAreWritten) {
    const auto written = image({kThreeObjects, "--object", "hand", "--gradient", "--axes",
                                "x=0:0.1:0.05,y=0:0.1:0.05,z=0.05:0.1:0.05,theta_z=0:1:0.5"});
    EXPECT_EQ(written->GetPointData()->GetNumberOfArrays(), 6);
    EXPECT_EQ(samplesIn(written, "view_factor at theta_z=0.5 rad").size(), 18u);
    EXPECT_EQ(samplesIn(written, "view_factor_gradient at theta_z=1 rad").size(), 6u * 18u);
}

// Catches: an experiment's source or object passed over by a preset.
TEST_F(FieldCommand, aPresetTakesTheExperimentsObject) {
    const auto circle = samplesIn(
        image({kThreeObjects, "--object", "circle", "--preset", "paper-translation"}), "view_factor");
    EXPECT_EQ(circle, samplesIn(image({"--preset", "paper-translation"}), "view_factor"))
        << "the example's circle and source are the paper's";
    EXPECT_NE(circle, samplesIn(image({kThreeObjects, "--object", "bunny", "--preset", "paper-translation"}),
                                "view_factor"));
}

// Catches: the only object asked for by name.
TEST_F(FieldCommand, theOnlyObjectNeedsNoName) {
    auto experiment = readExperiment(kThreeObjects.toStdString());
    ASSERT_TRUE(experiment);
    experiment->objects.resize(1);
    const QString file = path("one.json");
    ASSERT_TRUE(writeExperiment(*experiment, file.toStdString()));
    EXPECT_EQ(run({file, "--axes", "z=0.01:0.3:0.01"}).code, kExitDone);
    EXPECT_EQ(run({file, "--axes", "z=0.01:0.3:0.01", "--quantity", "T"}).code, kExitDone);
}

// Catches: overlapping samples passed over in silence.
TEST_F(FieldCommand, samplesWithoutAValueAreSaid) {
    const test::Captured outcome =
        run({kThreeObjects, "--object", "circle", "--axes", "x=0:0.05:0.05,z=0:0.1:0.1", "-o", path()});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_NE(outcome.err.find("2 of 4 samples have no value (NaN)"), std::string::npos) << outcome.err;
    EXPECT_EQ(numbersIn(readImage(path().toStdString()), "undefined_samples"), std::vector<double>{2});
}

// Catches: bad input answered, or refused without saying what and where.
TEST_F(FieldCommand, refusesBadInputInWords) {
    const auto axes = [](const char* text) {
        return QStringList{kThreeObjects, "--object", "circle", "--axes", text};
    };
    const auto hold = [&](const char* text) { return axes("x=0:1:0.1") + QStringList{"--hold", text}; };
    const QStringList preset{"--preset", "paper-translation"};
    const std::pair<QStringList, const char*> bad[] = {
        {axes("w=0:1:0.1"), "--axes: \"w\" is not known; known: x, y, z, theta_x"},
        {axes("x"), "--axes: an axis such as x=-0.2:0.2:0.01 (first:last:step) expected, \"x\" found"},
        {axes("x=0:1"), "(first:last:step) expected, \"x=0:1\" found"},
        {axes("x=0:1:2:3"), "\"x=0:1:2:3\" found"},
        {axes(""), "\"\" found"},
        {axes("x=0:1:0.1,"), "\"\" found"},
        {axes("x=zero:1:0.1"), "--axes: x: first: a finite number expected, \"zero\" found"},
        {axes("x=0:nan:0.1"), "--axes: x: last: a finite number expected, \"nan\" found"},
        {axes("x=0:1:inf"), "--axes: x: step: a finite number expected, \"inf\" found"},
        {axes("x=0:1:0"), "--axes: x: step: 0 is not allowed; it must be greater than zero"},
        {axes("x=1:0:-0.1"), "--axes: x: step: -0.1 is not allowed"},
        {axes("theta_y=1:0:0.1"), "--axes: theta_y: first:last: the lower limit 1 must be less"},
        {axes("x=0:1:0.1,y=0:1:0.1,x=0:1:0.1"), "--axes: the axis \"x\" is given twice"},
        {axes("x=0:1:1e-300"), "samples, more than the 100000"},
        {axes("x=0:1e300:1e-300"), "samples, more than the 100000"},
        {axes("x=0:1:1e-3,y=0:1:1e-3,z=0:1:1e-3") + QStringList{"-o", path()},
         "(an .h5 holds more): 1003003001 samples, more than the 100000000"},
        {axes("x=0:1:1e-4,y=0:1:1e-4,z=0:1:1e-3"), "axes: 100120021001 samples, more than the 50000000000"},
        {axes("x=0:1:1,y=0:1:1,z=0:1:1,theta_x=0:1:1,theta_y=0:1:1") + QStringList{"-o", path()},
         "5 is out of range; allowed: 1 to 4 axes of a .vti (an .h5 has up to six)"},
        {axes("x=1e7:1e7:1"), "axes: x: first: 10000000 is out of range"},
        {hold("w=0"), "--hold: \"w\" is not known"},
        {hold("y"), "--hold: a coordinate such as theta_x=0.1 expected, \"y\" found"},
        {hold("x=0.1"), "--hold: \"x\" is an axis and cannot be held as well"},
        {hold("y=0,y=1"), "--hold: the key \"y\" is given twice"},
        {hold("y=nan"), "--hold: y: a finite number expected, \"nan\" found"},
        {hold("y=1e9"), "held: y: 1000000000 is out of range"},
        {axes("x=0:1:0.1") + QStringList{"--tolerance", "small"},
         "--tolerance: a number expected, \"small\""},
        {axes("x=0:1:0.1") + QStringList{"--tolerance", "0"}, "tolerance: 0 is out of range"},
        {axes("x=0:1:0.1") + QStringList{"--tolerance", "nan"}, "tolerance: nan is out of range"},
        {axes("x=0:1:0.1") + QStringList{"--quantity", "Q"}, "--quantity: \"Q\" is not known; known: F, T"},
        {axes("x=0:1:0.1") + preset, "\"--axes\" and \"--preset\""},
        {{"--preset", "paper"}, "--preset: \"paper\" is not known; known: paper-translation, paper-rotation"},
        {preset + QStringList{"--quantity", "T"}, "--quantity T: an experiment with an object"},
        {QStringList{kThreeObjects, "--quantity", "T"} + preset,
         "--quantity T: an experiment with an object"},
        {preset + QStringList{"--object", "circle"}, "EXPERIMENT.json: an experiment"},
        {{"--axes", "x=0:1:0.1"}, "EXPERIMENT.json: an experiment"},
        {{kThreeObjects, "--axes", "x=0:1:0.1"}, "--object: one of circle, bunny, hand expected, nothing"},
        {{kThreeObjects, "--object", "cat", "--axes", "x=0:1:0.1"},
         "\"cat\" is not known; known: circle, bunny"},
        {{kThreeObjects, "--object", "circle"}, "--axes: axes such as x=-0.2:0.2:0.01"},
        {{"/no/such.json", "--axes", "x=0:1:0.1"}, "/no/such.json: there is no such file"},
        {{kThreeObjects, "second.json"}, "1 argument expected, 2 given"},
        {{"--frobnicate"}, "frobnicate"},
        {preset + QStringList{"-o", path("field.csv")}, "field.csv: \".csv\" is not known; known: .vti"},
        {preset + QStringList{"-o", ""}, "the name is empty"},
        {preset + QStringList{"-o", path("no/folder.vti")}, "there is no folder"},
        {axes("x=0:1:1,y=0:1:1,z=0:1:1,theta_x=0:1.5:0.001") + QStringList{"-o", path()},
         "theta_x: 1501 samples, more than the 1000"},
    };
    for (const auto& [arguments, words] : bad) {
        const test::Captured outcome = run(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_EQ(outcome.out, "") << arguments.join(' ').toStdString();
        EXPECT_TRUE(outcome.err.starts_with("bask field: ")) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
    }
    EXPECT_FALSE(QFile::exists(path()));
}

// Catches: the user's file, or the experiment, lost to the field.
TEST_F(FieldCommand, replacesNothingButFields) {
    const QStringList arguments{"--preset", "paper-translation", "-o", path("mine.vti")};
    QFile mine(path("mine.vti"));
    ASSERT_TRUE(mine.open(QIODevice::WriteOnly) && mine.write("mine") == 4);
    mine.close();
    const test::Captured refused = run(arguments);
    EXPECT_EQ(refused.code, kExitBadInput);
    EXPECT_EQ(refused.out, "") << "refused before the work";
    EXPECT_NE(refused.err.find("is not a field written by Bask"), std::string::npos) << refused.err;
    EXPECT_EQ(mine.size(), 4);
    ASSERT_TRUE(mine.remove());
    EXPECT_EQ(run(arguments).code, kExitDone);
    EXPECT_EQ(run(arguments).code, kExitDone) << "its own are replaced";
}

TEST_F(FieldCommand, helps) {
    const test::Captured outcome = run({"--help"});
    EXPECT_EQ(outcome.code, kExitDone);
    for (const char* words : {"bask field [options] [EXPERIMENT.json]", "--axes", "--preset", "--gradient"})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
}

// Catches: the other objects of the experiment not in the light of the one, or where they are not mounted.
TEST_F(FieldCommand, theOtherObjectsShadeUnlessTheyShallNot) {
    auto experiment = readExperiment(kThreeObjects.toStdString());
    ASSERT_TRUE(experiment);
    experiment->objects[1].shape = Disk{0.02};
    experiment->objects[1].mounting = experiment->objects[0].mounting; // in front of the circle
    experiment->objects[1].mounting[kZ] -= 0.03;
    ASSERT_TRUE(writeExperiment(*experiment, path("stacked.json").toStdString()));
    const auto valueOf = [&](const char* shade, bool told) {
        const test::Captured outcome = run({path("stacked.json"), "--object", "circle", "--axes",
                                            "z=0.1:0.1:0.01", "--shade", shade, "-o", path()});
        EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
        EXPECT_EQ(outcome.err.find("the shade of the other objects is rough") != std::string::npos, told);
        const auto data = readImage(path().toStdString());
        EXPECT_EQ(data->GetFieldData()->HasArray("rough_shade"), told ? 1 : 0);
        return data->GetScalarComponentAsDouble(0, 0, 0, 0);
    };
    const double none = valueOf("none", false), exact = valueOf("exact", false),
                 rough = valueOf("rough", true);
    const RadiatingContour source(experiment->source.shape), circle(experiment->objects[0].shape);
    const MountedObjects held({{circle, Pose::Identity()},
                               {RadiatingContour(Disk{0.02}), Pose(Eigen::Translation3d(0.0, 0.0, -0.03))}});
    const Pose above(Eigen::Translation3d(0.0, 0.0, 0.1));
    EXPECT_NEAR(none, viewFactorValue(source, circle, above), 1e-8);
    EXPECT_NEAR(exact, held.viewFactorValue(source, 0, above, 1e-6), 3e-5);
    EXPECT_LT(exact, 0.8 * none);
    EXPECT_NEAR(rough, exact, 0.03 * (none - exact));
    const test::Captured refused =
        run({path("stacked.json"), "--object", "circle", "--axes", "z=0.1:0.1:0.01", "--shade", "some"});
    EXPECT_EQ(refused.code, kExitBadInput);
}

} // namespace
} // namespace bask
