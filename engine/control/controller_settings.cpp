#include "engine/control/controller_settings.h"

namespace bask {

const char* controllerKindName(ControllerKind kind) {
    switch (kind) {
    case ControllerKind::ModelBased:
        return "model-based";
    case ControllerKind::Adaptive:
        return "adaptive";
    case ControllerKind::LevelServo:
        break;
    }
    return "level-servo";
}

} // namespace bask
