// The tables of parameters against what walks them: files, checks, the question about limits, the documents.

#include "engine/base/typed_unit.h"
#include "engine/control/controller_catalogue.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/limits_widened.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>

namespace bask {
namespace {

Experiment example() {
    Experiment e = readExperiment(BASK_EXAMPLES "/two-circles.json").value();
    e.objects[0].estimatedRates = HeatRates{0.2, 1e-11, 0.1};
    e.simulation.camera.rate_Hz = 25.0; // so that it is written
    e.simulation.thermalCamera.emplace();
    e.source.uneven.parts.emplace_back().shape = Disk{0.05};
    e.simulation.sourceUneven.emplace().profile.push_back({0.05});
    e.vision.markers.emplace_back();
    e.vision.camera = CameraModel{640, 480, 800.0, 801.0, 319.5, 239.5, {}, {}, {}, {}, {}};
    return e;
}

/// A parameter of an experiment, with the path of its part in the file.
struct Placed {
    std::string path; ///< with a dot at the end
    const ParameterFacts* facts;
    bool isWhole, isOptional;
    std::function<std::optional<double>(const Experiment&)> get;
    std::function<void(Experiment&, std::optional<double>)> set;
};

template <class Spec, class Part>
void place(std::vector<Placed>& out, const std::string& path, ParameterTable<Spec> table, Part part) {
    for (const Parameter<Spec>& p : table)
        out.push_back({path, &p, p.isWhole(), p.isOptional(),
                       [&p, part](const Experiment& e) { return p.get(part(const_cast<Experiment&>(e))); },
                       [&p, part](Experiment& e, std::optional<double> si) { p.set(part(e), si); }});
}

std::vector<Placed> everyParameter() {
    std::vector<Placed> out;
    place(
        out, "safety.", safetyParameters(), [](Experiment & e) -> auto& { return e.safety; });
    place(
        out, "objects[0].", objectLimitParameters(), [](Experiment & e) -> auto& { return e.objects[0]; });
    place(
        out, "objects[0].material.", materialParameters(),
        [](Experiment & e) -> auto& { return e.objects[0].material; });
    place(
        out, "objects[0].believed_rates.", heatRateParameters(),
        [](Experiment & e) -> auto& { return *e.objects[0].estimatedRates; });
    place(
        out, "air.", airParameters(), [](Experiment & e) -> auto& { return e.air; });
    place(
        out, "source.", sourceParameters(), [](Experiment & e) -> auto& { return e.source; });
    place(
        out, "vision.markers[0].", markerParameters(),
        [](Experiment & e) -> auto& { return e.vision.markers[0]; });
    place(
        out, "source.parts[0].", sourcePartParameters(),
        [](Experiment & e) -> auto& { return e.source.uneven.parts[0]; });
    place(
        out, "simulation.source_profile[0].", profilePointParameters(),
        [](Experiment & e) -> auto& { return e.simulation.sourceUneven->profile[0]; });
    place(
        out, "robot.", robotParameters(), [](Experiment & e) -> auto& { return e.robot; });
    place(
        out, "controller.", controllerParameters(), [](Experiment & e) -> auto& { return e.controller; });
    place(
        out, "sampling.", samplingParameters(), [](Experiment & e) -> auto& { return e.sampling; });
    place(
        out, "simulation.", simulationParameters(), [](Experiment & e) -> auto& { return e.simulation; });
    place(
        out, "simulation.camera.", simulatedCameraParameters(),
        [](Experiment & e) -> auto& { return e.simulation.camera; });
    place(
        out, "simulation.thermal_camera.", simulatedThermalCameraParameters(),
        [](Experiment & e) -> auto& { return *e.simulation.thermalCamera; });
    place(
        out, "vision.camera.", cameraModelParameters(),
        [](Experiment & e) -> auto& { return *e.vision.camera; });
    for (const ControllerEntry& entry : controllerCatalogue())
        for (const ControllerGain& gain : entry.gains)
            out.push_back(
                {std::string("controller.") + entry.group + '.', gain.facts, false, false,
                 [&gain](const Experiment& e) { return gain.get(e.controller); },
                 [&gain](Experiment& e, std::optional<double> si) { gain.set(e.controller, *si); }});
    return out;
}

/// Another valid value than the experiment's.
double another(const Placed& placed, const Experiment& e) {
    const double now = written(*placed.facts, placed.get(e).value_or(placed.facts->range.max));
    const double value =
        now == placed.facts->range.max ? now - 1.0 : std::min(now * 1.25 + 1e-9, placed.facts->range.max);
    return fromWritten(*placed.facts, placed.isWhole ? std::ceil(value) : value);
}

std::string refusedAt(const Placed& placed, double writtenValue) {
    Experiment e = example();
    placed.set(e, fromWritten(*placed.facts, writtenValue));
    const auto valid = validate(e);
    return valid ? "" : valid.error().where;
}

/// Of all drivers of a role: a parameter says in which direction it allows more, and is asked about.
template <class Driver, class Device>
void askedAboutDevices(const std::vector<Driver>& drivers, Device device) {
    for (const Driver& driver : drivers)
        for (const auto& parameter : driver.parameters) {
            const std::string name = std::string(driver.key) + ' ' + parameter.facts->name;
            EXPECT_NE(parameter.facts->loosens, Loosens::Unstated)
                << name << " does not say in which direction it allows more; Never: it is no limit";
            EXPECT_NE(parameter.facts->loosens, Loosens::InCode) << name << ": there is no such code";
            if (!loosensByItself(*parameter.facts))
                continue;
            Experiment lower = example();
            auto& spec = device(lower.rig.emplace()).emplace();
            spec.driver = driver.key;
            if constexpr (requires { spec.profile.watchdog; })
                spec.profile.watchdog.emplace();
            Experiment higher = lower;
            const ValidRange& range = parameter.facts->range;
            parameter.set(spec, fromWritten(*parameter.facts, range.max - 0.5 * (range.max - range.min)));
            parameter.set(*device(*higher.rig), fromWritten(*parameter.facts, range.max));
            const bool isDown = parameter.facts->loosens == Loosens::Down;
            EXPECT_EQ(widensLimits(lower, higher), !isDown) << name;
            EXPECT_EQ(widensLimits(higher, lower), isDown) << name;
        }
}

std::string document() {
    std::ifstream file(BASK_DOCS "/experiment-format.md");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Rows of the document's tables that name the key, by itself or at the end of a path.
std::vector<std::string> rowsOf(const std::string& text, const std::string& key) {
    std::vector<std::string> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::string named = line.substr(0, line.find(" | ", 1));
        if (line.starts_with("| ") && (named.find('`' + key + '`') != std::string::npos ||
                                       named.find('.' + key + '`') != std::string::npos))
            rows.push_back(line);
    }
    return rows;
}

/// As documents have it: 36000, 1e5.
std::string plain(double value) {
    const std::string text = formatNumber(value, std::abs(value) < 1e5 ? 7 : 3);
    return std::regex_replace(text, std::regex("e([+-])0*"), std::abs(value) < 1.0 ? "e-" : "e");
}

/// "1 to 100", "(0, 100]" or "0 (no limit) to 100"; where the least is another value's, its end.
bool tellsRange(const std::string& row, const Placed& placed) {
    const ValidRange& range = placed.facts->range;
    const std::string name = placed.facts->name;
    const bool isMinFixed = placed.path != "sampling." && name != "duration_limit" && name != "source_trip";
    const std::string maxWords = (range.excludesMin && isMinFixed ? ", " : " to ") + plain(range.max);
    return row.find(maxWords) != std::string::npos &&
           (!isMinFixed || row.find(' ' + std::string(range.excludesMin ? "(" : "") + plain(range.min)) !=
                               std::string::npos);
}

} // namespace

// Catches a unit of a form that nobody can type.
TEST(ExperimentParameters, EveryUnitCanBeTyped) {
    for (const Placed& each : everyParameter()) {
        const std::string symbol = each.facts->unit.symbol;
        const auto typed = converted(1.0, symbol + "/1", symbol); // not the very words
        ASSERT_TRUE(typed.has_value()) << each.path << each.facts->name << ": " << symbol;
        EXPECT_DOUBLE_EQ(*typed, 1.0) << symbol;
    }
}

// Catches a value that is lost on its way through the file, or lands in another.
TEST(ExperimentParameters, EachGoesThroughTheFile) {
    for (const Placed& placed : everyParameter()) {
        Experiment e = example();
        placed.set(e, another(placed, e));
        ASSERT_NE(e, example()) << placed.path << placed.facts->name;
        const auto read = experimentFromJson(experimentToJson(e), "", "");
        if (!read) // a relation to another value
            continue;
        EXPECT_EQ(*read, e) << placed.path << placed.facts->name;
    }
}

// Catches a range that is not checked, or whose complaint is about another place.
TEST(ExperimentParameters, EachIsRefusedOutsideItsRange) {
    for (const Placed& placed : everyParameter()) {
        const ValidRange& range = placed.facts->range;
        const std::string where = placed.path + keyOf(*placed.facts);
        EXPECT_EQ(refusedAt(placed, range.max * 1.01 + 1.0), where);
        EXPECT_EQ(refusedAt(placed, range.excludesMin ? range.min : range.min - std::abs(range.min) - 1.0),
                  where);
    }
}

// Catches a limit that may be raised on a real rig without a question: whoever adds one says in which
// direction it allows more.
TEST(ExperimentParameters, EveryLimitThatLoosensIsAskedAbout) {
    for (const Placed& placed : everyParameter()) {
        const bool isLimit = placed.path == "safety." || placed.path == "robot.";
        if (placed.facts->name == std::string("max_mounting_radius")) // what is told, not what is allowed
            continue;
        const bool hasDirection =
            placed.facts->loosens != Loosens::Never && placed.facts->loosens != Loosens::Unstated;
        EXPECT_EQ(hasDirection, isLimit || placed.path == "objects[0].") << placed.path << placed.facts->name;
        if (!isLimit)
            continue;
        Experiment lower = example(), higher = example();
        placed.set(lower, fromWritten(*placed.facts, placed.facts->range.max - 1.0));
        placed.set(higher, fromWritten(*placed.facts, placed.facts->range.max));
        const bool isDown = placed.facts->loosens == Loosens::Down;
        EXPECT_EQ(widensLimits(lower, higher), !isDown) << placed.facts->name;
        EXPECT_EQ(widensLimits(higher, lower), isDown) << placed.facts->name;
    }
}

// Catches the same of the devices of a real rig, of each driver: what is no limit says so, too.
TEST(ExperimentParameters, EveryLimitOfADeviceThatLoosensIsAskedAbout) {
    askedAboutDevices(
        robotDrivers(), [](RigSpec & rig) -> auto& { return rig.robot; });
    askedAboutDevices(
        thermometerDrivers(), [](RigSpec & rig) -> auto& { return rig.thermometer; });
    askedAboutDevices(
        heatSourceDrivers(), [](RigSpec & rig) -> auto& { return rig.source; });
    for (const Parameter<SerialSettings>& each : serialParameters())
        EXPECT_EQ(each.loosens, Loosens::Never) << each.name << ": nothing asks about a line";
    // Told here once more, since a direction that is wrong would not be noticed above.
    EXPECT_EQ(deviceParameter(heatSourceParameters(), "watchdog", SetupStep::Use).facts->loosens,
              Loosens::Up);
}

// Catches documents that tell another key, range or default than the program has.
TEST(ExperimentParameters, TheDocumentHasThem) {
    const std::string text = document();
    ASSERT_FALSE(text.empty());
    Experiment usual;
    usual.objects.emplace_back().estimatedRates.emplace();
    usual.vision.camera.emplace();
    usual.vision.markers.emplace_back();
    usual.source.uneven.parts.emplace_back();
    usual.simulation.sourceUneven.emplace().profile.emplace_back();
    usual.simulation.thermalCamera.emplace();
    for (const Placed& placed : everyParameter()) {
        const auto rows = rowsOf(text, keyOf(*placed.facts));
        ASSERT_FALSE(rows.empty()) << placed.path << keyOf(*placed.facts);
        EXPECT_TRUE(
            std::ranges::any_of(rows, [&](const std::string& row) { return tellsRange(row, placed); }))
            << placed.path << keyOf(*placed.facts) << ": " << placed.facts->range.min << " to "
            << placed.facts->range.max << " in " << rows.front();
        const auto value = placed.get(usual);
        if (!value || placed.facts->isRequired)
            continue;
        const std::string end = "| " + plain(written(*placed.facts, *value)) + " |";
        EXPECT_TRUE(std::ranges::any_of(rows, [&](const std::string& row) { return row.ends_with(end); }))
            << placed.path << keyOf(*placed.facts) << ": " << end << " in " << rows.front();
    }
}

} // namespace bask
