#include "engine/base/words.h"

#include "engine/base/run_state.h"
#include "engine/base/translated.h"

#include <algorithm>
#include <array>
#include <span>

namespace bask {
namespace {

struct VerbWord {
    CommandVerb verb;
    const char* name;
};

constexpr std::array kVerbs{
    VerbWord{CommandVerb::Arm, QT_TRANSLATE_NOOP("Verb", "Arm")},
    VerbWord{CommandVerb::Disarm, QT_TRANSLATE_NOOP("Verb", "Disarm")},
    VerbWord{CommandVerb::Start, QT_TRANSLATE_NOOP("Verb", "Start")},
    VerbWord{CommandVerb::Hold, QT_TRANSLATE_NOOP("Verb", "Hold")},
    VerbWord{CommandVerb::Resume, QT_TRANSLATE_NOOP("Verb", "Resume")},
    VerbWord{CommandVerb::Stop, QT_TRANSLATE_NOOP("Verb", "Stop")},
    VerbWord{CommandVerb::Reset, QT_TRANSLATE_NOOP("Verb", "Reset")},
    VerbWord{CommandVerb::Retreat, QT_TRANSLATE_NOOP("Verb", "Retreat")},
    VerbWord{CommandVerb::SetTargets, QT_TRANSLATE_NOOP("Verb", "Set targets")},
    VerbWord{CommandVerb::Move, QT_TRANSLATE_NOOP("Verb", "Move")},
    VerbWord{CommandVerb::Jog, QT_TRANSLATE_NOOP("Verb", "Jog")},
    VerbWord{CommandVerb::Home, QT_TRANSLATE_NOOP("Verb", "Home")},
    VerbWord{CommandVerb::Heat, QT_TRANSLATE_NOOP("Verb", "Heat")},
    VerbWord{CommandVerb::ConfirmSensor, QT_TRANSLATE_NOOP("Verb", "Confirm sensor")},
    VerbWord{CommandVerb::ClearAlarm, QT_TRANSLATE_NOOP("Verb", "Clear alarm")},
    VerbWord{CommandVerb::Shelve, QT_TRANSLATE_NOOP("Verb", "Shelve")},
    VerbWord{CommandVerb::Unshelve, QT_TRANSLATE_NOOP("Verb", "Unshelve")},
};

const char* nameOf(CommandVerb verb) {
    const auto found = std::ranges::find(kVerbs, verb, &VerbWord::verb);
    return found == kVerbs.end() ? "" : found->name;
}

struct Word {
    const char* name; ///< in files
    const char* text;
};

constexpr std::array kStates{
    Word{"Idle", QT_TRANSLATE_NOOP("State", "Idle")},
    Word{"Not ready", QT_TRANSLATE_NOOP("State", "Not ready")},
    Word{"Ready", QT_TRANSLATE_NOOP("State", "Ready")},
    Word{"Armed", QT_TRANSLATE_NOOP("State", "Armed")},
    Word{"Running", QT_TRANSLATE_NOOP("State", "Running")},
    Word{"Holding", QT_TRANSLATE_NOOP("State", "Holding")},
    Word{"Settled", QT_TRANSLATE_NOOP("State", "Settled")},
    Word{"Stopping", QT_TRANSLATE_NOOP("State", "Stopping")},
    Word{"Stopped", QT_TRANSLATE_NOOP("State", "Stopped")},
    Word{"Fault", QT_TRANSLATE_NOOP("State", "Fault (latched)")},
    // No run's, but why it cannot be.
    Word{"Connecting", QT_TRANSLATE_NOOP("State", "Connecting")},
    Word{"Homing", QT_TRANSLATE_NOOP("State", "Homing")},
    Word{"Over", QT_TRANSLATE_NOOP("State", "Over")},
};

constexpr std::array kFaults{
    Word{"none", QT_TRANSLATE_NOOP("Fault", "Restore all devices")}, // what ends them all
    Word{"sensor-lost", QT_TRANSLATE_NOOP("Fault", "Sensor lost")},
    Word{"sensor-open", QT_TRANSLATE_NOOP("Fault", "Sensor open")},
    Word{"sensor-short", QT_TRANSLATE_NOOP("Fault", "Sensor shorted")},
    Word{"sensor-frozen", QT_TRANSLATE_NOOP("Fault", "Sensor frozen")},
    Word{"sensor-jumping", QT_TRANSLATE_NOOP("Fault", "Sensor jumping")},
    Word{"sensor-off", QT_TRANSLATE_NOOP("Fault", "Sensor off its object")},
    Word{"sensors-swapped", QT_TRANSLATE_NOOP("Fault", "Sensors swapped with the next object")},
    Word{"object-hot", QT_TRANSLATE_NOOP("Fault", "Object heated otherwise")},
    Word{"robot-lost", QT_TRANSLATE_NOOP("Fault", "Robot lost")},
    Word{"robot-alarm", QT_TRANSLATE_NOOP("Fault", "Robot in alarm")},
    Word{"robot-restarted", QT_TRANSLATE_NOOP("Fault", "Robot restarted")},
    Word{"robot-slow", QT_TRANSLATE_NOOP("Fault", "Robot slow")},
    Word{"source-lost", QT_TRANSLATE_NOOP("Fault", "Heat source lost")},
    Word{"source-silent", QT_TRANSLATE_NOOP("Fault", "Heat source without temperature")},
    Word{"source-not-heating", QT_TRANSLATE_NOOP("Fault", "Heat source does not heat")},
    Word{"source-heats-alone", QT_TRANSLATE_NOOP("Fault", "Heat source heats unasked")},
    Word{"source-overheats", QT_TRANSLATE_NOOP("Fault", "Heat source overheats")},
    Word{"source-limited", QT_TRANSLATE_NOOP("Fault", "Heat source limited by itself")},
    Word{"source-keeps-heat", QT_TRANSLATE_NOOP("Fault", "Heat source cannot be switched off")},
    Word{"source-covered", QT_TRANSLATE_NOOP("Fault", "Source hidden from the camera")},
    Word{"camera-lost", QT_TRANSLATE_NOOP("Fault", "Camera lost")},
};

constexpr Word same(const char* text) {
    return {text, text};
}

constexpr std::array kDevices{
    same(QT_TRANSLATE_NOOP("Device", "robot")),
    same(QT_TRANSLATE_NOOP("Device", "thermometer")),
    same(QT_TRANSLATE_NOOP("Device", "thermal camera")),
    same(QT_TRANSLATE_NOOP("Device", "heat source")),
    same(QT_TRANSLATE_NOOP("Device", "heat source kept by hand")),
    same(QT_TRANSLATE_NOOP("Device", "source temperature")),
};

constexpr std::array kDamages{
    same(QT_TRANSLATE_NOOP("Damage", "its database is not whole")),
    same(QT_TRANSLATE_NOOP("Damage", "it is cut short")),
    same(QT_TRANSLATE_NOOP("Damage", "the header of its database was written over")),
    same(QT_TRANSLATE_NOOP("Damage", "it has a format number that no version has")),
    same(QT_TRANSLATE_NOOP("Damage", "a sample is missing")),
    same(QT_TRANSLATE_NOOP("Damage", "it does not say whether the rig was simulated")),
};

std::span<const Word> wordsOf(ArgKind kind) {
    switch (kind) {
    case ArgKind::State:
        return kStates;
    case ArgKind::Fault:
        return kFaults;
    case ArgKind::Device:
        return kDevices;
    case ArgKind::Damage:
        return kDamages;
    default: // the name is the text
        return {};
    }
}

} // namespace

MessageArg verbArg(CommandVerb verb) {
    return nameOf(verb);
}

bool isVerb(const MessageArg& arg, CommandVerb verb) {
    return arg.text() == nameOf(verb);
}

const char* wordContext(ArgKind kind) {
    switch (kind) {
    case ArgKind::Verb:
        return "Verb";
    case ArgKind::State:
        return "State";
    case ArgKind::Fault:
        return "Fault";
    case ArgKind::Device:
        return "Device";
    case ArgKind::Damage:
        return "Damage";
    case ArgKind::Label:
        return "Parameter";
    default:
        return nullptr;
    }
}

const char* wordText(ArgKind kind, const std::string& name) {
    const std::span<const Word> words = wordsOf(kind);
    const auto found = std::ranges::find_if(words, [&](const Word& word) { return name == word.name; });
    return found == words.end() ? name.c_str() : found->text;
}

const char* runStateName(RunState state) {
    switch (state) {
    case RunState::Idle:
        return "Idle";
    case RunState::NotReady:
        return "Not ready";
    case RunState::Ready:
        return "Ready";
    case RunState::Armed:
        return "Armed";
    case RunState::Running:
        return "Running";
    case RunState::Holding:
        return "Holding";
    case RunState::Settled:
        return "Settled";
    case RunState::Stopping:
        return "Stopping";
    case RunState::Stopped:
        return "Stopped";
    case RunState::Fault:
        return "Fault";
    }
    return "";
}

} // namespace bask
