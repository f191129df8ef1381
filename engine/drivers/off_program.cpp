#include "engine/drivers/off_program.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

using guard::OffStep;

OffStep made(std::string_view send, std::string_view expect, int reply_ms, int pause_ms) {
    if (send.size() > OffStep::kMaxBytes || expect.size() > OffStep::kMaxBytes)
        throw std::invalid_argument("OffStep: too long");
    OffStep step;
    step.timeout_ms = static_cast<std::uint16_t>(reply_ms);
    step.pause_ms = static_cast<std::uint16_t>(pause_ms);
    step.sends = static_cast<std::uint8_t>(send.size());
    step.expects = static_cast<std::uint8_t>(expect.size());
    std::ranges::copy(send, step.send);
    std::ranges::copy(expect, step.expect);
    return step;
}

} // namespace

OffStep offWrite(std::string_view bytes, std::string_view echo, int reply_ms, int pause_ms) {
    OffStep step = made(bytes, echo, reply_ms, pause_ms);
    if (!echo.empty())
        step.reply = OffStep::Reply::Bytes;
    return step;
}

OffStep offWhenBytes(std::string_view question, std::string_view answer, int reply_ms) {
    OffStep step = made(question, answer, reply_ms, 0);
    step.reply = OffStep::Reply::Bytes;
    step.mustFit = true;
    return step;
}

OffStep offWhenNumber(std::string_view question, double max, std::string_view tail, int reply_ms) {
    OffStep step = made(question, tail, reply_ms, 0);
    step.reply = OffStep::Reply::Number;
    step.mustFit = true;
    step.max = max;
    return step;
}

OffStep offWhenRegister(const ModbusQuery& question, const RegisterSpec& spec, double min, double max,
                        int reply_ms) {
    static_assert(static_cast<int>(RegisterType::Uint16) == static_cast<int>(OffStep::Type::Uint16) &&
                  static_cast<int>(RegisterType::Float32) == static_cast<int>(OffStep::Type::Float32));
    const std::string head{static_cast<char>(question.unit), static_cast<char>(question.function),
                           static_cast<char>(2 * question.count)};
    OffStep step = made(modbusRequest(question), head, reply_ms, 0);
    step.reply = OffStep::Reply::Register;
    step.mustFit = true;
    step.min = min;
    step.max = max;
    step.type = static_cast<OffStep::Type>(spec.type);
    step.isLowWordFirst = spec.isLowWordFirst;
    return step;
}

void add(guard::OffProgram& program, const OffStep& step) {
    if (program.count == guard::OffProgram::kMaxSteps)
        throw std::invalid_argument("OffProgram: too many steps");
    program.steps[program.count++] = step;
}

} // namespace bask
