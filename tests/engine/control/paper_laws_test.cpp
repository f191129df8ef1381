// The paper's two laws against what its section IV proves of them: one painted circle under the disk, source
// model of the paper, no limits, noise or rounding.

#include "engine/base/units.h"
#include "engine/control/adaptive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace bask {
namespace {

constexpr double kPaperT3_K = 298.15;

/// The circle 10 cm over the source (F = 0.5), at its steady state there.
struct PaperBench {
    std::shared_ptr<const RigGeometry> geometry;
    HeatRates rates;
    Vector6d q = Vector6d::Zero();
    double T_K = 0.0;
    double minF = 1.0, maxF = 0.0;

    explicit PaperBench(double maxSpeed_m_s = 10.0, const Air& air = {}) {
        RobotLimits limits;
        limits.maxSpeed_m_s = maxSpeed_m_s;
        limits.free = {false, false, true, false, false, false};
        geometry = std::make_shared<RigGeometry>(Disk{0.1}, std::vector<Shape>{Disk{0.015}},
                                                 std::vector<Vector6d>{Vector6d::Zero()}, limits);
        const Material painted{"painted", 0.9, 0.9, 904.0, 2700.0, 0.001, 1.0};
        Surroundings surroundings = surroundingsOf(SourceModel::Paper, 473.15, 0.25, kPaperT3_K);
        surroundings.air = air;
        rates = heatRates(painted, surroundings);
        q[kZ] = 0.10;
        T_K = rates.steadyTemperature_K(F());
    }
    double F() const { return geometry->viewFactors(q).F[0]; }
    double v() const { return rates.rate_K_s(F(), T_K); }

    /// One control step held for dt_s (small: Euler will do for the temperature).
    ControlOutput step(Controller& controller, double dt_s) {
        const double F_now = F();
        minF = std::min(minF, F_now);
        maxF = std::max(maxF, F_now);
        const double v_now = rates.rate_K_s(F_now, T_K);
        ControlOutput output = controller.step({0.0, q, 1.0, {{T_K, v_now}}}, dt_s);
        q += dt_s * output.rates;
        T_K += 0.5 * dt_s * (v_now + v());
        return output;
    }
};

ControllerSettings paperSettings(ControllerKind kind) {
    ControllerSettings settings;
    settings.kind = kind;
    settings.damping = 0.0;
    return settings;
}

/// H of one object: zeta^2 / (2 lambda1) + da1^2 / (2 gamma1) + da2^2 / (2 gamma2), a1 = 1 / lambda1, a2 =
/// lambda2 / lambda1, da the errors of the estimates. Along the law dH/dt = -K zeta^2 (paper, section IV-B).
double lyapunov(const AdaptiveGains& gains, const HeatRates& truth, const HeatRates& estimate, double zeta) {
    const double da1 = 1.0 / estimate.lambda1 - 1.0 / truth.lambda1;
    const double da2 = estimate.lambda2 / estimate.lambda1 - truth.lambda2 / truth.lambda1;
    return 0.5 * zeta * zeta / truth.lambda1 + 0.5 * da1 * da1 / gains.gamma1 +
           0.5 * da2 * da2 / gains.gamma2;
}

/// Whether a law finds back from a pose at which the circle does not see the source at all.
bool comesOutOfTheDark(ControllerKind kind, double acceleration_m_s2) {
    RobotLimits limits;
    limits.maxAcceleration_m_s2 = acceleration_m_s2;
    const RigGeometry geometry(Disk{0.1}, {Disk{0.015}}, {Vector6d::Zero()}, limits);
    Vector6d q;
    q << -0.0671, 0.2, 0.061, limits.upper[kThetaX], 0.0, 0.0;
    EXPECT_EQ(geometry.viewFactors(q).F[0], 0.0);
    const PaperBench bench;
    const auto law = makeController(
        paperSettings(kind), {std::make_shared<RigGeometry>(geometry), {bench.rates}, {kPaperT3_K + 5.0}});
    Vector6d rates = Vector6d::Zero();
    for (int k = 0; k < 30 && geometry.viewFactors(q).F[0] < 0.01; ++k) {
        rates = law->step({1.0 * k, q, 1.0, {{kPaperT3_K, 0.0}}, rates}, 1.0).rates;
        q += rates;
        EXPECT_TRUE(geometry.allowed(q));
    }
    return geometry.viewFactors(q).F[0] >= 0.01;
}

Observation moving(const PaperBench& bench, double T_K, double v_K_s) {
    return {0.0, bench.q, 1.0, {{T_K, v_K_s}}};
}

} // namespace

