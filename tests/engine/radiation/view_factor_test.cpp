#include "engine/radiation/view_factor.h"

#include "tests/engine/radiation/lambert_reference.h"
#include "tests/engine/radiation/random_poses.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace bask {
namespace {

using test::Draw;

constexpr double kPi = std::numbers::pi;

ViewFactor viewFactor(const Disk& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options = {}) {
    return bask::viewFactor(RadiatingContour(source), object, X_SO, options);
}
double viewFactorValue(const Disk& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance = 1e-9) {
    return bask::viewFactorValue(RadiatingContour(source), object, X_SO, tolerance);
}

Pose poseAt(double x, double y, double z, double rx = 0.0, double ry = 0.0, double rz = 0.0) {
    return poseFromRotationVector({x, y, z}, {rx, ry, rz});
}

Shape shapeOf(const nlohmann::json& j) {
    if (j["type"] == "disk")
        return Disk{j["radius_m"].get<double>()};
    if (j["type"] == "polygon") {
        Contour contour;
        for (const auto& p : j["points_m"])
            contour.points_m.emplace_back(p[0].get<double>(), p[1].get<double>());
        return contour;
    }
    int harmonics = 0;
    for (const auto& c : j["coefficients"])
        harmonics = std::max(harmonics, std::abs(c[0].get<int>()));
    std::vector<std::complex<double>> coefficients(static_cast<std::size_t>(2 * harmonics + 1));
    for (const auto& c : j["coefficients"])
        coefficients[static_cast<std::size_t>(c[0].get<int>() + harmonics)] = {c[1].get<double>(),
                                                                               c[2].get<double>()};
    return FourierContour(coefficients);
}

Eigen::Vector3d vectorOf(const nlohmann::json& j) {
    return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

// Catches: any wrong sign, frame, cut or factor, against an independent computation.
TEST(ViewFactor, meetsTheReferenceCases) {
    std::ifstream file(BASK_TEST_DATA "/view_factors.json");
    const auto cases = nlohmann::json::parse(file)["cases"];
    int checked = 0;
    for (const auto& one : cases) {
        SCOPED_TRACE(one["id"].get<std::string>());
        const RadiatingContour source(shapeOf(one["source"]));
        const Pose X_SO = poseFromRotationVector(vectorOf(one["pose"]["translation_m"]),
                                                 vectorOf(one["pose"]["rotation_vector_rad"]));
        const RadiatingContour object(shapeOf(one["object"]));
        const ViewFactor f = bask::viewFactor(source, object, X_SO);
        EXPECT_NEAR(f.value, one["view_factor"].get<double>(), 1e-10);
        EXPECT_EQ(visibilityName(f.visibility), one["visibility"].get<std::string>());
        EXPECT_NEAR(bask::viewFactorValue(source, object, X_SO), f.value, 1e-10);
        EXPECT_NEAR(bask::viewFactorValue(source, object, X_SO, 1e-4), f.value, 1e-4);
        Vector6d expected;
        for (int i = 0; i < 6; ++i)
            expected[i] = one["gradient"][static_cast<std::size_t>(i)].get<double>();
        EXPECT_LE((f.gradient - expected).head<3>().norm(), 1e-7 * expected.head<3>().norm());
        EXPECT_LE((f.gradient - expected).tail<3>().norm(), 1e-7 * expected.tail<3>().norm());
        ++checked;
    }
    EXPECT_EQ(checked, 60);
}

// Catches: loss of digits. Values known to 15 digits; source disk 15 cm, object disk 1.5 cm.
TEST(ViewFactor, meetsTheFifteenDigitValues) {
    struct Case {
        Pose X_SO;
        double value;
    };
    const Case cases[] = {
        {poseAt(0, 0, 0.05), 0.89918413173929207},
        {poseAt(0.04, 0.03, 0.05), 0.87832723802998868},
        {poseAt(0.03, -0.02, 0.08, 40 * kPi / 180), 0.61353047145569561},
        {poseAt(0.03, -0.02, 0.08, 20 * kPi / 180), 0.73011434333266277},
        {poseAt(0, 0, 0.05, 80 * kPi / 180), 0.38333986486825526},
    };
    const RadiatingContour object(Disk{0.015});
    for (const Case& one : cases)
        EXPECT_NEAR(viewFactor({0.15}, object, one.X_SO).value, one.value, 1e-13) << one.value;
}

// Catches: errors far away and nearly touching, where the general poses do not go.
TEST(ViewFactor, meetsTheClosedFormOfCoaxialDisks) {
    for (double height : {1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 1000.0})
        for (double radius : {0.001, 0.03, 0.0999, 0.1, 0.1001, 0.4}) {
            const double r1 = 0.1;
            const double x =
                1.0 + (1.0 + r1 * r1 / (height * height)) / (radius * radius / (height * height));
            // (x - sqrt(x^2 - 4 (r1/r2)^2))/2, written without cancellation.
            const double ratio = r1 / radius;
            const double expected = 2.0 * ratio * ratio / (x + std::sqrt(x * x - 4.0 * ratio * ratio));
            const ViewFactor f = viewFactor({r1}, RadiatingContour(Disk{radius}), poseAt(0, 0, height));
            EXPECT_NEAR(f.value, expected, 1e-13) << height << ' ' << radius;
            EXPECT_NEAR(f.gradient.head<2>().norm(), 0.0, 1e-8);
            EXPECT_LT(f.gradient[2], 0.0);
        }
}

// Catches: either cut treated otherwise than the other: seen from the other disk their roles are exchanged.
TEST(ViewFactor, isReciprocalBetweenDisksHoweverTheyAreCut) {
    Draw draw(11);
    const Pose flip = poseAt(0, 0, 0, kPi);
    int partial = 0;
    for (int i = 0; i < 500; ++i) {
        const double r1 = draw.between(0.05, 0.15);
        const double r2 = draw.between(0.01, 0.15);
        Pose X_SO = poseFromRotationVector(draw.vector(0.2), draw.vector(1.5));
        X_SO.translation().z() = draw.between(0.0, 0.2);
        const Pose swapped = flip * X_SO.inverse() * flip;
        const ViewFactor there = viewFactor({r1}, RadiatingContour(Disk{r2}), X_SO, {1e-11, 1 << 16});
        const ViewFactor back = viewFactor({r2}, RadiatingContour(Disk{r1}), swapped, {1e-11, 1 << 16});
        EXPECT_NEAR(r2 * r2 * there.value, r1 * r1 * back.value, 1e-12) << "pose " << i;
        EXPECT_EQ(there.visibility, back.visibility) << "pose " << i;
        partial += there.visibility == Visibility::Partial;
    }
    EXPECT_GT(partial, 200);
}

// Catches: a wrong cut, by brute force over both areas; shapes cut in several pieces included.
TEST(ViewFactor, agreesWithLambertsLawOverBothVisibleAreas) {
    Draw draw(5);
    int dipping = 0;
    int sourceCut = 0;
    for (int i = 0; i < 36; ++i) {
        const Disk source{0.1};
        const Shape shape = i % 6 == 5 || i % 9 == 4 ? Shape{draw.fourier(0.05, 0.8)} : draw.shape(i, 0.05);
        const bool dip = i % 2 == 1;
        const double azimuth = draw.between(0.0, 2.0 * kPi);
        const double away = dip ? draw.between(0.17, 0.24) : draw.between(0.0, 0.08);
        // Dipping ones lean towards the source from beyond its rim.
        const double tilt = dip ? draw.between(0.7, 1.5) : draw.between(-1.3, 1.3);
        const Pose X_SO = poseFromRotationVector({away * std::cos(azimuth), away * std::sin(azimuth), 0.0},
                                                 {-tilt * std::sin(azimuth), tilt * std::cos(azimuth), 0.0}) *
                          poseAt(0, 0, 0, 0, 0, draw.between(0.0, 2.0 * kPi));
        Pose raised = X_SO;
        raised.translation().z() = dip ? draw.between(-0.02, 0.02) : draw.between(0.09, 0.2);
        const ViewFactor f = viewFactor(source, RadiatingContour(shape), raised);
        EXPECT_NEAR(f.value, test::lambertViewFactor(source, shape, raised), 2e-7) << "pose " << i;
        dipping += dip && f.value > 0.0;
        sourceCut += !dip && f.visibility == Visibility::Partial;
    }
    EXPECT_GT(dipping, 12);
    EXPECT_GT(sourceCut, 3);
}

// Catches: any error of the closed-form field's curl, of the lever and of the frozen cut. Differences of
// fourth order.
TEST(ViewFactor, gradientIsTheDerivativeOfTheValue) {
    Draw draw(3);
    int partial = 0;
    int checked = 0;
    for (int i = 0; checked < 300; ++i) {
        const Disk source{draw.between(0.05, 0.15)};
        const RadiatingContour object(draw.shape(i, draw.between(0.01, 0.06)));
        Pose X_SO = poseFromRotationVector(draw.vector(0.2), draw.vector(i % 4 == 0 ? 3.1 : 1.2));
        X_SO.translation().z() = draw.between(0.04, 0.25);
        const ViewFactor f = viewFactor(source, object, X_SO, {1e-13, 1 << 16});
        if (f.value < 1e-4)
            continue;
        ++checked;
        partial += f.visibility == Visibility::Partial;
        Vector6d numeric;
        for (int k = 0; k < 6; ++k) {
            const auto moved = [&](double step) {
                Pose X = X_SO;
                if (k < 3)
                    X.translation()[k] += step;
                else
                    X.linear() =
                        Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(k - 3)).toRotationMatrix() * X.linear();
                return viewFactor(source, object, X, {1e-13, 1 << 16}).value;
            };
            const double h = 5e-5;
            numeric[k] = (8.0 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12.0 * h);
        }
        EXPECT_LE((f.gradient - numeric).head<3>().norm(), 2e-7 * (1.0 + numeric.head<3>().norm()))
            << "pose " << i;
        EXPECT_LE((f.gradient - numeric).tail<3>().norm(), 2e-7 * (0.1 + numeric.tail<3>().norm()))
            << "pose " << i;
    }
    EXPECT_GT(partial, 80);
}

// Catches: an axis of the source frame preferred to another.
TEST(ViewFactor, turnsWithTheSceneAboutTheSourceAxis) {
    Draw draw(17);
    for (int i = 0; i < 200; ++i) {
        const Disk source{0.1};
        const RadiatingContour object(draw.shape(i, 0.04));
        Pose X_SO = poseFromRotationVector(draw.vector(0.15), draw.vector(1.0));
        X_SO.translation().z() = draw.between(0.0, 0.2);
        const Pose turn = poseAt(0, 0, 0, 0, 0, draw.between(-kPi, kPi));
        const ViewFactor a = viewFactor(source, object, X_SO, {1e-12, 1 << 16});
        const ViewFactor b = viewFactor(source, object, turn * X_SO, {1e-12, 1 << 16});
        EXPECT_NEAR(a.value, b.value, 1e-12);
        EXPECT_LE((turn.linear() * a.gradient.head<3>() - b.gradient.head<3>()).norm(),
                  1e-8 * (1 + a.gradient.norm()));
        EXPECT_LE((turn.linear() * a.gradient.tail<3>() - b.gradient.tail<3>()).norm(),
                  1e-8 * (1 + a.gradient.norm()));
    }
}

// Catches: an estimate that flatters, a tolerance passed over, a NaN, a value outside [0, 1]; poses that
// touch, cut through and lie in the source plane included.
TEST(ViewFactor, errorEstimateIsHonestAndNothingIsNotANumber) {
    Draw draw(23);
    for (int i = 0; i < 3000; ++i) {
        const double r1 = draw.between(0.02, 0.2);
        const double r2 = std::exp(draw.between(std::log(0.003), std::log(0.1)));
        const RadiatingContour object(draw.shape(i, r2));
        Eigen::Vector3d rotation = draw.vector(1.6);
        if (i % 2 == 0)
            rotation *= std::exp(draw.between(std::log(1e-9), 0.0));
        Pose X_SO = poseFromRotationVector(draw.vector(0.25), rotation);
        X_SO.translation().z() =
            i % 4 == 0 ? std::exp(draw.between(std::log(1e-9), std::log(0.01))) : draw.between(-0.02, 0.2);
        if (i % 8 == 0) { // an outline that touches the rim from inside, a hair above it
            X_SO.translation().x() = r1 - r2;
            X_SO.translation().y() = 0.0;
        }
        const ViewFactor f = viewFactor({r1}, object, X_SO);
        ASSERT_TRUE(std::isfinite(f.value) && f.gradient.allFinite() && std::isfinite(f.errorEstimate))
            << "pose " << i;
        EXPECT_GE(f.value, 0.0);
        EXPECT_LE(f.value, 1.0);
        const ViewFactor sharp = viewFactor({r1}, object, X_SO, {1e-14, 100000});
        EXPECT_LE(std::abs(f.value - sharp.value), f.errorEstimate + sharp.errorEstimate) << "pose " << i;
        EXPECT_LE(f.errorEstimate, 1e-7) << "pose " << i;
        const ViewFactor rough = viewFactor({r1}, object, X_SO, {1e-4, 4096});
        EXPECT_LE(std::abs(rough.value - sharp.value), 1e-4) << "pose " << i;
        EXPECT_NEAR(viewFactorValue({r1}, object, X_SO), sharp.value, 5e-3) << "pose " << i;
    }
}

// Catches: the quick sum of a disk over a disk where it is not enough, or where a face is cut or hidden.
TEST(ViewFactor, valueAloneOfDisksIsWithinTheTolerance) {
    Draw draw(37);
    for (int i = 0; i < 6000; ++i) {
        const double tolerance = std::pow(10.0, -4.0 - i % 10);
        const double r1 = draw.between(0.02, 0.2);
        const RadiatingContour object(Disk{std::exp(draw.between(std::log(0.003), std::log(0.2)))});
        Pose X_SO = poseFromRotationVector(draw.vector(0.3), draw.vector(i % 2 == 0 ? 0.0 : 1.5));
        X_SO.translation().z() = i % 3 == 0 ? draw.between(0.0, 0.02) : draw.between(0.02, 0.4);
        const ViewFactor sharp = viewFactor({r1}, object, X_SO, {1e-15, 100000});
        EXPECT_NEAR(viewFactorValue({r1}, object, X_SO, tolerance), sharp.value,
                    tolerance + sharp.errorEstimate)
            << "pose " << i << ", tolerance " << tolerance;
    }
}

// Catches: a rule whose gradient is worse than its value, and a strip wider than it is, at tilts and
// parallel.
TEST(ViewFactor, quickSumOfDisksAgreesWithTheGeneralOne) {
    Draw draw(41);
    int quick = 0;
    for (int i = 0; i < 4000; ++i) {
        const double r1 = draw.between(0.05, 0.2);
        const double r2 = std::exp(draw.between(std::log(0.02), std::log(0.2)));
        const RadiatingContour source(Disk{r1}), object(Disk{r2});
        Pose X_SO = poseFromRotationVector(draw.vector(0.3), draw.vector(i % 2 == 0 ? 0.0 : 1.2));
        X_SO.translation().z() = draw.between(0.005, 0.4);
        if (i % 16 == 0) // above the centre
            X_SO.translation().head<2>().setZero();
        const ViewFactor general = viewFactor(source, object, X_SO, {1e-15, 100000});
        if (general.visibility != Visibility::Full)
            continue;
        const ViewFactor fine = viewFactor(source, object, X_SO, {.tolerance = 1e-12});
        EXPECT_NEAR(fine.value, general.value, 2e-14) << "pose " << i;
        EXPECT_LE((fine.gradient - general.gradient).norm(), 1e-11 / r2) << "pose " << i;
        const ViewFactor rough = viewFactor(source, object, X_SO, {.tolerance = 1e-5});
        EXPECT_EQ(rough.visibility, Visibility::Full);
        EXPECT_NEAR(rough.value, general.value, rough.errorEstimate) << "pose " << i;
        EXPECT_LE(rough.errorEstimate, 1e-5) << "pose " << i;
        EXPECT_LE((rough.gradient - general.gradient).norm(), 1e-4 / r2) << "pose " << i;
        quick += rough.value != general.value;
    }
    EXPECT_GT(quick, 1000);
}

// Catches: a result with few points allowed that claims more than it has.
TEST(ViewFactor, saysWhatWasReachedWhenPointsRunOut) {
    const RadiatingContour object(Disk{0.05});
    const Pose X_SO = poseAt(0.06, 0.0, 1e-4);
    const double exact = viewFactor({0.1}, object, X_SO, {1e-13, 1 << 18}).value;
    for (int max : {32, 64, 128, 512}) {
        const ViewFactor f = viewFactor({0.1}, object, X_SO, {1e-13, max});
        EXPECT_LE(std::abs(f.value - exact), f.errorEstimate) << max;
    }
}

// Catches: light through the back of either face, and NaN where planes coincide or only touch.
TEST(ViewFactor, isZeroWhereNothingIsSeen) {
    const Disk source{0.1};
    const double touching = std::atan2(0.05, 0.1);
    const Pose hidden[] = {
        poseAt(0, 0, 0.05, kPi),                   // faces away
        poseAt(0.02, 0.01, -0.05),                 // behind the source
        poseAt(0.3, 0, 0, 0, 0, 1.0),              // both in one plane, apart
        poseAt(-0.3, 0, 0.03, 0, 0.9),             // the source lies behind the object's plane
        poseAt(0, 0, -0.05, touching + 0.2),       // behind and tilted
        poseAt(0.4, 0, -0.0301, 0, kPi / 2),       // upright, wholly below
        poseAt(0, 0, 0.05, kPi - touching + 1e-9), // its plane just misses the source
    };
    for (const Shape& shape : {Shape{Disk{0.03}}, Shape{FourierContour({0.0, 0.0, 0.03})},
                               Shape{Contour{{{0.03, -0.02}, {0.0, 0.03}, {-0.03, -0.02}}}}}) {
        const RadiatingContour object(shape);
        for (const Pose& X_SO : hidden) {
            const ViewFactor f = viewFactor(source, object, X_SO);
            EXPECT_EQ(f.visibility, Visibility::Hidden);
            EXPECT_EQ(f.value, 0.0);
            EXPECT_EQ(f.gradient, Vector6d(Vector6d::Zero()));
            EXPECT_EQ(viewFactorValue(source, object, X_SO), 0.0);
        }
    }
}

// Catches: a jump where a cut begins to bite, in value or gradient.
TEST(ViewFactor, isContinuousWhereCutsBegin) {
    const Disk source{0.1};
    const RadiatingContour object(Disk{0.03});
    const double lean = 0.5;
    for (double angle : {1e-15, 1e-12, 1e-9, 1e-6}) {
        const double tilt =
            std::atan2(0.05, 0.1); // the plane of an object 5 cm over the centre meets the rim
        const ViewFactor before = viewFactor(source, object, poseAt(0, 0, 0.05, tilt - angle), {1e-13});
        const ViewFactor after = viewFactor(source, object, poseAt(0, 0, 0.05, tilt + angle), {1e-13});
        EXPECT_NEAR(before.value, after.value, 20 * angle + 1e-12);
        EXPECT_LE((before.gradient - after.gradient).norm(), 200 * angle + 1e-9);
        const double z = 0.03 * std::sin(lean);
        const ViewFactor above = viewFactor(source, object, poseAt(0.2, 0, z + angle, 0, lean), {1e-13});
        const ViewFactor below = viewFactor(source, object, poseAt(0.2, 0, z - angle, 0, lean), {1e-13});
        EXPECT_NEAR(above.value, below.value, 50 * angle + 1e-12);
        EXPECT_LE((above.gradient - below.gradient).norm(), 5000 * angle + 1e-8);
        EXPECT_NE(above.visibility, Visibility::Hidden);
        EXPECT_EQ(below.visibility, Visibility::Partial);
    }
}

// Catches: a shape kind with a rule of its own going astray; the same disk given in three ways.
TEST(ViewFactor, isTheSameForADiskHoweverGiven) {
    const RadiatingContour disk(Disk{0.03});
    const RadiatingContour fourier(FourierContour({0.0, 0.0, 0.03}));
    Contour many;
    constexpr int kCorners = 2000;
    for (int i = 0; i < kCorners; ++i)
        many.points_m.emplace_back(0.03 * std::cos(2 * kPi * i / kCorners),
                                   0.03 * std::sin(2 * kPi * i / kCorners));
    const RadiatingContour polygon(many);
    for (const Pose& X_SO :
         {poseAt(0.02, 0.03, 0.1, 0.2, -0.1, 0.3), poseAt(0.02, 0.03, 0.06, 0.9, 0.3, 0.3),
          poseAt(0.2, 0.03, 0.01, 0.1, 1.0, 0.0), poseAt(0.05, 0.0, 0.01, 0.0, 0.9, 0.0)}) {
        const ViewFactor a = viewFactor({0.1}, disk, X_SO);
        const ViewFactor b = viewFactor({0.1}, fourier, X_SO);
        const ViewFactor c = viewFactor({0.1}, polygon, X_SO);
        EXPECT_NEAR(a.value, b.value, 1e-11);
        EXPECT_NEAR(a.value, c.value, 1e-5);
        EXPECT_LE((a.gradient - b.gradient).norm(), 1e-7);
        EXPECT_LE((a.gradient - c.gradient).norm(), 1e-4 * a.gradient.norm());
        EXPECT_EQ(a.visibility, c.visibility);
    }
}

// Catches: the lever with the wrong sign when the reference point moves to the end-effector.
TEST(ViewFactor, gradientAboutAnotherPointIsTheDerivativeOfTurningAboutIt) {
    const Disk source{0.1};
    const RadiatingContour object(Disk{0.02});
    const Pose X_SE = poseAt(0.03, -0.02, 0.12, 0.3, 0.1, -0.4);
    const Pose X_EO = poseAt(0.05, 0.01, 0.02, 0.1, 0.0, 0.0);
    const Pose X_SO = X_SE * X_EO;
    const Vector6d row =
        gradientAbout(viewFactor(source, object, X_SO).gradient, X_SO.translation(), X_SE.translation());
    for (int k = 0; k < 6; ++k) {
        const auto moved = [&](double step) {
            Pose X = X_SE;
            if (k < 3)
                X.translation()[k] += step;
            else
                X.linear() =
                    Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(k - 3)).toRotationMatrix() * X.linear();
            return viewFactor(source, object, X * X_EO, {1e-13, 1 << 14}).value;
        };
        EXPECT_NEAR(row[k], (moved(1e-5) - moved(-1e-5)) / 2e-5, 1e-6) << k;
    }
}

