#pragma once
// The language of Dobot's four-axis arms (MG400, M1 Pro) over TCP: replies of its dashboard (29999) and
// motion (30003) ports, packets of its feedback port (30004), the move. Source: Dobot-Arm/
// TCP-IP-Protocol-4AXis, README-EN.md and "TCP_IP Remote Control Interface Guide (4axis)", 2024-04-19.

#include "engine/base/result.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// X, Y, Z in mm, R in degrees.
using DobotPosition = std::array<double, 4>;
inline constexpr std::string_view kDobotLetters = "XYZR";

/// RobotMode; other numbers are possible.
enum class DobotMode : std::uint64_t {
    Starting = 1,
    BrakeOpen = 2,
    Disabled = 4,
    Idle = 5,
    Dragged = 6,
    Running = 7,
    Recording = 8,
    Error = 9,
    Paused = 10,
    Jogging = 11
};

/// `0,{5},RobotMode();`
struct DobotReply {
    int error = 0;       ///< 0: taken
    std::string values;  ///< between the braces
    std::string command; ///< its name in small letters: case does not count
    bool operator==(const DobotReply&) const = default;
};

/// One reply without its semicolon, with or without ends of lines in it; empty where it is damaged or none.
std::optional<DobotReply> parseDobotReply(std::string_view text);

/// What a negative ErrorID of a reply means; empty for one that is not known.
std::string dobotErrorWords(int error);

/// Numbers in the reply to GetErrorID: of the controller first, then of each motor.
std::vector<int> dobotErrorIds(std::string_view values);

/// `MovL(1.000,2.000,3.000,4.000,SpeedL=5,AccL=20)`: straight, speed and acceleration in percent of the
/// arm's own. Refuses (ValueOutOfRange) positions that are not within 10 m or 10,000 degrees.
Result<std::string> dobotMove(const DobotPosition& to, int speed_percent, int acceleration_percent);

/// What is used of a packet.
struct DobotFeedback {
    DobotMode mode = DobotMode::Starting;
    DobotPosition position{};  ///< ToolVectorActual, in the frames below
    int user = 0, tool = 0;    ///< index of the global user and tool frame
    std::uint64_t time_ms = 0; ///< on the controller's clock
    bool operator==(const DobotFeedback&) const = default;
};

/// Packets out of a stream of bytes that comes in any pieces; out of step, it finds the next one.
class DobotFeedbackReader {
public:
    static constexpr std::size_t kPacketBytes = 1440;

    void add(std::string_view bytes) { m_bytes += bytes; }
    /// The next whole packet; empty: none yet. One whose numbers are not finite is left out.
    std::optional<DobotFeedback> next();
    void clear() { m_bytes.clear(); }
    /// Bytes that belonged to no packet.
    std::size_t discarded() const { return m_discarded; }

private:
    std::string m_bytes;
    std::size_t m_discarded = 0;
};

std::string dobotPacket(const DobotFeedback& feedback);

} // namespace bask
