#pragma once
// The interface of all controllers: a step from an observation to a velocity within the robot's limits.

#include "engine/control/controller_settings.h"
#include "engine/control/rig_geometry.h"
#include "engine/thermal/heat_balance.h"

#include <memory>
#include <vector>

namespace bask {

/// Estimated temperature and rate of one object.
struct ObjectObservation {
    double temperature_K = 0.0;
    double rate_K_s = 0.0;
};

/// The inputs of a controller at one sample.
struct Observation {
    double time_s = 0.0;                     ///< since the run's start
    Vector6d coordinates = Vector6d::Zero(); ///< of the end-effector, measured
    /// Net source power now, divided by the power for which the estimated lambda1 is given.
    double sourceStrength = 1.0;
    std::vector<ObjectObservation> objects;
    /// The last commanded rates of the pose coordinates, from which the robot accelerates; zero at rest.
    Vector6d lastRates = Vector6d::Zero();
};

/// The command of a step and the controller's estimates.
struct ControlOutput {
    Vector6d rates = Vector6d::Zero();  ///< of the pose coordinates, m/s and rad/s
    double smallestSingularValue = 0.0; ///< of the interaction matrix dF/dx, rotation scaled, 1/m
    std::vector<double>
        /// The temperatures that it aims at if no pose has all targets together; else empty.
        compromise_K;
    std::vector<HeatRates> estimate; ///< N, the controller's present estimate
    ActiveLimits limits;             ///< limits that restrict the command
    /// It still looks for a pose to stand at; false for a law that has none.
    bool isOnTheWay = false;
};

/// What a controller is given before it starts.
struct ControlModel {
    std::shared_ptr<const RigGeometry> geometry;
    std::vector<HeatRates> estimated; ///< N, the estimated rates at sourceStrength 1
    std::vector<double> targets_K;
};

/// Each step is a deterministic function of the observations so far; time is part of them. Not thread-safe.
class Controller {
public:
    virtual ~Controller() = default;
    /// Returns the velocity for the next dt_s. Throws std::invalid_argument if the number of objects is
    /// wrong.
    virtual ControlOutput step(const Observation& observation, double dt_s) = 0;
    virtual void setTargets(const std::vector<double>& targets_K) = 0;
    /// Sets a new geometry of the same rig, after the source has moved, without a jump of the command.
    virtual void setGeometry(std::shared_ptr<const RigGeometry> geometry) = 0;
    /// Sets new gains of the same kind without a jump of the command; estimates are kept.
    virtual void setGains(const ControllerSettings& settings) = 0;
};

std::unique_ptr<Controller> makeController(const ControllerSettings& settings, ControlModel model);

} // namespace bask
