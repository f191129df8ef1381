// Every refusal of the experiment reader: the code, the JSON path, and that nothing of it hangs or crashes.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/thermography/camera_profile.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <ctime>
#include <limits>
#include <random>

namespace bask {
namespace {

using nlohmann::json;

json base() {
    return json::parse(experimentToJson(test::twoDisks()));
}

Error refused(const std::string& text, const std::string& folder = "/nowhere") {
    const auto read = experimentFromJson(text, "e.json", folder);
    if (read) {
        ADD_FAILURE() << "accepted: " << text.substr(0, 200);
        return {};
    }
    EXPECT_EQ(read.error().where.rfind("e.json", 0), 0u) << describe(read.error());
    EXPECT_GT(describe(read.error()).size(), 15u);
    return read.error();
}

struct Change {
    const char* pointer; ///< JSON pointer of what is replaced
    const char* value;   ///< new value as JSON; empty: erased
    MessageCode code;
    const char* where;
};

class ChangedKey : public ::testing::TestWithParam<Change> {};

TEST_P(ChangedKey, IsRefusedAtItsPlace) {
    const Change& change = GetParam();
    json j = base();
    const json::json_pointer pointer{std::string(change.pointer)};
    if (*change.value != '\0')
        j[pointer] = json::parse(change.value);
    else
        j[pointer.parent_pointer()].erase(pointer.back());
    const Error error = refused(j.dump());
    EXPECT_EQ(error.code(), change.code) << describe(error);
    EXPECT_EQ(error.where, std::string("e.json") + (*change.where ? ": " : "") + change.where);
}

using enum MessageCode;

INSTANTIATE_TEST_SUITE_P(
    Reader, ChangedKey,
    ::testing::Values(Change{"/source/contour", R"({"type":"fourier","coefficients":[[2,0.1,0]]})",
                             SeriesUneven, "source.contour.coefficients"},
                      Change{"/source/contour", R"({"type":"fourier","coefficients":[[1,1e-7,0]]})",
                             ValueOutOfRange, "source.contour"},
                      Change{"/sorce", "1", JsonUnknownKey, ""},
                      Change{"/objects/1/colour", "1", JsonUnknownKey, "objects[1]"},
                      Change{"/objects/0/material/emissivity", "0.9", JsonUnknownKey, "objects[0].material"},
                      Change{"/objects/0/contour/radius_cm", "1", JsonUnknownKey, "objects[0].contour"},
                      Change{"/controller/adaptive/mu", "1", JsonUnknownKey, "controller.adaptive"},
                      Change{"/format", "", JsonMissingKey, ""}, Change{"/version", "", JsonMissingKey, ""},
                      Change{"/source", "", JsonMissingKey, ""}, Change{"/objects", "", JsonMissingKey, ""},
                      Change{"/environment/temperature_degC", "", JsonMissingKey, "environment"},
                      Change{"/objects/1/target_degC", "", JsonMissingKey, "objects[1]"},
                      Change{"/objects/1/mounting", "", JsonMissingKey, "objects[1]"},
                      Change{"/objects/1/material/density_kg_m3", "", JsonMissingKey, "objects[1].material"},
                      Change{"/source/temperature_degC", "\"hot\"", JsonWrongType, "source.temperature_degC"},
                      Change{"/source", "[]", JsonWrongType, "source"},
                      Change{"/objects", "{}", JsonWrongType, "objects"},
                      Change{"/objects/1", "null", JsonWrongType, "objects[1]"},
                      Change{"/objects/1/name", "3", JsonWrongType, "objects[1].name"},
                      Change{"/sampling/window", "10.5", JsonWrongType, "sampling.window"},
                      Change{"/objects/1/target_degC", "null", JsonWrongType, "objects[1].target_degC"},
                      Change{"/robot/free", "\"x\"", JsonWrongType, "robot.free"},
                      Change{"/robot/free/0", "\"w\"", ValueUnknown, "robot.free[0]"},
                      Change{"/robot/free/0", "\"y\"", AxisTwice, "robot.free[1]"},
                      Change{"/format", "\"cake\"", ValueUnknown, "format"},
                      Change{"/version", "2", VersionTooNew, "version"},
                      Change{"/version", "0", ValueOutOfRange, "version"},
                      Change{"/controller/kind", "\"pid\"", ValueUnknown, "controller.kind"},
                      Change{"/source/source_model", "\"white\"", ValueUnknown, "source.source_model"},
                      Change{"/source/contour/type", "\"square\"", ValueUnknown, "source.contour.type"},
                      Change{"/source/contour/type", "7", JsonWrongType, "source.contour.type"},
                      Change{"/source/contour/type", "", JsonMissingKey, "source.contour"},
                      Change{"/source/contour/type", "\"polygon\"", JsonUnknownKey, "source.contour"},
                      Change{"/source/contour", "", JsonMissingKey, "source"},
                      Change{"/source/contour/radius_cm", "1", JsonUnknownKey, "source.contour"},
                      Change{"/objects/0/contour/type", "\"blob\"", ValueUnknown, "objects[0].contour.type"},
                      Change{"/objects/0/target_K", "300", JsonTwoSpellings, "objects[0]"},
                      Change{"/simulation/seed", "-1", ValueOutOfRange, "simulation.seed"},
                      Change{"/simulation/seed", "1.5", JsonWrongType, "simulation.seed"},
                      Change{"/sampling/window", "99999999999", ValueOutOfRange, "sampling.window"}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, ChangedKey,
    ::testing::Values(
        Change{"/objects/1/contour/radius_m", "-0.01", ValueNotPositive, "objects[1].contour.radius_m"},
        Change{"/objects/1/contour/radius_m", "0", ValueNotPositive, "objects[1].contour.radius_m"},
        Change{"/source/contour/radius_m", "-1", ValueNotPositive, "source.contour.radius_m"},
        Change{"/source/contour/radius_m", "10.1", ValueOutOfRange, "source.contour.radius_m"},
        Change{"/objects/1/contour/radius_m", "1.1", ValueOutOfRange, "objects[1].contour.radius_m"},
        Change{"/objects/1/material/emittance", "1.5", ValueOutOfRange, "objects[1].material.emittance"},
        Change{"/objects/1/material/absorptance", "0", ValueNotPositive, "objects[1].material.absorptance"},
        Change{"/objects/1/material/infill", "1.01", ValueOutOfRange, "objects[1].material.infill"},
        Change{"/objects/1/material/thickness_mm", "-1", ValueNotPositive,
               "objects[1].material.thickness_mm"},
        Change{"/objects/1/target_degC", "1e9", ValueOutOfRange, "objects[1].target_degC"},
        Change{"/objects/1/target_degC", "-400", ValueOutOfRange, "objects[1].target_degC"},
        Change{"/objects/1/mounting/x_cm", "1000", ValueOutOfRange, "objects[1].mounting.x_cm"},
        Change{"/objects/1/name", "\" \"", NameEmpty, "objects[1].name"},
        Change{"/objects/1/name", "\"left, the\"", DuplicateName, "objects[1].name"},
        Change{"/objects", "[]", NoObjects, "objects"}, Change{"/robot/free", "[]", NoFreeAxis, "robot.free"},
        Change{"/robot/free", "[\"z\"]", TooManyObjects, "objects"},
        Change{"/robot/lower/z_cm", "40", LimitsReversed, "robot.lower.z_cm"},
        Change{"/robot/start/z_cm", "31", StartOutsideWorkspace, "robot.start.z_cm"},
        Change{"/robot/clearance_cm", "16", StartTooClose, "robot.start"},
        Change{"/robot/max_speed_cm_s", "0", ValueNotPositive, "robot.max_speed_cm_s"},
        Change{"/robot/max_acceleration_cm_s2", "-1", ValueOutOfRange, "robot.max_acceleration_cm_s2"},
        Change{"/robot/max_acceleration_cm_s2", "1001", ValueOutOfRange, "robot.max_acceleration_cm_s2"},
        Change{"/robot/max_angular_acceleration_rad_s2", "-0.1", ValueOutOfRange,
               "robot.max_angular_acceleration_rad_s2"},
        Change{"/source/temperature_degC", "20", SourceTooWeak, "source"},
        Change{"/sampling/window", "3", ValueOutOfRange, "sampling.window"},
        Change{"/sampling/period_s", "0", ValueOutOfRange, "sampling.period_s"},
        Change{"/objects/1/name", R"("a\u001b[31m")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\nb")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u0085")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("\u007fa")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u200b")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u202eb")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u2066b")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("\ufeffa")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u00adb")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("a\u3164b")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", R"("\u845b\udb40\udd00")", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/material/name", R"("a\u202eb")", NameNotPlain, "objects[1].material.name"},
        Change{"/objects/1/material/name", R"("a\u001b[31m")", NameNotPlain, "objects[1].material.name"},
        Change{"/objects/1/name", "\" a\"", NameNotPlain, "objects[1].name"},
        Change{"/objects/1/name", "\"a \"", NameNotPlain, "objects[1].name"},
        Change{"/controller/believed_rate_error_factor", "0.5", ValueOutOfRange,
               "controller.believed_rate_error_factor"},
        Change{"/controller/believed_rate_error_factor", "8.01", ValueOutOfRange,
               "controller.believed_rate_error_factor"},
        Change{"/objects/1/believed_rates", "{}", JsonMissingKey, "objects[1].believed_rates"},
        Change{"/objects/1/believed_rates",
               R"({"lambda1_K_s":1,"lambda2_1_K3s":1e-11,"lambda3_K_s":1,"lambda4":1})", JsonUnknownKey,
               "objects[1].believed_rates"},
        Change{"/objects/1/believed_rates", R"({"lambda1_K_s":-1,"lambda2_1_K3s":1e-11,"lambda3_K_s":1})",
               ValueNotPositive, "objects[1].believed_rates.lambda1_K_s"},
        Change{"/objects/1/believed_rates", R"({"lambda1_K_s":1,"lambda2_1_K3s":2,"lambda3_K_s":1})",
               ValueOutOfRange, "objects[1].believed_rates.lambda2_1_K3s"},
        Change{"/objects/1/believed_rates", R"({"lambda1_K_s":1,"lambda2_1_K3s":1e-11,"lambda3_K_s":0})",
               ValueNotPositive, "objects[1].believed_rates.lambda3_K_s"},
        Change{"/simulation/duration_limit_s", "0.01", ValueOutOfRange, "simulation.duration_limit_s"},
        Change{"/simulation/duration_limit_s", "-1", ValueNotPositive, "simulation.duration_limit_s"}));

// Catches a source or simulation that is taken although it means nothing: times that stand still, a motion
// that begins elsewhere, a probability above a half.
INSTANTIATE_TEST_SUITE_P(
    MovingSource, ChangedKey,
    ::testing::Values(
        Change{"/source/emittance_uncertainty", "-0.1", ValueOutOfRange, "source.emittance_uncertainty"},
        Change{"/source/emittance_uncertainty", "\"much\"", JsonWrongType, "source.emittance_uncertainty"},
        Change{"/source/tracked", "1", JsonWrongType, "source.tracked"},
        Change{"/source/pose/x_cm", "501", ValueOutOfRange, "source.pose.x_cm"},
        Change{"/source/pose/theta_y_deg", "91", ValueOutOfRange, "source.pose.theta_y_deg"},
        Change{"/source/pose/w_cm", "1", JsonUnknownKey, "source.pose"},
        Change{"/source/pose/z_cm", "14.5", StartTooClose, "robot.start"},
        Change{"/source/pose/theta_y_deg", "80", StartTooClose, "robot.start"},
        Change{"/source/temperature_profile", "200", JsonWrongType, "source.temperature_profile"},
        Change{"/source/temperature_profile", "[200]", JsonWrongType, "source.temperature_profile[0]"},
        Change{"/source/temperature_profile", R"([{"temperature_degC":200}])", JsonMissingKey,
               "source.temperature_profile[0]"},
        Change{"/source/temperature_profile", R"([{"time_s":0}])", JsonMissingKey,
               "source.temperature_profile[0]"},
        Change{"/source/temperature_profile", R"([{"time_s":-1,"temperature_degC":200}])", ValueOutOfRange,
               "source.temperature_profile[0].time_s"},
        Change{"/source/temperature_profile",
               R"([{"time_s":5,"temperature_degC":200},{"time_s":5,"temperature_degC":300}])",
               TimesNotGrowing, "source.temperature_profile[1].time_s"},
        Change{"/source/temperature_profile",
               R"([{"time_s":0,"temperature_degC":200},{"time_s":5,"temperature_degC":2001}])",
               ValueOutOfRange, "source.temperature_profile[1].temperature_degC"},
        Change{"/simulation/source_motion", R"([{"time_s":0,"x_cm":1}])", MotionElsewhere,
               "simulation.source_motion[0].x_cm"},
        Change{"/simulation/source_motion", R"([{"time_s":0},{"time_s":0}])", TimesNotGrowing,
               "simulation.source_motion[1].time_s"},
        Change{"/simulation/source_motion", R"([{"time_s":0},{"time_s":9,"theta_x_deg":181}])",
               ValueOutOfRange, "simulation.source_motion[1].theta_x_deg"},
        Change{"/simulation/source_motion", R"([{"time_s":0,"y":1}])", JsonUnknownKey,
               "simulation.source_motion[0]"},
        Change{"/simulation/source_emittance", "0", ValueNotPositive, "simulation.source_emittance"},
        Change{"/simulation/source_emittance", "1.1", ValueOutOfRange, "simulation.source_emittance"},
        Change{"/simulation/tracking_noise_mm", "-1", ValueOutOfRange, "simulation.tracking_noise_mm"},
        Change{"/simulation/tracking_noise_deg", "11", ValueOutOfRange, "simulation.tracking_noise_deg"},
        Change{"/simulation/tracking_noise_m", "0.001", JsonTwoSpellings, "simulation"},
        Change{"/simulation/tracking_delay_s", "3", ValueOutOfRange, "simulation.tracking_delay_s"},
        Change{"/simulation/sensor_lag_s", "-1", ValueOutOfRange, "simulation.sensor_lag_s"},
        Change{"/simulation/sensor_dropout", "0.6", ValueOutOfRange, "simulation.sensor_dropout"},
        Change{"/simulation/robot_latency_s", "11", ValueOutOfRange, "simulation.robot_latency_s"},
        Change{"/objects/1/simulated_material", "{}", JsonMissingKey, "objects[1].simulated_material"},
        Change{
            "/objects/1/simulated_material",
            R"({"emittance":2,"absorptance":0.9,"specific_heat_J_kgK":904,"density_kg_m3":2700,"thickness_mm":1})",
            ValueOutOfRange, "objects[1].simulated_material.emittance"}));

INSTANTIATE_TEST_SUITE_P(
    Outlines, ChangedKey,
    ::testing::Values(
        Change{"/objects/0/contour", R"({"type":"polygon","points_m":[[0,0],[1,0]]})", ContourTooFewPoints,
               "objects[0].contour.points_m"},
        Change{"/objects/0/contour", R"({"type":"polygon","points_m":[[0,0],[0.02,0.02],[0.02,0],[0,0.02]]})",
               ContourCrossing, "objects[0].contour.points_m"},
        Change{"/objects/0/contour", R"({"type":"polygon","points_m":[[0,0],[1,0],[1,"a"]]})", JsonWrongType,
               "objects[0].contour.points_m[2]"},
        Change{"/objects/0/contour/holes_m", "7", JsonWrongType, "objects[0].contour.holes_m"},
        Change{"/objects/0/contour/holes_m", "[[[0,0],[0.001,0]]]", ContourTooFewPoints,
               "objects[0].contour.holes_m[0]"},
        Change{"/objects/0/contour/holes_m", "[[[0,0],[0.001,0],[0,0.001]],[[0,0],[1]]]", JsonWrongType,
               "objects[0].contour.holes_m[1][1]"},
        Change{"/objects/0/contour/holes_m", "[[[0,0],[0.001,0.001],[0.001,0],[0,0.001]]]", ContourCrossing,
               "objects[0].contour.holes_m[0]"},
        Change{"/objects/0/contour/holes_m", "[[[0,0],[0.5,0],[0,0.5]]]", HoleOutside,
               "objects[0].contour.holes_m[0]"},
        Change{"/objects/0/contour/holes_m", "[[[0,0],[0.001,0],[0,0.001]],[[0,0],[0.002,0],[0,0.001]]]",
               HolesMeet, "objects[0].contour.holes_m[1]"},
        Change{"/source/contour/holes_m", "[[[1,0],[2,0],[1,1]]]", HoleOutside, "source.contour.holes_m[0]"},
        Change{"/objects/0/contour/outline_holes_m", "[[[0,0],[0.001,0],[0,0.001]]]", HoleOutside,
               "objects[0].contour.outline_holes_m[0]"},
        Change{"/objects/0/contour", R"({"type":"polygon","points_m":[[0,0],[1,0],[1]]})", JsonWrongType,
               "objects[0].contour.points_m[2]"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[[1,0.01]]})", JsonWrongType,
               "objects[0].contour.coefficients[0]"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[[1,0.01,0],[1,0.02,0]]})",
               JsonDuplicateKey, "objects[0].contour.coefficients"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[[1000000000,0.01,0]]})",
               HarmonicsOutOfRange, "objects[0].contour.coefficients"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[[0.5,0.01,0]]})",
               HarmonicsOutOfRange, "objects[0].contour.coefficients"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[]})", ContourZeroArea,
               "objects[0].contour"},
        Change{"/objects/0/contour", R"({"type":"fourier","coefficients":[[1,50,0]]})", ValueOutOfRange,
               "objects[0].contour"},
        Change{"/objects/0/contour", R"({"type":"import","file":"x.png","scale_px_per_mm":15,"harmoincs":5})",
               JsonUnknownKey, "objects[0].contour"},
        Change{"/objects/0/contour", R"({"type":"import","file":"x.csv","unit":"furlong"})", ValueUnknown,
               "objects[0].contour.unit"},
        Change{"/objects/0/contour", R"({"type":"import"})", JsonMissingKey, "objects[0].contour"},
        Change{"/source/contour", R"({"type":"polygon","points_m":[[0,0],[1,0]]})", ContourTooFewPoints,
               "source.contour.points_m"},
        Change{"/source/contour", R"({"type":"polygon","points_m":[[0,0],[0.2,0.2],[0.2,0],[0,0.2]]})",
               ContourCrossing, "source.contour.points_m"},
        Change{"/source/contour", R"({"type":"polygon","points_m":[[0,0],[0,20],[20,20],[20,0]]})",
               ValueOutOfRange, "source.contour"},
        Change{"/source/contour", R"({"type":"fourier","coefficients":[[1,0.1]]})", JsonWrongType,
               "source.contour.coefficients[0]"},
        Change{"/source/contour", R"({"type":"fourier","coefficients":[[41,0.1,0]]})", HarmonicsOutOfRange,
               "source.contour.coefficients"},
        Change{"/source/contour", R"({"type":"fourier","coefficients":[]})", ContourZeroArea,
               "source.contour"},
        Change{"/source/contour", R"({"type":"fourier","coefficients":[[1,10.1,0]]})", ValueOutOfRange,
               "source.contour"},
        Change{"/source/contour", R"({"type":"fourier","coefficients":[[1,0.1,0]],"harmonics":41})",
               ValueOutOfRange, "source.contour.harmonics"},
        Change{"/source/contour", R"({"type":"import","file":"x.csv","unit":"furlong"})", ValueUnknown,
               "source.contour.unit"},
        Change{"/source/contour", R"({"type":"import"})", JsonMissingKey, "source.contour"}));

