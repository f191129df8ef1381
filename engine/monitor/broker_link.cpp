#include "engine/monitor/broker_link.h"

#include "engine/base/message_code.h"
#include "engine/base/program_part.h"

namespace bask {

Result<std::unique_ptr<BrokerLink>> makeBrokerLink() {
    std::string problem;
    void* const make = moduleFunction("bask-mqtt.so", BASK_MODULES_BUILT, "baskMakeBrokerLink", problem);
    if (make == nullptr)
        return Error(MessageCode::MonitorNoModule, {}, {problem});
    return std::unique_ptr<BrokerLink>(reinterpret_cast<BrokerLink* (*)()>(make)());
}

} // namespace bask
