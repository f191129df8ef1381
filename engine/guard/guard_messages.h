#pragma once
// What Bask and its guard say to each other: packets of one kind byte and its bytes, over a socket pair that
// keeps them apart and in order. Both ends are built together.

#include <cstddef>
#include <cstdint>

namespace bask::guard {

inline constexpr int kVersion = 2;
inline constexpr int kSocket = 3;         ///< the guard's descriptor of it
inline constexpr double kSilence_s = 2.0; ///< of the engine: then the guard takes over
inline constexpr double kBeat_s = 0.1;    ///< between two of the engine's beats
inline constexpr std::size_t kMax = 4096; ///< bytes of one packet after its kind

/// To the guard. The bytes of Write go to the port as they are; Program has an OffProgram.
enum class Order : char {
    Beat = 'b',
    Open = 'o',
    Close = 'c',
    Write = 'w',
    Program = 'p',
    Arm = 'a',     ///< heat may be on from here: without the engine it is switched off
    Disarm = 'd',  ///< it is known to be off
    TakeOver = 'x' ///< at once
};

/// From the guard.
enum class Told : char {
    Hello = 'V',     ///< its version, one byte
    Beat = 'b',      ///< one for each
    Opened = 'O',    ///< the port's own name, or nothing
    Failed = 'F',    ///< an int: errno of the opening
    Exchanged = 'X', ///< not opened: it is another port; its own name, or nothing
    Lost = 'L',      ///< it was unplugged
    Stuck = 'S',     ///< it takes no more bytes
    Bytes = 'r',
    TookOver = 'T', ///< why, in English
    Off = 'K'       ///< confirmed; the guard ends
};

/// One step of switching off: bytes to send, and what is to come back.
struct OffStep {
    static constexpr std::size_t kMaxBytes = 64;
    enum class Reply : std::uint8_t {
        None,
        Bytes,    ///< these, anywhere in what comes
        Number,   ///< a line "NUMBER TAIL" of a number up to `most`; TAIL are the bytes
        Register, ///< a Modbus frame that begins with the bytes, of a number from `least` to `most`
    };
    enum class Type : std::uint8_t { Int16, Uint16, Int32, Uint32, Float32 };
    std::uint16_t timeout_ms = 0; ///< for what is to come back
    std::uint16_t pause_ms = 0;   ///< after it
    std::uint8_t sends = 0, expects = 0;
    Reply reply = Reply::None;
    bool mustFit = false; ///< or heat is not known to be off
    unsigned char send[kMaxBytes] = {};
    unsigned char expect[kMaxBytes] = {};
    double least = 0.0, most = 0.0;
    Type type = Type::Int16; ///< of the number in registers
    bool isLowWordFirst = false;
};

/// Heat is off when all of its steps that must fit did so in one pass.
struct OffProgram {
    static constexpr std::size_t kMaxSteps = 8;
    std::uint8_t count = 0;
    std::uint16_t quiet_ms = 60; ///< before the first step: what was half said is over, and late answers
    OffStep steps[kMaxSteps] = {};
};
static_assert(sizeof(OffProgram) <= kMax);

} // namespace bask::guard
