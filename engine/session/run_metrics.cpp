#include "engine/session/run_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace bask {
namespace {

using Samples = std::span<const TraceSample>;

double temperature_K(const ObjectSample& object) {
    return std::isfinite(object.true_K) ? object.true_K : object.estimated_K;
}

/// Index of the first sample with the target of the last one.
std::size_t lastTargetFrom(Samples samples, std::size_t i) {
    std::size_t from = samples.size() - 1;
    while (from > 0 && samples[from - 1].objects[i].target_K == samples[from].objects[i].target_K)
        --from;
    return from;
}

/// When T first passes `level` in the step's direction, linear between samples; samples without T are left
/// out.
std::optional<double> crossing_s(Samples samples, std::size_t i, double level_K, bool isUpward) {
    const auto excess = [&](const TraceSample& sample) {
        const double e = temperature_K(sample.objects[i]) - level_K;
        return isUpward ? e : -e;
    };
    const TraceSample* before = nullptr;
    for (const TraceSample& sample : samples) {
        const double now = excess(sample);
        if (!std::isfinite(now))
            continue;
        if (now >= 0.0) {
            if (before == nullptr)
                return sample.time_s;
            const double last = excess(*before);
            return before->time_s + (sample.time_s - before->time_s) * last / (last - now);
        }
        before = &sample;
    }
    return std::nullopt;
}

void judgeStep(ObjectMetrics& metrics, Samples samples, std::size_t i, double band_K) {
    if (!metrics.step_K || std::abs(*metrics.step_K) < 2.0 * band_K)
        return;
    const double step_K = *metrics.step_K, first_K = metrics.target_K - step_K;
    const bool isUpward = step_K > 0.0;
    const auto begun = crossing_s(samples, i, first_K + 0.1 * step_K, isUpward);
    const auto done = crossing_s(samples, i, first_K + 0.9 * step_K, isUpward);
    if (begun && done)
        metrics.rise_s = *done - *begun;
    double most_K = 0.0;
    for (const TraceSample& sample : samples) {
        const double over_K = temperature_K(sample.objects[i]) - metrics.target_K;
        if (std::isfinite(over_K))
            most_K = std::max(most_K, isUpward ? over_K : -over_K);
    }
    metrics.overshoot_K = most_K;
}

void judgeEnd(ObjectMetrics& metrics, const std::vector<TraceSample>& all, Samples samples, std::size_t i,
              double band_K) {
    const auto since_s = settlingTime_s(all, i, band_K);
    if (!since_s)
        return;
    metrics.settling_s = std::max(*since_s - metrics.from_s, 0.0);
    const double from_s = std::max({*since_s, metrics.from_s, samples.back().time_s - kSteadyWindow_s});
    double sum_K = 0.0, squares = 0.0;
    std::size_t count = 0;
    for (const TraceSample& sample : samples) {
        if (sample.time_s < from_s)
            continue;
        const double error_K = temperature_K(sample.objects[i]) - metrics.target_K;
        sum_K += error_K;
        squares += error_K * error_K;
        ++count;
    }
    const double mean_K = sum_K / static_cast<double>(count);
    metrics.steadyError_K = mean_K;
    if (count > 1)
        metrics.steadyDeviation_K =
            std::sqrt(std::max(squares - static_cast<double>(count) * mean_K * mean_K, 0.0) /
                      static_cast<double>(count - 1));
}

ObjectMetrics judgeObject(const std::vector<TraceSample>& all, std::size_t i, const Pose& X_EO,
                          double band_K) {
    ObjectMetrics metrics;
    metrics.target_K = std::numeric_limits<double>::quiet_NaN();
    if (all.empty())
        return metrics;
    const Samples samples = Samples(all).subspan(lastTargetFrom(all, i));
    const ObjectSample& first = samples.front().objects[i];
    const ObjectSample& last = samples.back().objects[i];
    metrics.target_K = last.target_K;
    metrics.from_s = samples.front().time_s;
    metrics.isTrue = std::isfinite(last.true_K);
    if (std::isfinite(temperature_K(last)))
        metrics.final_K = temperature_K(last);
    if (std::isfinite(temperature_K(first)) && std::isfinite(metrics.target_K))
        metrics.step_K = metrics.target_K - temperature_K(first);
    judgeStep(metrics, samples, i, band_K);
    judgeEnd(metrics, all, samples, i, band_K);
    const auto centre = [&](const TraceSample& s) -> Eigen::Vector3d {
        return poseFromCoordinates(s.coordinates) * X_EO.translation();
    };
    for (std::size_t k = 1; k < all.size(); ++k) {
        const double way_m = (centre(all[k]) - centre(all[k - 1])).norm();
        metrics.pathLength_m += std::isfinite(way_m) ? way_m : 0.0;
    }
    return metrics;
}

void judgeMotion(RunMetrics& metrics, const std::vector<TraceSample>& samples) {
    for (std::size_t k = 1; k < samples.size(); ++k) {
        const TraceSample& before = samples[k - 1];
        const Pose X0 = poseFromCoordinates(before.coordinates),
                   X1 = poseFromCoordinates(samples[k].coordinates);
        const double way_m = (X1.translation() - X0.translation()).norm();
        if (std::isfinite(way_m)) {
            metrics.pathLength_m += way_m;
            metrics.turned_rad += Eigen::AngleAxisd(X0.linear().transpose() * X1.linear()).angle();
        }
        const double lasts_s = samples[k].time_s - before.time_s;
        const ActiveLimits& limits = before.limits;
        if (!limits.any() || !(lasts_s > 0.0))
            continue;
        metrics.heldBack_s += lasts_s;
        for (int l = 0; l < static_cast<int>(metrics.atLimit_s.size()); ++l) {
            bool isActive = limits.has(static_cast<Limit>(l));
            for (int c = 1; static_cast<Limit>(l) == Limit::Workspace && c < 6; ++c)
                isActive = isActive || limits.has(Limit::Workspace, c);
            if (isActive)
                metrics.atLimit_s[static_cast<std::size_t>(l)] += lasts_s;
        }
        if (limits.has(Limit::Speed) || limits.has(Limit::Rotation))
            metrics.atVelocityLimit_s += lasts_s;
    }
}

} // namespace

std::optional<double> ObjectMetrics::overshootShare() const {
    return overshoot_K && step_K ? std::optional(*overshoot_K / std::abs(*step_K)) : std::nullopt;
}

RunMetrics runMetrics(const SessionRecord& session, double band_K) {
    const std::vector<TraceSample> samples = session.controlledSamples();
    RunMetrics metrics;
    metrics.band_K = band_K;
    metrics.samples = samples.size();
    metrics.duration_s = samples.empty() ? 0.0 : samples.back().time_s;
    for (std::size_t i = 0; i < session.experiment.objects.size(); ++i)
        metrics.objects.push_back(
            judgeObject(samples, i, poseFromCoordinates(session.experiment.objects[i].mounting), band_K));
    judgeMotion(metrics, samples);
    return metrics;
}

} // namespace bask
