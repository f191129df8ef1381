#include "engine/base/message_code.h"
#include "widgets/common/display.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

// Catches an offset applied to differences, a missing unit and "nan" or "0" shown for an unknown value.
TEST(Display, TemperaturesInEveryUnit) {
    EXPECT_EQ(formatTemperature(313.15, TemperatureUnit::Celsius), QStringLiteral("40.0\u00a0°C"));
    EXPECT_EQ(formatTemperature(313.15, TemperatureUnit::Kelvin, 2), QStringLiteral("313.15\u00a0K"));
    EXPECT_EQ(formatTemperature(313.15, TemperatureUnit::Fahrenheit), QStringLiteral("104.0\u00a0°F"));
    EXPECT_EQ(formatTemperature(std::nan(""), TemperatureUnit::Celsius), kNoValue);
}

// Catches digits that an uncertainty does not allow, and one of "0.00".
TEST(Display, DigitsFollowTheUncertainty) {
    EXPECT_EQ(decimalsOf(0.6, 1), 1);
    EXPECT_EQ(decimalsOf(0.05, 1), 2);
    EXPECT_EQ(decimalsOf(0.0949, 1), 2);
    EXPECT_EQ(decimalsOf(0.0951, 1), 1) << "is shown as 0.1";
    EXPECT_EQ(decimalsOf(0.004, 2), 3);
    EXPECT_EQ(decimalsOf(12.0, 0), 0);
    EXPECT_FALSE(decimalsOf(0.0, 2).has_value());
    EXPECT_FALSE(decimalsOf(1e-9, 2).has_value());
    EXPECT_FALSE(decimalsOf(std::nan(""), 2).has_value());
    const auto reading = [](double standardUncertainty_K) {
        return formatReading(313.273, standardUncertainty_K, TemperatureUnit::Celsius)
            .replace(QChar(0x00a0), u' ');
    };
    EXPECT_EQ(reading(0.3), QString::fromUtf8("40.1 \u00b0C \u00b1 0.6 K"));
    EXPECT_EQ(reading(0.025), QString::fromUtf8("40.12 \u00b0C \u00b1 0.05 K"));
    EXPECT_EQ(reading(6.0), QString::fromUtf8("40 \u00b0C \u00b1 12 K"));
    EXPECT_EQ(reading(0.0), QString::fromUtf8("40.1 \u00b0C"));
}

TEST(Display, DifferencesHaveSignAndNoOffset) {
    EXPECT_EQ(formatDifference(0.5, TemperatureUnit::Celsius), QStringLiteral("+0.5\u00a0K"));
    EXPECT_EQ(formatDifference(-10.0, TemperatureUnit::Fahrenheit), QStringLiteral("\u221218.0\u00a0°F"));
    EXPECT_EQ(formatDifference(-0.04, TemperatureUnit::Celsius), QStringLiteral("0.0\u00a0K"))
        << "no minus zero";
    EXPECT_EQ(formatRate(0.02, TemperatureUnit::Celsius), QStringLiteral("+1.2\u00a0K/min"));
    EXPECT_EQ(formatRate(INFINITY, TemperatureUnit::Celsius), kNoValue);
}

// Catches a column of differences that no reader can add up, and "nan".
TEST(Display, APrintedDifferenceIsThatOfThePrintedNumbers) {
    const auto printed = [](double t_degC, double reference_degC, TemperatureUnit unit, int decimals = 1) {
        return formatPrintedDifference(273.15 + t_degC, 273.15 + reference_degC, unit, decimals);
    };
    EXPECT_EQ(printed(40.14, 39.96, TemperatureUnit::Celsius), QStringLiteral("+0.1\u00a0K"));
    EXPECT_EQ(printed(40.14, 39.96, TemperatureUnit::Celsius, 2), QStringLiteral("+0.18\u00a0K"));
    EXPECT_EQ(printed(39.96, 40.14, TemperatureUnit::Celsius), QStringLiteral("\u22120.1\u00a0K"));
    EXPECT_EQ(printed(40.04, 39.96, TemperatureUnit::Celsius), QStringLiteral("0.0\u00a0K"));
    EXPECT_EQ(printed(std::nan(""), 40.0, TemperatureUnit::Celsius), kNoValue);
    EXPECT_EQ(printed(40.0, std::nan(""), TemperatureUnit::Fahrenheit), kNoValue);
}

