#pragma once
// What a command needs that drives a real rig: the engine on its thread, and the signals that end it.

#include "app/data_folder.h"
#include "engine/runtime/engine_worker.h"

#include <QThread>

#include <utility>

namespace bask {

/// Signals are counted while it lives. One at a time.
class SignalCount {
public:
    SignalCount();
    ~SignalCount();
    int now() const;
};

/// The engine has a thread of its own: a terminal that takes no more text must not hold it up.
class EngineThread {
public:
    EngineThread();
    ~EngineThread(); ///< safe state first
    template <class Work> void ask(Work work, Qt::ConnectionType how = Qt::QueuedConnection) {
        QMetaObject::invokeMethod(&worker, std::move(work), how);
    }
    void post(const Command& command);
    EngineWorker worker{{}, deviceFile().toStdString()};

private:
    QThread m_thread;
};

} // namespace bask
