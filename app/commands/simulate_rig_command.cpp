// bask simulate-rig: all the devices of an experiment's rig at the far ends of their ports, around one
// thermal plant.

#include "app/commands/command_line.h"
#include "app/commands/end_signal.h"
#include "app/commands/parse_command.h"
#include "app/examples.h"
#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/device_simulators/bench.h"
#include "engine/device_simulators/device_server.h"
#include "engine/drivers/driver_catalogue.h"
#include "engine/drivers/port_claim.h"
#include "engine/experiment/experiment_file.h"
#include "engine/rig/rig_setup.h"

#include <QCommandLineParser>

#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <poll.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr const char* kSimulateRig = "simulate-rig";
constexpr const char* kExample = "serial-rig"; // as File > Examples has it
constexpr int kTurn_ms = 2;

Result<BenchDevices> benchDevices(const Experiment& experiment) {
    const auto missing = [](const char* what) { return Error(MessageCode::RigIncomplete, {}, {what}); };
    if (!experiment.rig)
        return Error(MessageCode::RigMissing, {});
    const RigSpec& rig = *experiment.rig;
    if (!rig.robot || rig.robot->driver != "grbl")
        return missing("robot under Grbl");
    if (!rig.thermometer)
        return missing("thermometer");
    BenchDevices devices;
    devices.axes = rig.robot->axes;
    devices.channels = rig.thermometer->channels;
    devices.thermometerUnit = rig.thermometer->unit;
    if (driverOf(*rig.thermometer).isModbus)
        devices.thermometer = rig.thermometer->profile;
    else if (rig.thermometer->driver != "stream")
        return missing("thermometer that can be simulated");
    if (!rig.source || isManualSource(*rig.source))
        return missing("heat source with a port");
    devices.heaterUnit = rig.source->unit;
    if (driverOf(*rig.source).isModbus)
        devices.heater = rig.source->profile;
    else if (rig.source->driver != "namur")
        return missing("heat source that can be simulated");
    if (rig.source->port == rig.thermometer->port)
        return missing("port of its own for the heat source");
    return devices;
}

/// Whatever folder it is started in, and however long the path is.
std::string claimedName(const std::string& port) {
    const std::string path = std::filesystem::absolute(port).lexically_normal();
    return "simulated " + std::to_string(std::hash<std::string>()(path));
}

/// The bench with its ports, and the faults that are told on standard input.
class BenchServer {
public:
    static constexpr std::array<const char*, 3> kRoles{"robot", "thermometer", "heater"};

    explicit BenchServer(Bench& bench) : m_bench(bench) {}

    /// `paths` in the order of the roles. `areThere`: their terminals, made by others.
    Result<void> open(const std::array<std::string, 3>& paths, bool areThere) {
        m_areThere = areThere;
        m_paths = paths;
        for (std::size_t i = 0; i < m_paths.size(); ++i)
            if (const auto opened = plug(i); !opened)
                return opened;
        return {};
    }

    /// "robot silent"
    Result<void> setFault(const std::string& text) {
        const std::size_t space = text.find(' ');
        const std::string fault = space == std::string::npos ? "none" : text.substr(space + 1);
        for (std::size_t i = 0; i < kRoles.size(); ++i) {
            if (text.substr(0, space) != kRoles[i])
                continue;
            if (fault == "unplug")
                return m_servers[i].reset(), Result<void>();
            return fault == "plug" ? plug(i) : device(i).setFault(fault);
        }
        return Error(MessageCode::ValueUnknown, {}, {text.substr(0, space), "robot, thermometer, heater"});
    }

