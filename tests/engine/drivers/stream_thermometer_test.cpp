#include "engine/drivers/stream_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/stream_simulator.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

class StreamThermometerTest : public testing::Test {
protected:
    void run(double time_s) {
        for (double t = 0.0; t < time_s - 1e-9; t += 0.01) {
            m_thermometer.work();
            m_clock.advance(0.01);
        }
    }
    /// Said now, and taken by the next call.
    void say(const std::string& bytes) { m_link.say(bytes); }

    ManualClock m_clock;
    test::ScriptedLink m_link{"/dev/ttyTEST"};
    StreamThermometer m_thermometer{m_link, m_clock, 2};
};

// Catches a reading before there is one, and a channel that another one's line makes look told.
TEST_F(StreamThermometerTest, givesWhatWasPrinted) {
    EXPECT_EQ(m_thermometer.channels(), 2);
    EXPECT_EQ(m_thermometer.status().link, LinkState::Closed);
    run(0.05);
    EXPECT_EQ(m_thermometer.status().link, LinkState::Opening);
    EXPECT_EQ(m_thermometer.read().error().code(), MessageCode::DeviceSilent);
    say("f\nT1 = 23.4\n");
    run(0.1);
    const auto readings = m_thermometer.read().value();
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_TRUE(readings[0].valid);
    EXPECT_DOUBLE_EQ(readings[0].value_K, kelvinFromCelsius(23.4));
    EXPECT_FALSE(readings[1].valid);
    EXPECT_LT(readings[1].time_s, -1e200);
    EXPECT_EQ(m_thermometer.status().link, LinkState::Live);
    EXPECT_EQ(m_link.takeSent(), "") << "it does not listen";
}

// Catches a temperature told newer than it is when the engine looks late, and older ones lost on the way.
TEST_F(StreamThermometerTest, noReadingIsNewerThanItsMeasurement) {
    run(1.0);
    const double looked_s = m_clock.now_s() - 0.01;
    say("x\nT1 = 20\nT1 = 21\n"); // some time in the next two seconds
    m_clock.advance(2.0);
    run(0.01);
    EXPECT_DOUBLE_EQ(m_thermometer.read().value()[0].time_s, looked_s);
    run(0.1);
    EXPECT_DOUBLE_EQ(m_thermometer.read().value()[0].time_s, looked_s);
    EXPECT_DOUBLE_EQ(m_thermometer.read().value()[0].value_K, kelvinFromCelsius(21.0));
}

// Catches lines that waited at a link that was held up itself, told as new.
TEST_F(StreamThermometerTest, aLineThatWaitedAtTheLinkIsOld) {
    run(1.0);
    const double waited_s = m_clock.now_s() - 0.7;
    m_link.setEmptyAt(waited_s);
    say("x\nT1 = 20\nT1 = 21\n");
    run(0.1);
    EXPECT_DOUBLE_EQ(m_thermometer.read().value()[0].time_s, waited_s);
}

// Catches a fault that comes a moment after the temperature too late to spoil it.
TEST_F(StreamThermometerTest, aTemperatureWaitsForItsFault) {
    run(0.1);
    say("x\nT1 = 20\nT2 = 21\n");
    run(0.1);
    say("T1 = 988.0\nT2 = 22\n");
    run(0.02);
    say("T1 Fau");
    run(0.02);
    say("lt 0x80\n");
    run(0.1);
    const auto readings = m_thermometer.read().value();
    EXPECT_FALSE(readings[0].valid);
    EXPECT_EQ(readings[0].fault, SensorFault::Open);
    EXPECT_EQ(readings[0].value_K, 0.0);
    EXPECT_DOUBLE_EQ(readings[1].value_K, kelvinFromCelsius(22.0));
}

// Catches a silent device taken for live, and noise taken for life.
TEST_F(StreamThermometerTest, silenceAndNoiseAreLost) {
    run(0.1);
    say("x\nT1 = 20\nT2 = 21\n");
    run(0.1);
    EXPECT_EQ(m_thermometer.status().problem, Message{});
    for (int i = 0; i < 40; ++i) {
        say("\x83T\xf1 =\x19 2\xb3.4\r\n");
        run(0.1);
    }
    EXPECT_EQ(m_thermometer.status().link, LinkState::Lost);
    EXPECT_EQ(m_thermometer.status().problem.code, MessageCode::DeviceAnswersWrong);
    EXPECT_EQ(m_thermometer.status().problem.args.at(1), "\".T. =. 2..4\"");
    EXPECT_GE(m_thermometer.status().discarded, 30);
    EXPECT_FALSE(m_thermometer.read().ok());
    run(10.0);
    EXPECT_EQ(m_thermometer.status().problem.code, MessageCode::DeviceSilent);
    say("T1 = 20\nT1 = 21\nT2 = 22\n");
    run(1.0);
    say("T1 = 20\nT1 = 21\nT2 = 22\n");
    run(0.1);
    EXPECT_EQ(m_thermometer.status().link, LinkState::Live);
    EXPECT_EQ(m_thermometer.status().problem, Message{});
}

