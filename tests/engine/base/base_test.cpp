#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/base/plain_text.h"
#include "engine/base/pose.h"
#include "engine/base/program_part.h"
#include "engine/base/result.h"
#include "engine/base/share_done.h"
#include "engine/base/thread_priority.h"
#include "engine/base/units.h"
#include "engine/base/words.h"
#include "tests/support/told_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace bask {

TEST(Units, TemperaturesGoThereAndBack) {
    for (const auto unit : {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit})
        EXPECT_NEAR(kelvinFromDisplay(displayTemperature(313.15, unit), unit), 313.15, 1e-9);
    EXPECT_NEAR(displayTemperature(313.15, TemperatureUnit::Fahrenheit), 104.0, 1e-9);
    EXPECT_NEAR(displayDifference(0.5, TemperatureUnit::Fahrenheit), 0.9, 1e-12); // no offset in a difference
}

// Catches "circle +1.1e+02 K" in a sentence.
TEST(FormatNumber, HasNoExponentWhereAPersonReadsIt) {
    EXPECT_EQ(formatNumber(113.4, 2), "113");
    EXPECT_EQ(formatNumber(-99.6, 2), "-100");
    EXPECT_EQ(formatNumber(99.4, 2), "99");
    EXPECT_EQ(formatNumber(0.034, 2), "0.034");
    EXPECT_EQ(formatNumber(12345.6, 4), "12346");
    EXPECT_EQ(formatNumber(12345.6, 6), "12345.6");
    EXPECT_EQ(formatNumber(1.25e7, 3), "1.25e+07");
}

// Catches work that is left out or done twice, an exception that ends the program, and the rest of the work
// done all the same.
TEST(Parallel, DoesEachPieceOnceAndPassesOnTheFirstException) {
    for (const int threads : {0, 1, 3, 40}) {
        std::vector<std::atomic<int>> times(25);
        int told = 0;
        runInParallel(
            25, threads, [&](int index) { ++times[static_cast<std::size_t>(index)]; },
            [&](int done) {
                EXPECT_GE(done, told);
                told = done;
            });
        EXPECT_TRUE(std::ranges::all_of(times, [](const std::atomic<int>& each) { return each == 1; }));
    }
    std::atomic<int> begun = 0;
    const auto fail = [&](int) {
        ++begun;
        throw std::runtime_error("mine");
    };
    EXPECT_THROW(runInParallel(1000, 2, fail, {}), std::runtime_error);
    EXPECT_LE(begun, 2);
    runInParallel(0, 2, fail, {});
}

// Catches a niceness that the whole program has, or none.
TEST(ThreadPriority, IsThatOfTheCallingThread) {
    const auto niceness = [] { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())); };
    const int before = niceness();
    int nice = 0;
    std::jthread([&] {
        giveWay();
        nice = niceness();
    }).join();
    EXPECT_GE(nice, 10);
    EXPECT_EQ(niceness(), before);
}

// Catches a part that is missed where tests have it, and one that is said to be where it is not.
TEST(ProgramPart, IsFoundBesideTheProgramAndWhereItWasBuilt) {
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
    EXPECT_EQ(programPart(own.filename(), ""), own.string());
    EXPECT_EQ(programPart("null", "/dev"), "/dev/null");
    EXPECT_EQ(programPart("null", ""), "");
    EXPECT_EQ(programPart("no-such-part", "/dev"), "");
}

TEST(Pose, CoordinatesAreRzRyRx) {
    Vector6d q = Vector6d::Zero();
    q.tail<3>() = Eigen::Vector3d(0.3, -0.4, 1.1);
    const Eigen::Matrix3d R =
        (Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()))
            .toRotationMatrix();
    EXPECT_LT((poseFromCoordinates(q).linear() - R).norm(), 1e-15);
}

TEST(Pose, CoordinatesComeBackAlsoNearTheSingularTilt) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    for (int i = 0; i < 200; ++i) {
        Vector6d q;
        q << u(random), u(random), u(random), 3.0 * u(random), 1.57 * u(random), 3.0 * u(random);
        EXPECT_LT((coordinatesFromPose(poseFromCoordinates(q)) - q).norm(), 1e-9) << q.transpose();
    }
}

