#include "widgets/common/quantity_spin_box.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

// Catches a value that drifts when the display unit is switched to and fro.
TEST(QuantitySpinBox, UnitSwitchChangesTheTextOnly) {
    QuantitySpinBox box;
    QSignalSpy edited(&box, &QuantitySpinBox::valueEdited_K);
    box.setRange_K(273.15, 373.15);
    box.setValue_K(313.1734);
    box.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(box.text(), QStringLiteral("104.0\u00a0°F"));
    EXPECT_NEAR(box.maximum(), 212.0, 1e-9);
    box.setTemperatureUnit(TemperatureUnit::Kelvin);
    EXPECT_EQ(box.text(), QStringLiteral("313.2\u00a0K"));
    box.setTemperatureUnit(TemperatureUnit::Celsius);
    EXPECT_EQ(box.text(), QStringLiteral("40.0\u00a0°C"));
    EXPECT_DOUBLE_EQ(box.value_K(), 313.1734);
    EXPECT_EQ(edited.count(), 0) << "only a person's edits are reported";
}

TEST(QuantitySpinBox, TypingReportsKelvin) {
    QuantitySpinBox box;
    box.setTemperatureUnit(TemperatureUnit::Celsius);
    QSignalSpy edited(&box, &QuantitySpinBox::valueEdited_K);
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("45.5"));
    EXPECT_EQ(edited.count(), 0) << "not before Enter";
    QTest::keyClick(&box, Qt::Key_Return);
    ASSERT_EQ(edited.count(), 1);
    EXPECT_NEAR(edited.first().first().toDouble(), 318.65, 1e-9);
    QTest::keyClick(&box, Qt::Key_Up);
    EXPECT_NEAR(box.value_K(), 319.15, 1e-9);
    box.setValue_K(std::nan(""));
    EXPECT_NEAR(box.value_K(), 319.15, 1e-9) << "not a number is refused";
}

// Catches a number that is silently made another: by a comma, an exponent, or by lying out of range.
TEST(QuantitySpinBox, WhatIsTypedIsWhatIsTaken) {
    QuantitySpinBox box;
    box.setRange_K(223.15, 2273.15);
    const auto taken_degC = [&](const char* text) {
        box.setValue_K(313.15);
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, QString::fromUtf8(text));
        QTest::keyClick(&box, Qt::Key_Return);
        return std::round((box.value_K() - 273.15) * 1e6) * 1e-6;
    };
    for (const QLocale& locale : {QLocale::c(), QLocale(QLocale::French)}) {
        box.setLocale(locale);
        EXPECT_EQ(taken_degC("45,5"), 45.5);
        EXPECT_EQ(taken_degC("45.5"), 45.5);
        EXPECT_EQ(taken_degC("1e3"), 1000.0);
        EXPECT_EQ(taken_degC("-12"), -12.0);
        EXPECT_EQ(taken_degC("-99999"), 40.0) << "out of range: as before";
        EXPECT_EQ(taken_degC("4.5.6"), 40.0);
        EXPECT_EQ(taken_degC(""), 40.0);
    }
}

