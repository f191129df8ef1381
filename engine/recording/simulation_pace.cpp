#include "engine/recording/simulation_pace.h"

#include "engine/base/message_arg.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

QDateTime clockTime(const std::string& iso) {
    return QDateTime::fromString(QString::fromStdString(iso), Qt::ISODate);
}

} // namespace

std::optional<SimulationPace> simulationPace(const SessionRecord& facts, double last_s) {
    constexpr double kSecond_s = 1.0; // to which both ends are known
    const QDateTime begin = clockTime(facts.created), end = clockTime(facts.finished);
    if (!facts.simulated || !begin.isValid() || !end.isValid())
        return std::nullopt;
    const auto clock_s = static_cast<double>(begin.secsTo(end));
    if (clock_s < 0.0 || !(last_s > clock_s + 2.0 * kSecond_s))
        return std::nullopt;
    return SimulationPace{last_s, std::max(clock_s, kSecond_s)};
}

std::string paceText(const SimulationPace& pace) {
    const auto seconds = [](double time_s) {
        return formatNumber(std::round(10.0 * time_s) / 10.0, 8) + " s";
    };
    return seconds(pace.run_s) + " of the simulated rig in " + seconds(pace.clock_s) + " by the clock";
}

} // namespace bask