TEST(Pose, RotationAxesAreTheAngularVelocitiesOfTheAngles) {
    Vector6d q = Vector6d::Zero();
    q.tail<3>() = Eigen::Vector3d(0.3, -0.4, 1.1);
    const Eigen::Matrix3d axes = rotationAxes(q);
    for (int k = 0; k < 3; ++k) {
        Vector6d next = q;
        next[3 + k] += 1e-7;
        const Eigen::Matrix3d turn =
            poseFromCoordinates(next).linear() * poseFromCoordinates(q).linear().transpose();
        const Eigen::AngleAxisd rotation(turn);
        EXPECT_LT((rotation.angle() * rotation.axis() / 1e-7 - axes.col(k)).norm(), 1e-5);
    }
}

TEST(Pose, RotationVectorOfZeroLengthIsTheIdentity) {
    const Pose X = poseFromRotationVector(Eigen::Vector3d(1.0, 2.0, 3.0), Eigen::Vector3d::Zero());
    EXPECT_TRUE(X.linear().isIdentity());
    EXPECT_EQ(X.translation(), Eigen::Vector3d(1.0, 2.0, 3.0));
}

// Catches: a way that turns about another axis, the long way round, or not evenly.
TEST(Pose, TheWayBetweenPosesIsEven) {
    const Eigen::Vector3d axis(0.3, -0.4, 1.2);
    const Pose from = poseFromRotationVector({1.0, 2.0, 3.0}, {2.0, 0.1, -0.5});
    const Pose turn = poseFromRotationVector(Eigen::Vector3d::Zero(), axis);
    Pose to = from * turn;
    to.translation() = Eigen::Vector3d(2.0, 0.0, 3.0);
    const Pose quarter = poseBetween(from, to, 0.25);
    EXPECT_LT((quarter.translation() - Eigen::Vector3d(1.25, 1.5, 3.0)).norm(), 1e-12);
    const Pose turned = from * poseFromRotationVector(Eigen::Vector3d::Zero(), 0.25 * axis);
    EXPECT_TRUE(quarter.linear().isApprox(turned.linear(), 1e-12));
    EXPECT_TRUE(poseBetween(from, to, 0.0).isApprox(from, 1e-12));
    EXPECT_TRUE(poseBetween(from, to, 1.0).isApprox(to, 1e-12));
}

TEST(Result, ReadingTheWrongSideIsABrokenContract) {
    const Result<int> good = 7;
    const Result<int> bad = Error(MessageCode::FileNotFound, "x.json");
    EXPECT_EQ(good.value(), 7);
    EXPECT_THROW((void)good.error(), std::logic_error);
    EXPECT_THROW((void)bad.value(), std::logic_error);
}

TEST(Message, SaysWhereWhatAndWhatToDo) {
    EXPECT_EQ(describe(Error(MessageCode::FileNotFound, "x.json")),
              "x.json: there is no such file; check the path");
    EXPECT_EQ(describe(Message{MessageCode::TargetCountWrong, {"2", "3"}}), "2 targets given for 3 objects");
    EXPECT_EQ(describe(Message{MessageCode::TargetCountWrong, {}}),
              " targets given for  objects"); // missing arguments are harmless
}

// Catches: the end of an alarm that is recorded without what it was, and recordings of before with words
// there.
TEST(Message, TheEndOfAnAlarmSaysWhichOne) {
    EXPECT_EQ(describe(Message{MessageCode::EventAlarmOver, {"TargetCountWrong", "2", "3"}}),
              "over: 2 targets given for 3 objects");
    EXPECT_EQ(describe(Message{MessageCode::EventAlarmOver, {"The robot stood."}}), "over: The robot stood.");
    EXPECT_EQ(describe(Message{MessageCode::EventAlarmOver, {"EventAlarmOver", "x"}}),
              "over: EventAlarmOver");
}

