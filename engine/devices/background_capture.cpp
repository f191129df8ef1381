#include "engine/devices/background_capture.h"

namespace bask {

std::atomic<int>& hangingCaptures() {
    static std::atomic<int> hanging{0};
    return hanging;
}

Error captureRefusal(const std::string& name, const std::string& words) {
    return {MessageCode::CameraNotOpened, "", {name, words}};
}

std::string captureProblem(const Error& error) {
    return error.code() == MessageCode::CameraNotOpened && error.message.args.size() > 1
               ? error.message.args[1].text()
               : describe(error);
}

} // namespace bask
