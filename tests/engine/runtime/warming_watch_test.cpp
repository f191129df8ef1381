// Whether an object that follows its heat is told from one whose sensor does not, with readings as sensors
// give them.

#include "engine/base/units.h"
#include "engine/runtime/source_watch.h"
#include "engine/runtime/warming_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <random>

namespace bask {
namespace {

/// Of an object of this time constant by radiation: a quarter of that, and moving air.
LossRange lossesOf(double timeConstant_s) {
    return {0.25 / timeConstant_s, 15.0 / timeConstant_s};
}

/// dT/dt = power - loss (T - 298), read with noise and a resolution once a second.
struct Object {
    double noise_K = 0.02, resolution_K = 0.1;
    double loss_1_s = 1.0 / 450.0;
    double estimate = 1.0; ///< of the power, over the true one
    double lag_s = 0.0;    ///< of its sensor
    bool isFree = false;   ///< its losses grow with the 1.25th power, as much at 50 K
    double uncertainty_K = 0.0;

    /// When an alarm was given, s: a contradiction for 30 s, or the same value for so long. Infinite: never.
    double alarm_s(const std::function<double(double)>& power_K_s,
                   const std::function<double(double, double)>& reading = {}) const {
        WarmingWatch watch(lossesOf(450.0), 298.0, SafetySpec().warming_K);
        watch.restAt(0.0, 298.0);
        std::mt19937_64 random(5);
        std::normal_distribution<double> noise(0.0, noise_K);
        double T = 298.0, felt = 298.0, followed_s = 0.0;
        for (double t = 1.0; t < 1500.0; t += 1.0) {
            const double over_K = T - 298.0;
            T += power_K_s(t) -
                 loss_1_s * over_K * (isFree ? std::pow(std::max(over_K, 0.0) / 50.0, 0.25) : 1.0);
            felt += (T - felt) * (lag_s > 0.0 ? -std::expm1(-1.0 / lag_s) : 1.0);
            double value = felt + noise(random);
            if (resolution_K > 0.0)
                value = std::round(value / resolution_K) * resolution_K;
            watch.add(t, reading ? reading(t, value) : value, estimate * power_K_s(t), uncertainty_K);
            if (!watch.unfollowed())
                followed_s = t;
            if (t - followed_s >= 30.0 || (watch.sameFor_s() >= 30.0 && watch.unfollowedWhileSame(0.5)))
                return t;
        }
        return std::numeric_limits<double>::infinity();
    }
};

/// When a rise was told that nothing explains, s; as above.
double foreignHeat_s(const Object& object, const std::function<double(double)>& power_K_s,
                     const std::function<double(double)>& foreign_K_s) {
    WarmingWatch watch(lossesOf(450.0), 298.0, SafetySpec().warming_K);
    watch.restAt(0.0, 298.0);
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0.0, object.noise_K);
    double T = 298.0, felt = 298.0;
    for (double t = 1.0; t < 400.0; t += 1.0) {
        T += power_K_s(t) + foreign_K_s(t) - object.loss_1_s * (T - 298.0);
        felt += (T - felt) * (object.lag_s > 0.0 ? -std::expm1(-1.0 / object.lag_s) : 1.0);
        double value = felt + noise(random);
        if (object.resolution_K > 0.0)
            value = std::round(value / object.resolution_K) * object.resolution_K;
        watch.add(t, value, object.estimate * power_K_s(t), object.uncertainty_K);
        if (watch.foreignHeat())
            return t;
    }
    return std::numeric_limits<double>::infinity();
}

double approach(double t) { // the robot comes near in ten seconds and settles by drawing back
    return t < 20.0 ? 0.0 : t < 30.0 ? 0.012 * (t - 20.0) : t < 130.0 ? 0.12 : 0.06;
}

} // namespace

