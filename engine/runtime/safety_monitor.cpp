#include "engine/runtime/safety_monitor.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/hand_warm.h"
#include "engine/model/uneven_source.h"
#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace bask {
namespace {

using Condition = SafetyCondition;
using Reaction = SafetyReaction;

/// a sensor with exactly the same value is frozen beyond this expected change
constexpr double kWhileSame_K = 0.5;
constexpr double kAtSetPoint_K = 10.0;    ///< of a source that has warmed up
constexpr double kSetPointTrifle_K = 3.0; ///< resolution of a controller, and a ramp that it follows late
constexpr double kSameScale = 0.01;       ///< of a set point read back as a multiple of the one written
constexpr double kReadBack_s = 3.0;       ///< until a controller has taken a new set point
constexpr double kColder_K = 5.0;         ///< below room temperature
constexpr double kAboveRoom_K = 5.0;      ///< of a room that is as warm as a hand
constexpr double kLate_s = 1.0;           ///< delay of the loop
constexpr double kCoolingTimes = 5.0;     ///< time constants until an object has room temperature
constexpr double kDiskHysteresis = 1.1;
constexpr double kOpinionSigmas = 2.0;
constexpr double kSwapped_K = 1.5;      ///< noise, offsets and what objects warm in a period
constexpr double kDeviating_K = 1.0;    ///< readings of two objects that deviate in opposite ways
constexpr double kExplained_K = 0.2;    ///< and would not if they were exchanged
constexpr double kPair_s = 36.0;        ///< by what has changed in this time
constexpr double kSeemSwapped_s = 10.0; ///< for so long: it may be of a moment
constexpr double kUnusable_s = 60.0; ///< for so long a face is told to be unusable, which pose by pose it is
constexpr double kStayed = 0.1;      ///< a smaller share of the expected change is none

/// All problems of one sensor share one alarm, named after the first problem.
bool isSame(Condition a, std::size_t ofA, Condition b, std::size_t ofB) {
    const std::string_view key = alarmEntry(a).key;
    return ofA == ofB && (a == b || (!key.empty() && key == alarmEntry(b).key));
}

std::string oneDigit(double value) {
    return formatNumber(std::round(value * 10.0) / 10.0, 6);
}

/// In a fault, also by a source that heats by itself. During manual work, objects are taken off a hot rig.
bool isHeated(const SafetyObservation& seen) {
    return seen.asked_K || (seen.isHeatUnwanted && !seen.isSourceDark);
}

void sortByGravity(std::vector<SafetyFinding>& findings) {
    std::ranges::stable_sort(findings, [](const SafetyFinding& a, const SafetyFinding& b) {
        return alarmEntry(a.condition).reaction > alarmEntry(b.condition).reaction;
    });
}

} // namespace

SensorLimits sensorLimits(const Experiment& experiment) {
    constexpr double kTimes = 3.0;
    Experiment hottest = experiment;
    hottest.source.temperature_K = highestSetPoint_K(experiment.source);
    SensorLimits limits;
    limits.stalePeriods = experiment.safety.stalePeriods;
    limits.jumps = experiment.safety.jumps;
    const Surroundings surroundings = surroundingsOf(experiment);
    for (const ObjectSpec& object : experiment.objects)
        limits.bounds.emplace_back(
            lossRange(startRates(object, surroundings), object.material.emittance, experiment.environment_K),
            experiment.environment_K);
    const double maxViewFactor = emissionWithoutRings(hottest).maxWeight(hottest.source.temperature_K);
    for (const HeatRates& rates : nominalRates(hottest, experiment.environment_K))
        limits.largestRates_K_s.push_back(experiment.safety.largestRate_K_s.value_or(
            std::max(SafetySpec::kMinRate_K_s, kTimes * rates.lambda1 * maxViewFactor)));
    return limits;
}

SafetyMonitor::SafetyMonitor(const Experiment& experiment)
    : m_experiment(experiment), m_opinion(experiment.objects.size(), experiment.sampling.period_s),
      m_assignment(experiment.objects.size(), experiment.sampling.period_s),
      m_source(experiment.safety, experiment.environment_K),
      m_neighbours(rigGeometry(experiment)->neighbours()), m_coldAfter_s(0.0) {
    const Surroundings surroundings = surroundingsOf(experiment);
    for (const ObjectSpec& object : experiment.objects) {
        const HeatRates rates = startRates(object, surroundings);
        // Without the air that is assumed: an object must not count as cold too soon.
        const double timeConstant_s = rates.withoutAir().timeConstant_s(experiment.environment_K);
        const LossRange losses = lossRange(rates, object.material.emittance, experiment.environment_K);
        m_objects.push_back({WarmingWatch(losses, experiment.environment_K, experiment.safety.warming_K),
                             FrozenWatch(losses, experiment.environment_K), rates});
        m_coldAfter_s = std::max(m_coldAfter_s, kCoolingTimes * timeConstant_s);
    }
}

