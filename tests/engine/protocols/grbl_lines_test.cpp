#include "engine/protocols/grbl_lines.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

template <class T> T as(std::string_view line) {
    const GrblLine parsed = parseGrblLine(line);
    if (const T* found = std::get_if<T>(&parsed))
        return *found;
    ADD_FAILURE() << "\"" << line << "\" is of kind " << parsed.index();
    return {};
}

// Catches any of the lines of Grbl's interface document read as another.
TEST(GrblLines, EachKindIsTold) {
    as<GrblOk>("ok");
    as<GrblOk>("ok\r");
    as<GrblBlank>("");
    as<GrblBlank>(" \r");
    EXPECT_EQ(as<GrblError>("error:22").number, 22);
    EXPECT_EQ(as<GrblAlarm>("ALARM:1").number, 1);
    EXPECT_EQ(as<GrblReport>("[MSG:Reset to continue]").text, "MSG:Reset to continue");
    EXPECT_EQ(as<GrblReport>("[VER:1.1h.20190825:]").text, "VER:1.1h.20190825:");
    EXPECT_EQ(as<GrblOptions>("[OPT:VNM,100,1024,4,0]"), (GrblOptions{"VNM", 100, 1024}));
    EXPECT_EQ(as<GrblSetting>("$130=400.000"), (GrblSetting{130, "400.000"}));
    EXPECT_EQ(as<GrblBanner>("Grbl 1.1h ['$' for help]").identity, "Grbl 1.1h");
    EXPECT_EQ(as<GrblBanner>("GrblHAL 1.1f ['$' or '$HELP' for help]").identity, "GrblHAL 1.1f");
}

