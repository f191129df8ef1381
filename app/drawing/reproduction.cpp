#include "app/drawing/reproduction.h"

#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/base/units.h"
#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bask {
namespace {

RunEnding endingOf(const ReproducedRun& run) {
    if (run.outcome.fault)
        return RunEnding::Fault;
    if (run.outcome.settled)
        return RunEnding::Settled;
    return run.compromise.empty() ? RunEnding::NotSettled : RunEnding::Compromise;
}

Result<ReproducedRun> runOnce(Experiment experiment, std::size_t by) {
    if (by == kByTheLevelServo)
        experiment.controller.kind = ControllerKind::LevelServo;
    ReproducedRun run;
    run.controller = experiment.controller.kind;
    SimulatedRunOptions options;
    // To the end: what has settled may leave again.
    options.duration_s = experiment.simulation.durationLimit_s;
    options.progress = [&](double, const TraceSample& sample) { run.samples.push_back(sample); };
    const auto start = std::chrono::steady_clock::now();
    auto outcome = runSimulated(experiment, options);
    if (!outcome)
        return outcome.error();
    run.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.outcome = std::move(*outcome);
    for (const TraceEvent& event : run.outcome.events)
        if (event.message.code == MessageCode::EventCompromise)
            run.compromise = event.message.args.front().text();
    if (run.outcome.settled) {
        run.settling_s = 0.0;
        for (const ObjectOutcome& object : run.outcome.objects)
            run.settling_s = std::max(*run.settling_s, object.settlingTime_s.value_or(0.0));
    }
    run.ending = endingOf(run);
    return run;
}

/// Whole experiments take turns with runs as jobs: the level servo's runs, which are the longest, first.
struct Jobs {
    const std::vector<PaperExperiment>& experiments;
    std::vector<ReproducedExperiment> results;
    std::vector<std::optional<Error>> errors; // one a job

    explicit Jobs(const std::vector<PaperExperiment>& all)
        : experiments(all), results(all.size()), errors(2 * all.size()) {}

    int count() const { return static_cast<int>(errors.size()); }
    void run(std::size_t job) {
        const std::size_t by = job < experiments.size() ? kByTheLevelServo : kByThePaper;
        const std::size_t index = job % experiments.size();
        const Experiment& experiment = experiments[index].experiment;
        ReproducedExperiment& result = results[index];
        if (by == kByThePaper) { // the other job writes nothing but its own run
            result.paper = experiments[index];
            result.bound = settlingBound(experiment);
            result.feasibility = jointVerdict(experiment);
        }
        auto outcome = runOnce(experiment, by);
        if (outcome)
            result.runs[by] = std::move(*outcome);
        else
            errors[job] = outcome.error();
    }
};

std::string number(double value) {
    return formatNumber(value, 7);
}

std::string signedNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%+.2f", value);
    return text;
}

/// "settled after 404 s", "not settled, at the end +1.20, -0.30 K".
std::string endedWords(const ReproducedRun& run) {
    if (run.settling_s)
        return "settled after " + formatNumber(std::round(*run.settling_s), 6) + " s";
    std::string words = runEndingName(run.ending);
    if (!run.compromise.empty())
        words += " (expected by the controller: " + run.compromise + ")";
    return words + ", at the end " + finalErrorWords(run) + " K";
}

/// Where three objects end: the paper finds the one with the higher target closer to the source's centre.
std::string placeWords(const ReproducedExperiment& experiment, const ReproducedRun& run) {
    const Experiment& rig = experiment.paper.experiment;
    if (rig.objects.size() < 3)
        return "";
    std::string words;
    std::vector<double> distances_m;
    for (std::size_t i = 0; i < rig.objects.size(); ++i) {
        distances_m.push_back(objectCentre_m(rig, run.samples.back(), i).head<2>().norm());
        char text[32];
        std::snprintf(text, sizeof text, " %.1f", 100.0 * distances_m.back());
        words += (words.empty() ? "" : ", ") + rig.objects[i].name + text;
    }
    bool differ = false, closer = true;
    for (std::size_t i = 0; i < rig.objects.size(); ++i)
        for (std::size_t j = 0; j < rig.objects.size(); ++j)
            if (rig.objects[i].target_K > rig.objects[j].target_K + kSettledBand_K) {
                differ = true;
                closer = closer && distances_m[i] < distances_m[j];
            }
    words = " At the end the centres are beside the source's axis by (cm): " + words;
    if (!differ)
        return words + ".";
    return words + (closer ? "; as in the paper, a higher target is closer."
                           : "; not as in the paper, where a higher target is closer.");
}

