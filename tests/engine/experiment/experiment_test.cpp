#include "engine/base/edge_units.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/shape/fourier_contour.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QTemporaryDir>

#include <cmath>
#include <ctime>
#include <filesystem>
#include <numbers>
#include <random>

namespace bask {
namespace {

const std::string kExamples = BASK_EXAMPLES;

Experiment example(const std::string& name) {
    auto read = readExperiment(kExamples + '/' + name);
    if (!read) {
        ADD_FAILURE() << describe(read.error());
        return {};
    }
    return *read;
}

std::vector<std::string> exampleNames() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kExamples)) {
        if (entry.path().extension() == ".json")
            names.push_back(entry.path().filename().string());
    }
    return names;
}

TEST(Examples, AllAreReadAndValid) {
    EXPECT_EQ(exampleNames().size(), 11u);
    for (const std::string& name : exampleNames()) {
        const Experiment e = example(name);
        EXPECT_FALSE(e.objects.empty()) << name;
        EXPECT_TRUE(validate(e)) << name;
    }
}

TEST(Examples, ThreeObjectsAreTheCommonScenario) {
    const Experiment e = example("three-objects.json");
    ASSERT_EQ(e.objects.size(), 3u);
    EXPECT_EQ(e.source, (SourceSpec{Disk{0.1}, 473.15, 0.25, 0.01, SourceModel::Gray}));
    EXPECT_EQ(e.environment_K, 298.15);
    RobotLimits limits;
    limits.maxAcceleration_m_s2 = 0.3; // that of a stepping robot
    EXPECT_EQ(e.robot, limits);
    EXPECT_EQ(e.start, (Experiment{}.start));
    EXPECT_EQ(e.controller.kind, ControllerKind::LevelServo);
    EXPECT_EQ(e.controller.estimatedRateErrorFactor, 4.0);
    EXPECT_EQ(e.simulation.sensorOffset_K, 0.3);
    const std::array<const char*, 3> names{"circle", "bunny", "hand"};
    const std::array capacities{2440.0, 670.0, 1116.0};
    const std::array areas_mm2{M_PI * 225.0, 2851.1, 2299.0}; // of the fits
    for (std::size_t i = 0; i < 3; ++i) {
        const ObjectSpec& object = e.objects[i];
        EXPECT_EQ(object.name, names[i]);
        EXPECT_EQ(object.target_K, 313.15);
        EXPECT_NEAR(object.material.arealHeatCapacity_J_m2K(), capacities[i], 1.0);
        EXPECT_NEAR(shapeArea(object.shape) * 1e6, areas_mm2[i], 0.005 * areas_mm2[i]) << object.name;
        EXPECT_NEAR(object.mounting.head<2>().norm(), 0.05, 2e-4);
    }
    EXPECT_TRUE(std::holds_alternative<Disk>(e.objects[0].shape));
    EXPECT_EQ(std::get<FourierContour>(e.objects[1].shape).harmonics(), 5);
    EXPECT_EQ(std::get<FourierContour>(e.objects[2].shape).harmonics(), 10);
    EXPECT_EQ(e.objects[2].origin.file, "contours/hand_1200.png");
    EXPECT_NEAR(contourArea(e.objects[2].origin.outline) * 1e6, 2327.0, 3.0);
}

// Catches an example to begin with that Bask itself warns of.
TEST(Examples, TheFirstIsSimpleAndKeepsTheArea) {
    const Experiment e = example("three-objects.json");
    for (const ObjectSpec& object : e.objects)
        if (object.origin.harmonics > 0) {
            const FourierFit fit = fitFourier(object.origin.outline, object.origin.harmonics).value();
            EXPECT_FALSE(fit.crossesItself) << object.name;
            EXPECT_LT(std::abs(fit.areaError), 0.05) << object.name;
        }
}

TEST(Examples, AreReadInAFractionOfASecond) {
    const std::clock_t before = std::clock(); // of this process: other work on the machine does not count
    example("three-objects.json");
    EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 2.0);
}

TEST(RoundTrip, EveryExampleIsTheSameAndSelfContained) {
    for (const std::string& name : exampleNames()) {
        const Experiment e = example(name);
        const auto again = experimentFromJson(experimentToJson(e), name, "/nowhere");
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_TRUE(*again == e) << name;
        EXPECT_EQ(experimentToJson(*again), experimentToJson(e)) << name;
    }
}

