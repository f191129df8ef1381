#pragma once
// A thermometer that is read by a program of the operator's, docs/program-driver.md.

#include "engine/devices/thermometer.h"
#include "engine/drivers/program_talk.h"

namespace bask {

struct ThermometerDriver;

class ProgramThermometer final : public Thermometer, public Device {
public:
    /// `link` and `clock` must outlive it. `channels`: 0 takes as many as the program has.
    ProgramThermometer(ByteLink& link, const Clock& clock, int channels);

    void work() override;
    DeviceStatus status() const override { return m_talk.status(); }
    void expect(const std::string& signature) override { m_talk.expect(signature); }

    int channels() const override { return static_cast<int>(m_readings.size()); }
    void setPeriod(double period_s) override { m_talk.setPeriod(period_s); }
    /// The time of a reading is that of the question, less the age that the program tells.
    Result<std::vector<Reading>> read() override;

private:
    void take(const ProgramLine& line, const ProgramRequest* asked);

    ProgramTalk m_talk;
    int m_wanted;
    std::vector<Reading> m_readings;
};

/// Returns its entry in the driver catalogue.
ThermometerDriver programThermometerDriver();

} // namespace bask
