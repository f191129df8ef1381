#include "engine/runtime/servo_loop.h"

#include "engine/experiment/controller_json.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/alarm_causes.h"

#include <algorithm>

namespace bask {

bool isRunOn(RunState state) {
    return state == RunState::Running || state == RunState::Holding || state == RunState::Settled ||
           state == RunState::Stopping;
}

ServoLoop::ServoLoop(const Experiment& experiment, RigDevices devices, const Clock& clock)
    : m_experiment(experiment), m_mounting(checkMounting(experiment)), m_devices(std::move(devices)),
      m_clock(clock), m_readings(m_experiment, m_devices, clock, m_latest),
      m_motion(m_experiment, m_devices, m_readings, clock, m_latest,
               [this](const Message& reason) { refusedByRobot(reason); }),
      m_heat(m_experiment, m_devices, m_readings),
      m_retreat(m_experiment, m_devices, m_readings, m_motion, clock, m_latest),
      m_control(m_experiment, m_readings, clock), m_safety(experiment), m_faults(m_experiment, m_safety) {
    const auto isMissing = [](const auto& answer) {
        return !answer && answer.error().code() == MessageCode::RigIncomplete;
    };
    const bool isEmpty = isMissing(m_devices.robot.state()) && isMissing(m_devices.thermometer.read()) &&
                         isMissing(m_devices.source.read());
    if (m_devices.isReal && !isEmpty)
        fault({MessageCode::SafetyStartUp, {}});
}

ServoLoop::~ServoLoop() {
    makeSafe();
}

RigKnowledge ServoLoop::knowledge() const {
    return {m_faults.all(),       m_readings.answers(),       m_retreat.isRefused(),
            m_readings.sensors(), m_safety.wasSourceHeated(), m_safety.unaskedWarming_K()};
}

void ServoLoop::use(const RigKnowledge& known) {
    m_faults.use(known.faults);
    m_state = m_faults.isEmpty() ? RunState::NotReady : RunState::Fault;
    m_readings.use(known.answers);
    m_retreat.setRefused(known.isRetreatRefused);
    m_readings.sensors().useDistrust(known.sensors);
    m_safety.useHistory(known.wasSourceHeated, known.unaskedWarming_K);
    m_record = {}; // there is no start-up to report
}

bool ServoLoop::running() const {
    return isRunOn(m_state);
}

bool ServoLoop::isArmedOrOn() const {
    return running() || m_state == RunState::Armed;
}

bool ServoLoop::isManual() const {
    return m_state == RunState::NotReady || m_state == RunState::Ready || m_state == RunState::Stopped;
}

bool ServoLoop::isHeatedManually() const {
    return m_heat.manual_K() && (isManual() || m_state == RunState::Armed);
}

double ServoLoop::runTime_s() const {
    return m_runOn || m_isCooling ? m_clock.now_s() - m_control.began_s() : m_latest.time_s;
}

Error ServoLoop::refusal(CommandVerb verb) const {
    return Error(MessageCode::CommandNotNow, {}, {verbArg(verb), runStateName(m_state)});
}

void ServoLoop::event(MessageCode code, std::vector<MessageArg> args) {
    m_record.events.push_back({runTime_s(), {code, std::move(args)}});
}

void ServoLoop::command(const std::string& name, const std::string& value) {
    m_record.commands.push_back({runTime_s(), name, value, m_operator});
}

LoopRecord ServoLoop::takeRecord() {
    return std::exchange(m_record, {});
}

void ServoLoop::addNote(const std::string& text) {
    m_record.notes.push_back({runTime_s(), text, m_operator});
}

namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) { // names and reasons may contain any character
        if (letter == '"' || letter == '\\')
            out += '\\';
        out += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
    return out + '"';
}

} // namespace

void ServoLoop::setOperator(const std::string& name) {
    const bool isNew = name != m_operator;
    m_operator = name;
    if (isNew && isRecorded())
        command("operator", "{\"name\":" + quoted(name) + "}");
}

void ServoLoop::reportAcknowledged(const Alarm& alarm) {
    command("acknowledge", "{\"alarm\":" + quoted(alarm.key) + "}");
}

void ServoLoop::reportShelved(const Alarm& alarm, double for_s) {
    if (for_s > 0.0)
        command("shelve", "{\"alarm\":" + quoted(alarm.key) + ",\"for_s\":" + formatNumber(for_s, 6) +
                              ",\"reason\":" + quoted(alarm.shelfReason) + "}");
    else
        command("unshelve", "{\"alarm\":" + quoted(alarm.key) + "}");
}

