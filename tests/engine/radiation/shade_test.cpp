#include "engine/radiation/shade.h"

#include "app/commands/shape_json.h"
#include "engine/radiation/outline_table.h"
#include "tests/support/shaded_scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace bask {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Pose at(double x, double y, double z) {
    return Pose(Eigen::Translation3d(x, y, z));
}

// Coaxial parallel disks, from the first to the second (Howell, C-41).
double coaxial(double from, double to, double height) {
    const double r1 = from / height, r2 = to / height, s = 1.0 + (1.0 + r2 * r2) / (r1 * r1);
    return 0.5 * (s - std::sqrt(s * s - 4.0 * (r2 / r1) * (r2 / r1)));
}

Shape square(double side) {
    const double h = 0.5 * side;
    return Contour{{{-h, -h}, {h, -h}, {h, h}, {-h, h}}};
}

Shape square(double side, double x, double y) {
    Contour contour = std::get<Contour>(square(side));
    for (Eigen::Vector2d& p : contour.points_m)
        p += Eigen::Vector2d(x, y);
    return contour;
}

// Rays from random points of the object's face, by Lambert's law.
class Rays {
public:
    explicit Rays(const ShadedScene& scene, unsigned seed) : m_scene(scene), m_random(seed) {}

    /// Returns the share of the rays that reach the source, and its standard error.
    std::pair<double, double> share(int count) {
        int reached = 0;
        for (int i = 0; i < count; ++i)
            reached += reaches() ? 1 : 0;
        const double share = static_cast<double>(reached) / count;
        return {share, std::sqrt(std::max(share * (1.0 - share), 1.0 / count) / count)};
    }

private:
    bool reaches() {
        const double reach = shapeRadius(m_scene.object.shape());
        Eigen::Vector2d start;
        do
            start = {uniform(-reach, reach), uniform(-reach, reach)};
        while (!covers(m_scene.object, start));
        const double sine2 = uniform(0.0, 1.0), angle = uniform(0.0, 2.0 * kPi);
        const Vector3d way(std::sqrt(sine2) * std::cos(angle), std::sqrt(sine2) * std::sin(angle),
                           -std::sqrt(1.0 - sine2));
        const Vector3d p = m_scene.X_SO * Vector3d(start.x(), start.y(), 0.0),
                       d = m_scene.X_SO.linear() * way;
        const double far = -p.z() / d.z();
        if (p.z() <= 0.0 || d.z() >= 0.0 || !covers(m_scene.source, (p + far * d).head<2>()))
            return false;
        return std::ranges::none_of(m_scene.blockers, [&](const Blocker& blocker) {
            const Pose toBlocker = blocker.X_S.inverse();
            const Vector3d q = toBlocker * p, e = toBlocker.linear() * d;
            const double way = -q.z() / e.z();
            return way > 0.0 && way < far && covers(blocker.contour, (q + way * e).head<2>());
        });
    }

    static bool covers(const RadiatingContour& plate, const Eigen::Vector2d& p) {
        const bool inside = plate.impl().disk ? p.norm() < plate.impl().disk->radius_m
                                              : encloses(shapeOutline(plate.shape(), 400), p);
        return inside && std::ranges::none_of(holesOf(plate.shape()), [&](const Contour& hole) {
                   return encloses(hole.points_m, p);
               });
    }
    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }

    const ShadedScene& m_scene;
    std::mt19937_64 m_random;
};

ShadedViewFactor evaluate(const ShadedScene& scene, double tolerance = 1e-7) {
    return shadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers,
                            {.unshaded = {}, .tolerance = tolerance});
}

// Moves the object and, if wanted, the blockers, by a small twist [v; w] about the object's origin.
ShadedScene moved(const ShadedScene& scene, const Vector6d& twist, bool withBlockers) {
    ShadedScene result = scene;
    const Pose turn = poseFromRotationVector(Vector3d::Zero(), twist.tail<3>());
    const Vector3d p = scene.X_SO.translation();
    const Pose motion = Eigen::Translation3d(p + twist.head<3>()) * turn * Eigen::Translation3d(-p);
    result.X_SO = motion * scene.X_SO;
    for (Blocker& blocker : result.blockers)
        if (withBlockers && blocker.isHeld)
            blocker.X_S = motion * blocker.X_S;
    return result;
}

