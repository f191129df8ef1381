#include "engine/runtime/servo_loop.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/controller_json.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/alarm_causes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
bool isRunOn(RunState state) {
    return state == RunState::Running || state == RunState::Holding || state == RunState::Settled ||
           state == RunState::Stopping;
}

namespace {

// A real robot's steps are rounded: going along a limit, every second one would be outside, and not be sent.
constexpr double kMargin_m = 2e-5;
constexpr double kMargin_rad = 1e-4;

Experiment insideLimits(Experiment experiment) {
    RobotLimits& limits = experiment.robot;
    limits.clearance_m += kMargin_m;
    for (int k = 0; k < 6; ++k) {
        const double margin = k < 3 ? kMargin_m : kMargin_rad;
        if (limits.upper[k] - limits.lower[k] < 4.0 * margin)
            continue;
        limits.lower[k] += margin;
        limits.upper[k] -= margin;
    }
    return experiment;
}

} // namespace

ServoLoop::ServoLoop(const Experiment& experiment, RigDevices devices, const Clock& clock)
    : m_experiment(experiment), m_devices(std::move(devices)), m_clock(clock),
      m_geometry(rigGeometry(m_devices.isReal ? insideLimits(experiment) : experiment)),
      m_sensors(experiment.objects.size(), experiment.sampling, sensorLimits(experiment)),
      m_safety(experiment), m_made_s(clock.now_s()), m_sourceRead_s(clock.now_s()) {
    m_coordinates = experiment.start;
    m_latest.source = experiment.source.pose;
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

void ServoLoop::use(const RigKnowledge& known) {
    m_faults = known.faults;
    for (Latched& fault : m_faults)
        if (fault.finding && fault.finding->object >= m_experiment.objects.size())
            fault.finding.reset(); // of an object that is no more
    m_state = m_faults.empty() ? RunState::NotReady : RunState::Fault;
    m_made_s = known.made_s;
    m_hasThermometer = known.hasThermometer;
    m_hasRobot = known.hasRobot;
    m_hasSource = known.hasSource;
    m_isRetreatRefused = known.isRetreatRefused;
    if (known.sensors)
        m_sensors.useDistrust(*known.sensors);
    m_safety.useHistory(known.wasSourceHeated);
    m_record = {}; // there is no start to tell of
}

bool ServoLoop::running() const {
    return isRunOn(m_state);
}

PlaceState ServoLoop::placeState() const {
    const double old_s = std::max(SafetyMonitor::kRobotSlow_s,
                                  m_experiment.safety.stalePeriods * m_experiment.sampling.period_s);
    if (m_robotProblem.code != MessageCode::None || !(placeAge_s() <= old_s))
        return PlaceState::Unknown;
    return m_robot.isPlaceSure && !m_isHoming ? PlaceState::Sure : PlaceState::Unsure;
}

double ServoLoop::placeAge_s() const {
    return m_hasRobot ? m_clock.now_s() - m_robot.time_s : std::numeric_limits<double>::infinity();
}

double ServoLoop::sourceAge_s() const {
    return m_latest.source_K > 0.0 ? m_clock.now_s() - m_sourceRead_s
                                   : std::numeric_limits<double>::infinity();
}

bool ServoLoop::isArmedOrOn() const {
    return running() || m_state == RunState::Armed;
}

double ServoLoop::runTime_s() const {
    return m_runOn || m_isCooling ? m_clock.now_s() - m_startTime_s : m_latest.time_s;
}

Error ServoLoop::refusal(CommandVerb verb) const {
    return Error(MessageCode::CommandNotNow, {}, {verbArg(verb), runStateName(m_state)});
}

void ServoLoop::event(MessageCode code, std::vector<MessageArg> args) {
    m_record.events.push_back({runTime_s(), {code, std::move(args)}});
}

void ServoLoop::command(const std::string& name, const std::string& value) {
    m_record.commands.push_back({runTime_s(), name, value});
}

LoopRecord ServoLoop::takeRecord() {
    return std::exchange(m_record, {});
}

void ServoLoop::makeSafe() {
    endMove();
    m_devices.robot.setRetreating(false);
    m_handHeat_K.reset();
    switchHeatOff();
}

void ServoLoop::switchHeatOff() {
    const auto off = m_devices.source.heatOff(); // of a dead link: the heat expires in the device
    m_heatOffProblem = problemOf(off, m_hasSource);
    m_asked_K.reset();
}

void ServoLoop::endRun(const std::string& outcome) {
    if (m_runOn || m_outcome.empty()) // what comes after a run is not its outcome
        m_outcome = outcome;
    makeSafe();
    m_controller.reset();
    const bool isHeatUnsure = m_devices.isReal && heatState() != HeatState::Off;
    const bool isAsMeant = (outcome == "settled" || outcome == "stopped") && !isHeatUnsure;
    m_isCooling = m_isCooling || (m_runOn && !isAsMeant);
    m_runOn = false;
}

void ServoLoop::addFault(Latched fault) {
    if (std::ranges::find(m_faults, fault.key, &Latched::key) != m_faults.end())
        return;
    event(fault.message.code, fault.message.args);
    m_faults.push_back(std::move(fault));
}

namespace {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char letter : text) { // names and reasons may have any
        if (letter == '"' || letter == '\\')
            out += '\\';
        out += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
    }
    return out + '"';
}

} // namespace

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