TEST(Refusal, NamesTheMissingContourFile) {
    json j = base();
    j["objects"][0]["contour"] = {{"type", "import"}, {"file", "gone.csv"}, {"unit", "mm"}};
    const Error error = refused(j.dump());
    EXPECT_EQ(error.code(), FileNotFound);
    EXPECT_EQ(error.where, "e.json: objects[0].contour.file: /nowhere/gone.csv");
    j["source"]["contour"] = j["objects"][0]["contour"];
    EXPECT_EQ(refused(j.dump()).where, "e.json: source.contour.file: /nowhere/gone.csv");
}

TEST(Refusal, NamesTheAllowedRangeAndTheKnownKeys) {
    json j = base();
    j["objects"][0]["material"]["emittance"] = 2;
    EXPECT_EQ(describe(refused(j.dump())),
              "e.json: objects[0].material.emittance: 2 is out of range; allowed: 0 to 1");
    j = base();
    j["sampling"]["periode_s"] = 2;
    EXPECT_NE(describe(refused(j.dump()))
                  .find("\"periode_s\"; known here: order, period_s, thermal_frame_period_s, window"),
              std::string::npos);
}

// Catches a plant that cannot heat although what is believed can.
TEST(Refusal, NamesTheTrueEmittanceThatCannotHeat) {
    json j = base();
    j["source"]["source_model"] = "paper";
    j["simulation"]["source_emittance"] = 0.1;
    const Error error = refused(j.dump());
    EXPECT_EQ(error.code(), SourceTooWeak);
    EXPECT_EQ(error.where, "e.json: simulation.source_emittance");
}

