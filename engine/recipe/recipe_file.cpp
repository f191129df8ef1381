#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/parameter_json.h"
#include "engine/experiment/text_file.h"
#include "engine/recipe/recipe.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace bask {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Until = RecipeStep::Until;

constexpr std::uintmax_t kMaxBytes = 1u << 20;

/// In either spelling.
bool isIn(const json& j, const ParameterFacts& facts) {
    return j.contains(keyOf(facts)) || (facts.unit.edge && j.contains(siKey(facts.name, *facts.unit.edge)));
}

/// One condition: the keys of a second one are unknown there.
void readUntil(const json& j, const std::string& path, Failure& failure, RecipeStep& step) {
    Fields fields(j, path, failure);
    for (const Until until : {Until::Time, Until::Below, Until::Above})
        if (isIn(j, conditionParameters(until).front()))
            step.until = until;
    if (step.isOfObject())
        fields.read("object", step.object, true);
    readParameters(fields, conditionParameters(step.until), step);
    fields.close();
}

void readStep(const json& j, const std::string& path, const std::string& folder, Failure& failure,
              RecipeStep& step) {
    Fields fields(j, path, failure);
    if (failure)
        return;
    const bool isWait = j.contains("wait");
    if (!isWait && j.contains("run_example"))
        fields.read("run_example", step.example);
    else if (!isWait)
        fields.read("run", step.experiment, true);
    if (!failure && !isWait && !step.isRun() && (j.contains("run") || j.contains("run_example")))
        fields.fail(MessageCode::FileNotFound, fields.pathOf("run"));
    if (!step.experiment.empty())
        step.experiment = (fs::path(folder) / step.experiment).lexically_normal().string();
    readPart(fields, isWait ? "wait" : "until", true,
             [&](const json& part, const std::string& place) { readUntil(part, place, failure, step); });
    readParameters(fields, limitParameters(step.until), step);
    fields.readWord("otherwise", {{"stop", false}, {"next", true}}, step.goesOn);
    fields.close();
}

Recipe readRoot(const json& j, const std::string& folder, Failure& failure) {
    Recipe recipe;
    Fields root(j, {}, failure);
    readHeader(root, "bask-recipe", kRecipeFormat);
    root.readName("name", recipe.name);
    if (const json* steps = root.find("steps");
        steps != nullptr && steps->is_array() && steps->size() > kMaxRecipeSteps)
        root.fail(MessageCode::ValueOutOfRange, "steps",
                  {std::to_string(steps->size()), "0", std::to_string(kMaxRecipeSteps), ""});
    readEach(root, "steps", true, [&](const json& step, const std::string& place) {
        readStep(step, place, folder, failure, recipe.steps.emplace_back());
    });
    root.close();
    return recipe;
}

std::string folderOf(const std::string& path) {
    std::error_code failed;
    const fs::path whole = fs::absolute(path, failed);
    return (failed ? fs::path(path) : whole).parent_path().string();
}

/// Relative where it lies inside of the folder.
std::string written(const std::string& experiment, const std::string& folder) {
    const std::string inside = fs::path(experiment).lexically_relative(folder).string();
    return folder.empty() || inside.empty() || inside.starts_with("..") ? experiment : inside;
}

nlohmann::ordered_json stepJson(const RecipeStep& step, const std::string& folder) {
    nlohmann::ordered_json j, until;
    if (!step.example.empty())
        j["run_example"] = step.example;
    else if (!step.experiment.empty())
        j["run"] = written(step.experiment, folder);
    if (step.isOfObject())
        until["object"] = step.object;
    putParameters(until, conditionParameters(step.until), step);
    j[step.isRun() ? "until" : "wait"] = until;
    putParameters(j, limitParameters(step.until), step);
    if (step.goesOn)
        j["otherwise"] = "next";
    return j;
}

} // namespace

bool isRecipeFile(const std::string& path) {
    const auto text = readTextFile(path, kMaxBytes);
    return text && text->substr(0, 1024).find("\"bask-recipe\"") != std::string::npos;
}

Result<Recipe> recipeFromJson(const std::string& text, const std::string& folder) {
    return readJsonText<Recipe>(text, {}, [&](const json& j, Failure& failure, Recipe& out) {
        out = readRoot(j, folder, failure);
        if (!failure)
            failure = failureOf(validate(out));
    });
}

Result<Recipe> readRecipe(const std::string& path) {
    const auto text = readTextFile(path, kMaxBytes);
    if (!text)
        return text.error();
    const Result<Recipe> recipe = recipeFromJson(*text, folderOf(path));
    return recipe ? recipe : located(recipe.error(), path);
}

std::string recipeToJson(const Recipe& recipe, const std::string& folder) {
    nlohmann::ordered_json j;
    j["format"] = "bask-recipe";
    j["version"] = kRecipeFormat;
    j["name"] = recipe.name;
    j["steps"] = nlohmann::ordered_json::array();
    for (const RecipeStep& step : recipe.steps)
        j["steps"].push_back(stepJson(step, folder));
    return j.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

Result<void> writeRecipe(const Recipe& recipe, const std::string& path) {
    if (const auto valid = validate(recipe); !valid)
        return valid;
    return writeTextFile(path, recipeToJson(recipe, folderOf(path)));
}

} // namespace bask
