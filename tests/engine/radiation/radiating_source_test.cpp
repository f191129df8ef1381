// Uneven sources: sums of outlines with factors.

#include "engine/radiation/interaction_matrix.h"
#include "engine/radiation/radiating_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace bask {
namespace {

constexpr double kHalfWidth_m = 0.1, kHalfDepth_m = 0.07;

Contour polygon(std::vector<Eigen::Vector2d> points_m) {
    Contour contour;
    contour.points_m = std::move(points_m);
    return contour;
}

Pose movedBy(const Eigen::Vector3d& t) {
    return Pose(Eigen::Translation3d(t));
}

RadiatingContour rectangle() {
    return RadiatingContour(polygon({{-kHalfWidth_m, -kHalfDepth_m},
                                     {kHalfWidth_m, -kHalfDepth_m},
                                     {kHalfWidth_m, kHalfDepth_m},
                                     {-kHalfWidth_m, kHalfDepth_m}}));
}

/// The rectangle cut by slanted lines, and each piece by one across.
std::vector<Contour> pieces(int columns, int rows, std::mt19937_64& random) {
    std::uniform_real_distribution<double> off(-0.3, 0.3);
    std::vector<std::vector<Eigen::Vector2d>> grid;
    for (int i = 0; i <= columns; ++i) {
        auto& column = grid.emplace_back();
        for (int j = 0; j <= rows; ++j) {
            const bool isRim = i == 0 || i == columns, isEnd = j == 0 || j == rows;
            column.emplace_back(kHalfWidth_m * (2.0 * (i + (isRim ? 0.0 : off(random))) / columns - 1.0),
                                kHalfDepth_m * (2.0 * (j + (isEnd ? 0.0 : off(random))) / rows - 1.0));
        }
    }
    std::vector<Contour> out;
    for (std::size_t i = 0; i + 1 < grid.size(); ++i)
        for (std::size_t j = 0; j + 1 < grid[i].size(); ++j)
            out.push_back(polygon({grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]}));
    return out;
}

/// Coaxial parallel disks: from one of radius r to one of radius s at the distance h.
double coaxialDisks(double r, double s, double h) {
    const double R = r / h, S = s / h;
    const double X = 1.0 + (1.0 + S * S) / (R * R);
    return 0.5 * (X - std::sqrt(X * X - 4.0 * (S / R) * (S / R)));
}

RadiatingContour bunnyLike() {
    return RadiatingContour(
        FourierContour({{0.002, 0.001}, {0.0, 0.0}, {0.0, 0.0}, {0.02, 0.0}, {0.001, 0.0}}));
}

std::vector<Pose> somePoses(int count) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> across(-0.12, 0.12), up(0.03, 0.2), turn(-0.6, 0.6);
    std::vector<Pose> poses;
    poses.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        poses.push_back(poseFromRotationVector({across(random), across(random), up(random)},
                                               {turn(random), turn(random), turn(random)}));
    return poses;
}

} // namespace

// Catches: an even source that goes another way than before, or by another tolerance.
TEST(RadiatingSource, IsTheOutlineItselfWhereItIsEven) {
    const RadiatingContour outline(Disk{0.1});
    const RadiatingSource even(outline), one({{outline}}, {1.0});
    EXPECT_TRUE(even.isEven());
    EXPECT_TRUE(one.isEven());
    const RadiatingContour object = bunnyLike();
    for (const Pose& X_SO : somePoses(20)) {
        const Blocker blocker{RadiatingContour(Disk{0.02}), X_SO * movedBy({0.01, 0.0, -0.02})};
        const ViewFactor alone = viewFactor(outline, object, X_SO);
        for (const RadiatingSource& source : {even, one}) {
            const ViewFactor factor = viewFactor(source, object, X_SO);
            EXPECT_EQ(factor.value, alone.value);
            EXPECT_EQ(factor.gradient, alone.gradient);
            EXPECT_EQ(factor.errorEstimate, alone.errorEstimate);
            EXPECT_EQ(viewFactorValue(source, object, X_SO, 1e-6),
                      viewFactorValue(outline, object, X_SO, 1e-6));
            const ShadeOptions options{.unshaded = {}, .refusesCrossing = false};
            EXPECT_EQ(shadedViewFactor(source, object, X_SO, {&blocker, 1}, options).gradientRigid,
                      shadedViewFactor(outline, object, X_SO, {&blocker, 1}, options).gradientRigid);
            EXPECT_EQ(roughShade(source, object, X_SO, {&blocker, 1}),
                      roughShade(outline, object, X_SO, {&blocker, 1}));
        }
    }
}

