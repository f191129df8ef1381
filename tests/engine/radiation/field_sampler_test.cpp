#include "engine/base/message_code.h"
#include "engine/radiation/field_sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>

namespace bask {
namespace {

const RadiatingContour kSource{Disk{0.10}};
const RadiatingContour kObject{Disk{0.015}};

FieldRequest request(std::vector<FieldAxis> axes) {
    FieldRequest out{kSource, kObject, std::move(axes)};
    out.fixed << 0.03, -0.02, 0.06, 0.3, -0.4, 0.5;
    return out;
}

/// A few values of each coordinate; none of them puts the object into the source plane.
FieldAxis axisOf(Coordinate coordinate) {
    constexpr std::array<double, 6> kFirst{-0.08, -0.05, 0.04, -0.7, -1.1, 0.2};
    constexpr std::array<double, 6> kStep{0.03, 0.07, 0.05, 0.45, 0.6, 0.9};
    constexpr std::array<int, 6> kCount{4, 3, 3, 4, 4, 3};
    return {coordinate, kFirst[coordinate], kStep[coordinate], kCount[coordinate]};
}

std::shared_ptr<const Field> sampled(const FieldRequest& asked, const FieldRun& run = {}) {
    auto field = sampleField(asked, run);
    EXPECT_TRUE(field) << (field ? "" : describe(field.error()));
    return field ? *field : nullptr;
}

Vector6d coordinatesOf(const FieldRequest& asked, std::size_t sample) {
    Vector6d q = asked.fixed;
    for (const FieldAxis& axis : asked.axes) {
        q[axis.coordinate] = axis.at(static_cast<int>(sample % axis.count));
        sample /= axis.count;
    }
    return q;
}

double valueAt(const FieldRequest& asked, const Vector6d& q) {
    return viewFactorValue(kSource, kObject, asked.X_RS.inverse() * poseFromCoordinates(q) * asked.X_EO,
                           asked.tolerance);
}

void expectSinglesAgree(const FieldRequest& asked) {
    const auto field = sampled(asked);
    ASSERT_TRUE(field);
    std::size_t count = 1;
    for (const FieldAxis& axis : asked.axes)
        count *= static_cast<std::size_t>(axis.count);
    ASSERT_EQ(field->values.size(), count);
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_NEAR(field->values[i], valueAt(asked, coordinatesOf(asked, i)), 1e-13) << "sample " << i;
    EXPECT_EQ(field->undefinedSamples, 0u);
    EXPECT_TRUE(field->gradient.empty());
}

void walkCombinations(std::vector<FieldAxis>& axes) {
    if (!axes.empty())
        expectSinglesAgree(request(axes));
    if (axes.size() == kMaxAxes)
        return;
    for (int c = 0; c < 6; ++c) {
        const auto coordinate = static_cast<Coordinate>(c);
        bool used = false;
        for (const FieldAxis& axis : axes)
            used |= axis.coordinate == coordinate;
        if (used)
            continue;
        axes.push_back(axisOf(coordinate));
        walkCombinations(axes);
        axes.pop_back();
    }
}

// Catches: a field that says 1e-9 where points ran out: equal outlines a hair apart, of which one is summed.
TEST(FieldSampler, saysWhereTheToleranceWasNotReached) {
    const RadiatingContour circle(FourierContour({0.0, 0.0, 0.05}));
    FieldRequest request{circle, circle, {{kThetaX, 0.0, 0.5, 2}}};
    request.fixed[kZ] = 2e-5;
    const auto near = sampleField(request, {});
    ASSERT_TRUE(near);
    EXPECT_GE((*near)->unreachedSamples, 1u);
    EXPECT_GT((*near)->largestErrorEstimate, 1e-9);
    request.fixed[kZ] = 0.1;
    const auto apart = sampleField(request, {});
    ASSERT_TRUE(apart);
    EXPECT_EQ((*apart)->unreachedSamples, 0u);
    EXPECT_LE((*apart)->largestErrorEstimate, 1.01e-9);
}

// Catches: axes in the wrong order, a rotation not made anew when an angle changes, a held value forgotten;
// in all 516 ordered choices of one to four axes.
TEST(FieldSampler, agreesWithSingleCallsInEveryChoiceOfAxes) {
    std::vector<FieldAxis> axes;
    walkCombinations(axes);
}

// Catches: the mounting left out, or multiplied from the wrong side.
TEST(FieldSampler, putsTheMountingBehindThePose) {
    FieldRequest asked = request({axisOf(kX), axisOf(kThetaY), axisOf(kThetaZ)});
    asked.X_EO = poseFromCoordinates((Vector6d() << 0.02, -0.03, 0.01, 0.1, 0.2, 0.3).finished());
    expectSinglesAgree(asked);
}

/// A source off the base and turned about every axis.
Pose movedSource() {
    return poseFromCoordinates((Vector6d() << 0.01, 0.02, -0.015, -0.1, 0.15, 0.8).finished());
}

// Catches: coordinates of the source's frame where those of the robot's base are meant.
TEST(FieldSampler, theCoordinatesAreOfTheBaseTheSourceLiesIn) {
    FieldRequest asked = request({axisOf(kX), axisOf(kThetaY), axisOf(kThetaZ)});
    asked.X_RS = movedSource();
    expectSinglesAgree(asked);
    asked.X_EO = poseFromCoordinates((Vector6d() << 0.02, -0.03, 0.01, 0.1, 0.2, 0.3).finished());
    expectSinglesAgree(asked);
}

// Catches: a pose left out that the plates can take, or kept that they cannot; a height over the base's plane
// instead of the source's.
TEST(FieldSampler, leavesOutWhatIsTooLow) {
    FieldRequest asked = request({{kZ, -0.06, 0.005, 40}, axisOf(kThetaX), axisOf(kThetaY)});
    asked.X_RS = movedSource();
    asked.withGradient = true;
    asked.minHeight_m = 0.01;
    const auto field = sampled(asked);
    std::size_t leftOut = 0;
    for (std::size_t i = 0; i < field->values.size(); ++i) {
        const Pose X_SO = asked.X_RS.inverse() * poseFromCoordinates(coordinatesOf(asked, i));
        double lowest_m = 1.0;
        for (const Eigen::Vector2d& p : shapeOutline(kObject.shape(), 1000))
            lowest_m = std::min(lowest_m, (X_SO * Eigen::Vector3d(p.x(), p.y(), 0.0)).z());
        if (std::abs(lowest_m - 0.01) < 1e-4)
            continue; // within the outline's points
        ASSERT_EQ(std::isnan(field->values[i]), lowest_m < 0.01) << "sample " << i;
        ASSERT_EQ(std::isnan(field->gradient[6 * i]), lowest_m < 0.01) << "sample " << i;
        leftOut += lowest_m < 0.01;
    }
    EXPECT_GT(leftOut, 50u);
    EXPECT_LT(leftOut, field->values.size() - 50u);
}

// Catches: a chunk's edge that starts at the wrong sample, on a grid of many chunks with odd counts.
TEST(FieldSampler, agreesAcrossChunks) {
    expectSinglesAgree(request({{kZ, 0.03, 0.002, 37}, {kThetaX, -1.2, 0.11, 23}, {kX, -0.1, 0.05, 5}}));
}

void expectSlopes(FieldRequest asked) {
    asked.withGradient = true;
    asked.tolerance = 1e-13;
    const auto field = sampled(asked);
    ASSERT_EQ(field->gradient.size(), 6 * field->values.size());
    constexpr double kStep = 1e-4;
    for (std::size_t i = 0; i < field->values.size(); ++i) {
        const Vector6d q = coordinatesOf(asked, i);
        for (int c = 0; c < 6; ++c) {
            const Vector6d d = kStep * Vector6d::Unit(c);
            const double slope = (8.0 * (valueAt(asked, q + d) - valueAt(asked, q - d)) -
                                  valueAt(asked, q + 2.0 * d) + valueAt(asked, q - 2.0 * d)) /
                                 (12.0 * kStep);
            ASSERT_NEAR(field->gradient[6 * i + c], slope, 1e-6) << "sample " << i << ", coordinate " << c;
        }
    }
}

// Catches: a gradient about the wrong point, by the wrong angles or in the source's axes: it must be what the
// field itself does along its axes.
TEST(FieldSampler, gradientIsTheSlopeByTheCoordinates) {
    FieldRequest asked = request({axisOf(kY), axisOf(kThetaX), axisOf(kThetaZ)});
    asked.X_EO = poseFromCoordinates((Vector6d() << 0.02, -0.03, 0.01, 0.1, 0.2, 0.3).finished());
    expectSlopes(asked);
    asked.X_RS = movedSource();
    expectSlopes(asked);
}

// Catches: samples at one theta_z taken for those at another where they are not, or gradients that are not
// turned with it.
TEST(FieldSampler, turnedAboutTheAxisOfADiskItSeesTheSame) {
    for (const std::vector<Coordinate>& order :
         {std::vector{kThetaX, kThetaY, kThetaZ}, {kThetaZ, kZ, kThetaX}, {kThetaY, kThetaZ, kZ}}) {
        std::vector<FieldAxis> axes;
        axes.reserve(order.size());
        for (const Coordinate coordinate : order)
            axes.push_back(axisOf(coordinate));
        FieldRequest asked = request(axes);
        asked.fixed[kX] = asked.fixed[kY] = 0.0;
        expectSinglesAgree(asked);
        expectSlopes(asked);
        asked.fixed[kY] = 0.01;
        expectSinglesAgree(asked);
    }
}

// Catches: numbers that depend on who computed them.
TEST(FieldSampler, isTheSameOnAnyNumberOfThreads) {
    FieldRequest asked = request({{kX, -0.2, 0.01, 40}, {kThetaY, -1.5, 0.05, 60}});
    asked.withGradient = true;
    const auto one = sampled(asked, {1, {}, {}});
    for (const int threads : {0, 2, 3, 16}) {
        const auto many = sampled(asked, {threads, {}, {}});
        EXPECT_EQ(0, std::memcmp(one->values.data(), many->values.data(), one->values.size() * 8));
        EXPECT_EQ(0, std::memcmp(one->gradient.data(), many->gradient.data(), one->gradient.size() * 8));
    }
}

// Catches: progress that falls, repeats, never ends, or is called once a sample.
TEST(FieldSampler, progressRisesToOne) {
    for (const int threads : {1, 2}) {
        std::vector<double> seen;
        const auto caller = std::this_thread::get_id();
        FieldRun run{threads, {}, [&](double done) {
                         EXPECT_EQ(std::this_thread::get_id(), caller);
                         seen.push_back(done);
                     }};
        sampled(request({{kX, -0.2, 0.001, 400}, {kY, -0.2, 0.004, 100}}), run);
        ASSERT_FALSE(seen.empty());
        EXPECT_LE(seen.size(), 101u);
        for (std::size_t i = 1; i < seen.size(); ++i)
            EXPECT_GT(seen[i], seen[i - 1]);
        EXPECT_GT(seen.front(), 0.0);
        EXPECT_EQ(seen.back(), 1.0);
    }
}

// Catches: a cancelled sampling that goes on, or gives a half-filled field as if it were one.
TEST(FieldSampler, stopsWhenAsked) {
    const FieldRequest asked = request({{kX, -0.2, 0.0001, 4000}, {kThetaX, -1.5, 0.003, 1000}});
    for (const int threads : {1, 2}) {
        std::stop_source stop;
        double last = 0.0;
        const auto field = sampleField(asked, {threads, stop.get_token(), [&](double done) {
                                                   last = done;
                                                   stop.request_stop();
                                               }});
        ASSERT_FALSE(field);
        EXPECT_EQ(field.error().code(), MessageCode::FieldCancelled);
        EXPECT_LT(last, 1.0);
    }
    std::stop_source before;
    before.request_stop();
    EXPECT_FALSE(sampleField(asked, {0, before.get_token(), {}}));
}

// Catches: what the caller's functions throw ends the program, or is taken for an undefined sample.
TEST(FieldSampler, letsTheCallersExceptionsThrough) {
    FieldRequest asked = request({{kX, -0.2, 0.001, 400}, {kY, -0.2, 0.004, 100}});
    const auto refuse = [](double) -> double { throw std::invalid_argument("mine"); };
    EXPECT_THROW((void)sampleField(asked, {2, {}, [&](double done) { refuse(done); }}),
                 std::invalid_argument);
    asked.quantity.fromViewFactor = refuse;
    EXPECT_THROW((void)sampleField(asked, {2, {}, {}}), std::invalid_argument);
}

// Catches: a mapped quantity that loses its name, or maps the gradient too.
TEST(FieldSampler, mapsTheViewFactor) {
    FieldRequest asked = request({axisOf(kX), axisOf(kZ)});
    asked.withGradient = true;
    const auto plain = sampled(asked);
    EXPECT_EQ(plain->quantity, "view_factor");
    asked.quantity = {"steady_temperature", "K", [](double F) { return 300.0 + 100.0 * F; }};
    const auto mapped = sampled(asked);
    EXPECT_EQ(mapped->quantity, "steady_temperature");
    EXPECT_EQ(mapped->unit, "K");
    EXPECT_EQ(mapped->gradient, plain->gradient);
    for (std::size_t i = 0; i < plain->values.size(); ++i)
        EXPECT_EQ(mapped->values[i], 300.0 + 100.0 * plain->values[i]);
}

// Catches: one overlapping pose in the source plane that ends the sampling, is a number, or is not counted.
TEST(FieldSampler, posesWithoutAViewFactorAreNaNAndCounted) {
    FieldRequest asked{kSource, kObject, {{kX, -0.3, 0.05, 13}, {kZ, 0.0, 0.05, 2}}};
    asked.withGradient = true;
    const auto field = sampled(asked);
    std::size_t undefined = 0;
    for (std::size_t i = 0; i < field->values.size(); ++i) {
        const Pose X_SO = poseFromCoordinates(coordinatesOf(asked, i));
        bool refused = false;
        try {
            (void)viewFactorValue(kSource, kObject, X_SO);
        } catch (const std::invalid_argument&) {
            refused = true;
        }
        EXPECT_EQ(std::isnan(field->values[i]), refused) << i;
        EXPECT_EQ(std::isnan(field->gradient[6 * i + 5]), refused) << i;
        undefined += refused;
    }
    EXPECT_EQ(field->undefinedSamples, undefined);
    EXPECT_EQ(undefined, 5u) << "x from -10 to 10 cm in the source plane";
}

void expectRefused(const FieldRequest& asked, MessageCode code, const std::string& words) {
    const auto field = sampleField(asked);
    ASSERT_FALSE(field) << words;
    EXPECT_EQ(field.error().code(), code) << describe(field.error());
    EXPECT_NE(describe(field.error()).find(words), std::string::npos) << describe(field.error());
}

// Catches: a request that cannot be meant, sampled all the same or refused without saying where.
TEST(FieldSampler, refusesWhatIsNoGrid) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInf = std::numeric_limits<double>::infinity();
    const FieldAxis x = axisOf(kX);
    expectRefused(request({}), MessageCode::ValueOutOfRange, "axes: 0");
    expectRefused(
        request({x, axisOf(kY), axisOf(kZ), axisOf(kThetaX), axisOf(kThetaY), axisOf(kThetaZ), axisOf(kX)}),
        MessageCode::ValueOutOfRange, "axes: 7");
    expectRefused(request({x, axisOf(kY), x}), MessageCode::AxisTwice, "\"x\"");
    expectRefused(request({{kThetaZ, 0.0, 0.0, 3}}), MessageCode::ValueNotPositive, "theta_z: step: 0");
    expectRefused(request({{kZ, 0.0, -0.1, 3}}), MessageCode::ValueNotPositive, "z: step: -0.1");
    expectRefused(request({{kZ, 0.0, kNaN, 3}}), MessageCode::ValueNotPositive, "z: step: nan");
    expectRefused(request({{kZ, 0.0, 0.1, 0}}), MessageCode::ValueNotPositive, "z: count: 0");
    expectRefused(request({{kZ, kNaN, 0.1, 3}}), MessageCode::ValueOutOfRange, "z: first: nan");
    expectRefused(request({{kZ, -kInf, 0.1, 3}}), MessageCode::ValueOutOfRange, "z: first: -inf");
    expectRefused(request({{kZ, 0.0, 1e9, 2}}), MessageCode::ValueOutOfRange, "z: last: 1000000000");
    expectRefused(request({{kZ, 1.0, 1e-12, 3}}), MessageCode::ValueOutOfRange, "z: step: 1e-12");
    FieldRequest fixed = request({x});
    fixed.fixed[kThetaY] = kNaN;
    expectRefused(fixed, MessageCode::ValueOutOfRange, "held: theta_y: nan");
    fixed = request({x});
    fixed.fixed[kX] = kNaN; // has an axis: does not count
    EXPECT_TRUE(sampleField(fixed));
    FieldRequest loose = request({x});
    for (const double tolerance : {0.0, -1e-9, kNaN, 1.0}) {
        loose.tolerance = tolerance;
        expectRefused(loose, MessageCode::ValueOutOfRange, "tolerance");
    }
    const auto threads = sampleField(request({x}), {-1, {}, {}});
    ASSERT_FALSE(threads);
    EXPECT_EQ(threads.error().where, "threads");
}

// Catches: an absurd grid that takes all memory, or a count that overflows into a small one.
TEST(FieldSampler, refusesHugeGridsBeforeTakingMemory) {
    const FieldAxis longest{kX, 0.0, 1e-9, kMaxAxisSamples};
    const auto with = [&](Coordinate c) { return FieldAxis{c, 0.0, 1e-9, kMaxAxisSamples}; };
    expectRefused(request({longest, with(kY), with(kZ), with(kThetaX)}), MessageCode::FieldTooLarge,
                  "1e+20 samples, more than the 100000000");
    expectRefused(request({{kX, 0.0, 1e-9, kMaxAxisSamples + 1}}), MessageCode::FieldTooLarge,
                  "x: 100001 samples, more than the 100000");
    expectRefused(request({{kX, 0.0, 1e-9, std::numeric_limits<int>::max()}}), MessageCode::FieldTooLarge,
                  "2147483647");
    FieldRequest gradient = request({with(kX), {kY, 0.0, 1e-9, 143}});
    gradient.withGradient = true;
    expectRefused(gradient, MessageCode::FieldTooLarge, "14300000 samples, more than the 14285714");
}

/// Three objects of a rig at three heights; the second is the field's.
FieldRequest shadedRequest() {
    FieldRequest asked = request({axisOf(kX), axisOf(kY), {kZ, 0.12, 0.04, 3}});
    asked.fixed << 0.0, 0.0, 0.0, 0.15, -0.1, 0.4;
    asked.X_EO = poseFromCoordinates((Vector6d() << 0.01, -0.01, 0.02, 0.1, 0.0, 0.3).finished());
    asked.X_RS = movedSource();
    asked.others = {{RadiatingContour(Disk{0.02}),
                     poseFromCoordinates((Vector6d() << 0.0, 0.01, -0.02, 0, 0, 0).finished())},
                    {RadiatingContour(Disk{0.03}),
                     poseFromCoordinates((Vector6d() << -0.02, 0.0, 0.05, 0.2, 0, 0).finished())}};
    return asked;
}

MountedObjects heldIn(const FieldRequest& asked) {
    std::vector<MountedContour> all{{asked.object, asked.X_EO}};
    all.insert(all.end(), asked.others.begin(), asked.others.end());
    return MountedObjects(all);
}

// Catches: a field without shade, another object's, or of others that stand elsewhere than they are mounted.
TEST(FieldSampler, countsTheShadeOfTheOthers) {
    FieldRequest asked = shadedRequest();
    const MountedObjects held = heldIn(asked);
    const auto exact = sampled(asked);
    asked.isShadeRough = true;
    const auto rough = sampled(asked);
    EXPECT_EQ(exact->tolerance, kShadeTolerance);
    EXPECT_FALSE(exact->isShadeRough);
    EXPECT_TRUE(rough->isShadeRough);
    double largest = 0.0;
    for (std::size_t i = 0; i < exact->values.size(); ++i) {
        const Vector6d q = coordinatesOf(asked, i);
        const Pose X_SE = asked.X_RS.inverse() * poseFromCoordinates(q);
        const double alone = valueAt(asked, q);
        ASSERT_NEAR(exact->values[i], held.viewFactorValue(kSource, 0, X_SE, 1e-9), 2e-5) << i;
        ASSERT_NEAR(rough->values[i], alone * held.roughShare(kSource, 0, X_SE, alone), 1e-9) << i;
        ASSERT_LE(exact->values[i], alone + 1e-9);
        largest = std::max(largest, alone - exact->values[i]);
        ASSERT_NEAR(rough->values[i], exact->values[i], 0.1 * (alone - exact->values[i]) + 1e-5) << i;
    }
    EXPECT_GT(largest, 0.05) << "else nothing is shaded here";
}

// Catches: a gradient of the object alone, or about another point than the end-effector's.
TEST(FieldSampler, theGradientIsThatOfTheShadedField) {
    FieldRequest asked = shadedRequest();
    asked.axes = {{kX, -0.03, 0.03, 3}, {kThetaY, -0.3, 0.3, 3}};
    asked.fixed[kZ] = 0.15;
    asked.withGradient = true;
    const MountedObjects held = heldIn(asked);
    const auto field = sampled(asked);
    const auto at = [&](const Vector6d& q) {
        return held.viewFactor(kSource, 0, asked.X_RS.inverse() * poseFromCoordinates(q)).value;
    };
    for (std::size_t i = 0; i < field->values.size(); ++i) {
        const Vector6d q = coordinatesOf(asked, i);
        for (int c = 0; c < 6; ++c) {
            const Vector6d d = 2e-3 * Vector6d::Unit(c);
            const double slope = (at(q + d) - at(q - d)) / 4e-3;
            EXPECT_NEAR(field->gradient[6 * i + c], slope, 0.02 * std::abs(slope) + 0.05) << i << ' ' << c;
        }
    }
}

// Catches: other bits, or another time, where nothing can be shaded.
TEST(FieldSampler, objectsInOnePlaneChangeNoBit) {
    FieldRequest asked = request({axisOf(kX), axisOf(kZ), axisOf(kThetaX)});
    asked.X_EO = poseFromCoordinates((Vector6d() << 0.02, -0.03, 0.01, 0.1, 0.2, 0.3).finished());
    const auto alone = sampled(asked);
    for (const double x : {-0.05, 0.02, 0.04})
        asked.others.push_back(
            {RadiatingContour(Disk{0.02}), asked.X_EO * Pose(Eigen::Translation3d(x, -0.04, 0.0))});
    for (const bool isRough : {true, false}) {
        asked.isShadeRough = isRough;
        const auto together = sampled(asked);
        EXPECT_EQ(std::memcmp(alone->values.data(), together->values.data(), 8 * alone->values.size()), 0);
        EXPECT_EQ(together->tolerance, alone->tolerance);
        EXPECT_FALSE(together->isShadeRough);
    }
}

} // namespace
} // namespace bask