SafetyChanges SafetyMonitor::watch(const SafetyObservation& seen) {
    if (seen.objects.size() != m_objects.size())
        throw std::invalid_argument("SafetyMonitor: one observation an object");
    m_now_s = seen.now_s;
    m_present.clear();
    if (seen.asked_K)
        m_lastHeat_s = seen.now_s;
    std::vector<std::optional<CameraOpinion>> opinions;
    for (const ObservedObject& object : seen.objects)
        opinions.push_back(object.opinion);
    m_opinion.add(seen.now_s, opinions);
    if (isHeated(seen))
        m_assignment.add(seen.now_s, opinions);
    else
        m_assignment.reset(); // somebody may exchange them by hand
    noteSwaps(seen);
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        addObject(i, seen);
    addRobot(seen);
    addSource(seen);
    addHeating(seen);
    addRig(seen);
    SafetyChanges changes;
    raise(seen, changes);
    end(seen, changes);
    sortByGravity(m_active);
    sortByGravity(changes.raised);
    // A loose contact is one loss: a short return of the value does not start a new one.
    if (isLost()) {
        if (seen.now_s - m_lostLast_s >
            m_experiment.safety.pauseLimit_s + 1.5 * m_experiment.sampling.period_s)
            m_lostSince_s = seen.now_s;
        m_lostLast_s = seen.now_s;
    }
    return changes;
}

void SafetyMonitor::add(SafetyCondition condition, Message message, std::size_t object) {
    m_present.push_back({condition, object, std::move(message)});
}

const SafetyFinding* SafetyMonitor::activeOne(SafetyCondition condition, std::size_t object) const {
    const auto found = std::ranges::find_if(m_active, [&](const SafetyFinding& finding) {
        return isSame(finding.condition, finding.object, condition, object);
    });
    return found == m_active.end() ? nullptr : &*found;
}

void SafetyMonitor::keepActive(SafetyCondition condition, std::size_t object) {
    if (const SafetyFinding* const active = activeOne(condition, object))
        add(condition, active->message, object);
}

void SafetyMonitor::addObject(std::size_t i, const SafetyObservation& seen) {
    const ObservedObject& object = seen.objects[i];
    addSensor(i, seen);
    addWarming(i, seen);
    addTarget(i, seen);
    addOpinion(i, seen);
    // Readings too fast for heat, but enough in a row to make a fault: the object may have touched the
    // source.
    const bool isRejected = !object.measured_K && object.jump.inARow >= m_experiment.safety.jumps;
    auto seen_K = isRejected ? std::optional(object.jump.min_K) : object.measured_K;
    if (object.opinion) // an object may be hotter than a sensor that came off it
        seen_K = std::max(seen_K.value_or(0.0),
                          object.opinion->camera_K - kOpinionSigmas * object.opinion->uncertainty_K);
    const auto over = [&](Condition condition, MessageCode code, double limit_K) {
        const bool wasOver = isActive(condition, i);
        const double from_K = limit_K - (wasOver ? SafetySpec::kHysteresis_K : 0.0);
        const bool isUnseen = !seen_K && object.max_K > from_K; // its end was not observed
        const bool isBelow = seen_K && *seen_K > from_K && *seen_K <= limit_K;
        if (wasOver && (isUnseen || isBelow)) // below its limit the sentence would be wrong
            keepActive(condition, i);
        else if (seen_K && *seen_K > from_K)
            add(condition, {code, {name(i), roundedTemperatureArg(*seen_K), temperatureArg(limit_K)}}, i);
    };
    over(Condition::ObjectHot, MessageCode::SafetyObjectHot,
         tripLimit_K(m_experiment, m_experiment.objects[i]));
    over(Condition::ObjectWarm, MessageCode::SafetyObjectWarm,
         warningLimit_K(m_experiment, m_experiment.objects[i]));
}

// Two sensors that jump at once, each to what the other has read.
void SafetyMonitor::noteSwaps(const SafetyObservation& seen) {
    const auto isJumping = [&](std::size_t i) {
        return seen.objects[i].jump.inARow >= m_experiment.safety.jumps;
    };
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        if (auto& other = m_objects[i].swappedWith; other && !(isJumping(i) && isJumping(*other)))
            other.reset();
    for (ObjectWatch& object : m_objects)
        object.seemsSwappedWith.reset();
    const auto before_s = std::exchange(m_seemSwapped_s, {});
    if (!isHeated(seen)) // somebody may exchange them by hand
        return;
    const auto hasSensor = [&](std::size_t i) { return m_experiment.objects[i].readBy != ReadBy::Camera; };
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        for (std::size_t j = i + 1; j < m_objects.size(); ++j) {
            if (!hasSensor(i) || !hasSensor(j))
                continue;
            const Jump &one = seen.objects[i].jump, &other = seen.objects[j].jump;
            if (isJumping(i) && isJumping(j) &&
                std::abs(one.began_s - other.began_s) < 0.5 * m_experiment.sampling.period_s &&
                std::abs(one.to_K - other.from_K) <= kSwapped_K &&
                std::abs(other.to_K - one.from_K) <= kSwapped_K) {
                m_objects[i].swappedWith = j;
                m_objects[j].swappedWith = i;
            } else if (const auto& seenAs = m_assignment.exchanged();
                       seenAs && seenAs->one == i && seenAs->other == j) {
                m_objects[i].seemsSwappedWith = j;
                m_objects[j].seemsSwappedWith = i;
            } else if (seemSwapped(i, j)) {
                const auto before = before_s.find({i, j});
                const double since_s = before != before_s.end() ? before->second : seen.now_s;
                m_seemSwapped_s[{i, j}] = since_s;
                if (seen.now_s - since_s < kSeemSwapped_s)
                    continue;
                m_objects[i].seemsSwappedWith = j;
                m_objects[j].seemsSwappedWith = i;
            }
        }
}

