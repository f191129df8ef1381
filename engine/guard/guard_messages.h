#pragma once
// The messages between Bask and its guard: packets of one kind byte and its data, over a socket pair that
// preserves packets and their order. Both programs are built together.

#include <cstddef>
#include <cstdint>

namespace bask::guard {

inline constexpr int kVersion = 2;
inline constexpr int kSocket = 3;         ///< the guard's descriptor of the socket
inline constexpr double kSilence_s = 2.0; ///< silence of the engine after which the guard takes over
inline constexpr double kBeat_s = 0.1;    ///< between two heartbeats of the engine
inline constexpr std::size_t kMax = 4096; ///< bytes of one packet after its kind

/// Messages to the guard. The bytes of Write go to the port unchanged; Program contains an OffProgram.
enum class Order : char {
    Beat = 'b',
    Open = 'o',
    Close = 'c',
    Write = 'w',
    Program = 'p',
    Arm = 'a',     ///< heat may be on from now: without the engine the guard switches it off
    Disarm = 'd',  ///< the heat is known to be off
    TakeOver = 'x' ///< switch off at once
};

/// Messages from the guard.
enum class Told : char {
    Hello = 'V',     ///< its version, one byte
    Beat = 'b',      ///< one for each heartbeat
    Opened = 'O',    ///< with the port's own name, or empty
    Failed = 'F',    ///< with an int: errno of the opening
    Exchanged = 'X', ///< not opened, because it is another port; with its own name, or empty
    Lost = 'L',      ///< the port was unplugged
    Stuck = 'S',     ///< the port accepts no more bytes
    Bytes = 'r',
    TookOver = 'T', ///< with the reason, in English
    Off = 'K'       ///< confirmed; the guard ends
};

/// One step of switching off: bytes to send, and the expected answer.
struct OffStep {
    static constexpr std::size_t kMaxBytes = 64;
    enum class Reply : std::uint8_t {
        None,
        Bytes,    ///< these bytes, anywhere in the answer
        Number,   ///< a line "NUMBER TAIL" with a number not above the maximum; TAIL are the bytes
        Register, ///< a Modbus frame that begins with the bytes, with a number in the range
    };
    enum class Type : std::uint8_t { Int16, Uint16, Int32, Uint32, Float32 };
    std::uint16_t timeout_ms = 0; ///< for the answer
    std::uint16_t pause_ms = 0;   ///< after the step
    std::uint8_t sends = 0, expects = 0;
    Reply reply = Reply::None;
    bool mustFit = false; ///< if true, a wrong answer means that heat is not known to be off
    unsigned char send[kMaxBytes] = {};
    unsigned char expect[kMaxBytes] = {};
    double min = 0.0, max = 0.0;
    Type type = Type::Int16; ///< type of the number in registers
    bool isLowWordFirst = false;
};

/// Heat is off when all steps that must fit did so in one pass.
struct OffProgram {
    static constexpr std::size_t kMaxSteps = 8;
    std::uint8_t count = 0;
    /// Wait before the first step: unfinished messages and late answers are then over.
    std::uint16_t quiet_ms = 60;
    OffStep steps[kMaxSteps] = {};
};
static_assert(sizeof(OffProgram) <= kMax);

} // namespace bask::guard