TEST(Display, Durations) {
    EXPECT_EQ(formatDuration(0.0), QStringLiteral("0:00"));
    EXPECT_EQ(formatDuration(59.99), QStringLiteral("0:59"));
    EXPECT_EQ(formatDuration(723.0), QStringLiteral("12:03"));
    EXPECT_EQ(formatDuration(3723.0), QStringLiteral("1:02:03"));
    EXPECT_EQ(formatDuration(std::nan("")), kNoValue);
    EXPECT_EQ(formatDuration(1e300), formatDuration(1e15)) << "more than a whole number can hold";
}

TEST(Display, EveryStateHasWordAndExplanation) {
    for (int i = static_cast<int>(RunState::Idle); i <= static_cast<int>(RunState::Fault); ++i) {
        EXPECT_FALSE(runStateWord(static_cast<RunState>(i)).isEmpty());
        EXPECT_FALSE(runStateExplanation(static_cast<RunState>(i)).isEmpty());
    }
}

// Catches sentences in another unit than the reader's, live or as a recording has them, and figures that are
// no temperatures.
TEST(Display, SentencesSpeakTheUnitOfTheReader) {
    const Message live{MessageCode::SafetyObjectHot,
                       {"K 2", roundedTemperatureArg(kelvinFromCelsius(94.83), 1), temperatureArg(363.15)}};
    const Message recorded{MessageCode::SafetyObjectHot, {"K 2", "94.8", "90"}};
    for (const Message& message : {live, recorded}) {
        EXPECT_TRUE(messageText(message, TemperatureUnit::Celsius)
                        .startsWith(QString::fromUtf8(
                            "\"K 2\" is at 94.8\u00a0\u00b0C, above its trip limit of 90.0\u00a0\u00b0C.")));
        EXPECT_TRUE(messageText(message, TemperatureUnit::Kelvin)
                        .contains(QString::fromUtf8("limit of 363.2\u00a0K.")));
        EXPECT_TRUE(
            recordedText(message, std::nullopt)
                .startsWith(QString::fromUtf8("\"K 2\" is at 94.8 \u00b0C, above its trip limit of 90 ")));
    }
    EXPECT_TRUE(messageText(live, TemperatureUnit::Fahrenheit) // of 94.83
                    .startsWith(QString::fromUtf8(
                        "\"K 2\" is at 202.7\u00a0\u00b0F, above its trip limit of 194.0")));
    EXPECT_TRUE(messageText(recorded, TemperatureUnit::Fahrenheit)
                    .startsWith(QString::fromUtf8(
                        "\"K 2\" is at 202.6\u00a0\u00b0F, above its trip limit of 194.0")));
    setReadersUnit(TemperatureUnit::Fahrenheit);
    EXPECT_EQ(messageText(live), messageText(live, TemperatureUnit::Fahrenheit));
    setReadersUnit(TemperatureUnit::Celsius);
}

TEST(Display, AlsoRangesListsAndOtherSentencesDo) {
    const auto text = [](const Message& message) {
        return messageText(message, TemperatureUnit::Fahrenheit);
    };
    EXPECT_TRUE(text({MessageCode::ReasonSensorDistrusted, {"a", "20", "80", "100"}})
                    .contains(QString::fromUtf8("at 176.0 to 212.0\u00a0\u00b0F")));
    EXPECT_TRUE(text({MessageCode::SafetySensorJump, {"a", "12.5", "5"}})
                    .contains(QString::fromUtf8("by 22.5\u00a0\u00b0F/s")));
    EXPECT_EQ(text({MessageCode::ValueOutOfRange, {"400", "25", "350", "\u00b0C"}}),
              QString::fromUtf8("752.0 is out of range; allowed: 77.0 to 662.0 \u00b0F"));
    EXPECT_EQ(text({MessageCode::ValueOutOfRange, {"400", "25", "350", "mm"}}),
              QString::fromUtf8("400 is out of range; allowed: 25 to 350 mm"));
    EXPECT_EQ(text({MessageCode::EventTargetsChanged, {"a 100 \u00b0C, b 40.25 \u00b0C"}}),
              QString::fromUtf8("Targets: a 212.0\u00a0\u00b0F, b 104.5\u00a0\u00b0F"));
    EXPECT_EQ(text({MessageCode::EventNotSettled, {"a +10 K"}}),
              QString::fromUtf8("Not settled: a +18.0\u00a0\u00b0F"));
    EXPECT_TRUE(text({MessageCode::RemedyWait, {"SafetyObjectHot", "a", "100", "90"}})
                    .contains(QString::fromUtf8("\"a\" is at 212.0\u00a0\u00b0F")));
    EXPECT_TRUE(text({MessageCode::SafetySourceUnit, {"77", "25"}}) // it is about the two units
                    .contains(QString::fromUtf8("77 \u00b0C")));
    EXPECT_TRUE(text({MessageCode::ReasonSensorDoubted, {"a", "?"}})
                    .contains(QString::fromUtf8("reads ?\u00a0\u00b0F")));
}

