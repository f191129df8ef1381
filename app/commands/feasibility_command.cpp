// bask feasibility: whether all targets of an experiment can be held together: the pose and its margin, or
// why not and what is nearest.

#include "app/commands/command_line.h"
#include "app/commands/experiment_arguments.h"
#include "app/commands/output_file.h"
#include "app/commands/output_folder.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/base/whole_file.h"
#include "engine/exchange/reachable_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/mounting_check.h"
#include "engine/model/uneven_source.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"

#include <nlohmann/json.hpp>

#include <QCommandLineParser>

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

/// What the experiment's controller does on the simulated rig.
struct Prediction {
    std::optional<double> settled_s; ///< empty: it does not settle within its time
};

/// Everything asked for on the command line, checked.
struct FeasibilityArguments {
    Experiment experiment;
    std::vector<bool> fixed;
    std::string summaryPath; ///< empty: none
};

Result<std::vector<bool>> fixedObjects(const QStringList& names, const Experiment& experiment) {
    std::vector<bool> fixed(experiment.objects.size());
    std::string known;
    for (const ObjectSpec& object : experiment.objects)
        known += (known.empty() ? "" : ", ") + object.name;
    for (const QString& name : names) {
        const auto found = std::ranges::find(experiment.objects, name.toStdString(), &ObjectSpec::name);
        if (found == experiment.objects.end())
            return Error(MessageCode::ValueUnknown, "--hold", {name.toStdString(), known});
        fixed[static_cast<std::size_t>(found - experiment.objects.begin())] = true;
    }
    return fixed;
}

Result<FeasibilityArguments> readFeasibilityArguments(const QCommandLineParser& parser) {
    const std::string path = parser.positionalArguments().first().toStdString();
    auto experiment = readExperiment(path);
    if (!experiment)
        return experiment.error();
    FeasibilityArguments request{std::move(*experiment), {}, parser.value("summary").toStdString()};
    if (const auto model = replaceSourceModel(parser, request.experiment); !model)
        return model.error();
    if (const auto targets = replaceTargets(parser, request.experiment); !targets)
        return targets.error();
    if (const auto valid = validate(request.experiment); !valid)
        return valid.error();
    if (const auto mounting = checkMounting(request.experiment); !mounting)
        return mounting.error();
    const auto fixed = fixedObjects(parser.values("hold"), request.experiment);
    if (!fixed)
        return fixed.error();
    request.fixed = *fixed;
    std::vector<OutputFile> outputs;
    if (parser.isSet("summary"))
        outputs.push_back({request.summaryPath, "feasible", "a feasibility summary written by Bask"});
    if (const auto place = checkOutputs(inputsOf(path, request.experiment), outputs); !place)
        return place.error();
    return request;
}

std::string limitName(const PoseMargin& margin) {
    return margin.limit == Limit::Clearance
               ? "clearance"
               : std::string("workspace ") + kCoordinateNames[static_cast<std::size_t>(margin.coordinate)];
}

Json poseJson(const Vector6d& q) {
    Json pose;
    for (int c = 0; c < 6; ++c) {
        const std::string name = kCoordinateNames[static_cast<std::size_t>(c)];
        if (c < 3)
            pose[name + "_cm"] = q[c] * 100.0;
        else
            pose[name + "_deg"] = degFromRad(q[c]);
    }
    return pose;
}

Json celsiusJson(const std::vector<double>& values_K) {
    Json list = Json::array();
    for (const double value_K : values_K)
        list.push_back(celsiusFromKelvin(value_K));
    return list;
}

Json condition1Json(const Experiment& experiment, const std::vector<TargetVerdict>& verdicts) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const TargetVerdict& v = verdicts[i];
        rows.push_back({{"object", experiment.objects[i].name},
                        {"holds", v.verdict == FeasibilityVerdict::Reachable},
                        {"target_C", celsiusFromKelvin(v.target_K)},
                        {"least_C", celsiusFromKelvin(v.reachableMin_K)},
                        {"largest_C", celsiusFromKelvin(v.reachableMax_K)},
                        {"needed_F", v.neededViewFactor},
                        {"least_F", v.reachableMin_F},
                        {"largest_F", v.reachableMax_F}});
    }
    return rows;
}

Json condition2Json(const Experiment& experiment, const std::vector<PairVerdict>& verdicts) {
    Json rows = Json::array();
    for (const PairVerdict& v : verdicts)
        rows.push_back(
            {{"objects", Json::array({experiment.objects[static_cast<std::size_t>(v.first)].name,
                                      experiment.objects[static_cast<std::size_t>(v.second)].name})},
             {"holds", v.holds},
             {"wanted_K", v.wanted_K},
             {"least_K", v.min_K},
             {"largest_K", v.largest_K}});
    return rows;
}

