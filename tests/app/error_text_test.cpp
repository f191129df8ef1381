#include "app/error_text.h"
#include "app/resources.h"
#include "engine/base/message_code.h"
#include "widgets/common/alarm_words.h"
#include "widgets/common/language.h"

#include <gtest/gtest.h>

namespace bask::test {
namespace {

TEST(ErrorText, NamesThePlace) {
    EXPECT_EQ(sentence(Error(MessageCode::FileEmpty, "a.json")), QStringLiteral("a.json: the file is empty"));
    EXPECT_EQ(sentence(Error(MessageCode::FileEmpty, "")), QStringLiteral("the file is empty"));
}

// Catches: an argument with a percent sign taken for a placeholder.
TEST(ErrorText, ArgumentsAreNotPlaceholders) {
    EXPECT_TRUE(sentence(Message{MessageCode::FileUnreadable, {"100%1"}}).endsWith(QStringLiteral("100%1")));
}

// Catches: English words of the engine inside a translated sentence.
TEST(ErrorText, WordsOfTheEngineAreTranslatedToo) {
    initResources();
    Language language;
    language.set(QStringLiteral("fr"));
    const QString refusal = sentence(Message{MessageCode::CommandNotNow, {"Start", "Not ready"}});
    EXPECT_FALSE(refusal.contains(QStringLiteral("Start"))) << refusal.toStdString();
    EXPECT_FALSE(refusal.contains(QStringLiteral("Not ready"))) << refusal.toStdString();
    const QString tooEarly = sentence(Message{MessageCode::CommandNotNow, {"Reset", "Connecting"}});
    EXPECT_FALSE(tooEarly.contains(QStringLiteral("Connecting"))) << tooEarly.toStdString();
    const QString incomplete = sentence(Message{MessageCode::RigIncomplete, {"heat source"}});
    EXPECT_TRUE(incomplete.contains(QStringLiteral("source de chaleur"))) << incomplete.toStdString();
    const QString over = sentence(Message{MessageCode::EventAlarmOver, {"SafetySensorOpen", "disk"}});
    EXPECT_TRUE(over.contains(QStringLiteral("capteur"))) << over.toStdString();
}

// Catches: English words for what an export may replace inside a translated refusal.
TEST(ErrorText, WhatMayBeReplacedIsTranslated) {
    initResources();
    Language language;
    for (const QString& code : Language::codes()) {
        language.set(code);
        for (const char* kind :
             {"a table written by Bask", "a comparison written by Bask", "a figure drawn by Bask",
              "a report written by Bask", "a NeXus file written by Bask", "lines written by Bask",
              "a collection written by Bask", "a field written by Bask", "a surface file written by Bask"}) {
            const QString refusal = sentence(Message{MessageCode::OutputForeign, {kind}});
            EXPECT_EQ(refusal.contains(QLatin1String(kind)), code == QLatin1String("en"))
                << refusal.toStdString();
        }
    }
}

// Catches: a headline that is the whole text where sentences end with a Chinese full stop.
TEST(ErrorText, TheHeadlineIsTheFirstSentence) {
    initResources();
    Language language;
    Alarm alarm;
    alarm.message = {MessageCode::SafetyObjectHot, {"disk", "152.3", "150"}};
    for (const QString& code : Language::codes()) {
        language.set(code);
        const QString headline = alarmHeadline(alarm, TemperatureUnit::Celsius);
        EXPECT_LT(3 * headline.size(), 2 * alarmSentence(alarm, TemperatureUnit::Celsius).size())
            << headline.toStdString();
        EXPECT_TRUE(headline.contains(QStringLiteral("150"))) << headline.toStdString();
    }
}

} // namespace
} // namespace bask::test
