#pragma once
// A thermometer that prints its temperatures unasked, as an Arduino with MAX31865 does.

#include "engine/devices/thermometer.h"
#include "engine/drivers/link_watch.h"
#include "engine/protocols/rtd_stream.h"

namespace bask {

struct ThermometerDriver;

/// A reading has the last time at which the line was seen empty before it arrived: a reading is never older
/// than its time says, however late the engine or the link looks.
class StreamThermometer final : public Thermometer, public Device {
public:
    /// A device that is reset when it is opened needs two seconds to start.
    static constexpr double kSilence_s = 3.0;
    static constexpr double kSettle_s = 0.05; ///< without another line for this long a temperature is final

    /// `link` and `clock` must outlive it.
    StreamThermometer(ByteLink& link, const Clock& clock, int channels);

    void work() override;
    DeviceStatus status() const override { return m_watch.status(); }

    int channels() const override { return static_cast<int>(m_readings.size()); }
    /// A channel without any value so far is invalid and infinitely old.
    Result<std::vector<Reading>> read() override;

    /// Returns the number of lines so far that could not be read.
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

/// Returns its entry in the driver catalogue.
ThermometerDriver streamThermometerDriver();

} // namespace bask
