#pragma once
// A heat source that heats only while its guard process is there.

#include "engine/devices/heat_source.h"
#include "engine/drivers/heater_guard.h"

#include <functional>
#include <memory>

namespace bask {

class GuardedHeater final : public HeatSource {
public:
    /// `guard` and `clock` outlive it; a guard is started at once, by that program. `off` is what switches
    /// the heater off as it is now.
    GuardedHeater(std::unique_ptr<HeatSource> heater, HeaterGuard& guard, std::string program,
                  std::function<guard::OffProgram()> off, const Clock& clock);

    /// After the guard's and the heater's own work: what the guard is to know.
    void work();

    Result<Reading> read() override { return m_heater->read(); }
    /// An Error without a guard, and the heat is off then.
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    Result<void> heatOff() override { return m_heater->heatOff(); }
    /// As the heater says; and as long as the guard has not been told that it is off.
    bool heating() const override { return m_heater->heating() || m_guard.isArmed(); }
    std::optional<double> setPoint_K() const override { return m_heater->setPoint_K(); }
    HeatState heatState() const override;
    bool hasWatchdog() const override { return m_heater->hasWatchdog(); }
    Message cannotHeat() const override;
    Message guardProblem() const override;
    void renewGuard() override;

private:
    static constexpr double kSeenOff_s = 1.0; ///< so long it must be off: a set point is read back by then

    std::unique_ptr<HeatSource> m_heater;
    HeaterGuard& m_guard;
    std::string m_program;
    std::function<guard::OffProgram()> m_off;
    const Clock& m_clock;
    double m_heated_s = 0.0; ///< when it was on last
    bool m_wasGuarded = false;
};

} // namespace bask