// Catches alarms for objects that do nothing but obey: other losses, a wrong belief, coarse, noisy and slow
// sensors.
TEST(WarmingWatch, GivesNoAlarmForAnObjectThatFollows) {
    for (const double loss_1_s : {1.0 / 1500.0, 1.0 / 450.0, 1.0 / 90.0})
        for (const double estimate : {0.4, 1.0, 2.5})
            for (const double resolution_K : {0.0, 0.1, 0.5})
                for (const double noise_K : {0.0, 0.02, 0.3})
                    for (const double lag_s : {0.0, 15.0}) {
                        const Object object{noise_K, resolution_K, loss_1_s, estimate, lag_s};
                        EXPECT_GT(object.alarm_s(approach), 1500.0)
                            << loss_1_s << ' ' << estimate << ' ' << resolution_K << ' ' << noise_K << ' '
                            << lag_s;
                    }
}

// Catches alarms for objects that only the source heats: estimates that are wrong by a factor of four, an
// uneven source, and coarse, noisy and slow sensors.
TEST(WarmingWatch, TheSourceExplainsWhatItHeats) {
    const auto none = [](double) { return 0.0; };
    const auto uneven = [](double t) { return approach(t) * (1.0 + 0.1 * std::sin(0.3 * t)); };
    for (const double strength : {1.0, 6.0})
        for (const double estimate : {0.26, 1.0, 4.0})
            for (const double resolution_K : {0.0, 0.1, 1.0})
                for (const double noise_K : {0.0, 0.3})
                    for (const double lag_s : {0.0, 5.0, 15.0}) {
                        const Object object{noise_K, resolution_K, 1.0 / 450.0, estimate, lag_s};
                        EXPECT_GT(foreignHeat_s(
                                      object, [&](double t) { return strength * uneven(t); }, none),
                                  1500.0)
                            << strength << ' ' << estimate << ' ' << resolution_K << ' ' << noise_K << ' '
                            << lag_s;
                    }
}

// Catches an object that something else heats and that is not told before it is hot.
TEST(WarmingWatch, FindsAnObjectThatSomethingElseHeats) {
    for (const double lag_s : {0.0, 5.0})
        for (const double noise_K : {0.02, 0.3}) {
            const Object object{noise_K, 0.1, 1.0 / 450.0, 1.0, lag_s};
            const auto torch = [](double t) { return t < 300.0 ? 0.0 : 1.7; };
            const double told_s = foreignHeat_s(object, approach, torch);
            EXPECT_GT(told_s, 300.0);
            EXPECT_LT(told_s, 318.0) << lag_s << ' ' << noise_K;
        }
}

// Catches a thermal camera's error near the hot source taken for heat from elsewhere, and an object that is
// heated by far more.
TEST(WarmingWatch, WhatACameraErrsByIsNotHeatedOtherwise) {
    const auto none = [](double) { return 0.0; };
    const auto error = [](double t) { return t > 100.0 && t < 120.0 ? 0.3 : 0.0; };
    Object object{0.02, 0.0};
    EXPECT_LT(foreignHeat_s(object, none, error), 130.0);
    object.uncertainty_K = 2.0;
    EXPECT_GT(foreignHeat_s(object, none, error), 1500.0);
    EXPECT_LT(foreignHeat_s(object, none, [](double t) { return t > 100.0 ? 1.7 : 0.0; }), 130.0);
}

// Catches readings that come seldom and are each taken for the first one after a stop.
TEST(WarmingWatch, FindsForeignHeatInSlowReadings) {
    for (const double period_s : {1.0, 6.0, 10.0}) {
        WarmingWatch watch(lossesOf(450.0), 298.0, SafetySpec().warming_K);
        watch.restAt(0.0, 298.0);
        double T = 298.0, told_s = 0.0;
        for (double t = period_s; t < 400.0 && told_s == 0.0; t += period_s) {
            T += period_s * (t > 300.0 ? 1.7 : 0.05);
            watch.add(t, T, 0.05);
            if (watch.foreignHeat())
                told_s = t;
        }
        EXPECT_GT(told_s, 300.0) << period_s;
        EXPECT_LT(told_s, 300.0 + std::max(20.0, 4.0 * period_s)) << period_s;
    }
}