class RandomExperiment {
public:
    explicit RandomExperiment(unsigned seed) : m_random(seed) {}

    Experiment make() {
        Experiment e;
        e.title = "Caf\u00e9 \"quoted\"\n\u5f00\u59cb";
        e.source = source();
        e.environment_K = real(250, 310);
        e.robot.maxSpeed_m_s = real(0.001, 0.1);
        e.robot.maxAcceleration_m_s2 = real(0.0, 10.0);
        e.robot.maxAngularAcceleration_rad_s2 = real(0.0, 100.0);
        e.robot.maxRotation_rad_s = real(0.01, 1);
        e.robot.clearance_m = real(0, 0.02);
        for (int k = 0; k < 6; ++k) {
            e.start[k] = k == kZ ? real(0.2, 0.3) : real(-0.3, 0.3);
            e.robot.lower[k] = e.start[k] - real(0.01, 0.5);
            e.robot.upper[k] = e.start[k] + real(0.01, 0.5);
            e.robot.free[static_cast<std::size_t>(k)] = k < 3 || real(0, 1) < 0.5;
        }
        for (const char* name : {"a", "b", "c"})
            e.objects.push_back(object(name, static_cast<int>(e.objects.size())));
        e.controller.kind = ControllerKind::Adaptive;
        e.controller.levelServo = {real(1, 20), real(10, 100)};
        e.controller.modelBased = {real(0, 1), real(0.001, 1)};
        e.controller.adaptive = {real(0.01, 1), real(0.01, 1), real(0, 0.1), real(0, 1e-20)};
        e.controller.rotationLength_m = real(0.01, 1);
        e.controller.damping = real(0, 1);
        e.controller.estimatedRateErrorFactor = real(1, 8);
        e.sampling = {real(0.01, 2), 12, 2};
        e.simulation = {m_random(),  real(0, 1),     real(0, 1),    real(0, 1),  real(0, 1),
                        real(0, 10), real(0, 0.001), real(0, 0.01), real(1, 1e5)};
        makeTrue(e);
        return e;
    }

private:
    double real(double min, double max) { return std::uniform_real_distribution(min, max)(m_random); }

    /// What only the simulation knows; half of the experiments leave out what may be left out.
    void makeTrue(Experiment& e) {
        SimulationSpec& s = e.simulation;
        s.sensorLag_s = real(0, 20);
        s.sensorDropout = real(0, 0.5);
        s.robotLatency_s = real(0, 1);
        s.trackingNoise_m = real(0, 0.01);
        s.trackingNoise_rad = real(0, 0.1);
        s.trackingDelay_s = real(0, 2);
        if (real(0, 1) < 0.5)
            return;
        s.sourceEmittance = real(0.5, 1);
        if (std::holds_alternative<Disk>(e.source.shape)) {
            const double radius_m = std::get<Disk>(e.source.shape).radius_m;
            e.source.uneven.profile = {{0.1 * radius_m, real(0.5, 1.7), real(-9, 9)}, {radius_m, real(0, 2)}};
            SourcePartSpec& part = s.sourceUneven.emplace().parts.emplace_back();
            part.shape = Disk{0.3 * radius_m};
            part.pose[kX] = real(-0.5, 0.5) * radius_m;
            part.temperatureOffset_K = real(-9, 9);
        }
        Vector6d there = e.source.pose;
        for (int i = 0; i < 3; ++i) {
            s.sourceMotion.push_back({i + real(0, 1), there});
            there += Vector6d::Constant(real(-0.1, 0.1));
        }
        e.objects[1].simulatedMaterial = {
            "other", real(0.01, 1), real(0.01, 1), real(100, 5000), real(10, 9000), real(1e-5, 0.01), 1.0};
    }

