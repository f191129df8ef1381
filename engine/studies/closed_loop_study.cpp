#include "engine/studies/closed_loop_study.h"

#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/base/units.h"
#include "engine/control/pose_lookup.h"
#include "engine/control/steady_states.h"
#include "engine/control/velocity_solve.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"
#include "engine/studies/study_random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace bask {
namespace {

constexpr int kReachPoses = 12000;    // sampled for the bound
constexpr double kBoundStep_s = 0.1;  // of its integration
constexpr double kMaxBound_s = 1.0e6; // targets are below the steady temperature at F = 1, so it ends

using Random = StudyRandom;

/// Centroids anywhere in a disk about E, turned anyhow, the circles about the outlines apart.
std::vector<Vector6d> drawMountings(Random& random, const std::vector<ObjectSpec>& objects,
                                    StudyMountings kind) {
    for (int attempt = 0; attempt < kMaxDraws; ++attempt) {
        std::vector<Vector6d> mountings;
        bool apart = true;
        for (std::size_t i = 0; i < objects.size(); ++i) {
            const double radius_m = kStudyMountingRadius_m * std::sqrt(uniform(random, 0.0, 1.0));
            const double angle = uniform(random, -std::numbers::pi, std::numbers::pi);
            Vector6d mounting = objects[i].mounting;
            mounting[kX] = radius_m * std::cos(angle);
            mounting[kY] = radius_m * std::sin(angle);
            mounting[kThetaZ] = uniform(random, -std::numbers::pi, std::numbers::pi);
            if (kind == StudyMountings::Heights) {
                mounting[kZ] = uniform(random, -kStudyHeight_m, kStudyHeight_m);
                mounting[kThetaX] = uniform(random, -kStudyTilt_rad, kStudyTilt_rad);
                mounting[kThetaY] = uniform(random, -kStudyTilt_rad, kStudyTilt_rad);
            }
            for (std::size_t j = 0; j < i; ++j)
                apart = apart && (mounting - mountings[j]).head<2>().norm() >
                                     shapeRadius(objects[i].shape) + shapeRadius(objects[j].shape);
            mountings.push_back(mounting);
        }
        if (apart)
            return mountings;
    }
    throw std::invalid_argument("closed-loop study: the objects do not fit beside each other");
}

void drawGoal(Random& random, const RigGeometry& geometry, const Experiment& rig, ClosedLoopCase& drawn) {
    const std::vector<HeatRates> rates = trueRates(rig);
    for (int attempt = 0; attempt < kMaxDraws; ++attempt) {
        drawn.goal = drawAllowedPose(random, geometry, rig.start);
        const Eigen::VectorXd F = geometry.viewFactors(drawn.goal).F;
        const Eigen::VectorXd steady_K = steadyTemperatures_K(rates, geometry.neighbours(), F);
        drawn.targets_K.assign(steady_K.begin(), steady_K.end());
        if (std::ranges::min(drawn.targets_K) >= rig.environment_K + kStudyRise_K)
            return;
    }
    throw std::invalid_argument("closed-loop study: no pose holds the objects warm enough");
}

/// A polygon as large as the piece of a ring between two radii and two angles.
Contour ringPiece(double inner_m, double outer_m, double from, double to) {
    constexpr int kChords = 12;
    const double half = 0.5 * (to - from) / kChords;
    const double larger = std::sqrt(half / (std::sin(half) * std::cos(half))); // chords cut off a little
    Contour piece;
    const auto arc = [&](double radius_m, double first, double last) {
        for (int k = 0; k <= kChords; ++k) {
            const double angle = std::lerp(first, last, static_cast<double>(k) / kChords);
            piece.points_m.push_back(larger * radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        }
    };
    arc(outer_m, from, to);
    arc(inner_m, to, from);
    return piece;
}

/// A disk in the middle and six pieces of a ring round it, of equal areas and turned anyhow, each hotter or
/// colder than the source by up to `share` of its temperature above the room.
Unevenness drawUnevenness(Random& random, const Shape& source, double share) {
    const auto* disk = std::get_if<Disk>(&source);
    if (disk == nullptr)
        throw std::invalid_argument("closed-loop study: only a disk can be uneven");
    constexpr int kPieces = 6;
    const double middle_m = disk->radius_m / std::sqrt(kPieces + 1.0);
    const double first = uniform(random, -std::numbers::pi, std::numbers::pi);
    Unevenness uneven;
    const auto add = [&](const Shape& shape) {
        SourcePartSpec& part = uneven.parts.emplace_back();
        part.shape = shape;
        part.temperatureRatio = 1.0 + uniform(random, -share, share);
    };
    add(Disk{middle_m});
    for (int k = 0; k < kPieces; ++k) {
        constexpr double kAngle = 2.0 * std::numbers::pi / kPieces;
        add(ringPiece(middle_m, disk->radius_m, first + k * kAngle, first + (k + 1) * kAngle));
    }
    return uneven;
}

/// Best view factors of one object over time: what any sampled pose within reach offers.
class Reach {
public:
    /// sign +1: the largest view factor, -1: the least; `ideal`: what no view factor passes
    Reach(const PoseLookup& lookup, const std::vector<double>& travel_s,
          const std::vector<std::size_t>& order, Eigen::Index object, double sign, double F_start,
          double ideal)
        : m_lookup(lookup), m_travel_s(travel_s), m_order(order), m_object(object), m_sign(sign),
          m_ideal(ideal), m_bestOfAll((sign * lookup.table().col(object)).maxCoeff()), m_best(F_start) {}

    /// Times must grow.
    double at(double time_s) {
        for (; m_next < m_order.size() && m_travel_s[m_order[m_next]] <= time_s; ++m_next) {
            const double F = m_lookup.table()(static_cast<Eigen::Index>(m_order[m_next]), m_object);
            if (m_sign * F > m_sign * m_best)
                m_best = F;
        }
        return m_sign * m_best >= m_bestOfAll ? m_ideal : m_best;
    }

private:
    const PoseLookup& m_lookup;
    const std::vector<double>& m_travel_s;
    const std::vector<std::size_t>& m_order;
    Eigen::Index m_object;
    double m_sign;
    double m_ideal;
    double m_bestOfAll; ///< times the sign
    double m_best;
    std::size_t m_next = 0;
};

/// Whether no view factor ever holds the object so near its target.
bool isOutOfReach(const Experiment& rig, std::size_t object, double edge_K, double ideal) {
    const bool heats = edge_K > rig.environment_K;
    double source_K = rig.source.temperatureProfile.empty() ? rig.source.temperature_K : 0.0;
    for (const TimePoint<double>& point : rig.source.temperatureProfile)
        source_K = std::max(source_K, point.value);
    const HeatRates rates = trueRates(rig.objects[object], trueSurroundings(rig, source_K));
    return heats ? rates.steadyTemperature_K(ideal) <= edge_K : rates.steadyTemperature_K(ideal) >= edge_K;
}

/// Time in which the plant's object comes within the settled band of its target under view factors F(t), of
/// which none passes `ideal`.
template <class ViewFactorAt>
double timeToBand_s(const Experiment& rig, std::size_t object, double target_K, double ideal,
                    ViewFactorAt&& viewFactorAt) {
    ThermalPlant plant({{trueMaterial(rig.objects[object]), rig.environment_K,
                         shapeCharacteristicLength(rig.objects[object].shape)}},
                       rig.source.model, rig.environment_K, trueAir(rig));
    const double sign = target_K > rig.environment_K ? 1.0 : -1.0;
    const double edge_K = target_K - sign * kSettledBand_K;
    if (sign * (edge_K - rig.environment_K) > 0.0 && isOutOfReach(rig, object, edge_K, ideal))
        return std::numeric_limits<double>::infinity();
    double before_K = plant.temperature_K(0);
    for (int step = 0; step * kBoundStep_s < kMaxBound_s; ++step) {
        if (sign * plant.temperature_K(0) >= sign * edge_K) {
            if (step == 0)
                return 0.0;
            const double part = (edge_K - before_K) / (plant.temperature_K(0) - before_K);
            return (step - 1 + part) * kBoundStep_s;
        }
        before_K = plant.temperature_K(0);
        const double time_s = step * kBoundStep_s;
        const double J = trueSurroundings(rig, sourceSetPoint_K(rig.source, time_s)).netSourcePower_W_m2;
        plant.advance(kBoundStep_s, {viewFactorAt(time_s)}, J);
    }
    return std::numeric_limits<double>::infinity();
}

/// "circle +1.2 K, hand -0.8 K": who is where at the end.
std::string objectsOutside(const RunOutcome& outcome) {
    std::string words;
    for (const ObjectOutcome& object : outcome.objects) {
        const double error_K = object.final_K - object.target_K;
        if (!object.settlingTime_s)
            words += (words.empty() ? "" : ", ") + object.name + (error_K > 0.0 ? " +" : " ") +
                     formatNumber(error_K, 2) + " K";
    }
    return words;
}

/// Why a run is no success.
std::string failureOf(const RunOutcome& outcome, double duration_s) {
    std::string words;
    for (const TraceEvent& event : outcome.events) // the last alarm is the one that ended the run
        if (outcome.fault && alarmPriority(event.message.code) > 0)
            words = "fault at " + formatNumber(event.time_s) + " s: " + describe(event.message);
    if (!outcome.fault && outcome.simulated_s < duration_s - 2.0)
        words = "the run ended by itself at " + formatNumber(outcome.simulated_s) + " s";
    const std::string outside = objectsOutside(outcome);
    if (words.empty())
        words = outside.empty() ? "within the band in the last moments only" : "not settled";
    if (!outside.empty())
        words += "; at the end " + outside;
    for (const TraceEvent& event : outcome.events)
        if (event.message.code == MessageCode::EventCompromise)
            return words + "; called the targets infeasible at " + formatNumber(event.time_s) + " s";
    return words;
}

/// The way of the end-effector in a run.
class PathWatch {
public:
    void add(const TraceSample& sample) {
        if (!m_time_s.empty()) {
            const double dt_s = sample.time_s - m_time_s.back();
            m_way_m.push_back(m_way_m.back() + (sample.coordinates - m_place).head<3>().norm());
            if (dt_s > 0.0)
                m_commandAcceleration_m_s2 =
                    std::max(m_commandAcceleration_m_s2, (sample.twist - m_twist).head<3>().norm() / dt_s);
        } else {
            m_way_m.push_back(0.0);
        }
        m_time_s.push_back(sample.time_s);
        m_place = sample.coordinates;
        m_twist = sample.twist;
    }

    double way_m() const { return m_way_m.empty() ? 0.0 : m_way_m.back(); }
    double commandAcceleration_m_s2() const { return m_commandAcceleration_m_s2; }
    /// Empty if the run has ended before.
    std::optional<double> meanSpeed_m_s(double from_s) const {
        const auto first = std::ranges::lower_bound(m_time_s, from_s);
        if (first == m_time_s.end() || *first >= m_time_s.back())
            return std::nullopt;
        const auto index = static_cast<std::size_t>(first - m_time_s.begin());
        return (m_way_m.back() - m_way_m[index]) / (m_time_s.back() - *first);
    }

private:
    std::vector<double> m_time_s, m_way_m;
    Vector6d m_place = Vector6d::Zero();
    Vector6d m_twist = Vector6d::Zero();
    double m_commandAcceleration_m_s2 = 0.0;
};

/// What is not drawn stays as the rig has it.
void setConditions(const ClosedLoopStudy& study, const ClosedLoopCase& drawn, SimulationSpec& simulation) {
    if (study.convection_W_m2K > 0.0)
        simulation.convection_W_m2K = drawn.convection_W_m2K;
    if (study.sensorLag_s > 0.0)
        simulation.sensorLag_s = drawn.sensorLag_s;
    if (study.robotLatency_s > 0.0)
        simulation.robotLatency_s = drawn.robotLatency_s;
    if (study.uneven > 0.0)
        simulation.sourceUneven = drawn.sourceUneven;
}

/// Value below which the fraction of the sorted values lies, between neighbours linearly.
std::optional<double> quantile(const std::vector<double>& sorted, double fraction) {
    if (sorted.empty())
        return std::nullopt;
    const double place = fraction * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

std::string number(double value) {
    return formatNumber(value, 9);
}

std::string quoted(std::string text) {
    for (auto at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2))
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

std::string coordinates(const Vector6d& q) {
    std::string text;
    for (int k = 0; k < 6; ++k)
        text += ',' + number(k < 3 ? 100.0 * q[k] : degFromRad(q[k]));
    return text;
}

std::string csvRow(int index, const ClosedLoopRow& row) {
    const ClosedLoopCase& drawn = row.drawn;
    const auto timed = [&](double divisor) {
        return ',' + (row.settling_s ? number(*row.settling_s / divisor) : std::string());
    };
    std::string text = std::to_string(index) + ',' + std::to_string(drawn.seed) + ',' +
                       (row.settling_s ? '1' : '0') + timed(1.0) + timed(drawn.bound_s) +
                       timed(drawn.radiation_s) + ',' + number(row.overshoot_K) + ',' +
                       number(drawn.bound_s) + ',' + number(drawn.radiation_s) + ',' + number(drawn.travel_s);
    for (std::size_t i = 0; i < drawn.targets_K.size(); ++i)
        text += ',' + number(celsiusFromKelvin(drawn.targets_K[i])) + ',' +
                number(celsiusFromKelvin(row.final_K[i])) + ',' + number(100.0 * drawn.mountings[i][kX]) +
                ',' + number(100.0 * drawn.mountings[i][kY]) + ',' +
                number(degFromRad(drawn.mountings[i][kThetaZ])) + ',' +
                number(100.0 * drawn.mountings[i][kZ]) + ',' +
                number(degFromRad(drawn.mountings[i][kThetaX])) + ',' +
                number(degFromRad(drawn.mountings[i][kThetaY]));
    text += coordinates(drawn.start) + coordinates(drawn.goal) + (row.toldCompromise ? ",1," : ",0,") +
            quoted(row.failure);
    return text + ',' + (row.restSpeed_m_s ? number(1000.0 * *row.restSpeed_m_s) : std::string()) + ',' +
           number(row.way_m) + ',' + number(1000.0 * row.commandAcceleration_m_s2) + ',' +
           number(drawn.convection_W_m2K) + ',' + number(drawn.sensorLag_s) + ',' +
           number(drawn.robotLatency_s);
}

} // namespace

SettlingBound settlingBound(const Experiment& experiment) {
    const auto geometry = trueRigGeometry(experiment);
    const PoseLookup lookup(geometry, experiment.start, kReachPoses);
    std::vector<double> travel_s(lookup.size());
    for (std::size_t k = 0; k < lookup.size(); ++k)
        travel_s[k] = travelTime_s(geometry->limits(), experiment.start, lookup.pose(k));
    std::vector<std::size_t> order(lookup.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::size_t k) { return travel_s[k]; });
    const Eigen::VectorXd F = geometry->viewFactors(experiment.start).F;
    SettlingBound bound;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const double target_K = experiment.objects[i].target_K;
        const double sign = target_K > experiment.environment_K ? 1.0 : -1.0;
        const auto row = static_cast<Eigen::Index>(i);
        const double ideal = sign > 0.0 ? geometry->maxViewFactor() : 0.0;
        Reach reach(lookup, travel_s, order, row, sign, F[row], ideal);
        bound.radiation_s = std::max(
            bound.radiation_s, timeToBand_s(experiment, i, target_K, ideal, [&](double) { return ideal; }));
        bound.bound_s = std::max(bound.bound_s, timeToBand_s(experiment, i, target_K, ideal,
                                                             [&](double t_s) { return reach.at(t_s); }));
    }
    return bound;
}

