#include "engine/recording/nexus_file.h"

#include "engine/base/message_code.h"
#include "engine/base/version.h"
#include "engine/control/controller_catalogue.h"
#include "engine/exchange/hdf5_file.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/uneven_source.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/staged_files.h"
#include "engine/recording/thermal_frames.h"
#include "engine/thermography/frame_picture_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <span>

namespace bask {
namespace {

constexpr const char* kTime = "/entry/temperatures/time";
constexpr const char* kCamera = "/entry/instrument/thermal_camera";
constexpr const char* kPictures = "/entry/instrument/thermal_camera/data";
constexpr const char* kMaker = "Bask " BASK_VERSION;
constexpr std::size_t kMarkWithin = 8192; // bytes from the start: the root's attributes are written first

std::string numbered(const char* stem, std::size_t i) {
    return stem + std::to_string(i + 1);
}

/// The recorded pictures of a session, but for their pixels.
struct ThermalPictures {
    ThermalProfile profile;
    std::vector<double> times_s;
};

class NexusWriter {
public:
    NexusWriter(Hdf5File& file, const SessionRecord& session, const std::optional<ThermalPictures>& pictures)
        : m_file(file), m_session(session), m_pictures(pictures) {}

    void write() {
        m_file.attribute("/", "creator", kMaker);
        m_file.attribute("/", "NX_class", "NXroot");
        m_file.attribute("/", "default", "entry");
        m_file.attribute("/", "file_time", m_session.created);
        entry();
        plot();
        instrument();
        for (std::size_t i = 0; i < m_session.experiment.objects.size(); ++i)
            sample(i);
        for (std::size_t i = 0; i < m_session.experiment.objects.size(); ++i)
            controller(i);
        records();
        if (m_pictures)
            thermalPictures(*m_pictures);
    }

private:
    void entry() {
        m_file.group("/entry", "NXentry");
        m_file.attribute("/entry", "default", "temperatures");
        m_file.text("/entry/title", m_session.experiment.title);
        m_file.text("/entry/start_time", m_session.created);
        m_file.attribute("/entry/start_time", "meaning",
                         "when the recording was opened, at Arm; times of logs count from Start");
        m_file.number("/entry/duration", m_session.samples.empty() ? 0.0 : m_session.samples.back().time_s,
                      "s");
        m_file.text("/entry/entry_identifier", std::filesystem::path(m_session.path).filename().string());
        m_file.text("/entry/program_name", "Bask");
        m_file.attribute("/entry/program_name", "recorded_by", m_session.software);
        m_file.attribute("/entry/program_name", "exported_by", kMaker);
        m_file.text("/entry/simulated", m_session.simulated ? "true" : "false");
        m_file.text("/entry/outcome", m_session.interrupted() ? "interrupted" : m_session.outcome);
        const RunLabels& labels = m_session.labels;
        if (!labels.batch.empty())
            m_file.text("/entry/collection_identifier", labels.batch);
        if (labels.operatorName.empty())
            return;
        m_file.group("/entry/user", "NXuser");
        m_file.text("/entry/user/name", labels.operatorName);
        m_file.text("/entry/user/role", "operator");
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
        m_file.attribute(kTime, "start", m_session.created);
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

        const std::string source = "/entry/instrument/heat_source";
        m_file.group(source, "NXenvironment");
        m_file.text(source + "/name", "heat source");
        m_file.text(source + "/type", "radiating plate");
        m_file.number(source + "/set_point", e.source.temperature_K, "K");
        m_file.number(source + "/emittance", e.source.emittance, "1");
        if (!e.source.uneven.isEven())
            m_file.text(source + "/unevenness", unevennessWords(e));
        m_file.number(source + "/surroundings", e.environment_K, "K");
        m_file.group(source + "/surface", "NXsensor");
        m_file.text(source + "/surface/name", "source");
        m_file.text(source + "/surface/measurement", "temperature");
        runLogs("heat_source/");
        poseLogs(source, [](const TraceSample& s) { return s.source; });

        if (e.air.isKnown())
            air(e.air);

        const std::string robot = "/entry/instrument/robot";
        m_file.group(robot, "NXactuator");
        m_file.text(robot + "/name", "robot");
        m_file.text(robot + "/physical_quantity", "temperature");
        m_file.text(robot + "/description",
                    "moves the objects before the source: their view factors set their heat");
        poseLogs(robot, [](const TraceSample& s) { return s.coordinates; });
        runLogs("robot/");
    }

