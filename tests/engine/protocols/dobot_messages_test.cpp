#include "engine/protocols/dobot_messages.h"

#include "engine/base/message_code.h"
#include "engine/protocols/line_splitter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

// Catches replies read to another command, or with another result, than they are.
TEST(DobotMessages, RepliesAreRead) {
    EXPECT_EQ(*parseDobotReply("0,{5},RobotMode()"), (DobotReply{0, "5", "robotmode"}));
    EXPECT_EQ(*parseDobotReply("0,{},MovL(-500,100,200,150,SpeedL=5)"), (DobotReply{0, "", "movl"}));
    EXPECT_EQ(*parseDobotReply("\n-10000,{},Mov(1)"), (DobotReply{-10000, "", "mov"}));
    EXPECT_EQ(*parseDobotReply("\r\n0,{[\n\t[-2],\n\t[17]\n]\n},GetErrorID()"),
              (DobotReply{0, "[[-2],[17]]", "geterrorid"}));
    EXPECT_EQ(*parseDobotReply("0,{[[22,17],[],[3],[],[]]},GetErrorID()"),
              (DobotReply{0, "[[22,17],[],[3],[],[]]", "geterrorid"}));
    for (const char* damaged :
         {"", "0", "0,{}", "0,{},", "0,{},MovL", "0,{},MovL(", "x,{},MovL()", "0,},{MovL()", "{},MovL()",
          "0,{},(1)", "0,{},Mo-L(1)", "Control Mode Is Not Tcp"})
        EXPECT_FALSE(parseDobotReply(damaged)) << damaged;
}

// Catches two replies in one piece that are taken for one.
TEST(DobotMessages, RepliesEndWithASemicolon) {
    LineSplitter splitter(";");
    splitter.add("0,{},User(0);0,{},Tool(0);\n0,{5},Robot");
    EXPECT_EQ(splitter.next(), "0,{},User(0)");
    EXPECT_EQ(splitter.next(), "0,{},Tool(0)");
    EXPECT_FALSE(splitter.next());
    splitter.add("Mode();");
    EXPECT_EQ(splitter.next(), "\n0,{5},RobotMode()");
}

TEST(DobotMessages, ErrorsHaveNumbersAndWords) {
    EXPECT_EQ(dobotErrorIds("[[22,17],[],[3],[],[]]"), (std::vector<int>{22, 17, 3}));
    EXPECT_TRUE(dobotErrorIds("[[],[],[],[],[]]").empty());
    EXPECT_EQ(dobotErrorWords(-40001), "parameter out of range");
    EXPECT_EQ(dobotErrorWords(-77), "");
}

// Catches numbers without end or sense in a command that moves the arm.
TEST(DobotMessages, MovesAreBounded) {
    EXPECT_EQ(*dobotMove({1.0, -2.5, 1.0 / 3.0, -1e-9}, 5, 20),
              "MovL(1.000,-2.500,0.333,0.000,SpeedL=5,AccL=20)");
    for (const double far : {1e4, -1e300, std::nan(""), HUGE_VAL})
        EXPECT_EQ(dobotMove({0.0, far, 0.0, 0.0}, 5, 20).error().code(), MessageCode::ValueOutOfRange) << far;
}

// Catches offsets or byte order that are off; the values stand where the maker's table says.
TEST(DobotMessages, PacketsHaveTheMakersLayout) {
    const std::string packet = dobotPacket({DobotMode::Running, {1.0, 2.0, 3.0, 4.0}, 8, 9, 513});
    ASSERT_EQ(packet.size(), 1440U);
    EXPECT_EQ(packet.substr(0, 2), "\xA0\x05");
    EXPECT_EQ(packet[24], 7);
    EXPECT_EQ(packet.substr(32, 3), std::string("\1\2\0", 3));
    EXPECT_EQ(packet.substr(1011, 4), std::string("\0\10\11\0", 4));
    EXPECT_EQ(packet.substr(48, 8), "\xEF\xCD\xAB\x89\x67\x45\x23\x01");
    EXPECT_EQ(packet.substr(624, 8), std::string("\0\0\0\0\0\0\xF0\x3F", 8)); // 1.0
    EXPECT_EQ(packet.substr(648, 8), std::string("\0\0\0\0\0\0\x10\x40", 8)); // 4.0
}

// Catches packets lost in pieces, and a stream that stays out of step once a byte is missing.
TEST(DobotMessages, PacketsAreFoundAgain) {
    DobotFeedbackReader reader;
    const DobotFeedback one{DobotMode::Idle, {1.0, 2.0, 3.0, 4.0}},
        two{DobotMode::Error, {5.0, 6.0, 7.0, 8.0}, 1, 2, 100000};
    for (const char byte : dobotPacket(one)) {
        EXPECT_FALSE(reader.next());
        reader.add(std::string_view(&byte, 1));
    }
    EXPECT_EQ(reader.next(), one);
    reader.add(dobotPacket(one).substr(7) + dobotPacket(two) + dobotPacket(one));
    EXPECT_EQ(reader.next(), two);
    EXPECT_EQ(reader.next(), one);
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.discarded(), 1433U);
    reader.add(dobotPacket({DobotMode::Idle, {1.0, std::nan(""), 3.0, 4.0}}) + dobotPacket(two));
    EXPECT_EQ(reader.next(), two);
}

} // namespace
} // namespace bask
