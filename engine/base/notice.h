#pragma once
// Which alarms ask nothing of a person.

#include "engine/base/message.h"

namespace bask {

/// An alarm of priority 3 that holds and ends nothing: it is listed, and neither sounds the horn, comes to
/// the front, nor ends a recipe.
bool isNotice(MessageCode code);

} // namespace bask
