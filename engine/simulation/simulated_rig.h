#pragma once
// The simulated rig: plant, robot, thermometers, heat source, its tracker and a camera with one manual clock.
// It is part of the released program.

#include "engine/base/time_table.h"
#include "engine/radiation/mounted_objects.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/simulation/simulated_robot.h"
#include "engine/simulation/simulated_sensors.h"
#include "engine/simulation/simulated_source_tracker.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "engine/simulation/thermal_plant.h"
#include "engine/thermal/source_emission.h"

#include <optional>
#include <vector>

namespace bask {

/// The true properties of one object.
struct SimulatedObject {
    Shape shape;
    Vector6d mounting = Vector6d::Zero(); ///< coordinates of O in E
    Material material;
};

struct SimulatedRigConfig {
    Shape source = Disk{0.10};
    SourceModel sourceModel = SourceModel::Gray;
    double sourceEmittance = 0.25;
    double sourceTemperature_K = 473.15;    ///< at the start
    Vector6d sourcePose = Vector6d::Zero(); ///< coordinates of X_RS
    TimeTable<Vector6d> sourceMotion;       ///< of X_RS since the heat came on; empty: it does not move
    double environment_K = 298.15;
    Air air{}; ///< true
    std::vector<SimulatedObject> objects;
    Screens screens{};
    SimulatedRobotConfig robot;
    SimulatedThermometerConfig thermometer;
    SimulatedTrackerConfig tracker;
    SimulatedCameraConfig camera;
    std::optional<SimulatedThermalCameraConfig> thermalCamera{};
    double viewFactorTolerance = 1e-8;
    /// What radiates of an uneven source, in S, and how; empty: the source is even.
    std::vector<SourceTerm> sourceTerms{};
    SourceEmission sourceEmission{};
};

/// What of a rig an edit of its experiment leaves as it is.
struct RigCondition {
    double time_s = 0.0; ///< of its clock
    /// of each object, K; NaN: at the temperature of the environment
    std::vector<double> objects_K;
    std::optional<double> source_K;      ///< of a source that was heated; empty: as at the start
    std::optional<Vector6d> coordinates; ///< of the robot; empty: its start
    /// constant error of each object's sensor, K; NaN or missing: as it is drawn
    std::vector<double> sensorOffsets_K{};
};

/// The source that the objects see; of an uneven one the outlines are shared, and the factors are those of
/// its temperature.
class SimulatedSourceFace {
public:
    explicit SimulatedSourceFace(const SimulatedRigConfig& config);

    /// Sets its temperature, K. Returns whether its view factors change with that.
    bool setTemperature(double source_K);
    const RadiatingSource& source() const { return m_source; }
    const SourceEmission& emission() const { return m_emission; }

private:
    SourceEmission m_emission;
    RadiatingSource m_source;
    double m_source_K;
};

/// Returns the objects on the end-effector, as they and the screens shade them, the source being at its start
/// pose.
MountedObjects mountedObjects(const SimulatedRigConfig& config);
/// Returns the plant of these objects, at the temperature of the environment.
ThermalPlant thermalPlant(const SimulatedRigConfig& config, const MountedObjects& objects);

/// Advances everything together. The source radiates only while its heat is on (its shutter is open then).
/// Its motion starts when the heat comes on, each time from the first pose; without heat it does not move.
class SimulatedRig {
public:
    explicit SimulatedRig(const SimulatedRigConfig& config);
    SimulatedRig(const SimulatedRig&) = delete; // not copyable: its devices refer to its clock
    SimulatedRig& operator=(const SimulatedRig&) = delete;

    const Clock& clock() const { return m_clock; }
    Robot& robot() { return m_robot; }
    Thermometer& thermometer() { return m_thermometer; }
    HeatSource& heatSource() { return m_source; }
    SourceTracker& sourceTracker() { return m_tracker; }
    Camera& camera() { return m_camera; }
    ThermalCamera* thermalCamera() { return simulatedThermalCamera(); } ///< null: none

    RigCondition condition() const;
    /// Goes on from there; for a new rig.
    void use(const RigCondition& condition);

    /// Advances the clock by dt_s in steps of at most kStep_s.
    void advance(double dt_s);
    std::vector<double> trueTemperatures_K() const;
    const Pose& X_RS() const { return m_X_RS; } ///< true pose of the source

    /// Lets something else warm the object, at kHot_K_s.
    void setHot(std::size_t object, bool hot) { m_isHot.at(object) = hot; }
    bool isHot(std::size_t object) const { return m_isHot.at(object); }
    double environment_K() const { return m_config.environment_K; }

    SimulatedRobot& simulatedRobot() { return m_robot; }
    SimulatedThermometer& simulatedThermometer() { return m_thermometer; }
    SimulatedHeatSource& simulatedHeatSource() { return m_source; }
    SimulatedSourceTracker& simulatedSourceTracker() { return m_tracker; }
    SimulatedCamera& simulatedCamera() { return m_camera; }
    SimulatedThermalCamera* simulatedThermalCamera() { return m_thermalCamera ? &*m_thermalCamera : nullptr; }

    static constexpr double kStep_s = 0.1;
    static constexpr double kHot_K_s = 2.0;

private:
    void step(double until_s);
    void moveSource(const Pose& X_RS);
    void seeSource();
    void showCameras();
    std::vector<double> bandRadiances(double source_K) const;
    ThermalMoment thermalMoment() const;

    SimulatedRigConfig m_config;
    ManualClock m_clock;
    MountedObjects m_objects;
    ThermalPlant m_plant;
    SimulatedRobot m_robot;
    SimulatedThermometer m_thermometer;
    SimulatedHeatSource m_source;
    SimulatedSourceTracker m_tracker;
    SimulatedCamera m_camera;
    std::optional<SimulatedThermalCamera> m_thermalCamera;
    SimulatedSourceFace m_face;
    Pose m_X_RS;
    bool m_heated = false; ///< whether it was heated in the last step
    double m_heatedSince_s = 0.0;
    std::vector<bool> m_isHot;
    std::vector<double> m_F; ///< at m_computedAt, the end-effector in S
    std::optional<Pose> m_computedAt;
    MountedObjects m_backs;         ///< of the objects; only with a thermal camera
    Eigen::MatrixXd m_betweenFaces; ///< view factors; empty: none sees another
};

} // namespace bask
