#include "engine/base/message_code.h"
#include "widgets/common/display.h"

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

TEST(Display, DifferencesHaveSignAndNoOffset) {
    EXPECT_EQ(formatDifference(0.5, TemperatureUnit::Celsius), QStringLiteral("+0.5\u00a0K"));
    EXPECT_EQ(formatDifference(-10.0, TemperatureUnit::Fahrenheit), QStringLiteral("\u221218.0\u00a0°F"));
    EXPECT_EQ(formatDifference(-0.04, TemperatureUnit::Celsius), QStringLiteral("0.0\u00a0K"))
        << "no minus zero";
    EXPECT_EQ(formatRate(0.02, TemperatureUnit::Celsius), QStringLiteral("+1.2\u00a0K/min"));
    EXPECT_EQ(formatRate(INFINITY, TemperatureUnit::Celsius), kNoValue);
}

TEST(Display, Durations) {
    EXPECT_EQ(formatDuration(0.0), QStringLiteral("0:00"));
    EXPECT_EQ(formatDuration(59.99), QStringLiteral("0:59"));
    EXPECT_EQ(formatDuration(723.0), QStringLiteral("12:03"));
    EXPECT_EQ(formatDuration(3723.0), QStringLiteral("1:02:03"));
    EXPECT_EQ(formatDuration(std::nan("")), kNoValue);
}

TEST(Display, EveryStateHasWordAndExplanation) {
    for (int i = static_cast<int>(RunState::Idle); i <= static_cast<int>(RunState::Fault); ++i) {
        EXPECT_FALSE(runStateWord(static_cast<RunState>(i)).isEmpty());
        EXPECT_FALSE(runStateExplanation(static_cast<RunState>(i)).isEmpty());
    }
}

// Catches sentences in another unit than the page's, and figures that are no temperatures.
TEST(Display, SentencesSpeakTheUnitShown) {
    const QString sentence =
        QString::fromUtf8("\"K 2\" at 165.56 \u00b0C: 95.4\u00a0\u00b0C, 12.5 K, F = 1.31, "
                          "\u22125 \u00b0C");
    EXPECT_EQ(inUnit(sentence, TemperatureUnit::Celsius),
              QString::fromUtf8("\"K 2\" at 165.6\u00a0\u00b0C: 95.4\u00a0\u00b0C, 12.5 K, F = 1.31, "
                                "\u22125.0\u00a0\u00b0C"));
    EXPECT_EQ(
        inUnit(sentence, TemperatureUnit::Fahrenheit),
        QString::fromUtf8("\"K 2\" at 330.0\u00a0\u00b0F: 203.7\u00a0\u00b0F, 22.5\u00a0\u00b0F, F = 1.31, "
                          "23.0\u00a0\u00b0F"));
    EXPECT_TRUE(inUnit(sentence, TemperatureUnit::Kelvin).contains(QString::fromUtf8("438.7\u00a0K")));
}

// Catches arguments that are themselves taken for placeholders.
TEST(Display, MessageArgumentsAreTakenAsTheyAre) {
    const Message message{MessageCode::ReasonRobotLost, {"%1 of 100 %"}};
    EXPECT_TRUE(messageText(message).contains(QStringLiteral("%1 of 100 %")));
    EXPECT_EQ(messageText(Message{}), QString());
}
