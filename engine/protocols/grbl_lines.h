#pragma once
// The line protocol of Grbl 1.1 and grblHAL: the meaning of a line from the controller, and the lines and
// bytes that move it. Source: gnea/grbl, doc/markdown/interface.md, commands.md, jogging.md and doc/csv;
// grblHAL core, errors.h and alarms.c.

#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bask {

/// Bytes that the controller processes at once, at any place in the stream; `0x` of Grbl's documents.
namespace grbl {
inline constexpr char kStatus = '?';
inline constexpr char kHold = '!';
inline constexpr char kResume = '~';
inline constexpr char kReset = '\x18';
inline constexpr char kDoor = '\x84';
inline constexpr char kJogCancel = '\x85';
/// The order in which positions are reported.
inline constexpr std::string_view kLetters = "XYZABC";
} // namespace grbl

enum class GrblState { Idle, Run, Hold, Jog, Alarm, Door, Check, Home, Sleep, Tool };

/// `<Idle|MPos:0.000,0.000,0.000|...>`. Positions are millimetres and degrees, in the order of kLetters.
struct GrblStatus {
    GrblState state = GrblState::Idle;
    std::optional<int> part;           ///< of Hold (0 stopped, 1 slowing down), Door (0 closed) and Alarm
    std::string word;                  ///< state and part as reported: "Hold:0"
    std::vector<double> machine;       ///< MPos; empty: not reported
    std::vector<double> work;          ///< WPos = MPos - WCO; empty: not reported
    std::vector<double> offset;        ///< WCO, reported from time to time; empty: not reported
    std::optional<int> freeBlocks;     ///< Bf
    std::optional<int> freeBytes;      ///< Bf
    std::optional<bool> isHomed;       ///< H, grblHAL
    std::optional<unsigned> homedAxes; ///< H's mask, bit 0 X
    std::string pins;                  ///< Pn, active inputs
    bool operator==(const GrblStatus&) const = default;
};

struct GrblOk {
    bool operator==(const GrblOk&) const = default;
};
struct GrblError {
    int number = 0;
    bool operator==(const GrblError&) const = default;
};
struct GrblAlarm {
    int number = 0;
    bool operator==(const GrblAlarm&) const = default;
};
/// The controller has just started: all earlier lines are lost.
struct GrblBanner {
    std::string identity; ///< "Grbl 1.1h"
    bool operator==(const GrblBanner&) const = default;
};
/// `[MSG:...]`, and every other report in brackets, as "VER:1.1h...".
struct GrblReport {
    std::string text;
    bool operator==(const GrblReport&) const = default;
};
/// `[OPT:VNM,15,128]`.
struct GrblOptions {
    std::string letters;
    int blocks = 0; ///< size of the motion queue
    int bytes = 0;  ///< size of the line buffer
    bool operator==(const GrblOptions&) const = default;
};
/// `$10=1`.
struct GrblSetting {
    int number = 0;
    std::string value;
    bool operator==(const GrblSetting&) const = default;
};
struct GrblBlank {
    bool operator==(const GrblBlank&) const = default;
};
/// Anything else, shortened for display.
struct GrblGarbage {
    std::string text;
    bool operator==(const GrblGarbage&) const = default;
};

using GrblLine = std::variant<GrblBlank, GrblOk, GrblError, GrblAlarm, GrblStatus, GrblBanner, GrblReport,
                              GrblOptions, GrblSetting, GrblGarbage>;

/// Parses one line without its end. A line that is damaged anywhere is garbage as a whole. Only a banner is
/// found at any place, because a controller may restart in the middle of a line.
GrblLine parseGrblLine(std::string_view line);

/// Returns the meaning of an alarm or an error; empty if the number is unknown.
std::string grblAlarmWords(int number);
std::string grblErrorWords(int number);

/// Returns whether the controller's reported position is still true after that alarm; false for an unknown
/// one.
bool isPlaceKept(int alarm);

/// One axis of a move, mm or degrees.
struct GrblTarget {
    char letter = 'X';
    double from = 0.0;
    double to = 0.0;
};

/// Returns a setting's value, "10.000"; empty if it is not a plain number.
std::optional<double> grblNumber(std::string_view value);

/// Returns the feed rate of `$G`'s report, "GC:G0 G54 ... F500 S0": 0 from a start until a line sets it.
/// Empty if the report has none.
std::optional<double> grblFeedIn(std::string_view report);

/// Returns the position as the jog line contains it: rounded to a thousandth.
double grblRounded(double position);

/// Returns `$J=G21G90G53X1.000F60.0\n`: a jog to an absolute machine position within about `time_s`. The feed
/// counts degrees as millimetres, F = 60 sqrt(sum of squares) / time_s. Refuses (ValueOutOfRange) positions
/// outside 10 m or 10,000 degrees, and times that are not positive.
Result<std::string> grblJogLine(const std::vector<GrblTarget>& targets, double time_s);

} // namespace bask
