#include "engine/device_simulators/device_server.h"

#include "engine/device_simulators/pty_server.h"
#include "engine/device_simulators/terminal_server.h"

#include <utility>

namespace bask {
namespace {

template <class Server> Result<std::unique_ptr<DeviceServer>> anyOf(Result<std::unique_ptr<Server>> made) {
    if (!made)
        return made.error();
    return std::unique_ptr<DeviceServer>(std::move(*made));
}

} // namespace

Result<std::unique_ptr<DeviceServer>> serveAt(const std::string& path, ByteDevice& device, bool isThere) {
    return isThere ? anyOf(TerminalServer::open(device, path)) : anyOf(PtyServer::create(device, path));
}

} // namespace bask
