#include "app/why_not.h"

#include "engine/base/message_code.h"
#include "widgets/common/device_words.h"

#include <gtest/gtest.h>

#include <set>

namespace bask::test {

// Catches: a verb that is dead without a word, in any state, and a reason given for one that is possible.
TEST(WhyNot, EveryVerbThatCannotActSaysWhyInEveryState) {
    for (int state = 0; state <= static_cast<int>(RunState::Fault); ++state)
        for (int verb = 0; verb < kVerbs; ++verb)
            for (const bool canRetreat : {false, true}) {
                Snapshot snapshot;
                snapshot.state = static_cast<RunState>(state);
                snapshot.canRetreat = canRetreat;
                const auto which = static_cast<Verb>(verb);
                EXPECT_EQ(whyNot(snapshot, which).isEmpty(), allows(snapshot, which))
                    << runStateName(snapshot.state) << ", verb " << verb;
            }
}

// Catches: a remedy without its verb, and one that has to be waited for with one.
TEST(WhyNot, ARemedyHasItsVerb) {
    EXPECT_EQ(remedyVerb(MessageCode::RemedyReset), Verb::Reset);
    EXPECT_EQ(remedyVerb(MessageCode::RemedyRetreat), Verb::Retreat);
    EXPECT_EQ(remedyVerb(MessageCode::RemedyResume), Verb::Resume);
    EXPECT_EQ(remedyVerb(MessageCode::RemedyStop), Verb::Stop);
    EXPECT_EQ(remedyVerb(MessageCode::RemedyWait), std::nullopt);
    EXPECT_EQ(remedyVerb(MessageCode::None), std::nullopt);
}

// Catches: Home that needs Reset and Reset that needs Home; another cause that still forbids Reset and is not
// said.
TEST(WhyNot, AnUnsurePlaceHasOneOrderOfSteps) {
    Snapshot snapshot;
    snapshot.place = PlaceState::Unsure;
    snapshot.state = RunState::NotReady;
    EXPECT_TRUE(allowsHome(snapshot));
    EXPECT_TRUE(placeSteps(snapshot).startsWith(QStringLiteral("Home the robot")));
    EXPECT_FALSE(placeSteps(snapshot).contains(QStringLiteral("Reset"))) << "nothing is latched";
    snapshot.state = RunState::Fault;
    snapshot.remedy = messageAbout(MessageCode::RemedyWait, {MessageCode::RobotPlaceUnsure, {}});
    EXPECT_TRUE(allowsHome(snapshot));
    EXPECT_TRUE(placeSteps(snapshot).endsWith(QStringLiteral("Then Reset, then Arm.")));
    snapshot.remedy = messageAbout(MessageCode::RemedyWait, {MessageCode::SafetySourceHot, {"253.8", "250"}});
    EXPECT_TRUE(placeSteps(snapshot).contains(QStringLiteral("above its trip limit")));
    for (const RunState state : {RunState::Armed, RunState::Running, RunState::Stopping, RunState::Idle}) {
        snapshot.state = state;
        EXPECT_FALSE(allowsHome(snapshot));
        EXPECT_FALSE(whyNotHome(snapshot).isEmpty());
    }
    snapshot.state = RunState::Ready;
    EXPECT_TRUE(whyNotHome(snapshot).isEmpty());
    snapshot.place = PlaceState::Unknown;
    EXPECT_TRUE(whyNotHome(snapshot).contains(QStringLiteral("does not answer")));
}

// Catches: "Switch it off at its mains" again and again to a person who has done so.
TEST(WhyNot, ASourceThatCoolsSaysWhatResetWaitsFor) {
    Snapshot snapshot;
    snapshot.state = RunState::Fault;
    EXPECT_EQ(unaskedWait(snapshot, TemperatureUnit::Celsius), QString());
    snapshot.unaskedFall = UnaskedFall{0.4, 10.0};
    EXPECT_TRUE(unaskedWait(snapshot, TemperatureUnit::Celsius).contains(QStringLiteral("at its mains")));
    snapshot.unaskedFall->fallen_K = 3.2;
    const QString cools = unaskedWait(snapshot, TemperatureUnit::Celsius);
    EXPECT_FALSE(cools.contains(QStringLiteral("mains"))) << cools.toStdString();
    EXPECT_TRUE(cools.contains(QStringLiteral("fallen by 10\u00a0K; now 3\u00a0K"))) << cools.toStdString();
    EXPECT_TRUE(unaskedWait(snapshot, TemperatureUnit::Fahrenheit).contains(QStringLiteral("18")));
    snapshot.state = RunState::NotReady;
    EXPECT_EQ(unaskedWait(snapshot, TemperatureUnit::Celsius), QString());
}

// Catches: a run without a prediction and without a word, or the same for all causes.
TEST(WhyNot, EachMissingPredictionHasItsCause) {
    using enum RunForecast::Missing;
    std::set<QString> said;
    for (const RunForecast::Missing missing : {NotSeen, NotFinished, NotKnown, NotPossible})
        said.insert(whyNoForecast(missing));
    EXPECT_EQ(said.size(), 4U);
    EXPECT_FALSE(said.contains(QString()));
    EXPECT_EQ(whyNoForecast(Nothing), QString());
}

// Catches: one sentence for everything.
TEST(WhyNot, TheReasonIsTheStates) {
    Snapshot snapshot;
    std::set<QString> said;
    for (const RunState state : {RunState::Idle, RunState::NotReady, RunState::Armed, RunState::Running,
                                 RunState::Stopping, RunState::Fault}) {
        snapshot.state = state;
        said.insert(whyNot(snapshot, Verb::Arm));
    }
    EXPECT_EQ(said.size(), 6U);
    snapshot.state = RunState::NotReady;
    snapshot.reasons = {{MessageCode::ReasonSensorInvalid, {"hand"}}};
    EXPECT_TRUE(whyNot(snapshot, Verb::Arm).contains(QStringLiteral("hand")));
    said.clear();
    for (const PlaceState place : {PlaceState::Sure, PlaceState::Unsure, PlaceState::Unknown}) {
        snapshot.place = place;
        said.insert(whyNot(snapshot, Verb::Retreat));
    }
    EXPECT_EQ(said.size(), 3U);
}

// Catches: an action of the menus that is grey without a word, and a reason given for one that is possible.
TEST(WhyNot, TheOtherActionsSayWhyInEveryState) {
    for (int state = 0; state <= static_cast<int>(RunState::Fault); ++state) {
        Snapshot snapshot;
        snapshot.state = static_cast<RunState>(state);
        const bool isFree = allowsEdits(snapshot.state);
        EXPECT_EQ(whyNotAnother(snapshot).isEmpty(), isFree);
        EXPECT_FALSE(whyNotEndRecording(snapshot).isEmpty()) << "there is none";
        snapshot.recordingPath = "run.bask";
        EXPECT_EQ(whyNotEndRecording(snapshot).isEmpty(), isFree);
    }
    Snapshot snapshot;
    const QString none = whyNotAcknowledge(snapshot);
    snapshot.alarms.resize(2);
    EXPECT_TRUE(whyNotAcknowledge(snapshot).isEmpty());
    snapshot.alarms[0].isAcknowledged = snapshot.alarms[1].isAcknowledged = true;
    EXPECT_FALSE(whyNotAcknowledge(snapshot).isEmpty());
    EXPECT_NE(whyNotAcknowledge(snapshot), none);
}

} // namespace bask::test
