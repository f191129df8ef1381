#include "engine/drivers/hand_heater.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/base/units.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/driver_make.h"

namespace bask {
namespace {

Error notTyped() {
    return {MessageCode::RigIncomplete, {}, {"source temperature"}};
}

} // namespace

Result<void> HandHeater::setTemperature(double temperature_K) {
    if (!(temperature_K >= kLowest_K && temperature_K <= kHighest_K))
        return Error{MessageCode::ValueOutOfRange,
                     {},
                     {formatNumber(celsiusFromKelvin(temperature_K)),
                      formatNumber(celsiusFromKelvin(kLowest_K)), formatNumber(celsiusFromKelvin(kHighest_K)),
                      "degC"}};
    m_typed = {m_clock.now_s(), temperature_K, true};
    return {};
}

DeviceStatus HandHeater::status() const {
    DeviceStatus status;
    if (m_typed.valid) {
        status.link = LinkState::Live;
        status.lastReply_s = m_typed.time_s;
    } else {
        status.link = LinkState::Opening;
        status.problem = notTyped().message;
    }
    return status;
}

Result<Reading> HandHeater::read() {
    if (!m_typed.valid)
        return notTyped();
    return m_typed;
}

Result<void> HandHeater::keepHeating(double, double) {
    if (!m_typed.valid)
        return notTyped();
    return {};
}

HeatSourceDriver handHeaterDriver() {
    HeatSourceDriver driver;
    driver.key = "by_hand";
    driver.name = QT_TRANSLATE_NOOP("bask::Device", "Kept hot by a person");
    driver.link = DriverLink::None;
    driver.make = [](DriverLinks& links, const HeatSourceDeviceSpec&) -> MadeDevice<HeatSource> {
        return std::make_unique<HandHeater>(links.clock());
    };
    return driver;
}

} // namespace bask
