#include "engine/control/heating_plan.h"

#include "engine/control/bounded_least_squares.h"
#include "engine/control/velocity_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr int kLegSteps = 8;      ///< of a path between poses
constexpr int kStaySteps = 8;     ///< of a stay
constexpr double kHere_s = 0.05;  ///< a path shorter than this is left out
constexpr double kFar_K = 8.0;    ///< above this, squared errors grow linearly
constexpr double kHotShare = 2.2; ///< of the slowest object's time per kelvin, for every kelvin too hot
constexpr double kHotSteepness_1_K = 10.0;
constexpr double kFastShare = 0.3; ///< of the slowest object's time, the minimum that a fast object counts
constexpr double kMinPull = 0.05;  ///< of the view factor, for the time to heat or cool
// Within these an error counts little, so that noise does not keep the robot moving.
constexpr double kNearCold_K = 0.25;
constexpr double kNearHot_K = 0.05;
constexpr double kNearWeight = 0.05;
constexpr double kMissedRest = 2.0;    ///< time constants for which a rest that misses the aim is penalised
constexpr double kTravelShare = 0.2;   ///< travel counts as a delay of this share of it
constexpr double kShortTravel_s = 1.0; ///< shorter travel counts less
constexpr double kLeastDelay_s = 5.0;  ///< of the slowest object, for the price of travel

constexpr double kLengthStep_m = 2e-4;        // of the differences; well below the distance to a kink
constexpr double kTimePerLength_s_m = 1000.0; // 1 cm of a stay's pose counts as 10 s of its time

/// Variables of a plan: the free coordinates and the time of each stay, all as lengths.
class Variables {
public:
    explicit Variables(const RigGeometry& geometry) : m_geometry(geometry) {}
    Eigen::Index count() const { return 2 * (free() + 1); }

    /// `plan` changed by `step`; its poses may be outside workspace and clearance.
    HeatingPlan moved(const HeatingPlan& plan, const Eigen::VectorXd& step) const {
        HeatingPlan out = plan;
        Eigen::Index k = 0;
        for (Stay& stay : out.stays) {
            for (const int c : m_geometry.freeCoordinates())
                stay.pose[c] += step[k++] / scale(c);
            stay.time_s = std::max(0.0, stay.time_s + timeScale(stay) * step[k++]);
        }
        return out;
    }

    /// Rows G y >= h that keep a step y inside workspace and clearance, linearised, and times positive.
    void limits(const HeatingPlan& plan, Eigen::MatrixXd& G, Eigen::VectorXd& h) const {
        Eigen::Index row = 0, column = 0;
        for (const Stay& stay : plan.stays) {
            Eigen::MatrixXd poseG;
            Eigen::VectorXd poseH;
            stepLimits(m_geometry, stay.pose, poseG, poseH);
            const Eigen::Index poseRows = poseH.size();
            if (row == 0) {
                G = Eigen::MatrixXd::Zero(2 * (poseRows + 1), count());
                h = Eigen::VectorXd::Zero(G.rows());
            }
            for (Eigen::Index k = 0; k < free(); ++k)
                G.block(row, column + k, poseRows, 1) = poseG.col(k) / scale(coordinate(k));
            h.segment(row, poseRows) = poseH;
            row += poseRows;
            column += free();
            G(row, column++) = 1.0;
            h[row++] = -stay.time_s / timeScale(stay);
        }
    }

    /// `plan` with its poses moved back into workspace and clearance.
    HeatingPlan inside(HeatingPlan plan) const {
        for (Stay& stay : plan.stays)
            putBack(stay.pose);
        return plan;
    }

    /// Steps of the differences of each variable, away from the limits of the workspace.
    Eigen::VectorXd differences(const HeatingPlan& plan) const {
        Eigen::VectorXd out = Eigen::VectorXd::Constant(count(), kLengthStep_m);
        Eigen::Index k = 0;
        for (const Stay& stay : plan.stays) {
            for (const int c : m_geometry.freeCoordinates()) {
                if (stay.pose[c] + kLengthStep_m / scale(c) > m_geometry.limits().upper[c])
                    out[k] = -out[k];
                ++k;
            }
            ++k;
        }
        return out;
    }

private:
    static double scale(int coordinate) { return coordinate < 3 ? 1.0 : kRotationLength_m; }
    Eigen::Index free() const { return static_cast<Eigen::Index>(m_geometry.freeCoordinates().size()); }
    int coordinate(Eigen::Index k) const { return m_geometry.freeCoordinates()[static_cast<std::size_t>(k)]; }
    static double timeScale(const Stay& stay) { return std::max(kTimePerLength_s_m, 20.0 * stay.time_s); }