// Catches a value whose text in files or in English is not what it was before there were values, and one that
// is read back as something else.
TEST(Message, ArgumentsKeepTheirValueAndTheirText) {
    const double t_K = kelvinFromCelsius(94.8321);
    const Message hot{MessageCode::SafetyObjectHot,
                      {"left", roundedTemperatureArg(t_K), temperatureArg(363.15)}};
    EXPECT_EQ(argTexts(hot), (std::vector<std::string>{"left", "94.8", "90"}));
    EXPECT_EQ(describe(hot).find("\"left\" is at 94.8 \u00b0C, above its trip limit of 90 \u00b0C. "), 0U);
    EXPECT_DOUBLE_EQ(hot.args[1].kelvin(argKind(hot.code, 1)).value(), t_K);
    EXPECT_EQ(describe(Message{MessageCode::SafetyObjectHot, {"left", "94.8", "90"}}), describe(hot));
    EXPECT_NEAR(MessageArg("94.8").kelvin(ArgKind::Temperature).value(), 367.95, 1e-9);
    EXPECT_NEAR(MessageArg("12.4").kelvin(ArgKind::Difference).value(), 12.4, 1e-12);
    EXPECT_FALSE(MessageArg("?").kelvin(ArgKind::Temperature));
    EXPECT_EQ(describe(Message{MessageCode::SafetySensorJump, {"a", differenceArg(12.34, 3), "5"}})
                  .find("The sensor of \"a\" jumped by 12.3 K/s; heat can change it by at most 5 K/s."),
              0U);
    EXPECT_EQ(roundedTemperatureArg(std::nan("")).text(), "?");
}

// Catches objects whose names look like what stands between them.
TEST(Message, ObjectsWithTemperaturesAreReadBack) {
    const MessageArg live = MessageArg::temperatures(
        {{"left, big", kelvinFromCelsius(60.0)}, {"b 5", kelvinFromCelsius(55.555)}});
    EXPECT_EQ(live.text(), "left, big 60 \u00b0C, b 5 55.56 \u00b0C");
    const auto read = MessageArg(live.text()).objects(ArgKind::Temperatures);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read[0].object, "left, big");
    EXPECT_EQ(read[1].object, "b 5");
    EXPECT_NEAR(read[1].value_K, kelvinFromCelsius(55.56), 1e-9);
    const MessageArg off = MessageArg::differences({{"a", 2.13}, {"b", -0.5}, {"c", std::nan("")}});
    EXPECT_EQ(off.text(), "a +2.1 K, b -0.5 K, c ? K");
    EXPECT_NEAR(MessageArg(off.text()).objects(ArgKind::Differences).at(0).value_K, 2.1, 1e-12);
    EXPECT_TRUE(MessageArg("some words").objects(ArgKind::Differences).empty());
}

// Catches a sentence that files keep otherwise than as its English words.
TEST(Message, ASentenceMayBeAnArgument) {
    const Message off{MessageCode::SafetyHeatNotOff, {Message{MessageCode::LinkStuck, {"COM1"}}}};
    EXPECT_EQ(off.args[0].text(), describe(off.args[0].sentences().at(0)));
    EXPECT_NE(describe(off).find("Its answer: \"COM1\" takes no more bytes"), std::string::npos);
    EXPECT_TRUE(MessageArg("words").sentences().empty());
}

TEST(Message, VerbsAreComparedAsValues) {
    EXPECT_TRUE(isVerb(verbArg(CommandVerb::SetTargets), CommandVerb::SetTargets));
    EXPECT_FALSE(isVerb("Stop", CommandVerb::Start));
    EXPECT_STREQ(wordText(ArgKind::Fault, "sensor-open"), "Sensor open");
    const std::string unknown = "Hold:0"; // a device's own word
    EXPECT_STREQ(wordText(ArgKind::State, unknown), "Hold:0");
}

TEST(Message, EveryCodeHasASentenceAndAUniqueName) {
    std::set<std::string> names;
    int i = 0;
    for (;; ++i) {
        const auto code = static_cast<MessageCode>(i);
        if (messageCodeFromName(messageName(code)) != code)
            break;
        EXPECT_TRUE(names.insert(messageName(code)).second);
        EXPECT_TRUE(i == 0 || messageTemplate(code)[0] != '\0') << messageName(code);
    }
    // The last code of the enumeration: a code without an entry would end the walk before it.
    EXPECT_GT(i, 250);
}

