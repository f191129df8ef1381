#include "engine/runtime/heat_orders.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kHeatPeriods = 3.0; ///< heat goes off by itself after this many periods

} // namespace

HeatOrders::HeatOrders(const Experiment& experiment, const RigDevices& devices, const RigReadings& readings)
    : m_experiment(experiment), m_devices(devices), m_readings(readings) {}

Result<void> HeatOrders::keep(double setPoint_K) {
    const double validFor_s = kHeatPeriods * m_experiment.sampling.period_s;
    if (auto kept = m_devices.source.keepHeating(setPoint_K, validFor_s); !kept)
        return kept;
    m_asked_K = setPoint_K;
    m_offProblem = {};
    return {};
}

void HeatOrders::off() {
    // If the link is dead, the heat expires in the device.
    m_offProblem = m_readings.sourceProblem(m_devices.source.heatOff());
    m_asked_K.reset();
}

void HeatOrders::keepOff() {
    if (m_offProblem.code != MessageCode::None || isOn())
        off();
}

bool HeatOrders::isSourceDark() const {
    constexpr double kDark_K = 10.0; // above room temperature
    const auto& source_K = m_readings.source_K();
    const bool isCool = source_K && *source_K < m_experiment.environment_K + kDark_K;
    return !m_asked_K && (!m_devices.isReal || isCool);
}

double HeatOrders::max_K() const {
    double max_K = m_experiment.source.temperature_K;
    for (const auto& point : m_experiment.source.temperatureProfile)
        max_K = std::max(max_K, point.value);
    return max_K;
}

Result<void> HeatOrders::setManual(double setPoint_K) {
    if (!(setPoint_K > m_experiment.environment_K && setPoint_K <= max_K()))
        return Error(MessageCode::ValueOutOfRange, {},
                     {formatNumber(celsiusFromKelvin(setPoint_K)),
                      formatNumber(celsiusFromKelvin(m_experiment.environment_K)),
                      formatNumber(celsiusFromKelvin(max_K())), "\u00b0C"});
    m_manual_K = setPoint_K;
    return {};
}

} // namespace bask
