#include "engine/runtime/simulated_run.h"

#include "engine/base/message_code.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_drive.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bask {
namespace {

constexpr int kFillingWindows = 4;

/// Tracks since when each object's true temperature has been within the band.
class SettlingWatch {
public:
    explicit SettlingWatch(std::size_t objects) : m_since_s(objects) {}

    void add(const TraceSample& sample) {
        for (std::size_t i = 0; i < m_since_s.size(); ++i) {
            const ObjectSample& object = sample.objects[i];
            if (!(std::abs(object.true_K - object.target_K) <= kSettledBand_K)) // also for NaN
                m_since_s[i].reset();
            else if (!m_since_s[i])
                m_since_s[i] = sample.time_s;
        }
    }
    std::optional<double> since_s(std::size_t i) const { return m_since_s[i]; }
    bool allFor(double duration_s, double now_s) const {
        return std::ranges::all_of(m_since_s,
                                   [&](const auto& since) { return since && now_s - *since >= duration_s; });
    }

private:
    std::vector<std::optional<double>> m_since_s;
};

/// Keeps every sample until there are too many of them, then every second one and so on, and always the last.
class ThinnedSamples {
public:
    void add(const TraceSample& sample) {
        PredictedSample next{sample.time_s, sample.coordinates, {}};
        next.temperatures_K.reserve(sample.objects.size());
        for (const ObjectSample& object : sample.objects)
            next.temperatures_K.push_back(object.true_K);
        if (m_count++ % m_stride != 0) {
            m_last = std::move(next);
            return;
        }
        m_last.reset();
        m_kept.push_back(std::move(next));
        if (m_kept.size() < PredictedRun::kMaxSamples)
            return;
        for (std::size_t i = 1; 2 * i < m_kept.size(); ++i)
            m_kept[i] = std::move(m_kept[2 * i]);
        m_last = std::move(m_kept.back()); // an odd one, since their maximum is even
        m_kept.resize(m_kept.size() / 2);
        m_stride *= 2;
    }
    std::vector<PredictedSample> take() {
        if (m_last)
            m_kept.push_back(std::move(*m_last));
        return std::move(m_kept);
    }

private:
    std::vector<PredictedSample> m_kept;
    std::optional<PredictedSample> m_last; ///< the newest, if it was not kept
    std::size_t m_count = 0, m_stride = 1;
};
static_assert(PredictedRun::kMaxSamples % 2 == 0);

/// The experiment as far as it is known before a run: what only the simulated rig knows is as it is assumed,
/// so that a run which differs by that is seen to.
Experiment asPredicted(const Experiment& experiment) {
    Experiment seen = experiment;
    for (ObjectSpec& object : seen.objects)
        object.simulatedMaterial.reset();
    SimulationSpec& rig = seen.simulation;
    rig.faults.clear();
    rig.naturalConvection = experiment.air.isNatural;
    rig.convection_W_m2K = experiment.air.convection_W_m2K.value_or(0.0); // not counted where not known
    rig.sourceEmittance.reset();
    rig.sourcePose.reset();
    rig.sourceUneven.reset();
    rig.sourceMotion = {};
    if (rig.thermalCamera) {
        rig.thermalCamera->gain = rig.thermalCamera->offset_K = 0.0;
        rig.thermalCamera->calibration = {};
    }
    seen.vision = {}; // a followed source uses its true pose, since pictures take ten times as long
    return seen;
}

} // namespace

