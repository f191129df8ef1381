#include "engine/runtime/warming_watch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr double kBin_s = 6.0;
constexpr double kMinBin_s = 2.0;
constexpr double kBinsOfLoss = 0.02; // length of a bin as a share of the longest time constant
constexpr std::array<std::size_t, 5> kSpans{2, 5, 10, 20, 40}; // lengths of learnt spans, bins
constexpr double kResting_s = 20.0;   // a value that stays the same for longer gives no information
constexpr double kStalled_s = 5.0;    // and what comes after it may catch up at once
constexpr double kStalledTimes = 2.5; // the usual time between two readings, if that is longer
constexpr double kUsualShare = 0.05;
constexpr double kNoiseShare = 0.05;
constexpr double kNoiseTimes = 8.0;     // the change must exceed this many deviations in addition
constexpr double kToleranceTimes = 5.0; // in deviations, for learnt changes: there are hundreds of them
constexpr double kTolerance_K = 0.1;    // in addition, for the steps of a sensor
constexpr double kUnsureTimes = 2.0;    // of a reading's own uncertainty
constexpr double kMaxLaw = 2.4; // free convection of bare metal, with ΔT to the power of 1.25 up to 50 K
// relative error of energy and losses while it learns, as pose and air change
constexpr double kWrongThen = 0.06;
constexpr double kWrongNow = 0.05; // and from learning to now
constexpr double kRoomUnknown_K = 5.0, kRoomZeroed_K = 0.2;
constexpr double kRoomDrift_K_s = 2.0 / 3600.0;
constexpr double kShortestRest_s = 30.0, kLongestRest_s = 60.0; // several lags of a sensor
constexpr double kRestChange_K = 0.15;
constexpr double kBetterShare = 0.8; // of what is known, to count anew

/// Returns the range of the change over all fits.
template <class SpanOf> HeatFit::Change ofAll(const std::vector<HeatFit>& fits, SpanOf spanOf) {
    HeatFit::Change change{1e300, -1e300};
    for (std::size_t fit = 0; fit < fits.size(); ++fit) {
        const HeatFit::Change byOne = fits[fit].expected(spanOf(fit));
        change = {std::min(change.min_K, byOne.min_K), std::max(change.max_K, byOne.max_K)};
    }
    return change;
}

/// Returns the smallest possible change, with its sign; 0 if the sign is not certain.
double smallest_K(const HeatFit::Change& change) {
    return change.min_K > 0.0 ? change.min_K : std::min(change.max_K, 0.0);
}

double fourth(double x) {
    return x * x * x * x;
}

} // namespace

WarmingWatch::WarmingWatch(LossRange losses, double environment_K, double min_K)
    : m_losses(losses), m_environment_K(environment_K), m_min_K(min_K),
      m_bin_s(std::clamp(kBinsOfLoss / losses.min_1_s, kMinBin_s, kBin_s)),
      m_anything(kFits, HeatFit(losses)), m_fits(m_anything) {}

void WarmingWatch::reset() {
    m_bins.clear();
    m_unfollowed.reset();
    m_foreignHeat.reset();
    m_riseFrom_s = 0.0;
    m_fits = m_anything;
    m_now = {};
    m_learnt = 0;
}

void WarmingWatch::restAt(double time_s, double temperature_K) {
    reset();
    m_environment_K = temperature_K;
    m_zeroed_s = time_s;
    m_isRest = false;
    m_restRate_K_s = 0.0;
}

double WarmingWatch::roomUnknown_K(double time_s) const {
    return m_zeroed_s ? std::min(kRoomUnknown_K, kRoomZeroed_K + kRoomDrift_K_s * (time_s - *m_zeroed_s))
                      : kRoomUnknown_K;
}

