// Recipes as files: they survive them, and damage is told where it is.

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recipe/recipe.h"

#include <QDir>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

namespace bask {
namespace {

using Until = RecipeStep::Until;

RecipeStep step(Until until) {
    RecipeStep made;
    made.until = until;
    made.object = until == Until::Above || until == Until::Below ? "left \"1\"" : "";
    made.temperature_K = until == Until::Above || until == Until::Below ? kelvinFromCelsius(41.7) : 303.15;
    made.maxDuration_s = until == Until::Time ? RecipeStep().maxDuration_s : 1234.5;
    made.duration_s = until == Until::Time || until == Until::Settled ? 12.25 : RecipeStep().duration_s;
    return made;
}

struct RecipeFile : testing::Test {
    QTemporaryDir folder;
    std::string path = folder.filePath("recipe.json").toStdString();

    void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
    void writeSteps(const std::string& steps) {
        write(R"({"format": "bask-recipe", "version": 1, "steps": [)" + steps + "]}");
    }
    std::string text() {
        std::ifstream file(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Error refusal() {
        const auto read = readRecipe(path);
        return read ? Error() : read.error();
    }
    Recipe whole() {
        Recipe recipe;
        recipe.name = "n\u00e9o \"2\"";
        for (const Until until : {Until::Settled, Until::Time, Until::Above, Until::Below})
            recipe.steps.push_back(step(until));
        recipe.steps[0].experiment = folder.filePath("sub/a.json").toStdString();
        recipe.steps[1].experiment = "/somewhere/else.json";
        recipe.steps[2].example = "two-circles";
        recipe.steps[2].goesOn = true;
        return recipe;
    }
};

Result<Experiment> noExample(const std::string& name) {
    return Error(MessageCode::ValueUnknown, {}, {name, "none"});
}

} // namespace

// Catches a field that is written and not read, read and not written, or rounded.
TEST_F(RecipeFile, survivesItsFile) {
    for (const Recipe& recipe : {whole(), Recipe()}) {
        ASSERT_TRUE(writeRecipe(recipe, path));
        EXPECT_TRUE(isRecipeFile(path));
        const auto read = readRecipe(path);
        ASSERT_TRUE(read) << describe(read.error());
        EXPECT_EQ(*read, recipe);
    }
}

// Catches a folder of experiments that cannot be moved with its recipe.
TEST_F(RecipeFile, experimentsBesideItAreRelative) {
    ASSERT_TRUE(writeRecipe(whole(), path));
    EXPECT_NE(text().find("\"sub/a.json\""), std::string::npos) << text();
    EXPECT_NE(text().find("\"/somewhere/else.json\""), std::string::npos) << text();
    EXPECT_EQ(text().find(folder.path().toStdString()), std::string::npos) << text();
    const QString other = folder.filePath("moved");
    ASSERT_TRUE(QDir().mkpath(other));
    const std::string moved = other.toStdString() + "/recipe.json";
    std::ofstream(moved) << text();
    const auto read = readRecipe(moved);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->steps[0].experiment, other.toStdString() + "/sub/a.json");
}

TEST_F(RecipeFile, refusesWhatIsWrongAndSaysWhere) {
    struct Case {
        const char* step;
        MessageCode code;
        const char* place;
    };
    const Case cases[] = {
        {R"({})", MessageCode::JsonMissingKey, "steps[0]"},
        {R"(7)", MessageCode::JsonWrongType, "steps[0]"},
        {R"({"run": "a.json"})", MessageCode::JsonMissingKey, "steps[0]"},
        {R"({"run": "a.json", "until": {"time_s": 5}, "speed": 3})", MessageCode::JsonUnknownKey, "steps[0]"},
        {R"({"run": "", "until": {"time_s": 5}})", MessageCode::FileNotFound, "steps[0].run"},
        {R"({"run": 5, "until": {"time_s": 5}})", MessageCode::JsonWrongType, "steps[0].run"},
        {R"({"run": "a\u0000.json", "until": {"time_s": 5}})", MessageCode::NameNotPlain, "steps[0].run"},
        {R"({"run": "a.json", "run_example": "b", "until": {"time_s": 5}})", MessageCode::JsonUnknownKey,
         "steps[0]"},
        {R"({"run": "a.json", "wait": {"time_s": 5}})", MessageCode::JsonUnknownKey, "steps[0]"},
        {R"({"run_example": "a", "wait": {"time_s": 5}})", MessageCode::JsonUnknownKey, "steps[0]"},
        {R"({"run": "a.json", "until": {"settled_for_s": 5}})", MessageCode::JsonMissingKey, "steps[0]"},
        {R"({"run": "a.json", "until": {"settled_for_s": 50}, "at_most_s": 20})",
         MessageCode::ValueOutOfRange, "steps[0].until.settled_for_s"},
        {R"({"run": "a.json", "until": {"settled_for_s": 5, "time_s": 6}, "at_most_s": 20})",
         MessageCode::JsonUnknownKey, "steps[0].until"},
        {R"({"run": "a.json", "until": {}, "at_most_s": 20})", MessageCode::JsonMissingKey, "steps[0].until"},
        {R"({"run": "a.json", "until": {"time_min": 5}})", MessageCode::JsonUnknownKey, "steps[0].until"},
        {R"({"wait": {"time_s": -5}})", MessageCode::ValueOutOfRange, "steps[0].wait.time_s"},
        {R"({"wait": {"time_s": 1e300}})", MessageCode::ValueOutOfRange, "steps[0].wait.time_s"},
        {R"({"wait": {"time_s": 1e400}})", MessageCode::JsonSyntax, ""},
        {R"({"wait": {"time_s": NaN}})", MessageCode::JsonSyntax, ""},
        {R"({"wait": {"time_s": 5}, "at_most_s": 9})", MessageCode::JsonUnknownKey, "steps[0]"},
        {R"({"wait": {"settled_for_s": 5}, "at_most_s": 20})", MessageCode::ValueUnknown, "steps[0].wait"},
        {R"({"wait": {"below_degC": 30}, "at_most_s": 20})", MessageCode::JsonMissingKey, "steps[0].wait"},
        {R"({"wait": {"object": "", "below_degC": 30}, "at_most_s": 20})", MessageCode::JsonMissingKey,
         "steps[0].wait"},
        {R"({"wait": {"object": "a", "below_degF": 90}, "at_most_s": 20})", MessageCode::JsonUnknownKey,
         "steps[0].wait"},
        {R"({"wait": {"object": "a", "below_K": 3}, "at_most_s": 20})", MessageCode::ValueOutOfRange,
         "steps[0].wait.below"},
        {R"({"wait": {"object": "a", "below_K": 300, "below_degC": 30}, "at_most_s": 20})",
         MessageCode::JsonTwoSpellings, "steps[0].wait"},
        {R"({"wait": {"object": "a", "below_K": 300}, "at_most_s": 0})", MessageCode::ValueOutOfRange,
         "steps[0].at_most_s"},
        {R"({"wait": {"time_s": 5}, "otherwise": "repeat"})", MessageCode::ValueUnknown,
         "steps[0].otherwise"},
    };
    for (const Case& each : cases) {
        writeSteps(each.step);
        const Error error = refusal();
        EXPECT_EQ(messageName(error.code()), std::string(messageName(each.code)))
            << each.step << describe(error);
        EXPECT_EQ(error.where, path + (*each.place ? std::string(": ") + each.place : "")) << each.step;
    }
}

TEST_F(RecipeFile, refusesDamagedEmptyForeignAndHugeFiles) {
    const auto code = [this](const std::string& text) {
        write(text);
        return refusal().code();
    };
    EXPECT_EQ(code(""), MessageCode::FileEmpty);
    EXPECT_EQ(code(" \n"), MessageCode::FileEmpty);
    EXPECT_EQ(code("{"), MessageCode::JsonSyntax);
    EXPECT_EQ(code(std::string("\0\xff\xfe", 3)), MessageCode::JsonSyntax);
    EXPECT_EQ(code("[]"), MessageCode::JsonWrongType);
    EXPECT_EQ(code(std::string(100000, '[')), MessageCode::JsonTooDeep);
    EXPECT_EQ(code(R"({"format": "bask-rig", "version": 1, "steps": []})"), MessageCode::ValueUnknown);
    EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 2, "steps": []})"), MessageCode::VersionTooNew);
    EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 0, "steps": []})"), MessageCode::ValueOutOfRange);
    EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 1})"), MessageCode::JsonMissingKey);
    EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 1, "steps": {}})"), MessageCode::JsonWrongType);
    for (const char* name : {R"(a\u001b[31m)", R"(a\u202eb)", R"(a\u200b)", " a"}) {
        EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 1, "name": ")" + std::string(name) +
                       R"(", "steps": []})"),
                  MessageCode::NameNotPlain);
        EXPECT_EQ(refusal().where, path + ": name");
    }
    EXPECT_EQ(code(R"({"format": "bask-recipe", "version": 1, "steps": [], "steps": []})"),
              MessageCode::JsonDuplicateKey);
    std::string steps = "{}";
    for (int i = 0; i < 100000; ++i)
        steps += ",{}";
    writeSteps(steps);
    EXPECT_EQ(refusal().where, path + ": steps");
    EXPECT_EQ(refusal().code(), MessageCode::ValueOutOfRange);
    for (int i = 0; i < 900000; ++i)
        steps += ",{}";
    writeSteps(steps);
    EXPECT_EQ(refusal().code(), MessageCode::FileTooLarge);
    EXPECT_EQ(readRecipe(folder.path().toStdString()).error().code(), MessageCode::FileUnreadable);
    EXPECT_EQ(readRecipe(path + "x").error().code(), MessageCode::FileNotFound);
    EXPECT_FALSE(isRecipeFile(path + "x"));
}