void ServoLoop::fault(Message reason) {
    faultWith(latched(std::move(reason)));
}

void ServoLoop::faultWith(Latched reason) {
    if (m_runOn && m_state != RunState::Stopping) {
        const Message ended = messageAbout(MessageCode::EventStoppedFor, reason.message);
        event(ended.code, ended.args);
    }
    addFault(std::move(reason));
    if (m_state != RunState::Fault)
        endRun("fault");
    m_state = RunState::Fault;
}

double ServoLoop::environment_K() const {
    return m_sensors.zeroing() ? m_sensors.zeroing()->environment_K : m_experiment.environment_K;
}

RigKnowledge ServoLoop::knowledge() const {
    return {m_faults,    m_made_s,           m_hasThermometer, m_hasRobot,
            m_hasSource, m_isRetreatRefused, m_sensors,        m_safety.wasSourceHeated()};
}

Result<void> ServoLoop::mayArm() const {
    if (const auto fit = checkTargets(m_experiment); !fit)
        return fit;
    if (m_state != RunState::Ready && m_state != RunState::Stopped)
        return refusal(CommandVerb::Arm);
    if (m_isHoming)
        return Error(MessageCode::CommandNotNow, {}, {verbArg(CommandVerb::Arm), "Homing"});
    if (const Message why = m_devices.source.cannotHeat(); why.code != MessageCode::None)
        return Error(why.code, {}, why.args);
    if (!m_sensors.zeroing())
        if (const auto found = m_sensors.findZero(m_experiment.environment_K); !found)
            return found.error();
    return {};
}

Result<void> ServoLoop::arm() {
    if (const auto may = mayArm(); !may)
        return may;
    endMove();
    if (!m_sensors.zeroing()) {
        auto found = m_sensors.findZero(m_experiment.environment_K);
        if (!found)
            return found.error();
        take(std::move(*found));
    }
    const SourceSpec& source = m_experiment.source;
    const double power_W_m2 =
        netSourcePower_W_m2(source.model, source.temperature_K, source.emittance, environment_K());
    if (!(power_W_m2 > 0.0))
        return Error(MessageCode::SourceTooWeak, {}, {formatNumber(power_W_m2, 3)});
    if (!m_outcome.empty()) // what the objects did in the last run is over
        m_safety.restart();
    m_outcome.clear();
    m_isCooling = false;
    m_latest.time_s = 0.0;
    m_state = RunState::Armed;
    command("arm", zeroingJson(*m_sensors.zeroing())); // it may have been long before
    event(MessageCode::EventArmed);
    return {};
}

Result<void> ServoLoop::disarm() {
    if (m_state != RunState::Armed)
        return refusal(CommandVerb::Disarm);
    m_state = RunState::Ready;
    command("disarm");
    return {};
}

Result<void> ServoLoop::start(bool acceptInfeasible) {
    if (m_state != RunState::Armed)
        return refusal(CommandVerb::Start);
    if (const auto fresh = requireFreshSensors(); !fresh)
        return fresh;
    if (const auto fit = checkTargets(m_experiment); !fit)
        return fit;
    if (const SafetyFinding* finding = m_safety.forbidsResume())
        return Error(finding->message.code, {}, finding->message.args);
    m_startTime_s = m_clock.now_s();
    m_withinBandSince_s = m_startTime_s;
    m_compromise.clear();
    m_compromiseTold = false;
    m_safety.forgetLoss();
    ControlModel model;
    model.geometry = m_geometry;
    model.believed = believedRates(m_experiment, environment_K());
    m_belief = model.believed;
    for (const ObjectSpec& object : m_experiment.objects)
        model.targets_K.push_back(object.target_K);
    m_controller = makeController(m_experiment.controller, std::move(model));
    m_handHeat_K.reset();
    m_state = RunState::Running;
    m_runOn = true;
    command("start", R"({"environment_K":)" + formatNumber(environment_K(), 10) +
                         (acceptInfeasible ? R"(,"accept_infeasible":true})" : "}"));
    event(MessageCode::EventStarted);
    // The first step is taken at once, on the readings just made.
    control();
    trace();
    return {};
}

