#include "app/commands/end_signal.h"

#include <csignal>

namespace bask {
namespace {

volatile std::sig_atomic_t hasCome = 0;

} // namespace

void catchEndSignals() {
    hasCome = 0;
    for (const int signal : {SIGINT, SIGTERM})
        std::signal(signal, [](int) { hasCome = 1; });
}

bool hasEndSignal() {
    return hasCome != 0;
}

} // namespace bask