/// Whether what both read deviates from their heat, in opposite ways, and would not if it were exchanged.
bool SafetyMonitor::seemSwapped(std::size_t i, std::size_t j) const {
    const WarmingWatch &one = m_objects[i].warming, &other = m_objects[j].warming;
    const auto ofOne_K = one.unexplained_K(one, kPair_s), ofOther_K = other.unexplained_K(other, kPair_s);
    if (!ofOne_K || !ofOther_K || *ofOne_K * *ofOther_K >= 0.0 ||
        std::min(std::abs(*ofOne_K), std::abs(*ofOther_K)) < kDeviating_K)
        return false;
    const auto exchanged_K = one.unexplained_K(other, kPair_s), back_K = other.unexplained_K(one, kPair_s);
    return exchanged_K && back_K && std::max(std::abs(*exchanged_K), std::abs(*back_K)) <= kExplained_K;
}

std::optional<std::size_t> SafetyMonitor::swappedWith(std::size_t object) const {
    if (const auto& found = m_opinion.finding(object); found && found->verdict == OpinionVerdict::Swapped)
        return found->other;
    const ObjectWatch& watch = m_objects.at(object);
    return watch.swappedWith ? watch.swappedWith : watch.seemsSwappedWith;
}

void SafetyMonitor::addSensor(std::size_t i, const SafetyObservation& seen) {
    const ObservedObject& object = seen.objects[i];
    const bool isJumping = object.jump.inARow >= m_experiment.safety.jumps;
    if (const auto other = m_objects[i].swappedWith) {
        const Jump& jump = object.jump;
        const Jump& jumpOfOther = seen.objects[*other].jump;
        if (i < *other)
            add(Condition::SensorsSwapped,
                {MessageCode::SafetySensorsSwapped,
                 {name(i), name(*other), roundedTemperatureArg(jump.to_K),
                  roundedTemperatureArg(jumpOfOther.to_K), roundedTemperatureArg(jump.from_K),
                  roundedTemperatureArg(jumpOfOther.from_K)}},
                i);
        return;
    }
    if (const auto other = m_objects[i].seemsSwappedWith; other && i < *other) {
        const auto& seenAs = m_assignment.exchanged();
        const bool isByCamera = seenAs && seenAs->one == i && seenAs->other == *other;
        add(Condition::SensorsSwapped,
            isByCamera ? Message{MessageCode::SafetySensorsSeenSwapped,
                                 {name(i), name(*other), formatNumber(std::ceil(seenAs->within_s))}}
                       : Message{MessageCode::SafetySensorsSeemSwapped,
                                 {name(i), name(*other), formatNumber(kPair_s)}},
            i);
    }
    if (!object.isKnown || !(object.isLost || isJumping))
        return;
    if (object.jump.inARow > 0)
        add(Condition::SensorJump,
            {MessageCode::SafetySensorJump,
             {name(i), differenceArg(object.jump.rate_K_s, 3), differenceArg(object.largestRate_K_s, 3)}},
            i);
    else if (object.fault == SensorFault::Open)
        add(Condition::SensorOpen, {MessageCode::SafetySensorOpen, {name(i)}}, i);
    else if (object.fault == SensorFault::Short)
        add(Condition::SensorShort, {MessageCode::SafetySensorShort, {name(i)}}, i);
    else if (object.reason.code != MessageCode::None)
        add(Condition::CameraCannotRead, {MessageCode::SafetyCameraCannotRead, {name(i), object.reason}}, i);
    else if (object.isInvalid || !std::isfinite(object.age_s))
        add(Condition::SensorInvalid, {MessageCode::ReasonSensorInvalid, {name(i)}}, i);
    else
        add(Condition::SensorStale,
            {MessageCode::ReasonSensorStale, {name(i), formatNumber(object.age_s, 2)}}, i);
}

