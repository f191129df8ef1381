#include "app/commands/progress.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace bask {
namespace {

constexpr double kQuiet_s = 1.0, kOnTerminal_s = 0.2, kElsewhere_s = 60.0;

double seconds(std::chrono::steady_clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

} // namespace

std::string roughDuration(double time_s) {
    constexpr double kMinute_s = 60.0, kHour_s = 3600.0, kDay_s = 86400.0;
    const auto whole = [](double value) { return std::to_string(std::llround(value)); };
    if (!(time_s >= 0.0 && time_s < 1e5 * kDay_s))
        return "an unknown time";
    if (time_s < 100.0)
        return whole(time_s) + " s";
    if (time_s < 100.0 * kMinute_s)
        return whole(time_s / kMinute_s) + " min";
    if (time_s < 2.0 * kDay_s) {
        const long long minutes = std::llround(time_s / kMinute_s);
        return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
    }
    return time_s < 100.0 * kHour_s ? whole(time_s / kHour_s) + " h" : whole(time_s / kDay_s) + " days";
}

Progress::Progress(double total, std::string unit, Total kind)
    : m_total(total), m_unit(std::move(unit)), m_kind(kind), m_isTerminal(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
    if (m_isShown && m_isTerminal)
        std::fputc('\n', stderr);
}

void Progress::makeRoom() {
    if (m_isShown && m_isTerminal) {
        std::fputs("\r\033[K", stderr);
        m_isShown = false;
    }
}

ShareDone Progress::share() {
    return [this](double part) { tell(part * m_total); };
}

void Progress::tell(double done, const std::function<std::string()>& besides) {
    const Clock::time_point now = Clock::now();
    const double since_s = seconds(now - m_start);
    const bool isEnd = m_isShown && done >= m_total;
    if (since_s < kQuiet_s ||
        (!isEnd && seconds(now - m_told) < (m_isTerminal ? kOnTerminal_s : kElsewhere_s)))
        return;
    m_told = now;
    m_isShown = true;
    char text[160];
    if (m_unit.empty())
        std::snprintf(text, sizeof text, "%.0f %%", 100.0 * done / m_total);
    else
        std::snprintf(text, sizeof text, "%.0f of %s%.0f %s (%.0f %%)", done,
                      m_kind == Total::AtMost ? "at most " : "", m_total, m_unit.c_str(),
                      100.0 * done / m_total);
    std::string more;
    if (done > 0.0 && done < m_total)
        more = (m_kind == Total::AtMost ? ", at most " : ", about ") +
               roughDuration(since_s * (m_total - done) / done) + " left";
    if (besides)
        more += ", " + besides();
    if (m_isTerminal)
        std::fprintf(stderr, "\r%s%s\033[K", text, more.c_str()); // what was there before is erased
    else
        std::fprintf(stderr, "%s%s\n", text, more.c_str());
}

} // namespace bask
