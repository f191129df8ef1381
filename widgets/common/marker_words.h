#pragma once
// Words for the lines that mark events on the traces.

#include "engine/base/message.h"

#include <QString>

namespace bask {

/// Returns one or two words for the events that are drawn on the traces; empty for the others.
QString markerWord(MessageCode code);

} // namespace bask
