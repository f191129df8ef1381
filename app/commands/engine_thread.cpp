#include "app/commands/engine_thread.h"

#include "app/data_folder.h"

#include <array>
#include <csignal>

namespace bask {
namespace {

volatile std::sig_atomic_t g_signals = 0;

constexpr std::array kCounted{SIGINT, SIGTERM, SIGHUP};
// A stopped program would leave a hot plate to itself; a closed pipe must not end it either.
constexpr std::array kIgnored{SIGTSTP, SIGTTOU, SIGPIPE};

void count(int) {
    g_signals = g_signals + 1;
}

} // namespace

SignalCount::SignalCount() {
    g_signals = 0;
    for (const int each : kCounted)
        std::signal(each, count);
    for (const int each : kIgnored)
        std::signal(each, SIG_IGN);
}

SignalCount::~SignalCount() {
    for (const int each : kCounted)
        std::signal(each, SIG_DFL);
    for (const int each : kIgnored)
        std::signal(each, SIG_DFL);
}

int SignalCount::now() const {
    return g_signals;
}

EngineThread::EngineThread() : worker(alarmFile().toStdString()) {
    m_thread.setObjectName(QStringLiteral("engine"));
    worker.moveToThread(&m_thread);
    m_thread.start();
}

EngineThread::~EngineThread() {
    ask([this] { worker.shutdown(); }, Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

void EngineThread::post(const Command& command) {
    ask([this, command] { worker.post(command); });
}

} // namespace bask
