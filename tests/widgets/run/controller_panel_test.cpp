#include "widgets/run/controller_panel.h"

#include "widgets/common/quantity_spin_box.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

namespace {

struct Shown {
    ControllerPanel panel;
    ControllerSettings applied;
    QSignalSpy sent{&panel, &ControllerPanel::controllerApplied};

    Shown() {
        panel.setSettings(ControllerSettings{});
        panel.show();
    }
    GainSpinBox* gain(const char* key) {
        return panel.findChild<GainSpinBox*>(QStringLiteral("gain.") + QLatin1String(key));
    }
    QPushButton* button(const char* name) { return panel.findChild<QPushButton*>(QLatin1String(name)); }
    QString staged() { return panel.findChild<QLabel*>(QStringLiteral("gainsStaged"))->text(); }
    void type(const char* key, const char* text) {
        gain(key)->selectAll();
        QTest::keyClicks(gain(key), QLatin1String(text));
        QTest::keyClick(gain(key), Qt::Key_Return);
    }
};

} // namespace

// Catches a gain that takes effect while it is typed, and buttons that offer nothing to do.
TEST(ControllerPanel, EditsAreStagedUntilApply) {
    Shown shown;
    EXPECT_FALSE(shown.button("gainsApply")->isEnabled());
    EXPECT_FALSE(shown.button("gainsRevert")->isEnabled());
    shown.type("level_servo.time_constant", "12.5");
    EXPECT_EQ(shown.sent.count(), 0);
    EXPECT_TRUE(shown.panel.changed());
    EXPECT_FALSE(shown.staged().isEmpty());
    ASSERT_TRUE(shown.button("gainsApply")->isEnabled());

    QTest::mouseClick(shown.button("gainsApply"), Qt::LeftButton);
    ASSERT_EQ(shown.sent.count(), 1);
    const auto settings = shown.sent.first().first().value<ControllerSettings>();
    EXPECT_DOUBLE_EQ(settings.levelServo.timeConstant_s, 12.5);
    EXPECT_DOUBLE_EQ(settings.adaptive.gamma2, 1e-22) << "other gains come along unharmed";

    shown.panel.setSettings(settings); // the engine reports them
    EXPECT_FALSE(shown.button("gainsApply")->isEnabled());
    EXPECT_TRUE(shown.staged().isEmpty());
}

TEST(ControllerPanel, RevertGoesBackToWhatTheEngineUses) {
    Shown shown;
    shown.type("level_servo.time_constant", "99");
    QTest::mouseClick(shown.button("gainsRevert"), Qt::LeftButton);
    EXPECT_DOUBLE_EQ(shown.gain("level_servo.time_constant")->value(), 8.0);
    EXPECT_FALSE(shown.panel.changed());
    EXPECT_EQ(shown.sent.count(), 0);
}

// Catches typed text wiped out 20 times a second by the engine's report.
TEST(ControllerPanel, ReportsDoNotOverwriteStagedEdits) {
    Shown shown;
    shown.type("level_servo.time_constant", "12");
    ControllerSettings other;
    other.levelServo.integralTime_s = 90.0;
    shown.panel.setSettings(other);
    EXPECT_DOUBLE_EQ(shown.gain("level_servo.time_constant")->value(), 12.0);
    EXPECT_TRUE(shown.panel.changed());
    QTest::mouseClick(shown.button("gainsRevert"), Qt::LeftButton);
    EXPECT_DOUBLE_EQ(shown.gain("level_servo.integral_time")->value(), 90.0);
}

// Catches gains of another controller on screen.
TEST(ControllerPanel, ShowsTheChosenControllersGains) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    EXPECT_TRUE(shown.gain("level_servo.time_constant")->isVisible());
    EXPECT_FALSE(shown.gain("adaptive.gamma2")->isVisible());
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_End);
    EXPECT_FALSE(shown.gain("level_servo.time_constant")->isVisible());
    EXPECT_TRUE(shown.gain("adaptive.gamma2")->isVisible());
    EXPECT_TRUE(shown.gain("adaptive.gamma2")->text().startsWith(QStringLiteral("1e-22")));
    QTest::mouseClick(shown.button("gainsApply"), Qt::LeftButton);
    ASSERT_EQ(shown.sent.count(), 1);
    EXPECT_EQ(shown.sent.first().first().value<ControllerSettings>().kind, ControllerKind::Adaptive);
}

