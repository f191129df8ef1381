#pragma once
// The guard's log, written to the system's log and to a file by its own thread, so that a disk that hangs
// does not block the guard.

namespace bask::guard {

class GuardLog {
public:
    /// `file`: lines are appended to it; empty: to none. Each line names `port`.
    GuardLog(const char* file, const char* port);

    /// Logs one line, formatted as by printf; it is lost if a thousand lines are waiting.
    [[gnu::format(printf, 2, 3)]] void say(const char* format, ...);
    /// Waits until everything is written, at most a second.
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
