#include "app/commands/live_run.h"

#include "engine/base/message_code.h"
#include "engine/runtime/engine_worker.h"

#include <QCoreApplication>
#include <QTimer>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>

namespace bask {
namespace {

constexpr double kReadyWithin_s = 60.0;
constexpr double kStoppedWithin_s = 120.0;
constexpr double kArmed_s = 1.0; // the readings are fresh again after the session file was made
constexpr int kLook_ms = 20;

volatile std::sig_atomic_t g_signals = 0;

void count(int) {
    g_signals = g_signals + 1;
}

/// Signals are counted while it lives.
class SignalCount {
public:
    SignalCount() {
        g_signals = 0;
        m_interrupt = std::signal(SIGINT, count);
        m_terminate = std::signal(SIGTERM, count);
    }
    ~SignalCount() {
        std::signal(SIGINT, m_interrupt);
        std::signal(SIGTERM, m_terminate);
    }
    int now() const { return g_signals; }

private:
    void (*m_interrupt)(int);
    void (*m_terminate)(int);
};

/// One step of the way for each snapshot.
class LiveRun {
public:
    LiveRun(const Experiment& experiment, const SimulatedRunOptions& options)
        : m_experiment(experiment), m_options(options), m_withinSince_s(experiment.objects.size(), HUGE_VAL) {
        QObject::connect(&m_worker, &EngineWorker::published, &m_worker,
                         [this](const Snapshot& snapshot) { take(snapshot); });
        QObject::connect(&m_worker, &EngineWorker::stepped, &m_worker, [this](double lateness_s) {
            if (m_wish == Wish::Run && m_last.state != RunState::Armed)
                m_outcome.lateness.add(lateness_s);
        });
    }

    Result<RunOutcome> run() {
        const SignalCount signalCount;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, &m_worker, [&] { obey(signalCount.now()); });
        look.start(kLook_ms);
        m_worker.start();
        m_worker.post(LoadExperiment{m_experiment});
        if (!m_isOver)
            QCoreApplication::exec();
        look.stop();
        m_worker.shutdown();
        if (m_error)
            return *m_error;
        finish();
        return m_outcome;
    }

private:
    enum class Wish { Arm, Start, Run, End };

    void take(const Snapshot& snapshot) {
        m_last = snapshot;
        std::ranges::copy(snapshot.newEvents, std::back_inserter(m_outcome.events));
        for (const TraceSample& sample : snapshot.newSamples)
            note(sample);
        if (snapshot.refusal.code != MessageCode::None && !m_isResetting) // a reset may come too early
            return end(Error(snapshot.refusal.code, {}, snapshot.refusal.args));
        if (m_isPosting) // else its answer would be taken for the state before it
            return;
        switch (snapshot.state) {
        case RunState::Fault:
            return faulted(snapshot);
        case RunState::Ready:
            if (m_wish == Wish::Arm)
                later(Wish::Start, Arm{m_options.sessionPath});
            return;
        case RunState::Armed:
            m_armed_s = m_armed_s.value_or(m_clock.now_s());
            if (m_wish == Wish::Start && m_clock.now_s() - *m_armed_s >= kArmed_s)
                later(Wish::Run, Start{true});
            return;
        case RunState::Stopped:
            if (m_wish == Wish::End)
                over();
            return;
        default:
            return;
        }
    }

    void faulted(const Snapshot& snapshot) {
        const bool isStartUp =
            m_wish == Wish::Arm && std::ranges::all_of(snapshot.reasons, [](const Message& m) {
                return m.code == MessageCode::SafetyStartUp;
            });
        if (isStartUp)
            return later(Wish::Arm, Reset{});
        if (m_wish != Wish::Arm) {
            m_outcome.fault = true;
            return over();
        }
        const Message reason = snapshot.reasons.empty() ? Message() : snapshot.reasons.front();
        if (m_clock.now_s() - m_began_s > kReadyWithin_s)
            return end(Error(reason.code, {}, reason.args));
        if (m_clock.now_s() - m_reset_s > 1.0) // devices that were not there yet
            later(Wish::Arm, Reset{});
    }

    /// Not from inside of a snapshot's slot: the worker may be in the middle of a command.
    void later(Wish wish, const Command& command) {
        m_wish = wish;
        m_isPosting = true;
        m_isResetting = std::holds_alternative<Reset>(command);
        if (m_isResetting)
            m_reset_s = m_clock.now_s();
        QTimer::singleShot(0, &m_worker, [this, command] {
            m_isPosting = false;
            m_worker.post(command);
        });
    }

    void obey(int count) {
        if (count >= 2 && !m_isEmergency) {
            m_isEmergency = true;
            m_worker.post(EmergencyStop{});
        } else if (count == 1 && m_wish == Wish::Run) {
            stop();
        } else if (count >= 1 && m_wish != Wish::Run && m_wish != Wish::End) {
            m_outcome.fault = true;
            over();
        }
        const double now_s = m_clock.now_s();
        if (m_wish == Wish::Arm && now_s - m_began_s > kReadyWithin_s && !m_last.reasons.empty())
            end(Error(m_last.reasons.front().code, {}, m_last.reasons.front().args));
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
        const bool settledLong = !m_options.duration_s && heldFor_s() >= kSettledFor_s;
        if (settledLong || sample.time_s >= limit_s)
            stop();
    }

    double heldFor_s() const { return m_sample.time_s - *std::ranges::max_element(m_withinSince_s); }

    void stop() {
        m_stopped_s = m_clock.now_s();
        later(Wish::End, Stop{});
    }

    void finish() {
        m_outcome.simulated_s = m_sample.time_s;
        m_outcome.settled = !m_outcome.fault && heldFor_s() >= std::min(kHeldFor_s, m_sample.time_s);
        for (std::size_t i = 0; i < m_sample.objects.size(); ++i)
            m_outcome.objects.push_back(
                {m_experiment.objects[i].name, m_sample.objects[i].target_K, m_sample.objects[i].estimated_K,
                 std::isfinite(m_withinSince_s[i]) ? std::optional(m_withinSince_s[i]) : std::nullopt});
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
    SteadyClock m_clock;
    EngineWorker m_worker;
    Wish m_wish = Wish::Arm;
    bool m_isPosting = false, m_isResetting = false, m_isOver = false, m_isEmergency = false;
    double m_began_s = SteadyClock().now_s();
    double m_reset_s = -HUGE_VAL, m_stopped_s = 0.0;
    std::optional<double> m_armed_s;
    std::vector<double> m_withinSince_s; ///< infinite: outside of the band
    TraceSample m_sample;
    Snapshot m_last;
    RunOutcome m_outcome;
    std::optional<Error> m_error;
};

} // namespace

Result<RunOutcome> runLive(const Experiment& experiment, const SimulatedRunOptions& options) {
    if (!experiment.rig)
        return Error(MessageCode::RigMissing, {});
    return LiveRun(experiment, options).run();
}

} // namespace bask
