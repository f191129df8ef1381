#pragma once
// A recipe: experiments to run one after another, with waits between them. As one value and as a JSON file:
// "format": "bask-recipe", "version": 1.

#include "engine/base/parameter.h"
#include "engine/model/experiment.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bask {

/// A run of an experiment, or a wait at rest, until a condition is true.
struct RecipeStep {
    enum class Until {
        Settled, ///< all objects within kSettledBand_K of their targets, for duration_s
        Time,    ///< duration_s have passed
        Above,   ///< the object is at this temperature or hotter
        Below,   ///< the object is at this temperature or colder
    };
    std::string experiment; ///< its file, absolute; empty: see `example`
    std::string example;    ///< name of an example of Bask; both empty: a wait
    Until until = Until::Settled;
    double duration_s = 30.0;
    std::string object;
    double temperature_K = 303.15;
    double maxDuration_s = 1800.0; ///< longest duration; not used for Time
    /// Whether to continue with the next step if this one fails; otherwise the recipe ends.
    bool goesOn = false;

    bool isRun() const { return !experiment.empty() || !example.empty(); }
    bool isOfObject() const { return until == Until::Above || until == Until::Below; }
    bool operator==(const RecipeStep&) const = default;
};

struct Recipe {
    std::string name;
    std::vector<RecipeStep> steps;
    bool operator==(const Recipe&) const = default;
};

inline constexpr int kRecipeFormat = 1; ///< version written to and accepted from recipe files
inline constexpr std::size_t kMaxRecipeSteps = 500;
inline constexpr std::size_t kMaxRecipeName = 1000; ///< characters

/// The number that a step waits for: one parameter for each Until.
ParameterTable<RecipeStep> conditionParameters(RecipeStep::Until until);
/// And for how long at most; none for Until::Time.
ParameterTable<RecipeStep> limitParameters(RecipeStep::Until until);

/// Returns the longest duration of all steps together, s.
double maxDuration_s(const Recipe& recipe);

/// Checks ranges; refuses a wait until all have settled. The error's `where` is for example
/// "steps[1].at_most_s".
Result<void> validate(const Recipe& recipe);

/// Returns whether a file declares that it is a recipe, valid or not.
bool isRecipeFile(const std::string& path);
/// Reads a recipe; refuses unknown keys and wrong types. The experiments are not checked.
Result<Recipe> readRecipe(const std::string& path);
/// Like readRecipe, from text; experiments are searched in `folder`.
Result<Recipe> recipeFromJson(const std::string& text, const std::string& folder);
/// Returns JSON; experiments inside `folder` are written relative to it.
std::string recipeToJson(const Recipe& recipe, const std::string& folder);
/// Writes the whole recipe or leaves the old file.
Result<void> writeRecipe(const Recipe& recipe, const std::string& path);

using ExampleReader = std::function<Result<Experiment>(const std::string& name)>;
/// One for each step. For a wait it is the experiment of the run before it, or of the first run, whose
/// objects it waits for.
using RecipeExperiments = std::vector<std::shared_ptr<const Experiment>>;

/// Reads all experiments of a recipe, each once. Errors: a recipe that does not validate or has no run, an
/// experiment that cannot be read, objects that an experiment does not have, temperatures that can never
/// occur.
Result<RecipeExperiments> readExperiments(const Recipe& recipe, const ExampleReader& readExample);

/// Returns whether a person heats the rig's source, so that no recipe can switch the heat off between its
/// steps.
bool hasManualSource(const std::optional<RigSpec>& rig);

} // namespace bask
