#include "engine/monitor/monitor_status.h"

#include "engine/base/message_code.h"
#include "engine/base/program_part.h"
#include "engine/base/units.h"
#include "engine/base/version.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>

#include <unistd.h>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kStates{RunState::Idle,    RunState::NotReady, RunState::Ready,   RunState::Armed,
                             RunState::Running, RunState::Settled,  RunState::Holding, RunState::Stopping,
                             RunState::Stopped, RunState::Fault};

/// ISO 8601 with milliseconds.
std::string utcText(double utc_s) {
    const auto whole = static_cast<std::time_t>(std::floor(utc_s));
    std::tm parts{};
    ::gmtime_r(&whole, &parts);
    std::array<char, 40> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts);
    std::snprintf(text.data() + length, text.size() - length, ".%03dZ",
                  static_cast<int>(1e3 * (utc_s - static_cast<double>(whole))));
    return text.data();
}

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json celsius(double kelvin) {
    return number(celsiusFromKelvin(kelvin));
}

Json celsius(const std::optional<double>& kelvin) {
    return kelvin ? celsius(*kelvin) : Json(nullptr);
}

/// Whether the source was found to warm with its heat off, also where its device is not heard any more.
bool heatsUnasked(const Snapshot& snapshot) {
    return snapshot.heat != HeatState::On && isActive(snapshot.alarms, MessageCode::SafetySourceHeatsUnasked);
}

const char* heatWord(const Snapshot& snapshot) {
    switch (snapshot.heat) {
    case HeatState::On:
        return "on";
    case HeatState::Off:
        return heatsUnasked(snapshot) ? "unasked" : "off";
    default:
        return "unknown";
    }
}

const char* wordOf(PlaceState place) {
    switch (place) {
    case PlaceState::Sure:
        return "sure";
    case PlaceState::Unsure:
        return "unsure";
    case PlaceState::Unknown:
        break;
    }
    return "unknown";
}

const char* wordOf(SensorTrust trust) {
    switch (trust) {
    case SensorTrust::Trusted:
        return "trusted";
    case SensorTrust::Stale:
        return "stale";
    case SensorTrust::Distrusted:
        break;
    }
    return "distrusted";
}

template <class Values, class T> T at(const Values& values, std::size_t i, T missing) {
    return i < values.size() ? T(values[i]) : missing;
}

ObjectSample objectOf(const Snapshot& snapshot, std::size_t i) {
    ObjectSample unknown;
    unknown.measured_K = unknown.estimated_K = unknown.viewFactor = std::nan("");
    return at(snapshot.latest.objects, i, unknown);
}

Json objectsJson(const Snapshot& s) {
    Json out = Json::array();
    for (std::size_t i = 0; i < s.objects.size(); ++i) {
        const ObjectSample object = objectOf(s, i);
        out.push_back({{"name", s.objects[i]},
                       {"target_C", celsius(at(s.targets_K, i, std::nan("")))},
                       {"measured_C", celsius(object.measured_K)},
                       {"estimated_C", celsius(object.estimated_K)},
                       {"view_factor", number(object.viewFactor)},
                       {"sensor", wordOf(at(s.sensors, i, SensorTrust::Stale))},
                       {"age_s", number(at(s.readingAges_s, i, std::nan("")))}});
    }
    return out;
}

Json alarmsOf(const Snapshot& snapshot) {
    Json out = Json::array();
    for (const Alarm& alarm : snapshot.alarms)
        out.push_back({{"priority", alarm.priority},
                       {"code", messageName(alarm.message.code)},
                       {"text", describe(alarm.message)},
                       {"active", alarm.isActive},
                       {"acknowledged", alarm.isAcknowledged},
                       {"seen_by", alarm.seenBy},
                       {"raised", utcText(alarm.raised_s)}});
    return out;
}

std::string lineOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Samples of one metric.
class Metric {
public:
    Metric(std::string& out, const char* name, const char* type, const char* help)
        : m_out(out), m_name(name) {
        out += std::string("# HELP bask_") + name + ' ' + help + "\n# TYPE bask_" + name + ' ' + type + '\n';
    }
    /// `labels` in pairs of name and value.
    Metric& add(double value, const std::vector<std::pair<const char*, std::string>>& labels = {}) {
        m_out += std::string("bask_") + m_name;
        for (std::size_t k = 0; k < labels.size(); ++k)
            m_out +=
                std::string(k == 0 ? "{" : ",") + labels[k].first + "=\"" + escaped(labels[k].second) + '"';
        m_out += labels.empty() ? " " : "} ";
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), "%.15g", value);
        m_out += std::isnan(value)   ? "NaN"
                 : std::isinf(value) ? (value > 0.0 ? "+Inf" : "-Inf")
                                     : text.data();
        m_out += '\n';
        return *this;
    }

private:
    static std::string escaped(const std::string& text) {
        std::string out;
        for (const char letter : text)
            if (letter == '\n')
                out += "\\n";
            else
                out += letter == '"' || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
        return out;
    }

    std::string& m_out;
    const char* m_name;
};