Result<RunOutcome> runSimulated(const Experiment& experiment, const SimulatedRunOptions& options) {
    if (const auto valid = validate(experiment); !valid)
        return valid.error();
    SimulatedDrive drive(experiment);
    ServoLoop& loop = drive.loop();
    loop.setRecordEnd(RecordEnd::ObjectsCold);
    if (options.from)
        drive.use(*options.from);
    const int patience = kFillingWindows * experiment.sampling.window; // readings may be missing
    const auto isStopped = [&options] { return options.stop.stop_requested(); };
    for (int i = 0; i < patience && loop.state() != RunState::Ready && !isStopped(); ++i)
        drive.period();
    if (isStopped() && loop.state() != RunState::Ready)
        return RunOutcome();
    const auto isFinite = [](double t_K) { return std::isfinite(t_K); };
    // Warm objects were zeroed before they were warm; some that are a little warm could be zeroed, wrongly.
    if (options.from && std::ranges::any_of(options.from->objects_K, isFinite))
        loop.useZeroing({0.0, experiment.environment_K, std::vector<double>(experiment.objects.size())});
    loop.setOperator(options.labels.operatorName);
    if (const auto armed = loop.arm(); !armed)
        return armed.error();
    std::unique_ptr<SessionWriter> writer;
    if (!options.sessionPath.empty()) {
        using Earlier = SessionWriter::Earlier;
        auto created =
            SessionWriter::create(options.sessionPath, experiment, true, 0.5,
                                  options.mayReplace ? Earlier::Replaced : Earlier::Kept, options.labels);
        if (!created)
            return created.error();
        writer = std::move(*created);
    }
    if (const auto started = loop.start(true); !started)
        return started.error();

    RunOutcome outcome;
    SettlingWatch watch(experiment.objects.size());
    const double limit_s = options.duration_s.value_or(experiment.simulation.durationLimit_s);
    const double end_s = limit_s - 0.5 * experiment.sampling.period_s;
    TraceSample last;
    const auto keep = [&](LoopRecord& rows) -> Result<void> {
        if (writer)
            if (const auto written = write(rows, *writer); !written)
                return written;
        std::ranges::move(rows.events, std::back_inserter(outcome.events));
        return {};
    };
    while (true) {
        LoopRecord rows = loop.takeRecord();
        if (const auto kept = keep(rows); !kept)
            return kept.error();
        for (const TraceSample& sample : rows.samples) {
            watch.add(sample);
            last = sample;
            if (options.progress)
                options.progress(sample.time_s, sample);
        }
        const bool settledLongEnough = !options.duration_s && watch.allFor(kSettledFor_s, last.time_s);
        const bool over = loop.state() == RunState::Fault || loop.state() == RunState::Stopped ||
                          options.stop.stop_requested();
        if (over || last.time_s >= end_s || settledLongEnough)
            break;
        drive.period();
    }

    outcome.fault = loop.state() == RunState::Fault;
    outcome.isStopped = loop.state() == RunState::Stopped;
    // The record of a fault continues until the objects are cold.
    const double recordEnds_s = loop.runTime_s() + kFaultRecord_s;
    while (writer && loop.isCooling() && !options.stop.stop_requested() && loop.runTime_s() < recordEnds_s) {
        drive.period();
        LoopRecord rows = loop.takeRecord();
        if (const auto kept = keep(rows); !kept)
            return kept.error();
    }
    outcome.simulated_s = last.time_s;
    outcome.settled = loop.state() == RunState::Running || loop.state() == RunState::Settled;
    const double inBandFor_s = std::min(kInBandFor_s, last.time_s);
    for (std::size_t i = 0; i < last.objects.size(); ++i) {
        const ObjectSample& object = last.objects[i];
        outcome.objects.push_back(
            {experiment.objects[i].name, object.target_K, object.true_K, watch.since_s(i)});
        outcome.settled =
            outcome.settled && watch.since_s(i) && last.time_s - *watch.since_s(i) >= inBandFor_s;
    }
    if (writer) {
        const char* words = outcome.fault                   ? "fault"
                            : outcome.settled               ? "settled"
                            : options.stop.stop_requested() ? "stopped"
                                                            : "not-settled";
        if (const auto finished = writer->finish(words); !finished)
            return finished.error();
    }
    return outcome;
}

Result<PredictedRun> predictedRun(const Experiment& experiment, const std::optional<RigCondition>& from,
                                  std::stop_token stop, const std::function<void(double time_s)>& progress) {
    ThinnedSamples samples;
    SimulatedRunOptions options;
    options.stop = std::move(stop);
    options.from = from;
    options.progress = [&](double time_s, const TraceSample& sample) {
        samples.add(sample);
        if (progress)
            progress(time_s);
    };
    Experiment seen = asPredicted(experiment);
    if (from)
        seen.simulation.sensorOffset_K = 0.0; // what zeroing takes off
    const auto outcome = runSimulated(seen, options);
    if (!outcome)
        return outcome.error();
    PredictedRun predicted{samples.take(), std::nullopt, PredictedEnd::Settled};
    if (options.stop.stop_requested())
        predicted.end = PredictedEnd::Cut;
    else if (outcome->fault || outcome->isStopped)
        predicted.end = PredictedEnd::Fault;
    else if (!outcome->settled)
        predicted.end = PredictedEnd::Limit;
    if (predicted.end != PredictedEnd::Settled)
        return predicted;
    double settling_s = 0.0;
    for (const ObjectOutcome& object : outcome->objects)
        settling_s = std::max(settling_s, object.settlingTime_s.value_or(0.0));
    predicted.settling_s = settling_s;
    return predicted;
}

Result<void> addSpread(PredictedRun& run, const Experiment& experiment,
                       const std::optional<RigCondition>& from, int draws, std::stop_token stop,
                       const std::function<void(double time_s)>& progress) {
    Experiment drawn = experiment;
    const std::vector<HeatRates> estimates = estimatedRates(experiment, experiment.environment_K);
    for (std::size_t i = 0; i < drawn.objects.size(); ++i) // the seed says how wrong they are
        drawn.objects[i].estimatedRates = estimates[i];
    std::vector<PredictedSample> wide = run.samples;
    for (PredictedSample& sample : wide)
        sample.lowest_K = sample.highest_K = sample.temperatures_K;
    for (int draw = 1; draw <= draws; ++draw) {
        drawn.simulation.seed = experiment.simulation.seed + static_cast<std::uint64_t>(draw);
        const auto other = predictedRun(drawn, from, stop, progress);
        if (!other)
            return other.error();
        if (stop.stop_requested() || other->samples.empty())
            return {};
        if (other->end == PredictedEnd::Fault)
            continue;
        auto there = other->samples.begin();
        for (PredictedSample& sample : wide) {
            while (std::next(there) != other->samples.end() && std::next(there)->time_s <= sample.time_s)
                ++there;
            for (std::size_t i = 0; i < sample.temperatures_K.size(); ++i) {
                sample.lowest_K[i] = std::min(sample.lowest_K[i], there->temperatures_K[i]);
                sample.highest_K[i] = std::max(sample.highest_K[i], there->temperatures_K[i]);
            }
        }
    }
    run.samples = std::move(wide);
    return {};
}

Result<std::optional<double>> predictedSettling_s(const Experiment& experiment, std::stop_token stop,
                                                  const std::function<void(double time_s)>& progress) {
    const auto predicted = predictedRun(experiment, std::nullopt, std::move(stop), progress);
    return predicted ? Result<std::optional<double>>(predicted->settling_s) : predicted.error();
}

} // namespace bask
