#include "engine/protocols/program_lines.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace bask::test {
namespace {

struct BadLine {
    const char* line;
    const char* words; ///< in the error
};

const char* const kRobotState =
    R"({"id": 7, "seq": 12, "time": 4.2, "state": {"position": [0.1, -2e-3], "moving": true, "sure": false, "alarm": "door"}})";

} // namespace

TEST(ProgramLines, AreReadAsTheyAreDescribed) {
    const auto robot = parseProgramLine(kRobotState, ProgramRole::Robot);
    ASSERT_TRUE(robot) << describe(robot.error());
    EXPECT_EQ(robot->id, 7);
    EXPECT_EQ(robot->seq, 12);
    EXPECT_EQ(robot->time_s, 4.2);
    const auto& state = std::get<ProgramRobotState>(robot->what);
    EXPECT_EQ(state.position, (std::vector{0.1, -2e-3}));
    EXPECT_TRUE(state.isMoving);
    EXPECT_FALSE(state.isSure);
    EXPECT_EQ(state.alarm, "door");

    const auto channels = parseProgramLine(
        R"({"seq": 1, "time": 0, "state": {"temperatures": [300.5, null, 310, null], "age": 0.2,
            "faults": ["", "open", "short", ""], "uncertainties": [0.1, 0, 0, 0], "more": 1}})",
        ProgramRole::Thermometer);
    ASSERT_TRUE(channels) << describe(channels.error());
    EXPECT_FALSE(channels->id);
    EXPECT_EQ(channels->age_s, 0.2);
    const auto& told = std::get<std::vector<ProgramChannel>>(channels->what);
    EXPECT_EQ(told[0].temperature_K, 300.5);
    EXPECT_EQ(told[0].standardUncertainty_K, 0.1);
    EXPECT_EQ(told[1].fault, "open");
    EXPECT_FALSE(told[2].temperature_K) << "a number beside a fault is not believed";
    EXPECT_EQ(told[3].fault, "other") << "null without a reason";

    const auto hello = parseProgramLine(
        R"({"id": 1, "seq": 1, "time": 0.2, "hello": {"protocol": 1, "role": "robot", "name": "Ärm", "serial": "A",
            "axes": ["z", "x"], "moves": "velocity", "can_home": true, "limits": {"x": [-0.3, 0.2]}}})",
        ProgramRole::Robot);
    ASSERT_TRUE(hello) << describe(hello.error());
    const auto& what = std::get<ProgramHello>(hello->what);
    EXPECT_EQ(what.name, "Ärm");
    EXPECT_EQ(what.axes, (std::vector{2, 0}));
    EXPECT_TRUE(what.takesVelocities && what.canHome);
    EXPECT_EQ(what.limits[0], (std::array{-0.3, 0.2}));

    const auto unread =
        parseProgramLine(R"({"id": null, "seq": 3, "time": 1, "error": "no JSON"})", ProgramRole::Robot);
    ASSERT_TRUE(unread);
    EXPECT_EQ(std::get<ProgramRefusal>(unread->what).words, "no JSON");
}

