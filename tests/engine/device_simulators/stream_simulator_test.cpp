#include "engine/device_simulators/stream_simulator.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

StreamSimulatorConfig quiet(StreamFormat format, int channels) {
    StreamSimulatorConfig config;
    config.format = format;
    config.channels = channels;
    config.noise_K = 0.0;
    return config;
}

// Catches other words than the sketches print.
TEST(StreamSimulator, printsAsTheSketchesDo) {
    StreamSimulator sketch(quiet(StreamFormat::Sketch, 1));
    EXPECT_EQ(
        sketch.transmit(5.0),
        "RTD value: 8353\r\nRatio = 0.25494186\r\nResistance = 109.62500000\r\nTemperature = 25.00\r\n\r\n");
    ASSERT_TRUE(sketch.setFault("open").ok());
    const std::string open = sketch.transmit(5.1);
    EXPECT_NE(open.find("Temperature = 988.79\r\nFault 0x80\r\nRTD High Threshold\r\n"), std::string::npos);

    StreamSimulator named(quiet(StreamFormat::Named, 2));
    named.setTemperatures({300.15, 290.0});
    EXPECT_EQ(named.transmit(5.0), "T1 = 27.00\r\nT2 = 16.85\r\n");
    ASSERT_TRUE(named.setFault("short").ok());
    EXPECT_EQ(named.transmit(5.1), "T1 = -242.02\r\nT2 = 16.85\r\nT1 Fault 0x40\r\n");

    StreamSimulator row(quiet(StreamFormat::Row, 3));
    row.setTemperatures({300.15, 290.0, 273.15});
    EXPECT_EQ(row.transmit(5.0), "27.00,16.85,0.00\r\n");
    EXPECT_THROW(StreamSimulator(quiet(StreamFormat::Sketch, 2)), std::invalid_argument);
    EXPECT_THROW(StreamSimulator(quiet(StreamFormat::Row, 0)), std::invalid_argument);
}

// Catches a stream at another rate than it is set to, or one that catches up on an hour without a reader.
TEST(StreamSimulator, keepsItsRate) {
    StreamSimulator device(quiet(StreamFormat::Row, 1));
    std::string said;
    for (int i = 0; i <= 1000; ++i)
        said += device.transmit(5.0 + 0.01 * i);
    EXPECT_NEAR(static_cast<double>(std::ranges::count(said, '\n')), 101.0, 1.0);
    EXPECT_LE(std::ranges::count(device.transmit(3600.0), '\n'), 6);
}

// Catches faults that are not what their names say.
TEST(StreamSimulator, faultsAreWhatTheirNamesSay) {
    StreamSimulatorConfig config = quiet(StreamFormat::Row, 1);
    config.noise_K = 0.5;
    StreamSimulator device(config);
    double now_s = 0.0;
    const auto next = [&] { return device.transmit(now_s += 0.1); };
    const std::string first = next();
    EXPECT_NE(next(), first) << "noise";
    ASSERT_TRUE(device.setFault("frozen").ok());
    const std::string frozen = next();
    EXPECT_EQ(next(), frozen);
    ASSERT_TRUE(device.setFault("silent").ok());
    EXPECT_EQ(next(), "");
    ASSERT_TRUE(device.setFault("garbage").ok());
    EXPECT_EQ(next(), "\x83T\xf1 =\x19 2\xb3.4\r\n");
    ASSERT_TRUE(device.setFault("none").ok());
    EXPECT_NE(next(), next());
    EXPECT_EQ(device.setFault("melted").error().code(), MessageCode::ValueUnknown);
}

} // namespace
} // namespace bask
