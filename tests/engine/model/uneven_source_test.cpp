// Uneven sources of an experiment: rings of a radial profile, and what parts are refused.

#include "engine/model/uneven_source.h"

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bask {
namespace {

Experiment example() {
    return readExperiment(BASK_EXAMPLES "/two-circles.json").value();
}

SourcePartSpec part(const Shape& shape, const Vector6d& pose = Vector6d::Zero(), double ratio = 1.0) {
    SourcePartSpec made;
    made.shape = shape;
    made.pose = pose;
    made.temperatureRatio = ratio;
    return made;
}

Vector6d at(double x, double y, double z, double theta_y = 0.0) {
    Vector6d q = Vector6d::Zero();
    q << x, y, z, 0.0, theta_y, 0.0;
    return q;
}

Contour box(double x, double y) {
    Contour contour;
    contour.points_m = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
    return contour;
}

Error refusal(const Experiment& e) {
    const auto valid = validate(e);
    return valid ? Error() : valid.error();
}

Experiment withParts(std::vector<SourcePartSpec> parts) {
    Experiment e = example();
    e.source.uneven.parts = std::move(parts);
    return e;
}

/// F of a small face over the axis, at the height z.
double onAxis(const UnevenSource& source, double source_K, double z_m) {
    const RadiatingSource radiating(source.terms, source.emission.factors(source_K));
    const Pose X_SO(Eigen::Translation3d(0.0, 0.0, z_m));
    return viewFactorValue(radiating, RadiatingContour(Disk{1e-7}), X_SO, 1e-12);
}

} // namespace

// A source hardly warmer than the room, whose weight is linear in its temperature but for 4e-7:
// F = w(R) f(R) - b (R - z atan(R / z)) for w = a + b r and f(r) = r^2 / (r^2 + z^2).
TEST(UnevenSource, RingsOfALinearProfileMeetTheClosedForm) {
    Experiment e = example();
    const double R = std::get<Disk>(e.source.shape).radius_m;
    e.source.uneven.profile = {{0.0, 1.2}, {R, 0.4}};
    e.robot.clearance_m = 0.01;
    const UnevenSource source = unevenSource(e, e.source.uneven, e.source.emittance);
    EXPECT_LT(source.terms.size(), 50u);
    EXPECT_LT(source.ringError, 1e-6);
    const double b = -0.8 / R;
    for (const double z : {0.01, 0.03, 0.1, 0.3}) {
        const double expected = 0.4 * R * R / (R * R + z * z) - b * (R - z * std::atan(R / z));
        EXPECT_NEAR(onAxis(source, e.environment_K + 1e-3, z), expected, source.ringError + 5e-7) << z;
    }
}

// Catches: an error that is told too small, by the integral over many thin rings.
TEST(UnevenSource, TellsTheErrorOfItsRings) {
    Experiment e = example();
    const double R = std::get<Disk>(e.source.shape).radius_m;
    e.source.uneven.profile = {{0.01, 1.0, 3.0}, {0.04, 1.0, -5.0}, {0.05, 1.1}, {0.09, 0.6}};
    for (const double clearance_m : {0.001, 0.005, 0.02}) {
        e.robot.clearance_m = clearance_m;
        const UnevenSource source = unevenSource(e, e.source.uneven, e.source.emittance);
        EXPECT_LE(source.terms.size(), kMaxRings + 64);
        const SourceEmission& emission = source.emission;
        constexpr int kThin = 400000;
        for (const double z : {clearance_m, 3.0 * clearance_m}) {
            double sum = 0.0;
            for (int k = 0; k < kThin; ++k) {
                const double r = (k + 0.5) / kThin * R, dr = R / kThin;
                const std::vector<ProfilePoint>& p = e.source.uneven.profile;
                PartTemperature T{p.back().temperatureRatio, p.back().temperatureOffset_K};
                if (r <= p.front().radius_m)
                    T = {p.front().temperatureRatio, p.front().temperatureOffset_K};
                for (std::size_t i = 0; i + 1 < p.size(); ++i)
                    if (r > p[i].radius_m && r <= p[i + 1].radius_m) {
                        const double share = (r - p[i].radius_m) / (p[i + 1].radius_m - p[i].radius_m);
                        T = {std::lerp(p[i].temperatureRatio, p[i + 1].temperatureRatio, share),
                             std::lerp(p[i].temperatureOffset_K, p[i + 1].temperatureOffset_K, share)};
                    }
                const double T_K = T.at_K(e.source.temperature_K, e.environment_K);
                const double w = (std::pow(T_K, 4) - std::pow(e.environment_K, 4)) /
                                 (std::pow(e.source.temperature_K, 4) - std::pow(e.environment_K, 4));
                sum += w * 2.0 * r * z * z / std::pow(r * r + z * z, 2) * dr;
            }
            EXPECT_NEAR(onAxis(source, e.source.temperature_K, z), sum, source.ringError + 1e-7)
                << clearance_m << ' ' << z;
        }
        EXPECT_EQ(emission.terms.size(), source.terms.size());
    }
}

TEST(UnevenSource, AFlatProfileIsTheDiskItself) {
    Experiment e = example();
    e.source.uneven.profile = {{0.0}, {0.05}, {0.1}};
    const RadiatingSource source = radiatingSource(e);
    EXPECT_TRUE(source.isEven());
    const auto even = rigGeometry(example()), flat = rigGeometry(e);
    EXPECT_EQ(even->viewFactors(e.start).F, flat->viewFactors(e.start).F);
    EXPECT_EQ(even->viewFactors(e.start).dF, flat->viewFactors(e.start).dF);
    EXPECT_EQ(even->viewFactorsFast(e.start), flat->viewFactorsFast(e.start));
}

// Catches: weights that stay those of the set point while the source is colder.
TEST(UnevenSource, WeighsByThePresentTemperature) {
    Experiment e = withParts({part(Disk{0.04}, at(-0.05, 0, 0)), part(Disk{0.04}, at(0.05, 0, 0), 0.5)});
    const auto geometry = rigGeometry(e);
    EXPECT_FALSE(geometry->isSourceEven());
    EXPECT_EQ(geometry->maxViewFactor(), 1.0);
    Vector6d q = e.start;
    q[kX] = 0.05;
    const double hot = geometry->viewFactors(q).F[0];
    const double cold = geometry->withSourceTemperature(e.environment_K + 5.0)->viewFactors(q).F[0];
    EXPECT_GT(cold, 1.05 * hot); // nearer to 0.5 than to 0.35 for the part in front
    EXPECT_EQ(geometry->withSourceTemperature(e.source.temperature_K)->viewFactors(q).F,
              geometry->viewFactors(q).F);
    e.source.uneven.parts[1].temperatureRatio = 1.2;
    EXPECT_GT(rigGeometry(e)->maxViewFactor(), 1.2);
}

TEST(UnevenSource, TwoSourcesSideBySideAndATiltedOneAreTaken) {
    EXPECT_TRUE(validate(withParts({part(Disk{0.04}, at(-0.05, 0, 0)), part(Disk{0.04}, at(0.05, 0, 0))})));
    // A roof: each slopes away from the other, below the plane of S.
    EXPECT_TRUE(validate(withParts({part(box(0.03, 0.04), at(-0.031, 0, -0.009, -0.3)),
                                    part(box(0.03, 0.04), at(0.031, 0, -0.009, 0.3))})));
}

TEST(UnevenSource, RefusesPartsWithPlaceAndReason) {
    const auto refused = [](std::vector<SourcePartSpec> parts) {
        return refusal(withParts(std::move(parts)));
    };
    Error error = refused({part(Disk{0.04}), part(Disk{0.04}, at(0.05, 0, 0))});
    EXPECT_EQ(error.code(), MessageCode::SourcePartsOverlap);
    EXPECT_EQ(error.where, "source.parts[1]");
    error = refused({part(Disk{0.04}), part(Disk{0.04}, at(0.09, 0, 0))});
    EXPECT_EQ(error.code(), MessageCode::SourcePartOutside);
    EXPECT_EQ(error.where, "source.parts[1]");
    error = refused({part(Disk{0.04}, at(0, 0, 0.002))});
    EXPECT_EQ(error.code(), MessageCode::SourcePartRaised);
    EXPECT_EQ(refused({part(Disk{0.02}, at(0, 0, -0.03, 3.0))}).code(), MessageCode::SourcePartTurned);
    // A bowl: they look at each other. One above another: it hides it.
    EXPECT_EQ(refused({part(box(0.03, 0.04), at(-0.04, 0, -0.02, 0.3)),
                       part(box(0.03, 0.04), at(0.04, 0, -0.02, -0.3))})
                  .code(),
              MessageCode::SourcePartShades);
    error = refused({part(Disk{0.05}, at(0, 0, -0.02)), part(Disk{0.02})});
    EXPECT_EQ(error.code(), MessageCode::SourcePartShades);
    EXPECT_EQ(error.where, "source.parts[1]");
    EXPECT_EQ(refused({part(Disk{0.04}, at(0, 0, 0), 0.0)}).code(), MessageCode::SourceTooWeak);
    EXPECT_EQ(refused({part(Disk{0.0})}).where, "source.parts[0].contour.radius_m");
    EXPECT_EQ(refused({part(Disk{0.04}, at(0, 0, std::nan("")))}).where, "source.parts[0].pose.z_cm");
    EXPECT_EQ(refused(std::vector(65, part(Disk{0.001}))).where, "source.parts");

    Experiment e = example();
    e.simulation.sourceUneven = Unevenness{{part(Disk{0.2})}, {}};
    EXPECT_EQ(refusal(e).where, "simulation.source_parts[0]");
}

TEST(UnevenSource, RefusesProfilesWithPlaceAndReason) {
    const auto refused = [](std::vector<ProfilePoint> profile) {
        Experiment e = example();
        e.source.uneven.profile = std::move(profile);
        return refusal(e);
    };
    EXPECT_EQ(refused({{0.0}, {0.03}, {0.03}}).code(), MessageCode::RadiiNotGrowing);
    EXPECT_EQ(refused({{0.0}, {0.03}, {0.02}}).where, "source.profile[2].radius_mm");
    EXPECT_EQ(refused({{-0.01}}).where, "source.profile[0].radius_mm");
    EXPECT_EQ(refused({{std::nan("")}}).where, "source.profile[0].radius_mm");
    EXPECT_EQ(refused({{0.0}, {0.11}}).where, "source.profile[1].radius_mm");
    EXPECT_EQ(refused({{0.0, -0.1}}).where, "source.profile[0].temperature_ratio");
    EXPECT_EQ(refused({{0.0, 1.0, std::nan("")}}).where, "source.profile[0].temperature_offset_K");
    EXPECT_EQ(refused({{0.0, 0.0}}).code(), MessageCode::SourceTooWeak);
    Experiment e = example();
    e.source.uneven = {{part(Disk{0.02})}, {{0.0, 0.9}}};
    EXPECT_EQ(refusal(e).code(), MessageCode::JsonTwoSpellings);
    e.source.uneven = {{}, {{0.0, 0.9}}};
    e.source.shape = box(0.1, 0.1);
    EXPECT_EQ(refusal(e).code(), MessageCode::ProfileNeedsDisk);
}

} // namespace bask
