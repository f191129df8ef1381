#include "engine/recipe/simulated_recipe.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/alarm_log.h"
#include "engine/runtime/simulated_drive.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace bask {
namespace {

/// What EngineWorker is in real time, for the commands of a recipe.
class SimulatedEngine {
public:
    explicit SimulatedEngine(RunLabels labels) : m_labels(std::move(labels)) {}

    void post(const Command& command) {
        const Result<void> done = apply(command);
        if (!done && m_snapshot.refusal.code == MessageCode::None)
            m_snapshot.refusal = done.error().message;
        record();
    }

    void period() {
        m_drive->period();
        record();
        if (!m_drive->loop().running() && m_drive->loop().state() != RunState::Armed)
            close();
    }

    const Snapshot& snapshot() {
        if (!m_drive)
            return m_snapshot;
        const ServoLoop& loop = m_drive->loop();
        m_alarms.update(utcNow_s(), loop.alarmConditions());
        m_snapshot.alarms = m_alarms.alarms();
        m_snapshot.state = loop.state();
        m_snapshot.reasons = loop.reasons();
        m_snapshot.runTime_s = loop.runTime_s();
        m_snapshot.clock_s = m_drive->clock().now_s();
        m_snapshot.latest = loop.latest();
        m_snapshot.heat = loop.heat().state();
        m_snapshot.heatOn = loop.heat().isOn();
        return m_snapshot;
    }

    void forget() {
        m_snapshot.newSamples.clear();
        m_snapshot.newEvents.clear();
        m_snapshot.refusal = {};
    }

private:
    Result<void> apply(const Command& command) {
        if (const auto* load = std::get_if<LoadExperiment>(&command)) {
            close();
            m_drive = std::make_unique<SimulatedDrive>(load->experiment);
            m_drive->loop().setOperator(m_labels.operatorName);
            ++m_snapshot.loadId;
            return {};
        }
        ServoLoop& loop = m_drive->loop();
        if (const auto* arm = std::get_if<Arm>(&command))
            return armWith(*arm);
        if (const auto* start = std::get_if<Start>(&command)) {
            if (!start->acceptInfeasible && !jointVerdict(loop.experiment()).feasible)
                return Error(MessageCode::ReasonTargetInfeasible, {});
            return loop.start(start->acceptInfeasible);
        }
        if (std::holds_alternative<Stop>(command))
            return loop.stop();
        if (std::holds_alternative<Reset>(command))
            return loop.reset();
        throw std::logic_error("SimulatedEngine: no command of a recipe");
    }

    Result<void> armWith(const Arm& arm) {
        using Earlier = SessionWriter::Earlier;
        if (const auto armed = m_drive->loop().arm(); !armed || arm.recordingPath.empty())
            return armed;
        auto writer = SessionWriter::create(arm.recordingPath, m_drive->loop().experiment(), true, 0.5,
                                            arm.mayReplace ? Earlier::Replaced : Earlier::Kept, m_labels);
        if (!writer) {
            (void)m_drive->loop().disarm();
            return writer.error();
        }
        m_writer = std::move(*writer);
        return {};
    }

    void record() {
        LoopRecord rows = m_drive->loop().takeRecord();
        if (m_writer)
            if (const auto written = write(rows, *m_writer); !written)
                recorderFailed(written.error());
        std::ranges::move(rows.samples, std::back_inserter(m_snapshot.newSamples));
        std::ranges::move(rows.events, std::back_inserter(m_snapshot.newEvents));
    }

    void close() {
        if (!m_writer)
            return;
        const std::string outcome = m_drive->loop().outcome();
        if (const auto finished = m_writer->finish(outcome.empty() ? "stopped" : outcome); !finished)
            recorderFailed(finished.error());
        m_writer.reset();
    }

    void recorderFailed(const Error& error) {
        m_writer.reset();
        m_drive->loop().stopFor({MessageCode::ReasonRecorderFailed, {describe(error)}});
    }

    RunLabels m_labels;
    std::unique_ptr<SimulatedDrive> m_drive;
    std::unique_ptr<SessionWriter> m_writer;
    AlarmLog m_alarms;
    Snapshot m_snapshot;
};

} // namespace

void runSimulated(RecipeRunner& runner, const RecipeWatch& watch, const std::stop_token& stop,
                  const RunLabels& labels) {
    SimulatedEngine engine(labels);
    const auto post = [&](const std::vector<Command>& commands) {
        for (const Command& command : commands)
            engine.post(command);
    };
    post(runner.begin(engine.snapshot()));
    while (!runner.isOver()) {
        if (stop.stop_requested())
            post(runner.stopNow());
        engine.period();
        const Snapshot snapshot = engine.snapshot();
        engine.forget();
        post(runner.take(snapshot));
        if (watch)
            watch(runner, snapshot);
    }
}

} // namespace bask
