#include "engine/drivers/stream_thermometer.h"

#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/picked_channels.h"

#include <algorithm>

namespace bask {
namespace {

constexpr Reading kNothing{-1e300, 0.0, false, SensorFault::Other};

SensorFault faultOf(RtdFault fault) {
    switch (fault) {
    case RtdFault::None:
        return SensorFault::None;
    case RtdFault::Open:
        return SensorFault::Open;
    case RtdFault::Short:
        return SensorFault::Short;
    case RtdFault::OutOfRange:
        return SensorFault::OutOfRange;
    case RtdFault::Other:
        break;
    }
    return SensorFault::Other;
}

} // namespace

StreamThermometer::StreamThermometer(ByteLink& link, const Clock& clock, int channels)
    : m_link(link), m_clock(clock), m_watch(link, clock, kSilence_s), m_stream(channels),
      m_readings(static_cast<std::size_t>(channels), kNothing) {}

void StreamThermometer::begin() {
    m_stream.clear();
    m_lookedAt_s = m_cameAt_s = m_clock.now_s();
}

void StreamThermometer::work() {
    switch (m_watch.work()) {
    case LinkWatch::Turn::Closed:
        return;
    case LinkWatch::Turn::Opened:
        begin();
        return;
    case LinkWatch::Turn::Open:
        break;
    }
    const double now_s = m_clock.now_s();
    if (const std::string bytes = m_link.read(); !bytes.empty()) {
        m_stream.add(bytes, std::min(m_lookedAt_s, m_link.emptyAt_s()));
        m_cameAt_s = now_s;
    } else if (now_s - m_cameAt_s >= kSettle_s) {
        m_stream.settle();
    }
    m_lookedAt_s = now_s;
    for (const std::string& line : m_stream.takeDiscarded())
        m_watch.discarded(line);
    for (const RtdValue& value : m_stream.take()) {
        const bool isValid = value.fault == RtdFault::None;
        m_readings[static_cast<std::size_t>(value.channel)] = {
            value.stamp, isValid ? kelvinFromCelsius(value.value_degC) : 0.0, isValid, faultOf(value.fault)};
        m_watch.answered();
    }
}

Result<std::vector<Reading>> StreamThermometer::read() {
    if (!m_watch.isLive())
        return m_watch.error();
    return m_readings;
}

ThermometerDriver streamThermometerDriver() {
    static constexpr int kTriedChannels = 16; // before it is known how many there are
    ThermometerDriver driver;
    driver.key = "stream";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Lines of text (MAX31865)");
    driver.serial = {115200, 8, 'N', 1};
    driver.make = [](DriverLinks& links, const ThermometerDeviceSpec& spec) -> MadeDevice<Thermometer> {
        const int channels =
            spec.channels.empty() ? kTriedChannels : 1 + *std::ranges::max_element(spec.channels);
        auto all = std::make_unique<StreamThermometer>(links.serial(), links.clock(), channels);
        if (spec.channels.empty())
            return all;
        Device& device = *all;
        return {device, std::make_unique<PickedChannels>(std::move(all), spec.channels)};
    };
    return driver;
}

} // namespace bask
