#include "engine/guard/guard_log.h"

#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <pthread.h>
#include <syslog.h>
#include <unistd.h>

namespace bask::guard {
namespace {

constexpr int kLongest = 400; // of a line; less than what a pipe takes at once
constexpr std::size_t kStack = 128 * 1024;

struct Line {
    char text[kLongest];
};

/// "2026-11-23T19:20:01.123Z". The library's gmtime_r opens /etc/localtime when it is first called.
void writeTime(char* out, std::size_t size) {
    namespace time = std::chrono;
    timespec now{};
    ::clock_gettime(CLOCK_REALTIME, &now);
    const time::sys_seconds second{time::seconds(now.tv_sec)};
    const auto day = time::floor<time::days>(second);
    const time::year_month_day date(day);
    const time::hh_mm_ss clock(second - day);
    std::snprintf(out, size, "%04d-%02u-%02uT%02d:%02d:%02d.%03dZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                  static_cast<int>(clock.seconds().count()), static_cast<int>(now.tv_nsec / 1000000));
}

} // namespace

GuardLog::GuardLog(const char* file, const char* port) : m_file(file), m_port(port) {
    if (::pipe2(m_ends, O_CLOEXEC) != 0)
        return;
    ::fcntl(m_ends[1], F_SETFL, O_NONBLOCK);
    ::openlog("bask-guard", LOG_PID | LOG_NDELAY, LOG_DAEMON);
    pthread_attr_t attributes;
    ::pthread_attr_init(&attributes);
    ::pthread_attr_setstacksize(&attributes, kStack); // all of it is locked in memory
    m_isRunning = ::pthread_create(&m_thread, &attributes, run, this) == 0;
    ::pthread_attr_destroy(&attributes);
}

void GuardLog::say(const char* format, ...) {
    Line line{};
    writeTime(line.text, sizeof line.text);
    const std::size_t begun = std::strlen(line.text);
    const int named = std::snprintf(line.text + begun, sizeof line.text - begun,
                                    " bask-guard[%d] %.100s: ", static_cast<int>(::getpid()), m_port);
    const std::size_t at = begun + static_cast<std::size_t>(named);
    va_list values;
    va_start(values, format);
    std::vsnprintf(line.text + at, sizeof line.text - at, format, values);
    va_end(values);
    [[maybe_unused]] const ssize_t taken = ::write(m_ends[1], &line, sizeof line);
}

void* GuardLog::run(void* log) {
    const GuardLog& self = *static_cast<const GuardLog*>(log);
    Line line{};
    while (::read(self.m_ends[0], &line, sizeof line) == static_cast<ssize_t>(sizeof line)) {
        line.text[sizeof line.text - 1] = '\0';
        self.write(line.text);
    }
    return nullptr;
}

void GuardLog::write(const char* line) const {
    char text[kLongest + 1];
    const int count = std::snprintf(text, sizeof text, "%s\n", line);
    const auto size = static_cast<std::size_t>(count);
    ::syslog(LOG_ALERT, "%s", line);
    if (m_file[0] == '\0')
        return;
    const int file = ::open(m_file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file < 0)
        return;
    [[maybe_unused]] const ssize_t written = ::write(file, text, size);
    ::close(file);
}

void GuardLog::finish() {
    ::close(m_ends[1]);
    timespec until{};
    ::clock_gettime(CLOCK_REALTIME, &until);
    ++until.tv_sec;
    if (m_isRunning)
        ::pthread_timedjoin_np(m_thread, nullptr, &until);
}

} // namespace bask::guard
