#include "engine/control/level_servo.h"

#include "engine/control/steady_states.h"
#include "engine/control/travel_time.h"
#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kLargestGain_1_K = 1.0; ///< one kelvin of error demands at most the whole range of F
constexpr double kOff_K = 0.3;   ///< an object farther than this from its aim must still be moved there
constexpr int kRefinements = 12; ///< for a pose from the look-up
constexpr int kTouches = 3;      ///< for a pose that was right recently

constexpr double kRestPeriod_s = 5.0; ///< period of the search for poses that hold the targets
constexpr int kRestCandidates = 10;
constexpr int kRests = 3;             ///< number of them that are kept
constexpr double kRestsApart_s = 1.0; ///< minimum travel between two of them
constexpr double kRestMiss_K = 0.05;  ///< a rest this good stays where it is
constexpr double kRestTravelPrice_K2_s = 1e-3;
constexpr double kTrustInReading = 0.3; ///< the rest is the temperature predicted from the last ones
/// minimum time over which an object's drift is learnt, in its time constants
constexpr double kDriftShare = 1.0;

constexpr int kLevelPoses = 3;       ///< hot poses from which plans are proposed
constexpr int kFollowIterations = 4; ///< for the plan in use, at each step
constexpr int kSearchIterations = 6; ///< for a proposal
constexpr double kSearchPeriod_s = 2.0;
constexpr double kCalmSearchPeriod_s = 10.0; ///< while every object is within kCalm_K
constexpr double kCalm_K = 0.4;
constexpr double kWorthChanging = 0.95; ///< relative cost below which the plan in use is changed
constexpr double kBetter = 0.9;         ///< relative cost below which another plan replaces the present one
constexpr double kSurprise = 1.2;       ///< growth of the cost from one step to the next that starts a search
constexpr double kWorthGoing = 0.25;    ///< periods; a stay shorter than this is left out

constexpr double kComeToRest_K = 0.1;    ///< a rest whose steady temperatures miss the aim by less is held
constexpr double kLeaveRest_K = 0.15;    ///< and corrected if it misses the aim by more
constexpr double kAsGood_K = 0.03;       ///< where no pose misses less than that, by this more than the best
constexpr double kMissedFor_s = 15.0;    ///< for so long, so that noise corrects nothing
constexpr double kMovePrice_K2_m2 = 1.0; ///< of a correction: 10 cm count as a miss of 0.1 K
constexpr double kNear_K = 0.2;          ///< temperatures this near to the aim need no plan but the rest
constexpr double kPatience_K_s = 0.01;   ///< by so much farther ones after they could not be brought nearer
constexpr double kFarthestHold_K = 0.6;  ///< but not those farther than this
constexpr double kFarthestFull_K = 1.5;  ///< or this where there are as many objects as axes
constexpr double kStayNear_K = 0.45;     ///< on the way to a rest nearer ones stay this near
constexpr double kLoseHold_K = 0.3; ///< a rest is given up if a temperature is farther from its aim than this
constexpr double kUnforeseen_K = 0.1; ///< and by this farther than when it was taken
constexpr double kArrived_s = 0.01;   ///< travel left at a rest: what the robot resolves
constexpr int kWaySteps = 8;          ///< of the prediction on the way to a rest

constexpr double kSure_K = 0.3;  ///< identified rates with a smaller error are used for judging
constexpr double kUnmet_K = 0.4; ///< a compromise begins if the best pose misses a target by this
constexpr double kMet_K = 0.3;   ///< and ends below this

// The look-up gives starting points only: it may be this far behind a moving source.
constexpr double kTableShift_m = 0.01;
constexpr double kTableTurn_rad = 0.05;
constexpr double kTableWarmer = 0.2; // of an uneven source's temperature, K: a new table takes a second

/// Slope of the steady temperature by the view factor, K.
double temperaturePerViewFactor_K(const HeatRates& rates, double T_K) {
    return rates.lambda1 * rates.timeConstant_s(T_K);
}

/// The weight of an object in PoseQuery is relative to that of the heaviest: squared kelvin per view factor.
double heaviest_K2(const HeatingTask& task, const std::vector<double>& aim_K) {
    double out = 0.0;
    for (std::size_t k = 0; k < aim_K.size(); ++k)
        out = std::max(out, std::pow(temperaturePerViewFactor_K(task.rates[k], aim_K[k]), 2));
    return out;
}