// Catches: a number for faces in one plane, where it would be 1 or 0 by a rounding error; and a refusal of
// faces that lie apart or only share an edge.
TEST(ViewFactor, refusesFacesThatOverlapInOnePlane) {
    const Contour square{{{0.05, 0.05}, {-0.05, 0.05}, {-0.05, -0.05}, {0.05, -0.05}}};
    const Contour bar{{{0.2, 0.01}, {-0.2, 0.01}, {-0.2, -0.01}, {0.2, -0.01}}};
    const RadiatingContour source(square);
    for (const Pose& X_SO : {poseAt(0, 0, 0), poseAt(0.02, 0.01, 0, 0, 0, 0.4), poseAt(0, 0, 0, kPi)}) {
        EXPECT_THROW(bask::viewFactor(source, RadiatingContour(square), X_SO), std::invalid_argument);
        EXPECT_THROW(bask::viewFactor(source, RadiatingContour(bar), X_SO), std::invalid_argument);
        EXPECT_THROW(bask::viewFactor(source, RadiatingContour(Disk{0.001}), X_SO), std::invalid_argument);
        EXPECT_THROW(bask::viewFactorValue(source, RadiatingContour(Disk{1.0}), X_SO), std::invalid_argument);
    }
    for (const Pose& X_SO : {poseAt(0.1, 0, 0), poseAt(0.1, 0.1, 0), poseAt(0.3, 0, 0)})
        EXPECT_EQ(bask::viewFactor(source, RadiatingContour(square), X_SO).value, 0.0);
}

