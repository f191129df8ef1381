#pragma once
// What a command needs to drive a real rig: the engine on its thread, and the signals that end it.

#include "app/data_folder.h"
#include "engine/runtime/engine_worker.h"

#include <QThread>

#include <utility>

namespace bask {

/// A device that has just been connected answers a moment later: until then the engine is reset this often.
constexpr double kBetweenResets_s = 1.0;

/// Counts signals during its lifetime. Only one object at a time.
class SignalCount {
public:
    static constexpr int kLook_ms = 20; ///< between two looks at it

    SignalCount();
    ~SignalCount();
    int now() const;
};

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
