#pragma once
// The lines between Bask and a program that drives a device, docs/program-driver.md: requests are written,
// answers are read. SI units.

#include "engine/base/result.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bask {

namespace program {
inline constexpr int kProtocol = 1;
inline constexpr std::size_t kLongestLine = 65536;
inline constexpr double kDeadMan_s = 1.0;
} // namespace program

enum class ProgramRole { Robot, Thermometer, HeatSource };

/// "x, y, theta_z"
std::string coordinateNames(const std::vector<int>& coordinates);

/// "robot", "thermometer", "heater": the role in lines and commands.
const char* programRoleWord(ProgramRole role);

struct ProgramHello {
    std::string name, serial;
    // A robot's
    std::vector<int> axes; ///< the coordinate of each axis
    bool takesVelocities = false;
    bool canHome = false;
    std::array<std::array<double, 2>, 6> limits; ///< by coordinate, m and rad
    // A thermometer's
    int channels = 0;
    // A heat source's
    double maxTemperature_K = 0.0;
    bool hasWatchdog = false;
};

struct ProgramRobotState {
    std::vector<double> position; ///< m and rad, in the order of its axes
    bool isMoving = false;
    bool isSure = false;
    std::string alarm;
};

struct ProgramChannel {
    std::optional<double> temperature_K;
    std::string fault; ///< why it has no temperature, one of sensorFaultWords(); empty if it has one
    double standardUncertainty_K = 0.0; ///< 0: not told
};

struct ProgramHeaterState {
    std::optional<double> temperature_K;
    bool isHeating = false;
    std::optional<double> setPoint_K;
};

struct ProgramDone {};
struct ProgramRefusal {
    std::string words;
};

/// One line of a program.
struct ProgramLine {
    /// Of the request that it answers; empty: an unasked state, or a line that the program could not read.
    std::optional<std::int64_t> id;
    std::int64_t seq = 0;
    double time_s = 0.0; ///< on the program's clock
    double age_s = 0.0;  ///< of a state
    std::variant<ProgramDone, ProgramRefusal, ProgramHello, ProgramRobotState, std::vector<ProgramChannel>,
                 ProgramHeaterState>
        what;

    bool isState() const {
        return !std::holds_alternative<ProgramDone>(what) && !std::holds_alternative<ProgramRefusal>(what) &&
               !std::holds_alternative<ProgramHello>(what);
    }
};

/// Reads a line of a program of this role. Whatever does not follow the protocol is an error with its place
/// in the line; a list's length is not compared with the hello.
Result<ProgramLine> parseProgramLine(std::string_view line, ProgramRole role);

/// The numbers of a line, as far as they can be read where the rest is not to be used.
struct ProgramNumbers {
    std::optional<std::int64_t> id, seq;
};
ProgramNumbers programNumbers(std::string_view line);

std::string programHello(std::int64_t id, ProgramRole role);
/// "read", "stop", "home", "clear", "off".
std::string programRequest(std::int64_t id, const char* what);
/// Rates in m/s and rad/s, in the order of its axes.
std::string programVelocity(std::int64_t id, const std::vector<double>& rates, double validFor_s);
std::string programStep(std::int64_t id, const std::vector<double>& to, double duration_s);
std::string programHeat(std::int64_t id, double setPoint_K, double validFor_s);

} // namespace bask
