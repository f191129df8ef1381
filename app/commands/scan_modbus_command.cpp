// bask scan-modbus: which units answer at a port, and which profiles fit.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "engine/base/units.h"
#include "engine/drivers/modbus_search.h"

#include <nlohmann/json.hpp>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <thread>
#include <utility>

namespace bask {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kScanModbus = "scan-modbus";
constexpr const char* kUsualLines = "19200-8E1,9600-8N1";

std::string lineText(const SerialSettings& line) {
    return std::to_string(line.baud) + '-' + std::to_string(line.dataBits) + line.parity +
           std::to_string(line.stopBits);
}

QString commonLines() {
    QStringList out;
    for (const SerialSettings& line : kCommonModbusLines)
        out << QString::fromStdString(lineText(line));
    return out.join(u',');
}

/// "9600-8N1,19200-8E1"; empty if one of them is none.
std::vector<SerialSettings> linesOf(const QString& text) {
    static const QRegularExpression kLine(QStringLiteral("^(\\d{3,7})-([78])([NEO])([12])$"));
    std::vector<SerialSettings> out;
    for (const QString& each : text.split(u',')) {
        const auto match = kLine.match(each);
        if (!match.hasMatch() || match.captured(1).toInt() < 300 || match.captured(1).toInt() > 4000000)
            return {};
        out.push_back({match.captured(1).toInt(), match.captured(2).toInt(),
                       match.captured(3).front().toLatin1(), match.captured(4).toInt()});
    }
    return out;
}

void print(const FoundUnit& found) {
    std::printf("unit %d:%s", found.unit,
                found.fits.empty() ? " answers, but no profile that comes with Bask fits" : "");
    if (found.sameAs > 0)
        std::printf(" the same device as unit %d", found.sameAs);
    std::printf("\n");
    for (const ProfileFit& fit : found.fits) {
        std::printf("  %s:", fit.profile.c_str());
        for (const double t_K : fit.temperatures_K)
            std::printf(" %s", std::isnan(t_K) ? "-" : formatNumber(celsiusFromKelvin(t_K)).c_str());
        std::printf(" degC%s", fit.isTypeTold ? ", as the device tells of itself" : "");
        if (!fit.signature.empty())
            std::printf(", identity %s", fit.signature.c_str());
        std::printf("\n");
    }
    std::fflush(stdout);
}

Json jsonOf(const FoundUnit& found) {
    Json fits = Json::array();
    for (const ProfileFit& fit : found.fits) {
        Json temperatures = Json::array();
        for (const double t_K : fit.temperatures_K)
            temperatures.push_back(std::isnan(t_K) ? Json() : Json(celsiusFromKelvin(t_K)));
        fits.push_back({{"profile", fit.profile},
                        {"type_told", fit.isTypeTold},
                        {"identity", fit.signature.empty() ? Json() : Json(fit.signature)},
                        {"temperatures_degC", std::move(temperatures)}});
    }
    return {{"unit", found.unit},
            {"same_as_unit", found.sameAs > 0 ? Json(found.sameAs) : Json()},
            {"profiles", std::move(fits)}};
}

ModbusSearchState searched(const ModbusSearchSpec& spec, bool isTold) {
    ModbusSearch search(spec);
    Progress progress(1.0);
    std::size_t told = 0;
    ModbusSearchState state = search.state();
    while (!state.isOver) {
        search.work();
        QCoreApplication::processEvents();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        state = search.state();
        progress.tell(state.progress, [&] {
            return (spec.isNetwork ? "" : lineText(state.line) + ", ") + "unit " + std::to_string(state.unit);
        });
        while (isTold && told < state.found.size() &&
               (state.isOver || state.found[told].unit != state.unit)) {
            progress.makeRoom();
            print(state.found[told++]);
        }
    }
    progress.makeRoom();
    return state;
}

} // namespace

int scanModbusCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Asks which Modbus units answer at a serial port or a network address, and which profiles that come\n"
        "with Bask fit, with what they read. Nothing is written. The port must not be in use.\n"
        "Exit code: 0 a unit answers, 2 bad input, 3 none does.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addPositionalArgument("PORT", "/dev/ttyUSB0, 192.168.1.20 or logger:1502.");
    parser.addOptions(
        {{"units", "The units to ask, 1 to 247.", "FIRST-LAST", "1-16"},
         {"line",
          QStringLiteral("Settings of the serial line, tried until a unit answers: %1 if none are given, "
                         "\"common\" for %2.")
              .arg(QLatin1String(kUsualLines), commonLines()),
          "BAUD-8N1[,...]", kUsualLines},
         {"json", "Prints what was found as JSON."}});
    if (const auto code = parseCommand(parser, kScanModbus, arguments, 1))
        return *code;
    static const QRegularExpression kUnits(QStringLiteral("^(\\d{1,3})(?:-(\\d{1,3}))?$"));
    const auto units = kUnits.match(parser.value("units"));
    ModbusSearchSpec spec;
    spec.firstUnit = units.captured(1).toInt();
    spec.lastUnit = units.captured(2).isEmpty() ? spec.firstUnit : units.captured(2).toInt();
    if (!units.hasMatch() || spec.firstUnit < 1 || spec.lastUnit > 247 || spec.firstUnit > spec.lastUnit)
        return refuse(kScanModbus, QStringLiteral("--units: 1-16, or one unit, expected"));
    const QString lines = parser.value("line");
    spec.port = parser.positionalArguments().first().toStdString();
    spec.isNetwork = !spec.port.starts_with('/') && !spec.port.starts_with('.');
    spec.lines = lines == QLatin1String("common") ? kCommonModbusLines : linesOf(lines);
    if (spec.lines.empty())
        return refuse(
            kScanModbus,
            QStringLiteral(
                "--line: BAUD-8N1 expected, as 9600-8N1 or 19200-8E1, several with commas, or common"));
    if (const auto code = refuseIdle(
            parser, kScanModbus,
            {{"line", !spec.isNetwork, "is for serial ports; a network address has no such settings"}}))
        return *code;
    if (spec.isNetwork)
        spec.lines.resize(1);
    const bool isJson = parser.isSet("json");
    const ModbusSearchState state = searched(spec, !isJson);
    if (state.problem != Message{})
        return refuse(kScanModbus, Error(state.problem.code, {}, state.problem.args));
    const bool isAnyThere = !state.found.empty();
    if (isJson) {
        Json found = Json::array();
        for (const FoundUnit& unit : state.found)
            found.push_back(jsonOf(unit));
        const Json line = spec.isNetwork || !isAnyThere ? Json() : Json(lineText(state.line));
        std::printf("%s\n", Json{{"port", spec.port}, {"line", line}, {"units", found}}.dump(2).c_str());
    } else if (!isAnyThere) {
        std::printf("No unit from %d to %d answers.\n", spec.firstUnit, spec.lastUnit);
    } else if (!spec.isNetwork) {
        std::printf("The line is %s.\n", lineText(state.line).c_str());
    }
    return isAnyThere ? kExitDone : kExitNegative;
}

} // namespace bask
