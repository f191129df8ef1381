#include "engine/runtime/second_opinion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr double kSigmas = 4.0;
constexpr double kContact_K = 0.3;    // standard uncertainty of a zeroed sensor on its object
constexpr double kCold_K = 1.0;       // of an object as cold as what its face reflects
constexpr int kMaxColdReadings = 30;  // of which the mean is taken
constexpr double kLately_s = 15.0;    // three time constants of a slow sensor
constexpr double kSure_s = 3.0;       // a difference has to last as long,
constexpr int kSureReadings = 3;      // and for as many readings
constexpr double kExplained_s = 10.0; // until one emittance has explained the difference
constexpr double kMinEmittance = 0.02, kMaxEmittance = 1.02;
constexpr double kLagPeriods = 5.0; // stale readings, and the steps between two of them
constexpr double kTogether_s = 5.0; // two objects are compared by readings that near

double tolerance_K(const CameraOpinion& seen) {
    return kSigmas * std::hypot(seen.uncertainty_K, kContact_K);
}

double excess_K(const CameraOpinion& seen) {
    return std::abs(seen.contact_K - seen.reflected_K);
}

bool isWarm(const CameraOpinion& seen) {
    return excess_K(seen) > 2.0 * tolerance_K(seen);
}

} // namespace

SecondOpinion::SecondOpinion(std::size_t objects, double period_s)
    : m_objects(objects), m_lately_s(std::max(kLately_s, kLagPeriods * period_s)) {}

// As warm as what its face reflects, an object looks the same with any emittance.
SecondOpinion::Emittance SecondOpinion::emittanceOf(const CameraOpinion& seen) {
    if (!isWarm(seen) || std::isnan(seen.emittance))
        return {};
    const double within_K = tolerance_K(seen);
    return {seen.emittance, std::max(1.0, std::abs(seen.emittance)) * within_K / (excess_K(seen) - within_K)};
}

bool SecondOpinion::isWithin(const Watch& watch, double contact_K, double tolerance_K) {
    const auto [min, max] = std::ranges::minmax_element(
        watch.camera, {}, [](const std::pair<double, double>& moment) { return moment.second; });
    return contact_K > min->second - tolerance_K && contact_K < max->second + tolerance_K;
}

bool SecondOpinion::isAgreedWarm(const Watch& watch) {
    return watch.seen && watch.differing == 0 && isWarm(*watch.seen);
}

/// Whether one emittance explains what differs now, since when it differs, and what agreed before.
bool SecondOpinion::isExplained(const Watch& watch) {
    const double before = watch.before.tolerance;
    const double min = std::max({kMinEmittance, watch.minEmittance, watch.before.value - before});
    const double max = std::min({kMaxEmittance, watch.maxEmittance, watch.before.value + before});
    return std::isfinite(watch.now.tolerance) && min <= max;
}

CameraOpinion SecondOpinion::asTold(const Watch& watch) {
    CameraOpinion out = *watch.seen;
    out.contact_K = watch.told_K;
    return out;
}

void SecondOpinion::take(Watch& watch, double now_s, const CameraOpinion& seen) const {
    watch.camera.emplace_back(now_s, seen.camera_K);
    while (watch.camera.front().first < now_s - m_lately_s)
        watch.camera.pop_front();
    if (std::isnan(seen.contact_K) || seen.contact_s <= watch.contact_s)
        return;
    watch.seen_s = now_s;
    watch.contact_s = seen.contact_s;
    const double offset_K = seen.contact_K - seen.camera_K;
    if (watch.coldReadings < kMaxColdReadings && std::abs(seen.camera_K - seen.reflected_K) < kCold_K &&
        std::abs(offset_K) < tolerance_K(seen))
        watch.coldOffset_K += (offset_K - watch.coldOffset_K) / ++watch.coldReadings;
    watch.told_K = seen.contact_K;
    watch.seen = seen;
    watch.seen->contact_K -= watch.coldOffset_K;
    watch.now = emittanceOf(*watch.seen);
    if (isWithin(watch, watch.seen->contact_K, tolerance_K(seen))) {
        watch.agreed_s = now_s;
        watch.differing = 0;
        watch.isConfirmed = false;
        if (watch.now.tolerance < watch.before.tolerance)
            watch.before = watch.now;
        return;
    }
    if (watch.differing++ == 0) {
        watch.differs_s = now_s;
        watch.minEmittance = kMinEmittance;
        watch.maxEmittance = kMaxEmittance;
    }
    watch.minEmittance = std::max(watch.minEmittance, watch.now.value - watch.now.tolerance);
    watch.maxEmittance = std::min(watch.maxEmittance, watch.now.value + watch.now.tolerance);
}

