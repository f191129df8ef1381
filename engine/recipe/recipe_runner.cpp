#include "engine/recipe/recipe_runner.h"

#include "engine/base/message_code.h"
#include "engine/base/notice.h"
#include "engine/base/words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr double kReadyWithin_s = 60.0;
constexpr int kFillingWindows = 4; ///< of the rate estimator: readings drop out
constexpr double kArmed_s = 1.0;   ///< the readings are fresh again after the session file was made
constexpr double kStoppedWithin_s = 600.0;

bool isAtRest(RunState state) {
    return state == RunState::Idle || state == RunState::NotReady || state == RunState::Ready ||
           state == RunState::Stopped;
}

Message firstOf(const Snapshot& snapshot) {
    return snapshot.reasons.empty() ? Message{} : snapshot.reasons.front();
}

/// By jog, by its own controls, or heated by hand: a recipe has no part in that.
bool isOperatedManually(const Snapshot& snapshot) {
    return snapshot.isMoving || snapshot.heatSetPoint_K.has_value();
}

bool isPausedByPerson(const Snapshot& snapshot) {
    return std::ranges::any_of(snapshot.reasons, [](const Message& reason) {
        return reason.code == MessageCode::ReasonHeldByOperator;
    });
}

} // namespace

bool isNotThereYet(MessageCode code) {
    constexpr std::array kCodes{
        MessageCode::SafetyStartUp,    MessageCode::LinkNotOpened,    MessageCode::LinkLost,
        MessageCode::DeviceSilent,     MessageCode::RobotOpening,     MessageCode::ReasonRobotLost,
        MessageCode::ReasonSourceLost, MessageCode::RobotPlaceUnsure, MessageCode::ProgramSilent};
    return std::ranges::find(kCodes, code) != kCodes.end();
}

RecipeRunner::RecipeRunner(Recipe recipe, RecipeExperiments experiments, RecordingPath recordingPath)
    : m_recipe(std::move(recipe)), m_experiments(std::move(experiments)),
      m_recordingPath(std::move(recordingPath)), m_progress(m_recipe.steps.size()) {}

std::vector<Command> RecipeRunner::begin(const Snapshot& now) {
    m_orders.clear();
    m_loadId = now.loadId;
    remember(now.alarms);
    enter(0);
    return std::move(m_orders);
}

std::vector<Command> RecipeRunner::take(const Snapshot& snapshot) {
    m_orders.clear();
    switch (m_phase) {
    case Phase::Load:
        loading(snapshot);
        break;
    case Phase::Arm:
        arming(snapshot);
        break;
    case Phase::Start:
        starting(snapshot);
        break;
    case Phase::Run:
        running(snapshot);
        break;
    case Phase::Stop:
        stopping(snapshot);
        break;
    case Phase::Wait:
        waiting(snapshot);
        break;
    case Phase::Over:
        break;
    }
    return std::move(m_orders);
}

std::vector<Command> RecipeRunner::stopNow() {
    m_orders.clear();
    if (m_phase == Phase::Stop) {
        m_end = m_end == RecipeEnd::None ? RecipeEnd::Stopped : m_end;
    } else if (m_phase == Phase::Run) {
        m_end = RecipeEnd::Stopped;
        stopRun(State::Stopped);
    } else if (m_phase != Phase::Over) {
        if (m_phase == Phase::Arm || m_phase == Phase::Start)
            m_orders.emplace_back(Stop{}); // disarms; a start that is on its way is stopped
        finishAll(State::Stopped, RecipeEnd::Stopped);
    }
    return std::move(m_orders);
}

void RecipeRunner::takeOver(bool isHold) {
    if (m_phase != Phase::Over)
        finishAll(isHold && m_phase == Phase::Run ? State::Paused : State::Stopped, RecipeEnd::TakenOver);
}