// Catches a sensor that stopped for a while and comes back: it catches up at once.
TEST(WarmingWatch, ASensorThatComesBackIsNotHeatedOtherwise) {
    WarmingWatch watch(lossesOf(450.0), 298.0, SafetySpec().warming_K);
    watch.restAt(0.0, 298.0);
    double T = 298.0;
    for (double t = 1.0; t < 300.0; t += 1.0) {
        T += 0.12 - (T - 298.0) / 450.0;
        if (t < 60.0 || t > 100.0)
            watch.add(t, T, 0.12);
        else
            watch.add(t, 304.0, 0.12);
        ASSERT_FALSE(watch.foreignHeat()) << t;
    }
}

// Catches a deviation that is told of readings from long ago, or that a camera's uncertainty explains.
TEST(WarmingWatch, ADeviationIsOfNowAndBeyondTheUncertainty) {
    const auto unexplained_K = [](double uncertainty_K, double missing_s) {
        WarmingWatch watch(lossesOf(450.0), 298.0, SafetySpec().warming_K);
        watch.restAt(0.0, 298.0);
        double T = 298.0;
        for (double t = 1.0; t < 240.0 + missing_s; t += 1.0) {
            T += 0.12 - (T - 298.0) / 450.0;
            const double value = T - std::max(0.0, 0.1 * (t - 200.0));
            watch.add(t, t < 240.0 ? std::optional(value) : std::nullopt, 0.12, uncertainty_K);
        }
        return watch.unexplained_K(watch, 36.0);
    };
    EXPECT_LT(unexplained_K(0.0, 0.0).value(), -1.0);
    EXPECT_LT(unexplained_K(0.0, 3.0).value(), -1.0);
    EXPECT_FALSE(unexplained_K(0.0, 20.0));
    EXPECT_EQ(unexplained_K(2.0, 0.0).value(), 0.0);
}

// Catches losses that are taken for linear, or for the fourth power, and are of air that rises by itself.
TEST(WarmingWatch, GivesNoAlarmInFreeConvection) {
    const auto hot = [](double t) { return 6.0 * approach(t); }; // to 100 K over the room
    for (const double loss_1_s : {1.0 / 900.0, 1.0 / 450.0, 1.0 / 90.0})
        for (const double estimate : {0.4, 1.0, 2.5})
            for (const bool isHot : {false, true}) {
                Object object{0.02, 0.01, loss_1_s, estimate};
                object.isFree = true;
                EXPECT_GT(isHot ? object.alarm_s(hot) : object.alarm_s(approach), 1500.0)
                    << loss_1_s << ' ' << estimate << ' ' << isHot;
            }
}

// Catches an object that is far thicker than declared, and warms, taken for one whose sensor fell off.
TEST(WarmingWatch, GivesNoAlarmForAnObjectThatTakesHardlyAnything) {
    const Object object{0.02, 0.1, 1.0 / 4500.0, 8.0};
    EXPECT_GT(object.alarm_s([](double t) { return 0.1 * approach(t); }), 1500.0);
}

// Catches a thermal camera's error near the hot source taken for what the object does: it reads 1 K too much
// while the object is near, and less far away.
TEST(WarmingWatch, GivesNoAlarmForWhatACameraErrsBy) {
    const auto near = [](double t) { return t > 20.0 && t < 45.0 ? 0.4 : 0.0; };
    const auto reading = [&](double t, double value) { return value + 2.5 * near(t); };
    Object object{0.02, 0.0};
    EXPECT_LT(object.alarm_s(near, reading), 400.0);
    object.uncertainty_K = 0.4;
    EXPECT_GT(object.alarm_s(near, reading), 1500.0);
    const auto strong = [](double t) { return 3.0 * approach(t); };
    EXPECT_LT(object.alarm_s(strong, [](double, double) { return 298.0; }), 400.0);
}

// Catches a sensor that is off its object and shows the room.
TEST(WarmingWatch, FindsAnObjectThatDoesNotWarm) {
    const Object object;
    EXPECT_LT(object.alarm_s(approach, [](double, double value) { return value > 0.0 ? 298.0 : value; }),
              170.0);
}