// Catches a document that tells another key or range than the program has.
TEST_F(RecipeFile, theDocumentHasItsNumbers) {
    std::ifstream file(BASK_DOCS "/experiment-format.md");
    const std::string document{std::istreambuf_iterator<char>(file), {}};
    const auto expectRow = [&](const ParameterFacts& facts, const std::string& max) {
        std::istringstream lines(document);
        bool isTold = false;
        for (std::string line; std::getline(lines, line);)
            isTold = isTold ||
                     (line.starts_with("| ") && line.find('`' + keyOf(facts) + '`') != std::string::npos &&
                      line.find(' ' + formatNumber(facts.range.min) + " to " + max) != std::string::npos);
        EXPECT_TRUE(isTold) << keyOf(facts);
    };
    expectRow(conditionParameters(Until::Settled).front(), "`at_most_s`");
    for (const Until until : {Until::Time, Until::Above, Until::Below}) {
        const ParameterFacts& facts = conditionParameters(until).front();
        expectRow(facts, until == Until::Time ? "1e7" : formatNumber(facts.range.max));
    }
    EXPECT_EQ(conditionParameters(Until::Time).front().range.max, 1e7);
    EXPECT_EQ(limitParameters(Until::Settled).front().range.max, 1e7);
    expectRow(limitParameters(Until::Settled).front(), "1e7");
    EXPECT_TRUE(limitParameters(Until::Time).empty());
}

