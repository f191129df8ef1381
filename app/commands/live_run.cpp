#include "app/commands/live_run.h"

#include "app/commands/cooling_watch.h"
#include "app/commands/engine_thread.h"
#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/monitor/monitor.h"
#include "engine/recipe/recipe_runner.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <utility>

namespace bask {
namespace {

constexpr double kReadyWithin_s = 60.0;
constexpr double kStoppedWithin_s = 120.0; ///< of a retreat that does not move any more
constexpr double kArmed_s = 1.0;           // the readings are fresh again after the session file was made

/// One step of the way for each snapshot.
class LiveRun {
public:
    LiveRun(const Experiment& experiment, const SimulatedRunOptions& options, const LiveStart& start)
        : m_experiment(experiment), m_options(options), m_allowed(start.allowed), m_place(start.place),
          m_withinSince_s(experiment.objects.size(), HUGE_VAL) {
        m_monitor.use(start.monitor);
        m_engine->worker.setWatch(m_monitor.inlet());
        m_engine->worker.setRecordEnd(RecordEnd::ObjectsCold);
        QObject::connect(&m_engine->worker, &EngineWorker::published, &m_here,
                         [this](const Snapshot& snapshot) { take(snapshot); });
        QObject::connect(&m_engine->worker, &EngineWorker::stepped, &m_here, [this](double lateness_s) {
            if (m_wish == Wish::Run && m_last.state != RunState::Armed)
                m_outcome.lateness.add(lateness_s);
        });
    }

    Result<RunOutcome> run() {
        const SignalCount signalCount;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, &m_here, [&] { obey(signalCount.now()); });
        look.start(SignalCount::kLook_ms);
        m_engine->ask([this] { m_engine->worker.start(); });
        for (const Command& program : m_allowed)
            post(program);
        post(SetLabels{m_options.labels});
        post(LoadExperiment{m_experiment});
        if (!m_isOver)
            QCoreApplication::exec();
        look.stop();
        endEngine();
        if (m_error)
            return *m_error;
        finish();
        return m_outcome;
    }

private:
    enum class Wish { Arm, Start, Run, End, Watch };

    /// With what it tells last.
    void endEngine() {
        const auto before = static_cast<std::ptrdiff_t>(m_outcome.events.size());
        m_engine.reset();
        QCoreApplication::sendPostedEvents(&m_here);
        m_outcome.fault =
            m_outcome.fault || std::any_of(m_outcome.events.begin() + before, m_outcome.events.end(),
                                           [](const TraceEvent& event) {
                                               return event.message.code == MessageCode::HeatLeftUnknown;
                                           });
    }

    void take(const Snapshot& snapshot) {
        m_last = snapshot;
        std::ranges::copy(snapshot.newEvents, std::back_inserter(m_outcome.events));
        for (const TraceSample& sample : snapshot.newSamples)
            note(sample);
        if (m_isOver)
            return;
        if (snapshot.refusal.code != MessageCode::None && mayNotBeRefused(snapshot.refusal))
            return end(Error(snapshot.refusal.code, {}, snapshot.refusal.args));
        if (snapshot.refusal.code != MessageCode::None && snapshot.refusal.code != MessageCode::CommandNotNow)
            m_resetRefused = snapshot.refusal;
        switch (snapshot.state) {
        case RunState::Fault:
            return faulted(snapshot);
        case RunState::Ready:
            if (m_wish == Wish::Arm)
                go(Wish::Start, Arm{m_options.sessionPath, m_options.mayReplace});
            return;
        case RunState::Armed:
            m_armed_s = m_armed_s.value_or(m_clock.now_s());
            if (m_wish == Wish::Start && m_clock.now_s() - *m_armed_s >= kArmed_s) {
                // What was wrong before the run is not any more.
                std::erase_if(m_outcome.events,
                              [](const TraceEvent& event) { return alarmPriority(event.message.code) > 0; });
                go(Wish::Run, Start{true});
            }
            return;
        case RunState::Running:
            m_hasBegun = true;
            return;
        case RunState::Stopping:
            if (snapshot.latest.coordinates != m_retreatFrom) {
                m_retreatFrom = snapshot.latest.coordinates;
                m_stopped_s = m_clock.now_s();
            }
            return;
        case RunState::Stopped: // also by the engine itself
            if (m_wish == Wish::End || (m_wish == Wish::Run && m_hasBegun))
                m_wish = Wish::Watch;
            return watch(snapshot);
        default:
            return;
        }
    }

    /// A reset may come too early, and a stop after the engine's own.
    bool mayNotBeRefused(const Message& refusal) const {
        if (refusal.code == MessageCode::CommandNotNow && isVerb(refusal.args.front(), CommandVerb::Reset))
            return false;
        return m_wish == Wish::Start || (m_wish == Wish::Run && !m_hasBegun) ||
               (m_wish == Wish::Arm && !std::isfinite(m_reset_s));
    }

    void faulted(const Snapshot& snapshot) {
        if (m_wish != Wish::Arm) {
            m_outcome.fault = true;
            m_wish = Wish::Watch;
            return watch(snapshot);
        }
        if (const auto order = m_place.next(snapshot))
            return post(*order);
        if (m_place.isPending(snapshot))
            return;
        if (!snapshot.isPlaceSure)
            return end(Error(MessageCode::RobotPlaceUnsure, {}));
        for (const Message& reason : snapshot.reasons)
            if (!isNotThereYet(reason.code))
                return end(Error(reason.code, {}, reason.args));
        if (m_clock.now_s() - m_began_s > kReadyWithin_s)
            return endNotReady();
        if (m_clock.now_s() - m_reset_s > kBetweenResets_s) {
            m_reset_s = m_clock.now_s();
            post(Reset{});
        }
    }

