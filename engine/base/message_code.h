#pragma once
// The codes of all messages: one code for each sentence, generated from message_table.inc and
// alarm_table.inc.

namespace bask {

/// Codes of the sentences; MessageCode::None means no sentence.
enum class MessageCode : int {
    None,
#include "engine/base/message_names.inc" // made by the build: "FileNotFound," ...
};

struct Message;
/// Returns whether the arguments of `code` are the name of another message and that message's arguments, as
/// messageWithin reads them.
bool isAboutAnother(MessageCode code);
/// Returns the message `code` with `about` as its inner message.
Message messageAbout(MessageCode code, const Message& about);

} // namespace bask
