#include "engine/control/level_servo.h"

#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kLargestGain_1_K = 1.0; ///< a kelvin of error asks for the whole range of F at most
constexpr int kRefinements = 12;
constexpr double kRestPeriod_s = 5.0; ///< how often poses that hold the targets are looked for
constexpr int kRestCandidates = 10;
constexpr int kRests = 3;
constexpr int kLevelPoses = 3;
constexpr int kFollowIterations = 4; ///< of the plan at each step
constexpr int kSearchIterations = 6;
constexpr double kSure_K = 0.3;  ///< identified rates are sure enough to judge by
constexpr double kUnmet_K = 0.4; ///< a compromise begins when the best pose misses a target by this
constexpr double kMet_K = 0.3;   ///< and ends below this
constexpr double kRestTravelPrice_K2_s = 1e-3;
// The look-up gives starting points only: it may be this far behind a moving source.
constexpr double kTableShift_m = 0.01;
constexpr double kTableTurn_rad = 0.05;

/// Time until an object at T_K with view factor F has come to aim_K; infinite if it does not.
double arrival_s(const HeatRates& rates, double F, double T_K, double aim_K) {
    const double steady_K = rates.steadyTemperature_K(F);
    const double part = (steady_K - T_K) / (steady_K - aim_K);
    return part > 1.0 ? rates.timeConstant_s(aim_K) * std::log(part)
                      : std::numeric_limits<double>::infinity();
}

double restStay_s(const HeatingTask& task) {
    double out = 0.0;
    for (Eigen::Index i = 0; i < task.aim_K.size(); ++i)
        out = std::max(out, 0.1 * task.rates[static_cast<std::size_t>(i)].timeConstant_s(task.aim_K[i]));
    return out;
}

} // namespace

LevelServo::LevelServo(const ControllerSettings& settings, ControlModel model)
    : m_settings(settings), m_model(std::move(model)) {
    for (const HeatRates& rates : m_model.believed)
        m_identification.emplace_back(rates);
    m_aim_K = m_model.targets_K;
    m_drift_K_s = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_model.believed.size()));
}

void LevelServo::setTargets(const std::vector<double>& targets_K) {
    m_model.targets_K = targets_K;
    m_aim_K = targets_K;
    m_compromise = false;
    m_nextRest_s = 0.0;
    m_nextSearch_s = 0.0;
}

void LevelServo::setGeometry(std::shared_ptr<const RigGeometry> geometry) {
    // What was planned over the source goes with it.
    const Pose moved = geometry->X_RS() * m_model.geometry->X_RS().inverse();
    if (m_plan)
        m_plan->move(moved, geometry->limits());
    m_model.geometry = std::move(geometry);
    const Pose sinceTable = m_tableSource.inverse() * m_model.geometry->X_RS();
    if (sinceTable.translation().norm() > kTableShift_m ||
        Eigen::AngleAxisd(sinceTable.linear()).angle() > kTableTurn_rad)
        m_lookup.reset();
}

HeatingTask LevelServo::identify(const Observation& observation, const Eigen::VectorXd& F, double dt_s) {
    HeatingTask task;
    task.from = observation.coordinates;
    task.temperature_K.resize(F.size());
    task.aim_K = Eigen::Map<const Eigen::VectorXd>(m_aim_K.data(), F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double T_K = observation.objects[k].temperature_K;
        m_identification[k].add(observation.time_s, T_K, F[i], observation.sourceStrength);
        HeatRates rates = m_identification[k].rates();
        rates.lambda1 *= observation.sourceStrength;
        // drift
        const double surprise = m_expected_K.size() > 0 ? (T_K - m_expected_K[i]) / dt_s : 0.0;
        if (m_identification[k].steadyViewFactorDeviation(m_model.targets_K[k]) * rates.lambda1 *
                rates.timeConstant_s(T_K) <
            kSure_K)
            m_drift_K_s[i] += dt_s / m_settings.levelServo.integralTime_s * surprise;
        rates.lambda3 += m_drift_K_s[i];
        task.temperature_K[i] = T_K;
        task.rates.push_back(rates);
    }
    return task;
}

PoseQuery LevelServo::level(const HeatingTask& task) const {
    const auto N = task.aim_K.size();
    PoseQuery out{Eigen::VectorXd(N), Eigen::VectorXd(N), task.from};
    for (Eigen::Index i = 0; i < N; ++i) {
        const HeatRates& rates = task.rates[static_cast<std::size_t>(i)];
        const double timeConstant_s =
            std::max(m_settings.levelServo.timeConstant_s, 1.0 / (kLargestGain_1_K * rates.lambda1));
        const double rate_K_s = (task.aim_K[i] - task.temperature_K[i]) / timeConstant_s;
        out.wanted[i] =
            std::clamp(rate_K_s / rates.lambda1 + rates.steadyViewFactor(task.temperature_K[i]), 0.0, 1.0);
        // A fast object must be held more closely than a slow one, which must not be forgotten either.
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
        out.wanted[i] = std::clamp(rates.steadyViewFactor(aim_K[k]), 0.0, 1.0);
        out.weights[i] = std::pow(rates.lambda1 * rates.timeConstant_s(aim_K[k]), 2); // (dT/dF)^2
    }
    out.weights /= out.weights.maxCoeff();
    return out;
}