double SafetyMonitor::power_K_s(std::size_t i, const SafetyObservation& seen) const {
    const HeatRates& rates = m_objects[i].rates;
    const double fromSource =
        seen.isSourceDark ? 0.0 : rates.lambda1 * seen.sourceStrength * seen.objects[i].viewFactor;
    if (!m_neighbours.exchange())
        return fromSource;
    Eigen::VectorXd excess_K4 = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_objects.size()));
    for (std::size_t j = 0; j < m_objects.size(); ++j)
        if (const auto& measured_K = seen.objects[j].measured_K) // else as one that rests in the room
            excess_K4[static_cast<Eigen::Index>(j)] = std::pow(*measured_K, 4) - m_objects[j].rates.rest_K4();
    return fromSource + rates.lambda2 * m_neighbours.gains_K4(excess_K4)[static_cast<Eigen::Index>(i)];
}

std::vector<double> SafetyMonitor::powers_K_s(const SafetyObservation& seen) const {
    std::vector<double> powers_K_s;
    for (std::size_t i = 0; i < m_objects.size(); ++i)
        powers_K_s.push_back(power_K_s(i, seen));
    return powers_K_s;
}

bool SafetyMonitor::isSensorStill(std::size_t object) const {
    return isActive(Condition::SensorFrozen, object) || isActive(Condition::SensorQuiet, object);
}

void SafetyMonitor::confirmSensor(std::size_t object) {
    ObjectWatch& watch = m_objects.at(object);
    watch.warming.reset();
    watch.frozen.reset();
    watch.frozenAt_K.reset();
    watch.quiet.confirm();
    m_opinion.confirm(object);
    m_assignment.reset();
}

void SafetyMonitor::atRest(const SafetyObservation& seen) {
    m_opinion.atRest();
    m_assignment.reset();
    for (std::size_t i = 0; i < m_objects.size(); ++i) {
        m_objects[i].quiet.confirm(); // because their offsets have changed
        if (!seen.objects[i].measured_K)
            continue;
        m_objects[i].warming.restAt(seen.now_s, *seen.objects[i].measured_K);
        m_objects[i].frozen.restAt(seen.now_s, *seen.objects[i].measured_K);
    }
}

void SafetyMonitor::addOpinion(std::size_t i, const SafetyObservation& seen) {
    if (const Message& why = seen.objects[i].unchecked;
        why.code != MessageCode::None && seen.cameraProblem.code == MessageCode::None && seen.asked_K) {
        if (why.code == MessageCode::ThermalFaceUnusable)
            m_objects[i].unusable_s = seen.now_s;
        add(Condition::CameraCannotCheck, {MessageCode::SafetyCameraCannotCheck, {name(i), why}}, i);
    } else if (seen.asked_K && seen.now_s < m_objects[i].unusable_s + kUnusable_s) {
        keepActive(Condition::CameraCannotCheck, i); // or it would come and go with the pose
    }
    const auto& found = m_opinion.finding(i);
    if (!found)
        return;
    const bool isOfSensor =
        found->verdict != OpinionVerdict::EmittanceOther && found->verdict != OpinionVerdict::CameraDiffers;
    if (isOfSensor && !isHeated(seen)) // during manual work, sensors are taken off
        return;
    if (!isOfSensor && seen.objects[i].isLost) // a sensor that is not trusted has an alarm of its own
        return;
    const MessageArg contact = roundedTemperatureArg(found->seen.contact_K);
    const MessageArg camera = roundedTemperatureArg(found->seen.camera_K);
    const MessageArg within = differenceArg(2.0 * found->seen.uncertainty_K, 2);
    switch (found->verdict) {
    case OpinionVerdict::SensorOff:
        return add(Condition::SensorNotOnObject,
                   {MessageCode::SafetySensorNotOnObject,
                    {name(i), contact, camera, within, formatNumber(std::round(found->agreedAgo_s))}},
                   i);
    case OpinionVerdict::NeverOn:
        return add(Condition::SensorNotOnObject,
                   {MessageCode::SafetySensorNeverOn, {name(i), contact, camera, within}}, i);
    case OpinionVerdict::Swapped:
        return add(Condition::SensorsSwapped,
                   {MessageCode::SafetySensorsSwapped,
                    {name(i), name(found->other), contact, roundedTemperatureArg(found->seenOther.contact_K),
                     camera, roundedTemperatureArg(found->seenOther.camera_K)}},
                   i);
    case OpinionVerdict::EmittanceOther:
        return add(Condition::EmittanceOther,
                   {MessageCode::SafetyEmittanceOther,
                    {name(i), camera, within, contact, formatNumber(found->seen.emittance, 2),
                     formatNumber(m_experiment.objects[i].material.emittance, 2)}},
                   i);
    case OpinionVerdict::CameraDiffers:
        return add(Condition::CameraDisagrees,
                   {MessageCode::SafetyCameraDisagrees, {name(i), camera, within, contact}}, i);
    }
}

/// Whether the sensor's value stays although its object's heat must have changed it. That it stays without
/// its noise is no proof: the noise may come from what stands still now.
bool SafetyMonitor::isFrozen(std::size_t i) const {
    const ObjectWatch& watch = m_objects[i];
    return watch.frozen.missing_K() != 0.0 || (watch.warming.sameFor_s() >= m_experiment.safety.frozen_s &&
                                               watch.warming.unfollowedWhileSame(kWhileSame_K));
}

