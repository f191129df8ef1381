#pragma once
// What a command needs to drive a real rig: the engine on its thread, and the signals that end it.

#include "app/data_folder.h"
#include "engine/runtime/engine_worker.h"

#include <QThread>

#include <utility>

namespace bask {

/// Counts signals during its lifetime. Only one object at a time.
class SignalCount {
public:
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
