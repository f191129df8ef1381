#include "engine/device_simulators/bench.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kTolerance = 1e-7; // of the view factors

/// As strong as the experiment's robot may be asked to be; its travel is wider than the workspace, which the
/// host keeps.
GrblSimulatorConfig grblConfig(const SimulatedRigConfig& rig, const AxisMap& axes) {
    GrblSimulatorConfig config;
    config.start = axes.positions(rig.robot.start);
    config.home = config.start;
    config.lower.assign(config.start.size(), -1000.0);
    config.upper.assign(config.start.size(), 1000.0);
    config.workOffset.assign(config.start.size(), 0.0);
    return config;
}

} // namespace

Bench::Bench(const SimulatedRigConfig& rig, const BenchDevices& devices)
    : m_config(rig), m_devices(devices), m_axes(devices.axes, rig.robot.start),
      m_robot(grblConfig(rig, m_axes)), m_source(rig), m_objects(mountedObjects(rig)),
      m_plant(thermalPlant(rig, m_objects)) {
    if (devices.thermometer) {
        m_module = std::make_unique<ModbusSimulator>();
        m_module->addThermometer(devices.thermometerUnit, *devices.thermometer, rig.environment_K);
    } else {
        StreamSimulatorConfig stream;
        stream.channels = 1 + (devices.channels.empty() ? 0 : *std::ranges::max_element(devices.channels));
        stream.noise_K = rig.thermometer.noise_K;
        m_stream = std::make_unique<StreamSimulator>(stream);
    }
    if (devices.heater) {
        m_controller = std::make_unique<ModbusSimulator>();
        m_controller->addController(devices.heaterUnit, *devices.heater,
                                    {rig.environment_K, devices.heating_s, devices.cooling_s});
    } else {
        m_plate = std::make_unique<NamurSimulator>(
            NamurSimulatorConfig{rig.environment_K, devices.heating_s, devices.cooling_s});
    }
    show();
}

ByteDevice& Bench::thermometer() {
    if (m_module)
        return *m_module;
    return *m_stream;
}

ByteDevice& Bench::heater() {
    if (m_controller)
        return *m_controller;
    return *m_plate;
}

double Bench::plate_K() const {
    return m_controller ? m_controller->plate_K(m_devices.heaterUnit) : m_plate->temperature_K();
}

bool Bench::isHeating() const {
    return m_controller ? m_controller->isOn(m_devices.heaterUnit) : m_plate->isOn();
}

std::vector<double> Bench::temperatures_K() const {
    std::vector<double> out;
    for (std::size_t i = 0; i < m_plant.size(); ++i)
        out.push_back(m_plant.temperature_K(i));
    return out;
}

void Bench::advance(double now_s) {
    const double from_s = m_now_s.value_or(now_s);
    if (now_s - from_s < kStep_s && m_now_s)
        return;
    m_now_s = now_s;
    const Pose X_SE = poseFromCoordinates(m_config.sourcePose).inverse() * poseFromCoordinates(coordinates());
    m_source.setTemperature(plate_K());
    std::vector<double> F;
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        F.push_back(m_objects.viewFactorValue(m_source.source(), i, X_SE, kTolerance));
    const double J = netSourcePower_W_m2(m_config.sourceModel, plate_K(), m_config.sourceEmittance,
                                         m_config.environment_K);
    m_plant.advance(now_s - from_s, F, std::max(0.0, J));
    show();
}

void Bench::show() {
    const std::vector<double> t_K = temperatures_K();
    if (m_module) {
        for (std::size_t i = 0; i < t_K.size(); ++i)
            m_module->setTemperature(m_devices.thermometerUnit, m_devices.channels.at(i), t_K[i]);
        return;
    }
    std::vector<double> printed(static_cast<std::size_t>(1 + *std::ranges::max_element(m_devices.channels)),
                                m_config.environment_K);
    for (std::size_t i = 0; i < t_K.size(); ++i)
        printed.at(static_cast<std::size_t>(m_devices.channels[i])) = t_K[i];
    m_stream->setTemperatures(printed);
}

} // namespace bask