// Catches a question about limits that a reader of another scale or notation is asked in kelvins and points.
TEST(Display, WidenedLimitsSpeakTheReadersUnitAndNotation) {
    const auto text = [](MessageArg name, MessageArg before, MessageArg after) {
        return messageText({MessageCode::LimitLooser, {std::move(name), std::move(before), std::move(after)}},
                           TemperatureUnit::Fahrenheit);
    };
    const auto rate = [](double K_s) { return Message{MessageCode::RateOfChange, {differenceArg(K_s)}}; };
    EXPECT_EQ(text("Sensors apart when cold", differenceArg(5.0), differenceArg(10.0)),
              QString::fromUtf8("Sensors apart when cold: 18.0\u00a0\u00b0F instead of 9.0\u00a0\u00b0F"));
    EXPECT_EQ(
        text("Fastest plausible change", rate(2.0), rate(3.0)),
        QString::fromUtf8("Fastest plausible change: 5.4\u00a0\u00b0F/s instead of 3.6\u00a0\u00b0F/s"));
    EXPECT_EQ(
        text(Message{MessageCode::LimitOfTrip, {"hand"}}, temperatureArg(373.15), temperatureArg(383.15)),
        QString::fromUtf8("trip limit of \"hand\": 230.0\u00a0\u00b0F instead of 212.0\u00a0\u00b0F"));
    QLocale::setDefault(QLocale(QLocale::French));
    EXPECT_EQ(text(Message{MessageCode::LimitHighest, {"x"}}, numberArg(20.0, "cm"), numberArg(20.5, "cm")),
              QStringLiteral("highest x: 20,5 cm instead of 20 cm"));
    QLocale::setDefault(QLocale());
}

// Catches lists of objects that are recorded with points, and names with points, commas and units in them.
TEST(Display, ListsOfObjectsHaveTheReadersNotation) {
    QLocale::setDefault(QLocale(QLocale::French));
    const std::vector<ObjectKelvin> live{{"a 1.5 K, b", 2.5}, {"c", std::nan("")}};
    for (const MessageArg& objects :
         {MessageArg::differences(live), MessageArg("a 1.5 K, b +2.5 K, c ? K")}) {
        const QString text = recordedText({MessageCode::EventNotSettled, {objects}}, std::nullopt);
        EXPECT_TRUE(text.endsWith("b +2,5 K; c ? K")) << text.toStdString();
    }
    EXPECT_EQ(recordedText({MessageCode::EventNotSettled, {MessageArg::differences(live)}}, std::nullopt),
              QStringLiteral("Not settled: a 1.5 K, b +2,5 K; c ? K"));
    EXPECT_EQ(
        recordedText({MessageCode::EventTargetsChanged, {"v1.2 100.5 \u00b0C, b 40 \u00b0C"}}, std::nullopt),
        QString::fromUtf8("Targets: v1.2 100,5 \u00b0C; b 40 \u00b0C"));
    EXPECT_EQ(recordedText({MessageCode::EventNotSettled, {"all"}}, std::nullopt),
              QStringLiteral("Not settled: all"));
    QLocale::setDefault(QLocale());
}

// Catches arguments that are themselves taken for placeholders.
TEST(Display, MessageArgumentsAreTakenAsTheyAre) {
    const Message message{MessageCode::ReasonRobotLost, {"%1 of 100 %"}};
    EXPECT_TRUE(messageText(message).contains(QStringLiteral("%1 of 100 %")));
    EXPECT_EQ(messageText(Message{}), QString());
}
