#include "engine/protocols/rtd_stream.h"

#include <gtest/gtest.h>

#include <sstream>

namespace bask {
namespace {

const char* nameOf(RtdFault fault) {
    switch (fault) {
    case RtdFault::None:
        return "";
    case RtdFault::Open:
        return "open";
    case RtdFault::Short:
        return "short";
    case RtdFault::OutOfRange:
        return "range";
    case RtdFault::Other:
        break;
    }
    return "other";
}

/// "0:15.09 1:open", in the order in which they became certain.
std::string told(const std::vector<RtdValue>& values) {
    std::ostringstream text;
    for (const RtdValue& value : values) {
        text << (text.tellp() > 0 ? " " : "") << value.channel << ':';
        if (value.fault == RtdFault::None)
            text << value.value_degC;
        else
            text << nameOf(value.fault);
    }
    return text.str();
}

struct Read {
    std::string values;
    std::size_t discarded = 0;
};

/// A line that began before, then `bytes`, whole or in pieces of one; then a pause.
Read read(int channels, const std::string& bytes, bool inPieces = false) {
    RtdStream stream(channels);
    stream.add("half a line\n", 0.0);
    if (inPieces)
        for (const char c : bytes)
            stream.add(std::string(1, c), 0.0);
    else
        stream.add(bytes, 0.0);
    stream.settle();
    return {told(stream.take()), stream.takeDiscarded().size()};
}

const std::string kSketch = "RTD value: 8068\r\nRatio = 0.24621582\r\nResistance = 105.87280273\r\n"
                            "Temperature = 15.09\r\n\r\n";

struct Case {
    const char* what;
    int channels;
    std::string bytes;
    const char* values;
    std::size_t discarded;
};

// Catches each form misread, whole and byte by byte.
TEST(RtdStream, theFormsThatDevicesPrint) {
    const std::vector<Case> cases{
        {"the sketch", 1, kSketch + kSketch, "0:15.09 0:15.09", 0},
        {"several channels by name", 2, "T1 = 23.4\r\nT2 = -5.25\r\nT1 = 23.5\r\n", "0:23.4 1:-5.25 0:23.5",
         0},
        {"colon, unit, no blanks", 2, "T1:23.4 C\nt2=24.5\u00b0C\n", "0:23.4 1:24.5", 0},
        {"rows with commas", 3, "23.4,25.1,30.0\n23.5, 25.2, 30.1\n",
         "0:23.4 1:25.1 2:30 0:23.5 1:25.2 2:30.1", 0},
        {"rows with semicolons and blanks", 2, "1;2\n", "0:1 1:2", 0},
        {"rows with blanks only", 2, "23.4 \t 25.1\n", "0:23.4 1:25.1", 0},
        {"one number", 1, "23.4\n23.5 C\n", "0:23.4 0:23.5", 0},
        {"more channels than objects", 1, "T1 = 1\nT2 = 2\nT3 = 3\n", "0:1", 0},
        {"a row with more columns than objects", 1, "1,2,3\n", "0:1", 0},
        {"a banner in between", 1, "Temperature = 15.09\nAdafruit MAX31865 PT100 Sensor Test!\n", "0:15.09",
         0},
        {"no number", 2, "T1 = nan\nT2 = 24\n", "0:other 1:24", 0},
        {"no number in a row", 2, "nan,24\n", "0:other 1:24", 0},
        {"dead converter, code 0", 1, "Temperature = -246.86\n", "0:other", 0},
        {"dead converter, code 32767", 2, "988.79,20.0\n", "0:other 1:20", 0},
        {"beyond a PT100", 2, "T1 = -242.02\nT2 = 850.1\n", "0:range 1:range", 0},
    };
    for (const Case& each : cases)
        for (const bool inPieces : {false, true}) {
            const Read got = read(each.channels, each.bytes, inPieces);
            EXPECT_EQ(got.values, each.values) << each.what;
            EXPECT_EQ(got.discarded, each.discarded) << each.what;
        }
}

// Catches a temperature made of a damaged line.
TEST(RtdStream, whatIsDamagedIsDiscarded) {
    const std::vector<Case> cases{
        {"two lines run together", 1, "T1 = 23.T1 = 23.5\n", "", 1},
        {"a digit turned into something else", 1, "T1 = 2\x13.4\nT1 = 2x.4\nT1 = 23.4.5\n", "", 3},
        {"noise", 1, "\x81\xfe~8\x03.\xff\x10 2\n", "", 1},
        {"a noisy name", 1, "T\x91 = 23.4\n", "", 1},
        {"a hole in a row", 3, "23.4,,30.0\n", "", 1},
        {"a row cut short", 2, "23.4,25.1,30.0\n25.1,30.0\n23.4,25.1,30.0\n23.5,25.2,30.1\n",
         "0:23.4 1:25.1 0:23.5 1:25.2", 2},
        {"rows too short", 3, "1,2\n1,2\n", "", 2},
        {"rows run together", 2, "23.4,25.123.5,25.2\n", "", 1},
    };
    for (const Case& each : cases) {
        const Read got = read(each.channels, each.bytes);
        EXPECT_EQ(got.values, each.values) << each.what;
        EXPECT_EQ(got.discarded, each.discarded) << each.what;
    }
}

// Catches a temperature of a sensor at fault: the sketch prints one, and tells the fault after it, others
// before it.
TEST(RtdStream, aFaultSpoilsTheTemperatureBesideIt) {
    const std::vector<Case> cases{
        {"after it", 1, "Temperature = 988.00\nFault 0x80\nRTD High Threshold\n", "0:open", 0},
        {"before it", 1, "Fault 0x40\nRTD Low Threshold\nTemperature = 15.09\n", "0:short", 0},
        {"once more after the last, then over", 1, "T1 = 15\nFault 0x80\nT1 = 16\nT1 = 17\n",
         "0:open 0:open 0:17", 0},
        {"of all channels", 2, "T1 = 15\nT2 = 16\nFault 0x04\n", "0:other 1:other", 0},
        {"of one", 2, "T1 = 15\nT2 = 16\nT2 Fault 0x20\n", "0:15 1:open", 0},
        {"of one, before it", 2, "T2: Fault 0x10\nT1 = 15\nT2 = 16\n", "0:15 1:open", 0},
        {"with words", 1, "T1 = 15\nFault 0x08 (FORCE- open)\n", "0:open", 0},
        {"none", 1, "T1 = 15\nFault 0x00\n", "0:15", 0},
        {"unreadable", 1, "T1 = 15\nFault 0x\x93\n", "0:other", 1},
        {"damaged", 1, "T1 = 15\nFault \x91x40\n", "0:other", 1},
        {"without bits", 1, "T1 = 15\nFault!\n", "0:other", 0},
        {"told as none", 1, "T1 = 15\nNo Fault\n", "0:15", 0},
        {"several bits", 1, "T1 = 15\nFault 0xC4\n", "0:open", 0},
    };
    for (const Case& each : cases) {
        const Read got = read(each.channels, each.bytes);
        EXPECT_EQ(got.values, each.values) << each.what;
        EXPECT_EQ(got.discarded, each.discarded) << each.what;
    }
}

// Catches a temperature handed out before the fault that follows it can have come, and one that is held back
// for ever.
TEST(RtdStream, aTemperatureWaitsForWhatFollows) {
    RtdStream stream(1);
    stream.add("\nT1 = 1\nT1 = 20.5\n", 3.0); // the first is taken for half a line
    EXPECT_TRUE(stream.isWaiting());
    EXPECT_EQ(told(stream.take()), "");
    stream.settle();
    const auto values = stream.take();
    EXPECT_EQ(told(values), "0:20.5");
    EXPECT_EQ(values.at(0).stamp, 3.0) << "of its line, not of the pause";
    EXPECT_FALSE(stream.isWaiting());
    EXPECT_EQ(told(stream.take()), "") << "each once";
    stream.add("T1 = 21.5\n", 4.0);
    stream.add("T1 = 22.5\n", 5.0);
    const auto next = stream.take();
    EXPECT_EQ(told(next), "0:21.5");
    EXPECT_EQ(next.at(0).stamp, 4.0);
}

// Catches "123.4" read as "3.4" because the port was opened in the middle of it.
TEST(RtdStream, theFirstLineAfterOpeningIsNotUsed) {
    RtdStream stream(1);
    stream.add("3.4\n123.5\n", 0.0);
    stream.settle();
    EXPECT_EQ(told(stream.take()), "0:123.5");
    stream.add("12", 0.0);
    stream.clear();
    stream.add("3.6\n123.7\n", 0.0);
    stream.settle();
    EXPECT_EQ(told(stream.take()), "0:123.7");
    EXPECT_TRUE(stream.takeDiscarded().empty());
}

} // namespace
} // namespace bask