    void shape(int kind, Shape& shape, ContourOrigin& origin) {
        if (kind == 0) {
            shape = Disk{real(0.001, 0.05)};
        } else if (kind == 1) {
            std::vector<std::complex<double>> c{
                {real(-1, 1), real(-1, 1)}, {0, 0}, {30.0 + real(0, 1), real(0, 1)}};
            for (auto& value : c)
                value *= 1e-3;
            shape = FourierContour(c);
            origin = {"dir/file \\ name.csv", polygon(), 1};
            if (m_random() % 2 == 0)
                origin.holes = {triangle(2e-4), triangle(3e-4, 1e-3)};
        } else {
            shape = polygon();
        }
        if (m_random() % 2 == 0)
            shape = withHoles(shape, {triangle(2e-4), triangle(1e-4, 4e-4)});
    }

    Contour triangle(double size, double x = 0.0) {
        return {{{x, real(-size, 0)}, {x + real(0.5, 1) * size, 0}, {x + real(0, 0.1) * size, size}}};
    }

    SourceSpec source() {
        SourceSpec s;
        shape(static_cast<int>(m_random() % 3), s.shape, s.origin);
        s.temperature_K = real(400, 700);
        s.emittance = real(0.5, 1);
        for (int k = 0; k < 6; ++k)
            s.pose[k] = k < 3 ? real(-0.05, 0.05) : real(-0.2, 0.2);
        for (int i = 0; i < static_cast<int>(m_random() % 4); ++i)
            s.temperatureProfile.push_back({10.0 * i + real(0, 10), real(400, 700)});
        s.tracked = m_random() % 2 == 0;
        s.emittanceUncertainty = real(0, 0.1);
        return s;
    }

    ObjectSpec object(const char* name, int kind) {
        ObjectSpec o;
        o.name = name;
        shape(kind, o.shape, o.origin);
        o.material = {"stuff",        real(0.01, 1),    real(0.01, 1), real(100, 5000),
                      real(10, 9000), real(1e-5, 0.01), real(0.01, 1)};
        for (int k = 0; k < 6; ++k)
            o.mounting[k] = k < 3 ? real(-0.05, 0.05) : real(-0.5, 0.5);
        o.target_K = real(290, 400);
        if (kind % 2 == 0)
            o.estimatedRates = HeatRates{real(1e-4, 2), real(1e-13, 1e-10), real(1e-4, 2)};
        return o;
    }

    Contour polygon() {
        std::vector<Eigen::Vector2d> points;
        for (int k = 0; k < 40; ++k) {
            const double angle = 2.0 * M_PI * k / 40.0;
            const double radius = real(0.01, 0.03);
            points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
        }
        return centred(*makeContour(points));
    }

    std::mt19937_64 m_random;
};

TEST(RoundTrip, RandomExperimentsAreExact) {
    int tested = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Experiment e = RandomExperiment(seed).make();
        if (const auto valid = validate(e); !valid) {
            ASSERT_EQ(valid.error().code(), MessageCode::StartTooClose) << describe(valid.error());
            continue; // the tilted source is too near
        }
        ++tested;
        const auto again = experimentFromJson(experimentToJson(e), "", "");
        ASSERT_TRUE(again) << "seed " << seed << ": " << describe(again.error());
        ASSERT_TRUE(*again == e) << "seed " << seed;
    }
    EXPECT_GT(tested, 200);
}

TEST(RoundTrip, ThroughAFile) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath("e.json").toStdString();
    const Experiment e = RandomExperiment(7).make();
    ASSERT_TRUE(writeExperiment(e, path));
    ASSERT_TRUE(writeExperiment(e, path)) << "over an older file";
    EXPECT_TRUE(*readExperiment(path) == e);
}

TEST(RoundTrip, ACoordinateInRadiansOrMetresIsReadToo) {
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    j["objects"][0]["mounting"] = {{"y_m", 0.04}, {"theta_z_rad", 0.5}};
    j["objects"][0]["target_K"] = 320.0;
    j["objects"][0].erase("target_degC");
    const auto read = experimentFromJson(j.dump(), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->objects[0].mounting[kY], 0.04);
    EXPECT_EQ(read->objects[0].mounting[kThetaZ], 0.5);
    EXPECT_EQ(read->objects[0].target_K, 320.0);
}

