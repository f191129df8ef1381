#include "engine/control/controller.h"

#include "engine/control/adaptive.h"
#include "engine/control/level_servo.h"
#include "engine/control/model_based.h"

namespace bask {

std::unique_ptr<Controller> makeController(const ControllerSettings& settings, ControlModel model) {
    switch (settings.kind) {
    case ControllerKind::ModelBased:
        return std::make_unique<ModelBasedController>(settings, std::move(model));
    case ControllerKind::Adaptive:
        return std::make_unique<AdaptiveController>(settings, std::move(model));
    case ControllerKind::LevelServo:
        break;
    }
    return std::make_unique<LevelServo>(settings, std::move(model));
}

} // namespace bask
