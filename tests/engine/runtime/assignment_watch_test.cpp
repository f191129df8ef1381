// Which sensor is on which object, by how both change while a thermal camera looks on.

#include "engine/runtime/assignment_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

/// Two objects before a camera that is wrong by up to 0.5 K and, as a wrong emittance makes it, 4 % of what
/// they are above what they reflect, with sensors that lag.
struct Scene {
    explicit Scene(std::uint64_t seed) : random(seed) {
        std::uniform_real_distribution<double> between(-1.0, 1.0);
        for (int i = 0; i < 2; ++i) {
            off_K[i] = 0.5 * between(random);
            gain[i] = 1.0 + 0.04 * between(random);
        }
        lag_s = 2.5 + 2.5 * between(random);
    }
    /// A reading a second; `isMoved`: each sensor is on the other object now.
    void look(double one_K, double other_K, bool isMoved = false) {
        const double T_K[]{one_K, other_K};
        std::vector<std::optional<CameraOpinion>> seen;
        for (int i = 0; i < 2; ++i) {
            const double on_K = T_K[isMoved ? 1 - i : i];
            felt_K[i] = isBegun ? felt_K[i] + (on_K - felt_K[i]) * -std::expm1(-1.0 / lag_s) : on_K;
            CameraOpinion opinion;
            opinion.contact_K = frozen_K[i].value_or(felt_K[i]) + 0.05 * normal(random);
            opinion.contact_s = now_s;
            opinion.reflected_K = kRoom_K + reflected_K[i];
            opinion.camera_K =
                T_K[i] + off_K[i] + (gain[i] - 1.0) * (T_K[i] - opinion.reflected_K) + 0.02 * normal(random);
            opinion.uncertainty_K = std::hypot(0.2, 0.02 * (T_K[i] - opinion.reflected_K));
            seen.emplace_back(opinion);
        }
        isBegun = true;
        watch.add(now_s, seen);
        now_s += 1.0;
    }

    AssignmentWatch watch{2, 1.0};
    std::mt19937_64 random;
    std::normal_distribution<double> normal;
    double now_s = 0.0, lag_s = 0.0;
    double off_K[2]{}, gain[2]{}, felt_K[2]{kRoom_K, kRoom_K};
    double reflected_K[2]{}; ///< above the room
    std::optional<double> frozen_K[2]{};
    bool isBegun = false;
};

constexpr int kSeeds = 30;

} // namespace

// Catches: a watch that waits until the temperatures themselves disagree beyond doubt.
TEST(AssignmentWatch, TellsSensorsThatAreMovedWithinTenSeconds) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Scene scene(seed);
        for (int k = 0; k < 20; ++k)
            scene.look(kRoom_K + 20.0 + 0.05 * k, kRoom_K + 18.0 + 0.02 * k);
        ASSERT_FALSE(scene.watch.exchanged()) << seed;
        const double moved_s = scene.now_s;
        while (!scene.watch.exchanged() && scene.now_s < moved_s + 30.0)
            scene.look(kRoom_K + 21.0, kRoom_K + 18.4, true);
        ASSERT_TRUE(scene.watch.exchanged()) << seed;
        EXPECT_EQ(scene.watch.exchanged()->one, 0U);
        EXPECT_EQ(scene.watch.exchanged()->other, 1U);
        EXPECT_LE(scene.now_s - moved_s, 10.0) << seed << ", lag " << scene.lag_s;
    }
}

// As where they were swapped while both were cold.
TEST(AssignmentWatch, TellsSensorsThatFollowTheOtherObjectFromTheBeginning) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Scene scene(seed);
        double apart_K = 0.0;
        for (int k = 0; k < 120 && !scene.watch.exchanged(); ++k) {
            apart_K = 0.2 * k;
            scene.look(kRoom_K + 0.3 * k, kRoom_K + 0.1 * k, true);
        }
        ASSERT_TRUE(scene.watch.exchanged()) << seed;
        EXPECT_LE(apart_K, 4.5) << seed;
    }
}

