#include "widgets/common/language.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace bask;

namespace {

class NumberFieldTest : public ::testing::Test {
protected:
    NumberFieldTest() {
        window.resize(600, 300);
        window.show();
    }

    NumberField* field(double min, double max, int decimals, const char* suffix) {
        auto* made =
            numberField(&window, QStringLiteral("field"), min, max, decimals, QString::fromUtf8(suffix));
        made->show();
        return static_cast<NumberField*>(made);
    }

    /// As a person who selects everything, the unit too, or only the number.
    static void type(QDoubleSpinBox& field, const char* text, bool isAll = false) {
        field.setFocus();
        field.selectAll();
        if (isAll)
            field.findChild<QLineEdit*>()->selectAll();
        for (const QChar letter : QString::fromUtf8(text)) { // keyClicks knows Latin letters only
            QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, QString(letter));
            QApplication::sendEvent(&field, &press);
        }
        QTest::keyClick(&field, Qt::Key_Return);
    }

    /// What stands beside the field; empty if nothing.
    QString refusal() {
        const auto* label = window.findChild<QLabel*>(QStringLiteral("fieldRefusal"));
        return label != nullptr && label->isVisible() ? label->text() : QString();
    }

    QWidget window;
};

} // namespace

// Catches 15 mm that become 15 cm.
TEST_F(NumberFieldTest, AUnitThatIsTypedCounts) {
    Language language;
    for (const QString& code : Language::codes()) {
        language.set(code);
        NumberField* length = field(-100.0, 100.0, 2, " cm");
        for (const bool isAll : {false, true}) {
            for (const auto& [text, value] :
                 std::initializer_list<std::pair<const char*, double>>{{"15 mm", 1.5},
                                                                       {"15mm", 1.5},
                                                                       {"2.5 cm", 2.5},
                                                                       {"2,5 cm", 2.5},
                                                                       {"0.1 m", 10.0},
                                                                       {"-3 mm", -0.3}}) {
                length->setValue(7.0);
                type(*length, text, isAll);
                EXPECT_DOUBLE_EQ(length->value(), value) << code.toStdString() << ' ' << text;
                EXPECT_EQ(refusal(), QString()) << text;
                EXPECT_TRUE(length->text().endsWith(QStringLiteral(" cm"))) << length->text().toStdString();
            }
        }
        delete length;
    }
    language.set(QStringLiteral("en"));
    NumberField* time = field(0.0, 86400.0, 1, " s");
    type(*time, "2 min");
    EXPECT_DOUBLE_EQ(time->value(), 120.0);
    type(*time, "1.5 h");
    EXPECT_DOUBLE_EQ(time->value(), 5400.0);
    NumberField* share = field(0.0, 1.0, 3, "");
    type(*share, "50 %");
    EXPECT_DOUBLE_EQ(share->value(), 0.5);
    NumberField* angle = field(-180.0, 180.0, 1, "\u00b0");
    type(*angle, "1 rad");
    EXPECT_DOUBLE_EQ(angle->value(), 57.3);
    type(*angle, "30\u00b0");
    EXPECT_DOUBLE_EQ(angle->value(), 30.0);
}

// Catches a number that is taken without its unit, and one that is dropped without a word.
TEST_F(NumberFieldTest, AUnitOfSomethingElseIsRefusedWithWords) {
    NumberField* length = field(0.0, 100.0, 2, " cm");
    QSignalSpy refused(length, &NumberField::refused);
    for (const char* text : {"15 K", "15 s", "15 mm/s", "15 x", "15 c", "15 %"}) {
        length->setValue(7.0);
        type(*length, text);
        EXPECT_EQ(length->value(), 7.0) << text;
        EXPECT_EQ(length->text(), QStringLiteral("7.00 cm"));
        EXPECT_TRUE(refusal().contains(QString::fromUtf8(text))) << refusal().toStdString();
        EXPECT_TRUE(refusal().endsWith(QStringLiteral("is in cm"))) << refusal().toStdString();
    }
    EXPECT_EQ(refused.count(), 6);
    type(*length, "8 cm");
    EXPECT_EQ(length->value(), 8.0);
    EXPECT_EQ(refusal(), QString()) << "gone with the next number";
    NumberField* bare = field(0.0, 1.0, 3, "");
    type(*bare, "0.5 mm");
    EXPECT_EQ(bare->value(), 0.0);
    EXPECT_TRUE(refusal().contains(QStringLiteral("no unit"))) << refusal().toStdString();
}

