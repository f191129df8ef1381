#include "engine/device_simulators/byte_pump.h"

#include <array>
#include <cerrno>
#include <sys/socket.h>
#include <unistd.h>

namespace bask {
namespace {

/// A device without flow control does not wait for a reader: what comes on top is lost.
constexpr std::size_t kMaxPending = 16384;

bool isForLater() {
    return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

/// A socket whose other end has gone must not raise SIGPIPE.
ssize_t giveSome(int descriptor, const std::string& bytes) {
    const ssize_t given = ::send(descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    return given < 0 && errno == ENOTSOCK ? ::write(descriptor, bytes.data(), bytes.size()) : given;
}

} // namespace

bool BytePump::take(int descriptor, double now_s) {
    std::array<char, 4096> piece{};
    for (;;) {
        const ssize_t taken = ::read(descriptor, piece.data(), piece.size());
        if (taken <= 0)
            return taken < 0 && isForLater();
        m_device.receive({piece.data(), static_cast<std::size_t>(taken)}, now_s);
    }
}

bool BytePump::give(int descriptor) {
    while (!m_pending.empty()) {
        const ssize_t given = giveSome(descriptor, m_pending);
        if (given <= 0)
            return given == 0 || isForLater();
        m_pending.erase(0, static_cast<std::size_t>(given));
    }
    return true;
}

bool BytePump::work(int descriptor, double now_s) {
    if (!take(descriptor, now_s))
        return false;
    const std::string said = m_device.transmit(now_s);
    if (m_pending.size() + said.size() <= kMaxPending)
        m_pending += said;
    return give(descriptor);
}

void BytePump::discard(double now_s) {
    m_device.transmit(now_s);
    m_pending.clear();
}

} // namespace bask
