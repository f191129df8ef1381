// What a thermal camera finds about the sensors on the objects.

#include "engine/runtime/second_opinion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

/// Two objects with their sensors and a camera, at one reading a second; the camera takes a face of
/// `trueEmittance` for one of 0.9, and what it reflects is the room.
struct Scene {
    void look(double one_K, double other_K) {
        const auto opinion = [&](double T_K, double contact_K, double trueEmittance) {
            const double camera_K = kRoom_K + cameraOff_K + (T_K - kRoom_K) * trueEmittance / 0.9;
            return CameraOpinion{contact_K, now_s,   camera_K,
                                 0.2,       kRoom_K, 0.9 * (camera_K - kRoom_K) / (contact_K - kRoom_K)};
        };
        opinions.add(now_s, {opinion(one_K, contact_K.value_or(one_K), emittance),
                             opinion(other_K, otherContact_K.value_or(other_K), 0.9)});
        now_s += 1.0;
    }
    void look(int seconds, double one_K, double other_K) {
        for (int k = 0; k < seconds; ++k)
            look(one_K, other_K);
    }

    SecondOpinion opinions{2, 1.0};
    double now_s = 0.0;
    std::optional<double> contact_K{}, otherContact_K{}; ///< empty: as warm as the object
    double emittance = 0.9;
    double cameraOff_K = 0.0;
};

TEST(SecondOpinion, SaysNothingWhereBothAgree) {
    Scene scene;
    for (int k = 0; k < 100; ++k)
        scene.look(kRoom_K + 0.3 * k, kRoom_K + 0.2 * k);
    EXPECT_FALSE(scene.opinions.finding(0));
    EXPECT_FALSE(scene.opinions.finding(1));
}

// Catches a sensor's lag taken for a wrong sensor.
TEST(SecondOpinion, LetsASensorLagBehindItsObject) {
    Scene scene;
    double felt_K = kRoom_K;
    for (int k = 0; k < 60; ++k) {
        const double T_K = kRoom_K + 0.8 * k;
        felt_K += (T_K - felt_K) * (1.0 - std::exp(-1.0 / 5.0));
        scene.contact_K = felt_K; // 4 K behind
        scene.look(T_K, kRoom_K);
    }
    EXPECT_FALSE(scene.opinions.finding(0));
}

// Catches an offset that both have against one another from the beginning counted as a difference.
TEST(SecondOpinion, TakesOffWhatTheyDifferByWhenCold) {
    Scene scene;
    for (int k = 0; k < 60; ++k) {
        const double T_K = kRoom_K + std::max(0.0, 0.5 * (k - 20));
        scene.contact_K = T_K + 0.6;
        scene.look(T_K - 0.7 - 0.02 * (T_K - kRoom_K), kRoom_K); // and the camera's gain is off
    }
    EXPECT_FALSE(scene.opinions.finding(0));
}

TEST(SecondOpinion, TellsASensorThatComesOffWithinSeconds) {
    Scene scene;
    scene.look(30, kRoom_K + 20.0, kRoom_K + 15.0);
    const double off_s = scene.now_s;
    while (!scene.opinions.finding(0) && scene.now_s < off_s + 60.0) {
        scene.contact_K = kRoom_K + 20.0 * std::exp(-(scene.now_s - off_s) / 20.0);
        scene.look(kRoom_K + 20.0, kRoom_K + 15.0);
    }
    ASSERT_TRUE(scene.opinions.finding(0));
    EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::SensorOff);
    EXPECT_LE(scene.now_s - off_s, 10.0);
    EXPECT_FALSE(scene.opinions.finding(1));
    // It stands while the object cools to what the sensor reads.
    for (int k = 0; k < 60; ++k) {
        scene.contact_K = kRoom_K;
        scene.look(kRoom_K + 20.0 * std::exp(-k / 10.0), kRoom_K);
    }
    EXPECT_TRUE(scene.opinions.finding(0));
    scene.opinions.confirm(0);
    scene.look(5, kRoom_K, kRoom_K);
    EXPECT_FALSE(scene.opinions.finding(0));
}

TEST(SecondOpinion, TellsASensorThatWasNeverOnItsObject) {
    Scene scene;
    scene.contact_K = kRoom_K + 2.0;
    scene.look(10, kRoom_K + 20.0, kRoom_K);
    ASSERT_TRUE(scene.opinions.finding(0));
    EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::NeverOn);
}

