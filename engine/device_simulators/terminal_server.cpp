#include "engine/device_simulators/terminal_server.h"

#include "engine/base/message_code.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

namespace bask {

int openRawTerminal(const std::string& path) {
    const int terminal = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    if (terminal < 0)
        return -1;
    termios settings{};
    const bool read = ::tcgetattr(terminal, &settings) == 0;
    ::cfmakeraw(&settings);
    if (read && ::tcsetattr(terminal, TCSANOW, &settings) == 0)
        return terminal;
    const int reason = errno;
    ::close(terminal);
    errno = reason;
    return -1;
}

Result<std::unique_ptr<TerminalServer>> TerminalServer::open(ByteDevice& device, const std::string& path) {
    const int terminal = openRawTerminal(path);
    if (terminal < 0)
        return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
    return std::unique_ptr<TerminalServer>(new TerminalServer(device, terminal, path));
}

TerminalServer::TerminalServer(ByteDevice& device, int terminal, std::string path)
    : m_pump(device), m_terminal(terminal), m_path(std::move(path)) {}

TerminalServer::~TerminalServer() {
    if (m_terminal >= 0)
        ::close(m_terminal);
}

void TerminalServer::work(double now_s) {
    if (m_terminal < 0 && now_s >= m_nextOpen_s) {
        m_terminal = openRawTerminal(m_path);
        m_nextOpen_s = now_s + kReopen_s;
    }
    if (m_terminal >= 0 && m_pump.work(m_terminal, now_s))
        return;
    if (m_terminal >= 0)
        ::close(m_terminal);
    m_terminal = -1;
    m_pump.discard(now_s);
}

} // namespace bask