// Catches a reader that throws or takes nonsense for sound.
TEST_F(RecipeFile, everyDamagedByteIsReadOrRefused) {
    ASSERT_TRUE(writeRecipe(whole(), path));
    const std::string sound = text();
    std::mt19937 random(7);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = sound;
        damaged[random() % damaged.size()] = static_cast<char>(random());
        if (i % 3 == 0)
            damaged.resize(random() % damaged.size());
        const auto read = recipeFromJson(damaged, folder.path().toStdString());
        if (read) {
            EXPECT_TRUE(validate(*read));
        }
    }
}

TEST_F(RecipeFile, writesNothingThatItWouldNotRead) {
    Recipe recipe = whole();
    recipe.steps[0].maxDuration_s = -1.0;
    EXPECT_FALSE(writeRecipe(recipe, path));
    EXPECT_FALSE(isRecipeFile(path));
    EXPECT_EQ(writeRecipe(whole(), path + "/none/recipe.json").error().code(), MessageCode::FileUnwritable);
}

TEST_F(RecipeFile, experimentsAreReadOnceAndCheckedForTheirObjects) {
    Recipe recipe;
    recipe.steps.resize(3);
    recipe.steps[0] = step(Until::Below);
    recipe.steps[0].object = "right";
    recipe.steps[1].experiment = recipe.steps[2].experiment = BASK_EXAMPLES "/two-circles.json";
    const auto read = readExperiments(recipe, noExample);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ((*read)[0], (*read)[1]); // the first run's, whose objects are waited for
    EXPECT_EQ((*read)[1], (*read)[2]);
    EXPECT_DOUBLE_EQ(maxDuration_s(recipe), 1234.5 + 2 * 1800.0);

    recipe.steps[0].object = "hand";
    Error error = readExperiments(recipe, noExample).error();
    EXPECT_EQ(error.where, "steps[0].wait.object");
    EXPECT_EQ(argTexts(error.message), (std::vector<std::string>{"hand", "left, right"}));

    recipe.steps[0].object = "left";
    for (const double never_degC : {14.0, 2000.0}) { // in a room of 25 degC; the warning limit is 120
        recipe.steps[0].until = never_degC < 25.0 ? Until::Below : Until::Above;
        recipe.steps[0].temperature_K = kelvinFromCelsius(never_degC);
        error = readExperiments(recipe, noExample).error();
        EXPECT_EQ(error.code(), MessageCode::ValueOutOfRange);
        EXPECT_EQ(error.where, never_degC < 25.0 ? "steps[0].wait.below" : "steps[0].wait.above");
    }
    EXPECT_EQ(error.message.args[2], "120");
    recipe.steps[0].temperature_K = kelvinFromCelsius(120.0);
    EXPECT_TRUE(readExperiments(recipe, noExample));

    Experiment unreachable = *readExperiment(recipe.steps[1].experiment);
    unreachable.objects[1].target_K = kelvinFromCelsius(118.0);
    ASSERT_TRUE(writeExperiment(unreachable, path));
    recipe.steps[2].experiment = path;
    error = readExperiments(recipe, noExample).error();
    EXPECT_EQ(error.where, "steps[2].run");
    EXPECT_EQ(error.message.args.at(0), "right") << describe(error);
    recipe.steps[2].goesOn = true;
    EXPECT_TRUE(readExperiments(recipe, noExample)) << "the step fails and the next one follows";
    recipe.steps[2].goesOn = false;
    EXPECT_EQ(readExperiments(Recipe{}, noExample).error().code(), MessageCode::RecipeWithoutRun);

    recipe.steps[2].experiment = path + "x";
    error = readExperiments(recipe, noExample).error();
    EXPECT_EQ(error.code(), MessageCode::FileNotFound);
    EXPECT_EQ(error.where, "steps[2].run: " + path + "x");

    recipe.steps[2].experiment.clear();
    recipe.steps[2].example = "nowhere";
    EXPECT_EQ(readExperiments(recipe, noExample).error().code(), MessageCode::ValueUnknown);

    writeSteps(R"({"wait": {"time_s": 5}})"); // a recipe is no experiment: none runs itself
    recipe.steps[2] = RecipeStep();
    recipe.steps[2].experiment = path;
    EXPECT_EQ(readExperiments(recipe, noExample).error().code(), MessageCode::ValueUnknown);

    recipe.steps = {step(Until::Time)};
    EXPECT_EQ(readExperiments(recipe, noExample).error().where, "steps"); // nothing to run
}

} // namespace bask
