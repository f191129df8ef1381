#include "engine/drivers/device_spec.h"

#include "engine/base/translated.h"

namespace bask {
namespace {

using namespace unit;
using enum Loosens;

constexpr Unit kBaud{"", "baud", "Bd"};
constexpr ParameterFacts kModbusUnit{"unit",
                                     kNone,
                                     {1.0, 247.0},
                                     Never,
                                     QT_TRANSLATE_NOOP("Parameter", "Unit"),
                                     QT_TRANSLATE_NOOP("Parameter", "The device's Modbus address"),
                                     0};

// clang-format off
constexpr Parameter<SerialSettings> kSerial[]{
    {{"baud", kBaud, {300.0, 4e6}, Never}, &SerialSettings::baud},
    {{"data_bits", kNone, {7.0, 8.0}, Never}, &SerialSettings::dataBits},
    {{"stop_bits", kNone, {1.0, 2.0}, Never}, &SerialSettings::stopBits},
};

constexpr Parameter<ThermometerDeviceSpec> kThermometer[]{
    {kModbusUnit, &ThermometerDeviceSpec::unit},
};

constexpr Parameter<HeatSourceDeviceSpec> kHeatSource[]{
    {kModbusUnit, &HeatSourceDeviceSpec::unit},
    {{"watchdog", kSeconds, {20.0, 1500.0}, Up, QT_TRANSLATE_NOOP("Parameter", "Watchdog"),
      QT_TRANSLATE_NOOP("Parameter", "The device switches its heat off when it has heard nothing for so long"), 0}, &HeatSourceDeviceSpec::watchdog_s},
};
// clang-format on

} // namespace

ParameterTable<SerialSettings> serialParameters() {
    return kSerial;
}
ParameterTable<ThermometerDeviceSpec> thermometerParameters() {
    return kThermometer;
}
ParameterTable<HeatSourceDeviceSpec> heatSourceParameters() {
    return kHeatSource;
}

} // namespace bask
