#pragma once
// The engine on its own thread: takes commands by value, runs rig and loop on a timer, writes the session and
// publishes snapshots.

#include "engine/base/suspend_watch.h"
#include "engine/drivers/modbus_search.h"
#include "engine/drivers/sleep_inhibitor.h"
#include "engine/runtime/alarm_keeper.h"
#include "engine/runtime/alarm_log.h"
#include "engine/runtime/background_thread.h"
#include "engine/runtime/camera_watch.h"
#include "engine/runtime/command.h"
#include "engine/runtime/engine_session.h"
#include "engine/runtime/met_devices.h"
#include "engine/runtime/recordings.h"
#include "engine/runtime/snapshot.h"
#include "engine/runtime/underway.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>
#include <functional>
#include <memory>

Q_DECLARE_METATYPE(bask::Command)
Q_DECLARE_METATYPE(bask::Snapshot)
Q_DECLARE_METATYPE(std::shared_ptr<const bask::VisionView>)
Q_DECLARE_METATYPE(std::shared_ptr<const bask::ThermalView>)

namespace bask {

/// Lives on a QThread; every slot is called through queued connections. Rig and loop are created, used and
/// deleted there. Work that touches a file, or may wait in the system, is done on other threads.
class EngineWorker : public QObject {
    Q_OBJECT
public:
    /// Time to write the remaining data after the heat is off.
    static constexpr std::chrono::milliseconds kLastRows{3000};
    /// Maximum number of rows of each kind that wait for the receiver of snapshots; beyond it the oldest are
    /// dropped. One hour at 10 Hz.
    static constexpr std::size_t kMaxKept = 36000;

    /// `alarmFile` keeps the alarms across restarts, `deviceFile` the known devices; if a name is empty,
    /// nothing is kept. `awake` is a clock that stops while the computer sleeps.
    explicit EngineWorker(std::string alarmFile = {}, std::string deviceFile = {},
                          std::unique_ptr<Clock> awake = std::make_unique<AwakeClock>());
    ~EngineWorker() override;

    /// Sets what gets the state about 20 times a second and at once when it changes, with the events since
    /// the last time, on the engine's thread: also while the receiver of snapshots hangs. It must not wait.
    /// Call it before start().
    void setWatch(EngineWatch watch) { m_watch = std::move(watch); }

    /// Sets what the record of a fault waits for. Call it before start().
    void setRecordEnd(RecordEnd end) { m_recordEnd = end; }

    /// Returns whether a real source was not seen to go off. Call it after shutdown(), on the engine's
    /// thread.
    bool isHeatLeft() const { return m_isHeatLeft; }

public slots:
    void start();
    void post(const bask::Command& command);
    /// Enters the safe state, stops the timer and closes the recording. This may take kLastRows; data that is
    /// not saved by then is reported on standard error. Call it blocking before the thread quits.
    void shutdown();

signals:
    /// A new picture of the thermal camera, about ten a second while they are watched; limited in number as
    /// the snapshots are.
    void sawHeat(const std::shared_ptr<const bask::ThermalView>& view,
                 const std::shared_ptr<const int>& token);
    /// At most Underway::kMax wait in the receiver's queue, besides the answers to commands. A receiver that
    /// was blocked then gets the newest state, and all samples, events and notes up to kMaxKept. `token` is
    /// for counting.
    void published(const bask::Snapshot& snapshot, const std::shared_ptr<const int>& token);
    /// A control step of a real rig has begun this long after it was due. Each full period of it is a step
    /// that was lost.
    void stepped(double lateness_s);
    /// A new view of the watched camera; limited in number as the snapshots are.
    void looked(const std::shared_ptr<const bask::VisionView>& view, const std::shared_ptr<const int>& token);

private:
    void onTimer();
    double simulationSpeed() const;
    void advanceSimulated(double wall_s);
    void workReal();
    void tick();
    Result<void> endRecording();
    Result<void> keep(const KeepPrediction& kept);
    void closeFinished();
    void record();
    void endFailed(const Message& reason);
    void closeRecording();
    void hearBackground();
    void waitForFiles();
    /// Returns what the next session may use.
    KeptRig closeSession(bool isRigKept);
    void tellHeatNotOff();
    void publish();
    void fill(Snapshot& snapshot) const; ///< with the state now
    void addEvents(std::vector<TraceEvent> events);
    void tellWatch();
    void carryOut(const Command& command);
    void carryOutWaiting();
    void answer(const Result<void>& result);
    void dropBegun();
    Result<void> apply(const Command& command);
    Result<void> load(const Experiment& experiment, bool isEdit);
    Result<void> armWith(const Arm& arm);
    Result<void> armNow();
    void finishArming();
    Result<void> startWith(bool acceptInfeasible);
    void finishJudging();
    Result<void> setLabels(const RunLabels& labels);
    Result<void> applyFault(const SimulateFault& fault);
    Result<void> acknowledge(std::optional<std::uint64_t> id); ///< empty for all alarms
    Result<void> shelve(const ShelveAlarm& alarm);
    Result<void> unshelve(std::uint64_t id);
    void updateAlarms();
    void keepAlarms();
    void tell(const Message& message); ///< adds an event
    void tellUnfinished(const Error& error);
    void watchDisk();
    Result<void> setVision(const VisionSpec& vision);
    Result<void> choose(const std::string& camera);
    Result<void> type(double sourceTemperature_K);
    Result<void> tryDevice(const RigSpec& rig);
    Result<void> findUnits(const FindUnits& find);
    Result<void> sendByHand(const SendByHand& send);
    void endSearch();
    void endByHand();
    bool isMoving() const;      ///< as ordered, or as the robot says
    bool isHotOrMoving() const; ///< or a run is armed or on, or a retreat is announced
    void addTraffic(LoopRecord& rows, std::size_t max);
    void endTrial();
    Result<void> accept(DeviceRole role);
    void watchSleep();
    void forwardView();
    void showThermal(double wall_s);
    bool isInUse() const; ///< whether a run is armed or on
    /// Commands wait: a rig is being closed, or Arm or Start is not answered yet.
    bool isBusy() const { return m_isClosing || m_recordings.isBeginning() || m_judging; }

