#include "engine/thermal/rate_estimator.h"
#include "widgets/common/object_tile.h"

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace bask;

namespace {

struct Shown {
    ObjectTile tile{0};
    Shown() { tile.setName(QStringLiteral("bunny")); }
    QString text(const char* name) { return tile.findChild<QLabel*>(QLatin1String(name))->text(); }
    void feed(double time_s, double measured_K, double rate_K_s, bool valid = true) {
        ObjectSample sample;
        sample.measured_K = measured_K;
        sample.rate_K_s = rate_K_s;
        sample.target_K = 313.15;
        sample.valid = valid;
        tile.setSample(time_s, sample);
    }
};

} // namespace

TEST(ObjectTile, NumbersWithUnits) {
    Shown shown;
    shown.feed(1.0, 303.15, 0.1);
    EXPECT_EQ(shown.text("tileRate"), QStringLiteral("\u2014")) << "of one estimate";
    shown.feed(6.0, 303.15, 0.1);
    EXPECT_EQ(shown.text("tileName"), QStringLiteral("bunny"));
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.0\u00a0°C"));
    EXPECT_EQ(shown.text("tileTarget"), QStringLiteral("40.0\u00a0°C"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("\u221210.0\u00a0K"));
    EXPECT_EQ(shown.text("tileRate"), QStringLiteral("+6.0\u00a0K/min"));
    shown.tile.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("86.0\u00a0°F"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("\u221218.0\u00a0°F"));
}

// Catches a temperature whose uncertainty is known and not told, or told of a reading that is not known.
TEST(ObjectTile, TheTipTellsTheUncertainty) {
    Shown shown;
    const auto tip = [&shown] { return shown.tile.findChild<QLabel*>("tileTemperature")->toolTip(); };
    shown.feed(1.0, 303.15, 0.1);
    EXPECT_EQ(tip(), "");
    ObjectSample sample;
    sample.valid = true;
    sample.measured_K = 303.15;
    SensorView sensor{SensorTrust::Trusted, 0.1, 303.15, 0.153};
    shown.tile.setSample(2.0, sample, sensor);
    EXPECT_TRUE(tip().contains("Standard uncertainty 0.15 K.")) << tip().toStdString();
    sensor.trust = SensorTrust::Stale;
    shown.tile.setSample(3.0, sample, sensor);
    EXPECT_EQ(tip(), "");
    shown.tile.setRecordedUncertainty(0.2);
    TraceSample row;
    row.objects = {sample};
    shown.tile.setMoment({row}, 0, 0);
    EXPECT_TRUE(tip().contains("Standard uncertainty 0.20 K.")) << tip().toStdString();
}

// Catches: an uncertainty that only a pointer finds, digits that it does not allow, and digits that come and
// go with its noise.
TEST(ObjectTile, TheUncertaintyIsUnderTheReadingAndAllowsItsDigits) {
    Shown shown;
    ObjectSample sample;
    sample.valid = true;
    sample.measured_K = 273.15 + 30.123;
    sample.target_K = 273.15 + 40.0;
    const auto tell = [&](double u_K) {
        shown.tile.setSample(1.0, sample, {SensorTrust::Trusted, 0.1, sample.measured_K, u_K});
    };
    tell(0.153);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.1\u00a0°C"));
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("± 0.15\u00a0K"));
    EXPECT_TRUE(shown.tile.accessibleDescription().endsWith(QStringLiteral("30.1\u00a0°C ± 0.15\u00a0K")))
        << shown.tile.accessibleDescription().toStdString();
    tell(0.02);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.12\u00a0°C"));
    EXPECT_EQ(shown.text("tileTarget"), QStringLiteral("40.00\u00a0°C"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("\u22129.88\u00a0K"));
    EXPECT_EQ(shown.tile.shown().decimals, 2);
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("± 0.020\u00a0K"));
    tell(0.046);
    for (const double u_K : {0.049, 0.045, 0.05, 0.046}) { // at the limit of two decimals
        tell(u_K);
        EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.12\u00a0°C")) << u_K;
        EXPECT_EQ(shown.text("tileAge"), QStringLiteral("± 0.046\u00a0K")) << u_K;
    }
    tell(0.06);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.1\u00a0°C"));
    tell(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(shown.text("tileAge"), QString());
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("30.1\u00a0°C"));
}

