#include "engine/recording/nexus_writer.h"

#include "engine/base/version.h"
#include "engine/control/controller_catalogue.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/material_library.h"
#include "engine/model/uneven_source.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/simulation_pace.h"

#include <QDateTime>

#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

namespace bask {
namespace {

constexpr const char* kTime = "/entry/temperatures/time";
constexpr const char* kSource = "/entry/instrument/heat_source";
constexpr const char* kSurface = "/entry/instrument/heat_source_surface"; // no sensor may be in an actuator
constexpr const char* kCamera = "/entry/instrument/thermal_camera";
constexpr const char* kPredicted = "the run as it was predicted before Start";
constexpr const char* kPredictedWithBand = "the run as it was predicted before Start; lowest and highest: of "
                                           "runs with other sensor noise, not with other "
                                           "material, air or source";
constexpr const char* kMaker = "Bask " BASK_VERSION;

std::string numbered(const char* stem, std::size_t i) {
    return stem + std::to_string(i + 1);
}

/// With the ends of lines that NXnote wants.
std::string noteText(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\n' && !out.ends_with('\r'))
            out += '\r';
        out += c;
    }
    return out;
}

/// Name, source and date, as far as they are told.
std::string materialWords(const Material& material) {
    const std::string origin = originText(material);
    return origin.empty() ? material.name : material.name + ", " + origin;
}

class NexusWriter {
public:
    NexusWriter(Hdf5File& file, const SessionRecord& session, const std::optional<ThermalPictures>& pictures)
        : m_file(file), m_session(session), m_pictures(pictures) {}

    void write(const std::string& name, const ShareDone& done) {
        const std::size_t objects = m_session.experiment.objects.size();
        ShareCount count(done, 3.0 + 2.0 * static_cast<double>(objects));
        m_file.attribute("/", "creator", kMaker);
        m_file.attribute("/", "NX_class", "NXroot");
        m_file.attribute("/", "default", "entry");
        m_file.attribute("/", "creator_version", BASK_VERSION);
        m_file.attribute("/", "HDF5_Version", Hdf5File::libraryVersion());
        m_file.attribute("/", "file_name", name);
        m_file.attribute("/", "file_time", m_session.created);
        entry();
        plot();
        count.add();
        instrument();
        count.add();
        for (std::size_t i = 0; i < objects; ++i) {
            sample(i);
            count.add(2.0); // about as much as two of the others
        }
        for (std::size_t i = 0; i < objects; ++i)
            controller(i);
        records();
        count.add();
        if (m_pictures)
            thermalPictures(*m_pictures);
    }

private:
    void entry() {
        m_file.group("/entry", "NXentry");
        m_file.attribute("/entry", "default", "temperatures");
        m_file.text("/entry/title", m_session.experiment.title);
        m_file.text("/entry/start_time", m_session.created);
        if (!m_session.finished.empty())
            m_file.text("/entry/end_time", m_session.finished);
        const double duration_s = m_session.samples.empty() ? 0.0 : m_session.samples.back().time_s;
        m_file.wholeNumber("/entry/duration", static_cast<int>(std::lround(duration_s)), "s");
        m_file.number("/entry/collection_time", duration_s, "s");
        m_file.text("/entry/entry_identifier", std::filesystem::path(m_session.path).filename().string());
        m_file.text("/entry/program_name", "Bask");
        m_file.attribute("/entry/program_name", "version", BASK_VERSION);
        run();
        const RunLabels& labels = m_session.labels;
        if (!labels.batch.empty())
            m_file.text("/entry/collection_identifier", labels.batch);
        if (labels.operatorName.empty())
            return;
        m_file.group("/entry/user", "NXuser");
        m_file.text("/entry/user/name", labels.operatorName);
        m_file.text("/entry/user/role", "operator");
    }

