#include "engine/runtime/assignment_watch.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

constexpr double kAfter_s = 2.0, kBefore_s = 6.0; // windows, at one reading a second or more
constexpr double kAfterPeriods = 2.0, kBeforePeriods = 5.0;
constexpr std::array<double, 4> kGaps_s{2.5, 6.0, 12.0, 30.0};
constexpr double kGapPeriods = 2.5;
constexpr int kMinReadings = 3; // in each
constexpr double kKept_s = 45.0, kKeptPeriods = 15.0;
constexpr double kUnseen_s = 5.0; // a longer gap begins anew
constexpr double kSmall_K = 0.1;  // of a change that nothing else makes uncertain
constexpr double kSumTimes = 3.0; // standard deviations that the sum may be off,
constexpr double kSumShare = 0.2; // and this share of what an exchange moves
constexpr double kFarTimes = 3.0; // standard uncertainties that the temperatures may be off
constexpr double kFitTimes = 3.0; // standard deviations that an exchange may be off itself
constexpr double kApart_K = 0.7;  // what an exchange has to move at least

double distance(double value, double min, double max) {
    return std::max({0.0, min - value, value - max});
}

} // namespace

AssignmentWatch::AssignmentWatch(std::size_t objects, double period_s)
    : m_objects(objects), m_period_s(period_s) {}

void AssignmentWatch::reset() {
    m_objects.assign(m_objects.size(), {});
    m_before.reset();
    m_exchanged.reset();
}

void AssignmentWatch::take(Watch& watch, double now_s, const CameraOpinion& seen) const {
    const double passed_s = now_s - watch.camera_s;
    if (watch.isBegun && passed_s > std::max(kUnseen_s, kGapPeriods * m_period_s))
        watch = {};
    for (std::size_t k = 0; k < kLags_s.size(); ++k) {
        const bool isAtOnce = !watch.isBegun || kLags_s[k] == 0.0;
        watch.camera_K[k] +=
            (seen.camera_K - watch.camera_K[k]) * (isAtOnce ? 1.0 : -std::expm1(-passed_s / kLags_s[k]));
    }
    watch.isBegun = true;
    watch.camera_s = now_s;
    if (std::isnan(seen.contact_K) || seen.contact_s <= watch.contact_s)
        return;
    watch.contact_s = seen.contact_s;
    watch.samples.push_back(
        {now_s, seen.contact_K, watch.camera_K, seen.uncertainty_K, seen.camera_K - seen.reflected_K});
    while (watch.samples.front().time_s < now_s - std::max(kKept_s, kKeptPeriods * m_period_s))
        watch.samples.pop_front();
}

void AssignmentWatch::add(double now_s, const std::vector<std::optional<CameraOpinion>>& seen) {
    if (seen.size() != m_objects.size())
        throw std::invalid_argument("AssignmentWatch: one opinion an object");
    bool isNew = false;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i]) {
            take(m_objects[i], now_s, *seen[i]);
            const auto& samples = m_objects[i].samples;
            isNew = isNew || (!samples.empty() && samples.back().time_s == now_s);
        }
    if (!isNew)
        return;
    auto now = likeliest(now_s);
    const bool isSame = now && m_before && now->one == m_before->one && now->other == m_before->other;
    m_exchanged = isSame ? now : std::nullopt;
    m_before = now;
}