// Catches fields that are lost, or read into another's place.
TEST(GrblLines, StatusIsReadWhole) {
    const auto status = as<GrblStatus>("<Hold:0|MPos:1.500,-2.250,0.000,30.000|Bf:15,128|FS:0,0|Pn:XD|WCO:0."
                                       "5,0,0,-1|Ov:100,100,100|H:1,15>");
    EXPECT_EQ(status.state, GrblState::Hold);
    EXPECT_EQ(status.part, 0);
    EXPECT_EQ(status.word, "Hold:0");
    EXPECT_EQ(status.machine, (std::vector<double>{1.5, -2.25, 0.0, 30.0}));
    EXPECT_EQ(status.offset, (std::vector<double>{0.5, 0.0, 0.0, -1.0}));
    EXPECT_TRUE(status.work.empty());
    EXPECT_EQ(status.freeBlocks, 15);
    EXPECT_EQ(status.freeBytes, 128);
    EXPECT_EQ(status.isHomed, true);
    EXPECT_EQ(status.homedAxes, 15U);
    EXPECT_EQ(status.pins, "XD");
    const auto work = as<GrblStatus>("<Idle|WPos:1.0,2.0,3.0|A:SF>");
    EXPECT_EQ(work.work, (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_FALSE(work.part);
    for (const char* word :
         {"Idle", "Run", "Hold:1", "Jog", "Alarm:11", "Door:3", "Check", "Home", "Sleep", "Tool"})
        EXPECT_EQ(as<GrblStatus>("<" + std::string(word) + ">").word, word);
}

// Catches a damaged report whose remaining numbers are used as a place.
TEST(GrblLines, DamageAnywhereMakesGarbage) {
    for (const char* line : {"<Idle|MPos:1.000,2.0<Idle|MPos:1.000,2.000,3.000>",
                             "<Idle|MPos:1.000,2.000,3.0",
                             "Idle|MPos:1,2,3>",
                             "<Idle|MPos:1.000,,3.000>",
                             "<Idle|MPos:1.0.0,2.0,3.0>",
                             "<Idle|MPos:nan,0,0>",
                             "<Idle|MPos:inf,0,0>",
                             "<Idle|MPos:1e3,0,0>",
                             "<Idle|MPos:>",
                             "<Idle|MPos:1,2,3|MPos:1,2,3>",
                             "<Idle|:3>",
                             "<Idle|MPos>",
                             "<Idel|MPos:1,2,3>",
                             "<Hold:|MPos:1,2,3>",
                             "<Hold:0:1>",
                             "<Idle|Bf:15>",
                             "<Idle|H:x>",
                             "<Idle|H:1,2,3>",
                             "<>",
                             "<",
                             "okk",
                             "o",
                             "error:",
                             "error:x",
                             "error:-1",
                             "error:9x",
                             "ALARM:",
                             "$=3",
                             "$x=3",
                             "[OPT:V",
                             "start",
                             "Grbl",
                             "Grbl ",
                             "99999999999999"})
        EXPECT_TRUE(std::holds_alternative<GrblGarbage>(parseGrblLine(line))) << line;
    EXPECT_EQ(as<GrblGarbage>(std::string("\x01"
                                          "a\xff"))
                  .text,
              ".a.");
    EXPECT_EQ(as<GrblGarbage>(std::string(1000, 'x')).text.size(), 60U);
}

// Catches a restart that is overlooked because it began in the middle of a line.
TEST(GrblLines, ABannerIsSeenInTheMiddleOfALine) {
    EXPECT_EQ(as<GrblBanner>("<Idle|MPos:1.0Grbl 1.1f ['$' for help]").identity, "Grbl 1.1f");
    EXPECT_EQ(as<GrblBanner>("\xffokGrbl 1.1f ['$' for help]").identity, "Grbl 1.1f");
    as<GrblReport>("[MSG:Grbl 1.1 is not meant]");
}

// Catches numbers without words, and invented words for unknown ones.
TEST(GrblLines, AlarmsAndErrorsHaveWords) {
    EXPECT_EQ(grblAlarmWords(1), "hard limit");
    EXPECT_EQ(grblErrorWords(15), "jog beyond the travel");
    EXPECT_EQ(grblAlarmWords(99), "");
    EXPECT_EQ(grblErrorWords(999), "");
    EXPECT_TRUE(isPlaceKept(2));
    for (const int lost : {1, 3, 6, 8, 10, 11, 17, 99})
        EXPECT_FALSE(isPlaceKept(lost)) << lost;
}

// Catches a feed that forgets the turning axis: F counts degrees as millimetres.
TEST(GrblLines, JogTakesTheTimeThatIsWanted) {
    const auto line = grblJogLine({{'X', 1.0, 4.0}, {'A', 10.0, 14.0}}, 0.5);
    ASSERT_TRUE(line);
    EXPECT_EQ(*line, "$J=G21G90G53X4.000A14.000F600.0\n");
}

// Catches numbers with exponents, without end or without sense in a line that moves the robot.
TEST(GrblLines, JogNumbersAreBounded) {
    EXPECT_EQ(*grblJogLine({{'X', 0.0, -1e-9}}, 0.5), "$J=G21G90G53X0.000F0.1\n");
    EXPECT_EQ(*grblJogLine({{'X', -9000.0, 9000.0}}, 1e-6), "$J=G21G90G53X9000.000F99999.9\n");
    EXPECT_EQ(*grblJogLine({{'X', 0.0, 1.0 / 3.0}}, 1.0), "$J=G21G90G53X0.333F20.0\n");
    for (const double far : {1e4, -1e4, 1e300, std::nan(""), HUGE_VAL})
        EXPECT_EQ(grblJogLine({{'X', 0.0, far}}, 0.5).error().code(), MessageCode::ValueOutOfRange) << far;
    for (const double time : {0.0, -1.0, std::nan("")})
        EXPECT_FALSE(grblJogLine({{'X', 0.0, 1.0}}, time)) << time;
    const GrblTarget far{'X', 0.0, -9999.999};
    EXPECT_LT(grblJogLine({far, far, far, far}, 1e-3)->size(), 70U); // Grbl takes 79
}

// Catches a feed that is read from a report that has none, or from a damaged one.
TEST(GrblLines, TheFeedOfTheModesIsRead) {
    EXPECT_EQ(grblFeedIn("GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0"), 0.0);
    EXPECT_EQ(grblFeedIn("GC:G0 G54 G17 G21 G90 G94 G49 G98 G50 M5 M9 T0 F7.5 S0."), 7.5);
    EXPECT_EQ(grblFeedIn("GC:G0 G54 T0 F S0"), std::nullopt);
    EXPECT_EQ(grblFeedIn("GC:G0 G54 T0 F1#0 S0"), std::nullopt);
    EXPECT_EQ(grblFeedIn("GC:G0 G54 T0"), std::nullopt);
}

} // namespace
} // namespace bask