void RecipeRunner::enter(std::size_t step) {
    m_step = step;
    m_progress[step].state = State::Underway;
    m_isWithin = false;
    if (!now().isRun() && m_loaded == m_experiments[step]) {
        m_phase = Phase::Wait;
        m_isAnswered = false; // its clock is that of the next snapshot
        return;
    }
    if (m_keepsExperiment)
        return finishAll(State::Stopped, RecipeEnd::TakenOver);
    m_phase = Phase::Load;
    m_isAnswered = false;
    m_loaded = m_experiments[step];
    m_orders.emplace_back(LoadExperiment{*m_loaded});
}

void RecipeRunner::loading(const Snapshot& snapshot) {
    if (snapshot.loadId == m_loadId && !m_isAnswered) { // from before
        const MessageCode refusal = snapshot.refusal.code;
        if (refusal != MessageCode::None && refusal != MessageCode::CommandNotNow) // which no load is told
            failed(snapshot.refusal);
        return;
    }
    if (!m_isAnswered) {
        m_isAnswered = true;
        m_loadId = snapshot.loadId;
        m_since_s = snapshot.clock_s;
    } else if (snapshot.loadId != m_loadId || isOperatedManually(snapshot)) {
        return finishAll(State::Stopped, RecipeEnd::TakenOver);
    }
    const SamplingSpec& sampling = m_loaded->sampling;
    const double limit_s = std::max(kReadyWithin_s, kFillingWindows * sampling.window * sampling.period_s);
    const bool isLate = snapshot.clock_s - m_since_s > limit_s;
    if (snapshot.state == RunState::Fault) {
        // That of a rig which was connected just now waits for whoever looks at it; no other load latches
        // one.
        const auto passes = [](const Message& reason) { return isNotThereYet(reason.code); };
        if (isLate || m_step > 0 || !std::ranges::all_of(snapshot.reasons, passes))
            finishAll(State::Failed, RecipeEnd::Fault, firstOf(snapshot));
    } else if (const Alarm* alarm = newAlarm(snapshot)) {
        endBy(snapshot, RecipeEnd::Alarm, alarm->message);
    } else if (now().isRun() ? snapshot.state == RunState::Ready : isAtRest(snapshot.state)) {
        ready(snapshot);
    } else if (isLate) {
        failed(firstOf(snapshot));
    }
}

void RecipeRunner::ready(const Snapshot& snapshot) {
    remember(snapshot.alarms);
    m_since_s = snapshot.clock_s;
    if (!now().isRun()) {
        m_phase = Phase::Wait;
        return;
    }
    const auto recording = m_recordingPath(m_step);
    if (!recording)
        return failed(recording.error().message);
    m_progress[m_step].recording = *recording;
    m_isAnswered = false;
    m_phase = Phase::Arm;
    m_orders.emplace_back(Arm{m_progress[m_step].recording});
}

void RecipeRunner::arming(const Snapshot& snapshot) {
    if (isEndedBefore(snapshot))
        return;
    if (snapshot.loadId != m_loadId)
        return finishAll(State::Stopped, RecipeEnd::TakenOver);
    if (snapshot.state == RunState::Armed) {
        if (!m_isAnswered) {
            m_isAnswered = true;
            m_since_s = snapshot.clock_s;
        } else if (snapshot.clock_s - m_since_s >= kArmed_s) {
            m_phase = Phase::Start;
            m_orders.emplace_back(Start{false});
        }
    } else if (m_isAnswered) { // disarmed
        finishAll(State::Stopped, RecipeEnd::TakenOver);
    } else if (snapshot.refusal.code != MessageCode::None) {
        failed(snapshot.refusal);
    } else if (snapshot.clock_s - m_since_s > kReadyWithin_s) {
        failed(firstOf(snapshot));
    }
}

void RecipeRunner::starting(const Snapshot& snapshot) {
    if (isEndedBefore(snapshot))
        return;
    if (snapshot.state == RunState::Running) {
        m_phase = Phase::Run;
        return running(snapshot);
    }
    if (snapshot.state != RunState::Armed)
        return finishAll(State::Stopped, RecipeEnd::TakenOver);
    if (snapshot.refusal.code != MessageCode::None) {
        m_orders.emplace_back(Stop{}); // disarms
        failed(snapshot.refusal);
    }
}