ClosedLoopCase drawClosedLoopCase(const ClosedLoopStudy& study, int index) {
    Random random = studyRandom(study.seed, index);
    ClosedLoopCase drawn;
    drawn.seed = random();
    Experiment rig = study.rig;
    Random conditions = studyRandom(~study.seed, index); // of their own: the other draws stay as they are
    drawn.convection_W_m2K = uniform(conditions, 0.0, study.convection_W_m2K);
    drawn.sensorLag_s = uniform(conditions, 0.0, study.sensorLag_s);
    drawn.robotLatency_s = uniform(conditions, 0.0, study.robotLatency_s);
    if (study.uneven > 0.0) {
        drawn.uneven = uniform(conditions, 0.0, study.uneven);
        drawn.sourceUneven = drawUnevenness(conditions, rig.source.shape, drawn.uneven);
    }
    setConditions(study, drawn, rig.simulation);
    if (study.mountings != StudyMountings::AsGiven) {
        drawn.mountings = drawMountings(random, rig.objects, study.mountings);
        for (std::size_t i = 0; i < rig.objects.size(); ++i)
            rig.objects[i].mounting = drawn.mountings[i];
    } else {
        for (const ObjectSpec& object : rig.objects)
            drawn.mountings.push_back(object.mounting);
    }
    const auto geometry = trueRigGeometry(rig);
    drawn.start = drawAllowedPose(random, *geometry, rig.start);
    drawGoal(random, *geometry, rig, drawn);
    const SettlingBound bound = settlingBound(closedLoopExperiment(study, drawn));
    drawn.radiation_s = bound.radiation_s;
    drawn.bound_s = bound.bound_s;
    drawn.travel_s = travelTime_s(geometry->limits(), drawn.start, drawn.goal);
    return drawn;
}