    /// What NXentry has no names for.
    void run() {
        const std::string group = "/entry/run";
        m_file.group(group, "NXparameters");
        m_file.text(group + "/simulated", m_session.simulated ? "true" : "false");
        m_file.text(group + "/outcome", m_session.interrupted() ? "interrupted" : m_session.outcome);
        m_file.text(group + "/verification", m_session.verification);
        m_file.text(group + "/recorded_by", m_session.software);
        m_file.text(group + "/time_zero",
                    "Start; start_time is when the recording was opened, at Arm, before it");
        const double last_s = m_session.samples.empty() ? 0.0 : m_session.samples.back().time_s;
        if (const auto pace = simulationPace(m_session, last_s))
            m_file.text(group + "/simulation_pace", paceText(*pace));
    }

    /// Start's time of day, that all times are since; in files of the first versions when it was opened.
    std::string timeZero() const {
        const auto started_s = startedUtc_s(m_session);
        if (!started_s)
            return m_session.created;
        return QDateTime::fromMSecsSinceEpoch(std::llround(1e3 * *started_s))
            .toUTC()
            .toString(Qt::ISODateWithMs)
            .toStdString();
    }

    /// What a NeXus program shows at first; its time is that of all logs.
    void plot() {
        const std::string group = "/entry/temperatures";
        m_file.group(group, "NXdata");
        std::vector<double> times;
        for (const TraceSample& sample : m_session.samples)
            times.push_back(sample.time_s);
        m_file.numbers(kTime, times, "s");
        m_file.attribute(kTime, "long_name", "time since Start (s)");
        m_file.attribute(kTime, "start", timeZero());
        m_file.attribute(kTime, "target", kTime); // NeXus: where the links to it come from
        m_file.attribute(group, "axes", std::vector<std::string>{"time"});
        std::vector<std::string> others;
        for (std::size_t i = 0; i < m_session.experiment.objects.size(); ++i) {
            const std::string set = group + "/" + numbered("measured_", i);
            m_file.numbers(set, values([i](const TraceSample& s) { return s.objects[i].measured_K; }), "K");
            m_file.attribute(set, "target", set);
            m_file.attribute(set, "long_name", m_session.experiment.objects[i].name + ", measured (K)");
            if (i > 0)
                others.push_back(numbered("measured_", i));
        }
        m_file.attribute(group, "signal", "measured_1");
        if (!others.empty())
            m_file.attribute(group, "auxiliary_signals", others);
    }

    template <class Value> std::vector<double> values(const Value& value) const {
        std::vector<double> out;
        out.reserve(m_session.samples.size());
        for (const TraceSample& sample : m_session.samples)
            out.push_back(value(sample));
        return out;
    }

    void beginLog(const std::string& path, const std::string& description) {
        m_file.group(path, "NXlog");
        m_file.link(kTime, path + "/time");
        m_file.text(path + "/description", description);
    }
    template <class Value>
    void log(const std::string& path, const std::string& units, const std::string& description,
             const Value& value) {
        beginLog(path, description);
        m_file.numbers(path + "/value", values(value), units);
    }
    template <class Value>
    void flagLog(const std::string& path, const std::string& description, const Value& value) {
        beginLog(path, description);
        std::vector<int> out;
        for (const TraceSample& sample : m_session.samples)
            out.push_back(static_cast<int>(value(sample)));
        m_file.wholeNumbers(path + "/value", out, "1");
    }

    /// Seven logs: position and unit quaternion.
    template <class Coordinates> void poseLogs(const std::string& group, const Coordinates& coordinates) {
        const auto quaternion = [&](const TraceSample& s) {
            Eigen::Quaterniond q(poseFromCoordinates(coordinates(s)).linear());
            return q.w() < 0.0 ? Eigen::Quaterniond(-q.coeffs()) : q;
        };
        for (int k = 0; k < 3; ++k)
            log(group + "/" + kCoordinateNames[static_cast<std::size_t>(k)], "m",
                "position in the robot's base", [&, k](const TraceSample& s) { return coordinates(s)[k]; });
        log(group + "/qw", "1", "unit quaternion in the robot's base",
            [&](const TraceSample& s) { return quaternion(s).w(); });
        for (int k = 0; k < 3; ++k)
            log(group + "/q" + "xyz"[k], "1", "unit quaternion in the robot's base",
                [&, k](const TraceSample& s) { return quaternion(s).vec()[k]; });
    }