void ServoLoop::reportFault(SimulatedFault simulated, std::size_t object) {
    const char* const name = simulatedFaultName(simulated);
    if (isOfObject(simulated) && object < m_experiment.objects.size())
        event(MessageCode::EventObjectFault, {name, m_experiment.objects[object].name});
    else
        event(MessageCode::EventFault, {name});
}

void ServoLoop::reportFaultEnded(SimulatedFault simulated) {
    event(MessageCode::EventFaultEnded, {simulatedFaultName(simulated)});
}

void ServoLoop::reportFaultAsked(SimulatedFault simulated, std::size_t object, bool isOn) {
    if (!isRecorded())
        return;
    std::string value = "{\"fault\":" + quoted(simulatedFaultName(simulated));
    if (isOfObject(simulated) && object < m_experiment.objects.size())
        value += ",\"object\":" + quoted(m_experiment.objects[object].name);
    command("fault", value + (isOn ? "}" : ",\"on\":false}"));
}

void ServoLoop::reportSpeedAsked(double factor) {
    if (isRecorded())
        command("speed", "{\"factor\":" + formatNumber(factor, 6) + "}");
}

void ServoLoop::reportSourceTyped(double temperature_K) {
    if (isRecorded())
        command("source-temperature", "{\"temperature_K\":" + formatNumber(temperature_K, 10) + "}");
}

void ServoLoop::reportInfeasible(const Message& reason) {
    if (running() && m_state != RunState::Stopping)
        event(reason);
}

Result<void> ServoLoop::mayArm() const {
    if (!m_mounting)
        return m_mounting;
    if (const auto fit = checkTargets(m_experiment); !fit)
        return fit;
    if (const SafetyFinding* finding = m_safety.forbidsArm())
        return Error(finding->message.code, {}, finding->message.args);
    if (m_state != RunState::Ready && m_state != RunState::Stopped)
        return refusal(CommandVerb::Arm);
    if (m_motion.isHoming())
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Arm), "Homing"});
    if (const Message why = m_devices.source.cannotHeat(); why.code != MessageCode::None)
        return Error(why.code, {}, why.args);
    if (!m_readings.sensors().zeroing())
        if (const auto found = m_readings.sensors().findZero(m_experiment.environment_K); !found)
            return found.error();
    return {};
}

Result<void> ServoLoop::arm() {
    if (const auto may = mayArm(); !may)
        return may;
    m_motion.endMove();
    if (!m_readings.sensors().zeroing()) {
        auto found = m_readings.sensors().findZero(m_experiment.environment_K);
        if (!found)
            return found.error();
        take(std::move(*found));
    }
    const double power_W_m2 = surroundingsOf(m_experiment, m_readings.environment_K()).netSourcePower_W_m2;
    if (!(power_W_m2 > 0.0))
        return Error(MessageCode::SourceTooWeak, {}, {formatNumber(power_W_m2, 3)});
    if (!m_outcome.empty()) // forget what the objects did in the last run
        m_safety.restart();
    m_outcome.clear();
    m_isCooling = false;
    m_latest.time_s = 0.0;
    m_state = RunState::Armed;
    command("arm", zeroingJson(*m_readings.sensors().zeroing())); // the zeroing may be old
    event(MessageCode::EventArmed);
    return {};
}

Result<void> ServoLoop::disarm() {
    if (m_state != RunState::Armed)
        return refusal(CommandVerb::Disarm);
    m_state = RunState::Ready;
    command("disarm"); // no event: none of a run has begun that could be stopped
    return {};
}

Result<void> ServoLoop::requireFreshReadings() const {
    if (auto fresh = m_readings.requireFreshSensors(); !fresh)
        return fresh;
    if (!m_readings.isSourceSeen())
        return Error(MessageCode::ReasonSourcePoseLost, {});
    return {};
}

