#pragma once
// The NAMUR lines of laboratory hotplates (IKA), as in IKA's manuals, chapter "Interfaces and outputs":
// capitals, ended by blank CR LF. The device never sends unasked and does not answer unknown commands.

#include <optional>
#include <string>
#include <string_view>

namespace bask {

namespace namur {
inline constexpr const char* kName = "IN_NAME";
inline constexpr const char* kProbe = "IN_PV_1";    ///< degC of the external probe, channel 1
inline constexpr const char* kPlate = "IN_PV_2";    ///< degC of the plate, channel 2
inline constexpr const char* kSetPoint = "IN_SP_1"; ///< degC, channel 1
inline constexpr const char* kStart = "START_1";
inline constexpr const char* kStop = "STOP_1";
inline constexpr double kHighest_degC = 310.0; ///< largest value of OUT_SP_1; the smallest is 0
inline constexpr double kShortestWatchdog_s = 20.0, kLongestWatchdog_s = 1500.0;
} // namespace namur

/// Returns the line to send for a command such as "IN_PV_2".
std::string namurLine(const std::string& command);
/// Returns "OUT_SP_1 80.0"; the device does not answer it.
std::string namurSetPoint(double setPoint_degC);
/// Returns "OUT_WD1@30": the heating goes off unless this is sent again within that time. The device answers
/// with the time.
std::string namurWatchdog(double time_s);

/// The answer to a reading, "80.0 2".
struct NamurValue {
    double value = 0.0;
    int channel = 0;
};
/// Parses such an answer; empty for any other line.
std::optional<NamurValue> namurValue(std::string_view line);
bool isWatchdogEcho(std::string_view line, double time_s);
/// Returns whether the line can be a device's name, and not a value or an echo of a command.
bool isNamurName(std::string_view line);

} // namespace bask
