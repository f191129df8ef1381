#pragma once
// The controller of a run: from what the rig tells to velocities, and what it has estimated and aims at.

#include "engine/control/controller.h"
#include "engine/runtime/rig_readings.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// Borrows its arguments for its life. One thread.
class RunControl {
public:
    RunControl(const Experiment& experiment, const RigReadings& readings, const Clock& clock);

    /// Makes the experiment's controller; its run begins now.
    void begin();
    void end() { m_controller.reset(); }
    /// When the newest run began, on the clock.
    double began_s() const { return m_began_s; }

    /// Returns what the robot is to do; empty while an object's temperature, or the source's, is not known.
    /// `lastRates`: those commanded last.
    std::optional<ControlOutput> step(const Vector6d& lastRates);
    /// The experiment has other targets.
    void useTargets();
    /// The experiment has other gains, or another kind of controller, which takes over what was estimated.
    void useSettings(bool isSameKind);

    /// How long all objects have been within the band, s.
    double withinBand_s() const { return m_clock.now_s() - m_withinBandSince_s; }
    /// Begins to count anew.
    void countBandAnew() { m_withinBandSince_s = m_clock.now_s(); }

    /// Of the controller, after its last step, for each object; NaN before the first run.
    const std::vector<HeatRates>& estimates() const { return m_estimates; }
    /// Predicted errors of the compromise aimed at, for each object; empty: none.
    const std::vector<ObjectKelvin>& compromise() const { return m_compromise; }
    /// True once for the targets of a run: what it answers is to be told.
    bool isCompromiseNew();

private:
    void makeController();
    std::vector<double> targets_K() const;
    void noteCompromise(const ControlOutput& output);
    void forgetCompromise();

    const Experiment& m_experiment;
    const RigReadings& m_readings;
    const Clock& m_clock;
    std::shared_ptr<const RigGeometry> m_geometry; ///< as the controller has it
    std::unique_ptr<Controller> m_controller;
    double m_began_s = 0.0;
    double m_withinBandSince_s = 0.0;
    std::vector<HeatRates> m_estimates;
    std::vector<ObjectKelvin> m_compromise;
    bool m_isCompromiseTold = false;
};

} // namespace bask
