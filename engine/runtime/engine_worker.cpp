#include "engine/runtime/engine_worker.h"

#include "engine/base/message_code.h"
#include "engine/devices/video_camera.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/real_rig.h"
#include "engine/runtime/rig_setup.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <filesystem>

namespace bask {
namespace {

constexpr int kTimer_ms = 20;
constexpr int kRealTimer_ms = 4; ///< real devices are listened to so often
constexpr double kPublish_s = 0.05;
constexpr double kLongestGap_s =
    1.0; ///< of wall time that is made up for, after a suspended or stalled computer
constexpr double kMaxSpeed = 20.0;
constexpr double kDisk_s = 5.0;     ///< between looks at the room on the disk
constexpr double kHeldUp_s = 0.3;   ///< between two looks at real devices
constexpr double kHearing_s = 0.15; ///< until they have said again how they are
constexpr int kLongestStep_ms = 50; ///< of the rig, between looks at the command queue

template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };
template <class... Ts> Overloaded(Ts...) -> Overloaded<Ts...>;

TriedDevice triedState(RealRig& rig) {
    TriedDevice out;
    const auto states = rig.devices();
    if (states.empty())
        return out;
    out.state = states.front();
    const auto add = [&](const Reading& reading) {
        out.temperatures_K.push_back(reading.valid ? reading.value_K : std::nan(""));
    };
    if (out.state.role == DeviceRole::Robot) {
        if (const auto state = rig.robot().state())
            out.coordinates = state->coordinates;
    } else if (out.state.role == DeviceRole::Thermometer) {
        if (const auto readings = rig.thermometer().read())
            std::ranges::for_each(*readings, add);
    } else if (out.state.role == DeviceRole::HeatSource) {
        if (const auto reading = rig.heatSource().read())
            add(*reading);
    }
    return out;
}

double utc_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Offsets that were found with one experiment hold for the other.
bool haveSameSensors(const Experiment& a, const Experiment& b) {
    if (a.objects.size() != b.objects.size() || a.environment_K != b.environment_K ||
        a.rig.has_value() != b.rig.has_value())
        return false;
    return a.rig ? a.rig->thermometer == b.rig->thermometer : a.simulation == b.simulation;
}

/// Where a file is or will be; empty: the system does not tell.
std::optional<double> diskFree_MB(const std::string& file) {
    std::error_code code;
    const auto folder = std::filesystem::absolute(file, code).parent_path();
    const auto space = std::filesystem::space(folder, code);
    return code ? std::nullopt : std::optional(static_cast<double>(space.available) * 1e-6);
}

} // namespace

struct EngineWorker::Session {
    /// By the camera where the experiment has what that takes.
    struct Tracker final : SourceTracker {
        explicit Tracker(Session& owner) : session(owner) {}
        Result<PoseReading> read() override {
            if (session.vision && session.loop.experiment().vision.followsSource())
                return session.vision->read();
            if (session.simulated)
                return session.simulated->sourceTracker().read();
            return PoseReading();
        }
        Session& session;
    };

    explicit Session(const Experiment& experiment)
        : simulated(experiment.rig ? nullptr
                                   : std::make_unique<SimulatedRig>(simulatedRigConfig(experiment))),
          real(experiment.rig ? std::make_unique<RealRig>(experiment, steady) : nullptr), tracker(*this),
          loop(experiment, devices(), clock()), script(experiment.simulation.faults) {
        if (Camera* camera = simulated ? &simulated->camera() : real->camera())
            vision.emplace(*camera, simulated ? "simulated" : experiment.rig->camera, clock());
        if (real)
            real->setGuard(
                [this](const Vector6d& from, const Vector6d& to) { return loop.mayStep(from, to); });
    }

    const Clock& clock() const { return simulated ? simulated->clock() : steady; }
    RigDevices devices() {
        if (!simulated)
            return {real->robot(), real->thermometer(), real->heatSource(), {}, &tracker, true};
        return {simulated->robot(), simulated->thermometer(), simulated->heatSource(),
                [this] { return simulated->trueTemperatures_K(); }, &tracker};
    }

