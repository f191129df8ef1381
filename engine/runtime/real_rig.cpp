#include "engine/runtime/real_rig.h"

#include "engine/devices/video_camera.h"
#include "engine/runtime/missing_devices.h"

namespace bask {

struct RealRig::Parts {
    explicit Parts(const Clock& now) : clock(now) {}

    const Clock& clock;
    MotionGuard guard;
    MissingRobot noRobot;
    MissingThermometer noThermometer;
    MissingHeatSource noSource;
    std::unique_ptr<VideoCamera> camera;
};

RealRig::RealRig(const Experiment& experiment, const Clock& clock) : m_parts(std::make_unique<Parts>(clock)) {
    if (!experiment.rig->camera.empty())
        m_parts->camera = std::make_unique<VideoCamera>(experiment.rig->camera, clock);
}

RealRig::RealRig(const RigSpec& rig, const Clock& clock) : m_parts(std::make_unique<Parts>(clock)) {
    if (!rig.camera.empty())
        m_parts->camera = std::make_unique<VideoCamera>(rig.camera, clock);
}

RealRig::~RealRig() = default;

void RealRig::work() {}

Robot& RealRig::robot() {
    return m_parts->noRobot;
}

Thermometer& RealRig::thermometer() {
    return m_parts->noThermometer;
}

HeatSource& RealRig::heatSource() {
    return m_parts->noSource;
}

Camera* RealRig::camera() {
    return m_parts->camera.get();
}

void RealRig::setGuard(MotionGuard guard) {
    m_parts->guard = std::move(guard);
}

Result<void> RealRig::typeSourceTemperature(double) {
    return Error(MessageCode::RigIncomplete, {}, {"heat source"});
}

std::vector<RigDeviceState> RealRig::devices() const {
    return {};
}

} // namespace bask
