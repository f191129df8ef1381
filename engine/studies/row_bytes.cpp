#include "engine/studies/row_bytes.h"

#include "engine/base/json_text.h"
#include "engine/base/message_arg.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <limits>

// How the library is told of types that are not ours.
template <class T> struct nlohmann::adl_serializer<std::optional<T>> {
    static void to_json(json& to, const std::optional<T>& value) { to = value ? json(*value) : json(); }
    static void from_json(const json& from, std::optional<T>& value) {
        value = from.is_null() ? std::nullopt : std::optional<T>(from.get<T>());
    }
};
template <> struct nlohmann::adl_serializer<bask::Vector6d> {
    static void to_json(json& to, const bask::Vector6d& q) {
        to = std::array<double, 6>{q[0], q[1], q[2], q[3], q[4], q[5]};
    }
    static void from_json(const json& from, bask::Vector6d& q) {
        const auto numbers = from.get<std::array<double, 6>>();
        for (int k = 0; k < 6; ++k)
            q[k] = numbers[static_cast<std::size_t>(k)];
    }
};

namespace bask {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClosedLoopCase, seed, mountings, start, goal, targets_K, convection_W_m2K,
                                   sensorLag_s, robotLatency_s, uneven, radiation_s, bound_s, travel_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ClosedLoopRow, drawn, settling_s, overshoot_K, way_m, restSpeed_m_s,
                                   commandAcceleration_m_s2, final_K, toldCompromise, failure)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AlarmRunFacts, controller, objects, source_K, sourceModel, noise_K, lag_s,
                                   convection_W_m2K, readBy, cameraNoise_K, emittanceError, fault, object,
                                   fault_s)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RaisedAlarm, time_s, priority, name, sentence, isConsequence, isFalse)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AlarmStudyRow, drawn, simulated_s, alarms, isTripped, overTrip_K,
                                   overTarget_K, shown_s, told_s, acted_s, unseen_K, apartSoon_K, refusal)

namespace {

/// JSON has no number that is not finite, as the bound of a target that no pose holds: {"not finite": "inf"}.
constexpr const char* kNotFinite = "not finite";

void wrapNotFinite(nlohmann::json& json) {
    if (json.is_number_float() && !std::isfinite(json.get<double>()))
        json = {{kNotFinite, formatNumber(json.get<double>())}};
    else if (json.is_structured())
        for (nlohmann::json& each : json)
            wrapNotFinite(each);
}

void unwrapNotFinite(nlohmann::json& json) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (json.is_object() && json.contains(kNotFinite)) {
        const auto word = json[kNotFinite].get<std::string>();
        json = word == "inf" ? kInfinity : word == "-inf" ? -kInfinity : NAN;
    } else if (json.is_structured()) {
        for (nlohmann::json& each : json)
            unwrapNotFinite(each);
    }
}

template <class Row> std::string textOfRow(const Row& row) {
    nlohmann::json json(row);
    wrapNotFinite(json);
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <class Row> std::optional<Row> rowOf(const std::string& bytes) {
    std::optional<Row> row;
    const Failure failed = readJsonTree(bytes, "row", [&](nlohmann::json json, Failure&) {
        unwrapNotFinite(json);
        row = json.get<Row>();
    });
    return failed ? std::nullopt : row;
}

} // namespace

std::string bytesOf(const ClosedLoopRow& row) {
    return textOfRow(row);
}

std::string bytesOf(const AlarmStudyRow& row) {
    return textOfRow(row);
}

std::optional<ClosedLoopRow> closedLoopRowOf(const std::string& bytes, std::size_t objects) {
    auto row = rowOf<ClosedLoopRow>(bytes);
    if (row && (row->final_K.size() != objects || row->drawn.targets_K.size() != objects ||
                row->drawn.mountings.size() != objects))
        return std::nullopt;
    return row;
}

std::optional<AlarmStudyRow> alarmRowOf(const std::string& bytes) {
    auto row = rowOf<AlarmStudyRow>(bytes);
    if (row &&
        (row->drawn.fault < SimulatedFault::None || static_cast<int>(row->drawn.fault) >= kSimulatedFaults))
        return std::nullopt;
    return row;
}

} // namespace bask
