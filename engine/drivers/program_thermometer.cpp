#include "engine/drivers/program_thermometer.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"
#include "engine/drivers/picked_channels.h"
#include "engine/drivers/sensor_fault.h"

#include <algorithm>

namespace bask {
ProgramThermometer::ProgramThermometer(ByteLink& link, const Clock& clock, int channels)
    : m_talk(link, clock, ProgramRole::Thermometer), m_wanted(channels) {}

void ProgramThermometer::work() {
    const auto taken = [this](const ProgramLine& line, const ProgramRequest* asked) { take(line, asked); };
    if (m_talk.work(taken) == ProgramTalk::Turn::Opened)
        m_readings.clear();
}

void ProgramThermometer::take(const ProgramLine& line, const ProgramRequest* asked) {
    if (const auto* hello = std::get_if<ProgramHello>(&line.what); hello && hello->channels < m_wanted)
        m_talk.refuse("it has " + std::to_string(hello->channels) + " channels, and the rig uses " +
                      std::to_string(m_wanted));
    const auto* channels = std::get_if<std::vector<ProgramChannel>>(&line.what);
    if (channels == nullptr)
        return;
    if (static_cast<int>(channels->size()) != m_talk.hello()->channels)
        return m_talk.complain(std::to_string(channels->size()) + " temperatures instead of " +
                               std::to_string(m_talk.hello()->channels));
    const double at_s = m_talk.measuredAt_s(line, asked);
    m_readings.clear();
    for (const ProgramChannel& channel : *channels) {
        Reading reading{at_s, channel.temperature_K.value_or(0.0), channel.temperature_K.has_value(),
                        sensorFault(channel.fault)};
        reading.standardUncertainty_K = channel.standardUncertainty_K;
        m_readings.push_back(reading);
    }
}

Result<std::vector<Reading>> ProgramThermometer::read() {
    if (!m_talk.isLive() || m_readings.empty())
        return m_talk.error();
    return m_readings;
}

ThermometerDriver programThermometerDriver() {
    ThermometerDriver driver;
    driver.key = "program";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Program of your own");
    driver.link = DriverLink::Program;
    driver.make = [](DriverLinks& links, const ThermometerDeviceSpec& spec) -> MadeDevice<Thermometer> {
        const int channels = spec.channels.empty() ? 0 : 1 + *std::ranges::max_element(spec.channels);
        auto all = std::make_unique<ProgramThermometer>(links.program(ProgramRole::Thermometer),
                                                        links.clock(), channels);
        if (spec.channels.empty())
            return all;
        Device& device = *all;
        return {device, std::make_unique<PickedChannels>(std::move(all), spec.channels)};
    };
    return driver;
}

} // namespace bask
