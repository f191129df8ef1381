#pragma once
// Switches off, with the steps that the heater's driver has given: again and again until the device confirms
// that it is off.

#include "engine/guard/guard_log.h"
#include "engine/guard/guard_messages.h"
#include "engine/guard/guarded_port.h"

namespace bask::guard {

/// Returns whether the answer is the expected one of a step.
bool fits(const OffStep& step, const unsigned char* bytes, std::size_t count);

class OffRun {
public:
    OffRun(GuardedPort& port, const OffProgram& program, GuardLog& log)
        : m_port(port), m_program(program), m_log(log) {}

    /// Repeats until it is confirmed, without end if necessary; opens the port if it is not open, or has
    /// disappeared.
    void untilConfirmed();

private:
    bool isOpen();
    bool pass();
    bool take(const OffStep& step);
    /// Reads for this time; with an empty `step` all bytes are discarded.
    bool hear(const OffStep* step, int ms);
    void dropOld();
    void lose();
    void keep(const unsigned char* bytes, std::size_t count);
    bool isLogged() const;

    GuardedPort& m_port;
    const OffProgram& m_program;
    GuardLog& m_log;
    int m_passes = 0;
    std::size_t m_heard = 0;
    unsigned char m_bytes[GuardedPort::kMaxBytes] = {}; ///< bytes since the step was sent
};

} // namespace bask::guard
