// `bask run --recipe` as a script sees it.

#include "app/commands/command_line.h"
#include "engine/recipe/recipe.h"
#include "engine/recording/session_file.h"
#include "tests/support/captured_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <fstream>
#include <sstream>

namespace bask {
namespace {

const QString kShipped = QStringLiteral(BASK_EXAMPLES "/recipes/two-circles-by-degrees.json");

struct RecipeCommand : testing::Test {
    QTemporaryDir folder;
    QString path = folder.filePath("recipe.json");

    void write(const std::string& steps) {
        std::ofstream(path.toStdString())
            << R"({"format": "bask-recipe", "version": 1, "steps": [)" + steps + "]}";
    }
    test::Captured run(const QStringList& arguments) {
        return test::captured(runExperimentCommand, arguments);
    }
    test::Captured run() { return run({"--recipe", path}); }
};

} // namespace

// Catches: two objects in one place run as if that could be built, alone or as a step of a recipe; and two
// that only touch refused.
TEST_F(RecipeCommand, objectsThroughEachOtherAreRefusedBeforeAnythingRuns) {
    const std::string experiment = folder.filePath("experiment.json").toStdString();
    const auto place = [&](double y_cm, double lean_deg) {
        std::ifstream example(BASK_EXAMPLES "/two-circles.json");
        auto json = nlohmann::json::parse(example);
        json["objects"][1]["mounting"] = {{"x_cm", 0}, {"y_cm", y_cm}, {"theta_y_deg", lean_deg}};
        std::ofstream(experiment) << json;
    };
    write(R"({"run": "experiment.json", "until": {"time_s": 5}})");
    const QStringList alone{QString::fromStdString(experiment), "--duration", "5"};
    const std::string reason = "objects[1].mounting: left and right overlap; move one of them";
    for (const double lean_deg : {0.0, 90.0}) {
        place(4.0, lean_deg);
        const auto one = run(alone), step = run();
        EXPECT_EQ(one.code, kExitBadInput) << one.err;
        EXPECT_EQ(one.err, "bask run: " + reason + '\n');
        EXPECT_EQ(one.out, "");
        EXPECT_EQ(step.code, kExitBadInput) << step.err;
        EXPECT_NE(step.err.find("steps[0].run: " + reason), std::string::npos) << step.err;
    }
    place(1.0, 0.0); // edge on edge
    EXPECT_EQ(run(alone).code, kExitNegative);
    EXPECT_NE(run().code, kExitBadInput);
}

// Catches: the shipped recipe that does not get through, sessions that are not there or are of other steps.
TEST_F(RecipeCommand, theShippedRecipeGetsThrough) {
    const QString out = folder.filePath("made/here"), summaryPath = folder.filePath("summary.json");
    const auto done = run({"--recipe", kShipped, "--out", out, "--summary", summaryPath});
    ASSERT_EQ(done.code, kExitDone) << done.err << done.out;
    EXPECT_NE(done.err.find("5 steps, at most 5040 s"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("step 2 of 5: done after"), std::string::npos) << done.err;
    EXPECT_NE(done.out.find("recipe: done after"), std::string::npos) << done.out;
    EXPECT_EQ(QDir(out).entryList({"*"}, QDir::Files, QDir::Name),
              (QStringList{"01-two-circles.bask", "04-two-circles.bask", "05-three-objects.bask"}));
    const auto last = readSession(out.toStdString() + "/05-three-objects.bask");
    ASSERT_TRUE(last);
    EXPECT_EQ(last->experiment.objects.size(), 3u);
    EXPECT_FALSE(last->interrupted());
    std::ifstream file(summaryPath.toStdString());
    const auto summary = nlohmann::json::parse(file);
    ASSERT_EQ(summary["steps"].size(), 5u);
    EXPECT_EQ(summary["outcome"], "done");
    EXPECT_EQ(summary["steps"][1]["session"], nullptr);
    EXPECT_EQ(summary["steps"][4]["elapsed_s"], 180.0);
}

// Catches: recordings of an earlier time that are lost to the same command, or a file that is in the way of a
// late step and found hours later.
TEST_F(RecipeCommand, nothingThatIsThereIsRecordedOver) {
    write(R"({"run_example": "two-circles", "until": {"time_s": 5}}, {"wait": {"time_s": 1}},
             {"run_example": "two-circles", "until": {"time_s": 5}})");
    const QString out = folder.filePath("out");
    ASSERT_EQ(run({"--recipe", path, "--out", out}).code, kExitDone);
    const QString first = out + "/01-two-circles.bask", last = out + "/03-two-circles.bask";
    const auto bytesOf = [](const QString& name) {
        QFile file(name);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before = bytesOf(first);
    ASSERT_FALSE(before.isEmpty());
    const auto expectRefused = [&](const QString& inTheWay) {
        const auto done = run({"--recipe", path, "--out", out});
        EXPECT_EQ(done.code, kExitBadInput);
        EXPECT_EQ(done.out, "");
        EXPECT_NE(done.err.find(inTheWay.toStdString() + ": it is there already"), std::string::npos)
            << done.err;
        EXPECT_EQ(done.err.find("at most"), std::string::npos) << "it has begun: " << done.err;
    };
    expectRefused(first);
    EXPECT_EQ(bytesOf(first), before);
    ASSERT_TRUE(QFile::remove(first));
    expectRefused(last);
    EXPECT_FALSE(QFile::exists(first));
    // Of another kind.
    ASSERT_TRUE(QFile::remove(last));
    std::ofstream(last.toStdString()) << "notes";
    expectRefused(last);
    EXPECT_EQ(bytesOf(last), "notes");
    EXPECT_EQ(run({"--recipe", path, "--out", folder.filePath("other")}).code, kExitDone);
}

TEST_F(RecipeCommand, exitCodesTellHowItEnded) {
    write(R"({"run_example": "two-circles", "until": {"object": "left", "above_degC": 110}, "at_most_s": 20,
              "otherwise": "next"},
             {"run_example": "two-circles", "until": {"time_s": 5}})");
    auto done = run();
    EXPECT_EQ(done.code, kExitNegative);
    EXPECT_NE(done.err.find("step 1 of 2: not reached after 20 s"), std::string::npos) << done.err;
    EXPECT_NE(done.err.find("step 2 of 2: done after 5 s"), std::string::npos) << done.err;
    EXPECT_NE(done.out.find("recipe: not all steps done"), std::string::npos) << done.out;

    QFile example(QStringLiteral(BASK_EXAMPLES "/two-circles.json"));
    ASSERT_TRUE(example.open(QIODevice::ReadOnly));
    auto experiment = nlohmann::json::parse(example.readAll().toStdString());
    experiment["simulation"]["faults"] = {{{"time_s", 5}, {"fault", "sensor-lost"}, {"object", 0}}};
    std::ofstream(folder.filePath("lost.json").toStdString()) << experiment.dump();
    write(R"({"run": "lost.json", "until": {"time_s": 60}, "otherwise": "next"},
             {"run_example": "two-circles", "until": {"time_s": 5}})");
    done = run();
    EXPECT_EQ(done.code, kExitFault) << done.err;
    EXPECT_NE(done.err.find("step 1 of 2: failed after"), std::string::npos) << done.err;
    EXPECT_NE(done.out.find("not begun"), std::string::npos) << done.out;
}

TEST_F(RecipeCommand, refusesWhatCannotBeRunBeforeItBegins) {
    const auto refused = [this](const QStringList& arguments, const std::string& words) {
        const auto done = run(arguments);
        EXPECT_EQ(done.code, kExitBadInput) << done.err;
        EXPECT_NE(done.err.find(words), std::string::npos) << done.err;
        EXPECT_EQ(done.out, "");
    };
    write(
        R"({"run_example": "two-circles", "until": {"time_s": 5}}, {"run": "none.json", "until": {"time_s": 5}})");
    refused({"--recipe", path}, "recipe.json: steps[1].run: ");
    refused({"--recipe", path + "x"}, "there is no such file");
    write(R"({"run_example": "no-such", "until": {"time_s": 5}})");
    refused({"--recipe", path}, "steps[0].run_example: \"no-such\" is not known; known: three-objects, ");
    write(R"({"run_example": "two-circles", "until": {"time_s": 5}})");
    refused({"--recipe", path, "--live"}, "steps[0]");
    refused({"--recipe", path, "--targets", "40,40"}, "--targets is not for recipes");
    refused({"--recipe", path, "-o", folder.filePath("a.bask")}, "-o is not for recipes");
    refused({"--recipe", path, "--out", path}, "the folder cannot be made");
    refused({"--recipe", path, "--summary", path}, path.toStdString());
    refused({"--recipe", path, "other.json"}, "0 arguments expected, 1 given");
    refused({path, "--out", folder.path()}, "--out is for recipes");
    refused({"--recipe", ""}, "--recipe: the name is empty");
    refused({path}, "format"); // no experiment
}

// Catches a file that brings limits to a real rig which nobody was asked about.
TEST_F(RecipeCommand, looserLimitsOfARealRigAreRefusedUnasked) {
    std::ifstream data(BASK_TEST_DATA "/rig/three-thin-disks.json");
    std::stringstream text;
    text << data.rdbuf();
    const QString experiment = folder.filePath("rig.json");
    std::ofstream(experiment.toStdString()) << text.str();
    write(R"({"run": "rig.json", "until": {"time_s": 5}})");
    for (const QStringList& arguments :
         {QStringList{"--recipe", path, "--live"}, QStringList{experiment, "--live"}}) {
        const auto done = run(arguments);
        EXPECT_EQ(done.code, kExitBadInput) << done.err;
        EXPECT_NE(done.err.find("Largest turning speed: 0.2 rad/s instead of 0.1 rad/s"), std::string::npos)
            << done.err;
        EXPECT_NE(done.err.find("--accept-limits"), std::string::npos) << done.err;
    }
}

} // namespace bask