/// A stay at a rest, for plans that have nothing else to do: long enough to be moved by an optimisation.
double restStay_s(const HeatingTask& task) {
    double out = 0.0;
    for (Eigen::Index i = 0; i < task.aim_K.size(); ++i)
        out = std::max(out, 0.1 * task.rates[static_cast<std::size_t>(i)].timeConstant_s(task.aim_K[i]));
    return out;
}

} // namespace

LevelServo::LevelServo(const ControllerSettings& settings, ControlModel model)
    : m_settings(settings), m_model(std::move(model)) {
    for (const HeatRates& rates : m_model.estimated)
        m_identification.emplace_back(rates);
    m_aim_K = m_model.targets_K;
    m_drift_K_s = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_model.estimated.size()));
}

void LevelServo::setTargets(const std::vector<double>& targets_K) {
    m_model.targets_K = targets_K;
    m_aim_K = targets_K;
    m_compromise = false;
    m_hold.reset();
    m_nextRest_s = 0.0;
    m_nextSearch_s = 0.0;
}

void LevelServo::setGeometry(std::shared_ptr<const RigGeometry> geometry) {
    // Plans over the source move with it.
    const Pose moved = geometry->X_RS() * m_model.geometry->X_RS().inverse();
    if (m_plan)
        m_plan->plan.move(moved, geometry->limits());
    if (m_hold)
        m_hold = movedWithin(*m_hold, moved, geometry->limits());
    const bool isOtherHeat = !geometry->isSourceEven() && std::abs(geometry->source_K() - m_tableSource_K) >
                                                              kTableWarmer * m_tableSource_K;
    m_model.geometry = std::move(geometry);
    const Pose sinceTable = m_tableSource.inverse() * m_model.geometry->X_RS();
    if (sinceTable.translation().norm() > kTableShift_m ||
        Eigen::AngleAxisd(sinceTable.linear()).angle() > kTableTurn_rad || isOtherHeat)
        m_lookup.reset();
}

HeatingTask LevelServo::identify(const Observation& observation, const Eigen::VectorXd& F, double dt_s) {
    HeatingTask task;
    task.from = observation.coordinates;
    task.temperature_K.resize(F.size());
    task.aim_K = Eigen::Map<const Eigen::VectorXd>(m_aim_K.data(), F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i)
        task.temperature_K[i] = observation.objects[static_cast<std::size_t>(i)].temperature_K;
    const Neighbours& neighbours = m_model.geometry->neighbours();
    const Eigen::VectorXd gainsNow_K4 = neighbourGains_K4(m_model.estimated, neighbours, task.temperature_K),
                          gainsThen_K4 = neighbourGains_K4(m_model.estimated, neighbours, task.aim_K);
    m_early_K_s.resize(F.size());
    m_read_K.resize(F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double reading_K = observation.objects[k].temperature_K;
        m_identification[k].add(observation.time_s, reading_K, F[i], observation.sourceStrength,
                                gainsNow_K4[i]);
        HeatRates rates = m_identification[k].rates();
        rates.lambda1 *= observation.sourceStrength;
        const double T_K = observe(k, rates, observation, dt_s);
        m_read_K[i] = T_K;
        rates.lambda3 += m_drift_K_s[i];
        m_early_K_s[i] = rates.lambda2 * (gainsNow_K4[i] - gainsThen_K4[i]);
        task.rates.push_back(rates.inWarmerRoom(gainsThen_K4[i]));
        const double seen = m_identification[k].seenViewFactor(F[i], 0.0);
        task.temperature_K[i] =
            T_K + m_identification[k].lag_s() * (task.rates.back().rate_K_s(seen, T_K) + m_early_K_s[i]);
    }
    return task;
}

double LevelServo::observe(std::size_t k, const HeatRates& rates, const Observation& observation,
                           double dt_s) {
    const auto i = static_cast<Eigen::Index>(k);
    const double reading_K = observation.objects[k].temperature_K;
    // A change during a pause, or predicted with guessed rates, is neither noise nor drift.
    if (m_expected_K.size() == 0 || observation.time_s - m_time_s > 1.5 * dt_s || !sure(k))
        return reading_K;
    const double corrected_K = kTrustInReading * (reading_K - m_expected_K[i]);
    const double over_s =
        std::max(m_settings.levelServo.integralTime_s, kDriftShare * rates.timeConstant_s(reading_K));
    m_drift_K_s[i] += corrected_K / over_s;
    return m_expected_K[i] + corrected_K;
}

