#include "engine/protocols/plain_number.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

// Catches a number read out of a part of a text, or out of words that C takes for numbers.
TEST(PlainNumber, isTheWholeTextOrNothing) {
    EXPECT_EQ(plainNumber("-12.5"), -12.5);
    EXPECT_EQ(plainNumber("+3e2"), 300.0);
    EXPECT_EQ(plainNumber("7"), 7.0);
    for (const char* text : {"", " 1", "1 ", "1.2.3", "12,5", "nan", "inf", "-inf", "0x10", "+-1", "++1",
                             "1e999", "--1", ".", "-", "23.4C"})
        EXPECT_FALSE(plainNumber(text)) << text;
}

TEST(PlainNumber, blanksAreTrimmedAtTheEndsOnly) {
    EXPECT_EQ(withoutBlanks(" \t80.0 2 "), "80.0 2");
    EXPECT_EQ(withoutBlanks("  "), "");
    EXPECT_EQ(withoutBlanks(""), "");
}

} // namespace
} // namespace bask
