#include "app/end_signals.h"

#include <QCoreApplication>

#include <array>
#include <csignal>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace bask {
namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
std::array<int, 2> g_ends{-1, -1};

// Only what a handler may do.
void told(int) {
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = ::write(g_ends[0], &byte, 1);
}

} // namespace

EndSignals::EndSignals() {
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, g_ends.data()) != 0)
        return; // the signals then end the program at once, as they do by themselves
    m_notifier = new QSocketNotifier(g_ends[1], QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, [this] {
        m_notifier->setEnabled(false);
        QCoreApplication::exit();
    });
    for (const int each : kSignals)
        std::signal(each, told);
}

EndSignals::~EndSignals() {
    if (m_notifier == nullptr)
        return;
    for (const int each : kSignals)
        std::signal(each, SIG_DFL);
    for (int& end : g_ends)
        ::close(std::exchange(end, -1));
}

} // namespace bask
