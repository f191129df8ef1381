#include "engine/protocols/namur_lines.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches another line end or number format than the manual's: the plate says nothing to what it cannot
// read.
TEST(NamurLines, commandsAreAsInTheManual) {
    EXPECT_EQ(namurLine(namur::kPlate), "IN_PV_2 \r\n");
    EXPECT_EQ(namurLine(namurSetPoint(80.0)), "OUT_SP_1 80.0 \r\n");
    EXPECT_EQ(namurLine(namurSetPoint(60.04)), "OUT_SP_1 60.0 \r\n");
    EXPECT_EQ(namurLine(namurWatchdog(30.0)), "OUT_WD1@30 \r\n");
}

// Catches a value taken from a line that is damaged, of no channel, or no value at all.
TEST(NamurLines, aValueIsANumberAndAChannel) {
    const auto value = namurValue("80.5 2 ");
    ASSERT_TRUE(value);
    EXPECT_EQ(value->value, 80.5);
    EXPECT_EQ(value->channel, 2);
    EXPECT_EQ(namurValue("-3.2 1")->value, -3.2);
    EXPECT_EQ(namurValue("25   2")->channel, 2);
    for (const char* line : {"", "80.5", "80.5 ", "80.5 12", "80.5 x", "80.5 2 80.5 2", "8\x03.5 2",
                             "IN_PV_4", "nan 2", "80,5 2", "ok", " 2"})
        EXPECT_FALSE(namurValue(line)) << line;
}

// Catches a watchdog taken for running on any answer.
TEST(NamurLines, theWatchdogsEchoIsItsTime) {
    for (const char* line : {"30", "30.0 ", "30.0 1", "OUT_WD1@30", "30 s"})
        EXPECT_TRUE(isWatchdogEcho(line, 30.0)) << line;
    for (const char* line : {"20.0", "", "80.5 2", "ok", "OUT_WD1@20", "300"})
        EXPECT_FALSE(isWatchdogEcho(line, 30.0)) << line;
}

// Catches a plug that is bridged, or a late value, taken for a device with a strange name.
TEST(NamurLines, aNameIsNoEchoAndNoValue) {
    for (const char* line : {"IKARET", "RCT digital ", "C-MAG HS7"})
        EXPECT_TRUE(isNamurName(line)) << line;
    for (const char* line : {"IN_NAME", "IN_PV_4", "80.0 2", "", "IK\xC1RET", "START_1"})
        EXPECT_FALSE(isNamurName(line)) << line;
}

} // namespace
} // namespace bask