// Catches: a broken contract that would go on as NaN into a controller.
TEST(ViewFactor, refusesWhatIsNoPoseOrNoShape) {
    const RadiatingContour object(Disk{0.02});
    EXPECT_THROW(viewFactor({0.0}, object, poseAt(0, 0, 0.1)), std::invalid_argument);
    EXPECT_THROW(viewFactor({-1.0}, object, poseAt(0, 0, 0.1)), std::invalid_argument);
    EXPECT_THROW(viewFactor({0.1}, object, poseAt(0, 0, std::nan(""))), std::invalid_argument);
    EXPECT_THROW(viewFactorValue({std::nan("")}, object, poseAt(0, 0, 0.1)), std::invalid_argument);
    EXPECT_THROW(viewFactor({0.1}, object, poseAt(1e60, 0, 1e60)), std::invalid_argument);
    EXPECT_THROW(viewFactor({0.1}, object, poseAt(0, 0, 0.1), {.tolerance = -1.0}), std::invalid_argument);
    EXPECT_THROW(viewFactor({0.1}, object, poseAt(0, 0, 0.1), {.maxPoints = 0}), std::invalid_argument);
    EXPECT_FALSE(std::signbit(viewFactor({0.1}, object, poseAt(0, 0, 1e9)).value));
    EXPECT_THROW(RadiatingContour(Disk{0.0}), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(FourierContour({0.02, 0.0, 0.0})), std::invalid_argument);
    EXPECT_THROW(RadiatingContour(Contour{{{0, 0}, {1, 0}, {2, 0}}}), std::invalid_argument);
}

} // namespace
} // namespace bask
