#include "engine/drivers/modbus_link.h"

#include "engine/base/message_code.h"

namespace bask {

Error modbusException(const std::string& port, int unit, int exception) {
    return {MessageCode::DeviceException, "", {port, numberArg(unit), numberArg(exception)}};
}

std::optional<int> exceptionOf(const Error& error) {
    if (error.code() != MessageCode::DeviceException || error.message.args.size() < 3)
        return std::nullopt;
    const auto number = error.message.args[2].number();
    return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
}

} // namespace bask
