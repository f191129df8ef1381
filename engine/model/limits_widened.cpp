#include "engine/model/limits_widened.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/model/experiment_parameters.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace bask {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity(); ///< no limit

MessageArg rateArg(double rate_K_s) {
    return Message{MessageCode::RateOfChange, {differenceArg(rate_K_s, 5)}};
}

/// A value in the unit of files; one of a temperature keeps its kind, so that it is shown in the reader's
/// unit.
MessageArg valueArg(const ParameterFacts& facts, double si) {
    if (facts.loosens == Loosens::UpOrZero && si == 0.0)
        return QT_TRANSLATE_NOOP("Parameter", "no limit");
    if (facts.unit.edge == EdgeUnit::Temperature)
        return temperatureArg(si, 5);
    if (facts.unit.kelvins == Kelvins::Difference)
        return differenceArg(si, 5);
    if (facts.unit.kelvins == Kelvins::Rate)
        return rateArg(si);
    return numberArg(written(facts, si), facts.unit.words, 5);
}

bool isWider(const ParameterFacts& facts, double before, double after) {
    const auto limit = [&](double si) {
        return facts.loosens == Loosens::UpOrZero && si == 0.0 ? kNone : si;
    };
    return loosensByItself(facts) &&
           (facts.loosens == Loosens::Down ? after < before : limit(after) > limit(before));
}

class Widened {
public:
    void hotter(const MessageArg& name, double before_K, double after_K) {
        if (after_K > before_K)
            add(name, temperatureArg(before_K, 5), temperatureArg(after_K, 5));
    }
    /// What allows more of it by itself; Loosens::InCode is left out.
    void parameter(const ParameterFacts& facts, double before, double after) {
        if (isWider(facts, before, after))
            add(facts.label, valueArg(facts, before), valueArg(facts, after));
    }
    template <class Spec> void parameters(ParameterTable<Spec> table, const Spec& before, const Spec& after) {
        for (const Parameter<Spec>& each : table)
            if (const auto from = each.get(before), to = each.get(after); from && to)
                parameter(each, *from, *to);
    }
    void add(const MessageArg& name, const MessageArg& before, const MessageArg& after) {
        out.push_back({MessageCode::LimitLooser, {name, before, after}});
    }

    std::vector<Message> out;
};

void addWorkspace(Widened& widened, const RobotLimits& before, const RobotLimits& after) {
    constexpr std::array kNames{
        QT_TRANSLATE_NOOP("Parameter", "x"),       QT_TRANSLATE_NOOP("Parameter", "y"),
        QT_TRANSLATE_NOOP("Parameter", "z"),       QT_TRANSLATE_NOOP("Parameter", "theta x"),
        QT_TRANSLATE_NOOP("Parameter", "theta y"), QT_TRANSLATE_NOOP("Parameter", "theta z")};
    for (int k = 0; k < 6; ++k) {
        const auto i = static_cast<std::size_t>(k);
        if (!after.free[i])
            continue;
        const EdgeUnit unit = coordinateUnit(k);
        const auto text = [unit](double si) {
            return numberArg(fromSi(si, unit).value, std::string(readableUnit(unit)), 5);
        };
        const auto named = [&](MessageCode code) { return MessageArg(Message{code, {kNames[i]}}); };
        if (!before.free[i])
            widened.add(named(MessageCode::LimitAxis), QT_TRANSLATE_NOOP("Parameter", "fixed"),
                        QT_TRANSLATE_NOOP("Parameter", "free"));
        if (after.lower[k] < before.lower[k])
            widened.add(named(MessageCode::LimitLowest), text(before.lower[k]), text(after.lower[k]));
        if (after.upper[k] > before.upper[k])
            widened.add(named(MessageCode::LimitHighest), text(before.upper[k]), text(after.upper[k]));
    }
}

void addObjects(Widened& widened, const Experiment& before, const Experiment& after) {
    for (const ObjectSpec& object : after.objects) {
        const auto was = std::ranges::find(before.objects, object.name, &ObjectSpec::name);
        const bool isNew = was == before.objects.end();
        widened.hotter(Message{MessageCode::LimitOfWarning, {object.name}},
                       isNew ? before.safety.warning_K : warningLimit_K(before, *was),
                       warningLimit_K(after, object));
        widened.hotter(Message{MessageCode::LimitOfTrip, {object.name}},
                       isNew ? before.safety.trip_K : tripLimit_K(before, *was), tripLimit_K(after, object));
    }
}

/// An automatic one is kMinRate_K_s or more; how much more depends on what is heated.
void addRate(Widened& widened, const std::optional<double>& before, const std::optional<double>& after) {
    const char* name = QT_TRANSLATE_NOOP("Parameter", "Fastest plausible change");
    const double before_K_s = before.value_or(SafetySpec::kMinRate_K_s);
    if (after && *after > before_K_s)
        widened.add(name, rateArg(before_K_s), rateArg(*after));
    else if (before && !after)
        widened.add(name, rateArg(*before), QT_TRANSLATE_NOOP("Parameter", "automatic"));
}

/// Returns the device with its limits as they are where a file does not set them.
template <class Spec> Spec withUsualLimits(const Spec& device) {
    Spec usual = device, unset;
    unset.driver = device.driver;
    for (const DeviceParameter<Spec>& each : driverOf(device).parameters)
        if (loosensByItself(*each.facts))
            each.set(usual, each.get(unset));
    return usual;
}

/// A limit that the device before did not have is compared with the usual one.
template <class Spec>
void addDevice(Widened& widened, const std::optional<Spec>& before, const std::optional<Spec>& after) {
    if (!after)
        return;
    const Spec usual = withUsualLimits(*after);
    for (const DeviceParameter<Spec>& each : driverOf(*after).parameters) {
        if (!each.applies(*after))
            continue;
        double was = each.get(usual);
        if (before)
            for (const DeviceParameter<Spec>& its : driverOf(*before).parameters)
                if (its.facts == each.facts && its.applies(*before))
                    was = its.get(*before);
        widened.parameter(*each.facts, was, each.get(*after));
    }
}

void addRig(Widened& widened, const std::optional<RigSpec>& before, const std::optional<RigSpec>& after) {
    const auto isUnattended = [](const std::optional<RigSpec>& rig) {
        return rig && rig->source && rig->source->mayHeatUnattended;
    };
    if (isUnattended(after) && !isUnattended(before))
        widened.add(QT_TRANSLATE_NOOP("Parameter", "heat without a watchdog"),
                    QT_TRANSLATE_NOOP("Parameter", "not allowed"), QT_TRANSLATE_NOOP("Parameter", "allowed"));
    const RigSpec was = before.value_or(RigSpec()), is = after.value_or(RigSpec());
    addDevice(widened, was.robot, is.robot);
    addDevice(widened, was.thermometer, is.thermometer);
    addDevice(widened, was.source, is.source);
}

template <class Spec> void forgetLimits(std::optional<Spec>& device) {
    if (device)
        device = withUsualLimits(*device);
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
    if (usual.rig) {
        forgetLimits(usual.rig->robot);
        forgetLimits(usual.rig->thermometer);
        forgetLimits(usual.rig->source);
        if (usual.rig->source)
            usual.rig->source->mayHeatUnattended = false;
    }
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