std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

std::string csvHeader(const Experiment& experiment) {
    std::string text = "time_s,source_degC,x_cm,y_cm,z_cm,theta_x_deg,theta_y_deg,theta_z_deg,limited";
    for (const ObjectSpec& object : experiment.objects)
        for (const char* column : {" true_degC", " measured_degC", " target_degC", " view_factor",
                                   " believed_lambda1_K_s", " believed_lambda2_1_K3s"})
            text += ',' + quoted(object.name + column);
    return text + '\n';
}

void addCsvRow(std::string& text, const TraceSample& sample) {
    const auto add = [&](double value) { text += ',' + (std::isnan(value) ? std::string() : number(value)); };
    text += number(sample.time_s);
    add(celsiusFromKelvin(sample.source_K));
    for (int k = 0; k < 6; ++k)
        add(k < 3 ? 100.0 * sample.coordinates[k] : degFromRad(sample.coordinates[k]));
    text += sample.limits.any() ? ",1" : ",0";
    for (const ObjectSample& object : sample.objects) {
        add(celsiusFromKelvin(object.true_K));
        add(celsiusFromKelvin(object.measured_K));
        add(celsiusFromKelvin(object.target_K));
        add(object.viewFactor);
        add(object.lambda1);
        add(object.lambda2);
    }
    text += '\n';
}

} // namespace

Result<std::vector<ReproducedExperiment>> reproduce(const std::vector<PaperExperiment>& experiments,
                                                    int threads,
                                                    const std::function<void(int done, int all)>& progress) {
    Jobs jobs(experiments);
    runInParallel(
        jobs.count(), threads, [&](int job) { jobs.run(static_cast<std::size_t>(job)); },
        [&](int done) { progress(done, jobs.count()); });
    for (const auto& error : jobs.errors)
        if (error)
            return *error;
    return std::move(jobs.results);
}

Eigen::Vector3d objectCentre_m(const Experiment& experiment, const TraceSample& sample, std::size_t object) {
    const Pose X_SE = poseFromCoordinates(sample.source).inverse() * poseFromCoordinates(sample.coordinates);
    return (X_SE * poseFromCoordinates(experiment.objects[object].mounting)).translation();
}

bool ReproducedExperiment::asExpected(std::size_t by) const {
    double largest_K = 0.0;
    for (const ObjectOutcome& object : runs[by].outcome.objects)
        largest_K = std::max(largest_K, std::abs(object.final_K - object.target_K));
    return paper.expected[by].holds(runs[by].ending, largest_K);
}

std::string targetWords(const Experiment& experiment) {
    std::string words;
    for (const ObjectSpec& object : experiment.objects)
        words += (words.empty() ? "" : ", ") + formatNumber(celsiusFromKelvin(object.target_K), 4);
    return words;
}

std::string finalErrorWords(const ReproducedRun& run) {
    std::string words;
    for (const ObjectOutcome& object : run.outcome.objects)
        words += (words.empty() ? "" : ", ") + signedNumber(object.final_K - object.target_K);
    return words;
}

std::string verdictWords(const ReproducedExperiment& experiment, std::size_t by) {
    const ReproducedRun& run = experiment.runs[by];
    const ExpectedEnding& expected = experiment.paper.expected[by];
    std::string words;
    if (by == kByThePaper) {
        const bool agrees =
            (run.ending == RunEnding::Settled) == (experiment.paper.paper.ending == RunEnding::Settled);
        words = agrees ? "Agrees with the paper" : "Differs from the paper";
        words += " (there: " + experiment.paper.paper.reason + "): ";
    }
    words += endedWords(run) + ". ";
    if (experiment.asExpected(by))
        return words + expected.reason + placeWords(experiment, run);
    return words + "Not as recorded, which is \u201c" + expected.name() + "\u201d: " + expected.reason;
}

std::string reproductionCsv(const ReproducedExperiment& experiment, std::size_t by, const std::string& mark) {
    const ReproducedRun& run = experiment.runs[by];
    std::string text = "# " + mark + ": " + experiment.paper.name + " by the controller " +
                       run.controller.key() + ", " + endedWords(run) + "\n" +
                       csvHeader(experiment.paper.experiment);
    for (const TraceSample& sample : run.samples)
        addCsvRow(text, sample);
    return text;
}

} // namespace bask