// Catches "1.5" that is taken as 15 or 2, and a thousand as 1.
TEST_F(NumberFieldTest, WhatIsNoWholeNumberIsRefusedWithWords) {
    Language language;
    WholeNumberField width(&window);
    width.setSuffix(QStringLiteral(" px"));
    width.setRange(1, 5000);
    width.show();
    for (const QString& code : Language::codes()) {
        language.set(code);
        width.setValue(7);
        for (const char* text : {"1.5", "1,5", "1.0", "1,000", "1.000", "\uff11\uff0e\uff15", "15e-1", "4 1",
                                 "abc", "1 cm", "0", "81920", "99999999999999999999"}) {
            for (const bool isAll : {false, true}) {
                type(width, text, isAll);
                EXPECT_EQ(width.whole(), 7) << code.toStdString() << ' ' << text;
                EXPECT_EQ(width.text(), QStringLiteral("7 px"));
                EXPECT_TRUE(refusal().contains(QString::fromUtf8(text)))
                    << text << ": " << refusal().toStdString();
            }
        }
        for (const auto& [text, value] : std::initializer_list<std::pair<const char*, int>>{
                 {"12", 12}, {" 34 ", 34}, {"+5", 5}, {"1 000", 1000}, {"60 px", 60}, {"5000", 5000}}) {
            type(width, text, true);
            EXPECT_EQ(width.whole(), value) << code.toStdString() << ' ' << text;
            EXPECT_EQ(refusal(), QString()) << text;
        }
    }
    language.set(QStringLiteral("en"));
    type(width, "1.5");
    EXPECT_TRUE(refusal().contains(QStringLiteral("whole number"))) << refusal().toStdString();
    width.setValue(7);
    width.stepUp();
    EXPECT_EQ(width.text(), QStringLiteral("8 px"));
}

// Catches "41,5,5" that is taken as 41.55 or 415, and "1e" as 1.
TEST_F(NumberFieldTest, WhatIsNoNumberIsRefusedWithWords) {
    Language language;
    for (const QString& code : Language::codes()) {
        language.set(code);
        NumberField* length = field(0.0, 5000.0, 2, " mm");
        QuantitySpinBox temperature(&window);
        temperature.setRange_K(0.0, 3000.0);
        GainSpinBox gain(&window);
        for (QDoubleSpinBox* each : std::initializer_list<QDoubleSpinBox*>{length, &temperature, &gain}) {
            each->show();
            for (const char* text :
                 {"41,5,5", "41.5.5", "4,1,5", "4 1", "1e", "--5", "abc", "41,5 5", "1,234.5"}) {
                if (each == &temperature)
                    temperature.setValue_K(kelvinFromCelsius(7.0));
                else
                    each->setValue(7.0);
                type(*each, text);
                EXPECT_NEAR(each->value(), 7.0, 1e-9) << code.toStdString() << ' ' << text;
                EXPECT_TRUE(refusal().contains(QString::fromUtf8(text))) << refusal().toStdString();
            }
        }
        type(*length, "5001");
        EXPECT_EQ(length->value(), 7.0);
        EXPECT_TRUE(refusal().contains(QStringLiteral("5000"))) << "the range: " << refusal().toStdString();
        type(*length, "");
        EXPECT_EQ(length->value(), 7.0);
        delete length;
    }
    language.set(QStringLiteral("en"));
}

// Catches the number of a refused unit that stays where fields take it while it is typed.
TEST_F(NumberFieldTest, WhatWasTakenOnTheWayIsTakenBack) {
    NumberField* length = field(0.0, 100.0, 2, " cm");
    length->setKeyboardTracking(true);
    GainSpinBox gain(&window);
    gain.setSuffix(QStringLiteral(" s"));
    gain.show();
    for (QDoubleSpinBox* each : std::initializer_list<QDoubleSpinBox*>{length, &gain}) {
        each->setValue(7.0);
        type(*each, "15 K");
        EXPECT_EQ(each->value(), 7.0);
        type(*each, "8");
        each->stepUp();
        const double stepped = each->value();
        EXPECT_GT(stepped, 8.0);
        type(*each, "3 K");
        EXPECT_EQ(each->value(), stepped) << "not the one before";
    }
}

// Catches a screen reader that is told nothing.
TEST_F(NumberFieldTest, ARefusalDescribesTheFieldUntilTheNextEdit) {
    NumberField* length = field(0.0, 100.0, 2, " cm");
    length->setAccessibleDescription(QStringLiteral("of the object"));
    type(*length, "15 K");
    EXPECT_EQ(length->accessibleDescription(), refusal());
    EXPECT_NE(refusal(), QString());
    type(*length, "8");
    EXPECT_EQ(length->accessibleDescription(), QStringLiteral("of the object"));
}

