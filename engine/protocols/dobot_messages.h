#pragma once
// The protocol of Dobot's four-axis arms (MG400, M1 Pro) over TCP: replies of its dashboard (29999) and
// motion (30003) ports, packets of its feedback port (30004), and the move command. Source: Dobot-Arm/
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

/// RobotMode of the protocol; other numbers are possible.
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
    int error = 0;       ///< 0: accepted
    std::string values;  ///< text between the braces
    std::string command; ///< its name in lower case, because case does not matter
    bool operator==(const DobotReply&) const = default;
};

/// Parses one reply without its semicolon; it may contain line ends. Empty if it is damaged or not a reply.
std::optional<DobotReply> parseDobotReply(std::string_view text);

/// Returns the meaning of a negative ErrorID of a reply; empty if it is unknown.
std::string dobotErrorWords(int error);

/// Returns the numbers in the reply to GetErrorID: those of the controller first, then of each motor.
std::vector<int> dobotErrorIds(std::string_view values);

/// Returns `MovL(1.000,2.000,3.000,4.000,SpeedL=5,AccL=20)`: a straight move, with speed and acceleration in
/// percent of the arm's own. Refuses (ValueOutOfRange) positions outside 10 m or 10,000 degrees.
Result<std::string> dobotMove(const DobotPosition& to, int speed_percent, int acceleration_percent);

/// The parts of a packet that are used.
struct DobotFeedback {
    DobotMode mode = DobotMode::Starting;
    DobotPosition position{};  ///< ToolVectorActual, in the frames below
    int user = 0, tool = 0;    ///< number of the global user and tool frame
    std::uint64_t time_ms = 0; ///< on the controller's clock
    bool operator==(const DobotFeedback&) const = default;
};

/// Finds packets in a stream of bytes that arrives in pieces of any size; if it is out of step, it finds the
/// next packet.
class DobotFeedbackReader {
public:
    static constexpr std::size_t kPacketBytes = 1440;

    void add(std::string_view bytes) { m_bytes += bytes; }
    /// Returns the next complete packet; empty if there is none yet. A packet with numbers that are not
    /// finite is skipped.
    std::optional<DobotFeedback> next();
    void clear();
    /// Returns the number of bytes that belonged to no packet.
    std::size_t discarded() const { return m_discarded; }
    /// Returns what those bytes were, "1440 bytes with test word 0x0"; empty if there were none since
    /// clear().
    const std::string& strange() const { return m_strange; }

private:
    void discard(std::size_t count);

    std::string m_bytes, m_strange;
    bool m_isInStep = false; ///< the last packet was one
    std::size_t m_discarded = 0;
};

std::string dobotPacket(const DobotFeedback& feedback);

} // namespace bask