Result<void> ServoLoop::start(bool acceptInfeasible) {
    if (m_state != RunState::Armed)
        return refusal(CommandVerb::Start);
    if (const auto fresh = requireFreshReadings(); !fresh)
        return fresh;
    if (const auto fit = checkTargets(m_experiment); !fit)
        return fit;
    if (const SafetyFinding* finding = m_safety.forbidsResume())
        return Error(finding->message.code, {}, finding->message.args);
    m_safety.forgetLoss();
    m_control.begin();
    m_heat.endManual();
    m_state = RunState::Running;
    m_runOn = true;
    command("start", R"({"environment_K":)" + formatNumber(m_readings.environment_K(), 10) +
                         R"(,"started_utc_s":)" + formatNumber(utcNow_s(), 13) +
                         (acceptInfeasible ? R"(,"accept_infeasible":true})" : "}"));
    event(MessageCode::EventStarted);
    // The first step is taken at once, on the readings just made.
    control();
    trace();
    return {};
}

Result<void> ServoLoop::hold() {
    if (m_motion.isMoving()) {
        m_motion.breakOff();
        return {};
    }
    if (m_state != RunState::Running && m_state != RunState::Settled)
        return refusal(CommandVerb::Hold);
    m_state = RunState::Holding;
    m_pausedBySafety = false;
    m_motion.standStill();
    command("hold");
    event(MessageCode::EventHeld);
    return {};
}

Result<void> ServoLoop::resume() {
    if (m_state != RunState::Holding)
        return refusal(CommandVerb::Resume);
    if (const auto fresh = requireFreshReadings(); !fresh)
        return fresh;
    if (const SafetyFinding* finding = m_safety.forbidsResume())
        return Error(finding->message.code, {}, finding->message.args);
    m_state = RunState::Running;
    m_pausedBySafety = false;
    m_safety.forgetLoss();
    m_control.countBandAnew();
    command("resume");
    event(MessageCode::EventResumed);
    return {};
}

Result<void> ServoLoop::stop() {
    if (m_state == RunState::Armed)
        return disarm();
    if (m_state != RunState::Running && m_state != RunState::Holding && m_state != RunState::Settled)
        return refusal(CommandVerb::Stop);
    command("stop");
    return stopBy({MessageCode::EventStopped, {}});
}

Result<void> ServoLoop::stopBy(const Message& reason) {
    m_outcome = m_state == RunState::Settled ? "settled" : "stopped";
    if (!m_readings.allWithinBand())
        event(MessageCode::EventNotSettled, {m_readings.objectsOffTarget()});
    event(reason);
    beginRetreat();
    return {};
}

Result<void> ServoLoop::retreatNow() {
    if (const Message reason = keepsFromRetreat(); reason.code != MessageCode::None)
        return Error(reason.code, {}, reason.args);
    command("retreat");
    if (m_state == RunState::Stopping)
        return {};
    if (running())
        return stop();
    event(MessageCode::EventRetreat);
    beginRetreat();
    return {};
}

void ServoLoop::beginRetreat() {
    m_state = RunState::Stopping;
    m_heat.endManual();
    m_retreat.begin();
    m_heat.off();
    retreat(); // at once: the last velocity must not continue sideways
}

void ServoLoop::emergencyStop() {
    command("emergency-stop");
    m_motion.forgetHoming();
    event(MessageCode::EventEmergencyStop);
    const bool refuses = m_retreat.announced_s() || (m_state == RunState::Stopping && hot() != nullptr);
    m_retreat.setRefused(m_retreat.isRefused() || refuses);
    m_retreat.callOff();
    endRun("emergency-stop");
    (void)m_faults.add(latchedFault({MessageCode::ReasonEmergencyStop, {}}));
    m_state = RunState::Fault;
}

void ServoLoop::makeSafe() {
    m_motion.endMove();
    m_retreat.end();
    m_heat.endManual();
    m_heat.off();
}

void ServoLoop::endRun(const std::string& outcome) {
    if (m_runOn || m_outcome.empty()) // events after a run do not change its outcome
        m_outcome = outcome;
    makeSafe();
    m_control.end();
    const bool isHeatUnsure = m_devices.isReal && m_heat.state() != HeatState::Off;
    const bool isAsMeant = (outcome == "settled" || outcome == "stopped") && !isHeatUnsure;
    if (m_runOn && !isAsMeant) {
        m_isCooling = true;
        m_ended_s = m_clock.now_s();
    }
    m_runOn = false;
}

Result<void> ServoLoop::reset() {
    if (m_state != RunState::Fault)
        return refusal(CommandVerb::Reset);
    m_devices.source.renewGuard();
    m_safety.restart(); // forget what source and objects did; present conditions stay
    look();
    watch();
    if (const SafetyFinding* finding = m_safety.forbidsReset())
        return Error(finding->message.code, {}, finding->message.args);
    if (m_readings.isConnecting())
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Reset), "Connecting"});
    m_faults.clear();
    m_state = RunState::NotReady;
    command("reset");
    event(MessageCode::EventReset);
    updateReadiness();
    return {};
}

