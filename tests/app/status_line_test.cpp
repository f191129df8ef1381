#include "app/status_line.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "widgets/common/theme.h"

#include <QLabel>
#include <QMenu>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

struct Line {
    QMenu units, languages;
    StatusLine line{&units, &languages};
    Snapshot snapshot;

    Line() {
        snapshot.latest.objects.resize(1);
        snapshot.heat = HeatState::On;
        snapshot.source_K = snapshot.latest.source_K = kelvinFromCelsius(182.3);
        snapshot.sourceAge_s = 0.1;
        line.resize(1200, 30);
        line.show();
    }
    QLabel* label(const char* name) { return line.findChild<QLabel*>(QLatin1String(name)); }
    QColor ink(const char* name) { return label(name)->palette().color(QPalette::WindowText); }
};

} // namespace

// Catches: a real rig that seems to run at twenty times its speed.
TEST(StatusLineTest, LiveNeverShowsASimulationSpeed) {
    Line shown;
    shown.snapshot.simulationSpeed = 20.0;
    shown.line.apply(shown.snapshot);
    EXPECT_TRUE(shown.label("loopRate")->text().contains(QStringLiteral("×20")));
    shown.snapshot.simulated = false;
    shown.line.apply(shown.snapshot);
    EXPECT_FALSE(shown.label("loopRate")->text().contains(QStringLiteral("×")));
}

// Catches: a count of samples that grows after the run without a word why.
TEST(StatusLineTest, ARecordAfterTheRunSaysUntilWhen) {
    Line shown;
    shown.snapshot.recordingPath = "/runs/20261129T223014Z.bask";
    shown.snapshot.recordedRows = 105;
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("recording")->text(), QStringLiteral("recording 20261129T223014Z, 105 samples"));
    shown.snapshot.isRecordedUntilCold = true;
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("recording")->text(),
              QStringLiteral("recorded until cold: source 182.3\u00a0°C; 20261129T223014Z, 105 samples"));
}

// Catches: "heat off" of a heater that is lost, and its last temperature shown as if it were of now.
TEST(StatusLineTest, ALostHeaterIsUnknownAndItsTemperatureOld) {
    Line shown;
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat on"));
    EXPECT_EQ(shown.label("sourceState")->text(), QStringLiteral("source 182.3\u00a0°C,"));
    const QColor known = shown.ink("heatWord"), fresh = shown.ink("sourceState");
    shown.snapshot.heat = HeatState::Unknown;
    shown.snapshot.source_K.reset();
    shown.snapshot.sourceAge_s = 12.0;
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat UNKNOWN"));
    EXPECT_EQ(shown.label("sourceState")->text(), QStringLiteral("source 182.3\u00a0°C, 12 s old,"));
    EXPECT_NE(shown.ink("heatWord"), known);
    EXPECT_NE(shown.ink("sourceState"), fresh);
    EXPECT_NE(shown.ink("sourceState"), shown.ink("heatWord"));
    shown.snapshot.heat = HeatState::Off;
    shown.snapshot.source_K = kelvinFromCelsius(150.0);
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat off"));
    EXPECT_EQ(shown.ink("heatWord"), known);
    shown.line.setAnswering(false); // what the engine told last may be long over
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat UNKNOWN"));
    EXPECT_NE(shown.ink("sourceState"), fresh);
}

// Catches: "heat off" in the ink of every day beside a plate that heats all the same, and a warning that
// stays when it does so no more.
TEST(StatusLineTest, ASourceThatHeatsUnaskedIsNotSimplyOff) {
    Line shown;
    shown.snapshot.heat = HeatState::Off;
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat off"));
    const QColor calm = shown.ink("heatWord");
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    shown.snapshot.alarms = {alarm};
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heats though off"));
    EXPECT_EQ(shown.ink("heatWord"), alarmColor(1, isDark(&shown.line)));
    EXPECT_TRUE(shown.label("heatWord")->font().bold());
    shown.line.setAnswering(false);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat UNKNOWN"));
    EXPECT_EQ(shown.ink("heatWord"), unknownColor(isDark(&shown.line)));
    shown.line.setAnswering(true);
    shown.snapshot.alarms.front().isActive = false; // over, and not acknowledged yet
    shown.line.apply(shown.snapshot);
    EXPECT_EQ(shown.label("heatWord")->text(), QStringLiteral("heat off"));
    EXPECT_EQ(shown.ink("heatWord"), calm);
}

// Catches: monitoring that fails without a word, and its mark when there is none.
TEST(StatusLineTest, TellsHowTheMonitoringGoes) {
    Line shown;
    EXPECT_TRUE(shown.label("monitoring")->isHidden());
    MonitorState state;
    state.isOn = state.hasBroker = true;
    shown.line.showMonitor(state);
    EXPECT_EQ(shown.label("monitoring")->text(), QStringLiteral("monitoring begins"));
    state.isConnected = true;
    shown.line.showMonitor(state);
    EXPECT_EQ(shown.label("monitoring")->text(), QStringLiteral("monitored"));
    const QColor fine = shown.ink("monitoring");
    state.brokerProblem = {MessageCode::MonitorNoBroker, {"lab", "no answer"}};
    shown.line.showMonitor(state);
    EXPECT_EQ(shown.label("monitoring")->text(), QStringLiteral("monitoring fails"));
    EXPECT_TRUE(shown.label("monitoring")->toolTip().contains(QStringLiteral("no answer")));
    EXPECT_NE(shown.ink("monitoring"), fine);
    shown.line.showMonitor({});
    EXPECT_TRUE(shown.label("monitoring")->isHidden());
}

} // namespace bask::test