// Catches a part of an object that passes for the whole.
TEST(ObjectTile, TellsThatTheCameraSeesAPart) {
    Shown shown;
    ObjectSample sample;
    sample.valid = true;
    sample.measured_K = 303.15;
    sample.camera = {303.25, 0.25, 0.1, 20.0};
    shown.tile.setSample(1.0, sample);
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("Camera 30.1\u00a0°C ± 0.5\u00a0K"));
    sample.camera.isPartlyOutside = true;
    shown.tile.setSample(2.0, sample);
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("Camera 30.1\u00a0°C ± 0.5\u00a0K (part)"));
}

// Catches 40.1 beside a target of 40.0 and an error of 0.2.
TEST(ObjectTile, TheErrorIsThatOfTheShownNumbers) {
    Shown shown;
    ObjectSample sample;
    sample.valid = true;
    sample.target_K = 273.15 + 39.96;
    sample.measured_K = 273.15 + 40.14; // 0.18 K more
    shown.tile.setSample(1.0, sample);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("40.1\u00a0°C"));
    EXPECT_EQ(shown.text("tileTarget"), QStringLiteral("40.0\u00a0°C"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("+0.1\u00a0K"));
    EXPECT_EQ(shown.tile.shown().errorText(TemperatureUnit::Celsius), QStringLiteral("+0.1\u00a0K"));
    shown.tile.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("104.3\u00a0°F"));
    EXPECT_EQ(shown.text("tileTarget"), QStringLiteral("103.9\u00a0°F"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("+0.4\u00a0°F"));
}

// Catches: "Heating", black on white, on the card of an object that is above its trip limit; a word that
// jumps by noise at the limit.
TEST(ObjectTile, AboveALimitItHasItsColourAndWord) {
    Shown shown;
    shown.tile.resize(320, 120);
    const auto ground = [&] { return shown.tile.grab().toImage().pixelColor(160, 5); };
    shown.feed(1.0, 500.0, 0.5);
    EXPECT_EQ(activityPriority(shown.tile.activity()), 0) << "no limits are known";
    const QColor usual = ground();
    shown.tile.setLimits(393.15, 423.15);
    shown.feed(2.0, 393.0, 0.5);
    EXPECT_EQ(activityPriority(shown.tile.activity()), 0);
    shown.feed(3.0, 393.3, 0.5);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Above its warning limit"));
    EXPECT_EQ(activityPriority(shown.tile.activity()), 2);
    const QColor warned = ground();
    EXPECT_NE(warned, usual);
    shown.feed(4.0, 391.3, -0.1);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::AboveWarning) << "its alarm stays as well";
    shown.feed(4.5, 422.0, 0.5);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::AboveWarning) << "not above its trip limit yet";
    shown.feed(5.0, 424.0, 0.5);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Above its trip limit"));
    EXPECT_EQ(activityPriority(shown.tile.activity()), 1);
    EXPECT_NE(ground(), warned);
    EXPECT_EQ(shown.tile.shown().activity, ObjectActivity::AboveTrip);
    shown.feed(5.5, 422.0, -0.1);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::AboveTrip) << "its alarm stays as well";
    shown.feed(6.0, 424.0, 0.5, false);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::SensorInvalid) << "nobody knows";
    shown.feed(7.0, 390.0, -0.1);
    EXPECT_EQ(activityPriority(shown.tile.activity()), 0);
    EXPECT_EQ(ground(), usual);
}

TEST(ObjectTile, StateInAWord) {
    Shown shown;
    const auto ramp = [&](double begin_s, double from_K, double rate_K_s) {
        for (int k = 0; k <= 5; ++k)
            shown.feed(begin_s + k, from_K + rate_K_s * k, rate_K_s);
    };
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("No reading yet"));
    ramp(1.0, 303.15, 0.1);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Heating"));
    ramp(20.0, 323.15, -0.1);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Cooling"));
    ramp(40.0, 311.15, 0.0);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Off target"));
    shown.feed(60.0, 313.0, 0.01);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Settling"));
    shown.feed(70.0, 313.2, 0.0);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Settled"));
    ramp(71.0, 313.9, 0.05);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Heating")) << "left the band";
    shown.feed(77.0, 313.3, 0.0);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Settling")) << "the ten seconds begin again";
}

// Catches: "Heating +2.4 K/min" at the begin of a run, of an object that is at rest.
TEST(ObjectTile, TheFirstSampleTellsNoHeating) {
    Shown shown;
    shown.feed(0.0, 298.0, 2.4 / 60.0);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Steady);
    ObjectSample object;
    object.measured_K = 298.0;
    object.rate_K_s = -3.3 / 60.0;
    object.target_K = 313.15;
    object.valid = true;
    TraceSample first;
    first.objects = {object};
    Shown replayed;
    replayed.tile.setMoment({first}, 0, 0);
    EXPECT_EQ(replayed.tile.activity(), ObjectActivity::Steady);
    EXPECT_EQ(replayed.text("tileRate"), QStringLiteral("\u2014"));
}