void SafetyMonitor::addWarming(std::size_t i, const SafetyObservation& seen) {
    const ObservedObject& object = seen.objects[i];
    ObjectWatch& watch = m_objects[i];
    const bool isNew = object.measured_K && object.age_s < 0.5 * m_experiment.sampling.period_s;
    const std::optional<double> new_K = isNew ? object.measured_K : std::nullopt;
    watch.warming.add(seen.now_s, new_K, power_K_s(i, seen), object.uncertainty_K);
    watch.frozen.add(seen.now_s, new_K, power_K_s(i, seen));
    if (isNew)
        watch.quiet.add(seen.now_s, *object.measured_K);
    const bool isOther = object.measured_K && watch.frozenAt_K && *watch.frozenAt_K != *object.measured_K;
    if (isOther || object.jump.inARow > 0) // it gives another value, believed or not
        watch.frozenAt_K.reset();
    if (!watch.frozenAt_K && object.measured_K && isHeated(seen) && isFrozen(i)) {
        watch.frozenAt_K = object.measured_K;
        watch.frozenSince_s = seen.now_s - watch.warming.sameFor_s();
    }
    if (!object.measured_K || watch.frozenAt_K)
        keepActive(Condition::HeatedOtherwise, i); // its end was not observed
    if (watch.frozenAt_K)                          // also while readings are missing
        return add(
            Condition::SensorFrozen,
            {MessageCode::SafetySensorFrozen, {name(i), formatNumber(seen.now_s - watch.frozenSince_s, 3)}},
            i);
    if (!object.measured_K)
        return;
    if (const double quiet_s = watch.quiet.quietFor_s(); quiet_s > 0.0)
        add(Condition::SensorQuiet,
            {MessageCode::SafetySensorQuiet, {name(i), formatNumber(std::floor(quiet_s))}}, i);
    const bool isWatched = isHeated(seen) || isActive(Condition::HeatedOtherwise, i); // else maybe by hand
    const double byHand_K = std::max(kByHand_K, m_experiment.environment_K + kAboveRoom_K);
    const auto& foreign = watch.warming.foreignHeat();
    if (foreign && isWatched)
        add(Condition::HeatedOtherwise,
            {MessageCode::SafetyHeatedOtherwise,
             {name(i), differenceArg(foreign->rate_K_s, 2), differenceArg(foreign->explained_K_s, 2)}},
            i);
    else if (foreign && *object.measured_K > byHand_K) // told only: its limits act, as ever
        add(Condition::HeatedAtRest,
            {MessageCode::SafetyHeatedAtRest,
             {name(i), roundedTemperatureArg(*object.measured_K), differenceArg(foreign->rate_K_s, 2),
              differenceArg(foreign->explained_K_s, 2)}},
            i);
    if (const auto& found = watch.warming.unfollowed(); found && isHeated(seen))
        add(Condition::NotWarming, notFollowing(i, *found), i);
}

void SafetyMonitor::addTarget(std::size_t i, const SafetyObservation& seen) {
    const ObservedObject& object = seen.objects[i];
    ObjectWatch& watch = m_objects[i];
    const bool isHeatReady =
        seen.asked_K && seen.source_K && std::abs(*seen.source_K - *seen.asked_K) < kAtSetPoint_K;
    if (!seen.isControlled || !isHeatReady || object.target_K != watch.target_K) {
        watch.target_K = object.target_K;
        return watch.target.reset();
    }
    if (object.measured_K)
        watch.target.add(seen.now_s, *object.measured_K - object.target_K);
    if (const auto& found = watch.target.leaving())
        add(Condition::TargetLeft,
            {MessageCode::SafetyTargetLeft,
             {name(i), roundedTemperatureArg(object.target_K + found->error_K),
              differenceArg(std::abs(found->error_K), 2), formatNumber(found->for_s, 3)}},
            i);
}

/// Returns an object whose reading is too warm where that of `i` is too cold, or the other way round.
std::optional<std::size_t> SafetyMonitor::deviatingOtherwise(std::size_t i, const Unfollowed& found) const {
    for (std::size_t j = 0; j < m_objects.size(); ++j) {
        const WarmingWatch& other = m_objects[j].warming;
        const double sign = found.missing_K() < 0.0 ? -1.0 : 1.0;
        if (j != i && sign * other.unexplained_K(other, found.time_s).value_or(0.0) >= kDeviating_K)
            return j;
    }
    return std::nullopt;
}

Message SafetyMonitor::notFollowing(std::size_t i, const Unfollowed& found) const {
    const MessageArg expected = differenceArg(found.expected_K, 2), gained = differenceArg(found.gained_K, 2);
    const std::string time = formatNumber(found.time_s, 3);
    if (found.isImpossible)
        return {MessageCode::SafetyBeyondHeat, {name(i), gained, time}};
    if (const auto other = deviatingOtherwise(i, found))
        return {MessageCode::SafetyNotFollowingPair, {name(i), expected, time, gained, name(*other)}};
    if (std::abs(found.gained_K) >= kStayed * std::abs(found.expected_K))
        return {MessageCode::SafetyNotFollowing, {name(i), expected, time, gained}};
    return {MessageCode::SafetyNotWarming, {name(i), expected, time}};
}