TEST(WrittenForm, UsesTheNumbersThatPeopleWrite) {
    const std::string text = experimentToJson(example("three-objects.json"));
    for (const char* part : {"\"target_degC\": 40.0", "\"temperature_degC\": 25.0", "\"x_cm\": -4.35",
                             "\"theta_x_deg\": -35.0", "\"thickness_mm\": 1.0", "\"seed\": 1"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(text.find("_rad\": 0.61"), std::string::npos);
}

TEST(Reading, LeavesOutWhatHasDefaults) {
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    for (const char* key : {"title", "robot", "controller", "sampling", "simulation"})
        j.erase(key);
    const auto read = experimentFromJson("\xEF\xBB\xBF" + j.dump(), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->robot, RobotLimits{});
    EXPECT_EQ(read->controller, ControllerSettings{});
    EXPECT_EQ(read->simulation, SimulationSpec{});
}

// Catches air that is lost on its way through a file, a word that is not known, and a number beside the word.
TEST(Reading, TheAirIsANumberOrAWord) {
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    EXPECT_FALSE(j.contains("air"));
    const auto read = [&] { return experimentFromJson(j.dump(), "", ""); };
    EXPECT_FALSE(read()->air.isKnown());
    j["air"] = {{"convection_W_m2K", 8.0}};
    EXPECT_EQ(read()->air, Air{8.0});
    j["air"] = {{"convection", "unknown"}};
    EXPECT_EQ(read()->air, Air{});
    j["air"] = {{"convection", "natural"}};
    j["simulation"]["convection"] = "natural";
    ASSERT_TRUE(read()) << describe(read().error());
    EXPECT_EQ(read()->air, (Air{std::nullopt, true}));
    EXPECT_TRUE(read()->simulation.naturalConvection);
    EXPECT_EQ(experimentFromJson(experimentToJson(*read()), "", "").value(), *read());
    j["air"]["convection_W_m2K"] = 8.0;
    EXPECT_EQ(read().error().where, "air.convection");
    j["air"] = {{"convection", "still"}};
    EXPECT_EQ(read().error().where, "air.convection");
    j["air"] = {{"convection_W_m2K", -1.0}};
    EXPECT_EQ(read().error().where, "air.convection_W_m2K");
    EXPECT_EQ(read().error().message.code, MessageCode::ValueOutOfRange);
    j.erase("air");
    j["simulation"]["convection_W_m2K"] = 8.0;
    EXPECT_EQ(read().error().where, "simulation.convection");
}

// Catches a title that commands a terminal, and one in another script that is refused.
TEST(Reading, ATitleCannotCommandATerminal) {
    auto json = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    json["title"] = "a\x1b[31m\xc2\x9b";
    const auto refused = experimentFromJson(json.dump(), "made up", kExamples);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::NameNotPlain);
    EXPECT_EQ(refused.error().message.args.size(), 0U);
    json["title"] = "b\n\u00e4\u4e2d\u200f";
    const auto read = experimentFromJson(json.dump(), "made up", kExamples);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->title, json["title"].get<std::string>());
}

