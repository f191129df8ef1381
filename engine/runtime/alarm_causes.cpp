#include "engine/runtime/alarm_causes.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <array>

namespace bask {
namespace {

using Condition = SafetyCondition;

struct Consequence {
    Condition condition;
    Condition cause;         ///< if a condition has several causes, the nearest first
    bool isOfObject = false; ///< only if both are about the same object
    bool isOfLine = false;   ///< only if thermometer and source share a line
};

// The table has no cycles.
constexpr std::array kConsequences{
    Consequence{Condition::RobotAlarm, Condition::RobotLost},
    Consequence{Condition::RobotSlow, Condition::RobotLost},
    Consequence{Condition::RobotSlow, Condition::RobotAlarm},
    Consequence{Condition::RobotPlaceUnsure, Condition::RobotAlarm},
    Consequence{Condition::RobotPlaceUnsure, Condition::RobotSlow},
    Consequence{Condition::RobotPlaceUnsure, Condition::RobotLost},
    Consequence{Condition::SourceHot, Condition::SourceHeatsUnasked},
    Consequence{Condition::SourceLost, Condition::HeaterGuardGone},
    Consequence{Condition::SourceSilent, Condition::SourceLost},
    Consequence{Condition::HeatNotOff, Condition::SourceLost},
    Consequence{Condition::SetPointOther, Condition::SourceUnit},
    Consequence{Condition::SetPointOther, Condition::SourceLost},
    Consequence{Condition::SourceCold, Condition::SourceUnit},
    Consequence{Condition::SourceNotHeating, Condition::SetPointOther},
    Consequence{Condition::SourceNotHeating, Condition::SourceSilent},
    Consequence{Condition::SourceNotHeating, Condition::SourceLost},
    Consequence{Condition::SourceHeatsUnasked, Condition::SourceLost},
    Consequence{Condition::SourceNotCooling, Condition::SourceHeatsUnasked},
    Consequence{Condition::SourceNotCooling, Condition::SourceLost},
    Consequence{Condition::ThermometerLost, Condition::SourceLost, false, true},
    Consequence{Condition::ThermometerLost, Condition::HeaterGuardGone, false, true},
    Consequence{Condition::SensorOpen, Condition::ThermometerLost},
    Consequence{Condition::SensorShort, Condition::ThermometerLost},
    Consequence{Condition::SensorInvalid, Condition::ThermometerLost},
    Consequence{Condition::SensorStale, Condition::ThermometerLost},
    Consequence{Condition::SensorFrozen, Condition::ThermometerLost},
    Consequence{Condition::NotWarming, Condition::SensorFrozen, true},
    Consequence{Condition::NotWarming, Condition::SensorJump, true},
    Consequence{Condition::NotWarming, Condition::SourceNotHeating},
    Consequence{Condition::NotWarming, Condition::SourceSilent},
    Consequence{Condition::NotWarming, Condition::SourceLost},
    Consequence{Condition::ObjectWarm, Condition::ObjectHot, true},
    Consequence{Condition::ObjectWarm, Condition::HeatedOtherwise, true},
    Consequence{Condition::HeatedAtRest, Condition::ObjectHot, true},
    Consequence{Condition::HeatedAtRest, Condition::ObjectWarm, true},
    Consequence{Condition::TargetLeft, Condition::HeatedOtherwise, true},
    Consequence{Condition::TargetLeft, Condition::NotWarming, true},
    Consequence{Condition::TargetLeft, Condition::SensorFrozen, true},
    Consequence{Condition::TargetLeft, Condition::SourceOver},
    Consequence{Condition::SourceOver, Condition::SourceHot},
    Consequence{Condition::SourceOver, Condition::SourceHeatsUnasked},
    Consequence{Condition::SourceOver, Condition::SetPointOther},
    Consequence{Condition::SourceOver, Condition::SourceUnit},
};

const SafetyFinding* nearestCause(const SafetyFinding& finding, const std::vector<SafetyFinding>& present,
                                  const Experiment& experiment) {
    const bool isOneLine = experiment.rig && hasOneLine(*experiment.rig);
    for (const Consequence& row : kConsequences) {
        if (row.condition != finding.condition || (row.isOfLine && !isOneLine))
            continue;
        const auto cause = std::ranges::find_if(present, [&](const SafetyFinding& other) {
            return other.condition == row.cause && (!row.isOfObject || other.object == finding.object);
        });
        if (cause != present.end())
            return &*cause;
    }
    return nullptr;
}

} // namespace

std::string alarmKey(const SafetyFinding& finding, const Experiment& experiment) {
    const AlarmEntry& row = alarmEntry(finding.condition);
    std::string key = *row.key != '\0' ? row.key : messageName(finding.message.code);
    if (row.isOfObject)
        key += ':' + experiment.objects[finding.object].name;
    else if (finding.condition == Condition::RobotAlarm &&
             finding.message.code == MessageCode::RobotAlarm) // another alarm number is another alarm
        key += ':' + finding.message.args.at(0).text();
    return key;
}

const SafetyFinding* causeOf(const SafetyFinding& finding, const std::vector<SafetyFinding>& present,
                             const Experiment& experiment) {
    const SafetyFinding* cause = nullptr;
    for (const SafetyFinding* next = &finding; (next = nearestCause(*next, present, experiment)) != nullptr;)
        cause = next;
    return cause;
}

} // namespace bask
