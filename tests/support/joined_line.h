#pragma once
// Several devices on one line, as on RS-485: each hears everything, and what any of them says is heard.

#include <array>
#include <atomic>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <termios.h>
#include <thread>
#include <unistd.h>

namespace bask::test {

/// A pseudo-terminal linked at a path, before two others, which are there.
class JoinedLine {
public:
    JoinedLine(const std::string& path, const std::array<std::string, 2>& devices) {
        m_ends[0] = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
        ::grantpt(m_ends[0]);
        ::unlockpt(m_ends[0]);
        makeRaw(m_ends[0]);
        m_own = ::open(::ptsname(m_ends[0]), O_RDWR | O_NOCTTY | O_CLOEXEC); // or it would look hung up
        for (std::size_t i = 0; i < devices.size(); ++i) {
            m_ends[1 + i] = ::open(devices[i].c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
            makeRaw(m_ends[1 + i]);
        }
        m_isThere = ::symlink(::ptsname(m_ends[0]), path.c_str()) == 0 && m_ends[1] >= 0 && m_ends[2] >= 0;
        m_thread = std::thread([this] { join(); });
    }
    ~JoinedLine() {
        m_isOver = true;
        m_thread.join();
        for (const int each : m_ends)
            ::close(each);
        ::close(m_own);
    }
    bool isThere() const { return m_isThere; }

private:
    static void makeRaw(int end) {
        termios raw{};
        ::tcgetattr(end, &raw);
        ::cfmakeraw(&raw);
        ::tcsetattr(end, TCSANOW, &raw);
    }
    void join() const {
        std::array<char, 256> bytes{};
        while (!m_isOver) {
            std::array<pollfd, 3> ends{};
            for (std::size_t i = 0; i < ends.size(); ++i)
                ends[i] = {m_ends[i], POLLIN, 0};
            ::poll(ends.data(), ends.size(), 20);
            for (std::size_t i = 0; i < ends.size(); ++i) {
                const auto count =
                    (ends[i].revents & POLLIN) != 0 ? ::read(m_ends[i], bytes.data(), bytes.size()) : 0;
                for (std::size_t k = i == 0 ? 1 : 0; count > 0 && k < (i == 0 ? ends.size() : 1); ++k)
                    (void)!::write(m_ends[k], bytes.data(), static_cast<std::size_t>(count));
            }
        }
    }

    std::array<int, 3> m_ends{-1, -1, -1}; ///< the host's, then the devices'
    int m_own = -1;
    bool m_isThere = false;
    std::atomic<bool> m_isOver = false;
    std::thread m_thread;
};

} // namespace bask::test