// Catches: lags, wrong emittances and unequal heat taken for an exchange.
TEST(AssignmentWatch, SaysNothingOfSensorsInTheirPlaces) {
    for (std::uint64_t seed = 1; seed <= 10 * kSeeds; ++seed) {
        Scene scene(seed);
        std::uniform_real_distribution<double> rate(-0.3, 0.8);
        std::uniform_real_distribution<double> brighter(-3.0, 3.0);
        double one_K = kRoom_K, other_K = kRoom_K, oneRate = 0.0, otherRate = 0.0;
        double brighter_K[2]{};
        for (int k = 0; k < 300; ++k) {
            if (k % 15 == 0) { // the robot turns
                oneRate = rate(scene.random);
                otherRate = rate(scene.random);
                for (double& step_K : brighter_K)
                    step_K = brighter(scene.random);
            }
            for (int i = 0; i < 2; ++i)
                scene.reflected_K[i] = std::clamp(scene.reflected_K[i] + brighter_K[i], 0.0, 60.0);
            one_K = std::max(kRoom_K, one_K + oneRate);
            other_K = std::max(kRoom_K, other_K + otherRate);
            scene.look(one_K, other_K);
            ASSERT_FALSE(scene.watch.exchanged()) << seed << ", " << k << " s";
        }
    }
}

// Catches: a camera whose error drifts by kelvins within half a minute, beside sensors that agree with it.
TEST(AssignmentWatch, GoesByTheTemperaturesTooWhereTheyAreFarApart) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Scene scene(seed);
        for (int k = 0; k < 120; ++k) {
            scene.off_K[0] -= k > 40 && k < 80 ? 0.04 : 0.0;
            scene.off_K[1] += k > 40 && k < 80 ? 0.04 : 0.0;
            scene.look(kRoom_K + 5.0 + 0.06 * k, kRoom_K + 10.0 + 0.04 * k);
            ASSERT_FALSE(scene.watch.exchanged()) << seed << ", " << k << " s";
        }
    }
}

// Catches: one sensor that comes off, sensors that stand still, objects that nothing tells apart.
TEST(AssignmentWatch, SaysNothingOfWhatIsNoExchange) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Scene off(seed), still(seed), equal(seed);
        for (int k = 0; k < 60; ++k) {
            const double one_K = kRoom_K + 20.0 + 0.05 * k, other_K = kRoom_K + 15.0;
            if (k > 30)
                off.frozen_K[0] = kRoom_K + 20.0 * std::exp(-(k - 30) / 5.0);
            off.look(one_K, other_K);
            if (k == 30) {
                still.frozen_K[0] = one_K;
                still.frozen_K[1] = other_K;
            }
            still.look(one_K + 0.3 * std::max(0, k - 30), other_K + 0.1 * std::max(0, k - 30));
            equal.look(one_K, one_K, k > 30);
            EXPECT_FALSE(off.watch.exchanged()) << seed << ", " << k << " s";
            EXPECT_FALSE(still.watch.exchanged()) << seed << ", " << k << " s";
            EXPECT_FALSE(equal.watch.exchanged()) << seed << ", " << k << " s";
        }
    }
}

TEST(AssignmentWatch, ForgetsWhatWasWhenItIsReset) {
    Scene scene(1);
    for (int k = 0; k < 20; ++k)
        scene.look(kRoom_K + 20.0, kRoom_K + 15.0);
    scene.watch.reset(); // a person exchanges them
    for (int k = 0; k < 30; ++k) {
        scene.look(kRoom_K + 20.0, kRoom_K + 15.0, true);
        if (k == 0) {
            scene.felt_K[0] = kRoom_K + 15.0;
            scene.felt_K[1] = kRoom_K + 20.0;
            scene.watch.reset();
        }
        EXPECT_FALSE(scene.watch.exchanged()) << k;
    }
}

TEST(AssignmentWatch, ABrokenContractThrows) {
    AssignmentWatch watch(2, 1.0);
    EXPECT_THROW(watch.add(0.0, {}), std::invalid_argument);
}

} // namespace bask