void expectGradients(const ShadedScene& scene, double tolerance) {
    const ShadedViewFactor factor = evaluate(scene, 1e-10);
    constexpr double kStep = 1e-4;
    for (int i = 0; i < 6; ++i) {
        const double step = i < 3 ? 0.02 * kStep : kStep;
        const Vector6d twist = step * Vector6d::Unit(i);
        for (const bool rigid : {false, true}) {
            const double difference = (evaluate(moved(scene, twist, rigid), 1e-10).value -
                                       evaluate(moved(scene, -twist, rigid), 1e-10).value) /
                                      (2.0 * step);
            const Vector6d& gradient = rigid ? factor.gradientRigid : factor.gradient;
            EXPECT_NEAR(gradient[i], difference, tolerance * (1.0 + gradient.head<3>().norm())) << i << rigid;
        }
    }
}

// Catches: a wrong case, a lost piece of a shadow, gradients about another point.
TEST(Shade, meetsTheReferenceCases) {
    std::ifstream file(BASK_TEST_DATA "/shading.json");
    const nlohmann::json cases = nlohmann::json::parse(file)["cases"];
    ASSERT_EQ(cases.size(), 12U);
    for (const nlohmann::json& one : cases) {
        SCOPED_TRACE(one["id"].get<std::string>());
        Failure failure;
        ShadedScene scene{RadiatingContour(readCaseShape(one["source"], {}, failure)),
                          RadiatingContour(readCaseShape(one["object"], {}, failure)),
                          readCasePose(one["pose"], {}, failure),
                          {}};
        for (const nlohmann::json& blocker : one["blockers"])
            scene.blockers.push_back({RadiatingContour(readCaseShape(blocker["shape"], {}, failure)),
                                      readCasePose(blocker["pose"], {}, failure)});
        ASSERT_FALSE(failure);
        const ShadedViewFactor factor = evaluate(scene, 1e-9);
        EXPECT_NEAR(factor.value, one["view_factor"].get<double>(), 0.2 * one["tolerance"].get<double>());
        EXPECT_NEAR(factor.unshaded, one["unshaded"].get<double>(), one["tolerance"].get<double>());
        EXPECT_LT(factor.errorEstimate, 1e-7);
        for (int i = 0; i < 6; ++i)
            EXPECT_NEAR(factor.gradientRigid[i],
                        one["gradient_rigid"][static_cast<std::size_t>(i)].get<double>(),
                        one["gradient_tolerance"].get<double>());
        // At the tolerance of a controller, the estimate holds too.
        const ShadedViewFactor quick = evaluate(scene, 1e-6);
        EXPECT_NEAR(quick.value, factor.value, quick.errorEstimate + factor.errorEstimate);
    }
}

TEST(Shade, meetsClosedFormsOfCoaxialDisks) {
    for (const double height : {0.04, 0.06}) {
        const ShadedScene scene{RadiatingContour(Disk{0.08}),
                                RadiatingContour(Disk{0.015}),
                                at(0, 0, 0.10),
                                {{RadiatingContour(Disk{0.02}), at(0, 0, height)}}};
        const ShadedViewFactor factor = evaluate(scene, 1e-11);
        EXPECT_NEAR(factor.value, coaxial(0.015, 0.08, 0.10) - coaxial(0.015, 0.02, 0.10 - height), 1e-10);
        // What the blocker takes does not change when both move as one.
        EXPECT_NEAR(factor.gradientRigid[2], viewFactor(scene.source, scene.object, scene.X_SO).gradient[2],
                    1e-9);
        EXPECT_GT(factor.gradient[2], factor.gradientRigid[2]);
    }
}

// The values are those of the project's specification, from a closed form for polygons integrated over the
// face.
TEST(Shade, meetsSquaresOverAQuadrant) {
    const RadiatingContour unit(square(1.0));
    const Pose turned = at(0, 0, 1.0);
    const ShadedScene quadrant{
        unit, unit, turned, {{RadiatingContour(square(0.5, 0.25, 0.25)), at(0, 0, 0.5)}}};
    EXPECT_NEAR(evaluate(quadrant, 1e-11).value, 0.149868671774, 1e-10);
    const ShadedScene centred{unit, unit, turned, {{RadiatingContour(square(0.5)), at(0, 0, 0.5)}}};
    EXPECT_NEAR(evaluate(centred, 1e-11).value, 0.0995062946, 1e-10);
}

