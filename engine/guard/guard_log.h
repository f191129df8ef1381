#pragma once
// The guard's log: to the system's and to a file, by a thread of its own. A disk that hangs does not hang the
// guard.

namespace bask::guard {

class GuardLog {
public:
    /// `file`: lines are appended to it; empty: to none. `port` is named in each line.
    GuardLog(const char* file, const char* port);

    /// One line, formatted as by printf; lost where a thousand wait.
    [[gnu::format(printf, 2, 3)]] void say(const char* format, ...);
    /// Waits for what was said, a second at most.
    void finish();

private:
    static void* run(void* log);
    void write(const char* line) const;

    const char* m_file;
    const char* m_port;
    int m_ends[2] = {-1, -1};
    bool m_isRunning = false;
    unsigned long m_thread = 0;
};

} // namespace bask::guard
