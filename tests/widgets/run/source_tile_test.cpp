#include "widgets/run/source_tile.h"

#include "engine/base/message_code.h"
#include "widgets/common/theme.h"

#include <QLabel>

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

namespace {

struct ShownSource {
    SourceTile tile;
    Snapshot snapshot;
    ShownSource() {
        snapshot.warmUp = SourceWarmUp{kelvinFromCelsius(200.0)};
        tile.show();
    }
    QString text(const char* name) { return tile.findChild<QLabel*>(QLatin1String(name))->text(); }
    QColor ink(const char* name) {
        return tile.findChild<QLabel*>(QLatin1String(name))->palette().color(QPalette::WindowText);
    }
    /// A reading a second, each told by twenty snapshots.
    void run(double from_degC, double rate_K_s, int seconds) {
        for (int k = 0; k < 20 * seconds; ++k) {
            snapshot.clock_s += 0.05;
            const double read_s = std::floor(snapshot.clock_s + 1e-9);
            snapshot.sourceAge_s = snapshot.clock_s - read_s;
            snapshot.source_K = snapshot.latest.source_K =
                kelvinFromCelsius(std::round((from_degC + rate_K_s * (k / 20)) * 10.0) / 10.0);
            tile.apply(snapshot);
        }
    }
};

} // namespace

// Catches other words than those of the objects, a set point that is not shown, and a rate that follows how
// often one reading is told.
TEST(SourceTile, ShowsSetPointTemperatureAndTrend) {
    ShownSource shown;
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Waiting);
    shown.run(25.0, 0.5, 20);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Heating);
    EXPECT_EQ(shown.text("sourceTileState"), activityWord(ObjectActivity::Heating));
    EXPECT_EQ(shown.text("sourceTileTemperature"), QStringLiteral("34.5\u00a0\u00b0C"));
    EXPECT_EQ(shown.text("sourceTileSetPoint"), QStringLiteral("200.0\u00a0\u00b0C"));
    EXPECT_EQ(shown.text("sourceTileRate"), QStringLiteral("+30.0\u00a0K/min"));
    shown.snapshot.heatSetPoint_K = kelvinFromCelsius(100.0); // by hand
    shown.run(98.0, 0.0, 20);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Settled);
    EXPECT_EQ(shown.text("sourceTileSetPoint"), QStringLiteral("100.0\u00a0\u00b0C"));
    shown.snapshot.heatSetPoint_K.reset();
    shown.run(98.0, -0.2, 20);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Cooling);
    shown.run(90.0, 0.0, 20);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Steady) << "cold, and no nearer";
    shown.tile.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(shown.text("sourceTileSetPoint"), QStringLiteral("392.0\u00a0\u00b0F"));
}

// Catches a temperature of a while ago shown as if it were of now, and a trend of a source that is not heard.
TEST(SourceTile, WhatIsNotKnownIsGreyWithItsAge) {
    ShownSource shown;
    shown.run(25.0, 0.5, 20);
    const QColor fresh = shown.ink("sourceTileTemperature");
    EXPECT_EQ(shown.text("sourceTileAge"), QString());
    shown.snapshot.source_K.reset();
    shown.snapshot.sourceAge_s = 12.0;
    shown.snapshot.clock_s += 12.0;
    shown.tile.apply(shown.snapshot);
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::SensorInvalid);
    EXPECT_EQ(shown.text("sourceTileTemperature"), QStringLiteral("34.5\u00a0\u00b0C"));
    EXPECT_EQ(shown.text("sourceTileAge"), QStringLiteral("12 s old"));
    EXPECT_EQ(shown.text("sourceTileRate"), QStringLiteral("\u2014"));
    EXPECT_NE(shown.ink("sourceTileTemperature"), fresh);
    shown.run(25.0, 0.5, 5);
    EXPECT_EQ(shown.ink("sourceTileTemperature"), fresh);
    shown.tile.clear();
    EXPECT_EQ(shown.tile.activity(), ObjectActivity::Waiting);
    EXPECT_EQ(shown.text("sourceTileTemperature"), QStringLiteral("\u2014"));
}

// Catches "Settled", or "Off target", of a source whose heat is off.
TEST(SourceTile, OneThatIsOffIsNotSettled) {
    ShownSource shown;
    shown.snapshot.heat = HeatState::Off;
    shown.run(200.0, 0.0, 20);
    EXPECT_EQ(shown.text("sourceTileState"), QStringLiteral("Heat off"));
    shown.snapshot.heat = HeatState::On;
    shown.run(200.0, 0.0, 20);
    EXPECT_EQ(shown.text("sourceTileState"), activityWord(ObjectActivity::Settled));
    shown.snapshot.heat = HeatState::Off;
    shown.run(60.0, 0.0, 20);
    EXPECT_EQ(shown.text("sourceTileState"), QStringLiteral("Heat off"));
    shown.run(60.0, -0.3, 20);
    EXPECT_EQ(shown.text("sourceTileState"), activityWord(ObjectActivity::Cooling));
}

// Catches the word of a trend alone beside a source that heats although its heat is off.
TEST(SourceTile, ASourceThatHeatsUnaskedSaysSo) {
    ShownSource shown;
    shown.snapshot.heat = HeatState::Off;
    shown.run(25.0, 0.5, 20);
    EXPECT_EQ(shown.text("sourceTileState"), activityWord(ObjectActivity::Heating));
    const QColor calm = shown.ink("sourceTileState");
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    shown.snapshot.alarms = {alarm};
    shown.tile.apply(shown.snapshot);
    EXPECT_EQ(shown.text("sourceTileState"), QStringLiteral("heats though off"));
    EXPECT_EQ(shown.ink("sourceTileState"), alarmColor(1, isDark(&shown.tile)));
    shown.snapshot.alarms.front().isActive = false;
    shown.tile.apply(shown.snapshot);
    EXPECT_EQ(shown.text("sourceTileState"), activityWord(ObjectActivity::Heating));
    EXPECT_EQ(shown.ink("sourceTileState"), calm);
}
