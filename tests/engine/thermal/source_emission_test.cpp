// Weights of the parts of an uneven source.

#include "engine/thermal/source_emission.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15, kSource_K = 473.15;

double emission(double T_K) {
    return std::pow(T_K, 4) - std::pow(kRoom_K, 4);
}

SourceEmission ofPart(const EmissionTerm& part, SourceModel model = SourceModel::Gray) {
    return {model, 0.25, kRoom_K, {part}, {}};
}

double weightOf(const EmissionTerm& part, double source_K, SourceModel model = SourceModel::Gray) {
    return ofPart(part, model).factors(source_K).front();
}

} // namespace

TEST(SourceEmission, WeighsByTheExcessOverTheRoom) {
    EXPECT_DOUBLE_EQ(weightOf({0.25, {1.0, 0.0}}, kSource_K), 1.0);
    const double nine_K = kRoom_K + 0.9 * (kSource_K - kRoom_K);
    EXPECT_NEAR(weightOf({0.25, {0.9, 0.0}}, kSource_K), emission(nine_K) / emission(kSource_K), 1e-12);
    EXPECT_NEAR(weightOf({0.25, {1.0, -20.0}}, kSource_K), emission(kSource_K - 20.0) / emission(kSource_K),
                1e-12);
    EXPECT_NEAR(weightOf({0.5, {1.0, 0.0}}, kSource_K), 2.0, 1e-12);
    EXPECT_EQ(weightOf({0.25, {0.0, 0.0}}, kSource_K), 0.0);
}

// Catches: a part below the room, which would cool by radiation, or one without a bound where the source is
// as cold as the room.
TEST(SourceEmission, KeepsPartsBetweenTheRoomAndTwiceTheSource) {
    EXPECT_EQ(weightOf({0.25, {1.0, -500.0}}, kSource_K), 0.0);
    EXPECT_NEAR(weightOf({0.25, {1.0, 900.0}}, kSource_K),
                emission(kRoom_K + 2.0 * (kSource_K - kRoom_K)) / emission(kSource_K), 1e-12);
    for (const double source_K : {kRoom_K - 5.0, kRoom_K, kRoom_K + 1e-9, kRoom_K + 0.1})
        for (const double ratio : {0.0, 0.5, 1.5, 2.0})
            for (const double offset_K : {-10.0, 0.0, 10.0}) {
                const double weight = weightOf({0.25, {ratio, offset_K}}, source_K);
                EXPECT_GE(weight, 0.0);
                EXPECT_LE(weight, 2.1);
            }
    EXPECT_NEAR(weightOf({0.25, {0.7, 0.0}}, kRoom_K), 0.7, 1e-4);
}

TEST(SourceEmission, FollowsTheModelOfThePaper) {
    const auto power = [](double eps, double T_K) {
        return netSourcePower_W_m2(SourceModel::Paper, T_K, eps, kRoom_K);
    };
    EXPECT_NEAR(weightOf({0.25, {1.0, 0.0}}, kSource_K, SourceModel::Paper), 1.0, 1e-12);
    EXPECT_NEAR(weightOf({0.25, {1.0, -10.0}}, kSource_K, SourceModel::Paper),
                power(0.25, kSource_K - 10.0) / power(0.25, kSource_K), 1e-12);
    EXPECT_EQ(weightOf({0.25, {0.1, 0.0}}, kSource_K, SourceModel::Paper), 0.0);
    // Where the source begins to heat in that model its own power is nothing.
    for (double T_K = 400.0; T_K < 440.0; T_K += 0.1)
        EXPECT_LE(weightOf({0.25, {1.2, 0.0}}, T_K, SourceModel::Paper), 16.0) << T_K;
}

// The edge of a ring has the change of the weight, for both models and both ways to state a temperature.
TEST(SourceEmission, EdgesFallAsTheWeightDoes) {
    for (const SourceModel model : {SourceModel::Gray, SourceModel::Paper})
        for (const PartTemperature& rise : {PartTemperature{1e-5, 0.0}, PartTemperature{0.0, 1e-3}}) {
            const PartTemperature at{0.9, -3.0};
            const double edge = weightOf({0.25, at, rise}, kSource_K, model);
            const double below = weightOf(
                {0.25, {at.ratio - 0.5 * rise.ratio, at.offset_K - 0.5 * rise.offset_K}}, kSource_K, model);
            const double above = weightOf(
                {0.25, {at.ratio + 0.5 * rise.ratio, at.offset_K + 0.5 * rise.offset_K}}, kSource_K, model);
            EXPECT_NEAR(edge, below - above, 1e-6 * std::abs(edge));
            EXPECT_LT(edge, 0.0);
        }
    EXPECT_EQ(weightOf({0.25, {1.0, -900.0}, PartTemperature{0.0, 5.0}}, kSource_K), 0.0); // all in the room
}

TEST(SourceEmission, TellsTheLargestWeight) {
    EXPECT_EQ(SourceEmission{}.maxWeight(kSource_K), 1.0);
    EXPECT_EQ(ofPart({0.25, {0.5, 0.0}}).maxWeight(kSource_K), 1.0);
    EXPECT_NEAR(ofPart({0.25, {1.3, 0.0}}).maxWeight(kSource_K), weightOf({0.25, {1.3, 0.0}}, kSource_K),
                1e-12);
    SourceEmission profile = ofPart({0.25, {0.8, 0.0}});
    profile.profile = {{0.8, 0.0}, {1.1, 0.0}};
    EXPECT_NEAR(profile.maxWeight(kSource_K), weightOf({0.25, {1.1, 0.0}}, kSource_K), 1e-12);
}

} // namespace bask
