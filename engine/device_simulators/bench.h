#pragma once
// A complete simulated rig at the far end of byte links: robot, thermometer and heater with one thermal
// plant.

#include "engine/device_simulators/grbl_simulator.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/stream_simulator.h"
#include "engine/protocols/axis_map.h"
#include "engine/simulation/simulated_rig.h"
#include "engine/simulation/thermal_plant.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// The kinds of devices; ports and speeds belong to the server.
struct BenchDevices {
    std::vector<AxisSpec> axes; ///< axes of a Grbl controller
    /// A Modbus module with this profile; if empty, a device that prints its temperatures.
    std::optional<ModbusProfile> thermometer;
    int thermometerUnit = 1;
    std::vector<int> channels; ///< channel of each object
    /// A Modbus controller with this profile; if empty, a NAMUR hotplate.
    std::optional<ModbusProfile> heater;
    int heaterUnit = 2;
    double heating_s = 60.0, cooling_s = 600.0; ///< time constants of the plate
};

/// The plate radiates as long as it is hot: it has no shutter.
class Bench {
public:
    static constexpr double kStep_s = 0.05;

    /// Throws std::invalid_argument for impossible axes or profiles.
    Bench(const SimulatedRigConfig& rig, const BenchDevices& devices);

    ByteDevice& robot() { return m_robot; }
    ByteDevice& thermometer();
    ByteDevice& heater();

    /// Advances the plant to this time; call it after the devices have been advanced to it.
    void advance(double now_s);

    std::vector<double> temperatures_K() const;
    double plate_K() const;
    bool isHeating() const;
    GrblSimulator& grbl() { return m_robot; }
    Vector6d coordinates() const { return m_axes.coordinates(m_robot.positions()); }

private:
    void show(); ///< sets the temperatures of the thermometer

    SimulatedRigConfig m_config;
    BenchDevices m_devices;
    AxisMap m_axes;
    GrblSimulator m_robot;
    std::unique_ptr<ModbusSimulator> m_module, m_controller;
    std::unique_ptr<StreamSimulator> m_stream;
    std::unique_ptr<NamurSimulator> m_plate;
    SimulatedSourceFace m_source;
    MountedObjects m_objects;
    ThermalPlant m_plant;
    std::optional<double> m_now_s;
};

} // namespace bask