PoseQuery LevelServo::level(const HeatingTask& task) const {
    const auto N = task.aim_K.size();
    PoseQuery out{Eigen::VectorXd(N), Eigen::VectorXd(N), task.from};
    for (Eigen::Index i = 0; i < N; ++i) {
        const HeatRates& rates = task.rates[static_cast<std::size_t>(i)];
        const double timeConstant_s =
            std::max(m_settings.levelServo.timeConstant_s, 1.0 / (kLargestGain_1_K * rates.lambda1));
        const double rate_K_s = (task.aim_K[i] - task.temperature_K[i]) / timeConstant_s;
        out.wanted[i] = std::clamp(rate_K_s / rates.lambda1 + rates.steadyViewFactor(task.temperature_K[i]),
                                   0.0, m_model.geometry->maxViewFactor());
        // A fast object must be controlled more tightly than a slow one, which must not be forgotten either.
        out.weights[i] = rates.lambda1;
    }
    out.weights /= out.weights.maxCoeff();
    return out;
}

PoseQuery LevelServo::steady(const HeatingTask& task, const std::vector<double>& aim_K) const {
    const auto N = task.aim_K.size();
    PoseQuery out{Eigen::VectorXd(N), Eigen::VectorXd(N), task.from};
    for (Eigen::Index i = 0; i < N; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const HeatRates& rates = task.rates[k];
        out.wanted[i] = std::clamp(rates.steadyViewFactor(aim_K[k]), 0.0, m_model.geometry->maxViewFactor());
        out.weights[i] = std::pow(temperaturePerViewFactor_K(rates, aim_K[k]), 2);
    }
    out.weights /= out.weights.maxCoeff();
    return out;
}

bool LevelServo::sure(std::size_t k) const {
    const HeatRates rates = m_identification[k].rates();
    const double target_K = m_model.targets_K[k];
    return m_identification[k].steadyViewFactorDeviation(target_K) *
               temperaturePerViewFactor_K(rates, target_K) <=
           kSure_K;
}

bool LevelServo::allSure() const {
    for (std::size_t k = 0; k < m_aim_K.size(); ++k)
        if (!sure(k))
            return false;
    return true;
}

Eigen::VectorXd LevelServo::steadyAt_K(const HeatingTask& task, const Eigen::VectorXd& F) const {
    Eigen::VectorXd out(F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i)
        out[i] = task.rates[static_cast<std::size_t>(i)].steadyTemperature_K(F[i]);
    return out;
}

double LevelServo::farthest_K(const HeatingTask& task) {
    return (task.temperature_K - task.aim_K).cwiseAbs().maxCoeff();
}

double LevelServo::missedAt_K(const HeatingTask& task, const Vector6d& pose) const {
    return (steadyAt_K(task, m_model.geometry->viewFactorsFast(pose)) - task.aim_K).cwiseAbs().maxCoeff();
}

double LevelServo::farthestHold_K() const {
    return m_aim_K.size() < m_model.geometry->freeCoordinates().size() ? kFarthestHold_K : kFarthestFull_K;
}

bool LevelServo::arrivesNear(const HeatingTask& task, const Vector6d& rest) const {
    const double time_s = travelTime_s(m_model.geometry->limits(), task.from, rest);
    // One object alone can always be brought nearer.
    const double patience_K = task.aim_K.size() > 1 ? kPatience_K_s * (m_time_s - m_nearSince_s) : 0.0;
    const double near_K = std::min(farthestHold_K(), kNear_K + patience_K);
    if (farthest_K(task) > near_K)
        return false;
    const Eigen::VectorXd allowed_K =
        (task.temperature_K - task.aim_K).cwiseAbs().cwiseMax(std::min(kStayNear_K, near_K));
    Eigen::VectorXd T_K = task.temperature_K;
    for (int k = 0; k < kWaySteps; ++k) {
        const Eigen::VectorXd F =
            m_model.geometry->roughViewFactors(task.from + (k + 0.5) / kWaySteps * (rest - task.from));
        for (Eigen::Index i = 0; i < F.size(); ++i) {
            const HeatRates& rates = task.rates[static_cast<std::size_t>(i)];
            const double steady_K = rates.steadyTemperature_K(F[i]);
            T_K[i] =
                steady_K + (T_K[i] - steady_K) * std::exp(-time_s / kWaySteps / rates.timeConstant_s(T_K[i]));
        }
        if (((T_K - task.aim_K).cwiseAbs() - allowed_K).maxCoeff() > 0.0)
            return false;
    }
    return true;
}