Json shadeJson(const Experiment& experiment, const Vector6d& pose) {
    Json rows = Json::array();
    const std::vector<std::string> takers = takerNames(experiment);
    for (const TakenLight& taken : rigGeometry(experiment)->takenLight(pose))
        rows.push_back({{"object", experiment.objects[taken.object].name},
                        {"taken_by", takers[taken.taker]},
                        {"share", taken.share}});
    return rows;
}

std::string summaryJson(const Experiment& experiment, const JointVerdict& verdict,
                        const std::optional<Prediction>& prediction) {
    Json summary;
    summary["feasible"] = verdict.feasible;
    summary["reason"] = describe(verdict.reason);
    summary["remarks"] = Json::array();
    for (const MountingRemark& remark : overlapsInPlane(experiment))
        summary["remarks"].push_back(describe(remark.message));
    summary["caveat"] = describe(verdict.caveat);
    summary["shade_at_start"] = shadeJson(experiment, experiment.start);
    summary["pose"] = nullptr;
    summary["margin"] = nullptr;
    summary["shade_at_pose"] = Json::array();
    if (verdict.anyPose) {
        summary["pose"] = poseJson(verdict.pose);
        summary["shade_at_pose"] = shadeJson(experiment, verdict.pose);
        summary["margin"] = {
            {"distance_cm", verdict.margin.distance_m * 100.0},
            {"limit", limitName(verdict.margin)},
            {"smallest_singular_value_K_cm", verdict.margin.smallestSingularValue_K_m / 100.0}};
    }
    summary["steady_C"] = celsiusJson(verdict.steady_K);
    summary["residual_K"] = verdict.residuals_K;
    summary["nearest_feasible_C"] = celsiusJson(verdict.nearest_K);
    summary["held_kept"] = verdict.fixedKept;
    summary["surface_gap_cm"] = verdict.surfaceGap_m ? Json(*verdict.surfaceGap_m * 100.0) : Json(nullptr);
    const bool settles = prediction && prediction->settled_s;
    summary["predicted_time_s"] = settles ? Json(*prediction->settled_s) : Json(nullptr);
    summary["condition1"] = condition1Json(experiment, verdict.conditions1);
    summary["condition2"] = condition2Json(experiment, verdict.conditions2);
    return summary.dump(2) + "\n";
}

void printPose(const JointVerdict& verdict) {
    std::printf("%s x %.2f, y %.2f, z %.2f cm; theta_x %.2f, theta_y %.2f, theta_z %.2f degrees\n",
                verdict.feasible ? "pose:" : "best compromise:", verdict.pose[kX] * 100.0,
                verdict.pose[kY] * 100.0, verdict.pose[kZ] * 100.0, degFromRad(verdict.pose[kThetaX]),
                degFromRad(verdict.pose[kThetaY]), degFromRad(verdict.pose[kThetaZ]));
    std::printf(
        "margin: %.2f cm to its nearest limit (%s; a degree counts as %.2f cm), least effect of a move "
        "%.3g K/cm\n",
        verdict.margin.distance_m * 100.0, limitName(verdict.margin).c_str(), radFromDeg(1.0) * 10.0,
        verdict.margin.smallestSingularValue_K_m / 100.0);
}

void printShade(const Experiment& experiment, const Vector6d& pose, ShadedPose which) {
    for (const MountingRemark& remark : shadeRemarks(experiment, pose, which))
        std::printf("shade: %s\n", describe(remark.message).c_str());
}

void printVerdict(const Experiment& experiment, const JointVerdict& verdict,
                  const std::optional<Prediction>& prediction) {
    if (!experiment.source.uneven.isEven())
        std::printf("source: %s\n", unevennessWords(experiment).c_str());
    std::printf("%-16s %10s %10s %10s %10s   %s\n", "object", "target_C", "steady_C", "nearest_C", "needed_F",
                "within the workspace");
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const TargetVerdict& v = verdict.conditions1[i];
        std::printf("%-16s %10.2f", experiment.objects[i].name.c_str(), celsiusFromKelvin(v.target_K));
        if (verdict.anyPose)
            std::printf(" %10.2f %10.2f %10.3f   F %.3f to %.3f, %.1f to %.1f degC",
                        celsiusFromKelvin(verdict.steady_K[i]), celsiusFromKelvin(verdict.nearest_K[i]),
                        v.neededViewFactor, v.reachableMin_F, v.reachableMax_F,
                        celsiusFromKelvin(v.reachableMin_K), celsiusFromKelvin(v.reachableMax_K));
        std::printf("\n");
    }
    for (const PairVerdict& v : verdict.conditions2)
        std::printf("%s - %s: %.2f K wanted, %.2f to %.2f K within the workspace\n",
                    experiment.objects[static_cast<std::size_t>(v.first)].name.c_str(),
                    experiment.objects[static_cast<std::size_t>(v.second)].name.c_str(), v.wanted_K, v.min_K,
                    v.largest_K);
    if (verdict.anyPose)
        printPose(verdict);
    printShade(experiment, experiment.start, ShadedPose::Start);
    if (verdict.anyPose)
        printShade(experiment, verdict.pose, ShadedPose::Here);
    if (verdict.feasible && prediction)
        std::printf("feasible; on the simulated rig the experiment's controller %s\n",
                    prediction->settled_s
                        ? ("settles after " + formatNumber(*prediction->settled_s) + " s").c_str()
                        : "does not settle within its time");
    else if (verdict.feasible)
        std::printf("feasible\n");
    else
        std::printf("not feasible: %s\n", describe(verdict.reason).c_str());
    if (verdict.caveat != Message{})
        std::printf("note: %s\n", describe(verdict.caveat).c_str());
    if (!verdict.fixedKept)
        std::printf("the held targets cannot be held together either\n");
}

