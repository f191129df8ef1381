#include "app/commands/end_signal.h"

#include <csignal>
#include <initializer_list>

namespace bask {
namespace {

volatile std::sig_atomic_t hasCome = 0;

} // namespace

void catchEndSignals() {
    hasCome = 0;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (std::signal(signal, [](int) { hasCome = 1; }) == SIG_IGN && signal == SIGHUP)
            std::signal(signal, SIG_IGN); // as under nohup
}

bool hasEndSignal() {
    return hasCome != 0;
}

} // namespace bask
