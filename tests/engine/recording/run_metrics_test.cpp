#include "engine/recording/run_metrics.h"

#include "engine/base/message_code.h"
#include "engine/thermal/contact_uncertainty.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace bask {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTarget_K = 320.0;

/// One sample every half second of T(t), without motion.
template <class Temperature> SessionRecord recordOf(double duration_s, const Temperature& T_K) {
    SessionRecord record;
    record.experiment = test::twoDisks();
    record.experiment.objects.resize(1);
    for (int k = 0; 0.5 * k <= duration_s; ++k) {
        TraceSample sample;
        sample.time_s = 0.5 * k;
        ObjectSample object;
        object.target_K = kTarget_K;
        object.measured_K = T_K(sample.time_s);
        object.valid = true;
        object.true_K = kNaN;
        object.estimated_K = 1000.0; // not to be taken
        sample.objects.push_back(object);
        record.samples.push_back(sample);
    }
    return record;
}

// Catches: estimates at the beginning that are not told, since the first sample is before the first step.
TEST(RunMetrics, TheFirstEstimatesAreThoseThatWereToldFirst) {
    SessionRecord record = recordOf(5.0, [](double) { return kTarget_K; });
    record.samples[0].objects[0].lambda1 = kNaN;
    record.samples[1].objects[0].lambda1 = 0.2;
    record.samples[2].objects[0].lambda1 = 0.3;
    EXPECT_EQ(runMetrics(record).first.objects.at(0).lambda1, 0.2);
    EXPECT_EQ(runMetrics(record).first.time_s, 0.0);
}

TEST(RunMetrics, OfAFirstOrderStepAreItsAnalyticOnes) {
    constexpr double kTau_s = 20.0;
    const auto metrics =
        runMetrics(recordOf(200.0, [](double t) { return kTarget_K - 20.0 * std::exp(-t / kTau_s); }));
    const ObjectMetrics& object = metrics.objects.at(0);
    EXPECT_TRUE(metrics.trueObjects.empty());
    EXPECT_NEAR(object.step_K.value(), 20.0, 1e-9);
    EXPECT_NEAR(object.rise_s.value(), kTau_s * std::log(9.0), 0.01);
    EXPECT_NEAR(object.settling_s.value(), kTau_s * std::log(20.0 / 0.5), 0.5);
    EXPECT_EQ(object.overshoot_K.value(), 0.0);
    EXPECT_NEAR(object.steadyError_K.value(), 0.0, 0.006);
    EXPECT_EQ(metrics.duration_s, 200.0);
}

TEST(RunMetrics, OvershootOfASecondOrderStepDownwards) {
    constexpr double kDamping = 0.4, kFrequency = 0.3;
    const double damped = kFrequency * std::sqrt(1.0 - kDamping * kDamping);
    const auto metrics = runMetrics(recordOf(120.0, [&](double t) {
        return kTarget_K + 10.0 * std::exp(-kDamping * kFrequency * t) *
                               (std::cos(damped * t) + kDamping * kFrequency / damped * std::sin(damped * t));
    }));
    const double expected = std::exp(-M_PI * kDamping / std::sqrt(1.0 - kDamping * kDamping));
    EXPECT_NEAR(metrics.objects[0].step_K.value(), -10.0, 1e-9);
    EXPECT_NEAR(metrics.objects[0].overshootShare().value(), expected, 0.002);
    EXPECT_GT(metrics.objects[0].rise_s.value(), 1.0);
}

// Catches: an average over the warming, or one that the last minute's offset does not show in.
TEST(RunMetrics, SteadyErrorIsOfTheLastMinute) {
    const auto metrics = runMetrics(recordOf(300.0, [](double t) {
        return kTarget_K + (t < 100.0   ? -20.0
                            : t < 240.0 ? -0.4
                                        : 0.25 + (std::fmod(t, 1.0) < 0.25 ? 0.1 : -0.1));
    }));
    EXPECT_NEAR(metrics.objects[0].steadyError_K.value(), 0.25, 0.002);
    EXPECT_NEAR(metrics.objects[0].steadyDeviation_K.value(), 0.1, 0.001);
    EXPECT_EQ(metrics.objects[0].settling_s.value(), 100.0);
}