void WarmingWatch::noteRest() {
    if (m_bins.empty() || // or warmer or colder than any room: on its way
        std::abs(m_bins.back().temperature_K - m_environment_K) > roomUnknown_K(m_bins.back().time_s))
        return;
    const Mark& last = m_bins.back();
    // A power that lifts no object by more than the room is known by: one that is heated is at no rest,
    // wherever its sensor is.
    const double maxPower_K_s = kRoomZeroed_K * m_losses.min_1_s;
    // The rate by which the temperature may change unseen; it must become smaller by this.
    double rate_K_s = m_restRate_K_s + m_losses.max_1_s * (roomUnknown_K(last.time_s) - kRoomZeroed_K);
    double min_K = last.temperature_K, max_K = min_K;
    bool isRest = false;
    for (std::size_t i = m_bins.size() - 1; i-- > 0;) {
        const Mark& from = m_bins[i];
        min_K = std::min(min_K, from.temperature_K);
        max_K = std::max(max_K, from.temperature_K);
        const double time_s = last.time_s - from.time_s;
        const double power_K_s = (last.energy_K.front() - from.energy_K.front()) / time_s;
        if (max_K - min_K > kRestChange_K || std::abs(power_K_s) > maxPower_K_s || time_s > kLongestRest_s)
            break;
        const double unseen_K = std::max({max_K - min_K, kTolerance_K, kToleranceTimes * m_noise_K});
        if (time_s < kShortestRest_s || unseen_K / time_s > kBetterShare * rate_K_s)
            continue;
        rate_K_s = unseen_K / time_s;
        isRest = true;
    }
    if (!isRest)
        return;
    m_isRest = true;
    m_environment_K = last.temperature_K;
    m_zeroed_s = last.time_s;
    m_restRate_K_s = rate_K_s;
    m_bins.clear(); // they count from another balance
    m_learnt = 0;
}

void WarmingWatch::integrate(double dt_s, double power_K_s) {
    m_power.advance(dt_s, power_K_s, m_now.energy_K);
    m_now.linear_K_s += (m_now.temperature_K - m_environment_K) * dt_s;
    m_now.radiated_K_s +=
        (fourth(m_now.temperature_K) - fourth(m_environment_K)) / (4.0 * std::pow(m_environment_K, 3)) * dt_s;
}

void WarmingWatch::add(double time_s, std::optional<double> temperature_K, double power_K_s,
                       double uncertainty_K) {
    if (std::isnan(power_K_s)) // the object's position is not known
        return reset();
    const bool isFirst = m_now.count == 0;
    if (isFirst && !temperature_K)
        return;
    if (isFirst)
        m_power.begin(power_K_s);
    else
        integrate(time_s - m_now.time_s, power_K_s);
    m_now.time_s = time_s;
    if (!temperature_K)
        return;
    if (!isFirst) {
        const double since_s = time_s - m_read_s;
        m_usual_s += (m_usual_s > 0.0 ? kUsualShare : 1.0) * (since_s - m_usual_s);
    }
    m_read_s = time_s;
    const bool isSame = !isFirst && *temperature_K == m_now.temperature_K;
    if (m_now.count > 1 && !isSame) { // otherwise long constant values would make the noise look small
        const double second_K = (*temperature_K - 2.0 * m_now.temperature_K + m_before_K) / std::sqrt(6.0);
        m_noise_K =
            std::sqrt((1.0 - kNoiseShare) * m_noise_K * m_noise_K + kNoiseShare * second_K * second_K);
    }
    if (!isFirst && !isSame && time_s - m_same.time_s > std::max(kStalled_s, kStalledTimes * m_usual_s))
        m_riseFrom_s = time_s;
    m_before_K = m_now.temperature_K;
    m_now.temperature_K = *temperature_K;
    m_now.uncertainty_K = uncertainty_K;
    ++m_now.count;
    if (!isSame)
        m_same = m_now;
    if (m_bins.empty() || time_s >= m_binStart_s + m_bin_s) {
        judge();
        if (!m_bins.empty())
            judgeRise();
        m_bins.emplace_back();
        m_binStart_s = time_s;
    }
    Mark& bin = m_bins.back();
    const double share = 1.0 / ++bin.count;
    const auto approach = [&](double& mean, double value) { mean += share * (value - mean); };
    approach(bin.time_s, m_now.time_s);
    approach(bin.temperature_K, m_now.temperature_K);
    approach(bin.uncertainty_K, m_now.uncertainty_K);
    approach(bin.linear_K_s, m_now.linear_K_s);
    approach(bin.radiated_K_s, m_now.radiated_K_s);
    for (std::size_t k = 0; k < LaggedPower::kLags_s.size(); ++k)
        approach(bin.energy_K[k], m_now.energy_K[k]);
}