Experiment closedLoopExperiment(const ClosedLoopStudy& study, const ClosedLoopCase& drawn) {
    Experiment experiment = study.rig;
    experiment.start = drawn.start;
    experiment.simulation.seed = drawn.seed;
    setConditions(study, drawn, experiment.simulation);
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        experiment.objects[i].mounting = drawn.mountings[i];
        experiment.objects[i].target_K = drawn.targets_K[i];
    }
    return experiment;
}

Result<void> check(const ClosedLoopStudy& study) {
    auto valid = validate(study.rig);
    return valid ? checkMounting(study.rig) : valid;
}

Result<ClosedLoopRow> runClosedLoopCase(const ClosedLoopStudy& study, int index) {
    ClosedLoopRow row;
    row.drawn = drawClosedLoopCase(study, index);
    const Experiment experiment = closedLoopExperiment(study, row.drawn);
    SimulatedRunOptions options;
    options.duration_s = row.drawn.duration_s();
    PathWatch path;
    options.progress = [&](double, const TraceSample& sample) {
        path.add(sample);
        for (const ObjectSample& object : sample.objects) {
            const double sign = object.target_K > experiment.environment_K ? 1.0 : -1.0;
            row.overshoot_K = std::max(row.overshoot_K, sign * (object.true_K - object.target_K));
        }
    };
    const auto outcome = runSimulated(experiment, options);
    if (!outcome)
        return outcome.error();
    for (const ObjectOutcome& object : outcome->objects) {
        row.final_K.push_back(object.final_K);
        if (outcome->settled)
            row.settling_s = std::max(row.settling_s.value_or(0.0), object.settlingTime_s.value_or(0.0));
    }
    row.way_m = path.way_m();
    row.commandAcceleration_m_s2 = path.commandAcceleration_m_s2();
    if (row.settling_s)
        row.restSpeed_m_s = path.meanSpeed_m_s(*row.settling_s + kStudyRestAfter_s);
    row.toldCompromise = std::ranges::any_of(outcome->events, [](const TraceEvent& event) {
        return event.message.code == MessageCode::EventCompromise;
    });
    if (!outcome->settled)
        row.failure = failureOf(*outcome, row.drawn.duration_s());
    return row;
}