// Catches numbers without the uncertainty of what was read, and one that is told of sensors that nobody
// zeroed.
TEST(RunMetrics, HaveTheStandardUncertaintyOfTheReadings) {
    constexpr double kTau_s = 20.0;
    SessionRecord record = recordOf(200.0, [](double t) { return kTarget_K - 20.0 * std::exp(-t / kTau_s); });
    for (TraceSample& sample : record.samples)
        sample.objects[0].rate_K_s = 20.0 / kTau_s * std::exp(-sample.time_s / kTau_s);
    const auto metrics = [&record] { return runMetrics(record).objects.at(0); };
    EXPECT_FALSE(metrics().readingUncertainty_K) << "no zeroing is recorded";
    record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":[0.0,0.0]})"}};
    EXPECT_FALSE(metrics().readingUncertainty_K) << "that of other sensors";
    record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":"none"})"}};
    EXPECT_FALSE(metrics().readingUncertainty_K);

    record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":[0.0]})"}};
    const ObjectMetrics zeroed = metrics();
    EXPECT_NEAR(zeroed.readingUncertainty_K.value(), kClassB_K, 0.01) << "hardly any step or noise";
    EXPECT_LE(zeroed.steadyUncertainty_K.value(), zeroed.readingUncertainty_K.value());
    const double later_s = kTau_s * std::log(0.5 / (0.5 - kClassB_K)); // into the band, all 0.25 K too high
    EXPECT_NEAR(zeroed.settlingUncertainty_s.value(), later_s, 1.0);

    const SessionRecord whole = record;
    for (const bool isTold : {false, true}) { // its sensor is mended at rest, and confirmed
        record = whole;
        for (TraceSample& sample : record.samples)
            if (sample.time_s >= 190.0)
                sample.objects[0].measured_K += 20.0;
        for (TraceSample& sample : record.samples)
            sample.objects[0].valid = sample.time_s < 180.0 || sample.time_s >= 190.0;
        if (!isTold)
            std::erase_if(record.samples, [](const TraceSample& sample) { return !sample.objects[0].valid; });
        EXPECT_NEAR(metrics().readingUncertainty_K.value(), kClassB_K, 0.01) << isTold;
    }
    record = whole;

    for (TraceSample& sample : record.samples) // a sensor of steps of 0.2 K
        sample.objects[0].measured_K = 0.2 * std::round(5.0 * sample.objects[0].measured_K);
    const ObjectMetrics coarse = metrics();
    EXPECT_GT(coarse.readingUncertainty_K.value(), std::hypot(kClassB_K, 0.2 / std::sqrt(12.0)));
    EXPECT_GT(coarse.settlingUncertainty_s.value(), 1.0);

    record.samples.back().objects[0].target_K += 0.1;
    EXPECT_EQ(metrics().settling_s.value(), 0.0) << "another target, and one reading since";
    EXPECT_FALSE(metrics().settlingUncertainty_s);
    record.samples.back().objects[0].target_K = kTarget_K;

    for (TraceSample& sample : record.samples) // in the band from the beginning
        sample.objects[0].measured_K = kTarget_K + 0.1;
    EXPECT_EQ(metrics().settling_s.value(), 0.0);
    EXPECT_FALSE(metrics().settlingUncertainty_s);
}

// Catches a rise time whose uncertainty is not by how much it varies, for noise of each reading or for what
// all share, at a slow end as at a fast one, upward and downward.
TEST(RunMetrics, RiseTimeIsAsSureAsTheReadingsAtItsCrossings) {
    constexpr double kTau_s = 25.0;
    constexpr int kRuns = 400;
    for (const double step_K : {30.0, -12.0}) {
        for (const double noise_K : {0.02, 0.1}) {
            std::mt19937 random(7);
            std::normal_distribution<double> normal;
            double squares_s2 = 0.0, told_s2 = 0.0;
            const double room_K = kClassB_K; // of one sensor
            for (int run = 0; run < kRuns; ++run) {
                const double all_K = room_K * normal(random);
                SessionRecord record = recordOf(200.0, [&](double t) {
                    return kTarget_K - step_K * std::exp(-t / kTau_s) + all_K + noise_K * normal(random);
                });
                record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":[0.0]})"}};
                const ObjectMetrics metrics = runMetrics(record).objects.at(0);
                const double error_s = metrics.rise_s.value() - kTau_s * std::log(9.0);
                squares_s2 += error_s * error_s;
                told_s2 += std::pow(metrics.riseUncertainty_s.value(), 2);
            }
            const double ratio = std::sqrt(told_s2 / squares_s2);
            EXPECT_GT(ratio, 0.9) << step_K << " K, noise " << noise_K << " K";
            EXPECT_LT(ratio, 1.35) << step_K << " K, noise " << noise_K << " K";
        }
    }
    EXPECT_FALSE(
        runMetrics(recordOf(100.0, [](double t) { return kTarget_K - 20.0 * std::exp(-t / kTau_s); }))
            .objects.at(0)
            .riseUncertainty_s)
        << "no zeroing is recorded";
}

