#pragma once
// What every controller is: a pure step from an observation to a velocity within the robot's limits.

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

/// Everything a controller sees at one sample.
struct Observation {
    double time_s = 0.0;                     ///< since the run's start
    Vector6d coordinates = Vector6d::Zero(); ///< of the end-effector, measured
    double sourceStrength = 1.0; ///< net source power now over the one the believed lambda1 stand for
    std::vector<ObjectObservation> objects;
    /// Rates of the pose coordinates that the robot was told last, from which it accelerates; zero at rest.
    Vector6d lastRates = Vector6d::Zero();
};

/// What a step asks of the robot and what the controller thinks.
struct ControlOutput {
    Vector6d rates = Vector6d::Zero();  ///< of the pose coordinates, m/s and rad/s
    double smallestSingularValue = 0.0; ///< of the interaction matrix dF/dx, rotation scaled, 1/m
    std::vector<double>
        compromise_K; ///< the temperatures aimed at where the targets cannot be had together; else empty
    std::vector<HeatRates> belief; ///< N, as the controller believes them now
    ActiveLimits limits;           ///< that hold the command back
};

/// What a controller knows before it starts.
struct ControlModel {
    std::shared_ptr<const RigGeometry> geometry;
    std::vector<HeatRates> believed; ///< at sourceStrength 1
    std::vector<double> targets_K;
};

/// Steps are deterministic functions of the observations so far; time comes with them. Not thread-safe.
class Controller {
public:
    virtual ~Controller() = default;
    /// The velocity to hold for the next dt_s. Throws std::invalid_argument on a wrong number of objects.
    virtual ControlOutput step(const Observation& observation, double dt_s) = 0;
    virtual void setTargets(const std::vector<double>& targets_K) = 0;
    /// The source has moved: the same rig in another geometry, without a bump.
    virtual void setGeometry(std::shared_ptr<const RigGeometry> geometry) = 0;
    /// New gains of the same kind, without a bump: estimates are kept.
    virtual void setGains(const ControllerSettings& settings) = 0;
};

std::unique_ptr<Controller> makeController(const ControllerSettings& settings, ControlModel model);

} // namespace bask
