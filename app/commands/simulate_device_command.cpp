// bask simulate-device: a device that is not there, on a pseudo-terminal or a network port, for Bask's
// drivers or other programs.

#include "app/commands/command_line.h"
#include "app/commands/end_signal.h"
#include "app/commands/parse_command.h"
#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/device_server.h"
#include "engine/device_simulators/grbl_simulator.h"
#include "engine/device_simulators/modbus_simulator.h"
#include "engine/device_simulators/namur_simulator.h"
#include "engine/device_simulators/stream_simulator.h"
#include "engine/device_simulators/tcp_server.h"

#include <QCommandLineParser>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <poll.h>

namespace bask {
namespace {

constexpr const char* kSimulateDevice = "simulate-device";
constexpr int kDeviceTurn_ms = 2;
constexpr int kUnit = 1;
constexpr const char* kModule = "modmux-pm6rtd";
constexpr const char* kController = "eurotherm-2400";
constexpr const char* kNetworkModule = "labjack-t7-thermocouples";
constexpr const char* kNetworkController = "pixsys-drr245";

/// A device and what moves it besides the bytes.
struct Simulated {
    std::unique_ptr<ByteDevice> device;
    std::function<void(double now_s)> move = [](double) {};
};

/// One that can be asked for; the first of a role is its default.
struct Kind {
    const char* role;
    const char* driver;
    const char* line; ///< how a program sets its port
    Simulated (*make)();
    bool isNetwork = false;
};

Simulated hotplate() {
    return {std::make_unique<NamurSimulator>()};
}

/// Three objects that slowly warm and cool.
Simulated thermometer() {
    auto device = std::make_unique<StreamSimulator>();
    const auto move = [&stream = *device](double now_s) {
        std::vector<double> temperatures_K;
        for (const double middle_degC : {30.0, 40.0, 50.0})
            temperatures_K.push_back(
                kelvinFromCelsius(middle_degC + 5.0 * std::sin(2.0 * std::numbers::pi * now_s / 120.0)));
        stream.setTemperatures(temperatures_K);
    };
    return {std::move(device), move};
}

Simulated robot() {
    return {std::make_unique<GrblSimulator>()};
}

const ModbusProfile& shipped(const std::string& name) {
    return *std::ranges::find(shippedProfiles(), name, &ModbusProfile::name);
}

/// Each channel of a module warmer than the one before.
Simulated module() {
    auto device = std::make_unique<ModbusSimulator>();
    device->addThermometer(kUnit, shipped(kModule), kelvinFromCelsius(25.0));
    for (int channel = 0; channel < shipped(kModule).channels; ++channel)
        device->setTemperature(kUnit, channel, kelvinFromCelsius(25.0 + 5.0 * channel));
    return {std::move(device)};
}

Simulated controller() {
    auto device = std::make_unique<ModbusSimulator>();
    device->addController(kUnit, shipped(kController));
    return {std::move(device)};
}

/// Four thermocouples, each warmer than the one before, between inputs that are not set up.
Simulated networkModule() {
    auto device = std::make_unique<ModbusSimulator>(ModbusSimulator::Frames::Tcp);
    device->addThermometer(kUnit, shipped(kNetworkModule), kelvinFromCelsius(25.0));
    for (int channel = 0; channel < shipped(kNetworkModule).channels; ++channel) {
        if (channel % 2 == 0 && channel < 8)
            device->setTemperature(kUnit, channel, kelvinFromCelsius(25.0 + 5.0 * channel));
        else
            device->removeChannel(kUnit, channel);
    }
    return {std::move(device)};
}

Simulated networkController() {
    auto device = std::make_unique<ModbusSimulator>(ModbusSimulator::Frames::Tcp);
    device->addController(kUnit, shipped(kNetworkController));
    return {std::move(device)};
}

constexpr std::array kDeviceKinds{
    Kind{"robot", "grbl", "115200 baud, 8N1", robot},
    Kind{"thermometer", "stream", "115200 baud, 8N1", thermometer},
    Kind{"heater", "namur", "9600 baud, 7E1", hotplate},
    Kind{"thermometer", "modbus", "19200 baud, 8E1, unit 1, profile modmux-pm6rtd", module},
    Kind{"heater", "modbus", "9600 baud, 8N1, unit 1, profile eurotherm-2400", controller},
    Kind{"thermometer", "modbus_tcp",
         "Modbus TCP, unit 1, profile labjack-t7-thermocouples, channels 0, 2, 4 and 6", networkModule, true},
    Kind{"heater", "modbus_tcp", "Modbus TCP, unit 1, profile pixsys-drr245", networkController, true}};

/// "heater namur: none, silent, ..."
std::string listOfFaults() {
    std::string text;
    for (const Kind& kind : kDeviceKinds) {
        text += std::string("  ") + kind.role + ' ' + kind.driver + ':';
        for (const std::string& fault : kind.make().device->faults())
            text += ' ' + fault;
        text += '\n';
    }
    return text;
}

Result<const Kind*> kindOf(const std::string& role, const std::string& driver) {
    std::string roles, drivers;
    for (const Kind& kind : kDeviceKinds) {
        roles += (roles.empty() ? "" : ", ") + std::string(kind.role);
        if (role != kind.role)
            continue;
        if (driver.empty() || driver == kind.driver)
            return &kind;
        drivers += (drivers.empty() ? "" : ", ") + std::string(kind.driver);
    }
    if (drivers.empty())
        return Error{MessageCode::ValueUnknown, {}, {role, roles}};
    return Error{MessageCode::ValueUnknown, "--driver", {driver, drivers}};
}

void serveUntilEnded(DeviceServer& server, const Simulated& simulated) {
    const SteadyClock clock;
    while (!hasEndSignal()) {
        simulated.move(clock.now_s());
        server.work(clock.now_s());
        ::poll(nullptr, 0, kDeviceTurn_ms);
    }
}

/// `path` becomes the address, which is that of any free port for 0.
Result<std::unique_ptr<DeviceServer>> serverAt(std::string& path, ByteDevice& device, bool isNetwork,
                                               bool isThere) {
    if (!isNetwork)
        return serveAt(path, device, isThere);
    bool isNumber = false;
    const int port = QString::fromStdString(path).toInt(&isNumber);
    if (!isNumber || port < 0 || port > 65535 || isThere)
        return Error{
            MessageCode::ValueUnknown, "--link", {path, "a port of this computer, 1 to 65535, or 0"}};
    auto server = TcpServer::create(device, port);
    if (!server)
        return server.error();
    path = "127.0.0.1:" + std::to_string((*server)->port());
    return std::unique_ptr<DeviceServer>(std::move(*server));
}

int serve(const Kind& kind, std::string path, bool isThere, const std::string& fault) {
    const Simulated simulated = kind.make();
    if (const auto known = simulated.device->setFault(fault); !known)
        return refuse(kSimulateDevice, Error{known.error().code(), "--fault", known.error().message.args});
    auto server = serverAt(path, *simulated.device, kind.isNetwork, isThere);
    if (!server)
        return refuse(kSimulateDevice, server.error());
    catchEndSignals();
    std::printf("%s\n", path.c_str());
    std::fflush(stdout);
    std::fprintf(stderr,
                 "A simulated %s (%s%s%s) answers there until Ctrl+C. Give that as the device's port; "
                 "other programs open it with %s.\n",
                 kind.role, kind.driver, fault == "none" ? "" : ", fault ",
                 fault == "none" ? "" : fault.c_str(), kind.line);
    serveUntilEnded(**server, simulated);
    return kExitDone;
}

} // namespace

int simulateDeviceCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QStringLiteral(
            "A simulated device on a pseudo-terminal, which any program opens as a serial port: it "
            "takes and gives\nthe very bytes of a real one, until Ctrl+C, SIGTERM or the end of its "
            "terminal. The link is removed\nthen; one that is there is replaced, as if the cable were "
            "plugged in anew. Drivers and their faults, the first one a role's default:\n%1"
            "Exit code: 0 ended, 2 bad input, or no terminal there.")
            .arg(QString::fromStdString(listOfFaults())));
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOptions(
        {{"link",
          "Where the port is to be found; of modbus_tcp a port of this computer, 0 for a free one. "
          "Required.",
          "PATH"},
         {"open", "Opens the terminal that is at PATH already, of a null-modem cable or of "
                  "socat, instead of making one."},
         {"driver", "The language that it speaks.", "NAME"},
         {"fault", "Has a fault from the beginning.", "NAME", "none"}});
    parser.addPositionalArgument("DEVICE", "robot, thermometer or heater.");
    if (const auto code = parseCommand(parser, kSimulateDevice, arguments, 1))
        return *code;
    if (parser.value("link").isEmpty())
        return refuse(kSimulateDevice, QStringLiteral("--link is needed"));
    const auto kind =
        kindOf(parser.positionalArguments().first().toStdString(), parser.value("driver").toStdString());
    if (!kind)
        return refuse(kSimulateDevice, kind.error());
    if (const auto code = refuseIdle(
            parser, kSimulateDevice,
            {{"open", !(*kind)->isNetwork, "is for terminals; modbus_tcp is on a port of this computer"}}))
        return *code;
    return serve(**kind, parser.value("link").toStdString(), parser.isSet("open"),
                 parser.value("fault").toStdString());
}

} // namespace bask
