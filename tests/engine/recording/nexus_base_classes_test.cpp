// Holds exported files against what NeXus base classes allow, so that whatever is added to the export later
// has its place in one of them.

#include "engine/base/message_code.h"
#include "engine/control/controller_catalogue.h"
#include "engine/exchange/hdf5_file.h"
#include "engine/recording/nexus_file.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <hdf5.h>

namespace bask {
namespace {

enum class Kind { Text, Whole, Real, Number, Any };

struct BaseField {
    Kind kind = Kind::Any;
    const char* unit = "";                ///< Bask's, of the category of units there; empty: any unit
    std::vector<std::string> values = {}; ///< of a text, if the class enumerates them
};

struct BaseClass {
    std::map<std::string, BaseField> fields; ///< "*": under any name
    /// Class and name; without a name: under any.
    std::vector<std::pair<std::string, std::string>> groups = {};
    std::set<std::string> attributes = {};
};

/// What Bask may write of the base classes: fields with their type (NX_CHAR, NX_DATE_TIME and, as text,
/// NX_BINARY are Text; NX_INT and NX_POSINT are Whole; NX_FLOAT is Real), groups, attributes. Taken from
/// base_classes/*.nxdl.xml of github.com/nexusformat/definitions, branch main, commit cf669931 of June 2026.
/// A field that is not here may be added where the class has it.
const std::map<std::string, BaseClass>& baseClasses() {
    const BaseField text{Kind::Text}, time{Kind::Number, "s"}, seconds{Kind::Real, "s"};
    const BaseField kelvin{Kind::Real, "K"}, number{Kind::Number}, any;
    static const std::map<std::string, BaseClass> kClasses{
        {"NXroot",
         {{}, {{"NXentry", ""}}, {"creator", "creator_version", "file_name", "file_time", "HDF5_Version"}}},
        {"NXentry",
         {{{"title", text},
           {"start_time", text},
           {"end_time", text},
           {"duration", {Kind::Whole, "s"}},
           {"collection_time", seconds},
           {"entry_identifier", text},
           {"collection_identifier", text},
           {"program_name", text}},
          {{"NXinstrument", ""}, {"NXsample", ""}, {"NXuser", ""}}}},
        {"NXuser", {{{"name", text}, {"role", text}}}},
        {"NXinstrument", {{{"name", text}}, {{"NXactuator", ""}, {"NXdetector", ""}, {"NXsensor", ""}}}},
        {"NXactuator",
         {{{"name", text}, {"description", text}, {"physical_quantity", text}, {"type", text}},
          {{"NXpid_controller", ""}}}},
        {"NXsensor",
         {{{"name", text},
           {"model", text},
           {"attached_to", text},
           {"measurement", {Kind::Text, "", {"temperature"}}}}}},
        {"NXpid_controller",
         {{{"name", text},
           {"setpoint", {Kind::Real}},
           {"K_p", number},
           {"K_i", number},
           {"K_d", number},
           {"control_action", {Kind::Text, "", {"direct", "reverse"}}}},
          {{"NXsensor", "pv_sensor"}}}},
        {"NXdetector",
         {{{"local_name", text},
           {"description", text},
           {"layout", {Kind::Text, "", {"point", "linear", "area"}}},
           {"bit_depth_readout", {Kind::Whole}},
           {"saturation_value", number},
           {"data", number},
           {"start_time", seconds}}}},
        {"NXsample",
         {{{"name", text},
           {"description", text},
           {"identifier_sample", text}, // identifierNAME of NXobject
           {"type", {Kind::Text, "", {"sample", "simulated data"}}},
           {"temperature", kelvin},
           {"density", {Kind::Real, "kg/m^3"}},
           {"thickness", {Kind::Real, "m"}}},
          {{"NXenvironment", ""}}}},
        {"NXenvironment",
         {{{"name", text}, {"type", text}, {"value", {Kind::Real}}}, {{"NXactuator", ""}, {"NXsensor", ""}}}},
        {"NXlog", {{{"time", time}, {"value", number}, {"description", text}}}},
        {"NXnote",
         {{{"author", text},
           {"type", text},
           {"description", text},
           {"sequence_index", {Kind::Whole}},
           {"data", text}}}},
        {"NXdata", {{{"*", any}}, {}, {"signal", "axes", "auxiliary_signals"}}},
        {"NXparameters", {{{"*", any}}}},
        {"NXcollection", {{{"*", any}}}},
    };
    return kClasses;
}

/// Of every class but NXroot, from NXobject.
constexpr std::array kGroupsOfAll{"NXcollection", "NXdata", "NXlog", "NXnote", "NXparameters"};

class Opened {
public:
    explicit Opened(hid_t id) : m_id(id) {}
    ~Opened() {
        if (m_id >= 0)
            H5Idec_ref(m_id);
    }
    operator hid_t() const { return m_id; }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;

private:
    hid_t m_id;
};

std::set<std::string> attributesOf(hid_t thing) {
    std::set<std::string> names;
    H5Aiterate2(
        thing, H5_INDEX_NAME, H5_ITER_INC, nullptr,
        [](hid_t, const char* name, const H5A_info_t*, void* into) -> herr_t {
            static_cast<std::set<std::string>*>(into)->insert(name);
            return 0;
        },
        &names);
    return names;
}

std::string textAttribute(hid_t thing, const char* name) {
    if (H5Aexists(thing, name) <= 0)
        return "";
    const Opened attribute(H5Aopen(thing, name, H5P_DEFAULT));
    const Opened type(H5Aget_type(attribute));
    std::string text(H5Tget_size(type), '\0');
    H5Aread(attribute, type, text.data());
    return text.c_str();
}

std::vector<std::string> namesIn(hid_t group) {
    H5G_info_t info{};
    H5Gget_info(group, &info);
    std::vector<std::string> names;
    for (hsize_t i = 0; i < info.nlinks; ++i) {
        std::array<char, 256> name{};
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
        names.emplace_back(name.data());
    }
    return names;
}

/// Walks a file by HDF5's own functions and tells what its classes do not have.
class ClassWalk {
public:
    explicit ClassWalk(const std::string& path) {
        const Opened file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
        const Opened root(H5Gopen2(file, "/", H5P_DEFAULT));
        group(root, "");
    }

