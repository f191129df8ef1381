#pragma once
// A heat source that a person keeps hot: the temperature is typed, and nothing can be switched from here.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/devices/heat_source.h"

namespace bask {

struct HeatSourceDriver;

/// The reading's time is that of the typing, so that its age is told.
class HandHeater final : public HeatSource, public Device {
public:
    static constexpr double kLowest_K = 223.15, kHighest_K = 1773.15;

    explicit HandHeater(const Clock& clock) : m_clock(clock) {}

    void work() override {}
    DeviceStatus status() const override;

    Result<Reading> read() override;
    Result<void> keepHeating(double, double) override;
    /// Done as far as it can be: the caller asks isByHand() and tells the person.
    Result<void> heatOff() override { return {}; }
    /// While its temperature is known.
    bool heating() const override { return m_typed.valid; }
    HeatState heatState() const override { return m_typed.valid ? HeatState::On : HeatState::Unknown; }
    bool isByHand() const override { return true; }
    Result<void> setTemperature(double temperature_K) override;
    bool hasWatchdog() const override { return false; }

private:
    const Clock& m_clock;
    Reading m_typed;
};

/// Its entry in the catalogue of drivers.
HeatSourceDriver handHeaterDriver();

} // namespace bask