// Catches a word and a number that follow the noise of single samples.
TEST(ObjectTile, AtRestTheWordStaysTheSame) {
    Shown shown;
    for (int k = 0; k < 60; ++k) {
        shown.feed(k, 300.0, (k % 2 == 0 ? 1.0 : -1.0) * 3.0 / 60.0);
        if (k > 5) {
            EXPECT_EQ(shown.tile.activity(), ObjectActivity::Steady) << k;
        }
    }
    EXPECT_EQ(shown.text("tileRate"), QStringLiteral("0.0\u00a0K/min"));
    for (int k = 60; k < 70; ++k) // the same reading again and again is one
        shown.feed(60.0, 300.0, 3.0 / 60.0);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Steady);
    shown.feed(60.5, 0.0, 0.0, false); // a drop-out takes nothing of the mean away
    shown.feed(61.0, 300.0, -3.0 / 60.0);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Steady);
}

// Catches "heating" said of noise: readings of 0.1 K with noise at rest, by the estimator of the paper.
TEST(ObjectTile, NoiseIsNoHeatingAndASlowRampIs) {
    Shown shown;
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.02);
    RateEstimator estimator(10, 3);
    const auto feed = [&](int k, double true_K) {
        const double measured_K = std::round((true_K + noise(random)) * 10.0) / 10.0;
        estimator.add(k, measured_K);
        const auto estimate = estimator.estimate(); // none before its window is full
        shown.feed(k, measured_K, estimate ? estimate->rate_K_s : std::nan(""));
    };
    int said = 0;
    for (int k = 0; k < 3000; ++k) {
        feed(k, 300.037);
        said += shown.tile.activity() == ObjectActivity::Heating ||
                        shown.tile.activity() == ObjectActivity::Cooling
                    ? 1
                    : 0;
    }
    EXPECT_EQ(said, 0) << "of 3000";
    for (int k = 3000; k < 3030; ++k)
        feed(k, 300.037 + (k - 3000) * 3.0 / 60.0); // 3 K/min
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Heating);
}

// Catches a lost sensor shown as 0 or as its last value.
TEST(ObjectTile, AnInvalidSensorShowsNoNumber) {
    Shown shown;
    shown.feed(1.0, 313.0, 0.0);
    shown.feed(2.0, 0.0, 0.0, false);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("UNKNOWN"));
    for (const char* name : {"tileTemperature", "tileError", "tileRate"})
        EXPECT_EQ(shown.text(name), QStringLiteral("\u2014")) << name;
    EXPECT_EQ(shown.text("tileTarget"), QStringLiteral("40.0\u00a0°C"));
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::SensorInvalid);
}

// Catches a reading of a while ago shown as if it were of now, and one of a frozen sensor.
TEST(ObjectTile, AnOldReadingIsGreyWithItsAge) {
    Shown shown;
    const auto ink = [&] {
        return shown.tile.findChild<QLabel*>(QStringLiteral("tileTemperature"))
            ->palette()
            .color(QPalette::WindowText);
    };
    shown.feed(1.0, 321.35, 0.0);
    const QColor fresh = ink();
    EXPECT_EQ(shown.text("tileAge"), QString());
    ObjectSample lost;
    lost.target_K = 313.15;
    shown.tile.setSample(13.0, lost, {SensorTrust::Stale, 12.2, 321.35});
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("UNKNOWN"));
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("48.2\u00a0°C"));
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("12 s old"));
    EXPECT_NE(ink(), fresh);
    for (const char* name : {"tileError", "tileRate"})
        EXPECT_EQ(shown.text(name), QStringLiteral("\u2014")) << name;
    ObjectSample frozen = lost;
    frozen.measured_K = 321.35;
    frozen.valid = true;
    shown.tile.setSample(60.0, frozen, {SensorTrust::Stale, 150.0, 321.35});
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Stale"));
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("2:30 old"));
    EXPECT_NE(ink(), fresh);
    shown.feed(61.0, 313.0, 0.0);
    EXPECT_EQ(shown.text("tileAge"), QString());
    EXPECT_EQ(ink(), fresh);
}

