#pragma once
// The line language of Grbl 1.1 and grblHAL: what one line of the controller says, and the lines and bytes
// that move it. Source: gnea/grbl, doc/markdown/interface.md, commands.md, jogging.md and doc/csv; grblHAL
// core, errors.h and alarms.c.

#include "engine/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bask {

/// Bytes that are taken out of the stream at once, wherever they stand; `0x` of Grbl's documents.
namespace grbl {
inline constexpr char kStatus = '?';
inline constexpr char kHold = '!';
inline constexpr char kResume = '~';
inline constexpr char kReset = '\x18';
inline constexpr char kDoor = '\x84';
inline constexpr char kJogCancel = '\x85';
/// In the order in which positions are told.
inline constexpr std::string_view kLetters = "XYZABC";
} // namespace grbl

enum class GrblState { Idle, Run, Hold, Jog, Alarm, Door, Check, Home, Sleep, Tool };

/// `<Idle|MPos:0.000,0.000,0.000|...>`. Positions are millimetres and degrees, in the order of kLetters.
struct GrblStatus {
    GrblState state = GrblState::Idle;
    std::optional<int> part;           ///< of Hold (0 stopped, 1 slowing down), Door (0 closed) and Alarm
    std::string word;                  ///< state and part as told: "Hold:0"
    std::vector<double> machine;       ///< MPos; empty: not told
    std::vector<double> work;          ///< WPos = MPos - WCO; empty: not told
    std::vector<double> offset;        ///< WCO, told now and then; empty: not told
    std::optional<int> freeBlocks;     ///< Bf
    std::optional<int> freeBytes;      ///< Bf
    std::optional<bool> isHomed;       ///< H, grblHAL
    std::optional<unsigned> homedAxes; ///< H's mask, bit 0 X
    std::string pins;                  ///< Pn, inputs that are active
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
/// The controller has just started: every line before it is lost.
struct GrblBanner {
    std::string identity; ///< "Grbl 1.1h"
    bool operator==(const GrblBanner&) const = default;
};
/// `[MSG:...]`, and every other report in brackets as "VER:1.1h...".
struct GrblReport {
    std::string text;
    bool operator==(const GrblReport&) const = default;
};
/// `[OPT:VNM,15,128]`.
struct GrblOptions {
    std::string letters;
    int blocks = 0; ///< of the motion queue
    int bytes = 0;  ///< of the line buffer
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
/// Anything else, cut to what can be shown.
struct GrblGarbage {
    std::string text;
    bool operator==(const GrblGarbage&) const = default;
};

using GrblLine = std::variant<GrblBlank, GrblOk, GrblError, GrblAlarm, GrblStatus, GrblBanner, GrblReport,
                              GrblOptions, GrblSetting, GrblGarbage>;

/// One line without its end. A line that is damaged anywhere is garbage as a whole; only a banner is seen
/// wherever it stands, since a controller may restart in the middle of a line.
GrblLine parseGrblLine(std::string_view line);

/// What an alarm or an error means; empty for a number that is not known.
std::string grblAlarmWords(int number);
std::string grblErrorWords(int number);

/// True where the controller stands where it says after that alarm; false after an unknown one.
bool isPlaceKept(int alarm);

/// One axis of a move, mm or degrees.
struct GrblTarget {
    char letter = 'X';
    double from = 0.0;
    double to = 0.0;
};

/// As the jog line tells it: rounded to a thousandth.
double grblRounded(double position);

/// `$J=G21G90G53X1.000F60.0\n`: to an absolute machine position within about `time_s`. The feed counts
/// degrees as millimetres, F = 60 sqrt(sum of squares) / time_s. Refuses (ValueOutOfRange) positions that
/// are not within 10 m or 10,000 degrees, and times that are not positive.
Result<std::string> grblJogLine(const std::vector<GrblTarget>& targets, double time_s);

} // namespace bask
