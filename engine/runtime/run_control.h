#pragma once
// The controller of a run: computes velocities from the rig's readings, and keeps its estimates and its aim.

#include "engine/control/controller.h"
#include "engine/runtime/rig_readings.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// Borrows its arguments for its lifetime. One thread.
class RunControl {
public:
    RunControl(const Experiment& experiment, const RigReadings& readings, const Clock& clock);

    /// Creates the experiment's controller; the run begins now.
    void begin();
    void end() { m_controller.reset(); }
    /// Time on the clock when the newest run began.
    double began_s() const { return m_began_s; }

    /// Returns the command for the robot; empty if an object's temperature, or the source's, is not known.
    /// `lastRates` are the last commanded rates.
    std::optional<ControlOutput> step(const Vector6d& lastRates);
    /// Call when the experiment's targets have changed.
    void useTargets();
    /// Call when the experiment's gains have changed, or its kind of controller; a new controller takes over
    /// the estimates.
    void useSettings(bool isSameKind);

    /// How long all objects have been within the band, s.
    double withinBand_s() const { return m_clock.now_s() - m_withinBandSince_s; }
    /// Starts this time again.
    void countBandAnew() { m_withinBandSince_s = m_clock.now_s(); }

    /// Whether the controller still looks for a pose to stand at, after its last step.
    bool isOnTheWay() const { return m_isOnTheWay; }

    /// The controller's estimates after its last step, for each object; NaN before the first run.
    const std::vector<HeatRates>& estimates() const { return m_estimates; }
    /// Predicted errors of the compromise that is the aim, for each object; code None if there is none.
    Message compromise() const;
    /// Returns true once for each set of targets that needs a compromise, so that it is reported once.
    bool isCompromiseNew();

private:
    void makeController();
    std::vector<double> targets_K() const;
    void noteCompromise(const ControlOutput& output);
    void forgetCompromise();

    const Experiment& m_experiment;
    const RigReadings& m_readings;
    const Clock& m_clock;
    std::shared_ptr<const RigGeometry> m_geometry; ///< the controller's geometry
    std::unique_ptr<Controller> m_controller;
    double m_began_s = 0.0;
    double m_withinBandSince_s = 0.0;
    bool m_isOnTheWay = false;
    std::vector<HeatRates> m_estimates;
    std::vector<ObjectKelvin> m_compromise;
    bool m_isCompromiseTold = false;
};

} // namespace bask