HeatSpan WarmingWatch::span(const Mark& from, const Mark& to, std::size_t fit, double wrong) const {
    const std::size_t lag = fit / kLaws, law = fit % kLaws;
    const double faster_K = to.energy_K[lag] - from.energy_K[lag];
    const double slower_K = to.energy_K[lag + 1] - from.energy_K[lag + 1];
    const double linear_K_s = to.linear_K_s - from.linear_K_s;
    const double radiated_K_s = to.radiated_K_s - from.radiated_K_s;
    const auto losses_K_s = [&](std::size_t of) {
        return linear_K_s + (radiated_K_s - linear_K_s) * kMaxLaw * static_cast<double>(of) / kLaws;
    };
    const double room_K_s = roomUnknown_K(to.time_s) * (to.time_s - from.time_s);
    HeatSpan span{std::min(faster_K, slower_K), std::max(faster_K, slower_K),
                  std::min(losses_K_s(law), losses_K_s(law + 1)),
                  std::max(losses_K_s(law), losses_K_s(law + 1))};
    span.minEnergy_K -= wrong * std::abs(span.minEnergy_K);
    span.maxEnergy_K += wrong * std::abs(span.maxEnergy_K);
    span.minLoss_K_s -= wrong * std::abs(span.minLoss_K_s) + room_K_s;
    span.maxLoss_K_s += wrong * std::abs(span.maxLoss_K_s) + room_K_s;
    span.unsure_K = m_restRate_K_s * (to.time_s - from.time_s);
    return span;
}

double WarmingWatch::unsure_K(const Mark& from, const Mark& to) {
    return kUnsureTimes * (from.uncertainty_K + to.uncertainty_K);
}

void WarmingWatch::learn(Fits& fits, std::size_t end) const {
    for (const std::size_t bins : kSpans) {
        if (bins > end)
            continue;
        const Mark &from = m_bins[end - bins], &to = m_bins[end];
        const double readings = std::min(from.count, to.count);
        const double tolerance_K =
            kTolerance_K + kToleranceTimes * m_noise_K * std::sqrt(2.0 / readings) + unsure_K(from, to);
        for (std::size_t fit = 0; fit < fits.size(); ++fit)
            fits[fit].learn(span(from, to, fit, kWrongThen), to.temperature_K - from.temperature_K,
                            tolerance_K);
    }
    if (std::ranges::all_of(fits, &HeatFit::isEmpty)) // the model has failed: start again
        fits = m_anything;
}

// Called when a bin is full: judges the newest readings and learns from those that have become old enough.
void WarmingWatch::judge() {
    m_unfollowed.reset();
    if (m_bins.empty())
        return;
    for (const Mark& from : m_bins)
        for (const auto& found : {worst(m_fits, from, m_min_K, kWrongNow), impossible(from)})
            if (found &&
                (!m_unfollowed || std::abs(found->missing_K()) > std::abs(m_unfollowed->missing_K())))
                m_unfollowed = found;
    const bool isResting = sameFor_s() > kResting_s;
    for (; m_learnt < m_bins.size() && m_bins[m_learnt].time_s < m_now.time_s - kJudged_s; ++m_learnt)
        if (!m_unfollowed && !(isResting && m_bins[m_learnt].time_s > m_same.time_s))
            learn(m_fits, m_learnt);
    while (m_learnt > 0 && m_bins.front().time_s < m_now.time_s - kLongest_s) {
        m_bins.pop_front();
        --m_learnt;
    }
    if (!m_unfollowed)
        noteRest();
}