Result<std::vector<ClosedLoopRow>> runClosedLoopStudy(const ClosedLoopStudy& study, int threads,
                                                      const std::function<void(int done)>& progress) {
    if (const auto valid = check(study); !valid)
        return valid.error();
    std::vector<std::optional<Result<ClosedLoopRow>>> results(static_cast<std::size_t>(study.count));
    runInParallel(
        study.count, threads,
        [&](int index) { results[static_cast<std::size_t>(index)] = runClosedLoopCase(study, index); },
        progress);
    std::vector<ClosedLoopRow> rows;
    for (auto& result : results) {
        if (!*result)
            return result->error();
        rows.push_back(std::move(result->value()));
    }
    return rows;
}

ClosedLoopSummary summarize(const std::vector<ClosedLoopRow>& rows) {
    ClosedLoopSummary summary;
    std::vector<double> overBound, overRadiation, restSpeeds, ways;
    for (const ClosedLoopRow& row : rows) {
        summary.worstOvershoot_K = std::max(summary.worstOvershoot_K, row.overshoot_K);
        ways.push_back(row.way_m);
        if (row.restSpeed_m_s)
            restSpeeds.push_back(*row.restSpeed_m_s);
        if (!row.settling_s)
            continue;
        overBound.push_back(*row.settling_s / row.drawn.bound_s);
        overRadiation.push_back(*row.settling_s / row.drawn.radiation_s);
    }
    std::ranges::sort(overBound);
    std::ranges::sort(overRadiation);
    if (!rows.empty())
        summary.successRate = static_cast<double>(overBound.size()) / static_cast<double>(rows.size());
    summary.medianOverBound = quantile(overBound, 0.5);
    summary.tenthOverBound = quantile(overBound, 0.9);
    summary.medianOverRadiation = quantile(overRadiation, 0.5);
    std::ranges::sort(ways);
    summary.medianWay_m = quantile(ways, 0.5);
    if (!restSpeeds.empty()) {
        summary.meanRestSpeed_m_s = std::accumulate(restSpeeds.begin(), restSpeeds.end(), 0.0) /
                                    static_cast<double>(restSpeeds.size());
        summary.worstRestSpeed_m_s = std::ranges::max(restSpeeds);
    }
    return summary;
}