bool LevelServo::sure() const {
    for (std::size_t k = 0; k < m_identification.size(); ++k) {
        const HeatRates rates = m_identification[k].rates();
        const double target_K = m_model.targets_K[k];
        if (m_identification[k].steadyViewFactorDeviation(target_K) * rates.lambda1 *
                rates.timeConstant_s(target_K) >
            kSure_K)
            return false;
    }
    return true;
}

void LevelServo::findRest(const HeatingTask& task, double time_s) {
    const PoseQuery query = steady(task, m_model.targets_K);
    if (time_s < m_nextRest_s) {
        const PoseQuery near = steady(task, m_aim_K);
        if (m_plan)
            m_plan->rest = refinePose(*m_model.geometry, near, m_plan->rest, 3);
        return;
    }
    m_nextRest_s = time_s + kRestPeriod_s;
    std::vector<Vector6d> poses = m_lookup->best(query, kRestCandidates);
    if (m_plan)
        poses.push_back(m_plan->rest);
    poses.push_back(task.from);
    struct Found {
        Vector6d pose;
        double missed = 0.0;
        double price = 0.0;
    };
    std::vector<Found> found;
    Eigen::VectorXd nearest_K;
    double least = std::numeric_limits<double>::infinity();
    for (const Vector6d& start : poses) {
        Found rest{refinePose(*m_model.geometry, query, start, kRefinements)};
        const Eigen::VectorXd F = m_model.geometry->viewFactorsFast(rest.pose);
        Eigen::VectorXd steady_K(F.size());
        for (Eigen::Index i = 0; i < F.size(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            steady_K[i] = task.rates[k].steadyTemperature_K(F[i]);
            rest.missed += std::pow(steady_K[i] - m_model.targets_K[k], 2);
        }
        rest.price = rest.missed +
                     kRestTravelPrice_K2_s * travelTime_s(m_model.geometry->limits(), task.from, rest.pose);
        if (rest.missed < least) {
            least = rest.missed;
            nearest_K = steady_K;
        }
        found.push_back(rest);
    }
    std::ranges::sort(found, {}, &Found::price);
    m_rests.clear();
    for (const Found& rest : found) {
        const bool other = std::ranges::all_of(m_rests, [&](const Vector6d& q) {
            return travelTime_s(m_model.geometry->limits(), q, rest.pose) > 1.0;
        });
        if (other && static_cast<int>(m_rests.size()) < kRests)
            m_rests.push_back(rest.pose);
    }
    if (!sure())
        return;
    double worst_K = 0.0;
    for (std::size_t k = 0; k < m_aim_K.size(); ++k)
        worst_K = std::max(worst_K, std::abs(nearest_K[static_cast<Eigen::Index>(k)] - m_model.targets_K[k]));
    m_compromise = worst_K > (m_compromise ? kMet_K : kUnmet_K);
    for (std::size_t k = 0; k < m_aim_K.size(); ++k)
        m_aim_K[k] = m_compromise ? nearest_K[static_cast<Eigen::Index>(k)] : m_model.targets_K[k];
}

std::vector<HeatingPlan> LevelServo::proposals(const HeatingTask& task) const {
    const RigGeometry& geometry = *m_model.geometry;
    std::vector<HeatingPlan> out;
    for (const Vector6d& rest : m_rests)
        out.push_back({{Stay{rest, restStay_s(task)}, Stay{rest, restStay_s(task)}}, rest});
    const PoseQuery first = level(task);
    for (const Vector6d& pose : m_lookup->best(first, kLevelPoses)) {
        HeatingPlan plan;
        plan.rest = m_rests.front();
        plan.stays[0].pose = refinePose(geometry, first, pose, kRefinements);
        const Eigen::VectorXd F = geometry.viewFactorsFast(plan.stays[0].pose);
        // there until the first object has come to its aim
        double time_s = std::numeric_limits<double>::infinity();
        for (Eigen::Index i = 0; i < F.size(); ++i)
            if (task.aim_K[i] - task.temperature_K[i] > 0.3)
                time_s = std::min(time_s, arrival_s(task.rates[static_cast<std::size_t>(i)], F[i],
                                                    task.temperature_K[i], task.aim_K[i]));
        if (!std::isfinite(time_s))
            time_s = 0.0;
        plan.stays[0].time_s = time_s;
        HeatingTask then = task;
        then.from = plan.stays[0].pose;
        for (Eigen::Index i = 0; i < F.size(); ++i) {
            const HeatRates& rates = task.rates[static_cast<std::size_t>(i)];
            const double steady_K = rates.steadyTemperature_K(F[i]);
            then.temperature_K[i] = steady_K + (task.temperature_K[i] - steady_K) *
                                                   std::exp(-time_s / rates.timeConstant_s(task.aim_K[i]));
        }
        const PoseQuery second = level(then);
        const std::vector<Vector6d> next = m_lookup->best(second, 1);
        plan.stays[1] = {next.empty() ? plan.rest : refinePose(geometry, second, next.front(), kRefinements),
                         0.0};
        const Eigen::VectorXd F2 = geometry.viewFactorsFast(plan.stays[1].pose);
        for (Eigen::Index i = 0; i < F.size(); ++i)
            if (task.aim_K[i] - then.temperature_K[i] > 0.3) {
                const double t = arrival_s(task.rates[static_cast<std::size_t>(i)], F2[i],
                                           then.temperature_K[i], task.aim_K[i]);
                if (std::isfinite(t))
                    plan.stays[1].time_s = std::max(plan.stays[1].time_s, t);
            }
        out.push_back(plan);
    }
    return out;
}

void LevelServo::choosePlan(const HeatingTask& task) {
    const RigGeometry& geometry = *m_model.geometry;
    double cost = std::numeric_limits<double>::infinity();
    if (m_plan)
        m_plan = improvePlan(geometry, task, *m_plan, kFollowIterations, cost);
    struct Rated {
        HeatingPlan plan;
        double cost;
    };
    const double off_K = (task.temperature_K - task.aim_K).cwiseAbs().maxCoeff();
    const bool expected = cost < 1.2 * m_cost;
    m_cost = cost;
    if (m_plan && m_time_s < m_nextSearch_s && expected)
        return;
    m_nextSearch_s = m_time_s + (off_K < 0.4 ? 10.0 : 2.0);
    std::vector<Rated> rated;
    for (const HeatingPlan& plan : proposals(task))
        rated.push_back({plan, planResiduals(geometry, task, plan).squaredNorm()});
    // the best of the ways straight to a rest, and of those by a hot pose
    const auto hot = rated.begin() + static_cast<std::ptrdiff_t>(m_rests.size());
    std::ranges::sort(rated.begin(), hot, {}, &Rated::cost);
    std::ranges::sort(hot, rated.end(), {}, &Rated::cost);
    for (std::size_t k = 0; k < rated.size(); ++k) {
        if (k != 0 && (k < m_rests.size() || k >= m_rests.size() + 2))
            continue;
        double c = 0.0;
        const HeatingPlan plan = improvePlan(geometry, task, rated[k].plan, kSearchIterations, c);
        if (c < 0.97 * cost) {
            cost = m_cost = c;
            m_plan = plan;
        }
    }
}

VelocitySolution LevelServo::follow(const HeatingTask& task, const Vector6d& lastRates, double dt_s) {
    const RigGeometry& geometry = *m_model.geometry;
    const Stay last{m_plan->rest, restStay_s(task)};
    for (int k = 0; k < 2 && m_plan->stays[0].time_s < 0.25 * dt_s; ++k)
        m_plan->spend(dt_s, last); // no use to go there
    const double travel_s = travelTime_s(geometry.limits(), task.from, m_plan->stays[0].pose);
    if (travel_s > 0.5 * dt_s)
        return velocityTowards(geometry, task.from, m_plan->stays[0].pose, dt_s, lastRates);
    const double here_s = std::min(dt_s, m_plan->stays[0].time_s);
    const Vector6d goal = here_s < dt_s ? m_plan->stays[1].pose : m_plan->stays[0].pose;
    m_plan->spend(dt_s - travel_s, last);
    VelocitySolution out = velocityTowards(geometry, task.from, goal, dt_s, lastRates);
    if (here_s < dt_s &&
        !geometry.limits().limitsAcceleration()) // leave within the step, by going slower for the whole of it
        out.rates *= 1.0 - here_s / dt_s;
    return out;
}

ControlOutput LevelServo::step(const Observation& observation, double dt_s) {
    if (observation.objects.size() != m_identification.size())
        throw std::invalid_argument("LevelServo: wrong number of objects");
    if (!m_lookup) {
        m_lookup.emplace(m_model.geometry, observation.coordinates);
        m_tableSource = m_model.geometry->X_RS();
    }
    const ViewFactors fields = m_model.geometry->viewFactors(observation.coordinates);
    HeatingTask task = identify(observation, fields.F, dt_s);
    m_time_s = observation.time_s;
    findRest(task, observation.time_s);
    task.aim_K = Eigen::Map<const Eigen::VectorXd>(m_aim_K.data(), task.aim_K.size());
    choosePlan(task);
    const VelocitySolution motion = follow(task, observation.lastRates, dt_s);
    const Eigen::VectorXd F =
        m_model.geometry->viewFactorsFast(observation.coordinates + 0.5 * dt_s * motion.rates);
    m_expected_K.resize(F.size());
    for (Eigen::Index i = 0; i < F.size(); ++i)
        m_expected_K[i] = task.temperature_K[i] + dt_s * task.rates[static_cast<std::size_t>(i)].rate_K_s(
                                                             F[i], task.temperature_K[i]);
    ControlOutput out;
    for (const RateIdentification& identification : m_identification)
        out.belief.push_back(identification.rates());
    out.rates = motion.rates;
    out.limits = motion.limits;
    out.smallestSingularValue =
        singularRange(*m_model.geometry, fields.dF, m_settings.rotationLength_m).smallest;
    if (m_compromise)
        out.compromise_K = m_aim_K;
    return out;
}

} // namespace bask