/// By a fault, a retreat of the engine's own, or an alarm, before its run was on.
bool RecipeRunner::isEndedBefore(const Snapshot& snapshot) {
    const Alarm* alarm = newAlarm(snapshot);
    if (snapshot.state == RunState::Fault) {
        finishAll(State::Failed, RecipeEnd::Fault, firstOf(snapshot));
    } else if (snapshot.state == RunState::Stopping && !snapshot.reasons.empty()) {
        endBy(snapshot, RecipeEnd::Fault, firstOf(snapshot));
    } else if (alarm != nullptr && snapshot.state != RunState::Running) {
        m_end = RecipeEnd::Alarm;
        stopRun(State::Failed, alarm->message); // disarms; a start that is on its way is stopped
    } else {
        return false;
    }
    return true;
}

void RecipeRunner::running(const Snapshot& snapshot) {
    RecipeProgress& progress = m_progress[m_step];
    progress.elapsed_s = snapshot.runTime_s;
    const bool isOn = snapshot.state == RunState::Running || snapshot.state == RunState::Settled;
    const Alarm* alarm = newAlarm(snapshot);
    if (snapshot.state == RunState::Fault)
        return finishAll(State::Failed, RecipeEnd::Fault, firstOf(snapshot));
    if (snapshot.state == RunState::Holding && !isPausedByPerson(snapshot)) {
        m_end = RecipeEnd::Alarm;
        return stopRun(State::Failed, alarm != nullptr ? alarm->message : firstOf(snapshot));
    }
    if (!isOn && !snapshot.reasons.empty() && !isPausedByPerson(snapshot)) // the engine's own retreat
        return endBy(snapshot, RecipeEnd::Fault, firstOf(snapshot));
    if (!isOn)
        return finishAll(snapshot.state == RunState::Holding ? State::Paused : State::Stopped,
                         RecipeEnd::TakenOver);
    if (alarm != nullptr) {
        m_end = RecipeEnd::Alarm;
        return stopRun(State::Failed, alarm->message);
    }
    for (const TraceSample& sample : snapshot.newSamples)
        if (isReached(sample, sample.time_s)) {
            progress.elapsed_s = sample.time_s;
            return stopRun(State::Done);
        }
    if (now().until != RecipeStep::Until::Time && snapshot.runTime_s >= now().maxDuration_s)
        stopRun(State::NotReached);
}

void RecipeRunner::stopping(const Snapshot& snapshot) {
    if (!m_isAnswered) {
        m_isAnswered = true;
        m_since_s = snapshot.clock_s;
    }
    const Alarm* alarm = newAlarm(snapshot);
    if (snapshot.state == RunState::Fault)
        return finishAll(State::Failed, RecipeEnd::Fault, firstOf(snapshot));
    if (alarm != nullptr && m_end == RecipeEnd::None) {
        m_end = RecipeEnd::Alarm;
        m_reason = alarm->message;
    }
    if (isAtRest(snapshot.state)) {
        if (m_end == RecipeEnd::None)
            goOn();
        else
            m_phase = Phase::Over;
    } else if (snapshot.clock_s - m_since_s > kStoppedWithin_s) {
        finishAll(State::Failed, RecipeEnd::Fault,
                  {MessageCode::CommandNotNow, {verbArg(CommandVerb::Stop), runStateName(snapshot.state)}});
    }
}

void RecipeRunner::waiting(const Snapshot& snapshot) {
    if (!m_isAnswered) {
        m_isAnswered = true;
        m_since_s = snapshot.clock_s;
    }
    RecipeProgress& progress = m_progress[m_step];
    progress.elapsed_s = snapshot.clock_s - m_since_s;
    if (snapshot.state == RunState::Fault)
        return finishAll(State::Failed, RecipeEnd::Fault, firstOf(snapshot));
    if (const Alarm* alarm = newAlarm(snapshot))
        return endBy(snapshot, RecipeEnd::Alarm, alarm->message);
    if (!isAtRest(snapshot.state) || snapshot.loadId != m_loadId || isOperatedManually(snapshot))
        return finishAll(State::Stopped, RecipeEnd::TakenOver);
    if (isReached(snapshot.latest, progress.elapsed_s))
        finish(State::Done);
    else if (now().until != RecipeStep::Until::Time && progress.elapsed_s >= now().maxDuration_s)
        finish(State::NotReached);
}

