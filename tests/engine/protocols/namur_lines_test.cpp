#include "engine/protocols/namur_lines.h"

#include "engine/base/message.h"

#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <unistd.h>

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

// Catches a decimal comma: the plate says nothing to it, and keeps the set point before.
TEST(NamurLines, aComputersLanguageIsNotThePlates) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("bask_locale_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::string command = "localedef -i fr_FR -f UTF-8 " + (folder / "fr_FR.UTF-8").string();
    const bool isMade = std::system(command.c_str()) == 0;
    ::setenv("LOCPATH", folder.c_str(), 1);
    const std::string before = std::setlocale(LC_NUMERIC, nullptr);
    const bool isFrench = isMade && std::setlocale(LC_NUMERIC, "fr_FR.UTF-8") != nullptr;
    const std::string point = std::localeconv()->decimal_point;
    const std::string sent = namurSetPoint(80.5), number = formatNumber(80.5);
    std::setlocale(LC_NUMERIC, before.c_str());
    ::unsetenv("LOCPATH");
    std::filesystem::remove_all(folder);
    if (!isFrench)
        GTEST_SKIP() << "localedef cannot make a French locale here";
    EXPECT_EQ(point, ",");
    EXPECT_EQ(sent, "OUT_SP_1 80.5");
    EXPECT_EQ(number, "80.5");
}

// Catches numbers that look otherwise than printf's, as in records and tests until now, but for whole ones
// that it would write with an exponent.
TEST(NamurLines, numbersAreThoseOfPrintfInEnglish) {
    std::mt19937_64 random(14);
    std::uniform_real_distribution<double> magnitude(-12.0, 12.0), sign(-1.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double value = std::copysign(std::pow(10.0, magnitude(random)), sign(random));
        for (const int digits : {1, 2, 3, 4, 6, 7, 9, 10, 12}) {
            std::array<char, 40> text{};
            const bool isWhole = std::abs(value) < 1e5 && std::abs(value) >= std::pow(10.0, digits) - 0.5;
            std::snprintf(text.data(), text.size(), isWhole ? "%.*f" : "%.*g", isWhole ? 0 : digits, value);
            ASSERT_EQ(formatNumber(value, digits), text.data());
        }
    }
    for (const double value : {0.0, -0.0, 1.0, 100.0, 9999.0, 1e5, HUGE_VAL, -HUGE_VAL}) {
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.*g", 4, value);
        EXPECT_EQ(formatNumber(value), text.data());
    }
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