std::string closedLoopCsv(const ClosedLoopStudy& study, const std::vector<ClosedLoopRow>& rows) {
    static constexpr std::array<const char*, 3> kMountingWords{"as in the experiment", "random in one plane",
                                                               "random, with heights and tilts"};
    const Experiment& rig = study.rig;
    std::string text =
        "# Bask closed-loop study: random targets that a pose of the workspace holds, from random starts.\n"
        "# Controller " +
        std::string(rig.controller.kind.key()) + ", source model " +
        (rig.source.model == SourceModel::Gray ? "gray" : "paper") +
        ", believed rates wrong by random factors within " + number(rig.controller.estimatedRateErrorFactor) +
        ", mountings " + kMountingWords[static_cast<std::size_t>(study.mountings)] + ", convection to " +
        number(study.convection_W_m2K) + " W/(m2 K), sensor lag to " + number(study.sensorLag_s) +
        " s, robot latency to " + number(study.robotLatency_s) + " s" +
        (study.uneven > 0.0 ? ", source uneven to " + number(100.0 * study.uneven) + " %" : "") + ", seed " +
        std::to_string(study.seed) +
        ".\n"
        "# Settled: every true temperature within +-" +
        number(kSettledBand_K) + " K of its target until the end of the run, which lasts " +
        number(kStudyBounds) + " x bound_s + " + number(kStudyMinDuration_s) +
        " s; settling_s is the last object's.\n"
        "# radiation_s: until the slowest object is within the band at F = 1 from the first moment. bound_s: "
        "at the largest F of any pose within reach at full speed by then. travel_s: from start to goal.\n"
        "# overshoot_K: farthest true temperature above a target, of all objects and moments; goal: a pose "
        "that holds the targets.\n"
        "# rest_speed_mm_s: mean speed of the end-effector from " +
        number(kStudyRestAfter_s) +
        " s after settling_s to the end. way_m: its whole way. command_acceleration_mm_s2: largest change of "
        "the commanded velocity between two samples, per time.\n"
        "run,seed,settled,settling_s,over_bound,over_radiation,overshoot_K,bound_s,radiation_s,travel_s";
    for (const ObjectSpec& object : rig.objects)
        text += ',' + quoted(object.name + " target_degC") + ',' + quoted(object.name + " final_degC") + ',' +
                quoted(object.name + " x_cm") + ',' + quoted(object.name + " y_cm") + ',' +
                quoted(object.name + " theta_z_deg") + ',' + quoted(object.name + " z_cm") + ',' +
                quoted(object.name + " theta_x_deg") + ',' + quoted(object.name + " theta_y_deg");
    for (const char* pose : {"start", "goal"})
        for (const char* coordinate : {"x_cm", "y_cm", "z_cm", "theta_x_deg", "theta_y_deg", "theta_z_deg"})
            text += std::string(",") + pose + "_" + coordinate;
    text += ",told_compromise,failure,rest_speed_mm_s,way_m,command_acceleration_mm_s2,convection_W_m2K,"
            "sensor_lag_s,robot_latency_s";
    text += study.uneven > 0.0 ? ",uneven_percent\n" : "\n";
    for (std::size_t k = 0; k < rows.size(); ++k)
        text += csvRow(static_cast<int>(k) + 1, rows[k]) +
                (study.uneven > 0.0 ? ',' + number(100.0 * rows[k].drawn.uneven) : "") + '\n';
    return text;
}

} // namespace bask
