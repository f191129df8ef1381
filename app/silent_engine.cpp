#include "app/silent_engine.h"

namespace bask {

Snapshot withoutAnswer(const Snapshot& last, double since_s) {
    Snapshot now = last;
    now.pending.reset();
    now.canRetreat = false;
    now.sampleAge_s += since_s;
    now.sourceAge_s += since_s;
    now.placeAge_s += since_s;
    for (double& age_s : now.readingAges_s)
        age_s += since_s;
    for (SensorTrust& trust : now.sensors)
        if (trust == SensorTrust::Trusted)
            trust = SensorTrust::Stale;
    now.source_K.reset();
    now.place = PlaceState::Unknown;
    now.heat = HeatState::Unknown;
    now.isMoving = false;
    for (RigDeviceState& device : now.devices)
        device.age_s += since_s;
    now.tracking.reset();
    now.newSamples.clear();
    now.newEvents.clear();
    now.newNotes.clear();
    now.ports.reset();
    now.tried.reset();
    now.refusal = {};
    return now;
}

} // namespace bask
