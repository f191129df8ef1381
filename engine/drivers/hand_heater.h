#pragma once
// A heat source that a person heats: the temperature is typed, and the program cannot switch it.

#include "engine/base/clock.h"
#include "engine/devices/device.h"
#include "engine/devices/heat_source.h"

namespace bask {

struct HeatSourceDriver;

/// The reading has the time at which the temperature was typed, so that its age is known.
class HandHeater final : public HeatSource, public Device {
public:
    static constexpr double kLowest_K = 223.15, kHighest_K = 1773.15;

    explicit HandHeater(const Clock& clock) : m_clock(clock) {}

    void work() override {}
    DeviceStatus status() const override;

    Result<Reading> read() override;
    Result<void> keepHeating(double, double) override;
    /// Always succeeds; the caller checks isManual() and asks the person to switch it off.
    Result<void> heatOff() override { return {}; }
    /// True while its temperature is known.
    bool heating() const override { return m_typed.valid; }
    HeatState heatState() const override { return m_typed.valid ? HeatState::On : HeatState::Unknown; }
    bool isManual() const override { return true; }
    Result<void> setTemperature(double temperature_K) override;
    bool hasWatchdog() const override { return false; }

private:
    const Clock& m_clock;
    Reading m_typed;
};

/// Returns its entry in the driver catalogue.
HeatSourceDriver handHeaterDriver();

} // namespace bask