Result<void> ServoLoop::hold() {
    if (isMoving()) {
        m_isHoming = false;
        endMove();
        return {};
    }
    if (m_state != RunState::Running && m_state != RunState::Settled)
        return refusal(CommandVerb::Hold);
    m_state = RunState::Holding;
    m_heldBySafety = false;
    standStill();
    command("hold");
    event(MessageCode::EventHeld);
    return {};
}

void ServoLoop::holdFor(const SafetyFinding& finding) {
    if (isMoving()) {
        if (!m_isHoming) // broken off, it would lose its place
            (void)hold();
    } else if (m_state == RunState::Running || m_state == RunState::Settled) {
        m_state = RunState::Holding;
        m_heldBySafety = true;
        standStill();
        const Message held = messageAbout(MessageCode::EventHeldFor, finding.message);
        event(held.code, held.args);
    }
}

Result<void> ServoLoop::requireFreshSensor(std::size_t object) const {
    if (!m_sensors.isBelieved(object)) {
        const Message why = distrust(object);
        return Error(why.code, {}, why.args);
    }
    if (!m_sensors.fresh(object, m_clock.now_s()))
        return Error(MessageCode::ReasonSensorInvalid, {}, {m_experiment.objects[object].name});
    return {};
}

Result<void> ServoLoop::requireFreshSensors() const {
    for (std::size_t i = 0; i < m_sensors.size(); ++i)
        if (const auto fresh = requireFreshSensor(i); !fresh)
            return fresh;
    if (!sourceSeen())
        return Error(MessageCode::ReasonSourcePoseLost, {});
    return {};
}

Result<void> ServoLoop::resume() {
    if (m_state != RunState::Holding)
        return refusal(CommandVerb::Resume);
    if (const auto fresh = requireFreshSensors(); !fresh)
        return fresh;
    if (const SafetyFinding* finding = m_safety.forbidsResume())
        return Error(finding->message.code, {}, finding->message.args);
    m_state = RunState::Running;
    m_heldBySafety = false;
    m_safety.forgetLoss();
    m_withinBandSince_s = m_clock.now_s();
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
    if (!allWithinBand())
        event(MessageCode::EventNotSettled, {objectsOffTarget()});
    event(reason.code, reason.args);
    beginRetreat();
    return {};
}

void ServoLoop::reportSuspended(double slept_s) {
    const std::string time = formatNumber(slept_s, 3);
    event(MessageCode::EventSuspended, {time});
    if (running() || heatOn() || m_asked_K || isMoving() || !m_rates.isZero(0.0))
        stopFor({MessageCode::SafetySuspended, {time}});
}

void ServoLoop::emergencyStop() {
    command("emergency-stop");
    m_isHoming = false;
    event(MessageCode::EventEmergencyStop);
    const bool refuses = m_retreatAt_s || (m_state == RunState::Stopping && hot() != nullptr);
    m_isRetreatRefused = m_isRetreatRefused || refuses;
    m_retreatAt_s.reset();
    endRun("emergency-stop");
    Latched reason = latched({MessageCode::ReasonEmergencyStop, {}});
    if (std::ranges::find(m_faults, reason.key, &Latched::key) == m_faults.end())
        m_faults.push_back(std::move(reason));
    m_state = RunState::Fault;
}

