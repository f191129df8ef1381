#include "engine/drivers/driver_catalogue.h"

#include "engine/drivers/dobot_robot.h"
#include "engine/drivers/grbl_robot.h"
#include "engine/drivers/hand_heater.h"
#include "engine/drivers/modbus_heater.h"
#include "engine/drivers/modbus_thermometer.h"
#include "engine/drivers/namur_heater.h"
#include "engine/drivers/program_heater.h"
#include "engine/drivers/program_robot.h"
#include "engine/drivers/program_thermometer.h"
#include "engine/drivers/stream_thermometer.h"

#include <algorithm>

namespace bask {
namespace {

template <class Driver> const Driver& driverIn(const std::vector<Driver>& drivers, const std::string& key) {
    const auto driver = std::ranges::find(drivers, key, &Driver::key);
    if (driver == drivers.end())
        throw std::invalid_argument("a driver that is not in the catalogue: " + key);
    return *driver;
}

template <class Driver> std::vector<const DriverFacts*> factsOf(const std::vector<Driver>& drivers) {
    std::vector<const DriverFacts*> out;
    out.reserve(drivers.size());
    for (const Driver& driver : drivers)
        out.push_back(&driver);
    return out;
}

} // namespace

const std::vector<RobotDriver>& robotDrivers() {
    static const std::vector<RobotDriver> kDrivers{grblDriver(), dobotDriver(), programRobotDriver()};
    return kDrivers;
}

const std::vector<ThermometerDriver>& thermometerDrivers() {
    static const std::vector<ThermometerDriver> kDrivers{
        modbusThermometerDriver(), modbusTcpThermometerDriver(), streamThermometerDriver(),
        programThermometerDriver()};
    return kDrivers;
}

const std::vector<HeatSourceDriver>& heatSourceDrivers() {
    static const std::vector<HeatSourceDriver> kDrivers{handHeaterDriver(), namurHeaterDriver(),
                                                        modbusHeaterDriver(), modbusTcpHeaterDriver(),
                                                        programHeaterDriver()};
    return kDrivers;
}

std::vector<const DriverFacts*> driversOf(DeviceRole role) {
    switch (role) {
    case DeviceRole::Robot:
        return factsOf(robotDrivers());
    case DeviceRole::Thermometer:
        return factsOf(thermometerDrivers());
    case DeviceRole::HeatSource:
        return factsOf(heatSourceDrivers());
    case DeviceRole::Camera:
    case DeviceRole::ThermalCamera:
        break;
    }
    return {};
}

const RobotDriver& driverOf(const RobotDeviceSpec& spec) {
    return driverIn(robotDrivers(), spec.driver);
}

const ThermometerDriver& driverOf(const ThermometerDeviceSpec& spec) {
    return driverIn(thermometerDrivers(), spec.driver);
}

const HeatSourceDriver& driverOf(const HeatSourceDeviceSpec& spec) {
    return driverIn(heatSourceDrivers(), spec.driver);
}

} // namespace bask
