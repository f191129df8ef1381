#include "engine/runtime/warming_watch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kBins = 50;   ///< of the time looked back
constexpr int kStretch = 5; ///< bins of an earlier stretch
/// Times the losses by radiation: none, and what moving air can do.
constexpr std::array kLosses{0.0, 1.0, 3.0, 6.0};
constexpr double kNoiseShare = 0.05;
constexpr double kNoiseTimes = 8.0; ///< so many deviations more are asked for

} // namespace

WarmingWatch::WarmingWatch(double timeConstant_s, double least_K)
    : m_timeConstant_s(timeConstant_s), m_least_K(least_K),
      m_bin_s(std::min(kLongest_s, timeConstant_s) / kBins) {}

void WarmingWatch::reset() {
    m_bins.clear();
    m_unfollowed.reset();
    m_energy_K = 0.0;
    m_count = 0;
}

void WarmingWatch::restAt(double time_s, double temperature_K, double power_K_s) {
    reset();
    for (int i = -kStretch; i <= 0; ++i)
        m_bins.push_back({time_s + i * m_bin_s, temperature_K, i * m_bin_s * power_K_s, 1});
    m_binStart_s = m_time_s = time_s;
    m_temperature_K = temperature_K;
    m_power_K_s = power_K_s;
    m_same = {time_s, temperature_K, 0.0, 1};
    m_count = 1;
}

void WarmingWatch::add(double time_s, double temperature_K, double power_K_s) {
    if (m_count > 0)
        m_energy_K += 0.5 * (power_K_s + m_power_K_s) * (time_s - m_time_s);
    if (m_count > 1 && temperature_K != m_temperature_K) { // or long rests would make steps look small
        const double second_K = (temperature_K - 2.0 * m_temperature_K + m_before_K) / std::sqrt(6.0);
        m_noise_K =
            std::sqrt((1.0 - kNoiseShare) * m_noise_K * m_noise_K + kNoiseShare * second_K * second_K);
    }
    if (m_count == 0 || temperature_K != m_temperature_K)
        m_same = {time_s, temperature_K, m_energy_K, 1};
    m_before_K = m_temperature_K;
    m_temperature_K = temperature_K;
    m_power_K_s = power_K_s;
    m_time_s = time_s;
    ++m_count;
    if (m_bins.empty() || time_s >= m_binStart_s + m_bin_s) {
        m_unfollowed = worstSince(0, m_bins.size(), nullptr, m_least_K);
        m_bins.emplace_back();
        m_binStart_s = time_s;
        if (m_bins.size() > kBins)
            m_bins.erase(m_bins.begin());
    }
    Bin& bin = m_bins.back();
    const double share = 1.0 / ++bin.count;
    bin.time_s += share * (time_s - bin.time_s);
    bin.temperature_K += share * (temperature_K - bin.temperature_K);
    bin.energy_K += share * (m_energy_K - bin.energy_K);
}

double WarmingWatch::sameFor_s() const {
    return m_count > 0 ? m_time_s - m_same.time_s : 0.0;
}

std::optional<Unfollowed> WarmingWatch::worstSince(std::size_t first, std::size_t last, const Bin* start,
                                                   double least_K) const {
    std::optional<Unfollowed> worst;
    for (std::size_t end = std::max<std::size_t>(first, kStretch); end < last; ++end) {
        const auto found = unfollowedAfter(end, start ? *start : m_bins[end], least_K);
        if (found && (!worst || std::abs(found->expected_K) > std::abs(worst->expected_K)))
            worst = found;
    }
    return worst;
}

std::optional<Unfollowed> WarmingWatch::unfollowedWhileSame(double least_K) const {
    const auto begun =
        std::ranges::find_if(m_bins, [&](const Bin& bin) { return bin.time_s > m_same.time_s; });
    const auto after = static_cast<std::size_t>(begun - m_bins.begin()); // the stretch ends just before
    if (auto worst = worstSince(after < 2 ? 0 : after - 2, after, &m_same, least_K))
        return worst;
    return unmovedBy(after, least_K + kNoiseTimes * m_noise_K);
}

// Whatever it loses, it loses the same while it stays within `least_K`: the power of the two halves of that
// time may then differ by what the change could hide, and by what the losses may have changed with it.
std::optional<Unfollowed> WarmingWatch::unmovedBy(std::size_t first, double least_K) const {
    if (first + kStretch >= m_bins.size())
        return std::nullopt;
    const Bin& a = m_bins[first];
    const Bin& b = m_bins[(first + m_bins.size()) / 2];
    const double half_s = b.time_s - a.time_s, rest_s = m_time_s - b.time_s;
    const double change_K_s = (m_energy_K - b.energy_K) / rest_s - (b.energy_K - a.energy_K) / half_s;
    const double hidden_K_s = least_K * (1.0 / half_s + 1.0 / rest_s + kLosses.back() / m_timeConstant_s);
    if (std::abs(change_K_s) <= kBeliefFactor * hidden_K_s)
        return std::nullopt;
    return Unfollowed{change_K_s * rest_s / kBeliefFactor, 0.0, m_time_s - a.time_s};
}

std::optional<Unfollowed> WarmingWatch::unfollowedAfter(std::size_t end, const Bin& start,
                                                        double least_K) const {
    const Bin& a = m_bins[end - kStretch];
    const Bin& b = m_bins[end];
    const double length_s = b.time_s - a.time_s;
    double mean_K = 0.0;
    for (std::size_t i = end - kStretch; i <= end; ++i)
        mean_K += m_bins[i].temperature_K / (kStretch + 1);
    const double expected_K =
        leastExpected_K(end, start, (b.temperature_K - a.temperature_K) / length_s,
                        (b.energy_K - a.energy_K) / length_s, start.temperature_K - mean_K);
    const double gained_K = m_temperature_K - start.temperature_K;
    const bool follows = gained_K * expected_K >= kLeastShare * expected_K * expected_K;
    if (follows || std::abs(expected_K) < least_K + kNoiseTimes * m_noise_K)
        return std::nullopt;
    return Unfollowed{expected_K, gained_K, m_time_s - start.time_s};
}

double WarmingWatch::leastExpected_K(std::size_t end, const Bin& start, double rate_K_s, double power_K_s,
                                     double since_K) const {
    double least_K = std::numeric_limits<double>::infinity(), most_K = -least_K;
    for (const double loss : kLosses) {
        double going_K = 0.0, more_K = 0.0; // by the rate before, and per unit of the belief
        Bin from = start;
        const auto until = [&](double time_s, double energy_K) {
            const double dt_s = time_s - from.time_s;
            const double left = std::exp((0.5 * (from.time_s + time_s) - m_time_s) * loss / m_timeConstant_s);
            going_K += left * (rate_K_s - since_K * loss / m_timeConstant_s) * dt_s;
            more_K += left * (energy_K - from.energy_K - power_K_s * dt_s);
            from = {time_s, 0.0, energy_K, 0};
        };
        for (std::size_t i = end + 1; i < m_bins.size(); ++i)
            if (m_bins[i].time_s > from.time_s)
                until(m_bins[i].time_s, m_bins[i].energy_K);
        until(m_time_s, m_energy_K);
        for (const double belief : {kBeliefFactor, 1.0 / kBeliefFactor}) {
            least_K = std::min(least_K, going_K + belief * more_K);
            most_K = std::max(most_K, going_K + belief * more_K);
        }
    }
    return least_K > 0.0 ? least_K : most_K < 0.0 ? most_K : 0.0;
}

} // namespace bask