std::optional<AssignmentWatch::Change> AssignmentWatch::change(const Watch& watch, double end_s,
                                                               double gap_s) const {
    struct Mean {
        int count = 0;
        double contact_K = 0.0, uncertainty_K = 0.0, excess_K = 0.0;
        PerLag camera_K{};
    };
    const double after_s = std::max(kAfter_s, kAfterPeriods * m_period_s);
    const double before_s = std::max(kBefore_s, kBeforePeriods * m_period_s);
    Mean before, after;
    double squares_K2 = 0.0;
    int steps = 0;
    const Sample* last = nullptr;
    for (const Sample& sample : watch.samples) {
        const double ago_s = end_s - sample.time_s;
        Mean* const mean = ago_s < after_s + 0.1 * m_period_s           ? &after
                           : ago_s >= gap_s && ago_s < gap_s + before_s ? &before
                                                                        : nullptr;
        const Sample* const previous = std::exchange(last, mean != nullptr ? &sample : nullptr);
        if (mean == nullptr)
            continue;
        const double share = 1.0 / ++mean->count;
        const auto approach = [&](double& value, double to) { value += share * (to - value); };
        approach(mean->contact_K, sample.contact_K);
        approach(mean->uncertainty_K, sample.uncertainty_K);
        approach(mean->excess_K, sample.excess_K);
        for (std::size_t k = 0; k < kLags_s.size(); ++k)
            approach(mean->camera_K[k], sample.camera_K[k]);
        if (previous != nullptr && mean->count > 1) { // within a window
            const double step_K =
                (sample.contact_K - sample.camera_K[0]) - (previous->contact_K - previous->camera_K[0]);
            squares_K2 += step_K * step_K;
            ++steps;
        }
    }
    if (before.count < kMinReadings || after.count < kMinReadings)
        return std::nullopt;
    Change out;
    out.before_K = before.contact_K;
    out.after_K = after.contact_K;
    out.minSeen_K = out.maxSeen_K = after.camera_K[0] - before.camera_K[0];
    out.minAfter_K = std::ranges::min(after.camera_K);
    out.maxAfter_K = std::ranges::max(after.camera_K);
    out.uncertainty_K = after.uncertainty_K;
    for (std::size_t k = 1; k < kLags_s.size(); ++k) {
        const double seen_K = after.camera_K[k] - before.camera_K[k];
        out.minSeen_K = std::min(out.minSeen_K, seen_K);
        out.maxSeen_K = std::max(out.maxSeen_K, seen_K);
    }
    const double noise_K2 = steps > 0 ? 0.5 * squares_K2 / steps : 0.0;
    const double excess_K = std::max({1.0, std::abs(before.excess_K), std::abs(after.excess_K)});
    const double moved = std::min(1.0, std::abs(after.excess_K - before.excess_K) / excess_K);
    out.variance_K2 = kSmall_K * kSmall_K + noise_K2 * (1.0 / before.count + 1.0 / after.count) +
                      std::pow(moved * std::max(before.uncertainty_K, after.uncertainty_K), 2);
    return out;
}

double AssignmentWatch::logRatio(const Change& one, const Change& other) {
    const double before_K = one.before_K - other.before_K, after_K = one.after_K - other.after_K;
    const double min_K = one.minSeen_K - other.maxSeen_K, max_K = one.maxSeen_K - other.minSeen_K;
    const double variance_K2 = one.variance_K2 + other.variance_K2;
    const double off_K = distance(after_K, before_K + min_K, before_K + max_K);
    const double both_K = (one.after_K + other.after_K) - (one.before_K + other.before_K);
    const double bothOff_K =
        distance(both_K, one.minSeen_K + other.minSeen_K, one.maxSeen_K + other.maxSeen_K);
    if (off_K < kApart_K || bothOff_K > kSumTimes * std::sqrt(variance_K2) + kSumShare * off_K)
        return 0.0;
    const double apart_K =
        distance(after_K, other.minAfter_K - one.maxAfter_K, other.maxAfter_K - one.minAfter_K);
    if (apart_K > kFarTimes * std::hypot(one.uncertainty_K, other.uncertainty_K, kOffset_K))
        return 0.0;
    const auto logLikelihood = [](double off, double variance) {
        return -0.5 * (off * off / variance + std::log(variance));
    };
    const double inPlace = logLikelihood(off_K, variance_K2);
    const auto ratioTo = [&](double min, double max, double variance) {
        const double off = distance(after_K, min, max);
        return off * off > kFitTimes * kFitTimes * variance ? 0.0 : logLikelihood(off, variance) - inPlace;
    };
    return std::max(ratioTo(-before_K - max_K, -before_K - min_K, variance_K2 + kOffset_K * kOffset_K),
                    ratioTo(before_K - max_K, before_K - min_K, variance_K2));
}

std::optional<ExchangedSensors> AssignmentWatch::likeliest(double now_s) const {
    std::optional<ExchangedSensors> out;
    double max = kLogRatio;
    for (const double gap : kGaps_s) {
        const double gap_s = std::max(gap, kGapPeriods * m_period_s);
        std::vector<std::optional<Change>> changes;
        for (const Watch& watch : m_objects)
            changes.push_back(change(watch, now_s, gap_s));
        for (std::size_t i = 0; i < changes.size(); ++i)
            for (std::size_t j = i + 1; j < changes.size(); ++j) {
                if (!changes[i] || !changes[j])
                    continue;
                if (const double ratio = logRatio(*changes[i], *changes[j]); ratio > max) {
                    max = ratio;
                    out = ExchangedSensors{i, j, gap_s + std::max(kAfter_s, kAfterPeriods * m_period_s)};
                }
            }
    }
    return out;
}

} // namespace bask
