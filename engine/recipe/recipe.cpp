#include "engine/recipe/recipe.h"

#include "engine/base/json_text.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/checker.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <map>
#include <set>

namespace bask {
namespace {

constexpr double kRoomDiffers_K = 10.0; ///< from what the experiment says of it

constexpr double kMaxStep_s = 1e7;
constexpr ValidRange kAnyTemperature{kMinTemperature_degC, kMaxTemperature_degC};
constexpr bool kRequired = true;

// clang-format off
constexpr Parameter<RecipeStep> kConditions[]{ // in the order of RecipeStep::Until
    {{"settled_for", unit::kSeconds, {0.0, kMaxStep_s}, Loosens::Never, "", "", 3, kRequired}, &RecipeStep::duration_s}, // and at_most_s
    {{"time", unit::kSeconds, {1.0, kMaxStep_s}, Loosens::Never, "", "", 3, kRequired}, &RecipeStep::duration_s},
    {{"above", unit::kCelsius, kAnyTemperature, Loosens::Never, "", "", 1, kRequired}, &RecipeStep::temperature_K},
    {{"below", unit::kCelsius, kAnyTemperature, Loosens::Never, "", "", 1, kRequired}, &RecipeStep::temperature_K},
};
constexpr Parameter<RecipeStep> kLimit[]{
    {{"at_most", unit::kSeconds, {1.0, kMaxStep_s}, Loosens::Never, "", "", 3, kRequired}, &RecipeStep::maxDuration_s},
};
// clang-format on

std::string placeOf(std::size_t step, const std::string& key) {
    return "steps[" + std::to_string(step) + "]." + key;
}

/// Of what the step goes on until, as the file has it.
std::string untilOf(const RecipeStep& step, std::size_t i, const std::string& key) {
    return placeOf(i, step.isRun() ? "until." : "wait.") + key;
}

/// min and max as in the file, whose temperatures may be in either of two units.
void checkCondition(Checker& check, const RecipeStep& step, std::size_t i, double min, double max) {
    const Parameter<RecipeStep>& value = conditionParameters(step.until).front();
    check.range(untilOf(step, i, value.unit.edge ? value.name : keyOf(value)),
                written(value, *value.get(step)), min, max, value.unit.words);
}

/// A file's name goes to the system: a zero in it would make it another.
bool isPlain(const std::string& name) {
    return std::ranges::none_of(name, [](unsigned char c) { return c < ' '; });
}

void checkStep(Checker& check, const RecipeStep& step, std::size_t i) {
    using Until = RecipeStep::Until;
    if (!isPlain(step.experiment) || !isPlain(step.example) || !isPlain(step.object))
        check.fail(MessageCode::NameNotPlain, placeOf(i, step.isRun() ? "run" : "wait"));
    if (!step.isRun() && step.until == Until::Settled)
        check.fail(MessageCode::ValueUnknown, placeOf(i, "wait"),
                   {"settled_for_s", "above_degC, below_degC, time_s"});
    check.parameters(placeOf(i, {}), limitParameters(step.until), step);
    if (step.isOfObject() && step.object.empty())
        check.fail(MessageCode::JsonMissingKey, placeOf(i, step.isRun() ? "until" : "wait"), {"object"});
    const ValidRange& range = conditionParameters(step.until).front().range;
    const bool isOverLimit = step.until == Until::Settled && step.duration_s > step.maxDuration_s;
    checkCondition(check, step, i, range.min, isOverLimit ? step.maxDuration_s : range.max);
}

/// Over its warning limit an object ends the recipe, and colder than the room it does not get.
Result<void> checkObject(const RecipeStep& step, std::size_t i, const Experiment& experiment) {
    if (!step.isOfObject())
        return {};
    const bool isAbove = step.until == RecipeStep::Until::Above;
    const ParameterFacts& value = conditionParameters(step.until).front();
    std::string known;
    for (const ObjectSpec& object : experiment.objects) {
        known += (known.empty() ? "" : ", ") + object.name;
        if (object.name != step.object)
            continue;
        Checker check;
        checkCondition(check, step, i,
                       isAbove ? value.range.min : written(value, experiment.environment_K) - kRoomDiffers_K,
                       isAbove ? written(value, warningLimit_K(experiment, object)) : value.range.max);
        return check.result();
    }
    return Error(MessageCode::ValueUnknown, untilOf(step, i, "object"), {step.object, known});
}

} // namespace

ParameterTable<RecipeStep> conditionParameters(RecipeStep::Until until) {
    return std::span(kConditions).subspan(static_cast<std::size_t>(until), 1);
}

ParameterTable<RecipeStep> limitParameters(RecipeStep::Until until) {
    return until == RecipeStep::Until::Time ? ParameterTable<RecipeStep>() : kLimit;
}

double maxDuration_s(const Recipe& recipe) {
    double sum_s = 0.0;
    for (const RecipeStep& step : recipe.steps)
        sum_s += step.until == RecipeStep::Until::Time ? step.duration_s : step.maxDuration_s;
    return sum_s;
}

Result<void> validate(const Recipe& recipe) {
    Checker check;
    check.name("name", recipe.name, kMaxRecipeName);
    check.range("steps", static_cast<double>(recipe.steps.size()), 0.0, kMaxRecipeSteps);
    for (std::size_t i = 0; i < recipe.steps.size() && !check.failed(); ++i)
        checkStep(check, recipe.steps[i], i);
    return check.result();
}

Result<RecipeExperiments> readExperiments(const Recipe& recipe, const ExampleReader& readExample) {
    if (const auto valid = validate(recipe); !valid)
        return valid.error();
    RecipeExperiments out(recipe.steps.size());
    std::map<std::pair<std::string, std::string>, std::shared_ptr<const Experiment>> read;
    std::shared_ptr<const Experiment> first;
    std::set<const Experiment*> judged;
    for (std::size_t i = 0; i < out.size(); ++i) {
        const RecipeStep& step = recipe.steps[i];
        if (!step.isRun())
            continue;
        const std::string place = placeOf(i, step.example.empty() ? "run" : "run_example");
        auto& known = read[{step.experiment, step.example}];
        if (!known) {
            auto experiment =
                step.example.empty() ? readExperiment(step.experiment) : readExample(step.example);
            if (!experiment)
                return located(experiment.error(), place);
            if (const auto fit = checkTargets(*experiment); !fit) // it would never be ready
                return located(fit.error(), place);
            if (const auto mounting = checkMounting(*experiment); !mounting)
                return located(mounting.error(), place);
            known = std::make_shared<const Experiment>(std::move(*experiment));
        }
        // Nobody is there to agree to it when its turn comes.
        if (!step.goesOn && judged.insert(known.get()).second)
            if (const JointVerdict verdict = jointVerdict(*known); !verdict.feasible)
                return Error(verdict.reason.code, place, verdict.reason.args);
        out[i] = known;
        first = first ? first : known;
    }
    if (!first)
        return Error(MessageCode::RecipeWithoutRun, "steps");
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!out[i])
            out[i] = i == 0 ? first : out[i - 1];
        if (const auto there = checkObject(recipe.steps[i], i, *out[i]); !there)
            return there.error();
    }
    return out;
}

bool hasManualSource(const std::optional<RigSpec>& rig) {
    return rig && rig->source && isManualSource(*rig->source);
}

} // namespace bask
