#pragma once
// Everything Bask says in words, as a code and its arguments. The sentences are in message_table.inc and
// alarm_table.inc, in English, with what each argument is; whoever shows one translates it.

#include "engine/base/message_arg.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Names of sentences, see message_code.h: only files that say one need be built again for a new one.
enum class MessageCode : int;

/// A sentence to be: code and ordered arguments.
struct Message {
    MessageCode code{}; ///< MessageCode::None
    std::vector<MessageArg> args;

    bool operator==(const Message&) const = default;
};

/// English template of a code, with %1 ... %9; never null. Translators see it in context "Message".
const char* messageTemplate(MessageCode code);

/// Returns what the argument `index` of a message is, counted from 0, as the table of messages declares it.
ArgKind argKind(MessageCode code, std::size_t index);

/// English sentence with the arguments put in.
std::string describe(const Message& message);

/// The arguments as files keep them. To read them back, put these texts into a message.
std::vector<std::string> argTexts(const Message& message);

/// What an EventAlarmOver is about, or another message whose arguments are the name of a message and that
/// one's (isAboutAnother); empty: any other, or one of a recording that has words there.
std::optional<Message> messageWithin(const Message& message);

/// Priority as an alarm, 1 the highest (a person must act), 3 a notice; 0: not an alarm.
int alarmPriority(MessageCode code);

/// Stable name of a code ("FileNotFound"), as recorded in session files; and back (None when unknown).
const char* messageName(MessageCode code);
MessageCode messageCodeFromName(const std::string& name);

} // namespace bask
