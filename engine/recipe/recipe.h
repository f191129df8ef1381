#pragma once
// A recipe: experiments to be run one after another, with waits between them. As one value and as a JSON
// file: "format": "bask-recipe", "version": 1.

#include "engine/model/experiment.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bask {

/// A run of an experiment, or a wait at rest, until a condition holds.
struct RecipeStep {
    enum class Until {
        Settled, ///< all objects within kSettledBand_K of their targets, for duration_s
        Time,    ///< duration_s have passed
        Above,   ///< the object is at this temperature or hotter
        Below,   ///< or colder
    };
    std::string experiment; ///< its file, absolute; empty: see `example`
    std::string example;    ///< one that comes with Bask; both empty: a wait
    Until until = Until::Settled;
    double duration_s = 30.0;
    std::string object;
    double temperature_K = 303.15;
    double atMost_s = 1800.0; ///< of Time: its duration
    bool goesOn = false;      ///< to the next step, where this one fails; else the recipe ends there

    bool isRun() const { return !experiment.empty() || !example.empty(); }
    bool operator==(const RecipeStep&) const = default;
};

struct Recipe {
    std::string name;
    std::vector<RecipeStep> steps;
    bool operator==(const Recipe&) const = default;
};

inline constexpr int kRecipeFormat = 1; ///< version written to and accepted from recipe files
inline constexpr std::size_t kMaxRecipeSteps = 500;
inline constexpr double kLongestStep_s = 1e7;

/// What all steps take at the very most, s.
double atMost_s(const Recipe& recipe);

/// Ranges; a wait until all have settled there is not. The error's `where` is such as "steps[1].at_most_s".
Result<void> validate(const Recipe& recipe);

/// Whether a file says that it is one, sound or not.
bool isRecipeFile(const std::string& path);
/// Refuses unknown keys and wrong types. The experiments are not looked at.
Result<Recipe> readRecipe(const std::string& path);
/// Same from text; experiments are looked for in `folder`.
Result<Recipe> recipeFromJson(const std::string& text, const std::string& folder);
/// Experiments inside of `folder` are written relative to it.
std::string recipeToJson(const Recipe& recipe, const std::string& folder);
/// Writes it, whole or not at all.
Result<void> writeRecipe(const Recipe& recipe, const std::string& path);

using ExampleReader = std::function<Result<Experiment>(const std::string& name)>;
/// One a step; that of a wait is the run's before it, or of the first one: whose objects are waited for.
using RecipeExperiments = std::vector<std::shared_ptr<const Experiment>>;

/// All of a recipe's experiments, each read once. Errors: a recipe that does not validate or has no run, what
/// cannot be read, objects that an experiment does not have, temperatures that never come.
Result<RecipeExperiments> readExperiments(const Recipe& recipe, const ExampleReader& readExample);

/// A person switches its source, so that no recipe can take the heat off between its steps.
bool isKeptHotByHand(const std::optional<RigSpec>& rig);

} // namespace bask