Result<void> ServoLoop::setTargets(const std::vector<double>& targets_K) {
    Experiment changed = m_experiment;
    if (const auto result = bask::setTargets(changed, targets_K); !result)
        return result;
    if (std::ranges::equal(changed.objects, m_experiment.objects, {}, &ObjectSpec::target_K,
                           &ObjectSpec::target_K))
        return {};
    if (m_state == RunState::Stopping)
        return refusal(CommandVerb::SetTargets);
    if (const auto result = checkTargets(changed); !result && isArmedOrOn())
        return result;
    m_experiment = std::move(changed);
    updateReadiness();
    m_control.useTargets();
    std::string value;
    std::vector<ObjectKelvin> told;
    for (std::size_t i = 0; i < targets_K.size(); ++i) {
        value += (i == 0 ? "" : ",") + formatNumber(targets_K[i], 10);
        told.push_back({m_experiment.objects[i].name, targets_K[i]});
    }
    command("targets", "{\"targets_K\":[" + value + "]}");
    if (isArmedOrOn())
        event(MessageCode::EventTargetsChanged, {MessageArg::temperatures(std::move(told))});
    return {};
}

Result<void> ServoLoop::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    if (const auto result = validate(changed); !result)
        return result;
    const bool isSameKind = settings.kind == m_experiment.controller.kind;
    m_experiment = std::move(changed);
    m_control.useSettings(isSameKind);
    command("controller", controllerToJson(settings));
    if (isArmedOrOn())
        event(MessageCode::EventGainsChanged);
    return {};
}

Result<void> ServoLoop::setVision(const VisionSpec& vision) {
    if (isArmedOrOn())
        return Error(MessageCode::SessionAlreadyRunning, {});
    Experiment changed = m_experiment;
    changed.vision = vision;
    if (auto valid = validate(changed); !valid)
        return valid;
    m_experiment = std::move(changed);
    return {};
}

Result<void> ServoLoop::moveTo(const Vector6d& goal) {
    return isManual() ? m_motion.moveTo(goal) : refusal(CommandVerb::Move);
}

Result<void> ServoLoop::jog(const Vector6d& twist) {
    return isManual() ? m_motion.jog(twist) : refusal(CommandVerb::Jog);
}

Result<void> ServoLoop::home() {
    return isManual() || m_state == RunState::Fault ? m_motion.home() : refusal(CommandVerb::Home);
}

Result<void> ServoLoop::clearRobotAlarm() {
    return isManual() || m_state == RunState::Fault ? m_motion.clearAlarm()
                                                    : refusal(CommandVerb::ClearAlarm);
}

Result<void> ServoLoop::setHeat(std::optional<double> setPoint_K) {
    if (!setPoint_K) {
        m_heat.endManual();
        if (running() && m_state != RunState::Stopping)
            return stop();
        m_heat.off();
        return {};
    }
    if (!isManual())
        return refusal(CommandVerb::Heat);
    // otherwise nobody sees how hot the objects become
    if (auto fresh = m_readings.requireFreshSensors(); !fresh)
        return fresh;
    if (const SafetyFinding* lost = m_safety.lostSensor())
        return Error(lost->message.code, {}, lost->message.args);
    if (auto set = m_heat.setManual(*setPoint_K); !set)
        return set;
    if (m_isCooling) { // what is heated from now on is not of that run
        event(MessageCode::EventRecordEnded);
        endCooling();
    }
    keepHeating();
    return {};
}

std::optional<double> ServoLoop::heatSetPoint_K() const {
    if (m_state == RunState::Running || m_state == RunState::Settled || m_state == RunState::Holding)
        return sourceSetPoint_K(m_experiment.source, m_clock.now_s() - m_control.began_s());
    return m_heat.manual_K();
}

void ServoLoop::keepHeating() {
    if (const auto kept = m_heat.keep(*heatSetPoint_K()); !kept)
        stopWith(latched(SafetyFinding{SafetyCondition::SourceLost, 0, kept.error().message}));
}