    void instrument() {
        const Experiment& e = m_session.experiment;
        m_file.group("/entry/instrument", "NXinstrument");
        const std::string rig = e.rig && !e.rig->name.empty() ? e.rig->name : "rig";
        m_file.text("/entry/instrument/name", m_session.simulated ? "simulated rig" : rig);

        heatSource(e);

        const std::string robot = "/entry/instrument/robot";
        m_file.group(robot, "NXactuator");
        m_file.text(robot + "/name", "robot");
        m_file.text(robot + "/physical_quantity", "temperature");
        m_file.text(robot + "/description",
                    "moves the objects before the source: their view factors set their heat");
        poseLogs(robot, [](const TraceSample& s) { return s.coordinates; });
        runLogs("robot/");
    }

    void heatSource(const Experiment& e) {
        const std::string source = kSource, surface = kSurface;
        m_file.group(source, "NXactuator");
        m_file.attribute(source, "target", source);
        m_file.text(source + "/name", "heat source");
        m_file.text(source + "/type", "radiating plate");
        m_file.text(source + "/physical_quantity", "temperature");
        const std::string properties = source + "/properties";
        m_file.group(properties, "NXparameters");
        m_file.number(properties + "/set_point", e.source.temperature_K, "K");
        m_file.number(properties + "/emittance", e.source.emittance, "1");
        if (!e.source.uneven.isEven())
            m_file.text(properties + "/unevenness", unevennessWords(e));
        poseLogs(source, [](const TraceSample& s) { return s.source; });

        m_file.group(surface, "NXsensor");
        m_file.attribute(surface, "target", surface);
        m_file.text(surface + "/name", "source");
        m_file.text(surface + "/attached_to", "heat source");
        m_file.text(surface + "/measurement", "temperature");
        runLogs("heat_source_surface/");
    }

    /// What surrounds all objects alike: stated with the first, and linked from the others.
    void surroundings(std::size_t i) {
        const Experiment& e = m_session.experiment;
        if (const std::string group = shared(i, "/surroundings"); !group.empty()) {
            m_file.text(group + "/name", "room: what the objects see besides the source");
            m_file.number(group + "/value", e.environment_K, "K");
        }
        if (!e.air.isKnown())
            return;
        if (const std::string group = shared(i, "/air"); !group.empty())
            air(group, e.air);
    }

    /// Returns the group that the first sample has now; empty for others, which link to it.
    std::string shared(std::size_t i, const char* name) {
        std::string group = "/entry/sample_1" + std::string(name);
        if (i > 0) {
            m_file.link(group, "/entry/" + numbered("sample_", i) + name);
            return {};
        }
        m_file.group(group, "NXenvironment");
        m_file.attribute(group, "target", group);
        return group;
    }

    void air(const std::string& group, const Air& air) {
        m_file.text(group + "/name", "air in the room, as the experiment states it");
        m_file.text(group + "/type",
                    air.isNatural ? "natural convection, by correlation" : "given convection");
        m_file.group(group + "/properties", "NXparameters");
        for (const Parameter<Air>& value : airParameters())
            if (const auto si = value.get(air))
                m_file.number(group + "/properties/" + value.name, *si, siUnit(value.unit));
    }

    /// Columns of the run below a group of the instrument.
    void runLogs(const std::string& group) {
        for (const RunColumn& column : kRunColumns)
            if (column.nexus && std::string(column.nexus->path).starts_with(group))
                columnLog("/entry/instrument", column,
                          [](const TraceSample& s) -> const TraceSample& { return s; });
    }