// Catches the finding told twice, or of one of the two as a sensor that came off.
TEST(SecondOpinion, TellsSwappedSensorsOnce) {
    for (const double apart_K : {3.0, 8.0, -5.0}) {
        Scene scene;
        scene.look(30, kRoom_K + 20.0, kRoom_K + 20.0 + apart_K);
        scene.contact_K = kRoom_K + 20.0 + apart_K;
        scene.otherContact_K = kRoom_K + 20.0;
        scene.look(6, kRoom_K + 20.0, kRoom_K + 20.0 + apart_K);
        ASSERT_TRUE(scene.opinions.finding(0)) << apart_K;
        EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::Swapped);
        EXPECT_EQ(scene.opinions.finding(0)->other, 1U);
        EXPECT_FALSE(scene.opinions.finding(1));
        scene.opinions.confirm(1); // as if the person confirmed the other one
        EXPECT_FALSE(scene.opinions.finding(0));
    }
}

TEST(SecondOpinion, TellsTheEmittanceThatExplainsAllReadings) {
    Scene scene;
    scene.emittance = 0.65;
    double T_K = kRoom_K;
    for (int k = 0; k < 60; ++k, T_K += 0.4)
        scene.look(T_K, kRoom_K + 1.0);
    ASSERT_TRUE(scene.opinions.finding(0));
    EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::EmittanceOther);
    EXPECT_NEAR(scene.opinions.finding(0)->seen.emittance, 0.65, 0.01);
    scene.emittance = 0.9; // it is typed
    scene.look(2, T_K, kRoom_K + 1.0);
    EXPECT_FALSE(scene.opinions.finding(0));
}

TEST(SecondOpinion, TellsACameraThatSeesTheTableInstead) {
    Scene scene;
    scene.look(30, kRoom_K + 20.0, kRoom_K + 15.0);
    scene.contact_K = kRoom_K + 20.0;
    scene.otherContact_K = kRoom_K + 15.0;
    scene.look(20, kRoom_K, kRoom_K); // it sees the table
    ASSERT_TRUE(scene.opinions.finding(0));
    EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::CameraDiffers);
    scene.contact_K.reset();
    scene.otherContact_K.reset();
    scene.look(3, kRoom_K + 20.0, kRoom_K + 15.0);
    EXPECT_FALSE(scene.opinions.finding(0));
}

// Catches a reading that is repeated because no new one came, counted as another reading that differs.
TEST(SecondOpinion, CountsAReadingOnce) {
    SecondOpinion opinions(1, 1.0);
    for (int k = 0; k < 30; ++k)
        opinions.add(k, {CameraOpinion{kRoom_K, 1.0, kRoom_K + 20.0, 0.2, kRoom_K, -1.0}});
    EXPECT_FALSE(opinions.finding(0));
}

// Catches a finding about the emittance that becomes one about the sensor where nothing can be told any more.
TEST(SecondOpinion, KeepsWhatItSaidOfTheEmittanceWhileAllCools) {
    Scene scene;
    scene.emittance = 0.5;
    double T_K = kRoom_K;
    for (int k = 0; k < 60; ++k, T_K += 0.4)
        scene.look(T_K, kRoom_K + 1.0);
    ASSERT_TRUE(scene.opinions.finding(0));
    for (int k = 0; k < 120 && scene.opinions.finding(0); ++k, T_K = kRoom_K + (T_K - kRoom_K) * 0.97) {
        EXPECT_EQ(scene.opinions.finding(0)->verdict, OpinionVerdict::EmittanceOther) << k;
        scene.look(T_K, kRoom_K + 1.0);
    }
    EXPECT_FALSE(scene.opinions.finding(0)); // both tell the room
}

TEST(SecondOpinion, WaitsWhileTheCameraOrTheSensorTellsNothing) {
    SecondOpinion opinions(1, 1.0);
    for (int k = 0; k < 30; ++k) {
        opinions.add(k, {std::nullopt});
        CameraOpinion seen;
        seen.camera_K = kRoom_K + 20.0;
        opinions.add(k + 0.5, {seen});
    }
    EXPECT_FALSE(opinions.finding(0));
    EXPECT_THROW(opinions.add(31.0, {}), std::invalid_argument);
}

} // namespace
} // namespace bask