    SteadyClock steady;
    std::unique_ptr<SimulatedRig> simulated; ///< this or the next
    std::unique_ptr<RealRig> real;
    std::optional<VisionThread> vision; ///< where there is a camera
    Tracker tracker;
    ServoLoop loop;
    FaultScript script;
};

struct EngineWorker::RealCamera {
    explicit RealCamera(const std::string& name) : camera(name, clock), vision(camera, name, clock) {}
    SteadyClock clock;
    VideoCamera camera;
    VisionThread vision;
};

EngineWorker::EngineWorker(std::string alarmFile) : m_alarmFile(std::move(alarmFile)) {
    qRegisterMetaType<bask::Command>();
    qRegisterMetaType<bask::Snapshot>();
    qRegisterMetaType<std::shared_ptr<const bask::VisionView>>();
}

EngineWorker::~EngineWorker() = default;

void EngineWorker::start() {
    m_timer = new QTimer(this);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, &EngineWorker::onTimer);
    m_wall.start();
    m_timer->start(kTimer_ms);
    if (!m_alarmFile.empty()) {
        if (auto before = readAlarms(m_alarmFile))
            m_alarms = AlarmLog(std::move(*before));
        else
            m_pending.newEvents.push_back({0.0, before.error().message}); // written anew with the next alarm
    }
    publish();
}

void EngineWorker::shutdown() {
    m_isEnding = true;
    if (m_timer)
        m_timer->stop();
    if (m_isClosing) // by the load that this interrupts: it ends what is left
        return;
    if (m_session && m_session->loop.running())
        m_session->loop.emergencyStop();
    closeSession();
}

// First of all the rig is made safe. Its last words take a moment, in which events are processed.
void EngineWorker::closeSession() {
    m_isClosing = true;
    m_tried.reset();
    if (m_session) {
        m_session->loop.makeSafe();
        if (m_session->real && !m_session->real->sayLastWords())
            tellHeatNotOff();
        record();
    }
    closeRecording();
    if (m_isEnding)
        m_camera.reset();
    m_session.reset();
    m_isClosing = false;
}

void EngineWorker::tellHeatNotOff() {
    std::string port;
    for (const RigDeviceState& device : m_session->real->devices())
        if (device.role == DeviceRole::HeatSource)
            port = device.port;
    const Message message{MessageCode::SafetyHeatNotOff, {port}};
    m_pending.newEvents.push_back({m_session->loop.runTime_s(), message});
    std::vector<AlarmCondition> conditions = m_session->loop.alarmConditions();
    conditions.insert(conditions.begin(), {messageName(message.code), message, 1});
    if (m_alarms.update(utc_s(), conditions))
        keepAlarms();
}

void EngineWorker::post(const bask::Command& command) {
    if (m_isClosing) { // from inside of the last words; of several experiments the newest counts
        if (std::holds_alternative<LoadExperiment>(command))
            std::erase_if(m_waiting,
                          [](const Command& each) { return std::holds_alternative<LoadExperiment>(each); });
        m_waiting.push_back(command);
        return;
    }
    carryOut(command);
    while (!m_waiting.empty() && !m_isEnding) {
        const Command next = std::move(m_waiting.front());
        m_waiting.pop_front();
        carryOut(next);
    }
}

void EngineWorker::carryOut(const Command& command) {
    Result<void> result;
    try {
        result = apply(command);
    } catch (const std::exception& exception) {
        const Message reason{MessageCode::ReasonInternalFault, {exception.what()}};
        if (m_session)
            m_session->loop.fault(reason);
        result = Error(reason.code, {}, reason.args);
    }
    m_pending.refusal = result ? Message{} : result.error().message;
    record();
    closeFinished();
    updateAlarms();
    publish();
}