    std::set<std::string> problems;
    std::set<std::string> classes; ///< that were met

private:
    void group(hid_t here, const std::string& path) {
        const std::string own = textAttribute(here, "NX_class");
        const auto found = baseClasses().find(own);
        if (found == baseClasses().end()) {
            problems.insert(path + " has the class " + own);
            return;
        }
        classes.insert(own);
        const auto isForeign = [&](const std::string& what) { problems.insert(what + " in " + own); };
        const std::string inside = path + '/', at = path + '@';
        for (const std::string& name : attributesOf(here))
            if (!std::set<std::string>{"NX_class", "default", "target"}.contains(name) &&
                !found->second.attributes.contains(name))
                isForeign(at + name);
        for (const std::string& name : namesIn(here)) {
            const Opened thing(H5Oopen(here, name.c_str(), H5P_DEFAULT));
            if (H5Iget_type(thing) == H5I_GROUP) {
                child(thing, path, name, own);
            } else {
                const auto& fields = found->second.fields;
                const auto field = fields.contains(name) ? fields.find(name) : fields.find("*");
                if (field == fields.end())
                    isForeign(inside + name);
                else
                    dataSet(thing, inside + name, field->second);
            }
        }
    }

    void child(hid_t thing, const std::string& path, const std::string& name, const std::string& parent) {
        const std::string its = textAttribute(thing, "NX_class");
        const auto& groups = baseClasses().at(parent).groups;
        const bool isOfAll = parent != "NXroot" && std::ranges::find(kGroupsOfAll, its) != kGroupsOfAll.end();
        const bool isAllowed =
            isOfAll || std::ranges::any_of(groups, [&](const auto& group) {
                return group.first == its && (group.second.empty() || group.second == name);
            });
        if (!isAllowed)
            problems.insert(path + '/' + name + " (" + its + ") in " + parent);
        group(thing, path + '/' + name);
    }

    void dataSet(hid_t set, const std::string& path, const BaseField& field) {
        const Opened type(H5Dget_type(set));
        const H5T_class_t kind = H5Tget_class(type);
        const bool isWhole = kind == H5T_INTEGER, isReal = kind == H5T_FLOAT;
        const bool fits = field.kind == Kind::Text    ? kind == H5T_STRING
                          : field.kind == Kind::Whole ? isWhole
                          : field.kind == Kind::Real  ? isReal
                          : field.kind == Kind::Any   ? true
                                                      : isWhole || isReal;
        if (!fits)
            problems.insert(path + " has another type");
        const std::string unit = textAttribute(set, "units");
        if (*field.unit != '\0' && unit != field.unit)
            problems.insert(path + " is in " + unit);
        if (!field.values.empty() && fits) {
            std::string text(H5Tget_size(type), '\0');
            H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data());
            if (std::ranges::find(field.values, std::string(text.c_str())) == field.values.end())
                problems.insert(path + " is " + text.c_str());
        }
        // The last is an attribute of NeXus for all data, in its manual.
        const std::set<std::string> known{"units", "long_name", "target",
                                          "start", "version",   "interpretation"};
        const std::string at = path + '@';
        for (const std::string& name : attributesOf(set))
            if (!known.contains(name))
                problems.insert(at + name);
    }
};

/// A session with all that a run may have.
SessionRecord fullSession(const std::string& path) {
    Experiment experiment = test::twoDisks();
    experiment.simulation.thermalCamera.emplace().profile = "lepton-3.5";
    experiment.source.uneven.profile = {{0.0, 1.0}, {0.05, 0.8}};
    experiment.air.convection_W_m2K = 8.5;
    auto writer = SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced,
                                        {"A. Hu", "plate 7", "B3"});
    EXPECT_TRUE(writer) << describe(writer.error());
    const ThermalProfile profile = thermalProfile(experiment, true).value();
    for (int k = 0; k < 20; ++k)
        EXPECT_TRUE((*writer)->add(test::madeUpSample(experiment, k)));
    for (int k = 0; k < 2; ++k)
        EXPECT_TRUE((*writer)->add(
            TraceFrame{0.5 + k, std::make_shared<ThermalPicture>(test::madeUpPicture(profile, k))}));
    EXPECT_TRUE((*writer)->add(TraceEvent{0.5, {MessageCode::EventStarted, {}}}));
    EXPECT_TRUE((*writer)->add(CommandRow{0.0, "start", "{}", "A. Hu"}));
    EXPECT_TRUE((*writer)->add(TraceNote{1.5, "a draught", "A. Hu"}));
    EXPECT_TRUE((*writer)->add(TraceNote{2.5, "nobody's", ""}));
    EXPECT_TRUE((*writer)->finish("settled"));
    return readSession(path).value();
}

