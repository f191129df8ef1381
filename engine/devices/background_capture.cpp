#include "engine/devices/background_capture.h"

namespace bask {

std::atomic<int>& hangingCaptures() {
    static std::atomic<int> hanging{0};
    return hanging;
}

std::string captureProblem(const Error& error) {
    return error.code() == MessageCode::CameraNotOpened && error.message.args.size() > 1
               ? error.message.args[1].text()
               : describe(error);
}

} // namespace bask
