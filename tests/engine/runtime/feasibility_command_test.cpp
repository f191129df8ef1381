// bask feasibility as a script uses it: exit code, summary, words.

#include "app/commands/command_line.h"
#include "tests/support/captured_command.h"

#include <QFile>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <regex>

namespace bask::test {
namespace {

using nlohmann::json;

const QString kTriangle = QStringLiteral(BASK_EXAMPLES "/three-objects.json");
const QString kLine = QStringLiteral(BASK_EXAMPLES "/three-objects-in-line.json");

Captured feasibility(const QStringList& arguments) {
    return captured(feasibilityCommand, arguments);
}

class FeasibilityCommand : public testing::Test {
protected:
    QString file(const char* name) const { return m_folder.filePath(QLatin1String(name)); }

    json summaryOf(const QStringList& arguments, int exitCode) const {
        const QString path = file("summary.json");
        const Captured answer = feasibility(arguments + QStringList{"--summary", path});
        EXPECT_EQ(answer.code, exitCode) << answer.err;
        QFile read(path);
        EXPECT_TRUE(read.open(QIODevice::ReadOnly));
        return json::parse(read.readAll().toStdString());
    }

    QTemporaryDir m_folder;
};

// Catches: a shade that counts in the answer and is not told in it.
TEST_F(FeasibilityCommand, WhoShadesWhomIsInTheAnswer) {
    QFile example(QStringLiteral(BASK_EXAMPLES "/two-circles.json")), stacked(file("stacked.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly) && stacked.open(QIODevice::WriteOnly));
    json experiment = json::parse(example.readAll().toStdString());
    experiment["objects"][1]["mounting"] = json::parse(R"({"x_cm": 0, "y_cm": 3, "z_cm": 4})");
    stacked.write(QByteArray::fromStdString(experiment.dump()));
    stacked.close();
    const Captured answer = feasibility({file("stacked.json"), "--summary", file("summary.json")});
    const std::regex sentence(R"(shade: left takes \d+(\.\d)? % of the light of right at the start pose\n)");
    EXPECT_TRUE(std::regex_search(answer.out, sentence)) << answer.out;
    EXPECT_NE(answer.out.find(" % of the light of right at this pose\n"), std::string::npos) << answer.out;
    QFile written(file("summary.json"));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    const json summary = json::parse(written.readAll().toStdString());
    for (const char* key : {"shade_at_start", "shade_at_pose"}) {
        ASSERT_EQ(summary[key].size(), 1u) << key;
        EXPECT_EQ(summary[key][0]["object"], "right");
        EXPECT_EQ(summary[key][0]["taken_by"], "left");
        EXPECT_GE(summary[key][0]["share"].get<double>(), 0.005);
        EXPECT_LE(summary[key][0]["share"].get<double>(), 1.0);
    }
}

// Catches: two objects in one place, or through each other, told to be feasible; and two of which one only
// shades the other refused.
TEST_F(FeasibilityCommand, WhatNobodyCanBuildIsRefusedWithItsPlace) {
    const auto answerWith = [&](const char* mounting) {
        QFile example(QStringLiteral(BASK_EXAMPLES "/two-circles.json")), damaged(file("damaged.json"));
        EXPECT_TRUE(example.open(QIODevice::ReadOnly) && damaged.open(QIODevice::WriteOnly));
        json experiment = json::parse(example.readAll().toStdString());
        experiment["objects"][1]["mounting"] = json::parse(mounting);
        damaged.write(QByteArray::fromStdString(experiment.dump()));
        damaged.close();
        return feasibility({file("damaged.json"), "--targets", "45,44"});
    };
    const std::string reason = "objects[1].mounting: left and right overlap; move one of them";
    for (const char* mounting :
         {R"({"x_cm": 0, "y_cm": 4})", R"({"x_cm": 0, "y_cm": 4, "theta_x_deg": 90})"}) {
        const Captured answer = answerWith(mounting);
        EXPECT_EQ(answer.code, kExitBadInput) << mounting;
        EXPECT_NE(answer.err.find(reason), std::string::npos) << answer.err;
        EXPECT_EQ(answer.out, "not feasible: " + reason + '\n');
    }
    for (const char* mounting : {R"({"x_cm": 0, "y_cm": -4})", R"({"x_cm": 0, "y_cm": 3, "z_cm": 4})"}) {
        const Captured answer = answerWith(mounting);
        EXPECT_NE(answer.code, kExitBadInput) << answer.err;
        EXPECT_EQ(answer.err.find("overlap"), std::string::npos) << answer.err;
    }
}

// Catches: an overlap in one plane that only the window tells; the paper's own example.
TEST_F(FeasibilityCommand, AnOverlapInOnePlaneIsToldEverywhere) {
    const QString paper = QStringLiteral(BASK_EXAMPLES "/paper/unfeasible-isosurfaces-30-30.json");
    const std::string told = "small and large overlap; move one of them";
    const Captured answer = feasibility({paper});
    EXPECT_EQ(answer.code, 0);
    EXPECT_EQ(answer.err, "bask feasibility: " + told + '\n');
    EXPECT_EQ(answer.out.find(told), 0u) << answer.out;
    EXPECT_EQ(summaryOf({paper}, 0)["remarks"], json({told}));
    EXPECT_EQ(summaryOf({kTriangle, "--targets", "45,42,40"}, 0)["remarks"], json::array());
}

// Catches: a solution whose pose, margin or predicted time is missing or in other units.
TEST_F(FeasibilityCommand, FeasibleTargetsComeWithAPoseAndATime) {
    const json summary = summaryOf({kTriangle, "--targets", "45,42,40"}, 0);
    EXPECT_EQ(summary["feasible"], true);
    EXPECT_EQ(summary["reason"], "");
    for (const json& residual : summary["residual_K"])
        EXPECT_NEAR(residual.get<double>(), 0.0, 0.05);
    EXPECT_EQ(summary["residual_K"].size(), 3U);
    EXPECT_GE(summary["pose"]["z_cm"].get<double>(), 1.0);
    EXPECT_LE(summary["pose"]["z_cm"].get<double>(), 30.0);
    EXPECT_LE(std::abs(summary["pose"]["theta_x_deg"].get<double>()), 35.0);
    EXPECT_EQ(summary["pose"]["theta_y_deg"], 0.0);
    EXPECT_GT(summary["margin"]["distance_cm"].get<double>(), 1.0);
    EXPECT_LT(summary["margin"]["distance_cm"].get<double>(), 20.0);
    EXPECT_GT(summary["margin"]["smallest_singular_value_K_cm"].get<double>(), 0.1);
    EXPECT_GT(summary["predicted_time_s"].get<double>(), 20.0);
    EXPECT_EQ(summary["nearest_feasible_C"], json({45.0, 42.0, 40.0}));
    for (const char* condition : {"condition1", "condition2"})
        for (const json& row : summary[condition])
            EXPECT_EQ(row["holds"], true);
}

// Catches: a negative verdict with a positive exit code; a source model that is not used.
TEST_F(FeasibilityCommand, TooHotForThePapersSourceButNotForAGrayOne) {
    const json summary = summaryOf({kTriangle, "--targets", "70,35,35", "--source-model", "paper"}, 3);
    EXPECT_EQ(summary["feasible"], false);
    EXPECT_NE(summary["reason"].get<std::string>().find("61.4"), std::string::npos);
    EXPECT_EQ(summary["condition1"][0]["holds"], false);
    EXPECT_EQ(summary["condition1"][1]["holds"], true);
    EXPECT_EQ(summary["predicted_time_s"], nullptr);
    EXPECT_EQ(feasibility({kTriangle, "--targets", "70,35,35"}).code, 0);
}

// Catches: nearest targets that do not keep what they are told to, or that the command itself refuses.
TEST_F(FeasibilityCommand, NearestTargetsKeepTheHeldOneAndAreFeasible) {
    const json summary = summaryOf({kLine, "--targets", "45,45,45", "--hold", "bunny", "--hold", "hand"}, 3);
    EXPECT_EQ(summary["held_kept"], true);
    EXPECT_GT(summary["surface_gap_cm"].get<double>(), 0.5);
    std::vector<double> nearest = summary["nearest_feasible_C"];
    QStringList typed;
    for (const double target_C : nearest)
        typed << QString::number(target_C, 'f', 1);
    EXPECT_EQ(nearest[1], 45.0);
    EXPECT_EQ(nearest[2], 45.0);
    EXPECT_NE(nearest[0], 45.0);
    EXPECT_EQ(feasibility({kLine, "--targets", typed.join(',')}).code, 0) << typed.join(',').toStdString();
}

// Catches: a table without the objects, or without the reason, on standard output.
TEST_F(FeasibilityCommand, SaysItInWords) {
    const Captured answer = feasibility({kLine, "--targets", "45,45,45"});
    EXPECT_EQ(answer.code, 3);
    EXPECT_TRUE(answer.err.empty()) << answer.err;
    for (const char* words :
         {"circle", "bunny - hand", "best compromise:", "not feasible: each target can be"})
        EXPECT_NE(answer.out.find(words), std::string::npos) << words << '\n' << answer.out;
}

// Catches: a pair without its map, or a map without the cell that the target lies in; and another's file lost
// to it.
TEST_F(FeasibilityCommand, WritesWhichPairsAreReachable) {
    const QString folder = file("maps");
    const QStringList arguments{kTriangle, "--targets", "45,42,40", "--reachable", folder};
    ASSERT_EQ(feasibility(arguments).code, 0);
    ASSERT_EQ(feasibility(arguments).code, 0) << "over its own";
    for (const char* name : {"/reachable-1-2.csv", "/reachable-1-3.csv", "/reachable-2-3.csv"}) {
        QFile map(folder + name);
        ASSERT_TRUE(map.open(QIODevice::ReadOnly));
        const QByteArray text = map.readAll();
        EXPECT_TRUE(text.contains("a pose holds it"));
        EXPECT_EQ(text.count(",1\n") + text.count(",0\n"), 48 * 48);
        EXPECT_GT(text.count(",1\n"), 300);
    }
    QFile other(folder + "/reachable-1-3.csv");
    ASSERT_TRUE(other.open(QIODevice::WriteOnly));
    other.write("my notes");
    other.close();
    EXPECT_EQ(feasibility(arguments).code, 2);
}

// Catches: bad input that is taken, and a file of the user's that is lost to the summary.
TEST_F(FeasibilityCommand, RefusesBadInput) {
    const QString experiment = file("e.json");
    ASSERT_TRUE(QFile::copy(QStringLiteral(BASK_EXAMPLES "/two-circles.json"), experiment));
    QFile::setPermissions(experiment, QFile::ReadOwner | QFile::WriteOwner);
    for (const QStringList& arguments : {QStringList{},
                                         {file("gone.json")},
                                         {experiment, "--targets", "40"},
                                         {experiment, "--targets", "40,warm"},
                                         {experiment, "--source-model", "black"},
                                         {experiment, "--hold", "nobody"},
                                         {experiment, "--summary", experiment},
                                         {experiment, "--summary", file("gone/s.json")}}) {
        const Captured answer = feasibility(arguments);
        EXPECT_EQ(answer.code, 2) << arguments.join(' ').toStdString();
        EXPECT_FALSE(answer.err.empty());
        EXPECT_TRUE(answer.out.empty());
    }
    EXPECT_EQ(QFile(experiment).size(), QFile(QStringLiteral(BASK_EXAMPLES "/two-circles.json")).size());
}

} // namespace
} // namespace bask::test
