#pragma once
// A thermometer that prints its temperatures by itself, as an Arduino with MAX31865 does.

#include "engine/devices/thermometer.h"
#include "engine/drivers/link_watch.h"
#include "engine/protocols/rtd_stream.h"

namespace bask {

struct ThermometerDriver;

/// Readings carry the last moment at which the line was seen empty before they came: never newer than they
/// are, however late the engine looks, or the link.
class StreamThermometer final : public Thermometer, public Device {
public:
    static constexpr double kSilence_s = 3.0; ///< a device that is reset by being opened takes two to begin
    static constexpr double kSettle_s = 0.05; ///< without another line: a temperature is certain

    /// `link` and `clock` must outlive it.
    StreamThermometer(ByteLink& link, const Clock& clock, int channels);

    void work() override;
    DeviceStatus status() const override { return m_watch.status(); }

    int channels() const override { return static_cast<int>(m_readings.size()); }
    /// A channel that has told nothing yet is invalid and infinitely old.
    Result<std::vector<Reading>> read() override;

    /// Lines that could not be read so far.
    int discards() const { return m_watch.discards(); }

private:
    void begin();

    ByteLink& m_link;
    const Clock& m_clock;
    LinkWatch m_watch;
    RtdStream m_stream;
    std::vector<Reading> m_readings;
    double m_lookedAt_s = 0.0, m_cameAt_s = 0.0;
};

/// Its entry in the catalogue of drivers.
ThermometerDriver streamThermometerDriver();

} // namespace bask
