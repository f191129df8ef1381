#include "engine/base/message_code.h"
#include "widgets/common/display.h"
#include "widgets/common/language.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"

#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

using namespace bask;

namespace {

const QString kFrench = QStringLiteral("fr");

void type(QDoubleSpinBox& field, const char* text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, QString::fromUtf8(text));
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace

// Catches numbers in another notation than the language's words, groups of digits that read as a decimal
// mark, and a notation that outlives the language.
TEST(LanguageNotation, IsThatOfTheLanguage) {
    for (const QString& code : Language::codes()) {
        Language language;
        language.set(code);
        const bool isFrench = code == kFrench;
        EXPECT_EQ(formatTemperature(kelvinFromCelsius(40.0), TemperatureUnit::Celsius),
                  isFrench ? QStringLiteral("40,0\u00a0°C") : QStringLiteral("40.0\u00a0°C"))
            << code.toStdString();
        EXPECT_EQ(formatSigned(-12345.25, 2),
                  isFrench ? QStringLiteral("\u221212345,25") : QStringLiteral("\u221212345.25"));
        EXPECT_EQ(QLocale().toString(1234567), QStringLiteral("1234567"));
        EXPECT_EQ(QString::number(0.5), QStringLiteral("0.5")) << "for files";
        language.set(QStringLiteral("en")); // whose fonts the other tests have
    }
    {
        Language french;
        french.set(kFrench);
        EXPECT_EQ(QLocale().toString(0.5), QStringLiteral("0,5"));
    }
    EXPECT_EQ(QLocale().toString(0.5), QStringLiteral("0.5"));
}

// Catches a field that keeps the notation of the language before, or takes its own text for another number.
TEST(LanguageNotation, FieldsFollowWhileTheyAreShown) {
    Language language;
    QWidget window;
    QDoubleSpinBox* length = numberField(&window, QStringLiteral("length"), 0.0, 5000.0, 2, " mm");
    QuantitySpinBox temperature(&window);
    GainSpinBox gain(&window);
    length->setValue(1250.25);
    temperature.setValue_K(kelvinFromCelsius(40.0));
    gain.setValue(2.5);
    for (const QString& code : {kFrench, QStringLiteral("en"), kFrench}) {
        language.set(code);
        const QChar mark = code == kFrench ? u',' : u'.';
        EXPECT_EQ(length->text(), QStringLiteral("1250.25 mm").replace(u'.', mark));
        EXPECT_EQ(temperature.text(), QStringLiteral("40.0\u00a0°C").replace(u'.', mark));
        EXPECT_EQ(gain.text(), QStringLiteral("2.5").replace(u'.', mark));
        EXPECT_DOUBLE_EQ(length->value(), 1250.25);
        EXPECT_DOUBLE_EQ(gain.value(), 2.5);
    }
}

// Catches a mark that is refused, or makes 1250 of 1,25.
TEST(LanguageNotation, FieldsTakePointAndComma) {
    Language language;
    for (const QString& code : Language::codes()) {
        language.set(code);
        QWidget window;
        QDoubleSpinBox* length = numberField(&window, QStringLiteral("length"), 0.0, 5000.0, 3, " mm");
        GainSpinBox gain(&window);
        window.show();
        for (const char* typed : {"1.25", "1,25"}) {
            length->setValue(7.0);
            gain.setValue(7.0);
            type(*length, typed);
            type(gain, typed);
            EXPECT_DOUBLE_EQ(length->value(), 1.25) << code.toStdString() << ' ' << typed;
            EXPECT_DOUBLE_EQ(gain.value(), 1.25) << code.toStdString() << ' ' << typed;
        }
        for (const char* typed : {"1,250.5", "1.250,5", "1,2,5"}) {
            length->setValue(7.0);
            type(*length, typed);
            EXPECT_DOUBLE_EQ(length->value(), 7.0)
                << "not grouped by marks: " << code.toStdString() << ' ' << typed;
        }
        QuantitySpinBox temperature(&window);
        temperature.setRange_K(0.0, 3000.0);
        for (const char* pasted : {"1 500,2", "1\u00a0500.2", "1\u202f500,2"}) {
            const QString text = QString::fromUtf8(pasted);
            for (QDoubleSpinBox* field :
                 std::initializer_list<QDoubleSpinBox*>{length, &temperature, &gain}) {
                auto* line = field->findChild<QLineEdit*>();
                field->setFocus();
                line->selectAll();
                line->insert(text);
                QTest::keyClick(field, Qt::Key_Return);
                EXPECT_NEAR(field->value(), 1500.2, 1e-9) << code.toStdString() << ' ' << pasted;
            }
        }
    }
    language.set(QStringLiteral("en"));
}

// Catches a sentence of two notations, and names, addresses and quotations that are taken for numbers.
TEST(LanguageNotation, SentencesOfTheEngineHaveIt) {
    Language language;
    language.set(kFrench);
    const auto text = [](const Message& message) { return messageText(message, TemperatureUnit::Celsius); };
    EXPECT_EQ(text({MessageCode::ValueOutOfRange, {"0.5", "2.25", "350", "mm"}}),
              QStringLiteral("0,5 is out of range; allowed: 2,25 to 350 mm"));
    EXPECT_TRUE(text({MessageCode::ShadeAtPose, {"a", "12.5", "b"}}).contains(QStringLiteral("12,5 %")));
    EXPECT_TRUE(text({MessageCode::SafetySensorJump, {"a", "12.5", "5"}}).contains(QStringLiteral("12,5")));
    EXPECT_EQ(text({MessageCode::EventNotSettled, {"a.1 +1.5 K"}}),
              QStringLiteral("Not settled: a.1 +1,5 K"));
    EXPECT_EQ(text({MessageCode::EventNotSettled, {"disk 1.2 +1.5 K, b -2.25 K"}}),
              QStringLiteral("Not settled: disk 1.2 +1,5 K; b -2,25 K"));
    EXPECT_EQ(messageText({MessageCode::EventNotSettled, {"disk 1.2 +1.5 K, b -2.5 K"}},
                          TemperatureUnit::Fahrenheit),
              QStringLiteral("Not settled: disk 1.2 +2,7\u00a0°F; b \u22124,5\u00a0°F"));
    EXPECT_TRUE(text({MessageCode::DuplicateName, {"1.5"}}).contains(QStringLiteral("\"1.5\"")));
    EXPECT_TRUE(text({MessageCode::ShadeAtPose, {"1.5", "12.5", "2.5"}}).contains(QStringLiteral("1.5")));
    EXPECT_TRUE(text({MessageCode::MountingOverlap, {"1.5", "2.5 b"}}).contains(QStringLiteral("2.5 b")));
    EXPECT_TRUE(text({MessageCode::VersionTooNew, {"2.1", "2.0"}}).contains(QStringLiteral("2.1")));
    EXPECT_TRUE(text({MessageCode::FileUnreadable, {"1e5"}}).contains(QStringLiteral("1e5")));
    EXPECT_TRUE(text({MessageCode::ContourOpen, {"0.5", "1.25"}}).contains(QStringLiteral("1,25")));
    EXPECT_TRUE(text({MessageCode::MonitorNoBroker, {"10.0.0.2", "OpenSSL 3.0.2 says no"}})
                    .contains(QStringLiteral("10.0.0.2")));
}