// Catches words that stand on another page, or beside another field.
TEST_F(NumberFieldTest, ARefusalGoesWithItsField) {
    QWidget page(&window);
    page.resize(300, 200);
    page.show();
    NumberField* length = field(0.0, 100.0, 2, " cm");
    length->setParent(&page);
    length->show();
    const auto refuse = [&] {
        type(*length, "15 K");
        return !refusal().isEmpty();
    };
    ASSERT_TRUE(refuse());
    page.hide();
    EXPECT_EQ(refusal(), QString());
    page.show();
    ASSERT_TRUE(refuse());
    page.move(0, 50);
    EXPECT_EQ(refusal(), QString());
    ASSERT_TRUE(refuse());
    window.resize(500, 300);
    EXPECT_TRUE(QTest::qWaitFor([&] { return refusal().isEmpty(); }));
}

// Catches 0.4 mm that become none, or words that mean something else.
TEST_F(NumberFieldTest, WhatIsTooSmallForTheDigitsIsRefused) {
    NumberField* length = field(-100.0, 100.0, 1, " cm");
    length->setValue(7.0);
    type(*length, "0.4 mm");
    EXPECT_EQ(length->value(), 7.0);
    EXPECT_TRUE(refusal().endsWith(QStringLiteral("0.0 cm"))) << refusal().toStdString();
    for (const auto& [text, value] : std::initializer_list<std::pair<const char*, double>>{
             {"0 mm", 0.0}, {"0.6 mm", 0.1}, {"-1 m", -100.0}, {"12.34", 12.3}}) {
        type(*length, text);
        EXPECT_EQ(length->value(), value) << text;
        EXPECT_EQ(refusal(), QString()) << text;
    }
    NumberField* automatic = field(2.0, 10.0, 0, " cm");
    automatic->setSpecialValueText(QStringLiteral("Automatic"));
    automatic->setValue(7.0);
    type(*automatic, "23 mm");
    EXPECT_EQ(automatic->value(), 7.0);
    EXPECT_TRUE(refusal().endsWith(QStringLiteral("Automatic"))) << refusal().toStdString();
    type(*automatic, "1");
    EXPECT_TRUE(refusal().contains(QStringLiteral("more than 2 cm"))) << refusal().toStdString();
    type(*automatic, "20 mm");
    EXPECT_EQ(automatic->value(), 2.0) << "that is what the words stand for";
    QuantitySpinBox temperature(&window);
    temperature.show();
    type(temperature, "0.04");
    EXPECT_NEAR(temperature.value_K(), 273.15, 1e-9) << "a temperature as any other";
}

// Catches a thousand that is taken as 1.
TEST_F(NumberFieldTest, ACommaThatMayGroupThousandsIsRefused) {
    NumberField* length = field(0.0, 5000.0, 3, " mm");
    const auto taken = [&](const QLocale& locale, const char* text) {
        length->setLocale(locale);
        length->setValue(7.0);
        type(*length, text);
        return length->value();
    };
    const QLocale english(QLocale::English), french(QLocale::French);
    EXPECT_EQ(taken(english, "1,234"), 7.0);
    EXPECT_TRUE(refusal().endsWith(QStringLiteral("type 1234 or 1.234"))) << refusal().toStdString();
    EXPECT_EQ(taken(english, "1,500 cm"), 7.0);
    EXPECT_EQ(taken(english, "0,234"), 0.234);
    EXPECT_EQ(taken(english, "1,23"), 1.23);
    EXPECT_EQ(taken(english, "1.234"), 1.234);
    EXPECT_EQ(taken(french, "1,234"), 1.234);
}

// Catches a refusal that brings back the number before the last step, or the half of one that was cleared.
TEST_F(NumberFieldTest, ARefusalBringsBackTheLastNumberOnly) {
    NumberField* length = field(0.0, 100.0, 2, " cm");
    for (const bool isTracking : {false, true}) {
        length->setKeyboardTracking(isTracking);
        length->setValue(7.0);
        length->setFocus();
        length->selectAll();
        QTest::keyClicks(length, QStringLiteral("8"));
        QTest::keyClick(length, Qt::Key_Up); // without Enter
        EXPECT_EQ(length->value(), 9.0);
        QSignalSpy changed(length, &QDoubleSpinBox::valueChanged);
        type(*length, "x");
        EXPECT_EQ(length->value(), 9.0);
        for (const auto& each : changed) // a tracking field tells what is entered, changed or not
            EXPECT_EQ(each.first().toDouble(), 9.0);
        type(*length, "3 K");
        EXPECT_EQ(length->value(), 9.0);
        length->selectAll();
        QTest::keyClicks(length, QStringLiteral("15"));
        length->findChild<QLineEdit*>()->selectAll();
        QTest::keyClick(length, Qt::Key_Delete);
        QTest::keyClick(length, Qt::Key_Return);
        EXPECT_EQ(length->value(), 9.0) << "not the 15 on the way";
        EXPECT_EQ(refusal(), QString()) << "nothing was typed";
    }
}

