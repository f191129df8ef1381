// bask identify: heat rates of a recorded run's objects by least squares, as a table, as JSON, and as start
// values of the next run.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/session_identification.h"
#include "engine/rig/rig_setup.h"

#include <nlohmann/json.hpp>

#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kAfterReading = 0.7; // of the work
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct IdentifyArguments {
    std::shared_ptr<RecordedSession> session;
    std::optional<HeatRecords> records;
    std::optional<TraceSample> last; ///< before Stop
    SessionIdentification options;
    std::string outputPath; ///< empty: none
};

/// Result and comparison of one object.
struct Row {
    std::string name;
    IdentifiedRates identified;
    double arealHeatCapacity_J_m2K; ///< that gives lambda1 with the configured absorptance
    double absorptance;
    HeatRates nominal;    ///< of the experiment's material
    HeatRates controller; ///< its last estimate; NaN where it has none
};

struct NamedRate {
    const char* name;
    const char* unit;
    const char* key;
    Estimate IdentifiedRates::*estimate;
    double HeatRates::*rate; ///< null: none of the controllers' rates
};

constexpr std::array kRates{
    NamedRate{"lambda1", "K/s", "lambda1_K_s", &IdentifiedRates::lambda1, &HeatRates::lambda1},
    NamedRate{"lambda2", "1/(K3 s)", "lambda2_1_K3s", &IdentifiedRates::lambda2, &HeatRates::lambda2},
    NamedRate{"lambda3", "K/s", "lambda3_K_s", &IdentifiedRates::lambda3, &HeatRates::lambda3},
    NamedRate{"h A/(m c)", "1/s", "convection_1_s", &IdentifiedRates::convection, nullptr},
    NamedRate{"loss", "K/s", "loss_K_s", &IdentifiedRates::loss, nullptr},
    NamedRate{"loss slope", "1/s", "loss_slope_1_s", &IdentifiedRates::lossSlope, nullptr}};

/// An experiment of the user's own is no output of this command, and is not replaced.
Result<void> checkOutput(const std::string& session, const std::string& output) {
    if (auto place = checkOutputs({session}, {{output}}); !place)
        return place;
    std::error_code failed;
    if (!std::filesystem::exists(output, failed) || std::filesystem::file_size(output, failed) == 0)
        return {};
    const auto old = readExperiment(output);
    const auto hasRates = [](const ObjectSpec& object) { return object.estimatedRates.has_value(); };
    if (!old || std::ranges::none_of(old->objects, hasRates))
        return Error(MessageCode::OutputForeign, output, {"an experiment with estimated rates"});
    return {};
}

Result<IdentifyArguments> readIdentifyArguments(const QCommandLineParser& parser, const ShareDone& done) {
    const std::string path = parser.positionalArguments().front().toStdString();
    IdentifyArguments request;
    request.options = {parser.isSet("free-ambient"), parser.isSet("convection")};
    if (parser.isSet("o")) {
        request.outputPath = parser.value("o").toStdString();
        if (const auto output = checkOutput(path, request.outputPath); !output)
            return output.error();
    }
    const auto session = RecordedSession::open(path);
    if (!session)
        return session.error();
    request.session = *session;
    request.records.emplace(request.session->facts());
    const double until_s = controlledUntil_s(request.session->facts());
    const auto add = [&](const TraceSample& sample) {
        request.records->add(sample);
        if (sample.time_s <= until_s)
            request.last = sample;
    };
    const auto read = readSamples(path, add, {}, done);
    return read ? Result<IdentifyArguments>(std::move(request)) : read.error();
}

std::vector<Row> identifiedRows(const IdentifyArguments& request, const ShareDone& done) {
    const Experiment& experiment = request.session->facts().experiment;
    const double J = surroundingsOf(experiment).netSourcePower_W_m2;
    const std::vector<IdentifiedRates> identified = request.records->identify(request.options, done);
    const std::vector<HeatRates> nominal = nominalRates(experiment, experiment.environment_K);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < identified.size(); ++i) {
        const ObjectSpec& object = experiment.objects[i];
        const double alpha = object.material.absorptance;
        Row row{object.name, identified[i], alpha * J / identified[i].lambda1.value,
                alpha,       nominal[i],    {kNaN, kNaN, kNaN}};
        if (request.last)
            row.controller = {request.last->objects[i].lambda1, request.last->objects[i].lambda2, kNaN};
        rows.push_back(std::move(row));
    }
    return rows;
}

/// "-" where there is nothing to compare with.
std::string ratio(double value, double of) {
    return std::isfinite(value / of) ? formatNumber(value / of, 3) : "-";
}

void printTable(const std::vector<Row>& rows) {
    std::printf("%-16s %-10s %12s %12s %-9s %11s %14s\n", "object", "rate", "value", "std_error", "unit",
                "of_nominal", "of_controller");
    for (const Row& row : rows) {
        for (const NamedRate& rate : kRates) {
            const Estimate& estimate = row.identified.*rate.estimate;
            if (!std::isfinite(estimate.value))
                continue;
            const double nominal = rate.rate ? row.nominal.*rate.rate : kNaN;
            const double controller = rate.rate ? row.controller.*rate.rate : kNaN;
            std::printf("%-16s %-10s %12.5g %12.2g %-9s %11s %14s\n", row.name.c_str(), rate.name,
                        estimate.value, estimate.standardError, rate.unit,
                        ratio(estimate.value, nominal).c_str(), ratio(estimate.value, controller).c_str());
        }
    }
    for (const Row& row : rows) {
        const IdentifiedRates& fit = row.identified;
        if (std::isfinite(fit.loss.value))
            std::printf("%s: loss and its slope are those at %.1f degC\n", row.name.c_str(),
                        celsiusFromKelvin(fit.workingTemperature_K));
        if (fit.caveat != Message{})
            std::printf("%s: note: %s\n", row.name.c_str(), describe(fit.caveat).c_str());
        if (!fit.usable()) {
            std::printf("%s: not usable: %s\n", row.name.c_str(), describe(fit.reason).c_str());
            continue;
        }
        std::printf("%s: m c/A = %.4g J/(m2 K) with an absorptance of %.3g", row.name.c_str(),
                    row.arealHeatCapacity_J_m2K, row.absorptance);
        if (std::isfinite(fit.convection.value))
            std::printf(", then h = %.3g W/(m2 K)", fit.convection.value * row.arealHeatCapacity_J_m2K);
        std::printf("; %d readings, %.2g K about the fit, %d left out\n", fit.readings, fit.residual_K,
                    fit.outliers);
    }
}