    template <class Row, class RowOf>
    void columnLog(const std::string& group, const SampleColumn<Row>& column, const RowOf& rowOf) {
        const std::string path = group + '/' + column.nexus->path;
        const auto value = [&](const TraceSample& s) { return column.value.get(rowOf(s)); };
        if (column.isWhole)
            flagLog(path, column.nexus->description, value);
        else
            log(path, siUnit(column.unit), column.nexus->description, value);
    }

    void sample(std::size_t i) {
        const ObjectSpec& object = m_session.experiment.objects[i];
        const std::string group = "/entry/" + numbered("sample_", i);
        m_file.group(group, "NXsample");
        m_file.text(group + "/name", object.name);
        m_file.text(group + "/description", materialWords(object.material));
        m_file.text(group + "/type", m_session.simulated ? "simulated data" : "sample");
        if (!m_session.labels.sample.empty())
            m_file.text(group + "/identifier_sample", m_session.labels.sample);
        m_file.link("/entry/temperatures/" + numbered("measured_", i), group + "/temperature");
        properties(group, object);
        surroundings(i);
        sensors(group, object);
        for (const ObjectColumn& column : kObjectColumns) {
            if (!column.nexus || !m_session.rig().has(column.needs))
                continue;
            if (column.plot == Quantity::Temperature) { // is in NXdata already
                const std::string path = group + '/' + column.nexus->path;
                beginLog(path, column.nexus->description);
                m_file.link("/entry/temperatures/" + numbered("measured_", i), path + "/value");
                continue;
            }
            columnLog(group, column,
                      [i](const TraceSample& s) -> const ObjectSample& { return s.objects[i]; });
        }
    }

    void properties(const std::string& sample, const ObjectSpec& object) {
        const std::string group = sample + "/properties";
        m_file.group(group, "NXparameters");
        for (const Parameter<Material>& value : materialParameters()) {
            const std::string name = value.name;
            const bool isOfSample = name == "density" || name == "thickness"; // what NXsample has names for
            m_file.number((isOfSample ? sample : group) + '/' + name, value.get(object.material).value(),
                          siUnit(value.unit));
            const auto& known = object.material.uncertainties;
            if (const auto found = known.find(name); found != known.end())
                m_file.number(group + '/' + name + "_errors", found->second, siUnit(value.unit));
        }
        m_file.number(group + "/area", shapeArea(object.shape), "m^2");
        const Vector6d& mounting = object.mounting;
        m_file.numbers(group + "/mounting_position", std::span(mounting.data(), 3), "m");
        m_file.numbers(group + "/mounting_angles", std::span(mounting.data() + 3, 3), "rad");
    }

    /// What heats an object and what reads its temperature.
    void sensors(const std::string& sample, const ObjectSpec& object) {
        const std::string environment = sample + "/temperature_env";
        m_file.group(environment, "NXenvironment");
        m_file.text(environment + "/name", "radiation of the heat source");
        m_file.link(kSource, environment + "/heat_source");
        m_file.link(kSurface, environment + "/heat_source_surface");
        const std::string sensor = environment + "/sensor";
        m_file.group(sensor, "NXsensor");
        m_file.attribute(sensor, "target", sensor);
        m_file.text(sensor + "/name", "sensor of " + object.name);
        m_file.text(sensor + "/attached_to", object.name);
        m_file.text(sensor + "/measurement", "temperature");
        const auto profile = thermalProfile(m_session.experiment, m_session.simulated);
        if (!profile)
            return;
        const std::string camera = environment + "/thermal_camera";
        m_file.group(camera, "NXsensor");
        m_file.text(camera + "/name", "thermal camera, read on " + object.name);
        m_file.text(camera + "/model", profile->title);
        m_file.text(camera + "/measurement", "temperature");
    }

