#pragma once
// A pseudo-terminal for a program that writes otherwise on a terminal.

#include <QByteArray>

#include <cstdlib>

#include <fcntl.h>
#include <unistd.h>

namespace bask::test {

/// A pseudo-terminal; what was written into its far end comes out of it.
class Terminal {
public:
    Terminal() {
        if (m_near >= 0 && ::grantpt(m_near) == 0 && ::unlockpt(m_near) == 0)
            m_far = ::open(::ptsname(m_near), O_RDWR | O_NOCTTY | O_CLOEXEC);
    }
    ~Terminal() {
        ::close(m_far);
        ::close(m_near);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    int far() const { return m_far; }
    QByteArray written() {
        char bytes[4096];
        for (ssize_t count = 0; (count = ::read(m_near, bytes, sizeof bytes)) > 0;)
            m_written.append(bytes, count);
        return m_written;
    }

private:
    int m_near = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    int m_far = -1;
    QByteArray m_written;
};

} // namespace bask::test
