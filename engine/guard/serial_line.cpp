#include "engine/guard/serial_line.h"

#include <asm/termbits.h> // any speed; <termios.h> has only some, and declares the same names
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

namespace bask::guard {
namespace {

constexpr int kDrain_ms = 100; // for the last bytes before it is closed, which may be a stop

unsigned bitsFlag(int bits) {
    return bits == 5 ? CS5 : bits == 6 ? CS6 : bits == 7 ? CS7 : CS8;
}

/// Raw: no echo, no line editing, no flow control.
bool makeRaw(int descriptor, const PortSettings& settings) {
    termios2 line{};
    if (::ioctl(descriptor, TCGETS2, &line) != 0)
        return false;
    line.c_iflag = IGNBRK;
    line.c_oflag = 0;
    line.c_lflag = 0;
    line.c_cflag = CREAD | CLOCAL | BOTHER | bitsFlag(settings.dataBits);
    if (settings.parity != 'N')
        line.c_cflag |= PARENB | (settings.parity == 'O' ? PARODD : 0U);
    if (settings.stopBits == 2)
        line.c_cflag |= CSTOPB;
    line.c_ispeed = line.c_ospeed = static_cast<speed_t>(settings.baud);
    line.c_cc[VMIN] = 0;
    line.c_cc[VTIME] = 0;
    return ::ioctl(descriptor, TCSETS2, &line) == 0;
}

/// It stays exclusive when whoever made it so is killed, until its other end is closed, too; a line does not.
bool isPseudoTerminal(unsigned long long device) {
    constexpr unsigned kFirstMajor = 136, kLastMajor = 143; // Linux' numbers for /dev/pts
    return major(device) >= kFirstMajor && major(device) <= kLastMajor;
}

} // namespace

SerialLine::SerialLine(const PortSettings& settings) : m_settings(settings) {
    std::strncpy(m_expected, settings.id, kLongestId - 1);
}

/// The expected one of its names, or the first. By the kernel's own call: the library's allocates.
void SerialLine::findId(unsigned long long device) {
    m_id[0] = '\0';
    const int folder = ::open(m_settings.idFolder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    alignas(dirent64) char entries[4096];
    while (folder >= 0) {
        const ssize_t count = ::getdents64(folder, entries, sizeof entries);
        if (count <= 0)
            break;
        for (ssize_t at = 0; at < count;) {
            const auto& entry = *reinterpret_cast<const dirent64*>(entries + at);
            at += entry.d_reclen;
            struct stat there {};
            if (::fstatat(folder, entry.d_name, &there, 0) == 0 && S_ISCHR(there.st_mode) &&
                there.st_rdev == device && (m_id[0] == '\0' || std::strcmp(entry.d_name, m_expected) == 0))
                std::strncpy(m_id, entry.d_name, kLongestId - 1);
        }
    }
    if (folder >= 0)
        ::close(folder);
}

int SerialLine::open() {
    close();
    struct stat there {};
    if (::stat(m_settings.path, &there) != 0)
        return errno;
    findId(there.st_rdev);
    if (m_expected[0] == '\0')
        std::strncpy(m_expected, m_id, kLongestId - 1);
    if (std::strcmp(m_id, m_expected) != 0)
        return kExchanged;
    const int opened = ::open(m_settings.path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (opened < 0)
        return errno;
    int problem = 0;
    // The second keeps out a program of root's too, which the first does not.
    if (!isPseudoTerminal(there.st_rdev) && ::ioctl(opened, TIOCEXCL) != 0)
        problem = errno;
    else if (::flock(opened, LOCK_EX | LOCK_NB) != 0)
        problem = EBUSY;
    else if (!makeRaw(opened, m_settings))
        problem = errno;
    if (problem != 0) {
        ::close(opened);
        return problem;
    }
    m_descriptor = opened;
    ::ioctl(m_descriptor, TCFLSH, TCIOFLUSH);
    return 0;
}

void SerialLine::close() {
    if (m_descriptor < 0)
        return;
    int unsent = 0;
    for (int i = 0; i < kDrain_ms && ::ioctl(m_descriptor, TIOCOUTQ, &unsent) == 0 && unsent > 0; ++i)
        ::poll(nullptr, 0, 1);
    ::ioctl(m_descriptor, TCFLSH, TCIOFLUSH); // or the system waits for up to half a minute
    ::ioctl(m_descriptor, TIOCNXCL);
    ::close(m_descriptor);
    m_descriptor = -1;
}

long SerialLine::read(void* bytes, std::size_t max) {
    const ssize_t count = ::read(m_descriptor, bytes, max);
    if (count > 0)
        return count;
    if (count < 0 && (errno == EAGAIN || errno == EINTR))
        return 0;
    if (count < 0)
        return -1;
    // With VMIN 0 a read of nothing is nothing there, unless the line is hung up.
    pollfd state{m_descriptor, POLLIN, 0};
    ::poll(&state, 1, 0);
    return (state.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 ? -1 : 0;
}

} // namespace bask::guard