    SteadyClock m_steady; ///< declared before the real rig, so that it outlives it
    std::unique_ptr<Clock> m_awakeClock;
    SuspendWatch m_suspend;
    SleepInhibitor m_sleep;
    bool m_isSleepTold = false;
    std::unique_ptr<EngineSession> m_session;
    Recordings m_recordings; ///< Arm is answered when the file of the new recording exists
    /// The check whether the targets of a run that is to be started can be held.
    struct Judging {
        std::stop_source stop;
        std::future<bool> isFeasible;
    };
    std::optional<Judging> m_judging;
    std::string m_guardLog; ///< in the folder of the alarm file
    AlarmKeeper m_keeper;
    AlarmLog m_alarms;
    MetDevices m_devices;
    double m_sinceDisk_s = 0.0;
    std::future<std::optional<double>> m_diskFree_MB;
    std::future<std::vector<SerialPort>> m_ports;
    QTimer* m_timer = nullptr;
    QElapsedTimer m_wall;
    BackgroundThread m_closer; ///< closes cameras, and ports that were tried
    CameraWatch m_cameras;
    std::shared_ptr<const VisionView> m_view; ///< sent last
    std::unique_ptr<DeviceTrial> m_tried;
    std::unique_ptr<ModbusSearch> m_search;
    int m_searchNumber = 0;
    std::optional<ModbusSearchState> m_searchEnd; ///< of one that was refused or ended
    std::shared_ptr<TrafficLog> m_traffic = std::make_shared<TrafficLog>();
    std::uint64_t m_nextTraffic = 0;        ///< number of the first line that the recording does not have
    std::optional<double> m_trafficUntil_s; ///< with a fault: the last time whose traffic is recorded
    RunLabels m_labels;
    bool m_isClosing = false, m_isEnding = false;
    bool m_isHeatLeft = false;
    std::deque<Command> m_waiting; ///< received while isBusy()
    double m_speed = 1.0;
    double m_untilTick_s = 0.0; ///< for a simulated rig
    double m_nextTick_s = 0.0;  ///< for a real rig
    double m_worked_s = 0.0;    ///< when its devices were served last
    std::uint64_t m_lateSteps = 0;
    std::uint64_t m_runId = 0, m_loadId = 0;
    int m_ticksSinceRate = 0;
    double m_rateWindow_s = 0.0;
    double m_loopRate_Hz = 0.0;
    double m_sincePublished_s = 0.0;
    RunState m_publishedState = RunState::Idle;
    RecordEnd m_recordEnd = RecordEnd::ObjectsAndSourceCold;
    EngineWatch m_watch;
    std::vector<TraceEvent> m_unwatched; ///< since the watch was told last
    RunState m_watchedState = RunState::Idle;
    double m_sinceWatched_s = 0.0;
    Snapshot m_pending; ///< samples, events and notes since the last snapshot
    Underway m_snapshots, m_views, m_thermalViews;
    double m_sinceThermal_s = 0.0;
    std::uint64_t m_sequence = 0;
    BackgroundThread m_system; ///< reads the free disk space and the list of ports
    BackgroundThread m_judge;
};

} // namespace bask