// Catches a cable that is out and not told, and one that is not found again.
TEST_F(StreamThermometerTest, aPulledCableIsToldAndFoundAgain) {
    run(0.1);
    say("x\nT1 = 20\n");
    run(0.1);
    m_link.unplug();
    EXPECT_EQ(m_thermometer.status().link, LinkState::Lost);
    EXPECT_EQ(m_thermometer.read().error().code(), MessageCode::LinkLost);
    run(5.0);
    EXPECT_EQ(m_thermometer.read().error().code(), MessageCode::LinkNotOpened);
    m_link.plug();
    run(0.6);
    say("23\nT1 = 24\n");
    run(0.1);
    EXPECT_DOUBLE_EQ(m_thermometer.read().value()[0].value_K, kelvinFromCelsius(24.0));
    EXPECT_EQ(m_thermometer.discards(), 0);
}

/// Against the simulated device in each of its formats.
class StreamDeviceTest : public testing::TestWithParam<StreamFormat> {
protected:
    static constexpr int kMax = 3;
    int channels() const { return GetParam() == StreamFormat::Sketch ? 1 : kMax; }
    void run(double time_s) {
        for (double t = 0.0; t < time_s - 1e-9; t += 0.005) {
            m_thermometer.work();
            look();
            m_clock.advance(0.005);
        }
    }

    void look() {
        const auto readings = m_thermometer.read();
        if (!readings)
            return;
        for (const Reading& reading : *readings) {
            if (!reading.valid)
                continue;
            m_lowest_K = std::min(m_lowest_K, reading.value_K);
            m_highest_K = std::max(m_highest_K, reading.value_K);
        }
    }

    ManualClock m_clock;
    StreamSimulator m_device{{channels(), GetParam()}};
    test::DeviceLink m_link{m_device, m_clock};
    StreamThermometer m_thermometer{m_link, m_clock, channels()};
    double m_lowest_K = 1e9, m_highest_K = -1e9;
};

// Catches a fault that becomes a temperature, even for a moment, and one that is not told as what it is.
TEST_P(StreamDeviceTest, noFaultEverBecomesATemperature) {
    m_device.setTemperatures(std::vector<double>(static_cast<std::size_t>(channels()), 320.0));
    run(1.0);
    ASSERT_EQ(m_thermometer.status().link, LinkState::Live);
    EXPECT_NEAR(m_thermometer.status().rate_Hz, 10.0 * channels(), 2.0 * channels());
    const auto healthy = m_thermometer.read().value();
    for (const Reading& reading : healthy) {
        EXPECT_NEAR(reading.value_K, 320.0, 0.1);
        EXPECT_LT(m_clock.now_s() - reading.time_s, 0.25);
    }
    const bool tellsWhy = GetParam() != StreamFormat::Row;
    for (const std::string& fault : m_device.faults()) {
        ASSERT_TRUE(m_device.setFault(fault).ok());
        run(1.0);
        if (fault == "open" || fault == "short") {
            const auto readings = m_thermometer.read().value();
            EXPECT_FALSE(readings[0].valid) << fault;
            const SensorFault told = fault == "open" ? SensorFault::Open : SensorFault::Short;
            EXPECT_EQ(readings[0].fault == told, tellsWhy) << fault;
            for (std::size_t i = 1; i < readings.size(); ++i)
                EXPECT_TRUE(readings[i].valid) << fault << " of the first only";
        }
        if (fault == "garbage") {
            EXPECT_EQ(m_thermometer.status().problem.code, MessageCode::DeviceAnswersWrong);
        }
        if (fault == "frozen") {
            const double held_K = m_thermometer.read().value()[0].value_K;
            run(0.5);
            EXPECT_EQ(m_thermometer.read().value()[0].value_K, held_K);
        }
        if (fault == "silent") {
            run(3.0);
            EXPECT_EQ(m_thermometer.status().problem.code, MessageCode::DeviceSilent);
        }
        ASSERT_TRUE(m_device.setFault("none").ok());
        run(2.0);
        EXPECT_EQ(m_thermometer.status().link, LinkState::Live) << "after " << fault;
        EXPECT_TRUE(m_thermometer.read().value()[0].valid) << "after " << fault;
    }
    EXPECT_GT(m_lowest_K, 319.0);
    EXPECT_LT(m_highest_K, 321.0);
}

INSTANTIATE_TEST_SUITE_P(Formats, StreamDeviceTest,
                         testing::Values(StreamFormat::Sketch, StreamFormat::Named, StreamFormat::Row));

} // namespace
} // namespace bask
