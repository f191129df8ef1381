#include "engine/session/limits_widened.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

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
            add(name, words(celsiusFromKelvin(before_K), "\u00b0C", 1.0),
                words(celsiusFromKelvin(after_K), "\u00b0C", 1.0));
    }
    void add(const std::string& name, const std::string& before, const std::string& after) {
        out.push_back({MessageCode::LimitLooser, {name, before, after}});
    }

    std::vector<Message> out;

private:
    static std::string words(double value, const std::string& unit, double factor) {
        const std::string number = value == kNone ? "no limit" : formatNumber(value * factor, 5);
        return unit.empty() || value == kNone ? number : number + ' ' + unit;
    }
};

/// 0 is no limit.
double acceleration(double value) {
    return value > 0.0 ? value : kNone;
}

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

void addRobot(Widened& widened, const RobotLimits& before, const RobotLimits& after) {
    widened.more("speed", before.maxSpeed_m_s, after.maxSpeed_m_s, "cm/s", 100.0);
    widened.more("rotation", before.maxRotation_rad_s, after.maxRotation_rad_s, "rad/s");
    widened.less("clearance", before.clearance_m, after.clearance_m, "cm", 100.0);
    widened.more("acceleration", acceleration(before.maxAcceleration_m_s2),
                 acceleration(after.maxAcceleration_m_s2), "cm/s2", 100.0);
    widened.more("angular acceleration", acceleration(before.maxAngularAcceleration_rad_s2),
                 acceleration(after.maxAngularAcceleration_rad_s2), "rad/s2");
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

/// An automatic one is kLeastRate_K_s or more; how much more depends on what is heated.
void addRate(Widened& widened, const std::optional<double>& before, const std::optional<double>& after) {
    const std::string name = "largest rate";
    if (after)
        widened.more(name, before.value_or(SafetySpec::kLeastRate_K_s), *after, "K/s");
    else if (before)
        widened.add(name, formatNumber(*before) + " K/s", "automatic");
}

void addWatch(Widened& widened, const SafetySpec& before, const SafetySpec& after) {
    struct Row {
        const char* name;
        double SafetySpec::*value;
        const char* unit;
    };
    constexpr std::array kRaised{Row{"stale periods", &SafetySpec::stalePeriods, ""},
                                 Row{"held limit", &SafetySpec::heldLimit_s, "s"},
                                 Row{"frozen after", &SafetySpec::frozen_s, "s"},
                                 Row{"warming", &SafetySpec::warming_K, "K"},
                                 Row{"cross check", &SafetySpec::crossCheck_K, "K"},
                                 Row{"source heating", &SafetySpec::sourceHeating_s, "s"},
                                 Row{"source band", &SafetySpec::sourceBand_K, "K"},
                                 Row{"source unasked", &SafetySpec::sourceUnasked_K, "K"}};
    widened.hotter("warning limit", before.warning_K, after.warning_K);
    widened.hotter("trip limit", before.trip_K, after.trip_K);
    for (const Row& row : kRaised)
        widened.more(row.name, before.*row.value, after.*row.value, row.unit);
    widened.more("jumps", before.jumps, after.jumps);
    widened.less("least disk", before.leastDisk_MB, after.leastDisk_MB, "MB");
    addRate(widened, before.largestRate_K_s, after.largestRate_K_s);
}

void addRig(Widened& widened, const std::optional<RigSpec>& before, const std::optional<RigSpec>& after) {
    const auto isUnattended = [](const std::optional<RigSpec>& rig) {
        return rig && rig->source && rig->source->mayHeatUnattended;
    };
    if (isUnattended(after) && !isUnattended(before))
        widened.add("heat without a watchdog", "not allowed", "allowed");
}

} // namespace

std::vector<Message> widenedLimits(const Experiment& before, const Experiment& after) {
    Widened widened;
    addObjects(widened, before, after);
    widened.hotter("trip limit of the source", sourceTripLimit_K(before), sourceTripLimit_K(after));
    addWatch(widened, before.safety, after.safety);
    addRobot(widened, before.robot, after.robot);
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
    std::string list;
    for (const Message& each : widened)
        list += (list.empty() ? "" : "; ") + describe(each);
    return list.empty() ? Message{} : Message{MessageCode::LimitsLoosened, {list}};
}

bool widensLimits(const Experiment& before, const Experiment& after) {
    return !widenedLimits(before, after).empty();
}

} // namespace bask
