#include "app/commands/engine_thread.h"

#include "app/data_folder.h"

#include <array>

#include <unistd.h>

namespace bask {
namespace {

volatile std::sig_atomic_t g_signals = 0, g_last = 0;

constexpr std::array kCounted{SIGINT, SIGTERM, SIGHUP};
// A stopped program would leave a hot plate to itself; a closed pipe must not end it either.
constexpr std::array kIgnored{SIGTSTP, SIGTTOU, SIGPIPE};

void count(int signal) {
    g_signals = g_signals + 1;
    g_last = signal;
}

} // namespace

SignalCount::SignalCount() {
    g_signals = 0;
    g_last = 0;
    const auto set = [this](int signal, void (*handler)(int)) {
        Before& before = m_before.emplace_back(Before{signal, {}});
        struct sigaction action {};
        action.sa_handler = handler;
        action.sa_flags = SA_RESTART;
        ::sigaction(signal, nullptr, &before.action);
        if (before.action.sa_handler != SIG_IGN) // as SIGHUP under nohup
            ::sigaction(signal, &action, nullptr);
    };
    for (const int each : kCounted)
        set(each, count);
    for (const int each : kIgnored)
        set(each, SIG_IGN);
}

SignalCount::~SignalCount() {
    for (const Before& before : m_before)
        ::sigaction(before.signal, &before.action, nullptr);
}

int SignalCount::now() const {
    return g_signals;
}

int SignalCount::last() const {
    return g_last;
}

void endBySignal(int signal) {
    ::kill(::getpid(), signal);
    for (;;)
        ::pause();
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
