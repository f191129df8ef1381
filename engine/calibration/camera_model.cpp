#include "engine/calibration/camera_model.h"

#include "engine/base/message_code.h"

namespace bask {

std::string pixelsText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

Result<void> checkSize(const CameraModel& camera, int width, int height) {
    if (camera.width == 0 || (camera.width == width && camera.height == height))
        return {};
    return Error(MessageCode::CameraSizeOther, {},
                 {pixelsText(camera.width, camera.height), pixelsText(width, height)});
}

} // namespace bask