Result<void> ServoLoop::reset() {
    if (m_state != RunState::Fault)
        return refusal(CommandVerb::Reset);
    m_devices.source.renewGuard();
    m_safety.restart(); // what the source and the objects did is over; what they do now is not
    look();
    watch();
    if (const SafetyFinding* finding = m_safety.forbidsReset())
        return Error(finding->message.code, {}, finding->message.args);
    if (isAwaited(m_hasThermometer) || isAwaited(m_hasRobot) || isAwaited(m_hasSource))
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
    if (m_controller)
        m_controller->setTargets(targets_K);
    m_withinBandSince_s = m_clock.now_s();
    m_compromise.clear();
    m_compromiseTold = false;
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

void ServoLoop::reportInfeasible(const Message& reason) {
    if (running() && m_state != RunState::Stopping)
        event(reason.code, reason.args);
}

Result<void> ServoLoop::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    if (const auto result = validate(changed); !result)
        return result;
    const bool sameKind = settings.kind == m_experiment.controller.kind;
    m_experiment = std::move(changed);
    if (m_controller && sameKind) {
        m_controller->setGains(settings);
    } else if (m_controller) {
        // Another kind takes over from what the last one had learnt.
        ControlModel model;
        model.geometry = m_geometry;
        model.believed = m_belief;
        for (const ObjectSpec& object : m_experiment.objects)
            model.targets_K.push_back(object.target_K);
        m_controller = makeController(settings, std::move(model));
    }
    command("controller", controllerToJson(settings));
    if (isArmedOrOn())
        event(MessageCode::EventGainsChanged);
    return {};
}

Result<void> ServoLoop::setVision(const VisionSpec& vision) {
    if (m_state == RunState::Armed || running())
        return Error(MessageCode::SessionAlreadyRunning, {});
    Experiment changed = m_experiment;
    changed.vision = vision;
    if (auto valid = validate(changed); !valid)
        return valid;
    m_experiment = std::move(changed);
    return {};
}

std::optional<SourceTracking> ServoLoop::tracking() const {
    if (!m_experiment.source.tracked)
        return std::nullopt;
    const PoseReading& reading = m_sourceReading;
    SourceTracking tracking;
    tracking.isSeen = reading.valid && sourceSeen();
    tracking.isPredicted = reading.predicted;
    tracking.age_s = m_clock.now_s() - reading.seen_s;
    tracking.latency_s = reading.latency_s;
    tracking.position_m = reading.position_m;
    tracking.angle_rad = reading.angle_rad;
    return tracking;
}

void ServoLoop::addNote(const std::string& text) {
    m_record.notes.push_back({runTime_s(), text});
}

ServoLoop::Latched ServoLoop::latched(const SafetyFinding& finding) const {
    return {finding.message, alarmKey(finding, m_experiment), finding};
}

ServoLoop::Latched ServoLoop::latched(Message reason) {
    std::string key = messageName(reason.code);
    return {std::move(reason), std::move(key), std::nullopt};
}

Message ServoLoop::newest(const Latched& fault) const {
    for (const SafetyFinding& finding : m_safety.active())
        if (alarmKey(finding, m_experiment) == fault.key)
            return finding.message;
    return fault.message;
}

/// Returns whether its condition can be seen to be over, and is: the fault stays latched.
bool ServoLoop::isSeenOver(const Latched& fault) const {
    return fault.finding && alarmEntry(fault.finding->condition).isSeenOver &&
           std::ranges::none_of(m_safety.active(), [&](const SafetyFinding& finding) {
               return alarmKey(finding, m_experiment) == fault.key;
           });
}

std::vector<SafetyFinding> ServoLoop::foundOrLatched() const {
    std::vector<SafetyFinding> out = m_safety.active();
    for (const Latched& fault : m_faults)
        if (fault.finding)
            out.push_back(*fault.finding);
    return out;
}

std::vector<Message> ServoLoop::reasons() const {
    std::vector<Message> out;
    for (const Latched& fault : m_faults) // also those that a retreat will end in
        if (!fault.finding || causeOf(*fault.finding, m_safety.active(), m_experiment) == nullptr)
            out.push_back(newest(fault));
    for (const SafetyFinding& finding : m_safety.active()) {
        const AlarmEntry& row = alarmEntry(finding.condition);
        const bool isSaid =
            std::ranges::find(m_faults, alarmKey(finding, m_experiment), &Latched::key) != m_faults.end();
        if ((row.reaction >= SafetyReaction::Hold || row.priority == 1) && !isSaid &&
            causeOf(finding, m_safety.active(), m_experiment) == nullptr)
            out.push_back(finding.message);
    }
    if (m_state == RunState::Fault)
        return out;
    std::ranges::copy(missing(), std::back_inserter(out));
    for (std::size_t i = 0; i < m_sensors.size(); ++i)
        if (m_sensors.isDoubted(i))
            out.push_back(distrust(i));
    if (!sourceSeen() && m_sourceSeen_s < 0.0) // not seen yet, which is no alarm
        out.push_back({MessageCode::ReasonSourcePoseLost, {}});
    if (m_state == RunState::NotReady && !m_sensors.full())
        out.push_back(
            {MessageCode::ReasonEstimatorFilling,
             {std::to_string(m_sensors.leastCount()), std::to_string(m_experiment.sampling.window)}});
    if (const auto fit = checkTargets(m_experiment); !fit)
        out.push_back(fit.error().message);
    if (m_state == RunState::Holding && !m_heldBySafety && out.empty())
        out.push_back({MessageCode::ReasonHeldByOperator, {}});
    if (!m_compromise.empty() && running())
        out.push_back({MessageCode::EventCompromise, {MessageArg::differences(m_compromise)}});
    return out;
}

