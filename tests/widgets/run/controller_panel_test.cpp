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
    shown.type("timeConstant", "12.5");
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
    shown.type("timeConstant", "99");
    QTest::mouseClick(shown.button("gainsRevert"), Qt::LeftButton);
    EXPECT_DOUBLE_EQ(shown.gain("timeConstant")->value(), 8.0);
    EXPECT_FALSE(shown.panel.changed());
    EXPECT_EQ(shown.sent.count(), 0);
}

// Catches typed text wiped out 20 times a second by the engine's report.
TEST(ControllerPanel, ReportsDoNotOverwriteStagedEdits) {
    Shown shown;
    shown.type("timeConstant", "12");
    ControllerSettings other;
    other.levelServo.integralTime_s = 90.0;
    shown.panel.setSettings(other);
    EXPECT_DOUBLE_EQ(shown.gain("timeConstant")->value(), 12.0);
    EXPECT_TRUE(shown.panel.changed());
    QTest::mouseClick(shown.button("gainsRevert"), Qt::LeftButton);
    EXPECT_DOUBLE_EQ(shown.gain("integralTime")->value(), 90.0);
}

// Catches gains of another controller on screen.
TEST(ControllerPanel, ShowsTheChosenControllersGains) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    EXPECT_TRUE(shown.gain("timeConstant")->isVisible());
    EXPECT_FALSE(shown.gain("adaptiveGamma2")->isVisible());
    choice->setFocus();
    QTest::keyClick(choice, Qt::Key_End);
    EXPECT_FALSE(shown.gain("timeConstant")->isVisible());
    EXPECT_TRUE(shown.gain("adaptiveGamma2")->isVisible());
    EXPECT_TRUE(shown.gain("adaptiveGamma2")->text().startsWith(QStringLiteral("1e-22")));
    QTest::mouseClick(shown.button("gainsApply"), Qt::LeftButton);
    ASSERT_EQ(shown.sent.count(), 1);
    EXPECT_EQ(shown.sent.first().first().value<ControllerSettings>().kind, ControllerKind::Adaptive);
}

// Catches a prediction that lags behind what is typed, or speaks of another law.
TEST(ControllerPanel, SaysWhatTheStagedGainsPromise) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    auto* said = shown.panel.findChild<QLabel*>(QStringLiteral("gainsPrediction"));
    EXPECT_FALSE(said->isVisible());
    choice->setCurrentIndex(choice->findData(static_cast<int>(ControllerKind::ModelBased)));
    EXPECT_TRUE(said->text().contains(QStringLiteral("20.8"))) << said->text().toStdString(); // D 0.2, K 0.05
    EXPECT_TRUE(said->text().contains(QStringLiteral("23 s"))) << said->text().toStdString();
    shown.type("modelD", "2");
    EXPECT_TRUE(said->text().contains(QStringLiteral("overshoot 0.0"))) << said->text().toStdString();
    choice->setCurrentIndex(choice->findData(static_cast<int>(ControllerKind::Adaptive)));
    EXPECT_TRUE(said->text().contains(QStringLiteral("60 s"))) << said->text().toStdString(); // ln 20 / 0.05
}

// Catches two ways of typing the same gains that drift apart.
TEST(ControllerPanel, FrequencyAndDampingAreTheGainsInOtherWords) {
    Shown shown;
    auto* choice = shown.panel.findChild<QComboBox*>(QStringLiteral("controllerChoice"));
    EXPECT_FALSE(shown.gain("modelFrequency")->isVisible());
    choice->setCurrentIndex(choice->findData(static_cast<int>(ControllerKind::ModelBased)));
    EXPECT_TRUE(shown.gain("modelFrequency")->isVisible());
    EXPECT_NEAR(shown.gain("modelDamping")->value(), 0.4472, 1e-3);
    shown.type("modelDamping", "1");
    EXPECT_NEAR(shown.gain("modelD")->value(), 2.0 * std::sqrt(0.05), 1e-3);
    EXPECT_NEAR(shown.gain("modelK")->value(), 0.05, 1e-3);
    shown.type("modelFrequency", "0.5");
    EXPECT_DOUBLE_EQ(shown.gain("modelK")->value(), 0.25);
    EXPECT_NEAR(shown.gain("modelDamping")->value(), 1.0, 1e-3);
    shown.type("modelK", "0.01");
    EXPECT_NEAR(shown.gain("modelFrequency")->value(), 0.1, 1e-9);
    QTest::mouseClick(shown.button("gainsApply"), Qt::LeftButton);
    ASSERT_EQ(shown.sent.count(), 1);
    EXPECT_DOUBLE_EQ(shown.sent.first().first().value<ControllerSettings>().modelBased.K, 0.01);
}