void SafetyMonitor::addRobot(const SafetyObservation& seen) {
    const double slow_s =
        std::max(kRobotSlow_s, m_experiment.safety.stalePeriods * m_experiment.sampling.period_s);
    if (seen.robotProblem.code != MessageCode::None)
        add(Condition::RobotLost, seen.robotProblem);
    else if (seen.robotAge_s > slow_s)
        add(Condition::RobotSlow, {MessageCode::RobotSlow, {formatNumber(seen.robotAge_s, 2)}});
    if (seen.robotAlarm.code != MessageCode::None)
        add(Condition::RobotAlarm, seen.robotAlarm);
    if (!seen.isPlaceSure)
        add(Condition::RobotPlaceUnsure, {MessageCode::RobotPlaceUnsure, {}});
    if (const auto& lag = seen.robotLag)
        add(Condition::RobotSluggish,
            {MessageCode::SafetyRobotSluggish,
             {lag->setting, formatNumber(lag->taken_s, 3), formatNumber(lag->planned_s, 3),
              formatNumber(std::ceil(seen.longestRetreat_m / lag->mean_m_s), 6)}});
}

void SafetyMonitor::addSource(const SafetyObservation& seen) {
    const double silent_s =
        std::max(kSourceSilent_s, m_experiment.safety.stalePeriods * m_experiment.sampling.period_s);
    if (seen.sourceProblem.code != MessageCode::None)
        add(Condition::SourceLost, seen.sourceProblem);
    else if (seen.sourceAge_s > silent_s)
        add(Condition::SourceSilent, {MessageCode::SafetySourceSilent, {formatNumber(seen.sourceAge_s, 2)}});
    if (seen.heatOffProblem.code != MessageCode::None)
        add(Condition::HeatNotOff, {MessageCode::SafetyHeatNotOff, {seen.heatOffProblem}});
    if (seen.guardProblem.code != MessageCode::None)
        add(Condition::HeaterGuardGone, seen.guardProblem);
    if (seen.isSourcePoseLost)
        add(Condition::SourcePoseLost, {MessageCode::ReasonSourcePoseLost, {}});
    const double trip_K = sourceTripLimit_K(m_experiment);
    const double from_K = trip_K - (isActive(Condition::SourceHot) ? SafetySpec::kHysteresis_K : 0.0);
    const bool isBelow = seen.source_K && *seen.source_K > from_K && *seen.source_K <= trip_K;
    if (!seen.source_K || isBelow) // its end was not observed, or it is not over yet
        keepActive(Condition::SourceHot);
    if (!seen.source_K)
        return;
    if (*seen.source_K > trip_K)
        add(Condition::SourceHot,
            {MessageCode::SafetySourceHot, {roundedTemperatureArg(*seen.source_K), temperatureArg(trip_K)}});
    if (seen.isManual && seen.isHeatUnwanted && *seen.source_K > m_experiment.environment_K + kHandWarm_K)
        add(Condition::HeatByHand, {MessageCode::SafetyHeatByHand, {temperatureArg(*seen.source_K)}});
}

void SafetyMonitor::addHeating(const SafetyObservation& seen) {
    if (seen.isManual)
        return;
    if (!seen.source_K || seen.sourceProblem.code != MessageCode::None) {
        keepActive(Condition::SourceHeatsUnasked); // its end was not observed
        keepActive(Condition::SourceOver);
        return;
    }
    m_source.add(seen.now_s, *seen.source_K, seen.asked_K);
    if (const auto for_s = m_source.notHeatingFor_s())
        add(Condition::SourceNotHeating,
            {MessageCode::SafetySourceNotHeating,
             {roundedTemperatureArg(*seen.source_K), temperatureArg(seen.asked_K.value_or(0.0)),
              formatNumber(*for_s, 3)}});
    if (const auto over_K = m_source.over_K())
        add(Condition::SourceOver, {MessageCode::SafetySourceOver,
                                    {roundedTemperatureArg(*seen.source_K), differenceArg(*over_K, 3)}});
    if (const auto warming = m_source.heatsUnasked())
        add(Condition::SourceHeatsUnasked,
            {MessageCode::SafetySourceHeatsUnasked,
             {differenceArg(warming->gained_K, 3), formatNumber(warming->time_s, 3),
              differenceArg(m_experiment.safety.sourceUnasked_K)}});
    if (const auto for_s = m_source.notCoolingFor_s(m_experiment.environment_K + kHandWarm_K);
        for_s && seen.isSourceSwitched)
        add(Condition::SourceNotCooling, {MessageCode::SafetySourceNotCooling,
                                          {roundedTemperatureArg(*seen.source_K), formatNumber(*for_s, 3)}});
    addUnit(seen);
    if (seen.asked_K && !seen.hasWatchdog)
        add(Condition::NoWatchdog, {MessageCode::SafetyNoWatchdog, {}});
    if (seen.asked_K && seen.readBack_K && std::abs(*seen.asked_K - *seen.readBack_K) > kSetPointTrifle_K)
        add(Condition::SetPointOther, {MessageCode::SafetySetPointOther,
                                       {temperatureArg(*seen.asked_K), temperatureArg(*seen.readBack_K)}});
}