/// Settled by every reading from 40 s on, and at the edge of the band from 20 s to then and to the end.
ObjectMetrics grazing(double until40s_K, double atTheEnd_K) {
    SessionRecord record = recordOf(200.0, [&](double t) {
        return kTarget_K + (t < 20.0 ? 20.0 : t < 40.0 ? until40s_K : t < 60.0 ? 0.2 : atTheEnd_K);
    });
    record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":[0.0]})"}};
    return runMetrics(record).objects.at(0);
}

// Catches a settling time that is told to the second where a reading wrong by its uncertainty moves it by a
// minute, on either side of the band, or where it has perhaps not settled.
TEST(RunMetrics, SettlingIsAsSureAsTheTemperatureAtTheEdge) {
    EXPECT_EQ(grazing(0.6, 0.1).settling_s.value(), 40.0);
    EXPECT_NEAR(grazing(0.6, 0.1).settlingUncertainty_s.value(), 20.0, 1.0) << "sooner, if 0.25 K too high";
    EXPECT_EQ(grazing(-0.3, 0.1).settling_s.value(), 20.0);
    EXPECT_NEAR(grazing(-0.3, 0.1).settlingUncertainty_s.value(), 20.0, 1.0) << "later, if 0.25 K too high";
    EXPECT_NEAR(grazing(0.1, 0.0).settlingUncertainty_s.value(), 0.5 / std::sqrt(12.0), 0.01);
    EXPECT_TRUE(std::isinf(grazing(0.6, 0.4).settlingUncertainty_s.value()));
    EXPECT_TRUE(std::isinf(grazing(0.6, -0.4).settlingUncertainty_s.value()));
}

// Catches the uncertainty of a sensor told of an object that the thermal camera reads.
TEST(RunMetrics, OfAnObjectThatTheCameraReadsHaveTheCamerasUncertainty) {
    SessionRecord record = recordOf(100.0, [](double) { return kTarget_K; });
    record.commands = {{0.0, "arm", R"({"environment_K":298.0,"offsets_K":[0.0]})"}};
    record.experiment.objects[0].readBy = ReadBy::Camera;
    EXPECT_FALSE(runMetrics(record).objects[0].readingUncertainty_K) << "it told none";
    record.samples.back().objects[0].camera = {kTarget_K, 0.4, 0.1, 60.0};
    EXPECT_EQ(runMetrics(record).objects[0].readingUncertainty_K.value(), 0.4);
    EXPECT_EQ(runMetrics(record).objects[0].steadyUncertainty_K.value(), 0.4);
}

TEST(RunMetrics, CountFromTheLastChangeOfTheTarget) {
    SessionRecord record = recordOf(100.0, [](double t) {
        return t < 50.0 ? 310.0 : t < 60.0 ? 315.0 : kTarget_K;
    });
    for (TraceSample& sample : record.samples)
        if (sample.time_s < 40.0)
            sample.objects[0].target_K = 310.0;
    const ObjectMetrics object = runMetrics(record).objects[0];
    EXPECT_EQ(object.from_s, 40.0);
    EXPECT_EQ(object.step_K.value(), 10.0);
    EXPECT_EQ(object.settling_s.value(), 20.0);
}

TEST(RunMetrics, SayNothingOfWhatIsNotDefined) {
    const ObjectMetrics unsettled = runMetrics(recordOf(50.0, [](double) { return 300.0; })).objects[0];
    EXPECT_FALSE(unsettled.settling_s || unsettled.rise_s || unsettled.steadyError_K);
    EXPECT_EQ(unsettled.final_K.value(), 300.0);
    const ObjectMetrics small =
        runMetrics(recordOf(50.0, [](double t) { return kTarget_K - (t < 10.0 ? 0.9 : 0.0); })).objects[0];
    EXPECT_FALSE(small.rise_s || small.overshoot_K);
    EXPECT_TRUE(small.settling_s);

    SessionRecord none = recordOf(1.0, [](double) { return 300.0; });
    none.samples.clear();
    const RunMetrics empty = runMetrics(none);
    EXPECT_EQ(empty.samples, 0u);
    EXPECT_TRUE(std::isnan(empty.objects.at(0).target_K));
    EXPECT_FALSE(empty.objects[0].final_K || empty.objects[0].settling_s);
}

