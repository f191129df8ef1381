#pragma once
// What a command needs to drive a real rig: the engine on its thread, and the signals that end it.

#include "app/data_folder.h"
#include "engine/runtime/engine_worker.h"

#include <QThread>

#include <csignal>
#include <utility>
#include <vector>

namespace bask {

/// A device that has just been connected answers a moment later: until then the engine is reset this often.
constexpr double kBetweenResets_s = 1.0;

/// Counts signals during its lifetime, those that are not ignored; afterwards they do what they did before.
/// Only one object at a time.
class SignalCount {
public:
    static constexpr int kLook_ms = 20; ///< between two looks at it

    SignalCount();
    ~SignalCount();
    SignalCount(const SignalCount&) = delete;
    SignalCount& operator=(const SignalCount&) = delete;
    int now() const;
    int last() const; ///< number of the signal that came last; 0: none

private:
    struct Before {
        int signal;
        struct sigaction action;
    };
    std::vector<Before> m_before;
};

/// Ends the program by a signal that was counted, as it would have ended it at once. No SignalCount is there.
[[noreturn]] void endBySignal(int signal);

/// Runs the engine on its own thread, so that a blocked terminal does not delay it.
class EngineThread {
public:
    EngineThread();
    ~EngineThread(); ///< enters the safe state first
    template <class Work> void ask(Work work, Qt::ConnectionType how = Qt::QueuedConnection) {
        QMetaObject::invokeMethod(&worker, std::move(work), how);
    }
    void post(const Command& command);
    EngineWorker worker{{}, deviceFile().toStdString()};

private:
    QThread m_thread;
};

} // namespace bask
