#include "engine/control/level_servo.h"

#include "engine/control/velocity_solve.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kIntegralBand_K = 2.0; ///< integral action works within this of the target
constexpr double kHorizon_s = 30.0;     ///< over which a move must pay
constexpr double kHorizonGrowth =
    4.0; ///< by which it grows for every second in which nothing near gives the wanted F
constexpr double kMetResidual = 1e-5; ///< residual cost below which the wanted F are met
constexpr int kPathSamples = 6;       ///< of the way to a candidate
constexpr double kLargestGain_1_K =
    1.0; ///< a kelvin of error asks for the whole range of F at most, or noise would throw slow objects about
constexpr int kCandidates = 4; ///< look-up poses that are refined
constexpr int kRefinements = 12;
constexpr double kAimPeriod_s = 5.0; ///< how often it is asked whether one pose holds all targets
constexpr int kAimCandidates = 10;
constexpr double kSure_K = 0.3;  ///< identified rates are sure enough to judge by
constexpr double kUnmet_K = 0.4; ///< a compromise begins when the best pose misses a target by this
constexpr double kMet_K = 0.3;   ///< and ends below this

double singularValue(const RigGeometry& geometry, const ViewFactors& fields, double rotationLength_m) {
    const auto& free = geometry.freeCoordinates();
    Eigen::MatrixXd J(fields.F.size(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
        J.col(static_cast<Eigen::Index>(k)) = fields.dF.col(free[k]) / (free[k] < 3 ? 1.0 : rotationLength_m);
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J);
    return svd.singularValues().size() > 0 ? svd.singularValues().tail<1>()[0] : 0.0;
}

} // namespace

LevelServo::LevelServo(const ControllerSettings& settings, ControlModel model)
    : m_settings(settings), m_model(std::move(model)) {
    for (const HeatRates& rates : m_model.believed)
        m_identification.emplace_back(rates);
    m_aim_K = m_model.targets_K;
    m_integral_K_s.assign(m_model.believed.size(), 0.0);
    m_unmet = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_model.believed.size()));
}

void LevelServo::setTargets(const std::vector<double>& targets_K) {
    m_model.targets_K = targets_K;
    m_aim_K = targets_K;
    m_compromise = false;
    m_nextAim_s = 0.0;
    std::ranges::fill(m_integral_K_s, 0.0);
}

PoseQuery LevelServo::query(const Observation& observation, double dt_s) {
    const LevelServoGains& gains = m_settings.levelServo;
    const auto N = static_cast<Eigen::Index>(m_identification.size());
    PoseQuery out;
    out.wanted.resize(N);
    out.weights.resize(N);
    out.from = observation.coordinates;
    for (Eigen::Index i = 0; i < N; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const HeatRates rates = m_identification[k].rates();
        const double T = observation.objects[k].temperature_K;
        const double error_K = m_aim_K[k] - T;
        const double strength = rates.lambda1 * observation.sourceStrength;
        const double cooling = rates.lambda2 * std::pow(T, 4) - rates.lambda3;
        const double timeConstant_s =
            std::max({gains.timeConstant_s, 2.0 * dt_s, 1.0 / (kLargestGain_1_K * strength)});
        // A wanted F that the last pose could not give must not wind the integral up.
        const bool met = std::abs(m_unmet[i]) < 0.02;
        if (std::abs(error_K) < kIntegralBand_K && met)
            m_integral_K_s[k] += dt_s * error_K / (timeConstant_s * gains.integralTime_s);
        const double F = (error_K / timeConstant_s + m_integral_K_s[k] + cooling) / strength;
        out.wanted[i] = std::clamp(F, 0.0, 1.0);
        // A fast object must be held more closely than a slow one, which must not be forgotten either.
        out.weights[i] = strength;
    }
    out.weights /= out.weights.maxCoeff();
    return out;
}

std::vector<Vector6d> LevelServo::candidates(const PoseQuery& query, int count) const {
    std::vector<Vector6d> poses = m_lookup->best(query, count);
    if (m_model.geometry->allowed(query.from))
        poses.push_back(query.from);
    if (m_goal)
        poses.push_back(*m_goal);
    if (poses.empty())
        poses.push_back(query.from);
    for (Vector6d& pose : poses)
        pose = refinePose(*m_model.geometry, query, pose, kRefinements);
    return poses;
}