// A uniform source that is cut into 2 to 16 parts, each in a frame of its own.
TEST(RadiatingSource, CutIntoPartsGivesTheWholeOne) {
    std::mt19937_64 random(3);
    const RadiatingContour whole = rectangle();
    const RadiatingContour object = bunnyLike();
    const ViewFactorOptions fine{.tolerance = 1e-11};
    double worst = 0.0, worstGradient = 0.0;
    for (const auto& [columns, rows] :
         {std::pair(2, 1), std::pair(3, 1), std::pair(2, 2), std::pair(5, 1), std::pair(7, 1),
          std::pair(3, 3), std::pair(4, 3), std::pair(13, 1), std::pair(4, 4)}) {
        std::vector<SourceTerm> terms;
        for (const Contour& piece : pieces(columns, rows, random)) {
            const Pose X_SP = poseFromRotationVector({0.03, -0.02, 0.0}, {0.0, 0.0, 0.7});
            Contour own = piece;
            for (Eigen::Vector2d& p : own.points_m)
                p = (X_SP.inverse() * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
            terms.push_back({RadiatingContour(own), X_SP});
        }
        const RadiatingSource cut(terms, std::vector<double>(terms.size(), 1.0));
        EXPECT_FALSE(cut.isEven());
        for (const Pose& X_SO : somePoses(20)) {
            const ViewFactor a = viewFactor(whole, object, X_SO, fine),
                             b = viewFactor(cut, object, X_SO, fine);
            worst = std::max(worst, std::abs(a.value - b.value));
            worstGradient = std::max(worstGradient, (a.gradient - b.gradient).cwiseAbs().maxCoeff());
            EXPECT_LE(b.errorEstimate, 2e-11);
            EXPECT_NEAR(viewFactorValue(cut, object, X_SO, 1e-11), a.value, 1e-9);
        }
    }
    EXPECT_LT(worst, 1e-9);
    EXPECT_LT(worstGradient, 1e-9);
    std::printf("parts: value within %.1e, gradient within %.1e\n", worst, worstGradient);
}

// Rings are whole disks less the next smaller ones; the reference is the closed form.
TEST(RadiatingSource, RingsMeetTheirClosedForm) {
    const std::vector<double> radii{0.1, 0.083, 0.05, 0.031, 0.004};
    const std::vector<double> weights{0.7, 1.1, 0.2, 1.0, 1.9}; // of the rings, the outermost first
    std::vector<SourceTerm> terms;
    std::vector<double> factors;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        terms.push_back({RadiatingContour(Disk{radii[k]})});
        factors.push_back(k == 0 ? weights[0] : weights[k] - weights[k - 1]);
    }
    const RadiatingSource source(terms, factors);
    double worst = 0.0;
    for (const double r : {0.002, 0.015, 0.08})
        for (const double h : {0.01, 0.04, 0.2}) {
            double expected = 0.0;
            for (std::size_t k = 0; k < radii.size(); ++k)
                expected += weights[k] * (coaxialDisks(r, radii[k], h) -
                                          (k + 1 < radii.size() ? coaxialDisks(r, radii[k + 1], h) : 0.0));
            const ViewFactor factor =
                viewFactor(source, RadiatingContour(Disk{r}), movedBy({0.0, 0.0, h}), {.tolerance = 1e-12});
            worst = std::max(worst, std::abs(factor.value - expected));
        }
    EXPECT_LT(worst, 1e-10);
    std::printf("rings: within %.1e\n", worst);
}

// Catches: a gradient in the part's axes, a pose taken the wrong way round.
TEST(RadiatingSource, GradientIsInTheSourcesAxes) {
    const RadiatingSource source(
        {{RadiatingContour(Disk{0.03}), poseFromRotationVector({0.05, 0.01, -0.02}, {0.1, 0.4, 0.3})},
         {RadiatingContour(polygon({{-0.08, -0.02}, {-0.03, -0.03}, {-0.04, 0.05}}))}},
        {1.4, 0.3});
    const RadiatingContour object = bunnyLike();
    const ViewFactorOptions fine{.tolerance = 1e-12};
    for (const Pose& X_SO : somePoses(8)) {
        const ViewFactor factor = viewFactor(source, object, X_SO, fine);
        EXPECT_GT(factor.value, 0.0);
        for (int k = 0; k < 6; ++k) {
            constexpr double kStep = 1e-4;
            const auto moved = [&](double by) {
                const Vector6d twist = by * Vector6d::Unit(k);
                Pose X = X_SO;
                X.translation() += twist.head<3>();
                X.linear() =
                    poseFromRotationVector(Eigen::Vector3d::Zero(), twist.tail<3>()).linear() * X.linear();
                return viewFactor(source, object, X, fine).value;
            };
            EXPECT_NEAR(factor.gradient[k], (moved(kStep) - moved(-kStep)) / (2.0 * kStep), 2e-5);
        }
    }
}

