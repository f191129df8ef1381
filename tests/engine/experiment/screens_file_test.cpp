// Fixtures and shields in experiment files: round trips, and what is refused.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <limits>

namespace bask {
namespace {

using nlohmann::json;

constexpr const char* kArm =
    R"({"name": "arm", "contour": {"type": "polygon", "points_m": [[0, 0], [0.02, 0], [0.02, 0.01], [0, 0.01]]},
        "mounting": {"z_cm": -1.5, "theta_x_deg": 10}})";
constexpr const char* kScreen =
    R"({"name": "screen", "contour": {"type": "disk", "radius_m": 0.03}, "pose": {"x_cm": 4, "z_cm": 1}})";

json withScreens(const std::string& fixtures, const std::string& shields) {
    json j = json::parse(experimentToJson(test::twoDisks()));
    if (!fixtures.empty())
        j["fixtures"] = json::parse(fixtures);
    if (!shields.empty())
        j["shields"] = json::parse(shields);
    return j;
}

Error refusedScreens(const json& j) {
    const auto read = experimentFromJson(j.dump(), "e.json", "/nowhere");
    EXPECT_FALSE(read) << j.dump();
    return read ? Error() : read.error();
}

} // namespace

// Catches a pose that is lost or moved to the centroid, and keys in files that have no plates.
TEST(ScreensFile, PlatesStayWhereTheyAreWritten) {
    EXPECT_EQ(experimentToJson(test::twoDisks()).find("fixtures"), std::string::npos);
    EXPECT_EQ(experimentToJson(test::twoDisks()).find("shields"), std::string::npos);
    const std::string text =
        withScreens(std::string("[") + kArm + "]", std::string("[") + kScreen + "]").dump();
    const auto read = experimentFromJson(text, "e.json", "");
    ASSERT_TRUE(read) << describe(read.error());
    ASSERT_EQ(read->fixtures.size(), 1U);
    EXPECT_EQ(shapeOutline(read->fixtures[0].shape, 4)[2], Eigen::Vector2d(0.02, 0.01));
    EXPECT_NEAR(read->fixtures[0].pose[kZ], -0.015, 1e-12);
    ASSERT_EQ(read->shields.size(), 1U);
    EXPECT_EQ(read->shields[0].name, "screen");
    EXPECT_NEAR(read->shields[0].pose[kX], 0.04, 1e-12);
    const auto again = experimentFromJson(experimentToJson(*read), "e.json", "");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, *read);
    EXPECT_EQ(experimentToJson(*again), experimentToJson(*read));
}

TEST(ScreensFile, RefusesBadPlatesWithTheirPlace) {
    struct Bad {
        const char *fixtures, *shields;
        MessageCode code;
        const char* where;
    };
    using enum MessageCode;
    const std::string disk = R"("contour": {"type": "disk", "radius_m": 0.01})";
    const auto list = [&](const std::string& inside) { return "[{" + inside + "}]"; };
    const std::string noName = list(disk + R"(, "mounting": {})");
    const std::string blank = list(R"("name": " ", )" + disk + R"(, "mounting": {})");
    const std::string asObject =
        list(R"("name": ")" + test::twoDisks().objects[0].name + R"(", )" + disk + R"(, "mounting": {})");
    const std::string twice = list(R"("name": "arm", )" + disk + R"(, "pose": {"z_cm": 1})");
    const std::string noPose = list(R"("name": "a", )" + disk);
    const std::string posed = list(R"("name": "a", )" + disk + R"(, "pose": {})");
    const std::string tooFar = list(R"("name": "a", )" + disk + R"(, "mounting": {"x_cm": 101})");
    const std::string noArea =
        list(R"("name": "a", "contour": {"type": "disk", "radius_m": 0}, "mounting": {})");
    const std::string under = list(R"("name": "a", )" + disk + R"(, "pose": {"z_cm": -1})");
    const std::string through =
        list(R"("name": "a", )" + disk + R"(, "pose": {"z_cm": 0.5, "theta_x_deg": 60})");
    const std::string high = list(R"("name": "a", )" + disk + R"(, "pose": {"x_cm": 40, "z_cm": 40})");
    const std::string low = list(R"("name": "a", )" + disk + R"(, "mounting": {"z_cm": -60})");
    const std::string arm = std::string("[") + kArm + "]";
    for (const Bad& bad : {Bad{noName.c_str(), "", JsonMissingKey, "fixtures[0]"},
                           Bad{blank.c_str(), "", NameEmpty, "fixtures[0].name"},
                           Bad{asObject.c_str(), "", DuplicateName, "fixtures[0].name"},
                           Bad{arm.c_str(), twice.c_str(), DuplicateName, "shields[0].name"},
                           Bad{noPose.c_str(), "", JsonMissingKey, "fixtures[0]"},
                           Bad{posed.c_str(), "", JsonUnknownKey, "fixtures[0]"},
                           Bad{tooFar.c_str(), "", ValueOutOfRange, "fixtures[0].mounting.x_cm"},
                           Bad{noArea.c_str(), "", ValueNotPositive, "fixtures[0].contour.radius_m"},
                           Bad{"{}", "", JsonWrongType, "fixtures"},
                           Bad{"[1,2,3,4,5,6,7,8,9]", "", ValueOutOfRange, "fixtures"},
                           Bad{"", under.c_str(), ShieldBelowSource, "shields[0].pose"},
                           Bad{"", through.c_str(), ShieldBelowSource, "shields[0].pose"},
                           Bad{"", high.c_str(), StartTooCloseToShield, "robot.start"},
                           Bad{low.c_str(), "", StartTooClose, "robot.start"}}) {
        const std::string given = std::string(bad.fixtures) + bad.shields;
        const Error error = refusedScreens(withScreens(bad.fixtures, bad.shields));
        EXPECT_EQ(error.code(), bad.code) << given << ": " << describe(error);
        EXPECT_EQ(error.where.rfind(std::string("e.json: ") + bad.where, 0), 0U) << error.where;
    }
    Experiment experiment = test::twoDisks();
    experiment.shields.push_back({"screen", Disk{0.01}});
    experiment.shields[0].pose[kZ] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(validate(experiment).error().where, "shields[0].pose.z_cm");

    // A source that comes up to a shield later is refused, too.
    experiment.shields[0].pose[kZ] = 0.01;
    EXPECT_TRUE(validate(experiment));
    Vector6d up = experiment.source.pose;
    up[kZ] += 0.02;
    experiment.simulation.sourceMotion = {{0.0, experiment.source.pose}, {10.0, up}};
    EXPECT_EQ(validate(experiment).error().code(), ShieldBelowSource);
}

} // namespace bask