double LevelServo::cost(const PoseQuery& query, const Vector6d& goal) const {
    // Integral of the residual over the horizon: on the way, which may lead past the source, and at the goal.
    const double travel_s = travelTime_s(m_model.geometry->limits(), query.from, goal);
    const double horizon_s = kHorizon_s + kHorizonGrowth * m_unmetTime_s;
    double onTheWay = 0.0;
    for (int k = 0; k < kPathSamples && travel_s > 1.0; ++k) {
        const Vector6d q = query.from + (k + 0.5) / kPathSamples * (goal - query.from);
        onTheWay += residualCost(query, m_model.geometry->viewFactorsFast(q)) / kPathSamples;
    }
    const double there = residualCost(query, m_model.geometry->viewFactorsFast(goal));
    return travel_s * onTheWay + std::max(kHorizon_s, horizon_s - travel_s) * there;
}

Vector6d LevelServo::choosePose(const PoseQuery& query) const {
    // Mostly a pose close by will do, and nothing needs to be searched.
    if (m_model.geometry->allowed(query.from)) {
        const Vector6d near = refinePose(*m_model.geometry, query, query.from, kRefinements);
        if (residualCost(query, m_model.geometry->viewFactorsFast(near)) <= kMetResidual)
            return near;
    }
    const std::vector<Vector6d> poses = candidates(query, kCandidates);
    return *std::ranges::min_element(poses, {}, [&](const Vector6d& pose) { return cost(query, pose); });
}

void LevelServo::updateAim(const Observation& observation) {
    if (observation.time_s < m_nextAim_s)
        return;
    m_nextAim_s = observation.time_s + kAimPeriod_s;
    const auto N = static_cast<Eigen::Index>(m_identification.size());
    PoseQuery steady;
    steady.wanted.resize(N);
    steady.weights.resize(N);
    steady.from = observation.coordinates;
    std::vector<HeatRates> rates;
    for (Eigen::Index i = 0; i < N; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double target_K = m_model.targets_K[k];
        rates.push_back(m_identification[k].rates());
        rates.back().lambda1 *= observation.sourceStrength;
        const double slope_K =
            rates.back().lambda1 / (4.0 * rates.back().lambda2 * std::pow(target_K, 3)); // dT/dF
        if (m_identification[k].steadyViewFactorDeviation(target_K) * slope_K > kSure_K)
            return;
        steady.wanted[i] = std::clamp(rates.back().steadyViewFactor(target_K), 0.0, 1.0);
        steady.weights[i] = slope_K * slope_K;
    }
    steady.weights /= steady.weights.maxCoeff();
    Eigen::VectorXd F;
    for (const Vector6d& pose : candidates(steady, kAimCandidates)) {
        const Eigen::VectorXd there = m_model.geometry->viewFactorsFast(pose);
        if (F.size() == 0 || residualCost(steady, there) < residualCost(steady, F))
            F = there;
    }
    std::vector<double> nearest_K;
    double worst_K = 0.0;
    for (std::size_t k = 0; k < rates.size(); ++k) {
        nearest_K.push_back(rates[k].steadyTemperature_K(F[static_cast<Eigen::Index>(k)]));
        worst_K = std::max(worst_K, std::abs(nearest_K.back() - m_model.targets_K[k]));
    }
    m_compromise = worst_K > (m_compromise ? kMet_K : kUnmet_K);
    m_aim_K = m_compromise ? nearest_K : m_model.targets_K;
}

ControlOutput LevelServo::step(const Observation& observation, double dt_s) {
    if (observation.objects.size() != m_identification.size())
        throw std::invalid_argument("LevelServo: wrong number of objects");
    if (!m_lookup)
        m_lookup.emplace(m_model.geometry, observation.coordinates);
    const ViewFactors fields = m_model.geometry->viewFactors(observation.coordinates);
    ControlOutput out;
    for (std::size_t i = 0; i < m_identification.size(); ++i) {
        m_identification[i].add(observation.time_s, observation.objects[i].temperature_K,
                                fields.F[static_cast<Eigen::Index>(i)], observation.sourceStrength);
        out.belief.push_back(m_identification[i].rates());
    }
    updateAim(observation);
    const PoseQuery wanted = query(observation, dt_s);
    m_goal = choosePose(wanted);
    const Eigen::VectorXd had = m_model.geometry->viewFactorsFast(*m_goal);
    m_unmet = wanted.wanted - had;
    m_unmetTime_s = residualCost(wanted, had) > kMetResidual ? m_unmetTime_s + dt_s : 0.0;
    const VelocitySolution motion =
        velocityTowards(*m_model.geometry, observation.coordinates, *m_goal, dt_s);
    out.rates = motion.rates;
    out.limited = motion.limited;
    out.smallestSingularValue = singularValue(*m_model.geometry, fields, m_settings.rotationLength_m);
    if (m_compromise)
        out.compromise_K = m_aim_K;
    return out;
}

} // namespace bask