// The reading stays below the target, so the robot goes nearer. Catches a frozen sensor while its object
// warms.
TEST(WarmingWatch, FindsASensorThatIsFrozen) {
    for (const double from_s : {60.0, 80.0}) {
        const Object object;
        double kept_K = 0.0;
        const auto power_K_s = [&](double t) {
            return approach(t) * (t < from_s ? 1.0 : 1.0 + (t - from_s) / 60.0);
        };
        EXPECT_LT(
            object.alarm_s(power_K_s,
                           [&](double t, double value) { return t < from_s ? kept_K = value : kept_K; }),
            from_s + 60.0);
    }
}

// A light object that had just begun to cool, so that its rate before explains that it does not warm. Catches
// a robot that goes nearer and nearer by a reading that stays.
TEST(WarmingWatch, FindsASensorThatFreezesOnTheWay) {
    constexpr double kTime_s = 12.0, kFrozen_s = 40.0, kPeriod_s = 0.1;
    WarmingWatch watch(lossesOf(kTime_s), 298.0, SafetySpec().warming_K);
    watch.restAt(0.0, 298.0);
    double T = 298.0, kept_K = T, found_s = 1e9;
    for (double t = kPeriod_s; t < 60.0 && found_s > 1e8; t += kPeriod_s) {
        const double power_K_s = t < kFrozen_s - 3.0 ? 1.5
                                 : t < kFrozen_s     ? 0.1
                                                     : 0.1 + 0.3 * (t - kFrozen_s);
        T += kPeriod_s * (power_K_s - (T - 298.0) / kTime_s);
        if (t < kFrozen_s)
            kept_K = std::round(T / 0.02) * 0.02;
        watch.add(t, kept_K, power_K_s);
        if (watch.sameFor_s() >= 5.0 && watch.unfollowedWhileSame(0.5))
            found_s = t;
    }
    EXPECT_GT(found_s, kFrozen_s + 4.9);
    EXPECT_LT(found_s, kFrozen_s + 14.0);
}

// At rest in the heat, with noise below its sensor's step, so that only the very same reading tells. Its
// rates before explain each span of the rest by itself. Catches heat that grows, before a reading that needs
// it to be the same.
TEST(WarmingWatch, FindsAFrozenSensorWhoseObjectIsHeatedALittleMore) {
    constexpr double kFrozen_s = 600.0;
    const Object object{0.03, 0.1, 1.0 / 120.0};
    double kept_K = 0.0;
    const auto power_K_s = [&](double t) {
        return 0.4 * (t < kFrozen_s ? 1.0 : 1.0 + 0.2 * std::min(1.0, (t - kFrozen_s) / 100.0));
    };
    const double found_s = object.alarm_s(
        power_K_s, [&](double t, double value) { return t < kFrozen_s ? kept_K = value : kept_K; });
    EXPECT_GT(found_s, kFrozen_s + 29.0);
    EXPECT_LT(found_s, kFrozen_s + 130.0);
}

// Catches a sensor that comes off a slow object which is hardly warm: too slowly for a jump, and no change of
// more than 2 K was to come.
TEST(WarmingWatch, FindsASensorThatComesOffAnObjectHardlyWarm) {
    WarmingWatch watch(LossRange{0.00007, 0.02}, 298.0, SafetySpec().warming_K);
    watch.restAt(0.0, 298.0);
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise(0.0, 0.06);
    double T = 298.0, felt_K = T;
    for (double t = 1.0; t < 760.0; t += 1.0) {
        T += 0.012 - (T - 298.0) / 4100.0;
        felt_K += ((t < 740.0 ? T : 298.0) - felt_K) * -std::expm1(-1.0 / 1.5);
        watch.add(t, felt_K + noise(random), 0.003);
        if (t < 740.0) {
            ASSERT_FALSE(watch.unfollowed()) << t;
        }
    }
    ASSERT_TRUE(watch.unfollowed());
    EXPECT_TRUE(watch.unfollowed()->isImpossible);
}

