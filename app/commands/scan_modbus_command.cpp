// bask scan-modbus: which units answer at a port, and which profiles fit.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/drivers/modbus_scan.h"
#include "engine/drivers/modbus_tcp_link.h"
#include "engine/drivers/qt_modbus_link.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <thread>

namespace bask {
namespace {

constexpr const char* kName = "scan-modbus";
constexpr double kOpens_s = 3.5;

int refuse(const std::string& words) {
    std::fprintf(stderr, "bask %s: %s\n", kName, words.c_str());
    return kExitBadInput;
}

std::string lineText(const SerialSettings& line) {
    return std::to_string(line.baud) + '-' + std::to_string(line.dataBits) + line.parity +
           std::to_string(line.stopBits);
}

/// "9600-8N1"
std::optional<SerialSettings> lineOf(const QString& text) {
    static const QRegularExpression kLine(QStringLiteral("^(\\d{3,7})-([78])([NEO])([12])$"));
    const auto match = kLine.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    return SerialSettings{match.captured(1).toInt(), match.captured(2).toInt(),
                          match.captured(3).front().toLatin1(), match.captured(4).toInt()};
}

void work() {
    QCoreApplication::processEvents();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void print(const FoundUnit& found) {
    std::printf("unit %d: %s\n", found.unit,
                found.fits.empty() ? "answers, but no profile that comes with Bask fits" : "");
    for (const ProfileFit& fit : found.fits) {
        std::printf("  %s:", fit.profile.c_str());
        for (const double t_K : fit.temperatures_K)
            std::printf(" %s", std::isnan(t_K) ? "-" : formatNumber(celsiusFromKelvin(t_K)).c_str());
        std::printf(" degC\n");
    }
    std::fflush(stdout);
}

/// The number of units, or none if the port cannot be opened.
std::optional<std::size_t> scan(ModbusLink& link, int first, int last) {
    const SteadyClock clock;
    const double began_s = clock.now_s();
    link.open();
    while (!link.isOpen() && link.problem().code == MessageCode::None && clock.now_s() - began_s < kOpens_s)
        work();
    if (!link.isOpen()) {
        refuse(describe(link.problem()));
        return std::nullopt;
    }
    ModbusScan scan(link, first, last);
    std::size_t told = 0;
    int unit = 0;
    bool isOn = true;
    while (isOn) {
        isOn = scan.work();
        work();
        if (unit != scan.unit())
            std::fprintf(stderr, "\runit %d ", unit = scan.unit());
        const bool isWhole = !isOn || (told < scan.found().size() && scan.found()[told].unit != scan.unit());
        while (isWhole && told < scan.found().size()) {
            std::fputc('\r', stderr);
            print(scan.found()[told++]);
        }
    }
    std::fputs("\r        \r", stderr);
    if (!link.isOpen()) {
        refuse(describe(link.problem()));
        return std::nullopt;
    }
    return told;
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
    parser.addOptions({{"units", "The units to ask, 1 to 247.", "FIRST-LAST", "1-16"},
                       {"line", "The serial line; without it 19200-8E1, then 9600-8N1.", "BAUD-8N1"}});
    if (const auto code = parseCommand(parser, kName, arguments, 1))
        return *code;
    static const QRegularExpression kUnits(QStringLiteral("^(\\d{1,3})(?:-(\\d{1,3}))?$"));
    const auto units = kUnits.match(parser.value("units"));
    const int first = units.captured(1).toInt();
    const int last = units.captured(2).isEmpty() ? first : units.captured(2).toInt();
    if (!units.hasMatch() || first < 1 || last > 247 || first > last)
        return refuse("--units: 1-16, or one unit, expected");
    const std::string port = parser.positionalArguments().first().toStdString();
    const SteadyClock clock;
    if (!port.starts_with('/')) {
        ModbusTcpLink link(port, clock);
        const auto found = scan(link, first, last);
        if (found && *found == 0)
            std::printf("No unit from %d to %d answers.\n", first, last);
        return !found ? kExitBadInput : *found > 0 ? kExitDone : kExitNegative;
    }
    std::vector<SerialSettings> lines{{19200, 8, 'E', 1}, {9600, 8, 'N', 1}};
    if (parser.isSet("line")) {
        const auto line = lineOf(parser.value("line"));
        if (!line)
            return refuse("--line: BAUD-8N1 expected, as 9600-8N1 or 19200-8E1");
        lines = {*line};
    }
    for (const SerialSettings& line : lines) {
        std::fprintf(stderr, "line %s\n", lineText(line).c_str());
        QtModbusLink link(port, line, clock);
        const auto found = scan(link, first, last);
        if (!found)
            return kExitBadInput;
        if (*found > 0) {
            std::printf("The line is %s.\n", lineText(line).c_str());
            return kExitDone;
        }
    }
    std::printf("No unit from %d to %d answers.\n", first, last);
    return kExitNegative;
}

} // namespace bask
