#pragma once
// For commands that serve until Ctrl+C or SIGTERM.

namespace bask {

void catchEndSignals();
/// Whether one of them has come since.
bool hasEndSignal();

} // namespace bask