void LevelServo::chooseHold(const HeatingTask& task) {
    const Eigen::VectorXd off_K = (task.temperature_K - task.aim_K).cwiseAbs();
    const double lost_K = std::max(kLoseHold_K, m_unavoidable_K + kUnforeseen_K);
    const bool isLost = m_hold && (off_K.array() > (m_heldOff_K.array() + kUnforeseen_K).max(lost_K)).any();
    if (isLost)
        m_hold.reset();
    if (isLost || farthest_K(task) > farthestHold_K())
        m_nearSince_s = m_time_s;
    if (m_hold)
        return correctHold(task);
    std::vector<Vector6d> rests{task.from};
    rests.insert(rests.end(), m_rests.begin(), m_rests.end());
    for (const Vector6d& rest : rests) {
        if (missedAt_K(task, rest) > std::max(kComeToRest_K, m_unavoidable_K + kAsGood_K) ||
            !arrivesNear(task, rest))
            continue;
        m_hold = rest;
        m_heldOff_K = off_K;
        m_missedSince_s = m_time_s;
        return;
    }
}

void LevelServo::correctHold(const HeatingTask& task) {
    if (missedAt_K(task, *m_hold) <= std::max(kLeaveRest_K, m_unavoidable_K + kComeToRest_K))
        m_missedSince_s = m_time_s;
    if (m_time_s - m_missedSince_s < kMissedFor_s)
        return;
    PoseQuery query = steady(task, m_aim_K);
    query.movePrice_1_m2 = kMovePrice_K2_m2 / heaviest_K2(task, m_aim_K);
    m_hold = refinePose(*m_model.geometry, query, *m_hold, kRefinements);
    m_missedSince_s = m_time_s;
}

void LevelServo::findRests(const HeatingTask& task) {
    const RigGeometry& geometry = *m_model.geometry;
    const PoseQuery query = steady(task, m_model.targets_K);
    const Eigen::Map<const Eigen::VectorXd> targets_K(m_model.targets_K.data(), task.aim_K.size());
    std::vector<Vector6d> starts = m_lookup->best(query, kRestCandidates);
    starts.push_back(task.from);
    if (m_plan)
        starts.push_back(m_plan->plan.rest);
    struct Found {
        Vector6d pose;
        double price_K2;
    };
    std::vector<Found> found;
    Eigen::VectorXd nearest_K;
    const TravelTime travel(geometry.limits(), task.from);
    for (const Vector6d& start : starts) {
        const Vector6d pose = refinePose(geometry, query, start, kRefinements);
        const Eigen::VectorXd steady_K = steadyAt_K(task, geometry.viewFactorsFast(pose));
        const double missed_K2 = (steady_K - targets_K).squaredNorm();
        if (nearest_K.size() == 0 || missed_K2 < (nearest_K - targets_K).squaredNorm())
            nearest_K = steady_K;
        found.push_back({pose, missed_K2 + kRestTravelPrice_K2_s * travel.to(pose)});
    }
    std::ranges::sort(found, {}, &Found::price_K2);
    m_rests.clear();
    for (const Found& rest : found) {
        const TravelTime away(geometry.limits(), rest.pose);
        const bool another =
            std::ranges::all_of(m_rests, [&](const Vector6d& q) { return away.to(q) > kRestsApart_s; });
        if (another && static_cast<int>(m_rests.size()) < kRests)
            m_rests.push_back(rest.pose);
    }
    judgeTargets(nearest_K);
}

void LevelServo::judgeTargets(const Eigen::VectorXd& nearest_K) {
    m_unavoidable_K = 0.0;
    if (!allSure())
        return;
    const Eigen::Map<const Eigen::VectorXd> targets_K(m_model.targets_K.data(), nearest_K.size());
    const double worst_K = (nearest_K - targets_K).cwiseAbs().maxCoeff();
    m_compromise = worst_K > (m_compromise ? kMet_K : kUnmet_K);
    m_unavoidable_K = m_compromise ? 0.0 : worst_K;
    for (std::size_t k = 0; k < m_aim_K.size(); ++k)
        m_aim_K[k] = m_compromise ? nearest_K[static_cast<Eigen::Index>(k)] : m_model.targets_K[k];
}