    /// The laws are no classic PID: all gains by name, and those that are a PID's by NeXus's names too.
    void controller(std::size_t i) {
        const ControllerSettings& settings = m_session.experiment.controller;
        const std::string group = "/entry/instrument/robot/" + numbered("controller_", i);
        const std::string object = "/entry/" + numbered("sample_", i);
        m_file.group(group, "NXpid_controller");
        m_file.text(group + "/name", settings.kind.key());
        m_file.link(object + "/temperature_env/sensor", group + "/pv_sensor");
        const std::string target = object + "/temperature_target/value";
        m_file.attribute(target, "target", target);
        m_file.link(target, group + "/setpoint");
        m_file.text(group + "/control_action", "direct");
        const ControllerEntry& entry = controllerEntry(settings.kind);
        const std::string gains = group + "/gains";
        m_file.group(gains, "NXparameters");
        m_file.text(gains + "/law", entry.description);
        for (const ControllerGain& gain : entry.gains) {
            const std::string unit = siUnit(gain.facts->unit);
            m_file.number(gains + '/' + gain.facts->name, gain.get(settings), unit);
            if (settings.kind == ControllerKind::ModelBased)
                m_file.number(group + (std::string(gain.facts->name) == "K" ? "/K_p" : "/K_d"),
                              gain.get(settings), unit);
        }
        if (settings.kind == ControllerKind::LevelServo)
            m_file.number(group + "/K_p", 1.0 / settings.levelServo.timeConstant_s, "1/s");
    }

    template <class Rows, class Text>
    void column(const std::string& path, const Rows& rows, const Text& text) {
        std::vector<std::string> out;
        out.reserve(rows.size());
        for (const auto& row : rows)
            out.push_back(text(row));
        m_file.texts(path, out);
    }
    template <class Rows> void table(const std::string& path, const Rows& rows) {
        m_file.group(path, "NXcollection");
        std::vector<double> times;
        times.reserve(rows.size());
        for (const auto& row : rows)
            times.push_back(row.time_s);
        m_file.numbers(path + "/time", times, "s");
    }

    /// Nothing where nothing was predicted.
    void prediction() {
        const std::vector<PredictedSample>& samples = m_session.prediction.samples;
        if (samples.empty())
            return;
        const std::string group = "/entry/prediction";
        m_file.group(group, "NXdata");
        std::vector<double> times;
        for (const PredictedSample& sample : samples)
            times.push_back(sample.time_s);
        m_file.numbers(group + "/time", times, "s");
        m_file.text(group + "/title", m_session.prediction.hasBand() ? kPredictedWithBand : kPredicted);
        m_file.attribute(group, "axes", std::vector<std::string>{"time"});
        m_file.attribute(group, "signal", "temperature_1");
        for (std::size_t i = 0; i < m_session.experiment.objects.size(); ++i) {
            const auto numbers = [&](const char* stem, const auto& of) {
                std::vector<double> values;
                for (const PredictedSample& sample : samples)
                    values.push_back(of(sample).at(i));
                const std::string set = group + '/' + numbered(stem, i);
                m_file.numbers(set, values, "K");
                m_file.attribute(set, "long_name", m_session.experiment.objects[i].name + ", predicted (K)");
            };
            numbers("temperature_", [](const PredictedSample& s) { return s.temperatures_K; });
            if (!m_session.prediction.hasBand())
                continue;
            numbers("lowest_", [](const PredictedSample& s) { return s.lowest_K; });
            numbers("highest_", [](const PredictedSample& s) { return s.highest_K; });
        }
    }