// Catches: two names that look the same, and words that are refused though people write them so.
TEST(PlainText, NamesHaveNothingThatNobodySees) {
    for (const char* hidden :
         {"a\u00adb",     "a\u034fb",     "a\u061cb",    "a\u115fb", "a\u1160b",     "a\u17b4b",
          "a\u180eb",     "a\u200bb",     "a\u200db",    "a\u202eb", "a\u2066b",     "a\u3164b",
          "\ufeffa",      "a\uffa0b",     "a\ufff9b",    "a\ufffbb", "a\U0001bca0b", "a\U0001d173b",
          "a\U000e0001b", "a\U000e007fb", "a\U000e0fffb"}) {
        EXPECT_TRUE(hasInvisible(hidden)) << hidden;
        EXPECT_TRUE(hasInvisible(hidden, Variants::Kept)) << hidden;
    }
    for (const char* seen :
         {"", "disk", "Čapek", "测试对象", "テスト", "한국어", "🔥", "\xff\xc2", "a\u00a0b"})
        EXPECT_FALSE(hasInvisible(seen)) << seen;
    // A heart as an emoji, a Japanese family name in its own form, a Mongolian letter.
    for (const char* varied : {"❤\ufe0f", "邉\U000e0104", "\u1820\u180b"}) {
        EXPECT_TRUE(hasInvisible(varied)) << varied;
        EXPECT_FALSE(hasInvisible(varied, Variants::Kept)) << varied;
    }
    for (const char* stray : {"a\ufe0f", "\ufe0fa", "❤\ufe0f\ufe0f", "1\U000e0100"})
        EXPECT_TRUE(hasInvisible(stray, Variants::Kept)) << stray;
}

TEST(PlainText, OneLineHasNoControlCharactersAndNoSpaceAtItsEnds) {
    for (const char* line : {"", "a b", "Ä", "测试"})
        EXPECT_TRUE(isOneLine(line)) << line;
    for (const char* other : {" a", "a ", "a\nb", "a\tb", "a\x1b[31m", "a\x7f", "a\u0085"})
        EXPECT_FALSE(isOneLine(other)) << other;
}

TEST(PlainText, AFileNameKeepsLettersAndHidesTheRest) {
    EXPECT_EQ(plainFileName("left, the/../x"), "left__the____x");
    EXPECT_EQ(plainFileName("a-Z_9"), "a-Z_9");
}

TEST(Clock, RunsForwardOnly) {
    ManualClock clock;
    clock.advance(1.0);
    clock.advanceTo(3.0);
    EXPECT_EQ(clock.now_s(), 3.0);
    EXPECT_THROW(clock.advance(-0.1), std::logic_error);
    EXPECT_THROW(clock.advanceTo(2.0), std::logic_error);
}

// Catches a share that is told at each step, goes back, or passes the whole.
TEST(ShareCount, TellsEachHundredthOnceAndNoMoreThanAll) {
    test::ToldShares all;
    ShareCount count(all.told(), 1e5);
    for (int k = 0; k < 200'000; ++k) // twice as many as there should be
        count.add();
    all.expectAWhole(100);
    EXPECT_LE(all.shares().size(), 110U);
    EXPECT_NEAR(all.shares().front(), 0.01, 1e-9);

    test::ToldShares few;
    ShareCount three(few.told(), 3.0);
    for (int k = 0; k < 3; ++k)
        three.add();
    EXPECT_EQ(few.shares(), (std::vector<double>{1.0 / 3.0, 2.0 / 3.0, 1.0}));

    test::ToldShares none;
    ShareCount unknown(none.told(), 0.0); // how many there are is not known
    unknown.add();
    EXPECT_TRUE(none.shares().empty());
    ShareCount silent({}, 10.0);
    silent.add(20.0);
}

TEST(ShareCount, APartIsAPartOfTheWhole) {
    test::ToldShares whole;
    partOf(whole.told(), 0.5, 0.75)(0.5);
    tellShare(whole.told(), 1.0);
    EXPECT_EQ(whole.shares(), (std::vector<double>{0.625, 1.0}));
    EXPECT_FALSE(partOf({}, 0.0, 0.5));
    tellShare({}, 1.0);
}

} // namespace bask