// Catches: blockers that are not turned into the part's frame, a held one's motion in its axes.
TEST(RadiatingSource, ShadeOfPartsAddsUp) {
    std::mt19937_64 random(5);
    const RadiatingContour whole = rectangle();
    std::vector<SourceTerm> terms;
    const Pose X_SP = poseFromRotationVector({0.02, 0.01, 0.0}, {0.0, 0.0, 1.1});
    for (Contour piece : pieces(3, 2, random)) {
        for (Eigen::Vector2d& p : piece.points_m)
            p = (X_SP.inverse() * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>();
        terms.push_back({RadiatingContour(piece), X_SP});
    }
    const RadiatingSource cut(terms, std::vector<double>(terms.size(), 1.0));
    const RadiatingContour object(Disk{0.02});
    int shaded = 0;
    for (const Pose& X_SO : somePoses(10)) {
        const Blocker blocker{RadiatingContour(Disk{0.015}), X_SO * movedBy({0.01, 0.005, -0.015})};
        const ShadeOptions options{.unshaded = {}, .tolerance = 1e-7, .refusesCrossing = false};
        const ShadedViewFactor a = shadedViewFactor(whole, object, X_SO, {&blocker, 1}, options),
                               b = shadedViewFactor(cut, object, X_SO, {&blocker, 1}, options);
        shaded += a.value < a.unshaded - 0.01;
        EXPECT_NEAR(a.value, b.value, 1e-6);
        EXPECT_NEAR(a.unshaded, b.unshaded, 1e-8);
        EXPECT_LT((a.gradientRigid - b.gradientRigid).cwiseAbs().maxCoeff(), 1e-3);
        const double rough = roughShade(cut, object, X_SO, {&blocker, 1});
        EXPECT_NEAR(rough, a.unshaded - a.value, 0.05 * (a.unshaded - a.value) + 1e-3);
    }
    EXPECT_GT(shaded, 3);
}

// Shade of many rings is found with a few of them: beside each ring by itself, for a rim that radiates by
// `fall` less, and rings that lie the denser in the middle the larger `power` is.
TEST(RadiatingSource, ShadeOfRingsIsFoundWithAFew) {
    constexpr int kRings = 36;
    const RadiatingContour object(Disk{0.02});
    const ShadeOptions options{.unshaded = {}, .tolerance = 1e-7, .refusesCrossing = false};
    double worst = 0.0, worstGradient = 0.0, worstRough = 0.0, most = 0.0;
    for (const auto& [fall, power] : {std::pair{0.2, 1.0}, {0.5, 3.0}, {1.0, 1.0}, {-0.3, 0.5}}) {
        std::vector<SourceTerm> terms;
        std::vector<double> factors;
        for (int k = kRings; k > 0; --k) { // the outermost first
            terms.push_back({RadiatingContour(Disk{0.1 * std::pow(double(k) / kRings, power)})});
            factors.push_back(k == kRings ? 1.0 - fall : fall / (kRings - 1));
        }
        const RadiatingSource source(terms, factors);
        for (const Pose& X_SO : somePoses(20)) {
            const Blocker blocker{RadiatingContour(Disk{0.015}), X_SO * movedBy({0.01, 0.005, -0.015})};
            const ShadedViewFactor factor = shadedViewFactor(source, object, X_SO, {&blocker, 1}, options);
            double expected = 0.0;
            Vector6d gradient = Vector6d::Zero();
            for (std::size_t k = 0; k < terms.size(); ++k) {
                const ShadedViewFactor one =
                    shadedViewFactor(terms[k].contour, object, X_SO, {&blocker, 1}, options);
                expected += factors[k] * one.value;
                gradient += factors[k] * one.gradientRigid;
            }
            worst = std::max(worst, std::abs(factor.value - expected));
            EXPECT_LE(std::abs(factor.value - expected), factor.errorEstimate) << fall << ' ' << power;
            EXPECT_LT(factor.errorEstimate, 0.02 * std::abs(fall) + 1e-5);
            worstGradient = std::max(worstGradient, (factor.gradientRigid - gradient).cwiseAbs().maxCoeff());
            const double taken = factor.unshaded - factor.value;
            most = std::max(most, taken);
            const double rough = roughShade(source, object, X_SO, {&blocker, 1});
            worstRough = std::max(worstRough, std::abs(rough - taken));
        }
    }
    std::printf("shade of rings: within %.1e of up to %.2f, gradient within %.1e, roughly within %.1e\n",
                worst, most, worstGradient, worstRough);
    EXPECT_GT(most, 0.15);
    EXPECT_LT(worst, 2e-3);
    EXPECT_LT(worstGradient, 0.1);
    EXPECT_LT(worstRough, 0.02 * most);
}

TEST(RadiatingSource, RefusesWhatHasNoSum) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(RadiatingSource({}, {}), std::invalid_argument);
    EXPECT_THROW(RadiatingSource({{RadiatingContour(Disk{0.1})}}, {1.0, 1.0}), std::invalid_argument);
    EXPECT_THROW(RadiatingSource({{RadiatingContour(Disk{0.1})}}, {kNaN}), std::invalid_argument);
}

} // namespace bask