// The means of bins: a single wrong reading counts little. What was learnt of the object does not count: air
// that stands still again explains a rise, too. A rise that is over does not count either.
void WarmingWatch::judgeRise() {
    m_foreignHeat.reset();
    double most_K = m_min_K + kNoiseTimes * m_noise_K;
    for (std::size_t i = m_bins.size() - 1; i-- > 0;) {
        const Mark &from = m_bins[i], &to = m_bins.back();
        if (from.time_s < std::max(m_riseFrom_s, to.time_s - kRise_s))
            break;
        const HeatFit::Change change =
            ofAll(m_anything, [&](std::size_t fit) { return span(from, to, fit, kWrongNow); });
        const double explained_K = std::max(change.max_K, 0.0);
        const double gained_K = to.temperature_K - from.temperature_K;
        if (i + 2 == m_bins.size() && gained_K <= explained_K)
            break;
        const double beyond_K = gained_K - explained_K - unsure_K(from, to);
        if (beyond_K <= most_K)
            continue;
        most_K = beyond_K;
        const double time_s = to.time_s - from.time_s;
        m_foreignHeat = ForeignHeat{gained_K / time_s, explained_K / time_s};
    }
}

std::optional<WarmingWatch::Mark> WarmingWatch::at(double time_s) const {
    const auto after =
        std::ranges::find_if(m_bins, [time_s](const Mark& bin) { return bin.time_s >= time_s; });
    if (after == m_bins.end() || after == m_bins.begin())
        return std::nullopt;
    const Mark& before = *std::prev(after);
    const double share = (time_s - before.time_s) / (after->time_s - before.time_s);
    const auto between = [share](double a, double b) { return a + share * (b - a); };
    Mark out;
    out.time_s = time_s;
    out.temperature_K = between(before.temperature_K, after->temperature_K);
    out.uncertainty_K = between(before.uncertainty_K, after->uncertainty_K);
    out.linear_K_s = between(before.linear_K_s, after->linear_K_s);
    out.radiated_K_s = between(before.radiated_K_s, after->radiated_K_s);
    for (std::size_t k = 0; k < out.energy_K.size(); ++k)
        out.energy_K[k] = between(before.energy_K[k], after->energy_K[k]);
    return out;
}

std::optional<double> WarmingWatch::unexplained_K(const WarmingWatch& readings, double time_s) const {
    if (m_bins.size() < 2 || readings.m_bins.size() < 2)
        return std::nullopt;
    // the last bin is being filled
    const double to_s =
        std::min(m_bins[m_bins.size() - 2].time_s, readings.m_bins[readings.m_bins.size() - 2].time_s);
    const double usual_s = std::max(m_usual_s, readings.m_usual_s);
    if (m_now.time_s - to_s > 2.0 * (std::max(m_bin_s, readings.m_bin_s) + usual_s))
        return std::nullopt;
    std::optional<Mark> from = at(to_s - time_s), to = at(to_s);
    const std::optional<Mark> readFrom = readings.at(to_s - time_s), readTo = readings.at(to_s);
    if (!from || !to || !readFrom || !readTo)
        return std::nullopt;
    const auto readAs = [](Mark& mark, const Mark& read) {
        mark.temperature_K = read.temperature_K;
        mark.uncertainty_K = read.uncertainty_K;
        mark.linear_K_s = read.linear_K_s;
        mark.radiated_K_s = read.radiated_K_s;
    };
    readAs(*from, *readFrom);
    readAs(*to, *readTo);
    const HeatFit::Change change =
        ofAll(m_fits, [&](std::size_t fit) { return span(*from, *to, fit, kWrongNow); });
    const double gained_K = to->temperature_K - from->temperature_K;
    // of the other one's reference, where less is known of it
    const double unknown_K = std::max(readings.roomUnknown_K(to_s) - roomUnknown_K(to_s), 0.0);
    const double moved_K_s = std::max(readings.m_restRate_K_s - m_restRate_K_s, 0.0);
    const double hidden_K = kToleranceTimes * std::max(m_noise_K, readings.m_noise_K) + unsure_K(*from, *to) +
                            (m_losses.max_1_s * unknown_K + moved_K_s) * time_s;
    return std::max(gained_K - change.max_K - hidden_K, 0.0) +
           std::min(gained_K - change.min_K + hidden_K, 0.0);
}