// Catches 39.9817 that stays where a person has typed 40.0, because both look alike; and an edit of nothing.
TEST(QuantitySpinBox, WhatIsTypedAsItIsShownIsTaken) {
    QuantitySpinBox box;
    QSignalSpy edited(&box, &QuantitySpinBox::valueEdited_K);
    const double found_K = 273.15 + 39.9817;
    const auto enter = [&](const char* text) {
        box.setValue_K(found_K);
        EXPECT_EQ(box.text(), QStringLiteral("40.0\u00a0\u00b0C"));
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, QString::fromUtf8(text));
        QTest::keyClick(&box, Qt::Key_Return);
    };
    for (const char* text : {"40.0", "40", "40,0"}) {
        enter(text);
        EXPECT_EQ(box.value_K(), 313.15) << text;
        EXPECT_EQ(box.text(), QStringLiteral("40.0\u00a0\u00b0C"));
    }
    ASSERT_EQ(edited.count(), 3);
    EXPECT_EQ(edited.last()[0].toDouble(), 313.15);
    QTest::keyClicks(&box, QStringLiteral("40.0"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_EQ(edited.count(), 3) << "it is so already";
    enter("");
    enter("99999");
    EXPECT_EQ(box.value_K(), found_K) << "nothing that could be taken";
    EXPECT_EQ(edited.count(), 3);
}

// Catches a page that cannot follow typing, and one that keeps what was taken back.
TEST(QuantitySpinBox, TypingIsToldAndTakenBack) {
    QuantitySpinBox box;
    box.setValue_K(313.15);
    box.show();
    QSignalSpy typed(&box, &QuantitySpinBox::valueTyped_K), edited(&box, &QuantitySpinBox::valueEdited_K);
    const auto last_degC = [&] { return std::round((typed.last()[0].toDouble() - 273.15) * 1e6) * 1e-6; };
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("90"));
    ASSERT_EQ(typed.count(), 2);
    EXPECT_EQ(last_degC(), 90.0);
    box.setValue_K(363.15); // the page shows what it was told
    EXPECT_FALSE(box.text().contains(QStringLiteral("90.0"))) << "not rewritten under the hand";
    QTest::keyClick(&box, Qt::Key_Escape);
    EXPECT_EQ(last_degC(), 40.0);
    EXPECT_EQ(box.text(), QStringLiteral("40.0\u00a0\u00b0C"));
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("7"));
    QTest::keyClick(&box, Qt::Key_Backspace);
    QTest::keyClick(&box, Qt::Key_Return); // of nothing
    EXPECT_EQ(last_degC(), 40.0);
    EXPECT_EQ(edited.count(), 0);
}

// Catches a live target that changes by an entry that was refused.
TEST(QuantitySpinBox, ARefusedEntryIsNoEdit) {
    QuantitySpinBox box;
    box.setValue_K(313.15);
    box.show();
    QSignalSpy edited(&box, &QuantitySpinBox::valueEdited_K);
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("5"));
    QTest::keyClick(&box, Qt::Key_Escape);
    QTest::keyClick(&box, Qt::Key_Up);
    EXPECT_EQ(edited.count(), 1);
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("4 1"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_NEAR(box.value_K(), 313.65, 1e-9);
    EXPECT_EQ(edited.count(), 1);
}

// Catches a field that shows no value of the program any more, after an arrow key refused what was typed.
TEST(QuantitySpinBox, AfterARefusedArrowKeyItFollowsTheProgram) {
    for (const char* text : {"4 1", "99999", "7 mm"}) {
        QuantitySpinBox box;
        box.setValue_K(313.15);
        box.show();
        box.selectAll();
        QTest::keyClicks(&box, QString::fromUtf8(text));
        QTest::keyClick(&box, Qt::Key_Up);
        EXPECT_NEAR(box.value_K(), 313.15, 1e-9) << text;
        box.setValue_K(323.15);
        EXPECT_EQ(box.text(), QStringLiteral("50.0\u00a0\u00b0C")) << text;
    }
}

// Catches gains of 1e-22 shown or stored as 0.
TEST(GainSpinBox, AnyMagnitude) {
    GainSpinBox box;
    box.setSuffix(QStringLiteral(" s"));
    box.setValue(1e-22);
    EXPECT_DOUBLE_EQ(box.value(), 1e-22);
    EXPECT_EQ(box.text(), QStringLiteral("1e-22 s"));
    box.setValue(0.05);
    EXPECT_EQ(box.text(), QStringLiteral("0.05 s"));
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("2.5e-21"));
    QTest::keyClick(&box, Qt::Key_Return);
    EXPECT_DOUBLE_EQ(box.value(), 2.5e-21);
}

TEST(GainSpinBox, StepsChangeTheSecondDigitAndRetrace) {
    GainSpinBox box;
    box.setValue(8.0);
    box.stepUp();
    EXPECT_NEAR(box.value(), 8.1, 1e-12);
    box.setValue(1.0);
    box.stepDown();
    EXPECT_NEAR(box.value(), 0.99, 1e-12);
    box.stepUp();
    EXPECT_NEAR(box.value(), 1.0, 1e-12);
    box.stepUp();
    EXPECT_NEAR(box.value(), 1.1, 1e-12);
}