void addObjects(std::string& out, const Snapshot& s) {
    const auto add = [&](const char* name, const char* help, auto value) {
        Metric metric(out, name, "gauge", help);
        for (std::size_t i = 0; i < s.objects.size(); ++i)
            metric.add(value(i), {{"object", s.objects[i]}});
    };
    add("object_target_celsius", "Target of an object.",
        [&](std::size_t i) { return celsiusFromKelvin(at(s.targets_K, i, std::nan(""))); });
    add("object_measured_celsius", "Newest reading of an object.",
        [&](std::size_t i) { return celsiusFromKelvin(objectOf(s, i).measured_K); });
    add("object_estimated_celsius", "Estimated temperature of an object.",
        [&](std::size_t i) { return celsiusFromKelvin(objectOf(s, i).estimated_K); });
    add("object_view_factor", "View factor from an object to the source.",
        [&](std::size_t i) { return objectOf(s, i).viewFactor; });
    add("object_reading_age_seconds", "Age of an object's newest accepted reading.",
        [&](std::size_t i) { return at(s.readingAges_s, i, std::nan("")); });
    add("object_sensor_trusted", "1: the sensor of the object is trusted.", [&](std::size_t i) {
        return s.sensors.size() > i && s.sensors[i] == SensorTrust::Trusted ? 1.0 : 0.0;
    });
}

} // namespace

std::string statusJson(const MonitorStatus& status) {
    const Snapshot& s = status.snapshot;
    Json reasons = Json::array();
    for (const Message& reason : s.reasons)
        reasons.push_back(describe(reason));
    Json pending;
    if (s.pending)
        pending = {{"action", describe(s.pending->action)},
                   {"cause", describe(s.pending->cause)},
                   {"in_s", number(s.pending->in_s)}};
    Json coordinates;
    if (s.place != PlaceState::Unknown)
        for (int k = 0; k < 6; ++k)
            coordinates[std::array{"x_m", "y_m", "z_m", "theta_x_rad", "theta_y_rad",
                                   "theta_z_rad"}[static_cast<std::size_t>(k)]] =
                number(s.latest.coordinates[k]);
    return lineOf(
        {{"format", "bask-status"},
         {"version", 1},
         {"time", utcText(status.utc_s)},
         {"software", "Bask " BASK_VERSION},
         {"host", hostName()},
         {"simulated", s.simulated},
         {"closed", status.isClosed},
         {"state", runStateName(s.state)},
         {"reasons", reasons},
         {"pending", pending},
         {"run_time_s", number(s.runTime_s)},
         {"experiment", s.experiment},
         {"operator", s.labels.operatorName},
         {"sample", s.labels.sample},
         {"batch", s.labels.batch},
         {"recording", s.recordingPath},
         {"recorded_samples", s.recordedRows},
         {"late_steps", s.lateSteps},
         {"source",
          {{"temperature_C", celsius(s.source_K)},
           {"age_s", number(s.sourceAge_s)},
           {"heat", heatWord(s)},
           {"set_point_C", celsius(s.heatSetPoint_K)}}},
         {"robot", {{"place", wordOf(s.place)}, {"moves", s.isMoving}, {"coordinates", coordinates}}},
         {"objects", objectsJson(s)},
         {"alarms", alarmsOf(s)}});
}

std::string alarmsJson(const MonitorStatus& status) {
    return lineOf(alarmsOf(status.snapshot));
}

std::string eventJson(const MonitorEvent& event) {
    const Message& message = event.event.message;
    return lineOf({{"time", utcText(event.utc_s)},
                   {"run_time_s", number(event.event.time_s)},
                   {"code", messageName(message.code)},
                   {"text", describe(message)},
                   {"priority", alarmPriority(message.code)}});
}

std::string statusMetrics(const MonitorStatus& status) {
    const Snapshot& s = status.snapshot;
    std::string out;
    Metric(out, "up", "gauge", "1 while Bask runs; 0 after it was closed.").add(status.isClosed ? 0.0 : 1.0);
    Metric(out, "time_seconds", "gauge", "When the engine told this, seconds since 1970 UTC.")
        .add(status.utc_s);
    Metric(out, "info", "gauge", "What runs, in the labels.")
        .add(1.0, {{"version", BASK_VERSION},
                   {"experiment", s.experiment},
                   {"operator", s.labels.operatorName},
                   {"sample", s.labels.sample},
                   {"batch", s.labels.batch}});
    Metric state(out, "state", "gauge", "1 for the state of the run.");
    for (const RunState each : kStates)
        state.add(each == s.state ? 1.0 : 0.0, {{"state", runStateName(each)}});
    Metric(out, "simulated", "gauge", "1: the rig is simulated.").add(s.simulated ? 1.0 : 0.0);
    Metric(out, "run_time_seconds", "gauge", "Time since Start.").add(s.runTime_s);
    Metric(out, "recorded_samples", "gauge", "Samples of the recording that are safe on the disk.")
        .add(static_cast<double>(s.recordedRows));
    Metric(out, "late_steps_total", "counter", "Control steps that were late or lost.")
        .add(static_cast<double>(s.lateSteps));
    Metric(out, "source_celsius", "gauge", "Newest temperature of the source.")
        .add(s.source_K ? celsiusFromKelvin(*s.source_K) : std::nan(""));
    Metric(out, "heat_on", "gauge", "1: heat is commanded, or not yet confirmed off.")
        .add(s.heatOn ? 1.0 : 0.0);
    Metric(out, "heats_unasked", "gauge",
           "1: the source warms although its device says that its heat is off.")
        .add(heatsUnasked(s) ? 1.0 : 0.0);
    Metric alarms(out, "alarms", "gauge", "Alarms that are not acknowledged, by priority.");
    for (int priority = 1; priority <= 3; ++priority)
        alarms.add(static_cast<double>(std::ranges::count_if(s.alarms,
                                                             [=](const Alarm& alarm) {
                                                                 return alarm.priority == priority &&
                                                                        !alarm.isAcknowledged;
                                                             })),
                   {{"priority", std::to_string(priority)}});
    addObjects(out, s);
    return out;
}

} // namespace bask