TEST(Refusal, TakesNamesInAnyScriptAndTheLargestDoubtInTheRates) {
    json j = base();
    j["objects"][0]["name"] = "pièce à gauche 左";
    j["controller"]["believed_rate_error_factor"] = 8;
    j["simulation"]["duration_limit_s"] = j["sampling"]["period_s"];
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
}

TEST(Refusal, HostileTexts) {
    EXPECT_EQ(refused("").code(), FileEmpty);
    EXPECT_EQ(refused(" \n").code(), FileEmpty);
    EXPECT_EQ(refused("\xEF\xBB\xBF").code(), JsonSyntax);
    EXPECT_EQ(refused("\xFF\xFE{\0}\0").code(), JsonSyntax);
    EXPECT_EQ(refused(std::string(1000, '\0')).code(), JsonSyntax);
    EXPECT_EQ(refused("{\"format\": NaN}").code(), JsonSyntax);
    EXPECT_EQ(refused("{\"version\": 1e999}").code(), JsonSyntax);
    EXPECT_EQ(refused("[1,2,3]").code(), JsonWrongType);
    EXPECT_EQ(refused("12").code(), JsonWrongType);
    EXPECT_EQ(refused("{\"version\": 1, \"version\": 1}").code(), JsonDuplicateKey);
    EXPECT_EQ(refused("{\"a\": {\"b\": 1, \"b\": 2}}").code(), JsonDuplicateKey);
    EXPECT_EQ(refused(std::string(5'000'000, '[')).code(), JsonTooDeep);
    std::string deep;
    for (int k = 0; k < 100'000; ++k)
        deep += "{\"a\":";
    EXPECT_EQ(refused(deep).code(), JsonTooDeep);
    EXPECT_EQ(refused("{\"title\": \"" + std::string(33u << 20, 'x') + "\"}").code(), FileTooLarge);
    EXPECT_LT(describe(refused("{\"" + std::string(10'000, 'k') + "\": 1}")).size(), 1000u);
}

TEST(Refusal, HugeArraysTakeSecondsAtMost) {
    const std::clock_t before = std::clock();
    std::string many = "[0";
    for (int k = 0; k < 3'000'000; ++k)
        many += ",1";
    json j = base();
    std::string text = j.dump();
    text.insert(text.size() - 1, ",\"extra\":" + many + "]");
    EXPECT_EQ(refused(text).code(), JsonUnknownKey);
    std::string objects =
        "{\"format\":\"bask-experiment\",\"version\":1,\"source\":{},\"environment\":{},\"objects\":[{}";
    for (int k = 0; k < 500'000; ++k)
        objects += ",{}";
    refused(objects + "]}");
    EXPECT_LT(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC, 20.0);
}

TEST(Refusal, NumbersOutOfReachInTheValue) {
    Experiment e = test::twoDisks();
    e.objects[0].material.emittance = std::nan("");
    EXPECT_EQ(validate(e).error().where, "objects[0].material.emittance");
    e = test::twoDisks();
    e.objects[0].shape = FourierContour();
    EXPECT_EQ(validate(e).error().code(), HarmonicsOutOfRange);
    e = test::twoDisks();
    e.source.shape = Contour{{{0.1, 0.0}, {0.0, std::nan("")}, {-0.1, 0.0}}};
    EXPECT_EQ(validate(e).error().where, "source.contour.points_m");
    e = test::twoDisks();
    e.objects[1].mounting[kY] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(validate(e).error().where, "objects[1].mounting.y_cm");
    e = test::twoDisks();
    e.robot.lower[kX] = std::nan("");
    EXPECT_FALSE(validate(e));
}

TEST(Refusal, ATiltedDiskTooCloseAtTheStart) {
    Experiment e = test::twoDisks();
    e.start[kZ] = 0.02;
    ASSERT_TRUE(validate(e));
    e.start[kThetaX] = 0.6; // the rim comes down by 15 mm sin 0.6 = 8.5 mm more than is allowed with 10 mm
    e.start[kZ] = 0.018;
    EXPECT_EQ(validate(e).error().code(), StartTooClose);
    e.start[kZ] = 0.019;
    EXPECT_TRUE(validate(e));
}

TEST(Refusal, FilesThatAreNone) {
    const QTemporaryDir folder;
    EXPECT_EQ(readExperiment(folder.filePath("none.json").toStdString()).error().code(), FileNotFound);
    EXPECT_EQ(readExperiment(folder.path().toStdString()).error().code(), FileUnreadable);
    QFile file(folder.filePath("empty.json"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    EXPECT_EQ(readExperiment(file.fileName().toStdString()).error().code(), FileEmpty);
    ASSERT_TRUE(file.resize(40 << 20));
    EXPECT_EQ(readExperiment(file.fileName().toStdString()).error().code(), FileTooLarge);
    EXPECT_EQ(readExperiment("").error().code(), FileNotFound);
    EXPECT_EQ(writeExperiment(test::twoDisks(), "/nowhere/e.json").error().code(), FileUnwritable);
}

// Catches crashes, hangs and throws on any damaged text.
TEST(Fuzz, DamagedTextsAreAcceptedOrRefusedInWords) {
    const std::string whole = experimentToJson(test::twoDisks());
    std::mt19937 random(20260101);
    const auto below = [&](std::size_t n) {
        return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
    };
    const std::string characters = "{}[]\",:-+.eE0159tfn\\u \n\x01\xff";
    int refusals = 0;
    for (int k = 0; k < 3000; ++k) {
        std::string text = whole;
        for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
            const std::size_t at = below(text.size());
            switch (below(4)) {
            case 0:
                text[at] = characters[below(characters.size())];
                break;
            case 1:
                text.erase(at, 1 + below(20));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), 1 + below(40)));
                break;
            default:
                text.insert(at, 1, characters[below(characters.size())]);
            }
        }
        const auto read = experimentFromJson(text, "e.json", "/nowhere");
        if (!read) {
            ++refusals;
            ASSERT_NE(read.error().code(), None) << text;
        } else {
            ASSERT_TRUE(validate(*read));
        }
    }
    EXPECT_GT(refusals, 2000);
    for (std::size_t n = 0; n + 2 < whole.size(); n += 7)
        ASSERT_FALSE(experimentFromJson(whole.substr(0, n), "e.json", "/nowhere"));
}

TEST(ThermalCameraOfAnExperiment, IsRefusedWhereItDoesNotFit) {
    json j = base();
    const auto refuse = [&] { return refused(j.dump()); };
    j["objects"][1]["read_by"] = "eye";
    EXPECT_EQ(refuse().where, "e.json: objects[1].read_by");
    j["objects"][1]["read_by"] = "both";
    EXPECT_EQ(refuse().code(), ReadByNoCamera);
    EXPECT_EQ(refuse().where, "e.json: objects[1].read_by");
    j["simulation"]["thermal_camera"] = json::object();
    j["sampling"]["period_s"] = 1.0;
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
    j["sampling"]["period_s"] = 0.1; // a closed shutter would be a lost sensor
    EXPECT_EQ(refuse().where, "e.json: sampling.period_s");
    j["objects"][1]["read_by"] = "contact";
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));

    j["simulation"]["thermal_camera"]["calibration"] = {{"pose", {{"z_cm", 1e4}}}};
    EXPECT_EQ(refuse().where, "e.json: simulation.thermal_camera.calibration.pose.z_cm");

    j = base();
    json& camera = j["rig"]["thermal_camera"];
    camera =
        json::parse(R"({"device": "0", "profile": "lepton-3.5", "pose": {"z_cm": 110, "theta_x_deg": 180},
        "lens": {"width_px": 160, "height_px": 120, "fx_px": 150, "fy_px": 150, "cx_px": 79.5, "cy_px": 59.5}})");
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
    camera["lens"]["width_px"] = 161;
    EXPECT_EQ(refuse().where, "e.json: rig.thermal_camera.lens.width_px");
    camera["lens"]["width_px"] = 160;
    camera["lens"]["distortion"] = {-9.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_EQ(refuse().code(), LensNotInvertible);
    camera["lens"].erase("distortion");
    camera["pose"]["z_cm"] = 1e4;
    EXPECT_EQ(refuse().where, "e.json: rig.thermal_camera.pose.z_cm");
    camera["pose"]["z_cm"] = 110;
    camera["pose_uncertainty_mm"] = -1;
    EXPECT_EQ(refuse().where, "e.json: rig.thermal_camera.pose_uncertainty_mm");
    camera["pose_uncertainty_mm"] = 20.1;
    EXPECT_EQ(refuse().code(), ValueOutOfRange);
    camera["pose_uncertainty_mm"] = 20.0;
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
    camera.erase("pose");
    EXPECT_EQ(refuse().code(), JsonMissingKey);
    EXPECT_EQ(refuse().where, "e.json: rig.thermal_camera");
    camera.erase("pose_uncertainty_mm");
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
}

// Catches a target that is run for although its thermometer can never tell it, and one that is refused
// because a face of low emittance is taken for as bright as a black one. Limits by an independent integral: a
// camera that is right up to 150 degC, a room at 25 degC.
TEST(ThermalCameraOfAnExperiment, TellsItsTargets) {
    json j = base();
    j["sampling"]["period_s"] = 1.0;
    j["simulation"]["thermal_camera"] = {{"profile", "p2-pro"}};
    const auto isTold = [&](const char* readBy, double emittance, double target_degC) {
        json& object = j["objects"][1];
        object["read_by"] = readBy;
        object["material"]["emittance"] = emittance;
        object["target_degC"] = target_degC;
        object["warning_degC"] = 390.0;
        object["trip_degC"] = 400.0;
        const auto experiment = experimentFromJson(j.dump(), "e.json", "/nowhere");
        EXPECT_TRUE(experiment) << "a file, or a recording, that nobody could mend";
        const auto fit = checkTargets(experiment.value());
        EXPECT_TRUE(fit || fit.error().code() == TargetNotTold);
        return fit.ok();
    };
    EXPECT_TRUE(isTold("camera", 0.9, 160.0));
    EXPECT_FALSE(isTold("camera", 0.9, 160.2));
    EXPECT_TRUE(isTold("both", 0.9, 160.2));
    EXPECT_TRUE(isTold("contact", 0.9, 160.2));
    EXPECT_TRUE(isTold("camera", 0.5, 230.7));
    EXPECT_FALSE(isTold("camera", 0.5, 230.9));
    j["simulation"]["thermal_camera"]["profile"] = "lepton-3.5";
    EXPECT_TRUE(isTold("camera", 0.9, 380.0));

    ThermalProfile profile = findThermalProfile("lepton-3.5").value();
    profile.min_K = 323.15;
    j["rig"]["thermal_camera"] = {{"device", "0"}, {"profile", json::parse(thermalProfileToJson(profile))}};
    EXPECT_FALSE(isTold("camera", 0.9, 40.0)); // of the rig's own
    EXPECT_TRUE(isTold("camera", 0.9, 60.0));
}

// An object that the camera reads has no channel.
TEST(ThermalCameraOfAnExperiment, LeavesOutTheChannelsOfWhatItReads) {
    json j = base();
    j["rig"] = json::parse(R"({"thermometer": {"driver": "stream", "port": "t", "channels": [0, 1]},
                               "thermal_camera": {"device": "0", "profile": "p2-pro"}})");
    EXPECT_TRUE(experimentFromJson(j.dump(), "e.json", "/nowhere"));
    j["objects"][0]["read_by"] = "camera";
    EXPECT_EQ(refused(j.dump()).code(), ChannelCountWrong);
    j["rig"]["thermometer"]["channels"] = {3};
    const auto read = experimentFromJson(j.dump(), "e.json", "/nowhere");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(experimentFromJson(experimentToJson(*read), "e.json", "/nowhere").value(), *read);
}

} // namespace
} // namespace bask