    void air(const Air& air) {
        const std::string group = "/entry/instrument/air";
        m_file.group(group, "NXenvironment");
        m_file.text(group + "/name", "air in the room, as the experiment states it");
        m_file.text(group + "/type",
                    air.isNatural ? "natural convection, by correlation" : "given convection");
        for (const Parameter<Air>& value : airParameters())
            if (const auto si = value.get(air))
                m_file.number(group + '/' + value.name, *si, siUnit(value.unit));
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
        m_file.text(group + "/description", object.material.name);
        if (!m_session.labels.sample.empty())
            m_file.text(group + "/sample_id", m_session.labels.sample);
        for (const Parameter<Material>& value : materialParameters())
            m_file.number(group + '/' + value.name, value.get(object.material).value(), siUnit(value.unit));
        m_file.number(group + "/area", shapeArea(object.shape), "m^2");
        const Vector6d& mounting = object.mounting;
        m_file.numbers(group + "/mounting_position", std::span(mounting.data(), 3), "m");
        m_file.numbers(group + "/mounting_angles", std::span(mounting.data() + 3, 3), "rad");

        const std::string environment = group + "/temperature_env";
        m_file.group(environment, "NXenvironment");
        m_file.text(environment + "/name", "radiation of the heat source");
        const std::string sensor = environment + "/sensor";
        m_file.group(sensor, "NXsensor");
        m_file.attribute(sensor, "target", sensor);
        m_file.text(sensor + "/name", "sensor of " + object.name);
        m_file.text(sensor + "/attached_to", object.name);
        m_file.text(sensor + "/measurement", "temperature");
        if (m_session.rig().hasThermalCamera) {
            const std::string camera = group + "/thermal_camera";
            m_file.group(camera, "NXsensor");
            m_file.text(camera + "/name", "thermal camera, read on " + object.name);
            m_file.text(camera + "/measurement", "temperature");
        }
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

    /// The laws are no classic PID: the terms that there are, by what they act on, and the rest by name.
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
        m_file.text(group + "/description", entry.description);
        for (const ControllerGain& gain : entry.gains)
            m_file.number(group + '/' + pidName(settings.kind, gain.facts->name), gain.get(settings),
                          siUnit(gain.facts->unit));
        if (settings.kind == ControllerKind::LevelServo)
            m_file.number(group + "/K_p", 1.0 / settings.levelServo.timeConstant_s, "1/s");
    }

    /// NeXus has names of its own for the terms of a PID.
    static std::string pidName(ControllerKind kind, const std::string& name) {
        if (kind != ControllerKind::ModelBased)
            return name;
        return name == "K" ? "K_p" : "K_d";
    }

    template <class Rows, class Text>
    void column(const std::string& path, const Rows& rows, const Text& text) {
        std::vector<std::string> out;
        for (const auto& row : rows)
            out.push_back(text(row));
        m_file.texts(path, out);
    }
    template <class Rows> void table(const std::string& path, const Rows& rows) {
        m_file.group(path, "NXcollection");
        std::vector<double> times;
        for (const auto& row : rows)
            times.push_back(row.time_s);
        m_file.numbers(path + "/time", times, "s");
    }

    void records() {
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
        for (std::size_t i = 0; i < m_session.notes.size(); ++i) {
            const std::string note = "/entry/" + numbered("note_", i);
            m_file.group(note, "NXnote");
            m_file.text(note + "/type", "text/plain");
            m_file.text(note + "/data", m_session.notes[i].text);
            if (!m_session.notes[i].operatorName.empty())
                m_file.text(note + "/author", m_session.notes[i].operatorName);
            m_file.number(note + "/time", m_session.notes[i].time_s, "s");
        }
        m_file.group("/entry/experiment", "NXnote");
        m_file.text("/entry/experiment/type", "application/json");
        m_file.text("/entry/experiment/description", "the experiment as it was at the start");
        m_file.text("/entry/experiment/data", experimentToJson(m_session.experiment));
    }

