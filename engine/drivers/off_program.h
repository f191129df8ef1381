#pragma once
// How a driver describes to the guard what switches its device off.

#include "engine/guard/guard_messages.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/modbus_profile.h"

#include <string_view>

namespace bask {

/// Sends `bytes` and ignores the answer until `echo` has arrived, for at most reply_ms.
guard::OffStep offWrite(std::string_view bytes, std::string_view echo, int reply_ms, int pause_ms);
/// Sends `question`; exactly `answer` must be received.
guard::OffStep offWhenBytes(std::string_view question, std::string_view answer, int reply_ms);
/// Sends `question`; a line "NUMBER TAIL" must be received, with a number not above the given one.
guard::OffStep offWhenNumber(std::string_view question, double max, std::string_view tail, int reply_ms);
/// Sends `question`; a Modbus reply of this unit must be received, with a number (before its scale) in this
/// range.
guard::OffStep offWhenRegister(const ModbusQuery& question, const RegisterSpec& spec, double min, double max,
                               int reply_ms);
/// Appends a step. Throws std::invalid_argument if it is too long.
void add(guard::OffProgram& program, const guard::OffStep& step);

} // namespace bask
