#pragma once
// Everything Bask says in words, as a code and its arguments. The sentences are in message_table.inc and
// alarm_table.inc, in English; whoever shows one translates it.

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Names of sentences, see message_code.h: only files that say one need be built again for a new one.
enum class MessageCode : int;

/// A sentence to be: code and ordered arguments (already formatted numbers or names).
struct Message {
    MessageCode code{}; ///< MessageCode::None
    std::vector<std::string> args;

    bool operator==(const Message&) const = default;
};

/// English template of a code, with %1 ... %9; never null. Translators see it in context "Message".
const char* messageTemplate(MessageCode code);

/// English sentence with the arguments put in.
std::string describe(const Message& message);

/// What an EventAlarmOver is about, or another message whose arguments are the name of a message and that
/// one's (isAboutAnother); empty: any other, or one of a recording that has words there.
std::optional<Message> messageWithin(const Message& message);

/// Priority as an alarm, 1 the highest (a person must act), 3 a notice; 0: not an alarm.
int alarmPriority(MessageCode code);

/// Stable name of a code ("FileNotFound"), as recorded in session files; and back (None when unknown).
const char* messageName(MessageCode code);
MessageCode messageCodeFromName(const std::string& name);

/// Number in a sentence: %.*g with `digits` significant digits.
std::string formatNumber(double value, int digits = 4);

} // namespace bask
