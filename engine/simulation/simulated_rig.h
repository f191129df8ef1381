#pragma once
// The simulated rig: plant, robot, thermometers and heat source on one manual clock. Ships in the release.

#include "engine/radiation/view_factor.h"
#include "engine/simulation/simulated_robot.h"
#include "engine/simulation/simulated_sensors.h"
#include "engine/simulation/thermal_plant.h"

#include <vector>

namespace bask {

/// One object as it truly is.
struct SimulatedObject {
    Shape shape;
    Vector6d mounting = Vector6d::Zero(); ///< coordinates of O in E
    Material material;
};

struct SimulatedRigConfig {
    Shape source = Disk{0.10};
    SourceModel sourceModel = SourceModel::Gray;
    double sourceEmittance = 0.25;
    double sourceTemperature_K = 473.15;
    double environment_K = 298.15;
    double convection_W_m2K = 0.0;
    std::vector<SimulatedObject> objects;
    SimulatedRobotConfig robot;
    SimulatedThermometerConfig thermometer;
};

/// Advances everything together. The source radiates only while its heat is on (its shutter is open then).
class SimulatedRig {
public:
    explicit SimulatedRig(const SimulatedRigConfig& config);
    SimulatedRig(const SimulatedRig&) = delete; // its devices refer to its clock
    SimulatedRig& operator=(const SimulatedRig&) = delete;

    const Clock& clock() const { return m_clock; }
    Robot& robot() { return m_robot; }
    Thermometer& thermometer() { return m_thermometer; }
    HeatSource& heatSource() { return m_source; }

    /// Advances the clock by dt_s in steps of at most kStep_s.
    void advance(double dt_s);
    std::vector<double> trueTemperatures_K() const;

    SimulatedRobot& simulatedRobot() { return m_robot; }
    SimulatedThermometer& simulatedThermometer() { return m_thermometer; }
    SimulatedHeatSource& simulatedHeatSource() { return m_source; }

    static constexpr double kStep_s = 0.1;

private:
    void step(double until_s);

    SimulatedRigConfig m_config;
    ManualClock m_clock;
    std::vector<RadiatingContour> m_contours;
    std::vector<Pose> m_X_EO;
    ThermalPlant m_plant;
    SimulatedRobot m_robot;
    SimulatedThermometer m_thermometer;
    SimulatedHeatSource m_source;
    RadiatingContour m_sourceContour;
    std::vector<double> m_F; ///< at m_computedAt
    Vector6d m_computedAt;
};

} // namespace bask
