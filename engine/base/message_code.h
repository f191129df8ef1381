#pragma once
// The names of everything that Bask says: a code a sentence, made from message_table.inc and alarm_table.inc.

namespace bask {

/// Names of sentences; MessageCode::None is no sentence.
enum class MessageCode : int {
    None,
#include "engine/base/message_names.inc" // made by the build: "FileNotFound," ...
};

struct Message;
/// Returns whether its arguments are the name of another message and that one's arguments, as messageWithin
/// reads them.
bool isAboutAnother(MessageCode code);
/// Returns the message that says `code` about another one.
Message messageAbout(MessageCode code, const Message& about);

} // namespace bask