    void putBack(Vector6d& q) const {
        const RobotLimits& limits = m_geometry.limits();
        for (const int c : m_geometry.freeCoordinates())
            q[c] = std::clamp(q[c], limits.lower[c], limits.upper[c]);
        const double lacking_m = limits.clearance_m - m_geometry.lowestPoint_m(q);
        if (lacking_m > 0.0 && limits.free[kZ])
            q[kZ] = std::min(limits.upper[kZ], q[kZ] + lacking_m);
    }

    const RigGeometry& m_geometry;
};

} // namespace

void HeatingPlan::spend(double time_s, const Stay& next) {
    stays[0].time_s -= time_s;
    if (stays[0].time_s <= 0.0) {
        stays[0] = stays[1];
        stays[1] = next;
    }
}

void HeatingPlan::move(const Pose& motion, const RobotLimits& limits) {
    for (Vector6d* pose : {&stays[0].pose, &stays[1].pose, &rest})
        *pose = movedWithin(*pose, motion, limits);
}

Vector6d movedWithin(const Vector6d& pose, const Pose& motion, const RobotLimits& limits) {
    const Vector6d moved = coordinatesFromPose(motion * poseFromCoordinates(pose));
    Vector6d out = pose;
    for (int k = 0; k < 6; ++k)
        if (limits.free[static_cast<std::size_t>(k)])
            out[k] = std::clamp(moved[k], limits.lower[k], limits.upper[k]);
    return out;
}

PlanCost::PlanCost(const RigGeometry& geometry, const HeatingTask& task)
    : m_geometry(geometry), m_task(task), m_cold_s_K(task.aim_K.size()) {
    for (Eigen::Index i = 0; i < m_cold_s_K.size(); ++i) {
        const HeatRates& rates = task.rates[static_cast<std::size_t>(i)];
        const double max = geometry.maxViewFactor();
        const double F = std::clamp(rates.steadyViewFactor(task.aim_K[i]), 0.0, max - kMinPull);
        m_cold_s_K[i] = 1.0 / (rates.lambda1 * (max - F));
    }
    const double max_s_K = m_cold_s_K.maxCoeff();
    m_cold_s_K = m_cold_s_K.cwiseMax(kFastShare * max_s_K);
    m_hot_s_K = kHotShare * max_s_K;
    const double slowest_s = (task.temperature_K - task.aim_K).cwiseAbs().cwiseProduct(m_cold_s_K).maxCoeff();
    m_travel_s = std::sqrt(kTravelShare) * std::max(slowest_s, kLeastDelay_s);
}

/// View factors at the sampled points of a plan, in the order of the path: a difference changes only few of
/// them.
struct PlanCost::Places {
    template <std::size_t count> struct Values {
        Values() { q.fill(Vector6d::Constant(std::numeric_limits<double>::quiet_NaN())); }

        std::array<Vector6d, count> q;
        std::array<Eigen::VectorXd, count> value;
    };
    Values<3 * (kLegSteps + 1)> F; ///< without shade
    Values<3 * 2 + 1> shares; ///< that shade leaves: at the start, in the middles and at the ends of legs
};

/// Temperatures along a plan, and the residuals from them.
class PlanCost::Walk {
public:
    /// `known`: view factors of a similar plan; `seen`: filled with those of this one.
    Walk(const PlanCost& cost, const Places* known, Places* seen)
        : m_cost(cost), m_geometry(cost.m_geometry), m_task(cost.m_task), m_known(known), m_seen(seen),
          m_at(m_task.from), m_T(m_task.temperature_K), m_toGo_s(m_T.size()), m_F(m_T.size()),
          m_residuals(Eigen::VectorXd::Zero(m_T.size() * (3 * kLegSteps + 2 * kStaySteps + 2) + 3)) {
        for (Eigen::Index i = 0; i < m_T.size(); ++i)
            m_toGo_s[i] = toGo_s(i);
        if (m_geometry.mayShade())
            m_share = shareAt(m_at);
    }

