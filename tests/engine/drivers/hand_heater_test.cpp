#include "engine/drivers/hand_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

// Catches a temperature that nobody has typed, one that looks newer than it is, and one that no source has.
TEST(HandHeater, isLiveOnceATemperatureIsTypedAndTellsItsAge) {
    ManualClock clock;
    HandHeater heater(clock);
    EXPECT_TRUE(heater.isManual());
    EXPECT_EQ(heater.status().link, LinkState::Opening);
    EXPECT_EQ(heater.status().problem.code, MessageCode::RigIncomplete);
    EXPECT_FALSE(heater.read().ok());
    EXPECT_FALSE(heater.keepHeating(400.0, 1.0).ok());
    EXPECT_FALSE(heater.heating());
    EXPECT_FALSE(heater.setTemperature(std::nan("")).ok());
    EXPECT_EQ(heater.setTemperature(10.0).error().code(), MessageCode::ValueOutOfRange);
    EXPECT_FALSE(heater.read().ok());

    clock.advance(5.0);
    ASSERT_TRUE(heater.setTemperature(kelvinFromCelsius(150.0)).ok());
    clock.advance(100.0);
    heater.work();
    EXPECT_EQ(heater.status().link, LinkState::Live);
    EXPECT_EQ(heater.status().lastReply_s, 5.0);
    const Reading reading = heater.read().value();
    EXPECT_TRUE(reading.valid);
    EXPECT_EQ(reading.time_s, 5.0);
    EXPECT_DOUBLE_EQ(reading.value_K, kelvinFromCelsius(150.0));
    EXPECT_TRUE(heater.keepHeating(400.0, 1.0).ok());
    EXPECT_TRUE(heater.heating());
    EXPECT_TRUE(heater.heatOff().ok());
    EXPECT_EQ(heater.setPoint_K(), std::nullopt);
}

} // namespace
} // namespace bask