std::vector<HeatingPlan> LevelServo::restingPlans(const HeatingTask& task) const {
    std::vector<HeatingPlan> out;
    const double time_s = restStay_s(task);
    const PoseQuery query = steady(task, m_aim_K);
    for (const Vector6d& found : m_rests) { // some steps ago, with other estimates
        const Vector6d rest = refinePose(*m_model.geometry, query, found, kTouches);
        out.push_back({{Stay{rest, time_s}, Stay{rest, time_s}}, rest});
    }
    return out;
}

std::vector<HeatingPlan> LevelServo::heatingPlans(const HeatingTask& task, const Vector6d& rest) const {
    std::vector<HeatingPlan> out;
    const PoseQuery first = level(task);
    for (const Vector6d& start : m_lookup->best(first, kLevelPoses)) {
        HeatingPlan plan;
        plan.rest = rest;
        plan.stays[0].pose = refinePose(*m_model.geometry, first, start, kRefinements, Shade::Rough);
        HeatingTask then = task;
        plan.stays[0].time_s = stayAt(plan.stays[0].pose, false, then);
        const PoseQuery second = level(then);
        const std::vector<Vector6d> next = m_lookup->best(second, 1);
        plan.stays[1].pose =
            next.empty() ? rest
                         : refinePose(*m_model.geometry, second, next.front(), kRefinements, Shade::Rough);
        plan.stays[1].time_s = stayAt(plan.stays[1].pose, true, then);
        out.push_back(plan);
    }
    return out;
}

double LevelServo::stayAt(const Vector6d& pose, bool all, HeatingTask& task) const {
    const Eigen::VectorXd steady_K = steadyAt_K(task, m_model.geometry->roughViewFactors(pose));
    double time_s = all ? 0.0 : std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < steady_K.size(); ++i) {
        const double off_K = task.aim_K[i] - task.temperature_K[i];
        if (std::abs(off_K) < kOff_K || (steady_K[i] - task.aim_K[i]) * off_K <= 0.0)
            continue;
        const double arrival_s =
            task.rates[static_cast<std::size_t>(i)].timeConstant_s(task.aim_K[i]) *
            std::log((steady_K[i] - task.temperature_K[i]) / (steady_K[i] - task.aim_K[i]));
        time_s = all ? std::max(time_s, arrival_s) : std::min(time_s, arrival_s);
    }
    if (!std::isfinite(time_s))
        time_s = 0.0;
    task.from = pose;
    for (Eigen::Index i = 0; i < steady_K.size(); ++i) {
        const double tau_s = task.rates[static_cast<std::size_t>(i)].timeConstant_s(task.aim_K[i]);
        task.temperature_K[i] =
            steady_K[i] + (task.temperature_K[i] - steady_K[i]) * std::exp(-time_s / tau_s);
    }
    return time_s;
}

void LevelServo::choosePlan(const HeatingTask& task) {
    const PlanCost cost(*m_model.geometry, task);
    bool foreseen = false;
    if (m_plan) {
        const PricedPlan present{m_plan->plan, cost.of(m_plan->plan)};
        const PricedPlan improved = cost.improve(present.plan, kFollowIterations);
        foreseen = improved.cost < kSurprise * m_plan->cost;
        m_plan = improved.cost < kWorthChanging * present.cost ? improved : present;
    }
    if (m_time_s < m_nextSearch_s && foreseen)
        return;
    const bool calm = (task.temperature_K - task.aim_K).cwiseAbs().maxCoeff() < kCalm_K;
    m_nextSearch_s = m_time_s + (calm ? kCalmSearchPeriod_s : kSearchPeriod_s);
    const auto consider = [&](const std::vector<HeatingPlan>& proposed, std::size_t max) {
        std::vector<PricedPlan> plans;
        for (const HeatingPlan& plan : proposed)
            plans.push_back({plan, cost.of(plan)});
        std::ranges::sort(plans, {}, &PricedPlan::cost);
        plans.resize(std::min(plans.size(), max));
        for (const PricedPlan& plan : plans) {
            const PricedPlan better = cost.improve(plan.plan, kSearchIterations);
            if (!m_plan || better.cost < kBetter * m_plan->cost)
                m_plan = better;
        }
    };
    const std::vector<HeatingPlan> resting = restingPlans(task);
    consider(resting, 1);
    consider(heatingPlans(task, resting.front().rest), 2);
}