TEST(ModelBasedLaw, FollowsTheAnalyticResponseWithinOnePercentOfTheStep) {
    const struct {
        double K;
        double step_K;
        Air air;
    } cases[] = {{0.005, 0.2, {}}, {0.05, 0.2, {}}, {0.5, 0.05, {}}, {0.005, 0.2, {8.0}}, {0.05, 0.2, {8.0}}};
    for (const auto& [K, step_K, air] : cases) {
        PaperBench bench(10.0, air);
        ControllerSettings settings = paperSettings(ControllerKind::ModelBased);
        settings.modelBased = {0.2, K};
        const double target_K = bench.T_K + step_K;
        const auto controller = makeController(settings, {bench.geometry, {bench.rates}, {target_K}});
        double worst = 0.0;
        const double dt_s = 0.002;
        for (int i = 0; i < 40000; ++i) {
            const double analytic_K = target_K - step_K * errorAfterStep(settings.modelBased, i * dt_s);
            worst = std::max(worst, std::abs(bench.T_K - analytic_K) / step_K);
            ASSERT_FALSE(bench.step(*controller, dt_s).limits.any());
        }
        RecordProperty("worst_of_step_K" + std::to_string(K), std::to_string(worst));
        EXPECT_LT(worst, 0.01) << "K = " << K;
        EXPECT_GT(bench.minF, 0.02) << "K = " << K;
        EXPECT_LT(bench.maxF, 0.98) << "K = " << K;
    }
}

TEST(AdaptiveLaw, ItsLyapunovFunctionNeverIncreases) {
    const struct {
        double factor1, factor2; ///< believed over true
        Air air;
    } cases[] = {{1.0, 1.0, {}}, {2.0, 1.0, {}}, {0.5, 1.0, {}},   {1.0, 3.0, {}},
                 {0.4, 2.5, {}}, {3.0, 0.3, {}}, {0.4, 2.5, {8.0}}};
    for (const auto& [factor1, factor2, air] : cases) {
        PaperBench bench(10.0, air);
        ControllerSettings settings = paperSettings(ControllerKind::Adaptive);
        const HeatRates estimated = bench.rates.scaled(factor1, factor2);
        const double target_K = bench.T_K + 0.6;
        const auto controller = makeController(settings, {bench.geometry, {estimated}, {target_K}});
        const double dt_s = 0.005;
        double before = lyapunov(settings.adaptive, bench.rates, estimated,
                                 bench.v() + settings.adaptive.mu * (bench.T_K - target_K));
        const double start = before;
        int judged = 0;
        for (int i = 0; i < 40000; ++i) {
            const double zeta = bench.v() + settings.adaptive.mu * (bench.T_K - target_K);
            const ControlOutput output = bench.step(*controller, dt_s);
            const double after = lyapunov(settings.adaptive, bench.rates, output.estimate[0],
                                          bench.v() + settings.adaptive.mu * (bench.T_K - target_K));
            // Below the dead zone nothing is adapted, and H may rise by what zeta alone holds.
            if (std::abs(zeta) > AdaptiveController::kZetaDeadZone_K_s) {
                ASSERT_LE(after, before + 1e-9 * start) << factor1 << " " << factor2 << " at " << i * dt_s;
                ++judged;
            }
            before = after;
        }
        EXPECT_GT(judged, 400);
        EXPECT_LT(std::abs(bench.T_K - target_K), 0.3) << factor1 << " " << factor2;
    }
}

// The rate of H is that of the theory, not only its sign.
TEST(AdaptiveLaw, ItsLyapunovFunctionFallsAsKZetaSquared) {
    PaperBench bench;
    const ControllerSettings settings = paperSettings(ControllerKind::Adaptive);
    HeatRates estimated = bench.rates;
    estimated.lambda1 *= 1.5;
    const double target_K = bench.T_K + 0.6;
    const auto controller = makeController(settings, {bench.geometry, {estimated}, {target_K}});
    const double dt_s = 0.002;
    const auto zeta = [&] { return bench.v() + settings.adaptive.mu * (bench.T_K - target_K); };
    const double start = lyapunov(settings.adaptive, bench.rates, estimated, zeta());
    double wanted = 0.0, after = start;
    for (int i = 0; i < 5000; ++i) {
        wanted += settings.adaptive.K * std::pow(zeta(), 2) * dt_s;
        const ControlOutput output = bench.step(*controller, dt_s);
        after = lyapunov(settings.adaptive, bench.rates, output.estimate[0], zeta());
    }
    EXPECT_NEAR(start - after, wanted, 0.01 * wanted);
}