double WarmingWatch::sameFor_s() const {
    return m_now.count > 0 ? m_now.time_s - m_same.time_s : 0.0;
}

HeatFit::Change WarmingWatch::expected(const Fits& fits, const Mark& from, double wrong) const {
    return ofAll(fits, [&](std::size_t fit) { return span(from, m_now, fit, wrong); });
}

std::optional<Unfollowed> WarmingWatch::worst(const Fits& fits, const Mark& from, double min_K,
                                              double wrong) const {
    const double expected_K = smallest_K(expected(fits, from, wrong));
    const double gained_K = m_now.temperature_K - from.temperature_K;
    const bool follows = gained_K * expected_K >= kMinShare * expected_K * expected_K;
    if (follows || std::abs(expected_K) < min_K + kNoiseTimes * m_noise_K + unsure_K(from, m_now))
        return std::nullopt;
    return Unfollowed{expected_K, gained_K, m_now.time_s - from.time_s};
}

/// The temperature fell by more than any rates explain. A small fall also counts, such as that of a sensor
/// that comes off and cools slowly. An impossible rise is limited elsewhere.
std::optional<Unfollowed> WarmingWatch::impossible(const Mark& from) const {
    const HeatFit::Change change = expected(m_anything, from, kWrongNow);
    const double gained_K = m_now.temperature_K - from.temperature_K;
    if (gained_K > std::min(change.min_K, 0.0) - m_min_K - kNoiseTimes * m_noise_K - unsure_K(from, m_now))
        return std::nullopt;
    return Unfollowed{change.min_K, gained_K, m_now.time_s - from.time_s, true};
}

/// While a reading stays the same, the losses are constant, whatever they are. The energy that balances them
/// then lies on a straight line. If it deviates from the line by more than the reading may hide, even the
/// smallest k does not explain the constant reading.
std::optional<Unfollowed> WarmingWatch::bent(const Fits& fits, const Mark& middle, double min_K) const {
    const double share = (middle.time_s - m_same.time_s) / (m_now.time_s - m_same.time_s);
    LaggedPower::Energies bend_K{};
    for (std::size_t k = 0; k < LaggedPower::kLags_s.size(); ++k)
        bend_K[k] =
            middle.energy_K[k] - m_same.energy_K[k] - share * (m_now.energy_K[k] - m_same.energy_K[k]);
    const double expected_K = smallest_K(ofAll(fits, [&](std::size_t fit) {
        const auto [min_K, max_K] = std::minmax(bend_K[fit / kLaws], bend_K[fit / kLaws + 1]);
        return HeatSpan{min_K, max_K};
    }));
    if ((1.0 - kWrongNow) * std::abs(expected_K) < min_K + kNoiseTimes * m_noise_K)
        return std::nullopt;
    return Unfollowed{expected_K, 0.0, m_now.time_s - m_same.time_s};
}

// All readings up to the first of the equal ones were good: they are learnt from.
std::optional<Unfollowed> WarmingWatch::unfollowedWhileSame(double min_K) const {
    Fits fits = m_fits;
    for (std::size_t i = m_learnt; i < m_bins.size() && m_bins[i].time_s <= m_same.time_s; ++i)
        learn(fits, i);
    std::optional<Unfollowed> found;
    if (!m_isRest || m_same.time_s >= *m_zeroed_s) // else its losses are of another reference
        found = worst(fits, m_same, min_K, kWrongNow);
    for (const Mark& from : m_bins)
        if (from.time_s > m_same.time_s)
            for (const auto& since : {worst(fits, from, min_K, kWrongNow), bent(fits, from, min_K)})
                if (since && (!found || std::abs(since->expected_K) > std::abs(found->expected_K)))
                    found = since;
    return found;
}

} // namespace bask
