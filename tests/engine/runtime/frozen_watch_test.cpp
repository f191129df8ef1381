// Whether a sensor that stops is told, as the safety monitor asks: soon, before its object is far beyond its
// target, and never of one that is fine. An object is held at its target by what its sensor says.

#include "engine/runtime/frozen_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>
#include <random>

namespace bask {
namespace {

constexpr double kRoomOfHeld_K = 298.15;
constexpr double kNever_s = std::numeric_limits<double>::infinity();

struct Sensor {
    double noise_K, resolution_K, period_s;
};

std::ostream& operator<<(std::ostream& out, const Sensor& sensor) {
    return out << sensor.noise_K << " K, steps of " << sensor.resolution_K << " K, " << sensor.period_s
               << " s";
}

/// PLA of 1 mm, a third filled, before a plate of 200 degC: it warms by warming_K_s at most. It waits for
/// wait_s after its sensor was zeroed, then the run begins at 0 s.
struct HeldObject {
    Sensor sensor;
    unsigned seed = 1;
    double warming_K_s = 0.45;
    double loss_1_s = 1.0 / 118.0;
    double estimate = 1.0;  ///< of the power, over the true one
    double lag_s = 0.0;     ///< of its sensor
    double repeats_s = 0.0; ///< its device takes a new value so often
    double target_K = kRoomOfHeld_K + 15.0;
    double raisedTo_K = kRoomOfHeld_K + 35.0;
    double raised_s = kNever_s;
    double wait_s = 20.0;