TEST(Reading, PutsClockwiseAndOffCentreOutlinesRight) {
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    j["objects"][0]["contour"] = {{"type", "polygon"},
                                  {"points_m", {{0.01, 0.01}, {0.01, 0.03}, {0.03, 0.03}, {0.03, 0.01}}}};
    j["objects"][1]["contour"] = {{"type", "fourier"}, {"coefficients", {{0, 0.5, 0.5}, {-1, 0.02, 0.0}}}};
    const auto read = experimentFromJson(j.dump(), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    const auto& square = std::get<Contour>(read->objects[0].shape);
    EXPECT_NEAR(contourArea(square), 4e-4, 1e-12);
    EXPECT_LT(contourCentroid(square).norm(), 1e-12);
    EXPECT_EQ(std::get<FourierContour>(read->objects[1].shape).coefficient(1), 0.02);
    EXPECT_LT(std::abs(std::get<FourierContour>(read->objects[1].shape).coefficient(0)), 1e-12);
}

// Catches a set point that jumps between its moments, begins late or ends early.
TEST(SourceSetPoint, IsLinearBetweenItsMomentsAndConstantOutside) {
    SourceSpec source;
    EXPECT_EQ(sourceSetPoint_K(source, 77.0), source.temperature_K);
    source.temperatureProfile = {{100.0, 473.15}, {1100.0, 573.15}, {1200.0, 373.15}};
    for (const auto& [time_s, value_K] : {std::pair{0.0, 473.15},
                                          {100.0, 473.15},
                                          {350.0, 498.15},
                                          {1100.0, 573.15},
                                          {1150.0, 473.15},
                                          {1e6, 373.15}})
        EXPECT_NEAR(sourceSetPoint_K(source, time_s), value_K, 1e-9) << time_s;
}

// Catches a source read by other rules than objects: left off centre, clockwise, or without its origin.
TEST(Reading, PutsTheSourceRightAsItDoesObjects) {
    auto j = nlohmann::json::parse(experimentToJson(example("three-objects.json")));
    for (const nlohmann::json& contour :
         {nlohmann::json{{"type", "polygon"}, {"points_m", {{0.1, 0.1}, {0.1, 0.3}, {0.5, 0.3}, {0.5, 0.1}}}},
          nlohmann::json{{"type", "fourier"}, {"coefficients", {{0, 0.5, 0.5}, {-1, 0.02, 0.0}}}},
          nlohmann::json{{"type", "disk"}, {"radius_m", 0.02}}, j["objects"][1]["contour"]}) {
        j["source"]["contour"] = j["objects"][0]["contour"] = contour;
        const auto read = experimentFromJson(j.dump(), "", "");
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(read->source.shape, read->objects[0].shape);
        EXPECT_EQ(read->source.origin, read->objects[0].origin);
        const auto written = nlohmann::json::parse(experimentToJson(*read));
        EXPECT_EQ(written["source"]["contour"], written["objects"][0]["contour"]);
        const auto again = experimentFromJson(written.dump(), "", "");
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_TRUE(*again == *read);
    }
    EXPECT_EQ(j["source"]["contour"]["harmonics"], 5);
}

Contour square(double half_m, double x_m, double y_m) {
    return {{{x_m - half_m, y_m - half_m},
             {x_m + half_m, y_m - half_m},
             {x_m + half_m, y_m + half_m},
             {x_m - half_m, y_m + half_m}}};
}

// Catches holes that stay where they were while the outline is moved to its centroid, clockwise ones among
// them, and holes of a disk moved.
TEST(Reading, MovesHolesWithTheirOutline) {
    auto j = nlohmann::json::parse(experimentToJson(example("three-objects.json")));
    const nlohmann::json holes{{{0.11, 0.11}, {0.11, 0.12}, {0.12, 0.12}, {0.12, 0.11}}};
    for (const nlohmann::json& contour :
         {nlohmann::json{{"type", "polygon"},
                         {"points_m", {{0.1, 0.1}, {0.1, 0.14}, {0.14, 0.14}, {0.14, 0.1}}},
                         {"holes_m", holes}},
          nlohmann::json{
              {"type", "fourier"}, {"coefficients", {{0, 0.12, 0.12}, {-1, 0.02, 0.0}}}, {"holes_m", holes}},
          nlohmann::json{{"type", "disk"},
                         {"radius_m", 0.02},
                         {"holes_m", {{{-0.01, -0.01}, {-0.01, 0.0}, {0.0, 0.0}, {0.0, -0.01}}}}}}) {
        j["objects"][0]["contour"] = contour;
        const auto read = experimentFromJson(j.dump(), "", "");
        ASSERT_TRUE(read) << describe(read.error());
        ASSERT_EQ(holesOf(read->objects[0].shape).size(), 1u);
        const Contour& hole = holesOf(read->objects[0].shape)[0];
        EXPECT_LT((contourCentroid(hole) - Eigen::Vector2d(-0.005, -0.005)).norm(), 1e-15);
        EXPECT_GT(contourArea(hole), 0.0);
        const auto again = experimentFromJson(experimentToJson(*read), "", "");
        ASSERT_TRUE(again) << describe(again.error());
        EXPECT_TRUE(*again == *read);
    }
}

// Catches an import that forgets the holes or leaves them behind when outline and fit are centred, and an
// origin that cannot be fitted again.
TEST(Reading, ImportsHolesWithTheOutline) {
    const QTemporaryDir folder;
    QFile svg(folder.filePath("plate.svg"));
    ASSERT_TRUE(svg.open(QIODevice::WriteOnly));
    svg.write("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>"
              "<path d='M10,90 L60,90 L60,70 L30,70 L30,40 L10,40 Z M20,50 h4 v4 h-4 z M50,75 h4 v4 h-4 z'/>"
              "</svg>");
    svg.close();
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    const auto read = [&](int harmonics) {
        j["objects"][0]["contour"] = {{"type", "import"}, {"file", "plate.svg"}, {"harmonics", harmonics}};
        return experimentFromJson(j.dump(), "", folder.path().toStdString());
    };
    const auto exact = read(0);
    ASSERT_TRUE(exact) << describe(exact.error());
    const ObjectSpec& plate = exact->objects[0];
    EXPECT_NEAR(shapeArea(plate.shape) * 1e6, 1600 - 32, 1e-6);
    EXPECT_EQ(plate.origin.holes, holesOf(plate.shape));
    EXPECT_EQ(plate.origin.file, "plate.svg");
    const auto fitted = read(20);
    ASSERT_TRUE(fitted) << describe(fitted.error());
    const ObjectSpec& object = fitted->objects[0];
    EXPECT_EQ(object.origin.holes, plate.origin.holes);
    const FourierFit fit = fitFourier(plate.origin.outline, 20).value();
    EXPECT_GT(fit.centre_m.norm(), 1e-6); // else nothing is tested
    ASSERT_EQ(holesOf(object.shape).size(), 2u);
    for (std::size_t k = 0; k < 2; ++k)
        EXPECT_LT((contourCentroid(holesOf(object.shape)[k]) + fit.centre_m -
                   contourCentroid(holesOf(plate.shape)[k]))
                      .norm(),
                  1e-12);
    const auto again = shapeFromOutline(object.origin.outline, object.origin.holes, 20);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->origin.harmonics, 20);
    EXPECT_LT((contourCentroid(holesOf(again->shape)[0]) - contourCentroid(holesOf(object.shape)[0])).norm(),
              1e-12);
    const auto coarse = read(1);
    ASSERT_FALSE(coarse);
    EXPECT_EQ(coarse.error().code(), MessageCode::HoleOutside);
    EXPECT_NE(coarse.error().where.find("objects[0].contour.harmonics: holes["), std::string::npos);
    const auto whole = experimentFromJson(experimentToJson(*fitted), "", "/nowhere");
    ASSERT_TRUE(whole) << describe(whole.error());
    EXPECT_TRUE(*whole == *fitted);
}

