// Modbus RTU frames against those printed in the Modbus specification and its tutorials.

#include "engine/protocols/modbus_frame.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

std::string bytes(std::initializer_list<int> values) {
    std::string out;
    for (const int value : values)
        out += static_cast<char>(value);
    return out;
}

const std::string kRead = bytes({0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87});
const std::string kWriteTwo =
    bytes({0x11, 0x10, 0x00, 0x01, 0x00, 0x02, 0x04, 0x00, 0x0A, 0x01, 0x02, 0xC6, 0xF0});

// Catches a wrong polynomial, start value or byte order of the CRC.
TEST(ModbusFrame, CrcIsTheSpecificationsLowByteFirst) {
    EXPECT_EQ(modbusFrame(1, bytes({0x03, 0x00, 0x00, 0x00, 0x0A})),
              bytes({0x01, 0x03, 0x00, 0x00, 0x00, 0x0A, 0xC5, 0xCD}));
    EXPECT_EQ(modbusException(0x0A, 1, 2), bytes({0x0A, 0x81, 0x02, 0xB0, 0x53}));
}

// Catches fields taken from the wrong bytes.
TEST(ModbusFrame, RequestsAreTakenApart) {
    std::string line = kRead + kWriteTwo + bytes({0x11, 0x06, 0x00, 0x01, 0x00, 0x03, 0x9A, 0x9B});
    const auto read = takeModbusQuery(line);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->unit, 0x11);
    EXPECT_EQ(read->function, 3);
    EXPECT_EQ(read->address, 0x6B);
    EXPECT_EQ(read->count, 3);
    const auto many = takeModbusQuery(line);
    ASSERT_TRUE(many);
    EXPECT_EQ(many->values, (std::vector<std::uint16_t>{0x000A, 0x0102}));
    const auto one = takeModbusQuery(line);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->address, 1);
    EXPECT_EQ(one->values, std::vector<std::uint16_t>{3});
    EXPECT_EQ(one->count, 1);
    EXPECT_TRUE(line.empty());
}

// Catches a reader that needs a request in one piece.
TEST(ModbusFrame, ARequestMayComeByteByByte) {
    std::string line;
    for (std::size_t i = 0; i < kWriteTwo.size(); ++i) {
        EXPECT_FALSE(takeModbusQuery(line)) << i;
        line += kWriteTwo[i];
    }
    EXPECT_TRUE(takeModbusQuery(line));
}

// Catches a reader that stays out of step for ever after noise, or answers a damaged request.
TEST(ModbusFrame, NoiseAndDamageAreSkipped) {
    std::string damaged = kRead;
    damaged[3] = 0x6C;
    std::string line = "\x07\xFF" + damaged + kRead;
    const auto query = takeModbusQuery(line);
    ASSERT_TRUE(query);
    EXPECT_EQ(query->address, 0x6B);
}

// Catches wrong lengths and echoes in replies.
TEST(ModbusFrame, RepliesAreTheSpecifications) {
    EXPECT_EQ(modbusReadReply(0x11, 3, {0xAE41, 0x5652, 0x4340}),
              bytes({0x11, 0x03, 0x06, 0xAE, 0x41, 0x56, 0x52, 0x43, 0x40, 0x49, 0xAD}));
    std::string many = kWriteTwo, one = bytes({0x11, 0x06, 0x00, 0x01, 0x00, 0x03, 0x9A, 0x9B});
    EXPECT_EQ(modbusWriteReply(*takeModbusQuery(many)),
              bytes({0x11, 0x10, 0x00, 0x01, 0x00, 0x02, 0x12, 0x98}));
    const std::string echo = one;
    EXPECT_EQ(modbusWriteReply(*takeModbusQuery(one)), echo);
}

// Catches a write whose counts contradict each other being carried out.
TEST(ModbusFrame, AContradictoryWriteIsNotKnown) {
    std::string line = modbusFrame(1, bytes({0x10, 0x00, 0x01, 0x00, 0x03, 0x04, 0x00, 0x0A, 0x01, 0x02}));
    const auto query = takeModbusQuery(line);
    ASSERT_TRUE(query);
    EXPECT_FALSE(query->isKnown);
}

// Catches a header with its fields at the wrong place, and a frame of which a part is taken for the whole.
TEST(ModbusTcpFrame, IsTheSpecifications) {
    const std::string frame = modbusTcpFrame(0x1234, bytes({0x11, 0x03, 0x00, 0x6B, 0x00, 0x03}));
    EXPECT_EQ(frame, bytes({0x12, 0x34, 0, 0, 0, 6, 0x11, 0x03, 0x00, 0x6B, 0x00, 0x03}));
    for (std::size_t i = 0; i < frame.size(); ++i) {
        std::string_view part = std::string_view(frame).substr(0, i);
        EXPECT_FALSE(takeModbusTcpFrame(part)) << i;
        EXPECT_FALSE(isModbusTcpBroken(part)) << i;
        EXPECT_EQ(part.size(), i);
    }
    const std::string two = frame + modbusTcpFrame(0xffff, bytes({1, 0x83, 2}));
    std::string_view left = two;
    EXPECT_EQ(takeModbusTcpFrame(left).value().unitAndPdu, frame.substr(6));
    EXPECT_EQ(takeModbusTcpFrame(left).value().transaction, 0xffff);
    EXPECT_TRUE(left.empty());
}

// Catches a reader that waits for as many bytes as noise says, or takes a frame without a function.
TEST(ModbusTcpFrame, WhatIsNoneIsTold) {
    for (const std::string& each :
         {bytes({0, 1, 0, 1}), bytes({0, 1, 0, 0, 0, 2, 1, 3}), bytes({0, 1, 0, 0, 0, 0}),
          bytes({0, 1, 0, 0, 0, 255}), bytes({0, 1, 0, 0, 1, 0}), std::string("HTTP/1.1 400")}) {
        std::string_view left = each;
        EXPECT_TRUE(isModbusTcpBroken(left));
        EXPECT_FALSE(takeModbusTcpFrame(left));
    }
}

} // namespace
} // namespace bask