Result<Zeroing> ServoLoop::findZero() const {
    if (isArmedOrOn())
        return Error(MessageCode::SessionAlreadyRunning, {});
    if (m_heat.isOn() || m_heat.manual_K())
        return Error(MessageCode::ReasonNotAtAmbient, {}, {temperatureArg(m_experiment.environment_K)});
    if (const auto fresh = m_readings.requireFreshSensors(); !fresh)
        return fresh.error();
    return m_readings.sensors().findZero(m_experiment.environment_K);
}

void ServoLoop::take(Zeroing found) {
    found.utc_s = utcNow_s();
    m_readings.sensors().use(found);
    m_readings.takeSensors(); // otherwise the first step would use the old values
    m_safety.atRest(observe());
    event(MessageCode::EventZeroed);
}

Result<void> ServoLoop::zeroSensors() {
    auto found = findZero();
    if (!found)
        return found.error();
    take(std::move(*found));
    command("zero", zeroingJson(*m_readings.sensors().zeroing()));
    return {};
}

SensorTrust ServoLoop::sensorTrust(std::size_t object) const {
    const SensorChannels& sensors = m_readings.sensors();
    if (!sensors.isTrusted(object))
        return SensorTrust::Distrusted;
    return !sensors.fresh(object, m_clock.now_s()) || m_safety.isSensorStill(object) ? SensorTrust::Stale
                                                                                     : SensorTrust::Trusted;
}

Result<void> ServoLoop::confirmSensor(std::size_t object) {
    SensorChannels& sensors = m_readings.sensors();
    if (object >= sensors.size())
        return refusal(CommandVerb::ConfirmSensor);
    const std::string& name = m_experiment.objects[object].name;
    if (!sensors.confirm(object, m_clock.now_s()))
        return Error(MessageCode::ReasonSensorInvalid, {}, {name});
    m_safety.confirmSensor(object);
    const double value_K = sensors.measured_K(object);
    command("confirm-sensor", "{\"object\":" + std::to_string(object) +
                                  ",\"temperature_K\":" + formatNumber(value_K, 10) + "}");
    event(MessageCode::EventSensorConfirmed, {name, roundedTemperatureArg(value_K)});
    return {};
}

std::vector<Message> ServoLoop::reasons() const {
    std::vector<Message> out = m_faults.reasons();
    if (m_state == RunState::Fault)
        return out;
    const SensorChannels& sensors = m_readings.sensors();
    std::ranges::copy(m_readings.missing(), std::back_inserter(out));
    for (std::size_t i = 0; i < sensors.size(); ++i)
        if (sensors.isDoubted(i))
            out.push_back(m_readings.distrust(i));
    if (!m_readings.isSourceSeen() && !m_readings.wasSourceSeen()) // this is not an alarm
        out.push_back({MessageCode::ReasonSourcePoseLost, {}});
    if (m_state == RunState::NotReady && !sensors.full())
        out.push_back(sensors.filling());
    for (const auto& fit : {m_mounting, checkTargets(m_experiment), m_motion.checkReach()})
        if (!fit)
            out.push_back(fit.error().message);
    if (const SafetyFinding* finding = m_safety.forbidsArm(); finding != nullptr && !isArmedOrOn())
        out.push_back(finding->message);
    if (m_state == RunState::Holding && !m_pausedBySafety && out.empty())
        out.push_back({MessageCode::ReasonHeldByOperator, {}});
    if (Message aim = m_control.compromise();
        running() && aim.code != MessageCode::None && m_safety.lostSensor() == nullptr)
        out.push_back(std::move(aim));
    return out;
}

std::vector<AlarmCondition> ServoLoop::alarmConditions() const {
    std::vector<AlarmCondition> out = m_faults.alarmConditions();
    // What no pose holds by a wrong reading follows from that.
    const SafetyFinding* const lost = m_safety.lostSensor();
    if (Message aim = m_control.compromise(); running() && aim.code != MessageCode::None)
        out.push_back(
            {messageName(aim.code), std::move(aim), 3, lost ? alarmKey(*lost, m_experiment) : std::string()});
    return out;
}

void ServoLoop::updateReadiness() {
    if (m_state != RunState::NotReady && m_state != RunState::Ready)
        return;
    const bool isReady = m_readings.sensors().full() && m_readings.missing().empty() &&
                         requireFreshReadings() && m_mounting && checkTargets(m_experiment) &&
                         m_motion.checkReach() && m_safety.forbidsArm() == nullptr;
    m_state = isReady ? RunState::Ready : RunState::NotReady;
}

} // namespace bask