// Catches: shade where there is none, and a result that differs by rounding from the one without blockers.
TEST(Shade, leavesTheSameBitsWhereNothingIsBetween) {
    const RadiatingContour source(Disk{0.1}), object(Disk{0.02});
    const Pose X_SO = poseFromRotationVector({0.01, 0.02, 0.08}, {0.2, -0.1, 0.3});
    const ViewFactor plain = viewFactor(source, object, X_SO);
    const RadiatingContour plate(Disk{0.03});
    const Pose beside = X_SO * at(0.06, 0.0, 0.0), behind = X_SO * at(0.01, 0.0, 0.02),
               below = at(0, 0, -0.01), aside = at(0.3, 0.0, 0.04);
    for (const Pose& X_S : {beside, behind, below, aside}) {
        const std::vector<Blocker> blockers{{plate, X_S}};
        const ShadedViewFactor factor = shadedViewFactor(source, object, X_SO, blockers);
        EXPECT_EQ(factor.value, plain.value);
        EXPECT_EQ(factor.gradient, plain.gradient);
        EXPECT_EQ(factor.gradientRigid, plain.gradient);
        EXPECT_EQ(factor.errorEstimate, plain.errorEstimate);
    }
}

TEST(Shade, isTotalBehindAWall) {
    const ShadedScene scene{RadiatingContour(Disk{0.05}),
                            RadiatingContour(Disk{0.02}),
                            at(0, 0, 0.10),
                            {{RadiatingContour(square(0.4)), at(0.01, 0, 0.05)}}};
    const ShadedViewFactor factor = evaluate(scene);
    EXPECT_NEAR(factor.value, 0.0, 1e-9);
    EXPECT_LT(factor.gradient.norm(), 1e-6);
    EXPECT_GT(factor.unshaded, 0.1);
}

TEST(Shade, countsHolesOfAllFaces) {
    const Contour hole = std::get<Contour>(square(0.02));
    const ShadedScene scene{RadiatingContour(withHoles(Disk{0.08}, {hole})),
                            RadiatingContour(withHoles(square(0.06), {hole})),
                            poseFromRotationVector({0.01, 0.0, 0.09}, {0.2, 0.1, 0.0}),
                            {{RadiatingContour(withHoles(Disk{0.03}, {hole})), at(0.0, 0.01, 0.03)}}};
    const ShadedViewFactor factor = evaluate(scene);
    const auto [share, error] = Rays(scene, 3).share(400000);
    EXPECT_NEAR(factor.value, share, 4.0 * error);
    expectGradients(scene, 2e-4);
}

// Three plates, one of them steep, one that crosses the object's plane beside it, one that another one hides.
TEST(Shade, countsOverlappingShadowsOnce) {
    const ShadedScene scene{
        RadiatingContour(Disk{0.1}),
        RadiatingContour(Disk{0.02}),
        at(0, 0, 0.08),
        {{RadiatingContour(Disk{0.02}), at(0.02, 0, 0.04)},
         {RadiatingContour(square(0.03)), at(0.025, 0.0, 0.02)},
         {RadiatingContour(square(0.04)), poseFromRotationVector({-0.03, 0.01, 0.075}, {0.0, 1.3, 0.0})}}};
    const ShadedViewFactor factor = evaluate(scene);
    const auto [share, error] = Rays(scene, 4).share(400000);
    EXPECT_NEAR(factor.value, share, 4.0 * error);
    expectGradients(scene, 2e-4);
}

// From the middle of a tilted object's edge, a plate beside it is seen from the edge: to rounding, from above
// or from below.
TEST(Shade, isRightForAPlateSeenFromItsEdge) {
    const RadiatingContour source(Disk{0.1}), object(square(0.04)), plate(Disk{0.02});
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> angle(0.5, 1.0), tilt(-0.15, 0.15);
    for (int i = 0; i < 100; ++i) {
        const Pose X_SE =
            poseFromRotationVector(Vector3d(-0.05, 0.0, 0.06), {tilt(random), angle(random), 0.0});
        const Pose X_EO = poseFromRotationVector(Vector3d(0.0, 0.0, 0.0), {tilt(random), 0.0, 0.0});
        const auto shaded = [&](double lift_m) {
            const Blocker beside{plate, X_SE * at(0.045, 0.01, lift_m)};
            return shadedViewFactor(source, object, X_SE * X_EO, {&beside, 1},
                                    {.unshaded = {}, .tolerance = 1e-6});
        };
        const ShadedViewFactor even = shaded(0.0), lifted = shaded(1e-8);
        EXPECT_LT(even.errorEstimate, 2e-6);
        EXPECT_LT(even.value, even.unshaded);
        EXPECT_NEAR(even.value, lifted.value, 5e-6);
        EXPECT_TRUE(even.gradientRigid.allFinite());
    }
}