// Catches holes that no file names, set by the window, taken without a look.
TEST(Validation, LooksAtHoles) {
    Experiment e = example("two-circles.json");
    e.objects[0].shape = withHoles(Disk{0.015}, {square(0.002, 0.0, 0.0), square(0.002, 0.013, 0.0)});
    const auto refused = validate(e);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::HoleOutside);
    EXPECT_EQ(refused.error().where, "objects[0].contour.holes_m[1]");
    e.objects[0].shape = withHoles(Disk{0.015}, {Contour{shapeOutline(Disk{0.01}, 5001)}});
    EXPECT_EQ(validate(e).error().where, "objects[0].contour.holes_m");
    e.objects[0].shape = Disk{0.015};
    EXPECT_TRUE(validate(e));
    e.objects[0].origin.holes = {square(0.002, 0.0, 0.0)};
    EXPECT_EQ(validate(e).error().where, "objects[0].contour.outline_holes_m[0]");
}

/// A square of 20 units.
void writeSquare(QFile& csv) {
    EXPECT_TRUE(csv.open(QIODevice::WriteOnly));
    csv.write("x,y\n0,0\n20,0\n20,20\n0,20\n");
    csv.close();
}

// Catches a plate with many drilled holes that no experiment takes, since each of them has a hundred corners.
TEST(Reading, ImportsManyRoundHoles) {
    const QTemporaryDir folder;
    QFile svg(folder.filePath("sieve.svg"));
    ASSERT_TRUE(svg.open(QIODevice::WriteOnly));
    svg.write("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>"
              "<path d='M0,0 H100 V100 H0 Z");
    for (int k = 0; k < 190; ++k)
        svg.write(QByteArray(" M%1,%2 a2.5,2.5 0 1 0 5,0 a2.5,2.5 0 1 0 -5,0 z")
                      .replace("%1", QByteArray::number(2 + 7 * (k % 14)))
                      .replace("%2", QByteArray::number(5 + 7 * (k / 14))));
    svg.write("' fill-rule='evenodd'/></svg>");
    svg.close();
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    j["objects"][0]["contour"] = {{"type", "import"}, {"file", "sieve.svg"}, {"harmonics", 0}};
    const auto read = experimentFromJson(j.dump(), "", folder.path().toStdString());
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(holesOf(read->objects[0].shape).size(), 190u);
    EXPECT_NEAR(shapeArea(read->objects[0].shape) * 1e6, 10000 - 190 * std::numbers::pi * 6.25, 0.03 * 3731);
}