// Catches "0 s old" of a value that has been the same for 39 s, and "2 s old" of the newest one, which is not
// believed.
TEST(ObjectTile, TheAgeIsThatOfTheReadingThatIsShown) {
    Shown shown;
    ObjectSample frozen;
    frozen.target_K = 313.15;
    frozen.measured_K = 321.35;
    frozen.valid = true;
    SensorView sensor{SensorTrust::Stale, 0.2, 321.35};
    sensor.sameFor_s = 39.0;
    shown.tile.setSample(1.0, frozen, sensor);
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Stale"));
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("same for 39 s"));
    sensor.sameFor_s = 150.0;
    shown.tile.setSample(2.0, frozen, sensor);
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("same for 2:30"));
    EXPECT_EQ(shown.tile.shown().age, QStringLiteral("same for 2:30"));

    shown.feed(3.0, 321.35, 0.0);
    ObjectSample jumped;
    jumped.target_K = 313.15;
    shown.tile.setSample(5.0, jumped, {SensorTrust::Trusted, 2.0, 297.95});
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("UNKNOWN"));
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("24.8\u00a0°C"));
    EXPECT_EQ(shown.text("tileAge"), QString()) << "it is the newest";
    shown.tile.setSample(6.0, jumped, {SensorTrust::Distrusted, 3.0, 297.95});
    EXPECT_EQ(shown.tile.shown().age, QString());
    shown.tile.setSample(7.0, jumped, {SensorTrust::Trusted, 2.0, 321.35});
    EXPECT_EQ(shown.text("tileAge"), QStringLiteral("2 s old")) << "none came since";
}

// Catches 24.9 degC on the tile of an object that has 48 degC since its sensor came off, and no way to say
// that it is right after all.
TEST(ObjectTile, WhatIsNotBelievedIsStruckOutUntilAPersonConfirmsIt) {
    Shown shown;
    shown.tile.show();
    shown.tile.resize(240, shown.tile.sizeHint().height());
    const int height = shown.tile.sizeHint().height();
    auto* confirm = shown.tile.findChild<QPushButton*>(QStringLiteral("confirmSensor"));
    const auto isStruck = [&] {
        return shown.tile.findChild<QLabel*>(QStringLiteral("tileTemperature"))->font().strikeOut();
    };
    shown.feed(1.0, 321.0, 0.0);
    EXPECT_FALSE(confirm->isVisible() || isStruck());
    ObjectSample off;
    off.target_K = 313.15;
    shown.tile.setSample(2.0, off, {SensorTrust::Distrusted, 5.0, 298.05});
    EXPECT_EQ(shown.text("tileState"), QStringLiteral("Not believed"));
    EXPECT_EQ(shown.text("tileTemperature"), QStringLiteral("24.9\u00a0°C"));
    EXPECT_EQ(shown.text("tileError"), QStringLiteral("\u2014"));
    EXPECT_TRUE(isStruck());
    ASSERT_TRUE(confirm->isVisible());
    EXPECT_EQ(shown.tile.sizeHint().height(), height) << "the page does not jump";
    QSignalSpy confirmed(&shown.tile, &ObjectTile::confirmRequested);
    QTest::mouseClick(confirm, Qt::LeftButton);
    EXPECT_EQ(confirmed.count(), 1);
    shown.feed(3.0, 298.05, 0.0);
    EXPECT_FALSE(confirm->isVisible() || isStruck());
}

// Catches a replay that says "Settling" of an object that had long settled, or "Settled" of one that had not.
TEST(ObjectTile, AMomentOfARecordIsJudgedAsItWasLive) {
    std::vector<TraceSample> samples;
    Shown live;
    std::vector<ObjectActivity> said;
    for (int k = 0; k <= 400; ++k) { // in the band from 10 s to 25 s and from 30 s on
        TraceSample sample;
        sample.time_s = 0.1 * k;
        ObjectSample object;
        const bool isOut = k < 100 || (k >= 250 && k < 300);
        object.measured_K = isOut ? 310.0 : 313.15;
        object.rate_K_s = 0.1;
        object.target_K = 313.15;
        object.valid = true;
        sample.objects = {ObjectSample{}, object};
        samples.push_back(sample);
        live.tile.setSample(sample.time_s, object);
        said.push_back(live.tile.activity());
    }
    Shown replayed;
    for (const std::size_t k : {350U, 0U, 99U, 100U, 199U, 205U, 249U, 260U, 400U, 310U, 150U}) {
        replayed.tile.setMoment(samples, k, 1);
        EXPECT_EQ(replayed.tile.activity(), said[k]) << k;
    }
    replayed.tile.setMoment(samples, 400, 1);
    EXPECT_EQ(replayed.tile.activity(), ObjectActivity::Settled);
    EXPECT_TRUE(replayed.text("tileTemperature").startsWith(QStringLiteral("40.0")));
}
