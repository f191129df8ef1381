#pragma once
// The GUI's side of the engine: owns its thread, sends commands, hands on snapshots, says when no answer
// comes.

#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"
#include "engine/vision/vision_view.h"

#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <memory>

class QThread;

namespace bask {

class EngineWorker;

/// The one GUI-side class that knows the worker. Nothing here waits for the engine but shutDown, and that
/// only so long.
class EngineClient : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kSilence{2000};
    static constexpr std::chrono::milliseconds kEnd{
        8000}; ///< a heat source is given 2 s to go off, files then 3 s

    explicit EngineClient(QObject* parent = nullptr);
    ~EngineClient() override; ///< shutDown with a bound of kEnd

    /// `alarmFile` keeps the alarms over a restart, `deviceFile` which devices were met; empty: nothing does.
    void start(const QString& alarmFile = {}, const QString& deviceFile = {});
    void send(const Command& command);

    /// Safe state, recording closed, thread ended. False when the engine did not answer in time; its thread
    /// is then left to the end of the process, and the devices' own watchdogs act.
    bool shutDown(std::chrono::milliseconds bound);

    /// Begins the same from any thread, also when this one hangs. What it gives may outlive this.
    std::function<void()> ender() const;

    /// After shutDown: a real source was not seen to go off. Its guard goes on without Bask.
    bool isHeatLeft() const { return m_isHeatLeft; }

    bool answering() const { return m_answering; }

signals:
    void snapshot(const bask::Snapshot& snapshot);
    /// A new look at the camera, while it is watched (WatchCamera).
    void looked(const std::shared_ptr<const bask::VisionView>& view);
    /// False when no snapshot has come for kSilence; true with the next one.
    void answeringChanged(bool answering);

private:
    void take(const Snapshot& snapshot);

    struct Ending;

    QThread* m_thread = nullptr;
    EngineWorker* m_worker = nullptr;
    std::shared_ptr<Ending> m_ending;
    QTimer m_silence;
    bool m_answering = true;
    bool m_isHeatLeft = false;
};

} // namespace bask