TEST(AdaptiveLaw, EstimatesStayWithinTheirFactor) {
    const PaperBench bench;
    ControllerSettings settings = paperSettings(ControllerKind::Adaptive);
    settings.adaptive.gamma1 = 1e4;
    settings.adaptive.gamma2 = 1e-12;
    for (const double v_K_s : {0.05, -0.05}) {
        const auto controller = makeController(settings, {bench.geometry, {bench.rates}, {bench.T_K + 1e-3}});
        ControlOutput output;
        for (int i = 0; i < 200;
             ++i) // zeta v > 0: a1 grows and a2 falls; with the target far above, the reverse
            output = controller->step(moving(bench, v_K_s > 0.0 ? bench.T_K : bench.T_K + 2.0, v_K_s), 1.0);
        const double range = AdaptiveController::kEstimateRange * (1.0 + 1e-12);
        EXPECT_GE(output.estimate[0].lambda1, bench.rates.lambda1 / range);
        EXPECT_LE(output.estimate[0].lambda1, bench.rates.lambda1 * range);
        const double a2 = output.estimate[0].lambda2 / output.estimate[0].lambda1;
        const double start2 = bench.rates.lambda2 / bench.rates.lambda1;
        EXPECT_GE(a2, start2 / range);
        EXPECT_LE(a2, start2 * range);
        EXPECT_GT(std::abs(std::log(output.estimate[0].lambda1 / bench.rates.lambda1)), 2.9); // it was pushed
    }
}

TEST(AdaptiveLaw, NoiseBelowTheDeadZoneTeachesNothing) {
    const PaperBench bench;
    const ControllerSettings settings = paperSettings(ControllerKind::Adaptive);
    const auto estimateAfter = [&](double zeta_K_s) {
        const auto controller = makeController(settings, {bench.geometry, {bench.rates}, {bench.T_K}});
        ControlOutput output;
        for (int i = 0; i < 100; ++i)
            output = controller->step(moving(bench, bench.T_K, zeta_K_s), 1e-3);
        return output.estimate[0].lambda1;
    };
    EXPECT_DOUBLE_EQ(estimateAfter(0.9 * AdaptiveController::kZetaDeadZone_K_s), bench.rates.lambda1);
    EXPECT_NE(estimateAfter(1.1 * AdaptiveController::kZetaDeadZone_K_s), bench.rates.lambda1);
}

// Catches: a run that stands for ever beside the source with an object that is too cold.
TEST(PaperLaws, ComeOutOfTheDark) {
    for (const double acceleration_m_s2 : {0.0, 0.005}) { // at once, and in four steps
        EXPECT_TRUE(comesOutOfTheDark(ControllerKind::ModelBased, acceleration_m_s2));
        EXPECT_TRUE(comesOutOfTheDark(ControllerKind::Adaptive, acceleration_m_s2));
    }
}

TEST(AdaptiveLaw, StandsStillWhileALimitHoldsTheCommandBack) {
    const auto estimateAfter = [](const PaperBench& bench) {
        const auto controller = makeController(paperSettings(ControllerKind::Adaptive),
                                               {bench.geometry, {bench.rates}, {bench.T_K + 20.0}});
        ControlOutput output;
        for (int i = 0; i < 50; ++i)
            output = controller->step(moving(bench, bench.T_K, 0.02), 1e-3);
        EXPECT_EQ(output.limits.any(), bench.geometry->limits().maxSpeed_m_s < 1.0);
        return output.estimate[0].lambda1;
    };
    const PaperBench slow(0.001);
    EXPECT_DOUBLE_EQ(estimateAfter(slow), slow.rates.lambda1);
    const PaperBench fast;
    EXPECT_NE(estimateAfter(fast), fast.rates.lambda1);
}

} // namespace bask