Json numberOrNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json rowJson(const Row& row) {
    const IdentifiedRates& fit = row.identified;
    Json j;
    j["name"] = row.name;
    j["usable"] = fit.usable();
    j["reason"] = fit.usable() ? Json(nullptr) : Json(describe(fit.reason));
    j["note"] = fit.caveat == Message{} ? Json(nullptr) : Json(describe(fit.caveat));
    j["working_degC"] = numberOrNull(celsiusFromKelvin(fit.workingTemperature_K));
    for (const NamedRate& rate : kRates) {
        const Estimate& estimate = fit.*rate.estimate;
        Json& entry = j[rate.key];
        entry["value"] = numberOrNull(estimate.value);
        entry["standard_error"] = numberOrNull(estimate.standardError);
        if (rate.rate == nullptr)
            continue;
        entry["nominal"] = numberOrNull(row.nominal.*rate.rate);
        entry["controller"] = numberOrNull(row.controller.*rate.rate);
    }
    j["areal_heat_capacity_J_m2K"] = numberOrNull(row.arealHeatCapacity_J_m2K);
    j["readings"] = fit.readings;
    j["outliers"] = fit.outliers;
    j["windows"] = fit.windows;
    j["window_s"] = fit.window_s;
    j["residual_K"] = fit.residual_K;
    j["condition"] = numberOrNull(fit.condition);
    return j;
}

void printJson(const IdentifyArguments& request, const std::vector<Row>& rows) {
    Json j;
    j["session"] = request.session->facts().path;
    j["convection"] = request.options.convection;
    j["free_ambient"] = request.options.freeAmbient;
    j["objects"] = Json::array();
    for (const Row& row : rows)
        j["objects"].push_back(rowJson(row));
    std::printf("%s\n", j.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

/// The session's experiment with the rates that can be used, of the balance that the controllers know: with
/// the air that the experiment states, and no other convection.
Result<void> writeStartValues(const IdentifyArguments& request) {
    Experiment experiment = request.session->facts().experiment;
    SessionIdentification options = request.options;
    options.convection = false;
    const std::vector<IdentifiedRates> identified = [&] {
        Progress progress(1.0);
        return request.records->identify(options, progress.share());
    }();
    int written = 0;
    for (std::size_t i = 0; i < identified.size(); ++i) {
        ObjectSpec& object = experiment.objects[i];
        if (identified[i].usable()) {
            object.estimatedRates = identified[i].rates().withoutAir(); // that is the experiment's
            ++written;
        } else {
            std::fprintf(stderr, "bask identify: \"%s\" keeps its start values: %s\n", object.name.c_str(),
                         describe(identified[i].reason).c_str());
        }
    }
    if (written == 0) {
        std::fprintf(stderr, "bask identify: %s is not written\n", request.outputPath.c_str());
        return {};
    }
    return writeExperiment(experiment, request.outputPath);
}

} // namespace

int identifyCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Fits the heat balance to a recorded run: lambda1, lambda2, lambda3 of each object with standard "
        "errors,\nbeside those of the experiment's materials and the controller's last estimate.\n"
        "Exit code: 0 done, 2 bad input or unwritable output, 3 not usable for at least one object.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("SESSION.bask", "The session; one that is being recorded will do.");
    parser.addOptions(
        {{"convection", "Fit a convective term too; that takes wide temperatures and long records."},
         {"free-ambient", "Fit lambda3 too; otherwise the room's temperature ties it to lambda2."},
         {"json", "Print all digits, as JSON."},
         {"o",
          "Write the session's experiment with the rates as start values of its controllers, fitted with "
          "the air that the experiment states, and no other convection.",
          "EXPERIMENT.json"}});
    if (const auto code = parseCommand(parser, "identify", arguments, 1))
        return *code;
    std::optional<Progress> progress(std::in_place, 1.0);
    const auto request = readIdentifyArguments(parser, partOf(progress->share(), 0.0, kAfterReading));
    const std::vector<Row> rows =
        request ? identifiedRows(*request, partOf(progress->share(), kAfterReading, 1.0))
                : std::vector<Row>();
    progress.reset(); // ends its line before others
    if (!request)
        return refuse("identify", request.error());
    if (request->session->facts().interrupted())
        std::fputs("bask identify: the recording was interrupted or is still on; taking what is there\n",
                   stderr);
    if (parser.isSet("json"))
        printJson(*request, rows);
    else
        printTable(rows);
    if (!request->outputPath.empty())
        if (const auto written = writeStartValues(*request); !written)
            return refuse("identify", written.error());
    const auto usable = [](const Row& row) { return row.identified.usable(); };
    return std::ranges::all_of(rows, usable) ? kExitDone : kExitNegative;
}

} // namespace bask