// Catches a source that is told not to heat while it does, and one that heats unasked unnoticed.
TEST(SourceWatch, TellsASourceThatDoesNotObey) {
    SourceWatch watch{SafetySpec{}, kelvinFromCelsius(25.0)};
    double T = 300.0, t = 0.0;
    const auto seconds = [&](int count, double rate, std::optional<double> setPoint_K) {
        for (int i = 0; i < count; ++i, t += 1.0)
            watch.add(t, T += rate, setPoint_K);
    };
    seconds(100, 0.0, std::nullopt);
    seconds(600, 0.3, 480.0); // as a plate heats
    EXPECT_FALSE(watch.notHeatingFor_s());
    seconds(600, 0.0, 480.0); // there
    EXPECT_FALSE(watch.notHeatingFor_s());
    seconds(100, 0.0, 580.0); // a new set point
    EXPECT_FALSE(watch.notHeatingFor_s());
    seconds(30, 0.0, 580.0);
    EXPECT_TRUE(watch.notHeatingFor_s());
    seconds(5, 1.0, std::nullopt); // the plate's inertia
    seconds(300, -0.2, std::nullopt);
    EXPECT_FALSE(watch.heatsUnasked());
    seconds(9, 1.0, std::nullopt);
    EXPECT_FALSE(watch.heatsUnasked());
    seconds(2, 1.0, std::nullopt);
    ASSERT_TRUE(watch.heatsUnasked());
    EXPECT_NEAR(watch.heatsUnasked()->gained_K, 11.0, 1e-9);
    ASSERT_TRUE(watch.unaskedFall());
    EXPECT_NEAR(watch.unaskedFall()->fallen_K, 0.0, 1e-9);
    EXPECT_NEAR(watch.unaskedFall()->needed_K, 5.5, 1e-9) << "half of what it has warmed";
    seconds(3, -1.0, std::nullopt);
    ASSERT_TRUE(watch.unaskedFall());
    EXPECT_NEAR(watch.unaskedFall()->fallen_K, 3.0, 1e-9);
    seconds(3, -1.0, std::nullopt);
    EXPECT_FALSE(watch.unaskedFall()) << "it no longer counts as heating";
    EXPECT_FALSE(watch.heatsUnasked());
}

namespace {

/// When a source is told to be far above its set point, s, of one that reads so; infinite: never.
double over_s(const std::function<double(double)>& temperature_K,
              const std::function<std::optional<double>(double)>& setPoint_K) {
    SourceWatch watch{SafetySpec{}, kelvinFromCelsius(25.0)};
    for (double t = 0.0; t < 1800.0; t += 1.0) {
        watch.add(t, temperature_K(t), setPoint_K(t));
        if (watch.over_K())
            return t;
    }
    return std::numeric_limits<double>::infinity();
}

} // namespace

// Catches a source that warms without bounds, or stays too hot, and alarms for one that does as it is told:
// with an overshoot, with a lower set point, and switched on again while it is hot.
TEST(SourceWatch, TellsASourceFarAboveItsSetPoint) {
    const double set_K = kelvinFromCelsius(200.0), never_s = std::numeric_limits<double>::infinity();
    const auto at200 = [&](double) { return std::optional(set_K); };
    EXPECT_LT(over_s([&](double t) { return set_K + std::max(0.0, 2.0 * (t - 100.0)); }, at200), 113.0);
    EXPECT_LT(over_s([&](double t) { return set_K + std::min(15.0, 0.1 * t); }, at200), 300.0);
    const auto overshoot = [&](double by_K) {
        return [=](double t) { return set_K + by_K * std::exp(-t / 300.0) * std::sin(0.02 * t); };
    };
    EXPECT_EQ(over_s(overshoot(8.0), at200), never_s) << "5 K at its first peak";
    const auto cooling = [&](double t) { return kelvinFromCelsius(25.0) + 175.0 * std::exp(-t / 1200.0); };
    const auto lowered = [&](double t) { return t < 5.0 ? set_K : set_K - 80.0; };
    EXPECT_EQ(over_s(cooling, lowered), never_s);
    const auto noisy = [&](double t) { return cooling(t) + (static_cast<int>(t) % 2 == 0 ? 0.5 : -0.5); };
    EXPECT_EQ(over_s(noisy, lowered), never_s);
    const auto again = [&](double t) { return t < 60.0 ? std::nullopt : std::optional(set_K - 80.0); };
    EXPECT_EQ(over_s(cooling, again), never_s);
}

} // namespace bask