Result<void> EngineWorker::load(const Experiment& experiment) {
    if (m_session && isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (const auto valid = validate(experiment); !valid)
        return valid;
    const auto zeroing = m_session && haveSameSensors(m_session->loop.experiment(), experiment)
                             ? m_session->loop.zeroing()
                             : std::nullopt;
    closeSession(); // its ports are free before they are opened again
    if (m_isEnding)
        return {};
    m_session = std::make_unique<Session>(experiment);
    ++m_loadId;
    if (zeroing)
        m_session->loop.useZeroing(*zeroing);
    m_untilTick_s = experiment.sampling.period_s;
    m_worked_s = m_session->clock().now_s();
    m_nextTick_s = m_worked_s + experiment.sampling.period_s;
    m_timer->setInterval(m_session->real ? kRealTimer_ms : kTimer_ms);
    watch(m_watch);
    return {};
}

Result<void> EngineWorker::setVision(const VisionSpec& vision) {
    if (const auto set = m_session->loop.setVision(vision); !set)
        return set;
    if (m_session->simulated)
        m_session->simulated->simulatedCamera().setMarkers(markerLayout(vision));
    setTask();
    return {};
}

bool EngineWorker::isInUse() const {
    return m_session->loop.running() || m_session->loop.state() == RunState::Armed;
}

void EngineWorker::watch(const WatchCamera& wanted) {
    m_watch = wanted;
    m_isBoardOut = !isInUse();
    if (m_session->simulated)
        m_session->simulated->simulatedCamera().setBoard(
            wanted.show && !m_camera && m_isBoardOut ? wanted.board : std::nullopt);
    setTask();
}

void EngineWorker::setTask() {
    const Experiment& experiment = m_session->loop.experiment();
    const VisionSpec& vision = experiment.vision;
    VisionTask task;
    task.layout = markerLayout(vision);
    task.camera = vision.camera;
    if (vision.cameraPose)
        task.X_RC = poseFromCoordinates(*vision.cameraPose);
    task.follow = experiment.source.tracked && vision.followsSource();
    if (m_isBoardOut)
        task.board = m_watch.board;
    task.show = m_watch.show && !m_camera;
    if (m_session->vision)
        m_session->vision->setTask(task);
    if (m_camera) {
        task.follow = false;
        task.show = m_watch.show;
        m_camera->vision.setTask(task);
    }
}

Result<void> EngineWorker::choose(const std::string& camera) {
    // The old one is waited for, up to seconds: in a run neither STOP nor the heat's watchdog could.
    if (isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    m_camera = camera.empty() ? nullptr : std::make_unique<RealCamera>(camera);
    watch(m_watch);
    return {};
}

Result<void> EngineWorker::type(double sourceTemperature_K) {
    if (!m_session->real)
        return Error(MessageCode::RigMissing, {});
    return m_session->real->typeSourceTemperature(sourceTemperature_K);
}

Result<void> EngineWorker::tryDevice(const RigSpec& rig) {
    m_tried.reset();
    if (isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (rig.robot || rig.thermometer || rig.source || !rig.camera.empty())
        m_tried = std::make_unique<RealRig>(rig, m_steady);
    return {};
}

void EngineWorker::handOnView() {
    const bool isOwn = !m_camera && m_session && m_session->vision;
    auto view = m_camera ? m_camera->vision.newest() : isOwn ? m_session->vision->newest() : nullptr;
    if (view == m_view)
        return;
    m_view = std::move(view);
    if (m_view)
        emit looked(m_view);
}

Result<void> EngineWorker::armWith(const std::string& recordingPath) {
    ServoLoop& loop = m_session->loop;
    if (!recordingPath.empty()) {
        const double least_MB = loop.experiment().safety.leastDisk_MB;
        const auto free_MB = diskFree_MB(recordingPath);
        if (free_MB && *free_MB < least_MB)
            return Error(MessageCode::SafetyDiskLow, {},
                         {formatNumber(std::floor(*free_MB), 6), formatNumber(least_MB, 6)});
    }
    if (const auto armed = loop.arm(); !armed)
        return armed;
    closeRecording();
    ++m_runId;
    if (recordingPath.empty())
        return {};
    auto writer = SessionRecorder::create(recordingPath, loop.experiment(), m_session->simulated != nullptr);
    if (!writer) {
        (void)loop.disarm();
        return writer.error();
    }
    m_writer = std::move(*writer);
    // The file may have taken its time: the devices are heard before they are judged.
    m_nextTick_s = std::max(m_nextTick_s, m_session->clock().now_s() + loop.experiment().sampling.period_s);
    return {};
}

Result<void> EngineWorker::apply(const Command& command) {
    if (const auto* experiment = std::get_if<LoadExperiment>(&command))
        return load(experiment->experiment);
    if (const auto* speed = std::get_if<SetSimulationSpeed>(&command)) {
        m_speed = std::clamp(speed->factor, 1.0, kMaxSpeed);
        return {};
    }
    if (const auto* one = std::get_if<AcknowledgeAlarm>(&command))
        return acknowledge(one->id);
    if (std::holds_alternative<AcknowledgeAll>(command))
        return acknowledge(std::nullopt);
    if (!m_session)
        return Error(MessageCode::ReasonNoExperiment, {});
    ServoLoop& loop = m_session->loop;
    return std::visit(Overloaded{
                          [](const LoadExperiment&) { return Result<void>(); },
                          [](const SetSimulationSpeed&) { return Result<void>(); },
                          [](const AcknowledgeAlarm&) { return Result<void>(); },
                          [](const AcknowledgeAll&) { return Result<void>(); },
                          [&](const WatchCamera& wanted) { return watch(wanted), Result<void>(); },
                          [&](const ChooseCamera& camera) { return choose(camera.name); },
                          [&](const SetVision& set) { return setVision(set.vision); },
                          [&](const MoveTo& move) { return loop.moveTo(move.coordinates); },
                          [&](const Jog& jog) { return loop.jog(jog.twist); },
                          [&](const HomeRobot&) { return loop.home(); },
                          [&](const ClearRobotAlarm&) { return loop.clearRobotAlarm(); },
                          [&](const SetHeat& set) { return loop.setHeat(set.setPoint_K); },
                          [&](const TypeSourceTemperature& typed) { return type(typed.temperature_K); },
                          [&](const ZeroSensors&) { return loop.zeroSensors(); },
                          [&](const ListPorts&) { return m_pending.ports = serialPorts(), Result<void>(); },
                          [&](const TryDevice& device) { return tryDevice(device.rig); },
                          [&](const Arm& arm) { return armWith(arm.recordingPath); },
                          [&](const Disarm&) { return loop.disarm(); },
                          [&](const Start& start) { return loop.start(start.acceptInfeasible); },
                          [&](const Hold&) { return loop.hold(); },
                          [&](const Resume&) { return loop.resume(); },
                          [&](const Stop&) { return loop.stop(); },
                          [&](const EmergencyStop&) { return loop.emergencyStop(), Result<void>(); },
                          [&](const Reset&) { return loop.reset(); },
                          [&](const SetTargets& set) { return loop.setTargets(set.targets_K); },
                          [&](const ReportInfeasible& report) {
                              return loop.reportInfeasible(report.reason), Result<void>();
                          },
                          [&](const SetController& set) { return loop.setController(set.settings); },
                          [&](const AddNote& note) { return loop.addNote(note.text), Result<void>(); },
                          [&](const SimulateFault& fault) { return applyFault(fault); },
                      },
                      command);
}

Result<void> EngineWorker::applyFault(const SimulateFault& fault) {
    if (!m_session->simulated)
        return Error(MessageCode::FaultOnRealRig, {});
    clearFaults(*m_session->simulated);
    setFault(*m_session->simulated, fault.fault, fault.object, true);
    if (fault.fault != SimulatedFault::None)
        m_session->loop.reportFault(fault.fault, fault.object);
    return {};
}

Result<void> EngineWorker::acknowledge(std::optional<std::uint64_t> id) {
    std::vector<Alarm> seen;
    for (const Alarm& alarm : m_alarms.alarms())
        if (!alarm.isAcknowledged && (!id || alarm.id == *id))
            seen.push_back(alarm);
    const bool changed = id ? m_alarms.acknowledge(*id) : m_alarms.acknowledgeAll();
    if (changed)
        keepAlarms();
    for (const Alarm& alarm : seen)
        if (m_session)
            m_session->loop.reportAcknowledged(alarm);
    return {};
}

void EngineWorker::updateAlarms() {
    if (m_session && m_alarms.update(utc_s(), m_session->loop.alarmConditions()))
        keepAlarms();
}

void EngineWorker::keepAlarms() {
    if (m_alarmFile.empty())
        return;
    const auto written = writeAlarms(m_alarms.alarms(), m_alarmFile);
    if (!written && !m_isAlarmFileBad)
        m_pending.newEvents.push_back(
            {m_session ? m_session->loop.runTime_s() : 0.0, written.error().message});
    m_isAlarmFileBad = !written;
}

void EngineWorker::watchDisk() {
    m_sinceDisk_s = 0.0;
    m_session->loop.setDiskFree_MB(m_writer ? diskFree_MB(m_writer->path()) : std::nullopt);
}

void EngineWorker::onTimer() {
    if (m_isClosing)
        return;
    const double wall_s = std::min(kLongestGap_s, static_cast<double>(m_wall.nsecsElapsed()) * 1e-9);
    m_wall.restart();
    if (m_tried)
        m_tried->work();
    if (m_session) {
        m_sinceDisk_s += wall_s;
        if (m_sinceDisk_s >= kDisk_s)
            watchDisk();
        try {
            if (m_watch.board && m_isBoardOut == isInUse())
                watch(m_watch);
            if (m_session->simulated)
                advanceSimulated(wall_s);
            else
                workReal();
        } catch (const std::exception& exception) {
            m_session->loop.fault({MessageCode::ReasonInternalFault, {exception.what()}});
        }
    }
    handOnView();
    m_rateWindow_s += wall_s;
    if (m_rateWindow_s >= 2.0) {
        m_loopRate_Hz = m_ticksSinceRate / m_rateWindow_s;
        m_ticksSinceRate = 0;
        m_rateWindow_s = 0.0;
    }
    m_sincePublished_s += wall_s;
    const bool changed = m_session && m_session->loop.state() != m_publishedState;
    if (changed || m_sincePublished_s >= kPublish_s)
        publish();
}

void EngineWorker::tick() {
    m_session->loop.tick();
    ++m_ticksSinceRate;
    record();
    closeFinished();
    updateAlarms();
}

/// A hold waits for a person, for a time that they can keep.
double EngineWorker::simulationSpeed() const {
    return m_session && m_session->loop.state() == RunState::Holding ? 1.0 : m_speed;
}

void EngineWorker::advanceSimulated(double wall_s) {
    const double period_s = m_session->loop.experiment().sampling.period_s;
    const double speed = simulationSpeed();
    if (wall_s * speed > m_untilTick_s + 0.5 * period_s && wall_s > 3e-3 * kTimer_ms)
        ++m_lateSteps;
    double dt_s = std::min(wall_s * speed, std::max(wall_s, m_session->vision->lead_s()));
    QElapsedTimer spent;
    spent.start();
    // What does not fit is dropped: simulated time then runs slower than asked, and commands are never kept
    // waiting.
    while (dt_s > 0.0 && spent.elapsed() < kLongestStep_ms) {
        const double step_s = std::min(dt_s, m_untilTick_s);
        m_session->simulated->advance(step_s);
        dt_s -= step_s;
        m_untilTick_s -= step_s;
        if (m_untilTick_s <= 1e-9) {
            ServoLoop& loop = m_session->loop;
            if (loop.running())
                for (const ScriptedFault& raised :
                     m_session->script.play(*m_session->simulated, loop.runTime_s()))
                    loop.reportFault(raised.fault, raised.object);
            m_untilTick_s = period_s;
            tick();
        }
    }
}

void EngineWorker::workReal() {
    m_session->real->work();
    const double now_s = m_session->clock().now_s();
    // Held up itself, it hears first what the devices have said meanwhile, and judges them then.
    if (now_s - m_worked_s > kHeldUp_s)
        m_nextTick_s = now_s + kHearing_s;
    m_worked_s = now_s;
    if (now_s < m_nextTick_s)
        return;
    const double period_s = m_session->loop.experiment().sampling.period_s;
    emit stepped(now_s - m_nextTick_s);
    const double behind = std::floor((now_s - m_nextTick_s) / period_s); // whole periods, which are lost
    m_lateSteps += static_cast<std::uint64_t>(behind);
    m_nextTick_s += (1.0 + behind) * period_s;
    tick();
    m_session->real->work(); // what the tick has asked for goes out now
}

void EngineWorker::closeFinished() {
    if (m_session && !m_session->loop.running() && m_session->loop.state() != RunState::Armed)
        closeRecording();
}

void EngineWorker::record() {
    if (!m_session)
        return;
    LoopRecord rows = m_session->loop.takeRecord();
    if (m_writer) {
        const Result<void> result = m_writer->add(rows);
        if (!result) {
            m_failedWriter = std::move(m_writer);
            m_session->loop.stopFor({MessageCode::ReasonRecorderFailed, {describe(result.error())}});
        }
    }
    std::ranges::move(rows.samples, std::back_inserter(m_pending.newSamples));
    std::ranges::move(rows.events, std::back_inserter(m_pending.newEvents));
    std::ranges::move(rows.notes, std::back_inserter(m_pending.newNotes));
}

void EngineWorker::closeRecording() {
    m_failedWriter.reset();
    if (!m_writer)
        return;
    const std::string outcome = m_session ? m_session->loop.outcome() : std::string();
    if (const auto finished = m_writer->finish(outcome.empty() ? "stopped" : outcome); !finished && m_session)
        m_session->loop.fault({MessageCode::ReasonRecorderFailed, {describe(finished.error())}});
    m_writer.reset();
}

void EngineWorker::publish() {
    Snapshot snapshot = std::exchange(m_pending, Snapshot());
    snapshot.sequence = ++m_sequence;
    snapshot.runId = m_runId;
    snapshot.simulationSpeed = simulationSpeed();
    snapshot.loadId = m_loadId;
    snapshot.loopRate_Hz = m_loopRate_Hz;
    snapshot.lateSteps = m_lateSteps;
    snapshot.alarms = m_alarms.alarms();
    if (m_session) {
        const ServoLoop& loop = m_session->loop;
        snapshot.state = loop.state();
        snapshot.reasons = loop.reasons();
        snapshot.runTime_s = loop.runTime_s();
        snapshot.clock_s = m_session->clock().now_s();
        snapshot.latest = loop.latest();
        snapshot.simulated = m_session->simulated != nullptr;
        if (m_session->simulated)
            snapshot.latest.coordinates = m_session->simulated->simulatedRobot().coordinates();
        else
            snapshot.devices = m_session->real->devices();
        snapshot.sampleTime_s = loop.sampleTime_s();
        snapshot.sampleAge_s = m_session->clock().now_s() - loop.sampleTime_s();
        snapshot.source_K = loop.source_K();
        snapshot.heatOn = loop.heatOn();
        snapshot.isMoving = loop.isMoving();
        snapshot.tracking = loop.tracking();
        snapshot.robotAlarm = loop.robotAlarm();
        snapshot.isPlaceSure = loop.isPlaceSure();
        snapshot.heatSetPoint_K = loop.heatSetPoint_K();
        snapshot.isSourceByHand = m_session->real && m_session->real->heatSource().isByHand();
        snapshot.zeroing = loop.zeroing();
        if (const auto zero = loop.findZero(); !zero)
            snapshot.zeroProblem = zero.error().message;
        snapshot.controller = loop.experiment().controller;
        for (const ObjectSpec& object : loop.experiment().objects)
            snapshot.targets_K.push_back(object.target_K);
    } else {
        snapshot.state = RunState::NotReady;
        snapshot.reasons.push_back({MessageCode::ReasonNoExperiment, {}});
    }
    if (m_tried)
        snapshot.tried = triedState(*m_tried);
    if (m_writer) {
        snapshot.recordingPath = m_writer->path();
        snapshot.recordedRows = m_writer->rows();
    }
    m_publishedState = snapshot.state;
    m_sincePublished_s = 0.0;
    emit published(snapshot);
}

} // namespace bask
