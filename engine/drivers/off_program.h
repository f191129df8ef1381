#pragma once
// How a driver says to the guard what switches its device off.

#include "engine/guard/guard_messages.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/modbus_profile.h"

#include <string_view>

namespace bask {

/// Sent, and whatever comes back is passed over until `echo` has come, at most for reply_ms.
guard::OffStep offWrite(std::string_view bytes, std::string_view echo, int reply_ms, int pause_ms);
/// Sent, and these bytes must come back.
guard::OffStep offWhenBytes(std::string_view question, std::string_view answer, int reply_ms);
/// Sent, and a line "NUMBER TAIL" of a number up to `most` must come back.
guard::OffStep offWhenNumber(std::string_view question, double most, std::string_view tail, int reply_ms);
/// Sent, and a Modbus reply of this unit must come back that holds a number (before its scale) within these.
guard::OffStep offWhenRegister(const ModbusQuery& question, const RegisterSpec& spec, double least,
                               double most, int reply_ms);
/// Throws std::invalid_argument on a step that is too long.
void add(guard::OffProgram& program, const guard::OffStep& step);

} // namespace bask