// Catches a gain that steps away from the number that it has just put back.
TEST_F(NumberFieldTest, ARefusedGainDoesNotStep) {
    GainSpinBox gain(&window);
    gain.show();
    gain.setValue(7.0);
    gain.setFocus();
    gain.selectAll();
    QTest::keyClicks(&gain, QStringLiteral("41,5,5"));
    QTest::keyClick(&gain, Qt::Key_Up);
    EXPECT_EQ(gain.value(), 7.0);
    EXPECT_NE(refusal(), QString());
    QTest::keyClick(&gain, Qt::Key_Up);
    EXPECT_NEAR(gain.value(), 7.1, 1e-12);
}

// Catches words about a field that nobody has typed into.
TEST_F(NumberFieldTest, WhatIsShownIsNotRefused) {
    NumberField* automatic = field(0.0, 10.0, 1, " mm");
    automatic->setSpecialValueText(QStringLiteral("\u2014"));
    GainSpinBox gain(&window);
    gain.setRange(0.0, 0.123456); // shown as 0.1235
    gain.setValue(0.123456);
    for (QDoubleSpinBox* each : std::initializer_list<QDoubleSpinBox*>{automatic, &gain}) {
        const double before = each->value();
        each->show();
        each->setFocus();
        QTest::keyClick(each, Qt::Key_Return);
        EXPECT_EQ(each->value(), before);
        EXPECT_EQ(refusal(), QString());
    }
}

TEST_F(NumberFieldTest, TemperaturesAreTypedOnAnyScale) {
    QuantitySpinBox box(&window);
    box.setRange_K(0.0, 3000.0);
    box.show();
    for (const TemperatureUnit unit :
         {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit}) {
        box.setTemperatureUnit(unit);
        for (const char* text : {"100 \u00b0C", "100 degC", "373.15 K", "212 \u00b0F", "212F", "212\u2109"}) {
            box.setValue_K(300.0);
            type(box, text);
            EXPECT_NEAR(box.value_K(), 373.15, 0.06) << text; // a tenth of what is shown
        }
        for (const char* text : {"15 mm", "15 \u00b0", "15 K/min"}) {
            box.setValue_K(300.0);
            type(box, text);
            EXPECT_EQ(box.value_K(), 300.0) << text;
            EXPECT_TRUE(refusal().contains(QString::fromUtf8(text))) << refusal().toStdString();
        }
    }
}

TEST(TypedValue, IsANumberWithAUnitOrWithout) {
    const auto expect = [](const char* text, double value, const char* unit) {
        const auto typed = typedValue(QString::fromUtf8(text));
        ASSERT_TRUE(typed.has_value()) << text;
        EXPECT_EQ(typed->value, value) << text;
        EXPECT_EQ(typed->unit, QString::fromUtf8(unit)) << text;
    };
    expect(" 2,5 ", 2.5, "");
    expect("\u22122.5e-3", -2.5e-3, "");
    expect("1 234\u202f500,25", 1234500.25, "");
    expect("1 234,5 mm", 1234.5, "mm");
    expect("40.0\u00a0\u00b0C", 40.0, "\u00b0C");
    expect(".5mm", 0.5, "mm");
    expect("\uff0d\uff11\uff0e\uff15\uff4d\uff4d", -1.5, "mm");
    expect("\uff11\uff0c\uff15\u3000\uff05", 1.5, "%");
    expect("2\u30025", 2.5, "");
    expect("1e3 1/s", 1000.0, "1/s");
    expect("2 /min", 2.0, "/min");
    expect("12 W/(m\u00b2 K)", 12.0, "W/(m\u00b2 K)");
    for (const char* none : {"", "mm", "2,5,1", "nan", "inf", "1,250.5", "1 5", "4\u00a01", "1 2345", "1e",
                             "1e+", "1e999", "- 5", "1-2"})
        EXPECT_FALSE(typedValue(QString::fromUtf8(none)).has_value()) << none;
}