void SecondOpinion::add(double now_s, const std::vector<std::optional<CameraOpinion>>& seen) {
    if (seen.size() != m_objects.size())
        throw std::invalid_argument("SecondOpinion: one opinion an object");
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i])
            take(m_objects[i], now_s, *seen[i]);
    for (Watch& watch : m_objects)
        if (watch.finding && !isStanding(watch))
            watch.finding.reset();
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Watch& watch = m_objects[i];
        if (!watch.isConfirmed && now_s - watch.differs_s >= kSure_s && watch.differing >= kSureReadings &&
            !isOtherOfSwapped(i))
            judge(i, now_s);
    }
}

bool SecondOpinion::isStanding(const Watch& watch) const {
    switch (watch.finding->verdict) {
    case OpinionVerdict::EmittanceOther:
    case OpinionVerdict::CameraDiffers:
        return watch.differing > 0;
    case OpinionVerdict::SensorOff:
    case OpinionVerdict::NeverOn:
        return !isAgreedWarm(watch);
    case OpinionVerdict::Swapped:
        break;
    }
    const Watch& other = m_objects[watch.finding->other];
    return !isAgreedWarm(watch) || !isAgreedWarm(other) ||
           std::abs(watch.seen->camera_K - other.seen->camera_K) < 2.0 * tolerance_K(*watch.seen);
}

bool SecondOpinion::isOtherOfSwapped(std::size_t object) const {
    return std::ranges::any_of(m_objects, [&](const Watch& watch) {
        return watch.finding && watch.finding->verdict == OpinionVerdict::Swapped &&
               watch.finding->other == object;
    });
}

std::optional<std::size_t> SecondOpinion::swappedWith(std::size_t object) const {
    const Watch& one = m_objects[object];
    for (std::size_t j = 0; j < m_objects.size(); ++j) {
        const Watch& other = m_objects[j];
        if (j == object || !other.seen || one.seen_s - other.seen_s > kTogether_s)
            continue;
        const double within_K = std::max(tolerance_K(*one.seen), tolerance_K(*other.seen));
        if (std::abs(one.seen->camera_K - other.seen->camera_K) > 0.5 * within_K &&
            isWithin(other, one.seen->contact_K, within_K) &&
            isWithin(one, other.seen->contact_K, within_K) &&
            !isWithin(other, other.seen->contact_K, 0.5 * within_K))
            return j;
    }
    return std::nullopt;
}

void SecondOpinion::judge(std::size_t object, double now_s) {
    Watch& watch = m_objects[object];
    const bool isOfSensor = watch.finding && watch.finding->verdict != OpinionVerdict::EmittanceOther &&
                            watch.finding->verdict != OpinionVerdict::CameraDiffers;
    if (watch.finding && watch.finding->verdict == OpinionVerdict::Swapped)
        return;
    if (const auto other = swappedWith(object)) {
        const auto [first, second] = std::minmax(object, *other);
        m_objects[object].finding.reset();
        m_objects[*other].finding.reset();
        m_objects[first].finding = OpinionFinding{OpinionVerdict::Swapped, asTold(m_objects[first]), second,
                                                  asTold(m_objects[second])};
        return;
    }
    const bool isNoteBeforeCold = watch.finding && !std::isfinite(watch.now.tolerance);
    if (isOfSensor || isNoteBeforeCold)
        return;
    OpinionFinding found;
    found.seen = asTold(watch);
    if (isExplained(watch)) {
        if (now_s - watch.differs_s < kExplained_s)
            return;
        found.verdict = OpinionVerdict::EmittanceOther;
    } else if (watch.seen->camera_K < watch.seen->contact_K) {
        found.verdict = OpinionVerdict::CameraDiffers;
    } else if (std::isfinite(watch.agreed_s)) {
        found.verdict = OpinionVerdict::SensorOff;
        found.agreedAgo_s = now_s - watch.agreed_s;
    }
    watch.finding = found;
}

void SecondOpinion::confirm(std::size_t object) {
    m_objects.at(object).isConfirmed = m_objects[object].differing > 0;
    m_objects[object].finding.reset();
    for (Watch& watch : m_objects)
        if (watch.finding && watch.finding->verdict == OpinionVerdict::Swapped &&
            watch.finding->other == object)
            watch.finding.reset();
}

void SecondOpinion::atRest() {
    for (Watch& watch : m_objects) {
        watch.coldOffset_K = 0.0;
        watch.coldReadings = 0;
    }
}

} // namespace bask