VelocitySolution LevelServo::follow(const HeatingTask& task, const Vector6d& lastRates, double dt_s) {
    const RigGeometry& geometry = *m_model.geometry;
    const Stay last{m_plan->plan.rest, restStay_s(task)};
    for (int k = 0; k < 2 && m_plan->plan.stays[0].time_s < kWorthGoing * dt_s; ++k)
        m_plan->plan.spend(dt_s, last); // moving there is of no use
    const double travel_s = travelTime_s(geometry.limits(), task.from, m_plan->plan.stays[0].pose);
    if (travel_s > 0.5 * dt_s)
        return velocityTowards(geometry, task.from, m_plan->plan.stays[0].pose, dt_s, lastRates);
    const double here_s = std::min(dt_s, m_plan->plan.stays[0].time_s);
    const Vector6d goal = here_s < dt_s ? m_plan->plan.stays[1].pose : m_plan->plan.stays[0].pose;
    m_plan->plan.spend(dt_s - travel_s, last);
    VelocitySolution out = velocityTowards(geometry, task.from, goal, dt_s, lastRates);
    if (here_s < dt_s) { // leave within the step, at a lower speed for all of it
        const Vector6d standing = velocityTowards(geometry, task.from, task.from, dt_s, lastRates).rates;
        out.rates = standing + (1.0 - here_s / dt_s) * (out.rates - standing);
    }
    return out;
}

ControlOutput LevelServo::step(const Observation& observation, double dt_s) {
    if (observation.objects.size() != m_identification.size())
        throw std::invalid_argument("LevelServo: wrong number of objects");
    if (!m_lookup) {
        m_lookup.emplace(m_model.geometry, observation.coordinates);
        m_tableSource = m_model.geometry->X_RS();
        m_tableSource_K = m_model.geometry->source_K();
    }
    const ViewFactors fields = m_model.geometry->viewFactors(observation.coordinates);
    HeatingTask task = identify(observation, fields.F, dt_s);
    m_time_s = observation.time_s;
    if (m_time_s >= m_nextRest_s) {
        m_nextRest_s = m_time_s + kRestPeriod_s;
        findRests(task);
        task.aim_K = Eigen::Map<const Eigen::VectorXd>(m_aim_K.data(), task.aim_K.size());
    }
    if (m_plan && missedAt_K(task, m_plan->plan.rest) > kRestMiss_K) {
        m_plan->plan.rest = refinePose(*m_model.geometry, steady(task, m_aim_K), m_plan->plan.rest, kTouches);
    }
    VelocitySolution motion;
    chooseHold(task);
    if (m_hold) {
        m_plan.reset();
        const bool arrived = travelTime_s(m_model.geometry->limits(), task.from, *m_hold) < kArrived_s;
        motion = velocityTowards(*m_model.geometry, task.from, arrived ? task.from : *m_hold, dt_s,
                                 observation.lastRates);
    } else {
        choosePlan(task);
        motion = follow(task, observation.lastRates, dt_s);
    }
    const Eigen::VectorXd F =
        m_model.geometry->viewFactorsFast(observation.coordinates + 0.5 * dt_s * motion.rates);
    m_expected_K = m_read_K;
    for (Eigen::Index i = 0; i < F.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double seen = m_identification[k].seenViewFactor(F[i], 0.5 * dt_s);
        m_expected_K[i] += dt_s * (task.rates[k].rate_K_s(seen, m_read_K[i]) + m_early_K_s[i]);
    }

    ControlOutput out;
    for (const LaggedIdentification& identification : m_identification)
        out.estimate.push_back(identification.rates());
    out.rates = motion.rates;
    out.limits = motion.limits;
    out.isOnTheWay = !m_hold;
    out.smallestSingularValue =
        singularRange(*m_model.geometry, fields.dF, m_settings.rotationLength_m).smallest;
    if (m_compromise)
        out.compromise_K = m_aim_K;
    return out;
}

} // namespace bask
