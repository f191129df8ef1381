#pragma once
// The engine on its own thread: takes commands by value, runs rig and loop on a timer, writes the session,
// publishes snapshots.

#include "engine/runtime/alarm_log.h"
#include "engine/runtime/command.h"
#include "engine/runtime/servo_loop.h"
#include "engine/runtime/session_recorder.h"
#include "engine/runtime/snapshot.h"
#include "engine/vision/vision_thread.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>
#include <memory>

Q_DECLARE_METATYPE(bask::Command)
Q_DECLARE_METATYPE(bask::Snapshot)
Q_DECLARE_METATYPE(std::shared_ptr<const bask::VisionView>)

namespace bask {

class RealRig;

/// Lives on a QThread; every slot is called through queued connections. Rig and loop are made, used and
/// deleted there; the session is written on another thread.
class EngineWorker : public QObject {
    Q_OBJECT
public:
    /// `alarmFile`: keeps the alarms over a restart; empty: nothing does.
    explicit EngineWorker(std::string alarmFile = {});
    ~EngineWorker() override;

public slots:
    void start();
    void post(const bask::Command& command);
    /// Safe state, recording closed, timer stopped. Call it blocking before the thread quits.
    void shutdown();

signals:
    void published(const bask::Snapshot& snapshot);
    /// A control step of a real rig has begun, so long after it was due; what is longer than a period is
    /// steps that were lost.
    void stepped(double lateness_s);
    /// A new look at the camera, while it is watched.
    void looked(const std::shared_ptr<const bask::VisionView>& view);

private:
    /// The rig with its loop; made anew with each experiment.
    struct Session;

    void onTimer();
    double simulationSpeed() const;
    void advanceSimulated(double wall_s);
    void workReal();
    void tick();
    void closeFinished();
    void record();
    void closeRecording();
    void closeSession();
    void tellHeatNotOff();
    void publish();
    void carryOut(const Command& command);
    Result<void> apply(const Command& command);
    Result<void> load(const Experiment& experiment);
    Result<void> armWith(const std::string& recordingPath);
    Result<void> applyFault(const SimulateFault& fault);
    Result<void> acknowledge(std::optional<std::uint64_t> id); ///< empty: all
    void updateAlarms();
    void keepAlarms();
    void watchDisk();
    Result<void> setVision(const VisionSpec& vision);
    void watch(const WatchCamera& wanted);
    Result<void> choose(const std::string& camera);
    Result<void> type(double sourceTemperature_K);
    Result<void> tryDevice(const RigSpec& rig);
    void setTask();
    void handOnView();
    bool isInUse() const; ///< a run is armed or on

    std::unique_ptr<Session> m_session;
    std::unique_ptr<SessionRecorder> m_writer, m_failedWriter; ///< that one is waited for after the run
    std::string m_alarmFile;
    AlarmLog m_alarms;
    bool m_isAlarmFileBad = false; ///< told once
    double m_sinceDisk_s = 0.0;
    QTimer* m_timer = nullptr;
    QElapsedTimer m_wall;
    WatchCamera m_watch;
    bool m_isBoardOut = true; ///< not in a run: its search takes long, and a simulated one hides the source
    /// Chosen instead of the simulated camera: watched, never followed by, since it does not see the
    /// simulated rig.
    struct RealCamera;
    std::unique_ptr<RealCamera> m_camera;
    std::shared_ptr<const VisionView> m_view; ///< handed on last
    SteadyClock m_steady;
    std::unique_ptr<RealRig> m_tried; ///< one device alone
    bool m_isClosing = false, m_isEnding = false;
    std::deque<Command> m_waiting; ///< that came while a rig was closed
    double m_speed = 1.0;
    double m_untilTick_s = 0.0; ///< of a simulated rig
    double m_nextTick_s = 0.0;  ///< of a real one
    double m_worked_s = 0.0;    ///< its devices, last
    std::uint64_t m_lateSteps = 0;
    std::uint64_t m_runId = 0, m_loadId = 0;
    int m_ticksSinceRate = 0;
    double m_rateWindow_s = 0.0;
    double m_loopRate_Hz = 0.0;
    double m_sincePublished_s = 0.0;
    RunState m_publishedState = RunState::Idle;
    Snapshot m_pending; ///< samples, events and notes since the last snapshot
    std::uint64_t m_sequence = 0;
};

} // namespace bask