std::set<std::string> problemsOf(const SessionRecord& session, const std::string& folder) {
    const auto file = exportNexus(session, folder);
    if (!file)
        return {describe(file.error())};
    return ClassWalk(*file).problems;
}

// Catches a field, a group or an attribute that its class does not have, with all controllers and kinds of
// runs.
TEST(NexusBaseClasses, HoldAllThatIsExported) {
    const QTemporaryDir folder;
    const std::string out = folder.path().toStdString();
    SessionRecord session = fullSession(folder.filePath("run.bask").toStdString());
    const std::set<std::string> none;
    for (const ControllerEntry& entry : controllerCatalogue()) {
        session.experiment.controller.kind = entry.kind;
        EXPECT_EQ(problemsOf(session, out), none) << entry.name;
    }
    std::set<std::string> all;
    for (const auto& [name, base] : baseClasses())
        all.insert(name);
    EXPECT_EQ(ClassWalk(out + "/run.nxs").classes, all) << "the session lacks what a run may have";

    session.experiment.air = {std::nullopt, true};
    EXPECT_EQ(problemsOf(session, out), none);
    session.simulated = false; // without a rig: no thermal camera, no pictures
    session.outcome.clear();
    session.finished.clear();
    session.labels = {};
    session.experiment.air = {};
    session.experiment.source.uneven = {};
    session.samples.clear();
    session.notes.clear();
    EXPECT_EQ(problemsOf(session, out), none);
}

// Catches a walk that finds nothing wrong with anything.
TEST(NexusBaseClasses, AWalkTellsWhatTheyDoNotHave) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("bad.nxs");
    {
        Hdf5File file;
        file.attribute("/", "NX_class", "NXroot");
        file.attribute("/", "made_by", "a test");
        file.group("/entry", "NXentry");
        file.text("/entry/outcome", "settled");
        file.text("/entry/title", "right");
        file.attribute("/entry/title", "meaning", "none");
        file.number("/entry/duration", 2.5, "s");
        file.number("/entry/collection_time", 2.5, "min");
        file.group("/entry/instrument", "NXinstrument");
        file.group("/entry/instrument/air", "NXenvironment");
        file.group("/entry/instrument/plate", "NXplate");
        file.group("/entry/instrument/robot", "NXactuator");
        file.group("/entry/instrument/robot/controller_1", "NXpid_controller");
        file.group("/entry/instrument/robot/controller_1/other_sensor", "NXsensor");
        file.text("/entry/instrument/robot/controller_1/control_action", "sideways");
        const auto bytes = file.image("bad.nxs");
        ASSERT_TRUE(bytes);
        QFile out(path);
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        ASSERT_EQ(out.write(QByteArray::fromStdString(*bytes)), static_cast<qint64>(bytes->size()));
    }
    const std::string controller = "/entry/instrument/robot/controller_1";
    EXPECT_EQ(
        ClassWalk(path.toStdString()).problems,
        (std::set<std::string>{"@made_by in NXroot", "/entry/outcome in NXentry", "/entry/title@meaning",
                               "/entry/duration has another type", "/entry/collection_time is in min",
                               "/entry/instrument/air (NXenvironment) in NXinstrument",
                               "/entry/instrument/plate (NXplate) in NXinstrument",
                               "/entry/instrument/plate has the class NXplate",
                               controller + "/other_sensor (NXsensor) in NXpid_controller",
                               controller + "/control_action is sideways"}));
}

} // namespace
} // namespace bask
