#pragma once
// The NAMUR lines of laboratory hotplates (IKA), as in IKA's manuals, chapter "Interfaces and outputs":
// capitals, ended by blank CR LF; the device never speaks unasked and says nothing to what it does not know.

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
inline constexpr double kHighest_degC = 310.0; ///< of OUT_SP_1, from 0
inline constexpr double kShortestWatchdog_s = 20.0, kLongestWatchdog_s = 1500.0;
} // namespace namur

/// "IN_PV_2" as it is sent.
std::string namurLine(const std::string& command);
/// "OUT_SP_1 80.0"; the device says nothing to it.
std::string namurSetPoint(double setPoint_degC);
/// "OUT_WD1@30": heating goes off unless this is sent again within that time. The device says the time back.
std::string namurWatchdog(double time_s);

/// What a reading is answered with, "80.0 2".
struct NamurValue {
    double value = 0.0;
    int channel = 0;
};
/// Nothing of a line that is anything else.
std::optional<NamurValue> namurValue(std::string_view line);
bool isWatchdogEcho(std::string_view line, double time_s);
/// Words that can be a device's name, and not a value or an echo of a command.
bool isNamurName(std::string_view line);

} // namespace bask