    /// After a run.
    void watch(const Snapshot& snapshot) {
        if (m_wish != Wish::Watch)
            return;
        // The record of a fault goes on until the objects are cold.
        m_over_s = m_over_s.value_or(m_clock.now_s());
        const bool isRecording =
            !snapshot.recordingPath.empty() && m_clock.now_s() - *m_over_s < kFaultRecord_s;
        if (m_cooling.isOver(snapshot) && (!isRecording || m_cooling.isAlarmed(snapshot)))
            return over();
        if (std::exchange(m_isWatchTold, true))
            return;
        for (const Message& reason : snapshot.reasons)
            std::fprintf(stderr, "bask run: %s\n", describe(reason).c_str());
        std::fputs(
            "bask run: the run is over; waiting until the source is seen to cool, and the objects of a "
            "recorded fault. Ctrl+C ends that.\n",
            stderr);
    }

    void go(Wish wish, const Command& command) {
        m_wish = wish;
        post(command);
    }

    void post(const Command& command) {
        m_engine->ask([this, command] { m_engine->worker.post(command); });
    }

    void obey(int count) {
        const bool isBefore = m_wish == Wish::Arm || m_wish == Wish::Start;
        if (m_wish == Wish::Watch && count > m_stops) // a person looks after it
            return over();
        if (m_wish != Wish::Watch)
            m_stops = count;
        if (count >= 1 && isBefore) { // the end makes the rig safe
            m_outcome.fault = true;
            over();
        } else if (count >= 2 && !m_isEmergency) {
            m_isEmergency = true;
            post(EmergencyStop{});
        } else if (count == 1 && m_wish == Wish::Run) {
            stop();
        }
        const double now_s = m_clock.now_s();
        if (m_wish == Wish::Arm && now_s - m_began_s > kReadyWithin_s)
            endNotReady();
        if (m_wish == Wish::End && now_s - m_stopped_s > kStoppedWithin_s)
            over();
    }

    void note(const TraceSample& sample) {
        if (m_wish != Wish::Run)
            return;
        for (std::size_t i = 0; i < sample.objects.size(); ++i) {
            const ObjectSample& object = sample.objects[i];
            const bool within = std::abs(object.estimated_K - object.target_K) <= kSettledBand_K;
            m_withinSince_s[i] = within ? std::min(m_withinSince_s[i], sample.time_s) : HUGE_VAL;
        }
        m_sample = sample;
        if (m_options.progress)
            m_options.progress(sample.time_s, sample);
        const double limit_s = m_options.duration_s.value_or(m_experiment.simulation.durationLimit_s);
        const bool settledLong = !m_options.duration_s && inBandFor_s() >= kSettledFor_s;
        if (settledLong || sample.time_s >= limit_s)
            stop();
    }

    double inBandFor_s() const { return m_sample.time_s - *std::ranges::max_element(m_withinSince_s); }

    void stop() {
        m_stopped_s = m_clock.now_s();
        go(Wish::End, Stop{});
    }

    void finish() {
        m_outcome.simulated_s = m_sample.time_s;
        m_outcome.settled = !m_outcome.fault && inBandFor_s() >= std::min(kInBandFor_s, m_sample.time_s);
        for (std::size_t i = 0; i < m_sample.objects.size(); ++i)
            m_outcome.objects.push_back(
                {m_experiment.objects[i].name, m_sample.objects[i].target_K, m_sample.objects[i].estimated_K,
                 std::isfinite(m_withinSince_s[i]) ? std::optional(m_withinSince_s[i]) : std::nullopt});
    }

    /// With what kept it from being ready: why a reset was refused says more than that one is needed.
    void endNotReady() {
        std::vector<Message> why = m_last.reasons;
        if (m_resetRefused.code != MessageCode::None)
            why.insert(why.begin(), m_resetRefused);
        std::stable_partition(why.begin(), why.end(),
                              [](const Message& each) { return each.code != MessageCode::SafetyStartUp; });
        if (!why.empty())
            end(Error(why.front().code, {}, why.front().args));
    }
    void end(Error error) {
        m_error = std::move(error);
        over();
    }
    void over() {
        m_isOver = true;
        QCoreApplication::exit();
    }

    const Experiment& m_experiment;
    const SimulatedRunOptions& m_options;
    const std::vector<Command> m_allowed;
    PlaceOrders m_place;
    SteadyClock m_clock;
    Wish m_wish = Wish::Arm;
    bool m_hasBegun = false, m_isOver = false, m_isEmergency = false;
    Vector6d m_retreatFrom = Vector6d::Zero();
    double m_began_s = SteadyClock().now_s();
    double m_reset_s = -HUGE_VAL, m_stopped_s = 0.0;
    CoolingWatch m_cooling{m_experiment.environment_K};
    bool m_isWatchTold = false;
    int m_stops = 0;        ///< signals until then
    Message m_resetRefused; ///< why; code None: it was not
    std::optional<double> m_armed_s, m_over_s;
    std::vector<double> m_withinSince_s; ///< infinite: outside of the band
    TraceSample m_sample;
    Snapshot m_last;
    RunOutcome m_outcome;
    std::optional<Error> m_error;
    Monitor m_monitor;
    QObject m_here; ///< of the thread that takes the snapshots
    std::unique_ptr<EngineThread> m_engine = std::make_unique<EngineThread>();
};

} // namespace

Result<RunOutcome> runLive(const Experiment& experiment, const SimulatedRunOptions& options,
                           const LiveStart& start) {
    if (!experiment.rig)
        return Error(MessageCode::RigMissing, {});
    if (const auto fit = checkTargets(experiment); !fit) // it would never be ready
        return fit.error();
    return LiveRun(experiment, options, start).run();
}

} // namespace bask