// Catches: a shield that moves with the end-effector although it stands with the source.
TEST(Shade, letsAShieldStand) {
    ShadedScene scene{RadiatingContour(Disk{0.1}),
                      RadiatingContour(Disk{0.02}),
                      at(0.01, 0, 0.08),
                      {{RadiatingContour(Disk{0.02}), at(0.04, 0.03, 0.04)},
                       {RadiatingContour(Disk{0.01}), at(0, 0, 0.04)}}};
    scene.blockers[0].isHeld = false;
    expectGradients(scene, 2e-4);
    scene.blockers[1].isHeld = false;
    expectGradients(scene, 2e-4);
    const ShadedViewFactor factor = evaluate(scene, 1e-10);
    EXPECT_LT((factor.gradient - factor.gradientRigid).norm(), 1e-6);
}

TEST(Shade, refusesPlatesThatPassThroughAFace) {
    const RadiatingContour source(Disk{0.1}), object(Disk{0.02}), plate(Disk{0.03});
    const Pose upright = poseFromRotationVector(Vector3d::Zero(), {1.2, 0.0, 0.0});
    const std::vector<Blocker> throughObject{{plate, at(0.01, 0, 0.08) * upright}},
        throughSource{{plate, at(0, 0.05, 0) * upright}};
    EXPECT_THROW(shadedViewFactor(source, object, at(0, 0, 0.08), throughObject), std::invalid_argument);
    EXPECT_THROW(shadedViewFactor(source, object, at(0, 0, 0.08), throughSource), std::invalid_argument);
    // Beside the face it may cross its plane.
    const std::vector<Blocker> besideObject{{plate, at(0.05, 0, 0.08) * upright}};
    const ShadedViewFactor factor = shadedViewFactor(source, object, at(0, 0, 0.08), besideObject);
    EXPECT_LT(factor.value, factor.unshaded);
}

// From beside the hull to a shadow within the source and out again: what the value changes is what the
// gradient says, so no border between the cases shows.
TEST(Shade, isContinuousThroughItsCases) {
    const RadiatingContour source(Disk{0.08}), object(Disk{0.01}), plate(Disk{0.012});
    double last = 0.0, lastSlope = 0.0;
    constexpr int kSteps = 400;
    const double step = 0.24 / kSteps;
    for (int i = 0; i <= kSteps; ++i) {
        const ShadedScene scene{
            source, object, at(0.0, 0.0, 0.1), {{plate, at(-0.12 + step * i, 0.002, 0.05)}}};
        const ShadedViewFactor factor = evaluate(scene, 1e-9);
        const double slope = factor.gradientRigid[0] - factor.gradient[0]; // by the blocker alone
        if (i > 0) {
            EXPECT_NEAR(factor.value - last, 0.5 * step * (slope + lastSlope), 5e-6) << i;
        }
        last = factor.value;
        lastSlope = slope;
    }
}

// Within bounds, as rays say, and as exact as it says.
TEST(Shade, isRightInRandomScenes) {
    ShadedScenes scenes(7);
    int shaded = 0, far = 0, dishonest = 0;
    constexpr int kScenes = 250;
    for (int i = 0; i < kScenes; ++i) {
        SCOPED_TRACE(i);
        const ShadedScene scene = scenes.next(1 + i % 3);
        const ShadedViewFactor factor = evaluate(scene, 1e-6);
        ASSERT_GE(factor.value, 0.0);
        ASSERT_LE(factor.value, factor.unshaded);
        if (factor.value == factor.unshaded)
            continue;
        ++shaded;
        const auto [share, error] = Rays(scene, 100U + static_cast<unsigned>(i)).share(6000);
        EXPECT_NEAR(factor.value, share, 5.5 * error);
        far += std::abs(factor.value - share) > 3.0 * error ? 1 : 0;
        const ShadedViewFactor fine = evaluate(scene, 1e-9);
        dishonest += std::abs(factor.value - fine.value) > factor.errorEstimate + fine.errorEstimate ? 1 : 0;
        EXPECT_NEAR(factor.value, fine.value, 1e-5);
    }
    EXPECT_GT(shaded, kScenes / 4);
    EXPECT_LE(far, 4);
    EXPECT_LE(dishonest, 1);
}

} // namespace
} // namespace bask