// A controller that uses another unit or scale than its profile heats far beyond its command, or reports far
// more than the true temperature. No source is colder than the room. A scale shows where the set point is
// read back from another register than it was written to; where it is the same one, both are wrong alike.
void SafetyMonitor::addUnit(const SafetyObservation& seen) {
    if (!seen.asked_K)
        m_asked_K = 0.0;
    if (!seen.isSourceSwitched)
        return;
    const double room_K = m_experiment.environment_K;
    const auto tellsOtherUnit = [&](double told_degC, double meant_K) {
        add(Condition::SourceUnit,
            {MessageCode::SafetySourceUnit, {oneDigit(told_degC), oneDigit(celsiusFromKelvin(meant_K))}});
    };
    if (*seen.source_K < room_K - kColder_K)
        add(Condition::SourceCold,
            {MessageCode::SafetySourceCold,
             {roundedTemperatureArg(*seen.source_K), temperatureArg(room_K), differenceArg(kColder_K)}});
    else if (const auto told_degC = m_source.roomInFahrenheit_degC())
        tellsOtherUnit(*told_degC, room_K);
    if (!seen.asked_K || !seen.readBack_K)
        return;
    const double back_degC = celsiusFromKelvin(*seen.readBack_K);
    if (std::abs(back_degC - displayTemperature(*seen.asked_K, TemperatureUnit::Fahrenheit)) <=
        kSetPointTrifle_K)
        return tellsOtherUnit(back_degC, *seen.asked_K);
    if (std::abs(*seen.asked_K - m_asked_K) > kSetPointTrifle_K) {
        m_asked_K = *seen.asked_K;
        m_askedFrom_s = seen.now_s;
    }
    if (seen.now_s - m_askedFrom_s < kReadBack_s)
        return; // what is read back may be the one before
    const double asked_degC = celsiusFromKelvin(*seen.asked_K);
    for (const double factor : {0.1, 0.5, 2.0, 10.0})
        if (std::abs(back_degC - factor * asked_degC) <= kSameScale * factor * asked_degC &&
            std::abs(back_degC - asked_degC) > kSetPointTrifle_K)
            add(Condition::SourceUnit,
                {MessageCode::SafetySourceScale,
                 {temperatureArg(*seen.asked_K), temperatureArg(*seen.readBack_K), formatNumber(factor)}});
}

void SafetyMonitor::addRig(const SafetyObservation& seen) {
    // A thermometer that answers again in time is fine.
    const bool isThermometerDue = std::ranges::any_of(seen.objects, &ObservedObject::isLost);
    if (seen.thermometerProblem.code != MessageCode::None && isThermometerDue)
        add(Condition::ThermometerLost, seen.thermometerProblem);
    if (seen.cameraProblem.code != MessageCode::None)
        add(Condition::ThermalCameraLost, seen.cameraProblem);
    if (seen.sinceTick_s > m_experiment.sampling.period_s + kLate_s)
        add(Condition::LoopLate,
            {MessageCode::SafetyLoopLate,
             {formatNumber(seen.sinceTick_s - m_experiment.sampling.period_s, 2), formatNumber(kLate_s)}});
    const double disk_MB =
        m_experiment.safety.minDisk_MB * (isActive(Condition::DiskLow) ? kDiskHysteresis : 1.0);
    if (seen.diskFree_MB && *seen.diskFree_MB < disk_MB)
        add(Condition::DiskLow, {MessageCode::SafetyDiskLow,
                                 {formatNumber(std::floor(*seen.diskFree_MB), 6),
                                  formatNumber(m_experiment.safety.minDisk_MB, 6)}});
    addCrossCheck(seen);
}

// Cold objects in front of a cold source all have room temperature; at any other time they may differ.
void SafetyMonitor::addCrossCheck(const SafetyObservation& seen) {
    if (!seen.isSourceDark || seen.now_s - m_lastHeat_s < m_coldAfter_s)
        return;
    std::size_t coldest = 0, hottest = 0;
    for (std::size_t i = 0; i < seen.objects.size(); ++i) {
        if (!seen.objects[i].measured_K)
            return;
        if (*seen.objects[i].measured_K < *seen.objects[coldest].measured_K)
            coldest = i;
        if (*seen.objects[i].measured_K > *seen.objects[hottest].measured_K)
            hottest = i;
    }
    const double apart_K = *seen.objects[hottest].measured_K - *seen.objects[coldest].measured_K;
    if (apart_K > m_experiment.safety.crossCheck_K)
        add(Condition::SensorsApart, {MessageCode::SafetySensorsApart,
                                      {name(hottest), name(coldest), differenceArg(apart_K, 3),
                                       differenceArg(m_experiment.safety.crossCheck_K)}});
}