// Catches a line that is used although it is not one of the protocol, and an error that does not say where.
TEST(ProgramLines, ThatAreNoneAreRefused) {
    for (
        const BadLine& bad : {
            BadLine{"", "empty"},
            BadLine{"hello", "JSON"},
            BadLine{"[]", "object"},
            BadLine{R"({"id": 1, "time": 1, "ok": true})", "seq"},
            BadLine{R"({"seq": 0, "time": 1, "state": {}})", "seq"},
            BadLine{R"({"seq": 1.5, "time": 1, "state": {}})", "seq"},
            BadLine{R"({"id": 1, "seq": 1, "ok": true})", "time"},
            BadLine{R"({"seq": 1, "time": "now", "state": {}})", "time"},
            BadLine{R"({"seq": 1, "time": 1})", "state, ok, error or hello"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "ok": true, "state": {}})", "one of them"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "ok": false})", "ok"},
            BadLine{R"({"seq": 1, "time": 1, "ok": true})", "id"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [], "moving": false, "sure": true}})",
                "position"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [NaN], "moving": false, "sure": true}})",
                "JSON"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [1e400], "moving": false, "sure": true}})",
                ""},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [250], "moving": false, "sure": true}})",
                "position[0]"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [0], "sure": true}})", "moving"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [0], "moving": 1, "sure": true}})",
                "moving"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "state": {"position": [0], "moving": true, "sure": true, "age": -1}})",
                "age"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "hello": {"protocol": 2, "role": "robot", "name": "a"}})",
                "protocol"},
            BadLine{
                R"({"id": 1, "seq": 1, "time": 1, "hello": {"protocol": 1, "role": "heater", "name": "a"}})",
                "role"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "hello": {"protocol": 1, "role": "robot", "name": "a",
                     "moves": "steps", "axes": ["x", "x"]}})",
                    "axes[1]"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "hello": {"protocol": 1, "role": "robot", "name": "a",
                     "moves": "steps", "axes": ["x"], "limits": {"x": [1, -1]}}})",
                    "limits.x"},
            BadLine{R"({"id": 1, "seq": 1, "time": 1, "hello": {"protocol": 1, "role": "robot",
                     "moves": "steps", "axes": ["x"]}})",
                    "name"},
        }) {
        const auto line = parseProgramLine(bad.line, ProgramRole::Robot);
        ASSERT_FALSE(line) << bad.line;
        EXPECT_NE(describe(line.error()).find(bad.words), std::string::npos)
            << bad.line << ": " << describe(line.error());
    }
    EXPECT_FALSE(parseProgramLine(R"({"seq": 1, "time": 1, "state": {"temperatures": [-5]}})",
                                  ProgramRole::Thermometer));
    EXPECT_FALSE(parseProgramLine(R"({"seq": 1, "time": 1, "state": {"temperatures": [5], "faults": []}})",
                                  ProgramRole::Thermometer));
    EXPECT_FALSE(
        parseProgramLine(R"({"seq": 1, "time": 1, "state": {"temperature": 300}})", ProgramRole::HeatSource));
}

// Catches a damaged line that crashes the reader, or is taken for one with a position that no robot has.
TEST(ProgramLines, OfAHundredThousandDamagedOnesNoneHarms) {
    std::mt19937_64 random(7);
    const std::string whole = kRobotState;
    int valid = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string line = whole;
        for (auto damages = 1 + random() % 4; damages > 0; --damages) {
            const auto at = static_cast<std::size_t>(random() % line.size());
            switch (random() % 4) {
            case 0:
                line[at] = static_cast<char>(random());
                break;
            case 1:
                line.erase(at, 1 + random() % 5);
                break;
            case 2:
                line.insert(at, line.substr(at, random() % 20));
                break;
            default:
                line[at] = "0123456789eE+-.,{}[]\":"[random() % 22];
            }
            if (line.empty())
                line = "x";
        }
        const auto read = parseProgramLine(line, ProgramRole::Robot);
        if (!read)
            continue;
        ++valid;
        EXPECT_GE(read->seq, 1);
        if (const auto* state = std::get_if<ProgramRobotState>(&read->what)) {
            for (const double position : state->position)
                EXPECT_LE(std::abs(position), 100.0) << line;
        }
    }
    EXPECT_GT(valid, 100) << "a digit for a digit is a valid line";
    EXPECT_LT(valid, 60000);
}

TEST(ProgramLines, OfBaskAreOneLineEach) {
    EXPECT_EQ(programHello(1, ProgramRole::HeatSource),
              "{\"id\":1,\"do\":\"hello\",\"protocol\":1,\"role\":\"heater\",\"dead_man\":1.0}\n");
    EXPECT_EQ(programRequest(2, "read"), "{\"id\":2,\"do\":\"read\"}\n");
    EXPECT_EQ(programVelocity(3, {0.01, -0.5}, 0.25),
              "{\"id\":3,\"do\":\"velocity\",\"rates\":[0.01,-0.5],\"valid_for\":0.25}\n");
    EXPECT_EQ(programStep(4, {0.125}, 0.5), "{\"id\":4,\"do\":\"step\",\"to\":[0.125],\"duration\":0.5}\n");
    EXPECT_EQ(programHeat(5, 500.0, 2.0),
              "{\"id\":5,\"do\":\"heat\",\"set_point\":500.0,\"valid_for\":2.0}\n");
}

} // namespace bask::test
