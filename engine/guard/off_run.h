#pragma once
// Switching off, by the steps that the heater's driver has left: over and over until the device says that it
// is off.

#include "engine/guard/guard_log.h"
#include "engine/guard/guard_messages.h"
#include "engine/guard/guarded_port.h"

namespace bask::guard {

/// Whether what came back is what a step wants.
bool fits(const OffStep& step, const unsigned char* bytes, std::size_t count);

class OffRun {
public:
    OffRun(GuardedPort& port, const OffProgram& program, GuardLog& log)
        : m_port(port), m_program(program), m_log(log) {}

    /// Waits until it is confirmed, for ever if need be; opens the port where it is not, or gone.
    void untilConfirmed();

private:
    bool isOpen();
    bool pass();
    bool take(const OffStep& step);
    /// Reads on for so long; empty `step`: whatever comes is dropped.
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
    unsigned char m_bytes[GuardedPort::kMaxBytes] = {}; ///< since the step was sent
};

} // namespace bask::guard