// Catches: gaps in the readings that turn every number into NaN.
TEST(RunMetrics, LeaveUnknownTemperaturesOut) {
    SessionRecord record = recordOf(200.0, [](double t) { return kTarget_K - 20.0 * std::exp(-t / 20.0); });
    for (TraceSample& sample : record.samples) {
        if (sample.time_s > 5.0 && sample.time_s < 20.0)
            sample.objects[0].measured_K = kNaN;
        if (sample.time_s == 150.0) { // what is told is no reading
            sample.objects[0].measured_K = 1000.0;
            sample.objects[0].valid = false;
        }
    }
    const ObjectMetrics object = runMetrics(record).objects[0];
    EXPECT_NEAR(object.rise_s.value(), 20.0 * std::log(9.0), 0.01);
    EXPECT_EQ(object.overshoot_K.value(), 0.0);
    EXPECT_NEAR(object.settling_s.value(), 20.0 * std::log(20.0 / 0.5), 0.5);
    record.samples.back().objects[0].valid = false;
    EXPECT_FALSE(runMetrics(record).objects[0].final_K);
}

// Catches metrics of a simulated run that say nothing of what they are counted on, and a sensor that is off
// taken for the truth, or the truth for the sensor.
TEST(RunMetrics, CountOnTheReadingsAndOnTheTruthWhereItIsRecorded) {
    SessionRecord record = recordOf(200.0, [](double t) { return kTarget_K - 20.0 * std::exp(-t / 20.0); });
    for (TraceSample& sample : record.samples)
        sample.objects[0].true_K = sample.objects[0].measured_K - 0.6; // its sensor reads too high
    const RunMetrics metrics = runMetrics(record);
    ASSERT_EQ(metrics.trueObjects.size(), 1u);
    EXPECT_NEAR(metrics.objects[0].final_K.value(), kTarget_K, 0.01);
    EXPECT_NEAR(metrics.trueObjects[0].final_K.value(), kTarget_K - 0.6, 0.01);
    EXPECT_TRUE(metrics.objects[0].settling_s);
    EXPECT_FALSE(metrics.trueObjects[0].settling_s);
    EXPECT_NEAR(metrics.trueObjects[0].step_K.value(), 20.6, 1e-9);
    EXPECT_EQ(metrics.trueObjects[0].pathLength_m, metrics.objects[0].pathLength_m);
}

TEST(RunMetrics, PathsTurnsAndLimitsUntilStop) {
    SessionRecord record;
    record.experiment = test::twoDisks();
    record.experiment.objects[0].mounting << 0.1, 0, 0, 0, 0, 0;
    for (int k = 0; k <= 20; ++k) {
        TraceSample sample;
        sample.time_s = k;
        sample.objects.resize(2);
        sample.coordinates << 0.01 * std::min(k, 10), 0, 0.1, 0, 0, 0.02 * std::min(k, 10);
        if (k >= 15) // the retreat does not count
            sample.coordinates[kZ] = 0.3;
        if (k < 4)
            sample.limits.add(Limit::Speed);
        if (k == 3)
            sample.limits.add(Limit::Rotation);
        if (k == 5)
            sample.limits.add(Limit::Workspace, kThetaZ);
        record.samples.push_back(sample);
    }
    record.events.push_back({12.0, {MessageCode::EventStopped, {}}});
    const RunMetrics metrics = runMetrics(record);
    EXPECT_EQ(metrics.duration_s, 12.0);
    EXPECT_NEAR(metrics.pathLength_m, 0.1, 1e-12);
    EXPECT_NEAR(metrics.turned_rad, 0.2, 1e-12);
    EXPECT_EQ(metrics.atVelocityLimit_s, 4.0);
    EXPECT_EQ(metrics.clamped_s, 5.0);
    EXPECT_EQ(metrics.atLimit_s[static_cast<std::size_t>(Limit::Workspace)], 1.0);
    EXPECT_EQ(metrics.atLimit_s[static_cast<std::size_t>(Limit::Rotation)], 1.0);
    double way_m = 0.0; // of a point 0.1 m off, by hand
    for (int k = 0; k < 10; ++k)
        way_m += std::hypot(0.01 + 0.1 * (std::cos(0.02 * (k + 1)) - std::cos(0.02 * k)),
                            0.1 * (std::sin(0.02 * (k + 1)) - std::sin(0.02 * k)));
    EXPECT_NEAR(metrics.objects[0].pathLength_m, way_m, 1e-12);
}

