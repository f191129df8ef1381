#include "app/end_signals.h"

#include "engine/base/thread_name.h"

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
    [[maybe_unused]] const ssize_t written = ::send(g_ends[0], &byte, 1, MSG_DONTWAIT | MSG_NOSIGNAL);
}

} // namespace

EndSignals::EndSignals() {
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, g_ends.data()) != 0)
        return; // the signals then end the program at once, as they do by themselves
    m_thread = std::thread([this] {
        nameThread("end signals");
        listen();
    });
    for (const int each : kSignals)
        std::signal(each, told);
}

EndSignals::~EndSignals() {
    if (!m_thread.joinable())
        return;
    for (const int each : kSignals)
        std::signal(each, SIG_DFL);
    ::shutdown(g_ends[0], SHUT_WR); // the thread reads its end
    m_thread.join();
    for (int& end : g_ends)
        ::close(std::exchange(end, -1));
}

void EndSignals::setFirst(std::function<void()> first) {
    const std::lock_guard lock(m_mutex);
    m_first = std::move(first);
}

void EndSignals::listen() {
    char byte = 0;
    while (::read(g_ends[1], &byte, 1) > 0) {
        const std::lock_guard lock(m_mutex);
        if (m_first)
            m_first();
        QMetaObject::invokeMethod(
            qApp, [] { QCoreApplication::exit(); }, Qt::QueuedConnection);
    }
}

} // namespace bask
