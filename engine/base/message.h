#pragma once
// Every text that Bask shows, as a code and its arguments. The English sentences are in message_table.inc and
// alarm_table.inc, with the kind of each argument; the code that shows a message translates it.

#include "engine/base/message_arg.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Codes of the sentences, see message_code.h. Only files that use a code must be rebuilt when one is added.
enum class MessageCode : int;

/// A sentence before it is written out: code and ordered arguments.
struct Message {
    MessageCode code{}; ///< MessageCode::None
    std::vector<MessageArg> args;

    bool operator==(const Message&) const = default;
};

/// Returns the English template of a code, with %1 ... %9; never null. Its translation context is "Message".
const char* messageTemplate(MessageCode code);

/// Returns the kind of the argument `index` of a message, counted from 0, as the message table declares it.
ArgKind argKind(MessageCode code, std::size_t index);

/// Returns the English sentence with its arguments inserted.
std::string describe(const Message& message);

/// Returns the arguments as files store them. To read them back, put these texts into a message.
std::vector<std::string> argTexts(const Message& message);

/// Returns the inner message of a message about another one (isAboutAnother), for example of EventAlarmOver.
/// Empty for any other message, and for a recording that stores words there.
std::optional<Message> messageWithin(const Message& message);

/// Returns the priority as an alarm: 1 is the highest (a person must act), 3 is a notice, 0 is not an alarm.
int alarmPriority(MessageCode code);

/// Returns the stable name of a code ("FileNotFound"), as recorded in session files.
const char* messageName(MessageCode code);
/// The reverse; MessageCode::None if the name is unknown.
MessageCode messageCodeFromName(const std::string& name);

} // namespace bask