// Catches: a length of the run that ends with the last sample before its Stop, another one than in the list.
TEST(RunMetrics, DurationEndsWithTheStop) {
    SessionRecord record = recordOf(20.0, [](double) { return 300.0; });
    EXPECT_EQ(runMetrics(record).duration_s, 20.0);
    record.events.push_back({12.3, {MessageCode::EventStopped, {}}});
    EXPECT_EQ(runMetrics(record).duration_s, 12.3);
    EXPECT_EQ(runMetrics(record).samples, 25u) << "those until then";
    record.samples.resize(25); // interrupted in its last second
    EXPECT_EQ(runMetrics(record).duration_s, 12.3);
    record.samples.clear();
    EXPECT_EQ(runMetrics(record).duration_s, 0.0);
}

// Catches: a robot told to stand that is counted as held back, by the limits of its last command. One that
// cannot move for its limits is.
TEST(RunMetrics, AHoldIsAtNoLimit) {
    SessionRecord record = recordOf(20.0, [](double) { return 300.0; });
    for (TraceSample& sample : record.samples)
        sample.limits.add(Limit::Speed);
    EXPECT_EQ(runMetrics(record).atVelocityLimit_s, 20.0);
    record.events = {{5.0, {MessageCode::EventHeld, {}}},
                     {8.0, {MessageCode::EventResumed, {}}},
                     {12.25, {MessageCode::EventHeld, {}}}};
    const RunMetrics metrics = runMetrics(record);
    EXPECT_EQ(metrics.clamped_s, 5.0 + 4.0); // the first command after a Resume comes with the next sample
    EXPECT_EQ(metrics.atVelocityLimit_s, 5.0 + 4.0);
}

/// Since when an object with these errors, one sample a second, is settled.
std::optional<double> settledFrom_s(const std::vector<double>& errors_K, double band_K = kSettledBand_K,
                                    double firstTarget_K = kTarget_K) {
    SessionRecord record;
    record.experiment = test::twoDisks();
    record.experiment.objects.resize(1);
    for (const double error_K : errors_K) {
        ObjectSample object;
        object.target_K = record.samples.empty() ? firstTarget_K : kTarget_K;
        object.measured_K = kTarget_K + error_K;
        object.valid = std::isfinite(error_K);
        TraceSample sample;
        sample.time_s = static_cast<double>(record.samples.size());
        sample.objects.push_back(object);
        record.samples.push_back(sample);
    }
    return runMetrics(record, band_K).objects[0].settledFrom_s;
}

TEST(RunMetrics, SettledIsFromTheLastEntryIntoTheBand) {
    EXPECT_EQ(settledFrom_s({-5, 0, 2, -0.4, 0.3, 0.1}), 3.0);
    EXPECT_FALSE(settledFrom_s({-5, 0, 0, 0, 0.6})) << "outside at the end";
    EXPECT_EQ(settledFrom_s({0.1, 0, 0}), 0.0);
    EXPECT_EQ(settledFrom_s({-5, 0.9, 0.2}, 1.0), 1.0);
    EXPECT_EQ(settledFrom_s({-5, 0, kNaN, 0}), 1.0) << "a sample without a reading says nothing";
    EXPECT_FALSE(settledFrom_s({0, kNaN}, kSettledBand_K, 330.0)) << "of the target then";
    EXPECT_EQ(settledFrom_s({0, 0, 0, 0}, kSettledBand_K, 330.0), 1.0) << "of the target then";
}

// Catches: the last sample taken from the retreat, or from the time after a fault.
TEST(RunMetrics, TheLastSampleIsThatAtStop) {
    for (const MessageCode end :
         {MessageCode::EventStopped, MessageCode::EventStoppedFor, MessageCode::EventEmergencyStop}) {
        SessionRecord record = recordOf(10.0, [](double t) { return 300.0 + t; });
        record.events.push_back({6.0, {end, {}}});
        const RunMetrics metrics = runMetrics(record);
        EXPECT_EQ(metrics.last.time_s, 6.0);
        EXPECT_EQ(metrics.last.objects.at(0).measured_K, 306.0);
    }
    EXPECT_TRUE(runMetrics(SessionRecord()).last.objects.empty());
}

} // namespace
} // namespace bask