    void go(const Vector6d& to) {
        const double time_s = travelTime_s(m_geometry.limits(), m_at, to);
        if (time_s < kHere_s) {
            m_next += kLegSteps * m_T.size();
            m_place += kLegSteps;
            m_sharePlace += 2;
        } else {
            const Eigen::VectorXd from = m_share;
            Eigen::VectorXd middle, there;
            if (m_geometry.mayShade()) {
                middle = shareAt(0.5 * (m_at + to));
                there = shareAt(to);
            }
            for (int k = 0; k < kLegSteps; ++k) {
                const double part = (k + 0.5) / kLegSteps;
                if (m_geometry.mayShade()) // the parabola through the three
                    m_share = (1.0 - part) * (1.0 - 2.0 * part) * from + 4.0 * part * (1.0 - part) * middle +
                              part * (2.0 * part - 1.0) * there;
                lookAt(m_at + part * (to - m_at));
                step(time_s / kLegSteps);
            }
            m_share = there;
        }
        m_residuals[m_next++] = m_cost.m_travel_s * time_s / std::sqrt(time_s + kShortTravel_s);
        m_at = to;
    }

    void stay(double time_s) {
        if (time_s <= 0.0) {
            m_next += kStaySteps * m_T.size();
            ++m_place;
            return;
        }
        lookAt(m_at);
        // Short steps first, where temperatures change: otherwise plans would exploit the error of a coarse
        // step.
        for (int k = 0; k < kStaySteps; ++k)
            step(time_s * (2 * k + 1) / (kStaySteps * kStaySteps));
    }

    /// If the robot stays at this pose, errors decay to those of its steady temperatures.
    void rest() {
        lookAt(m_at);
        for (Eigen::Index i = 0; i < m_T.size(); ++i) {
            const HeatRates& rates = m_task.rates[static_cast<std::size_t>(i)];
            const double steady_K = rates.steadyTemperature_K(m_F[i]);
            const double tau_s = rates.timeConstant_s(m_task.aim_K[i]);
            // Waiting must not be cheaper than acting: too hot is as steep here as on the path.
            const double error_K = m_T[i] - m_task.aim_K[i];
            const double off_s = error_K > 0.0 ? m_toGo_s[i] : -m_cost.m_cold_s_K[i] * felt_K(error_K);
            const double missed_s = plainToGo_s(i, steady_K);
            m_residuals[m_next++] = std::sqrt(0.5 * tau_s) * (off_s - missed_s);
            m_residuals[m_next++] = std::sqrt(kMissedRest * tau_s) * missed_s;
        }
    }

    Eigen::VectorXd take() { return std::move(m_residuals); }

private:
    /// The values at a place of the plan, known or computed.
    template <class Values, class Compute>
    static void find(const Values* known, Values* seen, std::size_t place, const Vector6d& q,
                     Eigen::VectorXd& value, const Compute& compute) {
        if (known && known->q[place] == q)
            value = known->value[place];
        else
            compute(q, value);
        if (seen) {
            seen->q[place] = q;
            seen->value[place] = value;
        }
    }

    void lookAt(const Vector6d& q) {
        find(m_known ? &m_known->F : nullptr, m_seen ? &m_seen->F : nullptr, m_place++, q, m_F,
             [this](const Vector6d& at, Eigen::VectorXd& F) { m_geometry.unshadedViewFactors(at, F); });
        if (m_geometry.mayShade())
            m_F.array() *= m_share.array();
    }

    Eigen::VectorXd shareAt(const Vector6d& q) {
        Eigen::VectorXd share;
        find(m_known ? &m_known->shares : nullptr, m_seen ? &m_seen->shares : nullptr, m_sharePlace++, q,
             share, [this](const Vector6d& at, Eigen::VectorXd& found) {
                 Eigen::VectorXd F;
                 m_geometry.unshadedViewFactors(at, F);
                 found = m_geometry.roughShares(at, F);
             });
        return share;
    }

    /// Signed time that an object needs to reach its aim. Cold: the time to heat it, in which large errors
    /// grow as a root, so that their squares grow linearly. Hot: steeply.
    double toGo_s(Eigen::Index i) const {
        const double error_K = m_T[i] - m_task.aim_K[i];
        const double size_K = felt_K(error_K);
        if (error_K > 0.0)
            return m_cost.m_hot_s_K * size_K * (1.0 + kHotSteepness_1_K * size_K);
        if (size_K < kFar_K)
            return -m_cost.m_cold_s_K[i] * size_K;
        return -m_cost.m_cold_s_K[i] * std::sqrt((2.0 * size_K - kFar_K) * kFar_K);
    }

