#include "engine/guard/port_opener.h"

#include <cerrno>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

namespace bask::guard {
namespace {

constexpr std::size_t kOpenerStack = 128 * 1024; // all of it is locked in memory

} // namespace

PortOpener::PortOpener(GuardedPort& port) : m_port(port) {
    if (::pipe2(m_wanted, O_CLOEXEC) != 0 || ::pipe2(m_done, O_CLOEXEC) != 0)
        return;
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, kOpenerStack);
    m_isRunning = ::pthread_create(&m_thread, &attributes, run, this) == 0;
    ::pthread_attr_destroy(&attributes);
}

void PortOpener::begin() {
    m_isBusy = true;
    const char word = 0;
    if (!m_isRunning || ::write(m_wanted[1], &word, 1) != 1)
        open(); // here, where there is no other way
}

void PortOpener::open() {
    const int problem = m_port.open();
    [[maybe_unused]] const ssize_t written = ::write(m_done[1], &problem, sizeof problem);
}

int PortOpener::take() {
    int problem = EIO;
    while (::read(m_done[0], &problem, sizeof problem) < 0 && errno == EINTR) {
    }
    m_isBusy = false;
    return problem;
}

void* PortOpener::run(void* opener) {
    PortOpener& self = *static_cast<PortOpener*>(opener);
    char word = 0;
    for (;;) {
        const ssize_t count = ::read(self.m_wanted[0], &word, 1);
        if (count == 1)
            self.open();
        else if (count == 0 || errno != EINTR)
            return nullptr;
    }
}

} // namespace bask::guard