    void records() {
        prediction();
        table("/entry/events", m_session.events);
        column("/entry/events/code", m_session.events,
               [](const TraceEvent& e) { return std::string(messageName(e.message.code)); });
        column("/entry/events/text", m_session.events,
               [](const TraceEvent& e) { return describe(e.message); });
        table("/entry/commands", m_session.commands);
        column("/entry/commands/name", m_session.commands, [](const CommandRow& c) { return c.name; });
        column("/entry/commands/value", m_session.commands, [](const CommandRow& c) { return c.value; });
        column("/entry/commands/operator", m_session.commands,
               [](const CommandRow& c) { return c.operatorName; });
        for (std::size_t i = 0; i < m_session.notes.size(); ++i)
            note(i);
        jsonNote("/entry/experiment", "the experiment as it was at the start",
                 experimentToJson(m_session.experiment));
    }

    void note(std::size_t i) {
        const TraceNote& note = m_session.notes[i];
        const std::string group = "/entry/" + numbered("note_", i);
        m_file.group(group, "NXnote");
        m_file.text(group + "/type", "text/plain");
        m_file.text(group + "/data", noteText(note.text));
        if (!note.operatorName.empty())
            m_file.text(group + "/author", note.operatorName);
        m_file.wholeNumber(group + "/sequence_index", static_cast<int>(i) + 1, "1");
        // Its date is not known, but the time since Start.
        m_file.group(group + "/properties", "NXparameters");
        m_file.number(group + "/properties/time", note.time_s, "s");
    }

    void jsonNote(const std::string& group, const std::string& description, const std::string& json) {
        m_file.group(group, "NXnote");
        m_file.text(group + "/type", "application/json");
        m_file.text(group + "/description", description);
        m_file.text(group + "/data", noteText(json));
    }

    void thermalPictures(const ThermalPictures& pictures) {
        const ThermalProfile& profile = pictures.profile;
        describeCamera(profile);
        m_file.pictures(kNexusPictures, pictures.times_s.size(), profile.height, profile.width);
        m_file.attribute(kNexusPictures, "interpretation", "image");
        m_file.attribute(kNexusPictures, "long_name", "numbers of the thermal camera");
        const std::string times = std::string(kCamera) + "/start_time", plot = "/entry/thermal_pictures";
        m_file.numbers(times, pictures.times_s, "s");
        m_file.attribute(times, "long_name", "time since Start (s)");
        m_file.attribute(times, "start", timeZero());
        m_file.group(plot, "NXdata");
        for (const auto& [there, name] :
             {std::pair(std::string(kNexusPictures), "/data"), {times, "/time"}}) {
            m_file.attribute(there, "target", there);
            m_file.link(there, plot + name);
        }
        // NXdata: apparent temperature in K = (data + data_offset) * data_scaling_factor
        const double scale_K = profile.scale * (profile.unit == CountUnit::Fahrenheit ? 5.0 / 9.0 : 1.0);
        m_file.number(plot + "/data_scaling_factor", scale_K, "K");
        m_file.number(plot + "/data_offset", profile.temperature_K(0.0) / scale_K, "1");
        m_file.attribute(plot, "signal", "data");
        m_file.attribute(plot, "axes", std::vector<std::string>{"time", ".", "."});
    }

    void describeCamera(const ThermalProfile& profile) {
        const std::string camera = kCamera;
        m_file.group(camera, "NXdetector");
        m_file.text(camera + "/local_name", profile.name);
        m_file.text(camera + "/description", profile.title);
        m_file.text(camera + "/layout", "area");
        m_file.wholeNumber(camera + "/bit_depth_readout", profile.bits, "1");
        m_file.wholeNumber(camera + "/saturation_value", (1 << profile.bits) - 1, "1");
        jsonNote(camera + "/profile", "the camera's profile: what its numbers mean",
                 thermalProfileToJson(profile));
    }

    Hdf5File& m_file;
    const SessionRecord& m_session;
    const std::optional<ThermalPictures>& m_pictures;
};

} // namespace

void writeNexus(Hdf5File& file, const SessionRecord& session, const std::string& name,
                const std::optional<ThermalPictures>& pictures, const ShareDone& done) {
    NexusWriter(file, session, pictures).write(name, done);
}

} // namespace bask