    void serve() {
        const SteadyClock clock;
        while (!hasEndSignal()) {
            for (std::size_t i = 0; i < m_servers.size(); ++i) {
                if (m_servers[i])
                    m_servers[i]->work(clock.now_s());
                else
                    (void)device(i).transmit(clock.now_s()); // unplugged it goes on by itself
            }
            if (m_isHeating != m_bench.isHeating()) {
                m_isHeating = !m_isHeating;
                m_switched_s = clock.now_s();
            }
            m_bench.advance(clock.now_s());
            pollfd input{m_isListening ? STDIN_FILENO : -1, POLLIN, 0};
            if (::poll(&input, 1, kTurn_ms) > 0)
                listen();
        }
    }

private:
    /// A terminal of another number, maybe, under the same path.
    Result<void> plug(std::size_t role) {
        auto server = serveAt(m_paths[role], device(role), m_areThere);
        if (!server)
            return server.error();
        m_servers[role] = std::move(*server);
        return {};
    }
    ByteDevice& device(std::size_t role) {
        return role == 0 ? m_bench.robot() : role == 1 ? m_bench.thermometer() : m_bench.heater();
    }
    void listen() {
        std::array<char, 256> bytes{};
        const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
        if (count <= 0) {
            m_isListening = false;
            return;
        }
        m_told.append(bytes.data(), static_cast<std::size_t>(count));
        for (std::size_t at = m_told.find('\n'); at != std::string::npos; at = m_told.find('\n')) {
            tell(m_told.substr(0, at));
            m_told.erase(0, at + 1);
        }
    }
    void tell(const std::string& line) {
        if (line == "state") {
            const Vector6d q = m_bench.coordinates();
            std::printf("plate %.2f degC %s; robot %.4f %.4f %.4f m; objects",
                        celsiusFromKelvin(m_bench.plate_K()), m_bench.isHeating() ? "heating" : "off", q[0],
                        q[1], q[2]);
            for (const double t_K : m_bench.temperatures_K())
                std::printf(" %.3f", celsiusFromKelvin(t_K));
            std::printf(" degC\n");
        } else if (line == "switched") {
            std::printf("heat %s since %.6f s\n", m_isHeating ? "on" : "off", m_switched_s);
        } else if (const auto set = setFault(line); !set) {
            std::fprintf(stderr, "bask %s: %s\n", kSimulateRig, describe(set.error()).c_str());
        } else {
            std::printf("%s\n", line.c_str());
        }
        std::fflush(stdout);
    }

    Bench& m_bench;
    std::array<std::string, 3> m_paths;
    bool m_areThere = false;
    bool m_isHeating = false;
    double m_switched_s = 0.0; ///< when the bytes that switched the heat had come, steady clock
    std::array<std::unique_ptr<DeviceServer>, 3> m_servers; ///< null: unplugged
    std::string m_told;
    bool m_isListening = true;
};

} // namespace

int simulateRigCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "The devices of the experiment's \"rig\" on pseudo-terminals at their ports' paths, around one "
        "thermal\n"
        "plant, until Ctrl+C, SIGTERM or the end of its terminal; without a file those of the example\n"
        "serial-rig, which are in /tmp. A second one for the same ports is refused.\n"
        "A line \"robot silent\" on standard input begins a fault, \"robot none\" ends it; \"robot unplug\" "
        "takes\n"
        "its terminal away and \"robot plug\" makes it anew; \"state\" prints what is truly so, \"switched\" "
        "since\n"
        "when the heat is on or off, in seconds of the computer's monotonic clock.\n"
        "Exit code: 0 ended, 2 bad input, or no terminal there.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption(
        {"heating-time", "Time constant of the plate while it heats, in seconds.", "SECONDS", "60"});
    parser.addOption({"open", "Opens the terminals that are at the paths already, of null-modem cables or of "
                              "socat, instead of making new ones."});
    parser.addPositionalArgument("EXPERIMENT.json", "An experiment with a rig.", "[EXPERIMENT.json]");
    const bool isExample =
        parser.parse(QStringList{"bask"} + arguments) && parser.positionalArguments().isEmpty();
    if (const auto code = parseCommand(parser, kSimulateRig, arguments, isExample ? 0 : 1))
        return *code;
    const std::string path = isExample ? kExample : parser.positionalArguments().first().toStdString();
    if (const auto code = refuseIdle(parser, kSimulateRig,
                                     {{"open", !isExample, "is for the terminals of an EXPERIMENT.json"}}))
        return *code;
    const auto experiment = isExample ? readExample(kExample) : readExperiment(path);
    if (!experiment)
        return refuse(kSimulateRig, experiment.error());
    auto devices = benchDevices(*experiment);
    if (!devices)
        return refuse(kSimulateRig, Error(devices.error().code(), path, devices.error().message.args));
    devices->heating_s = parser.value("heating-time").toDouble();
    if (!(devices->heating_s >= 1.0 && devices->heating_s <= 1e5))
        return refuse(kSimulateRig, QStringLiteral("--heating-time is in seconds, 1 to 1e5"));
    const RigSpec& rig = *experiment->rig;
    std::array<PortClaim, 3> claims;
    const std::array<std::string, 3> ports{rig.robot->port, rig.thermometer->port, rig.source->port};
    for (std::size_t i = 0; i < ports.size(); ++i)
        if (!claims[i].take(claimedName(ports[i])))
            return refuse(kSimulateRig, QStringLiteral("another bask simulate-rig serves %1; end that first")
                                            .arg(QString::fromStdString(ports[i])));
    Bench bench(simulatedRigConfig(*experiment), *devices);
    BenchServer server(bench);
    catchEndSignals();
    if (const auto opened = server.open(ports, parser.isSet("open")); !opened)
        return refuse(kSimulateRig, opened.error());
    std::printf("robot %s\nthermometer %s\nheater %s\n", ports[0].c_str(), ports[1].c_str(),
                ports[2].c_str());
    std::fflush(stdout);
    server.serve();
    return kExitDone;
}

} // namespace bask