// Catches an import that works for objects only, or forgets the raw outline.
TEST(Reading, ImportsAndFitsTheSourcesOutline) {
    const QTemporaryDir folder;
    QFile csv(folder.filePath("square.csv"));
    writeSquare(csv);
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    j["source"]["contour"] = {{"type", "import"}, {"file", "square.csv"}, {"unit", "cm"}, {"harmonics", 7}};
    const auto read = experimentFromJson(j.dump(), "", folder.path().toStdString());
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(std::get<FourierContour>(read->source.shape).harmonics(), 7);
    EXPECT_NEAR(shapeArea(read->source.shape), 0.04, 0.001);
    EXPECT_EQ(read->source.origin.file, "square.csv");
    EXPECT_EQ(read->source.origin.outline.points_m.size(), 4u);
    EXPECT_LT(contourCentroid(read->source.origin.outline).norm(), 1e-12);
    const auto again = experimentFromJson(experimentToJson(*read), "", "/nowhere");
    ASSERT_TRUE(again) << describe(again.error());
    EXPECT_TRUE(*again == *read);
}

TEST(Reading, ImportsACsvAsAnExactPolygon) {
    const QTemporaryDir folder;
    QFile csv(folder.filePath("square.csv"));
    writeSquare(csv);
    auto j = nlohmann::json::parse(experimentToJson(example("two-circles.json")));
    j["objects"][0]["contour"] = {{"type", "import"}, {"file", "square.csv"}, {"unit", "mm"}};
    const auto read = experimentFromJson(j.dump(), "", folder.path().toStdString());
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(std::get<Contour>(read->objects[0].shape).points_m.size(), 4u);
    EXPECT_NEAR(shapeArea(read->objects[0].shape), 4e-4, 1e-12);
    EXPECT_EQ(read->objects[0].origin.outline, std::get<Contour>(read->objects[0].shape));
}

TEST(EdgeUnits, PreferShortNumbersAndSayWhenNoneIsExact) {
    EXPECT_EQ(fromSi(313.15, EdgeUnit::Temperature).value, 40.0);
    EXPECT_EQ(fromSi(radFromDeg(35.0), EdgeUnit::Angle).value, 35.0);
    EXPECT_EQ(fromSi(0.0435, EdgeUnit::LengthCm).value, 4.35);
    std::mt19937_64 random(1);
    for (const EdgeUnit unit :
         {EdgeUnit::Temperature, EdgeUnit::LengthCm, EdgeUnit::LengthMm, EdgeUnit::Angle}) {
        for (int k = 0; k < 2000; ++k) {
            const double si = std::uniform_real_distribution(-3.0, 600.0)(random);
            if (const ReadableValue readable = fromSi(si, unit); readable.exact) {
                ASSERT_EQ(toSi(readable.value, unit), si);
            }
        }
    }
}

TEST(SetTargets, ReplacesAllOrNothing) {
    Experiment e = example("three-objects.json");
    ASSERT_TRUE(setTargets(e, {320, 310, 305}));
    EXPECT_EQ(e.objects[2].target_K, 305);
    const Experiment before = e;
    EXPECT_EQ(setTargets(e, {320, 310}).error().code(), MessageCode::TargetCountWrong);
    const auto tooHot = setTargets(e, {320, 310, 1e6});
    ASSERT_FALSE(tooHot);
    EXPECT_EQ(tooHot.error().where, "objects[2].target_degC");
    EXPECT_FALSE(setTargets(e, {NAN, 310, 300}));
    EXPECT_TRUE(e == before);
}

} // namespace
} // namespace bask
