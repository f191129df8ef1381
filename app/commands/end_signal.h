#pragma once
// For commands that serve until Ctrl+C, SIGTERM or the end of their terminal.

namespace bask {

void catchEndSignals();
/// Whether one of them has come since.
bool hasEndSignal();

} // namespace bask