/// Of its words, which may be about less than its condition is at worst.
int ServoLoop::priorityOf(const Latched& fault) {
    const int ofWords = alarmPriority(fault.message.code);
    return ofWords > 0 ? ofWords : fault.finding ? alarmEntry(fault.finding->condition).priority : 1;
}

namespace {

// Seen over a link that works: what was lost before and is latched is not its cause.
bool heatsByItself(SafetyCondition condition) {
    return condition == SafetyCondition::SourceHeatsUnasked || condition == SafetyCondition::SourceNotCooling;
}

} // namespace

std::vector<AlarmCondition> ServoLoop::alarmConditions() const {
    const std::vector<SafetyFinding> present = foundOrLatched();
    std::vector<AlarmCondition> out;
    const auto add = [&](std::string key, const Message& message, int priority,
                         const std::optional<SafetyFinding>& finding = {}) {
        if (std::ranges::find(out, key, &AlarmCondition::key) != out.end())
            return;
        const auto& causes = finding && heatsByItself(finding->condition) ? m_safety.active() : present;
        const SafetyFinding* cause = finding ? causeOf(*finding, causes, m_experiment) : nullptr;
        out.push_back({std::move(key), message, priority, cause ? alarmKey(*cause, m_experiment) : ""});
    };
    for (const Latched& fault : m_faults)
        if (!isSeenOver(fault))
            add(fault.key, newest(fault), priorityOf(fault), fault.finding);
    for (const SafetyFinding& finding : m_safety.active())
        add(alarmKey(finding, m_experiment), finding.message, alarmEntry(finding.condition).priority,
            finding);
    if (!m_compromise.empty() && running())
        add(messageName(MessageCode::EventCompromise),
            {MessageCode::EventCompromise, {MessageArg::differences(m_compromise)}}, 3);
    return out;
}

std::vector<Message> ServoLoop::missing() const {
    std::vector<Message> out;
    for (const Message& problem : {m_robotProblem, m_thermometerProblem, m_sourceProblem})
        if (problem.code == MessageCode::RigIncomplete)
            out.push_back(problem);
    return out;
}

bool ServoLoop::sourceSeen() const {
    constexpr double kUnseen_s = 3.0; // a hand before the marker is no loss
    constexpr double kUnseenPeriods = 3.0;
    const double most_s = std::max(kUnseen_s, kUnseenPeriods * m_experiment.sampling.period_s);
    return !m_experiment.source.tracked || m_clock.now_s() - m_sourceSeen_s <= most_s;
}

bool ServoLoop::allWithinBand() const {
    return !m_latest.objects.empty() && std::ranges::all_of(m_latest.objects, [](const ObjectSample& object) {
        return std::abs(object.estimated_K - object.target_K) <= kSettledBand_K; // false when not a number
    });
}

MessageArg ServoLoop::objectsOffTarget() const {
    std::vector<ObjectKelvin> off;
    for (std::size_t i = 0; i < m_latest.objects.size(); ++i) {
        const double error_K = m_latest.objects[i].estimated_K - m_latest.objects[i].target_K;
        if (!(std::abs(error_K) <= kSettledBand_K))
            off.push_back({m_experiment.objects[i].name, error_K});
    }
    return MessageArg::differences(std::move(off));
}

void ServoLoop::updateReadiness() {
    if (m_state != RunState::NotReady && m_state != RunState::Ready)
        return;
    bool ready = m_sensors.full();
    for (std::size_t i = 0; i < m_sensors.size(); ++i)
        ready = ready && requireFreshSensor(i);
    ready = ready && missing().empty() && sourceSeen() && checkTargets(m_experiment);
    m_state = ready ? RunState::Ready : RunState::NotReady;
}

} // namespace bask