// Catches a gain that is valid in the file, and another one on the screen.
TEST(ControllerPanel, ShowsEveryGainThatAFileMayHave) {
    Shown shown;
    ControllerSettings settings;
    settings.adaptive = {90.0, 500.0, 0.0, 0.0};
    settings.modelBased.D = 0.0;
    settings.levelServo = {5e4, 9e5};
    shown.panel.setSettings(settings);
    EXPECT_EQ(shown.gain("adaptive.mu")->value(), 90.0);
    EXPECT_EQ(shown.gain("adaptive.K")->value(), 500.0);
    EXPECT_EQ(shown.gain("adaptive.gamma1")->value(), 0.0);
    EXPECT_EQ(shown.gain("adaptive.gamma2")->value(), 0.0);
    EXPECT_EQ(shown.gain("model_based.D")->value(), 0.0);
    EXPECT_EQ(shown.gain("level_servo.time_constant")->value(), 5e4);
    EXPECT_EQ(shown.gain("level_servo.integral_time")->value(), 9e5);
    EXPECT_FALSE(shown.panel.changed());
}

// Catches a prediction that lags behind what is typed, or speaks of another law.
TEST(ControllerPanel, SaysWhatTheStagedGainsPromise) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    auto* said = shown.panel.findChild<QLabel*>(QStringLiteral("gainsPrediction"));
    EXPECT_FALSE(said->isVisible());
    choice->setCurrentIndex(choice->findData(QLatin1String(ControllerKind::ModelBased.key())));
    EXPECT_TRUE(said->text().contains(QStringLiteral("20.8"))) << said->text().toStdString(); // D 0.2, K 0.05
    EXPECT_TRUE(said->text().contains(QStringLiteral("23 s"))) << said->text().toStdString();
    shown.type("model_based.D", "2");
    EXPECT_TRUE(said->text().contains(QStringLiteral("overshoot 0.0"))) << said->text().toStdString();
    choice->setCurrentIndex(choice->findData(QLatin1String(ControllerKind::Adaptive.key())));
    EXPECT_TRUE(said->text().contains(QStringLiteral("60 s"))) << said->text().toStdString(); // ln 20 / 0.05
}

// Catches heat rates that are wrong on purpose, of which the page that the run is watched on says nothing.
TEST(ControllerPanel, SaysThatHeatRatesAreWrongOnPurpose) {
    Shown shown;
    EXPECT_EQ(shown.staged(), QString());
    shown.panel.setWrongRates(4.0);
    EXPECT_TRUE(shown.staged().contains(QStringLiteral("\u00d74"))) << shown.staged().toStdString();
    const auto* said = shown.panel.findChild<QLabel*>(QStringLiteral("gainsStaged"));
    EXPECT_TRUE(said->toolTip().contains(QStringLiteral("wrong by up to \u00d74")));
    shown.type("level_servo.time_constant", "12");
    EXPECT_TRUE(shown.staged().contains(QStringLiteral("Not applied")));
    shown.button("gainsRevert")->click();
    shown.panel.setWrongRates(1.0);
    EXPECT_EQ(shown.staged(), QString());
}

// Catches two ways of typing the same gains that drift apart.
TEST(ControllerPanel, FrequencyAndDampingAreTheGainsInOtherWords) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    EXPECT_FALSE(shown.gain("frequency")->isVisible());
    choice->setCurrentIndex(choice->findData(QLatin1String(ControllerKind::ModelBased.key())));
    EXPECT_TRUE(shown.gain("frequency")->isVisible());
    EXPECT_NEAR(shown.gain("damping")->value(), 0.4472, 1e-3);
    shown.type("damping", "1");
    EXPECT_NEAR(shown.gain("model_based.D")->value(), 2.0 * std::sqrt(0.05), 1e-3);
    EXPECT_NEAR(shown.gain("model_based.K")->value(), 0.05, 1e-3);
    shown.type("frequency", "0.5");
    EXPECT_DOUBLE_EQ(shown.gain("model_based.K")->value(), 0.25);
    EXPECT_NEAR(shown.gain("damping")->value(), 1.0, 1e-3);
    shown.type("model_based.K", "0.01");
    EXPECT_NEAR(shown.gain("frequency")->value(), 0.1, 1e-9);
    QTest::mouseClick(shown.button("gainsApply"), Qt::LeftButton);
    ASSERT_EQ(shown.sent.count(), 1);
    EXPECT_DOUBLE_EQ(shown.sent.first().first().value<ControllerSettings>().modelBased.K, 0.01);
}
