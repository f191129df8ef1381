#pragma once
// Which alarms need no action by a person.

#include "engine/base/message.h"

namespace bask {

/// Returns whether this is an alarm of priority 3 that neither pauses nor ends anything. It is only listed:
/// it does not sound the horn, come to the front, or end a recipe.
bool isNotice(MessageCode code);

} // namespace bask
