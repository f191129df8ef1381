#pragma once
// Words of the engine's own that stand in its sentences: what a person asks for, states, simulated faults,
// devices. Each has a name, which files and recordings keep, and an English text that is translated.

#include "engine/base/message_arg.h"

namespace bask {

/// What a person can ask the engine for.
enum class CommandVerb {
    Arm,
    Disarm,
    Start,
    Hold,
    Resume,
    Stop,
    Reset,
    Retreat,
    SetTargets,
    Move,
    Jog,
    Home,
    Heat,
    ConfirmSensor,
    ClearAlarm,
    Shelve,
    Unshelve
};

/// The verb as an argument of a sentence (ArgKind::Verb).
MessageArg verbArg(CommandVerb verb);
/// Returns whether `arg` is this verb.
bool isVerb(const MessageArg& arg, CommandVerb verb);

/// Where translators find the words of a kind: "Verb", "State", "Fault", "Device", "Damage" or "Parameter";
/// null: its arguments are no words.
const char* wordContext(ArgKind kind);
/// English text of a word, "Sensor lost" for the fault "sensor-lost"; what has none is shown by its name.
const char* wordText(ArgKind kind, const std::string& name);

} // namespace bask