    struct Seen {
        double told_s = kNever_s;
        double overTarget_K = -1e9; ///< highest, of the object itself
    };
    Seen run(double frozen_s, double end_s) const {
        FrozenWatch frozen({0.25 * loss_1_s, 15.0 * loss_1_s}, kRoomOfHeld_K);
        frozen.restAt(-wait_s, kRoomOfHeld_K);
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        Seen seen;
        double T = kRoomOfHeld_K, felt = T, power_K_s = 0.0, value = T, taken_s = -1e9;
        const int count = static_cast<int>(std::lround((end_s + wait_s) / sensor.period_s));
        for (int i = 1; i <= count; ++i) {
            const double t = -wait_s + i * sensor.period_s;
            T += (power_K_s - loss_1_s * (T - kRoomOfHeld_K)) * sensor.period_s;
            felt += (T - felt) * (lag_s > 0.0 ? -std::expm1(-sensor.period_s / lag_s) : 1.0);
            const double read = felt + sensor.noise_K * normal(random);
            if (t < frozen_s && t - taken_s > repeats_s - 1e-9) {
                value = std::round(read / sensor.resolution_K) * sensor.resolution_K;
                taken_s = t;
            }
            const double aim_K = t >= raised_s ? raisedTo_K : target_K;
            if (t > 0.0) {
                const double wanted_K_s =
                    std::clamp((aim_K - value) / 8.0 + loss_1_s * (value - kRoomOfHeld_K), 0.0, warming_K_s);
                const double most_K_s = warming_K_s / 15.0 * sensor.period_s;
                power_K_s += std::clamp(wanted_K_s - power_K_s, -most_K_s, most_K_s);
            }
            seen.overTarget_K = std::max(seen.overTarget_K, T - aim_K);
            frozen.add(t, value, estimate * power_K_s);
            if (t > 0.0 && frozen.missing_K() != 0.0) {
                seen.told_s = t;
                break;
            }
        }
        return seen;
    }
};

} // namespace

// Catches a robot that goes nearer and nearer by a reading that stays while its object warms.
TEST(FrozenWatch, FindsASensorThatFreezesOnTheWay) {
    for (const Sensor& sensor :
         {Sensor{0.02, 0.01, 0.1}, Sensor{0.02, 0.1, 0.1}, Sensor{0.1, 0.01, 0.1}, Sensor{0.1, 0.1, 0.1},
          Sensor{0.3, 0.01, 0.1}, Sensor{0.3, 0.1, 0.1}, Sensor{0.02, 0.01, 0.5}, Sensor{0.02, 0.1, 0.5},
          Sensor{0.1, 0.01, 0.5}, Sensor{0.1, 0.1, 0.5}, Sensor{0.3, 0.01, 0.5}, Sensor{0.3, 0.1, 0.5},
          Sensor{0.02, 0.1, 1.0}}) {
        const HeldObject::Seen seen = HeldObject{sensor}.run(20.0, 60.0);
        EXPECT_LT(seen.told_s, 20.0 + 12.0) << sensor;
        EXPECT_LT(seen.overTarget_K, 0.0) << sensor;
    }
}

// While the robot comes near, the reading has hardly changed yet.
TEST(FrozenWatch, FindsASensorThatFreezesAsTheRobotComesNear) {
    for (const Sensor& sensor : {Sensor{0.02, 0.01, 0.1}, Sensor{0.02, 0.1, 0.1}, Sensor{0.3, 0.1, 0.1},
                                 Sensor{0.02, 0.1, 0.5}, Sensor{0.3, 0.01, 0.5}, Sensor{0.02, 0.1, 1.0}}) {
        const HeldObject::Seen seen = HeldObject{sensor}.run(6.0, 60.0);
        EXPECT_LT(seen.told_s, 6.0 + 40.0) << sensor;
        EXPECT_LT(seen.overTarget_K, 0.0) << sensor;
    }
}

// Catches a sensor that is known too little before a run that begins at once, and is then never found.
TEST(FrozenWatch, FindsASensorThatFreezesSoonAfterItWasZeroed) {
    for (const double frozen_s : {8.0, 10.0, 15.0}) {
        HeldObject object{{0.02, 0.1, 1.0}};
        object.wait_s = 1.0;
        const HeldObject::Seen seen = object.run(frozen_s, 100.0);
        EXPECT_LT(seen.told_s, frozen_s + 30.0) << frozen_s;
        EXPECT_LT(seen.overTarget_K, 0.0) << frozen_s;
    }
}

// A sensor without noise says the same at rest, frozen or not, until its object is to be warmer.
TEST(FrozenWatch, FindsASensorThatFrozeAtRestBeforeItsObjectIsHot) {
    for (const Sensor& sensor : {Sensor{0.02, 0.01, 0.1}, Sensor{0.02, 0.1, 0.1}, Sensor{0.02, 0.5, 0.5},
                                 Sensor{0.3, 0.1, 0.5}, Sensor{0.02, 0.1, 1.0}}) {
        HeldObject object{sensor};
        object.raised_s = 155.0;
        const HeldObject::Seen seen = object.run(150.0, 275.0);
        EXPECT_LT(seen.told_s, 155.0 + 75.0) << sensor;
        EXPECT_LT(seen.overTarget_K, 5.0) << sensor;
    }
}

// Steps of half a kelvin tell less: found later, but found.
TEST(FrozenWatch, FindsACoarseSensorThatFreezesOnTheWay) {
    for (const double period_s : {0.5, 1.0}) {
        const HeldObject::Seen seen = HeldObject{{0.02, 0.5, period_s}}.run(20.0, 100.0);
        EXPECT_LT(seen.told_s, 20.0 + 40.0) << period_s;
        EXPECT_LT(seen.overTarget_K, 5.0) << period_s;
    }
}

// Catches alarms for sensors that do nothing but repeat what is so: coarse ones at rest, slow ones, devices
// that are asked more often than they measure, and estimates that are wrong.
TEST(FrozenWatch, IsSilentInHealthyRuns) {
    int runs = 0;
    for (const double noise_K : {0.002, 0.02, 0.1, 0.3})
        for (const double resolution_K : {0.01, 0.1, 0.5})
            for (const double period_s : {0.5, 1.0})
                for (const double estimate : {0.4, 1.0, 2.5})
                    for (const double slow_s : {0.0, 5.0, 15.0}) {
                        HeldObject object{{noise_K, resolution_K, period_s}};
                        object.seed = static_cast<unsigned>(++runs);
                        object.estimate = estimate;
                        object.lag_s = slow_s;
                        object.repeats_s = slow_s == 5.0 ? 3.0 : 0.0;
                        object.target_K = kRoomOfHeld_K + 6.0 + runs % 30;
                        object.raisedTo_K = kRoomOfHeld_K + 6.0 + 7 * runs % 40;
                        object.raised_s = 90.0;
                        EXPECT_EQ(object.run(kNever_s, 150.0).told_s, kNever_s)
                            << object.sensor << ", " << estimate << ", " << slow_s << " s, to "
                            << object.target_K << " and " << object.raisedTo_K << " K";
                    }
    EXPECT_GE(runs, 200);
}

// Catches a device that repeats its readings for seconds while a quick object warms.
TEST(FrozenWatch, IsSilentWhereADeviceRepeatsItsReadings) {
    for (const double period_s : {0.1, 1.0})
        for (const double repeats_s : {1.0, 2.0, 3.0, 5.0})
            for (const double constant_s : {15.0, 30.0, 60.0})
                for (const double warming_K_s : {1.0, 2.0, 3.0}) {
                    HeldObject object{Sensor{0.02, 0.1, period_s}};
                    object.repeats_s = repeats_s;
                    object.loss_1_s = 1.0 / constant_s;
                    object.warming_K_s = warming_K_s;
                    object.raised_s = 60.0;
                    EXPECT_EQ(object.run(kNever_s, 120.0).told_s, kNever_s)
                        << object.sensor << ", " << repeats_s << " s, " << constant_s << " s, " << warming_K_s
                        << " K/s";
                }
}

// Catches a loss of the position that leaves what was expected before.
TEST(FrozenWatch, BeginsAnewWhereTheHeatIsNotKnown) {
    FrozenWatch watch({0.002, 0.13}, kRoomOfHeld_K);
    watch.restAt(0.0, kRoomOfHeld_K);
    double t = 0.0;
    for (; t < 60.0; t += 1.0)
        watch.add(t, std::round(10.0 * (kRoomOfHeld_K + 0.1 * t)) / 10.0, 0.2);
    EXPECT_EQ(watch.missing_K(), 0.0);
    for (; t < 75.0; t += 1.0)
        watch.add(t, kRoomOfHeld_K + 6.0, 0.2);
    EXPECT_GT(watch.missing_K(), FrozenWatch::kMin_K);
    watch.add(t, kRoomOfHeld_K + 6.0, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(watch.missing_K(), 0.0);
}

} // namespace bask
