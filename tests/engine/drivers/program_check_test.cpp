// What `bask check-device` says of programs that break one rule each.

#include "engine/drivers/program_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace bask::test {
namespace {

struct BrokenRule {
    const char* defect;
    ProgramRole role;
    const char* words; ///< that name it
};

std::vector<std::string> brokenRules(const std::string& command, ProgramRole role) {
    std::vector<std::string> out;
    checkProgram(command, role, {}, [&](const ProgramFinding& finding) {
        if (finding.kind == ProgramFinding::Kind::Broken)
            out.push_back(finding.words);
    });
    return out;
}

std::string broken(const char* defect, ProgramRole role) {
    return std::string("python3 " BASK_BROKEN_PROGRAM " \"") + defect + "\" " + programRoleWord(role);
}

void expectNamed(std::initializer_list<BrokenRule> rules) {
    for (const BrokenRule& rule : rules) {
        const std::vector<std::string> found = brokenRules(broken(rule.defect, rule.role), rule.role);
        EXPECT_TRUE(std::ranges::any_of(
            found, [&](const std::string& words) { return words.find(rule.words) != std::string::npos; }))
            << rule.defect << ": " << testing::PrintToString(found);
    }
}

} // namespace

// Each catches defects that a laboratory would meet before a hot plate. In parts, since they mostly wait.
TEST(ProgramCheck, NamesDefectsOfHelloAndLines) {
    expectNamed({BrokenRule{"exits", ProgramRole::Robot, "no such port: /dev/arm"},
                 BrokenRule{"no hello", ProgramRole::Robot, "does not answer hello"},
                 BrokenRule{"protocol", ProgramRole::Robot, "protocol"},
                 BrokenRule{"role", ProgramRole::Robot, "role"},
                 BrokenRule{"id", ProgramRole::Robot, "with its own id"},
                 BrokenRule{"not finite", ProgramRole::Robot, "NaN"},
                 BrokenRule{"hangs", ProgramRole::Robot, "does not answer read"},
                 BrokenRule{"crashes", ProgramRole::Robot, "has ended"},
                 BrokenRule{"babbles", ProgramRole::Robot, "KiB within a second"},
                 BrokenRule{"long line", ProgramRole::Robot, "KiB within a second"}});
}

TEST(ProgramCheck, NamesDefectsOfAnswers) {
    expectNamed({BrokenRule{"prints", ProgramRole::Robot, "\"position: 0.0\" is no line of the protocol"},
                 BrokenRule{"seq", ProgramRole::Robot, "(seq) comes instead of line 9"},
                 BrokenRule{"clock", ProgramRole::Robot, "its time is off by"},
                 BrokenRule{"slow", ProgramRole::Robot, "read a slow device in the background"},
                 BrokenRule{"unknown request", ProgramRole::Robot, "unknown request"}});
}

TEST(ProgramCheck, NamesDefectsOfMotion) {
    expectNamed({BrokenRule{"millimetres", ProgramRole::Robot, "check the units"},
                 BrokenRule{"sign", ProgramRole::Robot, "the sign"},
                 BrokenRule{"never moving", ProgramRole::Robot, "\"moving\" stays false"},
                 BrokenRule{"always moving", ProgramRole::Robot, "\"moving\" stays true"}});
}

TEST(ProgramCheck, NamesDefectsOfStops) {
    expectNamed({BrokenRule{"valid_for", ProgramRole::Robot, "when valid_for is over"},
                 BrokenRule{"stop", ProgramRole::Robot, "does not stand after stop"},
                 BrokenRule{"dead-man", ProgramRole::Robot, "(dead-man rule): stop"},
                 BrokenRule{"dead-man", ProgramRole::HeatSource, "(dead-man rule): switch off"}});
}

TEST(ProgramCheck, NamesDefectsOfHeatAndEnd) {
    expectNamed({BrokenRule{"off", ProgramRole::HeatSource, "heats on after off"},
                 BrokenRule{"max_temperature", ProgramRole::HeatSource, "above max_temperature"},
                 BrokenRule{"end of input", ProgramRole::HeatSource, "the end of its input"},
                 BrokenRule{"deaf to signals", ProgramRole::HeatSource, "the end of its input"}});
}

// Catches a check that finds fault with a program that has none.
TEST(ProgramCheck, FindsNothingInTheShippedOnes) {
    const std::string folder = testing::TempDir() + "check_world";
    for (const auto& [role, moves] : {std::pair{ProgramRole::Robot, "velocity"},
                                      {ProgramRole::Robot, "steps"},
                                      {ProgramRole::Thermometer, "steps"},
                                      {ProgramRole::HeatSource, "steps"}}) {
        const std::vector<std::string> found =
            brokenRules(std::string("python3 " BASK_PROGRAM_DRIVERS "/simulated_devices.py --role ") +
                            programRoleWord(role) + " --moves " + moves + " --world " + folder +
                            " --experiment " BASK_TEST_DATA "/rig/three-thin-disks.json",
                        role);
        EXPECT_TRUE(found.empty()) << programRoleWord(role) << ": " << testing::PrintToString(found);
    }
}

} // namespace bask::test
