// Plans of the level servo against the heat balance itself, and its stability argument.

#include "engine/control/heating_plan.h"
#include "engine/control/velocity_solve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

/// Two painted disks of different thickness over a hot disk.
struct PlannedRig {
    std::shared_ptr<const RigGeometry> geometry;
    HeatingTask task;

    PlannedRig() {
        Vector6d left = Vector6d::Zero(), right = Vector6d::Zero();
        left[kX] = -0.04;
        right[kX] = 0.04;
        geometry = std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>{Disk{0.015}, Disk{0.015}},
                                                 std::vector<Vector6d>{left, right}, RobotLimits());
        const Surroundings surroundings = surroundingsOf(SourceModel::Gray, 473.15, 0.25, kRoom_K);
        for (const double thickness_m : {0.0005, 0.001})
            task.rates.push_back(
                heatRates({"painted", 0.9, 0.9, 904.0, 2700.0, thickness_m, 1.0}, surroundings));
        task.from[kZ] = 0.2;
        task.temperature_K = Eigen::Vector2d::Constant(kRoom_K);
    }
    /// The task's aim becomes what `pose` holds.
    void aimAt(const Vector6d& pose) {
        const Eigen::VectorXd F = geometry->viewFactors(pose).F;
        task.aim_K.resize(2);
        for (Eigen::Index i = 0; i < 2; ++i)
            task.aim_K[i] = task.rates[static_cast<std::size_t>(i)].steadyTemperature_K(F[i]);
    }
    PlanCost cost() const { return {*geometry, task}; }
    /// Moves straight to `goal` for dt_s under the exact heat balance.
    void move(const Vector6d& goal, double dt_s) {
        const Vector6d rates = velocityTowards(*geometry, task.from, goal, dt_s).rates;
        constexpr int kSteps = 50;
        for (int k = 0; k < kSteps; ++k) {
            task.from += dt_s / kSteps * rates;
            const Eigen::VectorXd F = geometry->viewFactors(task.from).F;
            for (Eigen::Index i = 0; i < 2; ++i)
                task.temperature_K[i] +=
                    dt_s / kSteps *
                    task.rates[static_cast<std::size_t>(i)].rate_K_s(F[i], task.temperature_K[i]);
        }
    }
};

Vector6d pose(double x, double z) {
    Vector6d q = Vector6d::Zero();
    q[kX] = x;
    q[kZ] = z;
    return q;
}

} // namespace

// Catches an optimisation that returns a worse plan, or one outside workspace and clearance.
TEST(HeatingPlan, ImprovementNeverMakesWorseAndStaysInside) {
    PlannedRig rig;
    rig.aimAt(pose(0.02, 0.08));
    for (const double x : {-0.2, 0.0, 0.2})
        for (const double z : {0.01, 0.1, 0.3}) {
            const HeatingPlan plan{{Stay{pose(x, z), 20.0}, Stay{pose(0.0, 0.05), 5.0}}, pose(0.02, 0.08)};
            const PricedPlan better = rig.cost().improve(plan, 6);
            EXPECT_LE(better.cost, rig.cost().of(plan));
            EXPECT_NEAR(better.cost, rig.cost().of(better.plan), 1e-9 * better.cost);
            for (const Stay& stay : better.plan.stays) {
                EXPECT_TRUE(rig.geometry->allowed(stay.pose));
                EXPECT_GE(stay.time_s, 0.0);
            }
        }
}

// Catches a cost that does not fall along the way: then the argument for stability in level_servo.h is wrong.
TEST(HeatingPlan, TheCostFallsAsThePlanIsFollowed) {
    PlannedRig rig;
    const Vector6d rest = pose(0.02, 0.08);
    rig.aimAt(rest);
    const HeatingPlan plan{{Stay{pose(0.03, 0.02), 20.0}, Stay{rest, 10.0}}, rest};
    PricedPlan now = rig.cost().improve(plan, 10);
    const double first = now.cost;
    for (int step = 0; step < 400; ++step) {
        const double travel_s = travelTime_s(rig.geometry->limits(), rig.task.from, now.plan.stays[0].pose);
        rig.move(now.plan.stays[0].pose, 1.0);
        if (travel_s <= 0.5)
            now.plan.spend(1.0 - travel_s, {rest, 10.0});
        const PricedPlan next = rig.cost().improve(now.plan, 4);
        EXPECT_LE(next.cost, 1.02 * now.cost + 1e-3 * first) << "step " << step; // its grid of times moves
        now = next;
    }
    EXPECT_LT(now.cost, 1e-3 * first);
    EXPECT_LT((rig.task.temperature_K - rig.task.aim_K).cwiseAbs().maxCoeff(), 0.1);
}

// Catches a prediction that is not the heat balance: resting for ever, errors decay from where they are.
TEST(HeatingPlan, RestingCostsTheDecayOfTheErrors) {
    PlannedRig rig;
    const Vector6d rest = pose(0.0, 0.1);
    rig.aimAt(rest);
    rig.task.from = rest;
    rig.task.temperature_K = rig.task.aim_K;
    const HeatingPlan plan{{Stay{rest, 0.0}, Stay{rest, 0.0}}, rest};
    EXPECT_NEAR(rig.cost().of(plan), 0.0, 1e-9);
    std::array<double, 3> root{};
    for (double& each : root) {
        rig.task.temperature_K[0] -= 1.0;
        each = std::sqrt(rig.cost().of(plan));
    }
    EXPECT_NEAR(root[2] - root[1], root[1] - root[0], 1e-6 * root[0]);
    EXPECT_GT(root[0], 0.5 * (root[1] - root[0])); // a kelvin is no small error
}

// Catches a plan whose costs are beyond all bounds, which ended runs by an internal fault: a sensor that
// comes off makes the estimates of an object's heating absurd.
TEST(HeatingPlan, AbsurdRatesMakeNoPoseThatIsNotFinite) {
    for (const double absurd : {1e30, 1e160, 1e300}) {
        PlannedRig rig;
        rig.aimAt(pose(0.01, 0.08));
        rig.task.rates[0].lambda1 *= absurd;
        rig.task.rates[1].lambda2 *= absurd;
        const HeatingPlan plan{{Stay{pose(0.1, 0.1), 20.0}, Stay{pose(0.0, 0.05), 5.0}}, pose(0.02, 0.05)};
        PricedPlan priced{};
        EXPECT_NO_THROW(priced = rig.cost().improve(plan, 10)) << absurd;
        for (const Stay& stay : priced.plan.stays)
            EXPECT_TRUE(rig.geometry->allowed(stay.pose)) << absurd;
    }
}

} // namespace bask
