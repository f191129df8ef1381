#pragma once
// The GUI's side of the engine: owns its thread, sends commands, forwards snapshots, and reports when no
// answer comes.

#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "engine/thermography/thermal_view.h"
#include "engine/vision/vision_view.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>

class QThread;

namespace bask {

class EngineWorker;

/// The only GUI class that knows the worker. Only shutDown() waits for the engine, and only up to its bound.
class EngineClient : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kSilence{2000};
    static constexpr std::chrono::milliseconds kEnd{
        8000}; ///< 2 s for a heat source to go off, then 3 s for files, with a margin

    explicit EngineClient(QObject* parent = nullptr);
    ~EngineClient() override; ///< Calls shutDown with a bound of kEnd.

    /// `alarmFile` keeps the alarms across restarts, `deviceFile` the known devices; if a name is empty,
    /// nothing is kept.
    void start(const QString& alarmFile = {}, const QString& deviceFile = {});
    void send(const Command& command);
    /// As EngineWorker::setWatch(). Call it before start().
    void setWatch(EngineWatch watch) { m_watch = std::move(watch); }

    /// Enters the safe state, closes the recording and ends the thread. Returns false if the engine did not
    /// answer in time; its thread then runs until the process ends, and the devices' own watchdogs act.
    bool shutDown(std::chrono::milliseconds bound);

    /// Returns a function that starts the same from any thread, even if this one hangs. The function may
    /// outlive this object.
    std::function<void()> ender() const;

    /// Whether a real source was not seen to go off; valid after shutDown(). Its guard continues without
    /// Bask.
    bool isHeatLeft() const { return m_isHeatLeft; }

    bool answering() const { return m_answering; }

signals:
    void snapshot(const bask::Snapshot& snapshot);
    /// A new view of the watched camera (WatchCamera).
    void looked(const std::shared_ptr<const bask::VisionView>& view);
    /// A new picture of the thermal camera (WatchThermalCamera).
    void sawHeat(const std::shared_ptr<const bask::ThermalView>& view);
    /// False if no snapshot has come for kSilence; true with the next one.
    void answeringChanged(bool answering);

private:
    void take(const Snapshot& snapshot);

    struct Ending;

    EngineWatch m_watch;
    QThread* m_thread = nullptr;
    EngineWorker* m_worker = nullptr;
    std::shared_ptr<Ending> m_ending;
    QTimer m_silence;
    bool m_answering = true;
    bool m_isHeatLeft = false;
};

} // namespace bask