void SafetyMonitor::raise(const SafetyObservation& seen, SafetyChanges& changes) {
    std::vector<Pending> rising;
    for (SafetyFinding& finding : m_present) {
        const auto isIt = [&](const auto& other) {
            return isSame(other.condition, other.object, finding.condition, finding.object);
        };
        if (const auto active = std::ranges::find_if(m_active, isIt); active != m_active.end()) {
            if (active->condition == finding.condition)
                active->message = finding.message;
            continue;
        }
        const auto before = std::ranges::find_if(m_rising, isIt);
        const double since_s = before != m_rising.end() ? before->since_s : seen.now_s;
        if (seen.now_s - since_s >= alarmEntry(finding.condition).on_s - 1e-9) {
            m_active.push_back(finding);
            changes.raised.push_back(finding);
        } else {
            rising.push_back({finding.condition, finding.object, since_s});
        }
    }
    m_rising = std::move(rising);
}

void SafetyMonitor::end(const SafetyObservation& seen, SafetyChanges& changes) {
    std::vector<Pending> ending;
    std::vector<SafetyFinding> kept;
    for (SafetyFinding& finding : m_active) {
        const auto isIt = [&](const auto& other) {
            return isSame(other.condition, other.object, finding.condition, finding.object);
        };
        if (std::ranges::any_of(m_present, isIt)) {
            kept.push_back(std::move(finding));
            continue;
        }
        const auto before = std::ranges::find_if(m_ending, isIt);
        const double since_s = before != m_ending.end() ? before->since_s : seen.now_s;
        if (seen.now_s - since_s >= alarmEntry(finding.condition).off_s - 1e-9) {
            changes.ended.push_back(std::move(finding));
        } else {
            ending.push_back({finding.condition, finding.object, since_s});
            kept.push_back(std::move(finding));
        }
    }
    m_active = std::move(kept);
    m_ending = std::move(ending);
}

const SafetyFinding* SafetyMonitor::forbidsReset() const {
    const bool isGrave =
        !m_active.empty() && alarmEntry(m_active.front().condition).reaction >= SafetyReaction::Stop;
    return isGrave ? &m_active.front() : nullptr;
}

const SafetyFinding* SafetyMonitor::forbidsArm() const {
    const auto found = std::ranges::find_if(m_active, [](const SafetyFinding& finding) {
        return finding.condition == Condition::ObjectHot || finding.condition == Condition::ObjectWarm ||
               finding.condition == Condition::HeatedOtherwise ||
               finding.condition == Condition::HeatedAtRest;
    });
    return found != m_active.end() ? &*found : nullptr;
}

const SafetyFinding* SafetyMonitor::forbidsResume() const {
    const bool isGrave =
        !m_active.empty() && alarmEntry(m_active.front().condition).reaction >= SafetyReaction::Hold;
    return isGrave ? &m_active.front() : nullptr;
}

std::vector<SafetyMonitor::Delayed> SafetyMonitor::delayed() const {
    std::vector<Delayed> out;
    for (const Pending& rising : m_rising) {
        const double delay_s = alarmEntry(rising.condition).on_s;
        const double in_s = rising.since_s + delay_s - m_now_s;
        const auto finding = std::ranges::find_if(m_present, [&](const SafetyFinding& present) {
            return present.condition == rising.condition && present.object == rising.object;
        });
        if (finding != m_present.end() && in_s <= 0.5 * delay_s)
            out.push_back({*finding, in_s});
    }
    return out;
}

const SafetyFinding* SafetyMonitor::lost() const {
    const auto found = std::ranges::find_if(
        m_active, [](const SafetyFinding& finding) { return alarmEntry(finding.condition).isLoss; });
    return found == m_active.end() ? nullptr : &*found;
}

bool SafetyMonitor::isLostTooLong() const {
    return isLost() && m_now_s - m_lostSince_s > m_experiment.safety.pauseLimit_s;
}

double SafetyMonitor::lostTooLongIn_s() const {
    return m_lostSince_s + m_experiment.safety.pauseLimit_s - m_now_s;
}

const SafetyFinding* SafetyMonitor::lostSensor() const {
    const auto found = std::ranges::find_if(m_active, [](const SafetyFinding& finding) {
        const AlarmEntry& lost = alarmEntry(finding.condition);
        return lost.isLoss && lost.isOfObject;
    });
    return found == m_active.end() ? nullptr : &*found;
}

void SafetyMonitor::forgetLoss() {
    m_lostLast_s = -1e300;
}

double SafetyMonitor::unaskedWarming_K() const {
    const auto warming = m_source.heatsUnasked();
    return warming ? warming->gained_K : 0.0;
}

void SafetyMonitor::restart() {
    m_source.restart();
    for (ObjectWatch& object : m_objects)
        object.warming.reset();
}

} // namespace bask
