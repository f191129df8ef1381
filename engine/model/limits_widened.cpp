#include "engine/model/limits_widened.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/model/experiment_parameters.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace bask {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity(); ///< no limit

class Widened {
public:
    /// Where `after` is more; both times `factor` in words.
    void more(const std::string& name, double before, double after, const std::string& unit = "",
              double factor = 1.0) {
        if (after > before)
            add(name, words(before, unit, factor), words(after, unit, factor));
    }
    void less(const std::string& name, double before, double after, const std::string& unit = "",
              double factor = 1.0) {
        if (after < before)
            add(name, words(before, unit, factor), words(after, unit, factor));
    }
    void hotter(const std::string& name, double before_K, double after_K) {
        if (after_K > before_K)
            add(name, temperatureArg(before_K, 5), temperatureArg(after_K, 5));
    }
    /// What allows more of it by itself; Loosens::InCode is left out.
    void parameter(const ParameterFacts& facts, double before, double after) {
        const bool isDown = facts.loosens == Loosens::Down;
        const auto limit = [&](double si) { // 0 may be none
            return facts.loosens == Loosens::UpOrZero && si == 0.0 ? kNone : si;
        };
        const bool isWider = isDown ? after < before : limit(after) > limit(before);
        if (!isWider || facts.loosens == Loosens::Never || facts.loosens == Loosens::InCode)
            return;
        const bool isTemperature = facts.unit.edge == EdgeUnit::Temperature;
        const auto text = [&](double si) -> MessageArg {
            if (isTemperature)
                return temperatureArg(si, 5);
            return words(limit(si) == kNone ? kNone : written(facts, si), facts.unit.words, 1.0);
        };
        add(facts.label, text(before), text(after));
    }
    template <class Spec> void parameters(ParameterTable<Spec> table, const Spec& before, const Spec& after) {
        for (const Parameter<Spec>& each : table)
            if (const auto from = each.get(before), to = each.get(after); from && to)
                parameter(each, *from, *to);
    }
    void add(const std::string& name, const MessageArg& before, const MessageArg& after) {
        out.push_back({MessageCode::LimitLooser, {name, before, after}});
    }

    std::vector<Message> out;

private:
    static std::string words(double value, const std::string& unit, double factor) {
        const std::string number =
            value == kNone ? QT_TRANSLATE_NOOP("Parameter", "no limit") : formatNumber(value * factor, 5);
        return unit.empty() || value == kNone ? number : number + ' ' + unit;
    }
};

void addWorkspace(Widened& widened, const RobotLimits& before, const RobotLimits& after) {
    constexpr std::array kNames{"x", "y", "z", "theta x", "theta y", "theta z"};
    for (std::size_t i = 0; i < 6; ++i) {
        if (!after.free[i])
            continue;
        const auto k = static_cast<Eigen::Index>(i);
        const std::string unit = i < 3 ? "cm" : "deg";
        const double factor = i < 3 ? 100.0 : degFromRad(1.0);
        if (!before.free[i])
            widened.add(std::string("axis ") + kNames[i], "fixed", "free");
        widened.less(std::string("lowest ") + kNames[i], before.lower[k], after.lower[k], unit, factor);
        widened.more(std::string("highest ") + kNames[i], before.upper[k], after.upper[k], unit, factor);
    }
}

void addObjects(Widened& widened, const Experiment& before, const Experiment& after) {
    for (const ObjectSpec& object : after.objects) {
        const auto was = std::ranges::find(before.objects, object.name, &ObjectSpec::name);
        const bool isNew = was == before.objects.end();
        widened.hotter("warning limit of \"" + object.name + '"',
                       isNew ? before.safety.warning_K : warningLimit_K(before, *was),
                       warningLimit_K(after, object));
        widened.hotter("trip limit of \"" + object.name + '"',
                       isNew ? before.safety.trip_K : tripLimit_K(before, *was), tripLimit_K(after, object));
    }
}

/// An automatic one is kMinRate_K_s or more; how much more depends on what is heated.
void addRate(Widened& widened, const std::optional<double>& before, const std::optional<double>& after) {
    const std::string name = QT_TRANSLATE_NOOP("Parameter", "Fastest plausible change");
    if (after)
        widened.more(name, before.value_or(SafetySpec::kMinRate_K_s), *after, "K/s");
    else if (before)
        widened.add(name, formatNumber(*before) + " K/s", QT_TRANSLATE_NOOP("Parameter", "automatic"));
}

void addRig(Widened& widened, const std::optional<RigSpec>& before, const std::optional<RigSpec>& after) {
    const auto isUnattended = [](const std::optional<RigSpec>& rig) {
        return rig && rig->source && rig->source->mayHeatUnattended;
    };
    if (isUnattended(after) && !isUnattended(before))
        widened.add(QT_TRANSLATE_NOOP("Parameter", "heat without a watchdog"),
                    QT_TRANSLATE_NOOP("Parameter", "not allowed"), QT_TRANSLATE_NOOP("Parameter", "allowed"));
}

} // namespace

std::vector<Message> widenedLimits(const Experiment& before, const Experiment& after) {
    Widened widened;
    addObjects(widened, before, after);
    widened.hotter(QT_TRANSLATE_NOOP("Parameter", "Source: trip"), sourceTripLimit_K(before),
                   sourceTripLimit_K(after));
    widened.parameters(safetyParameters(), before.safety, after.safety);
    addRate(widened, before.safety.largestRate_K_s, after.safety.largestRate_K_s);
    widened.parameters(robotParameters(), before.robot, after.robot);
    addWorkspace(widened, before.robot, after.robot);
    addRig(widened, before.rig, after.rig);
    return widened.out;
}

std::vector<Message> widenedFromUsual(const Experiment& experiment) {
    Experiment usual = experiment;
    usual.safety = {};
    for (ObjectSpec& object : usual.objects) {
        object.warning_K.reset();
        object.trip_K.reset();
    }
    if (usual.rig && usual.rig->source)
        usual.rig->source->mayHeatUnattended = false;
    usual.robot = {};
    usual.robot.free = experiment.robot.free;
    usual.robot.lower = experiment.robot.lower;
    usual.robot.upper = experiment.robot.upper;
    return widenedLimits(usual, experiment);
}

std::vector<Message> widenedOnRealRig(const Experiment& now, const Experiment& next,
                                      const std::optional<RobotLimits>& real) {
    if (!next.rig)
        return {};
    if (now.rig)
        return widenedLimits(now, next);
    Widened widened{widenedFromUsual(next)};
    if (real)
        addWorkspace(widened, *real, next.robot);
    return widened.out;
}

Message limitsLoosened(const std::vector<Message>& widened) {
    return widened.empty() ? Message{} : Message{MessageCode::LimitsLoosened, {MessageArg(widened)}};
}

bool widensLimits(const Experiment& before, const Experiment& after) {
    return !widenedLimits(before, after).empty();
}

} // namespace bask
