// One sampling period of the servo loop: read, watch, control, record.

#include "engine/base/message_code.h"
#include "engine/model/hand_warm.h"
#include "engine/runtime/servo_loop.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace bask {
namespace {

constexpr double kSameTime_s = 0.01;
constexpr double kSameShutter_s = 0.1;             // two clocks do not tell one event alike
constexpr double kLongestCooling_s = 6.0 * 3600.0; ///< what is never known to be cold is not waited for
/// share of the clearance; below it the source has come nearer, or the robot obeys late
constexpr double kTooNear = 0.8;

} // namespace

void ServoLoop::tick() {
    try {
        look();
        watch();
        m_tick_s = m_clock.now_s();
        if (m_state == RunState::Running || m_state == RunState::Settled)
            control();
        else if (m_state == RunState::Stopping)
            retreat();
        else if (m_state == RunState::Fault && !m_motion.isHoming())
            makeSafe();
        else if (isManual())
            if (Message stuck = m_motion.goOn(); stuck.code != MessageCode::None)
                fault(std::move(stuck));
        if (m_state == RunState::Holding || isHeatedManually())
            keepHeating();
        else if (m_state != RunState::Running && m_state != RunState::Settled)
            m_heat.keepOff();
        trace();
        if (m_isCooling)
            watchCooling();
        updateReadiness();
    } catch (const std::exception& exception) {
        fault({MessageCode::ReasonInternalFault, {exception.what()}});
    }
}

void ServoLoop::look() {
    m_readings.read();
    m_motion.watch();
    noteShutter();
    const std::vector<HeatRates>& estimates = m_control.estimates();
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        m_latest.objects[i].lambda1 = estimates[i].lambda1;
        m_latest.objects[i].lambda2 = estimates[i].lambda2;
    }
}

void ServoLoop::noteShutter() {
    const ObjectThermometer* const byCamera = m_readings.byCamera();
    const auto shutter_s = byCamera != nullptr ? byCamera->camera().shutter_s() : std::nullopt;
    const bool isNew = shutter_s && (!m_shutter_s || *shutter_s > *m_shutter_s + kSameShutter_s);
    if (!isNew)
        return;
    m_shutter_s = shutter_s;
    if (isRecorded())
        event(MessageCode::EventShutter);
}

void ServoLoop::control() {
    keepHeating();
    if (m_state != RunState::Running && m_state != RunState::Settled)
        return; // the heat source is lost and the retreat has begun: keep its velocity
    const std::optional<ControlOutput> output = m_control.step(m_motion.rates());
    if (!output)
        return m_motion.standStill();
    m_latest.smallestSingularValue = output->smallestSingularValue;
    m_latest.limits = output->limits;
    if (m_readings.geometry()->lowestPoint_m(m_readings.coordinates()) <
        kTooNear * m_experiment.robot.clearance_m)
        m_motion.backOff();
    else
        m_motion.move(output->rates);
    noteSettling();
    if (m_control.isCompromiseNew())
        event(m_control.compromise());
}

void ServoLoop::noteSettling() {
    if (!m_readings.allWithinBand() || m_safety.isSourceOver()) {
        m_control.countBandAnew();
        if (m_state == RunState::Settled)
            m_state = RunState::Running;
    } else if (m_state == RunState::Running && m_control.withinBand_s() >= kRunSettledAfter_s &&
               !m_control.isOnTheWay()) {
        m_state = RunState::Settled;
        event(MessageCode::EventSettled);
    }
}

void ServoLoop::retreat() {
    const RetreatMotion::Step step = m_retreat.step();
    if (step == RetreatMotion::Step::UnderWay)
        return;
    if (step == RetreatMotion::Step::Stuck) {
        m_retreat.setRefused(true); // another retreat would not move either
        return fault(doesNotMove(m_retreat.left_m()));
    }
    const bool isOfRun = m_runOn;
    const std::string outcome = m_faults.isEmpty() ? m_outcome : "fault";
    trace();
    if (m_runOn)
        m_latest.time_s = m_clock.now_s() - m_control.began_s();
    endRun(outcome);
    if (!m_faults.isEmpty())
        m_state = RunState::Fault;
    else
        m_state = isOfRun ? RunState::Stopped : RunState::NotReady;
}

void ServoLoop::watchCooling() {
    const bool isCutShort = m_outcome != "settled" && m_outcome != "stopped";
    // nobody measures the temperature that a person has typed
    const bool isSourceAwaited =
        isCutShort && m_recordEnd == RecordEnd::ObjectsAndSourceCold && !m_devices.source.isManual();
    const bool isOver = areObjectsCold() && (!isSourceAwaited || isSourceCold());
    if (!isOver && m_clock.now_s() < m_ended_s + kLongestCooling_s)
        return;
    event(isOver ? MessageCode::EventCold : MessageCode::EventRecordEnded);
    endCooling();
}

bool ServoLoop::isSourceCold() const {
    const auto& source_K = m_readings.source_K();
    return source_K && *source_K <= m_readings.environment_K() + kHandWarm_K;
}

bool ServoLoop::areObjectsCold() const {
    constexpr double kCold_K = 313.15;
    constexpr double kOverRoom_K = 5.0;
    const bool isHeatOff =
        !m_heat.asked_K() && (m_devices.source.isManual() || m_heat.state() == HeatState::Off);
    const bool areApart = m_heat.isSourceDark() || m_retreat.isAway(); // otherwise they continue to warm up
    return isHeatOff && areApart && std::ranges::all_of(m_latest.objects, [&](const ObjectSample& object) {
               return object.estimated_K < std::max(kCold_K, m_readings.environment_K() + kOverRoom_K);
           });
}

void ServoLoop::trace() {
    if (!m_runOn && !m_isCooling)
        return;
    m_latest.time_s = m_clock.now_s() - m_control.began_s();
    m_record.samples.push_back(m_latest);
    traceFrame();
}

void ServoLoop::traceFrame() {
    const std::optional<double> period_s = m_experiment.sampling.thermalFramePeriod_s;
    if (!period_s || m_readings.byCamera() == nullptr)
        return;
    TraceFrame frame = m_readings.byCamera()->camera().frame();
    const bool isDue = frame.picture && (!m_frame_s || frame.time_s >= *m_frame_s + *period_s - kSameTime_s);
    if (!isDue)
        return;
    m_frame_s = frame.time_s;
    frame.time_s -= m_control.began_s();
    m_record.frames.push_back(std::move(frame));
}

} // namespace bask
