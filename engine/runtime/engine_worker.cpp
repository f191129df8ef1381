#include "engine/runtime/engine_worker.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/drivers/heater_guard.h"
#include "engine/rig/rig_setup.h"

#include <QDeadlineTimer>
#include <QThread>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <utility>

namespace bask {
namespace {

constexpr int kTimer_ms = 20;
constexpr int kRealTimer_ms = 4; ///< period of serving real devices
constexpr int kOverdue_ms = 50;  ///< of the timer, when it is late
constexpr double kPublish_s = 0.05;
constexpr double kThermal_s = 0.1; // between two pictures of the thermal camera
constexpr double kLongestGap_s =
    1.0; ///< longest real time that is caught up after a suspended or stalled computer
constexpr double kMaxSpeed = 20.0;
constexpr std::size_t kTrafficAtOnce = 2000; ///< lines of a fault that one control step records
constexpr double kTrafficAfter_s = 60.0;     ///< after a fault
constexpr double kDisk_s = 5.0;              ///< between checks of the free disk space
constexpr double kDelayed_s = 0.3;           ///< between two services of real devices: longer is a delay
constexpr double kHearing_s = 0.15;          ///< until the devices have reported their state again
constexpr int kLongestStep_ms = 50;          ///< of the rig, between checks of the command queue

template <class... Ts> struct Overloaded : Ts... { using Ts::operator()...; };
template <class... Ts> Overloaded(Ts...) -> Overloaded<Ts...>;

/// Appends rows and keeps the newest ones. A tenth is dropped at once, otherwise each new row would move all
/// others.
template <class Row> void append(std::vector<Row>& rows, std::vector<Row>& kept) {
    std::ranges::move(rows, std::back_inserter(kept));
    if (kept.size() > EngineWorker::kMaxKept)
        kept.erase(kept.begin(),
                   kept.begin() + static_cast<std::ptrdiff_t>(kept.size() - EngineWorker::kMaxKept * 9 / 10));
}

/// A command that ends something is carried out at once, whatever is in progress.
bool isEnd(const Command& command) {
    const auto* heat = std::get_if<SetHeat>(&command);
    return std::holds_alternative<Stop>(command) || std::holds_alternative<EmergencyStop>(command) ||
           std::holds_alternative<Hold>(command) || std::holds_alternative<Disarm>(command) ||
           std::holds_alternative<Retreat>(command) || (heat != nullptr && !heat->setPoint_K);
}

/// A command that begins something is void if something was ended after it.
bool isBegin(const Command& command) {
    return std::holds_alternative<Arm>(command) || std::holds_alternative<Start>(command) ||
           std::holds_alternative<Resume>(command) || std::holds_alternative<MoveTo>(command) ||
           std::holds_alternative<Jog>(command) || std::holds_alternative<HomeRobot>(command) ||
           std::holds_alternative<SetHeat>(command);
}

} // namespace

EngineWorker::EngineWorker(std::string alarmFile, std::string deviceFile, std::unique_ptr<Clock> awake)
    : m_awakeClock(std::move(awake)), m_suspend(m_steady, *m_awakeClock),
      m_guardLog(alarmFile.empty()
                     ? std::string()
                     : (std::filesystem::absolute(alarmFile).parent_path() / "guard.log").string()),
      m_keeper(std::move(alarmFile)), m_devices(std::move(deviceFile)), m_cameras(m_closer) {
    // Here and not on the engine's thread, which must not wait for a disk.
    (void)guardProgram();
    qRegisterMetaType<bask::Command>();
    qRegisterMetaType<bask::Snapshot>();
    qRegisterMetaType<std::shared_ptr<const bask::VisionView>>();
    qRegisterMetaType<std::shared_ptr<const bask::ThermalView>>();
}

EngineWorker::~EngineWorker() = default;

void EngineWorker::start() {
    m_timer = new QTimer(this);
    m_timer->setTimerType(Qt::PreciseTimer);
    connect(m_timer, &QTimer::timeout, this, &EngineWorker::onTimer);
    m_wall.start();
    m_timer->start(kTimer_ms);
    if (m_devices.problem() != Message{})
        tell(m_devices.problem());
    publish();
}

void EngineWorker::shutdown() {
    m_isEnding = true;
    if (m_timer)
        m_timer->stop();
    if (m_isClosing) // by the load that this call interrupts: it closes the rest
        return;
    if (m_session && m_session->loop.running())
        m_session->loop.emergencyStop();
    (void)closeSession(false);
    publish(); // the last messages
    tellWatch();
}

// First the rig is made safe. Its last commands take a moment, in which events are processed; a rig that is
// kept for another experiment needs none.
KeptRig EngineWorker::closeSession(bool isRigKept) {
    m_isClosing = true;
    if (m_isEnding)
        dropBegun();
    KeptRig kept;
    if (m_session) {
        endByHand();
        m_session->loop.makeSafe();
        if (m_session->real && !isRigKept && !m_session->real->sayLastWords())
            tellHeatNotOff();
        record();
        closeRecording();
        kept.watcher = isRigKept ? std::move(m_session->vision) : nullptr;
        kept.rig = std::move(m_session->real);
        if (kept.rig)
            kept.rig->setGuard({});
    }
    endTrial();
    endSearch();
    m_session.reset();
    m_isClosing = false;
    if (m_isEnding) {
        m_cameras.close();
        waitForFiles();
    }
    return kept;
}

/// At this point the heat is off, or it was reported that it is not.
void EngineWorker::waitForFiles() {
    const QDeadlineTimer deadline(kLastRows);
    const auto left = [&] { return std::chrono::milliseconds(deadline.remainingTime()); };
    std::vector<std::string> unsaved = m_recordings.unsaved(kLastRows);
    if (!m_keeper.wait(left()))
        unsaved.emplace_back("the list of alarms: the disk does not answer");
    (void)m_closer.wait(left());
    (void)SessionRecorder::waitForAll(left()); // their seals; the rows are known to be saved
    for (const std::string& each : unsaved)
        std::fprintf(stderr, "bask: not saved, or not all of it: %s\n", each.c_str());
}

void EngineWorker::tellHeatNotOff() {
    std::string port;
    for (const RigDeviceState& device : m_session->real->devices())
        if (device.role == DeviceRole::HeatSource)
            port = device.port;
    const Message message{MessageCode::HeatLeftUnknown, {port}};
    m_isHeatLeft = m_isEnding;
    const TraceEvent event{m_session->loop.runTime_s(), message};
    addEvents({event});
    LoopRecord rows;
    rows.events = {event};
    (void)m_recordings.add(std::move(rows)); // errors do not matter: it is about to be closed
    std::vector<AlarmCondition> conditions = m_session->loop.alarmConditions();
    conditions.insert(conditions.begin(), {messageName(message.code), message, 1});
    if (m_alarms.update(utcNow_s(), conditions))
        keepAlarms();
}

void EngineWorker::post(const bask::Command& command) {
    if (m_isEnding)
        return;
    if (isEnd(command) && !m_isClosing) {
        dropBegun();
    } else if (isBusy()) { // if several experiments wait, only the newest is loaded
        m_waiting.push_back(command);
        if (auto* load = std::get_if<LoadExperiment>(&m_waiting.back())) {
            const auto isOlder = [&](const Command& each) {
                const auto* other = std::get_if<LoadExperiment>(&each);
                if (other != nullptr && other != load)
                    load->isEdit = load->isEdit && other->isEdit;
                return other != nullptr && other != load;
            };
            m_waiting.erase(std::remove_if(m_waiting.begin(), std::prev(m_waiting.end()), isOlder),
                            std::prev(m_waiting.end()));
        }
        return;
    }
    carryOut(command);
    carryOutWaiting();
    // Posted events are processed before the timer: commands that arrive faster than they are answered would
    // delay it.
    if (m_timer && m_wall.elapsed() > kOverdue_ms)
        onTimer();
}

/// Cancels an Arm and a Start that are not answered yet, and waiting commands that begin something.
void EngineWorker::dropBegun() {
    if (m_judging)
        m_judging->stop.request_stop();
    m_judging.reset();
    m_recordings.dropBegun();
    std::erase_if(m_waiting, isBegin);
}

void EngineWorker::carryOutWaiting() {
    while (!m_waiting.empty() && !isBusy() && !m_isEnding) {
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
    answer(result);
}

void EngineWorker::answer(const Result<void>& result) {
    if (m_session && m_session->real && !m_isClosing) {
        try {
            m_session->real->work(); // sends what the command has asked for
        } catch (const std::exception& exception) {
            m_session->loop.fault({MessageCode::ReasonInternalFault, {exception.what()}});
        }
    }
    m_pending.refusal = result ? Message{} : result.error().message;
    record();
    updateAlarms(); // before a recording that tells of them is closed
    closeFinished();
    publish();
}

Result<void> EngineWorker::load(const Experiment& experiment, bool isEdit) {
    if (m_session && isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (const auto valid = validate(experiment); !valid)
        return valid;
    const auto zeroing = m_session ? m_session->zeroingFor(experiment, isEdit) : std::nullopt;
    const bool isSameRig =
        m_session && m_session->real && experiment.rig && m_session->real->isFor(experiment);
    const auto known = isSameRig ? std::optional(m_session->loop.knowledge()) : std::nullopt;
    const auto camera = isSameRig && m_session->thermometer
                            ? std::optional(m_session->thermometer->camera().memory())
                            : std::nullopt;
    const auto condition = isEdit && m_session ? m_session->condition(experiment) : std::nullopt;
    const auto sensors = isSameRig || condition ? m_session->sensorsFor(experiment) : std::nullopt;
    const bool isRecordEnded = m_session && m_session->loop.isCooling() && m_recordings.isOn();
    KeptRig kept = closeSession(isSameRig);
    if (m_isEnding)
        return {};
    if (!experiment.rig)
        kept = {};
    else if (!kept.rig)
        kept.rig = std::make_unique<RealRig>(experiment, m_steady, m_guardLog, m_devices.memory(),
                                             m_devices.programs(), m_traffic);
    else if (!isSameRig)
        kept.rig->change(experiment, m_devices.memory());
    kept.condition = condition;
    m_session = std::make_unique<EngineSession>(experiment, m_steady, std::move(kept));
    m_session->loop.setOperator(m_labels.operatorName);
    m_session->loop.setRecordEnd(m_recordEnd);
    m_alarms.use(m_session->real != nullptr);
    ++m_loadId;
    if (isRecordEnded)
        tell({MessageCode::EventRecordEnded, {}});
    if (known)
        m_session->loop.use(*known);
    if (zeroing)
        m_session->loop.useZeroing(*zeroing);
    if (sensors)
        m_session->useSensors(*sensors);
    if (camera && m_session->thermometer)
        m_session->thermometer->camera().use(*camera);
    m_untilTick_s = experiment.sampling.period_s;
    m_worked_s = m_session->clock().now_s();
    m_nextTick_s = m_worked_s + experiment.sampling.period_s;
    m_timer->setInterval(m_session->real ? kRealTimer_ms : kTimer_ms);
    m_cameras.watchOn(*m_session);
    if (known)
        tick(); // its alarms continue
    return {};
}

Result<void> EngineWorker::setVision(const VisionSpec& vision) {
    if (const auto set = m_session->loop.setVision(vision); !set)
        return set;
    if (m_session->simulated)
        m_session->simulated->simulatedCamera().setMarkers(markerLayout(vision));
    m_cameras.setTask(*m_session);
    return {};
}

bool EngineWorker::isInUse() const {
    return m_session->loop.isArmedOrOn();
}

Result<void> EngineWorker::choose(const std::string& camera) {
    if (isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    m_cameras.choose(*m_session, camera);
    return {};
}

/// Closing a port that does not respond blocks the caller: not this thread while there is heat or motion.
/// Otherwise the port is closed here, so that it is free at once for the next one that opens it.
void EngineWorker::endTrial() {
    if (!m_tried)
        return;
    m_closer.dispose(m_tried->takeCamera());
    m_closer.dispose(m_tried->takeThermalCamera());
    if (m_session && isHotOrMoving() && m_tried->mayEndElsewhere())
        m_closer.dispose(std::move(m_tried));
    m_tried.reset();
}

Result<void> EngineWorker::type(double sourceTemperature_K) {
    if (!m_session->real)
        return Error(MessageCode::RigMissing, {});
    auto typed = m_session->real->typeSourceTemperature(sourceTemperature_K);
    if (typed)
        m_session->loop.reportSourceTyped(sourceTemperature_K);
    return typed;
}

Result<void> EngineWorker::tryDevice(const RigSpec& rig) {
    endTrial();
    if (isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (rig.robot || rig.thermometer || rig.source || !rig.camera.empty() || rig.thermalCamera)
        m_tried = std::make_unique<DeviceTrial>(rig, m_devices, m_traffic);
    return {};
}

bool EngineWorker::isMoving() const {
    const RigReadings& readings = m_session->loop.readings();
    return m_session->loop.motion().isMoving() || (readings.isRobotTelling() && readings.robot().moving);
}

bool EngineWorker::isHotOrMoving() const {
    return isInUse() || m_session->loop.heat().isOn() || isMoving() || m_session->loop.pending();
}

/// Never waits for the port; who began the search is told that it is over.
void EngineWorker::endSearch() {
    if (m_search) {
        m_searchEnd = m_search->state();
        m_searchEnd->isOver = true;
        m_searchEnd->problem = {MessageCode::SessionAlreadyRunning, {}};
        if (m_search->mayEndElsewhere())
            m_closer.dispose(std::move(m_search));
    }
    m_search.reset();
}

Result<void> EngineWorker::findUnits(const FindUnits& find) {
    endSearch();
    m_searchEnd.reset();
    m_searchNumber = find.number;
    if (!find.spec)
        return {};
    const auto refuse = [this](const Message& why) {
        m_searchEnd.emplace();
        m_searchEnd->isOver = true;
        m_searchEnd->problem = why;
        return Error(why.code, {}, why.args);
    };
    if (isHotOrMoving())
        return refuse({MessageCode::SessionAlreadyRunning, {}});
    if (m_session->real)
        for (const RigDeviceState& device : m_session->real->devices())
            if (device.port == find.spec->port)
                return refuse({MessageCode::LinkNotOpened, {device.port, "a device of the rig has it"}});
    m_search = std::make_unique<ModbusSearch>(*find.spec, m_traffic);
    return {};
}

void EngineWorker::endByHand() {
    if (m_session && m_session->real)
        m_session->real->endByHand();
}

Result<void> EngineWorker::sendByHand(const SendByHand& send) {
    const bool isHot =
        m_session->loop.heat().isOn() && !(m_session->real && m_session->real->isSourceDoubted());
    if (isInUse() || isHot || isMoving() || m_session->loop.pending())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (!m_session->real)
        return Error(MessageCode::RigMissing, {});
    auto sent = m_session->real->sendByHand(send.link, send.bytes);
    if (sent)
        m_session->loop.reportByHand(send.link, shownBytes(send.bytes));
    return sent;
}

Result<void> EngineWorker::accept(DeviceRole role) {
    if (!m_session->real)
        return Error(MessageCode::RigMissing, {});
    if (isInUse() || (m_session->loop.heat().isOn() && !m_session->real->heatSource().isManual()))
        return Error(MessageCode::SessionAlreadyRunning, {});
    Experiment experiment = m_session->loop.experiment();
    std::string port;
    for (const RigDeviceState& device : m_session->real->devices())
        if (device.role == role)
            port = device.port;
    m_devices.forget(*m_session->real, role, m_system);
    tell({MessageCode::EventDeviceAccepted, {port}});
    return load(experiment, false);
}

void EngineWorker::forwardView() {
    auto view = m_cameras.newest(m_session.get());
    if (view == m_view || (view && m_views.isFull()))
        return;
    m_view = std::move(view);
    if (m_view)
        emit looked(m_view, m_views.next());
}

void EngineWorker::showThermal(double wall_s) {
    m_sinceThermal_s += wall_s;
    if (!m_cameras.isThermalWatched() || !m_session->thermometer || m_sinceThermal_s < kThermal_s ||
        m_thermalViews.isFull())
        return;
    m_sinceThermal_s = 0.0;
    emit sawHeat(m_session->thermometer->camera().view(), m_thermalViews.next());
}

Result<void> EngineWorker::armWith(const Arm& arm) {
    ServoLoop& loop = m_session->loop;
    if (const auto may = loop.mayArm(); !may)
        return may;
    if (!arm.recordingPath.empty()) {
        using Earlier = SessionRecorder::Earlier;
        m_recordings.begin(arm.recordingPath, loop.experiment(), m_session->simulated != nullptr,
                           loop.experiment().safety.minDisk_MB, m_labels,
                           arm.mayReplace ? Earlier::Replaced : Earlier::Kept);
        return {};
    }
    return armNow();
}

Result<void> EngineWorker::armNow() {
    if (const auto may = m_session->loop.mayArm(); !may)
        return may;
    record();
    if (!m_pending.newSamples.empty())
        publish();    // those of the previous run, with its number
    closeRecording(); // the recording of the previous run, with its outcome
    const auto armed = m_session->loop.arm();
    if (armed)
        ++m_runId;
    return armed;
}

/// Answers Arm after the file was created.
void EngineWorker::finishArming() {
    auto done = m_recordings.made();
    if (!done)
        return;
    if (*done)
        *done = armNow();
    if (*done) {
        m_recordings.takeBegun();
        m_nextTraffic = 0;
        m_trafficUntil_s.reset();
    } else {
        m_recordings.dropBegun();
    }
    answer(*done);
}

/// Start is answered after it is known whether the targets can be held.
Result<void> EngineWorker::startWith(bool acceptInfeasible) {
    ServoLoop& loop = m_session->loop;
    if (acceptInfeasible || loop.state() != RunState::Armed)
        return loop.start(acceptInfeasible);
    m_judging.emplace();
    m_judging->isFeasible = m_judge.ask([experiment = loop.experiment(), stop = m_judging->stop.get_token()] {
        const auto verdict = jointFeasibility(feasibilityRequest(experiment), stop);
        return verdict && verdict->feasible;
    });
    return {};
}

/// The targets are still the same: commands wait meanwhile, or have cancelled the start.
void EngineWorker::finishJudging() {
    if (!m_judging || !isReady(m_judging->isFeasible))
        return;
    auto judged = std::move(*m_judging);
    m_judging.reset();
    try {
        const bool isFeasible = judged.isFeasible.get();
        answer(isFeasible ? m_session->loop.start(false)
                          : Result<void>(Error(MessageCode::ReasonTargetInfeasible, {})));
    } catch (const std::exception& exception) {
        m_session->loop.fault({MessageCode::ReasonInternalFault, {exception.what()}});
        answer(Error(MessageCode::ReasonInternalFault, {}, {exception.what()}));
    }
}

Result<void> EngineWorker::apply(const Command& command) {
    if (isBegin(command) || isEnd(command)) {
        endSearch();
        endByHand();
    }
    if (const auto* experiment = std::get_if<LoadExperiment>(&command))
        return load(experiment->experiment, experiment->isEdit);
    if (const auto* speed = std::get_if<SetSimulationSpeed>(&command)) {
        const double before = std::exchange(m_speed, std::clamp(speed->factor, 1.0, kMaxSpeed));
        if (m_session && m_session->simulated && m_speed != before)
            m_session->loop.reportSpeedAsked(m_speed);
        return {};
    }
    if (const auto* set = std::get_if<SetLabels>(&command))
        return setLabels(set->labels);
    if (const auto* one = std::get_if<AcknowledgeAlarm>(&command))
        return acknowledge(one->id);
    if (std::holds_alternative<AcknowledgeAll>(command))
        return acknowledge(std::nullopt);
    if (const auto* alarm = std::get_if<ShelveAlarm>(&command))
        return shelve(*alarm);
    if (const auto* alarm = std::get_if<UnshelveAlarm>(&command))
        return unshelve(alarm->id);
    if (const auto* program = std::get_if<ConfirmProgram>(&command)) {
        m_devices.confirm(program->command, program->hash, program->isKept, m_system);
        tell({MessageCode::EventProgramConfirmed, {program->command}});
        return {};
    }
    if (!m_session)
        return Error(MessageCode::ReasonNoExperiment, {});
    ServoLoop& loop = m_session->loop;
    return std::visit(
        Overloaded{
            [](const LoadExperiment&) { return Result<void>(); },
            [](const SetSimulationSpeed&) { return Result<void>(); },
            [](const SetLabels&) { return Result<void>(); },
            [](const AcknowledgeAlarm&) { return Result<void>(); },
            [](const AcknowledgeAll&) { return Result<void>(); },
            [](const ShelveAlarm&) { return Result<void>(); },
            [](const UnshelveAlarm&) { return Result<void>(); },
            [](const ConfirmProgram&) { return Result<void>(); },
            [&](const WatchCamera& wanted) { return m_cameras.watch(*m_session, wanted), Result<void>(); },
            [&](const WatchThermalCamera& wanted) {
                return m_cameras.watch(*m_session, wanted), Result<void>();
            },
            [&](const ChooseCamera& camera) { return choose(camera.name); },
            [&](const SetVision& set) { return setVision(set.vision); },
            [&](const MoveTo& move) { return loop.moveTo(move.coordinates); },
            [&](const Jog& jog) { return loop.jog(jog.twist); },
            [&](const HomeRobot&) { return loop.home(); },
            [&](const ClearRobotAlarm&) { return loop.clearRobotAlarm(); },
            [&](const SetHeat& set) { return loop.setHeat(set.setPoint_K); },
            [&](const TypeSourceTemperature& typed) { return type(typed.temperature_K); },
            [&](const ZeroSensors&) { return loop.zeroSensors(); },
            [&](const ConfirmSensor& confirm) { return loop.confirmSensor(confirm.object); },
            [&](const ListPorts&) { return m_ports = m_system.ask(serialPorts), Result<void>(); },
            [&](const TryDevice& device) { return tryDevice(device.rig); },
            [&](const FindUnits& find) { return findUnits(find); },
            [&](const SendByHand& send) { return sendByHand(send); },
            [&](const AcceptDevice& device) { return accept(device.role); },
            [&](const Arm& arm) { return armWith(arm); },
            [&](const Disarm&) { return loop.disarm(); },
            [&](const Start& start) { return startWith(start.acceptInfeasible); },
            [&](const Hold&) { return loop.hold(); },
            [&](const Resume&) { return loop.resume(); },
            [&](const Stop&) { return loop.stop(); },
            [&](const EmergencyStop&) { return loop.emergencyStop(), Result<void>(); },
            [&](const Reset&) { return loop.reset(); },
            [&](const Retreat&) { return loop.retreatNow(); },
            [&](const EndRecording&) { return endRecording(); },
            [&](const SetTargets& set) { return loop.setTargets(set.targets_K); },
            [&](const ReportInfeasible& report) {
                return loop.reportInfeasible(report.reason), Result<void>();
            },
            [&](const SetController& set) { return loop.setController(set.settings); },
            [&](const KeepPrediction& kept) { return keep(kept); },
            [&](const AddNote& note) { return loop.addNote(note.text), Result<void>(); },
            [&](const SimulateFault& fault) { return applyFault(fault); },
        },
        command);
}

Result<void> EngineWorker::setLabels(const RunLabels& labels) {
    if (auto valid = validate(labels); !valid)
        return valid;
    const bool isOtherRun = labels.sample != m_labels.sample || labels.batch != m_labels.batch;
    if (isOtherRun && m_session && isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    m_labels = labels;
    if (m_session)
        m_session->loop.setOperator(labels.operatorName);
    return {};
}

Result<void> EngineWorker::applyFault(const SimulateFault& fault) {
    if (!m_session->simulated)
        return Error(MessageCode::FaultOnRealRig, {});
    SimulatedRig& rig = *m_session->simulated;
    m_session->loop.reportFaultAsked(fault.fault, fault.object, fault.isOn);
    const auto before = activeFaults(rig);
    if (fault.isOn)
        clearFaults(rig);
    else
        endFault(rig, fault.fault, fault.object);
    const auto after = activeFaults(rig);
    for (const ActiveFault& each : before)
        if (!std::ranges::count(after, each))
            m_session->loop.reportFaultEnded(each.fault);
    if (!fault.isOn || fault.fault == SimulatedFault::None)
        return {};
    setFault(rig, fault.fault, fault.object, true);
    m_session->loop.reportFault(fault.fault, fault.object);
    return {};
}

Result<void> EngineWorker::acknowledge(std::optional<std::uint64_t> id) {
    std::vector<Alarm> seen;
    for (const Alarm& alarm : m_alarms.alarms())
        if (!alarm.isAcknowledged && (!id || alarm.id == *id))
            seen.push_back(alarm);
    const bool changed = id ? m_alarms.acknowledge(*id, m_labels.operatorName)
                            : m_alarms.acknowledgeAll(m_labels.operatorName);
    if (changed)
        keepAlarms();
    for (const Alarm& alarm : seen)
        if (m_session)
            m_session->loop.reportAcknowledged(alarm);
    return {};
}

Result<void> EngineWorker::shelve(const ShelveAlarm& wanted) {
    const auto put =
        m_alarms.shelve(wanted.id, utcNow_s(), wanted.for_s, wanted.reason, m_labels.operatorName);
    if (!put)
        return put;
    const auto alarm = std::ranges::find(m_alarms.alarms(), wanted.id, &Alarm::id);
    if (m_session)
        m_session->loop.reportShelved(*alarm, wanted.for_s);
    keepAlarms();
    return {};
}

Result<void> EngineWorker::unshelve(std::uint64_t id) {
    const auto alarm = std::ranges::find(m_alarms.alarms(), id, &Alarm::id);
    if (alarm == m_alarms.alarms().end() || alarm->shelvedUntil_s == 0.0)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Unshelve), "Over"});
    if (m_session)
        m_session->loop.reportShelved(*alarm, 0.0);
    m_alarms.unshelve(id);
    keepAlarms();
    return {};
}

void EngineWorker::keepAlarms() {
    m_keeper.keep(m_alarms.all(), {m_recordings.isOn(), m_labels.operatorName});
}

void EngineWorker::updateAlarms() {
    if (m_session && m_alarms.update(utcNow_s(), m_session->loop.alarmConditions()))
        keepAlarms();
}

void EngineWorker::tell(const Message& message) {
    addEvents({{m_session ? m_session->loop.runTime_s() : 0.0, message}});
}

void EngineWorker::addEvents(std::vector<TraceEvent> events) {
    if (m_watch.tell)
        m_unwatched.insert(m_unwatched.end(), events.begin(), events.end());
    append(events, m_pending.newEvents);
}

/// Takes the answers of disk and system.
void EngineWorker::hearBackground() {
    if (auto before = m_keeper.takeBefore()) {
        m_alarms.addFromBefore(std::move(before->alarms));
        if (before->problem)
            tell(before->problem->message);
        if (!before->ownFile.empty())
            tell({MessageCode::AlarmsElsewhere, {before->ownFile}});
        keepAlarms();
    }
    if (const auto failure = m_keeper.takeFailure())
        tell(failure->message);
    if (isReady(m_ports))
        m_pending.ports = m_ports.get();
    if (isReady(m_diskFree_MB)) {
        const auto free_MB = m_diskFree_MB.get();
        if (m_session)
            m_session->loop.setDiskFree_MB(m_recordings.isOn() ? free_MB : std::nullopt);
    }
    for (const Error& failure : m_recordings.takeFailures())
        tellUnfinished(failure);
    finishArming();
    finishJudging();
}

/// Reports a failed recording of a run that is over; it ends neither a run, which has its own recording, nor
/// heat and moves by hand.
void EngineWorker::tellUnfinished(const Error& error) {
    const Message reason{MessageCode::ReasonRecorderFailed, {describe(error)}};
    if (m_session && !isInUse() && !isMoving() && !m_session->loop.heatSetPoint_K())
        m_session->loop.fault(reason);
    else
        tell(reason);
}

void EngineWorker::watchDisk() {
    m_sinceDisk_s = 0.0;
    if (!m_recordings.isOn())
        m_session->loop.setDiskFree_MB({});
    else if (!m_diskFree_MB.valid()) // a disk is not asked again before it has answered
        m_diskFree_MB = m_system.ask([file = m_recordings.path()] { return diskFree_MB(file); });
}

/// Keeps the computer awake while there is heat, and reports a suspend that happened nevertheless.
void EngineWorker::watchSleep() {
    const double slept_s = m_suspend.slept_s();
    const bool isReal = m_session->real != nullptr;
    if (slept_s > 0.0 && isReal)
        m_session->loop.reportSuspended(slept_s);
    m_sleep.keepAwake(isReal && m_session->loop.heat().isOn());
    if (const std::string problem = m_sleep.problem(); !problem.empty() && !m_isSleepTold) {
        m_isSleepTold = true;
        m_session->loop.reportMaySleep(problem);
    }
}

void EngineWorker::onTimer() {
    if (m_isClosing)
        return;
    const double wall_s = std::min(kLongestGap_s, static_cast<double>(m_wall.nsecsElapsed()) * 1e-9);
    m_wall.restart();
    try {
        if (m_tried)
            m_tried->work();
        if (m_search)
            m_search->work();
    } catch (const std::exception& exception) {
        tell({MessageCode::ReasonInternalFault, {exception.what()}});
        endTrial();
        endSearch();
    }
    hearBackground();
    carryOutWaiting();
    if (m_session) {
        m_sinceDisk_s += wall_s;
        if (m_sinceDisk_s >= kDisk_s)
            watchDisk();
        try {
            watchSleep();
            m_cameras.followRun(*m_session);
            if (m_session->simulated)
                advanceSimulated(wall_s);
            else
                workReal();
            showThermal(wall_s);
        } catch (const std::exception& exception) {
            m_session->loop.fault({MessageCode::ReasonInternalFault, {exception.what()}});
        }
    }
    forwardView();
    m_rateWindow_s += wall_s;
    if (m_rateWindow_s >= 2.0) {
        m_loopRate_Hz = m_ticksSinceRate / m_rateWindow_s;
        m_ticksSinceRate = 0;
        m_rateWindow_s = 0.0;
    }
    m_sinceWatched_s += wall_s;
    if (m_sinceWatched_s >= kPublish_s || (m_session && m_session->loop.state() != m_watchedState))
        tellWatch();
    m_sincePublished_s += wall_s;
    const bool changed = m_session && m_session->loop.state() != m_publishedState;
    if ((changed || m_sincePublished_s >= kPublish_s) && !m_snapshots.isFull())
        publish();
}

void EngineWorker::tick() {
    m_session->loop.tick();
    ++m_ticksSinceRate;
    record();
    updateAlarms(); // before a recording that tells of them is closed
    closeFinished();
}

/// In a hold the simulation runs in real time, so that a person can follow the countdown.
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
    // Time that does not fit is dropped: the simulation then runs slower than asked, and commands never wait.
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
    // After a delay of this thread, it first takes what the devices have sent meanwhile, and judges them
    // then.
    if (now_s - m_worked_s > kDelayed_s)
        m_nextTick_s = now_s + kHearing_s;
    m_worked_s = now_s;
    if (now_s < m_nextTick_s)
        return;
    const double period_s = m_session->loop.experiment().sampling.period_s;
    emit stepped(now_s - m_nextTick_s);
    const double behind = std::floor((now_s - m_nextTick_s) / period_s); // whole periods that are lost
    m_lateSteps += static_cast<std::uint64_t>(behind);
    m_nextTick_s += (1.0 + behind) * period_s;
    tick();
    if (m_session->loop.pending() || isInUse() || isMoving()) {
        endSearch();
        endByHand();
    }
    m_devices.remember(*m_session->real, m_system);
    m_session->real->work(); // sends what the tick has asked for
}

Result<void> EngineWorker::endRecording() {
    if (isInUse())
        return Error(MessageCode::SessionAlreadyRunning, {});
    m_session->loop.endCooling();
    closeRecording();
    return {};
}

Result<void> EngineWorker::keep(const KeepPrediction& kept) {
    if (!m_recordings.isOn() || kept.runId != m_runId || !kept.run || !isInUse())
        return {};
    for (const PredictedSample& sample : kept.run->samples)
        if (sample.temperatures_K.size() != m_session->loop.experiment().objects.size())
            return {}; // of other objects
    LoopRecord rows;
    rows.prediction = kept.run;
    return m_recordings.add(std::move(rows));
}

void EngineWorker::closeFinished() {
    if (m_session && !isInUse() && !m_session->loop.isCooling())
        closeRecording();
}

void EngineWorker::record() {
    if (!m_session)
        return;
    LoopRecord rows = m_session->loop.takeRecord();
    addTraffic(rows, kTrafficAtOnce);
    if (m_recordings.isOn())
        if (const auto added = m_recordings.add(rows); !added)
            endFailed({MessageCode::ReasonRecorderFailed, {describe(added.error())}});
    append(rows.samples, m_pending.newSamples);
    addEvents(std::move(rows.events));
    append(rows.notes, m_pending.newNotes);
}

/// After a run only its record ends: the rig may be in use for something else.
void EngineWorker::endFailed(const Message& reason) {
    if (!m_session->loop.isCooling())
        return m_session->loop.stopFor(reason);
    m_session->loop.endCooling();
    tell(reason);
}

/// With a fault, what led to it and what follows for a while.
void EngineWorker::addTraffic(LoopRecord& rows, std::size_t max) {
    if (!m_session->real || !m_recordings.isOn())
        return;
    const double now_s = m_session->clock().now_s();
    if (m_session->loop.state() == RunState::Fault && !m_trafficUntil_s && !m_isEnding)
        m_trafficUntil_s = now_s + kTrafficAfter_s;
    if (!m_trafficUntil_s)
        return;
    rows.traffic = m_traffic->from(m_nextTraffic, max);
    while (!rows.traffic.empty() && rows.traffic.back()->time_s > *m_trafficUntil_s)
        rows.traffic.pop_back();
    rows.start_s = now_s - m_session->loop.runTime_s();
    if (!rows.traffic.empty())
        m_nextTraffic = rows.traffic.back()->number + 1;
}

void EngineWorker::closeRecording() {
    if (m_session && m_recordings.isOn()) {
        LoopRecord rest;
        addTraffic(rest, m_isEnding ? kTrafficAtOnce : SIZE_MAX);
        (void)m_recordings.add(std::move(rest));
    }
    m_recordings.close(m_session ? m_session->loop.outcome() : std::string());
}

void EngineWorker::publish() {
    Snapshot snapshot = std::exchange(m_pending, Snapshot());
    snapshot.sequence = ++m_sequence;
    fill(snapshot);
    m_publishedState = snapshot.state;
    m_sincePublished_s = 0.0;
    emit published(snapshot, m_snapshots.next());
}

void EngineWorker::tellWatch() {
    m_sinceWatched_s = 0.0;
    m_watchedState = m_session ? m_session->loop.state() : RunState::NotReady;
    auto events = std::exchange(m_unwatched, {});
    if (!m_watch.tell || !m_watch.isWanted())
        return;
    Snapshot snapshot;
    fill(snapshot);
    snapshot.newEvents = std::move(events);
    m_watch.tell(snapshot);
}

void EngineWorker::fill(Snapshot& snapshot) const {
    snapshot.runId = m_runId;
    snapshot.simulationSpeed = simulationSpeed();
    snapshot.loadId = m_loadId;
    snapshot.loopRate_Hz = m_loopRate_Hz;
    snapshot.lateSteps = m_lateSteps;
    snapshot.alarms = m_alarms.alarms();
    snapshot.labels = m_labels;
    if (m_session) {
        m_session->tell(snapshot);
    } else {
        snapshot.state = RunState::NotReady;
        snapshot.reasons.push_back({MessageCode::ReasonNoExperiment, {}});
    }
    if (m_tried)
        snapshot.tried = m_tried->state();
    snapshot.search = m_search ? std::optional(m_search->state()) : m_searchEnd;
    if (snapshot.search)
        snapshot.search->number = m_searchNumber;
    snapshot.traffic = m_traffic;
    if (const SessionRecorder* recorder = m_recordings.newest()) {
        snapshot.recordingPath = recorder->path();
        snapshot.recordedRows = recorder->rows();
    }
    snapshot.isRecordedUntilCold = m_session && m_session->loop.isCooling() && m_recordings.isOn();
}

} // namespace bask
