#pragma once
// An experiment with a real rig, and what an engine would tell of it.

#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

namespace bask::test {

inline Experiment twoDisks() {
    Experiment experiment;
    for (const char* name : {"left", "right"}) {
        ObjectSpec object;
        object.name = name;
        object.shape = Disk{0.015};
        object.mounting[kX] = experiment.objects.empty() ? -0.03 : 0.03;
        experiment.objects.push_back(object);
    }
    return experiment;
}

inline RigSpec realRig() {
    RigSpec rig;
    rig.name = "bench 2";
    rig.robot.emplace().port = "/dev/ttyROBOT";
    rig.thermometer.emplace().port = "/dev/ttyTEMP";
    rig.thermometer->driver = "stream";
    rig.thermometer->channels = {0, 1};
    rig.source.emplace().driver = "namur";
    rig.source->port = "/dev/ttyPLATE";
    rig.source->serial = {9600, 7, 'E', 1};
    return rig;
}

/// Ready, at rest, everything fresh; simulated unless the experiment has a rig.
inline Snapshot quietSnapshot(const Experiment& experiment) {
    Snapshot snapshot;
    snapshot.state = RunState::Ready;
    snapshot.simulated = !experiment.rig;
    snapshot.latest.coordinates << 0.01, 0.02, 0.15, 0.1, 0.0, 0.0;
    snapshot.place = PlaceState::Sure;
    snapshot.placeAge_s = 0.05;
    snapshot.source_K = snapshot.latest.source_K = 300.0;
    snapshot.sourceAge_s = 0.05;
    snapshot.heat = HeatState::Off;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        ObjectSample object;
        object.valid = true;
        snapshot.latest.objects.push_back(object);
    }
    if (!experiment.rig)
        return snapshot;
    for (const DeviceRole role : {DeviceRole::Robot, DeviceRole::Thermometer, DeviceRole::HeatSource}) {
        RigDeviceState state;
        state.role = role;
        state.status.link = LinkState::Live;
        state.status.rate_Hz = 10.0;
        state.age_s = 0.012;
        snapshot.devices.push_back(state);
    }
    return snapshot;
}

} // namespace bask::test
