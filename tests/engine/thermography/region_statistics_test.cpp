#include "engine/thermography/region_statistics.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

namespace bask {
namespace {

ThermalPicture picture(int width, int height, double noise_K, unsigned seed,
                       const std::function<double(int, int)>& of) {
    ThermalPicture out{width, height, {}};
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            out.T_K.push_back(of(column, row) + noise_K * normal(random));
    return out;
}

std::vector<int> allOf(const ThermalPicture& of) {
    std::vector<int> out(of.T_K.size());
    std::iota(out.begin(), out.end(), 0);
    return out;
}

} // namespace

// Catches: a standard error that is not one. Truth: the spread of the mean over many pictures.
TEST(RegionStatistics, tellsHowWellTheMeanIsKnown) {
    double squares = 0.0, stated = 0.0;
    constexpr int kPictures = 400;
    for (unsigned seed = 1; seed <= kPictures; ++seed) {
        const ThermalPicture one = picture(16, 12, 0.05, seed, [](int, int) { return 310.0; });
        const auto found = regionStatistics(one, allOf(one));
        ASSERT_TRUE(found);
        squares += (found->mean_K - 310.0) * (found->mean_K - 310.0);
        stated += found->standardError_K;
        EXPECT_NEAR(found->spread_K, 0.05, 0.02);
        EXPECT_NEAR(found->noise_K, 0.05, 0.025);
        EXPECT_EQ(found->pixels, 192);
    }
    EXPECT_NEAR(stated / kPictures / std::sqrt(squares / kPictures), 1.0, 0.1);
}

// Catches: a mean that a few foreign pixels pull away: the plain one would be off by 5 K.
TEST(RegionStatistics, aFewForeignPixelsDoNotMoveTheMean) {
    ThermalPicture one = picture(20, 20, 0.05, 3, [](int, int) { return 310.0; });
    for (std::size_t k = 0; k < 20; ++k)
        one.T_K[k * 20] = 410.0;
    const auto found = regionStatistics(one, allOf(one));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->mean_K, 310.0, 0.02);
    EXPECT_NEAR(found->spread_K, 0.05, 0.01);
    EXPECT_EQ(found->max_K, 410.0);
}

// Catches: noise that is told as unevenness, and unevenness that is told too small or as noise.
TEST(RegionStatistics, tellsTheLargestDifferenceAcross) {
    double even_K = 0.0, byNoise_K = 0.0;
    for (unsigned seed = 1; seed <= 50; ++seed) {
        const ThermalPicture flat = picture(48, 48, 0.05, seed, [](int, int) { return 310.0; });
        const auto found = regionStatistics(flat, allOf(flat));
        even_K += found->difference->value_K / 50.0;
        byNoise_K += found->difference->byNoise_K / 50.0;
    }
    EXPECT_NEAR(even_K / byNoise_K, 1.0, 0.1);
    EXPECT_LT(even_K, 0.05);
    // 2 K across 48 columns; 40 of them lie between the middles of the outer tiles of 8.
    const ThermalPicture ramp =
        picture(48, 48, 0.05, 9, [](int column, int) { return 310.0 + 2.0 * column / 48.0; });
    const auto found = regionStatistics(ramp, allOf(ramp));
    ASSERT_TRUE(found->difference);
    EXPECT_NEAR(found->difference->value_K, 2.0 * 40.0 / 48.0, 0.05);
    EXPECT_GT(found->difference->value_K, 10.0 * found->difference->byNoise_K);
    EXPECT_NEAR(found->difference->standardUncertainty_K, 0.05 * std::sqrt(2.0) / 8.0, 0.003);
    EXPECT_NEAR(found->noise_K, 0.05, 0.015) << "without what varies slowly";
    EXPECT_GT(found->spread_K, 0.4);
}

// Catches: coarse steps of a camera that end in a division by zero.
TEST(RegionStatistics, standsCoarseSteps) {
    ThermalPicture one = picture(10, 10, 0.0, 1, [](int, int) { return 310.0; });
    one.T_K[5] = 310.015625;
    const auto found = regionStatistics(one, allOf(one));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->mean_K, 310.0, 0.001);
    EXPECT_TRUE(std::isfinite(found->standardError_K));
    EXPECT_GT(found->noise_K, 0.0);
}

// Catches: a reading from pixels that tell nothing.
TEST(RegionStatistics, saysWhyThereIsNone) {
    const ThermalPicture good = picture(20, 20, 0.05, 3, [](int, int) { return 310.0; });
    const auto code = [](const ThermalPicture& of, const std::vector<int>& pixels) {
        const auto found = regionStatistics(of, pixels);
        return found ? MessageCode::None : found.error().code();
    };
    EXPECT_EQ(code(good, allOf(good)), MessageCode::None);
    EXPECT_EQ(code(good, {1, 2, 3}), MessageCode::ThermalFaceSmall);
    EXPECT_EQ(code(good, {}), MessageCode::ThermalFaceSmall);
    ThermalPicture broken = good;
    broken.T_K[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(broken, allOf(broken)), MessageCode::ThermalPixelsUnknown);
    broken.T_K[7] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(code(broken, allOf(broken)), MessageCode::ThermalPixelsSaturated);
    broken.T_K[7] = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(code(broken, allOf(broken)), MessageCode::ThermalPixelsSaturated);
    const ThermalPicture dead = picture(20, 20, 0.0, 3, [](int, int) { return 310.0; });
    EXPECT_EQ(code(dead, allOf(dead)), MessageCode::ThermalPictureConstant);
    EXPECT_THROW((void)regionStatistics(good, std::vector<int>(9, 400)), std::out_of_range);
    EXPECT_THROW((void)regionStatistics(good, std::vector<int>(9, -1)), std::out_of_range);
}

TEST(RegionStatistics, aPolygonHasThePixelsWhoseCentresAreInIt) {
    EXPECT_EQ(pixelsIn({{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}}, 10, 5),
              (std::vector<int>{11, 12, 21, 22}));
    EXPECT_EQ(pixelsIn({{-9.0, -9.0}, {99.0, -9.0}, {99.0, 99.0}, {-9.0, 99.0}}, 3, 2).size(), 6U);
    EXPECT_TRUE(pixelsIn({{20.0, 20.0}, {30.0, 20.0}, {30.0, 30.0}}, 10, 5).empty());
}

} // namespace bask
