#include "widgets/common/source_words.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

namespace {

Snapshot coldSource() {
    Snapshot snapshot;
    snapshot.source_K = snapshot.latest.source_K = kelvinFromCelsius(25.0);
    snapshot.sourceAge_s = 0.1;
    snapshot.warmUp = SourceWarmUp{kelvinFromCelsius(200.0), 213.3};
    return snapshot;
}

} // namespace

// Catches a cold source that is passed over, and one that is called cold though it is warm, hotter, or not
// known.
TEST(SourceWords, ColdIsFarBelowTheSetPointOfTheRun) {
    Snapshot snapshot = coldSource();
    EXPECT_TRUE(isSourceCold(snapshot));
    snapshot.heatSetPoint_K = kelvinFromCelsius(25.0); // by hand: the run wants more
    EXPECT_TRUE(isSourceCold(snapshot));
    EXPECT_EQ(sourceGoal_K(snapshot), kelvinFromCelsius(25.0));
    snapshot.heatSetPoint_K.reset();
    EXPECT_EQ(sourceGoal_K(snapshot), kelvinFromCelsius(200.0));
    for (const double now_degC : {195.5, 200.0, 230.0}) {
        snapshot.source_K = kelvinFromCelsius(now_degC);
        EXPECT_FALSE(isSourceCold(snapshot)) << now_degC;
    }
    snapshot.source_K.reset();
    EXPECT_FALSE(isSourceCold(snapshot));
    snapshot = coldSource();
    snapshot.warmUp.reset();
    EXPECT_FALSE(isSourceCold(snapshot));
    EXPECT_TRUE(std::isnan(sourceGoal_K(snapshot)));
}

// Catches a time that is made up where nobody knows it, and one that is left out where it is known.
TEST(SourceWords, SaysHowFarAndHowLongOrThatItIsNotKnown) {
    Snapshot snapshot = coldSource();
    QString text = coldSourceText(snapshot, TemperatureUnit::Celsius);
    for (const char* part : {"25\u00a0\u00b0C", "200\u00a0\u00b0C", "\u2212175\u00a0K",
                             "Start does not wait for it", "about 3:40."})
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << " in " << text.toStdString();
    snapshot.warmUp->in_s.reset();
    text = coldSourceText(snapshot, TemperatureUnit::Celsius);
    EXPECT_TRUE(text.contains(QStringLiteral("not known"))) << text.toStdString();
    EXPECT_FALSE(text.contains(QStringLiteral("about")));
    EXPECT_TRUE(coldSourceText(snapshot, TemperatureUnit::Fahrenheit).contains(QStringLiteral("392")));
}