bool RecipeRunner::isReached(const TraceSample& sample, double time_s) {
    using Until = RecipeStep::Until;
    const RecipeStep& step = now();
    if (step.until == Until::Time)
        return time_s >= step.duration_s;
    if (step.until == Until::Settled) {
        const bool isWithin = std::ranges::all_of(sample.objects, [](const ObjectSample& object) {
            return std::abs(object.estimated_K - object.target_K) <=
                   kSettledBand_K; // false when not a number
        });
        if (isWithin && !m_isWithin)
            m_within_s = time_s;
        m_isWithin = isWithin;
        return isWithin && time_s - m_within_s >= step.duration_s;
    }
    const auto& objects = m_loaded->objects;
    const auto it = std::ranges::find(objects, step.object, &ObjectSpec::name);
    const auto index = static_cast<std::size_t>(it - objects.begin());
    if (index >= sample.objects.size() || !sample.objects[index].valid)
        return false;
    const double measured_K = sample.objects[index].measured_K;
    return step.until == Until::Above ? measured_K >= step.temperature_K : measured_K <= step.temperature_K;
}

/// Also one that is over again: the load of the next experiment takes an alarm's cause out of sight.
const Alarm* RecipeRunner::newAlarm(const Snapshot& snapshot) const {
    const auto isAllowed = [this](MessageCode code) {
        return isNotice(code) || (m_phase == Phase::Load && isNotThereYet(code));
    };
    const auto it = std::ranges::find_if(snapshot.alarms, [&](const Alarm& alarm) {
        return !m_knownAlarms.contains({alarm.id, alarm.count}) && !isAllowed(alarm.message.code);
    });
    return it == snapshot.alarms.end() ? nullptr : &*it;
}

void RecipeRunner::remember(const std::vector<Alarm>& alarms) {
    m_knownAlarms.clear();
    for (const Alarm& alarm : alarms)
        m_knownAlarms.emplace(alarm.id, alarm.count);
}

/// Nothing of it is on.
void RecipeRunner::failed(const Message& reason) {
    m_progress[m_step].recording.clear();
    finish(State::Failed, reason);
}

void RecipeRunner::stopRun(State state, Message reason) {
    m_orders.emplace_back(Stop{});
    m_phase = Phase::Stop;
    m_isAnswered = false;
    m_progress[m_step].state = state;
    m_progress[m_step].reason = reason;
    m_reason = std::move(reason);
}

/// A retreat of the engine's own is waited for: who ends a program must not cut it short.
void RecipeRunner::endBy(const Snapshot& snapshot, RecipeEnd end, const Message& reason) {
    if (snapshot.state != RunState::Stopping)
        return finishAll(State::Failed, end, reason);
    m_end = end;
    stopRun(State::Failed, reason);
    m_orders.clear();
}

void RecipeRunner::finish(State state, const Message& reason) {
    m_progress[m_step].state = state;
    m_progress[m_step].reason = reason;
    goOn();
}

void RecipeRunner::goOn() {
    const bool isDone = m_progress[m_step].state == State::Done;
    m_phase = Phase::Over;
    if (!isDone && !now().goesOn) {
        m_end = RecipeEnd::StepFailed;
        m_reason = m_progress[m_step].reason;
    } else if (m_step + 1 == m_recipe.steps.size()) {
        const auto done = [](const RecipeProgress& each) { return each.state == State::Done; };
        m_end = std::ranges::all_of(m_progress, done) ? RecipeEnd::Done : RecipeEnd::StepFailed;
    } else if (m_isLast) {
        m_end = RecipeEnd::Stopped;
    } else {
        enter(m_step + 1);
    }
}

void RecipeRunner::finishAll(State state, RecipeEnd end, const Message& reason) {
    m_progress[m_step].state = state;
    m_progress[m_step].reason = reason;
    m_end = end;
    m_reason = reason;
    m_phase = Phase::Over;
}

} // namespace bask
