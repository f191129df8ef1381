#pragma once
// Words of the engine that appear in its sentences: commands, states, simulated faults, devices. Each has a
// name, which files and recordings store, and an English text that is translated.

#include "engine/base/message_arg.h"

namespace bask {

/// The commands that a person can give to the engine.
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

/// Returns the verb as an argument of a sentence (ArgKind::Verb).
MessageArg verbArg(CommandVerb verb);
/// Returns whether `arg` is this verb.
bool isVerb(const MessageArg& arg, CommandVerb verb);

/// Returns the translation context of the words of a kind: "Verb", "State", "Fault", "Device", "Damage" or
/// "Parameter"; null if arguments of this kind are not words.
const char* wordContext(ArgKind kind);
/// Returns the English text of a word, "Sensor lost" for the fault "sensor-lost"; a word without a text is
/// shown by its name.
const char* wordText(ArgKind kind, const std::string& name);

} // namespace bask
