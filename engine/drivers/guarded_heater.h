#pragma once
// A heat source that heats only while its guard process runs.

#include "engine/devices/heat_source.h"
#include "engine/drivers/heater_guard.h"

#include <functional>
#include <memory>

namespace bask {

class GuardedHeater final : public HeatSource {
public:
    /// `guard` and `clock` must outlive it. Starts a guard at once, with that program. `off` returns what
    /// switches the heater off in its present state.
    GuardedHeater(std::unique_ptr<HeatSource> heater, HeaterGuard& guard, std::string program,
                  std::function<guard::OffProgram()> off, const Clock& clock);

    /// Call after the guard's and the heater's own work(): tells the guard what it must know.
    void work();

    Result<Reading> read() override { return m_heater->read(); }
    /// Returns an Error if there is no guard; the heat is then off.
    Result<void> keepHeating(double setPoint_K, double validFor_s) override;
    Result<void> heatOff() override { return m_heater->heatOff(); }
    /// True if the heater says so, and until the guard has been told that it is off.
    bool heating() const override { return m_heater->heating() || m_isDoubted || m_guard.isArmed(); }
    std::optional<double> setPoint_K() const override { return m_heater->setPoint_K(); }
    HeatState heatState() const override;
    bool hasWatchdog() const override { return m_heater->hasWatchdog(); }
    Message cannotHeat() const override;
    Message guardProblem() const override;
    void renewGuard() override;
    /// A person may have switched it on: the guard watches it until the heater says that it is off.
    void doubt() { m_isDoubted = true; }

private:
    /// It must be off for this long: a set point is read back by then.
    static constexpr double kSeenOff_s = 1.0;

    std::unique_ptr<HeatSource> m_heater;
    HeaterGuard& m_guard;
    std::string m_program;
    std::function<guard::OffProgram()> m_off;
    const Clock& m_clock;
    double m_heated_s = 0.0; ///< when it was last on
    bool m_wasGuarded = false, m_isDoubted = false;
};

} // namespace bask