    void thermalPictures(const ThermalPictures& pictures) {
        describeCamera(pictures.profile);
        m_file.pictures(kPictures, pictures.times_s.size(), pictures.profile.height, pictures.profile.width);
        m_file.attribute(kPictures, "interpretation", "image");
        m_file.attribute(kPictures, "long_name", "numbers of the thermal camera");
        m_file.attribute(kPictures, "meaning", "apparent temperature in K = data * scaling_factor + offset");
        const std::string camera = kCamera, plot = "/entry/thermal_pictures";
        m_file.numbers(camera + "/time", pictures.times_s, "s");
        m_file.attribute(camera + "/time", "long_name", "time since Start (s)");
        m_file.attribute(camera + "/time", "start", m_session.created);
        m_file.group(plot, "NXdata");
        for (const char* name : {"/data", "/time", "/scaling_factor", "/offset"}) {
            m_file.attribute(camera + name, "target", camera + name);
            m_file.link(camera + name, plot + name);
        }
        m_file.attribute(plot, "signal", "data");
        m_file.attribute(plot, "axes", std::vector<std::string>{"time", ".", "."});
    }

    void describeCamera(const ThermalProfile& profile) {
        const std::string camera = kCamera;
        m_file.group(camera, "NXdetector");
        m_file.text(camera + "/local_name", profile.name);
        m_file.text(camera + "/description", profile.title);
        m_file.number(camera + "/bit_depth_readout", profile.bits, "1");
        m_file.number(camera + "/saturation_value", (1 << profile.bits) - 1, "1");
        m_file.number(camera + "/scaling_factor",
                      profile.scale * (profile.unit == CountUnit::Fahrenheit ? 5.0 / 9.0 : 1.0), "K");
        m_file.number(camera + "/offset", profile.temperature_K(0.0), "K");
        m_file.group(camera + "/profile", "NXnote");
        m_file.text(camera + "/profile/type", "application/json");
        m_file.text(camera + "/profile/description", "the camera's profile: what its numbers mean");
        m_file.text(camera + "/profile/data", thermalProfileToJson(profile));
    }

    Hdf5File& m_file;
    const SessionRecord& m_session;
    const std::optional<ThermalPictures>& m_pictures;
};

/// Refuses a file that is there, not empty and not of exportNexus.
Result<void> checkOwn(const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed) || (std::filesystem::file_size(path, failed) == 0 && !failed))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string start(kMarkWithin, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!start.starts_with("\x89HDF") || start.find("Bask ") == std::string::npos)
        return Error(MessageCode::OutputForeign, path, {"a NeXus file written by Bask"});
    return {};
}

/// Empty where none was recorded.
Result<std::optional<ThermalPictures>> recordedPictures(const SessionRecord& session) {
    const auto profile = thermalProfile(session.experiment, session.simulated);
    if (!profile)
        return std::optional<ThermalPictures>();
    auto times_s = thermalFrameTimes(session.path);
    if (!times_s)
        return times_s.error();
    return times_s->empty() ? std::optional<ThermalPictures>()
                            : std::optional(ThermalPictures{*profile, std::move(*times_s)});
}

/// Fills the pictures of the file at `path`, which will be `target`.
Result<void> fillPictures(const std::string& session, const ThermalPictures& pictures,
                          const std::string& path, const std::string& target) {
    Hdf5Pictures file(path, kPictures);
    std::size_t count = 0;
    Result<void> done;
    const auto read = readThermalFrames(session, [&](double, const std::string& png) {
        if (!done || count == pictures.times_s.size()) // later ones of a session that is being recorded
            return;
        ++count;
        const auto counts = countsOfImage(png, pictures.profile, session);
        if (counts)
            file.add(counts->counts);
        else
            done = counts.error();
    });
    if (done)
        done = read;
    return done ? file.close(target) : done;
}

} // namespace

Result<std::string> exportNexus(const SessionRecord& session, const std::string& folder) {
    auto files = StagedFiles::into(folder);
    if (!files)
        return files.error();
    const std::string name = std::filesystem::path(session.path).stem().string() + ".nxs";
    const std::string target = files->target(name);
    if (auto place = checkOwn(target); !place)
        return place.error();
    const auto pictures = recordedPictures(session);
    if (!pictures)
        return pictures.error();
    std::string bytes;
    {
        Hdf5File file;
        NexusWriter(file, session, *pictures).write();
        auto image = file.image(target);
        if (!image)
            return image.error();
        bytes = std::move(*image);
    }
    auto written = files->write(name, bytes);
    if (written && *pictures)
        written = fillPictures(session.path, **pictures, files->staged(name), target);
    if (written)
        written = addCrate(*files, session);
    if (!written)
        return written.error();
    auto done = files->commit();
    return done ? Result<std::string>(done->front()) : done.error();
}

} // namespace bask
