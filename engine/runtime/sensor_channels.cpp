#include "engine/runtime/sensor_channels.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kMinPlausible_K = 173.15; ///< -100 degC: an open or shorted sensor reads beyond these
constexpr double kMaxPlausible_K = 1273.15;
constexpr double kScatter_K = 2.0; ///< of readings, noise and steps together: a smaller change is not a jump
constexpr double kLag_s = 5.0;     ///< lag of sensors behind their objects
constexpr double kForgiven_s = 600.0; ///< a sensor that was trusted for this time counts as good again
constexpr int kMaxDoublings = 6;
constexpr double kAmbientSpread_K = 2.0;   ///< PT100 class B and noise
constexpr double kAmbientDistance_K = 5.0; ///< of the mean from the experiment's environment temperature

bool plausible(const Reading& reading) {
    return reading.valid && std::isfinite(reading.value_K) && reading.value_K > kMinPlausible_K &&
           reading.value_K < kMaxPlausible_K;
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

const HeatBounds* SensorChannels::bounds(std::size_t i) const {
    return i < m_limits.bounds.size() ? &m_limits.bounds[i] : nullptr;
}

void SensorChannels::advance(double dt_s, const std::vector<double>& powers_K_s) {
    for (std::size_t i = 0; i < m_limits.bounds.size(); ++i) {
        double& max_K_s = m_channels[i].power_K_s;
        max_K_s = std::max(powers_K_s.at(i), max_K_s * std::exp(-dt_s / kLag_s));
        m_limits.bounds[i].advance(dt_s, powers_K_s[i], std::isnan(powers_K_s[i]) ? powers_K_s[i] : max_K_s);
    }
}

// A change as slow as by a hand or a draught is always possible; a change faster than the source can cause at
// its hottest is not. In between, and after a gap, which would allow any reading, the heat balance decides.
bool SensorChannels::isPossible(std::size_t i, const Reading& reading) const {
    const Channel& channel = m_channels[i];
    const HeatBounds* const within = bounds(i);
    const double since_s = reading.time_s - channel.window.back().time_s;
    const double change_K = std::abs(reading.value_K - channel.window.back().value_K) - kScatter_K;
    const bool isLate = since_s > m_limits.stalePeriods * m_sampling.period_s;
    if (within == nullptr || !(isLate || channel.isDistrusted)) {
        const double largest_K_s = largestRate_K_s(i);
        if (change_K > largest_K_s * since_s)
            return false;
        if (within == nullptr || change_K <= std::min(largest_K_s, SafetySpec::kMinRate_K_s) * since_s)
            return true;
    }
    const auto isWithin = [&](double value_K) { return within->contain(value_K, kScatter_K); };
    if (!isWithin(reading.value_K + channel.offset_K))
        return false;
    return !channel.isDistrusted || within->max_K() - within->min_K() <= kTold_K ||
           std::ranges::none_of(channel.jumped_K, isWithin);
}

// Compares with the last accepted reading.
bool SensorChannels::isJump(std::size_t i, const Reading& reading) {
    Channel& channel = m_channels[i];
    if (channel.window.empty())
        return false;
    const Reading& last = channel.window.back();
    const bool isNew = reading.time_s > (channel.jump.inARow > 0 ? channel.jump.time_s : last.time_s);
    if (!isNew)
        return channel.jump.inARow > 0;
    const bool isFine = isPossible(i, reading);
    channel.agreed = isFine ? channel.agreed + 1 : 0;
    // A loose contact that comes and goes is accepted later each time.
    const int enough = m_limits.jumps << std::clamp(channel.losses - 1, 0, kMaxDoublings);
    if (isFine && (!channel.isDistrusted || channel.agreed >= enough)) {
        if (channel.isDistrusted)
            channel.lossEnds_s = reading.time_s;
        channel.jump = {};
        channel.jumped_K.clear();
        channel.isDistrusted = false;
        return false;
    }
    channel.jump.time_s = reading.time_s;
    if (isFine)
        return true;
    if (channel.jump.inARow == 0) {
        channel.jump.rate_K_s = std::abs(reading.value_K - last.value_K) / (reading.time_s - last.time_s);
        channel.jump.began_s = reading.time_s;
        channel.jump.from_K = last.value_K + channel.offset_K;
        channel.jump.to_K = reading.value_K + channel.offset_K;
    }
    channel.jumped_K.push_back(reading.value_K + channel.offset_K);
    if (channel.jumped_K.size() > static_cast<std::size_t>(m_limits.jumps))
        channel.jumped_K.erase(channel.jumped_K.begin());
    channel.jump.min_K = std::ranges::min(channel.jumped_K);
    ++channel.jump.inARow;
    if (bounds(i) != nullptr && channel.jump.inARow >= m_limits.jumps) {
        if (!channel.isKnown)
            return confirm(i, reading.time_s), false;
        if (!channel.isDistrusted)
            channel.losses = reading.time_s - channel.lossEnds_s > kForgiven_s ? 1 : channel.losses + 1;
        channel.isDistrusted = true;
    }
    return true;
}

void SensorChannels::accept(std::size_t i, const Reading& reading) {
    Channel& channel = m_channels[i];
    if (!channel.estimator.add(reading.time_s, reading.value_K + channel.offset_K))
        return;
    if (!channel.window.empty() &&
        reading.time_s - channel.window.back().time_s > m_limits.stalePeriods * m_sampling.period_s)
        channel.scatter.gap();
    channel.window.push_back(reading);
    channel.scatter.add(reading.value_K);
    if (channel.window.size() > static_cast<std::size_t>(m_sampling.window))
        channel.window.erase(channel.window.begin());
    channel.isKnown = channel.isKnown || channel.estimator.full();
    if (i < m_limits.bounds.size())
        m_limits.bounds[i].set(reading.value_K + channel.offset_K);
}

void SensorChannels::add(const std::vector<Reading>& readings) {
    if (readings.size() != m_channels.size())
        throw std::invalid_argument("SensorChannels: one reading a channel");
    for (std::size_t i = 0; i < readings.size(); ++i) {
        Channel& channel = m_channels[i];
        channel.lastFault = readings[i].fault;
        channel.lastReason = readings[i].valid ? Message{} : readings[i].reason;
        const bool isPlausible = plausible(readings[i]);
        if (isPlausible)
            channel.told = readings[i];
        channel.lastInvalid = !isPlausible || isJump(i, readings[i]);
        if (channel.lastInvalid)
            channel.scatter.gap();
        else
            accept(i, readings[i]);
    }
}

void SensorChannels::useDistrust(const SensorChannels& before) {
    for (std::size_t i = 0; i < std::min(size(), before.size()); ++i) {
        m_channels[i].isDoubted = before.m_channels[i].isDoubted;
        if (!before.m_channels[i].isDistrusted)
            continue;
        RateEstimator estimator = std::move(m_channels[i].estimator);
        m_channels[i] = before.m_channels[i];
        m_channels[i].estimator = std::move(estimator);
        for (const Reading& reading : m_channels[i].window)
            m_channels[i].estimator.add(reading.time_s, reading.value_K + m_channels[i].offset_K);
        if (bounds(i) != nullptr && before.bounds(i) != nullptr)
            m_limits.bounds[i] = *before.bounds(i);
    }
}

double SensorChannels::told_K(std::size_t i, double now_s) const {
    const Channel& channel = m_channels[i];
    const bool isNew =
        channel.told.valid && now_s - channel.told.time_s <= m_limits.stalePeriods * m_sampling.period_s;
    return isNew ? channel.told.value_K + channel.offset_K : std::numeric_limits<double>::quiet_NaN();
}

bool SensorChannels::confirm(std::size_t i, double now_s) {
    Channel& channel = m_channels[i];
    if (std::isnan(told_K(i, now_s)))
        return false;
    channel.window.clear();
    channel.estimator.reset();
    channel.scatter.gap();
    channel.jump = {};
    channel.jumped_K.clear();
    channel.losses = 0;
    channel.isDistrusted = channel.isDoubted = channel.lastInvalid = false;
    accept(i, channel.told);
    return true;
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

double SensorChannels::uncertainty_K(std::size_t i) const {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const Channel& channel = m_channels[i];
    if (!channel.window.empty() && channel.window.back().standardUncertainty_K > 0.0)
        return channel.window.back().standardUncertainty_K;
    if (!m_zeroing)
        return kUnknown;
    const auto sensor = contactUncertainty(m_zeroing->offsets_K, m_sampling.window, channel.scatter);
    return sensor ? sensor->ofReading_K() : kUnknown;
}

bool SensorChannels::full() const {
    return std::ranges::all_of(m_channels, [](const Channel& channel) { return channel.estimator.full(); });
}

int SensorChannels::minCount() const {
    int min = m_sampling.window;
    for (const Channel& channel : m_channels)
        min = std::min(min, channel.estimator.count());
    return min;
}

Message SensorChannels::filling() const {
    const double missing = std::max(0.0, static_cast<double>(m_sampling.window) - minCount());
    const double in_s = std::max(1.0, std::ceil(missing * m_sampling.period_s));
    return {MessageCode::ReasonEstimatorFilling, {formatNumber(in_s, 4)}};
}

Result<Zeroing> SensorChannels::findZero(double expectedEnvironment_K) const {
    if (!full())
        return Error(filling().code, {}, filling().args);
    double total = 0.0;
    for (const Channel& channel : m_channels)
        total += mean(channel.window);
    const double common = total / static_cast<double>(m_channels.size());
    if (std::abs(common - expectedEnvironment_K) > kAmbientDistance_K)
        return Error(MessageCode::ReasonNotAtAmbient, {}, {temperatureArg(expectedEnvironment_K)});
    double spread_K = 0.0;
    for (const Channel& channel : m_channels)
        for (const Reading& reading : channel.window)
            spread_K = std::max(spread_K, std::abs(reading.value_K - common));
    if (spread_K > kAmbientSpread_K)
        return Error(MessageCode::ReasonSensorsDisagree, {},
                     {differenceArg(spread_K, 2), differenceArg(kAmbientSpread_K, 2)});
    Zeroing found;
    found.environment_K = common;
    for (const Channel& channel : m_channels)
        found.offsets_K.push_back(common - mean(channel.window));
    return found;
}

void SensorChannels::useReadings(const SensorChannels& before,
                                 const std::vector<std::optional<std::size_t>>& from) {
    if (from.size() != size())
        throw std::invalid_argument("SensorChannels: readings of other sensors");
    m_zeroing = before.m_zeroing;
    for (std::size_t i = 0; i < size(); ++i)
        if (from[i])
            m_channels[i] = before.m_channels.at(*from[i]);
    if (m_zeroing) {
        m_zeroing->offsets_K.clear();
        for (const Channel& channel : m_channels)
            m_zeroing->offsets_K.push_back(channel.offset_K);
    }
}

void SensorChannels::useReadings(const SensorChannels& before) {
    std::vector<std::optional<std::size_t>> same(before.size());
    for (std::size_t i = 0; i < same.size(); ++i)
        same[i] = i;
    useReadings(before, same);
}

void SensorChannels::rest(std::size_t i, const std::vector<Reading>& readings) {
    Channel& channel = m_channels[i];
    for (const Reading& reading : readings)
        if (plausible(reading)) {
            channel.told = reading;
            accept(i, reading);
        }
    if (!m_zeroing || channel.window.empty())
        return;
    Zeroing zeroing = *m_zeroing;
    zeroing.offsets_K[i] = zeroing.environment_K - mean(channel.window);
    use(zeroing);
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
