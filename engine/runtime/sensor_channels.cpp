#include "engine/runtime/sensor_channels.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kLeastPlausible_K = 173.15; ///< -100 degC: an open or shorted sensor reads beyond these
constexpr double kMostPlausible_K = 1273.15;
constexpr double kScatter_K = 2.0;         ///< of readings, noise and steps together: less is no jump
constexpr double kAmbientSpread_K = 2.0;   ///< PT100 class B and noise
constexpr double kAmbientDistance_K = 5.0; ///< of the mean from the experiment's environment

bool plausible(const Reading& reading) {
    return reading.valid && std::isfinite(reading.value_K) && reading.value_K > kLeastPlausible_K &&
           reading.value_K < kMostPlausible_K;
}

double mean(const std::vector<Reading>& window) {
    double sum = 0.0;
    for (const Reading& reading : window)
        sum += reading.value_K;
    return sum / static_cast<double>(window.size());
}

} // namespace

SensorChannels::SensorChannels(std::size_t channels, const SamplingSpec& sampling, SensorLimits limits)
    : m_sampling(sampling), m_limits(std::move(limits)) {
    for (std::size_t i = 0; i < channels; ++i)
        m_channels.push_back(Channel{RateEstimator(sampling.window, sampling.order)});
}

double SensorChannels::largestRate_K_s(std::size_t i) const {
    return i < m_limits.largestRates_K_s.size() ? m_limits.largestRates_K_s[i]
                                                : std::numeric_limits<double>::infinity();
}

// Judged from the last reading that was believed, whose age lets the next be farther from it: a sensor that
// was mended, or an object that was changed, is believed again after a while.
bool SensorChannels::isJump(std::size_t i, const Reading& reading) {
    Channel& channel = m_channels[i];
    if (channel.window.empty())
        return false;
    const Reading& last = channel.window.back();
    if (!(reading.time_s > last.time_s))
        return channel.jump.inARow > 0;
    const double change_K = std::abs(reading.value_K - last.value_K);
    const double since_s = reading.time_s - last.time_s;
    if (change_K <= kScatter_K + largestRate_K_s(i) * since_s) {
        channel.jump = {};
        return false;
    }
    const double value_K = reading.value_K + channel.offset_K;
    if (channel.jump.inARow == 0)
        channel.jump.rate_K_s = change_K / since_s;
    channel.jump.least_K = channel.jump.inARow == 0 ? value_K : std::min(channel.jump.least_K, value_K);
    if (channel.jump.inARow == 0 || reading.time_s > channel.jump.time_s) { // once each
        ++channel.jump.inARow;
        channel.jump.time_s = reading.time_s;
    }
    return true;
}

void SensorChannels::add(const std::vector<Reading>& readings) {
    if (readings.size() != m_channels.size())
        throw std::invalid_argument("SensorChannels: one reading a channel");
    for (std::size_t i = 0; i < readings.size(); ++i) {
        Channel& channel = m_channels[i];
        channel.lastFault = readings[i].fault;
        channel.lastInvalid = !plausible(readings[i]) || isJump(i, readings[i]);
        if (channel.lastInvalid ||
            !channel.estimator.add(readings[i].time_s, readings[i].value_K + channel.offset_K))
            continue;
        channel.window.push_back(readings[i]);
        if (channel.window.size() > static_cast<std::size_t>(m_sampling.window))
            channel.window.erase(channel.window.begin());
    }
}

double SensorChannels::age_s(std::size_t i, double now_s) const {
    const auto& window = m_channels[i].window;
    return window.empty() ? std::numeric_limits<double>::infinity() : now_s - window.back().time_s;
}

bool SensorChannels::fresh(std::size_t i, double now_s) const {
    return age_s(i, now_s) <= m_limits.stalePeriods * m_sampling.period_s;
}

double SensorChannels::measured_K(std::size_t i) const {
    const Channel& channel = m_channels[i];
    return channel.window.empty() ? std::numeric_limits<double>::quiet_NaN()
                                  : channel.window.back().value_K + channel.offset_K;
}

bool SensorChannels::full() const {
    return std::ranges::all_of(m_channels, [](const Channel& channel) { return channel.estimator.full(); });
}

int SensorChannels::leastCount() const {
    int least = m_sampling.window;
    for (const Channel& channel : m_channels)
        least = std::min(least, channel.estimator.count());
    return least;
}

Result<Zeroing> SensorChannels::findZero(double expectedEnvironment_K) const {
    if (!full())
        return Error(MessageCode::ReasonEstimatorFilling, {},
                     {std::to_string(leastCount()), std::to_string(m_sampling.window)});
    double total = 0.0;
    for (const Channel& channel : m_channels)
        total += mean(channel.window);
    const double common = total / static_cast<double>(m_channels.size());
    if (std::abs(common - expectedEnvironment_K) > kAmbientDistance_K)
        return Error(MessageCode::ReasonNotAtAmbient, {},
                     {formatNumber(celsiusFromKelvin(expectedEnvironment_K))});
    double spread_K = 0.0;
    for (const Channel& channel : m_channels)
        for (const Reading& reading : channel.window)
            spread_K = std::max(spread_K, std::abs(reading.value_K - common));
    if (spread_K > kAmbientSpread_K)
        return Error(MessageCode::ReasonSensorsDisagree, {},
                     {formatNumber(spread_K, 2), formatNumber(kAmbientSpread_K, 2)});
    Zeroing found;
    found.environment_K = common;
    for (const Channel& channel : m_channels)
        found.offsets_K.push_back(common - mean(channel.window));
    return found;
}

void SensorChannels::use(const Zeroing& zeroing) {
    if (zeroing.offsets_K.size() != m_channels.size())
        throw std::invalid_argument("SensorChannels: one offset a channel");
    for (std::size_t i = 0; i < m_channels.size(); ++i) {
        Channel& channel = m_channels[i];
        channel.offset_K = zeroing.offsets_K[i];
        channel.estimator.reset();
        for (const Reading& reading : channel.window)
            channel.estimator.add(reading.time_s, reading.value_K + channel.offset_K);
    }
    m_zeroing = zeroing;
}

} // namespace bask