    /// Size of an error, reduced within the band in which nothing need be done.
    static double felt_K(double error_K) {
        const double near_K = error_K > 0.0 ? kNearHot_K : kNearCold_K;
        const double size_K = std::abs(error_K);
        return size_K < near_K ? kNearWeight * size_K : size_K - (1.0 - kNearWeight) * near_K;
    }

    /// Proportional to the error: estimates of the far future are too uncertain for more.
    double plainToGo_s(Eigen::Index i, double T_K) const {
        const double error_K = T_K - m_task.aim_K[i];
        return error_K * (error_K > 0.0 ? m_cost.m_hot_s_K : m_cost.m_cold_s_K[i]);
    }

    void step(double dt_s) {
        const double root = std::sqrt(dt_s);
        for (Eigen::Index i = 0; i < m_T.size(); ++i) {
            const HeatRates& rates = m_task.rates[static_cast<std::size_t>(i)];
            m_T[i] += rates.step_K(m_F[i], m_T[i], dt_s);
            const double before_s = std::exchange(m_toGo_s[i], toGo_s(i));
            m_residuals[m_next++] = 0.5 * root * (before_s + m_toGo_s[i]);
        }
    }

    const PlanCost& m_cost;
    const RigGeometry& m_geometry;
    const HeatingTask& m_task;
    const Places* m_known;
    Places* m_seen;
    std::size_t m_place = 0, m_sharePlace = 0;
    Vector6d m_at;
    Eigen::VectorXd m_T;
    Eigen::VectorXd m_toGo_s; ///< N, at m_T
    Eigen::VectorXd m_F;
    Eigen::VectorXd m_share; ///< N, at m_at or on the way from there; empty if nothing shades
    Eigen::VectorXd m_residuals;
    Eigen::Index m_next = 0;
};

Eigen::VectorXd PlanCost::residuals(const HeatingPlan& plan) const {
    return residuals(plan, nullptr, nullptr);
}

Eigen::VectorXd PlanCost::residuals(const HeatingPlan& plan, const Places* known, Places* seen) const {
    Walk walk(*this, known, seen);
    for (const Stay& stay : plan.stays) {
        walk.go(stay.pose);
        walk.stay(stay.time_s);
    }
    walk.go(plan.rest);
    walk.rest();
    return walk.take();
}

PricedPlan PlanCost::improve(const HeatingPlan& plan, int iterations) const {
    const Variables variables(m_geometry);
    const Eigen::Index n = variables.count();
    Places places, tried;
    Eigen::VectorXd now = residuals(plan, nullptr, &places);
    PricedPlan best{plan, now.squaredNorm()};
    double damping = 1e-2;
    for (int i = 0; i < iterations; ++i) {
        Eigen::MatrixXd J(now.size(), n);
        const Eigen::VectorXd differences = variables.differences(best.plan);
        for (Eigen::Index k = 0; k < n; ++k) {
            const Eigen::VectorXd step = differences[k] * Eigen::VectorXd::Unit(n, k);
            J.col(k) = (residuals(variables.moved(best.plan, step), &places, nullptr) - now) / differences[k];
        }
        Eigen::MatrixXd H = J.transpose() * J;
        Eigen::VectorXd f = -J.transpose() * now;
        const double size = H.trace() / static_cast<double>(n) + 1e-9;
        H /= size;
        f /= size;
        Eigen::MatrixXd G;
        Eigen::VectorXd h;
        variables.limits(best.plan, G, h);
        bool better = false;
        for (int attempt = 0; attempt < 3 && !better; ++attempt) {
            const Eigen::MatrixXd damped = H + damping * Eigen::MatrixXd::Identity(n, n);
            const Eigen::VectorXd step = solveBounded(damped, f, G, h).y;
            if (!step.allFinite()) // the costs overflowed
                return best;
            const HeatingPlan next = variables.inside(variables.moved(best.plan, step));
            Eigen::VectorXd there = residuals(next, nullptr, &tried);
            const double cost = there.squaredNorm();
            better = cost < best.cost;
            if (better) {
                const bool done = cost > 0.999 * best.cost;
                best = {next, cost};
                now = std::move(there);
                std::swap(places, tried);
                if (done)
                    return best;
            }
            damping = better ? std::max(1e-8, 0.2 * damping) : 10.0 * damping;
        }
        if (!better)
            break;
    }
    return best;
}

} // namespace bask