/// reachable-1-2.csv and so on in the folder; nothing, and words on standard error, when that cannot be.
std::optional<std::vector<OutputFile>> mapFiles(const QString& folder, int objects) {
    QStringList names;
    for (int i = 0; i < objects; ++i)
        for (int j = i + 1; j < objects; ++j)
            names << QString::fromStdString(reachableFileStem(i, j) + ".csv");
    return filesIn(folder, "feasibility", kReachableMark, names);
}

/// Adds a file for each pair; none if no pose of the workspace is allowed.
void addMaps(const FeasibilityRequest& question, const std::vector<OutputFile>& places,
             std::vector<WholeFile>& files) {
    const std::vector<ReachableMap> maps = reachablePairs(question).value();
    for (std::size_t k = 0; k < maps.size(); ++k)
        files.push_back({places[k].path, reachableCsv(question.names, maps[k])});
}

} // namespace

int feasibilityCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Answers whether the robot's workspace has a pose with all targets as steady temperatures: that "
        "pose,\n"
        "its margin and the time that the experiment's controller takes on the simulated rig; or the reason\n"
        "why not, the best compromise and the nearest targets that can be held.\n"
        "Exit code: 0 feasible, 2 bad input or unwritable output, 3 not feasible.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("EXPERIMENT.json", "The experiment.");
    parser.addOptions(
        {{"targets", "Targets in degC, one an object: 50,40,40.", "LIST"},
         {"source-model", "gray or paper, instead of the experiment's.", "MODEL"},
         {"hold", "Keeps this object's target in the nearest ones; may be given more than once.", "NAME"},
         {"no-prediction", "Leave out the run on the simulated rig, which takes most of the time."},
         {"summary", "Write the answer as JSON.", "SUMMARY.json"},
         {"reachable", "Write a CSV for each pair of objects: which of their temperatures go together.",
          "DIR"}});
    if (const auto code = parseCommand(parser, "feasibility", arguments, 1, {"hold"}))
        return *code;
    const auto request = readFeasibilityArguments(parser);
    if (!request) {
        if (request.error().code() == MessageCode::MountingOverlap)
            std::printf("not feasible: %s\n", describe(request.error()).c_str());
        return refuse("feasibility", request.error());
    }
    std::vector<OutputFile> maps;
    if (parser.isSet("reachable")) {
        const auto files =
            mapFiles(parser.value("reachable"), static_cast<int>(request->experiment.objects.size()));
        if (!files)
            return kExitBadInput;
        maps = *files;
    }
    FeasibilityRequest question = feasibilityRequest(request->experiment);
    question.fixed = request->fixed;
    const JointVerdict verdict = jointFeasibility(question).value();
    std::optional<Prediction> prediction;
    if (verdict.feasible && !parser.isSet("no-prediction")) {
        Progress line(request->experiment.simulation.durationLimit_s, "s of the predicted run",
                      Progress::Total::AtMost);
        const auto predicted =
            predictedSettling_s(request->experiment, {}, [&](double time_s) { line.tell(time_s); });
        if (!predicted)
            return refuse("feasibility", predicted.error());
        prediction = Prediction{*predicted};
    }
    warnOfOverlaps("feasibility", request->experiment);
    for (const MountingRemark& remark : overlapsInPlane(request->experiment))
        std::printf("%s\n", describe(remark.message).c_str());
    printVerdict(request->experiment, verdict, prediction);
    std::vector<WholeFile> files; // the summary is not left without its maps
    if (!request->summaryPath.empty())
        files.push_back({request->summaryPath, summaryJson(request->experiment, verdict, prediction)});
    const std::size_t others = files.size();
    if (!maps.empty())
        addMaps(question, maps, files);
    if (const auto written = writeWholeFiles(files); !written)
        return refuse("feasibility", written.error());
    for (std::size_t k = others; k < files.size(); ++k)
        std::fprintf(stderr, "wrote %s\n", files[k].path.c_str());
    return verdict.feasible ? kExitDone : kExitNegative;
}

} // namespace bask
