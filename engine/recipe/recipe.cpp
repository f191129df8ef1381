#include "engine/recipe/recipe.h"

#include "engine/base/json_text.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <map>
#include <set>

namespace bask {
namespace {

constexpr double kRoomDiffers_K = 10.0; ///< from what the experiment says of it

std::string placeOf(std::size_t step, const char* key) {
    return "steps[" + std::to_string(step) + "]." + key;
}

/// Of what the step goes on until, as the file has it.
std::string untilOf(const RecipeStep& step, std::size_t i, const char* key) {
    return placeOf(i, step.isRun() ? "until." : "wait.") + key;
}

Result<void> checkSeconds(double value_s, double least_s, const std::string& place) {
    if (value_s >= least_s && value_s <= kLongestStep_s)
        return {};
    return Error(MessageCode::ValueOutOfRange, place,
                 {formatNumber(value_s), formatNumber(least_s), formatNumber(kLongestStep_s), "s"});
}

/// A file's name goes to the system: a zero in it would make it another.
bool isPlain(const std::string& name) {
    return std::ranges::none_of(name, [](unsigned char c) { return c < ' '; });
}

Result<void> check(const RecipeStep& step, std::size_t i) {
    using Until = RecipeStep::Until;
    if (!isPlain(step.experiment) || !isPlain(step.example) || !isPlain(step.object))
        return Error(MessageCode::NameNotPlain, placeOf(i, step.isRun() ? "run" : "wait"));
    if (!step.isRun() && step.until == Until::Settled)
        return Error(MessageCode::ValueUnknown, placeOf(i, "wait"),
                     {"settled_for_s", "above_degC, below_degC, time_s"});
    if (step.until == Until::Time)
        return checkSeconds(step.duration_s, 1.0, untilOf(step, i, "time_s"));
    if (const auto fits = checkSeconds(step.atMost_s, 1.0, placeOf(i, "at_most_s")); !fits)
        return fits;
    if (step.until == Until::Settled) {
        if (step.duration_s > step.atMost_s)
            return Error(MessageCode::ValueOutOfRange, untilOf(step, i, "settled_for_s"),
                         {formatNumber(step.duration_s), "0", formatNumber(step.atMost_s), "s"});
        return checkSeconds(step.duration_s, 0.0, untilOf(step, i, "settled_for_s"));
    }
    if (step.object.empty())
        return Error(MessageCode::JsonMissingKey, placeOf(i, step.isRun() ? "until" : "wait"), {"object"});
    const bool isAbove = step.until == Until::Above;
    const double t_degC = celsiusFromKelvin(step.temperature_K);
    if (t_degC >= kMinTemperature_degC && t_degC <= kMaxTemperature_degC)
        return {};
    return Error(MessageCode::ValueOutOfRange, untilOf(step, i, isAbove ? "above" : "below"),
                 {formatNumber(t_degC), formatNumber(kMinTemperature_degC),
                  formatNumber(kMaxTemperature_degC), "degC"});
}

/// Over its warning limit an object ends the recipe, and colder than the room it does not get.
Result<void> checkObject(const RecipeStep& step, std::size_t i, const Experiment& experiment) {
    const bool isAbove = step.until == RecipeStep::Until::Above;
    if (!isAbove && step.until != RecipeStep::Until::Below)
        return {};
    std::string known;
    for (const ObjectSpec& object : experiment.objects) {
        known += (known.empty() ? "" : ", ") + object.name;
        if (object.name != step.object)
            continue;
        const double t_degC = celsiusFromKelvin(step.temperature_K);
        const double least_degC =
            isAbove ? kMinTemperature_degC : celsiusFromKelvin(experiment.environment_K) - kRoomDiffers_K;
        const double most_degC =
            isAbove ? celsiusFromKelvin(warningLimit_K(experiment, object)) : kMaxTemperature_degC;
        if (t_degC >= least_degC && t_degC <= most_degC)
            return {};
        return Error(MessageCode::ValueOutOfRange, untilOf(step, i, isAbove ? "above" : "below"),
                     {formatNumber(t_degC), formatNumber(least_degC), formatNumber(most_degC), "degC"});
    }
    return Error(MessageCode::ValueUnknown, untilOf(step, i, "object"), {step.object, known});
}

} // namespace

double atMost_s(const Recipe& recipe) {
    double sum_s = 0.0;
    for (const RecipeStep& step : recipe.steps)
        sum_s += step.until == RecipeStep::Until::Time ? step.duration_s : step.atMost_s;
    return sum_s;
}

Result<void> validate(const Recipe& recipe) {
    if (recipe.steps.size() > kMaxRecipeSteps)
        return Error(MessageCode::ValueOutOfRange, "steps",
                     {std::to_string(recipe.steps.size()), "0", std::to_string(kMaxRecipeSteps), ""});
    for (std::size_t i = 0; i < recipe.steps.size(); ++i)
        if (const auto fits = check(recipe.steps[i], i); !fits)
            return fits;
    return {};
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

bool isKeptHotByHand(const std::optional<RigSpec>& rig) {
    return rig && rig->source && isKeptByHand(*rig->source);
}

} // namespace bask
