#include "engine/control/controller_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

/// The law integrated by small steps, a method that knows nothing of its solution.
struct Integrated {
    double overshoot = 0.0;
    double settling_s = 0.0;
};

Integrated integrate(const ModelBasedGains& gains, double step_K, double band_K) {
    Integrated out;
    double e = -step_K, v = 0.0;
    const double dt = 1e-4;
    for (int i = 0; i < 4'000'000; ++i) {
        v += 0.5 * dt * (-gains.D * v - gains.K * e);
        e += dt * v;
        v += 0.5 * dt * (-gains.D * v - gains.K * e);
        out.overshoot = std::max(out.overshoot, e / step_K);
        if (std::abs(e) > band_K)
            out.settling_s = (i + 1) * dt;
    }
    return out;
}

} // namespace

TEST(NaturalGains, AreTheSameLaw) {
    const NaturalGains natural = naturalGains({0.2, 0.05});
    EXPECT_NEAR(natural.frequency_rad_s, 0.2236, 1e-4);
    EXPECT_NEAR(natural.damping, 0.4472, 1e-4);
    const ModelBasedGains back = gainsFromNatural(natural);
    EXPECT_NEAR(back.D, 0.2, 1e-15);
    EXPECT_NEAR(back.K, 0.05, 1e-15);
}

// The paper's three gains (over- and underdamped), critical damping and its neighbours.
TEST(StepPrediction, IsThatOfTheIntegratedLaw) {
    for (const ModelBasedGains& gains :
         {ModelBasedGains{0.2, 0.005}, ModelBasedGains{0.2, 0.05}, ModelBasedGains{0.2, 0.5},
          ModelBasedGains{0.2, 0.01}, ModelBasedGains{0.2, 0.0100001}, ModelBasedGains{1.0, 0.05}})
        for (const double band_K : {0.5, 0.05, 3.0}) {
            const StepPrediction said = predictStep(gains, 10.0, band_K);
            const Integrated is = integrate(gains, 10.0, band_K);
            EXPECT_NEAR(said.overshoot, is.overshoot, 1e-4) << gains.D << " " << gains.K;
            EXPECT_NEAR(said.settling_s, is.settling_s, 0.01) << gains.D << " " << gains.K << " " << band_K;
        }
}

TEST(StepPrediction, OfExtremes) {
    EXPECT_TRUE(std::isinf(predictStep({0.0, 0.05}, 10.0, 0.5).settling_s));
    EXPECT_DOUBLE_EQ(predictStep({0.0, 0.05}, 10.0, 0.5).overshoot, 1.0);
    EXPECT_EQ(predictStep({100.0, 0.05}, 0.4, 0.5).settling_s, 0.0); // within the band already
    // Much damping: e = exp(-K t / D).
    EXPECT_NEAR(predictStep({100.0, 1.0}, 10.0, 0.5).settling_s, 100.0 * std::log(20.0), 0.1);
    EXPECT_NEAR(predictSettling_s({0.05, 0.15, 0.0, 0.0}, 10.0, 0.5), std::log(20.0) / 0.05, 1e-9);
    EXPECT_EQ(predictSettling_s({0.05, 0.15, 0.0, 0.0}, 0.1, 0.5), 0.0);
}

} // namespace bask
