#include "engine/monitor/broker_link.h"

#include "engine/base/message_code.h"
#include "engine/base/program_part.h"

#include <dlfcn.h>

namespace bask {

Result<std::unique_ptr<BrokerLink>> makeBrokerLink() {
    constexpr const char* kModule = "bask-mqtt.so";
    const std::string path = programPart(kModule, BASK_MODULES_BUILT);
    if (path.empty())
        return Error(MessageCode::MonitorNoModule, {}, {std::string(kModule) + " is missing"});
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL); // it stays loaded
    void* const make = library != nullptr ? ::dlsym(library, "baskMakeBrokerLink") : nullptr;
    if (make == nullptr)
        return Error(MessageCode::MonitorNoModule, {}, {::dlerror()});
    return std::unique_ptr<BrokerLink>(reinterpret_cast<BrokerLink* (*)()>(make)());
}

} // namespace bask
